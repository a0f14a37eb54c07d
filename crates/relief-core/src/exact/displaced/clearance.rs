//! Distance between a ray and a displaced mesh.

use glam::{DVec2, DVec3, Vec3Swizzles};

use super::bezier::Sheet;
use super::hierarchy::Bounds;
use super::hull::least_distance;
use super::ray_space::RaySpace;
use super::relief::Relief;
use super::search::{MAX_HALVINGS, rounding};
use super::shell::Piece;
use super::{DisplacedMesh, Sides};

impl DisplacedMesh {
    /// Returns the least distance between a ray and the displaced mesh, in metres. It is 0 for a
    /// ray that hits the mesh from either side. It is infinite for an invalid ray (see
    /// [`Self::first_hit`]) and for a mesh without triangles.
    ///
    /// The distance is measured to a point of the sheet, so it is never too small. It is too large
    /// by at most a millionth of itself and [`Self::TOLERANCE`] of the scene's size. It
    /// distinguishes a ray that almost touches the mesh from one that is wrongly reported as a
    /// miss. It takes far longer than a first hit.
    pub fn clearance(&self, origin: [f64; 3], direction: [f64; 3]) -> f64 {
        let Some(ray) = RaySpace::new(origin, direction) else { return f64::INFINITY };
        if self.first_hit(origin, direction, Sides::Both).is_some() {
            return 0.0;
        }
        let mut nearest =
            Nearest { relief: &self.relief, tolerance: self.tolerance(), distance: f64::INFINITY };
        let key = |bounds: &Bounds| Some(below(bounds.corners().map(|corner| ray.point(corner))));
        self.hierarchy.visit_by(f64::INFINITY, key, |triangle| {
            nearest.triangle(&Piece::whole(&self.relief, &ray, self.mesh.corners(triangle)));
            nearest.limit()
        });
        nearest.distance
    }
}

/// Nearest point found yet.
struct Nearest<'a> {
    relief: &'a Relief,
    tolerance: f64,
    distance: f64,
}

/// Lower bound of the distance between the ray and a hull. It is exact in the limit of a small
/// hull.
fn below(hull: impl Iterator<Item = DVec3> + Clone) -> f64 {
    let lateral = least_distance(hull.clone());
    if hull.clone().any(|point| point.z >= 0.0) {
        return lateral;
    }
    // All points are behind the origin, which is the nearest point of the ray.
    let nearest = hull.clone().min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let Some(direction) = nearest.and_then(DVec3::try_normalize) else { return lateral };
    hull.map(|point| point.dot(direction)).fold(f64::INFINITY, f64::min).max(lateral)
}

/// Distance between the ray, which begins at the origin, and a point.
fn distance(point: DVec3) -> f64 {
    if point.z >= 0.0 { point.xy().length() } else { point.length() }
}

impl Nearest<'_> {
    /// Distance below which a point still matters.
    fn limit(&self) -> f64 {
        if self.distance.is_finite() {
            self.distance - self.tolerance.max(1e-6 * self.distance)
        } else {
            f64::INFINITY
        }
    }

    fn triangle(&mut self, piece: &Piece) {
        // For a distant triangle, differences below its rounding are not resolved.
        self.tolerance = self.tolerance.max(rounding(piece));
        self.piece(piece);
    }

    fn piece(&mut self, piece: &Piece) {
        if let Some(cell) = piece.only_cell() {
            let patch = self.relief.cell(cell);
            for corners in piece.triangles(cell) {
                self.sheet(&Sheet::new(&patch, corners), MAX_HALVINGS);
            }
            return;
        }
        let mut parts = piece.split(self.relief).map(|part| (below(part.hull()), part));
        parts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        for (least, part) in &parts {
            if *least < self.limit() {
                self.piece(part);
            }
        }
    }

    fn sheet(&mut self, sheet: &Sheet, halvings: u32) {
        let here = sheet.at(DVec2::splat(1.0 / 3.0)).point;
        self.distance = self.distance.min(distance(here));
        if halvings == 0 {
            return;
        }
        let mut parts = sheet.split().map(|part| (below(part.hull()), part));
        parts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        for (least, part) in &parts {
            if *least < self.limit() {
                self.sheet(part, halvings - 1);
            }
        }
    }
}
