//! Whether Godot takes the text of every method.

use std::path::Path;

use relief_export::{FunctionOptions, Profile, functions};
use relief_shaders::{METHODS, Selection};

use super::FRAGMENT;

const SHADER: &str = include_str!("../../../../../crates/relief-cli/engines/godot/relief.gdshader");

/// Surfaces and shadows that methods are written with.
const WITH: [(&str, &str); 4] =
    [("plane", "none"), ("quadric-vertical", "ray"), ("quadric-perpendicular", "soft"), ("plane", "horizon")];

/// Reads all texts with Godot. Returns how many there are.
pub fn read_all(chromium: &Path) -> Result<usize, String> {
    let mut names = Vec::new();
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    for method in METHODS {
        for (surface, shadow) in WITH {
            let name = format!("{}_{surface}_{shadow}", method.name);
            let Some(text) = text(method.name, surface, shadow, &name) else { continue };
            let shader = SHADER.replace("\"relief.gdshaderinc\"", &format!("\"{name}.gdshaderinc\""));
            files.push((format!("{name}.gdshaderinc"), text));
            files.push((format!("{name}.gdshader"), shader.into_bytes()));
            names.push(name);
        }
    }
    let count = names.len();
    files.extend([
        ("list.txt".to_owned(), names.join("\n").into_bytes()),
        ("main.gd".to_owned(), include_bytes!("texts.gd").to_vec()),
        ("relief_fragment.gdshaderinc".to_owned(), FRAGMENT.as_bytes().to_vec()),
    ]);
    super::run(chromium, files)?;
    Ok(count)
}

/// A method's functions; none where it has none on this surface.
fn text(method: &str, surface: &str, shadow: &str, name: &str) -> Option<Vec<u8>> {
    let mut selection = Selection::method(method).ok()?;
    selection.choose("surface", surface).ok()?;
    selection.choose("shadow", shadow).ok()?;
    let options = FunctionOptions {
        name: Some(name.to_owned()),
        profiles: vec![Profile::Godot4],
        ..FunctionOptions::default()
    };
    let mut exported = functions(&selection, &options).ok()?;
    Some(exported.files.swap_remove(0).bytes)
}
