//! What a GeoTIFF's tags say about nodata and the size of a texel (OGC 19-008r4, GeoTIFF 1.1; GDAL's nodata
//! tag).

use tiff_reader::Ifd;

use crate::layout::{SampleKind, SampleType};

const TAG_PIXEL_SCALE: u16 = 33550;
const TAG_TIEPOINTS: u16 = 33922;
const TAG_TRANSFORMATION: u16 = 34264;
const TAG_KEYS: u16 = 34735;
const TAG_KEY_DOUBLES: u16 = 34736;
const TAG_NODATA: u16 = 42113;

const KEY_MODEL_TYPE: u16 = 1024;
const KEY_ANGULAR_UNIT: u16 = 2054;
const KEY_LINEAR_UNIT: u16 = 3076;
const KEY_LINEAR_UNIT_SIZE: u16 = 3077;

const MODEL_PROJECTED: u16 = 1;
const MODEL_GEOGRAPHIC: u16 = 2;

/// WGS 84: the equator's radius in metres, and the square of the first eccentricity.
const EQUATOR_M: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_14;

/// The raw value that marks a texel without a value, as the file's samples hold it.
pub(super) fn nodata(ifd: &Ifd, sample: SampleType) -> Option<f64> {
    let value: f64 = ifd.tag(TAG_NODATA)?.value.as_str()?.trim_matches(['\0', ' ']).parse().ok()?;
    // GDAL writes the number in decimals, which need not be those of the nearest f32.
    let stored = if sample == SampleType::float(32) { f64::from(value as f32) } else { value };
    (stored.is_finite() || sample.kind == SampleKind::Float).then_some(stored).filter(|value| !value.is_nan())
}

/// The size of a texel in metres along `u` and `v`.
///
/// In a projected system the unit is the file's; a projected file that does not name one is taken to be in
/// metres. In a geographic system (degrees) the size is that at the picture's centre: along a parallel and a
/// meridian of the WGS 84 ellipsoid. It is unknown where the file names no system, a unit that is not known
/// here, or a centre beyond the poles.
pub(super) fn texel_size_m(ifd: &Ifd) -> Option<[f64; 2]> {
    let keys = Keys::read(ifd)?;
    let grid = Grid::read(ifd)?;
    let [across, down] = match keys.short(KEY_MODEL_TYPE)? {
        MODEL_PROJECTED => grid.size.map(|side| side * keys.metres_per_unit().unwrap_or(f64::NAN)),
        MODEL_GEOGRAPHIC => {
            let radians_per_unit = match keys.short(KEY_ANGULAR_UNIT) {
                None | Some(9102) => std::f64::consts::PI / 180.0,
                Some(9101) => 1.0,
                Some(_) => return None,
            };
            let latitude = grid.centre_y * radians_per_unit;
            if latitude.abs() > std::f64::consts::FRAC_PI_2 {
                return None;
            }
            // Radii of curvature along the parallel (times its cosine) and along the meridian.
            let w = 1.0 - ECCENTRICITY_SQUARED * latitude.sin().powi(2);
            let parallel = EQUATOR_M / w.sqrt() * latitude.cos();
            let meridian = EQUATOR_M * (1.0 - ECCENTRICITY_SQUARED) / (w * w.sqrt());
            [grid.size[0] * radians_per_unit * parallel, grid.size[1] * radians_per_unit * meridian]
        }
        _ => return None,
    };
    [across, down].iter().all(|side| side.is_finite() && *side > 0.0).then_some([across, down])
}

/// Size of a texel, and the `y` of the picture's centre, in the units of the file's system.
struct Grid {
    size: [f64; 2],
    centre_y: f64,
}

impl Grid {
    fn read(ifd: &Ifd) -> Option<Self> {
        let doubles = |tag| ifd.tag(tag)?.value.as_f64_vec();
        let middle = [f64::from(ifd.width()) / 2.0, f64::from(ifd.height()) / 2.0];
        if let (Some(scale), Some(tie)) = (doubles(TAG_PIXEL_SCALE), doubles(TAG_TIEPOINTS)) {
            let (&[x, y, ..], &[_, row, _, _, tie_y, ..]) = (scale.as_slice(), tie.as_slice()) else {
                return None;
            };
            return Some(Self { size: [x.abs(), y.abs()], centre_y: tie_y - (middle[1] - row) * y });
        }
        let matrix = doubles(TAG_TRANSFORMATION)?;
        let &[xx, xy, _, _, yx, yy, _, y0, ..] = matrix.as_slice() else {
            return None;
        };
        let centre_y = yx * middle[0] + yy * middle[1] + y0;
        Some(Self { size: [xx.hypot(yx), xy.hypot(yy)], centre_y })
    }
}

/// The directory of keys that describes the file's coordinate system.
struct Keys {
    entries: Vec<u16>,
    doubles: Vec<f64>,
}

impl Keys {
    fn read(ifd: &Ifd) -> Option<Self> {
        let entries = ifd.tag(TAG_KEYS)?.value.as_u16_slice()?.to_vec();
        let doubles = ifd.tag(TAG_KEY_DOUBLES).and_then(|tag| tag.value.as_f64_vec()).unwrap_or_default();
        Some(Self { entries, doubles })
    }

    /// Location and value of a key: location 0 means that the value is the number itself.
    fn entry(&self, key: u16) -> Option<(u16, u16)> {
        let (entries, _) = self.entries.as_chunks::<4>();
        entries.iter().skip(1).find(|entry| entry[0] == key).map(|entry| (entry[1], entry[3]))
    }

    fn short(&self, key: u16) -> Option<u16> {
        self.entry(key).filter(|(location, _)| *location == 0).map(|(_, value)| value)
    }

    fn double(&self, key: u16) -> Option<f64> {
        let (location, index) = self.entry(key)?;
        if location == TAG_KEY_DOUBLES { self.doubles.get(usize::from(index)).copied() } else { None }
    }

    /// Metres in one unit of a projected system (EPSG unit numbers).
    fn metres_per_unit(&self) -> Option<f64> {
        match self.short(KEY_LINEAR_UNIT) {
            None | Some(9001) => Some(1.0),
            Some(9002) => Some(0.3048),
            Some(9003) => Some(1200.0 / 3937.0),
            Some(9036) => Some(1000.0),
            Some(32767) => self.double(KEY_LINEAR_UNIT_SIZE),
            Some(_) => None,
        }
    }
}
