//! The document: a scene file whose keys get values and lose them.

use std::collections::BTreeMap;
use std::path::Path;

use relief_scene::{SceneError, SceneSpec, SurfaceSpec, parse_values};
use relief_shaders::{REFINE, SEARCH, STAGES};
use toml::{Table, Value};

use crate::Refused;

/// The list of surfaces in a file.
pub const SURFACES: &str = "surfaces";

/// Tables of values whose members are keys of their own here.
const TABLES: [&str; 3] = ["set", "material", "viewer"];

/// The file's path, for messages: paths in the document stay as they are.
const NAME: &str = "";

/// Where a key stands: in the scene itself or in a surface.
struct Place<'a> {
    surface: Option<usize>,
    key: &'a str,
}

impl<'a> Place<'a> {
    fn of(key: &'a str, spec: &SceneSpec) -> Result<Self, Refused> {
        let refused = || Refused::Key(key.to_owned());
        let (surface, own) = match key.strip_prefix("surfaces[") {
            Some(rest) => {
                let (number, own) = rest.split_once("].").ok_or_else(refused)?;
                (Some(number.parse().map_err(|_| refused())?), own)
            }
            None => (None, key),
        };
        if !is_key(own) || own == SURFACES {
            return Err(refused());
        }
        let first = own.split('.').next().unwrap_or_default();
        if first != own && STAGES.iter().any(|stage| stage.key == first) {
            return Err(Refused::Value(format!("{own} is a setting: write it as set.{own}")));
        }
        // The only surface may be called by its number.
        let surface = surface.filter(|number| !(spec.surfaces.is_empty() && *number == 0));
        Ok(Self { surface, key: own })
    }
}

/// Whether a text can be a key within the scene or a surface.
pub fn is_key(text: &str) -> bool {
    let is_word = |word: &str| {
        !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
    };
    text.split('.').all(is_word)
}

/// Reads a scene from text and checks all that needs no file.
pub fn read(text: &str) -> Result<SceneSpec, Refused> {
    checked(parse_values(text, Path::new(NAME)).map_err(refused)?)
}

/// Refuses a scene whose values do not go together.
pub fn checked(spec: SceneSpec) -> Result<SceneSpec, Refused> {
    spec.check().map_err(|error| Refused::Value(error.to_string()))?;
    Ok(spec)
}

fn refused(error: SceneError) -> Refused {
    let said = match error {
        // The document has no lines that a user knows.
        SceneError::Toml { source, .. } => source.message().to_owned(),
        SceneError::Key { what, .. } => what,
        other => other.to_string(),
    };
    Refused::Value(said)
}

/// The scene in which a key has a value. Values that belong to another one are dropped, as flags drop them.
pub fn with(spec: &SceneSpec, key: &str, value: &str) -> Result<SceneSpec, Refused> {
    let place = Place::of(key, spec)?;
    let is_one =
        |value: &str| format!("value = {value}").parse::<Table>().is_ok_and(|table| table.len() == 1);
    let quoted = Value::String(value.to_owned()).to_string();
    let value = match (is_one(value), is_plain(value)) {
        (true, _) => value,
        (false, true) => quoted.as_str(),
        (false, false) => return Err(Refused::NotOne(value.to_owned())),
    };
    let refused = |error: SceneError| match refused(error) {
        // The reader of values knows no key.
        Refused::Value(said) if !said.contains(place.key) => Refused::Value(format!("{}: {said}", place.key)),
        other => other,
    };
    let mut line = format!("{} = {value}\n", place.key);
    // Search and refinement are chosen as a pair: the other one stays as it is.
    let pair = [STAGES[SEARCH].key, STAGES[REFINE].key];
    if pair.contains(&place.key) {
        let number = place.surface.unwrap_or_default();
        let chosen = spec.selections().ok().and_then(|each| each.get(number).copied());
        let stage = if place.key == pair[0] { REFINE } else { SEARCH };
        if let Some(chosen) = chosen {
            line += &format!("{} = {:?}\n", STAGES[stage].key, chosen.choices[stage].entry.name);
        }
    }
    let Some(number) = place.surface else {
        let over = parse_values(&line, Path::new(NAME)).map_err(refused)?;
        if spec.surfaces.is_empty() {
            return checked(spec.clone().overridden_by(over));
        }
        // With several surfaces a key of the file itself stays common: it replaces no surface's own.
        let common = spec.surface.clone().overridden_by(over.surface.clone());
        let of_scene = SceneSpec { surface: SurfaceSpec::default(), ..over };
        return checked(SceneSpec { surface: common, ..spec.clone().overridden_by(of_scene) });
    };
    let count = spec.surfaces.len().max(1);
    let mut new = spec.clone();
    let surface = new.surfaces.get_mut(number).ok_or(Refused::NoSurface { number, count })?;
    let over = parse_values(&format!("[[{SURFACES}]]\n{line}"), Path::new(NAME)).map_err(refused)?;
    for over in over.surfaces {
        *surface = surface.clone().overridden_by(over);
    }
    checked(new)
}

