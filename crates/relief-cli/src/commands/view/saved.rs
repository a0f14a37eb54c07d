//! Files that the page saves. They are the commands' own: each is written by the command that a user would
//! run.

use std::path::Path;
use std::process::{Command, Stdio};

use relief_io::write_atomically;
use relief_scene::SceneSpec;
use relief_shaders::{STAGES, Selection};
use relief_viewer::{Given, of_view};
use serde_json::{Value, json};

use crate::commands::scene::make_absolute;

/// A file to save: its name, and a label.
struct Saved {
    what: &'static str,
    label: &'static str,
    by: By,
}

/// What writes a file.
enum By {
    /// The scene's own text.
    Scene,
    /// `relief render`, into the picture.
    Picture,
    /// `relief render --aov`.
    Aov,
    /// `relief shader --entry functions`, in a language.
    Functions(&'static str),
}

/// Name of the functions' files, before the ending. They are kept under their method's name.
const FUNCTIONS: &str = "relief";

/// Everything that can be saved.
const SAVED: [Saved; 10] = [
    Saved { what: "picture.png", label: "Picture, PNG", by: By::Picture },
    Saved { what: "picture.jpg", label: "Picture, JPEG", by: By::Picture },
    Saved { what: "picture.exr", label: "Picture in linear light, EXR", by: By::Picture },
    Saved { what: "aov.exr", label: "Hits, positions, normals and costs (AOVs), EXR", by: By::Aov },
    Saved { what: "scene.toml", label: "Scene, TOML", by: By::Scene },
    Saved { what: "relief.wgsl", label: "Method as functions, WGSL", by: By::Functions("wgsl") },
    Saved { what: "relief.glsl", label: "Method as functions, GLSL", by: By::Functions("glsl") },
    Saved { what: "relief.hlsl", label: "Method as functions, HLSL", by: By::Functions("hlsl") },
    Saved { what: "relief.metal", label: "Method as functions, Metal", by: By::Functions("msl") },
    Saved { what: "relief.gdshaderinc", label: "Method as functions, Godot", by: By::Functions("godot") },
];

/// What the page offers.
pub fn offered() -> Value {
    let told = |Saved { what, label, by }: &Saved| {
        json!({
            "what": what, "label": label, "of_surface": matches!(by, By::Functions(_)),
            "of_view": !matches!(by, By::Scene),
        })
    };
    SAVED.iter().map(told).collect()
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
    let known = SAVED.iter().find(|saved| saved.what == what);
    let known = known.ok_or_else(|| format!("'{what}' is nothing that can be saved"))?;
    let whole = |file: &Path| std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    if let By::Scene = known.by {
        return Ok(Kept { name: what.to_owned(), bytes: given.scene_text(spec, whole).into_bytes() });
    }
    let spec = &of_view(spec, of.view).map_err(|error| error.to_string())?;
    let folder = tempfile::tempdir().map_err(|error| format!("a folder for it cannot be made: {error}"))?;
    let at = |name: &str| folder.path().join(name);
    let mut name = what.to_owned();
    let mut words: Vec<String> = match known.by {
        By::Scene | By::Picture => vec!["render".into(), "-o".into(), at(what).display().to_string()],
        By::Aov => {
            let picture = at("picture.png").display().to_string();
            vec!["render".into(), "-o".into(), picture, "--aov".into(), at(what).display().to_string()]
        }
        By::Functions(target) => {
            let selection = spec.selections().map_err(|error| error.to_string())?;
            let selection = selection.get(of.surface);
            let selection = selection.ok_or_else(|| format!("there is no surface {}", of.surface))?;
            let ending = what.strip_prefix(FUNCTIONS).unwrap_or(what);
            name = format!("{}{ending}", selection.method_name());
            let mut words = function_words(selection);
            words.extend(["--target", target, "-o"].map(str::to_owned));
            words.extend([folder.path().display().to_string(), "--name".to_owned(), FUNCTIONS.to_owned()]);
            words
        }
    };
    if matches!(known.by, By::Picture | By::Aov) {
        let scene = at("scene.toml");
        let mut spec = spec.clone();
        make_absolute(&mut spec).map_err(|failure| format!("{failure:?}"))?;
        let text = spec.to_toml();
        write_atomically(&scene, |file| file.write_all(text.as_bytes()))
            .map_err(|error| error.to_string())?;
        words.insert(1, scene.display().to_string());
    }
    run(&words)?;
    let bytes = std::fs::read(at(what)).map_err(|error| format!("{what}: it cannot be read: {error}"))?;
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
