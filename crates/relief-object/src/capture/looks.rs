//! What a mesh looks like at a point.

use glam::{DVec3, Vec3};
use relief_core::mesh::Mesh;
use relief_core::object::View;
use relief_core::raycast::SurfaceHit;
use relief_io::MeshColors;

/// A point of a mesh that an image shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub triangle: u32,
    /// Barycentric.
    pub weights: [f64; 3],
    /// Whether the front is seen.
    pub front: bool,
}

impl Place {
    /// Where a ray meets a mesh.
    pub fn of_hit(hit: &SurfaceHit) -> Self {
        Self { triangle: hit.triangle, weights: hit.weights, front: hit.front }
    }

    /// A point of a triangle with those corners, which is seen from a direction.
    pub fn of(corners: [DVec3; 3], point: DVec3, toward: DVec3, triangle: u32) -> Self {
        let [a, b, c] = corners;
        let (e, f, p) = (b - a, c - a, point - a);
        let normal = e.cross(f);
        let (ee, ef, ff, pe, pf) = (e.dot(e), e.dot(f), f.dot(f), p.dot(e), p.dot(f));
        let area = ee * ff - ef * ef;
        // The point is in the triangle but for rounding.
        let of = |weight: f64| if area > 0.0 { (weight / area).clamp(0.0, 1.0) } else { 0.0 };
        let (v, w) = (of(ff * pe - ef * pf), of(ee * pf - ef * pe));
        let sum = (v + w).max(1.0);
        let (v, w) = (v / sum, w / sum);
        Self { triangle, weights: [1.0 - v - w, v, w], front: normal.dot(toward) >= 0.0 }
    }

    /// The unit normal, turned to the side that is seen: to the right, upward and toward the viewer.
    pub fn normal(&self, mesh: &Mesh, view: &View) -> [f32; 3] {
        let normal = self.on(mesh).normal.as_dvec3();
        let normal = if self.front { normal } else { -normal };
        let [right, down, toward] = view.axes();
        unit([normal.dot(right), -normal.dot(down), normal.dot(toward)].map(|part| part as f32))
    }

    /// The linear colour.
    pub fn color(&self, mesh: &Mesh, colors: &MeshColors) -> [f32; 3] {
        let [red, green, blue, _] = colors.at(self.triangle, self.weights, self.uv(mesh));
        [red, green, blue]
    }

    /// Whether it is seen: what its material's mask leaves out is not.
    pub fn is_seen(&self, mesh: &Mesh, colors: &MeshColors) -> bool {
        !colors.has_mask(self.triangle) || colors.is_seen(self.triangle, self.weights, self.uv(mesh))
    }

    fn uv(&self, mesh: &Mesh) -> [f64; 2] {
        self.on(mesh).uv.as_dvec2().to_array()
    }

    fn on(&self, mesh: &Mesh) -> relief_core::mesh::Vertex {
        mesh.interpolated(self.triangle, self.weights.map(|weight| weight as f32))
    }
}

/// A direction of length 1; toward the viewer where it has none.
pub fn unit(normal: [f32; 3]) -> [f32; 3] {
    Vec3::from(normal).normalize_or(Vec3::Z).to_array()
}
