//! Values of `--aov` against a camera, a bilinear surface and a ray march that are written here a
//! second time.

use crate::common::aov::{Aov, Pixel};
use crate::common::command::Folder;
use crate::common::maps::{self, Map};
use crate::common::reference::{Continuation, Relief, View};
use glam::{DVec2, DVec3};

/// Tolerance of positions in metres: the error of `f32` at coordinates about 1, times its growth
/// along a grazing ray.
const TOLERANCE_M: f64 = 2e-5;

const VIEW: View = View {
    eye: DVec3::new(0.3, 0.7, 0.9),
    target: DVec3::new(0.05, -0.05, 0.1),
    fov_degrees: 50.0,
    size: [72, 54],
};

fn render(folder: &Folder, view: &View, relief: &Relief, more: &str) -> Aov {
    folder.write("map.png", relief.map.png());
    let mesh = if more.contains("--mesh") { "" } else { "--mesh square" };
    let line = format!(
        "render --height map.png --backend cpu --detail none -o a.png --aov a.exr {mesh} {} {} {more}",
        view.flags(),
        relief.flags()
    );
    folder.relief(&line).fine();
    Aov::read(&folder.path("a.exr"))
}

/// Returns the fault of a pixel that shows a point of the relief on the built-in square, if it has
/// one.
fn fault(pixel: &Pixel, view: &View, relief: &Relief, ray: DVec3) -> Option<String> {
    let surface = relief.point(pixel.uv);
    let off_ray = (pixel.position - view.eye).cross(ray).length() / ray.length();
    let depth = (pixel.position - view.eye).dot(view.forward());
    let checks = [
        ("the hit", (pixel.hit - 1.0).abs(), 0.0),
        ("the height", (pixel.height - relief.height(pixel.uv)).abs(), 2e-5),
        ("the position on the surface", (pixel.position - surface).length(), TOLERANCE_M),
        ("the position on the ray", off_ray, TOLERANCE_M),
        ("the normal", (pixel.normal - relief.normal(pixel.uv)).length(), 1e-3),
        ("the normal's length", (pixel.normal.length() - 1.0).abs(), 1e-5),
        ("the depth", (pixel.depth - depth).abs(), TOLERANCE_M),
        ("reads", (1.0 - pixel.reads).max(0.0), 0.0),
        ("steps", (1.0 - pixel.steps).max(0.0), 0.0),
        // No read is of less than the four heights of a cell.
        ("bytes", (16.0 * pixel.reads - pixel.bytes).max(0.0), 0.0),
    ];
    // A NaN is a fault.
    let wrong = checks.iter().find(|(_, off, allowed)| off.is_nan() || off > allowed);
    wrong.map(|(what, off, _)| format!("{what} is off by {off}"))
}

const NOTHING: Pixel = Pixel {
    hit: 0.0,
    uv: DVec2::ZERO,
    height: 0.0,
    position: DVec3::ZERO,
    normal: DVec3::ZERO,
    depth: 0.0,
    reads: 0.0,
    steps: 0.0,
    bytes: 0.0,
};

/// Fails where a pixel is wrong in itself, or where more than one in 200 shows another point than
/// the march found: at points that a ray only touches either may be right.
fn assert_true(aov: &Aov, view: &View, relief: &Relief) -> [usize; 2] {
    assert_eq!([aov.width, aov.height], view.size);
    let (mut hits, mut misses, mut disagree) = (0, 0, 0);
    for (x, y, pixel) in aov.pixels() {
        let ray = view.ray(x, y);
        if pixel.hit == 0.0 {
            assert_eq!(pixel, NOTHING, "({x}, {y})");
            misses += 1;
        } else {
            let fault = fault(&pixel, view, relief, ray);
            assert_eq!(fault, None, "({x}, {y}) of {}: {pixel:?}", relief.flags());
            hits += 1;
        }
        let agrees = match relief.first_hit(view.eye, ray) {
            None => pixel.hit == 0.0,
            Some(point) => pixel.hit == 1.0 && (pixel.position - point).length() < 10.0 * TOLERANCE_M,
        };
        disagree += usize::from(!agrees);
    }
    let pixels = aov.width * aov.height;
    assert!(disagree * 200 <= pixels, "{disagree} of {pixels} pixels of {} are elsewhere", relief.flags());
    [hits, misses]
}

