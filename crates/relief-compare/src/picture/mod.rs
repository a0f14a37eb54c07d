//! Measures of the difference of pictures: FLIP, structural similarity, peak signal-to-noise ratio,
//! and root mean square error.

mod flip;
mod kernel;

use relief_io::linear_to_srgb;
use relief_render::job::Rendering;
use relief_render::picture::linear;
use relief_scene::Scene;

pub use flip::{Flip, PIXELS_PER_DEGREE, flip};

/// Picture to compare, in linear colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Numbers of columns and rows.
    size: [u32; 2],
    /// Linear red, green and blue from 0 to 1, row by row from the top.
    pixels: Vec<[f32; 3]>,
}

/// Error of pictures that cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ImageError {
    /// The pictures differ in size.
    #[error("a picture of {}x{} pixels cannot be compared with one of {}x{}", a[0], a[1], b[0], b[1])]
    Sizes {
        /// Columns and rows of the first.
        a: [u32; 2],
        /// Columns and rows of the second.
        b: [u32; 2],
    },
    /// The number of pixels does not match the size, or is 0.
    #[error("{pixels} pixels do not form a picture of {}x{}", size[0], size[1])]
    Pixels {
        /// Columns and rows.
        size: [u32; 2],
        /// Number of pixels.
        pixels: usize,
    },
}

impl Image {
    /// Creates a picture from linear colours, row by row from the top. Values that a display cannot
    /// show (below 0, above 1, NaN) are clamped to 0 or 1.
    ///
    /// # Errors
    ///
    /// When the number of pixels does not match the size, or is 0.
    pub fn new(size: [u32; 2], linear: Vec<[f32; 3]>) -> Result<Self, ImageError> {
        let count = size.map(u64::from).iter().product::<u64>();
        if count == 0 || linear.len() as u64 != count {
            return Err(ImageError::Pixels { size, pixels: linear.len() });
        }
        // NaN is not above 0.
        let cut = |part: f32| if part > 0.0 { part.min(1.0) } else { 0.0 };
        let pixels = linear.into_iter().map(|pixel| pixel.map(cut)).collect();
        Ok(Self { size, pixels })
    }

    /// Creates the picture of a scene's rendering.
    ///
    /// # Errors
    ///
    /// When the rendering has no pixels.
    pub fn of(rendering: &Rendering, scene: &Scene) -> Result<Self, ImageError> {
        Self::new([rendering.width, rendering.height], linear(rendering, scene))
    }

    /// Returns the numbers of columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the linear colours, row by row from the top.
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.pixels
    }

    /// Returns the picture in 8-bit sRGB.
    pub fn srgb8(&self) -> Vec<[u8; 3]> {
        let byte = |linear: f32| (linear_to_srgb(linear.into()) * 255.0 + 0.5) as u8;
        self.pixels.iter().map(|pixel| pixel.map(byte)).collect()
    }

    /// Returns the difference of each pixel from another picture's: the root mean square of its parts.
    ///
    /// # Errors
    ///
    /// When the pictures differ in size.
    pub fn differences(&self, other: &Image) -> Result<Vec<f32>, ImageError> {
        self.check_size(other)?;
        let difference = |(a, b): (&[f32; 3], &[f32; 3])| {
            let squares = [0, 1, 2].map(|part| (a[part] - b[part]).powi(2));
            (squares.iter().sum::<f32>() / 3.0).sqrt()
        };
        Ok(self.pixels.iter().zip(&other.pixels).map(difference).collect())
    }

    /// Checks that both pictures have the same size.
    fn check_size(&self, other: &Image) -> Result<(), ImageError> {
        if self.size == other.size {
            return Ok(());
        }
        Err(ImageError::Sizes { a: self.size, b: other.size })
    }
}

/// Returns the root mean square difference of the linear colours.
///
/// # Errors
///
/// When the pictures differ in size.
pub fn root_mean_square(a: &Image, b: &Image) -> Result<f64, ImageError> {
    a.check_size(b)?;
    let parts = a.pixels.as_flattened().iter().zip(b.pixels.as_flattened());
    let sum: f64 = parts.map(|(a, b)| f64::from(a - b).powi(2)).sum();
    Ok((sum / (3 * a.pixels.len()) as f64).sqrt())
}

