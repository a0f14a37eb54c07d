//! Whether times hold: two runs in a row, bump mapping beside searches, and passes beside their frame.

use relief_compare::{PictureRecord, Records, TimeRecord};

use super::{Arguments, compared, contender, timed_cobbles};
use crate::table::table;

/// How many times as many pixels are timed.
const PIXELS: u32 = 8;

const METHODS: [&str; 8] =
    ["bump", "parallax", "steep", "occlusion", "relief", "cone", "quadtree", "pyramidal-bilinear"];

/// How far the ratios to bump mapping of two runs may be apart whose intervals do not overlap, and by how
/// much the passes may miss their frame.
const APART: f64 = 0.05;
const BESIDE_FRAME: f64 = 0.1;

/// Prints a table a machine, of two runs.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut comparison = timed_cobbles(arguments, PIXELS)?;
    comparison.contenders = METHODS.iter().map(|name| contender(name, &[])).collect::<Result<_, _>>()?;
    comparison.rays = 0;
    let runs = [compared(&comparison)?, compared(&comparison)?];
    for machine in &runs[0].about.machines {
        let on = (machine.backend.as_str(), machine.sampling.as_str());
        let mut rows = table(&[
            "method",
            "over bump, first run",
            "second run",
            "they agree",
            "slower than bump",
            "passes over frame",
            "within a tenth",
        ]);
        for name in METHODS {
            let of = |records| Some((times(records, name, on)?, times(records, METHODS[0], on)?));
            let [Some((first, bump)), Some((second, other_bump))] = [of(&runs[0]), of(&runs[1])] else {
                continue;
            };
            let ratios = [over(first, bump), over(second, other_bump)];
            let passes = passes_over_frame(first);
            rows.add_row([
                name.to_owned(),
                said(ratios[0]),
                said(ratios[1]),
                yes(do_agree(ratios)),
                if name == METHODS[0] {
                    "-".to_owned()
                } else {
                    yes(ratios.iter().all(|ratio| ratio[0] > 1.0))
                },
                passes.map_or("-".to_owned(), |part| format!("{part:.3}")),
                passes.map_or("-".to_owned(), |part| yes((part - 1.0).abs() <= BESIDE_FRAME)),
            ]);
        }
        println!(
            "Two runs in a row of {} frames each by turns, of cobbles without shadows; frames over those of \
             bump mapping, with what the true ratios lie between. {}, {} sampling, on {}\n\n{rows}\n",
            arguments.frames, machine.backend, machine.sampling, machine.device
        );
    }
    Ok(())
}

fn times<'a>(records: &'a Records, name: &str, on: (&str, &str)) -> Option<&'a TimeRecord> {
    let is_it = |record: &&PictureRecord| {
        record.method.method == name && (record.backend.as_str(), record.sampling.as_str()) == on
    };
    records.pictures.iter().find(is_it).and_then(|record| record.times.as_ref())
}

/// The ratio of two frames, and what it lies between.
fn over(frame: &TimeRecord, bump: &TimeRecord) -> [f64; 3] {
    [
        frame.frame_ms / bump.frame_ms,
        frame.frame_low_ms / bump.frame_high_ms,
        frame.frame_high_ms / bump.frame_low_ms,
    ]
}

fn do_agree([first, second]: [[f64; 3]; 2]) -> bool {
    let is_near = (first[0] / second[0] - 1.0).abs() <= APART;
    is_near || (first[1] <= second[2] && second[1] <= first[2])
}

/// The part of a frame that its passes take by the clock of the GPU.
fn passes_over_frame(times: &TimeRecord) -> Option<f64> {
    Some((times.trace_pass_ms? + times.shade_pass_ms?) / times.frame_ms)
}

fn said([ratio, low, high]: [f64; 3]) -> String {
    format!("{ratio:.2} ({low:.2} to {high:.2})")
}

fn yes(is_so: bool) -> String {
    if is_so { "yes" } else { "no" }.to_owned()
}
