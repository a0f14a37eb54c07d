//! The files that `relief height` writes.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::ValueEnum;
use relief_io::{Metadata, PngTexture, write_exr_rows, write_png_rows};

use crate::commands::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::interrupt::cancelled;

/// A file format, by the ending of the output's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    Png,
    Exr,
}

impl Format {
    /// The ending of such files' names.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
        }
    }
}

const FORMATS: [(&str, Format); 2] = [("png", Format::Png), ("exr", Format::Exr)];

/// A file to be written.
#[derive(Clone, Debug)]
pub struct Output {
    pub path: PathBuf,
    pub format: Format,
}

/// What a file is to hold: planes of texels, in PNG files from 0 to 1.
pub struct Content {
    pub size: [u32; 2],
    /// The channels' names in EXR files.
    pub names: &'static [&'static str],
    pub planes: Vec<Vec<f32>>,
    /// Bits of a sample in PNG files.
    pub bits: u32,
    pub metadata: Metadata,
}

impl Output {
    /// The file that a flag names, if it can be written and is none of those that are read.
    pub fn new(flag: &str, path: &Path, inputs: &[&Path]) -> Result<Self, Failure> {
        Ok(Self { path: path.to_owned(), format: format_of(flag, path, &FORMATS, inputs)? })
    }

    /// How texels are stored, as metadata say it.
    pub const fn stored_as(&self) -> &'static str {
        match self.format {
            Format::Png => "unorm16",
            Format::Exr => "float32",
        }
    }

    /// Writes it aside.
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
