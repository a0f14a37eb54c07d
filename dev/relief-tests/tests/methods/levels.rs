//! Levels of detail: each is traced as the map that it is, and pictures are near to pictures of many samples.

use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::mesh::Builtin;
use relief_core::registry::MapLevels;
use relief_core::{MapFormat, Path, Wrap};
use relief_scene::light::Light;
use relief_scene::{BackendChoice, Surface, View};
use relief_shaders::Selection;
use relief_shaders::cpu::{MethodTracer, PixelOut};
use relief_testing::maps;
use relief_testing::rays::Rays;
use relief_tests::accuracy;
use relief_tests::baked::{maps_in, slots};
use relief_tests::detail::Seen;
use relief_tests::pairs;
use relief_tests::shadows;

/// Rays over each map in each level, for each pair.
const RAYS: usize = 25;

#[test]
fn a_level_is_traced_as_the_map_that_it_is() {
    let pairs: Vec<_> = pairs::all().collect();
    let compared: usize = pairs
        .par_iter()
        .enumerate()
        .map(|(number, finest)| {
            let mut levels = *finest;
            levels.choose("detail", "footprint").expect("a listed name");
            // One pyramid serves all levels and so bounds each less tightly: other steps lead to the same
            // hit.
            let is_chain = levels.map_needs().iter().any(|need| need.input.levels != MapLevels::EachDetail);
            if is_chain || levels.check().is_err() {
                return 0;
            }
            let mut compared = 0;
            for (m, map) in maps::ALL.iter().enumerate().filter(|(m, _)| (m + number) % 8 == 0) {
                let heights = map.build(Wrap::ALL[(number + m / 8) % Wrap::ALL.len()]);
                let maps = maps_in(MapFormat::F32, &heights, &levels);
                let tracer = MethodTracer::over(&heights, &levels, slots(&heights, &levels, &maps));
                for k in 0..heights.levels() {
                    let level = heights.level(k);
                    let maps = maps_in(MapFormat::F32, &level, finest);
                    let own = MethodTracer::over(&level, finest, slots(&level, finest, &maps));
                    for (_, path) in Rays::new(&level, 7 + u64::from(k)).take(RAYS) {
                        let (a, b) = (tracer.first_hit_in(k, &path), own.first_hit(&path));
                        // As text, since a path that never ends may end at no number.
                        let name = pairs::name(finest);
                        assert_eq!(format!("{a:?}"), format!("{b:?}"), "{name} {} level {k}", map.name);
                        compared += 1;
                    }
                }
            }
            compared
        })
        .sum();
    assert!(compared > 50 * RAYS, "{compared}");
}

#[test]
fn coarser_columns_lie_over_finer_ones() {
    let mut hits = 0;
    for (number, map) in maps::ALL.iter().enumerate() {
        let heights = map.build(Wrap::ALL[number % Wrap::ALL.len()]);
        let highest = heights.texels().iter().copied().fold(0.0, f32::max);
        let at = |level: f64, path: &Path| {
            let mut selection = Selection::pair("pyramid-texels", "none").expect("listed names");
            selection.set("search.level", level).expect("a level");
            let maps = maps_in(MapFormat::F32, &heights, &selection);
            let tracer = MethodTracer::over(&heights, &selection, slots(&heights, &selection, &maps));
            tracer.first_hit(path)
        };
        for (_, path) in Rays::new(&heights, 11).take(RAYS) {
            let levels = [0.0, 1.0, 3.0, 20.0].map(|level| at(level, &path));
            for [fine, coarse] in levels.array_windows() {
                let before = fine.t + 1e-5 * path.exit;
                assert!(!fine.found || (coarse.found && coarse.t <= before), "{}: {path:?}", map.name);
                hits += usize::from(fine.found && coarse.t < fine.t);
            }
            // The coarsest is a plane, but for what lies beside a clamped map.
            let plane = &levels[3];
            let inside = plane.uv.iter().all(|place| (0.0..1.0).contains(place));
            if plane.found && plane.t > 0.0 && (inside || heights.wrap() != Wrap::Clamp) {
                assert!((plane.height - f64::from(highest)).abs() < 1e-4, "{}: {plane:?}", map.name);
            }
        }
    }
    assert!(hits > 100, "{hits}");
}

