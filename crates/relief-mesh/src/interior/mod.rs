//! Interiors, one file each. To add one, add a file here and its name to [`INTERIORS`].

mod adapt;
mod dice;
mod sweep;

use std::ops::Range;

use relief_core::registry::{Publication, UnknownName};

pub use adapt::{
    Distances, Facet, FillRequest, Filled, Gap, Ground, INTERIOR as ADAPT, STEPS, Turning, Window, along,
};
pub use dice::INTERIOR as DICE;
pub use sweep::INTERIOR as SWEEP;

use crate::patch::{Patch, PatchPoint};
use crate::{EdgeRule, MesherError, Spacing};

/// Rule that fills a patch between the points of its sides. It uses all points of the sides, and
/// adds none on them.
///
/// A patch is cut in steps, so that a large one need not be in memory at once.
#[derive(Clone, Copy, Debug)]
pub struct Interior {
    /// Name on the command line.
    pub name: &'static str,
    /// Summary in one line.
    pub summary: &'static str,
    /// Publication that describes it.
    pub publication: Publication,
    /// Spacings of sides that it accepts.
    pub takes: &'static [Spacing],
    /// Reason why it does not accept other spacings.
    pub why: &'static str,
    /// Method that fills patches.
    pub(crate) fills: Fills,
}

/// Method that fills patches.
#[derive(Clone, Copy, Debug)]
pub enum Fills {
    /// Fills any patch by a pattern.
    Patch(Pattern),
    /// Fills any patch by the surface over it.
    Ground(Fill),
}

/// Functions that fill patches whose borders have given points and heights. They return `None` if
/// there would be too many triangles, or if cancelled.
#[derive(Clone, Copy, Debug)]
pub struct Fill {
    /// Fills a tile of a plane.
    pub tile: FillOf<Window>,
    /// Fills a base triangle.
    pub facet: FillOf<Facet>,
}

/// Function that fills a patch over a ground.
pub type FillOf<G> = fn(&G, border: &[([i32; 2], f32)], FillRequest<'_>) -> Option<Filled>;

/// Pattern that depends on the points of the sides alone.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// Returns the number of steps in which a patch is cut.
    pub steps: fn(&Patch) -> u32,
    /// Returns the counts of a step.
    pub counts: fn(&Patch, step: u32) -> PatchCounts,
    /// Cuts the given steps. `first` is the number of their first inner point.
    pub cut: fn(&Patch, steps: Range<u32>, first: u32, &mut Cut),
}

/// Counts of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatchCounts {
    /// Points inside the patch; on a tile also the points of its border.
    pub points: u64,
    /// Number of triangles.
    pub triangles: u64,
}

/// Points and triangles of some steps.
#[derive(Clone, Debug, Default)]
pub struct Cut {
    /// Corners of the triangles. Inner points of earlier steps may be among them. Inner points of
    /// these steps occur once each, in the order of their numbers.
    pub points: Vec<PatchPoint>,
    /// Corners of the triangles as indices into `points`. They turn like the patch.
    pub triangles: Vec<[u32; 3]>,
}

impl Cut {
    /// Clears it for reuse.
    pub fn clear(&mut self) {
        self.points.clear();
        self.triangles.clear();
    }

    /// Adds a point and returns its index.
    pub fn point(&mut self, point: PatchPoint) -> u32 {
        // Steps are split long before this number overflows.
        self.points.push(point);
        self.points.len() as u32 - 1
    }
}

/// All interiors. Those that accept more edge rules come first.
pub static INTERIORS: &[Interior] = &[DICE, SWEEP, ADAPT];

/// Returns the interior of that name: the rule that fills a patch with triangles between the points of
/// its sides.
///
/// # Errors
///
/// Fails if no interior has that name. The error names the nearest.
pub fn interior(name: &str) -> Result<&'static Interior, UnknownName> {
    INTERIORS
        .iter()
        .find(|interior| interior.name == name)
        .ok_or_else(|| UnknownName::new("interior", name, INTERIORS.iter().map(|interior| interior.name)))
}

/// Checks that an edge rule and an interior go together.
///
/// # Errors
///
/// Fails with the reason if they do not.
pub fn check_pair(edges: &EdgeRule, interior: &Interior) -> Result<(), MesherError> {
    if interior.takes.contains(&edges.spacing) {
        return Ok(());
    }
    Err(MesherError::Pair { edges: edges.name, interior: interior.name, why: interior.why })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EDGE_RULES;

    #[test]
    fn pairs_that_make_no_sense_are_refused_with_the_reason() {
        for interior in INTERIORS {
            for edges in EDGE_RULES {
                let checked = check_pair(edges, interior);
                assert_eq!(checked.is_ok(), interior.takes.contains(&edges.spacing));
                if let Err(error) = checked {
                    assert!(error.to_string().ends_with(interior.why) && !interior.why.is_empty());
                }
            }
            assert!(EDGE_RULES.iter().any(|edges| check_pair(edges, interior).is_ok()));
        }
    }
}
