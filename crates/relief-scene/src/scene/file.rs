//! Scene files in TOML.
//!
//! Keys of a scene and of its surfaces stand side by side, so a scene of one surface is a plain
//! list. A surface's key there holds for every element of `[[surfaces]]`.

use super::keys::keys_of;
use super::{MaterialSpec, SceneError, SceneSpec, SurfaceSpec};
use relief_core::registry::UnknownName;
use relief_io::{Source, decode_text};
use relief_shaders::{AMBIENT, STAGES};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::io;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

/// Longest scene file that is read, in bytes. Scenes are short; a longer file is something else.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// Key of the list of surfaces.
const SURFACES: &str = "surfaces";

/// Key of the ambient light's colour.
const AMBIENT_COLOR: &str = "ambient-color";

/// Reads a scene file and checks everything that needs no other file. Relative paths in it start at
/// its folder.
///
/// # Errors
///
/// When the file cannot be read, is longer than 1 MiB, is not TOML, has an unknown key, or has a
/// value that cannot be used. Errors in the file state their line.
pub fn read_scene<'a>(source: impl Into<Source<'a>>) -> Result<SceneSpec, SceneError> {
    let source = source.into();
    let path = source.name();
    let text = read_text(source).map_err(|source| SceneError::Io { path: path.to_owned(), source })?;
    parse_scene(&text, path)
}

/// Reads a scene from the text of a scene file, like [`read_scene`]. `path` is the file's path, for
/// relative paths and for errors. The file need not exist.
///
/// # Errors
///
/// When the text is not TOML, has an unknown key, or has a value that cannot be used.
pub fn parse_scene(text: &str, path: &Path) -> Result<SceneSpec, SceneError> {
    let spec = parse_values(text, path)?;
    spec.check().map_err(|source| {
        let line = line_of(text, source.surface, source.key);
        SceneError::InFile { path: path.to_owned(), line, source }
    })?;
    Ok(spec)
}

/// Reads values from the text of a scene file, like [`parse_scene`], to be laid over a scene by
/// [`SceneSpec::overridden_by`]. What they need or exclude is not checked: see [`SceneSpec::check`].
///
/// # Errors
///
/// When the text is not TOML, has an unknown key, or has a value of another type.
pub fn parse_values(text: &str, path: &Path) -> Result<SceneSpec, SceneError> {
    let mut spec = parse(text).map_err(|error| match error {
        ParseError::Toml(mut source) => {
            source.set_input(Some(text));
            SceneError::Toml { path: path.to_owned(), source }
        }
        ParseError::Key { what, at } => {
            SceneError::Key { path: path.to_owned(), line: line_at(text, at.start), what }
        }
    })?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for file in spec.files_mut() {
        *file = folder.join(&*file);
    }
    Ok(spec)
}

fn read_text(source: Source<'_>) -> io::Result<String> {
    let bytes = source.start(MAX_FILE_BYTES + 1)?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        let what = "it is longer than 1 MiB, so it is no scene file";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, what));
    }
    decode_text(bytes).ok_or_else(|| {
        let what = "it holds no text, so it is no scene file";
        io::Error::new(io::ErrorKind::InvalidData, what)
    })
}

/// Error in the text of a scene file.
enum ParseError {
    Toml(Box<toml::de::Error>),
    Key { what: String, at: Range<usize> },
}

impl From<toml::de::Error> for ParseError {
    fn from(error: toml::de::Error) -> Self {
        ParseError::Toml(Box::new(error))
    }
}

fn parse(text: &str) -> Result<SceneSpec, ParseError> {
    let root = DeTable::parse(text)?;
    let span = root.span();
    let mut root = root.into_inner();
    let surfaces = root.remove(SURFACES);
    color_of_ambient(&mut root)?;
    let of_surface = |key: &str| key != "size" && keys_of::<SurfaceSpec>().contains(&key);
    let of_scene = |key: &str| keys_of::<SceneSpec>().contains(&key);
    check_keys(&root, |key| of_surface(key) || of_scene(key), &[keys_of::<SceneSpec>(), &[SURFACES]])?;
    let (own, rest): (DeTable, DeTable) =
        root.into_iter().partition(|(key, _)| of_scene(key.get_ref().as_ref()));
    let mut spec = SceneSpec::deserialize(Deserializer::from(Spanned::new(span.clone(), own)))?;
    spec.surface = surface_of(Spanned::new(span, rest))?;
    if let Some(surfaces) = surfaces {
        spec.surfaces = each_of(surfaces)?;
    }
    Ok(spec)
}

/// Keys by which surfaces use the environment map.
const ENVIRONMENT_KEYS: [&str; 2] = ["environment", "transmission"];

