//! The exact tracers on paths that no renderer should make: endless, far away, huge, tiny, not a number.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, FastTracer, MAX_START, MAX_TRAVEL, PyramidTracer, cell_walk, least_gap};
use relief_core::rng::Rng;
use relief_core::{Cost, HeightMap, Path, PathMetric, Wrap};
use relief_testing::judge::judge;
use relief_testing::maps;

/// No path may cost more reads: a pyramid tracer reads some tens of nodes for each cell that it comes down
/// to.
const MOST_READS: f64 = 64.0 * MAX_TRAVEL;

fn path(uv: [f64; 2], duv: [f64; 2], h: [f64; 3], exit: f64) -> Path {
    Path { uv, duv, h, exit, base: 0.0, metric: PathMetric::unit(1.0) }
}

/// Wild paths a map. A few in a hundred are followed for [`MAX_TRAVEL`] cells.
const PATHS: usize = 150;

/// A valley along `u`: rows at height 0 and 1 by turns.
fn valley(wrap: Wrap) -> HeightMap {
    HeightMap::from_fn(16, 4, wrap, |_, j| (j % 2) as f32).expect("a valid map")
}

fn all(map: &HeightMap, path: &Path) -> [ExactHit; 3] {
    [cell_walk(map, path), PyramidTracer::new(map).trace(path), FastTracer::new(map).trace(path)]
}

#[test]
fn an_endless_path_down_a_valley_is_given_up_by_all() {
    for wrap in Wrap::ALL {
        let map = valley(wrap);
        // The middle of row 0 lies at height 0.
        for answer in all(&map, &path([0.3, 0.125], [1.0, 0.0], [0.5, 0.0, 0.0], f64::INFINITY)) {
            assert!(answer.hit.found && answer.hit.exhausted, "{wrap}: {answer:?}");
            assert!((answer.clearance - 0.5).abs() < 1e-6, "{wrap}: {answer:?}");
            assert!(f64::from(answer.hit.cost.reads) <= MOST_READS, "{wrap}: {answer:?}");
        }
    }
}

#[test]
fn endless_paths_that_come_down_hit_and_others_miss() {
    for wrap in Wrap::ALL {
        let map = valley(wrap);
        let endless = |uv, duv, h| path(uv, duv, h, f64::INFINITY);
        let hitting = [
            endless([0.3, 0.125], [1.0, 0.0], [0.5, -1e-3, 0.0]),
            endless([0.3, 0.125], [1e-3, 0.0], [9.0, 1.0, -1e-3]),
            endless([0.3, 0.4], [0.0, 0.0], [2.0, -1e-9, 0.0]),
            endless([0.3, 0.125], [0.1, 0.0], [1e6, -10.0, 0.0]),
        ];
        for path in &hitting {
            for answer in all(&map, path) {
                assert!(answer.hit.found && !answer.hit.exhausted, "{wrap}: {path:?}\n{answer:?}");
            }
        }
        let missing = [
            endless([0.3, 0.125], [1.0, 0.0], [0.5, 1e-3, 0.0]),
            endless([0.3, 0.125], [1.0, 1.0], [1.0 + 1e-12, 0.0, 0.0]),
            endless([0.3, 0.125], [0.0, 0.0], [0.5, 0.0, 0.0]),
            endless([0.3, 0.125], [0.0, 0.0], [0.5, 0.0, 1.0]),
            endless([0.3, 0.125], [1.0, 1.0], [3.0, -2.0, 0.7]),
        ];
        for path in &missing {
            for answer in all(&map, path) {
                assert!(!answer.hit.found && answer.clearance >= 0.0, "{wrap}: {path:?}\n{answer:?}");
            }
        }
    }
}

#[test]
fn paths_that_cannot_be_traced_are_misses() {
    let map = valley(Wrap::Repeat);
    let sane = path([0.5, 0.5], [0.1, 0.1], [1.0, -1.0, 0.0], 1.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let broken = [
            Path { uv: [bad, 0.5], ..sane },
            Path { duv: [0.1, bad], ..sane },
            Path { h: [bad, 0.0, 0.0], ..sane },
            Path { h: [1.0, bad, 0.0], ..sane },
            Path { h: [1.0, 0.0, bad], ..sane },
        ];
        for path in &broken {
            assert_eq!(all(&map, path), [ExactHit::miss(Cost::default(), 0.0); 3], "{path:?}");
            assert_eq!(least_gap(&map, path, 0.0, 1.0), f64::INFINITY);
        }
    }
    for exit in [f64::NAN, -1.0, f64::NEG_INFINITY] {
        assert_eq!(all(&map, &Path { exit, ..sane }), [ExactHit::miss(Cost::default(), 0.0); 3]);
    }
    let far = Path { uv: [MAX_START, 0.5], ..sane };
    assert_eq!(all(&map, &far), [ExactHit::miss(Cost::default(), 0.0); 3]);
}

