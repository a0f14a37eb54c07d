//! `relief compare`: methods beside the truth and beside each other, as a page, records and a table.

mod report;

use std::path::PathBuf;

use clap::Args;
use relief_compare::{COBBLES_PNG, CompareError, Compared, Comparison, Contender, Machine, Watch, csv, page};
use relief_render::scene::{BackendChoice, Sampling, SceneSpec};
use relief_render::{RenderError, Renderer};
use relief_shaders::{DETAIL, GEOMETRY, METHODS, REFINE, SEARCH, STAGES, geometry};
use tempfile::TempDir;

use super::scene_arguments::{SceneArguments, of_scene};
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, answer};
use crate::{advice, interrupt, lanes, say, units};

/// What `relief compare` is given. Flags override the scene file.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  relief compare                                  # all methods on the sample cobbles\n  \
    relief compare --height wall.png --scales 2cm,10cm -o wall.html\n  \
    relief compare --methods relief,occlusion --steps 8,16,32,64 --csv steps.csv\n  \
    relief compare --methods cone,linear+true-secant --angles 60,85 --rays 100000\n  \
    relief compare scenes/jacksboro.toml --geometry none,vertex --json\n\n\
    Rays at an angle are compared with the exact first hit; pictures with the exact picture, and their pixels' \
    hits with its hits. The page sorts its figures and plots any of them against any other, without network."
)]
pub struct Arguments {
    /// Page to write
    #[arg(short, long, value_name = "PAGE.html", default_value = "comparison.html")]
    output: PathBuf,
    /// Write all figures, too, as JSON
    #[arg(long, value_name = "FILE.json")]
    records: Option<PathBuf>,
    /// Write all figures, too, as comma-separated values
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print all figures as one JSON object
    #[arg(long)]
    pub json: bool,

    /// Methods, or pairs of a search and a refinement as linear+binary; all for every method
    #[arg(
        long,
        value_name = "A,B",
        value_delimiter = ',',
        default_value = "all",
        help_heading = "What is compared"
    )]
    methods: Vec<String>,
    /// Steps that methods are allowed, one row each: of their search where that has them, else the search's
    /// limit, else the refinement's [default: each method's own]
    #[arg(
        long,
        value_name = "N,..",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "What is compared"
    )]
    steps: Vec<u32>,
    /// Degrees between rays and normal, where the mesh is flat
    #[arg(
        long,
        value_name = "DEGREES,..",
        value_delimiter = ',',
        default_value = "10,30,60,85",
        allow_hyphen_values = true,
        help_heading = "What is compared"
    )]
    angles: Vec<f64>,
    /// Metres of displacement between heights 0 and 1 [default: 0.05,0.15; of a scene its own]
    #[arg(
        long,
        value_name = "M,..",
        value_delimiter = ',',
        value_parser = units::length,
        allow_hyphen_values = true,
        conflicts_with = "scale",
        help_heading = "What is compared"
    )]
    scales: Vec<f64>,
    /// Longer sides of the height map in texels, filtered down by halves [default: as it is]
    #[arg(
        long,
        value_name = "N,..",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "What is compared"
    )]
    map_sizes: Vec<u32>,
    /// Where pictures are made: cpu, gpu (also a software adapter) or both [default: cpu, and gpu if there is
    /// one]
    #[arg(long, value_name = "cpu,gpu", value_delimiter = ',', help_heading = "What is compared")]
    backend: Vec<BackendChoice>,
    /// How a GPU reads textures: exact, fast or both
    #[arg(
        long,
        value_name = "exact,fast",
        value_delimiter = ',',
        default_value = "exact",
        help_heading = "What is compared"
    )]
    sampling: Vec<Sampling>,
    /// Rays of a method at an angle [default: 20000]
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=100_000_000),
        allow_hyphen_values = true,
        help_heading = "What is compared"
    )]
    rays: Option<u32>,
    /// A tenth of the rays, smaller pictures, and no flicker: a minute in place of several
    #[arg(long, help_heading = "What is compared")]
    quick: bool,

    #[command(flatten)]
    scene: SceneArguments,
}

/// What pictures are like where nothing is said of them.
const SIZE: [u32; 2] = [320, 240];
const QUICK_SIZE: [u32; 2] = [160, 120];

/// Displacements where nothing is said of them: normal and extreme.
const SCALES_M: [f64; 2] = [0.05, 0.15];

