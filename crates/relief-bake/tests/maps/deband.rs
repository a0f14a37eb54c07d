//! Slopes instead of steps: errors against the maps before rounding, bounds and threads.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, Ordering};

use relief_bake::deband::{DebandError, Debanding, deband, steps_of};
use relief_bake::quantise;
use relief_core::rng::Rng;
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

const SIDE: u32 = 512;

/// Sum of waves with frequencies of up to `most` along both axes. The amplitude falls with the
/// frequency to the power of `fall`. Heights are from 0 to 1.
fn waves(seed: u64, count: u32, most: i32, fall: f64) -> Vec<f64> {
    let mut rng = Rng::new(seed);
    let mut sum = vec![0.0f64; (SIDE * SIDE) as usize];
    let turns: Vec<f64> = (0..SIDE).map(|n| TAU * f64::from(n) / f64::from(SIDE)).collect();
    for _ in 0..count {
        let most = f64::from(most);
        let radius = most.powf(rng.between(0.0, 1.0)).max(1.0);
        let angle = rng.between(0.0, TAU);
        let [a, b] = [radius * angle.cos(), radius * angle.sin()].map(f64::round);
        let frequency = a.hypot(b);
        if frequency == 0.0 || frequency > most {
            continue;
        }
        // Each octave has as many waves here, and four times as many in a whole spectrum.
        let (phase, size) = (rng.between(0.0, TAU), frequency.powf(1.0 - fall));
        for (at, sum) in sum.iter_mut().enumerate() {
            let (i, j) = (at % SIDE as usize, at / SIDE as usize);
            *sum += size * (a * turns[i] + b * turns[j] + phase).cos();
        }
    }
    let [low, high] = sum.iter().fold([f64::MAX, f64::MIN], |[low, high], &h| [low.min(h), high.max(h)]);
    sum.iter().map(|h| (h - low) / (high - low)).collect()
}

fn rounded(heights: &[f64], levels: u32, wrap: Wrap) -> HeightMap {
    let most = f64::from(levels - 1);
    let texels = heights.iter().map(|h| ((h * most).round() / most) as f32).collect();
    HeightMap::new(SIDE, SIDE, texels, wrap).expect("a valid map")
}

fn error(texels: &[f32], heights: &[f64]) -> f64 {
    let squares = texels.iter().zip(heights).map(|(&texel, h)| (f64::from(texel) - h).powi(2));
    (squares.sum::<f64>() / heights.len() as f64).sqrt()
}

/// Greatest distance by which a texel moves.
fn moved(map: &HeightMap, smooth: &[f32]) -> f64 {
    smooth.iter().zip(map.texels()).map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max)
}

/// Error after the smoothing as a part of the error before. Checks that no texel moves too far.
fn ratio(heights: &[f64], levels: u32, wrap: Wrap, rounds: u32) -> f64 {
    let map = rounded(heights, levels, wrap);
    let step = steps_of(&map).expect("equal steps").step;
    assert!((step * f64::from(levels - 1) - 1.0).abs() < 1e-4, "{levels} levels: a step of {step}");
    let smooth = deband(&map, &Debanding { step, rounds }, &Watch::none()).expect("valid settings");
    let moved = moved(&map, &smooth);
    assert!(moved <= 0.5 * step + 1e-7, "{levels} levels: moved by {moved}");
    assert!(rounds == 0 || moved > 0.4 * step, "the bounds are used");
    error(&smooth, heights) / error(map.texels(), heights)
}

