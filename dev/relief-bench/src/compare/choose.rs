//! Whether a method that is chosen keeps its budget or its error in another run, and whether another one does
//! better there.

use relief_compare::{Candidate, Contender, Goal, Records, Timing, choose, with_other_steps};
use relief_core::Watch;
use relief_scene::Sampling;

use super::maps::maps;
use super::{Arguments, compared, on_square};
use crate::table::table;

/// Milliseconds of a frame as multiples of the fastest search's, and the requested texels.
const BUDGETS: [f64; 3] = [1.2, 1.5, 2.5];
const ERRORS: [f64; 3] = [2.0, 0.1, 0.01];

/// By how much another one may do better, in error or in time.
const BETTER: f64 = 0.1;

/// Errors below that many texels are rounding.
const ROUNDING_TEXELS: f64 = 1e-3;

/// Prints a table of all maps.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "asked",
        "chosen",
        "then: ms, texels",
        "in another run",
        "kept",
        "the best there",
        "within a tenth",
        "with a tenth of the time to spare",
    ]);
    for (name, map) in maps()? {
        let machine = arguments.machines(&[Sampling::Exact]).into_iter().take(1).collect();
        let mut comparison = on_square(name, map, arguments.size, machine)?;
        let searches: Vec<Contender> = Contender::all().into_iter().filter(Contender::is_of_rays).collect();
        comparison.contenders = with_other_steps(&searches);
        (comparison.rays, comparison.steps) = (arguments.rays.min(4_000), Vec::new());
        comparison.timing = Some(Timing { frames: arguments.frames, warm: 1, pixels: 1 });
        let [first, second] = [compared(&comparison)?, compared(&comparison)?];
        let fastest = choose(&first, Goal::WithinTexels(f64::MAX)).candidates;
        let fastest = fastest.first().ok_or("no method was timed")?.frame_ms;
        let goals = BUDGETS.map(|times| Goal::WithinMs(times * fastest));
        for goal in goals.into_iter().chain(ERRORS.map(Goal::WithinTexels)) {
            let looked = |records: &Records| -> Result<Records, String> {
                let mut records = records.clone();
                let again = comparison.time_again(&mut records, goal, &Watch::none());
                again.map_err(|error| error.to_string()).map(|_| records)
            };
            rows.add_row(row(name, goal, [&looked(&first)?, &looked(&second)?])?);
        }
    }
    println!(
        "Methods that search, with 8 to 256 steps, chosen for frames of {}x{} pixels without shadows, \
         {} frames of each by turns; another run of all of them after it\n\n{rows}\n",
        arguments.size[0], arguments.size[1], arguments.frames
    );
    Ok(())
}

fn row(name: &str, goal: Goal, [first, second]: [&Records; 2]) -> Result<[String; 9], String> {
    let asked = match goal {
        Goal::WithinMs(ms) => format!("{ms:.2} ms"),
        Goal::WithinTexels(texels) => format!("{texels} texels"),
    };
    let tried = choose(first, goal);
    let Some(chosen) = tried.candidates.first().filter(|_| tried.meeting > 0) else {
        // The machine was slower in the second look than in the first one, after which the budget was set.
        let rest = [asked, "none keeps it".to_owned()].into_iter();
        let row: Vec<String> = std::iter::once(name.to_owned()).chain(rest).collect();
        return Ok(std::array::from_fn(|at| row.get(at).cloned().unwrap_or_default()));
    };
    let again = choose(second, goal);
    let label = chosen.method.label();
    let then = again.candidates.iter().find(|other| other.method.label() == label);
    let then = then.ok_or("it was not timed again")?;
    let best = again.candidates.first().ok_or("nothing was timed again")?;
    let least = |of: &Candidate| match goal {
        Goal::WithinMs(_) => of.p99_texels.max(ROUNDING_TEXELS),
        Goal::WithinTexels(_) => of.frame_ms,
    };
    // Of a budget that a tenth is taken from, so that what hardly keeps it does not count.
    let spare = match goal {
        Goal::WithinMs(limit) => Goal::WithinMs(limit / (1.0 + BETTER)),
        Goal::WithinTexels(_) => goal,
    };
    let spared = choose(second, spare);
    let best_spared = spared.candidates.first().filter(|_| spared.meeting > 0);
    let said = |of: &Candidate| format!("{:.2}, {:.4}", of.frame_ms, of.p99_texels);
    let yes = |is_so: bool| if is_so { "yes" } else { "no" }.to_owned();
    Ok([
        name.to_owned(),
        asked,
        label,
        said(chosen),
        said(then),
        match goal {
            Goal::WithinMs(limit) if then.frame_ms > limit && then.frame_low_ms <= limit => {
                "by its interval".to_owned()
            }
            Goal::WithinMs(limit) => yes(then.frame_ms <= limit),
            Goal::WithinTexels(limit) => yes(then.p99_texels <= limit),
        },
        format!("{}: {}", best.method.label(), said(best)),
        yes(least(then) <= (1.0 + BETTER) * least(best)),
        yes(best_spared.is_none_or(|best| least(then) <= (1.0 + BETTER) * least(best))),
    ])
}