/// Moves numbers under the key of the stage `ambient` to the key of the ambient light's colour.
fn color_of_ambient(root: &mut DeTable) -> Result<(), ParseError> {
    let ambient = STAGES[AMBIENT].key;
    let is_color = |value: &Spanned<DeValue>| matches!(value.get_ref(), DeValue::Array(_));
    if !root.get(ambient).is_some_and(is_color) {
        return Ok(());
    }
    let Some((key, value)) = root.remove_entry(ambient) else { return Ok(()) };
    let at = key.span();
    if root.contains_key(AMBIENT_COLOR) {
        let what =
            format!("{ambient} and {AMBIENT_COLOR} both give the colour of the ambient light: leave one out");
        return Err(ParseError::Key { what, at });
    }
    // The light is constant, unless surfaces use the environment map.
    if !ENVIRONMENT_KEYS.iter().any(|key| root.contains_key(*key)) {
        let constant = DeValue::String(STAGES[AMBIENT].entries[0].name.into());
        root.insert(Spanned::new(at.clone(), ambient.into()), Spanned::new(at.clone(), constant));
    }
    root.insert(Spanned::new(at, AMBIENT_COLOR.into()), value);
    Ok(())
}

/// Returns the elements of `[[surfaces]]`.
fn each_of(surfaces: Spanned<DeValue>) -> Result<Vec<SurfaceSpec>, ParseError> {
    let span = surfaces.span();
    let DeValue::Array(elements) = surfaces.into_inner() else {
        return Err(no_list(span));
    };
    let each = elements.into_iter().map(|element| {
        let span = element.span();
        let DeValue::Table(table) = element.into_inner() else {
            return Err(no_list(span));
        };
        check_keys(&table, |key| keys_of::<SurfaceSpec>().contains(&key), &[])?;
        surface_of(Spanned::new(span, table))
    });
    each.collect()
}

fn no_list(at: Range<usize>) -> ParseError {
    ParseError::Key { what: format!("{SURFACES} must be tables: write [[{SURFACES}]] before each"), at }
}

/// Refuses keys that are neither known nor a stage's.
fn check_keys(table: &DeTable, known: impl Fn(&str) -> bool, others: &[&[&str]]) -> Result<(), ParseError> {
    for (key, value) in table {
        let name = key.get_ref().as_ref();
        let is_value = !matches!(value.get_ref(), DeValue::String(_));
        // The base of a block is a length.
        let is_map = keys_of::<SurfaceSpec>().contains(&name) && name != "base";
        if is_value && is_map && MaterialSpec::PARTS.contains(&name) {
            let what = format!(
                "{name} names the file of a map; a value is part of the material, as in material = {{ {name} \
                 = {} }}",
                if name == "emission" { "[1, 1, 1]" } else { "0.5" }
            );
            return Err(ParseError::Key { what, at: key.span() });
        }
        if !known(name) && !is_stage(name) {
            let stages = STAGES.iter().filter(|stage| stage.has_key()).map(|stage| stage.key);
            let keys = keys_of::<SurfaceSpec>().iter().chain(others.iter().copied().flatten()).copied();
            let what = UnknownName::new("key", name, keys.chain(stages)).to_string();
            return Err(ParseError::Key { what, at: key.span() });
        }
    }
    Ok(())
}

/// Returns whether the value of a key is the variant of a stage.
fn is_stage(key: &str) -> bool {
    relief_shaders::stage(key).is_some_and(|(_, stage)| stage.has_key())
}

/// Returns the surface that a table describes. Keys of stages hold names of variants.
fn surface_of(table: Spanned<DeTable>) -> Result<SurfaceSpec, ParseError> {
    let span = table.span();
    let (stages, rest): (DeTable, DeTable) =
        table.into_inner().into_iter().partition(|(key, _)| is_stage(key.get_ref().as_ref()));
    let mut surface = SurfaceSpec::deserialize(Deserializer::from(Spanned::new(span.clone(), rest)))?;
    surface.stages = BTreeMap::deserialize(Deserializer::from(Spanned::new(span, stages)))?;
    Ok(surface)
}

/// Returns the line, counted from 1, of a byte of a text.
fn line_at(text: &str, place: usize) -> usize {
    text[..place].matches('\n').count() + 1
}

/// Returns the line of a key's value, of a surface or of the scene itself.
fn line_of(text: &str, surface: Option<usize>, key: &str) -> usize {
    let Ok(root) = DeTable::parse(text) else { return 1 };
    let is_key = |name: &str| name == key || (key == AMBIENT_COLOR && name == STAGES[AMBIENT].key);
    let find = |table: &DeTable, is_key: &dyn Fn(&str) -> bool| {
        let found = table.iter().find(|(name, _)| is_key(name.get_ref().as_ref()));
        found.map(|(name, _)| name.span().start)
    };
    let place = |table: &DeTable| find(table, &is_key);
    // The key's older name, which in the scene itself is the picture's size.
    let older = |table: &DeTable| find(table, &|name| key == "mesh-scale" && name == "size");
    let of_surface = || {
        let DeValue::Array(surfaces) = root.get_ref().get(SURFACES)?.get_ref() else { return None };
        let element = surfaces.get(surface?)?;
        let DeValue::Table(table) = element.get_ref() else { return None };
        // A value that the surface lacks is the scene's, or missing.
        place(table).or_else(|| older(table)).or_else(|| place(root.get_ref())).or(Some(element.span().start))
    };
    let start = of_surface().or_else(|| place(root.get_ref()));
    line_at(text, start.unwrap_or(0))
}