#[test]
fn long_waves_come_back() {
    let heights = waves(7, 24, 6, 1.0);
    for levels in [32, 64, 128] {
        // The waves do tile. A clamped map cannot know, and errs at its edges.
        for (wrap, most) in [(Wrap::Repeat, 0.1), (Wrap::Clamp, 0.16)] {
            let ratio = ratio(&heights, levels, wrap, 150);
            println!("{levels} levels, {wrap}: {ratio:.3}");
            assert!(ratio <= most, "{levels} levels, {wrap}: {ratio}");
        }
    }
    // The measure notices rounds that do nothing, and too few rounds.
    assert_eq!(ratio(&heights, 32, Wrap::Repeat, 0), 1.0);
    assert!(ratio(&heights, 32, Wrap::Repeat, 2) > 0.2);
    // Bounds that are too wide move texels too far.
    let map = rounded(&heights, 32, Wrap::Repeat);
    let wide = deband(&map, &Debanding { step: 2.0 / 31.0, rounds: 20 }, &Watch::none()).expect("valid");
    assert!(moved(&map, &wide) > 0.6 / 31.0);
}

#[test]
fn fractal_ground_comes_nearer() {
    let heights = waves(5, 500, 200, 2.5);
    for levels in [32, 64, 128] {
        let ratio = ratio(&heights, levels, Wrap::Repeat, 150);
        println!("{levels} levels: {ratio:.3}");
        assert!(ratio <= 0.3, "{levels} levels: {ratio}");
    }
}

#[test]
fn relief_that_is_rougher_than_its_steps_stays() {
    let mut rng = Rng::new(2);
    let noise: Vec<f64> = (0..SIDE * SIDE).map(|_| rng.between(0.0, 1.0)).collect();
    let map = rounded(&noise, 256, Wrap::Repeat);
    let smooth = deband(&map, &Debanding::of_step(1.0 / 255.0), &Watch::none()).expect("valid settings");
    assert!(smooth.iter().zip(map.texels()).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn odd_sizes_and_level_maps_are_smoothed_too() {
    for [width, height] in [[1u32, 1u32], [1, 40], [53, 1], [2, 3], [31, 7]] {
        for wrap in Wrap::ALL {
            let ramp = |i: u32, j: u32| ((i + j) / 4) as f32 / 20.0;
            let map = HeightMap::from_fn(width, height, wrap, ramp).expect("a valid map");
            let smooth = deband(&map, &Debanding::of_step(0.05), &Watch::none()).expect("valid settings");
            assert!(smooth.iter().zip(map.texels()).all(|(a, b)| (a - b).abs() <= 0.025 + 1e-6));
            let level = HeightMap::from_fn(width, height, wrap, |_, _| 0.3).expect("a valid map");
            let same = deband(&level, &Debanding::of_step(0.05), &Watch::none()).expect("valid settings");
            assert!(same.iter().all(|h| (h - 0.3).abs() < 1e-6), "{width}x{height} {wrap}");
            assert_eq!(steps_of(&level), None);
        }
    }
}

#[test]
fn heights_are_the_same_bits_for_any_number_of_threads() {
    let map = quantise::heights(&rounded(&waves(3, 20, 6, 1.0), 60_000, Wrap::Mirror), 6).expect("valid");
    let how = Debanding { step: 1.0 / 63.0, rounds: 10 };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| deband(&map, &how, &Watch::none())).expect("valid settings")
    };
    let one = with(1);
    for threads in [2, 5] {
        assert!(one.iter().zip(with(threads)).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

#[test]
fn bad_settings_are_refused_and_work_is_cancelled() {
    let map = HeightMap::from_fn(32, 32, Wrap::Repeat, |i, _| i as f32 / 31.0).expect("a valid map");
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.5, 1e-9] {
        let refused = deband(&map, &Debanding::of_step(step), &Watch::none());
        assert!(matches!(refused, Err(DebandError::BadStep(_))), "{step}");
    }
    let many = Debanding { step: 0.1, rounds: u32::MAX };
    assert_eq!(deband(&map, &many, &Watch::none()), Err(DebandError::TooManyRounds(u32::MAX)));
    let cancel = AtomicBool::new(false);
    let tell = |_: &str, part: f32| {
        cancel.fetch_or(part > 0.5, Ordering::Relaxed);
    };
    let cancelled = deband(&map, &Debanding::of_step(0.1), &Watch::new(&tell, &cancel));
    assert_eq!(cancelled, Err(DebandError::Cancelled(Cancelled)));
}
