//! Slices through the space above a base that a relief fills: triangles with a height at each
//! corner.
//!
//! Source: Kautz and Seidel 2001, *Hardware Accelerated Displacement Mapping for Image Based
//! Rendering*, section 3. The renderer draws a slice at points where the height map is as high as
//! the slice. To add a way to slice, add a file here and a variant of [`SliceDirection`].

mod boxed;
mod error;
mod orthogonal;
mod quads;
mod screen;
mod settings;
mod surface;

use glam::DVec3;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::{HeightMap, SliceAxis, Watch};

pub use self::boxed::{BoxSlice, BoxSlicer};
pub use self::error::SliceError;
use self::quads::FlatPolygon;
pub use self::settings::{SliceAnchor, SliceDirection, SliceSettings};

/// Rounding of the lengths of a mesh's tiles, as a part of the spacing of slices.
const ROUNDING: f64 = 1e-5;

/// Corner of a slice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceVertex {
    /// Corner in the world. Normal, tangents and texture coordinates are taken from the point of
    /// the base under it.
    pub vertex: Vertex,
    /// Height of the corner, from 0 to 1.
    pub height: f32,
    /// Distance to the next slice along `axis`, in the units of that axis.
    pub step: f32,
    /// Axis of the slice, the same for all its corners.
    pub axis: SliceAxis,
}

/// Some slices, or parts of slices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SliceBlock {
    /// Corners of all triangles.
    pub vertices: Vec<SliceVertex>,
    /// Triangles as indices into `vertices`.
    pub triangles: Vec<[u32; 3]>,
}

/// Slices of a mesh under a height map.
///
/// ```
/// use relief_core::{HeightMap, Watch, Wrap, mesh::torus};
/// use relief_mesh::{SliceDirection, SliceSettings, Slicer};
///
/// let map = HeightMap::from_fn(64, 32, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
/// let map = map.with_displacement(0.02, 0.0)?;
/// let base = torus(16, 8)?;
/// let slicer = Slicer::new(&base, &map, SliceSettings { count: 20, direction: SliceDirection::Surface })?;
/// let mut triangles = 0;
/// slicer.each(&Watch::none(), |block| triangles += block.triangles.len() as u64)?;
/// assert_eq!((triangles, slicer.triangles()), (20 * 256, 20 * 256));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Slicer<'a> {
    base: &'a Mesh,
    direction: SliceDirection,
    /// Metres between the heights 0 and 1, and displacement of height 0.
    scale_m: f64,
    bias_m: f64,
    /// Number of slices between the heights 0 and 1.
    layers: u64,
    /// Distance between slices of constant `u` and `v`.
    step_uv: [f64; 2],
    /// Distance between slices of constant depth, in metres.
    spacing_m: f64,
    /// Number of the first vertex at the same position, for every vertex, where triangles are cut
    /// by depth.
    welded: Vec<u32>,
    /// Polygons whose slices are clipped by a texture's border.
    polygons: Vec<FlatPolygon>,
    vertices: u64,
    triangles: u64,
}

impl<'a> Slicer<'a> {
    /// Creates the slices of a base through the displacement of a height map.
    ///
    /// # Errors
    ///
    /// Fails if all slices would lie in one place, because there is no displacement, or no texture
    /// that defines their spacing. Fails if slices need a border of a texture that clips them, and
    /// there is none.
    pub fn new(base: &'a Mesh, map: &HeightMap, settings: SliceSettings) -> Result<Self, SliceError> {
        let SliceSettings { count, direction } = settings;
        let (scale_m, size) = (map.scale_m(), [map.width(), map.height()].map(f64::from));
        let tile_m = base.tile_m();
        let texel_m = (tile_m[0] / size[0]).min(tile_m[1] / size[1]);
        let is_length = |length: f64| length > 0.0 && length.is_finite();
        let (layers, spacing_m, step_uv) = match count {
            0 if !is_length(texel_m) => return Err(SliceError::NoSpacing),
            0 => ((scale_m / texel_m - ROUNDING).ceil().max(1.0) as u64, texel_m, size.map(f64::recip)),
            count => {
                let spacing_m = scale_m / f64::from(count);
                (u64::from(count), spacing_m, tile_m.map(|tile_m| spacing_m / tile_m))
            }
        };
        let steps = [step_uv[0], step_uv[1], spacing_m];
        if direction != SliceDirection::Surface && !steps.into_iter().all(is_length) {
            return Err(SliceError::NoSpacing);
        }
        let bias_m = map.bias_m();
        let (vertices, triangles) = (0, 0);
        let polygons = match direction {
            SliceDirection::Quads(..) => FlatPolygon::all_of(base, map)?,
            _ => Vec::new(),
        };
        let is_cut = matches!(direction, SliceDirection::Screen(..));
        let welded = if is_cut { base.welded() } else { Vec::new() };
        let slicer = Self {
            base,
            direction,
            scale_m,
            bias_m,
            layers,
            step_uv,
            spacing_m,
            welded,
            polygons,
            vertices,
            triangles,
        };
        let (vertices, triangles) = slicer.counted();
        Ok(Self { vertices, triangles, ..slicer })
    }

    /// Returns an upper bound on the number of corners.
    pub fn vertices(&self) -> u64 {
        self.vertices
    }

