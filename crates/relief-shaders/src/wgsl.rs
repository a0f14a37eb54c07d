//! The shaders as plain WGSL without imports, for any engine that reads it: assembled from the declarations
//! that a selection reaches, with the comments of their sources.
//!
//! Only the structure is assembled. Parameters, sizes and wrap stay in uniform buffers, so that one shader
//! serves every scene that has the same variants.
//!
//! ```
//! use relief_shaders::Selection;
//! use relief_shaders::wgsl::{Root, Sampling, assemble};
//!
//! let text = assemble(&Selection::method("cone")?, Root::Functions, Sampling::Exact);
//! assert!(text.contains("fn search_cone(") && !text.contains("fn search_linear("));
//! # Ok::<(), relief_shaders::SelectionError>(())
//! ```

use std::collections::BTreeSet;
use std::fmt::{self, Write as _};
use std::str::FromStr;

use relief_core::registry::UnknownName;

use crate::bindings::{self, Binding};
use crate::generated::{DECLARATIONS, MODULES};
use crate::stages::{Call, STAGES, Stage};
use crate::{Choice, Selection};

/// Rows and columns of a workgroup of the passes over pixels.
pub const SHADE_GROUP: u32 = 8;

/// Rays of a workgroup of the probe.
pub const PROBE_GROUP: u32 = 64;

/// Rays of a row of the probe's workgroups, so that more rays fit than a dispatch has columns.
pub const PROBE_ROW: u32 = 65_536;

/// Vertices, edges, triangles, blocks or points of a workgroup of the passes that tessellate.
pub const TESSELLATE_GROUP: u32 = 64;

/// Those of a row of workgroups, as [`PROBE_ROW`].
pub const TESSELLATE_ROW: u32 = 65_536;

/// Tallies that one invocation adds up.
pub const TESSELLATE_BLOCK: u32 = 256;

/// Vertices of the box that [`Root::TraceShells`] draws for a triangle.
pub const BOX_VERTICES: u32 = 36;

/// How textures are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sampling {
    /// Texels are loaded and interpolated in plain arithmetic: the same bits on every machine.
    #[default]
    Exact,
    /// The GPU's sampler interpolates: faster, with 8 bits of sub-texel precision on most hardware.
    Fast,
}

impl Sampling {
    /// Every choice, in the order in which help lists them.
    pub const ALL: [Sampling; 2] = [Sampling::Exact, Sampling::Fast];

    /// The name used on the command line and in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Sampling::Exact => "exact",
            Sampling::Fast => "fast",
        }
    }
}

impl fmt::Display for Sampling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Sampling {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|choice| choice.name() == name);
        found.ok_or_else(|| UnknownName::new("sampling", name, Self::ALL.map(Self::name)))
    }
}

/// What a shader is assembled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Root {
    /// The functions alone, for a program of one's own: `shade_pixel` is a whole pixel, `pixel_of` makes what
    /// it takes of a point of the picture and a triangle's corners.
    Functions,
    /// Rasterises the base mesh and traces it: `vertex_main`, `fragment_main`.
    Trace,
    /// Rasterises boxes around the shells of the base mesh and traces it: `shell_vertex`, `fragment_main`.
    /// Each triangle has [`BOX_VERTICES`]; a second instance is the mesh turned over.
    TraceShells,
    /// As [`Root::Trace`], for what a light sees: the keys of the hits alone: `vertex_main`, `light_main`.
    Light,
    /// The same of shells: `shell_vertex`, `light_main`.
    LightShells,
    /// As [`Root::Trace`], for a program's own depth buffer, which it fills before its own pass: to the bit
    /// the `z` that shading gives: `vertex_main`, `prepass_main`.
    Prepass,
    /// The same of shells: `shell_vertex`, `prepass_main`.
    PrepassShells,
    /// Shades what was traced: `shade_main`.
    Shade,
    /// Adds what was shaded to the samples before: `resolve_main`.
    Resolve,
    /// Makes a picture of what was shaded: `show_main`.
    Show,
    /// Runs the stages over a list of rays and writes every stage's result: `probe_main`.
    Probe,
    /// Builds a level of a pyramid of heights: `pyramid_vertex`, `pyramid_fragment`. It binds nothing of
    /// group 0.
    Pyramid,
    /// Makes displaced triangles of a base for a view, in passes one after the other: `begin_main`,
    /// `voxels_main`, `seen_main`; for each level of the grid `edges_main`, `patches_main`, `blocks_main` and
    /// `totals_main`; then `starts_main`, `points_main` and `triangles_main`.
    Tessellate,
}

