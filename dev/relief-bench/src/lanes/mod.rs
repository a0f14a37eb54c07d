//! Gain of the machine's vectors on the CPU, beside the same work without them.

use clap::{Args, ValueEnum};

mod compute;
mod frames;
mod packets;
mod pictures;
mod rays;
mod stages;
mod tiles;

/// Arguments of `lanes`.
#[derive(Args)]
pub struct Arguments {
    /// Parts to measure [default: all]
    #[arg(value_enum)]
    parts: Vec<Part>,
    /// Number of rounds; the fastest counts
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Part {
    /// Camera rays against base meshes, and whole frames that hardly do more
    Tiles,
    /// The exact tracer, beside Embree's packets where Embree 3 and a C++ compiler are installed
    Packets,
    /// Searches and refinements
    Stages,
    /// The same in a compute pass of the machine's adapter, beside lanes on all threads
    Compute,
    /// Whole pictures, beside the machine's adapter
    Pictures,
}

pub fn run(arguments: &Arguments) -> Result<(), String> {
    let is_asked = |part| arguments.parts.is_empty() || arguments.parts.contains(&part);
    if is_asked(Part::Tiles) {
        tiles::run(arguments.rounds)?;
    }
    if is_asked(Part::Packets) {
        packets::run(arguments.rounds)?;
    }
    if is_asked(Part::Stages) {
        stages::run(arguments.rounds)?;
    }
    if is_asked(Part::Compute) {
        compute::run(arguments.rounds)?;
    }
    if is_asked(Part::Pictures) {
        pictures::run(arguments.rounds)?;
    }
    Ok(())
}