#[test]
fn a_constant_map_is_a_plane_below_the_polygon() {
    let folder = Folder::new();
    let relief = Relief { scale_m: 0.2, bias_m: -0.2, ..Relief::new(Map::constant(0.25)) };
    let aov = render(&folder, &VIEW, &relief, "");
    let [hits, misses] = assert_true(&aov, &VIEW, &relief);
    assert!(hits > 500 && misses > 500);
    // In closed form, too: the plane 3/4 of the scale below the polygon.
    let level = -0.2 + 0.2 * (16384.0 / 65535.0);
    for (x, y, pixel) in aov.pixels() {
        let ray = VIEW.ray(x, y);
        let [base, below] = [0.0, level].map(|level| VIEW.eye + ray * ((level - VIEW.eye.y) / ray.y));
        let inside = base.x.abs().max(base.z.abs());
        if (inside - 0.5).abs() > 1e-4 {
            assert_eq!(pixel.hit == 1.0, inside < 0.5, "({x}, {y})");
        }
        if pixel.hit == 1.0 {
            assert!((pixel.position - below).length() < TOLERANCE_M, "({x}, {y})");
            assert!((pixel.uv - DVec2::new(below.x + 0.5, below.z + 0.5)).length() < TOLERANCE_M);
            assert!((pixel.normal - DVec3::Y).length() < 1e-6 && (pixel.height - 0.25).abs() < 1e-5);
        }
    }
}

#[test]
fn hits_are_the_first_points_of_the_bilinear_surface() {
    let folder = Folder::new();
    let hills = Relief { scale_m: 0.15, bias_m: -0.15, ..Relief::new(Map::hills()) };
    let reliefs = [
        hills.clone(),
        Relief { wrap: Continuation::Mirror, ..hills.clone() },
        Relief { wrap: Continuation::Clamp, ..hills.clone() },
        Relief { tile: [2.0, 1.5], ..hills.clone() },
        Relief { tile: [0.5, 3.0], wrap: Continuation::Mirror, ..hills.clone() },
        // Relief that stands out of the polygon: its silhouette stays the polygon's.
        Relief { bias_m: -0.05, ..hills.clone() },
        Relief { bias_m: 0.02, scale_m: 0.1, ..hills },
    ];
    for relief in reliefs {
        let aov = render(&folder, &VIEW, &relief, "");
        let [hits, misses] = assert_true(&aov, &VIEW, &relief);
        assert!(hits > 500 && misses > 500, "{}", relief.flags());
    }
}

#[test]
fn rays_go_on_beyond_the_edge_unless_the_map_is_clamped() {
    let folder = Folder::new();
    let hits_with = |wrap| {
        let relief = Relief { scale_m: 0.3, bias_m: -0.3, wrap, ..Relief::new(Map::constant(0.1)) };
        let aov = render(&folder, &VIEW, &relief, "");
        let hits: Vec<DVec2> = aov.pixels().filter(|(_, _, p)| p.hit == 1.0).map(|(_, _, p)| p.uv).collect();
        let outside = hits.iter().filter(|uv| uv.min_element() < 0.0 || uv.max_element() > 1.0).count();
        [hits.len(), outside]
    };
    let [repeat, repeat_outside] = hits_with(Continuation::Repeat);
    let [mirror, mirror_outside] = hits_with(Continuation::Mirror);
    let [clamp, clamp_outside] = hits_with(Continuation::Clamp);
    assert!(repeat_outside > 100, "texture coordinates are wrapped, or rays end at the edge");
    assert_eq!((repeat, repeat_outside), (mirror, mirror_outside));
    assert_eq!((clamp, clamp_outside), (repeat - repeat_outside, 0));
}

#[test]
fn the_fault_finder_finds_faults() {
    let folder = Folder::new();
    let relief = Relief { scale_m: 0.15, bias_m: -0.15, ..Relief::new(Map::hills()) };
    let aov = render(&folder, &VIEW, &relief, "");
    let (x, y, good) = aov.pixels().find(|(_, _, pixel)| pixel.hit == 1.0).expect("a hit");
    let ray = VIEW.ray(x, y);
    assert_eq!(fault(&good, &VIEW, &relief, ray), None);
    let aside = (good.position - VIEW.eye).length();
    let mutations = [
        Pixel { uv: good.uv + DVec2::new(0.01, 0.0), ..good },
        Pixel { uv: DVec2::new(good.uv.y, good.uv.x), ..good },
        Pixel { height: good.height + 1e-3, ..good },
        Pixel { position: good.position + DVec3::Y * 1e-3, ..good },
        Pixel { position: good.position + ray * 1e-3, ..good },
        Pixel { normal: good.normal * 0.99, ..good },
        Pixel { normal: DVec3::new(-good.normal.x, good.normal.y, -good.normal.z), ..good },
        Pixel { normal: DVec3::NAN, ..good },
        Pixel { depth: aside, ..good },
        Pixel { reads: 0.0, ..good },
        Pixel { steps: 0.0, ..good },
        Pixel { bytes: 4.0, ..good },
    ];
    for mutation in mutations {
        assert!(fault(&mutation, &VIEW, &relief, ray).is_some(), "{mutation:?}");
    }
    assert!(fault(&good, &VIEW, &relief, VIEW.ray(x, y + 1)).is_some(), "rows upside down");
    let deeper = Relief { bias_m: -0.16, ..relief };
    assert!(fault(&good, &VIEW, &deeper, ray).is_some());
}

