//! `relief compare`: compares methods with exact hits and with each other, as a page, records and a
//! table.

mod report;

use std::path::{Path, PathBuf};

use clap::Args;
use relief_compare::{Compared, Comparison, Goal, Ranking, Timing, choose, csv, page, with_other_steps};
use relief_core::MapFormat;
use relief_scene::Look;

use super::method_set::{
    MethodSet, MethodSetArguments, Unnamed, as_json, compared, look_again, of_comparison,
};
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::streams::{Files, answer};
use crate::{interrupt, units, values};

/// Arguments of `relief compare`. Flags override the scene file.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  relief compare                    # eight methods on the sample cobbles\n  \
    relief compare --methods all -o all.html\n  \
    relief compare --height wall.png --scales 2cm,10cm -o wall.html\n  \
    relief compare --methods relief,occlusion --steps 8,16,32,64 --csv steps.csv\n  \
    relief compare --methods cone,linear+true-secant --angles 60,85 --rays 100000\n  \
    relief compare --height wall.png --backend cpu --budget-ms 40   # the best within 40 ms\n  \
    relief compare --methods cone,frustum --texels float,half,unorm8 --shadow none,ray,horizon\n  \
    relief compare --methods relief,cone,vertex --distances 1,2,4,8\n  \
    relief compare scenes/jacksboro.toml --geometry none,vertex --json\n\n\
    --geometry and --shadow also take several names. Rays at an angle are compared with the exact first hit, \
    pictures with the exact picture, and their pixels' hits with its hits. The page sorts its figures and \
    plots any of them against any other, without network.\n\n\
    If no method keeps --budget-ms or --max-error, the page is written, the nearest method is named, and the \
    exit code is 1."
)]
pub struct Arguments {
    /// HTML page to write
    #[arg(short, long, value_name = "PAGE.html", default_value = "comparison.html")]
    output: PathBuf,
    /// Also write all figures as JSON
    #[arg(long, value_name = "FILE.json")]
    records: Option<PathBuf>,
    /// Also write all figures as comma-separated values
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print the result as one JSON object: all figures
    #[arg(long)]
    pub json: bool,

    /// Numbers of steps to try, one row each: the steps of the search, else the search's limit,
    /// else the steps of the refinement [default: each method's own]
    #[arg(
        long,
        value_name = "N,..",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "What is tried"
    )]
    steps: Vec<u32>,
    /// Angles between rays and normal in degrees, on flat meshes
    #[arg(
        long,
        value_name = "DEGREES,..",
        value_delimiter = ',',
        default_value = "10,30,60,85",
        allow_hyphen_values = true,
        help_heading = "What is tried"
    )]
    angles: Vec<f64>,
    /// Displacements in metres between heights 0 and 1 [default: 0.05,0.15; a scene's own; with
    /// --budget-ms or --max-error the usual one]
    #[arg(
        long,
        value_name = "M,..",
        value_delimiter = ',',
        value_parser = units::length,
        allow_hyphen_values = true,
        conflicts_with = "scale",
        help_heading = "What is tried"
    )]
    scales: Vec<f64>,
    /// Longer sides of the height map in texels; reached by halving it [default: as it is]
    #[arg(
        long,
        value_name = "N,..",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "What is tried"
    )]
    map_sizes: Vec<u32>,
    /// Distances in metres from the camera to the point that it looks at [default: as it is]
    #[arg(
        long,
        value_name = "M,..",
        value_delimiter = ',',
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "What is tried"
    )]
    distances: Vec<f64>,
    /// Storage of baked maps: float (32 bits), half (16) or unorm8 [default: float]
    #[arg(
        long,
        value_name = "float,half,unorm8",
        value_delimiter = ',',
        conflicts_with_all = ["budget_ms", "max_error"],
        help_heading = "What is tried"
    )]
    texels: Vec<MapFormat>,
    /// Number of rays per method and angle, 1 to 100000000 [default: 20000]
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=100_000_000),
        allow_hyphen_values = true,
        help_heading = "What is tried"
    )]
    rays: Option<u32>,
    /// Name the method with the least error whose frames of --size take at most this many
    /// milliseconds on --backend
    #[arg(
        long,
        value_name = "MS",
        value_parser = values::positive,
        allow_hyphen_values = true,
        conflicts_with = "max_error",
        help_heading = "What is chosen"
    )]
    budget_ms: Option<f64>,
    /// Name the fastest method that is at most this many texels off in 99 of 100 hits at the worst
    /// angle
    #[arg(
        long,
        value_name = "TEXELS",
        value_parser = values::positive,
        allow_hyphen_values = true,
        help_heading = "What is chosen"
    )]
    max_error: Option<f64>,
    /// A tenth of the rays, smaller pictures, no flicker and no times: takes seconds instead of
    /// minutes
    #[arg(long, help_heading = "What is tried")]
    quick: bool,

    #[command(flatten)]
    method_set: MethodSetArguments,
}

/// Default size of pictures.
const SIZE: [u32; 2] = [320, 240];
const QUICK_SIZE: [u32; 2] = [160, 120];

/// Default displacements: normal and extreme.
const SCALES_M: [f64; 2] = [0.05, 0.15];

/// Frames of each method when one is chosen.
const CHOOSING_FRAMES: u32 = 7;

