//! `view`: times of the page of `relief view` in headless Chromium, with the program or without a server.

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use serde_json::Value;

use crate::chromium::npm;
use crate::table::table;

/// Arguments of `view`.
#[derive(Args)]
pub struct Arguments {
    /// Chromium or Chrome
    #[arg(long, value_name = "PROGRAM", default_value = "/usr/bin/chromium")]
    chromium: PathBuf,
    /// The command
    #[arg(long, value_name = "PROGRAM", default_value = "target/release/relief")]
    relief: PathBuf,
    /// What `cargo xtask web` has written, usually target/web: the page without a
    /// server, in place of the program
    #[arg(long, value_name = "FOLDER")]
    web: Option<PathBuf>,
    /// Movements of the pointer in an orbit
    #[arg(long, default_value_t = 300)]
    frames: u32,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let map = folder.path().join("ground.png");
    let mut height = Command::new(&arguments.relief);
    height.args(["height", "procedure", "fbm", "--size", "2048x2048", "-q", "-o"]).arg(&map);
    said(&mut height)?;
    npm::modules()?;
    let (script, what) = match &arguments.web {
        Some(folder) => ("web_figures.mjs", folder),
        None => ("view_figures.mjs", &arguments.relief),
    };
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../npm").join(script);
    let mut node = Command::new("node");
    node.arg(program).arg(what).arg(&map).arg("--browser").arg(&arguments.chromium);
    let figures = said(node.args(["--frames", &arguments.frames.to_string()]))?;
    let figures: Value = serde_json::from_str(&figures).map_err(|error| format!("{figures}: {error}"))?;
    let mut rows = table(&["what", "figure"]);
    for (what, figure) in figures.as_object().into_iter().flatten() {
        match figure.as_object() {
            None => drop(rows.add_row([what.clone(), figure.to_string()])),
            Some(each) => {
                for (name, number) in each {
                    rows.add_row([format!("{what}: {name}"), number.to_string()]);
                }
            }
        }
    }
    println!("{rows}");
    Ok(())
}

/// What a program prints.
fn said(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{name}: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr).trim())),
    }
}
