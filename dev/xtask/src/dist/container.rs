//! An empty container: a root folder that holds the program and its input, and nothing else.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{at, copy, run};

/// A height map of 4 x 4 texels.
const HEIGHTS: &[u8] = b"P2 4 4 3\n0 1 2 3 1 2 3 0 2 3 0 1 3 0 1 2\n";

/// Starts a program in a folder that is its whole file system: it prints its methods and renders a picture.
///
/// # Errors
///
/// When the container cannot be made, or when the program needs a file of the system, fails or writes no
/// picture.
pub fn start(program: &Path) -> Result<(), String> {
    let inside = tempfile::tempdir().map_err(|error| format!("a temporary folder: {error}"))?;
    copy(program, &inside.path().join("relief"))?;
    let heights = inside.path().join("heights.pgm");
    fs::write(&heights, HEIGHTS).map_err(at(&heights))?;
    // A user of its own may enter another root folder without being an administrator.
    let contained = || {
        let mut command = Command::new("unshare");
        command.args(["--map-root-user", "chroot"]).arg(inside.path()).arg("/relief").env_clear();
        command.envs(std::env::var_os("PATH").map(|path| ("PATH", path)));
        command
    };
    run(contained().arg("methods").stdout(std::process::Stdio::null()))?;
    let rendering = ["render", "/heights.pgm", "--size", "64x48", "--no-cache", "-q", "-o", "/picture.png"];
    run(contained().args(rendering))?;
    let picture = inside.path().join("picture.png");
    let bytes = fs::metadata(&picture).map_err(at(&picture))?.len();
    if bytes == 0 { Err("the program wrote an empty picture".to_owned()) } else { Ok(()) }
}
