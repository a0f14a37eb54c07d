//! What a georeferenced file says of the ground, and what its values stand for.

/// Where a file says that its map lies on the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Georeference {
    /// The kind of its coordinate system.
    pub system: CoordinateSystem,
    /// The coordinate system's number in the EPSG's list, where the file gives it.
    pub epsg: Option<u16>,
    /// Size of a texel along `u` and `v` in metres, at the middle of the map; or why it is not known.
    pub texel_size_m: Result<[f64; 2], String>,
    /// Whether the file's columns, and whether its rows, lie in the other order than the map's: they are
    /// turned over in reading, so that column 0 is in the west and row 0 in the north. Of a grid that is
    /// turned by some angle the rows are turned over where it would be mirrored else.
    pub turned_over: [bool; 2],
    /// Where the texels lie in the file's coordinates; none where the file does not say it.
    pub transform: Option<GridTransform>,
    /// Metres in one unit of the file's coordinates, along x and y, at the middle of the map; none where they
    /// are not known.
    pub metres_per_unit: Option<[f64; 2]>,
    /// The shortest and the longest row, as parts of the middle one: 1 and 1 but for coordinates whose metres
    /// depend on the latitude.
    pub row_lengths: [f64; 2],
    /// The unit of its coordinates, as the file names it; none where it names none.
    pub unit: Option<String>,
    /// Who says that unit.
    pub unit_origin: UnitOrigin,
    /// The file beside the map that says where the grid lies; none where the map's own does.
    pub grid_file: Option<String>,
}

/// Where the texels of a map lie in the coordinates of its file. The map is the one that is read: its rows
/// are those of the file turned over where [`Georeference::turned_over`] says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridTransform {
    /// The outer corner of the first texel, x and y.
    pub origin: [f64; 2],
    /// The way from a column to the next one, along x and y.
    pub column: [f64; 2],
    /// The way from a row to the next one, along x and y.
    pub row: [f64; 2],
}

impl GridTransform {
    /// The coordinates of a point of the map, in texels from the outer corner of the first one.
    pub fn at(&self, [columns, rows]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + columns * self.column[axis] + rows * self.row[axis])
    }

    /// The six numbers `a b c d e f` of `x = a column + b row + c` and `y = d column + e row + f`.
    pub fn affine(&self) -> [f64; 6] {
        let Self { origin: [c, f], column: [a, d], row: [b, e] } = *self;
        [a, b, c, d, e, f]
    }
}

/// A kind of coordinate system, by how its units become metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CoordinateSystem {
    /// Angles on the ellipsoid.
    Geographic,
    /// Lengths in a map projection, taken for those on the ground.
    Projected,
    /// The projection of web maps (EPSG:3857), whose lengths are too long by 1 over the cosine of the
    /// latitude.
    WebMercator,
    /// Another one, or one that the file does not name.
    Unknown,
}

impl CoordinateSystem {
    /// The name that users are shown.
    pub const fn name(self) -> &'static str {
        match self {
            CoordinateSystem::Geographic => "geographic",
            CoordinateSystem::Projected => "projected",
            CoordinateSystem::WebMercator => "web mercator",
            CoordinateSystem::Unknown => "unknown",
        }
    }
}

/// Who says what a unit is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum UnitOrigin {
    /// A key of a GeoTIFF.
    Key(u16),
    /// The number of the coordinate system in the EPSG's list.
    Epsg(u16),
    /// The metadata that GDAL keeps in a TIFF.
    Metadata,
    /// A file beside the map, by its name.
    Beside(String),
    /// The user, by [`HeightOptions::unit`](crate::HeightOptions::unit).
    Given,
    /// The ground for the heights, or the heights for the ground: of these nothing is said.
    Shared,
    /// Nobody: metres for heights over degrees, or degrees, as is usual.
    Assumed,
    /// Nobody, and it is not known.
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

/// What the values of an elevation model's channel stand for: `(value * scale + offset) * metres_per_unit`
/// metres, above or below the zero of its system.
#[derive(Clone, Debug, PartialEq)]
pub struct Elevation {
    /// The unit by its name; none where nobody names one.
    pub unit: Option<String>,
    /// Metres in one unit; none where it is not known.
    pub metres_per_unit: Option<f64>,
    /// The factor on a raw value; 1 where the file names none.
    pub scale: f64,
    /// The units of raw value 0; 0 where the file names none.
    pub offset: f64,
    /// Whether its vertical system counts downward, so that its values are depths.
    pub downward: bool,
    /// Who says the unit.
    pub origin: UnitOrigin,
}

impl Elevation {
    /// The metres that raw values stand for, where the unit is known. Those of depths are negative.
    pub fn metres<const N: usize>(&self, raw: [f64; N]) -> Option<[f64; N]> {
        let metres_per_unit = self.metres_per_unit?;
        Some(self.units(raw).map(|units| units * metres_per_unit))
    }

    /// The same in units, whatever they are.
    pub(crate) fn units<const N: usize>(&self, raw: [f64; N]) -> [f64; N] {
        let sign = if self.downward { -1.0 } else { 1.0 };
        raw.map(|raw| sign * (raw * self.scale + self.offset))
    }

    /// Whether the file, one beside it or the user names the unit of the heights, and it is known.
    pub fn is_named(&self) -> bool {
        let is_guess = matches!(self.origin, UnitOrigin::Shared | UnitOrigin::Assumed | UnitOrigin::Unnamed);
        !is_guess && self.metres_per_unit.is_some()
    }

    /// Why the least and the greatest of its values are no metres of ground, if they are none. `ground_m` is
    /// the longer side of the whole map. Units that the user gives are not doubted, and of those that the
    /// file itself names only heights that no ground has.
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

/// The deepest and the highest ground of the Earth in metres, with something to spare.
const GROUND_M: [f64; 2] = [-11_100.0, 9_000.0];

/// The deepest relief as a part of the longer side of a map. A map shorter than a kilometre may be deeper,
/// since a single cliff may fill it.
const DEEPEST: f64 = 1.0 / 3.0;
const DEEPEST_OF_SHORT: f64 = 0.75;
const SHORT_GROUND_M: f64 = 1000.0;

/// Why heights are no metres of ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doubt {
    /// They lie where no ground is.
    Heights {
        /// The least and the greatest.
        range_m: [f64; 2],
    },
    /// The relief is deeper to its length than ground is.
    Relief {
        /// From the least to the greatest height.
        relief_m: f64,
        /// The longer side of the map.
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
                    "its heights would go from {least} m to {greatest} m, and ground lies from {deepest} m to \
                     {highest} m"
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
    fn heights_that_no_ground_has_are_doubted() {
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
