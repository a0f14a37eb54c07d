//! Fields: each says what is solid in the space over the base surface.
//!
//! A new field is a `.wesl` and a `.rs` file here and its name in the list below.

use crate::entry::Entry;

mod heights;
mod motif;
mod volume;

/// All fields, in the order of their numbers in the shaders. The first is the default.
pub static ENTRIES: &[Entry] = &[heights::ENTRY, volume::ENTRY, motif::ENTRY];

/// What is solid over a surface: what a field shows, or what a search or a refinement finds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solids {
    /// What lies below a surface of heights.
    #[default]
    Heights,
    /// What a volume holds, in any shape.
    Volumes,
    /// The triangles of a motif.
    Motifs,
    /// Heights and volumes, for a search that asks for the gap at points alone.
    Points,
    /// All, for a variant that does nothing.
    All,
}

impl Solids {
    /// Whether what a field shows is among them.
    pub fn has(self, shown: Solids) -> bool {
        match self {
            Solids::All => true,
            Solids::Points => matches!(shown, Solids::Heights | Solids::Volumes | Solids::Points),
            one => one == shown,
        }
    }

    /// Whether a single field shows them.
    pub const fn is_one(self) -> bool {
        matches!(self, Solids::Heights | Solids::Volumes | Solids::Motifs)
    }

    /// Returns what a surface with them is called in messages.
    pub const fn in_words(self) -> &'static str {
        match self {
            Solids::Heights => "heights",
            Solids::Volumes => "a volume",
            Solids::Motifs => "a motif",
            Solids::Points => "heights or a volume",
            Solids::All => "anything",
        }
    }
}
