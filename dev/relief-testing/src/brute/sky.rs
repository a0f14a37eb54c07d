//! Ambient occlusion and bent normals of one texel, from its horizons.

use std::f64::consts::{FRAC_PI_2, TAU};

use relief_core::HeightMap;

use super::horizon::{HorizonRay, slope};

/// Settings of the view of the sky from the texels of a map.
#[derive(Clone, Copy, Debug)]
pub struct Sky {
    /// Size of a texel in metres.
    pub texel_m: [f64; 2],
    /// Depth of the relief in metres.
    pub scale_m: f64,
    /// In how many azimuths.
    pub azimuths: u32,
    /// Reach in texels.
    pub reach: f64,
    /// The map's highest texel.
    pub highest: f64,
}

impl Sky {
    /// Angles from `+u` towards `+v`, and the horizons' elevations there, in radians.
    pub fn horizons(&self, map: &HeightMap, texel: [u32; 2]) -> impl Iterator<Item = [f64; 2]> {
        (0..self.azimuths).map(move |azimuth| {
            let angle = TAU * f64::from(azimuth) / f64::from(self.azimuths);
            let ray = HorizonRay::new(angle, self.texel_m);
            let slope = slope(map, texel, &ray, self.reach, self.highest) * self.scale_m / ray.step_m;
            [angle, slope.max(0.0).atan()]
        })
    }

    /// The part of a uniform sky's light that reaches a plane parallel to the base.
    pub fn visibility(&self, map: &HeightMap, texel: [u32; 2]) -> f64 {
        let open = self.horizons(map, texel).map(|[_, elevation]| elevation.cos().powi(2));
        open.sum::<f64>() / f64::from(self.azimuths)
    }

    /// The unit vector along the mean open direction: along `+u`, along `-v`, up.
    pub fn bent_normal(&self, map: &HeightMap, texel: [u32; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for [angle, elevation] in self.horizons(map, texel) {
            let (sin, cos) = elevation.sin_cos();
            let aside = FRAC_PI_2 - elevation - sin * cos;
            for (sum, part) in sum.iter_mut().zip([angle.cos() * aside, -angle.sin() * aside, cos * cos]) {
                *sum += part;
            }
        }
        let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
        sum.map(|x| x / length)
    }
}
