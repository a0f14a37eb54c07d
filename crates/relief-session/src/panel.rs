//! Controls for every key and every setting, made of the lists of the libraries.

use relief_scene::{Form, Key, KeyGroup, SceneSpec, Shown, keys, viewer_keys};
use relief_shaders::{METHODS, STAGES, Selection};
use serde::Serialize;

use crate::document::{values, with};

/// The controls of a document.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Panel {
    /// Controls of camera, light and picture.
    pub scene: Vec<Control>,
    /// Controls of each surface.
    pub surfaces: Vec<Vec<Control>>,
}

/// A control for a key.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Control {
    /// Key, as actions name it.
    pub key: String,
    /// Name in words.
    pub label: String,
    /// What it means, in one line.
    pub about: String,
    /// Title of the group that it is shown in.
    pub group: &'static str,
    /// What its values are.
    pub kind: Kind,
    /// Whether it takes a file or a folder.
    pub is_file: bool,
    /// Unit of its numbers; empty for plain ones.
    pub unit: String,
    /// Whether a number may be a text with its unit, such as `5cm`.
    pub takes_unit: bool,
    /// Least number that is accepted, or that is not accepted just below; none if there is none.
    pub min: Option<f64>,
    /// Greatest number, in the same way.
    pub max: Option<f64>,
    /// A small change that is seen.
    pub step: Option<f64>,
    /// Default, as a scene file writes it; none if other values decide it.
    pub default: Option<String>,
    /// Value, as a scene file writes it; none if the default holds.
    pub value: Option<String>,
    /// Names to choose from.
    pub choices: Vec<Choice>,
}

/// What the values of a control are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A text, or the name of a file or a folder.
    Text,
    /// One of the choices.
    Name,
    /// One of the choices, or a file's name.
    NameOrFile,
    /// True or false.
    Flag,
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// This many numbers.
    Numbers(usize),
    /// A value that a scene file writes in its own way, such as a list of lights.
    Other,
}

/// A name to choose from.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Choice {
    /// Name, without quotation marks.
    pub name: String,
    /// What it is, in one line; empty where the name says it.
    pub about: String,
    /// Why it is not to be had with the other values; none if it is.
    pub refused: Option<String>,
}

impl Panel {
    pub(crate) fn of(spec: &SceneSpec) -> Self {
        let is_table = |key: &Key| key.form == Form::Viewer;
        let mut keys: Vec<Key> =
            keys().into_iter().filter(|key| !is_table(key)).chain(viewer_keys()).collect();
        keys.sort_by_key(|key| (key.group as usize, key.rank));
        let (of_surface, of_scene): (Vec<Key>, Vec<Key>) = keys.into_iter().partition(|key| key.of_surface);
        let values = values(spec);
        let control = |key: &Key, before: &str| {
            let name = format!("{before}{}", key.name);
            let value = values.get(&name).or_else(|| values.get(key.name).filter(|_| key.of_surface));
            let mut control = Control::of(key, name, value.cloned());
            control.refuse(spec);
            control
        };
        let selections = spec.selections().unwrap_or_default();
        let surface = |number: usize| {
            let before = match spec.surfaces.is_empty() {
                true => String::new(),
                false => format!("surfaces[{number}]."),
            };
            let controls = |key: &Key| match (&key.form, selections.get(number)) {
                (Form::Settings, Some(selection)) => settings(selection, &before, &values),
                (Form::Settings, None) => Vec::new(),
                _ => vec![control(key, &before)],
            };
            of_surface.iter().flat_map(controls).collect()
        };
        Self {
            scene: of_scene.iter().map(|key| control(key, "")).collect(),
            surfaces: (0..spec.surfaces.len().max(1)).map(surface).collect(),
        }
    }
}

impl Control {
    fn of(key: &Key, name: String, value: Option<String>) -> Self {
        let (kind, names) = match &key.form {
            Form::Text | Form::File | Form::Folder => (Kind::Text, &[][..]),
            Form::Name(names) => (Kind::Name, &names[..]),
            Form::Mesh(names) | Form::Ramp(names) => (Kind::NameOrFile, &names[..]),
            Form::Flag => (Kind::Flag, &[][..]),
            Form::Number | Form::Length => (Kind::Number, &[][..]),
            Form::Whole => (Kind::Whole, &[][..]),
            Form::Numbers(count) | Form::Lengths(count) | Form::Wholes(count) => {
                (Kind::Numbers(*count), &[][..])
            }
            Form::Size | Form::Range => (Kind::Numbers(2), &[][..]),
            Form::Direction => (Kind::Numbers(3), &[][..]),
            Form::Background
            | Form::Memory
            | Form::Settings
            | Form::Material
            | Form::Lights
            | Form::Viewer => (Kind::Other, &[][..]),
        };
        let choice = |name: &&str| Choice {
            name: (*name).to_owned(),
            about: about(key.name, name).to_owned(),
            refused: None,
        };
        let (min, max) = key.number.map_or((None, None), |number| {
            let (least, greatest) = number.range;
            (end(least), end(greatest))
        });
        Self {
            key: name,
            label: label_of(key.name),
            about: key.about.to_owned(),
            group: key.group.name(),
            kind,
            is_file: matches!(key.form, Form::File | Form::Folder) || kind == Kind::NameOrFile,
            unit: key.number.map_or(String::new(), |number| number.unit.to_owned()),
            takes_unit: matches!(key.form, Form::Length | Form::Lengths(_)),
            min,
            max,
            step: key.number.map(|number| number.step),
            default: Some(key.default).filter(|default| !default.is_empty()).map(str::to_owned),
            value,
            choices: names.iter().map(choice).collect(),
        }
    }