/// Whether a value is a text that needs no quotation marks to be told from others.
pub fn is_plain(value: &str) -> bool {
    !value.is_empty() && !value.contains(|c: char| c.is_control() || "\"'=#[]{},".contains(c))
}

/// The scene in which a key has no value; none if it has none already.
pub fn without(spec: &SceneSpec, key: &str) -> Result<Option<SceneSpec>, Refused> {
    let place = Place::of(key, spec)?;
    let mut document = table_of(spec);
    let table = match place.surface {
        None => &mut document,
        Some(number) => {
            let surfaces = document.get_mut(SURFACES).and_then(Value::as_array_mut);
            let count = spec.surfaces.len().max(1);
            let found = surfaces.and_then(|surfaces| surfaces.get_mut(number)).and_then(Value::as_table_mut);
            found.ok_or(Refused::NoSurface { number, count })?
        }
    };
    let words: Vec<&str> = place.key.split('.').collect();
    if !remove(table, &words) {
        // An unknown key is refused as the reader of files refuses it.
        if !relief_scene::keys().iter().any(|key| key.name == words[0]) {
            parse_values(&format!("{} = 0\n", words[0]), Path::new(NAME)).map_err(refused)?;
        }
        return Ok(None);
    }
    // Search and refinement came as a pair, so they go as one.
    let pair = [STAGES[SEARCH].key, STAGES[REFINE].key];
    if pair.contains(&place.key) {
        let table = match place.surface {
            None => Some(&mut document),
            Some(number) => document.get_mut(SURFACES).and_then(|all| all.get_mut(number)?.as_table_mut()),
        };
        if let Some(table) = table {
            pair.iter().for_each(|key| drop(table.remove(*key)));
        }
    }
    read(&document.to_string()).map(Some)
}

/// Removes a value, and the tables that are empty without it.
fn remove(table: &mut Table, words: &[&str]) -> bool {
    match words {
        [] => false,
        [word] => table.remove(*word).is_some(),
        [word, rest @ ..] => {
            let Some(inner) = table.get_mut(*word).and_then(Value::as_table_mut) else { return false };
            let is_removed = remove(inner, rest);
            if inner.is_empty() {
                table.remove(*word);
            }
            is_removed
        }
    }
}

fn table_of(spec: &SceneSpec) -> Table {
    // What a scene writes, a scene reads: a test of scenes holds it.
    spec.to_toml().parse().unwrap_or_default()
}

/// All values by their keys, as actions name them.
pub fn values(spec: &SceneSpec) -> BTreeMap<String, String> {
    let mut values = BTreeMap::new();
    let mut document = table_of(spec);
    let surfaces = document.remove(SURFACES);
    flatten(&document, "", &mut values);
    for (number, surface) in surfaces.iter().filter_map(Value::as_array).flatten().enumerate() {
        if let Some(table) = surface.as_table() {
            flatten(table, &format!("{SURFACES}[{number}]."), &mut values);
        }
    }
    values
}

fn flatten(table: &Table, before: &str, values: &mut BTreeMap<String, String>) {
    for (key, value) in table {
        let name = format!("{before}{key}");
        let is_table = TABLES.contains(&key.as_str()) || before.ends_with("set.");
        match value.as_table().filter(|_| is_table) {
            Some(inner) => flatten(inner, &format!("{name}."), values),
            None => drop(values.insert(name, value.to_string())),
        }
    }
}

/// The keys whose values differ.
pub fn differing(before: &SceneSpec, after: &SceneSpec) -> Vec<String> {
    let [before, after] = [before, after].map(|spec| {
        let mut all = values(spec);
        all.extend(count_of(spec));
        all
    });
    let differs = |key: &&String| before.get(*key) != after.get(*key);
    let mut keys: Vec<String> = before.keys().chain(after.keys()).filter(differs).cloned().collect();
    keys.sort();
    keys.dedup();
    keys
}

/// The key that stands for the number of surfaces.
fn count_of(spec: &SceneSpec) -> Option<(String, String)> {
    (!spec.surfaces.is_empty()).then(|| (SURFACES.to_owned(), spec.surfaces.len().to_string()))
}