/// Compares and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let cancel = interrupt::catch()?;
    let spec = arguments.scene.spec()?;
    let families = arguments.families(&spec)?;
    let files = arguments.outputs(&spec)?;
    let sample = Sample::of(&spec)?;
    let comparison = arguments.comparison(&spec, &families, &sample)?;
    let written: Vec<&std::path::Path> = files.iter().map(PathBuf::as_path).collect();
    // Whether they can be written is known before minutes of work.
    let mut staged = Staged::open(&written, arguments.json, cancel)?;
    let progress = Progress::bar("comparing", arguments.json);
    let told = |_method: &str, part: f32| progress.show(part);
    let compared = comparison.run(&Watch { progress: &told, cancel }).map_err(of_comparison)?;
    drop(progress);
    let compared = with_command(compared);
    arguments.write(&compared, &mut staged)?;
    staged.finish()?;
    for left_out in compared.records.left_out.iter().filter(|_| !arguments.json) {
        say::note(format_args!("{} is left out: {}", left_out.what, left_out.reason));
    }
    answer(|out| report::tell(arguments.json, &compared.records, &files, out))
}

/// The comparison with the command line that asked for it.
fn with_command(mut compared: Compared) -> Compared {
    let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    let words = std::iter::once("relief".to_owned()).chain(words);
    compared.records.about.command = words.collect::<Vec<_>>().join(" ");
    compared
}

/// The sample map, where no other is given: a file as long as this lives.
struct Sample(Option<(TempDir, PathBuf)>);

impl Sample {
    fn of(spec: &SceneSpec) -> Result<Self, Failure> {
        if spec.each_surface().iter().any(|surface| surface.height.is_some()) || !spec.surfaces.is_empty() {
            return Ok(Self(None));
        }
        let failed = |error| Failure::Work(format!("a folder for the sample map cannot be made: {error}"));
        let folder = tempfile::Builder::new().prefix("relief-").tempdir().map_err(failed)?;
        let path = folder.path().join("cobbles.png");
        std::fs::write(&path, COBBLES_PNG).map_err(failed)?;
        Ok(Self(Some((folder, path))))
    }
}

