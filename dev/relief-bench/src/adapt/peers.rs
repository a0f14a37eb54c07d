//! Packages of PyPI in another process.

use std::fs;
use std::path::Path;
use std::process::Command;

use glam::DVec2;
use relief_core::HeightMap;
use serde_json::Value;

use super::distance::Piece;

/// The script, which is run as it is here.
const SCRIPT: &str = include_str!("../../python/meshes_beside.py");

/// Mesh that a package made.
pub struct Answer {
    pub version: String,
    pub seconds: f64,
    pub pieces: Vec<Piece>,
}

/// Meshes a map with a package, to a tolerance or a number of triangles.
pub fn made(python: &Path, package: &str, map: &HeightMap, number: f64) -> Result<Answer, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let at = |name: &str| folder.path().join(name);
    let heights: Vec<u8> = map.texels().iter().flat_map(|height| height.to_le_bytes()).collect();
    fs::write(at("heights.raw"), heights).map_err(|error| error.to_string())?;
    fs::write(at("beside.py"), SCRIPT).map_err(|error| error.to_string())?;
    let output = Command::new(python)
        .arg(at("beside.py"))
        .arg(folder.path())
        .arg(package)
        .args([map.width().to_string(), map.height().to_string(), number.to_string()])
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("{package}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let read = |name: &str| fs::read(at(name)).map_err(|error| error.to_string());
    let numbers = read("vertices.raw")?;
    let numbers: Vec<f64> =
        numbers.as_chunks::<4>().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes))).collect();
    let corners = read("triangles.raw")?;
    let corners: Vec<u32> =
        corners.as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    let vertex = |at: u32| {
        let [x, y, height] = numbers.as_chunks::<3>().0[at as usize];
        (DVec2::new(x, y), height)
    };
    Ok(Answer {
        version: answer["version"].as_str().unwrap_or("of unknown version").to_owned(),
        seconds: answer["seconds"].as_f64().ok_or_else(|| format!("there is no time in {answer}"))?,
        pieces: corners.as_chunks::<3>().0.iter().map(|corners| corners.map(vertex)).collect(),
    })
}
