//! Files that `relief render` writes: a picture, and AOVs. Both are written row by row while the
//! scene is rendered, so that pictures of any size fit into memory.

use std::io;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::ValueEnum;
use rayon::prelude::*;
use relief_core::Cancelled;
use relief_io::{
    LineSink, Metadata, PictureFormat, PictureSink, WriteProblem, write_exr_lines, write_picture,
};
use relief_render::picture::{AOV_CHANNELS, Display, aov_of, srgb};
use relief_render::{Bands, RenderError, RenderInfo, Wire};
use relief_scene::tone::Tone;
use relief_scene::{Scene, SceneSpec};
use relief_shaders::cpu::PixelOut;

use super::Arguments;
use crate::commands::numbered::files;
use crate::commands::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::interrupt::cancelled;

/// Least number of pixels of a row per core.
const ROW_PART: usize = 256;

/// Bits per channel of a PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bits {
    Eight,
    Sixteen,
}

impl FromStr for Bits {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, &'static str> {
        match text {
            "8" => Ok(Bits::Eight),
            "16" => Ok(Bits::Sixteen),
            _ => Err("a PNG has 8 or 16 bits per channel: give 8 or 16"),
        }
    }
}

/// Format of a picture on standard output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StreamFormat {
    Png,
    #[value(alias = "jpeg")]
    Jpg,
    Exr,
}

impl StreamFormat {
    /// Returns the ending of the names of such files.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Jpg => "jpg",
            Self::Exr => "exr",
        }
    }
}

/// Endings of pictures' names.
const PICTURES: [(&str, PictureFormat); 4] = [
    ("png", PictureFormat::Png8),
    ("jpg", PictureFormat::Jpeg),
    ("jpeg", PictureFormat::Jpeg),
    ("exr", PictureFormat::Exr),
];

/// Files to write.
pub struct Outputs {
    pub picture: PathBuf,
    pub format: PictureFormat,
    /// File of the AOVs.
    pub aov: Option<PathBuf>,
    wire: bool,
}

/// Reason that the files were not written.
pub enum Error {
    Render(RenderError),
    Failed(Failure),
}

impl From<Failure> for Error {
    fn from(failure: Failure) -> Self {
        Error::Failed(failure)
    }
}

/// Sums over the pixels of a picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Pixels that show a surface, at least in part.
    pub covered: usize,
    /// Pixels whose search ran out of steps.
    pub exhausted: usize,
    /// Reads of one sample per pixel.
    pub reads: u64,
}

/// Function that renders into a sink, with AOVs or without.
pub type Render<'a> = dyn FnMut(bool, &mut Bands) -> Result<RenderInfo, RenderError> + 'a;

impl Outputs {
    /// Creates the outputs of a scene. Outputs that cannot be written, or would replace an input,
    /// are refused before the work.
    pub fn new(
        arguments: &Arguments,
        picture: PathBuf,
        aov: Option<PathBuf>,
        spec: &SceneSpec,
    ) -> Result<Self, Failure> {
        let read = files(spec);
        let inputs: Vec<&Path> = read.iter().map(AsRef::as_ref).chain(arguments.scene.file()).collect();
        let mut format = format_of("--output", &picture, &PICTURES, &inputs)?;
        match (arguments.bits, format) {
            (None | Some(Bits::Eight), PictureFormat::Png8) | (None, _) => {}
            (Some(Bits::Sixteen), PictureFormat::Png8) => format = PictureFormat::Png16,
            (Some(_), _) => return Err(Failure::usage("--bits is for PNG: leave it out")),
        }
        if format.is_linear() && spec.tone.is_some_and(|tone| tone != Tone::None) {
            return Err(Failure::usage("an EXR holds linear light, without a tone curve: leave --tone out"));
        }
        if let Some(path) = &aov {
            format_of("--aov", path, &[("exr", ())], &inputs)?;
            if relief_io::file_set::is_same_file(path, &picture) || *path == picture {
                return Err(Failure::usage("--aov and --output name the same file: rename one"));
            }
        }
        Ok(Self { picture, format, aov, wire: arguments.wire })
    }

    /// Creates the output of a picture alone, whose name is known to be free.
    pub fn picture(picture: PathBuf) -> Option<Self> {
        let ending = picture.extension()?.to_string_lossy().to_ascii_lowercase();
        let (_, format) = PICTURES.into_iter().find(|(known, _)| *known == ending)?;
        Some(Self { picture, format, aov: None, wire: false })
    }

