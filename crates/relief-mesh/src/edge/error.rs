//! The fewest points within the tolerance.

use relief_core::registry::Publication;

use super::{Divides, EdgeRule, Knot, Spacing};

pub const RULE: EdgeRule = EdgeRule {
    name: "error",
    summary: "the fewest points whose chords stay within half of the tolerance",
    publication: Publication { paper: "Imai and Iri 1988, Polygonal Approximations of a Curve", section: "" },
    spacing: Spacing::Uneven,
    divides: Divides::Along(side),
};

/// The part of the tolerance that a side takes. Triangles at it have the rest for what the surface does
/// beside it; more points on sides are fewer inside.
const PART: f64 = 0.5;

fn side(rows: &[&[Knot]], tolerance: f64) -> Vec<usize> {
    fewest(rows, PART * tolerance, |knot| LONGEST * tolerance / knot.twist)
}

/// How many texels long a chord may be where the surface beside it has a twist of one tolerance a texel: a
/// triangle that is a step of the lattice wide, 1/16 of a texel, lies off by a quarter of the twist times
/// length and width, which is to be at most half of the tolerance.
pub const LONGEST: f64 = 32.0;

/// The fewest of some points of a line, the first and the last among them, whose chords pass all others in
/// every row within the tolerance, and are no longer than `longest` says for each knot that they leave
/// behind; of the ways with as many points the one whose chords are the most even.
fn fewest(rows: &[&[Knot]], tolerance: f64, longest: impl Fn(&Knot) -> f64) -> Vec<usize> {
    let count = rows[0].len();
    let longest = |at: usize| rows.iter().map(|row| longest(&row[at])).fold(f64::INFINITY, f64::min);
    // The number of chords to a point, the sum of their squared lengths, and the point before.
    let mut best = vec![(usize::MAX, f64::INFINITY, 0); count];
    best[0] = (0, 0.0, 0);
    // The least and the greatest slope that passes all points so far, in each row.
    let mut slopes = vec![[0.0; 2]; rows.len()];
    for from in 0..count {
        let (chords, squares, _) = best[from];
        slopes.fill([f64::NEG_INFINITY, f64::INFINITY]);
        let mut most = longest(from);
        for to in from + 1..count {
            let length = rows[0][to].place - rows[0][from].place;
            // A chord to the next point is always possible.
            if length > most && to > from + 1 {
                break;
            }
            let rise = |row: &[Knot]| row[to].height - row[from].height;
            let mut passing = rows.iter().zip(&slopes);
            let passes =
                passing.all(|(row, &[least, greatest])| (least..=greatest).contains(&(rise(row) / length)));
            if passes || to == from + 1 {
                let way = (chords + 1, squares + length * length, from);
                if (way.0, way.1) < (best[to].0, best[to].1) {
                    best[to] = way;
                }
            }
            let mut is_possible = true;
            for (row, [least, greatest]) in rows.iter().zip(&mut slopes) {
                *least = least.max((rise(row) - tolerance) / length);
                *greatest = greatest.min((rise(row) + tolerance) / length);
                is_possible &= *least <= *greatest;
            }
            if !is_possible {
                break;
            }
            most = most.min(longest(to));
        }
    }
    let mut chosen = vec![count - 1];
    while let Some(&last) = chosen.last().filter(|&&last| last != 0) {
        chosen.push(best[last].2);
    }
    chosen.reverse();
    chosen
}
