//! `relief render`: renders a scene to a picture. Baked maps that the method reads are baked first
//! and cached.

mod baked_maps;
mod frames;
mod output;
mod report;
mod sheet;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use relief_core::Watch;
use relief_maps::Maps;
use relief_render::false_color::{QUANTITIES, Quantity, quantity};
use relief_render::{RenderError, RenderInfo, Renderer};
use relief_scene::{BackendChoice, Sampling, Scene, SceneSpec};

pub use self::baked_maps::CacheArguments;
pub use self::output::Outputs;
use self::output::{Bits, Counts, StreamFormat};
use self::report::Picture;
use super::maps::{self, By};
use super::numbered::Numbering;
use super::scene_arguments::{MachineArguments, SceneArguments, of_scene};
use crate::failure::Failure;
use crate::frames::Frames;
use crate::progress::{Progress, TaskProgress};
use crate::streams::{Files, Written, tell_written};
use crate::{advice, interrupt, lanes, say};

/// Arguments of `relief render`. Flags override the scene file.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief render data/bricks.png -o bricks.png\n  \
    relief render scenes/jacksboro.toml --size 1600x1200 --samples 16 -o jacksboro.png\n  \
    relief render --height dem.tif --view top --projection orthographic -o map.png\n  \
    relief render --height map.exr --method occlusion --set search.steps=64 --aov aov.exr -o map.png\n  \
    relief render --height wave_%04d.png --frames 0..47 --eye 0.6,0.9,1.1 -o out_%04d.png\n  \
    relief render data/bricks.png --show height,steps -o numbers.png\n  \
    relief render data/bricks.png --methods parallax,relief,cone --show error -o errors.png\n\n\
    `relief methods` lists methods, searches and refinements with their settings; `relief render --help` \
    lists every flag.")]
pub struct Arguments {
    /// Picture to write: PNG or JPEG in sRGB, EXR in linear light; - for standard output
    #[arg(short, long, value_name = "FILE.png|jpg|exr")]
    output: PathBuf,
    /// Format of a picture on standard output, as in -o - --format png
    #[arg(long, value_enum, value_name = "png|jpg|exr", hide_short_help = true)]
    format: Option<StreamFormat>,
    /// Bits per channel of a PNG: 8 or 16 [default: 8]
    #[arg(long, value_name = "BITS")]
    bits: Option<Bits>,
    /// Also write AOVs, the values of each pixel's centre, as 32-bit float channels: hit (1 or 0),
    /// uv.x, uv.y, height (0 to 1), P.x, P.y, P.z (position), N.x, N.y, N.z (normal), depth (along
    /// the view axis), reads (of maps), steps (of search and refinement), bytes (that the reads
    /// fetch), lit (share of the first light that arrives), level (of detail), z (depth buffer, see
    /// --clip), surface (its number) and transmittance (share of its light that comes through
    /// translucent surfaces). Where the CPU renders `exact`, reads and steps count nodes and cells of
    /// the exact tracer
    #[arg(long, value_name = "FILE.exr")]
    aov: Option<PathBuf>,
    /// Render one picture per frame number from A to B, inclusive, as in 0..47. The number replaces
    /// %d, or %04d with leading zeros, once in each name: --output, --aov, and the files that scene
    /// and flags name (maps, textures, object, mesh, environment). %% is then a percent
    /// sign. All files are checked before the first frame. Each picture is the same as if rendered
    /// alone: fix the camera with --eye and --target, and the --range of float maps
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    frames: Option<Frames>,
    /// Draw the base mesh's edges over the picture, hidden ones faintly
    #[arg(long, hide_short_help = true, conflicts_with = "show")]
    wire: bool,
    #[arg(
        long,
        value_name = "NAME,..",
        value_delimiter = ',',
        value_parser = quantity,
        conflicts_with_all = ["aov", "frames", "bits"],
        help = show_help(),
    )]
    show: Vec<&'static Quantity>,
    /// Render several methods side by side, each with its name: methods, or pairs of a search and a
    /// refinement as linear+binary. With --show all of them share one scale. --set goes to the
    /// methods that have the setting
    #[arg(
        long,
        value_name = "A,B",
        value_delimiter = ',',
        conflicts_with_all = ["aov", "frames", "bits", "method", "search", "refine"],
        help_heading = "Method",
    )]
    methods: Vec<String>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    machine: MachineArguments,
    #[command(flatten)]
    cache: CacheArguments,
}

fn show_help() -> String {
    let each: Vec<String> =
        QUANTITIES.iter().map(|quantity| format!("{} ({})", quantity.name, quantity.title)).collect();
    format!(
        "Write numbers of each pixel in colours, with a legend, instead of the picture; several make a \
         sheet: {}. Where the CPU renders `exact`, reads and steps count nodes and cells of the exact tracer",
        each.join("; ")
    )
}

