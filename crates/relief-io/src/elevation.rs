//! Georeference of a file: the place of its texels on the ground, and the meaning of its values as
//! elevations.

/// Position of a map on the ground, as its file states it.
#[derive(Clone, Debug, PartialEq)]
pub struct Georeference {
    /// Kind of the coordinate system.
    pub system: CoordinateSystem,
    /// EPSG code of the coordinate system, if the file gives one.
    pub epsg: Option<u16>,
    /// Size of a texel along `u` and `v` in metres, at the middle of the map; or the reason why it
    /// is unknown.
    pub texel_size_m: Result<[f64; 2], String>,
    /// Whether the file's columns, and whether its rows, run opposite to the map's. They are
    /// flipped when the file is read, so that column 0 is in the west and row 0 in the north. In a
    /// rotated grid the rows are flipped if it would be mirrored otherwise.
    pub turned_over: [bool; 2],
    /// Transform from texels to the file's coordinates; none if the file does not give it.
    pub transform: Option<GridTransform>,
    /// Metres per unit of the file's coordinates, along x and y, at the middle of the map; none if
    /// unknown.
    pub metres_per_unit: Option<[f64; 2]>,
    /// Lengths of the shortest and the longest row, relative to the middle one. Both are 1, except
    /// in coordinates whose metres depend on the latitude.
    pub row_lengths: [f64; 2],
    /// Unit of the coordinates, as the file names it; none if it names none.
    pub unit: Option<String>,
    /// Source of `unit`.
    pub unit_origin: UnitOrigin,
    /// Name of the sidecar file that gives the grid's position; none if the map's own file gives
    /// it.
    pub grid_file: Option<String>,
}

/// Affine transform from a map's texels to the coordinates of its file. It belongs to the map as
/// read: flipped where [`Georeference::turned_over`] says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridTransform {
    /// Outer corner of the first texel, x and y.
    pub origin: [f64; 2],
    /// Step from one column to the next, along x and y.
    pub column: [f64; 2],
    /// Step from one row to the next, along x and y.
    pub row: [f64; 2],
}

impl GridTransform {
    /// Returns the coordinates of a point of the map, given in texels from the outer corner of the
    /// first one.
    pub fn at(&self, [columns, rows]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + columns * self.column[axis] + rows * self.row[axis])
    }

    /// Returns the six numbers `a b c d e f` of `x = a column + b row + c` and `y = d column + e
    /// row + f`. `x` and `y` are in the file's coordinate system. Columns and rows count from the
    /// outer corner of the first texel, so its centre is at one half.
    pub fn affine(&self) -> [f64; 6] {
        let Self { origin: [c, f], column: [a, d], row: [b, e] } = *self;
        [a, b, c, d, e, f]
    }
}

/// Kind of coordinate system, by how its units convert to metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CoordinateSystem {
    /// Angles on the ellipsoid.
    Geographic,
    /// Lengths in a map projection, taken as lengths on the ground.
    Projected,
    /// The projection of web maps (EPSG:3857), whose lengths are too long by 1 over the cosine of the
    /// latitude.
    WebMercator,
    /// Another kind, or one that the file does not name.
    Unknown,
}

impl CoordinateSystem {
    /// Name shown to users.
    pub const fn name(self) -> &'static str {
        match self {
            CoordinateSystem::Geographic => "geographic",
            CoordinateSystem::Projected => "projected",
            CoordinateSystem::WebMercator => "web mercator",
            CoordinateSystem::Unknown => "unknown",
        }
    }
}

/// Source of a unit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum UnitOrigin {
    /// A key of a GeoTIFF.
    Key(u16),
    /// The EPSG code of the coordinate system.
    Epsg(u16),
    /// The metadata that GDAL keeps in a TIFF.
    Metadata,
    /// A sidecar file, by its name.
    Beside(String),
    /// The user, by [`HeightOptions::unit`](crate::HeightOptions::unit).
    Given,
    /// The ground's unit taken for the heights, or the heights' unit for the ground, because the
    /// file names only one.
    Shared,
    /// No source: metres are assumed for heights over degrees, and degrees as is usual.
    Assumed,
    /// No source, and the unit is unknown.
    #[default]
    Unnamed,
}

impl std::fmt::Display for UnitOrigin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            UnitOrigin::Key(key) => write!(f, "key {key}"),
            UnitOrigin::Epsg(code) => write!(f, "EPSG:{code}"),
            UnitOrigin::Metadata => f.write_str("GDAL's metadata"),
            UnitOrigin::Beside(file) => f.write_str(file),
            UnitOrigin::Given => f.write_str("given"),
            UnitOrigin::Shared => f.write_str("shared by ground and heights"),
            UnitOrigin::Assumed => f.write_str("assumed, as no unit is named"),
            UnitOrigin::Unnamed => f.write_str("not named"),
        }
    }
}

/// Meaning of an elevation model's values: a raw value stands for `(value * scale + offset) *
/// metres_per_unit` metres, above or below the zero of its vertical system.
#[derive(Clone, Debug, PartialEq)]
pub struct Elevation {
    /// Name of the unit; none if no source names one.
    pub unit: Option<String>,
    /// Metres per unit; none if unknown.
    pub metres_per_unit: Option<f64>,
    /// Factor on a raw value; 1 if the file names none.
    pub scale: f64,
    /// Units at raw value 0; 0 if the file names none.
    pub offset: f64,
    /// Whether the vertical system counts downward, so that values are depths.
    pub downward: bool,
    /// Source of the unit.
    pub origin: UnitOrigin,
}

