//! `relief scene`: writes a scene file of `relief render`'s flags, with every key, or a schema for
//! editors.

use std::io::Write;
use std::ops::Bound;
use std::path::{Path, PathBuf, absolute};

use clap::Args;
use relief_io::write_atomically;
use relief_scene::background::Background;
use relief_scene::{Form, Key, KeyNumber, SceneSpec, keys, parse_scene, viewer_keys};
use relief_shaders::{STAGES, Stage};
use serde_json::{Map, Value, json};

use super::numbered::files;
use super::scene_arguments::{MachineArguments, SceneArguments};
use super::staged::format_of;
use crate::failure::Failure;
use crate::streams::{Files, answer, tell_written};

/// Arguments of `relief scene`.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief scene --height wall.png --method cone -o wall.toml\n  \
    relief scene wall.toml --samples 16        # the same with one key changed, on standard output\n  \
    relief scene --schema > relief-scene.schema.json")]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    machine: MachineArguments,
    /// Scene file to write [default: standard output]
    #[arg(short, long, value_name = "FILE.toml", conflicts_with = "schema")]
    output: Option<PathBuf>,
    /// Print the JSON schema of scene files, with which editors complete and check them
    #[arg(long)]
    schema: bool,
}

impl Arguments {
    /// Returns the file that may be standard input: a scene file names its maps, which a stream
    /// does not.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.scene.file_mut().into_iter().collect(), ..Files::default() }
    }
}

/// Writes the scene file, or the schema.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.schema {
        return answer(|out| Ok(writeln!(out, "{:#}", schema())?));
    }
    let mut spec = arguments.machine.over(arguments.scene.spec()?);
    let Some(path) = arguments.output.as_ref().filter(|path| path.as_os_str() != "-") else {
        return answer(|out| Ok(out.write_all(spec.to_toml().as_bytes())?));
    };
    let read = files(&spec);
    let inputs: Vec<&Path> = read.iter().map(AsRef::as_ref).collect();
    format_of("--output", path, &[("toml", ())], &inputs)?;
    // Paths in a scene file start at its folder, paths of flags at the current folder.
    if path.parent().is_some_and(|folder| !folder.as_os_str().is_empty()) {
        make_absolute(&mut spec)?;
    }
    let text = spec.to_toml();
    // What is written must be readable.
    parse_scene(&text, path).map_err(Failure::work)?;
    write_atomically(path, |file| file.write_all(text.as_bytes())).map_err(Failure::work)?;
    tell_written(false, |out| Ok(writeln!(out, "{}", path.display())?))
}

/// Makes all paths absolute, so that the scene can be read from anywhere.
pub fn make_absolute(spec: &mut SceneSpec) -> Result<(), Failure> {
    for file in spec.files_mut() {
        *file = absolute(&*file).map_err(|error| Failure::Work(format!("{}: {error}", file.display())))?;
    }
    Ok(())
}

/// The JSON schema of scene files (draft 2020-12).
fn schema() -> Value {
    let all = keys();
    let of_surface: Map<String, Value> =
        all.iter().filter(|key| key.of_surface).map(|key| (key.name.to_owned(), of_key(key))).collect();
    let mut properties: Map<String, Value> =
        all.iter().map(|key| (key.name.to_owned(), of_key(key))).collect();
    let mut own = of_surface;
    own.insert(
        "size".to_owned(),
        json!({ "type": "number", "description": "older name of mesh-scale", "deprecated": true }),
    );
    properties.insert(
        "surfaces".to_owned(),
        json!({
            "type": "array", "description": "several surfaces; keys that one leaves out are those above them",
            "items": { "type": "object", "properties": own, "additionalProperties": false },
        }),
    );
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A scene of relief", "type": "object",
        "properties": properties, "additionalProperties": false,
    })
}

