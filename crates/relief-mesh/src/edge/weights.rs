//! Weights of edges that are divided by voxels.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 3.2, which asks for more triangles where
//! heights vary and toward the silhouette. Gumhold and Hüttner 1999, section 6, asks for fewer
//! where a surface faces the eye and more where the relief is steep.

use glam::DVec3;
use relief_core::mesh::{BasePoint, Vertex};

use crate::surface::Relief;
use crate::{MesherError, View};

/// Weights that give an edge more or fewer parts than voxels.
///
/// The result depends on the edge's two ends, and on the height map between their texture
/// coordinates. An edge has `(1 - silhouette f) (1 + slope s + variation v)` times as many parts as
/// voxels:
///
/// - `f` is the cosine between the directions of its ends and those to the eye, from 0 at the
///   silhouette to 1.
/// - `s` is the mean slope of the relief along it, in metres a metre.
/// - `v` is the greatest difference of heights along it, as a part of what the map can hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weights {
    /// Weight of `f`, from 0 to 1. At 1 an edge that faces the eye has one part.
    pub silhouette: f64,
    /// Weight of `s`, at least 0.
    pub slope: f64,
    /// Weight of `v`, at least 0.
    pub variation: f64,
}

/// Parts of an edge between which heights are sampled.
const SAMPLES: u32 = 16;

impl Weights {
    /// No weights: edges have as many parts as voxels.
    pub const NONE: Self = Self { silhouette: 0.0, slope: 0.0, variation: 0.0 };

    /// Returns an error if a weight is out of its range.
    pub(crate) fn check(&self) -> Result<(), MesherError> {
        let Self { silhouette, slope, variation } = *self;
        let is_weight = |weight: f64| weight >= 0.0 && weight.is_finite();
        if (0.0..=1.0).contains(&silhouette) && is_weight(slope) && is_weight(variation) {
            Ok(())
        } else {
            Err(MesherError::BadWeights { weights: *self })
        }
    }

    /// Returns the number of parts of an edge, as a multiple of its voxels.
    pub(crate) fn factor(&self, relief: &Relief, view: &View, ends: [&Vertex; 2]) -> f64 {
        let facing = ends.map(|end| {
            let camera = &view.camera;
            let toward = if camera.is_orthographic() {
                -camera.forward()
            } else {
                (camera.eye() - end.position.as_dvec3()).normalize_or_zero()
            };
            end.normal.as_dvec3().normalize_or(DVec3::ZERO).dot(toward).abs()
        });
        let [a, b] = ends.map(BasePoint::from);
        let at = |k: u32| {
            let part = f64::from(k) / f64::from(SAMPLES);
            relief.height_at_uv(a.uv + (b.uv - a.uv) * part)
        };
        let heights: Vec<f64> = (0..=SAMPLES).map(at).collect();
        let length = a.position.distance(b.position);
        let rise: f64 = heights.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        let slope = if length > 0.0 { (relief.map().scale_m() * rise / length).abs() } else { 0.0 };
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let faces = (facing[0] + facing[1]) / 2.0;
        (1.0 - self.silhouette * faces) * (1.0 + self.slope * slope + self.variation * (greatest - least))
    }
}
