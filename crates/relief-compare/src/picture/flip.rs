//! FLIP: the perceived difference of two pictures when one alternates with the other (Andersson,
//! Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, *FLIP: A Difference Evaluator for
//! Alternating Images*).
//!
//! Each channel of an opponent colour space is blurred as an eye at that distance would blur it.
//! Colours are then compared in L\*a\*b\*, with less weight on dark ones. Where edges and points of
//! one picture are missing in the other, the difference counts more.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use rayon::prelude::*;

use super::kernel::{Kernel, filtered};
use super::{Image, ImageError};

/// Pixels per degree for an eye 0.7 m from a display that is 0.7 m wide and has 3840 columns:
/// FLIP's default.
pub const PIXELS_PER_DEGREE: f64 = 3840.0 * PI / 180.0;

/// Differences of two pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Flip {
    /// Numbers of columns and rows.
    pub size: [u32; 2],
    /// Difference of each pixel, from 0 to 1, row by row from the top.
    pub differences: Vec<f32>,
}

impl Flip {
    /// Returns the mean difference.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.differences.iter().copied().map(f64::from).sum();
        sum / self.differences.len() as f64
    }
}

/// Exponents of the differences of colours (section 4.1.3) and of features (section 4.2.2).
const COLOR_EXPONENT: f64 = 0.7;
const FEATURE_EXPONENT: f64 = 0.5;

/// Differences up to `SMALL` times the greatest one are mapped to 0 to `MOST`, most of the range.
const SMALL: f64 = 0.4;
const MOST: f64 = 0.95;

/// Width of the feature detectors in degrees.
const FEATURE_DEGREES: f64 = 0.082;

/// Gaussian of a contrast sensitivity: weight and width.
type Gaussian = [f64; 2];

/// Contrast sensitivities of luminance, red against green, and blue against yellow: table 1.
const SENSITIVITIES: [&[Gaussian]; 3] = [&[[1.0, 0.0047]], &[[1.0, 0.0053]], &[[34.1, 0.04], [13.5, 0.025]]];

/// Greatest width among them.
const WIDEST: f64 = 0.04;

/// Computes the differences between a reference and a test picture, seen at `pixels_per_degree`
/// pixels per degree.
///
/// # Errors
///
/// When the pictures differ in size.
pub fn flip(reference: &Image, test: &Image, pixels_per_degree: f64) -> Result<Flip, ImageError> {
    reference.check_size(test)?;
    let colors = color_differences(reference, test, pixels_per_degree);
    let features = feature_differences(reference, test, pixels_per_degree);
    let differences = colors.into_iter().zip(features);
    let differences = differences.map(|(color, feature)| color.powf(1.0 - feature) as f32).collect();
    Ok(Flip { size: reference.size, differences })
}

/// Colour differences from 0 to 1 (section 4.1).
fn color_differences(reference: &Image, test: &Image, pixels_per_degree: f64) -> Vec<f64> {
    let [reference, test] = [reference, test].map(|image| seen_colors(image, pixels_per_degree));
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|color| hunt(lab(color)));
    let greatest = hyab(green, blue).powf(COLOR_EXPONENT);
    let small = SMALL * greatest;
    let remapped = |difference: f64| {
        if difference < small {
            MOST / small * difference
        } else {
            MOST + (difference - small) / (greatest - small) * (1.0 - MOST)
        }
    };
    let both = reference.into_par_iter().zip(test);
    both.map(|(a, b)| remapped(hyab(a, b).powf(COLOR_EXPONENT))).collect()
}

/// Colours of a picture after an eye's blur, in L\*a\*b\* with the Hunt effect: dark colours look
/// paler.
fn seen_colors(image: &Image, pixels_per_degree: f64) -> Vec<[f64; 3]> {
    let radius = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i32;
    let opponents: Vec<[f64; 3]> = image.pixels.par_iter().map(|&rgb| opponent(rgb.map(f64::from))).collect();
    let [luminance, red_green, blue_yellow] = [0, 1, 2].map(|channel| {
        let plane: Vec<f64> = opponents.iter().map(|color| color[channel]).collect();
        blurred(&plane, image.columns_and_rows(), SENSITIVITIES[channel], radius, pixels_per_degree)
    });
    let to_rgb = from_opponent_matrix();
    let colors = luminance.into_par_iter().zip(red_green).zip(blue_yellow);
    let shown = colors.map(|((luminance, red_green), blue_yellow)| {
        let rgb = from_opponent(&to_rgb, [luminance, red_green, blue_yellow]);
        hunt(lab(rgb.map(|part| part.clamp(0.0, 1.0))))
    });
    shown.collect()
}

