//! `loaders`: what `relief bake --for` writes, read by three.js, OpenImageIO and pygltflib.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use clap::Args;
use relief_io::ENGINES;
use serde_json::{Map, Value, json};

use crate::chromium::{self, npm};
use crate::python;
use crate::table::table;

/// The page and the script, which are run as they are here.
const PAGE: &str = include_str!("page.js");
const SCRIPT: &str = include_str!("../../python/loaders_beside.py");

const PACKAGES: &str = "OpenImageIO==3.2.2.0 pygltflib==1.16.5 numpy";

/// Metres between the heights 0 and 1, on a tile of 1 m.
const SCALE_M: f64 = 0.05;

/// The maps of the material, by the names that its folder has them.
const MAPS: [(&str, &str, &str); 3] = [
    ("height", "cobbles.png", "cobbles_height.png"),
    ("color", "cobbles_color.png", "cobbles_color.png"),
    ("orm", "cobbles_orm.png", "cobbles_orm.png"),
];

/// Arguments of `loaders`.
#[derive(Args)]
pub struct Arguments {
    /// The command that writes the textures
    #[arg(long, value_name = "FILE", default_value = "target/release/relief")]
    relief: PathBuf,
    /// Folder with the maps `cobbles`
    #[arg(long, value_name = "FOLDER", default_value = "data")]
    data: PathBuf,
    /// A Python with OpenImageIO 3.2.2, pygltflib and numpy
    #[arg(long, value_name = "FILE", default_value = "python3")]
    python: PathBuf,
    /// The browser that runs three.js
    #[arg(long, value_name = "FILE", default_value = "chromium")]
    chromium: PathBuf,
}

/// Prints the table. Fails where a file is read otherwise than its table of the engine says, or where a
/// change in what was read is not noticed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let check = "import numpy, OpenImageIO, pygltflib; assert OpenImageIO.VERSION_STRING == '3.2.2.0', \
                 'OpenImageIO ' + OpenImageIO.VERSION_STRING";
    python::require(&arguments.python, check, PACKAGES)?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let set = folder.path().join("cobbles");
    fs::create_dir(&set).map_err(|error| error.to_string())?;
    let mut maps = Map::new();
    for (role, from, to) in MAPS {
        let (from, to) = (arguments.data.join(from), set.join(to));
        fs::copy(&from, &to).map_err(|error| format!("{}: {error}", from.display()))?;
        maps.insert(role.to_owned(), json!(to));
    }
    let mut engines = Vec::new();
    for engine in ENGINES {
        let to = folder.path().join(engine.name);
        engines.push(written(&arguments.relief, &set, engine.name, &to)?);
    }
    let input = input_of_three(&folder.path().join("three"))?;
    let answer = chromium::with_three(&arguments.chromium, PAGE, None, input)?;
    let answer: Value = serde_json::from_slice(&answer).map_err(|error| error.to_string())?;
    let job = json!({ "maps": maps, "scale": SCALE_M, "engines": engines, "three": answer });
    let file = folder.path().join("job.json");
    fs::write(&file, job.to_string()).map_err(|error| error.to_string())?;
    let output = Command::new(&arguments.python).args(["-c", SCRIPT]).arg(&file).output();
    let output = output.map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    tell(&answer)
}

/// Writes the textures for an engine. Returns what the command says of them.
fn written(relief: &Path, set: &Path, engine: &str, to: &Path) -> Result<Value, String> {
    let mut command = Command::new(relief);
    command.arg("bake").arg(set).args(["--for", engine, "--json", "--quiet", "--tile-size", "1,1"]);
    command.args(["--scale", &SCALE_M.to_string()]).arg("-o").arg(to);
    let ran = command.output().map_err(|error| format!("{}: {error}", relief.display()))?;
    if !ran.status.success() {
        return Err(format!("--for {engine}: {}", String::from_utf8_lossy(&ran.stderr)));
    }
    let mut told: Value = serde_json::from_slice(&ran.stdout).map_err(|error| error.to_string())?;
    let green = told["green"].clone();
    for texture in told["textures"].as_array_mut().into_iter().flatten() {
        texture["green"] = green.clone();
    }
    Ok(json!({ "name": engine, "folder": to, "textures": told["textures"], "files": told["files"] }))
}

/// The files as addresses that hold them: a page of a file may not fetch others.
fn input_of_three(folder: &Path) -> Result<Value, String> {
    let (mut files, mut gltf) = (Map::new(), None);
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())? {
        let path = entry.map_err(|error| error.to_string())?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let kind = match path.extension().and_then(|ending| ending.to_str()) {
            Some("png") => "image/png",
            Some("gltf") => {
                gltf = Some(name.clone());
                "model/gltf+json"
            }
            Some("bin") => "application/octet-stream",
            _ => continue,
        };
        let bytes = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        files.insert(name, format!("data:{kind};base64,{}", STANDARD.encode(bytes)).into());
    }
    let gltf = gltf.ok_or("--for three wrote no glTF file")?;
    Ok(json!({ "gltf": gltf, "files": files }))
}

fn tell(answer: &Value) -> Result<ExitCode, String> {
    let rows = answer["rows"].as_array().ok_or("no rows in the answer")?;
    let unnoticed = answer["unnoticed"].as_array().ok_or("no changes in the answer")?;
    let mut table = table(&["read by", "--for", "file", "verdict", "changes noticed"]);
    let mut wrong = 0;
    for row in rows {
        let text = |at: usize| row[at].as_str().unwrap_or_default().to_owned();
        let is_right = row[3] == true;
        wrong += usize::from(!is_right);
        let verdict = if is_right { "as written" } else { "WRONG" }.to_owned();
        table.add_row([text(0), text(1), text(2), verdict, text(4)]);
    }
    println!(
        "three.js {}, {}. {wrong} of {} read wrongly.\n\n{table}",
        npm::THREE,
        answer["versions"],
        rows.len()
    );
    for change in unnoticed {
        println!("Not noticed: {change}");
    }
    let is_fine = wrong == 0 && unnoticed.is_empty() && !rows.is_empty();
    Ok(if is_fine { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
