//! Command `relief` as a library, so that tests and the documentation of its flags reach it.
//! Programs should use the crate `relief` instead: this one prints, asks and exits.

use std::process::ExitCode;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use failure::Failure;
use say::Verbosity;
use streams::{Files, Streams};

mod advice;
mod commands;
mod cut;
mod failure;
mod file_kind;
mod frames;
mod interrupt;
mod lanes;
mod most_used;
mod pattern;
mod progress;
mod say;
mod streams;
mod units;
mod values;
mod waiting;

/// Displacement mapping: turns height maps and meshes into pictures, baked maps, displaced meshes
/// and shaders.
#[derive(Parser)]
#[command(name = "relief", version, propagate_version = true, max_term_width = 100)]
#[command(after_help = "Start with: relief render data/bricks.png -o bricks.png\n\n\
    Exit codes: 0 done; 1 the work failed and no file was written; 2 the command line is wrong. After code \
    1, `render --frames` keeps finished frames, and `compare` keeps its page if no method keeps --budget-ms \
    or --max-error.")]
struct Arguments {
    #[command(flatten)]
    common: Common,
    #[command(subcommand)]
    command: Command,
}

/// Flags of all commands.
#[derive(Args)]
struct Common {
    /// Print only errors and what was asked for: no progress, notes or names of written files
    #[arg(short, long, global = true, conflicts_with = "verbose", display_order = 900)]
    quiet: bool,
    /// Also print each part of the work with its time
    #[arg(short, long, global = true, display_order = 901)]
    verbose: bool,
    /// Number of worker threads, 1 to 1024 [default: one per core]
    #[arg(
        long,
        value_name = "N",
        global = true,
        value_parser = clap::value_parser!(u16).range(1..=1024),
        display_order = 902
    )]
    threads: Option<u16>,
}

impl Common {
    fn apply(&self) -> Result<(), Failure> {
        // A wrong SIMD width is refused before any work, whatever the command is.
        lanes::from_environment()?;
        say::set(match (self.quiet, self.verbose) {
            (true, _) => Verbosity::Quiet,
            (_, true) => Verbosity::Verbose,
            _ => Verbosity::Usual,
        });
        let Some(threads) = self.threads else { return Ok(()) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads));
        pool.build_global().map_err(Failure::work)
    }
}

#[derive(Subcommand)]
enum Command {
    /// Render a height map on a mesh to a picture
    Render(Box<commands::render::Arguments>),
    /// Write a scene file of render's flags, with every key
    Scene(Box<commands::scene::Arguments>),
    /// Show a scene on a page in the browser, to turn and to change; or change it by a script
    View(Box<commands::view::Arguments>),
    /// Report on a height map (size, depth, range, used levels, histogram, whether it tiles), a mesh
    /// (size, charts, seams, hard edges, tile sizes) or a volume
    Inspect(commands::inspect::Arguments),
    /// Bake a height map into the maps that methods read: cones, normals, horizons and more
    Bake(Box<commands::bake::Arguments>),
    /// Make a height map from a normal map, photographs under known lights, a simple and a detailed
    /// mesh, a depth object, or a formula
    Height(commands::height::Arguments),
    /// Make a volume of a closed mesh, a height map, numbered pictures or a formula
    Volume(Box<commands::volume::Arguments>),
    /// Make a closed mesh of cloth, chain mail or grass that surfaces repeat
    Motif(commands::motif::Arguments),
    /// Displace a mesh by a height map, without cracks, and write a GLB, PLY, OBJ or STL file
    Mesh(Box<commands::mesh::Arguments>),
    /// Capture a mesh as a depth object: images with depth from several views
    Capture(Box<commands::capture::Arguments>),
    /// Write a scene's relief as shells (offset copies of its mesh), which any glTF viewer shows by
    /// an alpha test
    Slices(Box<commands::slices::Arguments>),
    /// Compare methods by the error of their hits, their cost and their pictures, as a page and as
    /// figures
    Compare(Box<commands::compare::Arguments>),
    /// Draw how a method finds its hit: every turn of its loops along one ray
    Explain(Box<commands::explain::Arguments>),
    /// Time frames of methods, part by part
    Bench(Box<commands::bench::Arguments>),
    /// Export a method as a shader for other programs (WGSL, GLSL, HLSL, MSL or SPIR-V), and its
    /// bindings
    Shader(Box<commands::shader::Arguments>),
    /// Write all that an engine needs to show a relief: shader, maps, mesh, material and a page or scene
    Engine(Box<commands::engine::Arguments>),
    /// List every method, search and refinement with its settings and guarantees
    Methods(commands::methods::Arguments),
    /// Print a shell's completions, or write the completions of all shells into files
    Completions(commands::completions::Arguments),
    /// Print a manual page, or write all of them into files
    Man(commands::man::Arguments),
}

