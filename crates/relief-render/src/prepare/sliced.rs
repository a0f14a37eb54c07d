//! Slices through relief, which the geometry `slices` makes from base meshes and height maps, and
//! slices through objects, which `object-slices` makes from the box around them.

use std::sync::Arc;

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::object::ImageObject;
use relief_core::{HeightMap, Watch};
use relief_mesh::{
    BoxSlice, BoxSlicer, SliceAnchor, SliceDirection as Slicing, SliceError, SliceSettings, SliceVertex,
    Slicer,
};
use relief_shaders::cpu::{Corner, Shell};
use relief_shaders::slice::{SliceDirection, Slices};

use super::displaced::{BYTES_PER_TRIANGLE, BYTES_PER_VERTEX, GeometryError, corner};
use crate::prepare::Triangles;
use relief_scene::Scene;

/// Bytes of a slice through a box, with six corners.
const BYTES_PER_SLICE: u64 = 6 * 24 + 24;

/// Setting that makes fewer slices.
pub const FEWER: &str = "a smaller 'slices.count'";

/// Returns the settings of slices for the camera of a scene.
pub fn settings(slices: Slices, scene: &Scene) -> SliceSettings {
    let Slices { count, direction, with_eye, by_border } = slices;
    let camera = *scene.camera();
    let anchor = if with_eye { SliceAnchor::Eye } else { SliceAnchor::Object };
    let direction = match direction {
        SliceDirection::Auto => Slicing::Facing(camera),
        SliceDirection::A => Slicing::Surface,
        SliceDirection::B => Slicing::AcrossU,
        SliceDirection::C => Slicing::AcrossV,
        SliceDirection::Screen if by_border => Slicing::Quads(camera, anchor),
        SliceDirection::Screen => Slicing::Screen(camera, anchor),
    };
    SliceSettings { count, direction }
}

/// Returns the triangles of slices through a relief, and the bytes that they take. `left` is the
/// number of bytes that they may take.
pub fn triangles(
    mesh: &Mesh,
    map: &HeightMap,
    settings: SliceSettings,
    left: u64,
    watch: &Watch,
) -> Result<(Arc<Triangles>, u64), GeometryError> {
    let slicer = Slicer::new(mesh, map, settings).map_err(error)?;
    let mut buffer = TriangleBuffer::of(slicer.vertices(), slicer.triangles(), left)?;
    let made = slicer.each(watch, |block| {
        buffer.take(block.vertices.iter().map(sliced), &block.triangles);
    });
    made.map_err(error)?;
    let (triangles, needed) = buffer.triangles();
    Ok((Arc::new(triangles), needed))
}

/// Returns the triangles of slices through an object, and the bytes that they take. `mesh` is the
/// box around the object. With a camera the slices are sorted from front to back.
pub fn triangles_of_object(
    mesh: &Mesh,
    object: &ImageObject,
    (SliceSettings { count, direction }, camera): (SliceSettings, Option<Camera>),
    left: u64,
    watch: &Watch,
) -> Result<(Arc<Triangles>, u64), GeometryError> {
    let ball_m = 2.0 * object.views().first().map_or(0.0, |view| view.ball().1);
    let spacing_m = if count == 0 { object.jump_of(1.0) * ball_m } else { ball_m / f64::from(count) };
    let places = || mesh.vertices().iter().map(|vertex| vertex.position.as_dvec3());
    let bounds = [places().fold(DVec3::INFINITY, DVec3::min), places().fold(DVec3::NEG_INFINITY, DVec3::max)];
    let slicer = BoxSlicer::new(bounds, spacing_m, direction).map_err(error)?;
    let most = |each: u64| slicer.slices().saturating_mul(each);
    // Sorted slices are held until all of them are there.
    let held = if camera.is_some() { most(BYTES_PER_SLICE) } else { 0 };
    let mut buffer = TriangleBuffer::of(most(6), most(4), left.saturating_sub(held))?;
    let mut ends = Vec::with_capacity(slicer.slices() as usize);
    let mut take = |slice: &BoxSlice| {
        let at = |position: &DVec3| Vertex { position: position.as_vec3(), ..mesh.vertices()[0] };
        let faces: Vec<[u32; 3]> = (2..slice.len() as u32).map(|k| [0, k - 1, k]).collect();
        buffer.take(slice.iter().map(|position| corner(&at(position))), &faces);
        ends.push(buffer.faces.len() as u32);
    };
    match camera {
        None => slicer.each(watch, take).map_err(error)?,
        Some(camera) => {
            let mut slices = Vec::with_capacity(slicer.slices() as usize);
            slicer.each(watch, |slice| slices.push(slice.clone())).map_err(error)?;
            let off = |slice: &BoxSlice| slicer.distance_m(&slice[0], &camera);
            slices.sort_by(|one, other| off(one).total_cmp(&off(other)));
            slices.iter().for_each(&mut take);
        }
    }
    let (triangles, needed) = buffer.triangles();
    Ok((Arc::new(triangles.in_slices(ends)), needed))
}

fn error(error: SliceError) -> GeometryError {
    match error {
        SliceError::Cancelled(cancelled) => cancelled.into(),
        SliceError::NotFinite => GeometryError::NotFinite,
        error => GeometryError::Slices(error),
    }
}

/// Growing list of triangles, and the bytes that they take.
struct TriangleBuffer {
    corners: Vec<Corner>,
    faces: Vec<[u32; 3]>,
    needed: u64,
}

impl TriangleBuffer {
    /// Allocates memory for at most the given numbers of vertices and triangles. Fails if it takes
    /// more than `left` bytes.
    fn of(vertices: u64, triangles: u64, left: u64) -> Result<Self, GeometryError> {
        let [corners, faces] = [(vertices, BYTES_PER_VERTEX), (triangles, BYTES_PER_TRIANGLE)]
            .map(|(count, bytes)| count.saturating_mul(bytes));
        let needed = corners.saturating_add(faces);
        // The numbers of corners fit 32 bits.
        if needed > left || vertices > u64::from(u32::MAX) {
            return Err(GeometryError::Memory { triangles, needed, left, setting: FEWER });
        }
        let (corners, faces) =
            (Vec::with_capacity(vertices as usize), Vec::with_capacity(triangles as usize));
        Ok(Self { corners, faces, needed })
    }

    /// Appends triangles, with faces that index `corners`.
    fn take(&mut self, corners: impl Iterator<Item = Corner>, faces: &[[u32; 3]]) {
        let first = self.corners.len() as u32;
        self.corners.extend(corners);
        self.faces.extend(faces.iter().map(|face| face.map(|corner| first + corner)));
    }

    /// Returns all triangles, and the bytes that they take.
    fn triangles(self) -> (Triangles, u64) {
        let faces = self.faces.into_iter().zip(std::iter::repeat(Shell::whole()));
        (Triangles::new(self.corners, faces), self.needed)
    }
}

/// Converts a slice's vertex to a corner for the shaders.
fn sliced(of: &SliceVertex) -> Corner {
    Corner { of_surface: [of.height, of.step, of.axis as u32 as f32].into(), ..corner(&of.vertex) }
}
