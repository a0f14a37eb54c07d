//! What kinds baked from a volume share: the parameters that say how it lies in a map, and its
//! reading.

use relief_core::Volume;
use relief_core::registry::Param;

use crate::{BakeError, BakeInput, Settings};

/// Most columns, rows or slices.
const MOST: f32 = 32768.0;

const COLUMNS: Param = Param {
    name: "columns",
    summary: "columns of the volume, or 0 for as many as the map has",
    unit: "voxels",
    min: 0.0,
    max: MOST,
    default: 0.0,
    integer: true,
    names: &[],
};

const ROWS: Param =
    Param { name: "rows", summary: "rows of the volume, or 0 for as many as the map has", ..COLUMNS };

const SLICES: Param = Param { name: "slices", summary: "slices of the volume, or 0 for one", ..COLUMNS };

/// The first parameters of a kind that is baked from a volume.
pub(crate) const VOLUME_PARAMS: [Param; 3] = [COLUMNS, ROWS, SLICES];

/// The volume whose slices a map holds side by side, by the first three settings of a kind.
pub(crate) fn volume_of(
    source: &BakeInput,
    settings: &Settings,
    kind: &'static str,
) -> Result<Volume, BakeError> {
    let map = source.map;
    let given = |place: usize, otherwise: u32| match settings.count(place) {
        0 => otherwise,
        count => count,
    };
    let size = [given(0, map.width()), given(1, map.height()), given(2, 1)];
    Volume::of_atlas(map.clone(), size)
        .map_err(|error| BakeError::Impossible { kind, reason: error.to_string() })
}

/// Notes in a texture on the volume that it was baked from.
pub(crate) fn volume_notes(volume: &Volume) -> Vec<(&'static str, String)> {
    let [columns, rows, slices] = volume.size();
    vec![
        ("volume", format!("{columns} x {rows} x {slices}")),
        ("slices_in_a_row", volume.layout().slices_in_a_row().to_string()),
        ("wrap", volume.wrap().name().to_owned()),
    ]
}
