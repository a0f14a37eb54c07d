//! Image-based objects: capture, files and comparison with the mesh.

mod bad_files;
mod captured;
mod verified;
