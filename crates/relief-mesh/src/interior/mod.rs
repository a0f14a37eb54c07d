//! The interiors, one file each. A new one is a file here and its name in the list below.

mod adapt;
mod dice;
mod sweep;

use std::ops::Range;

use relief_core::registry::{Publication, UnknownName};

pub use adapt::{Facet, Filled, Gap, Ground, INTERIOR as ADAPT, STEPS, Seen, Turning, Wanted, Window, along};
pub use dice::INTERIOR as DICE;
pub use sweep::INTERIOR as SWEEP;

use crate::patch::{Patch, PatchPoint};
use crate::{EdgeRule, MesherError, Spacing};

/// What fills a patch between the points of its sides. All points of the sides are used, and no others lie on
/// them.
///
/// A patch is cut in steps, one after the other, so that a large one need not be held at once.
#[derive(Clone, Copy, Debug)]
pub struct Interior {
    /// The name on the command line.
    pub name: &'static str,
    /// One line on what it does.
    pub summary: &'static str,
    /// Where it was published.
    pub publication: Publication,
    /// The spacings of sides that it fills.
    pub takes: &'static [Spacing],
    /// Why it does not take the others.
    pub why: &'static str,
    /// How it fills them.
    pub(crate) fills: Fills,
}

/// What an interior fills, and how.
#[derive(Clone, Copy, Debug)]
pub enum Fills {
    /// Any patch, by a pattern.
    Patch(Pattern),
    /// Any patch, by what is on it.
    Ground(Fill),
}

/// Fills patches whose borders have those points, with heights. None where there would be too many triangles,
/// or it is cancelled.
#[derive(Clone, Copy, Debug)]
pub struct Fill {
    /// A tile of a plane.
    pub tile: FillOf<Window>,
    /// A base triangle.
    pub facet: FillOf<Facet>,
}

/// Fills a patch over some ground.
pub type FillOf<G> = fn(&G, border: &[([i32; 2], f32)], Wanted<'_>) -> Option<Filled>;

/// A pattern that follows from the points of the sides alone.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// In how many steps a patch is cut.
    pub steps: fn(&Patch) -> u32,
    /// What a step makes.
    pub counts: fn(&Patch, step: u32) -> PatchCounts,
    /// Makes what these steps do; `first` is the number of their first inner point.
    pub cut: fn(&Patch, steps: Range<u32>, first: u32, &mut Cut),
}

/// How much is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatchCounts {
    /// Points inside of the patch; on a tile those of the border, too.
    pub points: u64,
    /// Triangles.
    pub triangles: u64,
}

/// What some steps make of a patch.
#[derive(Clone, Debug, Default)]
pub struct Cut {
    /// Points that triangles have for corners. Inner ones of earlier steps are among them; those of the steps
    /// themselves are there once each, in the order of their numbers.
    pub points: Vec<PatchPoint>,
    /// Corners by their places in the points, in the sense of rotation of the patch's own.
    pub triangles: Vec<[u32; 3]>,
}

impl Cut {
    /// Empties it, to be filled again.
    pub fn clear(&mut self) {
        self.points.clear();
        self.triangles.clear();
    }

    /// Adds a point and gives its place.
    pub fn point(&mut self, point: PatchPoint) -> u32 {
        // Steps are cut apart long before that many points.
        self.points.push(point);
        self.points.len() as u32 - 1
    }
}

/// All interiors; those that take more edge rules come first.
pub static INTERIORS: &[Interior] = &[DICE, SWEEP, ADAPT];

/// The interior of that name.
///
/// # Errors
///
/// When none has that name; the error names the nearest.
pub fn interior(name: &str) -> Result<&'static Interior, UnknownName> {
    INTERIORS
        .iter()
        .find(|interior| interior.name == name)
        .ok_or_else(|| UnknownName::new("interior", name, INTERIORS.iter().map(|interior| interior.name)))
}

/// Whether an edge rule and an interior make a mesh together.
///
/// # Errors
///
/// When they do not, with the reason.
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
