//! Licences of the crates that the program is made of.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::{at, cargo, output};

/// Beginnings of the names of files that hold a licence, in capitals.
const NAMES: [&str; 5] = ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"];

/// Lists the crates that `relief-cli` is linked with, with their licences, then each licence's text once.
///
/// # Errors
///
/// When cargo fails, or when a crate names no licence.
pub fn of_dependencies(root: &Path, target: &str) -> Result<String, String> {
    let listed = output(cargo(root).args(["tree", "--package", "relief-cli", "--edges", "normal"]).args([
        "--no-default-features",
        "--features",
        "lanes",
        "--target",
        target,
        "--prefix",
        "none",
        "--format",
        "{p}",
    ]))?;
    let linked: BTreeSet<(&str, &str)> = listed.lines().filter_map(name_and_version).collect();
    let metadata = output(cargo(root).args(["metadata", "--format-version", "1"]))?;
    let metadata: Value = serde_json::from_str(&metadata).map_err(|error| error.to_string())?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata lists no packages")?;
    let mut list = String::new();
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in packages {
        let part = |key: &str| package[key].as_str();
        let (Some(name), Some(version)) = (part("name"), part("version")) else { continue };
        // The project's own crates have the licences beside this file.
        if !linked.contains(&(name, version)) || package["source"].is_null() {
            continue;
        }
        let title = format!("{name} {version}");
        let manifest = part("manifest_path").ok_or_else(|| format!("{title} has no manifest"))?;
        let files = licence_files(Path::new(manifest))?;
        let licence = part("license").or(part("license_file")).or((!files.is_empty()).then_some("see below"));
        let licence = licence.ok_or_else(|| format!("{title} names no licence"))?;
        list.push_str(&format!("{title}: {licence}\n"));
        for text in files {
            texts.entry(text).or_default().push(title.clone());
        }
    }
    let mut all = format!("relief is linked with these crates.\n\n{list}");
    for (text, titles) in texts {
        all.push_str(&format!("\n{}\n{}\n\n{}\n", "-".repeat(72), titles.join(", "), text.trim_end()));
    }
    Ok(all)
}

/// The name and version at the beginning of a line of `cargo tree`.
fn name_and_version(line: &str) -> Option<(&str, &str)> {
    let mut words = line.split_whitespace();
    Some((words.next()?, words.next()?.strip_prefix('v')?))
}

/// The texts of the licences beside a manifest, by the names of their files.
fn licence_files(manifest: &Path) -> Result<Vec<String>, String> {
    let folder = manifest.parent().ok_or("a manifest lies in a folder")?;
    let mut paths: Vec<_> = fs::read_dir(folder)
        .map_err(at(folder))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| {
            let name = path.file_name().map(|name| name.to_string_lossy().to_uppercase()).unwrap_or_default();
            path.is_file() && NAMES.iter().any(|begin| name.starts_with(begin))
        })
        .collect();
    paths.sort();
    paths
        .iter()
        .map(|path| {
            fs::read(path).map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).map_err(at(path))
        })
        .collect()
}
