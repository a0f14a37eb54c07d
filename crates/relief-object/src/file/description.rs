//! Parser of `object.toml`.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use glam::DVec3;
use relief_core::HeightMap;
use relief_core::object::{JumpCells, MAX_VIEWS};
use relief_core::registry::UnknownName;
use relief_io::{Source, decode_text};
use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

use super::{Measured, ObjectFileError, ObjectFileProblem};
use crate::{ViewKind, ViewSpec};

/// Longest file that is read, in bytes. A thousand views take 200 KiB.
const MAX_FILE_BYTES: u64 = 1 << 20;

const KEYS: [&str; 8] = ["kind", "centre", "radius", "depth", "color", "normal", "view", "measured"];
const VIEW_KEYS: [&str; 5] = ["from", "up", "eye", "fov", "rect"];
const MEASURED_KEYS: [&str; 9] =
    ["views", "size", "cells", "jump", "iou", "depth-error", "worst-from", "worst-iou", "worst-depth-error"];

/// Content of an `object.toml`.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Kind of the images' rays.
    pub kind: ViewKind,
    /// Centre of the ball that the images show, in metres.
    pub centre: DVec3,
    /// Radius of the ball, in metres.
    pub radius: f64,
    /// Name of the file of depths.
    pub depth: PathBuf,
    /// Name of the file of colours, if any.
    pub color: Option<PathBuf>,
    /// Name of the file of normals, if any.
    pub normal: Option<PathBuf>,
    /// The images.
    pub views: Vec<ViewEntry>,
    /// Differences from the mesh that the object was captured from, if they were measured.
    pub measured: Option<Measured>,
}

/// An image of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewEntry {
    /// Direction or eye of the view.
    pub spec: ViewSpec,
    /// Column, row, width and height of the image in the pictures.
    pub rect: [u32; 4],
    /// Line of the file on which the entry begins, counted from 1.
    pub(super) line: usize,
}

#[derive(Deserialize)]
struct Table {
    kind: Spanned<String>,
    centre: Spanned<Vec<f64>>,
    radius: f64,
    depth: PathBuf,
    color: Option<PathBuf>,
    normal: Option<PathBuf>,
    #[serde(default)]
    view: Vec<Spanned<ViewTable>>,
    measured: Option<Spanned<MeasuredTable>>,
}

#[derive(Deserialize)]
struct ViewTable {
    from: Option<Vec<f64>>,
    up: Option<Vec<f64>>,
    eye: Option<Vec<f64>>,
    fov: Option<f64>,
    rect: Option<Vec<u32>>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct MeasuredTable {
    views: u32,
    size: u32,
    cells: String,
    jump: f64,
    iou: f64,
    depth_error: Option<f64>,
    worst_from: Vec<f64>,
    worst_iou: f64,
    worst_depth_error: Option<f64>,
}

/// Views of a file for a capture: only `kind` and `[[view]]` are used. The file may have all keys
/// of an object, but needs only these. Rectangles are ignored.
#[derive(Deserialize)]
struct Views {
    kind: Option<Spanned<String>>,
    #[serde(default)]
    view: Vec<Spanned<ViewTable>>,
}

/// An error, and its position in the text.
enum Mistake {
    Toml(Box<toml::de::Error>),
    Problem { at: usize, view: Option<usize>, problem: ObjectFileProblem },
}

impl From<toml::de::Error> for Mistake {
    fn from(error: toml::de::Error) -> Self {
        Mistake::Toml(Box::new(error))
    }
}

fn wrong(at: usize, problem: impl Into<ObjectFileProblem>) -> Mistake {
    Mistake::Problem { at, view: None, problem: problem.into() }
}

/// Reads an object's file and checks everything that does not need the pictures.
///
/// # Errors
///
/// When the file cannot be read, is longer than 1 MiB, is not TOML, lacks a key or has an unknown
/// one. Also when there are no views or too many, a view is impossible, or rectangles are empty or
/// overlap. Errors name the line and the view.
pub fn read_description<'a>(source: impl Into<Source<'a>>) -> Result<Description, ObjectFileError> {
    let source = source.into();
    parse_description(&read_text(source)?, source.name())
}

/// Parses the text of an object's file like [`read_description`]. `path` is used in errors and need
/// not exist.
///
/// # Errors
///
/// As [`read_description`], except for errors of reading.
pub fn parse_description(text: &str, path: &Path) -> Result<Description, ObjectFileError> {
    parse(text).map_err(|mistake| mistake.of(path, text))
}

