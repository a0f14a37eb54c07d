//! `remesh`: what Gumhold and Hüttner 1999 say of their remesher, beside what it does.

mod claims;
mod moving;
mod plots;
mod silhouettes;
mod unseen;

use std::path::PathBuf;

use clap::Args;

/// Arguments of `remesh`.
#[derive(Args)]
pub struct Arguments {
    /// Random triangles that are looked at
    #[arg(long, default_value_t = 3_000_000, value_parser = clap::value_parser!(u32).range(1..))]
    triangles: u32,
    /// Width of the pictures, in pixels; they are three quarters as high
    #[arg(long, default_value_t = 800, value_parser = clap::value_parser!(u32).range(8..=8192))]
    width: u32,
    /// Draw Figures 6, 7 and 16 into this SVG in place of the tables
    #[arg(long, value_name = "FILE.svg")]
    plots: Option<PathBuf>,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    if let Some(path) = &arguments.plots {
        return std::fs::write(path, plots::svg()?).map_err(|error| format!("{}: {error}", path.display()));
    }
    println!("{}\n", claims::table(arguments.triangles));
    println!("{}\n", silhouettes::table(arguments.width)?);
    println!("{}\n", unseen::table(arguments.width)?);
    println!("{}", moving::table(arguments.width)?);
    Ok(())
}
