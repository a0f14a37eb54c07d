//! Report of `relief inspect` on a folder of textures.

use std::io::{self, Write};
use std::path::Path;

use relief_io::{
    DEFAULT_MAX_BYTES, FoundTexture, Ground, HeightOptions, TextureSet, find_textures, read_ground,
};
use serde_json::{Value, json};

use super::Arguments;
use crate::advice;
use crate::failure::Failure;
use crate::streams::answer;

/// Names of the channels of a packed map.
const CHANNELS: [&str; 4] = ["red", "green", "blue", "opacity"];

/// Finds the textures, reads their headers and prints both.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    arguments.refuse_flags_of_maps()?;
    let set = find_textures(&arguments.file, arguments.udim)
        .map_err(|error| Failure::Work(advice::with_flag(&error, advice::of_textures(&error))))?;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let options = HeightOptions { max_bytes, ..HeightOptions::default() };
    let headers = set.textures.iter().map(|texture| read_ground(&texture.path, &options));
    let headers = headers.collect::<Result<Vec<Ground>, _>>().map_err(Failure::of_picture)?;
    answer(|out| {
        if arguments.json {
            writeln!(out, "{:#}", as_json(arguments, &set, &headers))?;
            return Ok(());
        }
        Ok(print(out, arguments, &set, &headers)?)
    })
}

fn print(
    out: &mut impl Write,
    arguments: &Arguments,
    set: &TextureSet,
    headers: &[Ground],
) -> io::Result<()> {
    let count = set.textures.len();
    let s = if count == 1 { "" } else { "s" };
    writeln!(out, "{}: {count} texture{s} of the material {}", arguments.file.display(), set.name)?;
    for (texture, Ground { size: [width, height], format, .. }) in set.textures.iter().zip(headers) {
        let name = file_name(&texture.path);
        writeln!(out, "  {name}: {}, {}, {width}x{height} texels", kind(texture), format.name())?;
        for (role, channel) in channels(texture) {
            writeln!(out, "    {channel}: {role}")?;
        }
    }
    for (path, reason) in &set.left {
        writeln!(out, "  left out: {} ({reason})", file_name(path))?;
    }
    if let Err(error) = set.height() {
        writeln!(out, "  without heights: {error}")?;
    }
    Ok(())
}

fn as_json(arguments: &Arguments, set: &TextureSet, headers: &[Ground]) -> Value {
    let texture = |(texture, header): (&FoundTexture, &Ground)| {
        let channels: Vec<Value> =
            channels(texture).map(|(role, channel)| json!({ "channel": channel, "role": role })).collect();
        json!({
            "role": texture.role.name(), "file": file_name(&texture.path), "format": header.format.name(),
            "width": header.size[0], "height": header.size[1], "channels": channels,
            "green": texture.green.map(|green| green.name()), "udim": texture.udim,
        })
    };
    let textures: Vec<Value> = set.textures.iter().zip(headers).map(texture).collect();
    let left = set.left.iter();
    let left: Vec<Value> =
        left.map(|(path, reason)| json!({ "file": file_name(path), "reason": reason.to_string() })).collect();
    json!({ "folder": arguments.file, "name": set.name, "textures": textures, "left": left })
}

/// Describes what a texture holds, and what its name says of it.
fn kind(texture: &FoundTexture) -> String {
    let green = texture.green.map(|green| format!(" (green {green} by its name)"));
    let tile = texture.udim.map(|tile| format!(" of the UDIM tile {tile}"));
    format!("{}{}{}", texture.role, green.unwrap_or_default(), tile.unwrap_or_default())
}

/// Returns the parts of a packed map, each with the name of its channel.
fn channels(texture: &FoundTexture) -> impl Iterator<Item = (&'static str, &'static str)> {
    let channels = texture.role.channels().iter();
    channels.map(|(channel, role)| (role.name(), CHANNELS.get(*channel).copied().unwrap_or_default()))
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
