//! Lines from a base point to the detailed mesh.

use relief_core::mesh::BasePoint;
use relief_core::raycast::{Ray, RayCaster, Sides, SurfaceHit};

use super::Layer;

/// Result of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LineHit {
    /// Hit of the detailed mesh, at this displacement in metres.
    At(f64),
    /// Only faces turned the other way are hit.
    BackFace,
    /// Nothing is hit.
    Miss,
}

/// Settings of the lines.
pub(super) struct Line<'a> {
    pub high: &'a RayCaster,
    /// Greatest distance of a hit, in metres.
    pub cage_m: f64,
    pub layer: Layer,
    pub two_sided: bool,
    /// Heights up to this are 0, in metres.
    pub rounding: f64,
}

impl Line<'_> {
    /// Casts a line outward and inward from a base point along its normal.
    pub fn cast(&self, base: &BasePoint) -> LineHit {
        let length = base.normal.length();
        match self.find(base) {
            Some((height, _)) if height.abs() * length <= self.rounding => LineHit::At(0.0),
            Some((height, _)) => LineHit::At(height),
            None => {
                let both = Line { two_sided: true, ..*self };
                if both.find(base).is_some() { LineHit::BackFace } else { LineHit::Miss }
            }
        }
    }

    /// Returns the displacement that takes a base point to the detailed mesh, in metres, and the
    /// hit.
    pub fn find(&self, base: &BasePoint) -> Option<(f64, SurfaceHit)> {
        let length = base.normal.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        // A displacement of this much is as far as the cage.
        let farthest = self.cage_m / length;
        let [outward, inward] =
            [base.normal, -base.normal].map(|direction| Ray { origin: base.position, direction });
        let within = |hit: &SurfaceHit| hit.t <= farthest;
        // An outward ray meets a face turned outward from its back.
        let agrees = |hit: &SurfaceHit| self.two_sided || !hit.front;
        let mut out = self.high.hits(&outward, Sides::Both).take_while(within).filter(agrees);
        let sides = if self.two_sided { Sides::Both } else { Sides::Front };
        let inner = || self.high.next_hit(&inward, sides, None).filter(within);
        let above = match self.layer {
            Layer::Nearest => out.next(),
            Layer::Outermost => out.last(),
        };
        let below = match (self.layer, above) {
            (Layer::Outermost, Some(_)) => None,
            _ => inner(),
        };
        match (above, below) {
            (Some(above), Some(below)) if below.t < above.t => Some((-below.t, below)),
            (Some(above), _) => Some((above.t, above)),
            (None, below) => below.map(|below| (-below.t, below)),
        }
    }
}