#[test]
fn a_faded_relief_is_hit_where_a_flatter_one_is() {
    let maps = accuracy::maps();
    let cobbles = maps.iter().find(|named| named.name == "cobbles").expect("a sample map");
    for wrap in [Wrap::Repeat, Wrap::Mirror] {
        let map = cobbles.map.clone().with_wrap(wrap);
        let seen = Seen { map: &map, method: "cone", shadow: "none", texels: 4.0, tilt_deg: 60.0, side: 96 };
        // Half of it is flattened where its depth is in the middle between where that begins and where it
        // ends.
        let (depth, mean) = (seen.depth(), f64::from(map.mean()));
        let with = |flat: f64, begin: f64| {
            let mut selection = seen.selection("fade");
            selection.set("detail.flat", flat * depth).expect("pixels");
            selection.set("detail.begin", begin).expect("times");
            selection
        };
        let is_near = |selection, place| {
            let faded = seen.pixels_of(selection, [1.0, -1.0], 1, 0.0);
            let flatter = seen.pixels_of(seen.selection("footprint"), place, 1, 0.0);
            let same = |(a, b): &(&PixelOut, &PixelOut)| {
                let apart = [a.uv.x - b.uv.x, a.uv.y - b.uv.y].map(f32::abs);
                a.hit == b.hit && apart.iter().all(|apart| *apart < 2e-4)
            };
            faded.iter().zip(&flatter).filter(same).count() as f64 / faded.len() as f64
        };
        let half = with(0.5, 3.0);
        let near = is_near(half, [0.5, -1.0 + 0.5 * mean]);
        assert!(near > 0.998, "{wrap}: {near} of the pixels");
        let other = is_near(half, [1.0, -1.0]);
        assert!(other < 0.9, "{wrap}: {other} of the pixels are where they are without");
        // What is deep stays as it is, to the bit.
        let full = seen.pixels_of(with(0.5, 1.5), [1.0, -1.0], 1, 0.0);
        assert!(full == seen.pixels_of(seen.selection("footprint"), [1.0, -1.0], 1, 0.0), "{wrap}");
    }
}

#[test]
fn what_is_hardly_deeper_than_a_pixel_is_as_well_seen_flat() {
    let maps = accuracy::maps();
    for named in maps.iter().filter(|named| ["cobbles", "ground"].contains(&named.name)) {
        for (texels, tilt_deg) in [(16.0, 45.0), (32.0, 45.0), (32.0, 70.0)] {
            let seen = Seen { map: &named.map, method: "cone", shadow: "none", texels, tilt_deg, side: 32 };
            let [levels, faded] = seen.shown(["footprint", "fade"]);
            let case = format!("{} {tilt_deg} {texels}: {levels:.4?}\n{faded:.4?}", named.name);
            println!("{case}");
            // Of smooth ground there is little to redistribute.
            let is_rough = named.name == "cobbles";
            assert!(faded.error < if is_rough { 0.8 } else { 1.5 } * levels.error, "{case}");
            assert!(faded.flicker < if is_rough { 0.5 } else { 1.1 } * levels.flicker, "{case}");
            assert!(faded.reads < 0.75 * levels.reads, "{case}");
            assert!((faded.brightness - 1.0).abs() < 0.04, "{case}");
        }
    }
}

#[test]
fn pictures_come_near_to_those_of_many_samples() {
    let maps = accuracy::maps();
    let named = |name: &str| &maps.iter().find(|named| named.name == name).expect("a sample map").map;
    for (map, shadow, tilt_deg) in [
        ("ground", "ray", 0.0),
        ("ground", "ray", 45.0),
        ("cobbles", "none", 0.0),
        ("cobbles", "none", 45.0),
        ("cobbles", "ray", 0.0),
        ("cobbles", "ray", 45.0),
    ] {
        for texels in [2.0, 4.0, 8.0] {
            let seen = Seen { map: named(map), method: "cone", shadow, texels, tilt_deg, side: 32 };
            let [none, levels] = seen.shown(["none", "footprint"]);
            let case = format!("{map} {shadow} {tilt_deg} {texels}: {none:.4?}\n{levels:.4?}");
            println!("{case}");
            assert!(levels.error < none.error, "{case}");
            assert!(levels.reads <= none.reads, "{case}");
            if tilt_deg > 0.0 && texels >= 4.0 {
                assert!(levels.reads < 0.95 * none.reads, "{case}");
            }
            if texels == 4.0 && (map == "ground" || (tilt_deg == 0.0 && shadow == "none")) {
                assert!(levels.flicker < 0.5 * none.flicker, "{case}");
            }
            if texels == 8.0 {
                let most = if map == "ground" || tilt_deg == 0.0 { 0.02 } else { 0.08 };
                assert!((levels.brightness - 1.0).abs() < most, "{case}");
            }
        }
    }
}

#[test]
fn nothing_reflects_more_light_than_falls_on_it() {
    // Normals are derived for the mean tile of a mesh, and a torus has longer and shorter ones.
    let map = accuracy::maps().into_iter().find(|named| named.name == "cobbles").expect("a sample map").map;
    let mesh = Builtin::Torus.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(Vec2::new(8.0, 3.0)));
    let surface = Surface::new(mesh.expect("a mesh"), map.with_displacement(0.05, -0.05).expect("lengths"));
    let mut selection = Selection::exact();
    selection.choose("detail", "footprint").expect("a listed name");
    let light = Light::directional(DVec3::new(-0.6, 0.6, -0.1), Vec3::ONE).expect("a light");
    let scene = shadows::under_one_light(
        surface.with_selection(selection),
        light,
        View::Corner,
        [200, 160],
        BackendChoice::Cpu,
    );
    let pixels = shadows::pixels(&scene.to_builder().samples(4).build().expect("a scene"));
    let seen_in_levels = pixels.iter().filter(|pixel| pixel.level > 0).count();
    let brightest = pixels.iter().map(|pixel| pixel.color.x).fold(0.0, f32::max);
    println!("{seen_in_levels} pixels in levels, the brightest {brightest}");
    assert!(seen_in_levels > 100, "{seen_in_levels}");
    // The five normals that stand for all are a little longer than one.
    assert!((0.5..1.25).contains(&brightest), "{brightest}");
}
