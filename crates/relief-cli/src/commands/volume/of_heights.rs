//! Volumes of height maps.

use std::sync::atomic::AtomicBool;

use relief_bake::volumes::volume_from_heights;
use relief_core::Watch;
use relief_io::{HeightOptions, read_height_file};
use serde_json::Map;

use super::{Arguments, Made, of_volumes};
use crate::commands::maps::By;
use crate::failure::Failure;
use crate::progress::Progress;

/// Scale of a map that states none.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Bytes that reading takes for a voxel of the result.
const BYTES_PER_VOXEL: u64 = 16;

pub(super) fn make(arguments: &Arguments, cancel: &AtomicBool) -> Result<Made, Failure> {
    arguments.check_memory(arguments.size(), BYTES_PER_VOXEL, 0)?;
    let reading = &arguments.reading;
    let options = HeightOptions {
        channel: reading.channel.clone(),
        unit: reading.unit,
        raw: reading.raw,
        nodata: reading.nodata,
        fill: reading.fill(),
        wrap: arguments.wrap,
        max_bytes: arguments.max_bytes(),
        ..HeightOptions::default()
    };
    let file = {
        let _reading = Progress::spinner("reading", arguments.json);
        read_height_file(&arguments.input, &options).map_err(Failure::of_map)?
    };
    let notes = file.notes.iter().map(|note| By::Flags.note(note).to_string()).collect();
    let map = file.map;
    let tile_m = arguments.tile.or(map.stated_tile_m()).unwrap_or([1.0; 2]);
    // What a file says is the map's own scale; a flag gives the volume's heights.
    let (scale_m, bias_m) = match (map.stated_displacement_m(), map.stated_lengths_m()) {
        (Some([low, high]), _) => (high - low, low),
        (None, Some((_, scale_m))) => (scale_m, 0.0),
        (None, None) => (DEFAULT_SCALE_M, 0.0),
    };
    let scale_m = arguments.scale.unwrap_or(scale_m);
    let map = map.with_displacement(scale_m, arguments.bias.unwrap_or(bias_m)).map_err(Failure::work)?;
    let bar = Progress::bar("filling", arguments.json);
    let tell = |_: &str, part: f32| bar.show(part);
    let volume =
        volume_from_heights(&map, arguments.size(), &Watch::new(&tell, cancel)).map_err(of_volumes)?;
    let lines = vec![("map", format!("{}x{} heights", map.width(), map.height()))];
    Ok(Made { volume, tile_m, lines, about: Map::new(), notes })
}
