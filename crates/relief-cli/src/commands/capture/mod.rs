//! `relief capture`: images with depth of a mesh, which together are an image-based object.

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

use self::report::About;
use self::subject::Subject;
use super::inputs::replaced;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, tell_written};
use crate::waiting::waiting;
use crate::{interrupt, say, values};

/// What `relief capture` is given.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Mesh: a glTF, GLB, OBJ, PLY or STL file, or a built-in one (cube, cylinder, sphere, torus); or a scene
    /// file with one surface, for its mesh in its place, displaced if it has a height map, and its color
    #[arg(value_name = "MESH|SCENE.toml")]
    input: PathBuf,
    /// Folder to write the object into; it is made if it is missing
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// From where: cube, along the axes from both sides; octahedral, all around; hemi, the upper half of it;
    /// horizontal, around y; or the [[view]] tables of a file
    #[arg(long, value_name = "cube|octahedral|hemi|horizontal|FILE.toml", default_value_t)]
    views: Views,
    /// Frames of a side of the grid of octahedral and hemi, or directions of horizontal [default: 8]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    grid: Option<u32>,
    /// Texels of a side of each image
    #[arg(long, value_name = "PX", default_value = "209", allow_hyphen_values = true)]
    size: u32,
    /// From eyes, with this field of view, in place of parallel rays
    #[arg(long, value_name = "DEGREES", value_parser = values::positive, allow_hyphen_values = true)]
    perspective: Option<f64>,
    /// What the height of a texel is: centre, that of what its centre shows; pixel, the highest point in it,
    /// so that nothing thin is lost; or auto, whichever is nearer to the mesh [default: auto, with --verify 0
    /// pixel]
    #[arg(long, value_name = "auto|centre|pixel")]
    cover: Option<CoverChoice>,
    /// Bits of a depth: 32, floats in an EXR, or 16 or 8 in a PNG
    #[arg(long, value_name = "8|16|32", default_value = "32", allow_hyphen_values = true)]
    bits: u32,
    /// Compare with the mesh in so many pictures from random directions, 0 for none
    #[arg(long, value_name = "N", default_value = "32", allow_hyphen_values = true)]
    verify: u32,
    /// What images are between texels that jump, when they are compared: bilinear, step, highest or nearest
    /// [default: highest]
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    cells: Option<JumpCells>,
    /// By how many texels cells differ that jump, when they are compared [default: 4]
    #[arg(long, value_name = "TEXELS", allow_hyphen_values = true, hide_short_help = true)]
    jump: Option<f64>,
    /// Colour picture of the mesh, laid out by its texture coordinates, in place of that of its material
    #[arg(long, value_name = "FILE")]
    color: Option<PathBuf>,
    /// Replace files of the object's names in the folder that no capture has written
    #[arg(long)]
    force: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// Refuse to take more memory than this, as in 512MiB [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief capture spot.obj -o spot                                  # six images along the axes\n  \
    relief capture tree.glb --views octahedral --grid 12 --size 128 -o tree  # as engines' impostors\n  \
    relief capture rock.ply --views hemi --grid 7 --size 64 --bits 8 -o rock # for a camera above\n  \
    relief capture lamp.glb --perspective 40 --cover pixel -o lamp   # from eyes, nothing thin lost\n\n\
    An object is what all of its images say may be solid: hollows that no image looks into are filled. The \
    folder gets object.toml, depth.exr (or .png), normal.png and, of a mesh with colours, color.png; of \
    octahedral grids normal-depth.png, too, as engines have it. Colours are those of a glTF's material: its \
    base colour and picture; colours of vertices are not read. Both sides of triangles are seen. The \
    comparison counts the pixels that show object and mesh of those that show either (IoU) and says how far \
    apart they are on the mean, in percent of the ball's diameter.";

/// What is said of images that leave nothing of the object.
const NO_SOLID: &str = "nothing of the object is left: a single card is seen by no image along it, and what \
    an image does not see is not solid. --cover pixel with an odd --size keeps cards in the middle, and a mesh \
    with thickness stays; images of --views octahedral or hemi are shown all the same by `relief render \
    --method impostor-blend`";

/// Frames of a side, or directions, unless told otherwise.
const DEFAULT_GRID: u32 = 8;

/// From where, by a name or a file.
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

/// What heights are, or whichever is better.
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

/// Reads, captures, compares and writes.
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
            say::note("nothing is compared with the mesh: --cover pixel is taken, which loses nothing thin");
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
    let about =
        About { captured: &captured, compared: &compared, files: &files, is_solid, open_edges, seconds };
    tell_written(arguments.json, |out| Ok(about.tell(arguments, &subject, out)?))
}

impl Arguments {
    /// The files that may be standard streams: none, as an object is a folder.
    pub fn files(&mut self) -> Files<'_> {
        Files::default()
    }

    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// What can be judged before any file is read.
    fn check(&self) -> Result<(), Failure> {
        let has_grid = matches!(self.views, Views::Octahedral | Views::Hemi | Views::Horizontal);
        if self.grid.is_some() && !has_grid {
            return Err(Failure::usage("--grid needs --views octahedral, hemi or horizontal"));
        }
        if self.cover == Some(CoverChoice::Auto) && self.verify == 0 {
            return Err(Failure::usage(
                "--cover auto compares with the mesh, which --verify 0 does not: choose centre or pixel",
            ));
        }
        let [most, _] = MAX_PICTURES;
        if self.verify > most {
            return Err(Failure::Usage(format!(
                "--verify: {} pictures are too many: at most {most}",
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

    /// Refuses an object that would replace what it is made from.
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
                    "--output {}: would replace {}, which is read: give another folder",
                    self.output.display(),
                    input.display()
                )));
            }
        }
        Ok(())
    }

    /// What heights are: where nothing is compared, and nothing is said, those that lose nothing thin.
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

    /// The images to be written, and how far they, and others that were tried, are from the mesh.
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

    /// Whether anything of the object is left.
    fn is_solid(&self, captured: &Captured, measured: Option<&Measured>) -> Result<bool, Failure> {
        let Verification { cells, jump_texels, .. } = self.verification();
        let object = captured.object(cells, jump_texels).map_err(Failure::work)?;
        Ok(measured.is_none_or(|measured| measured.iou > 0.0) && object.has_solid())
    }

    /// Why there are no images, with the flag that would help.
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
                    "{error}: --max-memory raises it, a smaller --size needs less"
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
