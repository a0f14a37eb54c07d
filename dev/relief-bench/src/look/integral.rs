//! The model of `metallic-roughness` integrated over all directions of the light, in `f64`.
//!
//! The model is appendix B of glTF 2.0; its specular part is multiplied by Turquin's factor.

use std::f64::consts::TAU;

use glam::DVec3;

use super::Case;
use super::surroundings::Light;

/// Directions over which the specular and the diffuse part are integrated.
const SAMPLES: u32 = 4096;

/// The part that surfaces other than metals reflect along the normal.
const DIELECTRIC: f64 = 0.04;

/// A material as seen in a frame in which the normal is `+z`.
struct Seen {
    diffuse: DVec3,
    specular: DVec3,
    alpha: f64,
    view: DVec3,
}

impl Seen {
    fn of(case: &Case, base: DVec3, cosine: f64) -> Self {
        let (metallic, roughness) = (f64::from(case.metallic), f64::from(case.roughness));
        let view = DVec3::new((1.0 - cosine * cosine).max(0.0).sqrt(), 0.0, cosine);
        Self {
            diffuse: base * (1.0 - metallic),
            specular: DVec3::splat(DIELECTRIC).lerp(base, metallic),
            alpha: roughness * roughness,
            view,
        }
    }

    /// What a facet reflects, by the cosine between its normal and the view (Schlick 1994).
    fn fresnel(&self, cosine: f64) -> DVec3 {
        self.specular + (DVec3::ONE - self.specular) * (1.0 - cosine.min(1.0)).powi(5)
    }

    /// Smith's masking of both directions, with heights correlated, over four times both cosines.
    fn visible(&self, toward: DVec3) -> f64 {
        let hidden = |z: f64| (self.alpha.powi(2) + (1.0 - self.alpha.powi(2)) * z * z).sqrt();
        0.5 / (toward.z * hidden(self.view.z) + self.view.z * hidden(toward.z))
    }

    /// A facet's normal, distributed as those that are visible (Heitz 2018).
    fn facet(&self, [first, second]: [f64; 2]) -> DVec3 {
        let stretch = DVec3::new(self.alpha, self.alpha, 1.0);
        let view = (self.view * stretch).normalize();
        let aside = if view.z < 0.9999 { DVec3::Z.cross(view).normalize() } else { DVec3::X };
        let (sin, cos) = (TAU * second).sin_cos();
        let (x, y) = (first.sqrt() * cos, first.sqrt() * sin);
        let part = 0.5 * (1.0 + view.z);
        let y = (1.0 - part) * (1.0 - x * x).sqrt() + part * y;
        let up = (1.0 - x * x - y * y).max(0.0).sqrt();
        ((aside * x + view.cross(aside) * y + view * up) * stretch).normalize()
    }

    /// Calls with a sample's direction, facet and weight: the part of the light that white facets reflect.
    fn reflect(&self, mut call: impl FnMut(DVec3, DVec3, f64)) {
        for sample in 0..SAMPLES {
            let half = self.facet(point(sample));
            let toward = half * (2.0 * self.view.dot(half)) - self.view;
            if toward.z > 0.0 {
                let hidden = (self.alpha.powi(2) + (1.0 - self.alpha.powi(2)) * self.view.z.powi(2)).sqrt();
                let weight = 2.0 * self.visible(toward) * toward.z * (self.view.z + hidden);
                call(toward, half, weight / f64::from(SAMPLES));
            }
        }
    }

    /// Turquin's factor.
    fn again(&self) -> DVec3 {
        let mut once = 0.0;
        self.reflect(|_, _, weight| once += weight);
        DVec3::ONE + self.specular * (1.0 / once - 1.0)
    }
}

/// What a surface with that normal shows of a directional light of irradiance 1.
pub fn of_light(case: &Case, base: DVec3, [normal, view, toward]: [DVec3; 3]) -> DVec3 {
    let cosine = normal.dot(toward);
    if cosine <= 0.0 {
        return DVec3::ZERO;
    }
    let seen = Seen::of(case, base, normal.dot(view));
    let half = (view + toward).normalize();
    let fresnel = seen.fresnel(view.dot(half));
    let squared = seen.alpha.powi(2);
    let spread = normal.cross(half).length_squared() + squared * normal.dot(half).powi(2);
    let facets = squared / (spread * spread) * seen.visible(DVec3::new(0.0, 0.0, cosine));
    (seen.diffuse * (DVec3::ONE - fresnel) + fresnel * seen.again() * facets) * cosine
}

/// What a surface with that normal shows of light from all around. What is not reflected is scattered, as in
/// both programs.
pub fn of_surroundings(case: &Case, base: DVec3, [normal, view]: [DVec3; 2], light: Light) -> DVec3 {
    let seen = Seen::of(case, base, normal.dot(view));
    let along = (view - normal * normal.dot(view)).normalize_or(normal.any_orthonormal_vector());
    let across = normal.cross(along);
    let around = |at: DVec3| light((along * at.x + across * at.y + normal * at.z).normalize());
    let (mut shown, mut reflected) = (DVec3::ZERO, DVec3::ZERO);
    let again = seen.again();
    seen.reflect(|toward, half, weight| {
        let part = seen.fresnel(seen.view.dot(half)) * again * weight;
        reflected += part;
        shown += part * around(toward);
    });
    let mut scattered = DVec3::ZERO;
    if seen.diffuse != DVec3::ZERO {
        for sample in 0..SAMPLES {
            let [first, second] = point(sample);
            let (sin, cos) = (TAU * second).sin_cos();
            let (flat, up) = (first.sqrt(), (1.0 - first).sqrt());
            scattered += around(DVec3::new(flat * cos, flat * sin, up)) / f64::from(SAMPLES);
        }
    }
    shown + seen.diffuse * (DVec3::ONE - reflected) * scattered
}

/// Point of a square, of as many that fill it evenly (Hammersley).
fn point(sample: u32) -> [f64; 2] {
    let first = (f64::from(sample) + 0.5) / f64::from(SAMPLES);
    [first, f64::from(sample.reverse_bits()) / f64::from(u32::MAX)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_surfaces_in_white_surroundings_cannot_be_seen() {
        for (roughness, metallic) in [(0.1, 1.0), (0.5, 1.0), (1.0, 1.0), (0.1, 0.0), (1.0, 0.0)] {
            let case = Case { metallic, roughness, around: None };
            let normal = DVec3::new(0.3, 0.4, 0.8).normalize();
            let shown = of_surroundings(&case, DVec3::ONE, [normal, DVec3::Z], |_| DVec3::ONE);
            assert!((shown - DVec3::ONE).abs().max_element() < 1e-9, "{shown}");
        }
    }

    #[test]
    fn a_light_is_a_narrow_part_of_the_surroundings() {
        // A lobe around +y in which a white surface that faces it shows as 1.
        const SHARPNESS: i32 = 200;
        let lobe: Light =
            |toward| DVec3::splat(toward.y.max(0.0).powi(SHARPNESS) * f64::from(SHARPNESS + 2) / 2.0);
        let [normal, view] = [DVec3::new(0.1, 0.8, 0.5), DVec3::new(0.2, 0.3, 0.9)].map(DVec3::normalize);
        for roughness in [0.75, 1.0] {
            let case = Case { metallic: 1.0, roughness, around: None };
            let base = DVec3::new(0.9, 0.6, 0.3);
            let wide = of_surroundings(&case, base, [normal, view], lobe);
            let sharp = of_light(&case, base, [normal, view, DVec3::Y]);
            assert!((wide / sharp - DVec3::ONE).abs().max_element() < 0.05, "{wide} {sharp}");
        }
    }
}
