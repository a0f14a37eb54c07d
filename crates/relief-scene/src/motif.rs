//! Motifs of files: meshes in the space of a tile, and vector displacement maps as sheets.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use relief_core::ByteSize;
use relief_core::mesh::RawMesh;
use relief_core::registry::UnknownName;
use relief_io::{MeshFormat, ReadError, Source, VectorMap, read_motif_depth, read_raw_mesh, read_vector_map};
use relief_mesh::motif::{VectorSheet, VectorSheetError, vector_sheet};

/// Metres between the heights 0 and 1 of a mesh, where neither the caller nor its file says more.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Greatest integer of a map whose steps may show.
const COARSE: u32 = 255;

/// How far the lengths of a normal map's vectors are from 1 at most: by 8 bits.
const UNIT: f32 = 0.02;

/// What the channels of a vector displacement map are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum VectorAxes {
    /// Tangent, normal and bitangent.
    #[default]
    Tnb,
    /// Tangent, bitangent and normal.
    Tbn,
}

impl VectorAxes {
    /// All of them.
    pub const ALL: [VectorAxes; 2] = [VectorAxes::Tnb, VectorAxes::Tbn];

    /// Returns the name: `tnb` or `tbn`.
    pub const fn name(self) -> &'static str {
        match self {
            VectorAxes::Tnb => "tnb",
            VectorAxes::Tbn => "tbn",
        }
    }

    /// Returns what the channels are, in words.
    pub const fn in_words(self) -> &'static str {
        match self {
            VectorAxes::Tnb => "tangent, normal and bitangent",
            VectorAxes::Tbn => "tangent, bitangent and normal",
        }
    }
}

impl fmt::Display for VectorAxes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for VectorAxes {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = VectorAxes::ALL.into_iter().find(|axes| axes.name() == name);
        known.ok_or_else(|| UnknownName::new("order of axes", name, VectorAxes::ALL.map(VectorAxes::name)))
    }
}

/// Settings of [`read_motif`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotifOptions {
    /// Order of a vector displacement map's channels; `None` for the usual one. Meshes have none.
    pub axes: Option<VectorAxes>,
    /// Size of the tiles that the motif lies on, in metres along `u` and `v`.
    pub tile_m: [f64; 2],
    /// Metres between the heights 0 and 1 of a mesh, or the length of a vector of length 1 in a map. `None`
    /// for what the file says, or the length of a tile.
    pub scale_m: Option<f64>,
    /// Most bytes that reading may need.
    pub max_bytes: u64,
}

/// Motif of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MotifFile {
    /// The mesh in the space of a tile: `(u, height, v)`.
    pub mesh: RawMesh,
    /// Metres between its heights 0 and 1.
    pub scale_m: f64,
    /// Metres of its height 0 above the base, before any bias. It is 0 for meshes.
    pub low_m: f64,
    /// Metres that the scale stands for: between the heights 0 and 1, or of a vector of length 1.
    pub unit_m: f64,
    /// Order of the channels of a vector displacement map; `None` for meshes.
    pub axes: Option<VectorAxes>,
    /// Whether it is a map of 8 bits a channel, whose steps may show.
    pub is_coarse: bool,
}

/// Why a file is no motif.
#[derive(Debug, thiserror::Error)]
pub enum MotifFileError {
    /// The file cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// Its content is no motif.
    #[error("{}: {problem}", path.display())]
    Invalid {
        /// Path of the file.
        path: PathBuf,
        /// Description of the problem.
        problem: MotifProblem,
    },
}

/// What is wrong with a motif.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotifProblem {
    /// A height map in place of a vector displacement map.
    #[error("its three channels are the same, so it is a height map: give it as one, not as a motif")]
    HeightMap,
    /// A normal map in place of a vector displacement map.
    #[error(
        "all of its vectors have length 1, so it is a normal map: `relief height from-normals` makes heights \
         of it"
    )]
    NormalMap,
    /// The sheet of a map is too large.
    #[error(
        "a sheet of {width} x {height} texels needs {}, more than {}",
        ByteSize(*needed),
        ByteSize(*limit)
    )]
    Memory {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Bytes that it needs.
        needed: u64,
        /// Bytes that may be used.
        limit: u64,
    },
    /// A vector is too long, or the map too small.
    #[error(transparent)]
    Sheet(#[from] VectorSheetError),
    /// The order of axes is given for a mesh.
    #[error("it is a mesh, whose axes are known: an order of axes is for vector displacement maps")]
    AxesOfMesh,
}