    /// Returns an upper bound on the number of triangles.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// Returns upper bounds on the numbers of corners and triangles.
    fn counted(&self) -> (u64, u64) {
        if self.direction == SliceDirection::Surface {
            let of = |count: usize| self.layers.saturating_mul(count as u64);
            return (of(self.base.vertices().len()), of(self.base.triangles().len()));
        }
        self.numbers().fold((0, 0), |(vertices, triangles): (u64, u64), number| {
            let (slices, [corners, faces]) = match self.direction_at(number) {
                SliceDirection::AcrossU => (self.lines(number, 0), [4, 2]),
                SliceDirection::AcrossV => (self.lines(number, 1), [4, 2]),
                SliceDirection::Screen(camera, anchor) => (self.planes(number, &camera, anchor), [12, 6]),
                SliceDirection::Quads(camera, anchor) => (self.quads(number, &camera, anchor), [4, 2]),
                _ => (self.layers, [3, 1]),
            };
            let add = |sum: u64, each: u64| sum.saturating_add(slices.saturating_mul(each));
            (add(vertices, corners), add(triangles, faces))
        })
    }

    /// Calls `take` with all slices, block by block, always in the same order. The triangles of a
    /// block refer to its own corners.
    ///
    /// # Errors
    ///
    /// Fails when cancelled, or if a corner lies beyond the range of `f32`.
    pub fn each(&self, watch: &Watch, mut take: impl FnMut(&SliceBlock)) -> Result<(), SliceError> {
        let is_whole = self.direction == SliceDirection::Surface;
        let count = if is_whole { self.layers } else { u64::from(self.numbers().end) };
        for number in 0..count {
            watch.check()?;
            let block = if is_whole { self.of_surface(number + 1)? } else { self.of_part(number as u32)? };
            take(&block);
            watch.at((number + 1) as f32 / count as f32)?;
        }
        Ok(())
    }

    /// Returns the numbers of the parts of the base over which slices are made one by one:
    /// triangles or flat polygons.
    fn numbers(&self) -> std::ops::Range<u32> {
        let is_flat = matches!(self.direction, SliceDirection::Quads(..));
        let count = if is_flat { self.polygons.len() } else { self.base.triangles().len() };
        0..count as u32
    }

    /// Returns the slices over a part of the base.
    fn of_part(&self, number: u32) -> Result<SliceBlock, SliceError> {
        let mut block = SliceBlock::default();
        match self.direction_at(number) {
            SliceDirection::AcrossU => self.across(number, 0, &mut block)?,
            SliceDirection::AcrossV => self.across(number, 1, &mut block)?,
            SliceDirection::Screen(camera, anchor) => self.facing(number, &camera, anchor, &mut block)?,
            SliceDirection::Quads(camera, anchor) => self.bordered(number, &camera, anchor, &mut block)?,
            _ => self.along(number, &mut block)?,
        }
        Ok(block)
    }

    /// Returns the direction of the slices over a triangle. If directions may differ between
    /// triangles, it is the one whose planes face the camera most.
    fn direction_at(&self, number: u32) -> SliceDirection {
        let SliceDirection::Facing(camera) = self.direction else { return self.direction };
        let corners = self.base.corners(number);
        let mean = |of: fn(&Vertex) -> glam::Vec3| {
            corners.iter().map(|corner| of(corner).as_dvec3()).sum::<DVec3>() / 3.0
        };
        let (normal, tangent, bitangent) = (mean(|v| v.normal), mean(|v| v.tangent), mean(|v| v.bitangent));
        let middle = mean(|v| v.position) + normal * (self.bias_m + 0.5 * self.scale_m);
        let view = if camera.is_orthographic() { camera.forward() } else { middle - camera.eye() };
        let faces = |normal: DVec3| normal.normalize_or_zero().dot(view).abs();
        let [a, b, c] = [normal, bitangent.cross(normal), normal.cross(tangent)].map(faces);
        if a >= b.max(c) {
            SliceDirection::Surface
        } else if b >= c {
            SliceDirection::AcrossU
        } else {
            SliceDirection::AcrossV
        }
    }

    /// Returns the corner at a height over a point of the base.
    fn corner(
        &self,
        base: &Vertex,
        height: f64,
        step: f64,
        axis: SliceAxis,
    ) -> Result<SliceVertex, SliceError> {
        let metres = self.bias_m + self.scale_m * height;
        let position = (base.position.as_dvec3() + base.normal.as_dvec3() * metres).as_vec3();
        if !position.is_finite() {
            return Err(SliceError::NotFinite);
        }
        let vertex = Vertex { position, ..*base };
        Ok(SliceVertex { vertex, height: height as f32, step: step as f32, axis })
    }
}

impl SliceBlock {
    /// Adds a convex polygon.
    fn push(&mut self, corners: &[SliceVertex]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend_from_slice(corners);
        self.triangles.extend((2..corners.len() as u32).map(|k| [first, first + k - 1, first + k]));
    }
}

/// Returns the point between two vertices of the base, at `part` of the way. Nothing is normalised.
/// From either end it has the same bits.
fn between(a: &Vertex, b: &Vertex, part: f64) -> Vertex {
    let key = |vertex: &Vertex| vertex.position.to_array().map(f32::to_bits);
    let (a, b, part) = if key(a) <= key(b) { (a, b, part) } else { (b, a, 1.0 - part) };
    let mixed = |a: glam::Vec3, b: glam::Vec3| a.as_dvec3().lerp(b.as_dvec3(), part).as_vec3();
    Vertex {
        position: mixed(a.position, b.position),
        normal: mixed(a.normal, b.normal),
        tangent: mixed(a.tangent, b.tangent),
        bitangent: mixed(a.bitangent, b.bitangent),
        uv: a.uv.as_dvec2().lerp(b.uv.as_dvec2(), part).as_vec2(),
    }
}

#[cfg(test)]
mod tests;