/// Compares the methods and writes the page.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let cancel = interrupt::catch()?;
    // The best of all is looked for among all.
    let unnamed = if arguments.goal().is_some() { Unnamed::All } else { Unnamed::Usual };
    let mut method_set = arguments.method_set.method_set(unnamed)?;
    let files = arguments.outputs(&method_set)?;
    let comparison = arguments.comparison(&mut method_set)?;
    let written: Vec<&Path> = files.iter().map(PathBuf::as_path).collect();
    // Whether the files can be written is known before minutes of work.
    let mut staged = Staged::open(&written, arguments.json, cancel)?;
    let mut compared = compared("comparing", &comparison, arguments.json, cancel)?;
    if let Some(goal) = arguments.goal() {
        look_again("timing what is near", &comparison, &mut compared.records, goal, arguments.json, cancel)?;
    }
    arguments.write(&compared, &mut staged)?;
    staged.finish()?;
    let tried = arguments.goal().map(|goal| choose(&compared.records, goal));
    let chosen = tried.as_ref().map(|tried| (tried, arguments.method_set.scene.words()));
    answer(|out| report::tell(arguments.json, &compared.records, chosen, &files, out))?;
    tried.map_or(Ok(()), |tried| arguments.check_kept(&tried))
}

impl Arguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.method_set.scene.files(), ..Files::default() }
    }

    /// Returns the page and the files beside it, each with the ending of its format.
    fn outputs(&self, method_set: &MethodSet) -> Result<Vec<PathBuf>, Failure> {
        let read = method_set.inputs();
        let inputs: Vec<&Path> =
            read.iter().map(PathBuf::as_path).chain(self.method_set.scene.file()).collect();
        let named = [
            ("--output", Some(&self.output), "html"),
            ("--records", self.records.as_ref(), "json"),
            ("--csv", self.csv.as_ref(), "csv"),
        ];
        let mut files = Vec::new();
        for (flag, path, ending) in named {
            let Some(path) = path else { continue };
            format_of(flag, path, &[(ending, ())], &inputs)?;
            files.push(path.clone());
        }
        Ok(files)
    }

    /// Returns what is compared.
    fn comparison(&self, method_set: &mut MethodSet) -> Result<Comparison, Failure> {
        let spec = &mut method_set.spec;
        spec.size = spec.size.or(Some(if self.quick { QUICK_SIZE } else { SIZE }.into()));
        let has_scale = spec.each_surface().iter().any(|surface| surface.scale.is_some());
        let is_scene = self.method_set.scene.file().is_some();
        let mut comparison = method_set.comparison(self.json)?;
        // A light and a background that somebody chose are shown as they are.
        let spec = &method_set.spec;
        let is_lit = spec.light.is_some() || spec.lights.is_some() || spec.background.is_some();
        comparison.shown_look = (!is_lit).then_some(Look::Studio);
        comparison.steps.clone_from(&self.steps);
        comparison.angles_deg.clone_from(&self.angles);
        let has_own = is_scene || has_scale || self.goal().is_some();
        comparison.scales_m = match (self.scales.is_empty(), has_own) {
            (false, _) => self.scales.clone(),
            (true, true) => Vec::new(),
            (true, false) => SCALES_M.to_vec(),
        };
        comparison.map_sides.clone_from(&self.map_sizes);
        comparison.map_formats.clone_from(&self.texels);
        comparison.distances_m.clone_from(&self.distances);
        comparison.rays =
            self.rays.unwrap_or(if self.quick { comparison.rays / 10 } else { comparison.rays });
        comparison.flicker_samples = comparison.flicker_samples.filter(|_| !self.quick);
        comparison.timing = comparison.timing.filter(|_| !self.quick);
        if self.goal().is_some() {
            if comparison.scene.surfaces().len() > 1 {
                return Err(Failure::usage(
                    "--budget-ms and --max-error need the errors of hits, which only a scene with one \
                     surface has: remove the others",
                ));
            }
            // The choice is for pictures of this size, and may have any number of steps.
            comparison.timing = Some(Timing { frames: CHOOSING_FRAMES, warm: 1, pixels: 1 });
            comparison.flicker_samples = None;
            if self.steps.is_empty() {
                comparison.contenders = with_other_steps(&comparison.contenders);
            }
        }
        comparison.check().map_err(of_comparison)?;
        Ok(comparison)
    }

    /// Returns the goal by which a method is chosen.
    fn goal(&self) -> Option<Goal> {
        self.budget_ms.map(Goal::WithinMs).or(self.max_error.map(Goal::WithinTexels))
    }

    /// Returns an error if no method keeps the goal.
    fn check_kept(&self, tried: &Ranking) -> Result<(), Failure> {
        if tried.meeting > 0 {
            return Ok(());
        }
        let Some(nearest) = tried.candidates.first() else {
            return Err(Failure::work(
                "none of the methods has frames on this mesh that can be timed: give others",
            ));
        };
        let what = match self.budget_ms {
            Some(ms) => format!("no method keeps {ms} ms"),
            None => format!("no method keeps {} texels", self.max_error.unwrap_or_default()),
        };
        Err(Failure::Work(format!(
            "{what}: the nearest is {}, with {:.2} ms and {:.3} texels: give a larger limit",
            nearest.method.label(),
            nearest.frame_ms,
            nearest.p99_texels
        )))
    }

    /// Writes the page and the files that are asked for beside it.
    fn write(&self, compared: &Compared, staged: &mut Staged) -> Result<(), Failure> {
        staged.write(&self.output, page(compared).map_err(Failure::work)?)?;
        if let Some(path) = &self.records {
            staged.write(path, as_json(&compared.records)?)?;
        }
        if let Some(path) = &self.csv {
            staged.write(path, csv(&compared.records))?;
        }
        Ok(())
    }
}
