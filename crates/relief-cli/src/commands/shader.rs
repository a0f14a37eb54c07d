//! `relief shader`: exports a method as shaders or functions for other programs, with a JSON description of
//! what they bind.

mod functions;

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use relief_bake::KINDS;
use relief_core::registry::{MapMetric, MapSetting};
use relief_export::{ExportError, File, Options, Placement, Profile, Target, export};
use relief_shaders::surface::Shown;
use relief_shaders::wgsl::Sampling;
use relief_shaders::{
    AMBIENT, DETAIL, Entry, GEOMETRY, METHODS, MapNeed, Method, REFINE, SEARCH, SHADOW, SHADOW_SEARCH,
    STAGES, SURFACE, Selection, Stage,
};
use serde_json::{Value, json};

use super::staged::Staged;
use crate::failure::Failure;
use crate::streams::tell_written;
use crate::{interrupt, values};

/// Arguments of `relief shader`.
#[derive(Args)]
#[command(after_help = short_help(), after_long_help = after_help())]
pub struct Arguments {
    #[arg(
        long,
        value_name = "NAME",
        conflicts_with_all = ["search", "refine"],
        required_unless_present = "search",
        help_heading = "Method",
        help = method_help(),
    )]
    method: Option<String>,
    /// Search, together with --refine instead of --method
    #[arg(long, value_name = "NAME", requires = "refine", help_heading = "Method")]
    search: Option<String>,
    /// Refinement, together with --search instead of --method
    #[arg(long, value_name = "NAME", requires = "search", help_heading = "Method")]
    refine: Option<String>,
    #[arg(long, value_name = "NAME", help_heading = "Method", help = variants("Surface", SURFACE))]
    surface: Option<String>,
    #[arg(long, value_name = "NAME", help_heading = "Method", help = shadow_help())]
    shadow: Option<String>,
    /// Search for shadow rays, one of --search [default: the view's search where it can, else
    /// cells]
    #[arg(long, value_name = "NAME", help_heading = "Method")]
    shadow_search: Option<String>,
    #[arg(long, value_name = "NAME", help_heading = "Method", help = variants("Levels of detail", DETAIL))]
    detail: Option<String>,
    #[arg(long, value_name = "NAME", help_heading = "Method", help = variants("Ambient light", AMBIENT))]
    ambient: Option<String>,
    /// Initial value of a stage's setting, as in search.steps=64; repeatable. It stays in the
    /// uniform buffer, at the place that NAME.json states
    #[arg(long, value_name = "STAGE.NAME=VALUE", value_parser = values::setting, help_heading = "Method")]
    set: Vec<(String, f64)>,
    #[command(flatten)]
    functions: functions::Arguments,
    /// Write the depth of the displaced surface from fragments, by frame.clip, so that other
    /// geometry intersects the relief correctly; shaders of the surfaces prism and tetrahedra
    /// always do
    #[arg(long)]
    depth: bool,
    /// Shading languages to write: wgsl, glsl, hlsl, msl, spirv; of functions wgsl, wesl, glsl, hlsl,
    /// msl, godot, unreal
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',', required = true)]
    target: Vec<String>,
    /// Versions of the targets: core450 or es310 of glsl, 5.1 or 6.0 of hlsl, 2.0 of msl, 1.3 of
    /// spirv; of functions also core330, es300 and vulkan450 of glsl [default: the first of each]
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',')]
    profile: Vec<String>,
    /// Texture reads. exact: texel by texel, with the same bits on every machine; fast: through a
    /// sampler
    #[arg(long, value_name = "exact|fast", default_value_t)]
    sampling: Sampling,
    /// Group of all bindings: the descriptor set of SPIR-V, the register space of HLSL; GLSL and
    /// MSL have none [default: maps in 0, the mesh in 1]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    group: Option<u32>,
    /// Number of the first binding in --group; the others follow in the order of NAME.json. MSL
    /// counts buffers, textures and samplers separately from here [default: 0]
    #[arg(long, value_name = "N", requires = "group", allow_hyphen_values = true)]
    first_binding: Option<u32>,
    /// Name of the files, before their endings [default: the method, or SEARCH-REFINE]
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Folder for the files, created if missing; files of these names are replaced
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
}

