//! `relief capture`: captures a mesh as a depth object, which is a set of images with depth.

mod report;
mod subject;

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Args;
use relief_core::object::JumpCells;
use relief_core::registry::UnknownName;
use relief_core::{ByteSize, Watch};
use relief_io::DEFAULT_MAX_BYTES;
use relief_io::file_set::{FileSetError, is_same_file};
use relief_object::{
    Arrangement, CaptureError, CaptureSettings, Captured, Capturer, Cover, DEFAULT_JUMP_TEXELS, MAX_PICTURES,
    Measured, ObjectFiles, ObjectWriter, Verification, WriteObjectError, read_views,
};

use self::report::CaptureReport;
use self::subject::Subject;
use super::inputs::replaced;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, tell_written};
use crate::waiting::waiting;
use crate::{interrupt, say, values};

/// Arguments of `relief capture`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Mesh: a glTF, GLB, OBJ, PLY or STL file, or a built-in mesh (cube, cylinder, sphere, torus).
    /// Or a scene file with one surface: its mesh in its place, displaced if it has a height map,
    /// with its color
    #[arg(value_name = "MESH|SCENE.toml")]
    input: PathBuf,
    /// Folder for the object's files; created if missing
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Directions of the images: cube, along the axes from both sides; octahedral, all around;
    /// hemi, the upper half; horizontal, around y; or the [[view]] tables of a file
    #[arg(long, value_name = "cube|octahedral|hemi|horizontal|FILE.toml", default_value_t)]
    views: Views,
    /// Images along a side of the octahedral or hemi grid, 2 to 32, or directions of horizontal
    /// [default: 8]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    grid: Option<u32>,
    /// Width and height of each image in texels, 8 to 16384
    #[arg(long, value_name = "PX", default_value = "209", allow_hyphen_values = true)]
    size: u32,
    /// Field of view of perspective images in degrees [default: orthographic images]
    #[arg(long, value_name = "DEGREES", value_parser = values::positive, allow_hyphen_values = true)]
    perspective: Option<f64>,
    /// Meaning of a texel's height: centre, the height at its centre; pixel, the highest point in
    /// it, so that nothing thin is lost; or auto, whichever is nearer to the mesh [default: auto;
    /// pixel with --verify 0]
    #[arg(long, value_name = "auto|centre|pixel")]
    cover: Option<CoverChoice>,
    /// Bits per depth: 32, floats in an EXR, or 16 or 8 in a PNG
    #[arg(long, value_name = "8|16|32", default_value = "32", allow_hyphen_values = true)]
    bits: u32,
    /// Number of pictures from random directions, 0 to 4096, that compare the object with the mesh
    #[arg(long, value_name = "N", default_value = "32", allow_hyphen_values = true)]
    verify: u32,
    /// Surface between texels that jump, in the comparison: bilinear, step, highest or nearest
    /// [default: highest]
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    cells: Option<JumpCells>,
    /// Difference in texels from which on cells jump, in the comparison [default: 4]
    #[arg(long, value_name = "TEXELS", allow_hyphen_values = true, hide_short_help = true)]
    jump: Option<f64>,
    /// Colour picture of the mesh, laid out by its texture coordinates [default: the picture of its
    /// material]
    #[arg(long, value_name = "FILE")]
    color: Option<PathBuf>,
    /// Replace files of these names in the folder even if no capture has written them
    #[arg(long)]
    force: bool,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief capture spot.obj -o spot                                  # six images along the axes\n  \
    relief capture tree.glb --views octahedral --grid 12 --size 128 -o tree  # an octahedral impostor\n  \
    relief capture rock.ply --views hemi --grid 7 --size 64 --bits 8 -o rock # for a camera above\n  \
    relief capture lamp.glb --perspective 40 --cover pixel -o lamp   # perspective, nothing thin lost\n\n\
    The object is solid where all of its images allow it: hollows that no image looks into are filled.\n\n\
    The folder gets object.toml, depth.exr (or .png), normal.png and, for a mesh with colours, color.png; \
    for octahedral grids also normal-depth.png, as engines have it. Colours are the base colour and picture \
    of a glTF's material; colours of vertices are not read. Both sides of triangles are captured.\n\n\
    The comparison gives the intersection over union (IoU) of the pixels that show object and mesh, and \
    their mean distance in percent of the diameter of the object's ball.";

