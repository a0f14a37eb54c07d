//! The directory of keys that describes a GeoTIFF's coordinate system (OGC 19-008r4, GeoTIFF 1.1).

use tiff_reader::Ifd;

use super::units;

const TAG_KEYS: u16 = 34735;
const TAG_KEY_DOUBLES: u16 = 34736;

pub(super) const KEY_MODEL_TYPE: u16 = 1024;
pub(super) const KEY_RASTER_TYPE: u16 = 1025;
pub(super) const KEY_GEOGRAPHIC_TYPE: u16 = 2048;
pub(super) const KEY_ANGULAR_UNIT: u16 = 2054;
pub(super) const KEY_ANGULAR_UNIT_SIZE: u16 = 2055;
pub(super) const KEY_PROJECTED_TYPE: u16 = 3072;
const KEY_LINEAR_UNIT: u16 = 3076;
const KEY_LINEAR_UNIT_SIZE: u16 = 3077;
const KEY_VERTICAL_TYPE: u16 = 4096;
const KEY_VERTICAL_UNIT: u16 = 4099;

/// The number that stands for what the keys themselves define.
pub(super) const USER_DEFINED: u16 = 32767;

/// Vertical systems whose unit is not the metre, with the number of that unit: heights and depths over NGVD29,
/// NAVD88 and mean sea level in feet.
const VERTICAL_IN_FEET: [(u16, u16); 9] = [
    (5702, 9003),
    (6358, 9003),
    (6359, 9003),
    (6360, 9003),
    (8050, 9002),
    (8051, 9002),
    (8052, 9003),
    (8053, 9003),
    (8228, 9002),
];

/// The keys of a file.
pub(super) struct Keys {
    /// Of each key its number, where its value lies, how many values it has, and the value or its place.
    entries: Vec<[u16; 4]>,
    doubles: Vec<f64>,
}

impl Keys {
    /// The keys; none where the file has no directory, or an empty one. An error where the directory holds
    /// less than it says.
    pub(super) fn read(ifd: &Ifd) -> Result<Option<Self>, String> {
        let Some(tag) = ifd.tag(TAG_KEYS) else { return Ok(None) };
        let shorts = tag.value.as_u16_slice().ok_or("its directory of keys is not of shorts")?;
        let (entries, _) = shorts.as_chunks::<4>();
        let Some(([.., count], entries)) = entries.split_first() else {
            return Err("its directory of keys has no beginning".into());
        };
        let count = usize::from(*count);
        let entries = entries.get(..count).ok_or_else(|| {
            format!("its directory of keys announces {count} keys and holds {}", entries.len())
        })?;
        let doubles = ifd.tag(TAG_KEY_DOUBLES).and_then(|tag| tag.value.as_f64_vec()).unwrap_or_default();
        Ok((count > 0).then(|| Self { entries: entries.to_vec(), doubles }))
    }

    fn entry(&self, key: u16) -> Option<[u16; 4]> {
        self.entries.iter().find(|entry| entry[0] == key).copied()
    }

    /// The value of a key that is a number of 16 bit.
    pub(super) fn short(&self, key: u16) -> Option<u16> {
        // Location 0 means that the value is in the entry itself.
        self.entry(key).filter(|entry| entry[1] == 0).map(|[.., value]| value)
    }

    /// The value of a key that is the size of a unit.
    pub(super) fn unit_size(&self, key: u16) -> Result<Option<f64>, String> {
        let Some([_, TAG_KEY_DOUBLES, _, index]) = self.entry(key) else { return Ok(None) };
        let size = self.doubles.get(usize::from(index)).copied();
        let size = size.ok_or_else(|| format!("the number of its key {key} is missing"))?;
        if size.is_finite() && size > 0.0 {
            Ok(Some(size))
        } else {
            Err(format!("the unit of its key {key} has the size {size:?}"))
        }
    }

    /// Metres in one unit of a projected system; none where the unit is not known.
    pub(super) fn metres_per_unit(&self) -> Result<Result<f64, String>, String> {
        let Some(unit) = self.short(KEY_LINEAR_UNIT) else { return Ok(Ok(1.0)) };
        let metres = match unit {
            USER_DEFINED => self.unit_size(KEY_LINEAR_UNIT_SIZE)?,
            number => units::by_number(number).map(|(_, metres)| metres),
        };
        Ok(metres.ok_or_else(|| format!("the unit of its coordinates is not known (EPSG:{unit})")))
    }

    /// Name and metres of the unit of heights, where the keys say it.
    pub(super) fn vertical_unit(&self) -> Option<(String, Option<f64>)> {
        let of_system = || {
            let system = self.short(KEY_VERTICAL_TYPE)?;
            VERTICAL_IN_FEET.iter().find(|(known, _)| *known == system).map(|(_, unit)| *unit)
        };
        let number = self.short(KEY_VERTICAL_UNIT).filter(|&number| number != 0).or_else(of_system)?;
        Some(match units::by_number(number) {
            Some((name, metres)) => (name.to_owned(), Some(metres)),
            None => (format!("EPSG:{number}"), None),
        })
    }
}
