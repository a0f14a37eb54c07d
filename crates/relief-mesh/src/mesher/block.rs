//! Building of blocks, each by itself.

use std::collections::{HashMap, HashSet};

use glam::{DVec3, Vec3};
use pulp::{Simd, WithSimd};
use relief_core::Lanes;
use relief_core::mesh::{MeshBlock, PositionGrid, Vertex};

use super::outline::Outline;
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
use crate::surface::Relief;
use crate::triangles::{self, EdgeVertices, Inside, Numbered, PatchBorder, Triangles};
use crate::vertex_set::VertexSet;
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

    fn patches(
        &self,
        base: &Triangles,
        pattern: &Pattern,
        [from, to]: [[u32; 2]; 2],
        first: [u32; 2],
        builder: &mut BlockBuilder,
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
            let (border, inside) = (PatchBorder::new(base, &self.relief, patch), Inside::new(base, patch));
            self.leave_out(&mut cut, |point| self.relief.place(inside.uv(base, patch, point)));
            let numbers = [first_inner, first_vertex];
            let points_of_patch = PatchPoints {
                cut: &cut,
                border: &border,
                inside: &inside,
                relief: &self.relief,
                numbers,
                builder,
                points: &mut points,
            };
            // Compiled for the machine's SIMD width; the bits are the same.
            let own = Lanes::Eight.run_up_to_eight(points_of_patch);
            if let Some((volume, cull)) = &self.unseen {
                // Triangles without all of their corners were left out when they were counted.
                cut.triangles.retain(|corners| {
                    let corners = corners.map(|corner| points[corner as usize]);
                    corners.iter().all(|(numbered, _)| builder.knows(numbered.number))
                        && !volume.is_unseen(corners.map(|(_, position)| position), cull)
                });
            }
            builder.owner = base.whole(patch);
            builder.triangles(&cut.triangles, &points, false);
            builder.folds.extend(self.folded(base, patch, &cut, &points));
            first_vertex += own;
            first_inner = 0;
        }
    }

    /// Returns the folded pieces of a patch, if there are any.
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
        // Directions between are sums of the corners' directions. Nearly always this test is
        // enough.
        let directions = base.directions(patch);
        if !Lanes::Eight.run_up_to_eight(FoldTest { triangles: &cut.triangles, points, directions }) {
            return None;
        }
        let is_folded = |corners: &&[u32; 3]| {
            let positions = corners.map(|corner| points[corner as usize].1);
            folds::may_be_folded(positions, &directions) && {
                let direction = |corner: u32| base.direction(patch, &cut.points[corner as usize]);
                folds::is_folded(positions, corners.map(|corner| self.relief.direction(direction(corner))))
            }
        };
        let pieces = cut.triangles.iter().filter(is_folded).count() as u64;
        (pieces > 0).then(|| FoldedBase { triangle: base.whole(patch), pieces, middle_m: base.middle(patch) })
    }

    /// Leaves out triangles whose middle lies over a hole. `place` returns the place of a point,
    /// counted from the centre of the first texel.
    fn leave_out(&self, cut: &mut Cut, place: impl Fn(&PatchPoint) -> [f64; 2]) {
        let Cut { points, triangles } = cut;
        self.leave_out_of(triangles, |at| place(&points[at as usize]));
    }

    /// Leaves out triangles as [`leave_out`](Self::leave_out) does, by the numbers of points.
    fn leave_out_of(&self, triangles: &mut Vec<[u32; 3]>, place: impl Fn(u32) -> [f64; 2]) {
        if !self.relief.has_holes() {
            return;
        }
        triangles.retain(|corners| {
            let [a, b, c] = corners.map(&place);
            !self.relief.is_hole([0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0))
        });
    }

    fn filled_tile(&self, plane: &Adapted, tile: u32, builder: &mut BlockBuilder) {
        let mut triangles = plane.triangles(tile).to_vec();
        self.leave_out_of(&mut triangles, |at| plane.place(tile, at).map(|place| place - 0.5));
        let border = plane.border_points(&self.relief, tile);
        let mut points: Vec<(Numbered, Vec3)> =
            border.into_iter().map(|(number, position)| (Numbered::both(number), position)).collect();
        for at in 0..plane.counts(tile)[0] {
            let numbered = Numbered::both(plane.first_of_tile(tile) + at);
            points.push((numbered, builder.vertex(plane.inner_vertex(&self.relief, tile, at), numbered)));
        }
        // Filled tiles turn from `u` to `v`, patterns from `v` to `u`.
        builder.triangles(&triangles, &points, !plane.is_turned());
    }

    fn filled_patch(&self, filled: &triangles::Adapted, patch: u32, builder: &mut BlockBuilder) {
        let base = filled.base();
        let (mut cut, border) = (filled.cut(patch), PatchBorder::new(base, &self.relief, patch));
        let inside = Inside::new(base, patch);
        self.leave_out(&mut cut, |point| self.relief.place(inside.uv(base, patch, point)));
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            points.push(match *point {
                PatchPoint::Border { side, at } => border.point(side, at),
                PatchPoint::Inner { number, weights } => {
                    let numbered = Numbered::both(filled.first_of_patch(patch) + number);
                    let height = filled.inner_height(patch, number);
                    let vertex = inside.vertex_at(&self.relief, weights, height);
                    (numbered, builder.vertex(vertex, numbered))
                }
            });
        }
        builder.owner = base.whole(patch);
        builder.triangles(&cut.triangles, &points, false);
        builder.folds.extend(self.folded(base, patch, &cut, &points));
    }

    fn tile(&self, plane: &Grid, pattern: &Pattern, tile: &Tile, builder: &mut BlockBuilder) {
        let shape = Patch::Tile(plane.lines(tile));
        let mut cut = Cut::default();
        (pattern.cut)(&shape, 0..(pattern.steps)(&shape), 0, &mut cut);
        self.leave_out(&mut cut, |point| match *point {
            PatchPoint::Border { side, at } => {
                let lines = [tile.first[0] + side as usize, tile.first[1] + at as usize];
                plane.place(lines).map(|place| place - 0.5)
            }
            // A grid has points on its lines alone.
            PatchPoint::Inner { .. } => [f64::NAN; 2],
        });
        let points = Lanes::Eight.run_up_to_eight(TilePoints {
            cut: &cut,
            plane,
            tile,
            relief: &self.relief,
            builder,
        });
        builder.triangles(&cut.triangles, &points, plane.is_turned());
    }
}

