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

/// Rays or paths of a workgroup of the probe and path passes.
pub const PROBE_GROUP: u32 = 64;

/// Rays of a row of these workgroups, so that more rays fit than a dispatch has columns.
pub const PROBE_ROW: u32 = 65_536;

/// Vertices, edges, triangles, blocks or points of a workgroup of the passes that tessellate.
pub const TESSELLATE_GROUP: u32 = 64;

/// Vertices, edges, triangles, blocks or points of a row of such workgroups; see [`PROBE_ROW`].
pub const TESSELLATE_ROW: u32 = 65_536;

/// Tallies that one invocation adds up.
pub const TESSELLATE_BLOCK: u32 = 256;

/// The coarsest level of a grid that divides bases: no side is divided there.
pub const TESSELLATE_COARSEST: u32 = 20;

/// The value in place of the number of a side for a point inside a triangle.
pub const TESSELLATE_INSIDE: u32 = 3;

/// The value in place of an edge's triangles if it has more than two.
pub const TESSELLATE_COUNTLESS: u32 = u32::MAX;

/// Vertices of the box that [`Root::DrawShells`] draws for a triangle.
pub const BOX_VERTICES: u32 = 36;

/// The number that is added in a leaf of the BVH of [`Root::TraceShells`] if its triangle is seen
/// turned over, too.
pub const SHELL_BOTH_SIDES: u32 = 1;

/// The factor on the number of a leaf's triangle.
pub const SHELL_TRIANGLE: u32 = 2;

/// The way in which textures are read.
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

    /// Returns the name of this sampling, as files and the command spell it: `exact` or `fast`.
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

