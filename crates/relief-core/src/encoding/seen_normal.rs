//! Layout of maps of mean normals, as seen from fixed directions.

/// Default number of azimuths of the directions.
pub const AZIMUTHS: u32 = 8;

/// Default number of elevations per azimuth. Elevation `e` has the sine `(e + 1) / ELEVATIONS`.
pub const ELEVATIONS: u32 = 4;

/// Mip [level](crate::HeightMap::level) of the height map whose size the finest level of the means
/// has.
pub const FIRST_LEVEL: u32 = 2;
