use std::path::Path;
use std::sync::LazyLock;

use relief_core::ByteSize;
use relief_scene::{Form, MeshChoice, SceneError, keys, parse_scene};

use crate::{Target, text};

/// Any text as a scene file: an error that names a line of it, or a scene that can be loaded with a map of a
/// few texels and described again.
pub const SCENE: Target = Target { name: "scene", run, make };

/// A height map of two by two texels.
static MAP: LazyLock<tempfile::NamedTempFile> = LazyLock::new(|| {
    let file = tempfile::Builder::new().suffix(".pgm").tempfile().expect("a temporary file");
    std::fs::write(file.path(), b"P5 2 2 255\n\x00\x40\x80\xff").expect("it can be written");
    file
});

fn run(bytes: &[u8]) -> bool {
    let text = text(bytes);
    let mut spec = match parse_scene(text, Path::new("scene.toml")) {
        Ok(spec) => spec,
        Err(SceneError::InFile { line, .. } | SceneError::Key { line, .. }) => {
            assert!((1..=text.lines().count().max(1) + 1).contains(&line), "line {line}");
            return false;
        }
        Err(_) => return false,
    };
    // What a file names is not there; another one is.
    for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
        surface.height = Some(MAP.path().to_owned());
        (surface.color, surface.normal, surface.channel, surface.raw) = (None, None, None, None);
        if matches!(surface.mesh, Some(MeshChoice::File(_))) {
            (surface.mesh, surface.project) = (None, None);
        }
    }
    spec.max_memory = Some(ByteSize(256 << 20));
    let Ok(scene) = spec.load() else { return false };
    assert!(!scene.surfaces().is_empty());
    assert!(scene.camera().eye().is_finite() && scene.camera().half_height() > 0.0);
    assert!(scene.to_builder().build().is_ok());
    true
}

/// The scenes of the repository, and one with every key that goes with those before it.
fn make() -> Vec<Vec<u8>> {
    let scenes = [
        include_str!("../../../../scenes/bricks.toml"),
        include_str!("../../../../scenes/cobbles.toml"),
        include_str!("../../../../scenes/jacksboro.toml"),
        include_str!("../../../../scenes/logo.toml"),
        include_str!("../../../../scenes/still-life.toml"),
        include_str!("../../../../scenes/gallery/column.toml"),
        include_str!("../../../../scenes/gallery/cylinders.toml"),
        include_str!("../../../../scenes/gallery/room.toml"),
        include_str!("../../../../scenes/gallery/tori.toml"),
        &every_key(),
    ];
    scenes.map(|text| text.as_bytes().to_vec()).into()
}

fn every_key() -> String {
    let others =
        ["\"a\"", "true", "1.5", "[1, 0.5]", "[1, 0.5, 0.25]", "\"5cm\"", "\"az=200,alt=30\"", "\"32x24\""];
    let mut text = String::new();
    for key in keys() {
        let names = match &key.form {
            Form::Name(names) | Form::Mesh(names) => names.first().map(|name| format!("\"{name}\"")),
            _ => None,
        };
        let values = [key.default.to_string()].into_iter().chain(names).chain(others.map(str::to_owned));
        let longer = values.filter(|value| !value.is_empty());
        let mut longer = longer.map(|value| format!("{text}{} = {value}\n", key.name));
        if let Some(longer) = longer.find(|longer| run(longer.as_bytes())) {
            text = longer;
        }
    }
    text
}
