//! Points and triangles of the patches in a block.

use glam::{DVec3, Vec3};
use pulp::{Simd, WithSimd};
use relief_core::Lanes;

use super::builder::BlockBuilder;
use crate::folds::{self, FoldedBase};
use crate::interior::{Cut, Pattern};
use crate::mesher::Mesher;
use crate::patch::{Patch, PatchPoint};
use crate::plane::{Adapted, Grid, Tile};
use crate::surface::Relief;
use crate::triangles::{self, Inside, Numbered, PatchBorder, Triangles};

impl Mesher {
    pub(super) fn patches(
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

    pub(super) fn filled_tile(&self, plane: &Adapted, tile: u32, builder: &mut BlockBuilder) {
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

    pub(super) fn filled_patch(&self, filled: &triangles::Adapted, patch: u32, builder: &mut BlockBuilder) {
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

    pub(super) fn tile(&self, plane: &Grid, pattern: &Pattern, tile: &Tile, builder: &mut BlockBuilder) {
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
