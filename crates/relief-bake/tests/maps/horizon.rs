//! Horizons against every cell on the ray, within the bound that the kind states.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use relief_bake::kind::horizon::{KIND, NEAR_STEPS, horizons};
use relief_bake::{BakeError, Collected, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::horizon as brute;
use relief_testing::maps;

/// Distance of the judged texels of each map.
const STRIDE: usize = 5;

/// Number of azimuths. It is no multiple of four, so that most azimuths are along no axis and no
/// diagonal.
const AZIMUTHS: u32 = 10;

fn metrics() -> [Metric; 2] {
    [Metric::unit_tile(0.1).expect("a valid metric"), Metric::new([2.0, 0.7], 0.4).expect("a valid metric")]
}

/// Returns the greatest difference of neighbouring texels along an axis.
fn steepest(map: &HeightMap, axis: usize) -> f64 {
    let sides = [i64::from(map.width()), i64::from(map.height())];
    let places = (0..sides[1]).flat_map(|j| (0..sides[0]).map(move |i| [i, j]));
    places
        .map(|[i, j]| {
            let next = if axis == 0 { map.texel(i + 1, j) } else { map.texel(i, j + 1) };
            f64::from((next - map.texel(i, j)).abs())
        })
        .fold(0.0, f64::max)
}

/// Bounds of a stored slope.
struct Bounds {
    least: f64,
    most: f64,
}

/// Calls `judge` with the stored slope, the slope of each judged texel's ray over all tiles that
/// matter, and the bounds of the kind.
fn each_horizon(map: &HeightMap, metric: Metric, mut judge: impl FnMut(u32, f64, f64, Bounds)) {
    let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
    horizons(map, metric, AZIMUTHS, 1, &Watch::none(), &mut |azimuth, sines| {
        let ray = brute::HorizonRay::new(TAU * f64::from(azimuth) / f64::from(AZIMUTHS), metric.texel_m(map));
        let [x, y] = ray.step.map(f64::abs);
        let (side, across) = if y > x { (map.height(), x) } else { (map.width(), y) };
        let reach = f64::from(side).max(64.0);
        let metres = metric.scale_m / ray.step_m;
        let error = steepest(map, usize::from(y <= x)) * (2.0 + across) / (2.0 * NEAR_STEPS as f64);
        let slack = metres * (error + 1e-5);
        for texel in (0..sines.len()).step_by(STRIDE) {
            let place = [texel as u32 % map.width(), texel as u32 / map.width()];
            let exact = |reach: f64| metres * brute::slope(map, place, &ray, reach, highest).max(0.0);
            let sine = f64::from(sines[texel]);
            let slope = sine / (1.0 - sine * sine).sqrt();
            // Effect of rounding the sine to `f32` on a slope.
            let rounding = slack + 1e-6 * (1.0 + slope * slope) * slope.max(1.0);
            let bounds = Bounds { least: exact(reach) - rounding, most: exact(2.0 * reach) + rounding };
            judge(azimuth, slope, exact(4.0 * reach), bounds);
        }
        Ok(())
    })
    .expect("not cancelled");
}

#[test]
fn slopes_keep_their_bound_on_every_map() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for metric in metrics() {
                each_horizon(&map, metric, |azimuth, slope, exact, bounds| {
                    assert!(
                        slope >= bounds.least && slope <= bounds.most,
                        "{} {wrap} azimuth {azimuth}: {slope} for {exact}, from {} to {}",
                        named.name,
                        bounds.least,
                        bounds.most
                    );
                });
            }
        }
    }
}

#[test]
fn angles_are_near_those_of_dense_rays() {
    let ground =
        HeightMap::new(128, 128, maps::fractal(5, 128, 128, 0.55), Wrap::Repeat).expect("a valid map");
    let noise = maps::ALL[1].build(Wrap::Repeat);
    for map in [ground, noise] {
        let mut errors: Vec<f64> = Vec::new();
        each_horizon(&map, metrics()[0], |_, slope, exact, _| {
            errors.push((slope.atan() - exact.atan()).abs().to_degrees());
        });
        errors.sort_by(f64::total_cmp);
        let (median, p95) = (errors[errors.len() / 2], errors[errors.len() * 95 / 100]);
        println!("median {median}, 95th percentile {p95}");
        assert!(median < 0.1 && p95 < 1.0, "median {median}, 95th percentile {p95} degrees");
    }
}