const EXAMPLES: &str = "Examples:\n  relief shader --method cone --target wgsl -o shaders\n  \
    relief shader --method cone --entry functions --wrap repeat --target wgsl -o shaders\n  \
    relief shader --method relief --set search.steps=48 --target glsl,spirv --sampling fast -o shaders\n  \
    relief shader --search frustum --refine patch --surface prism --shadow horizon \\\n    \
    --target hlsl --profile 6.0 --group 2 -o shaders";

/// Returns the flags of a shader that shows triangles as they are.
fn facets() -> String {
    let flag = |place: usize, is_meant: fn(&Entry) -> bool| {
        let Stage { key, .. } = &STAGES[place];
        STAGES[place].first(is_meant).map_or(String::new(), |(_, entry)| format!("--{key} {}", entry.name))
    };
    [
        flag(SURFACE, |entry| entry.paths().shown == Shown::Triangles),
        flag(SEARCH, Entry::is_idle),
        flag(REFINE, Entry::is_idle),
        flag(SHADOW, Entry::is_idle),
    ]
    .join(" ")
}

fn short_help() -> String {
    format!("{EXAMPLES}\n\n`relief shader --help` describes the files.")
}

/// Examples, what is written, and the profiles.
fn after_help() -> String {
    let mut text = format!(
        "{EXAMPLES}\n\n\
         Each target gets one file with a vertex and a fragment function: NAME.wgsl, NAME.hlsl, NAME.metal \
         or NAME.spv. GLSL gets NAME.vert.glsl and NAME.frag.glsl, whose vertex shader is OpenGL's; Vulkan \
         takes the SPIR-V. The functions draw a surface in a single pass. The triangles' corners come from \
         storage buffers, each fragment's ray is traced through the relief, and its hit is shaded in linear \
         colours. Other shaders can call the functions below them: shade_pixel is a whole pixel.\n\n\
         The comment at the head of each file, and NAME.json for programs, describe the bindings and their \
         contents, the maps of `relief bake`, the layout of the buffers, the target's own names, and the \
         initial values. A shader serves every map, mesh and setting: only --method and the other stages, \
         --sampling and --depth change its code.\n\n\
         --entry functions writes one text for each target instead, for the fragment shader of an engine: \
         PREFIX_hit says where a ray meets the relief, PREFIX_light how much of a light arrives there (with \
         --shadow), PREFIX_tile and PREFIX_curvature make their inputs from derivatives. It has no vertices, \
         no lights and no entry points. --wrap makes it smaller. Methods and surfaces that have no functions \
         say which have.\n\n\
         With --group N all bindings are in that group, numbered from --first-binding in the order of \
         NAME.json. Without it they are where relief's own shaders have them, and in GLSL storage buffers \
         come first.\n\n\
         All files take their names at the end, or none does.\n\n\
         Profiles:\n"
    );
    let listed = |profiles: &[Profile]| -> String {
        let lines = profiles.iter().map(|of| format!("  {} {}: {}\n", of.target(), of.name(), of.title()));
        lines.collect()
    };
    text += &Target::ALL.map(|target| listed(target.profiles())).concat();
    text += "\nProfiles of functions:\n";
    text += &Target::OF_FUNCTIONS.map(|target| listed(target.profiles_of_functions())).concat();
    let shows_triangles = |method: &&Method| {
        let selection = Selection::of(method);
        selection.is_ok_and(|it| it.choices[GEOMETRY].entry.geometry().shown == Shown::Triangles)
    };
    let displaced: Vec<&str> = METHODS.iter().filter(shows_triangles).map(|method| method.name).collect();
    text + &format!(
        "\nMethods of displaced triangles ({}) have no shader of their own: `relief mesh` makes displaced \
         meshes, and {} shades them. For slices, the shader shades polygons that your program makes, such as \
         shells.",
        displaced.join(", "),
        facets()
    )
}

