//! Common part of `relief compare` and `relief bench`: a scene, the methods that are tried on it,
//! and the machines that render it.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use relief_compare::{
    COBBLES_PNG, CompareError, Compared, Comparison, Contender, Goal, LeftOut, Machine, Records,
};
use relief_core::Watch;
use relief_core::registry::UnknownName;
use relief_io::material_name;
use relief_render::{RenderError, Renderer};
use relief_scene::{BackendChoice, Look, Sampling, SceneSpec, SurfaceSpec};
use relief_shaders::{Choice, Entry, Family, GEOMETRY, REFINE, SEARCH, SHADOW, SLICES, STAGES, Selection};
use tempfile::TempDir;

use super::maps::{self, By};
use super::numbered::{Numbering, ONE_FRAME, files};
use super::scene_arguments::{SceneArguments, of_scene};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{advice, interrupt, lanes, say};

/// Flags for the methods that are tried, the machines and the scene.
#[derive(Args)]
pub struct MethodSetArguments {
    #[arg(
        long,
        value_name = "A,B",
        value_delimiter = ',',
        help_heading = "What is tried",
        help = methods_help(),
    )]
    methods: Vec<String>,
    /// Backends: cpu, gpu (also a software adapter) or both [default: cpu, and gpu if there is one]
    #[arg(long, value_name = "cpu,gpu", value_delimiter = ',', help_heading = "What is tried")]
    backend: Vec<BackendChoice>,
    /// Texture reads on a GPU: exact, fast or both
    #[arg(
        long,
        value_name = "exact,fast",
        value_delimiter = ',',
        default_value = "exact",
        help_heading = "What is tried"
    )]
    sampling: Vec<Sampling>,
    #[command(flatten)]
    pub scene: SceneArguments,
}

fn methods_help() -> String {
    let usual: Vec<String> = Contender::usual().into_iter().map(|contender| contender.name).collect();
    format!(
        "Methods, or pairs of a search and a refinement as linear+binary. all: every method but slices, \
         which take minutes; name them, or give --geometry slices [default: {}; all with a --geometry, a \
         goal, or `relief bench`]",
        usual.join(", ")
    )
}

/// Methods that are tried where neither methods nor geometries are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unnamed {
    /// All but slices.
    All,
    /// One of each family.
    Usual,
}

/// Methods that are tried on a scene. All files are named; all are read but the maps.
pub struct MethodSet {
    /// Scene. Its surfaces have no method of their own.
    pub spec: SceneSpec,
    /// Methods.
    pub contenders: Vec<Contender>,
    /// Shadows of the methods, if several are named; else the scene's.
    shadows: Vec<Choice>,
    /// Machines that render the pictures.
    pub machines: Vec<Machine>,
    /// Folder of the sample map if no map is given; removed when dropped.
    _sample: Option<TempDir>,
}

