//! `relief mesh --motif VECTORS.exr`: a vector displacement map as a motif.

use std::path::Path;

use clap::ValueEnum;
use relief_core::ByteSize;
use relief_io::{ReadProblem, VectorMap, read_vector_map};
use relief_mesh::motif::{VectorSheet, VectorSheetError, vector_sheet};

use crate::failure::Failure;
use crate::values;

/// Greatest integer of a map whose steps may show.
const COARSE: u32 = 255;

/// How far the lengths of a normal map's vectors are from 1 at most: by 8 bits.
const UNIT: f32 = 0.02;

/// What the channels of a vector displacement map are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Axes {
    /// Tangent, normal and bitangent.
    #[default]
    Tnb,
    /// Tangent, bitangent and normal.
    Tbn,
}

impl Axes {
    /// The name, as the flag spells it.
    pub const fn name(self) -> &'static str {
        match self {
            Axes::Tnb => "tnb",
            Axes::Tbn => "tbn",
        }
    }

    /// What the channels are.
    pub const fn in_words(self) -> &'static str {
        match self {
            Axes::Tnb => "tangent, normal and bitangent",
            Axes::Tbn => "tangent, bitangent and normal",
        }
    }
}

/// The sheet of a map.
pub struct Vectors {
    pub sheet: VectorSheet,
    /// Metres between the heights 0 and 1 of the sheet, and of its height 0 above the base.
    pub scale_m: f64,
    pub low_m: f64,
    /// What a user should know of the file.
    pub note: Option<String>,
}

/// Reads a map, and makes the sheet for tiles of that size in metres. A vector of length 1 is `unit_m` long.
pub fn read(file: &Path, axes: Axes, tile_m: [f64; 2], unit_m: f64, limit: u64) -> Result<Vectors, Failure> {
    let name = file.display();
    let map = read_vector_map(file, limit).map_err(|error| match error.problem {
        ReadProblem::NoColour { .. } => {
            Failure::Work(format!("{error}. A height map is given in place of --motif, not by it"))
        }
        _ => Failure::work(error),
    })?;
    let VectorMap { width, height, vectors, most } = map;
    if vectors.iter().all(|[x, y, z]| x == y && y == z) && vectors.iter().any(|[x, ..]| *x != 0.0) {
        return Err(Failure::Work(format!(
            "{name}: its three channels are the same, so it is a height map: give it in place of --motif"
        )));
    }
    if vectors
        .iter()
        .all(|vector| (vector.iter().map(|part| part * part).sum::<f32>().sqrt() - 1.0).abs() < UNIT)
    {
        return Err(Failure::Work(format!(
            "{name}: all of its vectors have length 1, so it is a normal map: `relief height from-normals` makes \
             heights of it"
        )));
    }
    let needed = vectors.len() as u64 * VectorSheet::BYTES_PER_TEXEL;
    if needed > limit {
        return Err(Failure::Work(format!(
            "{name}: a sheet of {width} x {height} texels needs {}, more than {}: --max-memory allows more, or make \
             the map smaller",
            ByteSize(needed),
            ByteSize(limit)
        )));
    }
    let deep_m = (tile_m[0] * tile_m[1]).sqrt();
    let in_tiles = |vector: [f32; 3]| {
        let [tangent, second, third] = vector.map(f64::from);
        let (bitangent, normal) = if axes == Axes::Tbn { (second, third) } else { (third, second) };
        // Bitangents point up in the map, along falling v.
        [tangent / tile_m[0], normal / deep_m, -bitangent / tile_m[1]].map(|part| part * unit_m)
    };
    let vectors: Vec<_> = vectors.into_iter().map(in_tiles).collect();
    let sheet = vector_sheet([width, height], &vectors).map_err(|error| match error {
        VectorSheetError::Far { column, row, tiles } => Failure::Work(format!(
            "{name}: the vector at ({column}, {row}) moves its point by {} tiles, more than {}: give a smaller --scale",
            values::six_digits(tiles),
            VectorSheet::FAR
        )),
        VectorSheetError::Size { .. } => Failure::Work(format!("{name}: {error}")),
    })?;
    let note = (most == Some(COARSE)).then(|| {
        format!("{name} has 8 bits a channel, whose steps show as terraces: export floats or 16 bits")
    });
    let [low, high] = sheet.heights;
    Ok(Vectors { scale_m: (high - low) * deep_m, low_m: low * deep_m, sheet, note })
}