/// Note on images that leave nothing of the object.
const NO_SOLID: &str = "the object is empty: what an image does not see is not solid, and a flat card is \
    seen by no image along it. --cover pixel with an odd --size keeps cards in the middle, and a mesh with \
    thickness stays. `relief render --method impostor-blend` shows images of --views octahedral or hemi all \
    the same";

/// Default of `--grid`: images along a side, or directions.
const DEFAULT_GRID: u32 = 8;

/// Arrangement of the images, by a name or a file.
#[derive(Clone, Debug, Default)]
enum Views {
    #[default]
    Cube,
    Octahedral,
    Hemi,
    Horizontal,
    File(PathBuf),
}

impl FromStr for Views {
    type Err = UnknownName;

    fn from_str(text: &str) -> Result<Self, UnknownName> {
        let named = [
            ("cube", Views::Cube),
            ("octahedral", Views::Octahedral),
            ("hemi", Views::Hemi),
            ("horizontal", Views::Horizontal),
        ];
        let path = PathBuf::from(text);
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
            return Ok(Views::File(path));
        }
        let names = named.each_ref().map(|(name, _)| *name);
        let known = named.into_iter().find(|(name, _)| *name == text).map(|(_, views)| views);
        known.ok_or_else(|| UnknownName::new("arrangement of views", text, names))
    }
}

impl fmt::Display for Views {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Views::Cube => f.write_str("cube"),
            Views::Octahedral => f.write_str("octahedral"),
            Views::Hemi => f.write_str("hemi"),
            Views::Horizontal => f.write_str("horizontal"),
            Views::File(path) => path.display().fmt(f),
        }
    }
}

/// Meaning of heights, or whichever is nearer to the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum CoverChoice {
    #[default]
    Auto,
    One(Cover),
}

const AUTO: &str = "auto";

impl FromStr for CoverChoice {
    type Err = UnknownName;

    fn from_str(text: &str) -> Result<Self, UnknownName> {
        if text == AUTO {
            return Ok(CoverChoice::Auto);
        }
        let names = [AUTO].into_iter().chain(Cover::ALL.map(Cover::name));
        text.parse().map(CoverChoice::One).map_err(|_: UnknownName| UnknownName::new("cover", text, names))
    }
}

impl fmt::Display for CoverChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CoverChoice::Auto => f.write_str(AUTO),
            CoverChoice::One(cover) => cover.fmt(f),
        }
    }
}

/// Reads the mesh, captures it, compares and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    arguments.check()?;
    let settings = arguments.settings()?;
    let subject = {
        let _reading = Progress::spinner("reading", arguments.json);
        Subject::read(arguments)?
    };
    if !arguments.json {
        subject.notes.iter().for_each(say::note);
        if arguments.cover.is_none() && arguments.verify == 0 {
            say::note(
                "--verify 0 compares nothing with the mesh, so --cover pixel is used, which loses nothing \
                 thin",
            );
        }
    }
    let capturer = Capturer::new(&subject.mesh, subject.colors.as_ref(), settings);
    let capturer = capturer.map_err(|error| arguments.of_capture(error))?;
    arguments.check_inputs(capturer.files(), &subject.inputs)?;
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let (folder, force) = (&arguments.output, arguments.force);
    let mut wait = waiting(folder, arguments.json, cancel);
    let writer = ObjectWriter::open(folder, capturer.files(), force, &mut wait);
    let writer = writer.map_err(|error| of_writing(error, cancel))?;
    let (captured, compared) = arguments.best(&capturer, cancel)?;
    let measured = compared.iter().find(|(cover, _)| *cover == captured.cover).map(|(_, measured)| measured);
    let is_solid = arguments.is_solid(&captured, measured)?;
    if !is_solid && !arguments.json {
        say::note(NO_SOLID);
    }
    let files = writer.write(&captured, measured).map_err(|error| of_writing(error, cancel))?;
    let seconds = started.elapsed().as_secs_f64();
    let open_edges = subject.mesh.measures().open_edges;
    let about = CaptureReport {
        captured: &captured,
        compared: &compared,
        files: &files,
        is_solid,
        open_edges,
        seconds,
    };
    tell_written(arguments.json, |out| Ok(about.tell(arguments, &subject, out)?))
}

