//! The shaders' functions that tessellate bases, for hosts that run them.

use super::generated::{
    BaseSite, BaseVertex, Corner, DicePlace, DicePoint, DiceRows, DiceTriangle, Resources, Sweep,
    SweptColumn, Tessellation, Voxel, Zip,
};
use super::{Bound, Vec2, Vec3};

/// Cuts the triangles of a base and displaces them, with the functions of
/// [`Root::Tessellate`](crate::wgsl::Root::Tessellate) that a GPU runs for each edge, triangle and
/// point.
#[derive(Clone, Copy, Debug)]
pub struct Tessellator<'a> {
    resources: Resources<'a>,
    grid: Tessellation,
}

impl<'a> Tessellator<'a> {
    /// Creates the functions over a surface's settings and height map, for a view.
    pub fn new(bound: &Bound<'a>, grid: Tessellation) -> Self {
        Self { resources: Resources::of(bound), grid }
    }

    /// Returns the voxel of a position in grid space.
    pub fn voxel_of(&self, position: Vec3<f32>) -> Voxel {
        self.resources.voxel_of(self.grid, position)
    }

    /// Returns the number of parts of an edge between two voxels, in a grid that is coarser by
    /// `level` doublings. `along` is the edge's change of `u` and `v`.
    pub fn parts_between(&self, [a, b]: [Voxel; 2], along: Vec2<f32>, level: u32) -> u32 {
        self.resources.parts_between(self.grid, a, b, along, level)
    }

    /// Returns the sweep of a triangle with corners in those voxels, in the same grid; `None` if it
    /// is not swept.
    pub fn sweep(&self, [a, b, c]: [Voxel; 3], level: u32) -> Option<Sweep> {
        let is_swept = self.resources.is_swept(self.grid, a, b, c, level);
        is_swept.then(|| self.resources.sweep_on(a, b, c, level))
    }

    /// Returns the number of points inside a swept triangle.
    pub fn swept_points(&self, sweep: Sweep) -> u32 {
        self.resources.swept_points_of(sweep)
    }

    /// Returns a column of a swept triangle. `first` is the number of its first point inside.
    pub fn swept_column(&self, sweep: Sweep, column: i32, first: u32) -> SweptColumn {
        self.resources.swept_column(sweep, column, first)
    }

    /// Returns the weights of the corners at the points inside a column, from below.
    pub fn swept_weights(&self, sweep: Sweep, column: SweptColumn) -> impl Iterator<Item = Vec3<f32>> {
        let inside = column.inside..column.inside + column.inner;
        inside.map(move |y| self.resources.swept_weights(sweep, column.column, y))
    }

    /// Returns the triangles between two neighbouring columns, with the winding of the whole one.
    /// Each corner is the side that it lies on and the number of parts before it there, or 3 and
    /// the number of a point inside.
    pub fn swept_triangles(&self, sweep: Sweep, columns: [SweptColumn; 2]) -> Vec<[[u32; 2]; 3]> {
        let mut pieces = Vec::new();
        for which in 0..3 {
            let mut zip = self.resources.zip_of(sweep, columns[0], columns[1], which);
            while self.resources.zip_rest(zip) > 0 {
                let goes_left = self.resources.zip_goes_left(zip);
                pieces.push(piece(sweep, zip, goes_left));
                zip = self.resources.zip_next(sweep, zip, goes_left);
            }
        }
        pieces
    }

    /// Whether a triangle is culled that is displaced by between `low_m` and `high_m` metres.
    pub fn is_left_out(&self, [a, b, c]: [BaseVertex; 3], [low_m, high_m]: [f32; 2]) -> bool {
        self.resources.is_left_out(self.grid, a, b, c, low_m, high_m)
    }

    /// Returns the pattern of a triangle whose sides have `parts` parts, from 1 to 32,767 each.
    pub fn rows(&self, parts: [u32; 3]) -> DiceRows {
        self.resources.dice_rows(parts)
    }

    /// Returns the number of points inside the pattern.
    pub fn points(&self, rows: DiceRows) -> u32 {
        self.resources.dice_points(rows)
    }

    /// Returns the number of the pattern's triangles.
    pub fn triangles(&self, rows: DiceRows) -> u32 {
        self.resources.dice_triangles(rows)
    }

    /// Returns the place of a point inside, by its number.
    pub fn place(&self, rows: DiceRows, number: u32) -> DicePlace {
        self.resources.dice_place(rows, number)
    }

    /// Returns the point at a place.
    pub fn point(&self, rows: DiceRows, place: DicePlace) -> DicePoint {
        self.resources.dice_point(rows, place)
    }

    /// Returns a triangle by its number.
    pub fn triangle(&self, rows: DiceRows, number: u32) -> DiceTriangle {
        self.resources.dice_triangle(rows, number)
    }

    /// Returns a vertex of the base with the displacement of `seen`, another one at its position.
    /// `voxel` is the voxel of `seen`.
    pub fn site_of_vertex(&self, vertex: BaseVertex, seen: BaseVertex, voxel: Voxel) -> BaseSite {
        self.resources.site_of_vertex(vertex, seen, voxel)
    }

    /// Returns the point of an edge with `at` of its `parts` parts before it.
    pub fn site_between(&self, [a, b]: [BaseSite; 2], shares: Vec2<f32>, [at, parts]: [u32; 2]) -> BaseSite {
        self.resources.site_between(a, b, shares, at, parts)
    }

    /// Returns the point inside a triangle with those weights in the picture.
    pub fn site_inside(&self, [a, b, c]: [BaseSite; 3], shares: Vec3<f32>, weights: Vec3<f32>) -> BaseSite {
        self.resources.site_inside(a, b, c, shares, weights)
    }

    /// Returns the displaced corner at a point of the base.
    pub fn displaced(&self, site: BaseSite) -> Corner {
        self.resources.displaced_site(self.grid, site)
    }
}

/// The triangle up to the next point of a zip.
fn piece(sweep: Sweep, zip: Zip, goes_left: bool) -> [[u32; 2]; 3] {
    let next = if goes_left { zip.next_left } else { zip.next_right };
    let [a, b, c] = [zip.at_left, zip.at_right, next].map(|point| [point.side, point.at]);
    if sweep.is_turned == 1 { [b, a, c] } else { [a, b, c] }
}
