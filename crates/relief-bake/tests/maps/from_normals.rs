//! Heights from normals: round trips, and a dense least-squares solution for comparison.

use relief_bake::from_normals::{
    FromNormalsError, GreenFit, Integration, NormalFaults, NormalSlopes, heights_from_either_green,
    heights_from_normals, heights_from_slopes,
};
use relief_bake::kind::normal::{Axes, Derivative, normals};
use relief_bake::quantise;
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::maps;
use relief_testing::maps::fractal;

fn metric(tile_m: [f64; 2], scale_m: f64) -> Metric {
    Metric::new(tile_m, scale_m).expect("positive lengths")
}

/// Returns the heights of a map in metres, without the parts that central differences miss: the
/// mean and, in a tiled map of even size, the waves that change sign from texel to texel.
fn visible(map: &HeightMap, metric: Metric) -> Vec<f64> {
    let [width, height] = [map.width() as usize, map.height() as usize];
    let mut heights: Vec<f64> = map.texels().iter().map(|&h| f64::from(h) * metric.scale_m).collect();
    let tiled = map.wrap() == Wrap::Repeat;
    for (along_u, along_v) in [(false, false), (true, false), (false, true), (true, true)] {
        if (along_u && !(tiled && width.is_multiple_of(2)))
            || (along_v && !(tiled && height.is_multiple_of(2)))
        {
            continue;
        }
        let sign = |at: usize| {
            let odd = (along_u && (at % width) % 2 == 1) ^ (along_v && (at / width) % 2 == 1);
            if odd { -1.0 } else { 1.0 }
        };
        let mean = heights.iter().enumerate().map(|(at, h)| sign(at) * h).sum::<f64>() / heights.len() as f64;
        for (at, height) in heights.iter_mut().enumerate() {
            *height -= sign(at) * mean;
        }
    }
    heights
}

fn root_mean_square(a: &[f32], b: &[f64]) -> f64 {
    (a.iter().zip(b).map(|(&a, b)| (f64::from(a) - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
}

fn integration(map: &HeightMap, metric: Metric) -> Integration {
    Integration { texel_m: metric.texel_m(map), wrap: map.wrap(), steepest: 1e6, ..Integration::default() }
}

/// Returns the root mean square error of the round trip as a part of the relief, with normals
/// stored in `bits` bits.
fn round_trip(map: &HeightMap, metric: Metric, axes: Axes, bits: u32) -> f64 {
    let (planes, _) =
        normals(map, metric, Derivative::Central, axes, &Watch::none()).expect("nobody cancels");
    let planes = planes.map(|plane| {
        let stored =
            |n: f32| 2.0 * quantise::unorm(0.5 * n + 0.5, bits, relief_core::Rounding::Nearest) - 1.0;
        plane.into_iter().map(|n| if bits == 0 { n } else { stored(n) }).collect::<Vec<f32>>()
    });
    let how = Integration { axes, ..integration(map, metric) };
    let size = [map.width(), map.height()];
    let back = heights_from_normals(size, [&planes[0], &planes[1], &planes[2]], &how, &Watch::none())
        .expect("they are normals");
    root_mean_square(&back.heights_m, &visible(map, metric)) / metric.scale_m
}

#[test]
fn what_was_baked_comes_back() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for (metric, axes) in [
                (metric([1.0, 1.0], 0.1), Axes::Tangent),
                (metric([3.0, 0.5], 0.4), Axes::TangentGreenDown),
                (metric([1.0, 2.0], 0.1), Axes::World),
            ] {
                let error = round_trip(&map, metric, axes, 0);
                assert!(error < 1e-5, "{} {wrap} {axes:?}: {error} of the relief", named.name);
            }
        }
    }
}

