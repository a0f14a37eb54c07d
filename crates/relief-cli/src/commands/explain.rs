//! `relief explain`: draws how a method finds its hit.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use relief_compare::explain::{Cut, Ray, RayError};
use relief_compare::figure::Figure;
use relief_core::Watch;
use relief_io::{PngColour, write_png8};
use relief_scene::{Look, SceneSpec, Surface};
use relief_shaders::cpu::{Mark, MethodTracer};
use relief_shaders::field::Solids;
use relief_shaders::{GEOMETRY, METHODS, REFINE, SEARCH, Selection};
use serde_json::{Value, json};

use super::inputs::replaced;
use super::maps::{self, By};
use super::method_set::sample;
use super::numbered::{Numbering, ONE_FRAME, files};
use super::render::CacheArguments;
use super::scene_arguments::{SceneArguments, of_scene};
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, tell_written};
use crate::{interrupt, say, units, values};

/// Arguments of `relief explain`. Flags override the scene file.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
    relief explain                          # the exact method on the sample cobbles\n  \
    relief explain rock.png --method cone --angle 75 -o cone.svg\n  \
    relief explain rock.png --search linear --refine binary --frames -o steps.png\n  \
    relief explain rock.png --method sphere-tracing --at 0.3,0.6 --direction 45\n  \
    relief explain rock.png --method exact --radius 0.2 --json   # over a base that curves away\n\n\
    The drawing is a cut along the ray. It shows where the ray is at each turn of the method's loops, what \
    the turn looked at (cones, boxes, balls, patches, brackets), the method's hit and the true first hit. \
    The turns are made by the method's own code.")]
pub struct Arguments {
    /// Drawing to write, .svg or .png
    #[arg(short, long, value_name = "FILE", default_value = "explain.svg")]
    output: PathBuf,
    /// Also write a drawing of each turn, as FILE-1, FILE-2 and so on
    #[arg(long)]
    frames: bool,
    /// Print the result as one JSON object: all turns with what they looked at
    #[arg(long)]
    pub json: bool,

    /// Angle between the ray and the normal in degrees, 0 to 89.9
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = Ray::default().angle_deg,
        allow_hyphen_values = true,
        help_heading = "Ray"
    )]
    angle: f64,
    /// Direction of the ray on the surface in degrees: 0 toward greater u, 90 toward greater v
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = Ray::default().direction_deg,
        allow_hyphen_values = true,
        help_heading = "Ray"
    )]
    direction: f64,
    /// Texture coordinates where the ray enters the relief, at height 1
    #[arg(
        long,
        value_name = "U,V",
        value_parser = values::pair,
        default_value = "0.2,0.8",
        allow_hyphen_values = true,
        help_heading = "Ray"
    )]
    at: [f64; 2],
    /// Radius by which the base curves away under the ray, so that the ray bends; negative: toward
    /// the ray [default: a flat base]
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Ray"
    )]
    radius: Option<f64>,

    #[command(flatten)]
    cache: CacheArguments,
    #[command(flatten)]
    scene: SceneArguments,
}

/// Most turns that get a drawing each.
const MOST_FRAMES: usize = 999;

/// A file format of drawings.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
}

