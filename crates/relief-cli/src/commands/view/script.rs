//! Changes a scene by a script of actions, and draws it.

use std::io::Write;
use std::path::{Path, PathBuf};

use relief_core::registry::UnknownName;
use relief_io::{decode_text, write_atomically};
use relief_render::RENDERING;
use relief_scene::{SceneSpec, parse_scene};
use relief_session::{Action, Drag, Refused, Seen, Session};
use serde_json::{Value, json};

use super::Arguments;
use crate::commands::numbered::files;
use crate::commands::render::{Outputs, PictureRenderer};
use crate::commands::scene::make_absolute;
use crate::commands::scene_arguments::of_scene;
use crate::failure::Failure;
use crate::progress::{Progress, TaskProgress};
use crate::say;
use crate::streams::tell_written;

/// Longest script that is read, in bytes.
const MAX_SCRIPT_BYTES: u64 = 16 << 20;

/// The names of what is written at the end.
const SCENE: &str = "scene.toml";
const PICTURE: &str = "picture.png";

/// The entry of a script that draws.
const DRAW: &str = "picture";

/// An entry of a script.
enum Entry {
    Action(Action, Option<Drag>),
    /// Draws into a file of that name.
    Picture(String),
}

/// A picture to be drawn, and of what.
struct Drawn {
    name: String,
    spec: SceneSpec,
}

/// Applies the script, and writes scene and pictures.
pub fn run(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    let script = read(path)?;
    let spec = arguments.spec()?;
    let mut session = Session::of(spec).map_err(Failure::usage)?;
    let mut changes = Vec::new();
    let mut pictures: Vec<Drawn> = Vec::new();
    // All actions come before any file, so that a script with a fault leaves nothing behind.
    for (number, entry) in script.iter().enumerate() {
        match entry {
            Entry::Picture(name) => {
                if name == PICTURE {
                    let what = format!("{name} is drawn at the end: give another name");
                    return Err(fault(path, number, &what));
                }
                if pictures.iter().any(|drawn| drawn.name == *name) {
                    return Err(fault(path, number, &format!("{name} is drawn twice: give another name")));
                }
                pictures.push(Drawn { name: name.clone(), spec: session.spec().clone() });
                changes.push(Vec::new());
            }
            Entry::Action(action, drag) => {
                let changed = match session.apply_in(*drag, action) {
                    // The camera of a view is known once the scene is read.
                    Err(Refused::NotSeen) => {
                        let _reading = Progress::spinner("reading", arguments.json);
                        session.shown(Seen::of(&session.spec().load().map_err(of_scene)?));
                        session.apply_in(*drag, action)
                    }
                    applied => applied,
                };
                let changed = changed.map_err(|refused| fault(path, number, &refused.to_string()))?;
                changes.push(changed.keys);
            }
        }
    }
    pictures.push(Drawn { name: PICTURE.to_owned(), spec: session.spec().clone() });
    let written = match &arguments.output {
        Some(folder) => arguments.write(folder, session.spec(), &pictures)?,
        None => Vec::new(),
    };
    tell_written(arguments.json, |out| match arguments.json {
        true => Ok(writeln!(out, "{:#}", json!({ "changed": changes, "files": written }))?),
        false => {
            for (number, keys) in changes.iter().enumerate() {
                let what = if keys.is_empty() { "nothing changed".to_owned() } else { keys.join(", ") };
                match &script[number] {
                    Entry::Picture(name) if written.is_empty() => {
                        writeln!(out, "{}: would draw {name}, with --output", number + 1)?;
                    }
                    Entry::Picture(name) => writeln!(out, "{}: draws {name}", number + 1)?,
                    Entry::Action(..) => writeln!(out, "{}: {what}", number + 1)?,
                }
            }
            written.iter().try_for_each(|file| writeln!(out, "{file}"))?;
            Ok(())
        }
    })
}

