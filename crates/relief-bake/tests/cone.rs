//! The kind `cone`: equal to brute force, safe under attack, tight, and what its cones cost a search.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use relief::exact::least_gap;
use relief::{HeightMap, Path, Wrap};
use relief_bake::kind::cone::{ConeApex, KIND, cone_ratios, decode};
use relief_bake::{Collected, Metric, Progress, bake, quantise};
use relief_tests::brute;
use relief_tests::maps::{self, fractal};
use relief_tests::probes::cone::{Contact, Probes, attack};
use relief_tests::rng::Rng;

/// Probes of each map in each form.
const PROBES: usize = 100_000;

/// The maps that are attacked.
const ATTACKED: [&str; 8] = [
    "white noise 37x53",
    "natural 128x128",
    "natural 101x67",
    "single spike 33x31",
    "needles in a pit 64x64",
    "checkerboard 24x24",
    "steps 61x40",
    "one row 1x29",
];

fn metrics() -> [Metric; 2] {
    [[1.0, 1.0], [3.0, 0.7]].map(|tile| Metric::new(tile, 0.1).expect("positive lengths"))
}

fn attacked() -> Vec<HeightMap> {
    let named = maps::ALL.iter().filter(|map| ATTACKED.contains(&map.name));
    let built: Vec<HeightMap> =
        named.enumerate().map(|(k, map)| map.build(Wrap::ALL[k % Wrap::ALL.len()])).collect();
    assert_eq!(built.len(), ATTACKED.len());
    built
}

fn ratios(map: &HeightMap, metric: &Metric, apex: ConeApex) -> Vec<f32> {
    cone_ratios(map, metric, apex, &Progress::none()).expect("nobody cancels")
}

/// The stored map as a reader decodes it, and the heights that it was baked from.
fn stored(map: &HeightMap, metric: Metric, apex: u32, bits: u32) -> (Vec<f64>, HeightMap) {
    let mut settings = KIND.defaults();
    settings.set("apex", f64::from(apex)).expect("an apex");
    settings.set("bits", f64::from(bits)).expect("bits");
    let mut sink = Collected::default();
    bake(&KIND, map, metric, &settings, &Progress::none(), &mut sink).expect("the map can be baked");
    let texture = &sink.textures[0];
    let notes = &texture.texture.notes;
    let note = notes.iter().find(|(name, _)| *name == "half_ratio_m").expect("the note is there");
    let half: f64 = note.1.parse().expect("a number");
    let decoded = texture.levels[0][0].iter().map(|&value| decode(value, half)).collect();
    let heights = if bits == 0 { map.clone() } else { quantise::heights(map, bits).expect("a valid map") };
    (decoded, heights)
}

fn at<T: Copy>(map: &HeightMap, values: &[T], [i, j]: [i64; 2]) -> T {
    let (i, j) = (map.wrap().index(i, map.width()), map.wrap().index(j, map.height()));
    values[j as usize * map.width() as usize + i as usize]
}

#[test]
fn equals_brute_force() {
    let cases: Vec<(usize, Wrap)> =
        (0..maps::ALL.len()).flat_map(|k| Wrap::ALL.map(|wrap| (k, wrap))).collect();
    cases.into_par_iter().for_each(|(k, wrap)| {
        let map = maps::ALL[k].build(wrap);
        // The large maps take long by brute force; one wrap, one metric and the centres are enough for them,
        // and the largest are left to the probes.
        let is_large = map.texels().len() > 1100;
        let is_huge = map.texels().len() > 4500;
        if (is_large && wrap != Wrap::Repeat) || is_huge {
            return;
        }
        for metric in metrics().into_iter().take(if is_large { 1 } else { 2 }) {
            let texel_m = metric.texel_m(&map);
            for apex in [ConeApex::Centre, ConeApex::Footprint] {
                if is_large && apex == ConeApex::Footprint {
                    continue;
                }
                let slow = brute::cone::slopes(&map, texel_m, apex == ConeApex::Footprint);
                for (at, (ratio, slow)) in ratios(&map, &metric, apex).into_iter().zip(slow).enumerate() {
                    let fast = 1.0 / f64::from(ratio);
                    // A slope of a millionth more is the stated slack.
                    assert!(
                        fast >= slow && fast <= slow * (1.0 + 3e-6) + 1e-11 / texel_m[0].min(texel_m[1]),
                        "{} {wrap} {apex:?} texel {at}: {fast} and {slow} by brute force",
                        maps::ALL[k].name
                    );
                }
            }
        }
    });
}