/// Reads the map, traces the ray and writes the drawings.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut spec = arguments.spec()?;
    let _sample = sample(&mut spec)?;
    let read = files(&spec);
    let inputs: Vec<&Path> = read.iter().map(AsRef::as_ref).collect();
    let format =
        format_of("--output", &arguments.output, &[("svg", Format::Svg), ("png", Format::Png)], &inputs)?;
    let cancel = interrupt::catch()?;
    let surface = arguments.surface(&spec)?;
    let heights = &**surface.height_map();
    let path = arguments.ray().path(heights, surface.metric()).map_err(of_ray)?;
    let selection = surface.selection();
    let progress = Progress::bar("baking", arguments.json);
    let tell = |_: &str, part: f32| progress.show(part);
    let (mut baked, uncached) = arguments.cache.maps();
    uncached.iter().for_each(say::note);
    let provided = baked.provide(selection, heights, surface.metric(), &Watch::new(&tell, cancel));
    let provided = provided.map_err(Failure::work)?;
    drop(progress);
    let explanation = MethodTracer::over(heights, selection, provided.slots()).explain(&path);
    let cut = Cut::new(name_of(selection), heights, path, explanation);
    let turns = cut.explanation().turns();
    if arguments.frames && turns > MOST_FRAMES {
        return Err(Failure::Usage(format!(
            "--frames: the method takes {turns} turns, and at most {MOST_FRAMES} are drawn one by one: give \
             a smaller --angle, or leave --frames out"
        )));
    }
    let frames = if arguments.frames { turns } else { 0 };
    let names: Vec<PathBuf> = (1..=frames).map(|turn| arguments.frame(turn, frames)).collect();
    if let Some((name, input)) = names.iter().find_map(|name| Some((name, replaced(name, &inputs)?))) {
        let (name, input) = (name.display(), input.display());
        return Err(Failure::Usage(format!(
            "--frames: {name} would replace the input {input}: give --output another name"
        )));
    }
    let outputs: Vec<&Path> = std::iter::once(&arguments.output).chain(&names).map(AsRef::as_ref).collect();
    let mut staged = Staged::open(&outputs, arguments.json, cancel)?;
    let drawing = Progress::bar("drawing", arguments.json);
    for (number, output) in outputs.iter().enumerate() {
        Watch::new(&|_, _| {}, cancel).check().map_err(|_| interrupt::cancelled())?;
        drawing.show(number as f32 / outputs.len() as f32);
        // The first is the drawing of all turns.
        let figure = cut.figure((number > 0).then_some(number));
        write(&mut staged, output, &figure, format)?;
    }
    drop(drawing);
    staged.finish()?;
    arguments.tell(&cut, frames)
}

/// Returns the names of search and refinement, after the method's that has both, if there is one.
fn name_of(selection: &Selection) -> String {
    let names = |of: &Selection| [GEOMETRY, SEARCH, REFINE].map(|stage| of.choices[stage].entry.name);
    let is_same = |name: &str| Selection::method(name).is_ok_and(|method| names(&method) == names(selection));
    let pair = format!("search {}, refinement {}", selection.search().name, selection.refine().name);
    match METHODS.iter().find(|method| is_same(method.name)) {
        Some(method) => format!("{}: {pair}", method.name),
        None => pair,
    }
}

fn write(staged: &mut Staged, output: &Path, figure: &Figure, format: Format) -> Result<(), Failure> {
    match format {
        Format::Svg => staged.write(output, figure.svg()),
        Format::Png => {
            let aside = staged.aside(output)?;
            let failed = |what: String| Failure::Work(format!("{}: {what}", output.display()));
            let ([width, height], pixels) =
                figure.pixels().ok_or_else(|| failed("the drawing is too large: write an SVG".to_owned()))?;
            write_png8(&aside, width, height, PngColour::Rgb, &pixels)
                .map_err(|error| failed(error.problem.to_string()))
        }
    }
}

/// Turns an error of the ray into a failure, with the flag that helps.
fn of_ray(error: RayError) -> Failure {
    let flag = match error {
        RayError::Angle(_) => "--angle",
        RayError::NotFinite(_) => "--at, --direction",
        RayError::Radius(_) => "--radius",
        RayError::Flat => "--scale",
    };
    Failure::Usage(format!("{flag}: {error}"))
}