#[test]
fn ground_comes_back_from_stored_normals_too() {
    for wrap in Wrap::ALL {
        let map = HeightMap::new(512, 512, fractal(5, 512, 512, 0.55), wrap).expect("a valid map");
        let metric = metric([1.0, 1.0], 0.1);
        for (bits, most) in [(0, 1e-8), (16, 1e-6), (8, 3e-4)] {
            let error = round_trip(&map, metric, Axes::Tangent, bits);
            assert!(error < most, "{wrap} {bits} bits: {error} of the relief");
        }
        // The comparison notices the other sign of green.
        let (planes, _) = normals(&map, metric, Derivative::Central, Axes::TangentGreenDown, &Watch::none())
            .expect("nobody cancels");
        let wrong = heights_from_normals(
            [512, 512],
            [&planes[0], &planes[1], &planes[2]],
            &integration(&map, metric),
            &Watch::none(),
        )
        .expect("they are normals");
        assert!(root_mean_square(&wrong.heights_m, &visible(&map, metric)) / metric.scale_m > 0.02);
        assert!(wrong.misfit > 0.1, "slopes that no relief has do not fit: {}", wrong.misfit);
    }
}

#[test]
fn slopes_that_fit_no_relief_give_the_nearest() {
    // The minimised sum is convex: where no step in any texel lowers it, it is least.
    let mut rng = relief_core::rng::Rng::new(4);
    for [width, height] in [[5u32, 4u32], [6, 8], [1, 7], [9, 1]] {
        for wrap in Wrap::ALL {
            for damping in [0.0, 0.3] {
                let texels = (width * height) as usize;
                let mut noise = || (0..texels).map(|_| rng.between(-1.0, 1.0) as f32).collect::<Vec<f32>>();
                let slopes = [noise(), noise()];
                let how = Integration { texel_m: [0.5, 0.8], wrap, damping, ..Integration::default() };
                let fit =
                    heights_from_slopes([width, height], [&slopes[0], &slopes[1]], &how, &Watch::none())
                        .expect("they are slopes");
                let cost = |heights: &[f64]| cost(heights, [width, height], &slopes, &how);
                let best: Vec<f64> = fit.heights_m.iter().map(|&h| f64::from(h)).collect();
                let least = cost(&best);
                if damping == 0.0 {
                    assert!((fit.misfit - (least / texels as f64).sqrt()).abs() < 1e-5);
                }
                for texel in 0..texels {
                    for step in [1e-4, -1e-4] {
                        let mut other = best.clone();
                        other[texel] += step;
                        assert!(
                            cost(&other) >= least,
                            "{width}x{height} {wrap} {damping}: texel {texel} is better by {step}"
                        );
                    }
                }
                let mean = best.iter().sum::<f64>() / texels as f64;
                assert!(mean.abs() < 1e-6);
            }
        }
    }
}

/// Returns the minimised sum, added up directly.
fn cost(heights: &[f64], size: [u32; 2], slopes: &[Vec<f32>; 2], how: &Integration) -> f64 {
    let at = |i: i64, j: i64| {
        heights[(how.wrap.index(j, size[1]) * size[0] + how.wrap.index(i, size[0])) as usize]
    };
    let mut sum = 0.0;
    for j in 0..i64::from(size[1]) {
        for i in 0..i64::from(size[0]) {
            let texel = (j * i64::from(size[0]) + i) as usize;
            for (axis, [di, dj]) in [[1, 0], [0, 1]].into_iter().enumerate() {
                let (before, here, after) = (at(i - di, j - dj), at(i, j), at(i + di, j + dj));
                let slope = (after - before) / (2.0 * how.texel_m[axis]);
                // At a clamped edge the difference is over one texel, and errors count half.
                let (place, side) = ([i, j][axis], i64::from(size[axis]));
                let is_edge = how.wrap == Wrap::Clamp && (place == 0 || place + 1 == side);
                let weight = if is_edge { 0.5 } else { 1.0 };
                sum += (slope - weight * f64::from(slopes[axis][texel])).powi(2);
                // (1 - cos θ) / 2 of a wave is a quarter of its second difference.
                let bend = 0.25 * (before - 2.0 * here + after) / how.texel_m[axis];
                sum += (how.damping * bend).powi(2);
            }
        }
    }
    sum
}

