//! Pictures with one pixel for each texel, and pictures in the proportions of the scene seen from
//! above.

use super::*;
use crate::renderer::Renderer;
use relief_core::Watch;
use relief_maps::Maps;
use relief_shaders::cpu::PixelOut;

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
        ..SceneSpec::of_surface(surface)
    }
}

fn pixels(scene: &Scene) -> Vec<PixelOut> {
    let rendered = Renderer::on_cpu().render(scene, &mut Maps::in_memory(), &Watch::none());
    rendered.expect("a picture").rendering.pixels
}

/// Fails unless each pixel has the height of its texel; tiles begin anew.
fn assert_texels(what: &str, spec: &SceneSpec, tiles: [u32; 2]) {
    let scene = spec.load().unwrap_or_else(|error| panic!("{what}: {error}"));
    let map = scene.surfaces()[0].height_map();
    let size = [map.width() * tiles[0], map.height() * tiles[1]];
    assert_eq!(scene.size(), size, "{what}");
    for (at, pixel) in pixels(&scene).iter().enumerate() {
        let (x, y) = (at as u32 % size[0], at as u32 / size[0]);
        let texel = map.texel(i64::from(x % map.width()), i64::from(y % map.height()));
        assert_eq!(pixel.hit, 1, "{what}: pixel {x}, {y}");
        let apart = (pixel.height - texel).abs();
        assert!(apart <= 1e-3, "{what}: pixel {x}, {y} has height {}, its texel {texel}", pixel.height);
    }
}

#[test]
fn each_pixel_has_the_height_of_its_texel() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let on = |height: PathBuf| SurfaceSpec { height: Some(height), ..SurfaceSpec::default() };
    assert_texels("cobbles", &of_map(on(shipped("data/cobbles.png"))), [1, 1]);
    for size in [[37, 53], [1, 1], [1, 29], [29, 1], [64, 3], [5, 211]] {
        let map = pgm(folder.path(), size, mixed);
        assert_texels(&format!("{size:?}"), &of_map(on(map)), [1, 1]);
    }
    let map = pgm(folder.path(), [37, 53], mixed);
    let tiled = SurfaceSpec { tile: Some([2.0, 3.0]), ..on(map.clone()) };
    assert_texels("tiles", &of_map(tiled), [2, 3]);
    let filled = SurfaceSpec { nodata: Some(7.0), fill: Some(true), ..on(map.clone()) };
    assert_texels("filled", &of_map(filled), [1, 1]);
    let deep = SurfaceSpec { scale: Some(0.6), bias: Some(-0.2), ..on(map.clone()) };
    assert_texels("deep", &of_map(deep), [1, 1]);
    let placed = SurfaceSpec {
        position: Some([3.0, -2.0, 7.0]),
        mesh_scale: Some(2.5),
        tile_size: Some([37.0, 53.0]),
        method: Some("cone".to_owned()),
        ..on(map.clone())
    };
    assert_texels("placed", &of_map(placed), [1, 1]);
    let constant = pgm(folder.path(), [6, 4], |_, _| 90);
    assert_texels("constant", &of_map(on(constant)), [1, 1]);
}

#[test]
fn a_map_of_holes_has_its_size() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    // One value is needed for a map to be read at all.
    let height = Some(pgm(folder.path(), [9, 5], |x, y| if x + y == 0 { 5 } else { 7 }));
    let nodata = Some(7.0);
    let spec = of_map(SurfaceSpec { height, nodata, holes: Some(true), ..SurfaceSpec::default() });
    let scene = spec.load().expect("a scene");
    assert_eq!(scene.size(), [9, 5]);
    let hits = pixels(&scene).iter().filter(|pixel| pixel.hit == 1).count();
    assert!(hits <= 4, "{hits} pixels show holes");
}

#[test]
fn pictures_from_above_have_the_proportions_of_what_is_seen() {
    let map = |width: u32, height: u32| {
        HeightMap::from_fn(width, height, Wrap::Repeat, |x, y| f32::from(mixed(x, y)) / 255.0).expect("a map")
    };
    let seen = |width: u32, height: u32, framing: Framing| {
        let map = map(width, height);
        let mesh = Builtin::Plane.build(map.proportions()).expect("a mesh");
        let builder = Scene::builder(Surface::new(mesh, map)).fitted_orthographic_camera(View::Top);
        builder.framing(framing).samples(1).backend(BackendChoice::Cpu)
    };
    for (sides, size) in
        [([40, 10], [800, 200]), ([10, 40], [200, 800]), ([7, 7], [800, 800]), ([1, 3000], [1, 800])]
    {
        let scene = seen(sides[0], sides[1], Framing::Visible).build().expect("a scene");
        assert_eq!(scene.size(), size, "{sides:?}");
        if size[0] > 1 {
            let misses = pixels(&scene).iter().filter(|pixel| pixel.hit == 0).count();
            assert_eq!(misses, 0, "{sides:?}: the border is not filled");
        }
        let scene = seen(sides[0], sides[1], Framing::Volume).build().expect("a scene");
        assert_eq!(scene.size(), [800, 600], "{sides:?}");
    }
    // A given size stays, and so does the size of other views.
    let given = seen(40, 10, Framing::Visible).size(64, 64).build().expect("a scene");
    assert_eq!(given.size(), [64, 64]);
    let front = seen(40, 10, Framing::Visible).fitted_orthographic_camera(View::Front);
    assert_eq!(front.build().expect("a scene").size(), [800, 600]);
    let perspective = seen(40, 10, Framing::Visible).fitted_camera(View::Top, 40.0);
    assert_eq!(perspective.build().expect("a scene").size(), [800, 600]);
}