impl Arguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.scene.files(), ..Files::default() }
    }

    fn ray(&self) -> Ray {
        Ray { at: self.at, angle_deg: self.angle, direction_deg: self.direction, radius_m: self.radius }
    }

    /// Returns the name of the drawing of a turn, with as many digits as the last one has.
    fn frame(&self, turn: usize, turns: usize) -> PathBuf {
        let digits = turns.to_string().len();
        let stem = self.output.file_stem().unwrap_or_default().to_string_lossy();
        let extension = self.output.extension().unwrap_or_default().to_string_lossy();
        self.output.with_file_name(format!("{stem}-{turn:0digits$}.{extension}"))
    }

    /// Returns the scene's description: one frame, and the finest level of the map.
    fn spec(&self) -> Result<SceneSpec, Failure> {
        let spec = self.scene.spec()?;
        Numbering::of(self.scene.file()).refuse(&spec, ONE_FRAME)?;
        Ok(spec.at_finest_level())
    }

    /// Returns the only surface: a height map with a method that follows rays.
    fn surface(&self, spec: &SceneSpec) -> Result<Surface, Failure> {
        // Nothing is rendered.
        let spec = SceneSpec {
            size: Some([1, 1].into()),
            samples: Some(1),
            look: Some(Look::Plain),
            ..spec.clone()
        };
        let scene = {
            let _reading = Progress::spinner("reading", self.json);
            spec.load().map_err(of_scene)?
        };
        if !self.json {
            maps::of_reading(&spec, &scene, By::Flags).iter().for_each(say::note);
        }
        let [surface] = scene.surfaces() else {
            return Err(Failure::usage("several surfaces: a drawing shows one: give one height map"));
        };
        if surface.object().is_some() {
            return Err(Failure::usage("a depth object: only methods over height maps are drawn"));
        }
        if surface.solids() != Solids::Heights {
            let shown = surface.solids().in_words();
            return Err(Failure::Usage(format!("{shown}: only methods over height maps are drawn")));
        }
        let selection = surface.selection();
        if selection.geometry().is_some() {
            return Err(Failure::Usage(format!(
                "{}: draws triangles or slices and searches no rays: give --method another method",
                selection.choices[GEOMETRY].entry.name
            )));
        }
        Ok(surface.clone())
    }

    fn tell(&self, cut: &Cut, frames: usize) -> Result<(), Failure> {
        let path = self.output.display();
        tell_written(self.json, |out| {
            if self.json {
                return Ok(writeln!(out, "{:#}", self.record(cut, frames))?);
            }
            writeln!(out, "{path}: {}", cut.summary())?;
            if frames > 0 {
                let (first, last) = (self.frame(1, frames), self.frame(frames, frames));
                writeln!(out, "{} to {}: a drawing for each turn", first.display(), last.display())?;
            }
            Ok(())
        })
    }

    fn record(&self, cut: &Cut, frames: usize) -> Value {
        let explanation = cut.explanation();
        let hit = &explanation.hit;
        let names: Vec<String> =
            (1..=frames).map(|turn| self.frame(turn, frames).display().to_string()).collect();
        json!({
            "output": self.output.display().to_string(),
            "frames": names,
            "summary": cut.summary(),
            "turns": explanation.turns(),
            "reads": hit.cost.reads,
            "bytes": hit.cost.bytes,
            "found": hit.found,
            "exhausted": hit.exhausted,
            "t": hit.t, "uv": hit.uv, "height": hit.height,
            "true": { "found": cut.truth().found, "t": cut.truth().t, "uv": cut.truth().uv },
            "texels_off": cut.texels_off(),
            "search": explanation.search.iter().map(record).collect::<Vec<_>>(),
            "search_found": explanation.found.description(),
            "interval": explanation.interval,
            "refinement": explanation.refinement.iter().map(record).collect::<Vec<_>>(),
        })
    }
}

/// Returns a mark as JSON. Every `t` is metres along the ray.
fn record(mark: &Mark) -> Value {
    match *mark {
        Mark::Turn { t } => json!({ "turn": t }),
        Mark::Sample { t } => json!({ "sample": t }),
        Mark::Patch { low, high, from, to } => json!({ "patch": { "uv": [low, high], "t": [from, to] } }),
        Mark::Box { low, high, top } => json!({ "box": { "uv": [low, high], "top": top } }),
        Mark::Cone { uv, apex, slope } => json!({ "cone": { "uv": uv, "apex": apex, "slope": slope } }),
        Mark::Frustum { low, high, top, slopes } => {
            json!({ "frustum": { "uv": [low, high], "top": top, "slopes": slopes } })
        }
        Mark::Ball { t, radius } => json!({ "ball": { "t": t, "radius": radius } }),
        Mark::Bracket { near, far } => json!({ "bracket": [near, far] }),
        Mark::Chord { ends, gaps } => json!({ "chord": { "t": ends, "gaps": gaps } }),
        Mark::Plane { t, height, rise } => json!({ "plane": { "t": t, "height": height, "rise": rise } }),
    }
}