#[test]
fn no_probe_finds_surface_in_a_cone() {
    let cases: Vec<(usize, u32, u32)> = (0..ATTACKED.len())
        .flat_map(|k| [0, 8, 16].into_iter().flat_map(move |bits| [0, 1].map(move |apex| (k, bits, apex))))
        .collect();
    let maps = attacked();
    cases.into_par_iter().for_each(|(k, bits, apex)| {
        let metric = metrics()[k % 2];
        let (values, heights) = stored(&maps[k], metric, apex, bits);
        let probes = Probes::new(&heights, metric.texel_m(&heights), apex == 1, u64::from(bits) + 1);
        let (violations, tightest) = attack(probes, PROBES, |contact| at(&heights, &values, contact.texel));
        assert_eq!(violations, 0, "{} with {bits} bits, apex {apex}: {tightest:?}", ATTACKED[k]);
    });
}

#[test]
fn a_map_loosened_by_one_step_is_caught() {
    for (k, map) in attacked().iter().enumerate() {
        for (bits, apex) in [(8, 1), (16, 1), (16, 0)] {
            let metric = metrics()[k % 2];
            let (values, heights) = stored(map, metric, apex, bits);
            let probes = || Probes::new(&heights, metric.texel_m(&heights), apex == 1, 3);
            let ratio = |contact: &Contact| at(&heights, &values, contact.texel);
            let (_, tightest) = attack(probes(), PROBES, ratio);
            let tightest = tightest.expect("there are probes");
            if tightest.limit.is_infinite() {
                continue;
            }
            // The stored codes of that texel, raised until the next is past the contact.
            let half = metric.tile_m[0].min(metric.tile_m[1]) / 8.0;
            let most = f64::from((1u32 << bits) - 1);
            let code = |ratio: f64| (ratio / (ratio + half)).sqrt() * most;
            let loosened = ((code(tightest.limit).floor() + 1.0) / most) as f32;
            let loosened = if loosened < 1.0 { decode(loosened, half) } else { f64::MAX };
            let caught = attack(probes(), PROBES, |contact| {
                if contact.texel == tightest.texel { loosened } else { ratio(contact) }
            });
            assert!(caught.0 > 0, "{} with {bits} bits: {tightest:?}", ATTACKED[k]);
        }
    }
}

/// What a bilinear filter makes of four stored values.
fn filtered(
    map: &HeightMap,
    values: &[f64],
    [x, y]: [f64; 2],
    f: fn(f64) -> f64,
    back: fn(f64) -> f64,
) -> f64 {
    let (i, j) = (x.floor(), y.floor());
    let (u, v) = (x - i, y - j);
    let value = |by: [i64; 2]| f(at(map, values, [i as i64 + by[0], j as i64 + by[1]]));
    back(
        value([0, 0]) * (1.0 - u) * (1.0 - v)
            + value([1, 0]) * u * (1.0 - v)
            + value([0, 1]) * (1.0 - u) * v
            + value([1, 1]) * u * v,
    )
}

#[test]
fn the_filtered_variant_may_be_filtered_and_the_centres_may_not() {
    let map = &attacked()[1];
    let metric = metrics()[0];
    let find = |apex: ConeApex, f: fn(f64) -> f64, back: fn(f64) -> f64| {
        let values: Vec<f64> = ratios(map, &metric, apex).into_iter().map(f64::from).collect();
        let probes = Probes::new(map, metric.texel_m(map), true, 5);
        attack(probes, PROBES, |contact| filtered(map, &values, contact.apex, f, back)).0
    };
    assert_eq!(find(ConeApex::Filtered, |m| m, |m| m), 0);
    assert_eq!(find(ConeApex::Filtered, f64::sqrt, |m| m * m), 0);
    for apex in [ConeApex::Centre, ConeApex::Footprint] {
        for (name, violations) in [
            ("ratios", find(apex, |m| m, |m| m)),
            ("their roots", find(apex, f64::sqrt, |m| m * m)),
            ("slopes", find(apex, |m| 1.0 / m, |m| 1.0 / m)),
        ] {
            println!("{apex:?}, {name} filtered: {violations} of {PROBES} probes find surface");
            assert!(violations > 0 || apex == ConeApex::Footprint, "{name} of centres filtered");
        }
    }
}

/// How a search uses the cones.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fetch {
    /// The apex moves to the ray.
    Moved,
    /// The apex stays at the nearest texel's centre; a ray that is not inside the cone goes on to the next texel.
    Fixed,
}

