//! Volumes of closed meshes.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use relief_core::mesh::RawMesh;
use relief_core::{Volume, Watch, Wrap};

use super::closest::squared_distance;
use super::columns::{Crossing, Line};
use super::faces::{Corner, Faces, STEPS};
use super::{Fit, REACH, VolumesError, by_rows};

/// Copies of triangles in other tiles that are always accepted.
const MOST_COPIES: usize = 1 << 22;

/// What counts as inside of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Solid {
    /// Where a line from above has entered more often than left, by the faces' sides. Parts that
    /// overlap are one solid.
    Winding,
    /// Where a line from above has crossed an odd number of faces, whichever way they look.
    Parity,
}

impl Solid {
    /// Returns the name of this rule: `winding` or `parity`.
    pub const fn name(self) -> &'static str {
        match self {
            Solid::Winding => "winding",
            Solid::Parity => "parity",
        }
    }
}

/// Settings for the volume of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshVolumeSettings {
    /// Columns, rows and slices.
    pub size: [u32; 3],
    /// Continuation beyond the edges. With [`Wrap::Repeat`], parts beyond the tile's edges come back
    /// on the other side; otherwise they are cut off.
    pub wrap: Wrap,
    /// Place of the mesh in the tile.
    pub fit: Fit,
    /// Empty voxels between the mesh and each side of the tile; with [`Fit::Tile`] below and above it.
    pub margin: f64,
    /// Lengths of the tile along `u` and `v` in metres.
    pub tile_m: [f64; 2],
    /// Distance from the surface in voxels at which values reach 0 and 1, above 0 and at most 8.
    pub reach: f64,
    /// What counts as inside. Default: winding for meshes whose faces agree on their sides, parity
    /// for others.
    pub solid: Option<Solid>,
}

impl MeshVolumeSettings {
    /// Most memory in bytes for a voxel, with the result.
    pub const BYTES_PER_VOXEL: u64 = 16;

    /// Most memory in bytes for a triangle.
    pub const BYTES_PER_TRIANGLE: u64 = 900;

    /// Creates the default settings for a volume of `size`: repeated, proportions kept, a margin of
    /// a voxel, a tile of 1 m, and values that reach 0 and 1 at [`REACH`].
    pub fn new(size: [u32; 3]) -> Self {
        Self {
            size,
            wrap: Wrap::Repeat,
            fit: Fit::Keep,
            margin: 1.0,
            tile_m: [1.0; 2],
            reach: REACH,
            solid: None,
        }
    }
}

/// Volume of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshVolume {
    /// The volume. Its scale is the length of its height in metres of the tile. With [`Fit::Tile`]
    /// scale and bias are those that put a height of the mesh at as many metres.
    pub volume: Volume,
    /// What counted as inside.
    pub solid: Solid,
    /// Triangles of the mesh.
    pub triangles: u64,
    /// Edges with an odd number of triangles. The mesh is closed if there are none.
    pub open_edges: u64,
    /// Other edges whose triangles do not agree on which side is outside.
    pub turned_edges: u64,
    /// Triangles that lie on another one that looks the other way, also in the next tile. They are
    /// inside the solid, and no surface.
    pub doubled: u64,
    /// Columns of voxels whose line crosses an odd number of faces: where the mesh is open. Below the
    /// last face they are solid.
    pub odd_columns: u64,
    /// Triangles that reach below height 0 or above height 1, which are cut off there.
    pub beyond: u64,
    /// Share of the mesh's area, from 0 to 1 and measured in voxels, on parts so thin that the volume is
    /// empty half a voxel behind the surface. Such parts have holes or are missing.
    pub thin: f64,
}

