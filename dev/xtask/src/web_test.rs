//! The page of `relief view`, used in headless Chromium by `dev/npm/view.mjs`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::guide::run::build;

/// Installs the packages of the tests, and runs them.
///
/// # Errors
///
/// When a package or the browser is missing, or a test fails: it has said so.
pub fn run(root: &Path, relief: Option<&Path>, browser: &Path, only: Option<&str>) -> Result<(), String> {
    let relief = match relief {
        Some(path) => std::path::absolute(path).map_err(|error| format!("{}: {error}", path.display()))?,
        None => build()?,
    };
    let packages = packages(root)?;
    let mut tests = Command::new("node");
    tests.arg(packages.join("view.mjs")).arg(relief).arg("--browser").arg(found(browser)?);
    if let Some(only) = only {
        tests.args(["--only", only]);
    }
    succeed(&mut tests)
}

/// Installs the packages of tests in a browser. Returns their folder.
pub fn packages(root: &Path) -> Result<PathBuf, String> {
    let packages = root.join("dev/npm");
    let mut install = Command::new("npm");
    install.arg("ci").arg("--prefix").arg(&packages);
    succeed(install.args(["--silent", "--no-audit", "--no-fund", "--ignore-scripts"]))?;
    Ok(packages)
}

/// The path of a program.
pub fn found(program: &Path) -> Result<PathBuf, String> {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let known = std::env::split_paths(&folders).map(|folder| folder.join(program));
    let mut known = known.chain([program.to_owned()]);
    known
        .find(|path| path.is_file())
        .ok_or_else(|| format!("{}: there is no such program: give it by --browser", program.display()))
}

pub fn succeed(command: &mut Command) -> Result<(), String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command.status().map_err(|error| format!("{name}: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("{name}: it failed ({status})")) }
}
