//! Arrangements of views for capturing a mesh.

use glam::DVec3;
use relief_core::object::GridMapping;

use crate::ViewSpec;

/// Most frames along a side of an octahedral grid. Its square is the most views of an object.
pub const MAX_GRID: u32 = 32;

/// Directions from which a mesh is captured.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Arrangement {
    /// Along the three axes, from both sides: `+x`, `-x`, `+y`, `-y`, `+z`, `-z`.
    #[default]
    Cube,
    /// From all around, by the octahedral mapping of a grid with this many frames per side, at
    /// least 2.
    ///
    /// The frame in column `i` and row `j` looks from `(x, 1 - |x| - |z|, z)`. Here `x` and `z` are
    /// `i` and `j` divided by the last number, from -1 to 1. The lower half is folded over the
    /// diagonals. Frames at the grid's border that look from the same direction appear twice, as in
    /// other programs.
    Octahedral(u32),
    /// From above and from the horizon, by the hemi-octahedral mapping of a grid with this many
    /// frames per side. With `a` and `b` from 0 to 1, `x = a - b` and `z = a + b - 1`, and `y` as
    /// in [`Octahedral`](Self::Octahedral).
    HemiOctahedral(u32),
    /// From this many directions around `y`, at least 1. The first is `+z`, and they proceed toward
    /// `+x`.
    Horizontal(u32),
    /// From these views, all of one kind.
    Given(Vec<ViewSpec>),
}

impl Arrangement {
    /// Frames per side, if they form a grid.
    pub fn grid(&self) -> Option<u32> {
        match self {
            Arrangement::Octahedral(side) | Arrangement::HemiOctahedral(side) => Some(*side),
            _ => None,
        }
    }

    /// Number of views.
    pub fn count(&self) -> usize {
        match self {
            Arrangement::Cube => 6,
            Arrangement::Octahedral(side) | Arrangement::HemiOctahedral(side) => {
                (*side as usize).saturating_mul(*side as usize)
            }
            Arrangement::Horizontal(count) => *count as usize,
            Arrangement::Given(specs) => specs.len(),
        }
    }

    /// All views: the given ones, or views with parallel rays.
    pub fn specs(&self) -> Vec<ViewSpec> {
        let orthographic = |from: DVec3| ViewSpec::Orthographic { from, up: None };
        match self {
            Arrangement::Cube => [DVec3::X, DVec3::Y, DVec3::Z]
                .into_iter()
                .flat_map(|axis| [orthographic(axis), orthographic(-axis)])
                .collect(),
            Arrangement::Octahedral(side) => {
                grid(*side).map(|at| orthographic(GridMapping::Octahedral.direction(at))).collect()
            }
            Arrangement::HemiOctahedral(side) => {
                grid(*side).map(|at| orthographic(GridMapping::HemiOctahedral.direction(at))).collect()
            }
            Arrangement::Horizontal(count) => (0..*count)
                .map(|number| {
                    let turn = std::f64::consts::TAU * f64::from(number) / f64::from(*count);
                    orthographic(DVec3::new(turn.sin(), 0.0, turn.cos()))
                })
                .collect(),
            Arrangement::Given(specs) => specs.clone(),
        }
    }
}

/// Positions of a grid from 0 to 1, row by row.
fn grid(side: u32) -> impl Iterator<Item = [f64; 2]> {
    let part = move |at: u32| f64::from(at) / f64::from(side.saturating_sub(1).max(1));
    (0..side).flat_map(move |row| (0..side).map(move |column| [part(column), part(row)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn directions(arrangement: &Arrangement) -> Vec<DVec3> {
        let specs = arrangement.specs();
        assert_eq!(specs.len(), arrangement.count());
        let from = |spec: &ViewSpec| match spec {
            ViewSpec::Orthographic { from, .. } => *from,
            ViewSpec::Perspective { .. } => panic!("by parallel rays"),
        };
        specs.iter().map(from).collect()
    }

    #[test]
    fn octahedral_grids_look_from_where_other_programs_have_them() {
        let from = directions(&Arrangement::Octahedral(3));
        let expected = [
            [0.0, -1.0, 0.0],
            [0.0, 0.0, -1.0],
            [0.0, -1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, -1.0, 0.0],
        ];
        for (from, expected) in from.iter().zip(expected) {
            assert!((*from - DVec3::from(expected)).length() < 1e-12, "{from} {expected:?}");
        }
        let hemi = directions(&Arrangement::HemiOctahedral(3));
        assert!(hemi.iter().all(|from| from.y >= 0.0 && (from.length() - 1.0).abs() < 1e-12));
        assert_eq!(hemi[0], DVec3::NEG_Z);
        assert_eq!(hemi[2], DVec3::X);
        assert_eq!(hemi[4], DVec3::Y);
        assert_eq!(hemi[8], DVec3::Z);
    }

    #[test]
    fn directions_are_spread_all_around() {
        for (arrangement, level) in [
            (Arrangement::Cube, false),
            (Arrangement::Octahedral(8), false),
            (Arrangement::Horizontal(5), true),
        ] {
            let from = directions(&arrangement);
            let sum: DVec3 = from.iter().sum();
            assert!((sum / from.len() as f64).length() < 0.2, "{arrangement:?}: {sum}");
            assert!(!level || from.iter().all(|from| from.y == 0.0));
        }
    }
}
