//! `quadrics`: what Oliveira and Policarpo 2005 say of their quadrics, measured.

mod angles;
mod discriminant;
mod fit;

use clap::Args;

/// Arguments of `quadrics`.
#[derive(Args)]
pub struct Arguments {
    /// Random quadrics, and rays, of each kind
    #[arg(long, default_value_t = 200_000)]
    rays: u32,
    /// Random views of each mesh
    #[arg(long, default_value_t = 4)]
    views: u32,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 800)]
    width: u32,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    println!("{}\n", fit::measured()?);
    println!("{}\n", discriminant::measured(arguments.rays));
    println!("{}", angles::measured(arguments.views, arguments.width)?);
    Ok(())
}
