//! Albedo in colour, once the normals are known.

use super::normals::{Exposure, Photo, Photometry, dot};
use crate::fill;

/// Collects the albedo of red, green and blue from photographs that come one after the other, so that one of
/// them in colour is held at a time.
///
/// With the unit normal `n` known, the albedo with the least sum of squares is `Σ I s / Σ s²` over the
/// samples used, where `s = intensity (l · n)`. For the brightness that the normals were found from it is
/// [`Photometry::albedo`].
pub struct ColourAlbedo<'a> {
    photometry: &'a Photometry,
    exposure: Exposure,
    sums: [Vec<f32>; 3],
    weights: Vec<f32>,
}

impl<'a> ColourAlbedo<'a> {
    /// Of a surface with these normals, from samples with that exposure.
    pub fn new(photometry: &'a Photometry, exposure: Exposure) -> Self {
        let texels = photometry.albedo.len();
        Self { photometry, exposure, sums: [0; 3].map(|_| vec![0.0; texels]), weights: vec![0.0; texels] }
    }

    /// Adds a photograph: its brightness, which decides what samples are used, and its colours. Pixels beyond
    /// the surface's size are not looked at.
    pub fn add(&mut self, photo: &Photo, colours: &[[f32; 4]]) {
        let length = dot(photo.to_light, photo.to_light).sqrt();
        let light = photo.to_light.map(|x| x / length * photo.intensity);
        let [x, y, z] = &self.photometry.normals;
        for (at, (&brightness, colour)) in
            photo.pixels.iter().zip(colours).take(self.weights.len()).enumerate()
        {
            let facing = dot(light, [x[at], y[at], z[at]].map(f64::from)) as f32;
            if facing > 0.0 && brightness > self.exposure.shadow && brightness < self.exposure.overexposed {
                for (sums, value) in self.sums.iter_mut().zip(colour) {
                    sums[at] += value * facing;
                }
                self.weights[at] += facing * facing;
            }
        }
    }

    /// Red, green and blue of a surface of that size; where no sample was used they are filled in smoothly.
    pub fn finish(self, size: [u32; 2]) -> [Vec<f32>; 3] {
        let known: Vec<bool> = self.weights.iter().map(|&weight| weight > 0.0).collect();
        self.sums.map(|mut plane| {
            for (value, &weight) in plane.iter_mut().zip(&self.weights).filter(|(_, weight)| **weight > 0.0) {
                *value /= weight;
            }
            fill::fill(size.map(|side| side as usize), &mut plane, &known);
            plane
        })
    }
}