fn of_key(key: &Key) -> Value {
    let numbers = |kind: &str, count: usize| list(json!({ "type": kind }), count);
    let length = || json!({ "type": ["number", "string"] });
    let direction = || json!({ "oneOf": [numbers("number", 3), { "type": "string" }] });
    let colour = || numbers("number", 3);
    let mut schema = match &key.form {
        Form::Text | Form::File | Form::Folder => json!({ "type": "string" }),
        Form::Name(names) => json!({ "type": "string", "enum": names }),
        Form::Mesh(names) | Form::Ramp(names) => json!({ "type": "string", "examples": names }),
        Form::Flag => json!({ "type": "boolean" }),
        Form::Number => json!({ "type": "number" }),
        Form::Whole => json!({ "type": "integer" }),
        Form::Numbers(count) => numbers("number", *count),
        Form::Length => length(),
        Form::Lengths(count) => list(length(), *count),
        Form::Direction => direction(),
        Form::Background => json!({ "oneOf": [colour(), { "enum": Background::NAMES }] }),
        Form::Wholes(count) => numbers("integer", *count),
        Form::Size => json!({ "oneOf": [numbers("integer", 2), { "const": "map" }] }),
        Form::Range => json!({ "oneOf": [numbers("number", 2), { "const": "auto" }] }),
        Form::Memory => json!({ "type": ["integer", "string"] }),
        Form::Settings => json!({
            "type": "object", "properties": settings(),
            "additionalProperties": {
                "type": "object", "additionalProperties": { "type": ["number", "string"] },
            },
        }),
        Form::Material => json!({
            "type": "object", "additionalProperties": false,
            "properties": {
                "diffuse": colour(), "specular": colour(), "shininess": { "type": "integer" },
                "base": colour(), "roughness": { "type": "number" }, "metallic": { "type": "number" },
                "emission": colour(),
            },
        }),
        Form::Viewer => {
            let values = viewer_keys().into_iter().map(|key| {
                let name = key.name.trim_start_matches("viewer.").to_owned();
                (name, of_key(&key))
            });
            let values: Map<String, Value> = values.collect();
            json!({ "type": "object", "properties": values, "additionalProperties": false })
        }
        Form::Lights => json!({
            "type": "array",
            "items": {
                "type": "object", "additionalProperties": false,
                "properties": {
                    "direction": direction(), "position": list(length(), 3), "color": colour(),
                    "intensity": { "type": "number" }, "angle": { "type": "number" }, "radius": length(),
                },
            },
        }),
    };
    if let Some(number) = key.number {
        bound(&mut schema, &number);
    }
    schema["description"] = key.about.into();
    schema
}

/// A list of `count` items.
fn list(item: Value, count: usize) -> Value {
    json!({ "type": "array", "items": item, "minItems": count, "maxItems": count })
}

/// The settings of all variants, stage by stage.
fn settings() -> Map<String, Value> {
    let of_stage = |stage: &Stage| {
        let mut params: Map<String, Value> = Map::new();
        for param in stage.entries.iter().flat_map(|entry| entry.params) {
            let (min, max) = (f64::from(param.min), f64::from(param.max));
            let unit = if param.unit.is_empty() { String::new() } else { format!(", in {}", param.unit) };
            let known = params.entry(param.name).or_insert_with(|| {
                let kind = if param.integer { "integer" } else { "number" };
                let of = if param.names.is_empty() { json!(kind) } else { json!([kind, "string"]) };
                json!({
                    "type": of, "minimum": min, "maximum": max,
                    "description": format!("{}{unit}", param.summary),
                })
            });
            // Variants that share a name may differ in its range.
            let wider =
                |known: &Value, own: f64, pick: fn(f64, f64) -> f64| pick(known.as_f64().unwrap_or(own), own);
            known["minimum"] = wider(&known["minimum"], min, f64::min).into();
            known["maximum"] = wider(&known["maximum"], max, f64::max).into();
        }
        json!({
            "type": "object", "properties": params, "additionalProperties": { "type": ["number", "string"] },
        })
    };
    STAGES.iter().map(|stage| (stage.key.to_owned(), of_stage(stage))).collect()
}

/// Puts the bounds of numbers where a schema has numbers.
fn bound(schema: &mut Value, number: &KeyNumber) {
    let has_numbers = match &schema["type"] {
        Value::Array(types) => types.iter().any(|of| of == "number"),
        of => of == "number" || of == "integer",
    };
    if has_numbers {
        let (least, greatest) = number.range;
        let ends = [(least, "minimum", "exclusiveMinimum"), (greatest, "maximum", "exclusiveMaximum")];
        for (bound, included, excluded) in ends {
            match bound {
                Bound::Included(at) => schema[included] = at.into(),
                Bound::Excluded(at) => schema[excluded] = at.into(),
                Bound::Unbounded => {}
            }
        }
        return;
    }
    for part in ["items", "oneOf"] {
        match schema.get_mut(part) {
            Some(Value::Array(each)) => each.iter_mut().for_each(|of| bound(of, number)),
            Some(of) => bound(of, number),
            None => {}
        }
    }
}
