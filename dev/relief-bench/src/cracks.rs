//! `cracks`: what shines through reliefs on closed meshes, from many random sides.

use std::process::ExitCode;

use clap::Args;
use clap::builder::PossibleValuesParser;
use indicatif::ProgressBar;
use relief_core::rng::Rng;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Sampling};
use relief_tests::curved::{Comparison, Curved, Drawn, Judged, Picture};

use crate::surfaces::Lies;
use crate::surfaces::bases::{Base, cobbles};
use crate::table::table;

/// The meshes without seams of their frames, or whose seams do not show.
const MESHES: [&str; 4] = ["torus-128x64", "torus-32x16", "torus-16x8", "sphere-32x16"];

/// The surfaces whose neighbours share their sides.
const SURFACES: [&str; 2] = ["prism", "tetrahedra"];

/// Arguments of `cracks`.
#[derive(Args)]
pub struct Arguments {
    /// Random views of each mesh, from far and from near
    #[arg(long, default_value_t = 200)]
    views: u32,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 160)]
    width: u32,
    /// Metres between the heights 0 and 1, on meshes that are 1 m large
    #[arg(long, default_value_t = 0.03)]
    scale: f64,
    /// Where the relief lies [default: both]
    #[arg(long, value_enum)]
    relief: Option<Lies>,
    /// Where the pictures are made: cpu, gpu
    #[arg(long, value_delimiter = ',', default_value = "cpu")]
    backend: Vec<BackendChoice>,
    /// Meshes
    #[arg(long, value_delimiter = ',', default_values = ["torus-32x16", "sphere-32x16"],
        value_parser = PossibleValuesParser::new(MESHES))]
    mesh: Vec<String>,
    /// Surfaces
    #[arg(long, value_delimiter = ',', default_values = SURFACES,
        value_parser = PossibleValuesParser::new(SURFACES))]
    surface: Vec<String>,
}

/// A surface on a backend.
struct Row {
    drawn: Drawn,
    backend: BackendChoice,
    renderer: Renderer,
    device: String,
    comparison: Comparison,
}

/// Prints the table, and fails where something shines through.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let map = cobbles()?;
    let lies = Lies::chosen(arguments.relief);
    let size = [arguments.width, arguments.width * 3 / 4];
    let mut table =
        table(&["mesh", "relief", "surface", "device", "hits", "open", "of all", "behind", "of all"]);
    let meshes = MESHES.iter().filter(|name| arguments.mesh.iter().any(|asked| asked == *name));
    let names: Vec<&str> = meshes.copied().collect();
    let progress = ProgressBar::new(names.len() as u64 * lies.len() as u64 * u64::from(arguments.views));
    let mut cracks = 0;
    for name in names {
        let Some(base) = Base::of(name)? else { continue };
        for lies in &lies {
            let scale_m = arguments.scale;
            let curved = Curved::new(base.mesh.clone(), &map, scale_m, lies.bias_m(scale_m));
            for row in looked_at(arguments, &curved, size, &progress)? {
                let Comparison { both, open, all_open, behind, all_behind, .. } = row.comparison;
                // Tetrahedra show a surface of their own, which may lie behind the judge's.
                cracks += open + if row.drawn.surface == "prism" { behind } else { 0 };
                let counts = [both, open, all_open, behind, all_behind].map(|count| count.to_string());
                let first = [name, lies.name(), row.drawn.surface, &row.device].map(str::to_owned);
                table.add_row(first.into_iter().chain(counts));
            }
        }
    }
    progress.finish_and_clear();
    println!(
        "{} random views of each, half of them nearer, {}x{} pixels.\n\n{table}",
        arguments.views, size[0], size[1]
    );
    Ok(if cracks == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A relief from all sides, on all surfaces and backends beside what the judge sees once.
fn looked_at(
    arguments: &Arguments,
    curved: &Curved,
    size: [u32; 2],
    progress: &ProgressBar,
) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    for surface in SURFACES.into_iter().filter(|name| arguments.surface.iter().any(|asked| asked == name)) {
        for &backend in &arguments.backend {
            rows.push(Row {
                drawn: Drawn::flat(surface),
                backend,
                renderer: Renderer::new(backend, Sampling::Exact).map_err(|error| error.to_string())?,
                device: String::new(),
                comparison: Comparison::default(),
            });
        }
    }
    let (mut rng, judge) = (Rng::new(5), curved.judge());
    for view in 0..arguments.views {
        let closeness = if view % 2 == 0 { 1.0 } else { rng.between(1.0, 2.0) };
        let camera = curved.random_camera(&mut rng, closeness);
        let judged = Judged::new(&judge, camera, size);
        for row in &mut rows {
            let scene = curved.scene(row.drawn, camera, size, row.backend);
            let (picture, device) = Picture::rendered_on(&scene, &mut row.renderer);
            row.comparison.add_cracks(&picture, &judged, curved);
            row.device = device;
        }
        progress.inc(1);
    }
    Ok(rows)
}
