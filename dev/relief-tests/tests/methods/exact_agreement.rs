//! The exact tracers against one another, over every adversarial map, wrap and kind of ray.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, FastTracer, PyramidTracer, cell_walk, least_gap};
use relief_core::{Cost, HeightMap, Path, Wrap};
use relief_testing::judge::{Tally, Verdict, judge};
use relief_testing::rays::{RayKind, Rays};
use relief_testing::{RAYS_PER_MAP, maps};

/// Height residual allowed to the two tracers in `f64`.
const EXACT: f64 = 1e-12;

fn every_map() -> Vec<(String, HeightMap)> {
    let both =
        |named: &maps::NamedMap| Wrap::ALL.map(|wrap| (format!("{} {wrap}", named.name), named.build(wrap)));
    maps::ALL.iter().flat_map(both).collect()
}

/// Judges a tracer's answers on a map by the cell walk's. Prints the rays on which they differ in hit
/// or miss, as long as their clearance grows.
fn agreement(
    name: &str,
    map: &HeightMap,
    rays: usize,
    tolerance: f64,
    trace: impl Fn(&Path) -> ExactHit,
) -> Tally {
    let mut tally = Tally::default();
    let mut widest = 0.0f64;
    for (kind, path) in Rays::new(map, 1).take(rays) {
        let (truth, other) = (cell_walk(map, &path), trace(&path));
        let verdict = judge(map, &path, &truth, &other, tolerance);
        match verdict {
            Ok(Verdict::Agree) => {}
            Ok(Verdict::Grazing) => {
                tally.grazing += 1;
                if truth.hit.found != other.hit.found {
                    let end = if path.exit.is_finite() { path.exit } else { truth.hit.t.max(other.hit.t) };
                    let clearance = least_gap(map, &path, 0.0, end);
                    if clearance.abs() > widest {
                        widest = clearance.abs();
                        println!(
                            "{name}, {kind:?}: hit or miss differs at a clearance of {clearance:e}: {path:?}"
                        );
                    }
                    assert!(clearance.abs() <= tolerance, "{path:?}");
                }
            }
            Err(disagreement) => panic!("{name}, {kind:?}: {disagreement}"),
        }
        tally.hits += usize::from(truth.hit.found);
        tally.misses += usize::from(!truth.hit.found);
    }
    tally
}

fn assert_is_a_fair_trial(tally: Tally, rays: usize) {
    println!("{tally:?}");
    assert_eq!(tally.hits + tally.misses, rays * maps::ALL.len() * Wrap::ALL.len());
    assert!(tally.hits > tally.misses / 4 && tally.misses > tally.hits / 10, "{tally:?}");
    assert!(tally.grazing < (tally.hits + tally.misses) / 10, "{tally:?}");
}

#[test]
fn the_two_exact_tracers_agree() {
    let tallies = every_map().into_par_iter().map(|(name, map)| {
        let tracer = PyramidTracer::new(&map);
        agreement(&name, &map, RAYS_PER_MAP, EXACT, |path| tracer.trace(path))
    });
    assert_is_a_fair_trial(tallies.reduce(Tally::default, Tally::plus), RAYS_PER_MAP);
}

#[test]
fn the_fast_tracer_is_within_its_bound() {
    let tallies = every_map().into_par_iter().map(|(name, map)| {
        let tracer = FastTracer::new(&map);
        agreement(&name, &map, RAYS_PER_MAP, FastTracer::ERROR, |path| {
            let hit = tracer.trace(path);
            let blocked = hit.hit.found && !hit.hit.exhausted;
            assert_eq!(tracer.is_blocked(path), blocked, "{name}: {path:?}");
            hit
        })
    });
    assert_is_a_fair_trial(tallies.reduce(Tally::default, Tally::plus), RAYS_PER_MAP);
}

/// The cell walk itself, by brute force: no sample before the hit is below the surface, and the hit is on it.
#[test]
fn the_cell_walk_agrees_with_dense_samples() {
    every_map().into_par_iter().for_each(|(name, map)| {
        for (kind, path) in Rays::new(&map, 2).take(RAYS_PER_MAP / 50) {
            let truth = cell_walk(&map, &path);
            let end = match (truth.hit.found, path.exit.is_finite()) {
                (true, _) => truth.hit.t,
                (false, true) => path.exit,
                (false, false) => 4.0,
            };
            for k in 0..1000 {
                let t = end * f64::from(k) / 1000.0;
                let gap = path.clearance(&map, t);
                assert!(
                    gap >= truth.clearance.min(0.0) - EXACT,
                    "{name}, {kind:?} at {t}: {gap:e}\n{path:?}\n{truth:?}"
                );
                let least = if truth.hit.found { f64::NEG_INFINITY } else { truth.clearance.min(1.0) };
                assert!(
                    gap >= least - EXACT,
                    "{name}, {kind:?}: {gap:e} is below the clearance\n{path:?}\n{truth:?}"
                );
            }
            if truth.hit.found && truth.hit.t > 0.0 {
                assert!(
                    path.clearance(&map, truth.hit.t).abs() <= EXACT,
                    "{name}, {kind:?}\n{path:?}\n{truth:?}"
                );
            }
        }
    });
}

