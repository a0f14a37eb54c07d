//! The displaced surface by its formula, without anything of the judge.

use glam::{DVec2, DVec3};
use relief_core::HeightMap;
use relief_core::mesh::Mesh;

/// The formula's parts, and whether it is deliberately wrong.
#[derive(Clone)]
pub struct Sheet {
    /// The base.
    pub mesh: Mesh,
    /// The heights.
    pub map: HeightMap,
    /// Metres between the heights 0 and 1.
    pub scale_m: f64,
    /// Metres from the base to height 0.
    pub bias_m: f64,
    /// A known mistake: the interpolated normal is made a unit vector.
    pub normalised: bool,
}

impl Sheet {
    fn sum(&self, triangle: u32, w: [f64; 3], of: impl Fn(usize) -> DVec3) -> DVec3 {
        let corners = self.mesh.triangles()[triangle as usize];
        (0..3).map(|k| w[k] * of(corners[k] as usize)).sum()
    }

    /// The normal there, not normalised.
    pub fn normal(&self, triangle: u32, w: [f64; 3]) -> DVec3 {
        let normal = self.sum(triangle, w, |at| self.mesh.vertices()[at].normal.as_dvec3());
        if self.normalised { normal.normalize() } else { normal }
    }

    /// The texture coordinates there.
    pub fn uv(&self, triangle: u32, w: [f64; 3]) -> DVec2 {
        self.sum(triangle, w, |at| self.mesh.vertices()[at].uv.as_dvec2().extend(0.0)).truncate()
    }

    /// The height there.
    pub fn height(&self, triangle: u32, w: [f64; 3]) -> f64 {
        let uv = self.uv(triangle, w);
        self.map.height_at(uv.x, uv.y)
    }

    /// The point of the sheet, in metres.
    pub fn point(&self, triangle: u32, w: [f64; 3]) -> DVec3 {
        let base = self.sum(triangle, w, |at| self.mesh.vertices()[at].position.as_dvec3());
        let metres = self.bias_m + self.scale_m * self.height(triangle, w);
        base + metres * self.normal(triangle, w)
    }

    /// The place on the map in cells.
    pub fn place(&self, triangle: u32, w: [f64; 3]) -> DVec2 {
        self.uv(triangle, w) * DVec2::new(self.map.width().into(), self.map.height().into()) - 0.5
    }

    /// Returns the number of base triangles.
    pub fn triangles(&self) -> u32 {
        self.mesh.triangles().len() as u32
    }

    /// A bound of the coordinates, in metres.
    pub fn size(&self) -> f64 {
        let farthest = self.mesh.vertices().iter().map(|vertex| vertex.position.length());
        f64::from(farthest.fold(0.0, f32::max)) + self.bias_m.abs() + self.scale_m.abs()
    }
}
