//! What a viewer of reliefs does, without a window and without threads of its own.
//!
//! * [`Viewer`] answers messages: its state, actions, pictures, dropped files, and files to save.
//! * [`Drawing`] draws one scene after the other, in one view or two, and keeps what they share.
//! * [`Document`] is the session with the number of its changes, as messages.
//! * [`Given`] holds files that a user drops, and [`Coming`] says what they change in a scene.
//!
//! ```
//! use relief_core::Watch;
//! use relief_io::MemoryFiles;
//! use relief_render::block_on;
//! use relief_viewer::{Asked, Viewer};
//!
//! let mut files = MemoryFiles::new();
//! files.insert("wall.pgm", b"P5 2 2 255\n\x00\x40\x80\xff".as_slice())?;
//! files.insert("scene.toml", b"height = \"wall.pgm\"".as_slice())?;
//! let mut viewer = Viewer::open(files, "scene.toml".as_ref())?;
//! let picture = block_on(viewer.picture(Asked::whole([8, 6]), &Watch::none()))?;
//! assert_eq!(picture.into_pixels().len(), 8 * 6 * 4);
//! let saved = block_on(viewer.save("picture.png", 0, &Watch::none()))?;
//! assert!(saved.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod asked;
mod colors;
mod coming;
mod document;
mod drawing;
mod exact;
mod given;
mod kind;
mod labels;
mod linked;
mod not_drawn;
mod pane;
mod pixel;
mod saved;
mod scene_files;
#[cfg_attr(not(feature = "gpu"), path = "no_takeover.rs")]
mod takeover;
#[cfg(test)]
mod tests;
mod tried;
mod viewer;

pub use asked::Asked;
pub use coming::Coming;
pub use document::{Document, Sent};
pub use drawing::{Drawing, Drawn, Notes, shown};
pub use given::{Given, GivenError};
pub use labels::{said_of_scene, with_labels};
pub use not_drawn::NotDrawn;
pub use saved::{SaveError, Saved, of_view};
pub use takeover::Warming;
pub use viewer::{OpenError, Viewer};
