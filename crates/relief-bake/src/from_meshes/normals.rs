//! Normals of the detailed mesh in the tangent frames of the simple one.

use glam::{DMat3, DVec3};
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::Mesh;
use relief_core::raycast::RayCaster;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::charts::{Charts, OFF_BORDER, Owner};
use super::line::Line;
use super::{CAST, CHARTED, FromMeshesError, MeshPair, prepare};
use crate::fill::fill;

/// Bakes the tangent-space normal map of a detailed mesh on a simple one. Returns planes of `x`
/// along growing `u`, `y` up in the picture and `z` outward, of unit length, row by row from the
/// top.
///
/// Heights between two meshes correct the facets of the simple mesh, whose normals bend as if there
/// were no facets. Normals derived from these heights count the facets twice. The normals here are
/// the detailed mesh's own, interpolated where [`heights_from_meshes`](super::heights_from_meshes)
/// hits it. Their components are along the interpolated tangent, bitangent and normal of the simple
/// mesh, each of unit length. Shaders read them in this form (Szirmay-Kalos and Umenhoffer 2008,
/// section 2). Texels beside a chart have the normal at its border; others are filled from coarse
/// to fine.
///
/// `caster` is the prepared mesh `high`. The result has the same bytes with any number of threads.
///
/// # Errors
///
/// Fails as [`heights_from_meshes`](super::heights_from_meshes) does.
pub fn normals_from_meshes(
    low: &Mesh,
    high: &Mesh,
    caster: &RayCaster,
    pair: &MeshPair,
    watch: &Watch,
) -> Result<[Vec<f32>; 3], FromMeshesError> {
    let (charts, line) = prepare(low, caster, pair, &watch.piece(0.0, CHARTED))?;
    let watch = watch.piece(CHARTED, CAST);
    let width = charts.size[0] as usize;
    let rows = charts.owners.len() / width;
    let mut found: Vec<Option<[f32; 3]>> = vec![None; charts.owners.len()];
    let done = AtomicUsize::new(0);
    found.par_chunks_mut(width).zip(charts.owners.par_chunks(width)).try_for_each(|(row, owners)| {
        for (texel, owner) in row.iter_mut().zip(owners) {
            let normal = owner.on().and_then(|owner| normal(low, high, &charts, &line, owner));
            *texel = normal.map(|normal| normal.as_vec3().to_array());
        }
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        watch.at(done as f32 / rows as f32)
    })?;
    let known: Vec<bool> = found.iter().map(Option::is_some).collect();
    if !known.contains(&true) {
        let texels = charts.owners.iter().filter(|owner| owner.is_inside()).count() as u64;
        return Err(FromMeshesError::NothingFound { texels, cage_m: line.cage_m, behind: 0 });
    }
    let mut planes = [0, 1, 2].map(|axis| {
        let mut plane: Vec<f32> =
            found.iter().map(|normal| normal.map_or(0.0, |normal| normal[axis])).collect();
        fill(charts.size.map(|side| side as usize), &mut plane, &known);
        plane
    });
    for at in (0..known.len()).filter(|at| !known[*at]) {
        let mean = DVec3::from([0, 1, 2].map(|axis| f64::from(planes[axis][at])));
        let unit = mean.try_normalize().unwrap_or(DVec3::Z).as_vec3();
        planes.iter_mut().zip(unit.to_array()).for_each(|(plane, part)| plane[at] = part);
    }
    Ok(planes)
}

/// Returns the normal at a texel, or at the border beside it, in the frame of the simple mesh
/// there.
fn normal(low: &Mesh, high: &Mesh, charts: &Charts, line: &Line, owner: &Owner) -> Option<DVec3> {
    let place =
        if owner.is_inside() { owner.centre() } else { owner.inside(charts.nearest(low, owner), OFF_BORDER) };
    let (_, hit) = line.find(&charts.base(low, owner.triangle, place))?;
    let corners = high.corners(hit.triangle);
    let parts = corners.iter().zip(hit.weights).map(|(corner, weight)| corner.normal.as_dvec3() * weight);
    let normal = parts.sum::<DVec3>().try_normalize()?;
    let weights = charts.weights(low, owner.triangle, place);
    let corners = low.corners(owner.triangle);
    let sum = |of: [glam::Vec3; 3]| -> DVec3 {
        of.iter().zip(weights).map(|(vector, weight)| vector.as_dvec3() * weight).sum()
    };
    let tangent = sum(corners.map(|corner| corner.tangent)).try_normalize()?;
    let bitangent = sum(corners.map(|corner| corner.bitangent)).try_normalize()?;
    let outward = sum(corners.map(|corner| corner.normal)).try_normalize()?;
    // Up in the picture is along falling v.
    let frame = DMat3::from_cols(tangent, -bitangent, outward);
    (frame.determinant().abs() > 1e-6).then(|| (frame.inverse() * normal).try_normalize()).flatten()
}
