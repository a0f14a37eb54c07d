//! `compare`: what `relief-compare` finds of all methods on several maps, of their errors against their
//! times, and of their times against the size of the map, the covered pixels and the triangles; what reads
//! cost, and whether times and choices hold.

mod choose;
mod fetches;
mod hold;
pub mod maps;
mod pixels;
mod polygons;
mod sizes;
mod times;

use clap::{Args, ValueEnum};
use relief_compare::{Comparison, Contender, Machine, Records, Timing};
use relief_core::mesh::square;
use relief_core::{HeightMap, Watch};
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::{SHADOW, STAGES, Selection};
use relief_tests::accuracy;

/// Arguments of `compare`.
#[derive(Args)]
pub struct Arguments {
    /// What is printed
    #[arg(
        value_enum,
        default_values = ["maps", "times", "sizes", "pixels", "polygons", "fetches", "hold", "choose"]
    )]
    parts: Vec<Part>,
    /// Rays a map and angle
    #[arg(long, default_value_t = 20_000)]
    rays: u32,
    /// Frames of each that count; medians count
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..=1000))]
    frames: u32,
    /// Times on a GPU, too, or on a program that plays one
    #[arg(long)]
    gpu: bool,
    /// No times on the CPU
    #[arg(long, requires = "gpu")]
    no_cpu: bool,
    /// Columns and rows of the least pictures whose frames are timed on a GPU without the CPU
    #[arg(long, requires = "no_cpu", default_value = "320x240", value_parser = crate::frame::size)]
    size: [u32; 2],
}

impl Arguments {
    /// Where frames are timed: on the CPU, and with those ways of sampling on a GPU, as asked for.
    fn machines(&self, samplings: &[Sampling]) -> Vec<Machine> {
        let cpu = (!self.no_cpu).then_some(Machine::CPU);
        let gpu = samplings.iter().filter(|_| self.gpu).map(|sampling| Machine::gpu(*sampling));
        cpu.into_iter().chain(gpu).collect()
    }
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// Every method on five maps, beside the exact answer
    Maps,
    /// Errors against times, of methods over their steps
    Times,
    /// Times and reads over the size of the map
    Sizes,
    /// Times over covered pixels and over triangles
    Pixels,
    /// Two polygons beside triangles at every texel, in time and bytes
    Polygons,
    /// What reads cost that depend on others
    Fetches,
    /// Whether times hold: two runs in a row, and passes beside their frames
    Hold,
    /// Whether what is chosen for a budget or an error keeps it in another run, and is the best there
    Choose,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    for part in &arguments.parts {
        match part {
            Part::Maps => maps::run(arguments.rays)?,
            Part::Times => times::run(arguments)?,
            Part::Sizes => sizes::run(arguments)?,
            Part::Pixels => pixels::run(arguments)?,
            Part::Polygons => polygons::run(arguments)?,
            Part::Fetches => fetches::run(arguments)?,
            Part::Hold => hold::run(arguments)?,
            Part::Choose => choose::run(arguments)?,
        }
    }
    Ok(())
}

/// How deep the relief is, in tiles.
const SCALE_M: f64 = 0.1;

/// A comparison on a square of a tile of that map, in pictures of that size, without shadows.
fn on_square(
    name: &str,
    map: HeightMap,
    size: [u32; 2],
    machines: Vec<Machine>,
) -> Result<Comparison, String> {
    let map = map.with_displacement(SCALE_M, -SCALE_M).map_err(|error| error.to_string())?;
    let mesh = square(1).map_err(|error| error.to_string())?;
    let mut selection = Selection::exact();
    selection.choose(STAGES[SHADOW].key, "none").map_err(|error| error.to_string())?;
    let surface = Surface::new(mesh, map).with_selection(selection);
    let scene = Scene::builder(surface).size(size[0], size[1]).samples(1);
    let mut comparison = Comparison::new(name, scene.build().map_err(|error| error.to_string())?);
    comparison.contenders = Contender::all();
    (comparison.flicker_samples, comparison.timing, comparison.machines) = (None, None, machines);
    Ok(comparison)
}

/// Comparison of cobbles in small pictures with timed frames, on the CPU and, as requested, on a GPU. The
/// cost of displacement is timed with `pixels` times as many pixels.
fn timed_cobbles(arguments: &Arguments, pixels: u32) -> Result<Comparison, String> {
    let named = accuracy::maps()
        .into_iter()
        .find(|named| named.name == "cobbles")
        .ok_or("the sample map is missing")?;
    let machines = arguments.machines(&[Sampling::Exact, Sampling::Fast]);
    let mut comparison = on_square(named.name, named.map, arguments.size, machines)?;
    comparison.timing = Some(Timing { frames: arguments.frames, warm: 2, pixels });
    Ok(comparison)
}

fn compared(comparison: &Comparison) -> Result<Records, String> {
    comparison.run(&Watch::none()).map(|compared| compared.records).map_err(|error| error.to_string())
}

/// A method, or a pair, with settings.
fn contender(name: &str, settings: &[(&str, f64)]) -> Result<Contender, String> {
    let mut contender = Contender::named(name).map_err(|error| error.to_string())?;
    for (key, value) in settings {
        contender.selection.set(key, *value).map_err(|error| error.to_string())?;
        contender.name += &format!(" {key}={value}");
    }
    Ok(contender)
}
