//! Fields: each says what is solid in the space over the base surface.
//!
//! A new field is a `.wesl` and a `.rs` file here and its name in the list below.

use crate::entry::Entry;

mod heights;
mod volume;

/// All fields, in the order of their numbers in the shaders. The first is the default.
pub static ENTRIES: &[Entry] = &[heights::ENTRY, volume::ENTRY];

/// The solids that a search or a refinement finds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solids {
    /// What lies below a surface of heights.
    #[default]
    Heights,
    /// What a volume holds, in any shape.
    Volumes,
    /// Both: it asks for the gap at points alone.
    Both,
}

impl Solids {
    /// Whether volumes are among them.
    pub const fn has_volumes(self) -> bool {
        !matches!(self, Solids::Heights)
    }

    /// Whether heights are among them.
    pub const fn has_heights(self) -> bool {
        !matches!(self, Solids::Volumes)
    }
}