#[test]
fn heights_become_a_map_and_back() {
    let map = maps::ALL[3].build(Wrap::Clamp);
    let metric = metric([1.0, 1.0], 0.25);
    let (planes, _) =
        normals(&map, metric, Derivative::Central, Axes::Tangent, &Watch::none()).expect("nobody cancels");
    let size = [map.width(), map.height()];
    let planes = [&planes[0][..], &planes[1], &planes[2]];
    let back = heights_from_normals(size, planes, &integration(&map, metric), &Watch::none())
        .expect("they are normals");
    assert_eq!(back.too_steep, 0);
    let again = back.to_map(Wrap::Clamp).expect("a valid map");
    for (&texel, &metres) in again.texels().iter().zip(&back.heights_m) {
        assert!((again.displacement_m(f64::from(texel)) - f64::from(metres)).abs() < 1e-7);
    }
}

#[test]
fn what_is_no_normal_map_is_refused_or_counted() {
    let level = ([0.0f32; 12], [1.0f32; 12]);
    let how = Integration::default();
    let none = Watch::none();
    let run =
        |size, x: &[f32], how: &Integration| heights_from_normals(size, [x, &level.0, &level.1], how, &none);
    assert!(matches!(run([0, 4], &level.0, &how), Err(FromNormalsError::Size(_))));
    assert!(matches!(run([5, 4], &level.0, &how), Err(FromNormalsError::WrongLength { given: 12, .. })));
    let mut broken = level.0;
    broken[6] = f32::NAN;
    assert!(matches!(run([4, 3], &broken, &how), Err(FromNormalsError::NotFinite { column: 2, row: 1 })));
    let bad = Integration { texel_m: [0.0, 1.0], ..how };
    assert!(matches!(run([4, 3], &level.0, &bad), Err(FromNormalsError::BadNumber { .. })));
    let overhang = heights_from_normals([4, 3], [&level.1, &level.0, &level.0], &how, &none);
    assert_eq!(overhang.expect("they are counted").too_steep, 12);
    let nothing = heights_from_normals([4, 3], [&level.0, &level.0, &level.0], &how, &none);
    assert!(nothing.expect("they are counted").heights_m.iter().all(|&h| h == 0.0));
    let flag = std::sync::atomic::AtomicBool::new(true);
    let cancelled =
        heights_from_normals([4, 3], [&level.0, &level.0, &level.1], &how, &Watch::cancelled_by(&flag));
    assert!(matches!(cancelled, Err(FromNormalsError::Cancelled(_))));
}

/// Returns the normals of a map, one vector a texel.
fn vectors(map: &HeightMap, metric: Metric, axes: Axes) -> Vec<[f32; 3]> {
    let ([x, y, z], _) =
        normals(map, metric, Derivative::Central, axes, &Watch::none()).expect("nobody cancels");
    x.iter().zip(&y).zip(&z).map(|((&x, &y), &z)| [x, y, z]).collect()
}

/// Returns heights from normals with unknown green, and the fit of green.
fn of_either_green(map: &HeightMap, normals: &[[f32; 3]], metric: Metric) -> (Vec<f32>, GreenFit) {
    let size = [map.width(), map.height()];
    let slopes = NormalSlopes::of_normals(size, normals, Axes::Tangent, 1e6).expect("they have directions");
    let (heights, slopes, fit) =
        heights_from_either_green(slopes, &integration(map, metric), &Watch::none()).expect("slopes");
    // The returned slopes are the ones that were integrated.
    let planes = [&slopes.along[0][..], &slopes.along[1]];
    let again = heights_from_slopes(size, planes, &integration(map, metric), &Watch::none()).expect("slopes");
    assert_eq!(again.heights_m, heights.heights_m);
    (heights.heights_m, fit)
}

#[test]
fn natural_maps_say_which_way_green_points() {
    let metric = metric([1.0, 1.5], 0.1);
    for named in maps::ALL.iter().filter(|named| named.name.starts_with("natural")) {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for (axes, is_down) in [(Axes::Tangent, false), (Axes::TangentGreenDown, true)] {
                let mut normals = vectors(&map, metric, axes);
                let (heights, fit) = of_either_green(&map, &normals, metric);
                assert!(fit.is_sure() && fit.is_down == is_down, "{} {wrap} {axes:?}: {fit:?}", named.name);
                assert!(fit.confidence > 0.9);
                assert!(root_mean_square(&heights, &visible(&map, metric)) < 1e-6);
                // Coarse normals show it, too.
                normals.iter_mut().flatten().for_each(|n| *n = (*n * 31.0).round() / 31.0);
                let (_, fit) = of_either_green(&map, &normals, metric);
                assert!(fit.is_sure() && fit.is_down == is_down, "{} {wrap} {axes:?}: {fit:?}", named.name);
            }
        }
    }
}