    /// Says of each name why it is not to be had.
    fn refuse(&mut self, spec: &SceneSpec) {
        if self.kind != Kind::Name {
            return;
        }
        for choice in &mut self.choices {
            let refused = with(spec, &self.key, &format!("{:?}", choice.name)).err();
            // A second view may be of a method that does not go with the scene: it says so where it is shown.
            let second = || spec.by_method(&choice.name).selections().err().map(|error| error.to_string());
            let shown = || spec.why_not_shown(choice.name.parse().ok()?).map(str::to_owned);
            choice.refused = match self.key.as_str() {
                "viewer.second" => second(),
                "viewer.show" | "viewer.second-show" => shown(),
                _ => refused.map(|refused| refused.to_string()),
            };
        }
    }
}

/// The settings of the chosen variants.
fn settings(
    selection: &Selection,
    before: &str,
    values: &std::collections::BTreeMap<String, String>,
) -> Vec<Control> {
    let mut controls = Vec::new();
    for (place, stage) in STAGES.iter().enumerate().filter(|(place, _)| selection.uses(*place)) {
        let choice = &selection.choices[place];
        for param in choice.entry.params {
            let setting = format!("{}.{}", stage.key, param.name);
            let own = format!("{before}set.{setting}");
            let value = values.get(&own).or_else(|| values.get(&format!("set.{setting}")));
            let names = param.names.iter().map(|name| Choice {
                name: (*name).to_owned(),
                about: String::new(),
                refused: None,
            });
            controls.push(Control {
                key: own,
                label: label_of(&setting),
                about: param.summary.to_owned(),
                group: KeyGroup::Method.name(),
                is_file: false,
                kind: match (param.names.is_empty(), param.integer) {
                    (false, _) => Kind::Name,
                    (true, true) => Kind::Whole,
                    (true, false) => Kind::Number,
                },
                unit: param.unit.to_owned(),
                takes_unit: false,
                min: Some(f64::from(param.min)),
                max: Some(f64::from(param.max)),
                step: Some(if param.integer { 1.0 } else { small(param.default) }),
                default: Some(format!("{:?}", param.default)),
                value: value.cloned(),
                choices: names.collect(),
            });
        }
    }
    controls
}

/// A tenth of a number, or of 1.
fn small(number: f32) -> f64 {
    let size = f64::from(number.abs());
    if size > 0.0 { 0.1 * size } else { 0.1 }
}

/// What a name of a key's list stands for.
fn about(key: &str, name: &str) -> &'static str {
    if key.starts_with("viewer.")
        && let Ok(shown) = name.parse::<Shown>()
    {
        return shown.about();
    }
    if ["method", "viewer.second"].contains(&key) {
        return METHODS.iter().find(|method| method.name == name).map_or("", |method| method.summary);
    }
    let stage = STAGES.iter().find(|stage| stage.key == key);
    let entry = stage.and_then(|stage| stage.entries.iter().find(|entry| entry.name == name));
    entry.map_or("", |entry| entry.summary)
}

fn end(bound: std::ops::Bound<f64>) -> Option<f64> {
    match bound {
        std::ops::Bound::Included(at) | std::ops::Bound::Excluded(at) => Some(at),
        std::ops::Bound::Unbounded => None,
    }
}

/// Returns the label of the control for a key, as actions name it: `Mesh scale` for `surfaces[1].mesh-scale`,
/// `Search: steps` for `set.search.steps`.
pub fn label_of(key: &str) -> String {
    let own =
        key.strip_prefix("surfaces[").and_then(|rest| rest.split_once("].")).map_or(key, |(_, own)| own);
    let setting = own.strip_prefix("set.").unwrap_or(own).split_once('.');
    match setting.filter(|(stage, _)| STAGES.iter().any(|known| known.key == *stage)) {
        Some((stage, name)) => format!("{}: {}", words(stage), words(name).to_lowercase()),
        None => words(own),
    }
}

/// A key in words: `mesh-scale` is `Mesh scale`, and `viewer.show` is `Show`.
fn words(key: &str) -> String {
    let text = key.rsplit('.').next().unwrap_or(key).replace('-', " ");
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
