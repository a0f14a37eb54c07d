//! The settings that a method's functions read, as members of one struct.
//!
//! In the sources they lie in the buffers of whole surfaces, beside much that functions do not read.

use std::collections::{BTreeMap, BTreeSet};

use relief_core::registry::Param;
use relief_core::{RayUse, Wrap};
use relief_shaders::{MapSlot, STAGES, Selection};

use super::parameters;
use super::reduce::{Types, Values};
use super::syntax::{
    Expression, Function, Parameter, Unit, change_expressions, expression, visit_expressions,
};
use crate::ExportError;

/// The buffers of the sources.
const BUFFERS: [&str; 2] = ["surface_settings", "point_settings"];

/// The name of the functions' parameter, and of the struct.
pub const SETTINGS: &str = "settings";
pub const STRUCT: &str = "ReliefSettings";

/// A setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The member of the struct.
    pub name: String,
    /// Its type, as WGSL writes it.
    pub of: String,
    /// A sentence that says what it holds.
    pub holds: String,
    /// For a parameter of a variant, its entry and its value to begin with.
    pub param: Option<(Param, f32)>,
}

/// Settings that are no parameters of a variant: the source, the name and what it holds.
const KNOWN: [(&str, &str, &str); 10] = [
    ("surface_settings.scale_m", "scale", "The length from the height 0 to the height 1."),
    (
        "surface_settings.bias_m",
        "bias",
        "The length from the mesh up to the height 0. With -scale all relief lies below the mesh.",
    ),
    (
        "surface_settings.shell_m",
        "shell",
        "The lengths from the mesh to the heights 0 and 1 along its normals: `bias`, and `bias` and `scale` \
         together. Not quite the same, however flat the relief is.",
    ),
    ("surface_settings.height_size", "height_size", "Columns and rows of the height map."),
    ("surface_settings.height_levels", "height_levels", "The number of levels of the height map."),
    ("surface_settings.mean_height", "mean_height", "The mean of the height map, from 0 to 1."),
    ("surface_settings.wrap", "wrap", "Beyond the map's edge: 0 repeats it, 1 ends it, 2 mirrors it."),
    (
        "surface_settings.volume",
        "volume",
        "Columns, rows and slices of the volume; slices in a row of its map.",
    ),
    ("surface_settings.jump", "jump", "The difference of heights beyond which a cell is no slope."),
    (
        "point_settings.light_radius",
        "light_radius",
        "The radius of the light's disc over its distance: the tangent of half its angular diameter.",
    ),
];

/// Members of the settings of baked maps: the name's end, and what it holds.
const OF_MAPS: [(&str, &str, &str); 3] = [
    ("layers", "layers", "The number of layers of the map"),
    ("tile_m", "tile", "The lengths of a tile along u and v that were told to the bake of the map"),
    (
        "first_level",
        "first_level",
        "The level of the height map that has the size of the finest level of the map",
    ),
];

/// Choices that no function makes at run time: the source and its value.
pub fn fixed(wrap: Option<Wrap>, has_holes: bool, rays: Option<RayUse>) -> Vec<(&'static str, Expression)> {
    let count = |value: u32| Expression::Literal(format!("{value}u"));
    let mut fixed = vec![
        ("has_holes", count(u32::from(has_holes))),
        ("has_creases", count(0)),
        ("has_normal", count(0)),
        ("has_vertex_normals", count(0)),
        // Maps hold values, not codes.
        ("coded", count(0)),
    ];
    if let Some(rays) = rays {
        fixed.push(("ray", count(rays as u32)));
    }
    if let Some(wrap) = wrap {
        fixed.push(("wrap", count(wrap as u32)));
    }
    fixed
}

/// Puts fixed choices in their places.
pub fn fix(unit: &mut Unit, fixed: &[(&'static str, Expression)]) {
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            let found = match part {
                Expression::Member(of, member) => {
                    let is_setting =
                        matches!(&**of, Expression::Name(name) if BUFFERS.contains(&name.as_str()));
                    let is_map = member == "coded" || member == "ray";
                    fixed.iter().find(|(name, _)| name == member && (is_setting || is_map))
                }
                _ => None,
            };
            if let Some((_, value)) = found {
                *part = value.clone();
            }
        });
    }
}

/// The order of a shell's corners from which on it overlaps itself.
const FOLDED: &str = "SHELL_FOLDED";

/// Takes shells for such that do not overlap themselves.
pub fn fix_unfolded(unit: &mut Unit) {
    let is_limit = |part: &Expression| matches!(part, Expression::Name(name) if name == FOLDED);
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            let is_folded = match part {
                Expression::Binary(sign, _, limit) if is_limit(limit) => match *sign {
                    "<" => Some(false),
                    ">=" => Some(true),
                    _ => None,
                },
                _ => None,
            };
            if let Some(is_folded) = is_folded {
                *part = Expression::Literal((!is_folded).to_string());
            }
        });
    }
}

