//! Any text as an object's file: an error that says its line, or views that can be, never a crash.

#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use relief_object::{ObjectFileError, parse_description};

fuzz_target!(|text: &str| match parse_description(text, Path::new("object.toml")) {
    Ok(description) => {
        assert!((1..=1024).contains(&description.views.len()));
        for view in &description.views {
            let [_, _, width, height] = view.rect;
            assert!(view.spec.view(description.centre, description.radius, [width, height]).is_ok());
        }
    }
    Err(ObjectFileError::InFile { line, .. }) => {
        assert!((1..=text.lines().count().max(1) + 1).contains(&line), "line {line}");
    }
    Err(_) => {}
});
