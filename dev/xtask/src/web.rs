//! The viewer as a module for the web: `web`, with the JavaScript side that `web/bindings` writes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::guide::run::build;
use crate::web_test::succeed;

const TARGET: &str = "wasm32-unknown-unknown";

/// Crates that a check compiles for speed, because they do most of the work of a picture. All others are not
/// optimised: the check takes less time in all.
const WORKING: [&str; 3] = ["relief-core", "relief-render", "relief-shaders"];

/// Builds the module in the profile `web` into `target/web-module`, and prints its size.
///
/// # Errors
///
/// When the target's standard library or Node is missing, or a build fails: it has said so.
pub fn make(root: &Path) -> Result<(), String> {
    let folder = written("web", &[], "web-module")?;
    succeed(script(root).arg("--size").arg(&folder))?;
    println!("wrote {}", folder.display());
    Ok(())
}

/// Builds the module quickly, and compares its pictures in Node with those of `relief`.
///
/// # Errors
///
/// See [`make`]. Also when a picture differs.
pub fn check(root: &Path, relief: Option<&Path>) -> Result<(), String> {
    let relief = relief.map_or_else(build, |path| Ok(path.to_owned()))?;
    let of_crate =
        |name: &&str| ["--config".to_owned(), format!("profile.release.package.{name}.opt-level=1")];
    let mut quick = vec!["--config".to_owned(), "profile.release.opt-level=0".to_owned()];
    quick.extend(WORKING.iter().flat_map(of_crate));
    let folder = written("release", &quick, "web-check")?;
    succeed(script(root).arg(&folder).arg(relief))
}

/// Builds the module in a profile with more arguments of cargo, and writes it with its JavaScript side into a
/// folder of the target folder. Returns the folder.
fn written(profile: &str, more: &[String], name: &str) -> Result<PathBuf, String> {
    let cargo = || Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let build = |arguments: &[&str]| succeed(cargo().args(["build", "--quiet"]).args(arguments));
    succeed(
        cargo()
            .args(["build", "--quiet", "-p", "relief-web", "--target", TARGET, "--profile", profile])
            .args(more),
    )?;
    // It runs for a second, and is compiled for longer.
    build(&["-p", "relief-web-bindings", "--release", "--config", "profile.release.opt-level=0"])?;
    let target = target_folder()?;
    let module = target.join(TARGET).join(profile).join("relief_web.wasm");
    let folder = target.join(name);
    let program = format!("relief-web-bindings{}", std::env::consts::EXE_SUFFIX);
    succeed(Command::new(target.join("release").join(program)).arg(module).arg(&folder))?;
    Ok(folder)
}

/// The folder of all builds, in which this program lies in the folder of a profile.
fn target_folder() -> Result<PathBuf, String> {
    let own = std::env::current_exe().map_err(|error| format!("the path of xtask: {error}"))?;
    own.ancestors().nth(2).map(Path::to_owned).ok_or_else(|| format!("{}: it is in no folder", own.display()))
}

fn script(root: &Path) -> Command {
    let mut node = Command::new("node");
    node.arg(root.join("dev/npm/web.mjs"));
    node
}
