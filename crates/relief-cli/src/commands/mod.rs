//! The subcommands, one file each.

pub mod bake;
pub mod bench;
pub mod capture;
pub mod compare;
pub mod completions;
pub mod explain;
pub mod height;
pub mod inputs;
pub mod inspect;
mod lengths;
pub mod man;
pub mod maps;
pub mod material_arguments;
pub mod mesh;
pub mod method_set;
pub mod methods;
pub mod motif;
pub mod numbered;
pub mod placement;
pub mod render;
pub mod scene;
pub mod scene_arguments;
pub mod shader;
pub mod slices;
pub mod staged;
pub mod stages;
pub mod volume;
