//! Coordinate systems as text: well-known text (WKT) of both versions and of ESRI, and EPSG codes.
//! Only units, heights and codes are read from it.

use super::{Crs, Unit, Vertical, WEB_MERCATOR, epsg, shown};
use crate::LengthUnit;
use crate::elevation::{CoordinateSystem, UnitOrigin};

/// Greatest depth of brackets. Real systems have ten levels.
const MAX_DEPTH: usize = 32;

/// Node of the text: the keyword before the brackets, texts and numbers in them, and nested nodes.
#[derive(Debug, Default)]
struct Node {
    /// Keyword in capital letters.
    keyword: String,
    values: Vec<String>,
    children: Vec<Node>,
}

/// Parses the text of a coordinate system. An error, with the reason, if it cannot be read.
pub(super) fn system(text: &str, file: &str) -> Result<Crs, String> {
    let text = text.trim();
    let origin = UnitOrigin::Beside(file.to_owned());
    if let Some(numbers) = by_number(text) {
        return Ok(numbers);
    }
    if !text.contains(['[', '(']) {
        // Another text is not an error, but its unit is unknown.
        let unit = Unit::Unknown { name: format!("{file} is not well-known text"), origin };
        return Ok(Crs { system: CoordinateSystem::Projected, epsg: None, unit, vertical: None });
    }
    let mut rest = text;
    let root = node(&mut rest, 0)?;
    let system = crs(&root, &origin)?;
    // ESRI writes the vertical system behind the horizontal one.
    let more = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
    let heights = if more.contains('[') { Some(node(&mut &*more, 0)?) } else { None };
    let heights =
        heights.filter(|node| node.is(&VERTICAL)).map(|node| vertical(&node, &origin)).transpose()?;
    Ok(Crs { vertical: heights.or(system.vertical), ..system })
}

/// Parses a system named by its code, such as `EPSG:32633`, or with a vertical one, such as
/// `EPSG:32633+5773`.
fn by_number(text: &str) -> Option<Crs> {
    let (authority, numbers) = text.rsplit_once(':')?;
    let is_epsg = authority.trim_end_matches(':').to_ascii_uppercase().ends_with("EPSG");
    let (number, vertical) = numbers.split_once('+').map_or((numbers, None), |(n, v)| (n, Some(v)));
    let number: u16 = number.trim().parse().ok().filter(|_| is_epsg)?;
    let vertical = match vertical {
        Some(vertical) => Some(Vertical::of_system(vertical.trim().parse().ok()?)),
        None => {
            epsg::geographic(number).and_then(|_| epsg::vertical(number)).map(|_| Vertical::of_system(number))
        }
    };
    let system = match number {
        number if WEB_MERCATOR.contains(&number) => CoordinateSystem::WebMercator,
        number if epsg::geographic(number).is_some() => CoordinateSystem::Geographic,
        _ => CoordinateSystem::Projected,
    };
    Some(Crs { system, epsg: Some(number), unit: Unit::of_system(system, number), vertical })
}

fn node(rest: &mut &str, depth: usize) -> Result<Node, String> {
    if depth > MAX_DEPTH {
        return Err(format!("has brackets more than {MAX_DEPTH} deep"));
    }
    let open = rest.find(['[', '(']).ok_or("ends too early")?;
    let mut node = Node { keyword: rest[..open].trim().to_ascii_uppercase(), ..Node::default() };
    *rest = &rest[open + 1..];
    loop {
        *rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
        let next = rest.chars().next().ok_or("ends too early")?;
        if next == '"' {
            let (text, after) = rest[1..].split_once('"').ok_or("ends within a name")?;
            node.values.push(text.to_owned());
            *rest = after;
        } else if matches!(next, ']' | ')') {
            *rest = &rest[1..];
            return Ok(node);
        } else {
            let end = rest.find([',', '[', '(', ']', ')']).ok_or("ends too early")?;
            if rest[end..].starts_with(['[', '(']) {
                node.children.push(self::node(rest, depth + 1)?);
            } else {
                node.values.push(rest[..end].trim().to_owned());
                *rest = &rest[end..];
            }
        }
    }
}

impl Node {
    fn is(&self, keywords: &[&str]) -> bool {
        keywords.contains(&self.keyword.as_str())
    }

    fn children<'a>(&'a self, keywords: &'a [&str]) -> impl DoubleEndedIterator<Item = &'a Node> {
        self.children.iter().filter(|child| child.is(keywords))
    }

    /// EPSG code of the node.
    fn epsg(&self) -> Option<u16> {
        self.children(&["AUTHORITY", "ID"]).find_map(|id| {
            let [authority, number, ..] = id.values.as_slice() else { return None };
            number.parse().ok().filter(|_| authority.eq_ignore_ascii_case("EPSG"))
        })
    }

