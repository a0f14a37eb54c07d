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
}

/// Where the texels of a map lie in the coordinates of its file. The map is the one that is read: its rows are
/// those of the file turned over where [`Georeference::turned_over`] says so.
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

/// What the values of an elevation model's channel stand for: `(value * scale + offset) * metres_per_unit`
/// metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Elevation {
    /// The unit as the file names it; none where it names none, which is taken for metres.
    pub unit: Option<String>,
    /// Metres in one unit; none where the unit is no length that is known here.
    pub metres_per_unit: Option<f64>,
    /// The factor on a raw value; 1 where the file names none.
    pub scale: f64,
    /// The units of raw value 0; 0 where the file names none.
    pub offset: f64,
}

impl Elevation {
    /// The metres that raw values stand for, where the unit is known.
    pub fn metres<const N: usize>(&self, raw: [f64; N]) -> Option<[f64; N]> {
        let metres_per_unit = self.metres_per_unit?;
        Some(raw.map(|raw| (raw * self.scale + self.offset) * metres_per_unit))
    }
}