/// Reads the views of a file, which is an object's or has only `kind` and `[[view]]`. Without
/// `kind` views are orthographic.
///
/// # Errors
///
/// As [`read_description`]. Whether a view is possible is not checked, since that depends on the
/// ball.
pub fn read_views<'a>(source: impl Into<Source<'a>>) -> Result<Vec<ViewSpec>, ObjectFileError> {
    let source = source.into();
    let text = read_text(source)?;
    let read = || -> Result<Vec<ViewSpec>, Mistake> {
        let root = checked(&text)?;
        let Views { kind, view } = Views::deserialize(Deserializer::from(root))?;
        let kind = kind.map_or(Ok(ViewKind::Orthographic), |kind| kind_of(&kind))?;
        let specs = each(&view, |table, _| spec_of(table, kind))?;
        Ok(specs)
    };
    read().map_err(|mistake| mistake.of(source.name(), &text))
}

impl Mistake {
    fn of(self, path: &Path, text: &str) -> ObjectFileError {
        match self {
            Mistake::Toml(mut source) => {
                source.set_input(Some(text));
                ObjectFileError::Toml { path: path.to_owned(), source }
            }
            Mistake::Problem { at, view, problem } => ObjectFileError::InFile {
                path: path.to_owned(),
                line: line_at(text, at),
                view,
                problem: Box::new(problem),
            },
        }
    }
}

/// Line of a byte position in a text, counted from 1.
fn line_at(text: &str, place: usize) -> usize {
    text[..place].matches('\n').count() + 1
}

fn read_text(source: Source<'_>) -> Result<String, ObjectFileError> {
    let read = || {
        if !source.is_file()? {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a file"));
        }
        let bytes = source.start(MAX_FILE_BYTES + 1)?;
        if bytes.len() as u64 > MAX_FILE_BYTES {
            return Err(io::Error::new(
                io::ErrorKind::FileTooLarge,
                "it is too long for an object: at most 1 MiB",
            ));
        }
        let no_text = || io::Error::new(io::ErrorKind::InvalidData, "it is not a text file, as objects are");
        decode_text(bytes).ok_or_else(no_text)
    };
    read().map_err(|error| ObjectFileError::Io { path: source.name().to_owned(), source: error })
}

/// Parses the text's table and checks that it has no unknown keys.
fn checked(text: &str) -> Result<Spanned<DeTable<'_>>, Mistake> {
    let root = DeTable::parse(text)?;
    check_keys(root.get_ref(), &KEYS, None)?;
    for (key, value) in root.get_ref() {
        match (key.get_ref().as_ref(), value.get_ref()) {
            ("view", DeValue::Array(views)) => {
                for (number, view) in views.iter().enumerate() {
                    if let DeValue::Table(table) = view.get_ref() {
                        check_keys(table, &VIEW_KEYS, Some(number + 1))?;
                    }
                }
            }
            ("measured", DeValue::Table(table)) => check_keys(table, &MEASURED_KEYS, None)?,
            _ => {}
        }
    }
    Ok(root)
}

fn check_keys(table: &DeTable, known: &[&str], view: Option<usize>) -> Result<(), Mistake> {
    match table.keys().find(|key| !known.contains(&key.get_ref().as_ref())) {
        None => Ok(()),
        Some(key) => {
            let unknown = UnknownName::new("key", key.get_ref(), known.iter().copied());
            Err(Mistake::Problem { at: key.span().start, view, problem: unknown.into() })
        }
    }
}

fn kind_of(kind: &Spanned<String>) -> Result<ViewKind, Mistake> {
    kind.get_ref().parse().map_err(|unknown: UnknownName| wrong(kind.span().start, unknown))
}

fn parse(text: &str) -> Result<Description, Mistake> {
    let table = Table::deserialize(Deserializer::from(checked(text)?))?;
    let kind = kind_of(&table.kind)?;
    let at = |span: Range<usize>| move |problem| wrong(span.start, problem);
    let centre = vector("centre", table.centre.get_ref()).map_err(at(table.centre.span()))?;
    let views = each(&table.view, |view, start| {
        let spec = spec_of(view, kind)?;
        let numbers = view.rect.as_ref().ok_or(ObjectFileProblem::Missing { key: "rect", kind })?;
        let rect: [u32; 4] = numbers.as_slice().try_into().map_err(|_| ObjectFileProblem::OtherLength {
            key: "rect",
            given: numbers.len(),
            must: 4,
        })?;
        let size = [rect[2], rect[3]];
        HeightMap::check_size(size[0], size[1])?;
        spec.view(centre, table.radius, size)?;
        Ok(ViewEntry { spec, rect, line: line_at(text, start) })
    })?;
    for (number, view) in views.iter().enumerate() {
        let rect = view.rect;
        if let Some(other) = views[..number].iter().position(|other| overlap(rect, other.rect)) {
            let problem = ObjectFileProblem::Overlap { rect, other: other + 1, with: views[other].rect };
            return Err(Mistake::Problem {
                at: table.view[number].span().start,
                view: Some(number + 1),
                problem,
            });
        }
    }
    let measured = match &table.measured {
        Some(measured) => Some(measured_of(measured.get_ref()).map_err(at(measured.span()))?),
        None => None,
    };
    let Table { radius, depth, color, normal, .. } = table;
    Ok(Description { kind, centre, radius, depth, color, normal, views, measured })
}