/// The slope and the cell of a hit match the surface there.
#[test]
fn slope_and_cell_belong_to_the_hit() {
    every_map().into_par_iter().for_each(|(name, map)| {
        let (pyramid, fast) = (PyramidTracer::new(&map), FastTracer::new(&map));
        let size = [f64::from(map.width()), f64::from(map.height())];
        for (kind, path) in Rays::new(&map, 3).take(RAYS_PER_MAP / 10) {
            for hit in [cell_walk(&map, &path), pyramid.trace(&path), fast.trace(&path)] {
                if !hit.hit.found || hit.hit.exhausted {
                    continue;
                }
                let [u, v, _] = path.at(hit.hit.t);
                let within = [u * size[0] - 0.5 - hit.cell[0] as f64, v * size[1] - 0.5 - hit.cell[1] as f64];
                let inside = |x: &f64| (-1e-9..=1.0 + 1e-9).contains(x);
                assert!(within.iter().all(inside), "{name}, {kind:?}: {path:?}\n{hit:?}");
                // The derivative of the patch, from its corners.
                let [h00, h10, h01, h11] = map.cell(hit.cell[0], hit.cell[1]).map(f64::from);
                let along_u = (h10 - h00) + (h00 - h10 - h01 + h11) * within[1];
                let along_v = (h01 - h00) + (h00 - h10 - h01 + h11) * within[0];
                let speed = [path.duv[0] * size[0], path.duv[1] * size[1]];
                let slope = path.h[1] + 2.0 * path.h[2] * hit.hit.t - along_u * speed[0] - along_v * speed[1];
                let scale = 1.0 + slope.abs() + speed[0].abs() + speed[1].abs();
                assert!(
                    (slope - hit.slope).abs() <= 1e-9 * scale,
                    "{name}, {kind:?}: {slope}\n{path:?}\n{hit:?}"
                );
            }
        }
    });
}

/// The judge has teeth: changed answers and changed maps do not pass.
#[test]
fn mutations_are_noticed() {
    let map = maps::ALL[1].build(Wrap::Mirror);
    let mut texels = map.texels().to_vec();
    texels.iter_mut().step_by(97).for_each(|texel| *texel = (*texel + 0.01).min(1.0));
    let raised = HeightMap::new(map.width(), map.height(), texels, Wrap::Mirror).expect("still a valid map");
    let (tracer, of_raised) = (FastTracer::new(&map), FastTracer::new(&raised));
    let of_other_wrap = FastTracer::new(&map.clone().with_wrap(Wrap::Clamp));
    type Trace<'a> = &'a dyn Fn(&Path) -> ExactHit;
    let mutations: [(&str, Trace); 6] = [
        ("t behind", &|path| {
            let mut hit = tracer.trace(path);
            hit.hit.t += 1e-7 * f64::from(u8::from(hit.hit.found));
            hit
        }),
        ("t and all before", &|path| {
            let mut hit = tracer.trace(path);
            hit.hit.t *= 1.0 - 1e-7;
            let [u, v, _] = path.at(hit.hit.t);
            (hit.hit.uv, hit.hit.height) = ([u, v], map.height_at(u, v));
            hit
        }),
        ("hits dropped", &|_| ExactHit::miss(Cost::default(), 0.0)),
        ("second hit", &|path| {
            let first = tracer.trace(path);
            let came_out = (1..100)
                .map(|k| first.hit.t + 0.01 * f64::from(k))
                .find(|t| *t < path.exit && path.clearance(&map, *t) > 0.01);
            let Some(start) = came_out.filter(|_| first.hit.found) else {
                return first;
            };
            let [u, v, h] = path.at(start);
            let rest = Path { uv: [u, v], h: [h, path.h[1], 0.0], exit: path.exit - start, ..*path };
            let mut second = tracer.trace(&rest);
            second.hit.t += start;
            if second.hit.found { second } else { first }
        }),
        ("raised texels", &|path| of_raised.trace(path)),
        ("other wrap", &|path| of_other_wrap.trace(path)),
    ];
    for (name, mutated) in mutations {
        let mut noticed = 0;
        let mut rays = Rays::new(&map, 4);
        for _ in 0..2000 {
            let path = rays.of_kind(RayKind::Random);
            let truth = cell_walk(&map, &path);
            noticed += usize::from(judge(&map, &path, &truth, &mutated(&path), FastTracer::ERROR).is_err());
        }
        println!("{name}: noticed on {noticed} of 2000 rays");
        assert!(noticed >= 20, "{name}: noticed on {noticed} of 2000 rays");
    }
}