/// Computes the volume of a closed mesh: ½ less the signed distance to its faces in voxels, divided
/// by twice the [`reach`](MeshVolumeSettings::reach) and clamped to `[0, 1]`.
///
/// Inside and outside are exact for the mesh whose corners are rounded to 2^-24 of the tile.
/// Distances are rounded like `f64`. The result has the same bytes with any number of threads.
///
/// ```
/// use relief_bake::volumes::{MeshVolumeSettings, volume_from_mesh};
/// use relief_core::Watch;
/// use relief_core::mesh::{RawCorner, RawMesh};
/// use glam::Vec3;
///
/// // A tetrahedron.
/// let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
/// let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let corner = |position| RawCorner { position, normal: RawCorner::NONE, uv: RawCorner::NONE };
/// let triangles = faces.map(|face| face.map(corner)).to_vec();
/// let mesh = RawMesh { positions, triangles, ..RawMesh::default() };
/// let made = volume_from_mesh(&mesh, &MeshVolumeSettings::new([32, 32, 32]), &Watch::none())?;
/// assert_eq!(made.open_edges, 0);
/// assert!(made.volume.value_at([0.15, 0.15, 0.15]) == 1.0 && made.volume.value_at([0.8, 0.8, 0.8]) == 0.0);
/// # Ok::<(), relief_bake::volumes::VolumesError>(())
/// ```
///
/// # Errors
///
/// When the size is invalid, a setting is outside its range, or the mesh has no triangles or numbers
/// that cannot be used; when it is flat, reaches more than [`MAX_TILES`](super::MAX_TILES) tiles, or
/// lies outside of the heights 0 to 1; or when it is cancelled.
pub fn volume_from_mesh(
    mesh: &RawMesh,
    settings: &MeshVolumeSettings,
    watch: &Watch,
) -> Result<MeshVolume, VolumesError> {
    let MeshVolumeSettings { size, wrap, fit, margin, tile_m, reach, solid } = *settings;
    Volume::check_size(size)?;
    let bad = |what, value, must| Err(VolumesError::BadSetting { what, value, must });
    if !(margin >= 0.0 && margin.is_finite()) {
        return bad("the margin", margin, "0 or more voxels");
    }
    if !(reach > 0.0 && reach <= 8.0) {
        return bad("the reach", reach, "above 0 and at most 8 voxels");
    }
    if let Some(side) = tile_m.into_iter().find(|side| !(*side > 0.0 && side.is_finite())) {
        return bad("a side of the tile", side, "finite and above 0");
    }
    let corners: Vec<_> = mesh.triangle_positions()?.collect();
    let (placed, [scale_m, bias_m]) = fit.place(&corners, size, margin, tile_m)?;
    drop(corners);
    watch.at(0.02)?;
    let repeats = wrap == Wrap::Repeat;
    let beyond = placed
        .iter()
        .filter(|corners| corners.iter().any(|at| !(-1e-6..=1.0 + 1e-6).contains(&at.z)))
        .count() as u64;
    let triangles = placed.len() as u64;
    let faces = Faces::new(&placed, repeats);
    drop(placed);
    watch.at(0.1)?;
    let agrees = faces.open_edges == 0 && faces.turned_edges == 0;
    let solid = solid.unwrap_or(if agrees { Solid::Winding } else { Solid::Parity });
    let grid = Grid { faces: &faces, size, reach, solid };
    let copies = grid.copies(repeats)?;
    let buckets = grid.buckets(&copies);
    let odd_columns = AtomicU64::new(0);
    let volume = by_rows(size, wrap, &watch.piece(0.15, 1.0), |row, values| {
        let odd = grid.fill(row, buckets[row as usize].iter().map(|at| &copies[*at as usize]), values);
        odd_columns.fetch_add(odd, Ordering::Relaxed);
    })?;
    let thin = grid.thin_part(&volume);
    let volume = volume.with_displacement(scale_m, bias_m)?;
    Ok(MeshVolume {
        volume,
        thin,
        solid,
        triangles,
        open_edges: faces.open_edges,
        turned_edges: faces.turned_edges,
        doubled: faces.doubled,
        odd_columns: odd_columns.into_inner(),
        beyond,
    })
}

/// Voxels behind the surface at which a part of the mesh must be solid not to count as thin. More, and
/// parts count that are seen well; fewer, and parts with holes do not.
const HALF_VOXEL: f64 = 0.5;

/// A triangle moved by whole tiles.
struct Copy {
    triangle: u32,
    tiles: [i64; 2],
}

/// Voxels that are filled.
struct Grid<'a> {
    faces: &'a Faces,
    size: [u32; 3],
    reach: f64,
    solid: Solid,
}

