//! How means of the normals that are seen from fixed directions are stored.

/// The azimuths that are looked from where nothing else is asked for.
pub const AZIMUTHS: u32 = 8;

/// The elevations in each azimuth where nothing else is asked for. That of number `e` has the sine
/// `(e + 1) / ELEVATIONS`.
pub const ELEVATIONS: u32 = 4;

/// The [level](crate::HeightMap::level) of the map that the finest level of its means is as large as.
pub const FIRST_LEVEL: u32 = 2;
