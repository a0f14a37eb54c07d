//! Slices through relief: the triangles that the geometry `slices` makes of base meshes and height maps.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_core::mesh::Mesh;
use relief_mesh::{
    SliceAnchor, SliceDirection as Slicing, SliceError, SliceSettings, SliceVertex, Slicer, Watch,
};
use relief_shaders::cpu::{Corner, Shell};
use relief_shaders::slice::{SliceDirection, Slices};

use crate::displaced::{BYTES_PER_TRIANGLE, BYTES_PER_VERTEX, GeometryError, corner};
use crate::scene::Scene;
use crate::triangles::Triangles;

/// What makes slices fewer.
pub const FEWER: &str = "a smaller 'slices.count'";

/// The slices of a scene.
pub fn settings(Slices { count, direction, with_eye }: Slices, scene: &Scene) -> SliceSettings {
    let camera = *scene.camera();
    let anchor = if with_eye { SliceAnchor::Eye } else { SliceAnchor::Object };
    let direction = match direction {
        SliceDirection::Auto => Slicing::Facing(camera),
        SliceDirection::A => Slicing::Surface,
        SliceDirection::B => Slicing::AcrossU,
        SliceDirection::C => Slicing::AcrossV,
        SliceDirection::Screen => Slicing::Screen(camera, anchor),
    };
    SliceSettings { count, direction }
}

/// Slices and the memory that they take, of which there are so many bytes left; the error is none where
/// it was cancelled.
pub fn triangles(
    mesh: &Mesh,
    map: &HeightMap,
    settings: SliceSettings,
    left: u64,
    watch: &Watch,
) -> Result<(Arc<Triangles>, u64), Option<GeometryError>> {
    let error = |error| match error {
        SliceError::Cancelled => None,
        SliceError::NotFinite => Some(GeometryError::NotFinite),
        error => Some(GeometryError::Slices(error)),
    };
    let slicer = Slicer::new(mesh, map, settings).map_err(error)?;
    let (vertices, triangles) = (slicer.vertices(), slicer.triangles());
    let [corners, faces] = [(vertices, BYTES_PER_VERTEX), (triangles, BYTES_PER_TRIANGLE)]
        .map(|(count, bytes)| count.saturating_mul(bytes));
    let needed = corners.saturating_add(faces);
    // The numbers of corners fit 32 bits.
    if needed > left || vertices > u64::from(u32::MAX) {
        return Err(Some(GeometryError::Memory { triangles, needed, left, setting: FEWER }));
    }
    let mut corners: Vec<Corner> = Vec::with_capacity(vertices as usize);
    let mut faces: Vec<[u32; 3]> = Vec::with_capacity(triangles as usize);
    let made = slicer.each(watch, |block| {
        let first = corners.len() as u32;
        corners.extend(block.vertices.iter().map(sliced));
        faces.extend(block.triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
    });
    made.map_err(error)?;
    let faces = faces.into_iter().zip(std::iter::repeat(Shell::whole()));
    Ok((Arc::new(Triangles::new(corners, faces)), needed))
}

/// A corner as the shaders have it.
fn sliced(of: &SliceVertex) -> Corner {
    Corner { of_surface: [of.height, of.step, of.axis as u32 as f32].into(), ..corner(&of.vertex) }
}
