//! Slices at equal depths from a camera as quads of one size, which the border of the texture
//! clips.
//!
//! Source: Kautz and Seidel 2001, section 3.3. Over a flat polygon one matrix maps positions to
//! texture coordinates and heights. So a quad may be larger than the space of the relief: beside
//! the texture, below height 0 and above height 1 nothing is drawn.

use glam::{DMat3, DVec2, DVec3, Vec3};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::{HeightMap, SliceAxis, Wrap};

use super::{SliceAnchor, SliceBlock, SliceError, SliceVertex, Slicer};

/// Greatest number of flat polygons of a mesh.
const MOST_POLYGONS: usize = 256;

/// Tolerance for the corners of one polygon, as a part of the polygon. Also the tolerance for the
/// area of the map that they show, as a part of the map.
const APART: f64 = 1e-4;

/// Flat polygon that shows the whole map once.
#[derive(Clone, Debug)]
pub(super) struct FlatPolygon {
    /// Point of the base at texture coordinates 0.
    at_zero: Vertex,
    /// Columns: the way to the end of the texture along `u`, the way along `v`, and a metre along
    /// the normal.
    of_texture: DMat3,
    /// Part of the texture that triangles have shown so far.
    shown: f64,
}

impl FlatPolygon {
    /// Returns all polygons of a mesh.
    pub(super) fn all_of(mesh: &Mesh, map: &HeightMap) -> Result<Vec<Self>, SliceError> {
        let mut polygons: Vec<Self> = Vec::new();
        for number in 0..mesh.triangles().len() as u32 {
            let corners = mesh.corners(number);
            let polygon = Self::of(corners[0]);
            let is_whole = corners.iter().all(|corner| {
                let on_map = |uv: f32| (-APART..=1.0 + APART).contains(&f64::from(uv));
                on_map(corner.uv.x) && on_map(corner.uv.y) && polygon.is_of(corner)
            });
            // The last polygon first: its triangles often come one after another.
            let known = polygons.iter().rposition(|known| known.is_of(corners[0]));
            if !is_whole || (known.is_none() && polygons.len() == MOST_POLYGONS) {
                return Err(SliceError::NoBorder);
            }
            let place = known.unwrap_or(polygons.len());
            if known.is_none() {
                polygons.push(polygon);
            }
            let [a, b, c] = corners.map(|corner| corner.uv.as_dvec2());
            polygons[place].shown += 0.5 * DVec2::perp_dot(b - a, c - a).abs();
        }
        let is_right = |polygon: &Self| {
            (polygon.shown - 1.0).abs() <= APART && polygon.of_texture.determinant().abs() > 0.0
        };
        let is_clipped = map.wrap() == Wrap::Clamp && polygons.iter().all(is_right);
        if is_clipped { Ok(polygons) } else { Err(SliceError::NoBorder) }
    }

    fn of(corner: &Vertex) -> Self {
        let [u, v] = corner.uv.as_dvec2().to_array();
        let [tangent, bitangent, normal] =
            [corner.tangent, corner.bitangent, corner.normal].map(|axis| axis.as_dvec3());
        let position = corner.position.as_dvec3() - tangent * u - bitangent * v;
        let at_zero = Vertex { position: position.as_vec3(), uv: glam::Vec2::ZERO, ..*corner };
        Self { at_zero, of_texture: DMat3::from_cols(tangent, bitangent, normal), shown: 0.0 }
    }

    /// Returns whether a corner of the base belongs to this polygon.
    fn is_of(&self, corner: &Vertex) -> bool {
        let (own, other) = (&self.at_zero, Self::of(corner).at_zero);
        let side = own.tangent.length().max(own.bitangent.length()).max(own.position.length());
        let is_near = |a: Vec3, b: Vec3, of: f32| f64::from(a.distance(b)) <= APART * f64::from(of);
        is_near(own.position, other.position, side)
            && is_near(own.tangent, other.tangent, side)
            && is_near(own.bitangent, other.bitangent, side)
            && is_near(own.normal, other.normal, 1.0)
    }

    /// Returns the corners of the space that the relief fills over the polygon.
    fn space(&self, bias_m: f64, scale_m: f64) -> [DVec3; 8] {
        std::array::from_fn(|place| {
            let [u, v, height] = [0, 1, 2].map(|axis| f64::from(u8::from(place >> axis & 1 == 1)));
            let texture = DVec3::new(u, v, bias_m + scale_m * height);
            self.at_zero.position.as_dvec3() + self.of_texture * texture
        })
    }
}

impl Slicer<'_> {
    /// Returns an upper bound on the number of quads over a polygon.
    pub(super) fn quads(&self, number: u32, camera: &Camera, anchor: SliceAnchor) -> u64 {
        let space = self.polygons[number as usize].space(self.bias_m, self.scale_m);
        let depths = space.map(|place| camera.forward().dot(place - camera.eye()));
        self.planes_between(depths, Self::first_depth(camera, anchor)).1
    }

    /// Adds the quads over a polygon. All have one size, which covers the space of the relief in
    /// the picture.
    pub(super) fn bordered(
        &self,
        number: u32,
        camera: &Camera,
        anchor: SliceAnchor,
        block: &mut SliceBlock,
    ) -> Result<(), SliceError> {
        let polygon = &self.polygons[number as usize];
        let space = polygon.space(self.bias_m, self.scale_m);
        let along = |axis: DVec3| {
            let places = space.map(|place| axis.dot(place - camera.eye()));
            [f64::min, f64::max].map(|of| places.into_iter().fold(places[0], of))
        };
        let ([left, right], [bottom, top]) = (along(camera.right()), along(camera.up()));
        let start = Self::first_depth(camera, anchor);
        let depths = space.map(|place| camera.forward().dot(place - camera.eye()));
        let (before, count) = self.planes_between(depths, start);
        let to_texture = polygon.of_texture.inverse();
        for plane in 1..=count {
            let depth = start + (before + plane as f64) * self.spacing_m;
            let corner = |across: f64, upward: f64| {
                let position =
                    camera.eye() + camera.forward() * depth + camera.right() * across + camera.up() * upward;
                let texture = to_texture * (position - polygon.at_zero.position.as_dvec3());
                let height = ((texture.z - self.bias_m) / self.scale_m) as f32;
                let (position, uv) = (position.as_vec3(), texture.truncate().as_vec2());
                if !(position.is_finite() && uv.is_finite() && height.is_finite()) {
                    return Err(SliceError::NotFinite);
                }
                let vertex = Vertex { position, uv, ..polygon.at_zero };
                Ok(SliceVertex { vertex, height, step: self.spacing_m as f32, axis: SliceAxis::Depth })
            };
            block.push(&[
                corner(left, bottom)?,
                corner(right, bottom)?,
                corner(right, top)?,
                corner(left, top)?,
            ]);
        }
        Ok(())
    }
}
