//! The edge rules, one file each. A new one is a file here and its name in the list below.

mod error;
mod pixels;
mod texels;
mod weights;

pub use error::{LONGEST, RULE as ERROR};
pub use pixels::RULE as PIXELS;
use relief_core::registry::{Publication, UnknownName};
pub use texels::RULE as TEXELS;
pub use weights::Weights;

use crate::MeshSettings;

/// How the points of a side lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// At equal distances.
    Even,
    /// Where they are needed.
    Uneven,
    /// One in every voxel along the side's main direction, in the grid space of a view.
    Voxels,
}

/// Where the sides of patches are divided. What it says of a side follows from the side's two ends alone.
#[derive(Clone, Copy, Debug)]
pub struct EdgeRule {
    /// The name on the command line.
    pub name: &'static str,
    /// One line on what it does.
    pub summary: &'static str,
    /// Where it was published.
    pub publication: Publication,
    /// How its points lie.
    pub spacing: Spacing,
    /// How it divides them.
    pub(crate) divides: Divides,
}

/// How sides are divided.
#[derive(Clone, Copy, Debug)]
pub enum Divides {
    /// At equal distances.
    Evenly(Evenly),
    /// By the voxels that their ends lie in: in how many parts.
    Voxels(fn([[i32; 3]; 2]) -> u64),
    /// By what lies along the side.
    Along(Along),
}

/// Which knots of a side are its points, the first and the last among them, rising. There is a row of knots
/// for every height map's edge that the side is, at the same places: one on a plane, two at a seam. The
/// tolerance is a height of the map.
pub type Along = fn(rows: &[&[Knot]], tolerance: f64) -> Vec<usize>;

/// The same where some of the knots, rising and without the ends, are points in any case: what lies between
/// two of them is divided by itself.
pub fn divided(divide: Along, rows: &[&[Knot]], fixed: &[usize], tolerance: f64) -> Vec<usize> {
    let last = rows.first().map_or(0, |row| row.len() - 1);
    let mut chosen = vec![0];
    let mut from = 0;
    for to in fixed.iter().copied().chain([last]) {
        let between: Vec<&[Knot]> = rows.iter().map(|row| &row[from..=to]).collect();
        chosen.extend(divide(&between, tolerance).into_iter().skip(1).map(|at| from + at));
        from = to;
    }
    chosen
}

/// Where sides are divided evenly.
#[derive(Clone, Copy, Debug)]
pub struct Evenly {
    /// In how many parts, at least 1, a side of a base triangle is divided that has so many texels from end
    /// to end along `u` and along `v`.
    pub parts: fn(texels: [f64; 2], &MeshSettings) -> u64,
    /// The least distance of the lines of a plane, in texels: an upper bound of their number follows from it.
    pub step: fn(&MeshSettings) -> f64,
    /// The lines across an axis of a plane that goes from one place to another, counted in texels so that
    /// `i + ½` is the centre of texel `i`: rising, with both ends.
    pub lines: fn(from: f64, to: f64, &MeshSettings) -> Vec<f64>,
}

/// A point that a side may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// Where it is, in texels along the side.
    pub place: f64,
    /// The height of the map there.
    pub height: f64,
    /// By how much the bilinear surface is twisted between it and the next one, on either side of the line:
    /// the greatest `|h00 - h10 - h01 + h11|`.
    pub twist: f64,
}

/// All edge rules.
pub static EDGE_RULES: &[EdgeRule] = &[TEXELS, PIXELS, ERROR];

/// The edge rule of that name.
///
/// # Errors
///
/// When none has that name; the error names the nearest.
pub fn edge_rule(name: &str) -> Result<&'static EdgeRule, UnknownName> {
    EDGE_RULES
        .iter()
        .find(|rule| rule.name == name)
        .ok_or_else(|| UnknownName::new("edge rule", name, EDGE_RULES.iter().map(|rule| rule.name)))
}
