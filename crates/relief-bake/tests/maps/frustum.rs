//! The quadrant frustum map against brute force, against the surface, and in use against the exact
//! first hit.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use relief_bake::kind::frustum::{FrustumMap, FrustumMapError, KIND, frustum_map, quadrant};
use relief_bake::{Collected, bake, quantise};
use relief_core::exact::cell_walk;
use relief_core::rng::Rng;
use relief_core::{HeightMap, MaxPyramid, Metric, Path, Rounding, Watch, Wrap};
use relief_testing::brute::frustum as brute;
use relief_testing::judge::judge;
use relief_testing::maps;
use relief_testing::probes::frustum::{Frustum, attack};
use relief_testing::rays::{RayKind, Rays};
use relief_testing::search::frustum::search;
use relief_testing::search::pyramid::search as quadtree;
use relief_tests::probes::{run, stored};

/// Probes of each map, and rays through it, in each number of bits.
const PROBES: usize = 100_000;

/// Factor by which a slope may exceed the least.
const TIE: f32 = 1.0 + 1.0 / 65536.0;

/// Height residual up to which a search's answer counts as exact, as for the exact tracers.
const TOLERANCE: f64 = 2e-12;

const QUADRANTS: [[bool; 2]; 4] = [[true, true], [false, true], [true, false], [false, false]];

/// Returns the map as stored in `bits` bits.
fn baked(map: &HeightMap, bits: u32) -> FrustumMap {
    let metric = Metric::new([2.0, 0.5], 0.1).expect("lengths");
    let textures = stored::textures(&KIND, map, metric, &[("bits", f64::from(bits))]).expect("a bake");
    stored::frustum_map(map, &textures)
}

fn read(frusta: &FrustumMap) -> impl Fn([i64; 2], [bool; 2]) -> Frustum + '_ {
    |cell, forward| stored::frustum(frusta, cell, forward)
}

fn highest(map: &HeightMap) -> f64 {
    brute::highest(map)
}

#[test]
fn every_slope_is_the_brute_forces_rounded_up() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            let frusta = frustum_map(&map, &Watch::none()).expect("not cancelled");
            let (width, most) = (map.width(), 2 * i64::from(map.width().max(map.height())) + 4);
            (0..map.texels().len()).into_par_iter().for_each(|at| {
                let cell = [(at as u32 % width).into(), (at as u32 / width).into()];
                assert_eq!(frusta.top()[at], map.cell(cell[0], cell[1]).into_iter().fold(0.0, f32::max));
                for forward in QUADRANTS {
                    let slow = brute::least_slope(&map, highest(&map), cell, forward, most).slope;
                    let fast = frusta.slopes(forward)[at];
                    let above = f64::from((slow as f32 * TIE).next_up().next_up()) + 4e-15;
                    let within = f64::from(fast) >= slow && f64::from(fast) <= above;
                    assert!(within, "{} {wrap} {cell:?} {forward:?}: {fast:e} and {slow:e}", named.name);
                }
            });
        }
    }
}

#[test]
fn no_place_of_the_surface_is_above_a_frustum_in_any_bits() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn probes_catch_frusta_that_are_too_low() {
    let map = run::map(0);
    let frusta = baked(&map, 0);
    let lowered = |cell, forward| {
        let frustum = read(&frusta)(cell, forward);
        Frustum { slope: 0.99 * frustum.slope, ..frustum }
    };
    assert!(attack(&map, lowered, PROBES, 1).violations > 0);
}