impl MethodSetArguments {
    /// Returns what is tried: `unnamed` where nothing is named.
    pub fn method_set(&self, unnamed: Unnamed) -> Result<MethodSet, Failure> {
        let mut spec = self.scene.spec()?;
        // Pictures that are measured do not follow the default look.
        spec.look.get_or_insert(Look::Plain);
        Numbering::of(self.scene.file()).refuse(&spec, ONE_FRAME)?;
        if let Some(file) = spec.each_surface().into_iter().find_map(|surface| surface.object) {
            return Err(Failure::Usage(format!(
                "{}: methods over height maps are compared, not depth objects: give a height map",
                file.display()
            )));
        }
        let names_geometry =
            spec.each_surface().iter().any(|surface| surface.stages.contains_key(STAGES[GEOMETRY].key));
        let unnamed = if names_geometry { Unnamed::All } else { unnamed };
        let families = self.families(&spec)?;
        let shadows = shadows(&mut spec)?;
        let settings = settings(&mut spec, &[GEOMETRY, SLICES, SEARCH, REFINE]);
        for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
            surface.stages.remove(STAGES[GEOMETRY].key);
            surface.method = None;
        }
        // All methods see the finest level, unless another is asked for.
        let mut spec = spec.at_finest_level();
        let contenders = self.contenders(&families, &settings, unnamed)?;
        let sample = sample(&mut spec)?;
        Ok(MethodSet { spec, contenders, shadows, machines: self.machines()?, _sample: sample })
    }

    /// Returns the geometries to try: the named ones, or all. Slices only if methods are named.
    fn families(&self, spec: &SceneSpec) -> Result<Vec<String>, Failure> {
        let surfaces = spec.each_surface();
        let names_one = surfaces.iter().any(|surface| {
            let named = |stage: usize| surface.stages.contains_key(STAGES[stage].key);
            named(SEARCH) || named(REFINE)
        });
        if self.scene.names_method() || names_one {
            return Err(Failure::usage(
                "--method, --search and --refine name one method: give --methods a list of names, pairs as \
                 linear+binary",
            ));
        }
        let entries = STAGES[GEOMETRY].entries;
        let known = || entries.iter().map(|entry| entry.name);
        let Some(text) = surfaces.iter().find_map(|surface| surface.stages.get(STAGES[GEOMETRY].key)) else {
            let are_named = !(self.methods.is_empty() || self.names_all());
            let is_quick = |entry: &&Entry| are_named || entry.geometry().family != Family::Slices;
            return Ok(entries.iter().filter(is_quick).map(|entry| entry.name.to_owned()).collect());
        };
        let of = |name: &str| {
            // Methods without a geometry trace rays.
            let base = entries.iter().find(|entry| entry.is_idle()).map_or(name, |entry| entry.name);
            let name = if name == Family::Ray.name() { base } else { name };
            let is_known = known().any(|known| known == name);
            let unknown =
                || Failure::Usage(format!("--geometry: {}", UnknownName::new("geometry", name, known())));
            if is_known { Ok(name.to_owned()) } else { Err(unknown()) }
        };
        text.split(',').map(of).collect()
    }

    fn names_all(&self) -> bool {
        self.methods.iter().any(|name| name == "all")
    }

    /// Returns the methods, each with its settings.
    fn contenders(
        &self,
        families: &[String],
        settings: &[(String, f64)],
        unnamed: Unnamed,
    ) -> Result<Vec<Contender>, Failure> {
        let mut contenders = match (self.methods.is_empty(), unnamed) {
            (true, Unnamed::Usual) => Contender::usual(),
            (true, Unnamed::All) => Contender::all(),
            (false, _) if self.names_all() => Contender::all(),
            (false, _) => {
                let named = self.methods.iter().map(|name| Contender::named(name));
                let named: Result<_, _> = named.collect();
                named.map_err(|error| Failure::Usage(format!("--methods: {error}")))?
            }
        };
        contenders.retain(|contender| {
            let geometry = contender.selection.choices[GEOMETRY].entry.name;
            families.iter().any(|family| family == geometry)
        });
        for (key, value) in settings {
            if !contenders.iter().any(|contender| contender.has(key)) {
                return Err(Failure::Usage(format!(
                    "--set {key}: none of the methods has this setting: `relief methods` says which have it, \
                     for --methods"
                )));
            }
            for contender in contenders.iter_mut().filter(|contender| contender.has(key)) {
                let set = contender.selection.set(key, *value);
                set.map_err(|error| Failure::Usage(format!("--set: {error}")))?;
            }
        }
        Ok(contenders)
    }

    /// Returns the machines that render the pictures.
    fn machines(&self) -> Result<Vec<Machine>, Failure> {
        let of_gpu = || self.sampling.iter().map(|&sampling| Machine::gpu(sampling));
        if self.backend.is_empty() {
            // A software adapter is no GPU, and is slower than the CPU backend.
            let found = Renderer::new(BackendChoice::Auto, Sampling::Exact).map_err(of_render)?;
            let has_gpu = found.backend() == "gpu";
            return Ok([Machine::CPU].into_iter().chain(of_gpu().filter(|_| has_gpu)).collect());
        }
        let mut machines = Vec::new();
        for backend in &self.backend {
            match backend {
                BackendChoice::Auto => {
                    return Err(Failure::usage(
                        "--backend auto: name cpu, gpu or both, since each is a column",
                    ));
                }
                BackendChoice::Cpu => machines.push(Machine::CPU),
                BackendChoice::Gpu => machines.extend(of_gpu()),
            }
        }
        Ok(machines)
    }
}

impl MethodSet {
    /// Reads the maps and prints notes on them, unless it is to be quiet. Everything that is not
    /// named here is as [`Comparison::new`] has it.
    pub fn comparison(&self, quiet: bool) -> Result<Comparison, Failure> {
        let scene = self.spec.load().map_err(of_scene)?;
        if !quiet {
            maps::of_reading(&self.spec, &scene, By::Flags).iter().for_each(say::note);
        }
        let named = |surface: SurfaceSpec| {
            let of_file = surface.height.as_ref().and_then(|path| path.file_stem());
            let of_file = of_file.map(|stem| stem.to_string_lossy().into_owned());
            // A folder such as `.` has its name in its whole path.
            let folder = surface.textures.map(|folder| folder.canonicalize().unwrap_or(folder));
            of_file.or_else(|| folder.as_deref().map(material_name))
        };
        let name = self.spec.each_surface().into_iter().find_map(named).unwrap_or_default();
        let mut comparison = Comparison::new(name, scene);
        comparison.contenders.clone_from(&self.contenders);
        comparison.shadows.clone_from(&self.shadows);
        comparison.machines.clone_from(&self.machines);
        comparison.lanes = lanes::from_environment()?;
        comparison.max_memory = self.spec.max_memory.unwrap_or(comparison.max_memory);
        Ok(comparison)
    }

    /// Returns the files that are read.
    pub fn inputs(&self) -> Vec<PathBuf> {
        files(&self.spec)
    }
}

/// Removes the settings of `stages` from a description and returns them: they belong to the
/// methods.
fn settings(spec: &mut SceneSpec, stages: &[usize]) -> Vec<(String, f64)> {
    let mut taken = Vec::new();
    for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
        surface.set.retain(|key, value| {
            let stage = key.split('.').next();
            let is_tried = stages.iter().any(|&place| stage == Some(STAGES[place].key));
            if is_tried {
                taken.push((key.clone(), *value));
            }
            !is_tried
        });
    }
    taken
}

