//! Grids of frames that look from all around, ordered by an octahedral mapping.

use glam::{DMat3, DVec3};

use super::View;

/// Mapping from a square of frames to their directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GridMapping {
    /// All directions: positions from -1 to 1 are `x` and `z` of `(x, 1 - |x| - |z|, z)`, and the
    /// lower half is folded over the diagonals (Engelhardt and Dachsbacher 2008).
    Octahedral,
    /// Directions from above and from the horizon: with positions `a` and `b` from 0 to 1,
    /// `x = a - b` and `z = a + b - 1`, and `y` as in [`Octahedral`](Self::Octahedral).
    HemiOctahedral,
}

impl GridMapping {
    /// Both mappings.
    pub const ALL: [GridMapping; 2] = [GridMapping::Octahedral, GridMapping::HemiOctahedral];

    /// Unit direction for a position on the unit square.
    pub fn direction(self, [a, b]: [f64; 2]) -> DVec3 {
        let [x, z] = match self {
            GridMapping::Octahedral => [2.0 * a - 1.0, 2.0 * b - 1.0],
            GridMapping::HemiOctahedral => [a - b, a + b - 1.0],
        };
        let y = 1.0 - x.abs() - z.abs();
        let below = (-y).max(0.0);
        let fold = |at: f64| if at >= 0.0 { at - below } else { at + below };
        let from = DVec3::new(fold(x), y, fold(z)).normalize();
        // Rounding leaves level or upright directions slightly tilted.
        DVec3::from(from.to_array().map(|part| if part.abs() < 1e-15 { 0.0 } else { part }))
    }

    /// Position on the unit square for a direction of any length. If only the upper half is mapped,
    /// directions from below have the position of the horizon above them.
    pub fn place(self, direction: DVec3) -> [f64; 2] {
        let is_hemi = self == GridMapping::HemiOctahedral;
        let y = if is_hemi { direction.y.max(0.0) } else { direction.y };
        let sum = direction.x.abs() + y.abs() + direction.z.abs();
        let [x, z] = [direction.x, direction.z].map(|part| if sum > 0.0 { part / sum } else { 0.0 });
        if is_hemi {
            return [0.5 * (x + z + 1.0), 0.5 * (z - x + 1.0)].map(|at| at.clamp(0.0, 1.0));
        }
        let outer = |beside: f64, at: f64| if at >= 0.0 { 1.0 - beside.abs() } else { beside.abs() - 1.0 };
        let [x, z] = if y < 0.0 { [outer(z, x), outer(x, z)] } else { [x, z] };
        [0.5 * (x + 1.0), 0.5 * (z + 1.0)].map(|at| at.clamp(0.0, 1.0))
    }
}

/// A square of frames, row by row, that look from the directions of a mapping, in any rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameGrid {
    /// Frames per side, at least 2.
    pub side: u32,
    /// Mapping to the frames' directions.
    pub mapping: GridMapping,
    /// Axes of the mapping in the world: unit vectors.
    pub axes: [DVec3; 3],
}

/// Greatest length of the difference between a frame's direction and the grid's.
const SAME_DIRECTION: f64 = 1e-5;

impl FrameGrid {
    /// Returns the grid that views with parallel rays form. `None` if they form none.
    pub fn of(views: &[View]) -> Option<Self> {
        let side = views.len().isqrt();
        if side < 2 || side * side != views.len() || views.iter().any(|view| view.eye().is_some()) {
            return None;
        }
        GridMapping::ALL.into_iter().find_map(|mapping| {
            let places = (0..side).flat_map(|row| (0..side).map(move |column| [column, row]));
            let last = (side - 1) as f64;
            let directions = places.map(|place| mapping.direction(place.map(|at| at as f64 / last)));
            let directions: Vec<DVec3> = directions.collect();
            // The first view defines the rotation of all.
            let unturned = View::orthographic(DVec3::ZERO, 1.0, directions[0], None, [1, 1]).ok()?;
            let [turned, plain] = [&views[0], &unturned].map(|view| {
                let [right, down, toward] = view.axes();
                DMat3::from_cols(right, down, toward)
            });
            let turn = turned * plain.transpose();
            let is_of = |(view, direction): (&View, &DVec3)| {
                (view.axes()[2] - turn * *direction).length() <= SAME_DIRECTION
            };
            let fits = views.iter().zip(&directions).all(is_of);
            let axes = [turn.x_axis, turn.y_axis, turn.z_axis];
            fits.then_some(Self { side: side as u32, mapping, axes })
        })
    }