/// Renders the scene and writes its files.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let spec = arguments.machine.over(arguments.scene.spec()?);
    let numbering = Numbering::of(arguments.scene.file());
    if let Some(frames) = arguments.frames {
        return frames::run(arguments, &spec, &numbering, frames);
    }
    arguments.refuse_frames(&spec, &numbering)?;
    if !(arguments.show.is_empty() && arguments.methods.is_empty()) {
        return sheet::run(arguments, &spec);
    }
    let spec = spec.with_keys_of_meshes().map_err(of_scene)?;
    let outputs = Outputs::new(arguments, arguments.output.clone(), arguments.aov.clone(), &spec)?;
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    let mut renderer = PictureRenderer::new(arguments);
    let progress = TaskProgress::new(arguments.json);
    let (counts, made) = renderer.draw(&scene, &outputs, &|task, part| progress.show(task, part))?;
    drop(progress);
    if !arguments.json {
        renderer.notes(&spec, &scene, &made).iter().for_each(say::note);
    }
    let picture = Picture { spec: &spec, scene: &scene, outputs: &outputs, counts, made: &made };
    tell_written(arguments.json, |out| match arguments.json {
        true => Ok(writeln!(out, "{:#}", picture.as_json())?),
        false => Ok(picture.tell(out)?),
    })
}

/// Renderer of one scene after the other.
pub struct PictureRenderer {
    /// Whether the answer is JSON: then nothing is said meanwhile.
    quiet: bool,
    /// Whether the command line names a backend or a sampling.
    is_machine_named: bool,
    /// Baked maps.
    baked: Maps,
    /// Reason that the baked maps are not cached, if they are not.
    no_cache: Option<String>,
    /// Renderer of the scene before, with the backend and sampling that it was made for.
    renderer: Option<(BackendChoice, Sampling, Renderer)>,
}

impl PictureRenderer {
    fn new(arguments: &Arguments) -> Self {
        Self::with(&arguments.cache, arguments.machine.is_named(), arguments.json)
    }

    /// Creates a renderer for commands with these flags.
    pub fn with(cache: &CacheArguments, is_machine_named: bool, quiet: bool) -> Self {
        let (baked, no_cache) = cache.maps();
        Self { quiet, is_machine_named, baked, no_cache, renderer: None }
    }

    /// Renders into files, which take their names when they are whole.
    pub fn draw(
        &mut self,
        scene: &Scene,
        outputs: &Outputs,
        tell: &(dyn Fn(&str, f32) + Sync),
    ) -> Result<(Counts, RenderInfo), Failure> {
        let (quiet, is_machine_named) = (self.quiet, self.is_machine_named);
        let (renderer, baked) = self.for_scene(scene)?;
        // Until here nothing exists that an interrupted program would leave behind.
        let cancel = interrupt::catch()?;
        let written = outputs.write(scene, cancel, quiet, &mut |numbers, sink| {
            renderer.render_bands(scene, baked, numbers, &Watch::new(tell, cancel), sink)
        });
        written.map_err(|error| match error {
            output::Error::Render(error) => of_render(error, is_machine_named),
            output::Error::Failed(failure) => failure,
        })
    }

    /// Returns a renderer for a scene, and the baked maps.
    fn for_scene(&mut self, scene: &Scene) -> Result<(&mut Renderer, &mut Maps), Failure> {
        let Self { is_machine_named, baked, renderer, .. } = self;
        let (backend, sampling) = (scene.backend(), scene.sampling());
        // A GPU's renderer keeps its programs; one on the CPU holds data of other maps.
        let before = renderer.take().filter(|(for_backend, for_sampling, renderer)| {
            (*for_backend, *for_sampling) == (backend, sampling) && renderer.backend() == "gpu"
        });
        let (.., renderer) = renderer.insert(match before {
            Some(before) => before,
            None => {
                let made =
                    Renderer::new(backend, sampling).map_err(|error| of_render(error, *is_machine_named))?;
                (backend, sampling, made)
            }
        });
        renderer.set_lanes(lanes::from_environment()?);
        Ok((renderer, baked))
    }

    /// Returns notes on what a user may not expect of a picture.
    pub fn notes(&self, spec: &SceneSpec, scene: &Scene, made: &RenderInfo) -> Vec<String> {
        // Where no map was baked, nobody misses a cache.
        let no_cache = self.no_cache.clone().filter(|_| !made.maps.is_empty());
        let of_reading = maps::of_reading(spec, scene, By::Flags);
        let notes = of_reading.iter().map(ToString::to_string).chain(no_cache);
        notes.chain(made.maps.iter().filter_map(baked_maps::note)).collect()
    }
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(StreamFormat::ending);
        let picture = Written { flag: "--output", path: &mut self.output, format };
        let split = self.frames.map(|_| "--frames");
        Files { read: self.scene.files(), written: vec![picture], split }
    }

    /// Refuses names with a placeholder for a frame number where no frames are asked for.
    fn refuse_frames(&self, spec: &SceneSpec, numbering: &Numbering) -> Result<(), Failure> {
        let advice = "give the range with --frames, as in --frames 0..47";
        numbering.refuse(spec, advice)?;
        let outputs = [("--output", Some(&self.output)), ("--aov", self.aov.as_ref())];
        let of_flags = Numbering::of(None);
        match outputs.into_iter().find(|(_, path)| path.is_some_and(|path| of_flags.is_pattern(path))) {
            Some((flag, Some(path))) => {
                let path = path.display();
                let what = "the name has a placeholder for a frame number";
                Err(Failure::Usage(format!("{flag} {path}: {what}: {advice}")))
            }
            _ => Ok(()),
        }
    }
}

/// Turns a rendering's error into a failure. A sampling that the backend lacks is the command
/// line's fault if the command line named either.
fn of_render(error: RenderError, is_machine_named: bool) -> Failure {
    match error {
        RenderError::FastOnCpu { .. } if is_machine_named => {
            Failure::Usage(advice::with(&error, advice::of_render(&error)))
        }
        other => Failure::Work(advice::with(&other, advice::of_render(&other))),
    }
}
