//! Metadata of a baked file, and the hash that identifies its bake.

use std::ops::Range;
use std::path::Path;

use relief_bake::{Kind, Settings, Texture, bits_of_heights};
use relief_core::{HeightMap, Metric, Rounding};
use relief_io::read_metadata;

use super::storage::{Packing, Storage};

/// Metadata entry with the hash that identifies a bake.
pub const KEY: &str = "relief.key";

/// Metadata entry with the names of a bake's files, as a JSON list.
const FILES: &str = "relief.files";

/// Names and values of a file's metadata.
pub type Entries = Vec<(String, String)>;

/// Returns the inputs that decide the values of a bake, as entries of all of its files.
/// `source_hash` is the hash of `map`.
fn inputs(
    kind: &Kind,
    settings: &Settings,
    map: &HeightMap,
    source_hash: &str,
    metric: Metric,
) -> Vec<(&'static str, String)> {
    let [tile_u, tile_v] = metric.tile_m;
    let guarantee = match bits_of_heights(kind, settings) {
        0 => kind.guarantee.to_owned(),
        bits => format!("{} It holds for the heights rounded to {bits} bits.", kind.guarantee),
    };
    let settings: Vec<String> = settings.iter().map(|(name, value)| format!("{name}={value}")).collect();
    vec![
        ("kind", kind.name.to_owned()),
        ("source", format!("blake3:{source_hash}")),
        ("source_size", format!("{} {}", map.width(), map.height())),
        ("wrap", map.wrap().name().to_owned()),
        ("tile_m", format!("{tile_u} {tile_v}")),
        ("scale_m", metric.scale_m.to_string()),
        ("settings", settings.join(" ")),
        ("convention", "height 1 is highest; row 0 is on top, v grows downward".to_owned()),
        ("units", "lengths in metres; heights in fractions of the scale; u and v in tiles".to_owned()),
        ("guarantee", guarantee),
        (
            "published",
            format!("{} {}", kind.publication.paper, kind.publication.section).trim_end().to_owned(),
        ),
        ("generator", concat!("relief ", env!("CARGO_PKG_VERSION")).to_owned()),
    ]
}

/// Hashes texts, each with its length.
fn hash_of<'a>(texts: impl Iterator<Item = &'a str>) -> blake3::Hash {
    let mut hasher = blake3::Hasher::new();
    for text in texts {
        hasher.update(&(text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    }
    hasher.finalize()
}

/// Inputs that decide the bytes of a bake's files, and the entries of all of them.
pub struct Identity {
    entries: Entries,
    key: String,
}

impl Identity {
    /// Creates the identity of a kind's bake from `map`, whose hash is `source_hash`.
    pub fn new(
        kind: &Kind,
        settings: &Settings,
        map: &HeightMap,
        source_hash: &str,
        metric: Metric,
        Packing { format, storage, zstd }: Packing,
    ) -> Self {
        let mut about = inputs(kind, settings, map, source_hash, metric);
        about.push(("stored_as", storage.name().to_owned()));
        let mut entries: Entries =
            about.into_iter().map(|(name, value)| (format!("relief.{name}"), value)).collect();
        if let Some([zero, one]) = map.physical_range() {
            entries.push(("relief.physical_range".to_owned(), format!("{zero} {one}")));
        }
        let container = [format.extension(), if zstd { "zstd" } else { "plain" }];
        let entry_texts = entries.iter().flat_map(|(name, value)| [name.as_str(), value.as_str()]);
        let key = hash_of(entry_texts.chain(container)).to_hex().to_string();
        Self { entries, key }
    }

    /// Returns the hash of all inputs.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// Returns the metadata of a file with these channels of `texture`. `files` are the names of
    /// all files of the bake. `level` and `slices` are given for a file that does not hold all of
    /// them.
    pub fn metadata(
        &self,
        texture: &Texture,
        channels: Range<usize>,
        level: Option<usize>,
        slices: Option<Range<u32>>,
        storage: Storage,
        files: &[String],
    ) -> Entries {
        let channels = &texture.channels[channels];
        let join = |texts: Vec<String>| texts.join(" ");
        let decode = if storage.is_normalised() {
            "value = range[0] + texel * (range[1] - range[0]), texel from 0 to 1"
        } else {
            "value = texel"
        };
        let [width, height, depth] = texture.level_size(level.unwrap_or(0));
        let depth = slices.as_ref().map_or(depth, |slices| slices.end - slices.start);
        let own = [
            ("channels", join(channels.iter().map(|channel| channel.name.to_owned()).collect())),
            ("channel_units", join(channels.iter().map(|channel| channel.unit.to_owned()).collect())),
            ("ranges", join(channels.iter().map(|c| format!("{},{}", c.range[0], c.range[1])).collect())),
            ("rounding", join(channels.iter().map(|c| rounding_name(c.rounding).to_owned()).collect())),
            ("decode", decode.to_owned()),
            ("size", format!("{width} {height} {depth}")),
        ];
        let mut entries = self.entries.clone();
        entries.extend(own.map(|(name, value)| (format!("relief.{name}"), value)));
        if !texture.name.is_empty() {
            entries.push(("relief.texture".to_owned(), texture.name.to_owned()));
        }
        if let Some(level) = level {
            entries.push(("relief.level".to_owned(), level.to_string()));
        }
        if let Some(Range { start, .. }) = slices {
            entries.push(("relief.first_slice".to_owned(), start.to_string()));
        }
        entries
            .extend(texture.notes.iter().map(|(name, value)| (format!("relief.note.{name}"), value.clone())));
        entries.push((KEY.to_owned(), self.key.clone()));
        entries.push((FILES.to_owned(), serde_json::json!(files).to_string()));
        // A value is one line in every format.
        for (_, value) in &mut entries {
            *value = value.replace(char::is_control, " ");
        }
        entries
    }
}

/// Whether a file's metadata state that it was baked.
pub fn is_baked(path: &Path) -> bool {
    read_metadata(path).is_ok_and(|found| found.get(KEY).is_some())
}

const fn rounding_name(rounding: Rounding) -> &'static str {
    match rounding {
        Rounding::Nearest => "nearest",
        Rounding::Down => "down",
        Rounding::Up => "up",
    }
}
