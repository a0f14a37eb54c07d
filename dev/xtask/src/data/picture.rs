//! Grids of texels, and the files that they are kept in.

use image::{DynamicImage, ImageBuffer, ImageError, ImageFormat, Luma, Rgb};
use std::io::Cursor;
use std::path::Path;

/// A rectangle of texels, row by row from the top.
#[derive(Clone, Debug)]
pub struct Grid<T> {
    pub width: u32,
    pub height: u32,
    pub texels: Vec<T>,
}

impl<T> Grid<T> {
    /// A square whose texels are computed from texture coordinates, at texel centres.
    pub fn square(side: u32, mut texel: impl FnMut(f64, f64) -> T) -> Self {
        let at = |index: u32| (f64::from(index) + 0.5) / f64::from(side);
        let places = (0..side).flat_map(|row| (0..side).map(move |column| (column, row)));
        let texels = places.map(|(column, row)| texel(at(column), at(row))).collect();
        Self { width: side, height: side, texels }
    }
}

impl<A, B> Grid<(A, B)> {
    /// Two grids from one of pairs.
    pub fn unzip(self) -> (Grid<A>, Grid<B>) {
        let (a, b) = self.texels.into_iter().unzip();
        (
            Grid { width: self.width, height: self.height, texels: a },
            Grid { width: self.width, height: self.height, texels: b },
        )
    }
}

impl Grid<f64> {
    /// A 16-bit picture that uses the full range: the least value becomes 0, the greatest 65535.
    pub fn heights(&self) -> DynamicImage {
        let least = self.texels.iter().copied().fold(f64::INFINITY, f64::min);
        let most = self.texels.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let image = ImageBuffer::from_fn(self.width, self.height, |x, y| {
            let value = self.texels[(y * self.width + x) as usize];
            Luma([((value - least) / (most - least) * 65535.0 + 0.5) as u16])
        });
        DynamicImage::ImageLuma16(image)
    }
}

impl Grid<[f64; 3]> {
    /// An 8-bit picture of sRGB colours from 0 to 255.
    pub fn colours(&self) -> DynamicImage {
        let image = ImageBuffer::from_fn(self.width, self.height, |x, y| {
            Rgb(self.texels[(y * self.width + x) as usize].map(|part| (part + 0.5) as u8))
        });
        DynamicImage::ImageRgb8(image)
    }
}

/// The bytes of a PNG file. Where a file that shows the same picture is there already, its bytes: another
/// version of the compressor then changes nothing.
pub fn encoded(path: &Path, image: &DynamicImage) -> Result<Vec<u8>, ImageError> {
    if let Ok(bytes) = std::fs::read(path)
        && image::load_from_memory_with_format(&bytes, ImageFormat::Png).is_ok_and(|there| there == *image)
    {
        return Ok(bytes);
    }
    let mut bytes = Cursor::new(Vec::new());
    image.write_with_encoder(image::codecs::png::PngEncoder::new_with_quality(
        &mut bytes,
        image::codecs::png::CompressionType::Best,
        image::codecs::png::FilterType::Adaptive,
    ))?;
    Ok(bytes.into_inner())
}

/// A grey picture, its values from 0 to 1.
pub fn read_grey(path: &Path) -> Result<Grid<f64>, String> {
    let image = image::open(path).map_err(|error| format!("{}: {error}", path.display()))?.into_luma16();
    let (width, height) = image.dimensions();
    Ok(Grid {
        width,
        height,
        texels: image.pixels().map(|Luma([value])| f64::from(*value) / 65535.0).collect(),
    })
}
