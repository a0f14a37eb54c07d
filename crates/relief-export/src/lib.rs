//! Displacement methods as shaders for any engine: in WGSL, GLSL, HLSL, MSL and SPIR-V, with a
//! manifest of their bindings.
//!
//! [`export`] makes everything in memory. A selection of stages becomes one shader, which
//! rasterises a base mesh, traces each fragment's ray and shades its hit. It has example entry
//! points, and no function that these do not call. Parameters, sizes and wrap stay in uniform
//! buffers.
//!
//! The WGSL is assembled by `relief-shaders`, with its comments; naga writes all other languages
//! from it. The [`Manifest`] is written beside them as JSON. It has the bindings, the layout of the
//! buffers and their names in each language: all that is needed to bind and fill everything.
//!
//! [`functions`](functions()) makes a method's functions alone, for the fragment functions of an engine.
//!
//! # Examples
//!
//! ```
//! use relief_export::{Options, Profile, export};
//! use relief_shaders::Selection;
//!
//! let mut selection = Selection::method("relief")?;
//! selection.set("search.steps", 48.0)?;
//! let profiles = vec![Profile::Wgsl, Profile::Core450];
//! let options = Options { name: Some("relief".to_owned()), profiles, ..Options::default() };
//! let exported = export(&selection, &options)?;
//!
//! let names: Vec<&str> = exported.files.iter().map(|file| file.name.as_str()).collect();
//! assert_eq!(names, ["relief.wgsl", "relief.vert.glsl", "relief.frag.glsl", "relief.json"]);
//! let heights = exported.manifest.bindings.iter().find(|bound| bound.name == "height_map");
//! assert_eq!(heights.map(|bound| (bound.group, bound.binding)), Some((0, 1)));
//! let search = exported.manifest.stages.iter().find(|stage| stage.stage == "search");
//! let steps = search.and_then(|search| search.params.first());
//! assert_eq!(steps.map(|param| (param.name, param.value)), Some(("steps", 48.0)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod binding_points;
mod describe;
mod error;
pub mod functions;
mod header;
mod layout;
pub mod manifest;
mod options;
mod program;
mod target;
mod textures;
mod writers;

use relief_shaders::{GEOMETRY, SHADOW, STAGES, Selection};

pub use error::ExportError;
pub use functions::{
    ExportedFunctions, Form, FunctionOptions, FunctionsManifest, functions, unreal_input, unreal_node,
};
pub use manifest::Manifest;
pub use options::{Options, Placement};
pub use target::{Profile, Target};

use crate::manifest::TargetFiles;
use crate::program::Program;
use crate::writers::{Body, Text};

/// An export, in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Exported {
    /// The shaders, target by target, and last the manifest as JSON.
    pub files: Vec<File>,
    /// The content of the last file.
    pub manifest: Manifest,
}

/// A file to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The file's name.
    pub name: String,
    /// The file's content.
    pub bytes: Vec<u8>,
}

/// Writes the shader of a selection in every profile of the options. The bytes are the same on
/// every run.
///
/// # Errors
///
/// When the stages do not go together, when no shader runs them, when a target cannot express them
/// or bind as much, or when two files would have the same name.
pub fn export(selection: &Selection, options: &Options) -> Result<Exported, ExportError> {
    check(selection)?;
    if options.profiles.is_empty() {
        return Err(ExportError::NoTarget);
    }
    let is_whole = |profile: &Profile| profile.target().profiles().contains(profile);
    if let Some(other) = options.profiles.iter().find(|profile| !is_whole(profile)) {
        return Err(ExportError::OnlyFunctions { profile: other.name() });
    }
    let derived = || format!("{}-{}", selection.search().name, selection.refine().name);
    let name = options.name.clone().unwrap_or_else(derived);
    let name = options::checked_name(&name)?;
    let program = Program::new(selection, options)?;
    let mut manifest = describe::manifest(selection, &program, name, options);
    let mut files: Vec<File> = Vec::new();
    let choices = program.parts.choices();
    for profile in &options.profiles {
        let mut written = Vec::new();
        for Text { file, body } in writers::write(&program, *profile, name, options)? {
            if files.iter().any(|other| other.name == file.file) {
                return Err(ExportError::SameFile(file.file));
            }
            let bytes = match body {
                Body::Words(words) => words.iter().flat_map(|word| word.to_le_bytes()).collect(),
                Body::Source(text, first) => {
                    let head = header::head(&choices, &manifest, *profile, &file);
                    let at = text.split_inclusive('\n').take(first).map(str::len).sum();
                    let (before, after) = text.split_at(at);
                    [before, &head, "\n", after.trim_start_matches('\n')].concat().into_bytes()
                }
            };
            files.push(File { name: file.file.clone(), bytes });
            written.push(file);
        }
        let (target, profile) = (profile.target().name(), profile.name());
        manifest.targets.push(TargetFiles { target, profile, files: written });
    }
    let json = serde_json::to_string_pretty(&manifest);
    let json = json.map_err(|error| ExportError::Invalid(error.to_string()))?;
    files.push(File { name: format!("{name}.json"), bytes: (json + "\n").into_bytes() });
    Ok(Exported { files, manifest })
}

/// Checks that shaders can run all stages of a selection together.
fn check(selection: &Selection) -> Result<(), ExportError> {
    let geometry = selection.choices[GEOMETRY].entry;
    let is_sliced = geometry.geometry().shown.is_sliced() && !selection.counts_in_stencil();
    if selection.geometry().is_some() && !is_sliced {
        return Err(ExportError::Displaced { geometry: geometry.name });
    }
    if selection.rays_through_scene().is_some() {
        let (stage, entry) = (STAGES[SHADOW].title, selection.choices[SHADOW].entry.name);
        return Err(ExportError::OnlyCpu { stage, entry });
    }
    Ok(selection.check()?)
}
