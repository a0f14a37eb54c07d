//! `cargo xtask link`: WESL modules in, their declarations and the Rust translation out.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use relief_shaders::shadow::ShadowRole;
use relief_shaders::{Entry, SHADOW, STAGES};
use wgsl_parse::syntax::TranslationUnit;

use self::lanes::LaneText;
use self::wesl_link::Features;
use crate::output::Generated;

mod bindings;
mod constants;
mod declarations;
mod dispatch;
mod docs;
mod explain;
mod lanes;
mod layout;
mod modules;
mod naga_check;
mod names;
mod rust;
mod wesl_link;

/// The modules whose functions other programs call, and which they are.
const FUNCTION_ROOTS: [(&str, &[&str]); 2] = [
    ("roots/functions", &["relief_hit", "relief_light", "relief_tile", "relief_curvature"]),
    ("roots/functions_of_triangles", &["relief_triangle_hit", "relief_triangle_light"]),
];

/// Roots of the programs that GPUs run. Their declarations are checked against the linker's result.
const GPU_ROOTS: [&str; 14] = [
    "roots/trace",
    "roots/trace_shells",
    "roots/stencil",
    "roots/draw",
    "roots/shade",
    "roots/gather",
    "roots/compose",
    "roots/resolve",
    "roots/show",
    "roots/screen",
    "roots/probe",
    "roots/paths",
    "roots/pyramid",
    "roots/tessellate",
];

/// The module whose functions are translated to Rust, in exact sampling, and which of them.
const CPU_ROOT: (&str, &[&str]) = (
    "roots/cpu",
    &[
        "shade_pixel",
        "pixel_of",
        "add_sample",
        "nothing_gathered",
        "reach_of_hit",
        "gather_segment",
        "pass_segment",
        "goes_on",
        "optical_depth",
        "transmittance_of",
        "seen_through",
        "ray_to_light",
        "background_at",
        "mirrored_light",
        "procedure_height",
        "voxel_of",
        "parts_between",
        "is_left_out",
        "site_of_vertex",
        "site_between",
        "site_inside",
        "displaced_site",
        "dice_rows",
        "dice_points",
        "dice_triangles",
        "dice_place",
        "dice_point",
        "dice_triangle",
        "is_swept",
        "sweep_on",
        "swept_points_of",
        "swept_column",
        "swept_weights",
        "zip_of",
        "zip_rest",
        "zip_goes_left",
        "zip_next",
    ],
);

/// The module whose functions are translated to Rust once more, with the marks of their loops.
const EXPLAIN_ROOT: (&str, &[&str]) = ("roots/explain", &["search_stage", "refine_stage"]);

/// Search and refinement over lanes, with all that they reach.
const TRACING: LaneText = LaneText {
    roots: &["trace", "shadow_search_stage", "wrapped_cell"],
    same_arguments: &[("wrapped_cell", "level"), ("continued_index", "wrap"), ("continued_pair", "wrap")],
    shared_members: &[("Path", "ray"), ("Path", "level")],
    by_hand: &["height_cell", "whole_cell"],
    ..LaneText::EMPTY
};

/// What comes before and after them, of rays that meet the same triangle.
const PIXELS: LaneText = LaneText {
    roots: &[
        "pixel_eye",
        "pixel_direction",
        "enter_relief",
        "segment_of",
        "hit_on_segment",
        "place_on_segment",
        "ray_to_light",
        "visible_light",
        "shade_hit",
    ],
    same_arguments: &[
        ("segment_of", "k"),
        ("hit_on_segment", "k"),
        ("continued_pair", "wrap"),
        ("ray_to_light", "number"),
        ("ray_to_light", "k"),
        ("ray_to_light", "count"),
        ("visible_light", "number"),
    ],
    shared_members: &[
        ("PixelIn", "side"),
        ("PixelIn", "a"),
        ("PixelIn", "b"),
        ("PixelIn", "c"),
        ("PixelIn", "shell"),
    ],
    one_by_one: is_one_by_one,
    by_hand: &[],
    levels_differ: true,
    blocks: &["Path", "Hit", "Entered", "PixelOut"],
};

