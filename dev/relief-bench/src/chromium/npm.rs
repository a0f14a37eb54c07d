//! Packages of npm, locked in `dev/npm`, which the other checks use too.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// Version of three.js in npm, and what it calls itself.
pub const THREE: &str = "0.187.0";
pub const REVISION: &str = "187";

/// Version of Babylon.js in npm.
pub const BABYLON: &str = "9.35.0";

/// Returns the folder of the packages. Installs them if they are missing, or older than their list.
pub fn modules() -> Result<PathBuf, String> {
    let npm = Path::new(env!("CARGO_MANIFEST_DIR")).join("../npm");
    let changed = |file: &str| -> Option<SystemTime> { npm.join(file).metadata().ok()?.modified().ok() };
    let is_there = changed("node_modules/.package-lock.json")
        .zip(changed("package-lock.json"))
        .is_some_and(|(installed, listed)| installed >= listed);
    if !is_there {
        let arguments = ["ci", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix"];
        let output = Command::new("npm").args(arguments).arg(&npm).output();
        let output =
            output.map_err(|error| format!("npm cannot be run ({error}): install Node.js with npm"))?;
        if !output.status.success() {
            return Err(format!("npm failed: {}", String::from_utf8_lossy(&output.stderr).trim()));
        }
    }
    Ok(npm.join("node_modules"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_what_is_locked() {
        let package = include_str!("../../../npm/package.json");
        let lock = include_str!("../../../npm/package-lock.json");
        for (name, version) in [("three", THREE), ("babylonjs", BABYLON)] {
            assert!(package.contains(&format!("\"{name}\": \"{version}\"")));
            assert!(lock.contains(&format!("\"version\": \"{version}\"")));
        }
        assert_eq!(THREE.split('.').nth(1), Some(REVISION));
    }
}
