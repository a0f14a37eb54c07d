//! Image-based depth objects (Kautz and Seidel 2001): from and to files.
//!
//! The object itself is [`ImageObject`](relief_core::object::ImageObject). [`read_object`] makes one of a
//! folder with an `object.toml` and an atlas of depths.

mod file;
mod view_spec;

pub use file::{DEFAULT_JUMP_TEXELS, ViewEntry, read_description, read_object, read_views};
pub use file::{Description, Measured, ObjectFile, ObjectFileError, ObjectFileProblem, ObjectOptions};
pub use view_spec::{ViewKind, ViewSpec};