#[test]
fn row_0_is_on_top_and_column_0_on_the_left() {
    let folder = Folder::new();
    // Looking along -z and down: far is up, +x is right.
    let view =
        View { eye: DVec3::new(0.0, 1.0, 1.0), target: DVec3::ZERO, fov_degrees: 30.0, size: [32, 32] };
    let flat = Relief { scale_m: 0.01, bias_m: -0.01, ..Relief::new(Map::constant(1.0)) };
    let top_is_red =
        image::RgbImage::from_fn(8, 8, |_, y| image::Rgb(if y < 4 { [255, 0, 0] } else { [0, 255, 0] }));
    folder.write("color.png", maps::encoded(&top_is_red.into(), image::ImageFormat::Png));
    let aov = render(&folder, &view, &flat, "--color color.png");
    let (top, bottom) = (aov.pixel(16, 4), aov.pixel(16, 28));
    assert!(top.depth > bottom.depth && top.position.z < bottom.position.z && top.uv.y < bottom.uv.y);
    let (left, right) = (aov.pixel(4, 16), aov.pixel(28, 16));
    assert!(left.position.x < right.position.x && left.uv.x < right.uv.x);
    let picture = image::open(folder.path("a.png")).expect("a valid picture").into_rgb8();
    assert_eq!(picture.dimensions(), (32, 32));
    let [[red, green, _], [other_red, other_green, _]] =
        [picture.get_pixel(16, 4).0, picture.get_pixel(16, 28).0];
    assert!(red > green && other_red < other_green, "the map's top row lies far away");
}

#[test]
fn back_faces_show_only_when_asked_for_and_then_turned_over() {
    let folder = Folder::new();
    let from_below =
        View { eye: DVec3::new(0.2, -1.0, 0.4), target: DVec3::ZERO, fov_degrees: 40.0, size: [24, 24] };
    let relief = Relief { scale_m: 0.1, bias_m: -0.1, ..Relief::new(Map::constant(0.5)) };
    let aov = render(&folder, &from_below, &relief, "");
    assert!(aov.pixels().all(|(_, _, pixel)| pixel == NOTHING));
    let aov = render(&folder, &from_below, &relief, "--two-sided");
    let hits: Vec<Pixel> = aov.pixels().map(|(_, _, pixel)| pixel).filter(|pixel| pixel.hit == 1.0).collect();
    assert!(hits.len() > 100);
    // Carved away from the eye, and facing it.
    assert!(hits.iter().all(|pixel| (pixel.position.y - 0.05).abs() < 1e-4 && pixel.normal.y < -0.99));
}

#[test]
fn on_every_mesh_points_lie_on_their_rays_and_normals_are_unit() {
    let folder = Folder::new();
    let view = View { eye: VIEW.eye * 1.8, size: [48, 40], ..VIEW };
    let relief = Relief { scale_m: 0.05, bias_m: -0.05, tile: [4.0, 2.0], ..Relief::new(Map::hills()) };
    for mesh in ["plane", "square", "cube", "cylinder", "sphere", "torus"] {
        let aov = render(&folder, &view, &relief, &format!("--mesh {mesh}"));
        let mut hits = 0;
        for (x, y, pixel) in aov.pixels().filter(|(_, _, pixel)| pixel.hit == 1.0) {
            let (ray, from_eye) = (view.ray(x, y), pixel.position - view.eye);
            let off_ray = from_eye.cross(ray).length() / ray.length();
            assert!(off_ray < 10.0 * TOLERANCE_M, "{mesh} ({x}, {y}): {off_ray} off its ray");
            assert!((pixel.depth - from_eye.dot(view.forward())).abs() < TOLERANCE_M, "{mesh} ({x}, {y})");
            assert!((pixel.normal.length() - 1.0).abs() < 1e-5, "{mesh} ({x}, {y})");
            assert!((pixel.height - relief.height(pixel.uv)).abs() < 1e-4, "{mesh} ({x}, {y})");
            hits += 1;
        }
        assert!(hits > 80, "{mesh}: {hits} hits");
    }
}