/// Removes the shadows from a description that names several, with their settings, and returns
/// them.
fn shadows(spec: &mut SceneSpec) -> Result<Vec<Choice>, Failure> {
    let stage = STAGES[SHADOW].key;
    let named = spec.each_surface().iter().find_map(|surface| surface.stages.get(stage).cloned());
    let Some(text) = named.filter(|text| text.contains(',')) else { return Ok(Vec::new()) };
    for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
        surface.stages.remove(stage);
    }
    let mut selections = Vec::new();
    for name in text.split(',') {
        let mut selection = Selection::default();
        let chosen = selection.choose(stage, name);
        chosen.map_err(|error| Failure::Usage(format!("--shadow: {error}")))?;
        selections.push(selection);
    }
    for (key, value) in settings(spec, &[SHADOW]) {
        let name = key.split_once('.').map_or("", |(_, name)| name);
        let having = |selection: &&mut Selection| selection.choices[SHADOW].entry.param(name).is_some();
        let mut is_of_one = false;
        for selection in selections.iter_mut().filter(having) {
            let set = selection.set(&key, value);
            set.map_err(|error| Failure::Usage(format!("--set: {error}")))?;
            is_of_one = true;
        }
        if !is_of_one {
            return Err(Failure::Usage(format!(
                "--set {key}: none of the shadows has this setting: see `relief methods`"
            )));
        }
    }
    Ok(selections.iter().map(|selection| selection.choices[SHADOW]).collect())
}

/// Adds the sample map to a description without a map.
pub fn sample(spec: &mut SceneSpec) -> Result<Option<TempDir>, Failure> {
    let has_map = spec.each_surface().iter().any(|surface| {
        let SurfaceSpec { height, volume, motif, textures, .. } = surface;
        [height, volume, motif, textures].into_iter().any(Option::is_some)
    });
    if has_map || !spec.surfaces.is_empty() {
        return Ok(None);
    }
    let failed = |error| {
        Failure::Work(format!(
            "no folder can be made for the sample map: {error}: give another map with --height"
        ))
    };
    let folder = tempfile::Builder::new().prefix("relief-").tempdir().map_err(failed)?;
    let path = folder.path().join("cobbles.png");
    std::fs::write(&path, COBBLES_PNG).map_err(failed)?;
    spec.surface.height = Some(path);
    Ok(Some(folder))
}

/// Runs the comparison with a progress bar, and prints notes on what was left out.
pub fn compared(
    what: &'static str,
    comparison: &Comparison,
    quiet: bool,
    cancel: &AtomicBool,
) -> Result<Compared, Failure> {
    let progress = Progress::bar(what, quiet);
    let tell = |_: &str, part: f32| progress.show(part);
    let mut compared = comparison.run(&Watch::new(&tell, cancel)).map_err(of_comparison)?;
    drop(progress);
    for LeftOut { what, reason } in compared.records.left_out.iter().filter(|_| !quiet) {
        say::note(format_args!("{what} is left out: {reason}"));
    }
    compared.records.about.command = command();
    Ok(compared)
}

/// Returns the command line of this run.
fn command() -> String {
    let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    std::iter::once("relief".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

/// Times once more what a goal hardly decides between, with a progress bar.
pub fn look_again(
    what: &'static str,
    comparison: &Comparison,
    records: &mut Records,
    goal: Goal,
    quiet: bool,
    cancel: &AtomicBool,
) -> Result<(), Failure> {
    let progress = Progress::bar(what, quiet);
    let tell = |_: &str, part: f32| progress.show(part);
    let looked = comparison.time_again(records, goal, &Watch::new(&tell, cancel));
    looked.map(|_| ()).map_err(of_comparison)
}

/// Formats the records as JSON.
pub fn as_json(records: &Records) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(records).map_err(Failure::work)?;
    Ok(text + "\n")
}

/// Turns a comparison's error into a failure, with the flag that helps.
pub fn of_comparison(error: CompareError) -> Failure {
    match error {
        CompareError::Value { what: "an angle", .. } => Failure::Usage(format!("--angles: {error}")),
        CompareError::Value { what: "a distance", .. } | CompareError::Orthographic => {
            Failure::Usage(format!("--distances: {error}"))
        }
        CompareError::Value { .. } => Failure::Usage(format!("--scales: {error}")),
        CompareError::NoLevel { .. } => Failure::Usage(format!("--map-sizes: {error}")),
        CompareError::Nothing(_) => Failure::usage(error),
        CompareError::Selection(error) => Failure::Usage(format!("--steps: {error}")),
        CompareError::TooMuchMemory { .. } => Failure::Work(format!(
            "{error}: --max-memory raises the limit; fewer --rays, a smaller --size and fewer --methods need \
             less"
        )),
        CompareError::Cancelled(_) => interrupt::cancelled(),
        CompareError::Render { source, .. } => of_render(*source),
        other => Failure::work(other),
    }
}

fn of_render(error: RenderError) -> Failure {
    Failure::Work(advice::with(&error, advice::of_render(&error)))
}
