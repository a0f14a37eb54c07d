//! The table of units by EPSG codes beside PyPI pyproj: every number of 16 bit must have the same unit, or
//! none, in both.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use clap::Args;
use relief_io::epsg;
use serde_json::Value;

use crate::python;

const SCRIPT: &str = include_str!("../python/epsg_beside.py");

/// The package whose answers count, with the list that the table was made of.
const PYPROJ: &str = "pyproj==3.7.1";

/// How far apart two sizes of a unit may be, as a part of them: PROJ's own vary in the last digit.
const ROUNDING: f64 = 1e-12;

/// Arguments of `units`.
#[derive(Args)]
pub struct Arguments {
    /// Python with pyproj 3.7.1
    #[arg(long, default_value = "python3")]
    python: PathBuf,
}

/// The size of a system's unit, and whether it counts downward.
type Axis = (f64, bool);

/// Compares and prints; fails where something differs.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let check = "import pyproj; assert pyproj.__version__ == '3.7.1', 'pyproj ' + pyproj.__version__";
    python::require(&arguments.python, check, PYPROJ)?;
    let output = Command::new(&arguments.python).args(["-c", SCRIPT]).output();
    let output = output.map_err(|error| format!("pyproj cannot be asked: {error}"))?;
    if !output.status.success() {
        return Err(format!("pyproj failed: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let about: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let systems = about["systems"].as_array().ok_or("pyproj listed no systems")?;
    let mut theirs: BTreeMap<(&str, u16), Axis> = BTreeMap::new();
    for system in systems {
        let fields = (system[0].as_str(), system[1].as_u64(), system[2].as_f64(), system[3].as_bool());
        let (Some(kind), Some(code), Some(size), Some(downward)) = fields else {
            return Err(format!("pyproj listed {system}"));
        };
        match u16::try_from(code) {
            Ok(code) => drop(theirs.insert((kind, code), (size, downward))),
            Err(_) => println!("EPSG:{code} ({kind}) has more than the 16 bits of a GeoTIFF's codes"),
        }
    }
    let mut differences = 0;
    for kind in ["projected", "vertical", "geographic"] {
        let (mut count, mut of_metres) = (0, 0);
        for code in 0..=u16::MAX {
            let (ours, theirs) = (ours(kind, code), theirs.get(&(kind, code)).copied());
            count += usize::from(theirs.is_some());
            of_metres += usize::from(theirs.is_some_and(|(size, _)| size == 1.0));
            let is_same = match (ours, theirs) {
                (Some(ours), Some(theirs)) => {
                    (ours.0 / theirs.0 - 1.0).abs() < ROUNDING && ours.1 == theirs.1
                }
                (ours, theirs) => ours == theirs,
            };
            if !is_same {
                differences += 1;
                println!("EPSG:{code} ({kind}): {ours:?} here, {theirs:?} in pyproj");
            }
        }
        println!("{kind}: {count} systems, {of_metres} in metres");
    }
    println!(
        "{differences} differences from pyproj {} (PROJ {})",
        about["pyproj"].as_str().unwrap_or_default(),
        about["proj"].as_str().unwrap_or_default()
    );
    Ok(if differences == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn ours(kind: &str, code: u16) -> Option<Axis> {
    match kind {
        "projected" => Some((epsg::length(epsg::projected(code)?)?.size, false)),
        "vertical" => {
            let axis = epsg::vertical(code)?;
            Some((epsg::length(axis.unit)?.size, axis.downward))
        }
        _ => Some((epsg::angle(epsg::geographic(code)?)?.size, false)),
    }
}
