//! What a mesh looks like at a point.

use glam::{DVec3, Vec3};
use relief_core::mesh::Mesh;
use relief_core::object::View;
use relief_io::{MeshColors, Picture};

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
        let texel = match &colors.picture {
            Some(picture) => bilinear(picture, self.on(mesh).uv.as_dvec2().to_array()),
            None => [1.0; 3],
        };
        [0, 1, 2].map(|part| texel[part] * colors.factor[part])
    }

    fn on(&self, mesh: &Mesh) -> relief_core::mesh::Vertex {
        mesh.interpolated(self.triangle, self.weights.map(|weight| weight as f32))
    }
}

/// A direction of length 1; toward the viewer where it has none.
pub fn unit(normal: [f32; 3]) -> [f32; 3] {
    Vec3::from(normal).normalize_or(Vec3::Z).to_array()
}

/// A picture's colour at texture coordinates, repeated.
fn bilinear(picture: &Picture, uv: [f64; 2]) -> [f32; 3] {
    let size = [picture.width, picture.height];
    let along = |axis: usize| {
        let at = uv[axis].rem_euclid(1.0) * f64::from(size[axis]) - 0.5;
        let side = i64::from(size[axis]);
        let first = at.floor();
        let place = |at: i64| at.rem_euclid(side) as usize;
        ([place(first as i64), place(first as i64 + 1)], (at - first) as f32)
    };
    let (([left, right], x), ([top, bottom], y)) = (along(0), along(1));
    let texel = |column: usize, row: usize| picture.texels[row * size[0] as usize + column];
    [0, 1, 2].map(|part| {
        let mix = |a: f32, b: f32, at: f32| a + (b - a) * at;
        let upper = mix(texel(left, top)[part], texel(right, top)[part], x);
        mix(upper, mix(texel(left, bottom)[part], texel(right, bottom)[part], x), y)
    })
}
