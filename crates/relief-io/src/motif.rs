//! Motifs in files: meshes in the space of a tile, and how deep they are.

use serde_json::Value;

use crate::mesh::read_node_extras;
use crate::source::Source;
use crate::{ReadError, ReadProblem};

/// Name of the entry in a GLB's extras that says that its mesh lies in the space of a tile.
pub const MOTIF_EXTRAS: &str = "motif";

/// Greatest depth of a motif, in tiles.
const DEEPEST: f64 = 1e6;

/// Returns the depth of a motif's heights in tiles, as its file says: `depth` under [`MOTIF_EXTRAS`] in the
/// extras of its node. `None` for other meshes.
///
/// # Errors
///
/// When the file cannot be read, is not a mesh, is damaged, needs more than `max_bytes`, or states another
/// depth than a number above 0.
pub fn read_motif_depth<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<Option<f64>, ReadError> {
    let source = source.into();
    let Some(text) = read_node_extras(source, MOTIF_EXTRAS, max_bytes)? else { return Ok(None) };
    let value: Option<Value> = serde_json::from_str(&text).ok();
    let depth = value.and_then(|value| value.get("depth")?.as_f64());
    let depth = depth.filter(|depth| *depth > 0.0 && *depth <= DEEPEST);
    depth.map(Some).ok_or_else(|| source.error(ReadProblem::MotifDepth(text)))
}
