//! The `relief` command.

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Failure;

mod advice;
mod commands;
mod failure;
mod progress;
mod values;
mod waiting;

/// Displacement mapping: a height map and a mesh go in, a picture comes out.
#[derive(Parser)]
#[command(name = "relief", version, propagate_version = true, max_term_width = 100)]
#[command(after_help = "Start with: relief render --height data/bricks.png -o bricks.png")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Render a height map on a mesh to a picture
    Render(Box<commands::render::Arguments>),
    /// Say what is in a height map: size, depth, range, used levels, histogram, whether it tiles
    Inspect(commands::inspect::Arguments),
    /// Bake a height map into the maps that methods read: cones, normals, horizons and more
    Bake(Box<commands::bake::Arguments>),
    /// Make a height map from a normal map, or from photographs under known lights
    Height(commands::height::Arguments),
    /// List every method, search and refinement with its parameters and guarantees
    Methods(commands::methods::Arguments),
}

/// Keeps graphics drivers from complaining on standard error that there is no desktop, among `--json`'s errors, too:
/// a layer of Mesa's drivers looks for the desktop's GPU when it lists adapters.
#[cfg(target_os = "linux")]
fn quieten_drivers() {
    let desktop = ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "DISPLAY"];
    if desktop.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: this is the first thing that the program does, so no other thread reads the environment.
        #[allow(unsafe_code)]
        unsafe {
            std::env::set_var("NODEVICE_SELECT", "1");
        }
    }
}

fn main() -> ExitCode {
    #[cfg(target_os = "linux")]
    quieten_drivers();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() && std::env::args_os().any(|argument| argument == "--json") => {
            return Failure::unparsed(&error).report(true);
        }
        Err(error) => error.exit(),
    };
    let (result, json) = match &arguments.command {
        Command::Render(arguments) => (commands::render::run(arguments), arguments.json),
        Command::Inspect(arguments) => (commands::inspect::run(arguments), arguments.json),
        Command::Bake(arguments) => (commands::bake::run(arguments), arguments.json),
        Command::Height(arguments) => (commands::height::run(arguments), arguments.json()),
        Command::Methods(arguments) => (commands::methods::run(arguments), arguments.json),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(json),
    }
}
