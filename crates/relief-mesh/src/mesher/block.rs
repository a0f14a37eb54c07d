//! Blocks of a mesh, each made by itself.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::{MeshBlock, PositionGrid, Vertex};

use super::solid::Solid;
use super::{Base, EMPTY, Mesher};
use crate::cache_order::cache_order;
use crate::crack::CrackPart;
use crate::folds::{self, FoldedBase};
use crate::interior::{Cut, Pattern};
use crate::patch::{Patch, PatchPoint};
use crate::plan::Work;
use crate::plane::{Adapted, Faces, Grid, Tile};
use crate::smooth::Normals;
use crate::triangles::{self, Numbered, Triangles};
use crate::{Rounded, Stream};

/// A block that was made.
pub struct Made {
    pub block: MeshBlock,
    pub part: Option<CrackPart>,
    /// The smooth numbers of the triangles' corners.
    pub smooth: Vec<[u32; 3]>,
    pub bounds_m: [Vec3; 2],
    /// What is folded over, in the order of the base's triangles.
    pub folds: Vec<FoldedBase>,
    /// The same of the underside of a solid.
    pub folds_below: Vec<FoldedBase>,
    pub rounded: Rounded,
}

impl Mesher {
    /// A block; none where a position is not finite.
    pub fn made(&self, work: &Work, how: &Stream, normals: Option<&Normals>) -> Option<Made> {
        let local = how.cache_order.then(Vec::new);
        let mut making = Making { normals, local, ..Making::default() };
        match (&self.base, work) {
            (Base::Triangles(base, pattern), Work::Patches { from, to, first_inner, first_vertex }) => {
                self.patches(base, pattern, [*from, *to], [*first_inner, *first_vertex], &mut making);
            }
            (Base::Grid(grid, pattern), Work::Tile(number)) => {
                self.tile(grid, pattern, &grid.tile(*number), &mut making);
            }
            (Base::Adapted(plane), Work::Corners(range)) => {
                for number in range.clone() {
                    making.vertex(plane.corner_vertex(&self.relief, number), Numbered::both(number));
                }
            }
            (Base::Adapted(plane), Work::Edges(range)) => {
                for side in range.clone() {
                    for at in 0..plane.points_of_side(side) {
                        let vertex = plane.side_vertex(&self.relief, side, at);
                        making.vertex(vertex, Numbered::both(plane.first_of_side(side) + at));
                    }
                }
            }
            (Base::Adapted(plane), Work::Tile(number)) => self.filled_tile(plane, *number, &mut making),
            (Base::Filled(filled), Work::Filled(range)) => {
                for patch in range.clone() {
                    self.filled_patch(filled, patch, &mut making);
                }
            }
            (base, Work::Solid(first)) => {
                if let (Some(Solid::Plane(solid)), Some(rectangle)) = (&self.solid, base.rectangle()) {
                    making.faces(solid.faces(rectangle, &self.relief), *first, rectangle.is_turned);
                }
            }
            (base, Work::Below(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    for place in range.clone() {
                        let (vertex, numbered) = solid.corner(base, place);
                        making.vertex(vertex, numbered);
                    }
                }
            }
            (base, Work::Underside(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    making.underside(base, range.clone().map(|place| solid.triangle(base, place)));
                }
            }
            (base, Work::Walls(range)) => {
                if let (Some(Solid::Triangles(solid)), Some(base)) = (&self.solid, base.triangles()) {
                    for wall in range.clone() {
                        let faces = solid.wall(base, &self.relief, wall);
                        making.faces(faces, solid.first_of_wall(wall), false);
                    }
                }
            }
            (base, Work::Corners(range)) => {
                if let Some(base) = base.triangles() {
                    for number in range.clone() {
                        making.vertex(base.corner_vertex(&self.relief, number), base.corner_numbered(number));
                    }
                }
            }
            (base, Work::Edges(range)) => {
                if let Some(base) = base.triangles() {
                    for edge in range.clone() {
                        for at in 1..=base.points_of_edge(edge) {
                            let vertex = base.edge_vertex(&self.relief, edge, at);
                            making.vertex(vertex, base.edge_numbered(edge, at));
                        }
                    }
                }
            }
            // The plan of one base has no work of the other.
            _ => {}
        }
        making.order();
        let Making { mut block, smooth, folds, folds_below, .. } = making;
        scale(&mut block, how.size);
        let rounded = how.grid.map(|grid| round(&mut block, &grid)).unwrap_or_default();
        let positions = block.vertices.iter().map(|vertex| vertex.position);
        let bounds_m = positions.clone().fold(EMPTY, |[low, high], at| [low.min(at), high.max(at)]);
        if !positions.clone().all(|position| position.is_finite()) {
            return None;
        }
        let part = how.check.then(|| CrackPart::of(block.points.iter().copied()));
        Some(Made { block, part, smooth, bounds_m, folds, folds_below, rounded })
    }

