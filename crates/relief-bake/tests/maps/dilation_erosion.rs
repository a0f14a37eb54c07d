//! Dilation and erosion against the extremes of each window, and against the surface.

use std::sync::atomic::AtomicBool;

use relief_bake::kind::Reach;
use relief_bake::kind::dilation_erosion::{KIND, window_bounds};
use relief_bake::quantise;
use relief_core::{HeightMap, MaxPyramid, Metric, Watch, Wrap};
use relief_testing::probes::dilation_erosion as probes;
use relief_testing::probes::place::Place;
use relief_testing::probes::pyramid::holds;
use relief_testing::{brute, maps};
use relief_tests::probes::{run, stored};

/// Probes of each map, in each wrap.
const PROBES: usize = 100_000;

/// Erosion and dilation of every cell.
fn baked(map: &HeightMap, radius: u32, bits: u32) -> Vec<[f32; 2]> {
    let metric = Metric::new([2.0, 0.5], 0.1).expect("lengths");
    let set = [("radius", f64::from(radius)), ("bits", f64::from(bits))];
    let textures = stored::textures(&KIND, map, metric, &set).expect("a bake");
    let channels = &textures[0].levels[0];
    channels[0].iter().zip(&channels[1]).map(|(min, max)| [*min, *max]).collect()
}

#[test]
fn every_cell_has_the_extremes_of_its_window() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            let larger = map.width().max(map.height());
            for radius in [0, 1, 2, 7, larger / 2, larger - 1, larger, larger + 3] {
                if radius > 20 && map.texels().len() > 2000 {
                    continue; // The brute force would take minutes.
                }
                let brute = brute::dilation_erosion::window_bounds(&map, radius);
                assert!(baked(&map, radius, 0) == brute, "{} {wrap}, radius {radius}", named.name);
            }
        }
    }
}

#[test]
fn a_radius_beyond_the_map_sees_all_of_it() {
    let map = maps::ALL[3].build(Wrap::Mirror);
    let heights = map.texels().iter();
    let all = heights.fold([1.0f32, 0.0], |[low, high], &h| [h.min(low), h.max(high)]);
    assert!(baked(&map, relief_core::MAX_SIDE, 0).iter().all(|bounds| *bounds == all));
}

#[test]
fn the_surface_stays_within_in_any_bits() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn probes_catch_the_bounds_of_a_smaller_window() {
    let map = run::map(0);
    let (folding, bounds) = (MaxPyramid::new(&map), baked(&map, 4, 0));
    let read =
        |cell: [i64; 2]| bounds[(folding.row(cell[1]) * map.width() + folding.column(cell[0])) as usize];
    assert_eq!(probes::attack(&map, 4, read, PROBES, 1).violations, 0);
    assert!(probes::attack(&map, 5, read, PROBES, 1).violations > 0);
}

#[test]
fn rounded_bounds_are_the_bounds_of_rounded_heights() {
    for (wrap, bits) in Wrap::ALL.into_iter().zip([8, 16, 8]) {
        let map = maps::ALL[0].build(wrap);
        let rounded = quantise::heights(&map, bits).expect("a valid map");
        assert_eq!(baked(&map, 3, bits), baked(&rounded, 3, 0), "{wrap}, {bits} bits");
    }
}

#[test]
fn a_bound_one_step_too_tight_is_caught_where_it_touches() {
    let (radius, step) = (3i64, 1.0 / 65_535.0);
    for wrap in Wrap::ALL {
        let map = maps::ALL[0].build(wrap);
        let bounds = baked(&map, radius as u32, 0);
        for (at, &[least, most]) in bounds.iter().enumerate() {
            let cell = [at as i64 % i64::from(map.width()), at as i64 / i64::from(map.width())];
            let touching = |height: f32| {
                let mut around = (cell[1] - radius..=cell[1] + radius + 1)
                    .flat_map(|j| (cell[0] - radius..=cell[0] + radius + 1).map(move |i| [i, j]))
                    .map(|cell| Place { cell, within: [0.0; 2] });
                around.find(|place| place.height(&map) == f64::from(height)).expect("it is attained")
            };
            let (low, high) = (touching(least), touching(most));
            assert!(holds(&map, &low, [least, most]) && holds(&map, &high, [least, most]));
            assert!(
                !holds(&map, &low, [least + step, most]) && !holds(&map, &high, [least, most - step]),
                "{wrap}"
            );
        }
    }
}

#[test]
fn the_same_bytes_from_any_number_of_threads() {
    let map = HeightMap::new(300, 500, maps::fractal(3, 300, 500, 0.5), Wrap::Repeat).expect("a valid map");
    for radius in [4, 400] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| baked(&map, radius, 0))
        };
        assert!(on(1) == on(3));
    }
}

#[test]
fn the_reach_is_the_radius_and_the_cell() {
    let mut settings = KIND.defaults();
    settings.set("radius", 5.0).expect("a known radius");
    assert_eq!((KIND.reach)(&settings), Reach::Texels(6));
}

#[test]
fn a_cancelled_bake_ends() {
    let map = maps::ALL[1].build(Wrap::Clamp);
    let cancel = AtomicBool::new(true);
    assert!(window_bounds(&map, 3, &Watch::cancelled_by(&cancel)).is_err());
}