#[test]
fn no_ray_passes_the_exact_first_hit_in_any_bits() {
    for (at, (name, wrap)) in run::MAPS.into_iter().enumerate() {
        let map = run::map(at);
        for bits in [0, 8, 16] {
            let (decoded, frusta) = (stored::heights(&map, bits).expect("valid"), baked(&map, bits));
            let lanes = 64;
            let wrong = (0..lanes).into_par_iter().find_map_first(|lane| {
                let mut rays = Rays::new(&decoded, 1000 * at as u64 + lane);
                let paths = rays.by_ref().filter(|(kind, _)| *kind != RayKind::Endless);
                paths.take(PROBES / lanes as usize + 1).find_map(|(kind, path)| {
                    let truth = cell_walk(&decoded, &path);
                    let found = search(&decoded, &path, read(&frusta));
                    let verdict = judge(&decoded, &path, &truth, &found.answer, TOLERANCE);
                    verdict.err().map(|wrong| format!("{kind:?}: {wrong}"))
                })
            });
            assert_eq!(wrong, None, "{name} {wrap}, {bits} bits");
        }
    }
}

#[test]
fn a_slope_one_step_too_low_is_caught_where_it_touches() {
    for (at, wrap) in [(0, Wrap::Repeat), (3, Wrap::Clamp), (3, Wrap::Mirror)] {
        let map = maps::ALL[at].build(wrap);
        let frusta = baked(&map, 16);
        let decoded = quantise::heights(&map, 16).expect("valid");
        let steepest =
            QUADRANTS.into_iter().flat_map(|forward| frusta.slopes(forward)).copied().fold(0.0, f32::max);
        let step = f64::from(steepest) / 32_767.0;
        let (width, height) = (i64::from(map.width()), i64::from(map.height()));
        let mut caught = 0;
        for cell in (0..height).flat_map(|j| (0..width).map(move |i| [i, j])) {
            for forward in QUADRANTS {
                let slow =
                    brute::least_slope(&decoded, highest(&decoded), cell, forward, 2 * width.max(height) + 2);
                let Some(place) = slow.touches else { continue };
                let mut frustum = read(&frusta)(cell, forward);
                assert!(frustum.holds(&decoded, &place, forward), "{wrap} {cell:?} {forward:?}");
                frustum.slope -= step;
                assert!(!frustum.holds(&decoded, &place, forward), "{wrap} {cell:?} {forward:?} {slow:?}");
                caught += 1;
            }
        }
        assert!(caught > 4000, "only {caught} slopes touch anything");
    }
}

#[test]
fn rays_catch_a_map_that_is_too_low() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    let (top, slopes) = frustum_map(&map, &Watch::none()).expect("not cancelled").into_planes();
    let lowered = slopes.map(|plane| plane.into_iter().map(|slope| slope * 0.9).collect());
    let frusta = FrustumMap::new([map.width(), map.height()], map.wrap(), top, lowered).expect("planes");
    let wrong =
        Rays::new(&map, 5).filter(|(kind, _)| *kind != RayKind::Endless).take(20_000).any(|(_, path)| {
            let found = search(&map, &path, read(&frusta));
            judge(&map, &path, &cell_walk(&map, &path), &found.answer, TOLERANCE).is_err()
        });
    assert!(wrong);
}

/// Returns the steps a ray of the frustum search, the quadtree search and the cell walk. They are
/// means over rays from the top of a relief a tenth of the tile deep, at elevations from 5 to 85
/// degrees.
fn steps(map: &HeightMap) -> [f64; 3] {
    let frusta = frustum_map(map, &Watch::none()).expect("not cancelled");
    let pyramid = MaxPyramid::new(map);
    let mut rng = Rng::new(1);
    let count = 20_000;
    let mut sums = [0.0; 3];
    for _ in 0..count {
        let (azimuth, elevation) =
            (rng.between(0.0, std::f64::consts::TAU), rng.between(5.0, 85.0).to_radians());
        let (across, from) = (0.1 / elevation.tan(), [rng.unit(), rng.unit()]);
        let to = [from[0] + across * azimuth.cos(), from[1] + across * azimuth.sin()];
        let path = Path::between([from[0], from[1], 1.0], [to[0], to[1], 0.0]);
        let taken = [
            search(map, &path, read(&frusta)).steps,
            quadtree(map, &pyramid, &path).steps,
            cell_walk(map, &path).hit.cost.reads,
        ];
        for (sum, steps) in sums.iter_mut().zip(taken) {
            *sum += f64::from(steps) / f64::from(count);
        }
    }
    sums
}

