//! Units of length, by their numbers in the EPSG's list and by the names that GDAL's files give them.

/// A unit of length.
struct Length {
    epsg: Option<u16>,
    /// In small letters; the first is the one shown.
    names: &'static [&'static str],
    metres: f64,
}

const fn length(epsg: u16, names: &'static [&'static str], metres: f64) -> Length {
    Length { epsg: Some(epsg), names, metres }
}

const LENGTHS: [Length; 12] = [
    length(9001, &["m", "metre", "metres", "meter", "meters"], 1.0),
    length(9002, &["ft", "foot", "feet", "international foot", "international feet"], 0.3048),
    length(
        9003,
        &["us-ft", "us_ft", "us ft", "ftus", "us foot", "us survey foot", "us survey feet", "survey foot"],
        1200.0 / 3937.0,
    ),
    length(9005, &["clarke's foot"], 0.304_797_265_4),
    length(9014, &["fathom", "fathoms"], 1.8288),
    length(9030, &["nautical mile", "nmi"], 1852.0),
    length(9036, &["km", "kilometre", "kilometres", "kilometer", "kilometers"], 1000.0),
    length(9093, &["mi", "mile", "miles", "statute mile"], 1609.344),
    length(9096, &["yd", "yard", "yards"], 0.9144),
    length(1025, &["mm", "millimetre", "millimetres", "millimeter", "millimeters"], 0.001),
    length(1033, &["cm", "centimetre", "centimetres", "centimeter", "centimeters"], 0.01),
    Length { epsg: None, names: &["dm", "decimetre", "decimetres", "decimeter", "decimeters"], metres: 0.1 },
];

/// Name and metres of a unit by its number.
pub(super) fn by_number(epsg: u16) -> Option<(&'static str, f64)> {
    LENGTHS.iter().find(|length| length.epsg == Some(epsg)).map(|length| (length.names[0], length.metres))
}

/// Metres of a unit by its name, in any case.
pub(super) fn by_name(name: &str) -> Option<f64> {
    let name = name.to_lowercase();
    LENGTHS.iter().find(|length| length.names.contains(&name.as_str())).map(|length| length.metres)
}