/// Puts members of one struct in the place of the buffers' members. Returns the struct's members.
pub fn gather(unit: &mut Unit, selection: &Selection) -> Result<Vec<Setting>, ExportError> {
    let types = Types::of(unit);
    let values = Values::of(unit);
    let mut settings: BTreeMap<String, Setting> = BTreeMap::new();
    let mut fault = None;
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        change_expressions(&mut function.body, &mut |part| {
            let Some(source) = source(part, &values) else { return };
            let Some(of) = types.type_of(part, &locals) else { return };
            let is_vector_of_params = source.ends_with(".params");
            if types.is_struct(&of) || of.starts_with("array<") || is_vector_of_params {
                return;
            }
            match setting(&source, &of, selection) {
                Some(setting) => {
                    *part = Expression::name(SETTINGS).member(&setting.name);
                    settings.insert(source, setting);
                }
                // A component of a vector that is a setting.
                None => fault = fault.take().or(Some(source)),
            }
        });
    }
    match fault {
        Some(source) => Err(ExportError::Invalid(format!("{source} is no setting of functions"))),
        None => {
            let mut settings: Vec<(String, Setting)> = settings.into_iter().collect();
            settings.sort_by_key(|(source, _)| rank(source));
            Ok(settings.into_iter().map(|(_, setting)| setting).collect())
        }
    }
}

/// The order of settings: what is known by name, parameters stage by stage, then maps.
fn rank(source: &str) -> (usize, usize, String) {
    let known = KNOWN.iter().position(|(name, ..)| *name == source);
    let place = source.split(['[', ']']).nth(1).and_then(|place| place.parse().ok());
    let is_map = usize::from(source.contains(".maps["));
    match known {
        Some(known) => (0, known, String::new()),
        None => (1 + is_map, place.unwrap_or(0), source.to_owned()),
    }
}

/// A member of a buffer by its path, with known indices.
fn source(of: &Expression, values: &Values) -> Option<String> {
    match of {
        Expression::Name(name) => BUFFERS.contains(&name.as_str()).then(|| name.clone()),
        Expression::Member(of, member) => Some(format!("{}.{member}", source(of, values)?)),
        Expression::Index(of, index) => {
            let known = values.value(index).map_or_else(
                || expression(index),
                |value| expression(&value.literal()).trim_end_matches('u').to_owned(),
            );
            Some(format!("{}[{known}]", source(of, values)?))
        }
        Expression::Group(inner) => source(inner, values),
        _ => None,
    }
}

fn setting(source: &str, of: &str, selection: &Selection) -> Option<Setting> {
    let made = |name: String, holds: String, param| Some(Setting { name, of: of.to_owned(), holds, param });
    if let Some((_, name, holds)) = KNOWN.iter().find(|(known, ..)| *known == source) {
        return made((*name).to_owned(), (*holds).to_owned(), None);
    }
    let rest = source.strip_prefix("surface_settings.")?;
    let indexed = |array: &str| {
        let (index, member) = rest.strip_prefix(array)?.split_once("].")?;
        Some((index.parse::<usize>().ok()?, member.to_owned()))
    };
    if let Some((place, member)) = indexed("choices[") {
        let letter = member.strip_prefix("params.")?;
        let component = ["x", "y", "z", "w"].iter().position(|known| *known == letter)?;
        let (stage, choice) = (STAGES.get(place)?, selection.choices.get(place)?);
        let param = choice.entry.params.get(component)?;
        let value = *choice.params.get(component)?;
        let unit = if param.unit.is_empty() { String::new() } else { format!(" in {}", param.unit) };
        let holds = format!("{}: {}{unit}, {} to {}.", stage.title, param.summary, param.min, param.max);
        return made(parameters::name(stage.key, param.name), capitalised(&holds), Some((*param, value)));
    }
    let (slot, member) = indexed("maps[")?;
    let slot = MapSlot::ALL.get(slot)?;
    let (_, ending, holds) = OF_MAPS.iter().find(|(known, ..)| *known == member)?;
    made(format!("{}_{ending}", slot.key()), format!("{holds} {}.", slot.name()), None)
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Hands the settings to each function that reads them, as its first parameter.
pub fn hand_over(unit: &mut Unit) {
    let reads = |function: &Function| {
        let mut found = false;
        visit_expressions(&function.body, &mut |part| {
            found |= matches!(part, Expression::Name(name) if name == SETTINGS);
        });
        found
    };
    let mut takers: BTreeSet<String> =
        unit.functions().filter(|function| reads(function)).map(|function| function.name.clone()).collect();
    loop {
        let known = takers.len();
        for function in unit.functions() {
            let mut calls = false;
            visit_expressions(&function.body, &mut |part| {
                calls |= matches!(part, Expression::Call(name, _) if takers.contains(name));
            });
            if calls {
                takers.insert(function.name.clone());
            }
        }
        if takers.len() == known {
            break;
        }
    }
    for function in unit.functions_mut() {
        if takers.contains(&function.name) {
            let parameter = Parameter { name: SETTINGS.to_owned(), of: STRUCT.to_owned() };
            function.parameters.insert(0, parameter);
        }
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part
                && takers.contains(name)
            {
                arguments.insert(0, Expression::name(SETTINGS));
            }
        });
    }
}
