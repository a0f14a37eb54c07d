//! Border of a patch.

use glam::Vec3;

use super::{AlongEdge, Numbered, Triangles};
use crate::point;
use crate::surface::Relief;

/// Border of a patch, whose points are computed one by one.
#[derive(Debug)]
pub struct PatchBorder<'a> {
    base: &'a Triangles,
    relief: &'a Relief,
    patch: u32,
    corners: [(Numbered, Vec3); 3],
    /// Sides that have points between their ends.
    sides: [Option<AlongEdge<'a>>; 3],
}

impl<'a> PatchBorder<'a> {
    pub fn new(base: &'a Triangles, relief: &'a Relief, patch: u32) -> Self {
        let corner = |vertex: u32| {
            let position = relief.displaced(&base.at_corner(vertex));
            (base.corners.numbered(vertex), point::stored(position))
        };
        let side = |edge: u32| (base.edges.parts(edge) > 1).then(|| AlongEdge::new(base, edge));
        let corners = base.triangles[patch as usize].map(corner);
        Self { base, relief, patch, corners, sides: base.edges.sides(patch).map(side) }
    }

    /// Returns the numbers and the position of the point of a side with `at` parts before it.
    pub fn point(&self, side: u32, at: u32) -> (Numbered, Vec3) {
        (self.numbered(side, at), self.position(side, at))
    }

    /// Returns the numbers alone.
    #[inline(always)]
    pub fn numbered(&self, side: u32, at: u32) -> Numbered {
        match (at, &self.sides[side as usize]) {
            (0, _) | (_, None) => self.corners[side as usize].0,
            _ => {
                let (edge, at) = self.base.on_side(self.patch, side, at);
                self.base.edges.numbered(edge, at)
            }
        }
    }

    /// Returns the position alone.
    #[inline(always)]
    pub fn position(&self, side: u32, at: u32) -> Vec3 {
        match (at, &self.sides[side as usize]) {
            (0, _) | (_, None) => self.corners[side as usize].1,
            (_, Some(along)) => {
                let (edge, at) = self.base.on_side(self.patch, side, at);
                along.position(self.relief, self.base.edges.place(edge, at))
            }
        }
    }
}
