//! Developer commands: `cargo xtask link` writes the linked shaders, `cargo xtask data` the sample maps.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

mod data;
mod link;
mod output;

#[derive(Parser)]
#[command(name = "xtask", about = "Developer commands of Relief")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Change nothing; fail when a generated file is not what would be written.
    #[arg(long, global = true)]
    check: bool,
}

#[derive(Subcommand)]
enum Command {
    /// Link the WESL modules to plain WGSL and translate them to Rust, into crates/relief-shaders/generated.
    Link,
    /// Generate the sample maps that the project made itself, into data.
    Data,
}

/// The root of the workspace.
fn workspace() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.ancestors().nth(2).unwrap_or(manifest).to_owned()
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match arguments.command {
        Command::Link => link::files(&workspace()),
        Command::Data => data::files(&workspace()),
    };
    let done = result.and_then(|files| output::settle(&workspace(), &files, arguments.check));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
