//! Runs `relief` in a scratch folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// Commands that choose a backend.
const WITH_BACKEND: [&str; 3] = ["render", "compare", "bench"];

/// A folder with copies of the sample maps and scenes, removed when dropped.
pub struct Scratch(TempDir);

impl Scratch {
    /// Copies `data/` and `scenes/`, as a reader's working folder has them.
    pub fn new(root: &Path) -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| format!("a scratch folder: {error}"))?;
        for name in ["data", "scenes", "scenes/gallery"] {
            copy_files(&root.join(name), &folder.path().join(name))?;
        }
        Ok(Self(folder))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) -> Result<(), String> {
        std::fs::write(self.path(name), text).map_err(|error| format!("{name}: {error}"))
    }

    /// Runs `relief` with these arguments, on the CPU and with a cache of its own.
    pub fn run(&self, relief: &Path, words: &[String]) -> Result<(), String> {
        let mut command = Command::new(relief);
        command.args(words).current_dir(self.0.path());
        if words.first().is_some_and(|word| WITH_BACKEND.contains(&word.as_str()))
            && !words.iter().any(|word| word == "--backend")
        {
            command.args(["--backend", "cpu"]);
        }
        command.env("RELIEF_CACHE", self.path("cache"));
        let done = command.output().map_err(|error| format!("{}: {error}", relief.display()))?;
        if done.status.success() {
            return Ok(());
        }
        let said = String::from_utf8_lossy(&done.stderr);
        Err(format!("relief {}: {}: {}", words.join(" "), done.status, said.trim()))
    }
}

fn copy_files(from: &Path, to: &Path) -> Result<(), String> {
    let copied = || {
        std::fs::create_dir_all(to)?;
        for entry in std::fs::read_dir(from)? {
            let entry = entry?;
            if entry.file_type()?.is_file() {
                std::fs::copy(entry.path(), to.join(entry.file_name()))?;
            }
        }
        Ok::<(), std::io::Error>(())
    };
    copied().map_err(|error| format!("copying {}: {error}", from.display()))
}

/// Builds `relief` in the profile of this program, and returns its path, which is beside this program's.
pub fn build() -> Result<PathBuf, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["build", "--quiet", "--bin", "relief"]);
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    let status = command.status().map_err(|error| format!("cargo: {error}"))?;
    if !status.success() {
        return Err(format!("building relief: {status}"));
    }
    let own = std::env::current_exe().map_err(|error| format!("the path of xtask: {error}"))?;
    Ok(own.with_file_name(format!("relief{}", std::env::consts::EXE_SUFFIX)))
}
