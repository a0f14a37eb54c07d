//! Report of `relief inspect` on a volume.

use std::io::Write;

use relief_io::{DEFAULT_MAX_BYTES, TexelFormat, VolumeOptions, read_volume};
use serde_json::json;

use super::Arguments;
use crate::commands::volume::{print_volume, share_solid};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::answer;

/// Reads the volume and prints its size, bits, solid share and lengths.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    arguments.refuse_flags_of_maps()?;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let file = {
        let _reading = Progress::spinner("reading", arguments.json);
        let options = VolumeOptions { max_bytes, ..VolumeOptions::default() };
        read_volume(&arguments.file, &options).map_err(Failure::of_picture)?
    };
    let volume = &file.volume;
    let [width, height, slices] = volume.size();
    let (bits, kind) = match file.format {
        TexelFormat::R8 => (8, "integers"),
        TexelFormat::R32F => (32, "floats"),
        _ => (16, "integers"),
    };
    let packed = if file.zstd { "Zstandard" } else { "none" };
    answer(|out| {
        let name = arguments.file.display().to_string();
        if arguments.json {
            let about = json!({
                "input": name, "format": "KTX2", "size": volume.size(), "bits": bits, "compression": packed,
                "solid": share_solid(volume), "scale_m": volume.atlas().scale_m(),
                "bias_m": volume.atlas().bias_m(),
                "tile_m": file.tile_m, "wrap": volume.wrap().name(),
            });
            return Ok(writeln!(out, "{about:#}")?);
        }
        writeln!(out, "{name}: KTX2 volume, {width}x{height}x{slices} voxels")?;
        writeln!(out, "  values      {bits}-bit {kind}, compression {packed}")?;
        Ok(print_volume(out, volume, file.tile_m)?)
    })
}
