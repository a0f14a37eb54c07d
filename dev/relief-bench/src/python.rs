//! A Python with packages of PyPI that other programs' figures need.

use std::path::Path;
use std::process::Command;

/// Whether there is such a Python: it must run `check`, which imports what these packages have.
///
/// # Errors
///
/// When there is none, with what is missing and how to get it.
pub fn require(python: &Path, check: &str, packages: &str) -> Result<(), String> {
    let name = python.display();
    let install = format!(
        "make one with `python3 -m venv VENV && VENV/bin/pip install {packages}` and give VENV/bin/python"
    );
    match Command::new(python).args(["-c", check]).output() {
        Err(error) => Err(format!("{name} cannot be run ({error}): {install}")),
        Ok(output) if !output.status.success() => {
            let text = String::from_utf8_lossy(&output.stderr);
            let last = text.lines().last().unwrap_or_default();
            Err(format!("{name} lacks a package ({last}): {install}"))
        }
        Ok(_) => Ok(()),
    }
}
