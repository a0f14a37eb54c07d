//! Sizes of pictures with one pixel a texel: refusals, and their text.

use super::*;

/// A grey picture of these rows.
fn pgm(folder: &Path, size: [u32; 2], texel: impl Fn(u32, u32) -> u8) -> PathBuf {
    let path = folder.join("map.pgm");
    let [width, height] = size;
    let mut bytes = format!("P5 {width} {height} 255\n").into_bytes();
    bytes.extend((0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| texel(x, y)));
    fs::write(&path, bytes).expect("a temporary file");
    path
}

/// Any texels, no two beside each other alike.
fn mixed(x: u32, y: u32) -> u8 {
    ((x * 97 + y * 61 + x * y * 13) % 251) as u8
}

fn of_map(surface: SurfaceSpec) -> SceneSpec {
    SceneSpec {
        size: Some(PictureSize::Map),
        view: Some(View::Top),
        projection: Some(ProjectionChoice::Orthographic),
        samples: Some(1),
        backend: Some(BackendChoice::Cpu),
        ..of(surface)
    }
}

#[test]
fn one_pixel_a_texel_needs_a_map_from_above() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let height = Some(pgm(folder.path(), [37, 53], mixed));
    let base = SurfaceSpec { height, ..SurfaceSpec::default() };
    let key = |spec: SceneSpec| match spec.load().expect_err("no picture of the map's size") {
        SceneError::Value(error) => (error.key, error.problem),
        error => panic!("{error}"),
    };
    let of_size = |spec: SceneSpec| {
        let (key, problem) = key(spec);
        let ValueProblem::MapSize(problem) = problem else { panic!("{key}: {problem}") };
        assert_eq!(key, "size");
        problem
    };
    let of_base = || of_map(base.clone());
    let needs = |what| ("size", ValueProblem::Needs(what));
    for view in [None, Some(View::Corner), Some(View::Front)] {
        assert_eq!(key(SceneSpec { view, ..of_base() }), needs("view top"));
    }
    for projection in [None, Some(ProjectionChoice::Perspective)] {
        assert_eq!(key(SceneSpec { projection, ..of_base() }), needs("projection orthographic"));
    }
    let two = SceneSpec { surfaces: vec![base.clone(), base.clone()], ..of_base() };
    assert_eq!(of_size(two), MapSizeProblem::Several(2));
    let alone = SurfaceSpec { mesh: Some(MeshChoice::File("a.obj".into())), ..SurfaceSpec::default() };
    let error = of_map(alone).check().expect_err("no map");
    assert_eq!(error.problem, ValueProblem::MapSize(MapSizeProblem::NoMap));
    for mesh in [Builtin::Square, Builtin::Sphere] {
        let other = SurfaceSpec { mesh: Some(mesh.into()), ..base.clone() };
        assert_eq!(of_size(of_map(other)), MapSizeProblem::OtherMesh);
    }
    let turned = SurfaceSpec { rotation: Some([0.0, 90.0, 0.0]), ..base.clone() };
    assert_eq!(of_size(of_map(turned)), MapSizeProblem::Turned);
    let part = SurfaceSpec { tile: Some([1.5, 1.0]), ..base.clone() };
    assert_eq!(of_size(of_map(part)), MapSizeProblem::PartTexels([55.5, 53.0]));
    let long = SurfaceSpec { tile_size: Some([53.0, 53.0]), ..base.clone() };
    assert!(matches!(of_size(of_map(long)), MapSizeProblem::NotSquare(wide) if wide > 1.4));
    // Sides and memory are checked when the map is known.
    let many = SurfaceSpec { tile: Some([1.0, 5000.0]), ..base.clone() };
    assert!(matches!(key(of_map(many)).1, ValueProblem::Size { width: 37, height: 265_000 }));
    let tight = SceneSpec { max_memory: Some(ByteSize(300_000)), ..of_base() };
    assert!(matches!(tight.load(), Err(SceneError::TooMuchMemory { width: 37, height: 53, .. })));
    // What is laid over a scene takes the place of what it excludes.
    let eye = SceneSpec { eye: Some([1.0; 3]), target: Some([0.0; 3]), ..SceneSpec::default() };
    let corner = SceneSpec { view: Some(View::Corner), ..SceneSpec::default() };
    let perspective = SceneSpec { projection: Some(ProjectionChoice::Perspective), ..SceneSpec::default() };
    for over in [eye, corner, perspective] {
        assert_eq!(of_base().overridden_by(over).size, None);
    }
    let top = SceneSpec { view: Some(View::Top), ..SceneSpec::default() };
    assert_eq!(of_base().overridden_by(top).size, Some(PictureSize::Map));
}

#[test]
fn sizes_are_written_as_they_are_read() {
    for text in ["map", "37x53", "1x1"] {
        assert_eq!(text.parse::<PictureSize>().expect("a size").to_string(), text);
    }
    for text in ["", "Map", "37", "37x", "x53", "37x53x2", "-1x5", "maps"] {
        assert_eq!(text.parse::<PictureSize>(), Err(PictureSizeError), "{text}");
    }
    let written = "size = \"map\"\nview = \"top\"\nprojection = \"orthographic\"\n";
    let spec = read(written).expect("a proper scene");
    assert_eq!(spec.size, Some(PictureSize::Map));
    assert_eq!(read(&spec.to_toml()).expect("the same scene"), spec);
    for wrong in ["\"maps\"", "\"37x53\"", "[37]", "[1, 2, 3]", "37", "true"] {
        assert!(matches!(read(&format!("size = {wrong}\n")), Err(SceneError::Toml { .. })), "{wrong}");
    }
}