    fn patches(
        &self,
        base: &Triangles,
        pattern: &Pattern,
        [from, to]: [[u32; 2]; 2],
        first: [u32; 2],
        making: &mut Making,
    ) {
        let [mut first_inner, mut first_vertex] = first;
        let mut cut = Cut::default();
        let mut points: Vec<(Numbered, Vec3)> = Vec::new();
        for patch in from[0]..=to[0].min(base.count() - 1) {
            let shape = base.patch(patch);
            let begin = if patch == from[0] { from[1] } else { 0 };
            let end = if patch == to[0] { to[1] } else { (pattern.steps)(&shape) };
            if begin == end {
                first_inner = 0;
                continue;
            }
            cut.clear();
            points.clear();
            (pattern.cut)(&shape, begin..end, first_inner, &mut cut);
            let mut own = 0;
            for point in &cut.points {
                points.push(match *point {
                    PatchPoint::Border { side, at } => base.border(&self.relief, patch, side, at),
                    PatchPoint::Inner { number, weights } => {
                        let number_of = first_vertex.wrapping_add(number).wrapping_sub(first_inner);
                        let numbered = Numbered::both(number_of);
                        if number < first_inner {
                            (numbered, base.inner(&self.relief, patch, weights))
                        } else {
                            own += 1;
                            let vertex = base.inner_vertex(&self.relief, patch, weights);
                            (numbered, making.vertex(vertex, numbered))
                        }
                    }
                });
            }
            making.triangles(&cut.triangles, &points, false);
            making.folds.extend(self.folded(base, patch, &cut, &points));
            first_vertex += own;
            first_inner = 0;
        }
    }

    /// What of a patch is folded over.
    fn folded(
        &self,
        base: &Triangles,
        patch: u32,
        cut: &Cut,
        points: &[(Numbered, Vec3)],
    ) -> Option<FoldedBase> {
        if !base.can_fold() {
            return None;
        }
        let of_corners = base.directions(patch);
        let is_folded = |corners: &&[u32; 3]| {
            let positions = corners.map(|corner| points[corner as usize].1);
            // Directions between are sums of the corners'.
            folds::may_be_folded(positions, of_corners) && {
                let direction = |corner: u32| base.direction(patch, &cut.points[corner as usize]);
                folds::is_folded(positions, corners.map(|corner| self.relief.direction(direction(corner))))
            }
        };
        let pieces = cut.triangles.iter().filter(is_folded).count() as u64;
        (pieces > 0).then(|| FoldedBase { triangle: base.whole(patch), pieces, middle_m: base.middle(patch) })
    }

    fn filled_tile(&self, plane: &Adapted, tile: u32, making: &mut Making) {
        let border = plane.border_points(&self.relief, tile);
        let mut points: Vec<(Numbered, Vec3)> =
            border.into_iter().map(|(number, position)| (Numbered::both(number), position)).collect();
        for at in 0..plane.counts(tile)[0] {
            let numbered = Numbered::both(plane.first_of_tile(tile) + at);
            points.push((numbered, making.vertex(plane.inner_vertex(&self.relief, tile, at), numbered)));
        }
        // They turn from `u` to `v`, those of patterns from `v` to `u`.
        making.triangles(plane.triangles(tile), &points, !plane.is_turned());
    }

    fn filled_patch(&self, filled: &triangles::Adapted, patch: u32, making: &mut Making) {
        let cut = filled.cut(patch);
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            points.push(match *point {
                PatchPoint::Border { side, at } => filled.base().border(&self.relief, patch, side, at),
                PatchPoint::Inner { number, .. } => {
                    let numbered = Numbered::both(filled.first_of_patch(patch) + number);
                    let vertex = filled.inner_vertex(&self.relief, patch, number);
                    (numbered, making.vertex(vertex, numbered))
                }
            });
        }
        making.triangles(&cut.triangles, &points, false);
        making.folds.extend(self.folded(filled.base(), patch, &cut, &points));
    }

    fn tile(&self, plane: &Grid, pattern: &Pattern, tile: &Tile, making: &mut Making) {
        let shape = Patch::Tile(plane.lines(tile));
        let mut cut = Cut::default();
        (pattern.cut)(&shape, 0..(pattern.steps)(&shape), 0, &mut cut);
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            if let PatchPoint::Border { side, at } = *point {
                let lines = [tile.first[0] + side as usize, tile.first[1] + at as usize];
                let number = plane.number(lines);
                let numbered = Numbered::both(number);
                let position = if Grid::is_own(tile, lines) {
                    making.vertex(plane.vertex(&self.relief, lines), numbered)
                } else {
                    plane.position(&self.relief, lines)
                };
                points.push((numbered, position));
            }
        }
        making.triangles(&cut.triangles, &points, plane.is_turned());
    }
}