/// Filters a channel with its contrast sensitivity, a sum of Gaussians whose weights add up to 1.
fn blurred(
    plane: &[f64],
    size: [usize; 2],
    sensitivity: &[Gaussian],
    radius: i32,
    pixels_per_degree: f64,
) -> Vec<f64> {
    let kernels = sensitivity.iter().map(|&[weight, width]| {
        let kernel = Kernel::new(radius, |place| {
            let degrees = place / pixels_per_degree;
            (-PI * PI * degrees * degrees / width).exp()
        });
        (kernel, weight * (PI / width).sqrt())
    });
    let kernels: Vec<(Kernel, f64)> = kernels.collect();
    let total: f64 = kernels.iter().map(|(kernel, weight)| weight * kernel.sum().powi(2)).sum();
    let mut sum = vec![0.0; plane.len()];
    for (kernel, weight) in kernels {
        let weighted = kernel.clone().scaled(weight / total);
        for (sum, value) in sum.iter_mut().zip(filtered(plane, size, &weighted, &kernel)) {
            *sum += value;
        }
    }
    sum
}

/// Differences of edges and points from 0 to 1 (section 4.2).
fn feature_differences(reference: &Image, test: &Image, pixels_per_degree: f64) -> Vec<f64> {
    let deviation = 0.5 * FEATURE_DEGREES * pixels_per_degree;
    let radius = (3.0 * deviation).ceil() as i32;
    let gauss = |place: f64| (-place * place / (2.0 * deviation * deviation)).exp();
    let smooth = Kernel::new(radius, gauss);
    let smooth = smooth.clone().scaled(1.0 / smooth.sum());
    let edge = Kernel::new(radius, |place| -place * gauss(place)).balanced();
    let curvature = |place: f64| (place * place / (deviation * deviation) - 1.0) * gauss(place);
    let point = Kernel::new(radius, curvature).balanced();
    let strengths = |image: &Image, detector: &Kernel| {
        let size = image.columns_and_rows();
        let luminance = |rgb: &[f32; 3]| (opponent(rgb.map(f64::from))[0] + 16.0) / 116.0;
        let luminance: Vec<f64> = image.pixels.iter().map(luminance).collect();
        let across = filtered(&luminance, size, detector, &smooth);
        let down = filtered(&luminance, size, &smooth, detector);
        across.into_iter().zip(down).map(|(across, down)| across.hypot(down)).collect::<Vec<f64>>()
    };
    let [edges, points] = [edge, point].map(|detector| {
        let (a, b) = (strengths(reference, &detector), strengths(test, &detector));
        a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).collect::<Vec<f64>>()
    });
    let greater = edges.into_iter().zip(points).map(|(edge, point)| edge.max(point));
    greater.map(|difference| (FRAC_1_SQRT_2 * difference).powf(FEATURE_EXPONENT)).collect()
}

impl Image {
    fn columns_and_rows(&self) -> [usize; 2] {
        self.size.map(|side| side as usize)
    }
}

/// Matrix from linear sRGB to XYZ under D65, in exact fractions.
const TO_XYZ: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// X, Y and Z of white.
fn white() -> [f64; 3] {
    TO_XYZ.map(|row| row.iter().sum())
}

/// X, Y and Z of a linear colour, divided by white's.
fn relative_xyz(rgb: [f64; 3]) -> [f64; 3] {
    let (xyz, white) =
        (TO_XYZ.map(|row| row.iter().zip(rgb).map(|(weight, part)| weight * part).sum::<f64>()), white());
    [0, 1, 2].map(|part| xyz[part] / white[part])
}

