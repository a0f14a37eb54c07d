//! Normals from rendered photographs, with attached and cast shadows.

use relief_bake::from_normals::{Integration, heights_from_normals};
use relief_bake::photometric::{
    ColourAlbedo, Exposure, Photo, PhotometricError, check_lights, normals_from_photos,
};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::normal as brute;
use relief_testing::maps::fractal;

const SIDE: u32 = 96;
const EXPOSURE: Exposure = Exposure { shadow: 0.02, overexposed: f32::INFINITY };

struct Scene {
    map: HeightMap,
    metric: Metric,
    lights: Vec<([f64; 3], f64)>,
}

impl Scene {
    /// Creates ground under a ring of lights, each stronger than the previous one.
    fn ring(lights: usize, elevation: f64, scale_m: f64) -> Self {
        let map = HeightMap::new(SIDE, SIDE, fractal(9, SIDE, SIDE, 0.5), Wrap::Repeat).expect("a valid map");
        let lights = (0..lights)
            .map(|at| {
                let (sin, cos) = (at as f64 / lights as f64 * std::f64::consts::TAU + 0.3).sin_cos();
                let level = elevation.cos();
                ([level * cos, level * sin, elevation.sin()], 1.0 + 0.2 * at as f64)
            })
            .collect();
        Self { map, metric: Metric::unit_tile(scale_m).expect("positive lengths"), lights }
    }

    fn texels(&self) -> impl Iterator<Item = [i64; 2]> {
        (0..i64::from(SIDE * SIDE)).map(|at| [at % i64::from(SIDE), at / i64::from(SIDE)])
    }

    fn normal(&self, texel: [i64; 2]) -> [f64; 3] {
        let slopes = brute::patch_slopes(&self.map, self.metric.tile_m, self.metric.scale_m, texel);
        brute::normal(brute::mean(&slopes))
    }

    fn albedo([i, j]: [i64; 2]) -> f64 {
        0.4 + 0.3 * ((i / 9 + j / 7) % 3) as f64
    }

    /// Returns whether a texel is in another's shadow, by small steps towards the light.
    fn is_shadowed(&self, [i, j]: [i64; 2], to_light: [f64; 3]) -> bool {
        let side = f64::from(SIDE);
        let from = [(i as f64 + 0.5) / side, (j as f64 + 0.5) / side];
        let height = f64::from(self.map.texel(i, j));
        (1..).map(|step| f64::from(step) * 0.25 / side).find_map(|t| {
            let h = height + t * to_light[2] / self.metric.scale_m;
            // Up in the picture is against v.
            let ground = self.map.height_at(from[0] + t * to_light[0], from[1] - t * to_light[1]);
            if ground > h + 1e-9 {
                Some(true)
            } else if h > 1.0 {
                Some(false)
            } else {
                None
            }
        }) == Some(true)
    }

    fn photos(&self) -> Vec<Vec<f32>> {
        let shot = |&(to_light, intensity): &([f64; 3], f64)| {
            let pixel = |texel| {
                let facing: f64 = self.normal(texel).iter().zip(to_light).map(|(n, l)| n * l).sum();
                let lit = facing > 0.0 && !self.is_shadowed(texel, to_light);
                if lit { (facing * intensity * Self::albedo(texel)) as f32 } else { 0.0 }
            };
            self.texels().map(pixel).collect()
        };
        self.lights.iter().map(shot).collect()
    }

    fn with_lights<'a>(&self, pixels: &'a [Vec<f32>]) -> Vec<Photo<'a>> {
        let photo = |(pixels, &(to_light, intensity)): (&'a Vec<f32>, &([f64; 3], f64))| Photo {
            pixels,
            to_light: to_light.map(|x| 3.0 * x),
            intensity,
        };
        pixels.iter().zip(&self.lights).map(photo).collect()
    }
}

#[test]
fn normals_and_albedo_come_back_where_three_lights_reach() {
    let scene = Scene::ring(6, 0.7, 0.25);
    let pixels = scene.photos();
    let dark = pixels.iter().flatten().filter(|&&pixel| pixel <= EXPOSURE.shadow).count();
    assert!(dark > pixels.len() * 300, "the scene has too few shadows to be a test: {dark}");
    let found = normals_from_photos([SIDE; 2], &scene.with_lights(&pixels), EXPOSURE, &Watch::none())
        .expect("the photographs are good");
    let known = found.known.iter().filter(|&&known| known).count();
    assert!(known * 10 > found.known.len() * 9, "only {known} known");
    assert!(known < found.known.len(), "something must be filled in for this to be a test");
    for (at, texel) in scene.texels().enumerate() {
        let normal = [0, 1, 2].map(|axis| f64::from(found.normals[axis][at]));
        if found.known[at] {
            assert!(brute::angle(normal, scene.normal(texel)) < 2e-6, "{texel:?}");
            assert!((f64::from(found.albedo[at]) - Scene::albedo(texel)).abs() < 1e-5);
        } else {
            let length = normal.iter().map(|x| x * x).sum::<f64>();
            assert!((length - 1.0).abs() < 1e-5 && normal[2] > 0.0);
        }
    }
    assert!(found.misfit < 1e-6);
    // Shadows that are taken for dark ground spoil the fit: only the threshold excludes them.
    let all = Exposure { shadow: -1.0, ..EXPOSURE };
    let spoilt = normals_from_photos([SIDE; 2], &scene.with_lights(&pixels), all, &Watch::none())
        .expect("there are known pixels");
    assert!(spoilt.misfit > 1e-3, "{}", spoilt.misfit);
}

