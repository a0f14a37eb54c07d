//! Heights from the shading of one rendered photograph.

use relief_bake::from_shading::{FromShadingError, Shading, heights_from_shading};
use relief_core::{Watch, Wrap};

const SIDE: u32 = 48;

fn how(to_light: [f64; 3], wrap: Wrap) -> Shading {
    Shading {
        to_light,
        albedo: Some(0.8),
        overexposed: f32::INFINITY,
        texel_m: [1.0 / f64::from(SIDE); 2],
        wrap,
    }
}

/// Smooth hills on a tile of 1 m, in metres.
fn hill([u, v]: [f64; 2]) -> f64 {
    let [u, v] = [u, v].map(|x| x * std::f64::consts::TAU);
    0.01 * (u.sin() * v.cos() + 0.6 * (2.0 * u + v).sin())
}

fn heights() -> Vec<f64> {
    let at = |at: u32| (f64::from(at) + 0.5) / f64::from(SIDE);
    (0..SIDE * SIDE).map(|texel| hill([at(texel % SIDE), at(texel / SIDE)])).collect()
}

/// The brightness under a unit light, from slopes of the formula itself.
fn photo([right, up, front]: [f64; 3]) -> Vec<f32> {
    let at = |at: u32| (f64::from(at) + 0.5) / f64::from(SIDE);
    let step = 1e-5;
    let pixel = |texel: u32| {
        let [u, v] = [at(texel % SIDE), at(texel / SIDE)];
        let p = (hill([u + step, v]) - hill([u - step, v])) / (2.0 * step);
        let q = (hill([u, v + step]) - hill([u, v - step])) / (2.0 * step);
        (0.8 * (front - right * p + up * q).max(0.0) / (1.0 + p * p + q * q).sqrt()) as f32
    };
    (0..SIDE * SIDE).map(pixel).collect()
}

fn correlation(found: &[f64], truth: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let [a, b] = [found, truth].map(mean);
    let sum =
        |f: &dyn Fn(f64, f64) -> f64| found.iter().zip(truth).map(|(x, y)| f(x - a, y - b)).sum::<f64>();
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}

/// Returns the slopes towards the light inside the map, in some unit.
fn slopes(heights: &[f64], [right, up, _]: [f64; 3]) -> Vec<f64> {
    let side = SIDE as usize;
    let inner = (1..side - 1).flat_map(|row| (1..side - 1).map(move |column| row * side + column));
    let slope = |at: usize| {
        right * (heights[at + 1] - heights[at - 1]) - up * (heights[at + side] - heights[at - side])
    };
    inner.map(slope).collect()
}

#[test]
fn hills_come_back_from_one_photograph() {
    for light in [[0.6, 0.0, 0.8], [0.48, 0.36, 0.8], [-0.48, 0.64, 0.6]] {
        let pixels = photo(light);
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
            // The correlations of the heights, and of the slopes towards the light.
            let run = |to_light| {
                let found = heights_from_shading([SIDE; 2], &pixels, &how(to_light, wrap), &Watch::none())
                    .expect("the photograph is good");
                assert!(found.misfit < 0.02 && found.too_bright == 0 && found.dark == 0);
                let found: Vec<f64> = found.heights_m.iter().map(|&h| f64::from(h)).collect();
                let truth = heights();
                [correlation(&found, &truth), correlation(&slopes(&found, light), &slopes(&truth, light))]
            };
            let [near, seen] = run(light.map(|x| 3.0 * x));
            assert!(seen > 0.95, "{light:?} {wrap}: {seen}");
            // Of a map that does not tile, the light does not show the profile across it.
            let least = if wrap == Wrap::Repeat { 0.9 } else { 0.6 };
            assert!(near > least, "{light:?} {wrap}: {near}");
            // A light on the other side turns hills into hollows.
            let [_, turned] = run([-light[0], -light[1], light[2]]);
            assert!(turned < -0.5, "{light:?} {wrap}: {turned}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let light = [0.6, 0.0, 0.8];
    let pixels = photo(light);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| heights_from_shading([SIDE; 2], &pixels, &how(light, Wrap::Clamp), &Watch::none()))
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn thin_and_uniform_photographs_are_level() {
    for size in [[1, 1], [1, 9], [17, 1], [2, 3], [9, 31]] {
        let pixels = vec![0.4; (size[0] * size[1]) as usize];
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
            let how = Shading { albedo: None, ..how([0.6, 0.0, 0.8], wrap) };
            let found = heights_from_shading(size, &pixels, &how, &Watch::none()).expect("a photograph");
            assert!((found.albedo - 0.5).abs() < 1e-6);
            assert!(found.heights_m.iter().all(|h| h.abs() < 1e-6), "{size:?}");
            assert!(found.to_map(wrap).is_ok());
        }
    }
}

#[test]
fn wrong_photographs_are_counted_or_refused() {
    let good = how([0.6, 0.0, 0.8], Wrap::Clamp);
    let pixels = photo([0.6, 0.0, 0.8]);
    let run = |pixels: &[f32], how: &Shading| heights_from_shading([SIDE; 2], pixels, how, &Watch::none());
    let with = |value: f32| {
        let mut pixels = pixels.clone();
        pixels[SIDE as usize + 3] = value;
        run(&pixels, &Shading { overexposed: 1.0, ..good })
    };
    for value in [f32::NAN, f32::INFINITY, -0.5] {
        assert!(matches!(with(value), Err(FromShadingError::BadPixel { column: 3, row: 1, .. })));
    }
    let found = with(1.0).expect("one pixel is overexposed");
    assert_eq!([found.overexposed, found.too_bright, found.dark], [1, 1, 0]);
    assert_eq!(with(0.0).expect("one pixel is black").dark, 1);
    let low = run(&pixels, &Shading { albedo: Some(0.1), ..good }).expect("it is only told");
    assert_eq!(low.too_bright, pixels.len());
    for to_light in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 1.0]] {
        assert_eq!(run(&pixels, &Shading { to_light, ..good }), Err(FromShadingError::NoDirection));
    }
    for to_light in [[1.0, 0.0, 0.0], [0.0, 0.3, -0.5], [1.0, 0.0, 1e-9]] {
        let error = run(&pixels, &Shading { to_light, ..good });
        assert!(matches!(error, Err(FromShadingError::BelowHorizon(_))));
    }
    for albedo in [0.0, -0.2, 1.5, f64::NAN] {
        let error = run(&pixels, &Shading { albedo: Some(albedo), ..good });
        assert!(matches!(error, Err(FromShadingError::BadAlbedo(_))));
    }
    let error = run(&pixels, &Shading { texel_m: [0.0, 1.0], ..good });
    assert!(matches!(error, Err(FromShadingError::BadTexel(..))));
    assert!(matches!(run(&pixels[1..], &good), Err(FromShadingError::WrongLength { .. })));
    assert_eq!(run(&vec![0.0; pixels.len()], &good), Err(FromShadingError::NothingLit));
    let huge = heights_from_shading([u32::MAX; 2], &pixels, &good, &Watch::none());
    assert!(matches!(huge, Err(FromShadingError::Size(_))));
    let flag = std::sync::atomic::AtomicBool::new(true);
    let cancelled = heights_from_shading([SIDE; 2], &pixels, &good, &Watch::cancelled_by(&flag));
    assert!(matches!(cancelled, Err(FromShadingError::Cancelled(_))));
}