#[test]
fn rays_take_fewer_steps_than_through_the_pyramid_and_the_cells() {
    let natural =
        HeightMap::new(256, 256, maps::fractal(7, 256, 256, 0.55), Wrap::Repeat).expect("a valid map");
    let mut rng = Rng::new(9);
    let noise = HeightMap::from_fn(256, 256, Wrap::Repeat, |_, _| rng.unit() as f32).expect("a valid map");
    for (name, map) in [("natural", natural), ("white noise", noise)] {
        let [frustum, pyramid, walk] = steps(&map);
        println!("{name} 256x256: {frustum:.1} frusta, {pyramid:.1} nodes, {walk:.1} cells a ray");
        assert!(frustum < 0.75 * pyramid && frustum < 0.75 * walk, "{name}: {frustum} {pyramid} {walk}");
    }
}

#[test]
fn the_metric_and_the_threads_do_not_matter() {
    let map = HeightMap::new(150, 90, maps::fractal(3, 150, 90, 0.5), Wrap::Repeat).expect("a valid map");
    let on = |threads: usize, metric: Metric| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let mut collected = Collected::default();
        pool.install(|| bake(&KIND, &map, metric, &KIND.defaults(), &Watch::none(), &mut collected))
            .expect("a bake");
        collected
    };
    let one = on(1, Metric::unit_tile(1.0).expect("a length"));
    assert!(one == on(3, Metric::new([0.1, 7.0], 3.0).expect("lengths")));
    assert_eq!(
        one.textures.iter().map(|texture| texture.texture.name).collect::<Vec<_>>(),
        ["top", "slopes"]
    );
}

#[test]
fn stored_slopes_need_no_rounding() {
    let map = maps::ALL[2].build(Wrap::Repeat);
    for bits in [8, 16] {
        let mut settings = KIND.defaults();
        settings.set("bits", f64::from(bits)).expect("a known number of bits");
        let mut collected = Collected::default();
        let metric = Metric::unit_tile(1.0).expect("a length");
        bake(&KIND, &map, metric, &settings, &Watch::none(), &mut collected).expect("a bake");
        for texture in &collected.textures {
            for (channel, plane) in texture.texture.channels.iter().zip(&texture.levels[0]) {
                let [low, high] = channel.range;
                assert!(plane.iter().all(|value| (low..=high).contains(value)));
                let stored = |value: f32| quantise::unorm(value / high, bits, Rounding::Nearest) * high;
                assert!(plane.iter().all(|&value| stored(value) == value), "{bits} bits");
            }
        }
    }
}

#[test]
fn wrong_planes_are_refused() {
    let planes = || [0; 4].map(|_| vec![0.0; 6]);
    assert!(FrustumMap::new([3, 2], Wrap::Clamp, vec![0.0; 6], planes()).is_ok());
    let short = FrustumMap::new([3, 2], Wrap::Clamp, vec![0.0; 5], planes());
    assert_eq!(short, Err(FrustumMapError::Length { cells: 6, given: 5 }));
    let mut negative = planes();
    negative[quadrant([false, true])][3] = -1.0;
    let negative = FrustumMap::new([3, 2], Wrap::Clamp, vec![0.0; 6], negative);
    assert_eq!(negative, Err(FrustumMapError::Value { value: -1.0 }));
    assert!(FrustumMap::new([0, 2], Wrap::Clamp, vec![], [0; 4].map(|_| vec![])).is_err());
}

#[test]
fn a_cancelled_bake_ends() {
    let map = maps::ALL[1].build(Wrap::Clamp);
    let cancel = AtomicBool::new(true);
    assert!(frustum_map(&map, &Watch::cancelled_by(&cancel)).is_err());
}
