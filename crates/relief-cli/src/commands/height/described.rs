//! Heights with what a file says of them.

use relief_core::Wrap;
use relief_io::HeightNote;

use super::output::{Content, Output};
use crate::failure::Failure;

/// The paper and section of what makes heights of normals, photographs and meshes.
pub const SURVEYED: &str = "Szirmay-Kalos and Umenhoffer 2008 2.2";

/// Heights on their way to a file, and what is said of them.
pub struct Described {
    /// Columns and rows.
    pub size: [u32; 2],
    /// The heights, row by row.
    pub texels: Vec<f32>,
    pub wrap: Wrap,
    pub note: HeightNote,
    /// What they were made of and how, by names.
    pub origin: Vec<(&'static str, String)>,
    /// Where the way was published, if it was.
    pub published: Option<&'static str>,
    /// What holds of them, if it can be said in a line.
    pub guarantee: Option<&'static str>,
    /// What only some heights have.
    pub more: Vec<(&'static str, String)>,
}

impl Described {
    /// What goes to a file of that format.
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
