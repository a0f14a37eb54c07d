//! Levels of detail: each is traced as the map that it is, and pictures come near to those of many samples.

use rayon::prelude::*;
use relief_core::{MapFormat, Path, Wrap};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_tests::accuracy;
use relief_tests::baked::{maps_in, slots};
use relief_tests::detail::Seen;
use relief_tests::maps;
use relief_tests::pairs;
use relief_tests::rays::Rays;

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
            if levels.check().is_err() {
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
            if tilt_deg > 0.0 && texels > 4.0 {
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
