//! Building of blocks, each by itself.

mod builder;
mod patches;

use std::collections::HashSet;

use glam::{DVec3, Vec3};
use relief_core::mesh::{MeshBlock, PositionGrid, Vertex};

use self::builder::BlockBuilder;
use super::outline::Outline;
use super::solid::Solid;
use super::{Base, EMPTY, Mesher};
use crate::crack::CrackPart;
use crate::folds::FoldedBase;
use crate::plan::Work;
use crate::smooth::Normals;
use crate::triangles::{EdgeVertices, Numbered};
use crate::{Pose, Rounded, Shading, Stream};

/// Finished block with its measurements.
pub struct FinishedBlock {
    pub block: MeshBlock,
    pub part: Option<CrackPart>,
    /// Numbers of the triangles' corners for smooth normals.
    pub smooth: Vec<[u32; 3]>,
    pub bounds_m: [Vec3; 2],
    /// Folds, in the order of the base's triangles.
    pub folds: Vec<FoldedBase>,
    /// Folds of a solid's underside.
    pub folds_below: Vec<FoldedBase>,
    pub rounded: Rounded,
}

impl Mesher {
    /// Builds a block, in the memory of one that is not needed any more. Returns `None` if a
    /// position is not finite.
    pub fn finished_block(
        &self,
        work: &Work,
        how: &Stream,
        normals: Option<&Normals>,
        block: MeshBlock,
    ) -> Option<FinishedBlock> {
        let smooth = (self.shading == Shading::Mesh && normals.is_none()).then(Vec::new);
        let used = self.used.as_ref();
        let outline = self.outline();
        let mut builder =
            BlockBuilder { block: emptied(block), normals, smooth, used, outline, ..BlockBuilder::default() };
        self.build(work, &mut builder);
        let count = builder.block.triangles.len();
        builder.block.owners.resize(count, MeshBlock::NO_OWNER);
        if how.cache_order {
            builder.order();
        }
        let BlockBuilder { mut block, smooth, folds, folds_below, .. } = builder;
        apply_pose(&mut block, &self.pose, how.size);
        let rounded = how.grid.map(|grid| round(&mut block, &grid)).unwrap_or_default();
        let (mut bounds_m, mut is_finite) = (EMPTY, true);
        for Vertex { position, .. } in &block.vertices {
            bounds_m = [bounds_m[0].min(*position), bounds_m[1].max(*position)];
            is_finite &= position.is_finite();
        }
        if !is_finite {
            return None;
        }
        let part = how.check.then(|| CrackPart::of(&block.points, &block.corners));
        let smooth = smooth.unwrap_or_default();
        Some(FinishedBlock { block, part, smooth, bounds_m, folds, folds_below, rounded })
    }

    /// Returns the triangles of a block that are not left out. Their corners have the numbers of
    /// all vertices, before any is left out.
    pub fn remaining_triangles(&self, work: &Work) -> Vec<[u32; 3]> {
        // Vertices alone make no triangles.
        if matches!(work, Work::Corners(_) | Work::Edges(_)) {
            return Vec::new();
        }
        let mut builder = BlockBuilder { is_counted: true, ..BlockBuilder::default() };
        self.build(work, &mut builder);
        builder.block.triangles
    }

    /// Returns the vertices of a block that are in `wanted`, with their numbers.
    pub fn find_vertices(&self, work: &Work, wanted: &HashSet<u32>) -> Vec<(u32, Vertex)> {
        let mut builder = BlockBuilder { wanted: Some(wanted), ..BlockBuilder::default() };
        self.build(work, &mut builder);
        builder.found
    }

    fn outline(&self) -> Option<&Outline> {
        match &self.solid {
            Some(Solid::Outline(outline)) => Some(outline),
            _ => None,
        }
    }

