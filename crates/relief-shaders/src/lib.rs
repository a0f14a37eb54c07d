//! Per-pixel displacement mapping as shaders: stages, each variant written once in WESL, linked to plain WGSL
//! for GPUs and translated to Rust for CPUs.
//!
//! * [`STAGES`] is the table of the stages; [`geometry`], [`surface`], [`field`], [`detail`], [`search`],
//!   [`refine`], [`shade`], [`shadow`], [`ambient`], [`mod@slice`] and [`object`] list their variants, one
//!   file each beside its shader.
//! * [`METHODS`] names pairs of search and refinement; [`procedure`] has formulas that fill height maps.
//! * [`wgsl`] assembles shaders as text for any engine; [`bindings`] says what they bind.
//! * `cpu` (with the feature of that name) is the same shaders as Rust.
//!
//! ```
//! use relief_shaders::Selection;
//! use relief_shaders::wgsl::{Root, Sampling, assemble};
//!
//! let text = assemble(&Selection::method("cone")?, Root::Functions, Sampling::Exact);
//! assert!(text.contains("fn search_cone"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod ambient;
pub mod bindings;
#[cfg(feature = "cpu")]
pub mod cpu;
pub mod detail;
mod entry;
pub mod field;
pub mod geometry;
#[path = "../generated/declarations.rs"]
#[rustfmt::skip]
#[allow(clippy::all)]
mod generated;
mod light_ray;
mod maps;
mod methods;
pub mod object;
pub mod procedure;
pub mod refine;
mod scene_maps;
pub mod search;
mod selection;
pub mod shade;
pub mod shadow;
pub mod slice;
mod slots;
mod stages;
pub mod surface;
mod variants;
pub mod wgsl;

pub use entry::{Companion, Entry, Role, TracingRole, find};
pub use light_ray::LightRayState;
pub use maps::{MapError, MapNeed, MapProblem, SlotMaps};
pub use methods::{Family, METHODS, Method, method};
pub use selection::{Choice, Selection, SelectionError};
pub use slots::MapSlot;
pub use stages::{
    AMBIENT, Call, DETAIL, FIELD, GEOMETRY, OBJECT, REFINE, SEARCH, SHADE, SHADOW, SHADOW_SEARCH, SLICES,
    STAGES, SURFACE, Stage, stage, stage_of_setting,
};
pub use variants::Variants;

/// The most lights of a picture: the length of the shaders' array of lights.
pub const MAX_LIGHTS: usize = 8;

/// The most shadow maps of a light: one for each face of a cube around it.
pub const LIGHT_FACES: usize = 6;

/// The most shadow maps in a picture.
pub const MAX_LIGHT_VIEWS: usize = LIGHT_FACES * MAX_LIGHTS;

/// The survey that classifies every per-pixel method by its search and its refinement.
const SURVEY: &str = "Szirmay-Kalos and Umenhoffer 2008, Displacement Mapping on the GPU - State of the Art";

/// The paper on slices, and on objects of images with depth.
const DEPTH_OBJECTS: &str =
    "Kautz and Seidel 2001, Hardware Accelerated Displacement Mapping for Image Based Rendering";

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use relief_core::registry::{MAX_PARAMS, MapSetting, SHADER_PARAMS};

    use super::*;

    fn stems(stage: &str, extension: &str) -> BTreeSet<String> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(stage);
        std::fs::read_dir(folder)
            .expect("the stage's folder")
            .map(|file| file.expect("a readable folder").path())
            .filter(|path| path.extension().is_some_and(|found| found == extension))
            .map(|path| path.file_stem().expect("a file has a name").to_string_lossy().into_owned())
            .filter(|stem| stem != "mod" && stem != "tests")
            .collect()
    }

    #[test]
    fn every_file_is_listed_and_every_entry_has_its_files() {
        let listed: BTreeSet<String> = procedure::ENTRIES.iter().map(|entry| entry.name.to_owned()).collect();
        for extension in ["rs", "wesl"] {
            assert_eq!(
                stems("procedure", extension),
                listed,
                "procedures: {extension} files and list differ"
            );
        }
        for Stage { key, folder, entries, calls, .. } in &STAGES {
            let listed: BTreeSet<String> = entries.iter().map(|entry| entry.name.replace('-', "_")).collect();
            assert_eq!(listed.len(), entries.len(), "{key}: a name stands twice");
            assert_eq!(stems(folder, "rs"), listed, "{key}: Rust files and list differ");
            let shaders = if calls.is_empty() { BTreeSet::new() } else { listed };
            assert_eq!(stems(folder, "wesl"), shaders, "{key}: shader files and list differ");
        }
    }

    #[test]
    fn a_variant_reads_one_baked_map_at_most_and_from_a_slot_of_its_stage() {
        for Stage { key, entries, slot, .. } in &STAGES {
            for entry in *entries {
                assert!(entry.maps.len() <= usize::from(slot.is_some()), "{key} {}", entry.name);
                for (name, value) in entry.maps.iter().flat_map(|map| map.settings) {
                    if let MapSetting::Param(param) = value {
                        assert!(entry.param(param).is_some(), "{key} {}: {name} of {param}", entry.name);
                    }
                }
            }
        }
    }

    #[test]
    fn parameters_beyond_those_of_shaders_choose_a_map() {
        for Stage { key, entries, .. } in &STAGES {
            for entry in *entries {
                for param in entry.params.iter().skip(SHADER_PARAMS) {
                    let chooses = |(_, value): &(_, MapSetting)| *value == MapSetting::Param(param.name);
                    let mut settings = entry.maps.iter().flat_map(|map| map.settings);
                    assert!(settings.any(chooses), "{key} {}: {}", entry.name, param.name);
                }
            }
        }
    }

    #[test]
    fn defaults_are_in_range() {
        for Stage { key, entries, .. } in &STAGES {
            for entry in *entries {
                assert!(entry.params.len() <= MAX_PARAMS, "{key} {}", entry.name);
                for param in entry.params {
                    assert!(param.min <= param.default && param.default <= param.max, "{}", param.name);
                    assert!(!param.integer || param.default.fract() == 0.0, "{}", param.name);
                }
            }
        }
    }
}
