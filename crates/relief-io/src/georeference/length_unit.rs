//! Units of length, by the names that people and files use.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

use super::epsg;

/// Unit of length of a file's heights or coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit {
    name: &'static str,
    metres: f64,
}

/// Names of units in lower case, the displayed one first, with their EPSG code or their size in
/// metres.
const NAMES: [(&[&str], Result<u16, f64>); 13] = [
    (&["m", "metre", "metres", "meter", "meters"], Ok(9001)),
    (&["dm", "decimetre", "decimetres", "decimeter", "decimeters"], Err(0.1)),
    (&["cm", "centimetre", "centimetres", "centimeter", "centimeters"], Ok(1033)),
    (&["mm", "millimetre", "millimetres", "millimeter", "millimeters"], Ok(1025)),
    (&["um", "micrometre", "micrometres", "micrometer", "micrometers"], Err(1e-6)),
    (&["km", "kilometre", "kilometres", "kilometer", "kilometers"], Ok(9036)),
    (&["ft", "foot", "feet", "international foot", "international feet", "foot_international"], Ok(9002)),
    (
        &[
            "us-ft",
            "us_ft",
            "us ft",
            "ftus",
            "us foot",
            "us survey foot",
            "us survey feet",
            "survey foot",
            "foot_us",
        ],
        Ok(9003),
    ),
    (&["in", "inch", "inches"], Err(0.0254)),
    (&["yd", "yard", "yards"], Ok(9096)),
    (&["mi", "mile", "miles", "statute mile"], Ok(9093)),
    (&["nmi", "nautical mile", "nautical miles"], Ok(9030)),
    (&["fathom", "fathoms"], Ok(9014)),
];

impl LengthUnit {
    /// The metre.
    pub const METRE: Self = Self { name: "m", metres: 1.0 };

    /// Name that is shown: a well-known abbreviation if there is one.
    pub const fn name(self) -> &'static str {
        self.name
    }

    /// Metres in one unit.
    pub const fn metres(self) -> f64 {
        self.metres
    }

    /// Returns the unit with an EPSG code.
    pub fn by_code(code: u16) -> Option<Self> {
        let unit = epsg::length(code)?;
        let short = NAMES.iter().find(|(_, known)| *known == Ok(code)).map(|(names, _)| names[0]);
        Some(Self { name: short.unwrap_or(unit.name), metres: unit.size })
    }

    /// Returns the unit with a name, in any case: `m`, `metre`, `us-ft`, `US survey foot`, or a
    /// name of the EPSG's list.
    pub fn by_name(name: &str) -> Option<Self> {
        let name = name.trim().to_lowercase();
        match NAMES.iter().find(|(names, _)| names.contains(&name.as_str())) {
            Some((names, Err(metres))) => Some(Self { name: names[0], metres: *metres }),
            Some((_, Ok(code))) => Self::by_code(*code),
            None => epsg::lengths()
                .find(|unit| unit.name.to_lowercase() == name)
                .and_then(|unit| Self::by_code(unit.code)),
        }
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl FromStr for LengthUnit {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = NAMES.iter().map(|(names, _)| names[0]);
        Self::by_name(name).ok_or_else(|| UnknownName::new("unit", name, known))
    }
}

/// Units that a user gives for a file: `cm`, or `cm,ft` for heights in centimetres on a ground in
/// feet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenUnits {
    /// Unit of the heights; overrides the file.
    pub heights: LengthUnit,
    /// Unit of the ground's coordinates; overrides the file. None: the file's unit or, if it names
    /// none that is known, the unit of the heights.
    pub ground: Option<LengthUnit>,
}

impl fmt::Display for GivenUnits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.ground {
            Some(ground) => write!(f, "{},{ground}", self.heights),
            None => write!(f, "{}", self.heights),
        }
    }
}

impl FromStr for GivenUnits {
    type Err = UnknownName;

    fn from_str(text: &str) -> Result<Self, UnknownName> {
        Ok(match text.split_once(',') {
            Some((heights, ground)) => Self { heights: heights.parse()?, ground: Some(ground.parse()?) },
            None => Self { heights: text.parse()?, ground: None },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_found_by_their_names() {
        for (name, shown, metres) in [
            ("m", "m", 1.0),
            (" Metre ", "m", 1.0),
            ("dm", "dm", 0.1),
            ("cm", "cm", 0.01),
            ("FEET", "ft", 0.3048),
            ("US survey foot", "us-ft", 1200.0 / 3937.0),
            ("Foot_US", "us-ft", 1200.0 / 3937.0),
            ("Clarke's foot", "Clarke's foot", 0.304_797_265_4),
            ("british foot (1936)", "British foot (1936)", 0.304_800_749_1),
        ] {
            let unit = LengthUnit::by_name(name).expect(name);
            assert_eq!(unit.name(), shown, "{name}");
            assert!((unit.metres() / metres - 1.0).abs() < 1e-14, "{name}: {unit:?}");
        }
        let both: GivenUnits = "cm,us-ft".parse().expect("two units");
        assert_eq!((both.to_string(), both.heights.metres()), ("cm,us-ft".to_owned(), 0.01));
        for bad in ["", "kelvin", "cm,", ",m", "degree", "1", "cm,m,m"] {
            assert!(bad.parse::<GivenUnits>().is_err(), "{bad}");
        }
    }
}
