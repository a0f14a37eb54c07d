//! Search for the first crossing of the ray with the sheet over one base triangle.
//!
//! The shell is halved along the lines between cells. The sheet inside a cell is halved through the
//! middles of its sides. The search is depth first and takes the nearer half first. It leaves a
//! part as soon as the ray misses its hull, or enters it only behind the best crossing. A part is
//! finished when Newton's method is certain of its crossings, or when it is smaller than the
//! tolerance.

use glam::{DVec2, DVec3};

use super::bezier::{Crossings, Sheet, SheetPoint};
use super::hull::{entry_depth, is_missed};
use super::ray_space::RaySpace;
use super::relief::Relief;
use super::shell::Piece;
use super::{Side, Sides};
use crate::mesh::Vertex;

/// Rounding of a point in ray space, relative to the largest length in its computation.
const ROUNDING: f64 = 1.0 / (1u64 << 46) as f64;

/// Limit of the halvings of a sheet inside a cell. Fewer reach the resolution of `f64`.
pub(super) const MAX_HALVINGS: u32 = 128;

/// A crossing or touch of ray and sheet.
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

/// State of a search, with the first crossing found yet.
#[derive(Clone, Debug)]
pub(super) struct Search<'a> {
    relief: &'a Relief,
    ray: &'a RaySpace,
    sides: Sides,
    /// Size in metres below which parts are not divided, unless their rounding is larger.
    tolerance: f64,
    pub first: Option<Crossing>,
    pub nodes: u64,
    triangle: u32,
    /// Rounding of the triangle's points, in metres.
    error: f64,
}

/// Least and greatest corner of a box around some points.
fn extent(points: impl Iterator<Item = DVec3>) -> [DVec3; 2] {
    points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[least, greatest], point| {
        [least.min(point), greatest.max(point)]
    })
}

/// Rounding of the points of a piece and its parts in ray space, in metres.
pub(super) fn rounding(piece: &Piece) -> f64 {
    let [least, greatest] = extent(piece.hull());
    let positions = piece.corners.iter().map(|corner| corner.position.length()).fold(0.0, f64::max);
    ROUNDING * positions.max(least.abs().max(greatest.abs()).length())
}

impl<'a> Search<'a> {
    pub fn new(relief: &'a Relief, ray: &'a RaySpace, sides: Sides, tolerance: f64) -> Self {
        Self { relief, ray, sides, tolerance, first: None, nodes: 0, triangle: 0, error: 0.0 }
    }

    /// Depth below which a crossing still matters.
    pub fn limit(&self) -> f64 {
        self.first.map_or(f64::INFINITY, |crossing| crossing.depth)
    }

    /// Searches one base triangle for a nearer crossing.
    pub fn triangle(&mut self, number: u32, vertices: [&Vertex; 3]) {
        let piece = Piece::whole(self.relief, self.ray, vertices);
        self.triangle = number;
        self.error = rounding(&piece);
        if let Some(depth) = self.entry(piece.hull()) {
            self.piece(piece, depth);
        }
    }

    /// Lower bound of the depth at which the ray enters a hull; `None` if it misses, or enters too
    /// late.
    fn entry(&mut self, hull: impl Iterator<Item = DVec3> + Clone) -> Option<f64> {
        self.nodes += 1;
        let depths = hull.clone().map(|point| point.z);
        let [near, far] = depths
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[near, far], depth| [near.min(depth), far.max(depth)]);
        let is_ahead = far >= -self.error && near < self.limit();
        if !is_ahead || is_missed(hull.clone(), self.error) {
            return None;
        }
        // A hull that begins before the limit and ends behind it may still be entered behind it.
        // One crossing at each depth, to rounding, is enough: there may be a curve of them where a
        // sheet has no area.
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

    /// Accepts a crossing if it is on a side that counts, ahead of the origin, and before the best
    /// one.
    fn take(&mut self, at: &SheetPoint, grazing: bool) {
        let depth = at.point.z;
        let [x, y] = at.tangents;
        // This over the shell's volume is the growth along the ray of the height above the sheet.
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
