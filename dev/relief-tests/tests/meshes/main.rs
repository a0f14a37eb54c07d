//! Displaced meshes beside the truth: no holes, bounds that hold, all views.

mod culled_triangles;
mod mesh_attacked;
mod mesh_cracks;
mod mesh_displacement;
mod mesh_error;
mod mesh_error_on_meshes;
mod mesh_holes;
mod mesh_layers;
mod mesh_outputs;
mod mesh_pairs;
mod mesh_solids;
mod mesh_strips;
mod mesh_views;
mod wire;
