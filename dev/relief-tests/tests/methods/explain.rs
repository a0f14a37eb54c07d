//! The marks of loops: what is drawn is what the method does.

use relief_core::{HeightMap, Path, Wrap};
use relief_shaders::cpu::{Explanation, Mark, MethodTracer};
use relief_shaders::refine;
use relief_testing::maps;
use relief_testing::rays::{RayKind, Rays};
use relief_tests::baked::{maps_for, slots};
use relief_tests::pairs;

/// Rays a pair and a map.
const RAYS: usize = 400;

fn map(wrap: Wrap) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("a listed map");
    named.build(wrap)
}

/// Calls `look` with every pair's drawing of every ray, straight and bent, and the hit of its tracer.
fn each(mut look: impl FnMut(&str, &HeightMap, &Path, &Explanation, &MethodTracer)) {
    for (number, selection) in pairs::all().enumerate() {
        let map = map(Wrap::ALL[number % Wrap::ALL.len()]);
        let baked = maps_for(&map, &selection);
        let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
        let finite = Rays::new(&map, 7).filter(|(kind, _)| *kind != RayKind::Endless);
        for (_, path) in finite.take(RAYS) {
            look(&pairs::name(&selection), &map, &path, &tracer.explain(&path), &tracer);
        }
    }
}

#[test]
fn turns_are_the_steps_of_the_same_path() {
    let mut turns = 0;
    each(|name, _, path, drawn, tracer| {
        assert_eq!(drawn.hit, tracer.first_hit(path), "{name} {path:?}");
        assert_eq!(drawn.turns(), drawn.hit.cost.steps as usize, "{name} {path:?}");
        turns += drawn.turns();
    });
    assert!(turns > 100_000, "{turns} turns");
}

#[test]
fn marks_hold_what_the_search_looked_at() {
    let mut kinds = [0usize; 8];
    each(|name, map, path, drawn, _| {
        let at = Path::from(&relief_shaders::cpu::Path::from(path));
        for mark in drawn.marks() {
            let near = |wanted: f64, found: f64| (wanted - found).abs() < 1e-3 * (1.0 + found.abs());
            let (kind, holds) = match *mark {
                Mark::Turn { t } => (0, t.is_finite()),
                // Without a bracket a chord may lead anywhere.
                Mark::Sample { t } => (1, t.is_finite()),
                Mark::Patch { low, high, from, to } => {
                    // A tested part of the ray lies over the cell, but for rounding.
                    let middle = at.at(0.5 * (from + to));
                    let inside = |axis: usize| {
                        (low[axis] - 1e-3..=high[axis] + 1e-3).contains(&middle[axis]) || to <= from
                    };
                    (2, inside(0) && inside(1))
                }
                Mark::Box { low, high, top } => {
                    let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
                    // Extents beside a clamped map have no end.
                    let is_near = (high[0] - low[0]).max(high[1] - low[1]) < 4.0;
                    let is_columns = name.starts_with("pyramid-texels");
                    (3, !is_near || is_columns || map.height_at(middle[0], middle[1]) <= top + 1e-6)
                }
                Mark::Cone { uv, apex, slope } => {
                    (4, slope >= 0.0 && near(map.height_at(uv[0], uv[1]), apex))
                }
                Mark::Frustum { low, high, top, .. } => {
                    let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
                    (5, map.height_at(middle[0], middle[1]) <= top + 1e-6)
                }
                Mark::Ball { t, radius } => (6, radius > 0.0 && t.is_finite()),
                // Only halving keeps the order where the path begins below the surface.
                Mark::Bracket { near, far } => (7, near <= far || name.ends_with("secant")),
                Mark::Chord { ends, gaps } => (7, ends.iter().chain(&gaps).all(|it| it.is_finite())),
                Mark::Plane { t, height, .. } => {
                    let [u, v, _] = at.at(t);
                    (7, near(map.height_at(u, v), height))
                }
            };
            assert!(holds, "{name}: {mark:?} on {path:?}");
            kinds[kind] += 1;
        }
    });
    assert!(kinds.iter().all(|count| *count > 100), "{kinds:?}");
}

#[test]
fn methods_without_a_search_have_no_turns_in_it() {
    let map = map(Wrap::Repeat);
    let path = Path::between([0.1, 0.2, 1.0], [0.4, 0.6, 0.0]);
    for entry in refine::ENTRIES {
        let Ok(selection) = relief_shaders::Selection::pair("none", entry.name) else { continue };
        if selection.check_pair().is_ok() {
            let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &[]));
            let drawn = tracer.explain(&path);
            assert!(drawn.search.is_empty() && drawn.interval == [0.0, 1.0], "{}: {drawn:?}", entry.name);
        }
    }
}
