//! What is said of the units of heights and ground: what is taken for granted, and what cannot be.

use relief_core::HeightMap;
use relief_io::{CoordinateSystem, Elevation, Format, Georeference, Ground, LengthUnit, UnitOrigin};

use crate::values::six_digits;

/// How a unit is known, behind the unit's name.
pub fn by(origin: &UnitOrigin) -> String {
    match origin {
        UnitOrigin::Given => "by --unit".to_owned(),
        UnitOrigin::Assumed => "as no unit is named".to_owned(),
        UnitOrigin::Shared | UnitOrigin::Unnamed => String::new(),
        origin => format!("by {origin}"),
    }
}

/// What is said of a map's units where not all of them are named or known.
pub fn notes(ground: &Ground) -> Vec<String> {
    let mut notes = Vec::new();
    let Some(elevation) = &ground.elevation else { return notes };
    let placed = ground.georeference.as_ref();
    if let (Some(unit), None) = (&elevation.unit, elevation.metres_per_unit) {
        notes.push(format!("its heights are in {unit}, which is no known length: --unit names another"));
    }
    match placed {
        Some(Georeference {
            unit: Some(unit), texel_size_m: Err(_), metres_per_unit: None, system, ..
        }) if is_linear(*system) && elevation.origin != UnitOrigin::Given => {
            notes.push(format!(
                "the unit of its coordinates is not known ({unit}): --unit gives it, as in --unit m,ft for \
                 heights in m on a ground in ft"
            ));
        }
        Some(Georeference { unit: None, transform: Some(_), .. })
            if elevation.origin == UnitOrigin::Unnamed =>
        {
            notes.push(
                "neither its heights nor its ground name a unit: they are taken to share one, and their \
                 metres are not known: --unit names it"
                    .to_owned(),
            );
        }
        Some(Georeference { unit: Some(unit), unit_origin: UnitOrigin::Shared, .. }) => {
            notes.push(format!(
                "its ground names no unit: the unit of the heights is taken, {}: --unit names another",
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
            "its heights name no unit: the unit of the ground is taken, {}: --unit names another",
            with_metres(unit, elevation.metres_per_unit)
        ));
    }
    notes
}

fn is_linear(system: CoordinateSystem) -> bool {
    matches!(system, CoordinateSystem::Projected | CoordinateSystem::WebMercator)
}

/// A unit with its metres, where it is not the metre.
pub fn with_metres(unit: &str, metres: Option<f64>) -> String {
    match metres {
        Some(metres) if metres != 1.0 => format!("{unit} of {} m each", six_digits(metres)),
        _ => unit.to_owned(),
    }
}

/// Why the heights of a map are no metres of ground.
pub fn doubt_of(ground: &Ground, map: &HeightMap) -> Option<String> {
    let elevation = ground.elevation.as_ref()?;
    let metres_per_unit = elevation.metres_per_unit?;
    // What the map knows has been scaled already.
    let range = map.physical_range()?.map(|metres| metres / metres_per_unit);
    let scaled = Elevation { scale: 1.0, offset: 0.0, downward: false, ..elevation.clone() };
    doubt(&scaled, Some(range), [map.width(), map.height()], map.texel_size_m())
}

/// Why values of a map are no metres of ground, with the flag that says what they are.
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
    Some(format!("{doubt}: --unit cm|dm|ft names their unit, --unit {so} says that they are right"))
}
