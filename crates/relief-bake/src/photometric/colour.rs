//! Albedo in colour, from known normals.

use super::normals::{Exposure, Photo, Photometry, dot};
use crate::fill;

/// Collects the albedo of red, green and blue from photographs that come one after the other. Only
/// one coloured photograph is held at a time.
///
/// With the unit normal `n` known, the albedo with the least sum of squares is `Σ I s / Σ s²` over
/// the samples used. Here `s = intensity (l · n)`. For the brightness from which the normals were
/// found, this is [`Photometry::albedo`].
pub struct ColourAlbedo<'a> {
    photometry: &'a Photometry,
    exposure: Exposure,
    sums: [Vec<f32>; 3],
    weights: Vec<f32>,
}

impl<'a> ColourAlbedo<'a> {
    /// Starts without any photograph, for a surface with these normals. `exposure` says which
    /// samples are used.
    pub fn new(photometry: &'a Photometry, exposure: Exposure) -> Self {
        let texels = photometry.albedo.len();
        Self { photometry, exposure, sums: [0; 3].map(|_| vec![0.0; texels]), weights: vec![0.0; texels] }
    }

    /// Adds a photograph: its brightness, which decides which samples are used, and its colours.
    /// Pixels beyond the surface's size are ignored.
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

    /// Returns red, green and blue of a surface of `size`. Texels without any used sample are
    /// filled in smoothly.
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