/// Steps of a cone-stepping search until it is within a thousandth of a texel of the surface or has left the relief, and
/// whether it has stepped past a hit.
fn search(
    map: &HeightMap,
    ratios: &[f32],
    fetch: Fetch,
    from: [f64; 2],
    step: [f64; 2],
    fall: f64,
) -> (usize, bool) {
    let n = f64::from(map.width());
    let speed = step[0].hypot(step[1]);
    let (mut t, mut steps) = (0.0f64, 0);
    loop {
        let place = [from[0] + step[0] * t, from[1] + step[1] * t];
        let z = 1.0 - fall * t;
        let gap = z - map.height_at(place[0], place[1]);
        if gap < -1e-9 {
            return (steps, true);
        }
        if z <= 0.0 || gap < 1e-6 || steps >= 2000 {
            return (steps, false);
        }
        let texel = place.map(|x| (x * n).floor());
        let centre = texel.map(|k| (k + 0.5) / n);
        let ratio = f64::from(at(map, ratios, texel.map(|k| k as i64)));
        // Steps below a thousandth of a texel end the search.
        let least = 1e-3 / n / speed;
        let advance = match fetch {
            Fetch::Moved => gap * ratio / (speed + fall * ratio),
            Fetch::Fixed => {
                let apex = map.height_at(centre[0], centre[1]);
                let aside = [place[0] - centre[0], place[1] - centre[1]];
                // |aside + step t| = ratio (z - fall t - apex)
                let room = ratio * (z - apex);
                let c = aside[0] * aside[0] + aside[1] * aside[1] - room * room;
                let b = aside[0] * step[0] + aside[1] * step[1] + room * ratio * fall;
                let a = speed * speed - ratio * ratio * fall * fall;
                let leave = if room > 0.0 && c < 0.0 {
                    let root = (b * b - a * c).max(0.0).sqrt();
                    if b > 0.0 { -c / (b + root) } else { (root - b) / a }
                } else {
                    0.0
                };
                // To the border of the texel, whose four patches a search solves exactly.
                let border = (0..2).fold(f64::INFINITY, |t, axis| {
                    let side = if step[axis] > 0.0 { texel[axis] + 1.0 } else { texel[axis] };
                    if step[axis] == 0.0 { t } else { t.min((side / n - place[axis]) / step[axis]) }
                });
                if leave < border {
                    // The patches of the texel are solved: the first hit in it ends the search.
                    let path = Path::between(
                        [from[0], from[1], 1.0],
                        [from[0] + step[0], from[1] + step[1], 1.0 - fall],
                    );
                    let path = Path { exit: f64::INFINITY, ..path };
                    let hit = least_gap(map, &path, t, t + border + least) <= 1e-9;
                    if hit {
                        return (steps + 1, false);
                    }
                }
                leave.max(border + least)
            }
        };
        if advance < least {
            return (steps, false);
        }
        t += advance;
        steps += 1;
    }
}

#[test]
fn any_start_costs_little_more_than_the_centre() {
    for (name, n, roughness) in [("smooth", 128, 0.4), ("natural", 128, 0.5)] {
        let map = HeightMap::new(n, n, fractal(7, n, n, roughness), Wrap::Repeat).expect("a valid map");
        let metric = metrics()[0];
        let mut rng = Rng::new(1);
        let rays: Vec<([f64; 2], [f64; 2], f64)> = (0..1000)
            .map(|_| {
                let (angle, run) = (rng.between(0.0, std::f64::consts::TAU), rng.between(-5.0, 0.0).exp2());
                ([rng.unit(), rng.unit()], [angle.cos() * run, angle.sin() * run], 1.0)
            })
            .collect();
        let measure = |apex: ConeApex, fetch: Fetch| {
            let ratios = ratios(&map, &metric, apex);
            let slope = ratios.iter().map(|&m| 1.0 / f64::from(m)).sum::<f64>() / ratios.len() as f64;
            let runs: Vec<(usize, bool)> = rays
                .par_iter()
                .map(|&(from, step, fall)| search(&map, &ratios, fetch, from, step, fall))
                .collect();
            let steps = runs.iter().map(|run| run.0).sum::<usize>() as f64 / runs.len() as f64;
            let late = runs.iter().filter(|run| run.1).count();
            println!("{name} {apex:?} {fetch:?}: mean slope {slope:.4}, {steps:.2} steps a ray, {late} late");
            (slope, steps, late)
        };
        let centre = measure(ConeApex::Centre, Fetch::Moved);
        let fixed = measure(ConeApex::Centre, Fetch::Fixed);
        let footprint = measure(ConeApex::Footprint, Fetch::Moved);
        let filtered = measure(ConeApex::Filtered, Fetch::Moved);
        assert_eq!((fixed.2, footprint.2, filtered.2), (0, 0, 0), "{name}: surface in a safe cone");
        assert!(footprint.0 < 1.3 * centre.0, "{name}: slope {} and {}", footprint.0, centre.0);
    }
}

#[test]
fn bakes_the_same_on_any_number_of_threads_and_ends_when_cancelled() {
    let map = &attacked()[2];
    let metric = metrics()[1];
    let bake_on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| ratios(map, &metric, ConeApex::Footprint))
    };
    assert_eq!(bake_on(1), bake_on(3));
    let cancel = AtomicBool::new(true);
    assert!(cone_ratios(map, &metric, ConeApex::Centre, &Progress::new(&|_| {}, &cancel)).is_err());
}
