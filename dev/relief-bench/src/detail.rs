//! `detail`: levels of detail beside many samples, on three maps.

use clap::Args;
use comfy_table::Table;
use relief_tests::accuracy::maps;
use relief_tests::detail::Seen;

use crate::table::table;

/// Arguments of `detail`.
#[derive(Args)]
pub struct Arguments {
    /// Columns and rows of the pictures
    #[arg(long, default_value_t = 64)]
    side: u32,
    /// The method
    #[arg(long, default_value = "cone")]
    method: String,
}

/// Pixels that cover the texels beside each other of the relief that is seen by its levels, and of the one
/// that is hardly deeper than a pixel.
const NEAR: [f64; 3] = [2.0, 4.0, 8.0];
const FAR: [f64; 3] = [8.0, 16.0, 32.0];

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let method = &arguments.method;
    println!("Pictures of one sample beside 256 samples in the finest level; `{method}`");
    println!("{}", compared(arguments, ["none", "footprint"], "with levels", &[0.0, 45.0, 70.0], NEAR));
    println!("Far away, `footprint` beside `fade`; `{method}`");
    println!("{}", compared(arguments, ["footprint", "fade"], "faded", &[45.0, 70.0], FAR));
    Ok(())
}

/// Two details beside each other.
fn compared(
    arguments: &Arguments,
    details: [&str; 2],
    second: &str,
    tilts: &[f64],
    texels: [f64; 3],
) -> Table {
    let figures = ["error", "flicker", "brightness", "reads"].into_iter().flat_map(|figure| [figure, second]);
    let columns: Vec<&str> = ["map", "shadow", "tilt", "texels"].into_iter().chain(figures).collect();
    let mut rows = table(&columns);
    for named in maps().iter().filter(|named| ["cobbles", "bricks", "ground"].contains(&named.name)) {
        for shadow in ["none", "ray"] {
            for &tilt_deg in tilts {
                for texels in texels {
                    let Arguments { side, method } = arguments;
                    let seen = Seen { map: &named.map, method, shadow, texels, tilt_deg, side: *side };
                    let [a, b] = seen.shown(details);
                    rows.add_row([
                        named.name.to_owned(),
                        shadow.to_owned(),
                        format!("{tilt_deg}"),
                        format!("{texels}"),
                        format!("{:.4}", a.error),
                        format!("{:.4}", b.error),
                        format!("{:.4}", a.flicker),
                        format!("{:.4}", b.flicker),
                        format!("{:.3}", a.brightness),
                        format!("{:.3}", b.brightness),
                        format!("{:.1}", a.reads),
                        format!("{:.1}", b.reads),
                    ]);
                }
            }
        }
    }
    rows
}