impl Root {
    /// Every root.
    pub const ALL: [Root; 13] = [
        Root::Functions,
        Root::Trace,
        Root::TraceShells,
        Root::Light,
        Root::LightShells,
        Root::Prepass,
        Root::PrepassShells,
        Root::Shade,
        Root::Resolve,
        Root::Show,
        Root::Probe,
        Root::Pyramid,
        Root::Tessellate,
    ];

    /// The functions that it is assembled for.
    pub const fn functions(self) -> &'static [&'static str] {
        match self {
            Root::Functions => &["pixel_of", "shade_pixel"],
            Root::Trace => &["vertex_main", "fragment_main"],
            Root::TraceShells => &["shell_vertex", "fragment_main"],
            Root::Light => &["vertex_main", "light_main"],
            Root::LightShells => &["shell_vertex", "light_main"],
            Root::Prepass => &["vertex_main", "prepass_main"],
            Root::PrepassShells => &["shell_vertex", "prepass_main"],
            Root::Shade => &["shade_main"],
            Root::Resolve => &["resolve_main"],
            Root::Show => &["show_main"],
            Root::Probe => &["probe_main"],
            Root::Pyramid => &["pyramid_vertex", "pyramid_fragment"],
            Root::Tessellate => &[
                "begin_main",
                "voxels_main",
                "seen_main",
                "edges_main",
                "patches_main",
                "blocks_main",
                "totals_main",
                "starts_main",
                "points_main",
                "triangles_main",
            ],
        }
    }
}

/// A module of the sources.
pub(crate) struct Module {
    /// Its path, such as `search/linear`.
    pub path: &'static str,
    /// The comment at its head.
    pub head: &'static str,
}

/// A declaration of a module.
pub(crate) struct Declaration {
    /// The path of its module.
    pub module: &'static str,
    pub name: &'static str,
    /// The sampling that it is for, where there is one for each.
    pub sampling: Option<Sampling>,
    /// The other declarations that it uses, and the stages that it calls.
    pub uses: &'static [&'static str],
    /// As it is written, its comment first.
    pub text: &'static str,
}

/// The shader of a selection: what its root reaches, and nothing else. The same text on every run.
pub fn assemble(selection: &Selection, root: Root, sampling: Sampling) -> String {
    let reached = reached(selection, root, sampling);
    let declared = || {
        DECLARATIONS.iter().filter(|declaration| {
            declaration.sampling.is_none_or(|of| of == sampling) && reached.contains(declaration.name)
        })
    };
    let mut text = head(selection, &reached, sampling);
    for Module { path, head } in MODULES {
        let mut of_module = declared().filter(|declaration| declaration.module == *path).peekable();
        if of_module.peek().is_none() {
            continue;
        }
        let _ = write!(text, "\n// {}\n", "-".repeat(77));
        text.push_str(head);
        let mut was_short = false;
        for declaration in of_module {
            // Declarations of a line stand together.
            let is_short = !declaration.text.contains('\n');
            if !(is_short && was_short) {
                text.push('\n');
            }
            was_short = is_short;
            text.push_str(declaration.text);
            text.push('\n');
        }
    }
    for (place, stage) in STAGES.iter().enumerate() {
        for call in stage.calls {
            if reached.contains(stage.function(call).as_str()) {
                text.push_str(&called(place, stage, call, &selection.choices[place]));
            }
        }
    }
    text
}

/// The names that a root reaches.
fn reached(selection: &Selection, root: Root, sampling: Sampling) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut waiting: Vec<String> = root.functions().iter().map(|&name| name.to_owned()).collect();
    while let Some(name) = waiting.pop() {
        if !reached.insert(name.clone()) {
            continue;
        }
        for (stage, choice) in STAGES.iter().zip(&selection.choices) {
            if let Some(call) = stage.calls.iter().find(|call| stage.function(call) == name) {
                waiting.push(stage.function_of(call, choice.entry));
                waiting.push("surface_settings".to_owned());
            }
        }
        for declaration in DECLARATIONS.iter().filter(|declaration| declaration.name == name) {
            if declaration.sampling.is_none_or(|of| of == sampling) {
                waiting.extend(declaration.uses.iter().map(|&name| name.to_owned()));
            }
        }
    }
    reached
}

/// The call of a function of the variant that is chosen for a stage.
fn called(place: usize, stage: &Stage, call: &Call, choice: &Choice) -> String {
    let declared: Vec<String> = call.inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = call.inputs.iter().map(|(name, _)| *name).collect();
    format!(
        "\n// The {} that is chosen: {}.\nfn {}({}) -> {} {{\n    return {}({}, surface_settings.choices[{place}].params);\n}}\n",
        stage.title,
        choice.entry.summary,
        stage.function(call),
        declared.join(", "),
        call.returns,
        stage.function_of(call, choice.entry),
        passed.join(", "),
    )
}

