//! Rules for all sources: which files they may be, which texts may name flags, and how plain the English is.

use std::path::{Path, PathBuf};

mod files;
mod flags;
mod words;

/// The root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The folders of the crates that are published.
fn crates() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("crates")).expect("the workspace has crates");
    entries
        .map(|entry| entry.expect("the folder is readable").path())
        .filter(|folder| folder.join("src/lib.rs").is_file())
        .collect()
}
