//! Block under construction: its vertices, triangles and folds.

use std::collections::{HashMap, HashSet};

use glam::Vec3;
use relief_core::mesh::{MeshBlock, Vertex};

use crate::cache_order::cache_order;
use crate::folds::{self, FoldedBase};
use crate::mesher::outline::Outline;
use crate::plane::Faces;
use crate::smooth::Normals;
use crate::triangles::{Numbered, Triangles};
use crate::vertex_set::VertexSet;

/// Block under construction.
#[derive(Default)]
pub(super) struct BlockBuilder<'a> {
    pub(super) block: MeshBlock,
    /// Smooth numbers of the triangles' corners, if normals are computed from these triangles.
    pub(super) smooth: Option<Vec<[u32; 3]>>,
    pub(super) normals: Option<&'a Normals>,
    /// Remaining vertices, once they are known.
    pub(super) used: Option<&'a VertexSet>,
    /// Whether triangles alone are needed.
    pub(super) is_counted: bool,
    /// Outline along which touching pieces are parted.
    pub(super) outline: Option<&'a Outline>,
    /// Vertices that are searched for, and the ones found.
    pub(super) wanted: Option<&'a HashSet<u32>>,
    pub(super) found: Vec<(u32, Vertex)>,
    pub(super) folds: Vec<FoldedBase>,
    pub(super) folds_below: Vec<FoldedBase>,
    /// Base triangle of the triangles that are added next.
    pub(super) owner: u32,
}

impl BlockBuilder<'_> {
    /// Adds a vertex, unless no triangle uses it, and returns its position.
    #[inline(always)]
    pub(super) fn vertex(&mut self, mut vertex: Vertex, numbered: Numbered) -> Vec3 {
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
    pub(super) fn knows(&self, number: u32) -> bool {
        self.used.is_none_or(|used| used.contains(number))
    }

    /// Adds faces with their own vertices.
    pub(super) fn faces(&mut self, Faces { own, points, triangles }: Faces, is_turned: bool) {
        for (vertex, numbered) in own {
            self.vertex(vertex, numbered);
        }
        self.owner = MeshBlock::NO_OWNER;
        self.triangles(&triangles, &points, is_turned);
    }

    /// Adds triangles of the base as an underside, turned over.
    pub(super) fn underside(
        &mut self,
        base: &Triangles,
        all: impl Iterator<Item = (u32, [(Numbered, Vec3); 3])>,
    ) {
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

    pub(super) fn triangles(&mut self, triangles: &[[u32; 3]], points: &[(Numbered, Vec3)], is_turned: bool) {
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
    pub(super) fn beneath(&mut self, above: MeshBlock, outline: &Outline) {
        let MeshBlock { vertices, triangles, points, corners, owners } = above;
        let first = outline.first_below;
        self.block.vertices.extend(vertices.iter().map(|vertex| outline.vertex_below(vertex)));
        self.block.triangles.extend(triangles.iter().map(|[a, b, c]| [first + a, first + c, first + b]));
        self.block.points.extend(points.into_iter().map(|point| outline.below(point)));
        self.block.corners.extend(corners.iter().map(|[a, b, c]| [*a, *c, *b]));
        self.block.owners.extend(owners);
    }

    /// Adds a wall along an outline.
    pub(super) fn wall(&mut self, outline: &Outline, at: u32) {
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
    pub(super) fn order(&mut self) {
        let Some(order) = cache_order(&self.block.corners, self.block.points.len()) else { return };
        self.block.triangles = ordered(&self.block.triangles, &order);
        self.block.corners = ordered(&self.block.corners, &order);
        self.block.owners = ordered(&self.block.owners, &order);
        if let Some(smooth) = &mut self.smooth {
            *smooth = ordered(smooth, &order);
        }
    }
}

fn ordered<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
    order.iter().map(|&at| list[at as usize]).collect()
}
