//! Ground: the surface that triangles approximate, and its distances from them, by places on a
//! lattice.

use super::delaunay::Delaunay;
use crate::Judge;

/// Distance of the surface from a triangle along the direction of displacement, in heights of the
/// map. Positive where the surface is above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap<P = [f64; 2]> {
    pub height: f64,
    /// Place of the distance: in steps of the lattice, or as a position along a line.
    pub place: P,
}

/// Greatest and least distance of the surface from a triangle or line, with their signs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaps<P = [f64; 2]> {
    pub above: Gap<P>,
    pub below: Gap<P>,
}

impl<P: Copy + Default> Gaps<P> {
    /// Returns the value that holds no distance.
    pub fn none() -> Self {
        let [above, below] = [f64::NEG_INFINITY, f64::INFINITY];
        let [above, below] = [above, below].map(|height| Gap { height, place: P::default() });
        Self { above, below }
    }

    /// Adds a distance, in heights of the map, at `place`.
    pub fn take(&mut self, height: f64, place: impl Fn() -> P) {
        if height > self.above.height {
            self.above = Gap { height, place: place() };
        }
        if height < self.below.height {
            self.below = Gap { height, place: place() };
        }
    }

    /// Returns the greatest and the least distance, in this order, widened by the triangle's bend.
    ///
    /// `bend` is the bound that `Ground::bend` returns, at least 0, in heights of the map. It is
    /// added to the greatest distance and subtracted from the least.
    pub fn bent(self, bend: f64) -> [Gap<P>; 2] {
        let Self { above, below } = self;
        [Gap { height: above.height + bend, ..above }, Gap { height: below.height - bend, ..below }]
    }

    /// Returns the distance of greater absolute value, with its sign. `None` if there is none.
    pub fn worst(&self) -> Option<Gap<P>> {
        let gap = if self.above.height >= -self.below.height { self.above } else { self.below };
        gap.height.is_finite().then_some(gap)
    }
}

/// Returns the vertex of the distance `gap + b s + a s²` over a segment that ends at `next`, if it
/// lies between the ends: the distance there, and `s`, from 0 to 1.
pub fn vertex_between(gap: f64, next: f64, a: f64) -> Option<(f64, f64)> {
    let b = next - gap - a;
    (b * a < 0.0 && b.abs() < 2.0 * a.abs()).then(|| {
        let s = -0.5 * b / a;
        (gap + 0.5 * b * s, s)
    })
}

/// Corner of a triangle: lattice point and height.
pub type Corner = ([i32; 2], f64);

/// Surface that a patch approximates. Places are counted in steps of its lattice.
pub trait Ground {
    /// Returns the triangles of the patch's corners, which are the first points.
    fn first_triangles(&self) -> Delaunay;

    /// Returns whether a point lies within the patch and not on its border.
    fn is_inside(&self, point: [i32; 2]) -> bool;

    /// Returns the distance between insertable points, in steps.
    fn step(&self, judge: Judge) -> i32;

    /// Returns the height of the surface at a point, in heights of the map.
    fn height(&self, point: [i32; 2]) -> f64;

    /// Returns an upper bound on the numbers of the centres of texels.
    fn centres(&self) -> usize;

    /// Calls `each` with number, distance and place of each centre of a texel within a triangle or
    /// on its edges.
    fn each_centre(&self, corners: [Corner; 3], each: impl FnMut(usize, f64, &dyn Fn() -> [f64; 2]));

    /// Returns the farthest distance at the centres of texels within a triangle and on its edges.
    fn worst_within(&self, corners: [Corner; 3]) -> Option<Gap>;

    /// Returns the greatest and the least distance at these centres.
    fn within(&self, corners: [Corner; 3]) -> Gaps;

    /// Returns the greatest and the least distance along an edge, ends included.
    fn along(&self, ends: [Corner; 2]) -> Gaps;

    /// Returns points around holes. They are inserted before any other.
    fn outline(&self) -> Vec<[i32; 2]>;

    /// Returns whether there are holes.
    fn has_holes(&self) -> bool;

    /// Returns whether a triangle is left out because its middle lies over a hole.
    fn is_left_out(&self, corners: [Corner; 3]) -> bool;

    /// Returns a bound on how much farther the surface may be than the distances say, in heights of
    /// the map. The reason is that the direction of displacement turns over the triangle.
    fn bend(&self, _corners: [Corner; 3]) -> f64 {
        0.0
    }

    /// Returns the place at which a new point makes a triangle bend less.
    fn bend_place(&self, corners: [Corner; 3]) -> [f64; 2] {
        middle(corners.map(|(at, _)| at.map(f64::from)))
    }
}

/// Returns the middle of three places.
pub fn middle([a, b, c]: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0)
}
