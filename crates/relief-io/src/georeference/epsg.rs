//! Units of coordinate systems by EPSG code, from a table of a few kilobytes.
//!
//! The table holds every projected, vertical and geographic system of the EPSG's list. A code that
//! is missing belongs to another kind of system, or is newer than the list.

/// Table of units and systems. Its first lines describe its format.
const TABLE: &str = include_str!("epsg.txt");

/// Unit of the EPSG's list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EpsgUnit {
    /// EPSG code of the unit.
    pub code: u16,
    /// Size of the unit: metres in a unit of length, radians in a unit of angle.
    pub size: f64,
    /// Name in the EPSG's list.
    pub name: &'static str,
}

/// Axis of a vertical system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VerticalAxis {
    /// EPSG code of the unit.
    pub unit: u16,
    /// Whether values are depths, which grow downward.
    pub downward: bool,
}

/// Returns the unit of length with an EPSG code.
pub fn length(code: u16) -> Option<EpsgUnit> {
    units("length").find(|unit| unit.code == code)
}

/// Returns the unit of angle with an EPSG code.
pub fn angle(code: u16) -> Option<EpsgUnit> {
    units("angle").find(|unit| unit.code == code)
}

/// Iterates over all units of length.
pub(crate) fn lengths() -> impl Iterator<Item = EpsgUnit> {
    units("length")
}

/// Returns the code of the unit of a projected system's coordinates.
pub fn projected(code: u16) -> Option<u16> {
    unit_of("projected", code)
}

/// Returns the code of the unit of a geographic system's latitudes and longitudes. Degrees are
/// 9122, however they are written.
pub fn geographic(code: u16) -> Option<u16> {
    unit_of("geographic", code).or_else(|| unit_of("geographic-3d", code))
}

/// Returns the vertical axis of a vertical system, or of a geographic one with heights above its
/// ellipsoid.
pub fn vertical(code: u16) -> Option<VerticalAxis> {
    let up = |unit| VerticalAxis { unit, downward: false };
    let down = |unit| VerticalAxis { unit, downward: true };
    let ellipsoidal = || unit_of("geographic-3d", code).map(|_| up(METRE));
    unit_of("vertical", code).map(up).or_else(|| unit_of("down", code).map(down)).or_else(ellipsoidal)
}

/// EPSG code of the metre.
const METRE: u16 = 9001;

fn units(kind: &'static str) -> impl Iterator<Item = EpsgUnit> {
    TABLE.lines().filter_map(move |line| {
        let mut words = line.strip_prefix(kind)?.strip_prefix(' ')?.splitn(3, ' ');
        let (code, size, name) = (words.next()?, words.next()?, words.next()?);
        Some(EpsgUnit { code: code.parse().ok()?, size: size.parse().ok()?, name })
    })
}

/// Returns the code of the unit under which a system is listed.
fn unit_of(kind: &str, code: u16) -> Option<u16> {
    let (hundred, place) = (code / 100, code % 100);
    let mut unit = None;
    for line in TABLE.lines() {
        let (first, rest) = line.split_once(' ')?;
        if first.starts_with(|first: char| first.is_ascii_digit()) {
            let holds = |range: &str| {
                let (from, to) = range.split_once('-').unwrap_or((range, range));
                let ends: [Option<u16>; 2] = [from, to].map(|end| end.parse().ok());
                matches!(ends, [Some(from), Some(to)] if (from..=to).contains(&place))
            };
            if unit.is_some() && first.parse() == Ok(hundred) && rest.split(' ').any(holds) {
                return unit;
            }
        } else {
            unit = if first == kind { rest.parse().ok() } else { None };
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn systems_have_the_units_of_the_list() {
        // Numbers of each kind of unit, with those beside them that have another one or are nothing.
        let projected_systems = [
            (2271, Some(9003)),
            (6597, Some(9003)),
            (2263, Some(9003)),
            (3089, Some(9003)),
            (2222, Some(9002)),
            (2223, Some(9002)),
            (2224, Some(9002)),
            (2225, Some(9003)),
            (32617, Some(9001)),
            (3857, Some(9001)),
            (3785, Some(9001)),
            (27700, Some(9001)),
            (2314, Some(9005)),
            (24382, Some(9084)),
            (31000, None),
            (1, None),
            (0, None),
            (4326, None),
            (5703, None),
            (32767, None),
            (u16::MAX, None),
        ];
        for (code, unit) in projected_systems {
            assert_eq!(projected(code), unit, "EPSG:{code}");
        }
        let axis = |unit, downward| Some(VerticalAxis { unit, downward });
        for (code, expected) in [
            (5703, axis(9001, false)),
            (6360, axis(9003, false)),
            (8228, axis(9002, false)),
            (5754, axis(9095, false)),
            (6357, axis(9001, true)),
            (6359, axis(9003, true)),
            (5715, axis(9001, true)),
            (4979, axis(9001, false)),
            (4326, None),
            (5103, None),
            (9999, None),
        ] {
            assert_eq!(vertical(code), expected, "EPSG:{code}");
        }
        for (code, unit) in
            [(4326, Some(9122)), (4979, Some(9122)), (4807, Some(9105)), (4978, None), (3857, None)]
        {
            assert_eq!(geographic(code), unit, "EPSG:{code}");
        }
    }

    #[test]
    fn every_unit_of_a_system_is_in_the_table() {
        let mut counts = [0; 3];
        // The list goes no farther.
        for code in 1024..32_767 {
            let (ground, heights, degrees) = (projected(code), vertical(code), geographic(code));
            for unit in ground.into_iter().chain(heights.map(|axis| axis.unit)).filter(|unit| *unit != METRE)
            {
                assert!(length(unit).is_some_and(|unit| unit.size > 1e-3 && unit.size < 1e4), "{code}");
            }
            assert!(degrees.is_none_or(|unit| angle(unit).is_some()), "{code}");
            counts[0] += usize::from(ground.is_some_and(|unit| unit != METRE));
            counts[1] += usize::from(heights.is_some_and(|axis| axis.downward));
            counts[2] += usize::from(degrees == Some(9105));
        }
        assert_eq!(counts, [1002, 52, 8]);
    }
}
