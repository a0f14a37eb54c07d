//! Notes on the units of heights and ground: which ones are assumed, and which cannot be known.

use relief_core::HeightMap;
use relief_io::{CoordinateSystem, Elevation, Format, Georeference, Ground, LengthUnit, UnitOrigin};

use crate::values::six_digits;

/// Describes how a unit is known, behind the unit's name.
pub fn by(origin: &UnitOrigin) -> String {
    match origin {
        UnitOrigin::Given => "by --unit".to_owned(),
        UnitOrigin::Assumed => "as no unit is named".to_owned(),
        UnitOrigin::Shared | UnitOrigin::Unnamed => String::new(),
        origin => format!("by {origin}"),
    }
}

/// Returns notes on a map's units if not all of them are named or known.
pub fn notes(ground: &Ground) -> Vec<String> {
    let mut notes = Vec::new();
    let Some(elevation) = &ground.elevation else { return notes };
    let placed = ground.georeference.as_ref();
    if let (Some(unit), None) = (&elevation.unit, elevation.metres_per_unit) {
        notes.push(format!("its heights are in {unit}, which is no known length: set another with --unit"));
    }
    match placed {
        Some(Georeference {
            unit: Some(unit), texel_size_m: Err(_), metres_per_unit: None, system, ..
        }) if is_linear(*system) && elevation.origin != UnitOrigin::Given => {
            notes.push(format!(
                "the unit of its coordinates is not known ({unit}): set it with --unit, as in --unit m,ft \
                 for heights in m on a ground in ft"
            ));
        }
        Some(Georeference { unit: None, transform: Some(_), .. })
            if elevation.origin == UnitOrigin::Unnamed =>
        {
            notes.push(
                "neither its heights nor its ground name a unit: they are assumed to share one, and their \
                 metres are not known: set it with --unit"
                    .to_owned(),
            );
        }
        Some(Georeference { unit: Some(unit), unit_origin: UnitOrigin::Shared, .. }) => {
            notes.push(format!(
                "its ground names no unit: the unit of the heights is assumed, {}: set another with --unit",
                with_metres(unit, elevation.metres_per_unit)
            ));
        }
        _ => {}
    }
    let is_picture = ground.format != Format::Tiff;
    if let (UnitOrigin::Shared, Some(unit)) = (&elevation.origin, &elevation.unit)
        && (is_picture || elevation.metres_per_unit != Some(1.0))
    {
        notes.push(format!(
            "its heights name no unit: the unit of the ground is assumed, {}: set another with --unit",
            with_metres(unit, elevation.metres_per_unit)
        ));
    }
    notes
}

fn is_linear(system: CoordinateSystem) -> bool {
    matches!(system, CoordinateSystem::Projected | CoordinateSystem::WebMercator)
}

/// Formats a unit with its length in metres, if it is not the metre.
pub fn with_metres(unit: &str, metres: Option<f64>) -> String {
    match metres {
        Some(metres) if metres != 1.0 => format!("{unit} of {} m each", six_digits(metres)),
        _ => unit.to_owned(),
    }
}

/// Returns why the heights of a map may not be metres of ground, if so.
pub fn doubt_of(ground: &Ground, map: &HeightMap) -> Option<String> {
    let elevation = ground.elevation.as_ref()?;
    let metres_per_unit = elevation.metres_per_unit?;
    // The map's own range is scaled already.
    let range = map.physical_range()?.map(|metres| metres / metres_per_unit);
    let scaled = Elevation { scale: 1.0, offset: 0.0, downward: false, ..elevation.clone() };
    doubt(&scaled, Some(range), [map.width(), map.height()], map.texel_size_m())
}

/// Returns why values of a map may not be metres of ground, if so, with the flag that names their
/// unit.
pub fn doubt(
    elevation: &Elevation,
    range: Option<[f64; 2]>,
    size: [u32; 2],
    texel_m: Option<[f64; 2]>,
) -> Option<String> {
    let range = range?;
    let ground_m =
        texel_m.map(|[u, v]| (u * f64::from(size[0])).max(v * f64::from(size[1]))).filter(|m| m.is_finite());
    let doubt = elevation.doubt(range, ground_m)?;
    let so = elevation.unit.as_deref().unwrap_or(LengthUnit::METRE.name());
    Some(format!("{doubt}: set their unit with --unit cm|dm|ft, or confirm them with --unit {so}"))
}