#[test]
fn what_fits_either_way_is_not_told() {
    let metric = metric([1.0, 1.0], 0.2);
    let mut rng = relief_core::rng::Rng::new(8);
    let furrows = HeightMap::from_fn(48, 30, Wrap::Repeat, |i, _| 0.5 + 0.5 * (i as f32 * 0.261_799).sin())
        .expect("a valid map");
    let noise: Vec<[f32; 3]> =
        (0..48 * 30).map(|_| [rng.between(-0.5, 0.5) as f32, rng.between(-0.5, 0.5) as f32, 1.0]).collect();
    let level = vec![[0.0, 0.0, 1.0]; 48 * 30];
    for (what, normals) in
        [("furrows", vectors(&furrows, metric, Axes::TangentGreenDown)), ("noise", noise), ("level", level)]
    {
        let (_, fit) = of_either_green(&furrows, &normals, metric);
        assert!(!fit.is_sure() && !fit.is_down, "{what}: {fit:?}");
    }
}

#[test]
fn faults_of_normals_are_counted_and_mended() {
    let map = HeightMap::new(64, 48, fractal(3, 64, 48, 0.4), Wrap::Clamp).expect("a valid map");
    let metric = metric([1.0, 0.75], 0.1);
    let good = vectors(&map, metric, Axes::Tangent);
    let slopes = |normals: &[[f32; 3]]| NormalSlopes::of_normals([64, 48], normals, Axes::Tangent, 32.0);
    let clean = slopes(&good).expect("they have directions");
    assert_eq!(clean.faults, NormalFaults::default());
    // Lengths do not count.
    let long: Vec<[f32; 3]> = good.iter().map(|normal| normal.map(|x| 4.0 * x)).collect();
    let long = slopes(&long).expect("they have directions");
    assert_eq!(long.faults, NormalFaults { not_unit: 64 * 48, ..NormalFaults::default() });
    for (a, b) in long.along.iter().flatten().zip(clean.along.iter().flatten()) {
        assert!((a - b).abs() < 1e-5);
    }
    let mut broken = good.clone();
    broken[64 * 20 + 30] = [f32::NAN, 0.0, 1.0];
    broken[64 * 20 + 31] = [0.0; 3];
    broken[64 * 21 + 30] = [f32::INFINITY, 0.0, 1.0];
    broken[5] = [0.6, 0.0, -0.8];
    broken[6] = [0.999_9, 0.0, 0.01];
    let found = slopes(&broken).expect("others have directions");
    let expected = NormalFaults {
        without_direction: 3,
        first_hole: Some([30, 20]),
        below_horizon: 1,
        too_steep: 1,
        ..NormalFaults::default()
    };
    assert_eq!(found.faults, expected);
    assert_eq!([found.along[0][5], found.along[0][6]], [-32.0, -32.0]);
    let steepest = clean.along.iter().flatten().fold(0.0f32, |most, slope| most.max(slope.abs()));
    for at in [64 * 20 + 30, 64 * 20 + 31, 64 * 21 + 30] {
        let [u, v] = [found.along[0][at], found.along[1][at]];
        assert!(u.abs() <= steepest && v.abs() <= steepest && (u != 0.0 || v != 0.0), "{at}: {u} {v}");
    }
    let nothing = slopes(&vec![[0.0; 3]; 64 * 48]);
    assert!(matches!(nothing, Err(FromNormalsError::NoDirection)));
    assert!(matches!(slopes(&good[1..]), Err(FromNormalsError::WrongLength { .. })));
    let steepest = NormalSlopes::of_normals([64, 48], &good, Axes::Tangent, f64::NAN);
    assert!(matches!(steepest, Err(FromNormalsError::BadNumber { .. })));
    let empty = NormalSlopes::of_normals([0, 48], &[], Axes::Tangent, 32.0);
    assert!(matches!(empty, Err(FromNormalsError::Size(_))));
}
