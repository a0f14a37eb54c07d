//! PyPI's embreex in another process.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use relief_core::camera::Ray;
use serde_json::Value;

use super::tessellation::Triangles;

/// The script, which is run as it is here.
const SCRIPT: &str = include_str!("../../python/embree_beside.py");

/// What it measured.
pub struct Answer {
    /// The package's version.
    pub version: String,
    /// Seconds of processor time and from beginning to end.
    pub build_s: [f64; 2],
    /// Resident memory that the scene holds.
    pub bytes: f64,
    /// Of each set of rays those a second of processor time, and each ray's depth.
    pub sets: BTreeMap<&'static str, (f64, Vec<f32>)>,
}

/// Builds a scene of those triangles and traces all sets of rays.
pub fn measured(
    python: &Path,
    triangles: &Triangles,
    sets: &[(&'static str, &[Ray])],
    runs: u16,
) -> Result<Answer, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let at = |name: &str| folder.path().join(name);
    let write = |name: &str, bytes: Vec<u8>| fs::write(at(name), bytes).map_err(|error| error.to_string());
    write("vertices.raw", triangles.points.iter().flatten().flat_map(|x| x.to_le_bytes()).collect())?;
    write("triangles.raw", triangles.corners.iter().flatten().flat_map(|x| x.to_le_bytes()).collect())?;
    for (name, rays) in sets {
        let numbers =
            |ray: &Ray| [ray.origin, ray.direction].map(|vector| vector.as_vec3().to_array()).concat();
        let bytes = rays.iter().flat_map(numbers).flat_map(f32::to_le_bytes).collect();
        write(&format!("{name}.rays"), bytes)?;
    }
    write("beside.py", SCRIPT.into())?;
    let output = Command::new(python)
        .arg(at("beside.py"))
        .arg(folder.path())
        .arg(runs.to_string())
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let number = |value: &Value, name: &str| {
        value[name].as_f64().ok_or_else(|| format!("there is no {name} in {answer}"))
    };
    let mut traced = BTreeMap::new();
    for (name, _) in sets {
        let bytes = fs::read(at(&format!("{name}.depths"))).map_err(|error| error.to_string())?;
        let depths = bytes.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
        traced.insert(*name, (number(&answer[*name], "cpu")?, depths));
    }
    Ok(Answer {
        version: answer["version"].as_str().unwrap_or("of unknown version").to_owned(),
        build_s: [number(&answer, "build_cpu_s")?, number(&answer, "build_wall_s")?],
        bytes: number(&answer, "bytes")?,
        sets: traced,
    })
}
