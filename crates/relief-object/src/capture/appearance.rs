//! Appearance of a mesh at a point: normal, colour and visibility.

use glam::{DVec3, Vec3};
use relief_core::mesh::Mesh;
use relief_core::object::View;
use relief_core::raycast::SurfaceHit;
use relief_io::MeshColors;

/// A point of a mesh that an image shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisiblePoint {
    pub triangle: u32,
    /// Barycentric weights.
    pub weights: [f64; 3],
    /// Whether the front is visible.
    pub front: bool,
}

impl VisiblePoint {
    /// Returns the point at a hit.
    pub fn of_hit(hit: &SurfaceHit) -> Self {
        Self { triangle: hit.triangle, weights: hit.weights, front: hit.front }
    }

    /// Returns a point of a triangle with these corners, which is seen from the direction `toward`.
    pub fn of(corners: [DVec3; 3], point: DVec3, toward: DVec3, triangle: u32) -> Self {
        let [a, b, c] = corners;
        let (e, f, p) = (b - a, c - a, point - a);
        let normal = e.cross(f);
        let (ee, ef, ff, pe, pf) = (e.dot(e), e.dot(f), f.dot(f), p.dot(e), p.dot(f));
        let area = ee * ff - ef * ef;
        // The point is in the triangle, except for rounding.
        let of = |weight: f64| if area > 0.0 { (weight / area).clamp(0.0, 1.0) } else { 0.0 };
        let (v, w) = (of(ff * pe - ef * pf), of(ee * pf - ef * pe));
        let sum = (v + w).max(1.0);
        let (v, w) = (v / sum, w / sum);
        Self { triangle, weights: [1.0 - v - w, v, w], front: normal.dot(toward) >= 0.0 }
    }

    /// Unit normal of the visible side: its components to the right, upward and toward the viewer.
    pub fn normal(&self, mesh: &Mesh, view: &View) -> [f32; 3] {
        let normal = self.on(mesh).normal.as_dvec3();
        let normal = if self.front { normal } else { -normal };
        let [right, down, toward] = view.axes();
        unit([normal.dot(right), -normal.dot(down), normal.dot(toward)].map(|part| part as f32))
    }

    /// Linear colour.
    pub fn color(&self, mesh: &Mesh, colors: &MeshColors) -> [f32; 3] {
        let [red, green, blue, _] = colors.at(self.triangle, self.weights, self.uv(mesh));
        [red, green, blue]
    }

    /// Whether the point is visible. Points outside the material's mask are not.
    pub fn is_visible(&self, mesh: &Mesh, colors: &MeshColors) -> bool {
        !colors.has_mask(self.triangle) || colors.is_seen(self.triangle, self.weights, self.uv(mesh))
    }

    fn uv(&self, mesh: &Mesh) -> [f64; 2] {
        self.on(mesh).uv.as_dvec2().to_array()
    }

    fn on(&self, mesh: &Mesh) -> relief_core::mesh::Vertex {
        mesh.interpolated(self.triangle, self.weights.map(|weight| weight as f32))
    }
}

/// Normalises a direction. A zero vector becomes the direction toward the viewer.
pub fn unit(normal: [f32; 3]) -> [f32; 3] {
    Vec3::from(normal).normalize_or(Vec3::Z).to_array()
}