/// Points of a patch to be computed.
struct PatchPoints<'a, 'm> {
    cut: &'a Cut,
    border: &'a PatchBorder<'a>,
    inside: &'a Inside,
    relief: &'a Relief,
    /// First inner point of the patch that belongs to this block, and the number of its vertex.
    numbers: [u32; 2],
    builder: &'a mut BlockBuilder<'m>,
    points: &'a mut Vec<(Numbered, Vec3)>,
}

impl WithSimd for PatchPoints<'_, '_> {
    /// Number of vertices that belong to this block.
    type Output = u32;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> u32 {
        let [first_inner, first_vertex] = self.numbers;
        let mut own = 0;
        for point in &self.cut.points {
            self.points.push(match *point {
                PatchPoint::Border { side, at } => {
                    let numbered = self.border.numbered(side, at);
                    let is_known = self.builder.knows(numbered.number);
                    (numbered, if is_known { self.border.position(side, at) } else { Vec3::NAN })
                }
                PatchPoint::Inner { number, weights } => {
                    let number_of = first_vertex.wrapping_add(number).wrapping_sub(first_inner);
                    let numbered = Numbered::both(number_of);
                    own += u32::from(number >= first_inner);
                    if !self.builder.knows(number_of) {
                        (numbered, Vec3::NAN)
                    } else if number < first_inner || self.builder.is_counted {
                        (numbered, self.inside.position(self.relief, weights))
                    } else {
                        let vertex = self.inside.vertex(self.relief, weights);
                        (numbered, self.builder.vertex(vertex, numbered))
                    }
                }
            });
        }
        own
    }
}

