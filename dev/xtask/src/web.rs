//! The viewer as a module for the web: `web`, with the JavaScript side that `web/bindings` writes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::guide::run::build;
use crate::web_test::{found, packages, succeed};

const TARGET: &str = "wasm32-unknown-unknown";

/// Crates that a check compiles for speed, because they do most of the work of a picture. All others are not
/// optimised: the check takes less time in all.
const WORKING: [&str; 3] = ["relief-core", "relief-render", "relief-shaders"];

/// Builds the module in the profile `module`, writes the page with it into `target/web`, for any
/// static host, and prints what it takes. With `serve` it also serves the page at this port of the
/// machine, until it is stopped.
///
/// # Errors
///
/// When the target's standard library or Node is missing, or a build fails: it has said so.
pub fn make(root: &Path, serve: Option<u16>) -> Result<(), String> {
    let module = written("module", &[], "web-module")?;
    let folder = target_folder()?.join("web");
    page(root, &module, &folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    println!("wrote {}", folder.display());
    succeed(script(root).arg("--size").arg(&folder))?;
    match serve {
        Some(port) => {
            let mut node = Command::new("node");
            succeed(node.arg(root.join("dev/npm/serve.mjs")).arg(folder).arg(port.to_string()))
        }
        None => Ok(()),
    }
}

/// Files of the page that speak to the program of `relief view`: the web has its own.
const OF_PROGRAM: [&str; 2] = ["main.js", "host.js"];

/// What the page shows at first.
const SAMPLES: [&str; 2] = ["cobbles.png", "cobbles_color.png"];

/// Writes the page with a module into a folder, in place of what was there.
fn page(root: &Path, module: &Path, folder: &Path) -> std::io::Result<()> {
    if folder.exists() {
        std::fs::remove_dir_all(folder)?;
    }
    std::fs::create_dir_all(folder.join("samples"))?;
    let sources = [root.join("crates/relief-cli/page"), module.to_owned(), root.join("web/page")];
    for (number, source) in sources.iter().enumerate() {
        for file in std::fs::read_dir(source)? {
            let file = file?;
            let name = file.file_name();
            let is_left_out = number == 0 && OF_PROGRAM.iter().any(|other| name == *other);
            // The settings of the type checker stay with the sources.
            if !is_left_out && file.path().extension().is_none_or(|ending| ending != "json") {
                std::fs::copy(file.path(), folder.join(name))?;
            }
        }
    }
    for sample in SAMPLES {
        std::fs::copy(root.join("data").join(sample), folder.join("samples").join(sample))?;
    }
    Ok(())
}

/// Builds the module quickly, and compares its pictures with the command's: in Node, and
/// on the page in a browser.
///
/// # Errors
///
/// See [`make`]. Also when a picture differs, or the browser is missing.
pub fn check(root: &Path, relief: Option<&Path>, browser: &Path) -> Result<(), String> {
    let browser = found(browser)?;
    let relief = relief.map_or_else(build, |path| Ok(path.to_owned()))?;
    let of_crate =
        |name: &&str| ["--config".to_owned(), format!("profile.release.package.{name}.opt-level=1")];
    let mut quick = vec!["--config".to_owned(), "profile.release.opt-level=0".to_owned()];
    quick.extend(WORKING.iter().flat_map(of_crate));
    let module = written("release", &quick, "web-check")?;
    succeed(script(root).arg(&module).arg(&relief))?;
    let folder = target_folder()?.join("web-check-page");
    page(root, &module, &folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut tests = Command::new("node");
    tests.arg(packages(root)?.join("web_page.mjs")).arg(folder).arg(relief);
    succeed(tests.arg("--browser").arg(browser))
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
