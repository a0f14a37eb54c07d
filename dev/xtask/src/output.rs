//! Generated files: written where they differ, or compared with what is there.

use std::path::{Path, PathBuf};

/// A file to be generated, its path relative to the workspace.
pub struct Generated {
    pub path: PathBuf,
    pub bytes: Vec<u8>,
}

/// Writes the files that differ, or with `check` fails when one does.
pub fn settle(root: &Path, files: &[Generated], check: bool) -> Result<(), String> {
    let mut stale = Vec::new();
    for file in files {
        let path = root.join(&file.path);
        if std::fs::read(&path).is_ok_and(|there| there == file.bytes) {
            continue;
        }
        if check {
            stale.push(file.path.display().to_string());
            continue;
        }
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        }
        std::fs::write(&path, &file.bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("wrote {}", file.path.display());
    }
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!("stale: {}; run the same command without --check and commit the result", stale.join(", ")))
}