impl Arguments {
    /// Returns the files that may be standard streams: none, as an object is a folder.
    pub fn files(&mut self) -> Files<'_> {
        Files::default()
    }

    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// Checks the arguments before any file is read.
    fn check(&self) -> Result<(), Failure> {
        let has_grid = matches!(self.views, Views::Octahedral | Views::Hemi | Views::Horizontal);
        if self.grid.is_some() && !has_grid {
            return Err(Failure::usage(
                "--grid needs --views octahedral, hemi or horizontal: add one, or leave it out",
            ));
        }
        if self.cover == Some(CoverChoice::Auto) && self.verify == 0 {
            return Err(Failure::usage(
                "--cover auto compares with the mesh, and --verify 0 does not: choose --cover centre or \
                 pixel",
            ));
        }
        let [most, _] = MAX_PICTURES;
        if self.verify > most {
            return Err(Failure::Usage(format!(
                "--verify: {} pictures are too many: give at most {most}",
                self.verify
            )));
        }
        match self.jump {
            Some(jump) if jump.is_nan() || jump < 0.0 => {
                Err(Failure::Usage(format!("--jump: {jump} cannot be used: it must be 0 or more")))
            }
            _ => Ok(()),
        }
    }

    /// Refuses an object that would replace a file that it is made from.
    fn check_inputs(&self, files: ObjectFiles, read: &[PathBuf]) -> Result<(), Failure> {
        let inputs: Vec<&Path> = read.iter().map(AsRef::as_ref).collect();
        // Of a file of views nothing else is read, whatever it names.
        let views = match &self.views {
            Views::File(path) => Some(path),
            _ => None,
        };
        for file in files.changed(&self.output) {
            let of_views = || views.filter(|views| is_same_file(&file, views)).cloned();
            if let Some(input) = replaced(&file, &inputs).or_else(of_views) {
                return Err(Failure::Usage(format!(
                    "--output {}: would replace the input {}: give another folder",
                    self.output.display(),
                    input.display()
                )));
            }
        }
        Ok(())
    }

    /// Returns the meaning of heights: without a comparison and a flag, the one that loses nothing
    /// thin.
    fn cover(&self) -> CoverChoice {
        let pixel = || if self.verify == 0 { CoverChoice::One(Cover::Pixel) } else { CoverChoice::Auto };
        self.cover.unwrap_or_else(pixel)
    }

    fn settings(&self) -> Result<CaptureSettings, Failure> {
        let grid = self.grid.unwrap_or(DEFAULT_GRID);
        let arrangement = match &self.views {
            Views::Cube => Arrangement::Cube,
            Views::Octahedral => Arrangement::Octahedral(grid),
            Views::Hemi => Arrangement::HemiOctahedral(grid),
            Views::Horizontal => Arrangement::Horizontal(grid),
            Views::File(path) => Arrangement::Given(read_views(path).map_err(Failure::work)?),
        };
        let Self { size, bits, perspective: fov_degrees, .. } = *self;
        Ok(CaptureSettings { arrangement, fov_degrees, size, bits, max_bytes: self.max_bytes() })
    }

    fn verification(&self) -> Verification {
        Verification {
            views: self.verify,
            cells: self.cells.unwrap_or_default(),
            jump_texels: self.jump.unwrap_or(DEFAULT_JUMP_TEXELS),
            ..Verification::default()
        }
    }

    /// Captures with each meaning of heights that is asked for, and returns the best images with
    /// all comparisons.
    fn best(
        &self,
        capturer: &Capturer,
        cancel: &AtomicBool,
    ) -> Result<(Captured, Vec<(Cover, Measured)>), Failure> {
        let covers = match self.cover() {
            CoverChoice::Auto => Cover::ALL.to_vec(),
            CoverChoice::One(cover) => vec![cover],
        };
        let mut best: Option<(Captured, Option<Measured>)> = None;
        let mut compared = Vec::new();
        for cover in covers {
            let captured = {
                let bar = Progress::bar("capturing", self.json);
                let tell = |_: &str, part: f32| bar.show(part);
                let watch = Watch::new(&tell, cancel);
                capturer.capture(cover, &watch).map_err(|error| self.of_capture(error))?
            };
            let measured = {
                let bar = Progress::bar("comparing", self.json);
                let tell = |_: &str, part: f32| bar.show(part);
                let watch = Watch::new(&tell, cancel);
                let measured = capturer.verify(&captured, &self.verification(), &watch);
                measured.map_err(|error| self.of_capture(error))?
            };
            compared.extend(measured.map(|measured| (cover, measured)));
            let is_better = match (&best, &measured) {
                (Some((_, Some(before))), Some(measured)) => measured.is_nearer_than(before),
                _ => best.is_none(),
            };
            if is_better {
                best = Some((captured, measured));
            }
        }
        let nothing = || Failure::work("there is nothing to capture");
        best.map(|(captured, _)| (captured, compared)).ok_or_else(nothing)
    }

    /// Whether anything of the object is solid.
    fn is_solid(&self, captured: &Captured, measured: Option<&Measured>) -> Result<bool, Failure> {
        let Verification { cells, jump_texels, .. } = self.verification();
        let object = captured.object(cells, jump_texels).map_err(Failure::work)?;
        Ok(measured.is_none_or(|measured| measured.iou > 0.0) && object.has_solid())
    }

    /// Turns an error of capturing into a failure, with the flag that helps.
    fn of_capture(&self, error: CaptureError) -> Failure {
        let flag = match &error {
            CaptureError::Cancelled(_) => return interrupt::cancelled(),
            CaptureError::BadSize(_) | CaptureError::Size(_) => "--size",
            CaptureError::BadGrid(_) => "--grid",
            CaptureError::BadCount(_) if self.grid.is_some() => "--grid",
            CaptureError::BadBits(_) => "--bits",
            CaptureError::BadPictures { .. } => "--verify",
            CaptureError::OwnFov => "--perspective",
            CaptureError::View { .. } if self.perspective.is_some() => "--perspective",
            CaptureError::TooMuchMemory { .. } => {
                return Failure::Work(format!(
                    "{error}: --max-memory raises the limit, a smaller --size needs less"
                ));
            }
            CaptureError::View { .. } | CaptureError::CutOff { .. } | CaptureError::BadCount(_) => {
                return Failure::Work(format!("{}: {error}", self.views));
            }
            CaptureError::Object(_) => return Failure::work(error),
        };
        Failure::Usage(format!("{flag}: {error}"))
    }
}

fn of_writing(error: WriteObjectError, cancel: &AtomicBool) -> Failure {
    match error {
        WriteObjectError::Set(FileSetError::Busy { .. }) if cancel.load(Ordering::Relaxed) => {
            interrupt::cancelled()
        }
        WriteObjectError::Stranger(_) => {
            Failure::Work(format!("{error}: move it away, give another --output, or replace it with --force"))
        }
        other => Failure::work(other),
    }
}
