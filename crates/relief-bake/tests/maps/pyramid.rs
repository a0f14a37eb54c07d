//! The pyramid against the extremes of each node's cells, and against the surface.

use std::sync::atomic::AtomicBool;

use relief_bake::kind::pyramid::{KIND, OVER_LEVELS, OVER_TEXELS, pyramids};
use relief_bake::{BakeError, Collected, CollectedTexture, bake};
use relief_core::exact::cell_walk;
use relief_core::{HeightMap, MaxPyramid, Metric, Watch, Wrap};
use relief_testing::judge::judge;
use relief_testing::probes::place::Place;
use relief_testing::probes::pyramid as probes;
use relief_testing::rays::{RayKind, Rays};
use relief_testing::search::pyramid::search;
use relief_testing::{brute, maps};
use relief_tests::probes::run;
use relief_tests::probes::stored::{self, pair as node};

/// Probes of each map in each wrap and number of bits.
const PROBES: usize = 100_000;

fn baked_with(map: &HeightMap, setting: (&str, u32)) -> CollectedTexture {
    let metric = Metric::new([2.0, 0.5], 0.1).expect("lengths");
    stored::textures(&KIND, map, metric, &[(setting.0, f64::from(setting.1))]).expect("a bake").remove(0)
}

fn baked(map: &HeightMap, bits: u32) -> CollectedTexture {
    baked_with(map, ("bits", bits))
}

/// Returns all nodes of a level, row by row.
fn nodes(texture: &CollectedTexture, level: usize) -> Vec<[f32; 2]> {
    let [width, height, _] = texture.texture.level_size(level);
    let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    places.map(|(column, row)| node(texture, level, column, row)).collect()
}

#[test]
fn every_node_of_every_level_is_the_extremes_of_its_cells() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            let texture = baked(&map, 0);
            let mut size = [map.width(), map.height(), 1];
            for level in 0..texture.levels.len() {
                assert_eq!(texture.texture.level_size(level), size, "{} {wrap}", named.name);
                let brute = brute::pyramid::level(&map, level as u32);
                assert_eq!(nodes(&texture, level), brute, "{} {wrap}, level {level}", named.name);
                size = [size[0].div_ceil(2), size[1].div_ceil(2), 1];
            }
            assert_eq!(texture.levels.last().map(|channels| channels[0].len()), Some(1));
        }
    }
}

#[test]
fn over_levels_every_node_is_the_extremes_of_its_cells_in_all_of_them() {
    let mut are_wider = 0;
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            let (finest, all) = (baked(&map, 0), baked_with(&map, ("over", OVER_LEVELS)));
            for level in 0..all.levels.len() {
                let brute = brute::pyramid::level_over_levels(&map, level as u32);
                assert_eq!(nodes(&all, level), brute, "{} {wrap}, level {level}", named.name);
                are_wider += usize::from(nodes(&finest, level) != brute);
            }
        }
    }
    assert!(are_wider > 0, "the levels of detail lie within the bounds of the finest on every map");
}

#[test]
fn over_texels_every_node_is_the_extremes_of_its_texels() {
    for named in maps::ALL {
        let map = named.build(Wrap::Clamp);
        let texture = baked_with(&map, ("over", OVER_TEXELS));
        for level in 0..texture.levels.len() {
            let [width, height, _] = texture.texture.level_size(level);
            for (column, row) in (0..height).flat_map(|row| (0..width).map(move |column| (column, row))) {
                let along = |node: u32, size: u32| (node << level)..((node + 1) << level).min(size);
                let texels = along(row, map.height()).flat_map(|j| {
                    let map = &map;
                    along(column, map.width()).map(move |i| map.texel(i64::from(i), i64::from(j)))
                });
                let (least, greatest) = texels
                    .fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), texel| (a.min(texel), b.max(texel)));
                assert_eq!(node(&texture, level, column, row), [least, greatest], "{} {level}", named.name);
            }
        }
    }
}

#[test]
fn the_surface_stays_within_every_level_in_any_bits() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn a_quadtree_search_never_passes_the_exact_first_hit() {
    for (at, named) in maps::ALL.iter().enumerate() {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            let pyramid = MaxPyramid::new(&map);
            let paths = Rays::new(&map, at as u64).filter(|(kind, _)| *kind != RayKind::Endless);
            for (kind, path) in paths.take(PROBES / 20) {
                let found = search(&map, &pyramid, &path);
                let verdict = judge(&map, &path, &cell_walk(&map, &path), &found.answer, 2e-12);
                assert!(verdict.is_ok(), "{} {wrap}, {kind:?}: {verdict:?}", named.name);
            }
        }
    }
}

#[test]
fn stored_values_need_no_rounding() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    for bits in [8, 16] {
        for channel in baked(&map, bits).levels.iter().flatten() {
            for &value in channel {
                let rounded = relief_bake::quantise::unorm(value, bits, relief_core::Rounding::Nearest);
                assert_eq!(rounded, value, "{bits} bits");
            }
        }
    }
}

#[test]
fn a_node_one_step_too_tight_is_caught_where_it_touches() {
    let step = 1.0 / 65_535.0;
    for wrap in Wrap::ALL {
        let map = maps::ALL[0].build(wrap);
        let texture = baked(&map, 0);
        for level in 0..texture.levels.len() {
            let [columns, rows, _] = texture.texture.level_size(level);
            for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
                let [least, most] = node(&texture, level, column, row);
                let touching = |height: f32| {
                    let (left, top) = (column << level, row << level);
                    let cells = (top..(top + (1 << level)).min(map.height()))
                        .flat_map(|j| (left..(left + (1 << level)).min(map.width())).map(move |i| [i, j]));
                    let corners = cells.flat_map(|cell| {
                        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]
                            .map(|within| Place { cell: cell.map(i64::from), within })
                    });
                    corners
                        .into_iter()
                        .find(|place| place.height(&map) == f64::from(height))
                        .expect("it is attained")
                };
                let (low, high) = (touching(least), touching(most));
                assert!(
                    probes::holds(&map, &low, [least, most]) && probes::holds(&map, &high, [least, most])
                );
                assert!(!probes::holds(&map, &low, [least + step, most]), "{wrap}, level {level}");
                assert!(!probes::holds(&map, &high, [least, most - step]), "{wrap}, level {level}");
            }
        }
    }
}

#[test]
fn a_cancelled_bake_ends_and_progress_reaches_the_end() {
    let map = maps::ALL[1].build(Wrap::Mirror);
    let cancel = AtomicBool::new(true);
    assert!(pyramids(&map, &Watch::cancelled_by(&cancel)).is_err());
    let metric = Metric::unit_tile(1.0).expect("a length");
    let cancelled =
        bake(&KIND, &map, metric, &KIND.defaults(), &Watch::cancelled_by(&cancel), &mut Collected::default());
    assert!(matches!(cancelled, Err(BakeError::Cancelled(_))));
    let last = std::sync::Mutex::new(0.0f32);
    let keep = |_: &str, part: f32| {
        let mut last = last.lock().expect("no panic while it is held");
        *last = last.max(part);
    };
    pyramids(&map, &Watch::telling(&keep)).expect("not cancelled");
    assert_eq!(*last.lock().expect("no panic while it was held"), 1.0);
}
