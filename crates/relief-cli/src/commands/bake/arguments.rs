//! Flags of `relief bake`, their help, and the file or folder that they name.

use std::path::{Path, PathBuf};

use clap::Args;
use relief_bake::{KINDS, Kind};
use relief_core::ByteSize;

use super::for_engine::{EngineArguments, FolderArguments};
use super::storage::{FileFormat, TexelChoice};
use super::{MIPS, for_engine};
use crate::commands::maps::HeightArguments;
use crate::failure::Failure;
use crate::streams::Files;
use crate::{units, values};

/// Arguments of `relief bake`.
#[derive(Args)]
#[command(after_help = short_help(), after_long_help = after_help())]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw; - for standard
    /// input (its files are named stdin). With --for also a folder of textures
    pub(super) height: PathBuf,
    /// Kinds of baked maps, as in cone,normal; listed below
    #[arg(
        long,
        value_name = "KIND[,KIND...]",
        value_delimiter = ',',
        required_unless_present = "engine",
        conflicts_with = "engine"
    )]
    pub(super) kind: Vec<String>,
    #[command(flatten)]
    pub(super) engine: EngineArguments,
    /// Folder for the files, created if missing; or, for a single kind, the file itself, as in
    /// normal.png
    #[arg(short, long, value_name = "DIR|FILE")]
    pub(super) output: PathBuf,
    /// File format [default: png for normal, occlusion and bent-normal, which other programs read
    /// as pictures; exr for the rest and for --texels float]
    #[arg(long, value_enum, conflicts_with = "engine")]
    pub(super) format: Option<FileFormat>,
    /// Setting of a kind, as in cone.bits=8; repeatable
    #[arg(long, value_name = "KIND.NAME=VALUE", value_parser = setting, conflicts_with = "engine")]
    pub(super) set: Vec<(String, f64)>,
    /// Displacement in metres between heights 0 and 1, or with a unit, as in 5cm [default: the
    /// range of a georeferenced elevation model, else 0.05]
    #[arg(long, value_name = "M", value_parser = units::length)]
    pub(super) scale: Option<f64>,
    /// Tile size along u and v in metres, or with units, as in 30cm,20cm [default: a georeferenced
    /// file's, else square texels and 1 m for the longer side]
    #[arg(long, value_name = "U,V", value_parser = units::two_lengths)]
    pub(super) tile_size: Option<[f64; 2]>,
    /// Storage of values, which are rounded to the side that keeps a map's guarantee
    #[arg(long, value_enum, default_value = "auto", conflicts_with = "engine", help_heading = "Storage")]
    pub(super) texels: TexelChoice,
    /// Compress the levels of KTX2 files with Zstandard
    #[arg(long, conflicts_with = "engine", help_heading = "Storage", hide_short_help = true)]
    pub(super) zstd: bool,
    /// Allow block compression of heights, which keeps 8 levels per block: for copies only
    #[arg(long, conflicts_with = "engine", help_heading = "Storage", hide_short_help = true)]
    pub(super) lossy_heights: bool,
    /// Bake again even if the files are up to date, and replace files of other programs
    #[arg(long)]
    pub(super) force: bool,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB to read the map]
    #[arg(long, value_name = "SIZE", hide_short_help = true)]
    pub(super) max_memory: Option<ByteSize>,
    #[command(flatten)]
    pub(super) reading: HeightArguments,
}

/// What the textures of a material are written from, and how.
pub struct MaterialJob {
    pub height: PathBuf,
    pub folder: FolderArguments,
    pub output: PathBuf,
    pub scale: Option<f64>,
    pub tile_size: Option<[f64; 2]>,
    pub force: bool,
    pub json: bool,
    pub max_memory: Option<ByteSize>,
    pub reading: HeightArguments,
}

impl From<MaterialJob> for Arguments {
    fn from(job: MaterialJob) -> Self {
        let MaterialJob { height, folder, output, scale, tile_size, force, json, max_memory, reading } = job;
        Self {
            height,
            kind: Vec::new(),
            engine: EngineArguments { name: None, folder },
            output,
            format: None,
            set: Vec::new(),
            scale,
            tile_size,
            texels: TexelChoice::Auto,
            zstd: false,
            lossy_heights: false,
            force,
            json,
            max_memory,
            reading,
        }
    }
}

/// Examples, and the names of all kinds.
fn short_help() -> String {
    let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
    format!(
        "Examples:\n  relief bake bricks.png --kind normal -o bricks_normal.png\n  \
         relief bake bricks.png --kind cone --set cone.bits=8 --format ktx2 -o maps\n  \
         relief bake Bricks090 --for unreal -o unreal    # a folder of textures\n\n\
         Kinds: {}; `relief bake --help` describes them and their settings.",
        names.join(", ")
    )
}

fn setting(text: &str) -> Result<(String, f64), String> {
    values::setting(text).map_err(|_| "write it as KIND.NAME=NUMBER, as in cone.bits=8".to_owned())
}

