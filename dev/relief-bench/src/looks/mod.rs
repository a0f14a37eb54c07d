//! `looks`: first pictures of `relief render`, measured by what makes a picture good to look at, and their
//! times beside pictures of `--look plain`; and a sheet of materials.

mod cases;
mod measures;
mod picture;
mod pictures;
mod sets;
mod sheet;
mod textures;
mod times;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::{Args, ValueEnum};

/// Arguments of `looks`.
#[derive(Args)]
pub struct Arguments {
    /// What is measured
    #[arg(value_enum, default_values = ["pictures", "times"])]
    parts: Vec<Part>,
    /// The command that renders
    #[arg(long, value_name = "FILE", default_value = "target/release/relief")]
    relief: PathBuf,
    /// Look of the pictures, or of the times that are compared with `plain` [default: none for pictures,
    /// so that the command chooses; studio for times]
    #[arg(long, value_name = "NAME")]
    look: Option<String>,
    /// Only pictures whose name has this text in it
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Sheet of all pictures to write, PNG or JPEG
    #[arg(short, long, value_name = "FILE", default_value = "looks.jpg")]
    output: PathBuf,
    /// Folder with the glTF models of the sheet of sets
    #[arg(long, value_name = "FOLDER")]
    models: Option<PathBuf>,
    /// Runs of each command that is timed; medians count
    #[arg(
        long,
        value_name = "N",
        default_value_t = 5,
        value_parser = clap::value_parser!(u16).range(1..=100)
    )]
    rounds: u16,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// Outline, coverage, margins, shadows and clipping of every picture, and a sheet of them
    Pictures,
    /// A sheet of ten sets of textures, glTF models and two blocks; fails where a texture is not taken
    Sets,
    /// Seconds of a first picture beside `--look plain`, and of shadows between surfaces
    Times,
}

/// Prints the tables, and fails where a bound is missed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let relief = arguments.relief.canonicalize();
    let relief = relief.map_err(|error| format!("{}: {error}", arguments.relief.display()))?;
    let relief = Relief(relief);
    let mut holds = true;
    for part in &arguments.parts {
        holds &= match part {
            Part::Pictures => pictures::run(&relief, arguments)?,
            Part::Sets => sets::run(&relief, arguments)?,
            Part::Times => times::run(&relief, arguments)?,
        };
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The command `relief`.
struct Relief(PathBuf);

impl Relief {
    /// Renders a picture without a cache. Returns what the command printed on its standard output.
    fn render(&self, arguments: &[OsString], output: &Path) -> Result<String, String> {
        let mut command = Command::new(&self.0);
        command.args(["render", "--quiet", "--no-cache"]).args(arguments).arg("-o").arg(output);
        let ran = command.output().map_err(|error| format!("{}: {error}", self.0.display()))?;
        if ran.status.success() {
            return Ok(String::from_utf8_lossy(&ran.stdout).into_owned());
        }
        let text = String::from_utf8_lossy(&ran.stderr);
        let line = text.lines().find(|line| line.starts_with("error")).or(text.lines().next());
        Err(line.unwrap_or("the command failed without a word").trim_start_matches("error: ").to_owned())
    }
}

/// `PASS` or `MISS`, for a table.
fn verdict(holds: bool) -> &'static str {
    if holds { "PASS" } else { "MISS" }
}
