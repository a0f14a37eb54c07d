//! Directory of keys that describes a GeoTIFF's coordinate system (OGC 19-008r4, GeoTIFF 1.1).

use tiff_reader::Ifd;

use crate::elevation::{CoordinateSystem, UnitOrigin};
use crate::georeference::{Crs, USER_DEFINED, Unit, Vertical, WEB_MERCATOR, epsg};

const TAG_KEYS: u16 = 34735;
const TAG_KEY_DOUBLES: u16 = 34736;

const KEY_MODEL_TYPE: u16 = 1024;
pub(super) const KEY_RASTER_TYPE: u16 = 1025;
const KEY_GEOGRAPHIC_TYPE: u16 = 2048;
const KEY_ANGULAR_UNIT: u16 = 2054;
const KEY_ANGULAR_UNIT_SIZE: u16 = 2055;
const KEY_PROJECTED_TYPE: u16 = 3072;
const KEY_LINEAR_UNIT: u16 = 3076;
const KEY_LINEAR_UNIT_SIZE: u16 = 3077;
const KEY_VERTICAL_TYPE: u16 = 4096;
const KEY_VERTICAL_UNIT: u16 = 4099;

const MODEL_PROJECTED: u16 = 1;
const MODEL_GEOGRAPHIC: u16 = 2;

/// EPSG code of the degree.
const DEGREE: u16 = 9122;

/// Codes of vertical systems of GeoTIFF 1.0, which name an ellipsoid or a datum and no unit.
const WITHOUT_UNIT: [std::ops::RangeInclusive<u16>; 2] = [5001..=5033, 5101..=5106];

/// Keys of a file.
pub(super) struct Keys {
    /// For each key: its number, the location of its value, its number of values, and the value or
    /// its index.
    entries: Vec<[u16; 4]>,
    doubles: Vec<f64>,
}

impl Keys {
    /// Reads the keys; none if the file has no directory, or an empty one. An error if the
    /// directory is shorter than it says.
    pub(super) fn read(ifd: &Ifd) -> Result<Option<Self>, String> {
        let Some(tag) = ifd.tag(TAG_KEYS) else { return Ok(None) };
        let shorts = tag.value.as_u16_slice().ok_or("its directory of keys is not of shorts")?;
        let (entries, _) = shorts.as_chunks::<4>();
        let Some(([.., count], entries)) = entries.split_first() else {
            return Err("its directory of keys has no beginning".into());
        };
        let count = usize::from(*count);
        let entries = entries
            .get(..count)
            .ok_or_else(|| format!("its directory of keys says {count} keys, but holds {}", entries.len()))?;
        let doubles = ifd.tag(TAG_KEY_DOUBLES).and_then(|tag| tag.value.as_f64_vec()).unwrap_or_default();
        Ok((count > 0).then(|| Self { entries: entries.to_vec(), doubles }))
    }

    fn entry(&self, key: u16) -> Option<[u16; 4]> {
        self.entries.iter().find(|entry| entry[0] == key).copied()
    }

    /// Returns the value of a 16-bit key.
    pub(super) fn short(&self, key: u16) -> Option<u16> {
        // Location 0 means that the value is in the entry itself.
        self.entry(key).filter(|entry| entry[1] == 0).map(|[.., value]| value)
    }

    /// Returns the value of a key for the size of a unit.
    fn unit_size(&self, key: u16) -> Result<Option<f64>, String> {
        let Some([_, TAG_KEY_DOUBLES, _, index]) = self.entry(key) else { return Ok(None) };
        let size = self.doubles.get(usize::from(index)).copied();
        let size = size.ok_or_else(|| format!("the number of its key {key} is missing"))?;
        if size.is_finite() && size > 0.0 {
            Ok(Some(size))
        } else {
            Err(format!("the unit of its key {key} has the size {size:?}"))
        }
    }

    /// Returns the value of a 16-bit key, unless it is 0.
    fn code(&self, key: u16) -> Option<u16> {
        self.short(key).filter(|&number| number != 0)
    }

