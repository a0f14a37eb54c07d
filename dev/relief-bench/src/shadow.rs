//! `shadow`: every shadow beside rays of the exact search, on three maps and three meshes.

use clap::Args;
use relief_core::mesh::Builtin;
use relief_scene::BackendChoice;
use relief_tests::accuracy::maps;
use relief_tests::shadows::{Lit, mean_error, squared_error, wrong};

use crate::table::table;

/// Arguments of `shadow`.
#[derive(Args)]
pub struct Arguments {
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 200)]
    width: u32,
}

const MESHES: [Builtin; 3] = [Builtin::Plane, Builtin::Sphere, Builtin::Torus];

const ELEVATIONS_DEG: [f64; 3] = [15.0, 30.0, 50.0];

/// The disc of the soft lights, in degrees.
const DISC_DEG: f64 = 5.0;

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut hard = table(&[
        "map",
        "mesh",
        "light",
        "entry",
        "horizon 16",
        "horizon 32",
        "visibility nearest",
        "three",
        "heuristic",
    ]);
    let mut three = table(&["map", "mesh", "light", "nearest", "three", "heuristic"]);
    let mut soft =
        table(&["map", "mesh", "light", "horizon 16", "horizon 32", "1", "2", "4", "8", "16", "32", "64"]);
    for named in maps().iter().filter(|named| ["cobbles", "bricks", "ground"].contains(&named.name)) {
        for mesh in MESHES {
            for elevation_deg in ELEVATIONS_DEG {
                let size = [arguments.width, arguments.width * 3 / 4];
                let lit = Lit {
                    map: &named.map,
                    mesh,
                    elevation_deg,
                    diameter_deg: 0.0,
                    size,
                    backend: BackendChoice::Cpu,
                };
                let about = [named.name.to_owned(), mesh.name().to_owned(), format!("{elevation_deg}")];
                let [ray, entry, few, many, nearest, between, heuristic] = lit.parts([
                    ("ray", &[]),
                    ("entry", &[]),
                    ("horizon", &[]),
                    ("horizon", &[("shadow.azimuths", 32.0)]),
                    ("visibility", &[("shadow.directions", 1.0)]),
                    ("visibility", &[]),
                    ("heuristic", &[]),
                ]);
                let shadows = [&entry, &few, &many, &nearest, &between, &heuristic];
                let percent = shadows.map(|parts| format!("{:.2}", 100.0 * wrong(parts, &ray)));
                hard.add_row(about.iter().chain(&percent));
                let means =
                    [&nearest, &between, &heuristic].map(|parts| format!("{:.4}", mean_error(parts, &ray)));
                three.add_row(about.iter().chain(&means));
                let lit = Lit { diameter_deg: DISC_DEG, ..lit };
                let truth = lit.truth();
                let [few, many] = lit.parts([("horizon", &[]), ("horizon", &[("shadow.azimuths", 32.0)])]);
                let mut row = [few, many].map(|parts| format!("{:.4}", mean_error(&parts, &truth))).to_vec();
                for samples in [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0] {
                    let [parts] = lit.parts([("soft", &[("shadow.samples", samples)])]);
                    row.push(format!("{:.6}", squared_error(&parts, &truth)));
                }
                soft.add_row(about.iter().chain(&row));
            }
        }
    }
    println!("Pixels that are lit and should be dark, or the other way, in percent; hard lights\n{hard}\n");
    println!("Mean error of the part that arrives; hard lights\n{three}\n");
    println!(
        "A disc of {DISC_DEG} degrees beside rays to 256 of its points: mean error of horizons, mean squared \
         error of so many rays\n{soft}"
    );
    Ok(())
}