/// Runs the command that the program's arguments name and returns the exit code: 0 done, 1 the work
/// failed, 2 the command line is wrong. Wrong arguments and `--help` end the program here.
pub fn run() -> ExitCode {
    let parsed = command().try_get_matches().and_then(|matches| Arguments::from_arg_matches(&matches));
    let mut arguments = match parsed {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() && std::env::args_os().any(|argument| argument == "--json") => {
            return Failure::unparsed(&error).report(true);
        }
        // Nobody reads an argument of a megabyte.
        Err(error) if error.use_stderr() && cut::is_long(&error.render().to_string()) => {
            return Failure::unparsed(&error).report(false);
        }
        Err(error) => error.exit(),
    };
    let json = arguments.command.json();
    match arguments.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(json),
    }
}

/// Returns the command line, as help and completions show it.
pub fn command() -> clap::Command {
    most_used::first(Arguments::command())
}

impl Arguments {
    fn run(&mut self) -> Result<(), Failure> {
        self.common.apply()?;
        let streams = Streams::open(self.command.files())?;
        self.command.run()?;
        streams.finish()
    }
}

impl Command {
    /// Returns the files that may be standard streams.
    fn files(&mut self) -> Files<'_> {
        match self {
            Command::Render(arguments) => arguments.files(),
            Command::Scene(arguments) => arguments.files(),
            Command::View(arguments) => arguments.files(),
            Command::Inspect(arguments) => arguments.files(),
            Command::Bake(arguments) => arguments.files(),
            Command::Height(arguments) => arguments.files(),
            Command::Volume(arguments) => arguments.files(),
            Command::Motif(arguments) => arguments.files(),
            Command::Mesh(arguments) => arguments.files(),
            Command::Capture(arguments) => arguments.files(),
            Command::Slices(arguments) => arguments.files(),
            Command::Compare(arguments) => arguments.files(),
            Command::Explain(arguments) => arguments.files(),
            Command::Bench(arguments) => arguments.files(),
            Command::Engine(arguments) => arguments.files(),
            Command::Shader(_) | Command::Methods(_) | Command::Completions(_) | Command::Man(_) => {
                Files::default()
            }
        }
    }

    /// Whether the answer is JSON.
    fn json(&self) -> bool {
        match self {
            Command::Render(arguments) => arguments.json,
            Command::View(arguments) => arguments.json,
            Command::Inspect(arguments) => arguments.json,
            Command::Bake(arguments) => arguments.json,
            Command::Height(arguments) => arguments.json(),
            Command::Volume(arguments) => arguments.json,
            Command::Motif(arguments) => arguments.json,
            Command::Mesh(arguments) => arguments.json,
            Command::Capture(arguments) => arguments.json,
            Command::Slices(arguments) => arguments.json,
            Command::Compare(arguments) => arguments.json,
            Command::Explain(arguments) => arguments.json,
            Command::Bench(arguments) => arguments.json,
            Command::Shader(arguments) => arguments.json,
            Command::Engine(arguments) => arguments.json,
            Command::Methods(arguments) => arguments.json,
            Command::Scene(_) | Command::Completions(_) | Command::Man(_) => false,
        }
    }

    fn run(&self) -> Result<(), Failure> {
        match self {
            Command::Render(arguments) => commands::render::run(arguments),
            Command::Scene(arguments) => commands::scene::run(arguments),
            Command::View(arguments) => commands::view::run(arguments),
            Command::Inspect(arguments) => commands::inspect::run(arguments),
            Command::Bake(arguments) => commands::bake::run(arguments),
            Command::Height(arguments) => commands::height::run(arguments),
            Command::Volume(arguments) => commands::volume::run(arguments),
            Command::Motif(arguments) => commands::motif::run(arguments),
            Command::Mesh(arguments) => commands::mesh::run(arguments),
            Command::Capture(arguments) => commands::capture::run(arguments),
            Command::Slices(arguments) => commands::slices::run(arguments),
            Command::Compare(arguments) => commands::compare::run(arguments),
            Command::Explain(arguments) => commands::explain::run(arguments),
            Command::Bench(arguments) => commands::bench::run(arguments),
            Command::Shader(arguments) => commands::shader::run(arguments),
            Command::Engine(arguments) => commands::engine::run(arguments),
            Command::Methods(arguments) => commands::methods::run(arguments),
            Command::Completions(arguments) => commands::completions::run(arguments, &command()),
            Command::Man(arguments) => commands::man::run(arguments, &command()),
        }
    }
}