/// The purpose of an assembled shader, with the names of its entry points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Root {
    /// Only functions, for a program with its own entry points, in tangent space:
    /// `relief_hit`, `relief_light`, `relief_tile`, `relief_curvature`. Of surfaces whose rays
    /// go through the frame of a base point.
    Functions,
    /// The same over a triangle and the space above it: `relief_triangle_hit`, `relief_triangle_light`.
    TriangleFunctions,
    /// Rasterises the base mesh and traces it: `vertex_main`, `fragment_main`.
    Trace,
    /// Traces shells, which rays find in a BVH: `cover_vertex`, whose three vertices cover the
    /// picture, and `shells_main`.
    TraceShells,
    /// Traces objects of images: `cover_vertex`, `objects_main`.
    TraceObjects,
    /// Fills a shadow map like [`Root::Trace`], with the keys of the hits alone: `vertex_main`,
    /// `light_main`.
    Light,
    /// Fills a shadow map of shells: `cover_vertex`, `shells_light_main`.
    LightShells,
    /// Fills a shadow map of objects of images: `cover_vertex`, `objects_light_main`.
    LightObjects,
    /// Rasterises slices through an object, one pass per image. `stencil_vertex` takes the image as
    /// the instance. `stencil_test_fragment` keeps the points that must be counted.
    /// `stencil_hit_fragment` does so for the last image, with the output of [`Root::Trace`].
    /// `stencil_clear_fragment` covers all of a slice.
    Stencil,
    /// Fills a program's own depth buffer before its own pass, with the very bits of `z` that
    /// shading gives: `vertex_main`, `prepass_main`.
    Prepass,
    /// Fills a depth buffer with shells, whose boxes are rasterised: `shell_vertex`,
    /// `shell_prepass_main`. Each triangle has [`BOX_VERTICES`]; a second instance is the mesh
    /// turned over.
    PrepassShells,
    /// Fills a depth buffer with objects of images, which fill these boxes: `shell_vertex`,
    /// `prepass_main`.
    PrepassObjects,
    /// Traces and shades a surface in a single pass of a program's own, and gives linear colours:
    /// `draw_vertex`, `draw_fragment`. The depth test of the triangles decides what lies nearer.
    Draw,
    /// Draws with the `z` of the hits, for a program's own depth buffer: `draw_vertex`,
    /// `draw_depth_fragment`.
    DrawDepth,
    /// Draws shells with the `z` of the hits: `draw_box_vertex`, `draw_box_fragment`.
    DrawShells,
    /// Draws objects of images with the `z` of the hits: `draw_box_vertex`, `draw_depth_fragment`.
    DrawObjects,
    /// Draws the shells of a translucent surface, to be blended with premultiplied alpha from the
    /// farthest to the nearest: `draw_box_vertex`, `draw_translucent_fragment`.
    DrawTranslucent,
    /// Shades the traced hits: `shade_main`.
    Shade,
    /// Gathers the light of a translucent surface in front of the shaded hits: `gather_main`.
    Gather,
    /// Says how far rays go before light is gathered, and lays what was gathered over the shaded hits:
    /// `begin_gather_main`, `compose_main`.
    Compose,
    /// Adds the shaded colours to the samples before: `resolve_main`.
    Resolve,
    /// Makes a picture of the shaded colours: `show_main`.
    Show,
    /// Makes a picture for screens of the shaded colours: `screen_main`.
    Screen,
    /// Runs the stages over a list of rays and writes every stage's result: `probe_main`.
    Probe,
    /// Runs search and refinement over a list of paths: `paths_main`.
    Paths,
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
    pub const ALL: [Root; 27] = [
        Root::Functions,
        Root::TriangleFunctions,
        Root::Trace,
        Root::TraceShells,
        Root::TraceObjects,
        Root::Light,
        Root::LightShells,
        Root::LightObjects,
        Root::Stencil,
        Root::Prepass,
        Root::PrepassShells,
        Root::PrepassObjects,
        Root::Draw,
        Root::DrawDepth,
        Root::DrawShells,
        Root::DrawObjects,
        Root::DrawTranslucent,
        Root::Shade,
        Root::Gather,
        Root::Compose,
        Root::Resolve,
        Root::Show,
        Root::Screen,
        Root::Probe,
        Root::Paths,
        Root::Pyramid,
        Root::Tessellate,
    ];

    /// Returns the functions that it is assembled for.
    pub const fn functions(self) -> &'static [&'static str] {
        match self {
            Root::Functions => &["relief_hit", "relief_light", "relief_tile", "relief_curvature"],
            Root::TriangleFunctions => &["relief_triangle_hit", "relief_triangle_light"],
            Root::Trace => &["vertex_main", "fragment_main"],
            Root::TraceShells => &["cover_vertex", "shells_main"],
            Root::TraceObjects => &["cover_vertex", "objects_main"],
            Root::Light => &["vertex_main", "light_main"],
            Root::LightShells => &["cover_vertex", "shells_light_main"],
            Root::LightObjects => &["cover_vertex", "objects_light_main"],
            Root::Stencil => {
                &["stencil_vertex", "stencil_test_fragment", "stencil_hit_fragment", "stencil_clear_fragment"]
            }
            Root::Prepass => &["vertex_main", "prepass_main"],
            Root::PrepassShells => &["shell_vertex", "shell_prepass_main"],
            Root::PrepassObjects => &["shell_vertex", "prepass_main"],
            Root::Draw => &["draw_vertex", "draw_fragment"],
            Root::DrawDepth => &["draw_vertex", "draw_depth_fragment"],
            Root::DrawShells => &["draw_box_vertex", "draw_box_fragment"],
            Root::DrawObjects => &["draw_box_vertex", "draw_depth_fragment"],
            Root::DrawTranslucent => &["draw_box_vertex", "draw_translucent_fragment"],
            Root::Shade => &["shade_main"],
            Root::Gather => &["gather_main"],
            Root::Compose => &["begin_gather_main", "compose_main"],
            Root::Resolve => &["resolve_main"],
            Root::Show => &["show_main"],
            Root::Screen => &["screen_main"],
            Root::Probe => &["probe_main"],
            Root::Paths => &["paths_main"],
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
                "swept_main",
            ],
        }
    }
}

/// A module of the sources.
pub(crate) struct Module {
    /// The path, such as `search/linear`.
    pub path: &'static str,
    /// The comment at its head.
    pub head: &'static str,
}

/// A declaration of a module.
pub(crate) struct Declaration {
    /// The path of its module.
    pub module: &'static str,
    pub name: &'static str,
    /// The sampling that it belongs to; `None` if it serves both.
    pub sampling: Option<Sampling>,
    /// The other declarations that it uses, and the stages that it calls.
    pub uses: &'static [&'static str],
    /// The declaration as it is written, with its comment first.
    pub text: &'static str,
}

/// Assembles the shader of a selection: all that its root reaches, and nothing else. The text is
/// the same on every run.
pub fn assemble(selection: &Selection, root: Root, sampling: Sampling) -> String {
    let parts = Parts::new(selection, root, sampling);
    let mut text = parts.choices();
    if !parts.bindings.is_empty() {
        let _ = write!(text, "//\n// Bindings:\n{}", bindings::table(&parts.bindings));
    }
    text + &parts.code()
}

