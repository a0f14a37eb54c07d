//! Shadows of rays: nothing shadows itself, and what the exact tracer sees in a light's way is in its way.

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use relief_core::exact::least_gap;
use relief_core::mesh::square;
use relief_core::{HeightMap, Path, PathMetric, Wrap};
use relief_scene::light::Light;
use relief_scene::{BackendChoice, Surface, View};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_testing::{maps, steepest};
use relief_tests::adapter::has_adapter;
use relief_tests::shadows;

/// The relief's depth on the unit square, in metres.
const SCALE_M: f64 = 0.15;

/// A method with rays for shadows, or without any shadow.
fn selection(method: &str, shadow: &str) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shadow", shadow).expect("a shadow");
    selection
}

/// The pixels of a map on the unit square under one light, and nothing else that gives light.
fn pixels(
    map: &HeightMap,
    selection: Selection,
    light: DVec3,
    size: [u32; 2],
    backend: BackendChoice,
) -> Vec<PixelOut> {
    let map = map.clone().with_displacement(SCALE_M, -SCALE_M).expect("lengths");
    let surface = Surface::new(square(1).expect("a mesh"), map).with_selection(selection);
    let light = Light::directional(light, Vec3::ONE).expect("a light");
    shadows::pixels(&shadows::under_one_light(surface, light, View::Corner, size, backend))
}

/// Directions toward lights at these degrees above the horizon, all around.
fn lights(degrees: &[f64], around: u32) -> Vec<DVec3> {
    let at = |degrees: f64, turn: u32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let (v, u) = (f64::from(turn) / f64::from(around) * std::f64::consts::TAU + 0.1).sin_cos();
        DVec3::new(cos * u, sin, cos * v)
    };
    degrees.iter().flat_map(|&degrees| (0..around).map(move |turn| at(degrees, turn))).collect()
}

#[test]
fn level_and_tilted_ground_has_no_shadow_at_any_light() {
    let side = 37u32;
    let last = f64::from(side - 1);
    // Height at a corner, and rise along u and v over the whole.
    let ground = [
        ("level", 0.37, [0.0, 0.0]),
        ("at the top", 1.0, [0.0, 0.0]),
        ("tilted", 0.1, [0.8, 0.0]),
        ("tilted across", 0.05, [0.27, 0.63]),
    ];
    for (name, corner, [along_u, along_v]) in ground {
        let height =
            |i: u32, j: u32| (corner + (along_u * f64::from(i) + along_v * f64::from(j)) / last) as f32;
        let map = HeightMap::from_fn(side, side, Wrap::Clamp, height).expect("a map");
        for method in ["exact", "cone", "frustum", "quadtree", "erosion-dilation", "sphere-tracing"] {
            let worst = lights(&[0.01, 0.5, 3.0, 10.0, 30.0, 60.0, 90.0], 7).into_par_iter().map(|light| {
                let of =
                    |shadow| pixels(&map, selection(method, shadow), light, [40, 30], BackendChoice::Cpu);
                let (lit, shadowed) = (of("none"), of("ray"));
                // Beyond the outermost texels' centres the ground is level, so that it stands above tilted
                // ground's extension: what is near to it, and light that grazes the ground, are left out.
                let edge = 8.0 / side as f32;
                let is_inside = |pixel: &PixelOut| {
                    let is_far = [pixel.uv.x, pixel.uv.y].iter().all(|at| (edge..=1.0 - edge).contains(at));
                    is_far && (name == "level" || name == "at the top" || pixel.color.x > 0.01)
                };
                let inside = lit.iter().zip(&shadowed).filter(|(pixel, _)| is_inside(pixel));
                let differences = inside.map(|(a, b)| (a.color.x - b.color.x).abs());
                differences.fold(0.0, f32::max)
            });
            let worst = worst.reduce(|| 0.0, f32::max);
            assert_eq!(worst, 0.0, "{name}, {method}");
        }
    }
}

