//! Tests of reading and writing files, valid and broken.

#[path = "../common/mod.rs"]
mod common;

mod broken_files;
mod broken_gltf;
mod broken_meshes;
mod color_tables;
mod exr_and_tiff;
mod formats;
mod geotiff;
mod gltf_materials;
mod gltf_poses;
mod ktx2;
mod mesh_writers;
mod meshes;
mod nodata;
mod options;
mod orientation;
mod pictures;
mod real_data;
mod sidecars;
mod sources;
mod texts;
mod textures;
mod units;
mod volumes;
mod writers;
