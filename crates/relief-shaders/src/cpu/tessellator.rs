//! The shaders' functions that tessellate bases, for hosts that run them.

use super::generated::{
    BaseSite, BaseVertex, Corner, DicePlace, DicePoint, DiceRows, DiceTriangle, Resources, Tessellation,
    Voxel,
};
use super::{Bound, Vec2, Vec3};

/// Cuts the triangles of a base and displaces them: the functions of
/// [`Root::Tessellate`](crate::wgsl::Root::Tessellate) that a GPU runs for each edge, triangle and point.
#[derive(Clone, Copy, Debug)]
pub struct Tessellator<'a> {
    resources: Resources<'a>,
    grid: Tessellation,
}

impl<'a> Tessellator<'a> {
    /// Those over a surface's settings and height map, for a view.
    pub fn new(bound: &Bound<'a>, grid: Tessellation) -> Self {
        Self { resources: Resources::of(bound), grid }
    }

    /// A position in grid space.
    pub fn voxel_of(&self, position: Vec3<f32>) -> Voxel {
        self.resources.voxel_of(self.grid, position)
    }

    /// In how many parts an edge between two voxels is divided, where the grid is coarser by so many
    /// doublings.
    pub fn parts_between(&self, a: Voxel, b: Voxel, level: u32) -> u32 {
        self.resources.parts_between(a, b, level)
    }

    /// Whether nothing of a triangle is made that is displaced by between so many metres.
    pub fn is_left_out(&self, [a, b, c]: [BaseVertex; 3], [low_m, high_m]: [f32; 2]) -> bool {
        self.resources.is_left_out(self.grid, a, b, c, low_m, high_m)
    }

    /// The pattern of a triangle whose sides have so many parts, at least 1 and at most 32,767 each.
    pub fn rows(&self, parts: [u32; 3]) -> DiceRows {
        self.resources.dice_rows(parts)
    }

    /// How many points it has inside.
    pub fn points(&self, rows: DiceRows) -> u32 {
        self.resources.dice_points(rows)
    }

    /// How many triangles it has.
    pub fn triangles(&self, rows: DiceRows) -> u32 {
        self.resources.dice_triangles(rows)
    }

    /// The place of an inner point by its number.
    pub fn place(&self, rows: DiceRows, number: u32) -> DicePlace {
        self.resources.dice_place(rows, number)
    }

    /// The point at a place.
    pub fn point(&self, rows: DiceRows, place: DicePlace) -> DicePoint {
        self.resources.dice_point(rows, place)
    }

    /// A triangle by its number.
    pub fn triangle(&self, rows: DiceRows, number: u32) -> DiceTriangle {
        self.resources.dice_triangle(rows, number)
    }

    /// A vertex of the base, displaced as another one at its position says, which lies in that voxel.
    pub fn site_of_vertex(&self, vertex: BaseVertex, seen: BaseVertex, voxel: Voxel) -> BaseSite {
        self.resources.site_of_vertex(vertex, seen, voxel)
    }

    /// The point of an edge that so many of its parts lie before.
    pub fn site_between(&self, [a, b]: [BaseSite; 2], shares: Vec2<f32>, [at, parts]: [u32; 2]) -> BaseSite {
        self.resources.site_between(a, b, shares, at, parts)
    }

    /// The point inside of a triangle that has those weights in the picture.
    pub fn site_inside(&self, [a, b, c]: [BaseSite; 3], shares: Vec3<f32>, weights: Vec3<f32>) -> BaseSite {
        self.resources.site_inside(a, b, c, shares, weights)
    }

    /// What a point of the base becomes.
    pub fn displaced(&self, site: BaseSite) -> Corner {
        self.resources.displaced_site(self.grid, site)
    }
}
