//! Descriptions completed with their files.

use super::*;

#[test]
fn a_scene_is_loaded_with_its_defaults() {
    let height = Some(shipped("data/noise.png"));
    let scene = of(SurfaceSpec { height, ..SurfaceSpec::default() }).load().expect("a scene");
    let [surface] = scene.surfaces() else { panic!("one surface") };
    let map = surface.height_map();
    assert_eq!((map.width(), map.height(), map.wrap()), (128, 128, Wrap::Repeat));
    assert_eq!((map.scale_m(), map.bias_m()), (0.05, -0.05));
    assert_eq!((scene.size(), scene.samples()), ([800, 600], 4));
    assert_eq!(scene.camera().projection(), Projection::Perspective { fov_degrees: 40.0 });
    assert_eq!(scene.lights().len(), 1);
    assert_eq!((surface.two_sided(), surface.mesh().triangles().len()), (false, 2));
    assert!(surface.selection().is_exact());
    assert!(surface.color().is_none() && surface.normal_map().is_none());
    // The builder's defaults with the look of pictures are the same ones, but for the detail: a surface of
    // its own does not know how many samples its picture has.
    let mut selection = Selection::exact();
    selection.choose("detail", "footprint").expect("a detail");
    let own = Surface::new(Builtin::Plane.build([1.0, 1.0]).expect("a mesh"), Arc::clone(map));
    let own = own.with_selection(selection);
    // What maps and picture of a file need is left out of the memory for triangles.
    let left = scene.geometry_memory();
    let built = Scene::builder(own).look(Look::Studio).build().expect("a scene");
    assert!(left.0 > 3 << 30 && left < built.geometry_memory(), "{left}");
    let built = built.to_builder().geometry_memory(left).build().expect("a scene");
    assert_eq!(format!("{built:?}"), format!("{scene:?}"));
}

#[test]
fn normal_maps_point_where_they_are_said_to() {
    let load = |green: &str| {
        let height = Some(shipped("data/noise.png"));
        let normal = Some(shipped("data/bricks_color.png"));
        let spec = SurfaceSpec { height, normal, green: green.parse().ok(), ..SurfaceSpec::default() };
        let scene = of(spec).load().expect("a scene");
        let map = scene.surfaces()[0].normal_map().expect("a normal map");
        assert_eq!((map.width, map.height, map.texels.len()), (256, 256, 256 * 256));
        map.texels.clone()
    };
    for ([x, y, z, zero], [other_x, other_y, other_z, _]) in load("+y").into_iter().zip(load("-y")) {
        assert_eq!((x, y, z, zero), (other_x, -other_y, other_z, 0.0));
        assert!((x * x + y * y + z * z - 1.0).abs() < 1e-5);
    }
}

#[test]
fn missing_maps_and_too_large_ones_are_refused() {
    assert!(matches!(SceneSpec::default().load(), Err(SceneError::NoHeightMap(None))));
    let with_map = |height: PathBuf| of(SurfaceSpec { height: Some(height), ..SurfaceSpec::default() });
    let absent = with_map("no/such/file.png".into());
    assert!(matches!(absent.load(), Err(SceneError::Read(_))));

    let tight = SceneSpec { size: Some([10, 10].into()), ..with_map(shipped("data/noise.png")) };
    let with = |bytes| SceneSpec { max_memory: Some(ByteSize(bytes)), ..tight.clone() }.load();
    assert!(matches!(with(1000), Err(SceneError::TooMuchMemory { width: 10, height: 10, .. })));
    let Err(SceneError::Read(error)) = with(30_000) else { panic!("the picture fits, the map does not") };
    assert!(matches!(error.problem, relief_io::ReadProblem::TooMuchMemory { width: 128, height: 128, .. }));
    assert!(with(64 << 20).is_ok());
    // Reading fits at 8 bytes a texel; the map and what is built on it, 11 bytes a texel, do not.
    let folder = tempfile::tempdir().expect("a temporary folder");
    let large = folder.path().join("large.pgm");
    fs::write(&large, [&b"P5 300 300 255\n"[..], &[7; 300 * 300]].concat()).expect("a temporary file");
    let limit = Some(ByteSize(10 * 300 * 300));
    let map = SceneSpec { max_memory: limit, size: Some([10, 10].into()), ..with_map(large) };
    let Err(SceneError::TooMuchToTrace { width, needed, left, .. }) = map.load() else {
        panic!("there is room to read the map, but not to render it")
    };
    assert!(width == 300 && needed > left);
    // Of a vast picture a band of rows is held.
    let vast = SceneSpec { size: Some([MAX_IMAGE_SIDE; 2].into()), ..tight };
    assert!(vast.load().is_ok());
    let vast = SceneSpec { max_memory: Some(ByteSize(32 << 20)), ..vast };
    assert!(matches!(vast.load(), Err(SceneError::TooMuchMemory { .. })));
}

#[test]
fn several_surfaces_are_loaded_each_file_once() {
    let noise = SurfaceSpec { height: Some(shipped("data/noise.png")), ..SurfaceSpec::default() };
    let mut spec = of(noise);
    spec.surfaces = vec![
        SurfaceSpec { mesh_scale: Some(2.0), ..SurfaceSpec::default() },
        SurfaceSpec { scale: Some(0.25), position: Some([0.0, 0.0, 3.0]), ..SurfaceSpec::default() },
        SurfaceSpec { height: Some(shipped("data/spikes.png")), ..SurfaceSpec::default() },
    ];
    let scene = spec.load().expect("a scene");
    let [first, second, third] = scene.surfaces() else { panic!("three surfaces") };
    assert!(first.height_map().shares_texels(second.height_map()));
    assert!(!first.height_map().shares_texels(third.height_map()));
    assert_eq!((first.height_map().scale_m(), second.height_map().scale_m()), (0.05, 0.25));
    let [large, small] = [first, second].map(|surface| surface.metric().tile_m);
    assert!((large[0] - 2.0 * small[0]).abs() < 1e-12, "{large:?} and {small:?}");
    assert!(second.mesh().vertices().iter().all(|vertex| vertex.position.z >= 2.5));

    spec.surface.height = None;
    let missing = spec.load().expect_err("a surface without a height map");
    assert!(matches!(missing, SceneError::NoHeightMap(Some(0))), "{missing:?}");
}
