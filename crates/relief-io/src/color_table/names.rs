//! Names of colours in tables of GDAL and GRASS.

use relief_core::registry::UnknownName;

/// Names, and red, green and blue from 0 to 255.
const NAMES: [(&str, [u8; 3]); 16] = [
    ("white", [255, 255, 255]),
    ("black", [0, 0, 0]),
    ("red", [255, 0, 0]),
    ("green", [0, 255, 0]),
    ("blue", [0, 0, 255]),
    ("yellow", [255, 255, 0]),
    ("magenta", [255, 0, 255]),
    ("cyan", [0, 255, 255]),
    ("aqua", [0, 191, 191]),
    ("grey", [191, 191, 191]),
    ("gray", [191, 191, 191]),
    ("orange", [255, 127, 0]),
    ("brown", [191, 127, 63]),
    ("purple", [127, 0, 255]),
    ("violet", [127, 0, 255]),
    ("indigo", [0, 127, 255]),
];

/// Returns the colour of a name, in any case.
pub fn color(name: &str) -> Result<[u8; 3], UnknownName> {
    let known = NAMES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
    known
        .map(|(_, color)| *color)
        .ok_or_else(|| UnknownName::new("colour", name, NAMES.map(|(known, _)| known)))
}