/// Converts a linear colour to the opponent space YCxCz, a linear version of L\*a\*b\*.
fn opponent(rgb: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = relative_xyz(rgb);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Matrix from X, Y and Z divided by white's to a linear colour.
fn from_opponent_matrix() -> glam::DMat3 {
    let to_xyz = glam::DMat3::from_cols_array_2d(&TO_XYZ).transpose();
    to_xyz.inverse() * glam::DMat3::from_diagonal(white().into())
}

/// Converts a colour of the opponent space to a linear colour.
fn from_opponent(to_rgb: &glam::DMat3, [luminance, red_green, blue_yellow]: [f64; 3]) -> [f64; 3] {
    let y = (luminance + 16.0) / 116.0;
    (*to_rgb * glam::DVec3::new(y + red_green / 500.0, y, y - blue_yellow / 200.0)).to_array()
}

/// Converts a linear colour to L\*a\*b\* (CIE 1976).
fn lab(rgb: [f64; 3]) -> [f64; 3] {
    const DELTA: f64 = 6.0 / 29.0;
    let [x, y, z] = relative_xyz(rgb).map(|part| {
        if part > DELTA.powi(3) { part.cbrt() } else { part / (3.0 * DELTA * DELTA) + 4.0 / 29.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Scales chroma by lightness, as it is perceived (Hunt 1952).
fn hunt([lightness, a, b]: [f64; 3]) -> [f64; 3] {
    [lightness, 0.01 * lightness * a, 0.01 * lightness * b]
}

/// Distance for large differences (Abasi, Tehran and Fairchild 2020): lightness and chroma are
/// separate.
fn hyab(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

#[cfg(test)]
mod tests {
    use relief_io::srgb_to_linear;

    use super::*;
    use relief_core::rng::Rng;

    const SIZE: [u32; 2] = [61, 47];

    /// Picture of 8-bit sRGB colours that any program can reproduce: noise of SplitMix64, ramps,
    /// stripes, or a mixture.
    fn picture(seed: u64, kind: u32) -> Image {
        let mut rng = Rng::new(seed);
        let pixels = (0..SIZE[0] * SIZE[1]).map(|at| {
            let (x, y) = (at % SIZE[0], at / SIZE[0]);
            let noise = [0; 3].map(|_| (rng.bits() >> 56) as u32);
            let ramp = [4 * x, 5 * y, 2 * (x + y)];
            let stripes = [if (x / 5 + y / 7) % 2 == 0 { 220 } else { 20 }; 3];
            let mixed = [0, 1, 2].map(|part| ramp[part] / 2 + noise[part] / 4 + stripes[part] / 8);
            let bytes = [noise, ramp, stripes, mixed][kind as usize];
            bytes.map(|byte| srgb_to_linear(f64::from(byte) / 255.0) as f32)
        });
        Image::new(SIZE, pixels.collect()).expect("a picture")
    }

    /// Seeds and kinds of pairs, pixels per degree, and the mean by the authors' own program
    /// (`flip-evaluator` 1.7 of PyPI).
    const PAIRS: [([u64; 2], [u32; 2], f64, f64); 10] = [
        ([1, 2], [0, 0], PIXELS_PER_DEGREE, 0.460_129),
        ([1, 2], [1, 2], PIXELS_PER_DEGREE, 0.832_805),
        ([1, 2], [3, 3], PIXELS_PER_DEGREE, 0.170_860),
        ([1, 2], [0, 1], PIXELS_PER_DEGREE, 0.771_209),
        ([1, 2], [2, 3], PIXELS_PER_DEGREE, 0.743_784),
        ([3, 4], [1, 3], PIXELS_PER_DEGREE, 0.530_661),
        ([3, 4], [3, 1], PIXELS_PER_DEGREE, 0.530_907),
        ([3, 4], [3, 3], 30.0, 0.309_313),
        ([3, 4], [2, 1], 30.0, 0.905_132),
        ([3, 4], [0, 3], 100.0, 0.621_623),
    ];

    #[test]
    fn means_are_those_of_the_authors_program() {
        for (seeds, kinds, pixels_per_degree, expected) in PAIRS {
            let [reference, test] = [0, 1].map(|at| picture(seeds[at], kinds[at]));
            let mean = flip(&reference, &test, pixels_per_degree).expect("as large").mean();
            assert!((mean - expected).abs() < 1e-3, "{seeds:?} {kinds:?}: {mean}, expected {expected}");
        }
    }

    #[test]
    fn it_is_symmetric_and_stays_between_0_and_1() {
        let [a, b] = [picture(5, 0), picture(6, 2)];
        let [ab, ba] = [flip(&a, &b, PIXELS_PER_DEGREE), flip(&b, &a, PIXELS_PER_DEGREE)];
        let (ab, ba) = (ab.expect("as large"), ba.expect("as large"));
        assert_eq!(ab, ba);
        assert!(ab.differences.iter().all(|difference| (0.0..=1.0).contains(difference)));
    }
}
