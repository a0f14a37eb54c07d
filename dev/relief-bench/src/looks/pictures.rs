//! The table of all pictures, with what they are judged by.

use relief_tests::data_dir;

use super::cases::{Case, cases};
use super::measures::{Measures, SEEN, median};
use super::picture::Picture;
use super::{Arguments, Relief, sheet, verdict};
use crate::table::table;

/// The least part of the outline that is seen, without colour maps and with them.
const OUTLINE: [f64; 2] = [0.95, 0.85];

/// The least part of the picture that a square map on a plane covers.
const COVERED: f64 = 0.45;

/// The most that opposite margins differ, in sides of the picture.
const MARGINS: f64 = 0.02;

/// The least median of the deviations in shadow, in bytes, and in medians of those in light.
const SHADOWS: [f64; 2] = [2.0, 0.5];

/// Least number of windows for a median.
const WINDOWS: usize = 20;

/// The part of the covered pixels that fewer than are clipped.
const CLIPPED: f64 = 0.01;

/// What is asked of a picture.
const BOUNDS: [&str; 5] = ["outline", "covered", "margins", "shadows", "clipped"];

/// Prints the table and writes the sheet. Returns whether all bounds hold.
pub fn run(relief: &Relief, arguments: &Arguments) -> Result<bool, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let [png, aov] = ["picture.png", "aov.exr"].map(|name| folder.path().join(name));
    let mut header = vec!["picture", "row, column"];
    header.extend(BOUNDS);
    header.extend(["verdict"]);
    let mut rows = table(&header);
    let (mut shown, mut refused, mut tally) = (Vec::new(), Vec::new(), [[0usize; 2]; BOUNDS.len()]);
    let only = |case: &Case| arguments.only.as_ref().is_none_or(|only| case.name.contains(only));
    for case in cases(arguments.look.is_some())?.into_iter().filter(only) {
        let mut flags = case.arguments.clone();
        flags.extend(arguments.look.iter().flat_map(|look| ["--look".into(), look.into()]));
        flags.extend(["--aov".into(), aov.clone().into()]);
        match relief.render(&flags, &png) {
            Ok(_) => {}
            Err(error) if case.is_foreign => {
                // The folder is not the same for everyone.
                let folder = data_dir().map(|folder| format!("{}/", folder.display()));
                refused.push(folder.map_or(error.clone(), |folder| error.replace(&folder, "")));
                continue;
            }
            Err(error) => return Err(format!("{}: {error}", case.name)),
        }
        let picture = Picture::read(&png, &aov)?;
        let judged = judge(&case, &Measures::of(&picture), picture.size);
        let [row, column] = sheet::place(shown.len());
        let mut cells = vec![case.name, format!("{row}, {column}")];
        let mut missed = Vec::new();
        for ((bound, tally), (cell, holds)) in BOUNDS.iter().zip(&mut tally).zip(judged) {
            cells.push(cell);
            if let Some(holds) = holds {
                tally[0] += usize::from(holds);
                tally[1] += 1;
                missed.extend((!holds).then_some(*bound));
            }
        }
        let of_all = verdict(missed.is_empty());
        cells.push(format!("{of_all} {}", missed.join(", ")).trim_end().to_owned());
        rows.add_row(cells);
        shown.push(sheet::small(&picture));
    }
    sheet::write(&shown, &arguments.output)?;
    let look = arguments.look.as_deref().map_or(String::new(), |look| format!(" --look {look}"));
    println!(
        "Pictures of `relief render FILE{look}`. *Outline*: pixels that differ from the background by {SEEN} \
         or more, at least 95 % ({:.0} % with colours). *Covered*: at least {:.0} % by square maps on \
         planes. *Margins*: above, below, left and right in pixels; opposite ones differ by at most {:.0} % \
         of the side. *Shadows*: deviation of luma in bytes in windows of 8x8 pixels in shadow / in light; \
         at least {} and half of that in light. *Clipped*: less than {:.0} % of covered pixels.\n",
        100.0 * OUTLINE[1],
        100.0 * COVERED,
        100.0 * MARGINS,
        SHADOWS[0],
        100.0 * CLIPPED,
    );
    println!("{rows}\n");
    if !refused.is_empty() {
        println!("Left out, since the command refuses them:\n");
        refused.iter().for_each(|error| println!("* {error}"));
        println!();
    }
    let mut of_bounds = table(&["bound", "pictures that keep it", "of", "verdict"]);
    for (bound, [kept, all]) in BOUNDS.iter().zip(tally) {
        of_bounds.add_row([*bound, &kept.to_string(), &all.to_string(), verdict(kept == all)]);
    }
    println!("{of_bounds}\n");
    Ok(tally.iter().all(|[kept, all]| kept == all))
}

