//! The `relief` command as a library, so that tests and the documentation of its flags reach it. Programs take the
//! crate `relief` instead: this one prints, asks and exits.

use std::process::ExitCode;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use failure::Failure;
use say::Loudness;
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

/// Displacement mapping: a height map and a mesh go in, pictures, maps and displaced meshes come out.
#[derive(Parser)]
#[command(name = "relief", version, propagate_version = true, max_term_width = 100)]
#[command(after_help = "Start with: relief render --height data/bricks.png -o bricks.png\n\n\
    Exit codes: 0 done, 1 the work failed and no file was written (but for whole frames of render --frames, \
    and the page of compare where no method keeps --budget-ms or --max-error), 2 the command line is wrong.")]
struct Arguments {
    #[command(flatten)]
    common: Common,
    #[command(subcommand)]
    command: Command,
}

/// Flags of every command.
#[derive(Args)]
struct Common {
    /// Say nothing but errors and what was asked for: no progress, no notes, nothing about files
    #[arg(short, long, global = true, conflicts_with = "verbose", display_order = 900)]
    quiet: bool,
    /// Say what is done, too, and how long it takes
    #[arg(short, long, global = true, display_order = 901)]
    verbose: bool,
    /// Threads that work [default: one a core]
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
        // A wrong one is refused before anything is done, whatever the command is.
        lanes::from_environment()?;
        say::set(match (self.quiet, self.verbose) {
            (true, _) => Loudness::Quiet,
            (_, true) => Loudness::Verbose,
            _ => Loudness::Usual,
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
    /// Say what is in a height map (size, depth, range, used levels, histogram, whether it tiles), or in a
    /// mesh (size, charts, seams, hard edges, lengths of tiles)
    Inspect(commands::inspect::Arguments),
    /// Bake a height map into the maps that methods read: cones, normals, horizons and more
    Bake(Box<commands::bake::Arguments>),
    /// Make a height map from a normal map, photographs under known lights, or a simple and a detailed mesh
    Height(commands::height::Arguments),
    /// Displace a mesh by a height map, without cracks, to triangles in a glTF, PLY, OBJ or STL file
    Mesh(Box<commands::mesh::Arguments>),
    /// Capture a mesh in images with depth, which together are an image-based object
    Capture(Box<commands::capture::Arguments>),
    /// Write a scene's relief as shells, which any viewer of glTF shows by an alpha test
    Slices(Box<commands::slices::Arguments>),
    /// Compare methods: how wrong their hits are, what they cost and how they look, as a page and as figures
    Compare(Box<commands::compare::Arguments>),
    /// Time frames of methods, part by part
    Bench(Box<commands::bench::Arguments>),
    /// Export a method as a shader for other programs: WGSL, GLSL, HLSL, MSL or SPIR-V, and what it binds
    Shader(Box<commands::shader::Arguments>),
    /// List every method, search and refinement with its parameters and guarantees
    Methods(commands::methods::Arguments),
    /// Print what shells complete, or write it into files
    Completions(commands::completions::Arguments),
    /// Print a manual page, or write all of them into files
    Man(commands::man::Arguments),
}

/// Runs the command that the program's arguments name, and says how it ended: 0 done, 1 the work failed, 2 the
/// command line is wrong. Wrong arguments and `--help` end the program here.
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

/// The command line, as help and completions show it.
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
    /// The files that may be standard streams.
    fn files(&mut self) -> Files<'_> {
        match self {
            Command::Render(arguments) => arguments.files(),
            Command::Scene(arguments) => arguments.files(),
            Command::Inspect(arguments) => arguments.files(),
            Command::Bake(arguments) => arguments.files(),
            Command::Height(arguments) => arguments.files(),
            Command::Mesh(arguments) => arguments.files(),
            Command::Capture(arguments) => arguments.files(),
            Command::Slices(arguments) => arguments.files(),
            Command::Compare(arguments) => arguments.files(),
            Command::Bench(arguments) => arguments.files(),
            Command::Shader(_) | Command::Methods(_) | Command::Completions(_) | Command::Man(_) => {
                Files::default()
            }
        }
    }

    /// Whether the answer is for machines.
    fn json(&self) -> bool {
        match self {
            Command::Render(arguments) => arguments.json,
            Command::Inspect(arguments) => arguments.json,
            Command::Bake(arguments) => arguments.json,
            Command::Height(arguments) => arguments.json(),
            Command::Mesh(arguments) => arguments.json,
            Command::Capture(arguments) => arguments.json,
            Command::Slices(arguments) => arguments.json,
            Command::Compare(arguments) => arguments.json,
            Command::Bench(arguments) => arguments.json,
            Command::Shader(arguments) => arguments.json,
            Command::Methods(arguments) => arguments.json,
            Command::Scene(_) | Command::Completions(_) | Command::Man(_) => false,
        }
    }

    fn run(&self) -> Result<(), Failure> {
        match self {
            Command::Render(arguments) => commands::render::run(arguments),
            Command::Scene(arguments) => commands::scene::run(arguments),
            Command::Inspect(arguments) => commands::inspect::run(arguments),
            Command::Bake(arguments) => commands::bake::run(arguments),
            Command::Height(arguments) => commands::height::run(arguments),
            Command::Mesh(arguments) => commands::mesh::run(arguments),
            Command::Capture(arguments) => commands::capture::run(arguments),
            Command::Slices(arguments) => commands::slices::run(arguments),
            Command::Compare(arguments) => commands::compare::run(arguments),
            Command::Bench(arguments) => commands::bench::run(arguments),
            Command::Shader(arguments) => commands::shader::run(arguments),
            Command::Methods(arguments) => commands::methods::run(arguments),
            Command::Completions(arguments) => commands::completions::run(arguments, &command()),
            Command::Man(arguments) => commands::man::run(arguments, &command()),
        }
    }
}
