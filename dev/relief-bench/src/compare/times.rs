//! Errors against times, of methods over their steps: what is as near as what engines ship, and how much
//! faster.

use relief_compare::{Contender, ErrorRecord, PictureRecord, TimeRecord};
use relief_core::MapFormat;

use super::{Arguments, compared, contender, timed_cobbles};
use crate::table::table;

/// How many times as many pixels are timed: twice as many along each side.
const PIXELS: u32 = 4;

/// Steps of the methods that engines ship.
const STEPS: [u32; 6] = [8, 16, 32, 64, 128, 256];

/// The most bytes of map a texel of what these are compared with.
const MOST_BYTES: f64 = 8.0;

/// Part of the time that the best method should take at the error of the given number of steps.
const AIMS: [(u32, f64); 2] = [(16, 0.5), (256, 0.2)];

fn contenders() -> Result<Vec<Contender>, String> {
    let mut contenders = vec![contender("bump", &[])?];
    let shipped = [contender("occlusion", &[])?, contender("relief", &[("refine.steps", 5.0)])?];
    for shipped in &shipped {
        for steps in STEPS {
            contenders.extend(shipped.with_steps(steps).map_err(|error| error.to_string())?);
        }
    }
    for name in
        ["exact", "quadtree", "cone", "frustum", "relaxed", "relaxed-cone-stepping", "erosion-dilation"]
    {
        contenders.push(contender(name, &[])?);
    }
    for name in ["cone-stepping", "relaxed-cone-stepping", "pyramidal-bilinear"] {
        for steps in [8, 16] {
            contenders.extend(contender(name, &[])?.with_steps(steps).map_err(|error| error.to_string())?);
        }
    }
    Ok(contenders)
}

/// Prints the table of each machine, and the ratios that are read off it.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut comparison = timed_cobbles(arguments, PIXELS)?;
    (comparison.rays, comparison.contenders) = (0, contenders()?);
    comparison.map_formats = MapFormat::ALL.to_vec();
    let records = compared(&comparison)?;
    for machine in &records.about.machines {
        let on = |record: &&PictureRecord| {
            (&record.backend, &record.sampling) == (&machine.backend, &machine.sampling)
        };
        let judged = records.pictures.iter().filter(on).filter_map(judged);
        let of_machine: Vec<Judged> = judged.collect();
        println!(
            "{}, {} sampling, on {}: {} frames of each in turn; displacement is what a frame takes more than \
             one of bump mapping, without shadows\n",
            machine.backend, machine.sampling, machine.device, arguments.frames
        );
        let mut rows = table(&[
            "method",
            "passed %",
            "p99 texels",
            "map bytes a texel",
            "displacement ms",
            "95 % sure",
            "frame ms",
        ]);
        for (record, error, times) in &of_machine {
            rows.add_row([
                record.method.label(),
                format!("{:.3}", 100.0 * error.passed),
                format!("{:.3}", error.p99_texels),
                format!("{:.1}", record.method.bytes_a_texel()),
                format!("{:.2}", times.displacement_ms),
                format!("{:.2} to {:.2}", times.displacement_low_ms, times.displacement_high_ms),
                format!("{:.2}", times.frame_ms),
            ]);
        }
        println!("{rows}\n");
        ratios(&of_machine);
    }
    Ok(())
}

/// Prints how long the fastest method takes that is as near as what engines ship.
fn ratios(records: &[Judged]) {
    for (steps, aim) in AIMS {
        let shipped = records
            .iter()
            .filter(|(record, ..)| record.method.steps == Some(steps) && record.method.search == "linear");
        for (shipped, most, theirs) in shipped {
            let is_as_near = |(record, error, _): &&Judged| {
                record.method.search != "linear"
                    && record.method.method != "bump"
                    && record.method.bytes_a_texel() <= MOST_BYTES
                    && error.passed <= most.passed
                    && error.p99_texels <= most.p99_texels.max(1e-3)
                    && error.missed <= most.missed.max(1e-3)
            };
            let near = records.iter().filter(is_as_near);
            let best = near.min_by(|(.., a), (.., b)| a.displacement_ms.total_cmp(&b.displacement_ms));
            let Some((best, _, ours)) = best else {
                println!("{}: nothing is as near", shipped.method.label());
                continue;
            };
            let ratio = ours.displacement_ms / theirs.displacement_ms;
            println!(
                "{}: {} takes {ratio:.2} of its time ({:.2} to {:.2} ms of {:.2} to {:.2}); the aim is \
                 {aim}: {}",
                shipped.method.label(),
                best.method.label(),
                ours.displacement_low_ms,
                ours.displacement_high_ms,
                theirs.displacement_low_ms,
                theirs.displacement_high_ms,
                if ratio <= aim { "reached" } else { "missed" }
            );
        }
    }
    println!();
}

/// A picture with its errors and times.
type Judged<'a> = (&'a PictureRecord, ErrorRecord, &'a TimeRecord);

fn judged(record: &PictureRecord) -> Option<Judged<'_>> {
    Some((record, record.error?, record.times.as_ref()?))
}
