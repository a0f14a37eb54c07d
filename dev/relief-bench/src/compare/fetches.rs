//! What a read costs that depends on the one before, beside one that does not: Szirmay-Kalos and Umenhoffer
//! 2008, section 4.4.2.

use relief_compare::PictureRecord;

use super::{Arguments, compared, contender, timed_cobbles};
use crate::table::table;

/// How many times as many pixels are timed.
const PIXELS: u32 = 4;

/// Steps of the linear search, and those that are added to it, as further ones or as ones of a refinement.
const STEPS: f64 = 32.0;
const MORE: f64 = 32.0;

/// A search and a refinement that is given more steps.
const REFINEMENTS: [&str; 2] = ["binary", "secant"];

/// Prints a table a machine.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut comparison = timed_cobbles(arguments, PIXELS)?;
    let mut contenders = Vec::new();
    for refinement in REFINEMENTS {
        let pair = format!("linear+{refinement}");
        for (search, refine) in [(STEPS, 1.0), (STEPS + MORE, 1.0), (STEPS, 1.0 + MORE)] {
            contenders.push(contender(&pair, &[("search.steps", search), ("refine.steps", refine)])?);
        }
    }
    (comparison.rays, comparison.contenders) = (0, contenders);
    let records = compared(&comparison)?;
    for machine in &records.about.machines {
        let on = |record: &&PictureRecord| {
            (&record.backend, &record.sampling) == (&machine.backend, &machine.sampling)
        };
        let of_machine: Vec<&PictureRecord> = records.pictures.iter().filter(on).collect();
        let mut rows =
            table(&["refinement", "linear: ns a read", "dependent: ns a read", "dependent over linear"]);
        for (refinement, of) in REFINEMENTS.iter().zip(of_machine.as_chunks::<3>().0) {
            let [few, linear, dependent] = of;
            let [linear, dependent] = [linear, dependent].map(|more| a_read_ns(few, more, arguments.size));
            let ratio = linear.zip(dependent).map(|(linear, dependent)| dependent / linear);
            let cell = |number: Option<f64>| number.map_or("-".to_owned(), |number| format!("{number:.2}"));
            rows.add_row([(*refinement).to_owned(), cell(linear), cell(dependent), cell(ratio)]);
        }
        println!(
            "What a read more costs a pixel of cobbles without shadows, where {MORE} steps are added to \
             {STEPS} linear ones. {}, {} sampling, on {}\n\n{rows}\n",
            machine.backend, machine.sampling, machine.device
        );
    }
    Ok(())
}

/// Nanoseconds of a read, of those that one picture has more than another.
fn a_read_ns(few: &PictureRecord, more: &PictureRecord, size: [u32; 2]) -> Option<f64> {
    let [(few, few_ms), (more, more_ms)] = [(few, few.times.as_ref()?), (more, more.times.as_ref()?)]
        .map(|(record, times)| (record, times.displacement_ms));
    let reads = more.cost?.reads - few.cost?.reads;
    let pixels = f64::from(size[0] * size[1] * PIXELS);
    // Of the pixels those are searched that show the surface.
    let shown = more.error.map_or(1.0, |error| error.rays as f64 / f64::from(size[0] * size[1]));
    Some(1e6 * (more_ms - few_ms) / (reads * pixels * shown))
}
