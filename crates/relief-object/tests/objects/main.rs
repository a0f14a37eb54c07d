//! Image-based objects: captured, kept in files, verified.

mod bad_files;
mod captured;
mod verified;
