//! Commands that make pictures: `render`, `compare`, `bench`.

#[path = "../common/mod.rs"]
mod common;

mod around;
mod bench;
mod blocks;
mod compare;
mod compare_files;
mod file_materials;
mod frames;
mod gltf_materials;
mod notes;
mod page;
mod page_files;
mod pictures;
mod procedure;
mod shown;
mod view;
mod views;
