//! Volumes of meshes.

use std::sync::atomic::AtomicBool;

use relief_bake::volumes::{Fit, MeshVolumeSettings, volume_from_mesh};
use relief_core::Watch;
use relief_io::{read_motif_depth, read_raw_mesh};
use serde_json::{Map, json};

use super::{Arguments, Made, of_volumes};
use crate::failure::Failure;
use crate::progress::Progress;

pub(super) fn make(arguments: &Arguments, cancel: &AtomicBool) -> Result<Made, Failure> {
    let depth = read_motif_depth(&arguments.input, arguments.max_bytes()).map_err(Failure::of_mesh)?;
    let raw = {
        let _reading = Progress::spinner("reading", arguments.json);
        read_raw_mesh(&arguments.input, arguments.max_bytes()).map_err(Failure::of_mesh)?
    };
    let more = (raw.triangles.len() as u64).saturating_mul(MeshVolumeSettings::BYTES_PER_TRIANGLE);
    arguments.check_memory(arguments.size(), MeshVolumeSettings::BYTES_PER_VOXEL, more)?;
    let usual = MeshVolumeSettings::new(arguments.size());
    let tile_m = arguments.tile.unwrap_or(usual.tile_m);
    let fit = arguments.fit.unwrap_or(if depth.is_some() { Fit::Tile } else { Fit::Keep });
    let settings = MeshVolumeSettings {
        wrap: arguments.wrap.unwrap_or(usual.wrap),
        fit,
        margin: arguments.margin.unwrap_or(usual.margin),
        tile_m,
        reach: arguments.reach.unwrap_or(usual.reach),
        ..usual
    };
    let made = {
        let bar = Progress::bar("filling", arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        volume_from_mesh(&raw, &settings, &Watch::new(&tell, cancel)).map_err(of_volumes)?
    };
    let volume = if fit == Fit::Tile {
        // A motif's depth is between its heights 0 and 1; the volume's heights reach beyond.
        let depth_m = depth.map_or(DEFAULT_SCALE_M, |depth| depth * tile_m[0]);
        let [scale_m, bias_m] =
            [made.volume.atlas().scale_m(), made.volume.atlas().bias_m()].map(|length| depth_m * length);
        made.volume.clone().with_displacement(scale_m, bias_m).map_err(Failure::work)?
    } else {
        made.volume.clone()
    };
    let mut notes = Vec::new();
    let name = arguments.input.display();
    if made.open_edges > 0 {
        notes.push(format!(
            "{name}: the mesh is not closed: {} of its edges are open. What lies below an odd number of \
             faces is solid",
            made.open_edges
        ));
    } else if made.turned_edges > 0 {
        notes.push(format!(
            "{name}: faces do not agree on their outer side at {} edges, so their sides are not used",
            made.turned_edges
        ));
    }
    if made.odd_columns > 0 {
        let [width, height, _] = volume.size().map(u64::from);
        notes.push(format!(
            "{name}: {} of {} columns cross an odd number of faces, and are solid down to the floor",
            made.odd_columns,
            width * height
        ));
    }
    if made.beyond > 0 {
        notes.push(format!(
            "{name}: {} of {} triangles reach beyond the heights 0 to 1, and are cut off there",
            made.beyond, made.triangles
        ));
    }
    if made.thin > MUCH_THIN {
        notes.push(format!(
            "{name}: {:.0} % of its surface is on parts thinner than a voxel, which break into pieces: make \
             them thicker, or give more voxels with --size",
            100.0 * made.thin
        ));
    }
    let motif = if depth.is_some() { "motif of " } else { "" };
    let lines = vec![("mesh", format!("{motif}{} triangles, --fit {fit}", made.triangles))];
    let about = [
        ("triangles", json!(made.triangles)),
        ("open_edges", json!(made.open_edges)),
        ("turned_edges", json!(made.turned_edges)),
        ("odd_columns", json!(made.odd_columns)),
        ("beyond", json!(made.beyond)),
        ("thin", json!(made.thin)),
        ("doubled", json!(made.doubled)),
        ("solid_by", json!(made.solid.name())),
        ("fit", json!(fit.name())),
    ];
    let about = Map::from_iter(about.map(|(name, value)| (name.to_owned(), value)));
    Ok(Made { volume, tile_m, lines, about, notes })
}

/// Greatest part of a mesh's surface on thin parts without a note. The tips of blades are always thin.
const MUCH_THIN: f64 = 0.25;

/// Scale of a mesh that lies in the tile and does not say how deep that is.
const DEFAULT_SCALE_M: f64 = 0.05;