/// A shader in parts, for programs that write a head of their own, or number the bindings anew.
///
/// ```
/// use relief_shaders::Selection;
/// use relief_shaders::wgsl::{Parts, Root, Sampling};
///
/// let mut parts = Parts::new(&Selection::method("steep")?, Root::Draw, Sampling::Exact);
/// for (number, binding) in (0..).zip(&mut parts.bindings) {
///     (binding.group, binding.number) = (2, number);
/// }
/// assert!(parts.code().contains("@group(2) @binding(1) var height_map: texture_2d<f32>;"));
/// # Ok::<(), relief_shaders::SelectionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Parts {
    selection: Selection,
    sampling: Sampling,
    reached: BTreeSet<String>,
    /// The bindings, in the order of [`BINDINGS`](bindings::BINDINGS). [`Parts::code`] declares
    /// variables with the groups and numbers given here.
    pub bindings: Vec<Binding>,
}

impl Parts {
    /// Collects the parts of a selection that a root reaches.
    pub fn new(selection: &Selection, root: Root, sampling: Sampling) -> Self {
        let reached = reached(selection, root.functions(), sampling);
        let bindings = bindings::BINDINGS.into_iter().filter(|binding| reached.contains(binding.name));
        Self { selection: *selection, sampling, bindings: bindings.collect(), reached }
    }

    /// Whether the stage at `place` in [`STAGES`] is run.
    pub fn has_stage(&self, place: usize) -> bool {
        STAGES[place].functions().any(|function| self.reached.contains(&function))
    }

    /// Returns a comment on the choices: for each stage the variant, its publication, its map and
    /// its parameters.
    pub fn choices(&self) -> String {
        let mut text = head(&format!("{} sampling", self.sampling));
        for (place, stage) in STAGES.iter().enumerate().filter(|(place, _)| self.has_stage(*place)) {
            chosen(&mut text, place, stage, &self.selection.choices[place]);
        }
        text
    }

    /// Returns the declarations, with the comments of their sources.
    pub fn code(&self) -> String {
        // Looked up once: there are many declarations, and many modules.
        let is_part = |declaration: &&Declaration| {
            declaration.sampling.is_none_or(|of| of == self.sampling)
                && self.reached.contains(declaration.name)
        };
        let declared: Vec<&Declaration> = DECLARATIONS.iter().filter(is_part).collect();
        let mut text = String::new();
        for Module { path, head } in MODULES {
            let mut of_module = declared.iter().filter(|declaration| declaration.module == *path).peekable();
            if of_module.peek().is_none() {
                continue;
            }
            let _ = write!(text, "\n// {}\n", "-".repeat(77));
            text.push_str(head);
            let mut was_short = false;
            for declaration in of_module {
                // Declarations of one line stand together.
                let is_short = !declaration.text.contains('\n');
                if !(is_short && was_short) {
                    text.push('\n');
                }
                was_short = is_short;
                let bound = self.bindings.iter().find(|binding| binding.name == declaration.name);
                match bound {
                    Some(binding) => text.push_str(&binding.declaration()),
                    None => text.push_str(declaration.text),
                }
                text.push('\n');
            }
        }
        for (place, stage) in STAGES.iter().enumerate() {
            for call in stage.calls {
                if self.reached.contains(stage.function(call).as_str()) {
                    text.push_str(&called(place, stage, call, &self.selection.choices[place]));
                }
            }
        }
        text
    }
}

/// A function that is part of no stage and reads no binding, with all that it calls.
pub(crate) fn of_function(name: &str) -> String {
    let (selection, sampling) = (Selection::default(), Sampling::Exact);
    let reached = reached(&selection, &[name], sampling);
    let parts = Parts { selection, sampling, bindings: Vec::new(), reached };
    format!("{}{}", head(&format!("the function {name}")), parts.code())
}

/// The first lines of a shader, which name it.
fn head(what: &str) -> String {
    format!("// Relief: displacement mapping, {what}.\n// SPDX-License-Identifier: MIT OR Apache-2.0\n")
}

/// The names that functions reach.
fn reached(selection: &Selection, functions: &[&str], sampling: Sampling) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut waiting: Vec<String> = functions.iter().map(|&name| name.to_owned()).collect();
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

/// The function that calls the variant chosen for a stage.
fn called(place: usize, stage: &Stage, call: &Call, choice: &Choice) -> String {
    let declared: Vec<String> = call.inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = call.inputs.iter().map(|(name, _)| *name).collect();
    format!(
        "\n// The chosen {}: {}.\nfn {}({}) -> {} {{\n    \
         return {}({}, surface_settings.choices[{place}].params);\n}}\n",
        stage.title,
        choice.entry.summary,
        stage.function(call),
        declared.join(", "),
        call.returns,
        stage.function_of(call, choice.entry),
        passed.join(", "),
    )
}

/// Writes the choice for a stage: its publication, its map and its parameters.
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
            "//   surface_settings.choices[{place}].params.{component}: {}, {} ({} to {}, default {})",
            param.name, param.summary, param.min, param.max, param.default
        );
    }
}

#[cfg(test)]
mod tests;