/// Obstacle on the way from a pixel's hit to a light: the ray's greatest depth below the surface, and its
/// least distance from it after it has left the hit's own cell.
fn truth(map: &HeightMap, pixel: &PixelOut, light: DVec3) -> (f64, f64) {
    let uv = [f64::from(pixel.uv.x), f64::from(pixel.uv.y)];
    let height = map.height_at(uv[0], uv[1]);
    let duv = [light.x, light.z];
    let slope = light.y / SCALE_M;
    let mut exit = (1.0 - height) / slope;
    let size = [map.width(), map.height()].map(f64::from);
    let mut leave = exit;
    for axis in 0..2 {
        let place = uv[axis] * size[axis] - 0.5;
        let speed = duv[axis] * size[axis];
        let border = if speed > 0.0 { place.floor() + 1.0 } else { place.floor() };
        if speed != 0.0 {
            leave = leave.min((border - place) / speed);
        }
        if map.wrap() == Wrap::Clamp && duv[axis] != 0.0 {
            let edge = if duv[axis] > 0.0 { 1.0 } else { 0.0 };
            exit = exit.min((edge - uv[axis]) / duv[axis]);
        }
    }
    let path =
        Path { uv, duv, h: [height, slope, 0.0], exit, base: 0.0, ..Path::between([0.0; 3], [1.0; 3]) };
    let path = Path { metric: PathMetric::unit(SCALE_M), ..path };
    (-least_gap(map, &path, 0.0, exit), least_gap(map, &path, leave.max(0.0), exit))
}

#[test]
fn rays_answer_as_the_exact_tracer_does() {
    let mut backends = vec![(BackendChoice::Cpu, vec!["exact", "cone", "quadtree"])];
    if has_adapter() {
        backends.push((BackendChoice::Gpu, vec!["frustum"]));
    }
    for (backend, methods) in backends {
        for named in &maps::ALL[..4] {
            for wrap in Wrap::ALL {
                let map = named.build(wrap);
                let places = 4.0 * f64::from(map.width().max(map.height())) + 2.0;
                let slack = 4e-6 + 8.0 * f64::from(f32::EPSILON) * steepest(&map) * places;
                for method in &methods {
                    let (mut lit, mut dark, mut grazing) = (0, 0, 0);
                    for light in lights(&[12.0, 35.0], 3) {
                        let of = |shadow| pixels(&map, selection(method, shadow), light, [120, 90], backend);
                        for (open, shadowed) in of("none").iter().zip(&of("ray")) {
                            if open.hit == 0 || open.color.x < 1e-3 {
                                continue;
                            }
                            assert_eq!(open.uv, shadowed.uv);
                            let is_lit = shadowed.color.x > 0.5 * open.color.x;
                            let (depth, clearance) = truth(&map, shadowed, light);
                            if depth > slack {
                                assert!(
                                    !is_lit,
                                    "{} {wrap} {method}: lit {depth} below {open:?}",
                                    named.name
                                );
                                dark += 1;
                            } else if depth <= 1e-12 && clearance > slack {
                                assert!(
                                    is_lit,
                                    "{} {wrap} {method}: dark, {clearance} clear {open:?}",
                                    named.name
                                );
                                lit += 1;
                            } else {
                                grazing += 1;
                            }
                        }
                    }
                    println!(
                        "{} {wrap} {method} {backend}: {lit} lit, {dark} dark, {grazing} grazing",
                        named.name
                    );
                    assert!(grazing < (lit + dark) / 10 + 50, "{lit} {dark} {grazing}");
                }
            }
        }
    }
}

#[test]
fn soft_shadows_of_the_exact_tracer_are_those_of_an_exact_search() {
    for named in &maps::ALL[..4] {
        let map = named.build(Wrap::Repeat).with_displacement(SCALE_M, -SCALE_M).expect("lengths");
        let of = |search: &str, samples: f64| {
            let mut selection = selection("exact", "soft");
            selection.choose("shadow-search", search).expect("a search");
            selection.set("shadow.samples", samples).expect("a number of rays");
            let surface = Surface::new(square(1).expect("a mesh"), map.clone()).with_selection(selection);
            let light = Light::directional(DVec3::new(-0.6, 0.4, 0.3), Vec3::ONE);
            let light = light.and_then(|light| light.with_diameter(20.0)).expect("a light");
            let scene = shadows::under_one_light(surface, light, View::Corner, [120, 90], BackendChoice::Cpu);
            shadows::pixels(&scene)
        };
        let (exact, searched, other) = (of("cells", 8.0), of("cone", 8.0), of("cells", 7.0));
        // A ray that grazes the surface may be judged either way.
        let differ = |pixels: &[PixelOut]| {
            exact.iter().zip(pixels).filter(|(a, b)| (a.lit - b.lit).abs() > 1e-6).count()
        };
        assert!(differ(&searched) * 200 < exact.len(), "{}: {}", named.name, differ(&searched));
        assert!(differ(&other) * 50 > exact.len(), "{}: {}", named.name, differ(&other));
    }
}