/// Numbers of every magnitude: nothing panics, hangs, or leaves the path.
#[test]
fn any_finite_path_is_answered() {
    let number = |rng: &mut Rng| {
        let size = rng.pick(&[0.0, -0.0, 5e-324, 1e-300, 1e-30, 1e-9, 1.0, 3.7, 1e3, 1e9, 1e30, 1e89, 1e300]);
        size * rng.pick(&[-1.0, 1.0]) * if rng.below(2) == 0 { rng.between(0.5, 1.0) } else { 1.0 }
    };
    let maps = [maps::ALL[0], maps::ALL[12], maps::ALL[13]];
    let each = maps.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named.name, named.build(wrap))));
    each.collect::<Vec<_>>().into_par_iter().for_each(|(name, map)| {
        let (pyramid, fast) = (PyramidTracer::new(&map), FastTracer::new(&map));
        let mut rng = Rng::new(11);
        for _ in 0..PATHS {
            let uv = [number(&mut rng), number(&mut rng)];
            let duv = [number(&mut rng), number(&mut rng)];
            let h = [rng.between(0.0, 1.2), number(&mut rng), number(&mut rng)];
            let exit = if rng.below(8) == 0 { f64::INFINITY } else { number(&mut rng).abs() };
            let path = path(uv, duv, h, exit);
            for answer in [cell_walk(&map, &path), pyramid.trace(&path), fast.trace(&path)] {
                let hit = answer.hit;
                assert!((0.0..=exit).contains(&hit.t), "{name} {}: {path:?}\n{answer:?}", map.wrap());
                assert!((0.0..=1.0).contains(&hit.height), "{name} {}: {path:?}\n{answer:?}", map.wrap());
                assert!(
                    f64::from(hit.cost.reads) <= MOST_READS,
                    "{name} {}: {path:?}\n{answer:?}",
                    map.wrap()
                );
            }
        }
    });
}

/// The unit of `t` does not matter: the same path at a trillionth and a trillion times the speed hits at the
/// same place.
#[test]
fn the_answer_does_not_depend_on_the_unit_of_t() {
    let mut rng = Rng::new(12);
    for wrap in Wrap::ALL {
        let map = maps::ALL[2].build(wrap);
        let fast = FastTracer::new(&map);
        for _ in 0..2000 {
            let [u, v, du, dv] = [rng.unit(), rng.unit(), rng.between(-0.4, 0.4), rng.between(-0.4, 0.4)];
            let base = path([u, v], [du, dv], [1.0, -1.0, 0.0], 1.0);
            let truth = cell_walk(&map, &base);
            for unit in [1e-12, 1e12] {
                let scaled = path([u, v], [du / unit, dv / unit], [1.0, -1.0 / unit, 0.0], unit);
                let mut answer = fast.trace(&scaled);
                answer.hit.t /= unit;
                answer.slope *= unit;
                let verdict = judge(&map, &base, &truth, &answer, 2.0 * FastTracer::ERROR);
                assert!(
                    verdict.is_ok(),
                    "{wrap}, {unit:e}: {}",
                    verdict.map_or_else(|wrong| wrong.to_string(), |_| String::new())
                );
            }
        }
    }
}

/// Far from the origin and far inside a large map, the error grows in proportion and no more.
#[test]
fn large_maps_and_distant_tiles() {
    let map = HeightMap::new(1024, 640, maps::fractal(3, 1024, 640, 0.6), Wrap::Repeat).expect("a valid map");
    let (pyramid, fast) = (PyramidTracer::new(&map), FastTracer::new(&map));
    let mut rng = Rng::new(13);
    for distance in [1.0, 1e2, 1e4] {
        let tolerance = FastTracer::ERROR * (1.0 + distance * 1024.0 / 4096.0) * 2.0;
        for _ in 0..2000 {
            let uv = [0, 1].map(|_| (rng.between(-1.0, 1.0) * distance).round() + rng.unit());
            let duv = [0, 1].map(|_| rng.between(-0.5, 0.5));
            let path = path(uv, duv, [1.0, -1.0, 0.0], 1.0);
            let truth = cell_walk(&map, &path);
            for answer in [pyramid.trace(&path), fast.trace(&path)] {
                let verdict = judge(&map, &path, &truth, &answer, tolerance);
                assert!(
                    verdict.is_ok(),
                    "{}",
                    verdict.map_or_else(|wrong| wrong.to_string(), |_| String::new())
                );
            }
        }
    }
}

/// Same map, same path, same bits: whoever builds the hierarchy and with however many threads.
#[test]
fn answers_are_deterministic() {
    let map = maps::ALL[0].build(Wrap::Mirror);
    let trace = |threads: usize| {
        let pool =
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
        pool.install(|| {
            let fast = FastTracer::new(&map);
            let rays = relief_testing::rays::Rays::new(&map, 6).take(2000);
            rays.map(|(_, path)| fast.trace(&path)).collect::<Vec<_>>()
        })
    };
    assert_eq!(trace(1), trace(3));
}
