//! Files that `relief height` writes.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::ValueEnum;
use relief_io::file_set::is_same_file;
use relief_io::{Metadata, PngTexture, linear_to_srgb, write_exr_rows, write_png_rows};

use crate::commands::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::interrupt::cancelled;

/// File format, by the ending of the output's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    Png,
    Exr,
}

impl Format {
    /// Returns the ending of the names of such files.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
        }
    }
}

/// Refuses two outputs with the same file.
pub fn check_distinct<const N: usize>(named: [Option<&PathBuf>; N]) -> Result<(), Failure> {
    for (at, path) in named.iter().enumerate() {
        let Some(path) = path else { continue };
        if named[..at].iter().flatten().any(|other| is_same_file(other, path)) {
            return Err(Failure::Usage(format!("{} is named for two outputs: rename one", path.display())));
        }
    }
    Ok(())
}

/// Encodes colours of linear light for a file format: sRGB in PNG, linear in EXR.
pub fn encoded(mut content: Content, format: Format) -> Content {
    if format == Format::Png {
        let values = content.planes.iter_mut().flatten();
        values.for_each(|value| *value = linear_to_srgb(f64::from(value.clamp(0.0, 1.0))) as f32);
    }
    content
}

/// Encodes normals for a file format: from 0 to 1 in PNG, from -1 to 1 in EXR.
pub fn coded(mut planes: [Vec<f32>; 3], format: Format) -> Vec<Vec<f32>> {
    if format == Format::Png {
        planes.iter_mut().flatten().for_each(|value| *value = 0.5 * *value + 0.5);
    }
    planes.into()
}

/// Returns the metadata of a picture beside a height map; `more` says what it was made of.
pub fn metadata(
    kind: &str,
    more: Vec<(&str, String)>,
    [width, height]: [u32; 2],
    space: &str,
    published: &str,
) -> Result<Metadata, Failure> {
    let kind = [("kind", kind.to_owned())];
    let rest = [
        ("size", format!("{width} {height} 1")),
        ("note.space", space.to_owned()),
        ("published", published.to_owned()),
        ("generator", concat!("relief ", env!("CARGO_PKG_VERSION")).to_owned()),
    ];
    let entries = kind.into_iter().chain(more).chain(rest);
    let entries = entries.map(|(name, value)| (format!("relief.{name}"), value)).collect();
    Metadata::new(entries).map_err(|problem| Failure::Work(problem.to_string()))
}

/// Space of the normals, as metadata state it.
pub const NORMAL_SPACE: &str = "tangent, +y up in the picture";

/// Returns the colour encoding of a file format, as metadata state it.
pub const fn color_space(format: Format) -> &'static str {
    match format {
        Format::Png => "sRGB",
        Format::Exr => "linear",
    }
}

const FORMATS: [(&str, Format); 2] = [("png", Format::Png), ("exr", Format::Exr)];

/// Output file.
#[derive(Clone, Debug)]
pub struct Output {
    pub path: PathBuf,
    pub format: Format,
}

/// Content of a file: planes of texels, in PNG files from 0 to 1.
pub struct Content {
    pub size: [u32; 2],
    /// Names of the channels in EXR files.
    pub names: &'static [&'static str],
    pub planes: Vec<Vec<f32>>,
    /// Bits per sample in PNG files.
    pub bits: u32,
    pub metadata: Metadata,
}

impl Output {
    /// Creates the output that a flag names, if it can be written and is none of `inputs`.
    pub fn new(flag: &str, path: &Path, inputs: &[&Path]) -> Result<Self, Failure> {
        Ok(Self { path: path.to_owned(), format: format_of(flag, path, &FORMATS, inputs)? })
    }

    /// Returns how texels are stored, as metadata state it.
    pub const fn stored_as(&self) -> &'static str {
        match self.format {
            Format::Png => "unorm16",
            Format::Exr => "float32",
        }
    }

    /// Writes the file aside; it takes its name later.
    pub fn write(&self, staged: &mut Staged, content: &Content, cancel: &AtomicBool) -> Result<(), Failure> {
        let Output { path, format } = self;
        let aside = staged.aside(path)?;
        let [width, height] = content.size;
        let mut rows = |row: relief_io::Row, texels: &mut [f32]| -> io::Result<()> {
            if cancel.load(Ordering::Relaxed) {
                return Err(io::Error::other("cancelled"));
            }
            let start = row.row as usize * width as usize;
            texels.copy_from_slice(&content.planes[row.channel][start..start + width as usize]);
            Ok(())
        };
        let written = match format {
            Format::Png => {
                let texture =
                    PngTexture { width, height, channels: content.planes.len(), bits: content.bits };
                write_png_rows(&aside, &texture, &content.metadata, &mut rows)
            }
            Format::Exr => write_exr_rows(&aside, width, height, content.names, &content.metadata, &mut rows),
        };
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        written.map_err(|error| Failure::Work(format!("{}: {}", path.display(), error.problem)))
    }
}
