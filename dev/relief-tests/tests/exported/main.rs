//! Exported shaders beside the renderer.

mod exported_pictures;
mod exported_shaders;
mod exported_slices;
mod functions;
mod triangle_functions;
mod unreal;