impl Elevation {
    /// Converts raw values to metres, negative for depths. None if the unit is unknown.
    pub fn metres<const N: usize>(&self, raw: [f64; N]) -> Option<[f64; N]> {
        let metres_per_unit = self.metres_per_unit?;
        Some(self.units(raw).map(|units| units * metres_per_unit))
    }

    /// Converts raw values to units of the file, negative for depths.
    pub(crate) fn units<const N: usize>(&self, raw: [f64; N]) -> [f64; N] {
        let sign = if self.downward { -1.0 } else { 1.0 };
        raw.map(|raw| sign * (raw * self.scale + self.offset))
    }

    /// Whether the file, a sidecar or the user names the unit of the heights, and it is known.
    pub fn is_named(&self) -> bool {
        let is_guess = matches!(self.origin, UnitOrigin::Shared | UnitOrigin::Assumed | UnitOrigin::Unnamed);
        !is_guess && self.metres_per_unit.is_some()
    }

    /// Returns a reason to doubt that the values are metres of ground, if there is one. `range`
    /// holds the least and the greatest raw value; `ground_m` is the longer side of the whole map
    /// in metres. Units that the user gives are not doubted. If the file itself names the unit,
    /// only heights outside all ground on Earth are doubted.
    pub fn doubt(&self, range: [f64; 2], ground_m: Option<f64>) -> Option<Doubt> {
        if self.origin == UnitOrigin::Given {
            return None;
        }
        let metres = self.metres(range)?;
        let range_m = [metres[0].min(metres[1]), metres[0].max(metres[1])];
        if range_m[0] < GROUND_M[0] || range_m[1] > GROUND_M[1] {
            return Some(Doubt::Heights { range_m });
        }
        let (ground_m, relief_m) = (ground_m.filter(|_| !self.is_named())?, range_m[1] - range_m[0]);
        let deepest = if ground_m < SHORT_GROUND_M { DEEPEST_OF_SHORT } else { DEEPEST };
        (relief_m > deepest * ground_m).then_some(Doubt::Relief { relief_m, ground_m })
    }
}

/// Deepest and highest ground of the Earth in metres, with a margin.
const GROUND_M: [f64; 2] = [-11_100.0, 9_000.0];

/// Deepest plausible relief, relative to the longer side of a map. A map shorter than a kilometre
/// may be deeper, since a single cliff may fill it.
const DEEPEST: f64 = 1.0 / 3.0;
const DEEPEST_OF_SHORT: f64 = 0.75;
const SHORT_GROUND_M: f64 = 1000.0;

/// Reason to doubt that values are metres of ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doubt {
    /// The heights lie outside all ground on Earth.
    Heights {
        /// Least and greatest height in metres.
        range_m: [f64; 2],
    },
    /// The relief is too deep for its horizontal size.
    Relief {
        /// Difference of the greatest and the least height in metres.
        relief_m: f64,
        /// Longer side of the map in metres.
        ground_m: f64,
    },
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Doubt::Heights { range_m: [least, greatest] } => {
                let [deepest, highest] = GROUND_M;
                write!(
                    f,
                    "its heights would go from {least} m to {greatest} m, but ground lies from {deepest} m \
                     to {highest} m"
                )
            }
            Doubt::Relief { relief_m, ground_m } => write!(
                f,
                "its heights would differ by {relief_m} m on {ground_m} m of ground, which is too steep"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_beyond_the_earths_are_reported() {
        let model = |metres: f64, origin: UnitOrigin| Elevation {
            unit: Some("m".to_owned()),
            metres_per_unit: Some(metres),
            scale: 1.0,
            offset: 0.0,
            downward: false,
            origin,
        };
        let (shared, named) = (UnitOrigin::Shared, UnitOrigin::Key(4099));
        for (metres, origin, range, ground, is_doubted) in [
            (1.0, &shared, [236.0, 1076.0], Some(30_000.0), false),
            (1.0, &shared, [-11_034.0, 8_849.0], Some(4e7), false),
            (1.0, &shared, [29_332.0, 31_000.0], Some(1722.0), true),
            (1.0, &shared, [29_332.0, 31_000.0], None, true),
            (0.01, &shared, [29_332.0, 31_000.0], Some(1722.0), false),
            (0.3048, &shared, [0.0, 29_032.0], Some(1e6), false),
            (1.0, &shared, [-32_768.0, 100.0], Some(1e6), true),
            (1.0, &shared, [0.0, 1000.0], Some(2000.0), true),
            (1.0, &shared, [0.0, 300.0], Some(400.0), false),
            (1.0, &shared, [0.0, 301.0], Some(400.0), true),
            (1.0, &shared, [0.0, 5000.0], None, false),
            (1.0, &named, [0.0, 390.0], Some(400.0), false),
            (1.0, &named, [0.0, 9_001.0], Some(1e6), true),
            (1.0, &UnitOrigin::Given, [0.0, 21_229.0], Some(1e6), false),
        ] {
            let found = model(metres, origin.clone()).doubt(range, ground);
            assert_eq!(found.is_some(), is_doubted, "{metres} {origin} {range:?} {ground:?}: {found:?}");
        }
        let depth = Elevation { downward: true, ..model(1.0, UnitOrigin::Shared) };
        assert_eq!(depth.metres([10.0, 30.0]), Some([-10.0, -30.0]));
        assert!(depth.doubt([0.0, 12_000.0], None).is_some() && depth.doubt([0.0, 11_000.0], None).is_none());
    }
}