    /// Writes the files while the scene is rendered.
    pub fn write(
        &self,
        scene: &Scene,
        cancel: &AtomicBool,
        quiet: bool,
        render: &mut Render,
    ) -> Result<(Counts, RenderInfo), Error> {
        let paths: Vec<&Path> =
            [Some(&self.picture), self.aov.as_ref()].into_iter().flatten().map(AsRef::as_ref).collect();
        let mut staged = Staged::open(&paths, quiet, cancel)?;
        let picture = staged.aside(&self.picture)?;
        let aov = self.aov.as_ref().map(|path| staged.aside(path)).transpose()?;
        let mut ended = Err(Error::Render(RenderError::Cancelled(Cancelled)));
        // Writers pass on errors inside of them only as system errors.
        let mut draw = |picture: &mut PictureSink, numbers: Option<&mut LineSink>| -> io::Result<()> {
            ended = self.draw(scene, render, picture, numbers);
            if ended.is_ok() { Ok(()) } else { Err(io::Error::other("stopped")) }
        };
        let size = scene.size();
        let mut of_aov = None;
        let written = write_picture(&picture, size, self.format, |picture| match &aov {
            None => draw(picture, None),
            Some(path) => {
                let written = write_exr_lines(path, size, &AOV_CHANNELS, &Metadata::default(), |numbers| {
                    draw(picture, Some(numbers))
                });
                written.map_err(|error| {
                    of_aov = self.aov.as_ref().map(|path| failed(path, error.problem));
                    io::Error::other("stopped")
                })
            }
        });
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled().into());
        }
        // The first error says why.
        let ended = match (ended, written) {
            (Ok(ended), Ok(())) => ended,
            (Ok(_), Err(error)) => {
                return Err(of_aov.unwrap_or_else(|| failed(&self.picture, error.problem)).into());
            }
            (Err(error), _) => return Err(error),
        };
        staged.finish()?;
        Ok(ended)
    }

    /// Renders into the sinks of both files.
    fn draw(
        &self,
        scene: &Scene,
        render: &mut Render,
        picture: &mut PictureSink,
        mut numbers: Option<&mut LineSink>,
    ) -> Result<(Counts, RenderInfo), Error> {
        let is_linear = self.format.is_linear();
        let display = if is_linear { Display::of(scene).without_tone() } else { Display::of(scene) };
        let width = scene.size()[0] as usize;
        let mut wire = self.wire.then(|| Wire::new(scene));
        let mut counts = Counts::default();
        let mut next_row = 0;
        let mut planes = AOV_CHANNELS.map(|_| Vec::new());
        let mut row = |pixels: &[PixelOut]| -> Result<(), Failure> {
            let mut colours = display.linear_row(next_row, pixels);
            next_row += 1;
            // Light beyond the range of sRGB would shine through the lines.
            if !is_linear {
                colours.iter_mut().for_each(|colour| *colour = colour.map(|part| part.clamp(0.0, 1.0)));
            }
            if let Some(wire) = &mut wire {
                wire.next_row(pixels, &mut colours);
            }
            if !is_linear {
                colours.par_iter_mut().with_min_len(ROW_PART).for_each(|colour| *colour = srgb(*colour));
            }
            picture(&colours).map_err(|error| failed(&self.picture, WriteProblem::Io(error)))?;
            if let (Some(sink), Some(path)) = (&mut numbers, &self.aov) {
                planes.iter_mut().for_each(Vec::clear);
                for pixel in pixels {
                    for (plane, number) in planes.iter_mut().zip(aov_of(pixel)) {
                        plane.push(number);
                    }
                }
                let lines = planes.each_ref().map(Vec::as_slice);
                sink(&lines).map_err(|error| failed(path, WriteProblem::Io(error)))?;
            }
            counts.add(pixels);
            Ok(())
        };
        let mut stopped = None;
        let rendered =
            render(self.aov.is_some(), &mut |band| match band.chunks(width.max(1)).try_for_each(&mut row) {
                Ok(()) => Ok(()),
                Err(failure) => {
                    stopped = Some(failure);
                    Err(Cancelled)
                }
            });
        match (rendered, stopped) {
            (_, Some(failure)) => Err(failure.into()),
            (Ok(made), None) => Ok((counts, made)),
            (Err(error), None) => Err(Error::Render(error)),
        }
    }
}

impl Counts {
    fn add(&mut self, pixels: &[PixelOut]) {
        for pixel in pixels.iter().filter(|pixel| pixel.color.w > 0.0) {
            self.covered += 1;
            self.exhausted += pixel.exhausted as usize;
            self.reads += u64::from(pixel.reads);
        }
    }
}

fn failed(path: &Path, problem: WriteProblem) -> Failure {
    Failure::Work(format!("{}: {problem}", path.display()))
}