/// Reads a motif: a mesh in the space of a tile, or a vector displacement map, which becomes a sheet.
///
/// # Errors
///
/// When the file cannot be read, is another kind of map, or needs more memory than is allowed.
pub fn read_motif<'a>(
    source: impl Into<Source<'a>>,
    options: &MotifOptions,
) -> Result<MotifFile, MotifFileError> {
    let source = source.into();
    let path = source.name();
    let of_file = |problem: MotifProblem| MotifFileError::Invalid { path: path.to_owned(), problem };
    let MotifOptions { axes, tile_m, scale_m, max_bytes } = *options;
    let tile_length_m = (tile_m[0] * tile_m[1]).sqrt();
    if MeshFormat::by_name(path).is_some() {
        if axes.is_some() {
            return Err(of_file(MotifProblem::AxesOfMesh));
        }
        let mesh = read_raw_mesh(source, max_bytes)?;
        // As deep as it is long.
        let depth = read_motif_depth(source, max_bytes)?;
        let unit_m = scale_m.or(depth.map(|depth| depth * tile_length_m)).unwrap_or(DEFAULT_SCALE_M);
        return Ok(MotifFile { mesh, scale_m: unit_m, low_m: 0.0, unit_m, axes: None, is_coarse: false });
    }
    let map = read_vector_map(source, max_bytes)?;
    let (axes, unit_m) = (axes.unwrap_or_default(), scale_m.unwrap_or(tile_length_m));
    let is_coarse = map.most == Some(COARSE);
    let sheet = sheet(map, axes, tile_m, unit_m, max_bytes).map_err(of_file)?;
    let [low, high] = sheet.heights;
    Ok(MotifFile {
        scale_m: (high - low) * tile_length_m,
        low_m: low * tile_length_m,
        mesh: sheet.mesh,
        unit_m,
        axes: Some(axes),
        is_coarse,
    })
}

/// Makes the sheet of a map for tiles of that size in metres. A vector of length 1 is `unit_m` long.
fn sheet(
    map: VectorMap,
    axes: VectorAxes,
    tile_m: [f64; 2],
    unit_m: f64,
    limit: u64,
) -> Result<VectorSheet, MotifProblem> {
    let VectorMap { width, height, vectors, .. } = map;
    if vectors.iter().all(|[x, y, z]| x == y && y == z) && vectors.iter().any(|[x, ..]| *x != 0.0) {
        return Err(MotifProblem::HeightMap);
    }
    let length = |vector: &[f32; 3]| vector.iter().map(|part| part * part).sum::<f32>().sqrt();
    if vectors.iter().all(|vector| (length(vector) - 1.0).abs() < UNIT) {
        return Err(MotifProblem::NormalMap);
    }
    let needed = vectors.len() as u64 * VectorSheet::BYTES_PER_TEXEL;
    if needed > limit {
        return Err(MotifProblem::Memory { width, height, needed, limit });
    }
    let deep_m = (tile_m[0] * tile_m[1]).sqrt();
    let in_tiles = |vector: [f32; 3]| {
        let [tangent, second, third] = vector.map(f64::from);
        let (bitangent, normal) = if axes == VectorAxes::Tbn { (second, third) } else { (third, second) };
        // Bitangents point up in the map, along falling v.
        [tangent / tile_m[0], normal / deep_m, -bitangent / tile_m[1]].map(|part| part * unit_m)
    };
    let vectors: Vec<_> = vectors.into_iter().map(in_tiles).collect();
    Ok(vector_sheet([width, height], &vectors)?)
}
