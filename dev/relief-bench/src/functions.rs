//! `functions`: methods as functions for other programs. Whether they find the renderer's hits over all pairs
//! and wraps, to the bit in WGSL and nearly in GLSL ES 3.00, and how large each method is.

mod es300;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use relief_core::Wrap;
use relief_export::{Form, FunctionOptions, functions};
use relief_render::gpu::Prober;
use relief_shaders::{METHODS, Selection};
use relief_testing::maps;
use relief_tests::exported::{Device, differing_hits, shortened, size_of, surface_of};
use relief_tests::one_source::rays::pixels;
use relief_tests::pairs;

use crate::table::table;

/// Arguments of `functions`.
#[derive(Args)]
pub struct Arguments {
    /// Rays of each program
    #[arg(long, default_value_t = 100_000)]
    rays: usize,
    /// Print only the sizes
    #[arg(long)]
    sizes: bool,
    /// Run the functions in GLSL ES 3.00, in Chromium, beside the renderer's hits
    #[arg(long)]
    es300: bool,
    /// With --es300: run every Nth pair alone
    #[arg(long, value_name = "N", default_value_t = 1)]
    every: usize,
    /// Chromium or Chrome, for --es300
    #[arg(long, value_name = "PROGRAM", default_value = "chromium")]
    chromium: PathBuf,
}

/// Prints the tables. Fails where a hit differs.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    if arguments.es300 {
        return es300::run(&arguments.chromium, arguments.rays, arguments.every);
    }
    println!("{}", sizes()?);
    if arguments.sizes {
        return Ok(ExitCode::SUCCESS);
    }
    let device = Device::open().ok_or("there is no software adapter")?;
    let mut prober = Prober::new(device.gpu());
    let (mut programs, mut rays, mut differing) = (0, 0, 0);
    for (number, pair) in pairs::all().enumerate() {
        let selection = shortened(without_shadow(pair)?);
        for wrap in Wrap::ALL {
            let map = &maps::ALL[(number + wrap as usize) % maps::ALL.len()];
            let heights = map.build(wrap).with_displacement(0.3, -0.3).map_err(|error| error.to_string())?;
            let rays_of = pixels(&heights, arguments.rays, number as u64 + 1);
            let options = FunctionOptions { wrap: Some(wrap), ..FunctionOptions::default() };
            let exported = functions(&selection, &options).map_err(|error| error.to_string())?;
            let wrong =
                differing_hits(&device, &mut prober, &exported, &surface_of(heights, selection), &rays_of);
            if wrong > 0 {
                println!("{}, {wrap}, {}: {wrong} hits differ", pairs::name(&selection), map.name);
            }
            (programs, rays, differing) = (programs + 1, rays + rays_of.len(), differing + wrong);
        }
    }
    println!("{programs} programs, {rays} rays: {differing} hits differ in a bit from the renderer's");
    Ok(if differing == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn without_shadow(mut selection: Selection) -> Result<Selection, String> {
    selection.choose("shadow", "none").map_err(|error| error.to_string())?;
    Ok(selection)
}

/// Lines and kilobytes of every method, without comments and empty lines.
fn sizes() -> Result<String, String> {
    let mut rows = table(&[
        "method",
        "`plane`",
        "with `ray`",
        "`quadric-vertical`",
        "`quadric-perpendicular`",
        "`prism`",
        "`tetrahedra`",
    ]);
    for method in METHODS {
        let of = |form: Form, surface: &str, shadow: &str| -> Option<String> {
            let mut selection = Selection::of(method).ok()?;
            selection.choose("surface", surface).ok()?;
            selection.choose("shadow", shadow).ok()?;
            let options = FunctionOptions { form, wrap: Some(Wrap::Repeat), ..FunctionOptions::default() };
            let [lines, bytes] = size_of(&functions(&selection, &options).ok()?);
            Some(format!("{lines}, {:.1} KB", bytes as f64 / 1000.0))
        };
        let sizes = [
            of(Form::Tangent, "plane", "none"),
            of(Form::Tangent, "plane", "ray"),
            of(Form::Tangent, "quadric-vertical", "none"),
            of(Form::Tangent, "quadric-perpendicular", "none"),
            of(Form::Triangle, "prism", "none"),
            of(Form::Triangle, "tetrahedra", "none"),
        ];
        if sizes.iter().any(Option::is_some) {
            let cells = sizes.into_iter().map(|size| size.unwrap_or_else(|| "-".to_owned()));
            rows.add_row([method.name.to_owned()].into_iter().chain(cells));
        }
    }
    Ok(rows.to_string())
}
