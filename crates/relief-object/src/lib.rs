//! Objects defined by images with depth (Kautz and Seidel 2001): reading, writing, and capture from
//! meshes.
//!
//! The object itself is [`ImageObject`](relief_core::object::ImageObject). [`read_object`] reads
//! one from a folder with an `object.toml` and an atlas of depths. [`Capturer`] renders images with
//! depth of a mesh.
//!
//! ```
//! use relief_core::object::{DEFAULT_JUMP_TEXELS, JumpCells};
//! use relief_core::{Watch, mesh::torus, raycast::Ray};
//! use relief_object::{CaptureSettings, Capturer, Cover};
//!
//! let settings = CaptureSettings { size: 64, ..CaptureSettings::default() };
//! let torus = torus(64, 32)?;
//! let captured = Capturer::new(&torus, None, settings)?.capture(Cover::Centre, &Watch::none())?;
//! // From above onto the tube.
//! let ray = Ray { origin: [0.35, 2.0, 0.0].into(), direction: [0.0, -1.0, 0.0].into() };
//! let object = captured.object(JumpCells::default(), DEFAULT_JUMP_TEXELS)?;
//! let hit = object.first_hit(&ray).ok_or("the torus is there")?;
//! assert!((hit.t - 1.85).abs() < 1e-2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arrangement;
mod capture;
mod file;
mod verify;
mod view_spec;

pub use arrangement::{Arrangement, MAX_GRID};
pub use capture::{
    CaptureError, CaptureSettings, Captured, CapturedImage, Capturer, Cover, MAX_IMAGE_SIDE, MIN_IMAGE_SIDE,
};
pub use file::{Description, Measured, ObjectFile, ObjectFileError, ObjectFileProblem, ObjectOptions};
pub use file::{OBJECT_FILE, ObjectFiles, ObjectWriter, WriteObjectError};
pub use file::{ViewEntry, parse_description, read_description, read_object, read_views};
pub use relief_core::object::DEFAULT_JUMP_TEXELS;
pub use verify::{MAX_PICTURES, Verification, even_directions};
pub use view_spec::{ViewKind, ViewSpec};