/// Returns the peak signal-to-noise ratio of the 8-bit sRGB pictures in decibels; `None` if they
/// are equal.
///
/// # Errors
///
/// When the pictures differ in size.
pub fn peak_signal_to_noise(a: &Image, b: &Image) -> Result<Option<f64>, ImageError> {
    a.check_size(b)?;
    let (bytes_a, bytes_b) = (a.srgb8(), b.srgb8());
    let parts = bytes_a.as_flattened().iter().zip(bytes_b.as_flattened());
    let sum: f64 = parts.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum();
    let mean = sum / bytes_a.as_flattened().len() as f64;
    Ok((mean > 0.0).then(|| 10.0 * (255.0 * 255.0 / mean).log10()))
}

/// Returns the structural similarity of the 8-bit luma of both pictures (Wang, Bovik, Sheikh and
/// Simoncelli 2004). It is the mean over windows of 8 x 8 pixels, 1 if they are equal.
///
/// # Errors
///
/// When the pictures differ in size.
pub fn structural_similarity(a: &Image, b: &Image) -> Result<f64, ImageError> {
    a.check_size(b)?;
    let gray = |image: &Image| {
        let [width, height] = image.size;
        let luma = image.srgb8().into_iter().map(|rgb| {
            // Rec. 709.
            let [r, g, b] = rgb.map(f64::from);
            (0.2126 * r + 0.7152 * g + 0.0722 * b + 0.5) as u8
        });
        image::GrayImage::from_vec(width, height, luma.collect())
            .ok_or(ImageError::Pixels { size: image.size, pixels: image.pixels.len() })
    };
    let algorithm = image_compare::Algorithm::MSSIMSimple;
    let similarity = image_compare::gray_similarity_structure(&algorithm, &gray(a)?, &gray(b)?);
    similarity.map(|similarity| similarity.score).map_err(|_| ImageError::Sizes { a: a.size, b: b.size })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(side: u32, add: f32) -> Image {
        let count = side * side;
        let pixels = (0..count).map(|at| [at as f32 / count as f32, 0.3 + add, 0.1]).collect();
        Image::new([side, side], pixels).expect("a picture")
    }

    #[test]
    fn the_same_picture_has_no_error() {
        let image = ramp(20, 0.0);
        assert_eq!(root_mean_square(&image, &image), Ok(0.0));
        assert_eq!(peak_signal_to_noise(&image, &image), Ok(None));
        assert_eq!(structural_similarity(&image, &image), Ok(1.0));
        assert_eq!(flip(&image, &image, PIXELS_PER_DEGREE).map(|flip| flip.mean()), Ok(0.0));
    }

    #[test]
    fn errors_are_those_that_one_computes_by_hand() {
        let [a, b] = [ramp(16, 0.0), ramp(16, 0.3)];
        let rms = root_mean_square(&a, &b).expect("as large");
        assert!((rms - 0.3 / 3f64.sqrt()).abs() < 1e-6, "{rms}");
        // Linear 0.3 and 0.6 are the bytes 149 and 203 of sRGB; of three parts one differs.
        let psnr = peak_signal_to_noise(&a, &b).expect("as large").expect("they differ");
        assert!((psnr - 10.0 * (3.0 * (255.0 / 54.0f64).powi(2)).log10()).abs() < 1e-9, "{psnr}");
        let similarity = structural_similarity(&a, &b).expect("as large");
        assert!((0.2..0.99).contains(&similarity), "{similarity}");
    }

    #[test]
    fn unreadable_and_wrongly_sized_pictures_are_refused() {
        assert_eq!(Image::new([2, 2], vec![]), Err(ImageError::Pixels { size: [2, 2], pixels: 0 }));
        assert_eq!(Image::new([0, 2], vec![]), Err(ImageError::Pixels { size: [0, 2], pixels: 0 }));
        let [a, b] = [ramp(2, 0.0), ramp(3, 0.0)];
        let sizes = ImageError::Sizes { a: [2, 2], b: [3, 3] };
        assert_eq!(root_mean_square(&a, &b), Err(sizes));
        assert_eq!(peak_signal_to_noise(&a, &b), Err(sizes));
        assert_eq!(structural_similarity(&a, &b), Err(sizes));
        assert_eq!(flip(&a, &b, PIXELS_PER_DEGREE).map(|flip| flip.mean()), Err(sizes));
        let cut = Image::new([1, 1], vec![[f32::NAN, -1.0, f32::INFINITY]]).expect("a pixel");
        assert_eq!(cut.pixels(), [[0.0, 0.0, 1.0]]);
    }
}
