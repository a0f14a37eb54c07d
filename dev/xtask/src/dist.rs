//! Makes what a release holds: a static `relief` for Linux, with manual pages, completions, licences and
//! checksums, and starts it in an empty container.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

mod archive;
mod container;
mod licences;

/// The target of the build: its libc is linked statically, so the program runs on any Linux.
const TARGET: &str = "x86_64-unknown-linux-musl";

/// Builds the release and writes it into the folder `out`, by default `target/dist`.
///
/// # Errors
///
/// When the target's standard library is not installed, when a build or a run of the program fails, when a
/// dependency has no licence, or when a file cannot be written.
pub fn make(root: &Path, out: Option<&Path>) -> Result<(), String> {
    let out = out.map_or_else(|| root.join("target/dist"), Path::to_owned);
    let relief = build(root)?;
    let name = format!("relief-{}-{TARGET}", env!("CARGO_PKG_VERSION"));
    let staged = tempfile::tempdir().map_err(|error| format!("a temporary folder: {error}"))?;
    let folder = staged.path().join(&name);
    fs::create_dir_all(&folder).map_err(at(&folder))?;
    copy(&relief, &folder.join("relief"))?;
    for file in ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"] {
        copy(&root.join(file), &folder.join(file))?;
    }
    let licences = licences::of_dependencies(root, TARGET)?;
    let path = folder.join("THIRD-PARTY-LICENSES.txt");
    fs::write(&path, licences).map_err(at(&path))?;
    run(Command::new(&relief).args(["man", "--output"]).arg(folder.join("man")))?;
    run(Command::new(&relief).args(["completions", "--output"]).arg(folder.join("completions")))?;
    container::start(&folder.join("relief"))?;

    fs::create_dir_all(&out).map_err(at(&out))?;
    let file = out.join(format!("{name}.tar.gz"));
    let sum = archive::write(&folder, &name, &file)?;
    let sums = out.join(format!("{name}.tar.gz.sha256"));
    fs::write(&sums, format!("{sum}  {name}.tar.gz\n")).map_err(at(&sums))?;
    let bytes = fs::metadata(&file).map_err(at(&file))?.len();
    println!("{} ({} KiB), started in an empty container", file.display(), bytes / 1024);
    println!("{}", sums.display());
    Ok(())
}

/// Builds the command without the GPU backend: a static program cannot load a graphics driver.
fn build(root: &Path) -> Result<PathBuf, String> {
    let target_libdir = output(Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]))?;
    if !Path::new(target_libdir.trim()).is_dir() {
        return Err(format!("no standard library for {TARGET}; `rustup target add {TARGET}` installs it"));
    }
    let features = ["--no-default-features", "--features", "lanes"];
    run(cargo(root)
        .args(["build", "--release", "--package", "relief-cli", "--bin", "relief", "--target", TARGET])
        .args(features)
        .env("CARGO_PROFILE_RELEASE_STRIP", "symbols"))?;
    let metadata = output(cargo(root).args(["metadata", "--format-version", "1", "--no-deps"]))?;
    let metadata: serde_json::Value = serde_json::from_str(&metadata).map_err(|error| error.to_string())?;
    let folder = metadata["target_directory"].as_str().ok_or("cargo metadata names no target folder")?;
    Ok(Path::new(folder).join(TARGET).join("release/relief"))
}

fn cargo(root: &Path) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root);
    cargo
}

fn run(command: &mut Command) -> Result<(), String> {
    let status = command.status().map_err(|error| format!("{}: {error}", text(command)))?;
    if status.success() { Ok(()) } else { Err(format!("{}: {status}", text(command))) }
}

fn output(command: &mut Command) -> Result<String, String> {
    let done = command.output().map_err(|error| format!("{}: {error}", text(command)))?;
    if !done.status.success() {
        return Err(format!("{}: {}", text(command), String::from_utf8_lossy(&done.stderr).trim()));
    }
    String::from_utf8(done.stdout).map_err(|error| format!("{}: {error}", text(command)))
}

/// A command as it would be typed.
fn text(command: &Command) -> String {
    let parts = std::iter::once(command.get_program()).chain(command.get_args());
    parts.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ")
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    fs::copy(from, to).map(drop).map_err(at(from))
}

/// Names the file in an error.
fn at(path: &Path) -> impl Fn(std::io::Error) -> String + '_ {
    move |error| format!("{}: {error}", path.display())
}
