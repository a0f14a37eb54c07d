//! Height maps whose texels the tests know.

use std::io::Cursor;

use image::{DynamicImage, ImageBuffer, ImageFormat, Luma};

/// Texels of 16 bit, row by row from the top.
#[derive(Clone, Debug)]
pub struct Map {
    pub width: u32,
    pub height: u32,
    pub texels: Vec<u16>,
}

impl Map {
    pub fn new(width: u32, height: u32, texel: impl Fn(u32, u32) -> u16) -> Self {
        let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| texel(x, y));
        Self { width, height, texels: texels.collect() }
    }

    /// Creates a map of one height, as a part of the highest.
    pub fn constant(height: f64) -> Self {
        Self::new(4, 4, |_, _| (height * 65535.0).round() as u16)
    }

    /// Smooth hills that tile, no two alike.
    pub fn hills() -> Self {
        Self::new(16, 12, |x, y| {
            let [u, v] = [f64::from(x) / 16.0, f64::from(y) / 12.0].map(|part| part * std::f64::consts::TAU);
            let hills = u.sin() * v.cos() + 0.5 * (2.0 * u + 1.0).cos() + 0.4 * (2.0 * v + u).sin();
            ((0.5 + 0.25 * hills) * 65535.0).round() as u16
        })
    }

    /// More of them, as texture coordinates are long.
    pub fn many_hills() -> Self {
        Self::new(256, 128, |x, y| {
            let [u, v] =
                [f64::from(x) / 256.0, f64::from(y) / 128.0].map(|part| part * std::f64::consts::TAU);
            ((0.5 + 0.25 * ((6.0 * u).sin() * (4.0 * v).cos() + (3.0 * v + 5.0 * u).sin())) * 65535.0) as u16
        })
    }

    pub fn png(&self) -> Vec<u8> {
        let image = ImageBuffer::<Luma<u16>, _>::from_raw(self.width, self.height, self.texels.clone());
        encoded(&DynamicImage::ImageLuma16(image.expect("as many texels as the size says")), ImageFormat::Png)
    }
}

pub fn encoded(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    image.write_to(&mut Cursor::new(&mut bytes), format).expect("an image that the format can hold");
    bytes
}
