//! What triangles are laid over: how far the surface is from them, by places on a lattice.

use super::delaunay::Delaunay;
use crate::Judge;

/// A distance of the surface from a triangle, along the direction of displacement: greater than 0 where the
/// surface is above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap<P = [f64; 2]> {
    pub height: f64,
    /// Where: in steps of the lattice, or how far along something.
    pub place: P,
}

/// The greatest and the least distance of the surface from something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaps<P = [f64; 2]> {
    pub above: Gap<P>,
    pub below: Gap<P>,
}

impl<P: Copy + Default> Gaps<P> {
    /// Of nothing.
    pub fn none() -> Self {
        let [above, below] = [f64::NEG_INFINITY, f64::INFINITY];
        let [above, below] = [above, below].map(|height| Gap { height, place: P::default() });
        Self { above, below }
    }

    /// Takes one more distance.
    pub fn take(&mut self, height: f64, place: impl Fn() -> P) {
        if height > self.above.height {
            self.above = Gap { height, place: place() };
        }
        if height < self.below.height {
            self.below = Gap { height, place: place() };
        }
    }

    /// Both, as they are of a triangle that is bent.
    pub fn bent(self, bend: f64) -> [Gap<P>; 2] {
        let Self { above, below } = self;
        [Gap { height: above.height + bend, ..above }, Gap { height: below.height - bend, ..below }]
    }

    /// The farther one, if there is any.
    pub fn worst(&self) -> Option<Gap<P>> {
        let gap = if self.above.height >= -self.below.height { self.above } else { self.below };
        gap.height.is_finite().then_some(gap)
    }
}

/// The vertex of the distance `gap + b s + a s²` over a segment that ends at `next`, if it lies between the
/// ends: the distance there, and `s`, from 0 to 1.
pub fn vertex_between(gap: f64, next: f64, a: f64) -> Option<(f64, f64)> {
    let b = next - gap - a;
    (b * a < 0.0 && b.abs() < 2.0 * a.abs()).then(|| {
        let s = -0.5 * b / a;
        (gap + 0.5 * b * s, s)
    })
}

/// A corner of a triangle: where, and how high.
pub type Corner = ([i32; 2], f64);

/// What a patch is triangulated over. Places are counted in steps of its lattice.
pub trait Ground {
    /// The triangles of its corners, which are the first points.
    fn first_triangles(&self) -> Delaunay;

    /// Whether a point lies within it, and not on its border.
    fn is_inside(&self, point: [i32; 2]) -> bool;

    /// How many steps apart points are that are inserted.
    fn step(&self, judge: Judge) -> i32;

    /// The height of the surface at a point.
    fn height(&self, point: [i32; 2]) -> f64;

    /// A bound of the numbers of the centres of texels.
    fn centres(&self) -> usize;

    /// The centres of texels within a triangle, and on its edges: number, distance, and place.
    fn each_centre(&self, corners: [Corner; 3], each: impl FnMut(usize, f64, &dyn Fn() -> [f64; 2]));

    /// The farthest distance at the centres of texels within a triangle, and on its edges.
    fn worst_within(&self, corners: [Corner; 3]) -> Option<Gap>;

    /// The greatest and the least distance there.
    fn within(&self, corners: [Corner; 3]) -> Gaps;

    /// Distances along an edge, its ends among them.
    fn along(&self, ends: [Corner; 2]) -> Gaps;

    /// Points around holes that are inserted before any other.
    fn outline(&self) -> Vec<[i32; 2]>;

    /// Whether there are holes.
    fn has_holes(&self) -> bool;

    /// Whether a triangle is left out, because its middle lies over a hole.
    fn is_left_out(&self, corners: [Corner; 3]) -> bool;

    /// How much farther the surface may be from a triangle than its distances say, because the direction of
    /// displacement turns over it.
    fn bend(&self, _corners: [Corner; 3]) -> f64 {
        0.0
    }

    /// Where a point makes a triangle bend less.
    fn bend_place(&self, corners: [Corner; 3]) -> [f64; 2] {
        middle(corners.map(|(at, _)| at.map(f64::from)))
    }
}

/// The middle of three places.
pub fn middle([a, b, c]: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0)
}