    /// Unit of the coordinates: the system's own, or its first axis' unit.
    fn unit(&self, origin: &UnitOrigin) -> Result<Option<Unit>, String> {
        const UNITS: [&str; 3] = ["UNIT", "LENGTHUNIT", "ANGLEUNIT"];
        let of_axis = || self.children(&["AXIS"]).next().and_then(|axis| axis.children(&UNITS).next());
        let Some(found) = self.children(&UNITS).next_back().or_else(of_axis) else { return Ok(None) };
        let name = found.values.first().cloned().unwrap_or_default();
        let name = LengthUnit::by_name(&name).map_or_else(|| shown(&name), |unit| unit.name().to_owned());
        let Some(size) = found.values.get(1) else { return Ok(Some(Unit::named(name, origin.clone()))) };
        match size.parse::<f64>().ok().filter(|size| size.is_finite() && *size > 0.0) {
            Some(size) => Ok(Some(Unit::Known { name, size, origin: origin.clone() })),
            None => Err(format!("has a unit of the impossible size '{}'", shown(size))),
        }
    }

    /// Whether the coordinates are Cartesian, from the middle of the Earth.
    fn is_cartesian(&self) -> bool {
        let mut kinds = self.children(&["CS"]).filter_map(|cs| cs.values.first());
        kinds.any(|kind| kind.eq_ignore_ascii_case("Cartesian"))
    }

    /// Whether the system is Web Mercator.
    fn is_web_mercator(&self) -> bool {
        let is_number = self.epsg().is_some_and(|number| WEB_MERCATOR.contains(&number));
        let methods = self.children(&["CONVERSION"]).flat_map(|conversion| conversion.children(&["METHOD"]));
        let names = methods.chain(self.children(&["PROJECTION", "EXTENSION"])).flat_map(|node| &node.values);
        let is_name = |name: &String| {
            let name = name.to_ascii_lowercase().replace([' ', '_', '-'], "");
            name.contains("auxiliarysphere")
                || name.contains("pseudomercator")
                || name.contains("nadgrids=@null")
        };
        is_number || names.chain(self.values.first()).any(is_name)
    }
}

const PROJECTED: [&str; 4] = ["PROJCS", "PROJCRS", "PROJECTEDCRS", "DERIVEDPROJCRS"];
const GEOGRAPHIC: [&str; 5] = ["GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS"];
const LOCAL: [&str; 3] = ["LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"];
const VERTICAL: [&str; 4] = ["VERT_CS", "VERTCRS", "VERTICALCRS", "VERTCS"];

fn crs(node: &Node, origin: &UnitOrigin) -> Result<Crs, String> {
    let unknown =
        || Crs { system: CoordinateSystem::Unknown, epsg: None, unit: Unit::Unnamed, vertical: None };
    let system = match node.keyword.as_str() {
        "COMPD_CS" | "COMPOUNDCRS" => {
            let horizontal = node.children.iter().find(|child| !child.is(&VERTICAL) && is_system(child));
            let crs = horizontal.map_or_else(|| Ok(unknown()), |child| crs(child, origin))?;
            let heights = node.children(&VERTICAL).next();
            let heights = heights.map(|node| vertical(node, origin)).transpose()?;
            return Ok(Crs { vertical: heights.or(crs.vertical), ..crs });
        }
        "BOUNDCRS" => {
            let source = node.children(&["SOURCECRS"]).flat_map(|source| &source.children).next();
            return source.map_or_else(|| Ok(unknown()), |source| crs(source, origin));
        }
        _ if node.is(&PROJECTED) && node.is_web_mercator() => CoordinateSystem::WebMercator,
        _ if node.is(&PROJECTED) || node.is(&LOCAL) => CoordinateSystem::Projected,
        _ if node.is(&GEOGRAPHIC) && !node.is_cartesian() => CoordinateSystem::Geographic,
        _ => return Ok(unknown()),
    };
    let epsg = node.epsg();
    let unit = node.unit(origin)?.or_else(|| epsg.map(|number| Unit::of_system(system, number)));
    let axes: Vec<&Node> = node.children(&["AXIS"]).collect();
    let up = match (axes.as_slice(), epsg) {
        ([_, _, up], _) => up.unit(origin)?.map(|unit| Vertical { unit, downward: false }),
        (_, Some(number)) if epsg::geographic(number).is_some() && epsg::vertical(number).is_some() => {
            Some(Vertical::of_system(number))
        }
        _ => None,
    };
    Ok(Crs { system, epsg, unit: unit.unwrap_or_default(), vertical: up })
}

fn is_system(node: &Node) -> bool {
    node.is(&PROJECTED) || node.is(&GEOGRAPHIC) || node.is(&LOCAL) || node.is(&["BOUNDCRS"])
}

fn vertical(node: &Node, origin: &UnitOrigin) -> Result<Vertical, String> {
    let by_number = node.epsg().map(Vertical::of_system);
    let is_down = |value: &String| value.eq_ignore_ascii_case("down");
    let axis = node.children(&["AXIS"]).next();
    // ESRI writes the direction as a parameter.
    let direction = node.children(&["PARAMETER"]).find(|parameter| {
        parameter.values.first().is_some_and(|name| name.eq_ignore_ascii_case("Direction"))
    });
    let downward = match (axis, direction) {
        (Some(axis), _) => axis.values.iter().skip(1).any(is_down),
        (None, Some(direction)) => direction.values.get(1).is_some_and(|sign| sign.starts_with('-')),
        (None, None) => by_number.as_ref().is_some_and(|vertical| vertical.downward),
    };
    let unit = node.unit(origin)?.or_else(|| by_number.map(|vertical| vertical.unit));
    Ok(Vertical { unit: unit.unwrap_or_default(), downward })
}
