//! Files that the page saves. They are the commands' own: each is written by the command that a user would
//! run.

use std::path::Path;
use std::process::{Command, Stdio};

use relief_io::write_atomically;
use relief_scene::SceneSpec;
use relief_shaders::{STAGES, Selection};
use relief_viewer::{Given, Saved, of_view};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::commands::scene::make_absolute;

/// Name of the functions' files, before the ending. They are kept under their method's name.
const FUNCTIONS: &str = "relief";

/// What the program saves besides what any viewer does: methods as functions. Ending, language as
/// `relief shader` has it, and label.
const LANGUAGES: [(&str, &str, &str); 5] = [
    (".wgsl", "wgsl", "Method as functions, WGSL"),
    (".glsl", "glsl", "Method as functions, GLSL"),
    (".hlsl", "hlsl", "Method as functions, HLSL"),
    (".metal", "msl", "Method as functions, Metal"),
    (".gdshaderinc", "godot", "Method as functions, Godot"),
];

/// What the page offers.
pub fn offered() -> Value {
    let functions = LANGUAGES.iter().map(|(ending, _, label)| {
        let what = format!("{FUNCTIONS}{ending}");
        json!({ "what": what, "label": label, "of_surface": true, "of_view": true })
    });
    Saved::offered().into_iter().chain(functions).collect()
}

/// What a file is made of: a view, from 0 on, and a surface, where one has a method.
#[derive(Clone, Copy, Default)]
pub struct Of {
    pub view: usize,
    pub surface: usize,
}

/// A file to be kept: its name and its bytes.
pub struct Kept {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Makes a file.
///
/// `given` are the page's files: in a scene file they are named as the user knows them.
pub fn saved(spec: &SceneSpec, what: &str, of: Of, given: &Given) -> Result<Kept, String> {
    let language = what.strip_prefix(FUNCTIONS).and_then(|ending| {
        LANGUAGES.iter().find(|(known, ..)| *known == ending).map(|(ending, target, _)| (*ending, *target))
    });
    if let Some((ending, target)) = language {
        return functions(&view(spec, of)?, of.surface, ending, target);
    }
    let mut words = ["render", "-o"].map(str::to_owned).to_vec();
    let folder = folder()?;
    let at = |name: &str| folder.path().join(name).display().to_string();
    match Saved::named(what).map_err(|error| error.to_string())? {
        Saved::Scene => {
            let whole = |file: &Path| std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
            return Ok(Kept { name: what.to_owned(), bytes: given.scene_text(spec, whole).into_bytes() });
        }
        Saved::Picture(_) => words.push(at(what)),
        Saved::Aov => words.extend([at("picture.png"), "--aov".to_owned(), at(what)]),
    }
    let mut spec = view(spec, of)?;
    make_absolute(&mut spec).map_err(|failure| format!("{failure:?}"))?;
    let (scene, text) = (folder.path().join("scene.toml"), spec.to_toml());
    write_atomically(&scene, |file| file.write_all(text.as_bytes())).map_err(|error| error.to_string())?;
    words.push(scene.display().to_string());
    run(&words)?;
    kept(what.to_owned(), &folder.path().join(what))
}

/// Makes the file of a surface's method as functions.
fn functions(spec: &SceneSpec, surface: usize, ending: &str, target: &str) -> Result<Kept, String> {
    let selections = spec.selections().map_err(|error| error.to_string())?;
    let selection = selections.get(surface).ok_or_else(|| format!("there is no surface {surface}"))?;
    let folder = folder()?;
    let mut words = function_words(selection);
    words.extend(["--target", target, "--name", FUNCTIONS, "-o"].map(str::to_owned));
    words.push(folder.path().display().to_string());
    run(&words)?;
    let name = format!("{}{ending}", selection.method_name());
    kept(name, &folder.path().join(format!("{FUNCTIONS}{ending}")))
}

/// The scene of a view.
fn view(spec: &SceneSpec, of: Of) -> Result<SceneSpec, String> {
    of_view(spec, of.view).map_err(|error| error.to_string())
}

/// A folder for what is made.
fn folder() -> Result<TempDir, String> {
    tempfile::tempdir().map_err(|error| format!("a folder for it cannot be made: {error}"))
}

fn kept(name: String, file: &Path) -> Result<Kept, String> {
    let bytes = std::fs::read(file).map_err(|error| format!("{name}: it cannot be read: {error}"))?;
    Ok(Kept { name, bytes })
}

/// Runs this program.
fn run(words: &[String]) -> Result<(), String> {
    let program = std::env::current_exe().map_err(|error| format!("this program is not found: {error}"))?;
    let output = Command::new(program).args(words).args(["-q", "--json"]).stdin(Stdio::null()).output();
    let output = output.map_err(|error| format!("this program cannot be started again: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let said: Option<Value> = serde_json::from_slice(&output.stderr).ok();
    let said = said.and_then(|said| Some(said["error"].as_str()?.to_owned()));
    Err(said.unwrap_or_else(|| String::from_utf8_lossy(&output.stderr).trim().to_owned()))
}

/// The words of the command that writes a selection as functions, with its settings.
fn function_words(selection: &Selection) -> Vec<String> {
    let mut words = ["shader", "--entry", "functions"].map(str::to_owned).to_vec();
    for (place, stage) in STAGES.iter().enumerate() {
        let choice = &selection.choices[place];
        let is_asked =
            ["surface", "field", "search", "refine", "shadow", "shadow-search"].contains(&stage.key);
        if is_asked && stage.has_key() && selection.uses(place) && stage.entries.len() > 1 {
            words.extend([format!("--{}", stage.key), choice.entry.name.to_owned()]);
        }
        if is_asked && selection.uses(place) {
            let settings = choice.entry.params.iter().zip(choice.params);
            for (param, value) in settings.filter(|(param, value)| param.default != *value) {
                words.extend(["--set".to_owned(), format!("{}.{}={value}", stage.key, param.name)]);
            }
        }
    }
    words
}
