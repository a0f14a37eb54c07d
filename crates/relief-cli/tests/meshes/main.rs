//! Commands that make meshes and depth objects: `mesh`, `slices`, `capture`.

#[path = "../common/mod.rs"]
mod common;

mod bad_objects;
mod capture;
mod displaced_mesh;
mod mesh;
mod mesh_files;
mod mesh_keys;
mod mesh_solids;
mod motif_shells;
mod slices;
