//! What is baked: a height map, or a volume, whose slices lie side by side in a map.

use std::collections::BTreeSet;

use relief_bake::{KINDS, Kind, Settings};
use relief_core::HeightMap;
use relief_io::{DEFAULT_MAX_BYTES, VolumeOptions, read_height_file, read_volume};

use super::Arguments;
use crate::commands::maps::{self, Note};
use crate::failure::Failure;
use crate::file_kind::FileKind;

type Kinds<'k> = Vec<(&'k Kind, Settings)>;

/// Names of the settings that say how the slices of a volume lie, in the order of its axes.
const SIDES: [&str; 3] = ["columns", "rows", "slices"];

/// Reads the file. Returns the map, the kinds with the settings that follow from the file, and notes.
pub fn read<'k>(
    arguments: &Arguments,
    kinds: Kinds<'k>,
) -> Result<(HeightMap, Kinds<'k>, BTreeSet<Note>), Failure> {
    if FileKind::of(&arguments.height)? == FileKind::Volume {
        let (map, kinds) = volume(arguments, kinds)?;
        return Ok((map, kinds, BTreeSet::new()));
    }
    let is_atlas = |name: &str| {
        arguments.set.iter().any(|(key, _)| key.strip_prefix(name).is_some_and(|key| key == ".slices"))
    };
    let of_volume = kinds.iter().map(|(kind, _)| kind).find(|kind| kind.of_volume && !is_atlas(kind.name));
    if let Some(Kind { name, .. }) = of_volume {
        let file = arguments.height.display();
        return Err(Failure::Usage(format!(
            "{file}: {name} is of volumes: give one, which `relief volume` makes; of a picture of slices say \
             how they lie, with --set {name}.columns, {name}.rows and {name}.slices"
        )));
    }
    let options = arguments.reading.options(arguments.max_memory);
    let file = read_height_file(&arguments.height, &options).map_err(Failure::of_map)?;
    let notes = maps::of_file(&arguments.height, &file, &arguments.reading);
    Ok((file.map, kinds, notes))
}

/// Reads a volume, whose atlas is baked.
fn volume<'k>(arguments: &Arguments, mut kinds: Kinds<'k>) -> Result<(HeightMap, Kinds<'k>), Failure> {
    let file = arguments.height.display();
    let of_heights = kinds.iter().find(|(kind, _)| !kind.of_volume);
    if let Some((kind, _)) = of_heights {
        let of_volume: Vec<&str> = KINDS.iter().filter(|kind| kind.of_volume).map(|kind| kind.name).collect();
        return Err(Failure::Usage(format!(
            "{file}: is a volume, and {} is baked from heights: bake {}",
            kind.name,
            of_volume.join(" or ")
        )));
    }
    if let Some(flag) = arguments.reading.flag_of_heights() {
        return Err(Failure::Usage(format!("{flag} is for height maps: leave it out")));
    }
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let options = VolumeOptions { max_bytes, wrap: arguments.reading.wrap };
    let volume = read_volume(&arguments.height, &options).map_err(Failure::of_picture)?.volume;
    for (_, settings) in &mut kinds {
        for (name, side) in SIDES.into_iter().zip(volume.size()) {
            settings.set(name, f64::from(side)).map_err(Failure::usage)?;
        }
    }
    Ok((volume.atlas().clone(), kinds))
}