/// Examples, what is written, and all kinds with their settings.
fn after_help() -> String {
    let mut text = String::from(
        "Examples:\n  relief bake bricks.png --kind cone --set cone.bits=8 --format ktx2 -o maps\n  \
         relief bake dem.tif --fill --wrap clamp --kind normal,horizon -o maps\n  \
         relief bake Bricks090 --for unreal -o unreal\n\n\
         Files are named HEIGHT.KIND.FORMAT. Where a kind has several, the texture's name, channels, mip \
         level or slices come before FORMAT. Each file holds its metadata: kind, settings, hash of the \
         source, wrap, tile and scale in metres, channels with ranges and rounding, and the names of all \
         files of the bake.\n\n\
         HEIGHT.relief-manifest lists the files of all bakes of a map with their hashes. Files that are up \
         to date are not baked again. Files that a new bake of a kind no longer writes are removed, unless \
         they were changed. Files of other programs are replaced only with --force.\n\n\
         All files take their names at the end; Ctrl-C changes nothing (exit code 1). While it bakes, a \
         hidden folder in DIR takes 4 bytes a value. The next run finishes or removes what a killed run \
         left.\n\n",
    );
    text += &for_engine::long_help();
    text += "\n\nKinds:\n";
    for kind in KINDS {
        text += &format!("  {}: {}\n", kind.name, kind.summary);
        for param in kind.params {
            let key = format!("{}.{}", kind.name, param.name);
            let default =
                if param.name == MIPS { "1 in ktx2, else 0".to_owned() } else { param.default.to_string() };
            text += &format!("      {key}={default} ({} to {}): {}\n", param.min, param.max, param.summary);
        }
    }
    text
}

impl Arguments {
    /// Returns the file that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: vec![&mut self.height], ..Files::default() }
    }

    /// Refuses a folder where a height map is needed.
    pub(super) fn refuse_folder(&self) -> Result<(), Failure> {
        let name = self.height.display();
        if self.height.is_dir() {
            return Err(Failure::Usage(format!(
                "{name}: this is a folder: --kind bakes a height map; give its file, or the whole folder an \
                 engine with --for"
            )));
        }
        if self.engine.folder.udim.is_some() || self.engine.folder.green.is_some() {
            return Err(Failure::usage("--udim and --green are for folders of textures: add --for"));
        }
        if let Some(flag) = self.engine.folder.maps.first() {
            return Err(Failure::Usage(format!("{flag} names a map of a material for an engine: add --for")));
        }
        Ok(())
    }

    /// Returns the format of a kind's files.
    pub(super) fn format_of(&self, kind: &Kind) -> FileFormat {
        let usual = match self.texels {
            TexelChoice::Float => FileFormat::Exr,
            _ if kind.is_picture => FileFormat::Png,
            _ => FileFormat::Exr,
        };
        self.file().map(|file| file.format).or(self.format).unwrap_or(usual)
    }

    /// Returns the file to write, if the output is a file and not a folder.
    pub(super) fn file(&self) -> Option<OutputFile> {
        let ending = self.output.extension()?.to_str()?.to_ascii_lowercase();
        let format = FileFormat::ALL.into_iter().find(|format| format.extension() == ending)?;
        let (name, stem) = (self.output.file_name()?.to_str()?, self.output.file_stem()?.to_str()?);
        (!self.output.is_dir()).then(|| OutputFile { name: name.to_owned(), stem: stem.to_owned(), format })
    }

    /// Returns the folder that files are written into.
    pub(super) fn folder(&self) -> &Path {
        match self.file() {
            None => &self.output,
            Some(_) => match self.output.parent() {
                Some(folder) if !folder.as_os_str().is_empty() => folder,
                _ => Path::new("."),
            },
        }
    }

    /// Checks that a single file can be written, if one is asked for.
    pub(super) fn check_file(&self, kinds: usize) -> Result<(), Failure> {
        let Some(file) = self.file() else { return Ok(()) };
        let name = self.output.display();
        if kinds != 1 {
            return Err(Failure::Usage(format!(
                "--output {name}: one file cannot hold {kinds} kinds: give the name of a folder"
            )));
        }
        if let Some(format) = self.format.filter(|format| *format != file.format) {
            let [ending, format] = [file.format, format].map(FileFormat::extension);
            return Err(Failure::Usage(format!(
                "--output {name}: the ending says {ending}, --format says {format}: leave --format out"
            )));
        }
        if !self.folder().is_dir() {
            let folder = self.folder().display();
            return Err(Failure::Work(format!(
                "{name}: cannot be written: there is no folder {folder}: make it first"
            )));
        }
        Ok(())
    }
}

/// A single file to write.
pub(super) struct OutputFile {
    pub(super) name: String,
    pub(super) stem: String,
    pub(super) format: FileFormat,
}
