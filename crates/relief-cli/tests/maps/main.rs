//! Commands that make maps, `bake` and `height`, and metadata of heights.

#[path = "../common/mod.rs"]
mod common;

mod bad_height_input;
mod bake;
mod bake_files;
mod cache;
mod deband;
mod elevation;
mod engines;
mod for_mesh;
mod from_meshes;
mod from_view;
mod height;
mod height_files;
mod height_photos;
mod height_shading;
mod metres;
mod normal_holes;
mod volume;
