//! A sheet of materials: sets of textures by the names of five programs, glTF models and blocks.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use relief_tests::accuracy::sample_maps;

use super::picture::Picture;
use super::textures::{self, SETS};
use super::{Arguments, Relief, sheet};
use crate::table::table;

/// Blocks of ground: a relief with walls down to a base, coloured by height and by a map.
const BLOCKS: [(&str, &[&str]); 2] = [
    ("block, coloured by height", &["--ramp", "terrain"]),
    ("block, coloured by a map", &["--color", "jacksboro_color.png"]),
];

/// Endings of the names of models.
const MODELS: [&str; 2] = ["glb", "gltf"];

/// Prints the table and writes the sheet. Returns whether every set was found whole.
pub fn run(relief: &Relief, arguments: &Arguments) -> Result<bool, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let data = sample_maps();
    let mut cases: Vec<(String, Vec<OsString>, usize)> = Vec::new();
    for set in &SETS {
        let to = folder.path().join(set.folder);
        textures::write(set, &data, &to)?;
        cases.push((set.folder.to_owned(), vec![to.into()], set.taken()));
    }
    let models = arguments.models.as_deref().map_or(Ok(Vec::new()), models)?;
    if models.is_empty() {
        println!("No glTF models are shown: --models names a folder of them.\n");
    }
    for model in models {
        let name = model.file_name().unwrap_or_default().to_string_lossy().into_owned();
        cases.push((name, vec!["--mesh".into(), model.into()], 0));
    }
    for (name, flags) in BLOCKS {
        let mut all: Vec<OsString> = vec![data.join("jacksboro.png").into(), "--walls".into()];
        all.extend(flags.iter().map(|flag| match flag.ends_with(".png") {
            true => data.join(flag).into(),
            false => OsString::from(flag),
        }));
        cases.push((name.to_owned(), all, 0));
    }
    let [png, aov] = ["picture.png", "aov.exr"].map(|name| folder.path().join(name));
    let mut rows = table(&["picture", "row, column", "textures taken", "verdict"]);
    let (mut shown, mut whole) = (Vec::new(), true);
    for (name, mut flags, wanted) in cases {
        flags.extend(["--json", "--size", "800x600", "--aov"].map(OsString::from));
        flags.push(aov.clone().into());
        let answer = relief.render(&flags, &png).map_err(|error| format!("{name}: {error}"))?;
        let (taken, count) = taken(&answer)?;
        let is_whole = count == wanted;
        whole &= is_whole;
        let [row, column] = sheet::place(shown.len());
        let verdict = if is_whole { String::new() } else { format!("MISS: {wanted} were expected") };
        rows.add_row([name, format!("{row}, {column}"), taken, verdict]);
        shown.push(sheet::small(&Picture::read(&png, &aov)?));
    }
    sheet::write(&shown, &arguments.output)?;
    println!("{rows}\n");
    Ok(whole)
}

/// The glTF models of a folder.
fn models(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let error = |error: std::io::Error| format!("{}: {error}", folder.display());
    let entries = std::fs::read_dir(folder).map_err(error)?;
    let mut models = Vec::new();
    for entry in entries {
        let path = entry.map_err(error)?.path();
        if path.extension().is_some_and(|ending| MODELS.iter().any(|model| ending == *model)) {
            models.push(path);
        }
    }
    models.sort();
    Ok(models)
}

/// What the command says of the textures that it took, and how many they are.
fn taken(answer: &str) -> Result<(String, usize), String> {
    let answer: serde_json::Value = serde_json::from_str(answer).map_err(|error| error.to_string())?;
    let notes = answer["notes"].as_array().into_iter().flatten();
    let text = notes.filter(|note| note["about"] == "texture-set").find_map(|note| note["text"].as_str());
    let Some(text) = text else { return Ok(("-".to_owned(), 0)) };
    let listed = text.rsplit_once(": ").map_or(text, |(_, listed)| listed);
    // A packed map has several names: "occlusion, roughness and metalness in one map from FILE".
    Ok((listed.to_owned(), listed.matches(" from ").count()))
}