/// Points of a tile of a plane to be computed.
struct TilePoints<'a, 'm> {
    cut: &'a Cut,
    plane: &'a Grid,
    tile: &'a Tile,
    relief: &'a Relief,
    builder: &'a mut BlockBuilder<'m>,
}

impl WithSimd for TilePoints<'_, '_> {
    /// Numbers and positions of the points.
    type Output = Vec<(Numbered, Vec3)>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self { cut, plane, tile, relief, builder } = self;
        let mut points = Vec::with_capacity(cut.points.len());
        for point in &cut.points {
            if let PatchPoint::Border { side, at } = *point {
                let lines = [tile.first[0] + side as usize, tile.first[1] + at as usize];
                let numbered = Numbered::both(plane.number(lines));
                let position = if Grid::is_own(tile, lines) {
                    builder.vertex(plane.vertex(relief, lines), numbered)
                } else {
                    plane.position(relief, lines)
                };
                points.push((numbered, position));
            }
        }
        points
    }
}

/// Triangles to be tested for folds, with the directions of displacement at their patch's corners.
struct FoldTest<'a> {
    triangles: &'a [[u32; 3]],
    points: &'a [(Numbered, Vec3)],
    directions: [DVec3; 3],
}

impl WithSimd for FoldTest<'_> {
    /// Whether any triangle may be folded.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        let mut found = false;
        for &[a, b, c] in self.triangles {
            let positions = [a, b, c].map(|corner| self.points[corner as usize].1);
            found |= folds::may_be_folded(positions, &self.directions);
        }
        found
    }
}

/// Block under construction.
#[derive(Default)]
struct BlockBuilder<'a> {
    block: MeshBlock,
    /// Smooth numbers of the triangles' corners, if normals are computed from these triangles.
    smooth: Option<Vec<[u32; 3]>>,
    normals: Option<&'a Normals>,
    /// Remaining vertices, once they are known.
    used: Option<&'a VertexSet>,
    /// Whether triangles alone are needed.
    is_counted: bool,
    /// Outline along which touching pieces are parted.
    outline: Option<&'a Outline>,
    /// Vertices that are searched for, and the ones found.
    wanted: Option<&'a HashSet<u32>>,
    found: Vec<(u32, Vertex)>,
    folds: Vec<FoldedBase>,
    folds_below: Vec<FoldedBase>,
    /// Base triangle of the triangles that are added next.
    owner: u32,
}