impl Arguments {
    /// Writes the pictures, and last the scene.
    fn write(&self, folder: &Path, spec: &SceneSpec, pictures: &[Drawn]) -> Result<Vec<String>, Failure> {
        // Files that cannot be read are found before anything is written. Most pictures read the same.
        let mut known: Vec<Vec<PathBuf>> = Vec::new();
        for Drawn { spec, .. } in pictures {
            let read: Vec<PathBuf> = files(spec).iter().map(|file| file.to_path_buf()).collect();
            if !known.contains(&read) {
                let _reading = Progress::spinner("reading", self.json);
                spec.load().map_err(of_scene)?;
                known.push(read);
            }
        }
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::Work(format!("{}: cannot be made: {error}", folder.display())))?;
        let mut renderer = PictureRenderer::with(&self.cache, self.machine.is_named(), self.json);
        let mut written = Vec::new();
        let progress = TaskProgress::new(self.json);
        for (number, Drawn { name, spec }) in pictures.iter().enumerate() {
            let path = folder.join(name);
            let outputs =
                Outputs::picture(path.clone()).ok_or_else(|| Failure::usage("a picture needs an ending"))?;
            let spec = spec.clone().with_keys_of_meshes().map_err(of_scene)?;
            let scene = spec.load().map_err(of_scene)?;
            let tell = |task: &str, part: f32| {
                let part =
                    if task == RENDERING { (number as f32 + part) / pictures.len() as f32 } else { part };
                progress.show(task, part);
            };
            let (_, made) = renderer.draw(&scene, &outputs, &tell)?;
            if !self.json && number + 1 == pictures.len() {
                renderer.notes(&spec, &scene, &made).iter().for_each(say::note);
            }
            written.push(path.display().to_string());
        }
        drop(progress);
        let path = folder.join(SCENE);
        let mut spec = spec.clone();
        make_absolute(&mut spec)?;
        let text = spec.to_toml();
        // What is written must be readable.
        parse_scene(&text, &path).map_err(Failure::work)?;
        write_atomically(&path, |file| file.write_all(text.as_bytes())).map_err(Failure::work)?;
        written.push(path.display().to_string());
        Ok(written)
    }
}

/// The failure of an entry of the script.
fn fault(script: &Path, number: usize, what: &str) -> Failure {
    Failure::Work(format!("{}, action {}: {what}", script.display(), number + 1))
}

/// Reads a script.
fn read(path: &Path) -> Result<Vec<Entry>, Failure> {
    let failed = |what: String| Failure::Work(format!("{}: {what}", path.display()));
    let length = std::fs::metadata(path).map_err(|error| failed(format!("cannot be read: {error}")))?.len();
    if length > MAX_SCRIPT_BYTES {
        return Err(failed("it is longer than 16 MiB, so it is no script".to_owned()));
    }
    let bytes = std::fs::read(path).map_err(|error| failed(format!("cannot be read: {error}")))?;
    let text = decode_text(bytes).ok_or_else(|| failed("it holds no text, so it is no script".to_owned()))?;
    let list: Vec<Value> = serde_json::from_str(&text)
        .map_err(|error| failed(format!("no list of actions in JSON: {error}: see `relief view --help`")))?;
    let entry = |(number, value): (usize, Value)| entry(value).map_err(|what| fault(path, number, &what));
    list.into_iter().enumerate().map(entry).collect()
}

fn entry(mut value: Value) -> Result<Entry, String> {
    let drag = value.as_object_mut().and_then(|table| table.remove("drag"));
    let drag = match drag.map(|drag| drag.as_u64().ok_or("drag must be a whole number from 0 on")) {
        Some(number) => Some(Drag(number?)),
        None => None,
    };
    if value["do"] == DRAW {
        let name = value["file"].as_str().ok_or("a picture needs a file, as in \"file\": \"turned.png\"")?;
        let is_plain = Path::new(name).file_name().is_some_and(|own| own == name);
        if !is_plain || Outputs::picture(PathBuf::from(name)).is_none() {
            return Err(format!(
                "'{name}' is no name for a picture: it must be the name of a .png, .jpg or .exr in the folder of \
                 --output"
            ));
        }
        return Ok(Entry::Picture(name.to_owned()));
    }
    let name = value["do"].as_str().ok_or("an action needs its name, as in \"do\": \"orbit\"")?;
    if !Action::NAMES.contains(&name) {
        return Err(UnknownName::new("action", name, Action::NAMES.into_iter().chain([DRAW])).to_string());
    }
    let action: Action = serde_json::from_value(value.clone()).map_err(|error| format!("{name}: {error}"))?;
    // A field that an action does not have would be lost without a word.
    let known = serde_json::to_value(&action).unwrap_or_default();
    let unknown =
        value.as_object().into_iter().flatten().find(|(field, _)| known.get(field.as_str()).is_none());
    match unknown {
        Some((field, _)) => Err(format!("{name}: it has no field `{field}`")),
        None => Ok(Entry::Action(action, drag)),
    }
}
