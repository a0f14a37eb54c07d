//! Vector displacement maps as motifs: a sheet of triangles whose points are moved along three axes.

use glam::{DVec3, Vec3};
use relief_core::mesh::{RawCorner, RawMesh};

/// Steps of the sheet's places along a tile. In `f32` they are exact as far as [`VectorSheet::FAR`], so the
/// sheet's images in all tiles join.
const STEPS: f64 = (1u32 << 20) as f64;

/// Room above and below the sheet, as a part of its extent, and in tiles for a level one.
const ROOM: f64 = 1.0 / 256.0;

/// Why vectors make no sheet.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum VectorSheetError {
    /// There are no vectors, or not as many as the size says.
    #[error("{vectors} vectors are not {width} x {height}")]
    Size {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Vectors.
        vectors: usize,
    },
    /// A vector is not finite or reaches too far.
    #[error(
        "the vector at ({column}, {row}) moves its point by {tiles} tiles, more than {far}",
        far = VectorSheet::FAR
    )]
    Far {
        /// Its column.
        column: u32,
        /// Its row.
        row: u32,
        /// Tiles by which it moves its point.
        tiles: f64,
    },
}

/// A sheet in the space of a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct VectorSheet {
    /// The sheet: positions `(u, height, v)` as of every motif, with smooth normals
    /// and two triangles a texel.
    pub mesh: RawMesh,
    /// What the heights 0 and 1 are, in tiles above the surface that was displaced: a little below its lowest
    /// point and a little above its highest.
    pub heights: [f64; 2],
}

impl VectorSheet {
    /// Bytes of memory for a texel, with the vector.
    pub const BYTES_PER_TEXEL: u64 = 160;

    /// Tiles by which a vector moves its point at most: fewer than [`crate::shell_map::map_shells`] takes.
    pub const FAR: f64 = 14.0;
}

/// Makes a sheet of vectors, row by row from the top of the map: parts of each along `u`, along the height
/// and along `v`, which runs down the map, all in tiles.
///
/// A point lies at each texel's centre, moved by its vector. The sheet goes on across the tile's edges to the
/// points of the tiles beside it, so that all tiles together are one sheet. A quad is cut along its shorter
/// diagonal. Places are rounded to 2⁻²⁰ of a tile.
///
/// Source: Szirmay-Kalos and Umenhoffer 2008, section 7, which moves points along three axes by such maps.
///
/// ```
/// use relief_mesh::motif::vector_sheet;
///
/// // One point in four leans over to the next.
/// let vectors = [[0.0, 0.0, 0.0], [0.4, 0.3, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
/// let sheet = vector_sheet([2, 2], &vectors)?;
/// assert_eq!(sheet.mesh.triangles.len(), 8);
/// # Ok::<(), relief_mesh::motif::VectorSheetError>(())
/// ```
///
/// # Errors
///
/// When there are more or fewer vectors than the size says, or one is not finite or longer than 14 tiles.
pub fn vector_sheet(size: [u32; 2], vectors: &[[f64; 3]]) -> Result<VectorSheet, VectorSheetError> {
    let [width, height] = size.map(|count| count as usize);
    if vectors.is_empty() || width.checked_mul(height) != Some(vectors.len()) {
        return Err(VectorSheetError::Size { width: size[0], height: size[1], vectors: vectors.len() });
    }
    let far = |vector: &[f64; 3]| vector.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    if let Some(at) = vectors
        .iter()
        .position(|vector| !(DVec3::from(*vector).is_finite() && far(vector) <= VectorSheet::FAR))
    {
        let (column, row) = ((at % width) as u32, (at / width) as u32);
        return Err(VectorSheetError::Far { column, row, tiles: far(&vectors[at]) });
    }
    let range = vectors
        .iter()
        .fold([f64::MAX, f64::MIN], |[low, high], vector| [low.min(vector[1]), high.max(vector[1])]);
    let extent = range[1] - range[0];
    let room = ROOM * if extent > 0.0 { extent } else { 1.0 };
    let heights = [range[0] - room, range[1] + room];
    let grid = Grid { width, height, vectors };
    let deep = heights[1] - heights[0];
    let mut mesh = RawMesh::default();
    for row in 0..=height {
        for column in 0..=width {
            // Rounded in its own tile, so that its images lie whole tiles from it.
            let [u, up, v] = grid.point(column % width, row % height).to_array();
            let stepped = |place: f64, tile: usize| ((place * STEPS).round() / STEPS + tile as f64) as f32;
            let (u, v) = (stepped(u, column / width), stepped(v, row / height));
            mesh.positions.push(Vec3::new(u, ((up - heights[0]) / deep) as f32, v));
        }
    }
    let number = |column: usize, row: usize| (row * (width + 1) + column) as u32;
    let mut normals = vec![DVec3::ZERO; width * height];
    for row in 0..height {
        for column in 0..width {
            // Around the quad, counter-clockwise from above.
            let around = [(0, 0), (0, 1), (1, 1), (1, 0)].map(|(right, down)| (column + right, row + down));
            let at = around.map(|(column, row)| grid.point(column, row));
            let is_turned = at[1].distance_squared(at[3]) < at[0].distance_squared(at[2]);
            let triangles = if is_turned { [[0, 1, 3], [1, 2, 3]] } else { [[0, 1, 2], [0, 2, 3]] };
            for corners in triangles {
                let numbers = corners.map(|corner: usize| number(around[corner].0, around[corner].1));
                let [a, b, c] = numbers.map(|number| mesh.positions[number as usize].as_dvec3());
                let normal = (b - a).cross(c - a);
                for corner in corners {
                    let (column, row) = around[corner];
                    normals[row % height * width + column % width] += normal;
                }
                mesh.triangles.push(numbers.map(|number| RawCorner {
                    position: number,
                    normal: number,
                    uv: RawCorner::NONE,
                }));
            }
        }
    }
    for row in 0..=height {
        let row = row % height * width;
        mesh.normals
            .extend((0..=width).map(|column| normals[row + column % width].normalize_or_zero().as_vec3()));
    }
    Ok(VectorSheet { mesh, heights })
}

/// The vectors of a map that goes on in all directions.
struct Grid<'a> {
    width: usize,
    height: usize,
    vectors: &'a [[f64; 3]],
}

impl Grid<'_> {
    /// A point of the sheet, in tiles.
    fn point(&self, column: usize, row: usize) -> DVec3 {
        let vector = self.vectors[row % self.height * self.width + column % self.width];
        let centre = |at: usize, count: usize| (at as f64 + 0.5) / count as f64;
        DVec3::new(centre(column, self.width), 0.0, centre(row, self.height)) + DVec3::from(vector)
    }
}