    /// Returns the unit of a key, if it names one: by its code, or by a size in another key.
    fn unit(
        &self,
        key: u16,
        size_key: u16,
        by_code: fn(u16, UnitOrigin) -> Unit,
    ) -> Result<Option<Unit>, String> {
        let origin = UnitOrigin::Key(key);
        Ok(match self.code(key) {
            None => None,
            Some(USER_DEFINED) => {
                let name = format!("EPSG:{USER_DEFINED}");
                Some(match self.unit_size(size_key)? {
                    Some(size) => {
                        let name = "user-defined".to_owned();
                        Unit::Known { name, size, origin: UnitOrigin::Key(size_key) }
                    }
                    None => Unit::Unknown { name, origin },
                })
            }
            Some(number) => Some(by_code(number, origin)),
        })
    }

    /// Returns the coordinate system. A key for the unit takes precedence over the unit of the
    /// system's code.
    pub(super) fn system(&self) -> Result<Crs, String> {
        let (projected, geographic) = (self.code(KEY_PROJECTED_TYPE), self.code(KEY_GEOGRAPHIC_TYPE));
        let implied = || match (projected, geographic) {
            (Some(_), _) => Some(MODEL_PROJECTED),
            (None, Some(_)) => Some(MODEL_GEOGRAPHIC),
            (None, None) => None,
        };
        let (system, number) = match self.code(KEY_MODEL_TYPE).or_else(implied) {
            Some(MODEL_PROJECTED) if projected.is_some_and(|number| WEB_MERCATOR.contains(&number)) => {
                (CoordinateSystem::WebMercator, projected)
            }
            Some(MODEL_PROJECTED) => (CoordinateSystem::Projected, projected),
            Some(MODEL_GEOGRAPHIC) => (CoordinateSystem::Geographic, geographic),
            _ => (CoordinateSystem::Unknown, None),
        };
        let epsg = number.filter(|&number| number != USER_DEFINED);
        let of_number = || epsg.map(|number| Unit::of_system(system, number));
        let unit = match system {
            CoordinateSystem::Geographic => {
                let named = self.unit(KEY_ANGULAR_UNIT, KEY_ANGULAR_UNIT_SIZE, Unit::angle)?;
                let degrees = || Unit::angle(DEGREE, UnitOrigin::Assumed);
                named.or_else(of_number).unwrap_or_else(degrees)
            }
            CoordinateSystem::Projected | CoordinateSystem::WebMercator => {
                let named = self.unit(KEY_LINEAR_UNIT, KEY_LINEAR_UNIT_SIZE, Unit::length)?;
                named.or_else(of_number).unwrap_or_default()
            }
            CoordinateSystem::Unknown => Unit::Unnamed,
        };
        Ok(Crs { system, epsg, unit, vertical: self.vertical(geographic)? })
    }

    /// Whether the keys name a vertical system, or its unit.
    pub(super) fn has_heights(&self) -> bool {
        self.code(KEY_VERTICAL_TYPE).or_else(|| self.code(KEY_VERTICAL_UNIT)).is_some()
    }

    /// Returns the vertical axis, if the keys name one.
    fn vertical(&self, geographic: Option<u16>) -> Result<Option<Vertical>, String> {
        let is_system = |number: &u16| {
            *number != USER_DEFINED && !WITHOUT_UNIT.iter().any(|numbers| numbers.contains(number))
        };
        let above_ellipsoid = || geographic.filter(|&number| epsg::vertical(number).is_some());
        let number = self.code(KEY_VERTICAL_TYPE).filter(is_system);
        let of_number = number.or_else(above_ellipsoid).map(Vertical::of_system);
        Ok(match self.unit(KEY_VERTICAL_UNIT, USER_DEFINED, Unit::length)? {
            Some(unit) => {
                Some(Vertical { unit, downward: of_number.is_some_and(|vertical| vertical.downward) })
            }
            None => of_number,
        })
    }
}