/// A block while it is made.
#[derive(Default)]
struct Making<'a> {
    block: MeshBlock,
    smooth: Vec<[u32; 3]>,
    normals: Option<&'a Normals>,
    folds: Vec<FoldedBase>,
    folds_below: Vec<FoldedBase>,
    /// The triangles by their places in the points that they were made of, if they are to be ordered.
    local: Option<Vec<[u32; 3]>>,
    /// How many of these points there are.
    points: u32,
}

impl Making<'_> {
    /// Adds a vertex and gives its position.
    fn vertex(&mut self, mut vertex: Vertex, numbered: Numbered) -> Vec3 {
        if let Some(normals) = self.normals {
            vertex.normal = normals.of(numbered.smooth, vertex.normal);
        }
        self.block.vertices.push(vertex);
        vertex.position
    }

    /// Adds faces that have all of their vertices, of which the first has that number.
    fn faces(&mut self, faces: Faces, first: u32, is_turned: bool) {
        let points: Vec<(Numbered, Vec3)> = (first..)
            .map(Numbered::both)
            .zip(faces.vertices)
            .map(|(numbered, vertex)| (numbered, self.vertex(vertex, numbered)))
            .collect();
        self.triangles(&faces.triangles, &points, is_turned);
    }

    /// Adds triangles of the base as they lie at an underside, turned over.
    fn underside(&mut self, base: &Triangles, all: impl Iterator<Item = (u32, [(Numbered, Vec3); 3])>) {
        let (mut places, mut points, mut triangles) = (HashMap::new(), Vec::new(), Vec::new());
        for (patch, corners) in all {
            if folds::is_folded(corners.map(|(_, position)| position), base.directions(patch)) {
                let (triangle, middle_m) = (base.whole(patch), base.middle(patch));
                self.folds_below.push(FoldedBase { triangle, pieces: 1, middle_m });
            }
            triangles.push(corners.map(|corner| {
                *places.entry(corner.0.number).or_insert_with(|| {
                    points.push(corner);
                    points.len() as u32 - 1
                })
            }));
        }
        self.triangles(&triangles, &points, true);
    }

    fn triangles(&mut self, triangles: &[[u32; 3]], points: &[(Numbered, Vec3)], is_turned: bool) {
        if let Some(local) = &mut self.local {
            local.extend(triangles.iter().map(|corners| corners.map(|corner| self.points + corner)));
            self.points += points.len() as u32;
        }
        for corners in triangles {
            let mut corners = corners.map(|corner| points[corner as usize]);
            if is_turned {
                corners.swap(1, 2);
            }
            self.block.triangles.push(corners.map(|(numbered, _)| numbered.number));
            self.block.points.push(corners.map(|(_, position)| position));
            self.smooth.push(corners.map(|(numbered, _)| numbered.smooth));
        }
    }

    /// Puts the triangles in order, if they are to be.
    fn order(&mut self) {
        let Some(local) = self.local.take() else { return };
        let Some(order) = cache_order(&local, self.points as usize) else { return };
        self.block.triangles = ordered(&self.block.triangles, &order);
        self.block.points = ordered(&self.block.points, &order);
        self.smooth = ordered(&self.smooth, &order);
    }
}

fn ordered<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
    order.iter().map(|&at| list[at as usize]).collect()
}

/// Makes a block larger or smaller. Equal positions stay equal.
fn scale(block: &mut MeshBlock, size: f64) {
    if size == 1.0 {
        return;
    }
    let scaled = |vector: Vec3| -> Vec3 { (vector.as_dvec3() * DVec3::splat(size)).as_vec3() };
    for vertex in &mut block.vertices {
        vertex.position = scaled(vertex.position);
        vertex.tangent = scaled(vertex.tangent);
        vertex.bitangent = scaled(vertex.bitangent);
    }
    for point in block.points.as_flattened_mut() {
        *point = scaled(*point);
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
    for corners in &mut block.points {
        let had_area = has_area(corners);
        *corners = corners.map(|corner| grid.snapped(corner));
        rounded.without_area += u64::from(had_area && !has_area(corners));
    }
    rounded
}

fn has_area(corners: &[Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a) != DVec3::ZERO
}