/// Converts each view. Their number must be possible for an object.
fn each<T>(
    views: &[Spanned<ViewTable>],
    of: impl Fn(&ViewTable, usize) -> Result<T, ObjectFileProblem>,
) -> Result<Vec<T>, Mistake> {
    if views.is_empty() || views.len() > MAX_VIEWS {
        let at = views.get(MAX_VIEWS).map_or(0, |view| view.span().start);
        return Err(wrong(at, ObjectFileProblem::BadCount(views.len())));
    }
    let numbered = views.iter().enumerate().map(|(number, view)| {
        let at = view.span().start;
        let of_view = |problem| Mistake::Problem { at, view: Some(number + 1), problem };
        of(view.get_ref(), at).map_err(of_view)
    });
    numbered.collect()
}

fn vector(key: &'static str, numbers: &[f64]) -> Result<DVec3, ObjectFileProblem> {
    let array: [f64; 3] = numbers.try_into().map_err(|_| ObjectFileProblem::OtherLength {
        key,
        given: numbers.len(),
        must: 3,
    })?;
    Ok(array.into())
}

fn spec_of(table: &ViewTable, kind: ViewKind) -> Result<ViewSpec, ObjectFileProblem> {
    let missing = |key| ObjectFileProblem::Missing { key, kind };
    let other = |key| Err(ObjectFileProblem::OtherKind { key, kind });
    let up = table.up.as_ref().map(|up| vector("up", up)).transpose()?;
    match kind {
        ViewKind::Orthographic if table.eye.is_some() => other("eye"),
        ViewKind::Orthographic if table.fov.is_some() => other("fov"),
        ViewKind::Perspective if table.from.is_some() => other("from"),
        ViewKind::Orthographic => {
            let from = vector("from", table.from.as_ref().ok_or(missing("from"))?)?;
            Ok(ViewSpec::Orthographic { from, up })
        }
        ViewKind::Perspective => {
            let eye = vector("eye", table.eye.as_ref().ok_or(missing("eye"))?)?;
            let fov_degrees = table.fov.ok_or(missing("fov"))?;
            Ok(ViewSpec::Perspective { eye, up, fov_degrees })
        }
    }
}

/// Whether two rectangles share a texel.
fn overlap(a: [u32; 4], b: [u32; 4]) -> bool {
    let along = |axis: usize| {
        let [from, to] = [a, b].map(|rect| u64::from(rect[axis]));
        let [len, other] = [a, b].map(|rect| u64::from(rect[axis + 2]));
        from < to + other && to < from + len
    };
    along(0) && along(1)
}

fn measured_of(table: &MeasuredTable) -> Result<Measured, ObjectFileProblem> {
    let part = |key: &'static str, value: f64| match (0.0..=1.0).contains(&value) {
        true => Ok(value),
        false => Err(ObjectFileProblem::Measured { key, value, must: "from 0 to 1" }),
    };
    let error = |key: &'static str, value: Option<f64>| match value {
        Some(value) if !(value.is_finite() && value >= 0.0) => {
            Err(ObjectFileProblem::Measured { key, value, must: "finite and not negative" })
        }
        other => Ok(other),
    };
    let cells: JumpCells = table.cells.parse()?;
    if table.jump.is_nan() || table.jump < 0.0 {
        return Err(ObjectFileProblem::Measured { key: "jump", value: table.jump, must: "0 or more" });
    }
    Ok(Measured {
        views: table.views,
        size: table.size,
        cells,
        jump_texels: table.jump,
        iou: part("iou", table.iou)?,
        depth_error_percent: error("depth-error", table.depth_error)?,
        worst_from: vector("worst-from", &table.worst_from)?,
        worst_iou: part("worst-iou", table.worst_iou)?,
        worst_depth_error_percent: error("worst-depth-error", table.worst_depth_error)?,
    })
}
