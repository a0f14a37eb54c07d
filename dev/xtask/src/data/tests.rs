use super::lattice::{fractal_noise, random};
use super::picture::Grid;
use super::*;
use image::GenericImageView;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

#[test]
fn the_committed_files_are_those_that_are_generated() {
    for file in files(root()).expect("the elevation model is there") {
        let path = root().join(&file.path);
        let there = std::fs::read(&path).expect("a committed file");
        assert!(there == file.bytes, "{}: run `cargo xtask data`", path.display());
    }
}

#[test]
fn files_that_show_the_same_picture_are_kept_and_others_replaced() {
    let path = root().join("data/noise.png");
    let image = noise::map().heights();
    assert_eq!(picture::encoded(&path, &image).ok(), std::fs::read(&path).ok());
    let other = spikes::map().heights();
    assert_ne!(picture::encoded(&path, &other).ok(), std::fs::read(&path).ok());
}

#[test]
fn heights_use_the_full_range() {
    for map in [bricks::maps().0, cobbles::maps().0, spikes::map(), logo::map()] {
        let image = map.heights().into_luma16();
        let values = || image.pixels().map(|pixel| pixel.0[0]);
        assert_eq!((values().min(), values().max()), (Some(0), Some(u16::MAX)));
    }
}

/// The largest step between neighbours across the tile's edge, relative to the largest within it.
fn seam(map: &Grid<f64>) -> f64 {
    let (w, h) = (map.width as usize, map.height as usize);
    let at = |x: usize, y: usize| map.texels[(y % h) * w + x % w];
    let (mut within, mut across) = (0.0f64, 0.0f64);
    for y in 0..h {
        for x in 0..w {
            for (nx, ny) in [(x + 1, y), (x, y + 1)] {
                let step = (at(x, y) - at(nx, ny)).abs();
                let worst = if nx == w || ny == h { &mut across } else { &mut within };
                *worst = worst.max(step);
            }
        }
    }
    across / within
}

#[test]
fn maps_tile_without_a_seam() {
    for map in [bricks::maps().0, cobbles::maps().0, spikes::map(), logo::map()] {
        assert!(seam(&map) <= 1.0, "{}", seam(&map));
    }
    let noise = Grid::square(64, |u, v| fractal_noise(u, v, 8, 3, 5));
    assert!(seam(&noise) <= 1.0);
    // Without wrapping the same noise has one.
    let cut = Grid::square(64, |u, v| fractal_noise(u * 0.9, v * 0.9, 8, 3, 5));
    assert!(seam(&cut) > 1.2);
}

#[test]
fn random_numbers_are_even() {
    let mut counts = [0u32; 16];
    for i in 0..160_000u32 {
        counts[(random(i % 400, i / 400, 7) * 16.0) as usize] += 1;
    }
    // 10,000 are expected in each sixteenth, with a standard deviation of 97.
    assert!(counts.iter().all(|count| count.abs_diff(10_000) < 500), "{counts:?}");
}

#[test]
fn the_elevation_model_covers_its_stated_range() {
    let model = picture::read_grey(&root().join("data/jacksboro.png")).expect("the elevation model");
    assert_eq!((model.width, model.height), (403, 344));
    // Whole metres from 236 to 1076.
    for texel in &model.texels {
        let metres = 236.0 + 840.0 * texel;
        assert!((metres - metres.round()).abs() < 840.0 / 65535.0, "{metres}");
    }
    let colours = jacksboro::colours(&model).colours();
    assert_eq!(colours.dimensions(), (202, 172));
}
