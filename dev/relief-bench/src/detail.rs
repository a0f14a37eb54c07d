//! `detail`: levels of detail beside many samples, on three maps.

use clap::Args;
use relief_tests::accuracy::maps;
use relief_tests::detail::Seen;

use crate::table::table;

/// What `detail` is given.
#[derive(Args)]
pub struct Arguments {
    /// Columns and rows of the pictures
    #[arg(long, default_value_t = 64)]
    side: u32,
    /// The method
    #[arg(long, default_value = "cone")]
    method: String,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "shadow",
        "tilt",
        "texels",
        "error",
        "with levels",
        "flicker",
        "with levels",
        "brightness",
        "with levels",
        "reads",
        "with levels",
    ]);
    for named in maps().iter().filter(|named| ["cobbles", "bricks", "ground"].contains(&named.name)) {
        for shadow in ["none", "ray"] {
            for tilt_deg in [0.0, 45.0, 70.0] {
                for texels in [2.0, 4.0, 8.0] {
                    let Arguments { side, method } = arguments;
                    let seen = Seen { map: &named.map, method, shadow, texels, tilt_deg, side: *side };
                    let [none, levels] = seen.shown(["none", "footprint"]);
                    rows.add_row([
                        named.name.to_owned(),
                        shadow.to_owned(),
                        format!("{tilt_deg}"),
                        format!("{texels}"),
                        format!("{:.4}", none.error),
                        format!("{:.4}", levels.error),
                        format!("{:.4}", none.flicker),
                        format!("{:.4}", levels.flicker),
                        format!("{:.3}", none.brightness),
                        format!("{:.3}", levels.brightness),
                        format!("{:.1}", none.reads),
                        format!("{:.1}", levels.reads),
                    ]);
                }
            }
        }
    }
    println!("Pictures of one sample beside 256 samples in the finest level; `{}`\n{rows}", arguments.method);
    Ok(())
}