/// Whether a function is called for each lane by itself: the rays of shadows go ways of their own, and so do
/// look-ups in shadow maps.
fn is_one_by_one(name: &str) -> bool {
    let stage = &STAGES[SHADOW];
    let goes_alone = |entry: &&Entry| {
        use ShadowRole::{FromEntry, LightViews, ToLights};
        matches!(entry.shadow(), Some(FromEntry | ToLights { .. } | LightViews { .. }))
    };
    let mut alone = stage.entries.iter().filter(goes_alone);
    ["folded_enter", "folded_segment", "is_in_hole"].contains(&name)
        || alone.any(|entry| stage.calls.iter().any(|call| stage.function_of(call, entry) == name))
}

/// All generated files.
pub fn files(workspace: &Path) -> Result<Vec<Generated>, String> {
    let modules = modules::Modules::read(&workspace.join("crates/relief-shaders/src"))?;
    let folder = PathBuf::from("crates/relief-shaders/generated");
    let declarations = declarations::all(&modules)?;
    let mut shared = Vec::new();
    for root in GPU_ROOTS {
        for fast in [false, true] {
            let linked = wesl_link::link(&modules, root, &[], Features { fast, explain: false })?;
            declarations::check(&declarations, &linked, fast)?;
            let (module, _) = valid(root, &linked)?;
            shared.push(module);
        }
    }
    for (root, keep) in FUNCTION_ROOTS {
        for fast in [false, true] {
            let linked = wesl_link::link(&modules, root, keep, Features { fast, explain: false })?;
            declarations::check(&declarations, &linked, fast)?;
            valid(root, &linked)?;
        }
    }
    let (root, keep) = CPU_ROOT;
    let linked = wesl_link::link(&modules, root, keep, Features::default())?;
    declarations::check(&declarations, &linked, false)?;
    let text = wesl_link::ordered(&linked)?;
    let (module, info) = valid("cpu", &linked)?;
    naga_check::refuse_untranslatable(&module, &info, &text, &modules)?;
    let docs = docs::Docs::of(&declarations);
    let rust = docs.add(&rust::translate(&module, &info)?)?;
    let explain = explained(&modules)?;
    let tracing = lanes::translate(&module, &info, &TRACING, &text, &modules)?;
    let pixels = lanes::translate(&module, &info, &PIXELS, &text, &modules)?;
    let blocks = lanes::blocks(&module, &PIXELS)?;
    let translated: BTreeSet<String> = module.types.iter().filter_map(|(_, ty)| ty.name.clone()).collect();
    let layout = docs.add(&layout::write(&shared.iter().collect::<Vec<_>>(), &translated)?)?;
    let written = declarations::write(&modules, &declarations);
    let files = [
        ("declarations.rs", written),
        ("cpu.rs", rust),
        ("explain.rs", explain),
        ("lanes.rs", tracing),
        ("pixel_lanes.rs", pixels),
        ("blocks.rs", blocks),
        ("layout.rs", layout),
    ];
    let generated =
        |(name, text): (&str, String)| Generated { path: folder.join(name), bytes: text.into_bytes() };
    Ok(files.map(generated).into())
}

/// The translation with marks.
fn explained(modules: &modules::Modules) -> Result<String, String> {
    let (root, keep) = EXPLAIN_ROOT;
    let linked = wesl_link::link(modules, root, keep, Features { fast: false, explain: true })?;
    let (module, info) = valid(root, &linked)?;
    naga_check::refuse_untranslatable(&module, &info, &wesl_link::ordered(&linked)?, modules)?;
    explain::marked(&rust::written(&module, &info)?)
}

fn valid(name: &str, linked: &TranslationUnit) -> Result<(naga::Module, naga::valid::ModuleInfo), String> {
    naga_check::validate(&wesl_link::ordered(linked)?).map_err(|error| format!("{name}: {error}"))
}