fn method_help() -> String {
    let names = METHODS.iter().filter(|method| {
        let geometry = Selection::of(method).ok().and_then(|selection| selection.geometry());
        geometry.is_none()
    });
    format!("Method: {}", names.map(|method| method.name).collect::<Vec<_>>().join(", "))
}

/// Lists the variants of a stage; the first is the default.
fn variants(title: &str, place: usize) -> String {
    let names: Vec<&str> = STAGES[place].entries.iter().map(|entry| entry.name).collect();
    format!("{title}: {} [default: {}]", names.join(", "), names[0])
}

fn shadow_help() -> String {
    let idle = STAGES[SHADOW].first(Entry::is_idle).map_or("", |(_, entry)| entry.name);
    let plain = variants("Shadow", SHADOW);
    format!("{}; of functions {idle}]", plain.trim_end_matches(']'))
}

/// Exports the shaders and writes them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let files = if arguments.functions.are_asked() {
        functions::files(arguments)?
    } else {
        arguments.functions.check_unused()?;
        let selection = arguments.selection(None, None)?;
        export(&selection, &arguments.options()?).map_err(of_export)?.files
    };
    let paths: Vec<PathBuf> = files.iter().map(|file| arguments.output.join(&file.name)).collect();
    write(&files, &paths, arguments.json)?;
    tell_written(arguments.json, |out| {
        if arguments.json {
            let file = |(path, file): (&PathBuf, &File)| json!({ "path": path, "bytes": file.bytes.len() });
            let files: Value = paths.iter().zip(&files).map(file).collect();
            return Ok(writeln!(out, "{:#}", json!({ "files": files }))?);
        }
        for (path, file) in paths.iter().zip(&files) {
            writeln!(out, "{}: {} bytes", path.display(), file.bytes.len())?;
        }
        Ok(())
    })
}

/// Writes all files, or none.
fn write(files: &[File], paths: &[PathBuf], quiet: bool) -> Result<(), Failure> {
    let cancel = interrupt::catch()?;
    let outputs: Vec<&Path> = paths.iter().map(PathBuf::as_path).collect();
    let mut staged = Staged::open(&outputs, quiet, cancel)?;
    for (path, file) in outputs.iter().zip(files) {
        staged.write(path, &file.bytes)?;
    }
    staged.finish()
}

impl Arguments {
    /// Returns the stages that are asked for, with a shadow and a level of detail where none is named.
    fn selection(&self, shadow: Option<&str>, detail: Option<&str>) -> Result<Selection, Failure> {
        let mut selection = match (&self.method, &self.search, &self.refine) {
            (None, Some(search), Some(refine)) => {
                let mut selection = Selection::default();
                choose(&mut selection, SEARCH, search)?;
                choose(&mut selection, REFINE, refine)?;
                selection
            }
            (method, ..) => {
                let name = method.as_deref().unwrap_or_default();
                Selection::method(name).map_err(|error| Failure::Usage(format!("--method: {error}")))?
            }
        };
        // A shadow search is chosen after the shadow, which brings another one.
        let stages = [
            (SURFACE, self.surface.as_deref()),
            (DETAIL, self.detail.as_deref().or(detail)),
            (SHADOW, self.shadow.as_deref().or(shadow)),
            (SHADOW_SEARCH, self.shadow_search.as_deref()),
            (AMBIENT, self.ambient.as_deref()),
        ];
        for (stage, name) in stages {
            if let Some(name) = name {
                choose(&mut selection, stage, name)?;
            }
        }
        for (key, value) in &self.set {
            selection.set(key, *value).map_err(|error| Failure::Usage(format!("--set: {error}")))?;
        }
        Ok(selection)
    }

    fn options(&self) -> Result<Options, Failure> {
        Ok(Options {
            name: self.file_name(),
            sampling: self.sampling,
            depth: self.depth,
            profiles: self.profiles()?,
            placement: self.placement(),
            bake: Some(bake_line),
        })
    }

