//! Heights with the metadata of their file.

use relief_core::Wrap;
use relief_io::HeightNote;

use super::output::{Content, Output};
use crate::failure::Failure;

/// Paper and section of the ways from normals, photographs and meshes to heights.
pub const SURVEYED: &str = "Szirmay-Kalos and Umenhoffer 2008 2.2";

/// Heights on the way to a file, with their metadata.
pub struct AnnotatedHeights {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Heights, row by row.
    pub texels: Vec<f32>,
    pub wrap: Wrap,
    pub note: HeightNote,
    /// Source and settings, by names.
    pub origin: Vec<(&'static str, String)>,
    /// Publication of the method, if there is one.
    pub published: Option<&'static str>,
    /// Guarantee that fits in a line, if there is one.
    pub guarantee: Option<&'static str>,
    /// Further entries that only some heights have.
    pub more: Vec<(&'static str, String)>,
}

impl AnnotatedHeights {
    /// Returns the content of a file of the output's format.
    pub fn content(self, output: &Output) -> Result<Content, Failure> {
        let Self { size, texels, wrap, note, origin, published, guarantee, more } = self;
        let [width, height] = size;
        let said = [
            ("convention", "height 1 is highest; row 0 is on top, v grows downward"),
            ("units", "lengths in metres; heights in fractions of the scale, above the bias"),
        ];
        let stored = [
            ("generator", concat!("relief ", env!("CARGO_PKG_VERSION")).to_owned()),
            ("channels", "height".to_owned()),
            ("ranges", "0,1".to_owned()),
            ("rounding", "nearest".to_owned()),
            ("stored_as", output.stored_as().to_owned()),
            ("size", format!("{width} {height} 1")),
        ];
        let guarantee = guarantee.map(|guarantee| ("guarantee", guarantee));
        let published = published.map(|published| ("published", published));
        let said =
            said.into_iter().chain(guarantee).chain(published).map(|(name, value)| (name, value.to_owned()));
        let wrap = [("wrap", wrap.name().to_owned())];
        let entries = wrap.into_iter().chain(origin).chain(said).chain(stored).chain(more).collect();
        let metadata = note.metadata(entries).map_err(|problem| Failure::Work(problem.to_string()))?;
        Ok(Content { size, names: &["height"], planes: vec![texels], bits: 16, metadata })
    }
}
