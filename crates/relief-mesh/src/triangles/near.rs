//! Halving of base triangles that reach behind the eye, so that parts behind it can be left out.
//!
//! Grid space ends near the eye. All parts behind are divided as if they were there, more finely
//! than anything else. Clipping at a plane would make corners that depend on the plane, and points
//! with other bits on either side of an edge. Halves of a side depend on its ends alone.

use relief_core::mesh::Mesh;

use super::halves::{Halved, Limits, halved as halved_where};
use crate::cull::{Hull, Outside, ViewVolume};
use crate::surface::Relief;
use crate::{BaseSurface, MeshSettings, MesherError};

/// Greatest number of parts of a side that is not halved.
const PARTS: u64 = 64;

/// Number of triangles beyond which nothing is halved any further.
const TRIANGLES: usize = 1 << 20;

/// Halves the triangles that reach nearer to the eye than grid space, and may be seen, until their
/// sides have few parts. Returns `None` if there is nothing to halve. A bent base is not halved, as
/// its halves bend in other ways.
pub fn halved(
    mesh: &Mesh,
    relief: &Relief,
    parts: fn([[i32; 3]; 2]) -> u64,
    settings: &MeshSettings,
    limits: &Limits,
) -> Result<Option<Halved>, MesherError> {
    let Some((_, view)) = settings.cull.zip(settings.view) else { return Ok(None) };
    if settings.base != BaseSurface::Flat || view.camera.is_orthographic() {
        return Ok(None);
    }
    let (grid, volume) = (view.voxels()?, ViewVolume::new(&view));
    let heights = relief.levels().map(|level| level.extremes().map(f64::from));
    let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [least, greatest]| {
        [low.min(least), high.max(greatest)]
    });
    let reach_m = relief.metres(low).abs().max(relief.metres(high).abs());
    halved_where(mesh, relief, limits, |halves, triangles| {
        let position = |vertex: u32| halves.vertex(vertex).position;
        let voxel = |vertex: u32| grid.of(position(vertex).as_dvec3()).at;
        let is_near = |corners: &&[u32; 3]| {
            let places = corners.map(|vertex| position(vertex).as_dvec3());
            let [a, b, c] = places;
            let hull = Hull { points: [a, b, c, a, b, c], radius_m: reach_m };
            places.iter().any(|place| grid.is_before(*place)) && !volume.misses(&hull, &Outside::ALL)
        };
        let near = if triangles.len() > TRIANGLES.max(2 * mesh.triangles().len()) {
            Vec::new()
        } else {
            triangles.iter().filter(is_near).copied().collect()
        };
        halves.sides(&near, |ends| {
            let [a, b] = ends.map(position);
            let middle = a * 0.5 + b * 0.5;
            parts(ends.map(voxel)) > PARTS && middle != a && middle != b
        })
    })
}
