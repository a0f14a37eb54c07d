//! Pictures of pages: reduced, and compared beyond rounding.

use std::io::Cursor;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::imageops::{FilterType, resize};
use image::{ImageFormat, RgbImage};

/// Quality of the JPEGs, of 100.
const QUALITY: u8 = 85;

/// Side of the blocks in pixels whose means are compared.
const BLOCK: u32 = 8;

/// Greatest difference of a block's mean, of 255. A sample that falls on the other side of an edge by
/// rounding moves the mean of its block by less than 1; a change that can be seen moves one by more.
const TOLERANCE: f64 = 2.0;

/// A JPEG of a picture's file, at most this wide.
pub fn shown(file: &Path, width: u32) -> Result<Vec<u8>, String> {
    let failed = |error: image::ImageError| format!("{}: {error}", file.display());
    let mut picture = image::open(file).map_err(failed)?.to_rgb8();
    if picture.width() > width {
        let height = (f64::from(picture.height()) * f64::from(width) / f64::from(picture.width())).round();
        picture = resize(&picture, width, height as u32, FilterType::CatmullRom);
    }
    encoded(&picture).map_err(failed)
}

/// The JPEG of a picture.
pub fn encoded(picture: &RgbImage) -> Result<Vec<u8>, image::ImageError> {
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, QUALITY).encode_image(picture)?;
    Ok(bytes)
}

/// Compares two JPEGs; an error says how they differ beyond rounding.
pub fn same(there: &[u8], made: &[u8]) -> Result<(), String> {
    let [there, made] = [decoded(there)?, decoded(made)?];
    if there.dimensions() != made.dimensions() {
        let [a, b] = [there.dimensions(), made.dimensions()];
        return Err(format!("has {}x{} pixels, and is made with {}x{}", a.0, a.1, b.0, b.1));
    }
    let (width, height) = made.dimensions();
    for top in (0..height).step_by(BLOCK as usize) {
        for left in (0..width).step_by(BLOCK as usize) {
            let difference = difference(&there, &made, left, top);
            if difference > TOLERANCE {
                let [right, bottom] = [(left + BLOCK).min(width), (top + BLOCK).min(height)];
                return Err(format!(
                    "differs from what its command makes: by {difference:.1} of 255 on average between \
                     the pixels {left},{top} and {right},{bottom}"
                ));
            }
        }
    }
    Ok(())
}

fn decoded(bytes: &[u8]) -> Result<RgbImage, String> {
    let picture = image::load(Cursor::new(bytes), ImageFormat::Jpeg);
    Ok(picture.map_err(|error| format!("cannot be read: {error}"))?.to_rgb8())
}

/// Greatest difference of a channel's mean over a block.
fn difference(there: &RgbImage, made: &RgbImage, left: u32, top: u32) -> f64 {
    let [right, bottom] = [(left + BLOCK).min(made.width()), (top + BLOCK).min(made.height())];
    let mut sums = [0i64; 3];
    for y in top..bottom {
        for x in left..right {
            let [a, b] = [there.get_pixel(x, y), made.get_pixel(x, y)];
            for (sum, (a, b)) in sums.iter_mut().zip(a.0.into_iter().zip(b.0)) {
                *sum += i64::from(a) - i64::from(b);
            }
        }
    }
    let pixels = f64::from((right - left) * (bottom - top));
    sums.into_iter().map(|sum| sum.unsigned_abs() as f64 / pixels).fold(0.0, f64::max)
}