    /// Returns the profiles of whole shaders or, if functions are asked for, of functions.
    fn profiles(&self) -> Result<Vec<Profile>, Failure> {
        let targets = self.target.iter().map(|name| name.parse::<Target>());
        let targets: Vec<Target> = targets
            .collect::<Result<_, _>>()
            .map_err(|error| Failure::Usage(format!("--target: {error}")))?;
        let asked = self.functions.are_asked();
        let profiles_of =
            |target: &Target| if asked { target.profiles_of_functions() } else { target.profiles() };
        if let Some(&target) = targets.iter().find(|target| profiles_of(target).is_empty()) {
            let error = match asked {
                true => ExportError::NoFunctionsIn { target },
                false => ExportError::OnlyFunctions { profile: target.name() },
            };
            return Err(of_export(error));
        }
        let profiles = if asked {
            Profile::of_functions(&targets, &self.profile)
        } else {
            Profile::of_names(&targets, &self.profile)
        };
        profiles.map_err(|error| Failure::Usage(format!("--profile: {error}")))
    }

    fn file_name(&self) -> Option<String> {
        self.name.clone().or_else(|| self.method.clone())
    }

    fn placement(&self) -> Option<Placement> {
        let first_binding = self.first_binding.unwrap_or_default();
        self.group.map(|group| Placement { group, first_binding })
    }
}

pub fn choose(selection: &mut Selection, stage: usize, name: &str) -> Result<(), Failure> {
    let key = STAGES[stage].key;
    selection.choose(key, name).map_err(|error| Failure::Usage(format!("--{key}: {error}")))
}

/// Returns the command line that bakes a map.
pub fn bake_line(need: &MapNeed) -> String {
    let kind = need.input.kind;
    let params = KINDS.iter().find(|known| known.name == kind).map_or(&[][..], |known| known.params);
    let is_default =
        |name: &str, value: f32| params.iter().any(|param| param.name == name && param.default == value);
    let is_of_volume = need.input.settings.iter().any(|(_, value)| matches!(value, MapSetting::Volume(_)));
    let heights = match need.side {
        Some(_) => "LEVEL",
        None if is_of_volume => "VOLUME",
        None => "HEIGHT",
    };
    let mut line = format!("relief bake {heights} --kind {kind}");
    for (name, value) in need.settings.iter().filter(|(name, value)| !is_default(name, *value)) {
        line += &format!(" --set {kind}.{name}={value}");
    }
    line += match need.input.metric {
        MapMetric::Scene => " --scale M --tile-size U,V",
        MapMetric::Texture => " --scale 1 --tile-size 1,1",
    };
    line += " -o DIR";
    match need.side {
        Some(side) => line + &format!(" (LEVEL: the finest level of HEIGHT of at most {side} texels a side)"),
        None => line,
    }
}

/// Turns an error of the export into a failure, with the flag that helps.
pub fn of_export(error: ExportError) -> Failure {
    let at_odds = match &error {
        ExportError::Selection(error) => error.keys(),
        _ => Vec::new(),
    };
    if let Some(key) = at_odds.first() {
        return Failure::Usage(format!("--{key}: {error}"));
    }
    match &error {
        ExportError::Displaced { .. } => {
            Failure::Usage(format!("--method: {error}: `relief mesh` makes meshes, {} shades them", facets()))
        }
        // The geometry and the objects of images come with the method.
        ExportError::NoFunctions { key: "geometry" | "object", .. } => {
            Failure::Usage(format!("--method: {error}"))
        }
        ExportError::NoFunctions { key, .. } => Failure::Usage(format!("--{key}: {error}")),
        ExportError::OnlyFunctions { .. } => {
            Failure::Usage(format!("--target: {error}: add --entry functions"))
        }
        ExportError::NoFunctionsIn { .. } => Failure::Usage(format!("--target: {error}")),
        ExportError::Prefix { .. } => Failure::Usage(format!("--prefix: {error}")),
        ExportError::OnlyCpu { .. } => Failure::Usage(format!("--shadow: {error}")),
        ExportError::Name(_) => Failure::Usage(format!("--name: {error}")),
        ExportError::SameFile(_) => Failure::Usage(format!("--target: {error}")),
        ExportError::Placement { .. } => Failure::Usage(format!("--group, --first-binding: {error}")),
        _ => Failure::work(error),
    }
}
