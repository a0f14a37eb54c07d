//! From a base point to the detailed mesh.

use relief_core::mesh::BasePoint;
use relief_core::raycast::{Ray, RayCaster, Sides, SurfaceHit};

use super::Layer;

/// What lies on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Seen {
    /// The detailed mesh, so many metres of displacement away.
    At(f64),
    /// Only faces that look the other way.
    Behind,
    /// Nothing.
    Nothing,
}

/// How lines are looked along.
pub(super) struct Line<'a> {
    pub high: &'a RayCaster,
    /// The farthest that counts, in metres.
    pub cage_m: f64,
    pub layer: Layer,
    pub two_sided: bool,
    /// Heights up to it are 0, in metres.
    pub rounding: f64,
}

impl Line<'_> {
    /// Looks outward and inward from a base point along its normal.
    pub fn look(&self, base: &BasePoint) -> Seen {
        let length = base.normal.length();
        match self.find(base) {
            Some((height, _)) if height.abs() * length <= self.rounding => Seen::At(0.0),
            Some((height, _)) => Seen::At(height),
            None => {
                let both = Line { two_sided: true, ..*self };
                if both.find(base).is_some() { Seen::Behind } else { Seen::Nothing }
            }
        }
    }

    /// The displacement that takes a base point to the detailed mesh, in metres, and what is hit there.
    pub fn find(&self, base: &BasePoint) -> Option<(f64, SurfaceHit)> {
        let length = base.normal.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        // A displacement of so much is as far as the cage.
        let farthest = self.cage_m / length;
        let [outward, inward] =
            [base.normal, -base.normal].map(|direction| Ray { origin: base.position, direction });
        let within = |hit: &SurfaceHit| hit.t <= farthest;
        // Who goes outward meets a face that looks outward from its back.
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