/// The comment at the head: what was chosen, with its parameters, and what is to be bound.
fn head(selection: &Selection, reached: &BTreeSet<String>, sampling: Sampling) -> String {
    let mut text = format!(
        "// Relief: displacement mapping, {sampling} sampling.\n// SPDX-License-Identifier: MIT OR Apache-2.0\n"
    );
    for (place, stage) in STAGES.iter().enumerate() {
        if stage.functions().any(|function| reached.contains(&function)) {
            chosen(&mut text, place, stage, &selection.choices[place]);
        }
    }
    let bound: Vec<&Binding> =
        bindings::BINDINGS.iter().filter(|binding| reached.contains(binding.name)).collect();
    if !bound.is_empty() {
        let _ = write!(text, "//\n// Bindings:\n{}", bindings::table(&bound));
    }
    text
}

/// What is chosen for a stage, where it was published, what it reads and what its parameters are.
fn chosen(text: &mut String, place: usize, stage: &Stage, choice: &Choice) {
    let Choice { entry, .. } = choice;
    let published = [entry.publication.paper, entry.publication.section].join(", ");
    let published = published.trim_end_matches(", ");
    let _ = write!(text, "//\n// {}: {}, {} ({published})\n", stage.title, entry.name, entry.summary);
    for map in entry.maps {
        let name = [map.kind, map.texture].join(" ");
        let slot = stage.slot.map_or("", |slot| slot.name());
        let _ = writeln!(text, "//   {slot}: a baked map of the kind {}", name.trim_end());
    }
    for (param, component) in entry.params.iter().zip(["x", "y", "z", "w"]) {
        let _ = writeln!(
            text,
            "//   surface_settings.choices[{place}].params.{component}: {}, {} ({} to {}, usually {})",
            param.name, param.summary, param.min, param.max, param.default
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{refine, search};

    fn pairs() -> impl Iterator<Item = Selection> {
        let names =
            search::ENTRIES.iter().flat_map(|a| refine::ENTRIES.iter().map(move |b| (a.name, b.name)));
        names.map(|(search, refine)| Selection::pair(search, refine).expect("listed names"))
    }

    fn validate(text: &str) -> Result<(), String> {
        let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
        let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
        let valid = naga::valid::Validator::new(flags, capabilities).validate(&module);
        valid.map(drop).map_err(|error| error.emit_to_string(text))
    }

    #[test]
    fn every_pair_gives_a_valid_shader_and_the_same_one_again() {
        for selection in pairs() {
            for root in Root::ALL {
                for sampling in [Sampling::Exact, Sampling::Fast] {
                    let text = assemble(&selection, root, sampling);
                    let name = || format!("{} {} {root:?}", selection.search().name, selection.refine().name);
                    validate(&text).unwrap_or_else(|error| panic!("{}: {error}", name()));
                    assert_eq!(text, assemble(&selection, root, sampling), "{}", name());
                }
            }
        }
    }

    #[test]
    fn a_broken_shader_is_noticed() {
        let text = assemble(&Selection::default(), Root::Functions, Sampling::Exact);
        assert!(validate(&text.replace("fn height_at", "fn height_elsewhere")).is_err());
    }

    #[test]
    fn a_shader_holds_what_its_root_reaches_and_nothing_else() {
        let cone = Selection::method("cone").expect("a method");
        let trace = assemble(&cone, Root::Trace, Sampling::Exact);
        for there in ["fn search_cone(", "fn refine_patch(", "// Cone stepping", "search_map, the baked map"]
        {
            assert!(trace.contains(there), "{there}");
        }
        for gone in ["search_linear", "frustum", "shade_", "color_map", "map_sampler", "override", "switch"] {
            assert!(!trace.contains(gone), "{gone}");
        }
        // Shading without rays to the lights is the same whatever was searched for.
        let frustum = Selection::method("frustum").expect("a method");
        let shade = |selection: &Selection, shadow| {
            let mut selection = *selection;
            selection.choose("shadow", shadow).expect("a shadow");
            assemble(&selection, Root::Shade, Sampling::Exact)
        };
        assert_eq!(shade(&cone, "none"), shade(&frustum, "none"));
        assert!(shade(&frustum, "ray").contains("fn search_frustum("));
        assert!(assemble(&cone, Root::Shade, Sampling::Fast).contains("map_sampler"));
    }
}