#[test]
fn an_even_slope_has_its_own_horizon_in_every_azimuth() {
    const SIDE: u32 = 96;
    const MANY: u32 = 16;
    // Falls of 45 degrees along an axis, along the other one, and between them.
    for [x, y] in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8]] {
        let rise = |i, j| 0.5 + (x * (f64::from(i) - 47.5) + y * (f64::from(j) - 47.5)) / 256.0;
        let map = HeightMap::from_fn(SIDE, SIDE, Wrap::Clamp, |i, j| rise(i, j) as f32).expect("a map");
        let metric = Metric::new([f64::from(SIDE); 2], 256.0).expect("a valid metric");
        let highest = f64::from(map.texels().iter().copied().fold(0.0, f32::max));
        let (mut slices, mut judged) = (Vec::new(), 0);
        horizons(&map, metric, MANY, 1, &Watch::none(), &mut |azimuth, sines| {
            let angle = TAU * f64::from(azimuth) / f64::from(MANY);
            let ray = brute::HorizonRay::new(angle, metric.texel_m(&map));
            for at in 0..sines.len() as u32 {
                let place = [at % SIDE, at / SIDE];
                // Beyond the edges the ground is level.
                if place.iter().any(|&along| !(28..SIDE - 28).contains(&along)) {
                    continue;
                }
                // Lines are searched up to twice the reach.
                let [expected, farther] = [1.0, 2.0].map(|times| {
                    let slope = brute::slope(&map, place, &ray, times * f64::from(SIDE), highest);
                    (256.0 / ray.step_m * slope).max(0.0).atan().to_degrees()
                });
                let even = (x * angle.cos() + y * angle.sin()).max(0.0).atan().to_degrees();
                // Where the ground beyond the edges decides the horizon, the slope is not even.
                if (expected - even).abs().max((farther - even).abs()) > 0.01 {
                    continue;
                }
                judged += 1;
                let found = f64::from(sines[at as usize]).asin().to_degrees();
                assert!(
                    (found - expected).abs() < 0.15,
                    "slope {x} {y}, azimuth {azimuth}, texel {place:?}: {found} for {expected} degrees"
                );
            }
            slices.push(f64::from(sines[(SIDE * SIDE / 2 + SIDE / 2) as usize]));
            Ok(())
        })
        .expect("not cancelled");
        assert!(judged > 8 * 40 * 40, "{judged}");
        // Along an axis, azimuths on both sides of it see the same.
        if x == 1.0 {
            for azimuth in 1..MANY as usize / 2 {
                let [one, other] = [slices[azimuth], slices[MANY as usize - azimuth]];
                assert!((one - other).abs() < 1e-4, "azimuth {azimuth}: {one} and {other}");
            }
        }
    }
}

#[test]
fn the_bounds_notice_a_wrong_map() {
    let map = HeightMap::new(64, 64, maps::fractal(5, 64, 64, 0.4), Wrap::Repeat).expect("a valid map");
    let (mut judged, mut caught) = (0, [0; 2]);
    each_horizon(&map, metrics()[0], |_, slope, _, bounds| {
        judged += 1;
        for (caught, wrong) in caught.iter_mut().zip([slope + 0.1, slope - 0.15]) {
            *caught += usize::from(wrong < bounds.least || wrong > bounds.most);
        }
    });
    assert!(caught.iter().all(|caught| *caught * 10 > judged), "{caught:?} of {judged}");
}

#[test]
fn a_wall_stands_where_it_is() {
    // A wall of 0.5 m in the east of a plain of 4 m by 2 m with texels of 0.125 m.
    let wall = |i, _| if i == 20 { 1.0 } else { 0.0 };
    let map = HeightMap::from_fn(32, 16, Wrap::Clamp, wall).expect("a valid map");
    let metric = Metric::new([4.0, 2.0], 0.5).expect("a valid metric");
    let mut slices = Vec::new();
    horizons(&map, metric, 8, 1, &Watch::none(), &mut |_, sines| {
        slices.push(sines.to_vec());
        Ok(())
    })
    .expect("not cancelled");
    let at = |azimuth: usize| f64::from(slices[azimuth][8 * 32 + 12]);
    let distance = 8.0 * 0.125;
    assert!((at(0) - (0.5f64 / distance).atan().sin()).abs() < 1e-6);
    let diagonal = distance * 2.0f64.sqrt();
    assert!((at(1) - (0.5 / diagonal).atan().sin()).abs() < 1e-6);
    assert!((at(7) - at(1)).abs() < 1e-6);
    for open in 2..7 {
        assert_eq!(at(open), 0.0, "azimuth {open}");
    }
}

#[test]
fn stored_values_are_deterministic_and_rounded_to_the_nearest() {
    let map = maps::ALL[3].build(Wrap::Mirror);
    let bake_with = |threads, bits: f64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let mut settings = KIND.defaults();
        settings.set("bits", bits).expect("in range");
        let mut sink = Collected::default();
        pool.install(|| bake(&KIND, &map, metrics()[1], &settings, &Watch::none(), &mut sink))
            .expect("not cancelled");
        sink.textures.remove(0)
    };
    for (bits, step) in [(0.0, 0.0), (8.0, 255.0), (16.0, 65535.0)] {
        let one = bake_with(1, bits);
        assert_eq!(one, bake_with(3, bits));
        assert_eq!(one.texture.size, [101, 67, 16]);
        let texels = &one.levels[0][0];
        assert_eq!(texels.len(), 101 * 67 * 16);
        assert!(texels.iter().all(|x| (0.0..=1.0).contains(x)));
        if step > 0.0 {
            assert!(
                texels.iter().all(|x| (f64::from(*x) * step - (f64::from(*x) * step).round()).abs() < 1e-2)
            );
        }
    }
}

#[test]
fn a_cancelled_bake_ends() {
    let map = maps::ALL[1].build(Wrap::Repeat);
    let (cancel, reports) = (AtomicBool::new(false), AtomicUsize::new(0));
    let report = |_: &str, part: f32| {
        assert!((0.0..=1.0).contains(&part));
        if reports.fetch_add(1, Ordering::Relaxed) == 20 {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let mut slices = 0;
    let ended = horizons(&map, metrics()[0], 16, 1, &Watch::new(&report, &cancel), &mut |_, _| {
        slices += 1;
        Ok(())
    });
    assert!(matches!(ended, Err(BakeError::Cancelled(_))) && slices < 16);
}
