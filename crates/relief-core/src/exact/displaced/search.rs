//! The first crossing of the ray with the sheet over one base triangle.
//!
//! The shell is halved along the lines between cells, and the sheet inside a cell along the middles of its
//! sides, depth first and the nearer half first. A part is left as soon as the ray misses its hull, or meets
//! it only behind what was found. It is finished when Newton's method is certain of its crossings, or when it
//! is smaller than the tolerance.

use glam::{DVec2, DVec3};

use super::bezier::{Crossings, Sheet, SheetPoint};
use super::hull::{entry_depth, is_missed};
use super::ray_space::RaySpace;
use super::relief::Relief;
use super::shell::Piece;
use super::{Side, Sides};
use crate::mesh::Vertex;

/// Rounding of a point in ray space, as a part of the largest length that it is reckoned from.
const ROUNDING: f64 = 1.0 / (1u64 << 46) as f64;

/// How often a sheet inside a cell is halved at most: more than it takes until the numbers of `f64` lie no
/// closer.
pub(super) const MAX_HALVINGS: u32 = 128;

/// Where the sheet is crossed, or touched.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub depth: f64,
    pub triangle: u32,
    pub weights: DVec3,
    pub height: f64,
    pub side: Side,
    pub folded: bool,
    pub grazing: bool,
}

/// The first crossing that was found so far.
#[derive(Clone, Debug)]
pub(super) struct Search<'a> {
    relief: &'a Relief,
    ray: &'a RaySpace,
    sides: Sides,
    /// Parts that are smaller, or smaller than their rounding, are not told apart, in metres.
    tolerance: f64,
    pub first: Option<Crossing>,
    pub nodes: u64,
    triangle: u32,
    /// The rounding of the triangle's points, in metres.
    error: f64,
}

/// The least and the greatest corner of a box around some points.
fn extent(points: impl Iterator<Item = DVec3>) -> [DVec3; 2] {
    points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[least, greatest], point| {
        [least.min(point), greatest.max(point)]
    })
}

/// The rounding of points of a piece and its parts in ray space, in metres.
pub(super) fn rounding(piece: &Piece) -> f64 {
    let [least, greatest] = extent(piece.hull());
    let positions = piece.corners.iter().map(|corner| corner.position.length()).fold(0.0, f64::max);
    ROUNDING * positions.max(least.abs().max(greatest.abs()).length())
}

impl<'a> Search<'a> {
    pub fn new(relief: &'a Relief, ray: &'a RaySpace, sides: Sides, tolerance: f64) -> Self {
        Self { relief, ray, sides, tolerance, first: None, nodes: 0, triangle: 0, error: 0.0 }
    }

    /// Depths that are not below are of no interest any more.
    pub fn limit(&self) -> f64 {
        self.first.map_or(f64::INFINITY, |crossing| crossing.depth)
    }

    /// Looks for a nearer crossing in one base triangle.
    pub fn triangle(&mut self, number: u32, vertices: [&Vertex; 3]) {
        let piece = Piece::whole(self.relief, self.ray, vertices);
        self.triangle = number;
        self.error = rounding(&piece);
        if let Some(depth) = self.entry(piece.hull()) {
            self.piece(piece, depth);
        }
    }

    /// A lower bound of the depth at which the ray meets a hull; `None` where it does not, or too late.
    fn entry(&mut self, hull: impl Iterator<Item = DVec3> + Clone) -> Option<f64> {
        self.nodes += 1;
        let depths = hull.clone().map(|point| point.z);
        let [near, far] = depths
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[near, far], depth| [near.min(depth), far.max(depth)]);
        let is_ahead = far >= -self.error && near < self.limit();
        if !is_ahead || is_missed(hull.clone(), self.error) {
            return None;
        }
        // What begins before the limit and ends behind may still be met behind it. Of crossings at the same
        // depth, to rounding, one is enough: there may be a curve of them where a sheet has no area.
        let is_behind = far >= self.limit() && {
            let [entry, rounding] = entry_depth(hull, self.error);
            entry >= self.limit() - rounding.min(self.tolerance)
        };
        (!is_behind).then_some(near)
    }

    fn piece(&mut self, piece: Piece, near: f64) {
        if near >= self.limit() {
            return;
        }
        if let Some(cell) = piece.only_cell() {
            let patch = self.relief.cell(cell);
            for corners in piece.triangles(cell) {
                let sheet = Sheet::new(&patch, corners);
                if self.entry(sheet.hull()).is_some() {
                    self.sheet(&sheet, MAX_HALVINGS);
                }
            }
            return;
        }
        let [a, b] = piece.split(self.relief);
        let [near_a, near_b] = [self.entry(a.hull()), self.entry(b.hull())];
        let ordered = if near_b < near_a { [(b, near_b), (a, near_a)] } else { [(a, near_a), (b, near_b)] };
        for (part, near) in ordered {
            if let Some(near) = near {
                self.piece(part, near);
            }
        }
    }

    fn sheet(&mut self, sheet: &Sheet, halvings: u32) {
        match sheet.crossings(self.error) {
            Crossings::None => return,
            Crossings::One(point) => return self.take(&point, false),
            Crossings::Unknown => {}
        }
        let [least, greatest] = extent(sheet.hull());
        if halvings == 0 || (greatest - least).max_element() <= self.tolerance.max(self.error) {
            return self.take(&sheet.at(DVec2::splat(1.0 / 3.0)), true);
        }
        let [a, b] = sheet.split();
        let [near_a, near_b] = [self.entry(a.hull()), self.entry(b.hull())];
        let ordered = if near_b < near_a { [(b, near_b), (a, near_a)] } else { [(a, near_a), (b, near_b)] };
        for (part, near) in ordered {
            if near.is_some_and(|near| near < self.limit()) {
                self.sheet(&part, halvings - 1);
            }
        }
    }

    /// Takes a crossing if it is on a side that counts, ahead, and before what was found.
    fn take(&mut self, at: &SheetPoint, grazing: bool) {
        let depth = at.point.z;
        let [x, y] = at.tangents;
        // How fast the height above the sheet grows along the ray is this over the shell's volume.
        let area = x.x * y.y - x.y * y.x;
        let rises = (area > 0.0 && at.volume > 0.0) || (area < 0.0 && at.volume < 0.0);
        let side = if rises && !grazing { Side::Back } else { Side::Front };
        let counts = side == Side::Front || self.sides == Sides::Both;
        if counts && depth >= 0.0 && depth < self.limit() {
            self.first = Some(Crossing {
                depth,
                triangle: self.triangle,
                weights: at.weights,
                height: at.height,
                side,
                folded: at.volume < 0.0,
                grazing,
            });
        }
    }
}
