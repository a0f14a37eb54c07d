//! `relief render`: a scene to a picture. A baked map that the method reads is baked first and kept in a
//! cache.

mod baked_maps;
mod output;
mod report;

use std::path::PathBuf;

use clap::Args;
use relief_render::{RenderError, Renderer};

use self::baked_maps::CacheArguments;
use self::output::{Bits, Outputs, StreamFormat};
use super::maps;
use super::scene_arguments::{MachineArguments, SceneArguments, of_scene};
use crate::failure::Failure;
use crate::progress::{Progress, TaskProgress};
use crate::streams::{Files, Written, answer};
use crate::{advice, interrupt, lanes, say};

/// What `relief render` is given. Flags override the scene file.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief render --height data/bricks.png -o bricks.png\n  \
    relief render scenes/jacksboro.toml --size 1600x1200 --samples 16 -o jacksboro.png\n  \
    relief render --height dem.tif --view top --projection orthographic -o map.png\n  \
    relief render --height map.exr --method occlusion --set search.steps=64 --aov map-aov.exr -o map.png\n\n\
    `relief methods` lists methods, searches and refinements with their settings; `relief render --help` lists \
    every flag.")]
pub struct Arguments {
    /// Picture to write: PNG and JPEG in sRGB, EXR as linear light; - for the standard output
    #[arg(short, long, value_name = "FILE.png|jpg|exr")]
    output: PathBuf,
    /// Format of a picture that goes to the standard output, as in -o - --format png
    #[arg(long, value_enum, value_name = "png|jpg|exr", hide_short_help = true)]
    format: Option<StreamFormat>,
    /// Bits of a sample in a PNG: 8 or 16 [default: 8]
    #[arg(long, value_name = "BITS")]
    bits: Option<Bits>,
    /// Write numbers of every pixel's centre, too, as 32-bit float channels: hit (1 or 0), uv.x and uv.y,
    /// height (0 to 1), P.x, P.y and P.z (position), N.x, N.y and N.z (normal), depth (along the view axis),
    /// reads (of maps), steps (turns of the search's and the refinement's loops), bytes (that the reads
    /// fetch), lit (the part of the first light that arrives) and level (of detail). Where the CPU renders
    /// `exact`, reads and steps are nodes and cells of its tracer
    #[arg(long, value_name = "FILE.exr")]
    aov: Option<PathBuf>,
    /// Draw the edges of the base meshes over the picture, faint where they are behind what is seen
    #[arg(long, hide_short_help = true)]
    wire: bool,
    /// Print one JSON object about the picture
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    machine: MachineArguments,
    #[command(flatten)]
    cache: CacheArguments,
}

/// Renders and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let spec = arguments.machine.over(arguments.scene.spec()?).with_keys_of_meshes().map_err(of_scene)?;
    let outputs = Outputs::new(arguments, &spec)?;
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    let (mut kept, no_cache) = arguments.cache.maps();
    let renderer = Renderer::new(scene.backend(), scene.sampling());
    let mut renderer = renderer.map_err(|error| arguments.of_render(error))?;
    renderer.set_lanes(lanes::from_environment()?);
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let progress = TaskProgress::new(arguments.json);
    let told = |task, part| progress.show(task, part);
    let written = outputs.write(&scene, cancel, arguments.json, &mut |numbers, sink| {
        renderer.render_bands(&scene, &mut kept, numbers, &told, cancel, sink)
    });
    let (counts, made) = written.map_err(|error| match error {
        output::Error::Render(error) => arguments.of_render(error),
        output::Error::Failed(failure) => failure,
    })?;
    drop(progress);
    // Where no map was baked nobody misses a place to keep it.
    let no_cache = no_cache.filter(|_| !made.maps.is_empty());
    if !arguments.json {
        let notes = maps::of_reading(&spec, &scene).into_iter().chain(no_cache);
        for note in notes.chain(made.maps.iter().filter_map(baked_maps::note)) {
            say::note(note);
        }
    }
    answer(|out| report::tell(arguments, &spec, &scene, &counts, &made, out))
}

impl Arguments {
    /// The files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(StreamFormat::ending);
        let picture = Written { flag: "--output", path: &mut self.output, format };
        Files { read: self.scene.files(), written: vec![picture], ..Files::default() }
    }

    /// A sampling that the backend does not have is the command line's fault when the command line named one
    /// of them.
    fn of_render(&self, error: RenderError) -> Failure {
        match error {
            RenderError::FastOnCpu { .. } if self.machine.is_named() => {
                Failure::Usage(advice::with(&error, advice::of_render(&error)))
            }
            other => Failure::Work(advice::with(&other, advice::of_render(&other))),
        }
    }
}
