//! Times and reads over the size of the map: Oh, Ki and Lee 2006, Figure 21, which has 1.28 times the time
//! for 64 times the texels.

use relief_compare::Timing;
use relief_core::{HeightMap, Wrap};
use relief_scene::Sampling;
use relief_testing::maps::fractal;

use super::{Arguments, compared, contender, on_square};
use crate::table::table;

/// Longer sides of the map, from one that is filtered down.
const SIDES: [u32; 4] = [2048, 1024, 512, 256];

const METHODS: [&str; 7] =
    ["bump", "quadtree", "pyramidal-bilinear", "frustum", "cone", "sphere-tracing", "relief"];

/// Most time of the greatest map's frames, as a multiple of the least map's.
const PUBLISHED: f64 = 1.28;

/// Prints a table a machine.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let texels = fractal(11, SIDES[0], SIDES[0], 0.5);
    let map = HeightMap::new(SIDES[0], SIDES[0], texels, Wrap::Repeat).map_err(|error| error.to_string())?;
    let machines = arguments.machines(&[Sampling::Fast]);
    let mut comparison = on_square("ground", map, [512, 512], machines)?;
    comparison.contenders = METHODS.iter().map(|name| contender(name, &[])).collect::<Result<_, _>>()?;
    (comparison.rays, comparison.map_sides) = (0, SIDES.to_vec());
    comparison.timing = Some(Timing { frames: arguments.frames, warm: 2, pixels: 1 });
    let records = compared(&comparison)?;
    for machine in &records.about.machines {
        println!(
            "A fractal map filtered down, the same picture of 512x512 pixels: milliseconds of a frame / \
             reads of a pixel. {}, {} sampling, on {}\n",
            machine.backend, machine.sampling, machine.device
        );
        let sides = SIDES.map(|side| format!("{side}²"));
        let header: Vec<&str> = ["method"]
            .into_iter()
            .chain(sides.iter().map(String::as_str))
            .chain(["largest over least"])
            .collect();
        let mut rows = table(&header);
        for name in METHODS {
            let mut row = vec![name.to_owned()];
            let mut frames = Vec::new();
            for side in SIDES {
                let found = records.pictures.iter().find(|record| {
                    (record.method.method.as_str(), record.method.map_size[0]) == (name, side)
                        && (&record.backend, &record.sampling) == (&machine.backend, &machine.sampling)
                });
                let Some((record, times)) = found.and_then(|record| Some((record, record.times.as_ref()?)))
                else {
                    row.push("-".to_owned());
                    continue;
                };
                frames.push(times.frame_ms);
                let reads = record.cost.map_or(0.0, |cost| cost.reads);
                row.push(format!("{:.2} / {reads:.1}", times.frame_ms));
            }
            let ratio =
                frames.first().zip(frames.last()).map_or(f64::NAN, |(largest, least)| largest / least);
            row.push(format!("{ratio:.2}"));
            rows.add_row(row);
        }
        println!("{rows}\n\nThe paper has {PUBLISHED} for its own.\n");
    }
    Ok(())
}
