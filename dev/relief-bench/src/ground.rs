//! Whether meshes of maps lie where the maps do: `cargo relief-bench ground --python VENV/bin/python --relief
//! target/release/relief`.

use std::path::PathBuf;
use std::process::{Command, ExitCode};

use clap::Args;
use serde_json::Value;

use crate::python;
use crate::table::table;

const SCRIPT: &str = include_str!("../python/ground_beside.py");

/// What the metres of degrees and of web maps may be off pyproj's: web maps are reckoned with on a sphere.
const METRES_OFF: f64 = 4e-3;

/// The error that is asked for.
const ERROR_M: f64 = 1.0;

#[derive(Args)]
pub struct Arguments {
    /// A Python that has numpy, tifffile, trimesh and pyproj
    #[arg(long)]
    python: PathBuf,
    /// The command to judge
    #[arg(long, default_value = "target/release/relief")]
    relief: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let packages = "numpy tifffile trimesh pyproj";
    python::require(&arguments.python, "import numpy, tifffile, trimesh, pyproj", packages)?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let relief = arguments.relief.canonicalize();
    let relief = relief.map_err(|error| format!("{}: {error}", arguments.relief.display()))?;
    let ran = Command::new(&arguments.python).args(["-c", SCRIPT]).arg(relief).arg(folder.path()).output();
    let ran = ran.map_err(|error| error.to_string())?;
    if !ran.status.success() {
        return Err(String::from_utf8_lossy(&ran.stderr).into_owned());
    }
    let report: Value = serde_json::from_slice(&ran.stdout).map_err(|error| error.to_string())?;
    println!("trimesh {}, pyproj {}\n", report["trimesh"], report["pyproj"]);
    let mut table = table(&[
        "model",
        "triangles",
        "corners off, m",
        "allowed, m",
        "metres off pyproj's",
        "error, m",
        "with half the triangles, m",
    ]);
    let mut holds = true;
    for (name, model) in report["models"].as_object().into_iter().flatten() {
        let number = |key: &str| model[key].as_f64();
        let within = |value: Option<f64>, most: Option<f64>| match (value, most) {
            (Some(value), Some(most)) => value <= most,
            _ => false,
        };
        holds &= within(number("off_m"), number("allowed_m"));
        if name != "none" {
            holds &= within(number("metres_off"), Some(METRES_OFF));
            holds &= within(number("error_m"), Some(ERROR_M)) && model["all_seen"] == true;
            // The check itself can fail.
            holds &= !within(number("half_error_m"), Some(ERROR_M));
        }
        let shown = |key: &str| number(key).map_or(String::new(), |value| format!("{value:.3e}"));
        table.add_row([
            name.clone(),
            model["triangles"].to_string(),
            shown("off_m"),
            shown("allowed_m"),
            shown("metres_off"),
            shown("error_m"),
            shown("half_error_m"),
        ]);
    }
    println!("{table}");
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