#[test]
fn every_method_shows_points_of_the_surface() {
    let folder = Folder::new();
    let view = View { size: [40, 30], ..VIEW };
    let relief = Relief { scale_m: 0.05, bias_m: -0.05, ..Relief::new(Map::hills()) };
    let methods = folder.relief("methods --json").fine().stdout;
    let methods: serde_json::Value = serde_json::from_str(&methods).expect("JSON");
    let methods = methods["methods"].as_array().expect("a list of methods");
    assert!(methods.len() >= 11);
    // Objects of images, volumes and motifs have no height map.
    let has_none = |method: &&serde_json::Value| {
        ["object", "volume", "motif"].into_iter().any(|family| method["family"] == family)
    };
    for method in methods.iter().filter(|method| !has_none(method)) {
        let name = method["name"].as_str().expect("a name");
        let aov = render(&folder, &view, &relief, &format!("--method {name}"));
        let hits: Vec<Pixel> = aov.pixels().map(|(_, _, p)| p).filter(|p| p.hit == 1.0).collect();
        assert!(hits.len() > 200, "{name}: {} hits", hits.len());
        // Approximate methods leave the ray, but what they show is on the surface, with its normal
        // and depth. Displaced triangles are beside it between their vertices, by a little of the
        // relief's depth.
        let (off_m, turned) = match method["geometry"].as_str().expect("a name") {
            "none" => (TOLERANCE_M, 1e-3),
            _ => (0.04 * relief.scale_m, 0.2),
        };
        for pixel in hits {
            assert!((pixel.position - relief.point(pixel.uv)).length() < off_m, "{name}: {pixel:?}");
            assert!((pixel.normal - relief.normal(pixel.uv)).length() < turned, "{name}: {pixel:?}");
            let depth = (pixel.position - view.eye).dot(view.forward());
            assert!((pixel.depth - depth).abs() < TOLERANCE_M, "{name}: {pixel:?}");
        }
    }
}

#[test]
fn the_channels_are_those_promised() {
    let folder = Folder::new();
    let aov = render(&folder, &View { size: [7, 5], ..VIEW }, &Relief::new(Map::constant(0.5)), "");
    let mut expected = [
        "hit",
        "uv.x",
        "uv.y",
        "height",
        "P.x",
        "P.y",
        "P.z",
        "N.x",
        "N.y",
        "N.z",
        "depth",
        "reads",
        "steps",
        "bytes",
        "lit",
        "level",
        "z",
        "surface",
        "transmittance",
    ];
    expected.sort_unstable();
    assert_eq!(aov.names(), expected);
    assert!(aov.plane("hit").iter().all(|&hit| hit == 0.0 || hit == 1.0));
}

/// Skips without an adapter, unless `RELIEF_REQUIRE_GPU` is 1.
#[test]
fn the_gpu_writes_the_same_numbers() {
    let folder = Folder::new();
    let relief = Relief { scale_m: 0.15, bias_m: -0.15, ..Relief::new(Map::hills()) };
    let view = View { size: [40, 30], ..VIEW };
    let cpu = render(&folder, &view, &relief, "");
    let line = format!(
        "render --height map.png --mesh square --backend gpu -o gpu.png --aov gpu.exr {} {}",
        view.flags(),
        relief.flags()
    );
    let ran = folder.relief(&line);
    if ran.code == Some(1) && std::env::var_os("RELIEF_REQUIRE_GPU").is_none_or(|value| value != "1") {
        println!("skipped: {}", ran.stderr);
        assert!(!folder.path("gpu.png").exists());
        return;
    }
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let gpu = Aov::read(&folder.path("gpu.exr"));
    assert_true(&gpu, &view, &relief);
    let same = |(x, y, pixel): &(usize, usize, Pixel)| {
        let other = cpu.pixel(*x, *y);
        pixel.hit == other.hit && (pixel.position - other.position).length() < 10.0 * TOLERANCE_M
    };
    let different = gpu.pixels().filter(|pixel| !same(pixel)).count();
    assert!(different * 200 <= 40 * 30, "{different} pixels differ");
}