    fn build(&self, work: &Work, builder: &mut BlockBuilder) {
        match (&self.base, work) {
            (_, Work::Copies(range)) => {
                for at in self.outline().into_iter().flat_map(|_| range.clone()) {
                    if let Some(outline) = self.outline() {
                        let (vertex, numbered) = outline.copy(at);
                        builder.vertex(vertex, numbered);
                    }
                }
            }
            (_, Work::Beneath(at)) => {
                if let Some(outline) = self.outline() {
                    let (used, outlined) = (builder.used, Some(outline));
                    let mut above = BlockBuilder { used, outline: outlined, ..BlockBuilder::default() };
                    self.build(&self.blocks[*at as usize], &mut above);
                    builder.beneath(above.block, outline);
                }
            }
            (_, Work::Outline(range)) => {
                if let Some(outline) = self.outline() {
                    range.clone().for_each(|at| builder.wall(outline, at));
                }
            }
            (Base::Triangles(base, pattern), Work::Patches { from, to, first_inner, first_vertex }) => {
                self.patches(base, pattern, [*from, *to], [*first_inner, *first_vertex], builder);
            }
            (Base::Grid(grid, pattern), Work::Tile(number)) => {
                self.tile(grid, pattern, &grid.tile(*number), builder);
            }
            (Base::Adapted(plane), Work::Corners(range)) => {
                for number in range.clone() {
                    builder.vertex(plane.corner_vertex(&self.relief, number), Numbered::both(number));
                }
            }
            (Base::Adapted(plane), Work::Edges(range)) => {
                for side in range.clone() {
                    for at in 0..plane.points_of_side(side) {
                        let vertex = plane.side_vertex(&self.relief, side, at);
                        builder.vertex(vertex, Numbered::both(plane.first_of_side(side) + at));
                    }
                }
            }
            (Base::Adapted(plane), Work::Tile(number)) => self.filled_tile(plane, *number, builder),
            (Base::Filled(filled), Work::Filled(range)) => {
                for patch in range.clone() {
                    self.filled_patch(filled, patch, builder);
                }
            }
            (base, Work::Solid(first)) => {
                if let (Some(Solid::Plane(solid)), Some(rectangle)) = (&self.solid, base.rectangle()) {
                    builder.faces(solid.faces(rectangle, &self.relief, *first), rectangle.is_turned);
                }
            }
            (base, Work::Below(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    for place in range.clone() {
                        let (vertex, numbered) = solid.corner(base, place);
                        builder.vertex(vertex, numbered);
                    }
                }
            }
            (base, Work::Underside(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    builder.underside(base, range.clone().map(|place| solid.triangle(base, place)));
                }
            }
            (base, Work::Walls(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    for wall in range.clone() {
                        builder.faces(solid.wall(base, &self.relief, wall), false);
                    }
                }
            }
            (base, Work::Corners(range)) => {
                if let Some(base) = base.triangles() {
                    for number in range.clone() {
                        builder
                            .vertex(base.corner_vertex(&self.relief, number), base.corner_numbered(number));
                    }
                }
            }
            (base, Work::Edges(range)) => {
                if let Some(base) = base.triangles() {
                    for edge in range.clone() {
                        let vertices = EdgeVertices::new(base, edge);
                        for at in 1..=base.points_of_edge(edge) {
                            let (vertex, numbered) = vertices.at(&self.relief, at);
                            builder.vertex(vertex, numbered);
                        }
                    }
                }
            }
            // The plan of one base has no work of the other.
            _ => {}
        }
    }
}

fn emptied(mut block: MeshBlock) -> MeshBlock {
    block.vertices.clear();
    block.triangles.clear();
    block.points.clear();
    block.corners.clear();
    block.owners.clear();
    block
}

/// Moves, turns and scales a block into place. Equal positions stay equal.
fn apply_pose(block: &mut MeshBlock, pose: &Pose, size: f64) {
    if size == 1.0 && *pose == Pose::IDENTITY {
        return;
    }
    let position = |of: Vec3| pose.position(of.as_dvec3(), size).as_vec3();
    let direction = |of: Vec3, size: f64| (pose.turned(of.as_dvec3()) * DVec3::splat(size)).as_vec3();
    for vertex in &mut block.vertices {
        vertex.position = position(vertex.position);
        vertex.normal = direction(vertex.normal, 1.0);
        vertex.tangent = direction(vertex.tangent, size);
        vertex.bitangent = direction(vertex.bitangent, size);
    }
    for point in &mut block.points {
        *point = position(*point);
    }
}

/// Rounds the positions of a block to a lattice.
fn round(block: &mut MeshBlock, grid: &PositionGrid) -> Rounded {
    let mut rounded = Rounded::default();
    for vertex in &mut block.vertices {
        let position = grid.snapped(vertex.position);
        let moved_m = position.as_dvec3().distance(vertex.position.as_dvec3());
        rounded.greatest_m = rounded.greatest_m.max(moved_m);
        vertex.position = position;
    }
    let had_area: Vec<bool> = block.positions().map(has_area).collect();
    for point in &mut block.points {
        *point = grid.snapped(*point);
    }
    let has_area = block.positions().map(has_area);
    rounded.without_area =
        had_area.into_iter().zip(has_area).filter(|(had, has)| *had && !has).count() as u64;
    rounded
}

fn has_area(corners: [Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a) != DVec3::ZERO
}