impl BlockBuilder<'_> {
    /// Adds a vertex, unless no triangle uses it, and returns its position.
    #[inline(always)]
    fn vertex(&mut self, mut vertex: Vertex, numbered: Numbered) -> Vec3 {
        if let Some(normals) = self.normals {
            vertex.normal = normals.of(numbered.smooth, vertex.normal);
        }
        if let Some(wanted) = self.wanted {
            if wanted.contains(&numbered.number) {
                self.found.push((numbered.number, vertex));
            }
        } else if !self.is_counted && self.knows(numbered.number) {
            self.block.vertices.push(vertex);
        }
        vertex.position
    }

    /// Returns whether a triangle may use the vertex `number`.
    #[inline(always)]
    fn knows(&self, number: u32) -> bool {
        self.used.is_none_or(|used| used.contains(number))
    }

    /// Adds faces with their own vertices.
    fn faces(&mut self, Faces { own, points, triangles }: Faces, is_turned: bool) {
        for (vertex, numbered) in own {
            self.vertex(vertex, numbered);
        }
        self.owner = MeshBlock::NO_OWNER;
        self.triangles(&triangles, &points, is_turned);
    }

    /// Adds triangles of the base as an underside, turned over.
    fn underside(&mut self, base: &Triangles, all: impl Iterator<Item = (u32, [(Numbered, Vec3); 3])>) {
        let (mut places, mut points, mut triangles) = (HashMap::new(), Vec::new(), Vec::new());
        let mut owners = std::mem::take(&mut self.block.owners);
        for (patch, corners) in all {
            owners.push(base.whole(patch));
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
        self.block.owners = owners;
    }

    fn triangles(&mut self, triangles: &[[u32; 3]], points: &[(Numbered, Vec3)], is_turned: bool) {
        let first = self.block.points.len() as u32;
        self.block.points.extend(points.iter().map(|(_, position)| position));
        let turned = |corners: &[u32; 3]| {
            let [a, b, c] = *corners;
            if is_turned { [a, c, b] } else { [a, b, c] }
        };
        let triangles = triangles.iter().map(turned);
        let numbered = |corner: u32| points[corner as usize].0;
        if let Some(smooth) = &mut self.smooth {
            let of = |[a, b, c]: [u32; 3]| [numbered(a).smooth, numbered(b).smooth, numbered(c).smooth];
            smooth.extend(triangles.clone().map(of));
        }
        if let Some(outline) = self.outline {
            for corners in triangles {
                self.parted(
                    outline,
                    corners.map(|corner| numbered(corner).number),
                    corners.map(|c| first + c),
                );
            }
            self.block.owners.resize(self.block.triangles.len(), self.owner);
            return;
        }
        let number = |corner: u32| {
            let number = numbered(corner).number;
            self.used.map_or(number, |used| used.number(number))
        };
        let numbers = |[a, b, c]: [u32; 3]| [number(a), number(b), number(c)];
        self.block.triangles.extend(triangles.clone().map(numbers));
        self.block.corners.extend(triangles.map(|[a, b, c]| [first + a, first + b, first + c]));
        self.block.owners.resize(self.block.triangles.len(), self.owner);
    }

    /// Adds a triangle whose corners may lie where pieces touch.
    fn parted(&mut self, outline: &Outline, mut numbers: [u32; 3], mut corners: [u32; 3]) {
        let own = [0, 1, 2].map(|k| outline.replacement(numbers[k], numbers[(k + 1) % 3]));
        for k in 0..3 {
            if let Some((number, position)) = own[k] {
                numbers[k] = number;
                corners[k] = self.block.points.len() as u32;
                self.block.points.push(position);
            }
        }
        self.block.triangles.push(numbers.map(|number| self.used.map_or(number, |used| used.number(number))));
        self.block.corners.push(corners);
    }

    /// Adds the bottom below a block. It faces the other way.
    fn beneath(&mut self, above: MeshBlock, outline: &Outline) {
        let MeshBlock { vertices, triangles, points, corners, owners } = above;
        let first = outline.first_below;
        self.block.vertices.extend(vertices.iter().map(|vertex| outline.vertex_below(vertex)));
        self.block.triangles.extend(triangles.iter().map(|[a, b, c]| [first + a, first + c, first + b]));
        self.block.points.extend(points.into_iter().map(|point| outline.below(point)));
        self.block.corners.extend(corners.iter().map(|[a, b, c]| [*a, *c, *b]));
        self.block.owners.extend(owners);
    }

    /// Adds a wall along an outline.
    fn wall(&mut self, outline: &Outline, at: u32) {
        let ends = outline.wall(at);
        let place = self.block.points.len() as u32;
        self.block.points.extend(ends.map(|(_, position)| position));
        self.block.points.extend(ends.map(|(_, position)| outline.below(position)));
        let [a, b] = ends.map(|(number, _)| self.used.map_or(number, |used| used.number(number)));
        let numbers = [a, b, outline.first_below + a, outline.first_below + b];
        for corners in [[1, 0, 2], [1, 2, 3]] {
            self.block.triangles.push(corners.map(|corner| numbers[corner]));
            self.block.corners.push(corners.map(|corner| place + corner as u32));
        }
    }

    /// Reorders the triangles for vertex caches.
    fn order(&mut self) {
        let Some(order) = cache_order(&self.block.corners, self.block.points.len()) else { return };
        self.block.triangles = ordered(&self.block.triangles, &order);
        self.block.corners = ordered(&self.block.corners, &order);
        self.block.owners = ordered(&self.block.owners, &order);
        if let Some(smooth) = &mut self.smooth {
            *smooth = ordered(smooth, &order);
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

fn ordered<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
    order.iter().map(|&at| list[at as usize]).collect()
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