impl Grid<'_> {
    /// Returns a corner in voxels: whole numbers are voxels' centres.
    fn in_voxels(&self, corner: Corner, tiles: [i64; 2]) -> DVec3 {
        let tiles = [tiles[0], tiles[1], 0];
        DVec3::from_array([0, 1, 2].map(|axis| {
            let at = (corner[axis] + tiles[axis] * STEPS) as f64 / STEPS as f64;
            at * f64::from(self.size[axis]) - 0.5
        }))
    }

    /// Returns the copies of all triangles that reach the tile.
    fn copies(&self, repeats: bool) -> Result<Vec<Copy>, VolumesError> {
        let mut copies = Vec::new();
        for (triangle, corners) in (0u32..).zip(&self.faces.triangles) {
            let [along_u, along_v] = [0, 1].map(|axis| {
                if !repeats {
                    return 0..=0;
                }
                let all = corners.map(|corner| corner[axis] as f64 / STEPS as f64);
                let [least, greatest] = [
                    all.iter().copied().fold(f64::MAX, f64::min),
                    all.iter().copied().fold(f64::MIN, f64::max),
                ];
                let reach = (self.reach + 1.0) / f64::from(self.size[axis]);
                (-(greatest + reach).floor()) as i64..=(1.0 - (least - reach)).floor() as i64
            });
            for v in along_v {
                copies.extend(along_u.clone().map(|u| Copy { triangle, tiles: [u, v] }));
            }
            if copies.len() > MOST_COPIES.max(4 * self.faces.triangles.len()) {
                return Err(VolumesError::TooManyCopies);
            }
        }
        Ok(copies)
    }

    fn voxels(&self, copy: &Copy) -> [DVec3; 3] {
        self.faces.triangles[copy.triangle as usize].map(|corner| self.in_voxels(corner, copy.tiles))
    }

    /// Returns for each row the copies that reach it.
    fn buckets(&self, copies: &[Copy]) -> Vec<Vec<u32>> {
        let mut buckets = vec![Vec::new(); self.size[1] as usize];
        for (at, copy) in (0u32..).zip(copies) {
            let corners = self.voxels(copy);
            let [columns, rows] = [0, 1].map(|axis| self.near(&corners, axis));
            if columns.is_empty() {
                continue;
            }
            for bucket in &mut buckets[rows] {
                bucket.push(at);
            }
        }
        buckets
    }

    /// Returns the voxels along an axis that a triangle may reach.
    fn near(&self, corners: &[DVec3; 3], axis: usize) -> std::ops::Range<usize> {
        let least = corners.iter().map(|at| at[axis]).fold(f64::MAX, f64::min) - self.reach - 1e-6;
        let greatest = corners.iter().map(|at| at[axis]).fold(f64::MIN, f64::max) + self.reach + 1e-6;
        let side = f64::from(self.size[axis]);
        let (first, end) = (least.ceil().clamp(0.0, side), (greatest.floor() + 1.0).clamp(0.0, side));
        first as usize..(end as usize).max(first as usize)
    }

    /// Returns the part of the area, in voxels, on whose inner side the volume is empty half a voxel
    /// behind the surface. Which side is the inner one does not matter: both are looked at.
    fn thin_part(&self, volume: &Volume) -> f64 {
        let [mut thin, mut all] = [0.0; 2];
        for triangle in &self.faces.triangles {
            let [a, b, c] = triangle.map(|corner| self.in_voxels(corner, [0; 2]));
            let across = (b - a).cross(c - a);
            let (area, middle) = (across.length(), (a + b + c) / 3.0);
            let top = f64::from(self.size[2]) - 0.5;
            if area > 0.0 && (-0.5..=top).contains(&middle.z) {
                let beside = across * (HALF_VOXEL / area);
                let is_solid = |at: DVec3| {
                    let place = [0, 1, 2].map(|axis| (at[axis] + 0.5) / f64::from(self.size[axis]));
                    volume.value_at(place) >= Volume::SURFACE
                };
                all += area;
                thin += if is_solid(middle + beside) || is_solid(middle - beside) { 0.0 } else { area };
            }
        }
        if all > 0.0 { thin / all } else { 0.0 }
    }

    /// Fills a row of all slices. Returns the number of columns with an odd number of crossings.
    fn fill<'a>(&self, row: u32, copies: impl Iterator<Item = &'a Copy>, values: &mut [f32]) -> u64 {
        let [width, rows, _] = self.size;
        let mut nearest = vec![self.reach * self.reach; values.len()];
        let mut crossings: Vec<Vec<Crossing>> = vec![Vec::new(); width as usize];
        for copy in copies {
            let corners = self.voxels(copy);
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
            let (columns, slices) = (self.near(&corners, 0), self.near(&corners, 2));
            for column in columns {
                let triangle = &self.faces.triangles[copy.triangle as usize];
                crossings[column]
                    .extend(Line::new([column as u32, row], [width, rows], copy.tiles).crossing(triangle));
                for slice in slices.clone() {
                    let at = DVec3::new(column as f64, f64::from(row), slice as f64);
                    if normal.dot(at - corners[0]).abs() <= self.reach + 1e-6 {
                        let nearest = &mut nearest[slice * width as usize + column];
                        *nearest = nearest.min(squared_distance(at, corners));
                    }
                }
            }
        }
        let mut odd = 0;
        for (column, crossings) in crossings.iter_mut().enumerate() {
            odd += u64::from(crossings.len() % 2 == 1);
            self.sign(column, crossings, &nearest, values);
        }
        odd
    }

    /// Sets the values of a column from its crossings and distances, from the highest voxel down.
    fn sign(&self, column: usize, crossings: &mut [Crossing], nearest: &[f64], values: &mut [f32]) {
        let [width, _, slices] = self.size;
        crossings.sort_by(|a, b| b.height.total_cmp(&a.height));
        let (mut next, mut winding, mut count) = (0, 0, 0);
        for slice in (0..slices).rev() {
            let centre = (f64::from(slice) + 0.5) / f64::from(slices) * STEPS as f64;
            while let Some(crossing) = crossings.get(next).filter(|crossing| crossing.height > centre) {
                winding += crossing.side;
                count += 1;
                next += 1;
            }
            let is_inside = match self.solid {
                Solid::Winding => winding != 0,
                Solid::Parity => count % 2 == 1,
            };
            let at = (slice * width) as usize + column;
            let part = 0.5 * nearest[at].sqrt() / self.reach;
            values[at] = (if is_inside { 0.5 + part } else { 0.5 - part }).clamp(0.0, 1.0) as f32;
        }
    }
}
