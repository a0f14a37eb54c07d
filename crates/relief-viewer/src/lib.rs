//! What a viewer of reliefs does, without a window and without threads of its own.
//!
//! * [`Viewer`] answers messages: its state, actions, pictures, dropped files, and files to save.
//! * [`Drawing`] draws one scene after the other, and keeps what they share.
//! * [`Given`] takes files that a user drops, and says what they change in a scene.
//!
//! ```
//! use relief_core::Watch;
//! use relief_io::MemoryFiles;
//! use relief_viewer::{Asked, Viewer};
//!
//! let mut files = MemoryFiles::new();
//! files.insert("wall.pgm", b"P5 2 2 255\n\x00\x40\x80\xff".as_slice())?;
//! files.insert("scene.toml", b"height = \"wall.pgm\"".as_slice())?;
//! let mut viewer = Viewer::open(files, "scene.toml".as_ref())?;
//! let picture = viewer.picture(Asked::whole([8, 6]), &Watch::none())?;
//! assert_eq!(picture.pixels.len(), 8 * 6 * 4);
//! assert!(viewer.save("picture.png", &Watch::none())?.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod drawing;
mod given;
mod saved;
#[cfg(test)]
mod tests;
mod viewer;

pub use drawing::{Asked, Drawing, Drawn, NotDrawn, shown};
pub use given::Given;
pub use saved::{SaveError, Saved, scene_text};
pub use viewer::{OpenError, Sent, Viewer};
