//! Developer commands: `cargo xtask link` writes the linked shaders, `cargo xtask data` the sample
//! maps, `cargo xtask guide` the guide's pictures, `cargo xtask dist` a release, `cargo xtask web` the
//! module for the web; `cargo xtask web-test` uses the page of `relief view` in a browser, `cargo
//! xtask words` counts words.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

mod data;
mod dist;
mod guide;
mod link;
mod output;
mod web;
mod web_test;
mod words;

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
    /// Run the commands of README and docs/guide, and make the pictures that they show.
    Guide {
        /// Program to run [default: relief, built in the profile of xtask].
        #[arg(long)]
        relief: Option<PathBuf>,
    },
    /// Make a release: a static relief for Linux, packed with man pages, completions and licences.
    Dist {
        /// Folder for archive and checksum [default: target/dist].
        #[arg(short, long)]
        output: Option<PathBuf>,
    },
    /// Build the page of the viewer for static hosts into target/web: it draws in the browser, without a
    /// server. Prints the size of its module. With --check, build the module quickly, and compare what it
    /// renders in Node and in a browser with what relief renders.
    Web {
        /// Serve the page at this port of this machine.
        #[arg(long, value_name = "PORT")]
        serve: Option<u16>,
        /// Chromium or Chrome, for --check.
        #[arg(long, default_value = "chromium")]
        browser: PathBuf,
        /// Program to compare with [default: relief, built in the profile of xtask].
        #[arg(long)]
        relief: Option<PathBuf>,
    },
    /// Use the page of `relief view` in headless Chromium, as a person does.
    WebTest {
        /// Program to run [default: relief, built in the profile of xtask].
        #[arg(long)]
        relief: Option<PathBuf>,
        /// Chromium or Chrome.
        #[arg(long, default_value = "chromium")]
        browser: PathBuf,
        /// Run the tests whose names hold this.
        #[arg(long)]
        only: Option<String>,
    },
    /// Count worn phrases in comments, and sentence lengths of pages.
    Words {
        /// Folders with Rust sources.
        #[arg(required = true)]
        folders: Vec<PathBuf>,
    },
}

/// The root of the workspace.
fn workspace() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.ancestors().nth(2).unwrap_or(manifest).to_owned()
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let root = workspace();
    let settle = |files: Vec<output::Generated>| output::settle(&root, &files, arguments.check);
    let done = match arguments.command {
        Command::Link => link::files(&root).and_then(settle),
        Command::Data => data::files(&root).and_then(settle),
        Command::Guide { relief } => guide::settle(&root, relief.as_deref(), arguments.check),
        Command::Dist { output } => dist::make(&root, output.as_deref()),
        Command::Web { relief, serve, browser } => match arguments.check {
            true => web::check(&root, relief.as_deref(), &browser),
            false => web::make(&root, serve),
        },
        Command::WebTest { relief, browser, only } => {
            web_test::run(&root, relief.as_deref(), &browser, only.as_deref())
        }
        Command::Words { folders } => words::print(&folders),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
