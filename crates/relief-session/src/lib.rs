//! A scene as one document that actions change. For viewers, editors and scripts: it draws nothing, and reads
//! no file.
//!
//! * [`Session`] holds the document, a scene file. [`Session::apply`] says which keys changed, or refuses
//!   with the reason and changes nothing.
//! * [`Action`] is one change: a key gets a value or loses it, as text, as in the file; surfaces come and go;
//!   the camera and the sun turn; undo, redo, back to the start.
//! * [`Session::panel`] describes a control for every key and every setting of the chosen variants.
//!
//! ```
//! use relief_session::{Action, Session};
//!
//! let mut session = Session::new("height = \"wall.png\"\n")?;
//! let changed = session.apply(&Action::set("method", "\"cone\""))?;
//! assert_eq!(changed.keys, ["method"]);
//!
//! // A value that does not fit changes nothing.
//! let refused = session.apply(&Action::set("samples", "5000")).unwrap_err();
//! assert!(refused.to_string().contains("1024"));
//!
//! session.apply(&Action::Undo)?;
//! assert!(!session.text().contains("method = \"cone\""));
//! # Ok::<(), relief_session::Refused>(())
//! ```

mod action;
mod camera;
#[cfg(test)]
mod camera_tests;
mod document;
mod link;
mod panel;
mod session;
#[cfg(test)]
mod tests;

pub use action::{Action, Changed, Refused};
pub use camera::{Extent, Seen};
pub use link::{Link, LinkError, LinkedFile};
pub use panel::{Choice, Control, Kind, Panel, label_of};
pub use session::{Drag, Session, Taken};