    /// Returns the three frames around a direction toward a viewer, as numbers and weights. Each
    /// square of four frames is cut along its diagonal from the first to the last. The frames are
    /// the corners of the triangle that contains the direction, and the weights are its barycentric
    /// coordinates there.
    pub fn frames(&self, toward: DVec3) -> [(usize, f64); 3] {
        let own = DVec3::from(self.axes.map(|axis| axis.dot(toward)));
        let last = f64::from(self.side - 1);
        let place = self.mapping.place(own).map(|at| (at * last).clamp(0.0, last));
        let cell = place.map(|at| at.floor().min(last - 1.0));
        let [x, y] = [place[0] - cell[0], place[1] - cell[1]];
        let first = cell[1] as usize * self.side as usize + cell[0] as usize;
        let (right, below) = (first + 1, first + self.side as usize);
        let beside = if x > y { right } else { below };
        [(first, 1.0 - x.max(y)), (beside, (x - y).abs()), (below + 1, x.min(y))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn views(side: u32, mapping: GridMapping, turn: DMat3) -> Vec<View> {
        let part = |at: u32| f64::from(at) / f64::from(side - 1);
        let places = (0..side).flat_map(|row| (0..side).map(move |column| [part(column), part(row)]));
        let view = |place: [f64; 2]| {
            let plain = View::orthographic(DVec3::ZERO, 1.0, mapping.direction(place), None, [8, 8]);
            let [_, down, toward] = plain.expect("a view").axes();
            View::orthographic(DVec3::ZERO, 1.0, turn * toward, Some(turn * -down), [8, 8]).expect("a view")
        };
        places.map(view).collect()
    }

    #[test]
    fn places_are_those_of_directions() {
        let mut rng = Rng::new(7);
        for _ in 0..10_000 {
            let direction = rng.direction();
            for mapping in GridMapping::ALL {
                let place = mapping.place(direction);
                assert!(place.iter().all(|at| (0.0..=1.0).contains(at)), "{direction} {place:?}");
                if mapping == GridMapping::Octahedral || direction.y > 0.0 {
                    assert!((mapping.direction(place) - direction).length() < 1e-9, "{direction} {place:?}");
                }
            }
        }
    }

    #[test]
    fn grids_are_known_however_they_are_turned() {
        let turn = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 2.1);
        for mapping in GridMapping::ALL {
            for side in [2, 3, 6, 7] {
                let mut views = views(side, mapping, turn);
                let grid = FrameGrid::of(&views).expect("a grid");
                assert_eq!((grid.side, grid.mapping), (side, mapping));
                let middle = (side * side / 2) as usize;
                for (number, view) in views.iter().enumerate() {
                    // Frames at the border may appear twice.
                    let all = grid.frames(view.axes()[2]);
                    let most = all.iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("three");
                    let same = (views[most.0].axes()[2] - view.axes()[2]).length();
                    assert!(most.1 > 0.999 && same < 1e-6, "{side} {number}: {all:?}");
                }
                // All four frames of the smallest grid look from below.
                let is_one = side == 2 && mapping == GridMapping::Octahedral;
                views.swap(0, middle);
                assert_eq!(FrameGrid::of(&views).is_none(), !is_one, "{side}");
            }
        }
        let all = views(3, GridMapping::Octahedral, turn);
        assert_eq!(FrameGrid::of(&all[..8]), None);
    }

    #[test]
    fn weights_are_those_of_the_direction_among_its_frames() {
        let views = views(9, GridMapping::Octahedral, DMat3::IDENTITY);
        let grid = FrameGrid::of(&views).expect("a grid");
        let mut rng = Rng::new(8);
        let mut before: Option<(DVec3, DVec3)> = None;
        for step in 0..20_000 {
            // The blend of the frames has no jumps over small steps.
            let toward = match before {
                Some((toward, _)) if step % 100 != 0 => (toward + rng.direction() * 1e-5).normalize(),
                _ => {
                    before = None;
                    rng.direction()
                }
            };
            let frames = grid.frames(toward);
            assert!((frames.iter().map(|(_, weight)| weight).sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(frames.iter().all(|(_, weight)| *weight >= 0.0));
            let mean: DVec3 = frames.iter().map(|(number, weight)| views[*number].axes()[2] * *weight).sum();
            assert!(mean.normalize().dot(toward) > 0.98, "{toward} {frames:?}");
            if let Some((_, mean_before)) = before {
                assert!((mean - mean_before).length() < 1e-3, "{toward} {frames:?}");
            }
            before = Some((toward, mean));
        }
    }
}
