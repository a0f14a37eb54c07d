//! Edge rules, one file each. To add one, add a file here and its name to [`EDGE_RULES`].

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

/// Spacing of the points of a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// At equal distances.
    Even,
    /// Where the tolerance needs them.
    Uneven,
    /// One in every voxel along the side's main direction, in the grid space of a view.
    Voxels,
}

/// Rule that divides the sides of patches. Its result for a side depends on the side's two ends
/// alone.
#[derive(Clone, Copy, Debug)]
pub struct EdgeRule {
    /// The name on the command line.
    pub name: &'static str,
    /// Summary in one line.
    pub summary: &'static str,
    /// Publication that describes it.
    pub publication: Publication,
    /// Spacing of its points.
    pub spacing: Spacing,
    /// Method that divides the sides.
    pub(crate) divides: Divides,
}

/// Method that divides sides.
#[derive(Clone, Copy, Debug)]
pub enum Divides {
    /// At equal distances.
    Evenly(Evenly),
    /// By the voxels of the ends: returns the number of parts.
    Voxels(fn([[i32; 3]; 2]) -> u64),
    /// By the heights along the side.
    Along(Along),
}

/// Returns which knots of a side are its points, rising, first and last included.
///
/// There is a row of knots for each edge of a height map on which the side lies: one on a plane,
/// two at a seam. All rows have the same places. The tolerance is a height of the map.
pub type Along = fn(rows: &[&[Knot]], tolerance: f64) -> Vec<usize>;

/// Divides a side by `divide`, with the knots `fixed` as points in any case. They rise and exclude
/// the ends. Each stretch between two of them is divided by itself.
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

/// Rule that divides sides evenly.
#[derive(Clone, Copy, Debug)]
pub struct Evenly {
    /// Returns the number of parts, at least 1, of a base triangle's side that has `texels` from
    /// end to end along `u` and `v`.
    pub parts: fn(texels: [f64; 2], &MeshSettings) -> u64,
    /// Returns the least distance between lines of a plane, in texels. It bounds their number from
    /// above.
    pub step: fn(&MeshSettings) -> f64,
    /// Returns the lines across an axis of a plane, rising, with both ends. Places are counted in
    /// texels: `i + ½` is the centre of texel `i`.
    pub lines: fn(from: f64, to: f64, &MeshSettings) -> Vec<f64>,
}

/// Possible point of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// Position along the side, in texels.
    pub place: f64,
    /// Height of the map there.
    pub height: f64,
    /// Twist of the bilinear surface between this knot and the next: the greatest
    /// `|h00 - h10 - h01 + h11|` on either side of the line.
    pub twist: f64,
}

/// All edge rules.
pub static EDGE_RULES: &[EdgeRule] = &[TEXELS, PIXELS, ERROR];

/// Returns the edge rule `name`.
///
/// # Errors
///
/// Fails if no edge rule has that name. The error names the nearest.
pub fn edge_rule(name: &str) -> Result<&'static EdgeRule, UnknownName> {
    EDGE_RULES
        .iter()
        .find(|rule| rule.name == name)
        .ok_or_else(|| UnknownName::new("edge rule", name, EDGE_RULES.iter().map(|rule| rule.name)))
}