#[test]
fn heights_come_back_from_photographs() {
    let scene = Scene::ring(8, 0.9, 0.15);
    let pixels = scene.photos();
    let found = normals_from_photos([SIDE; 2], &scene.with_lights(&pixels), EXPOSURE, &Watch::none())
        .expect("the photographs are good");
    let how = Integration { texel_m: scene.metric.texel_m(&scene.map), ..Integration::default() };
    let [x, y, z] = &found.normals;
    let heights = heights_from_normals([SIDE; 2], [x, y, z], &how, &Watch::none()).expect("normals");
    let mean = scene.map.texels().iter().map(|&h| f64::from(h)).sum::<f64>() / f64::from(SIDE * SIDE);
    let error = scene
        .map
        .texels()
        .iter()
        .zip(&heights.heights_m)
        .map(|(&h, &found)| ((f64::from(h) - mean) * scene.metric.scale_m - f64::from(found)).powi(2));
    let error = (error.sum::<f64>() / f64::from(SIDE * SIDE)).sqrt() / scene.metric.scale_m;
    assert!(error < 0.01, "{error} of the relief");
}

#[test]
fn colours_come_back_without_light_and_shadow() {
    let scene = Scene::ring(6, 0.7, 0.25);
    let pixels = scene.photos();
    let photos = scene.with_lights(&pixels);
    let found = normals_from_photos([SIDE; 2], &photos, EXPOSURE, &Watch::none()).expect("good photographs");
    // Red reflects as much as the brightness, green half of it, blue nothing; the last channel is
    // opacity.
    let coloured =
        |pixels: &[f32]| -> Vec<[f32; 4]> { pixels.iter().map(|&p| [p, 0.5 * p, 0.0, 1.0]).collect() };
    let albedo = |exposure: Exposure| {
        let mut albedo = ColourAlbedo::new(&found, exposure);
        for photo in &photos {
            albedo.add(photo, &coloured(photo.pixels));
        }
        albedo.finish([SIDE; 2])
    };
    let worst = |[red, green, blue]: &[Vec<f32>; 3]| {
        let known = scene.texels().enumerate().filter(|(at, _)| found.known[*at]);
        known.fold(0.0f64, |worst, (at, texel)| {
            let whole = Scene::albedo(texel);
            let off = [(red, whole), (green, 0.5 * whole), (blue, 0.0)]
                .map(|(plane, expected)| (f64::from(plane[at]) - expected).abs());
            off.into_iter().fold(worst, f64::max)
        })
    };
    let colours = albedo(EXPOSURE);
    assert!(worst(&colours) < 1e-4, "{}", worst(&colours));
    assert!(colours.iter().flatten().all(|value| value.is_finite()));
    // With shadows among the samples the albedo is wrong.
    assert!(worst(&albedo(Exposure { shadow: -1.0, ..EXPOSURE })) > 0.1);
}

#[test]
fn overexposed_samples_are_left_out() {
    let scene = Scene::ring(8, 0.9, 0.1);
    let mut pixels = scene.photos();
    let limit = 0.9;
    pixels.iter_mut().flatten().for_each(|pixel| *pixel = pixel.min(limit));
    let run = |overexposed| {
        let exposure = Exposure { overexposed, ..EXPOSURE };
        normals_from_photos([SIDE; 2], &scene.with_lights(&pixels), exposure, &Watch::none())
            .expect("there are known pixels")
    };
    assert!(run(limit).misfit < 1e-6);
    assert!(run(f32::INFINITY).misfit > 1e-2);
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let scene = Scene::ring(3, 0.9, 0.1);
    let pixels = scene.photos();
    let good = scene.with_lights(&pixels);
    let run = |photos: &[Photo]| normals_from_photos([SIDE; 2], photos, EXPOSURE, &Watch::none());
    assert!(run(&good).is_ok());
    assert!(matches!(run(&good[..2]), Err(PhotometricError::TooFew(2))));
    let mut photos = good.clone();
    photos[1].pixels = &pixels[1][1..];
    assert!(matches!(run(&photos), Err(PhotometricError::WrongLength { photo: 1, .. })));
    let mut broken = pixels[2].clone();
    broken[SIDE as usize + 3] = -1.0;
    photos = good.clone();
    photos[2].pixels = &broken;
    assert!(matches!(run(&photos), Err(PhotometricError::BadPixel { photo: 2, column: 3, row: 1, .. })));
    photos = good.clone();
    photos[0].to_light = [0.0; 3];
    assert!(matches!(run(&photos), Err(PhotometricError::BadLight(0))));
    for (photo, x) in photos.iter_mut().zip([-0.5, 0.0, 0.5]) {
        photo.to_light = [x, 0.0, 1.0];
    }
    assert!(matches!(run(&photos), Err(PhotometricError::LightsInAPlane)));
    // Lights are checked without their photographs, too.
    let lights =
        |photos: &[Photo]| photos.iter().map(|photo| (photo.to_light, photo.intensity)).collect::<Vec<_>>();
    assert!(matches!(check_lights(&lights(&photos)), Err(PhotometricError::LightsInAPlane)));
    assert!(matches!(check_lights(&lights(&good[1..])), Err(PhotometricError::TooFew(2))));
    assert_eq!(check_lights(&lights(&good)), Ok(()));
    let night = vec![0.0; pixels[0].len()];
    photos = good.clone();
    photos.iter_mut().for_each(|photo| photo.pixels = &night);
    assert!(matches!(run(&photos), Err(PhotometricError::NothingKnown)));
    let flag = std::sync::atomic::AtomicBool::new(true);
    let cancelled = normals_from_photos([SIDE; 2], &good, EXPOSURE, &Watch::cancelled_by(&flag));
    assert!(matches!(cancelled, Err(PhotometricError::Cancelled(_))));
}