/// Figures in the order of [`BOUNDS`], each with whether its bound holds; `None` where none is asked for.
fn judge(case: &Case, measures: &Measures, size: [usize; 2]) -> [(String, Option<bool>); BOUNDS.len()] {
    let percent = |part: f64| format!("{:.1} %", 100.0 * part);
    let none = || ("-".to_owned(), None);
    let outline = measures
        .outline
        .map_or_else(none, |part| (percent(part), Some(part >= OUTLINE[usize::from(case.is_coloured)])));
    let covered = (percent(measures.covered), case.is_square.then_some(measures.covered >= COVERED));
    let margins = measures.margins.map_or_else(none, |[top, bottom, left, right]| {
        let is_even = |a: usize, b: usize, side: usize| a.abs_diff(b) as f64 <= MARGINS * side as f64;
        let holds = is_even(left, right, size[0]) && is_even(top, bottom, size[1]);
        (format!("{top} {bottom} {left} {right}"), case.is_fitted.then_some(holds))
    });
    let of_kind = |list: &[f64]| median(list).filter(|_| list.len() >= WINDOWS);
    let shadows = match (of_kind(&measures.shadows), of_kind(&measures.lights)) {
        (None, _) => none(),
        (Some(dark), None) => (format!("{dark:.1} / -"), Some(dark >= SHADOWS[0])),
        (Some(dark), Some(light)) => {
            let holds = dark >= SHADOWS[0] && dark >= SHADOWS[1] * light;
            (format!("{dark:.1} / {light:.1}"), Some(holds))
        }
    };
    let clipped = measures.clipped.map_or_else(none, |part| (percent(part), Some(part < CLIPPED)));
    [outline, covered, margins, shadows, clipped]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> Case {
        Case {
            name: "made".to_owned(),
            arguments: Vec::new(),
            is_coloured: false,
            is_square: true,
            is_fitted: true,
            is_foreign: false,
        }
    }

    fn good() -> Measures {
        Measures {
            covered: 0.46,
            margins: Some([20, 32, 10, 26]),
            outline: Some(0.96),
            shadows: vec![3.0; 30],
            lights: vec![5.0; 30],
            clipped: Some(0.009),
        }
    }

    fn verdicts(case: &Case, measures: &Measures) -> [Option<bool>; 5] {
        judge(case, measures, [800, 600]).map(|(_, holds)| holds)
    }

    #[test]
    fn a_good_picture_keeps_all_bounds_and_each_fault_misses_its_own() {
        assert_eq!(verdicts(&case(), &good()), [Some(true); 5]);
        let faults = [
            Measures { outline: Some(0.94), ..good() },
            Measures { covered: 0.44, ..good() },
            Measures { margins: Some([20, 33, 10, 26]), ..good() },
            Measures { shadows: vec![1.9; 30], lights: vec![1.9; 30], ..good() },
            Measures { clipped: Some(0.01), ..good() },
        ];
        for (number, fault) in faults.iter().enumerate() {
            let mut expected = [Some(true); 5];
            expected[number] = Some(false);
            assert_eq!(verdicts(&case(), fault), expected);
        }
        let left = Measures { margins: Some([20, 20, 10, 27]), ..good() };
        assert_eq!(verdicts(&case(), &left)[2], Some(false));
        let weak = Measures { lights: vec![6.1; 30], ..good() };
        assert_eq!(verdicts(&case(), &weak)[3], Some(false));
    }

    #[test]
    fn bounds_that_a_picture_cannot_keep_are_not_asked_for() {
        let other = Case { is_coloured: true, is_square: false, is_fitted: false, ..case() };
        let measures = Measures {
            covered: 0.1,
            margins: Some([0, 300, 0, 0]),
            outline: Some(0.86),
            shadows: vec![0.0; 19],
            ..good()
        };
        assert_eq!(verdicts(&other, &measures), [Some(true), None, None, None, Some(true)]);
    }
}
