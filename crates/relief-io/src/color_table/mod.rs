//! Tables of colours by elevation: built-in ones, and text files of GDAL, GRASS, QGIS and GMT.

mod builtin;
mod names;
mod problem;
mod ramp;
mod read;

pub use builtin::BuiltinRamp;
pub use problem::ColorTableProblem;
pub use ramp::ColorRamp;

use crate::text::decode_text;
use crate::{ReadError, ReadProblem, Source};

/// Most bytes of a file with a table.
const MOST_BYTES: u64 = 8 << 20;

/// Elevation of an entry of a [`ColorTable`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableElevation {
    /// Elevation in the map's unit, metres for elevation models with a known unit.
    Absolute(f64),
    /// Part of the map's range in percent, from 0 (its least elevation) to 100 (its greatest).
    Percent(f64),
}

/// Entry of a [`ColorTable`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorEntry {
    /// Elevation that has the colour.
    pub elevation: TableElevation,
    /// Red, green, blue and opacity, from 0 to 255. Colours are encoded by the sRGB curve.
    pub color: [u8; 4],
}

/// Table of colours by elevation, as `gdaldem color-relief` reads them.
///
/// ```
/// use relief_io::{BuiltinRamp, ColorTable, Source, read_color_table};
///
/// let text = "# metres, red, green, blue\n0 50 180 50\n1000 white\nnv 0 0 0 0\n";
/// let table = read_color_table(Source::bytes("hills.txt", text.as_bytes()))?;
/// assert_eq!(table.ramp([0.0, 1000.0]).color(500.0)[..3], [152.5, 217.5, 152.5]);
///
/// let terrain = ColorTable::from(BuiltinRamp::Terrain);
/// assert!(!terrain.has_absolute());
/// # Ok::<(), relief_io::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ColorTable {
    /// Entries in the file's order, at least one.
    entries: Vec<ColorEntry>,
    nodata: Option<[u8; 4]>,
    outside: Option<[u8; 4]>,
}

impl ColorTable {
    /// Creates a table of at least one entry. Entries may stand in any order.
    pub(crate) fn of(entries: Vec<ColorEntry>) -> Self {
        Self { entries, nodata: None, outside: None }
    }

    /// Returns the entries in the file's order, at least one.
    pub fn entries(&self) -> &[ColorEntry] {
        &self.entries
    }

    /// Returns the colour of texels without a value, the entry `nv`. `None` if the table has none.
    pub fn nodata(&self) -> Option<[u8; 4]> {
        self.nodata
    }

    /// Returns the colour of elevations below and above all entries, the entry `default` of GRASS.
    /// `None` if they have the colour of the nearest entry, as in GDAL.
    pub fn outside(&self) -> Option<[u8; 4]> {
        self.outside
    }

    /// Returns whether an entry has an elevation that is no percentage.
    pub fn has_absolute(&self) -> bool {
        self.absolute_range().is_some()
    }

    /// Returns the least and the greatest elevation that is no percentage.
    pub fn absolute_range(&self) -> Option<[f64; 2]> {
        let absolute = self.entries.iter().filter_map(|entry| match entry.elevation {
            TableElevation::Absolute(elevation) => Some([elevation; 2]),
            TableElevation::Percent(_) => None,
        });
        absolute.reduce(|[low, high], [at, _]| [low.min(at), high.max(at)])
    }

    /// Returns whether a colour is not opaque, except of texels without a value.
    pub fn has_opacity(&self) -> bool {
        self.entries.iter().map(|entry| entry.color).chain(self.outside).any(|[.., opacity]| opacity < 255)
    }

    /// Returns the colours for a map whose least and greatest elevation are `range`.
    pub fn ramp(&self, range: [f64; 2]) -> ColorRamp {
        ColorRamp::new(self, range)
    }
}

/// Reads a table of colours by elevation from a text file of GDAL, GRASS, QGIS or GMT.
///
/// Each line holds an elevation and its colour: `1200 190 185 135`, with an optional fourth number
/// for the opacity. Numbers of colours go from 0 to 255. A name such as `brown` may stand for
/// three of them. Fields are separated by spaces, tabs, commas or colons. Lines that begin with `#`
/// or `/` are comments.
///
/// * `50%` is a part of the map's range: 0% its least elevation, 100% its greatest.
/// * `nv` stands for texels without a value, `default` for elevations outside of all entries.
/// * After five fields of QGIS's export its label follows, which is not read.
/// * Palettes of GMT (`.cpt`) hold two elevations with their colours in each line. Their head says
///   `# COLOR_MODEL = RGB`.
///
/// Elevations rise or fall from line to line, and so do percentages. Equal ones make a step.
///
/// # Errors
///
/// When the file cannot be read, is longer than 8 MiB or no text; when a line has too few fields, an
/// elevation that is not finite or out of order, or a colour that is unknown or not from 0 to 255;
/// when there are no entries or more than 65,536.
pub fn read_color_table<'a>(source: impl Into<Source<'a>>) -> Result<ColorTable, ReadError> {
    let source = source.into();
    let read = || {
        let fits = |len: u64| match len > MOST_BYTES {
            true => Err(ColorTableProblem::TooLong { bytes: len, most: MOST_BYTES }.whole()),
            false => Ok(()),
        };
        let bytes = source.whole(fits)?;
        fits(bytes.len() as u64)?;
        let bytes = bytes.into_owned();
        let is_text =
            !bytes.contains(&0) || bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
        let text = Some(bytes).filter(|_| is_text).and_then(decode_text);
        let text = text.ok_or_else(|| ColorTableProblem::NoText.whole())?;
        read::table(&text)
    };
    read().map_err(|problem: ReadProblem| source.error(problem))
}