impl Arguments {
    /// The files that may be the standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.scene.files(), ..Files::default() }
    }

    /// The page and what is written beside it, each with an ending that says what it is.
    fn outputs(&self, spec: &SceneSpec) -> Result<Vec<PathBuf>, Failure> {
        let surfaces = spec.each_surface();
        let read = surfaces.iter().flat_map(|surface| surface.files()).map(PathBuf::as_path);
        let inputs: Vec<_> = read.chain(self.scene.file()).collect();
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

    /// The geometries that are compared: all, or those that are named.
    fn families(&self, spec: &SceneSpec) -> Result<Vec<String>, Failure> {
        for surface in spec.each_surface() {
            let named = |stage: usize| surface.stages.contains_key(STAGES[stage].key);
            if surface.method.is_some() && self.scene.names_method() || named(SEARCH) || named(REFINE) {
                return Err(Failure::usage(
                    "--method, --search and --refine name one method: give --methods the names of those \
                     that are compared, pairs as linear+binary",
                ));
            }
        }
        let key = STAGES[GEOMETRY].key;
        let surfaces = spec.each_surface();
        let Some(text) = surfaces.iter().find_map(|surface| surface.stages.get(key)) else {
            return Ok(STAGES[GEOMETRY].entries.iter().map(|entry| entry.name.to_owned()).collect());
        };
        let known = || STAGES[GEOMETRY].entries.iter().map(|entry| entry.name);
        let of = |name: &str| {
            // Rays are what there is without a geometry.
            let name = if name == "ray" { geometry::NONE } else { name };
            if known().any(|known| known == name) {
                return Ok(name.to_owned());
            }
            let unknown = relief_core::registry::UnknownName::new("geometry", name, known());
            Err(Failure::Usage(format!("--geometry: {unknown}")))
        };
        text.split(',').map(of).collect()
    }

    /// What is compared.
    fn comparison(
        &self,
        spec: &SceneSpec,
        families: &[String],
        sample: &Sample,
    ) -> Result<Comparison, Failure> {
        let mut spec = spec.clone();
        for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
            surface.stages.remove(STAGES[GEOMETRY].key);
            // All methods see the finest level, unless another is asked for.
            surface.stages.entry(STAGES[DETAIL].key.to_owned()).or_insert_with(|| "none".to_owned());
            surface.method = None;
        }
        // Settings of searches and refinements are the methods' own.
        let settings = self.settings(&mut spec);
        if let Sample(Some((_, path))) = sample {
            spec.surface.height = Some(path.clone());
        }
        let is_scene = self.scene.file().is_some();
        spec.size = spec.size.or(Some(if self.quick { QUICK_SIZE } else { SIZE }));
        let has_scale = spec.each_surface().iter().any(|surface| surface.scale.is_some());
        let scene = spec.load().map_err(of_scene)?;
        let name = spec.each_surface().iter().find_map(|surface| surface.height.clone());
        let name = name.as_deref().and_then(|path| path.file_stem()).unwrap_or_default();
        let mut comparison = Comparison::new(name.to_string_lossy(), scene);
        comparison.contenders = self.contenders(families, &settings)?;
        comparison.steps.clone_from(&self.steps);
        comparison.angles_deg.clone_from(&self.angles);
        comparison.scales_m = match (self.scales.is_empty(), is_scene || has_scale) {
            (false, _) => self.scales.clone(),
            (true, true) => Vec::new(),
            (true, false) => SCALES_M.to_vec(),
        };
        comparison.map_sides.clone_from(&self.map_sizes);
        comparison.rays =
            self.rays.unwrap_or(if self.quick { comparison.rays / 10 } else { comparison.rays });
        comparison.flicker_samples = comparison.flicker_samples.filter(|_| !self.quick);
        comparison.lanes = lanes::from_environment()?;
        comparison.machines = self.machines()?;
        comparison.check().map_err(of_comparison)?;
        Ok(comparison)
    }

    /// Takes the settings of searches and refinements out of a description.
    fn settings(&self, spec: &mut SceneSpec) -> Vec<(String, f64)> {
        let mut taken = Vec::new();
        for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
            surface.set.retain(|key, value| {
                let of = |stage: usize| key.split('.').next() == Some(STAGES[stage].key);
                let is_of_method = of(SEARCH) || of(REFINE) || of(GEOMETRY);
                if is_of_method {
                    taken.push((key.clone(), *value));
                }
                !is_of_method
            });
        }
        taken
    }

    /// The methods, with the settings that each has.
    fn contenders(&self, families: &[String], settings: &[(String, f64)]) -> Result<Vec<Contender>, Failure> {
        let all: Vec<String> = METHODS.iter().map(|method| method.name.to_owned()).collect();
        let is_all = self.methods.iter().any(|name| name == "all");
        let mut contenders = Vec::new();
        for name in if is_all { &all } else { &self.methods } {
            let named = Contender::named(name).map_err(|error| Failure::Usage(format!("--methods: {error}")));
            let contender = named?;
            let geometry = contender.selection.choices[GEOMETRY].entry.name;
            if families.iter().any(|family| family == geometry) {
                contenders.push(contender);
            }
        }
        for (key, value) in settings {
            let having = || contenders.iter().filter(|contender| contender.has(key));
            if having().next().is_none() {
                return Err(Failure::Usage(format!("--set {key}: none of the methods has such a setting")));
            }
            for contender in contenders.iter_mut().filter(|contender| contender.has(key)) {
                contender
                    .selection
                    .set(key, *value)
                    .map_err(|error| Failure::Usage(format!("--set: {error}")))?;
            }
        }
        Ok(contenders)
    }

    /// Where pictures are made.
    fn machines(&self) -> Result<Vec<Machine>, Failure> {
        let of_gpu = || self.sampling.iter().map(|&sampling| Machine::gpu(sampling));
        if self.backend.is_empty() {
            // A software adapter is no GPU, and slower than the CPU is by itself.
            let found = Renderer::new(BackendChoice::Auto, Sampling::Exact).map_err(of_render)?;
            let has_gpu = found.backend() == "gpu";
            return Ok([Machine::CPU].into_iter().chain(of_gpu().filter(|_| has_gpu)).collect());
        }
        let mut machines = Vec::new();
        for backend in &self.backend {
            match backend {
                BackendChoice::Auto => {
                    return Err(Failure::usage("--backend: name cpu, gpu or both: auto is no column"));
                }
                BackendChoice::Cpu => machines.push(Machine::CPU),
                BackendChoice::Gpu => machines.extend(of_gpu()),
            }
        }
        Ok(machines)
    }

    /// Writes the page and what is asked for beside it.
    fn write(&self, compared: &Compared, staged: &mut Staged) -> Result<(), Failure> {
        let write = |staged: &mut Staged, path: &PathBuf, text: String| {
            let aside = staged.aside(path)?;
            std::fs::write(aside, text)
                .map_err(|error| Failure::Work(format!("{}: cannot be written: {error}", path.display())))
        };
        let page = page(compared).map_err(Failure::work)?;
        write(staged, &self.output, page)?;
        if let Some(path) = &self.records {
            write(staged, path, report::json(&compared.records)?)?;
        }
        if let Some(path) = &self.csv {
            write(staged, path, csv(&compared.records))?;
        }
        Ok(())
    }
}

/// Why there is no comparison, with what mends it.
fn of_comparison(error: CompareError) -> Failure {
    match error {
        CompareError::Value { what: "an angle", .. } => Failure::Usage(format!("--angles: {error}")),
        CompareError::Value { .. } => Failure::Usage(format!("--scales: {error}")),
        CompareError::NoLevel { .. } => Failure::Usage(format!("--map-sizes: {error}")),
        CompareError::Nothing(_) => Failure::usage(error),
        CompareError::Selection(error) => Failure::Usage(format!("--steps: {error}")),
        CompareError::Stopped => interrupt::cancelled(),
        CompareError::Render { source, .. } => of_render(*source),
        other => Failure::work(other),
    }
}

fn of_render(error: RenderError) -> Failure {
    Failure::Work(advice::with(&error, advice::of_render(&error)))
}
