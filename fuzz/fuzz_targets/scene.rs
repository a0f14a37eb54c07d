//! Any text as a scene file: an error that says its line, or a scene that can be loaded with a map of a few
//! texels and described again, never a crash.

#![no_main]

use std::path::Path;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use relief_core::ByteSize;
use relief_render::scene::{MeshChoice, SceneError, parse_scene};

/// A height map of two by two texels.
static MAP: LazyLock<tempfile::NamedTempFile> = LazyLock::new(|| {
    let file = tempfile::Builder::new().suffix(".pgm").tempfile().expect("a temporary file");
    std::fs::write(file.path(), b"P5 2 2 255\n\x00\x40\x80\xff").expect("it can be written");
    file
});

fuzz_target!(|text: &str| {
    let mut spec = match parse_scene(text, Path::new("scene.toml")) {
        Ok(spec) => spec,
        Err(SceneError::InFile { line, .. } | SceneError::Key { line, .. }) => {
            assert!((1..=text.lines().count().max(1) + 1).contains(&line), "line {line}");
            return;
        }
        Err(_) => return,
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
    if let Ok(scene) = spec.load() {
        assert!(!scene.surfaces().is_empty());
        assert!(scene.camera().eye().is_finite() && scene.camera().half_height() > 0.0);
        assert!(scene.to_builder().build().is_ok());
    }
});
