//! Edge rule `error`: the fewest points within the tolerance.

use relief_core::registry::Publication;

use super::{Divides, EdgeRule, Knot, Spacing};

pub const RULE: EdgeRule = EdgeRule {
    name: "error",
    summary: "the fewest points whose chords stay within half of the tolerance",
    publication: Publication { paper: "Imai and Iri 1988, Polygonal Approximations of a Curve", section: "" },
    spacing: Spacing::Uneven,
    divides: Divides::Along(side),
};

/// Part of the tolerance that a side uses. The triangles at the side need the rest for the surface
/// beside it. More points on sides mean fewer inside.
const PART: f64 = 0.5;

fn side(rows: &[&[Knot]], tolerance: f64) -> Vec<usize> {
    fewest(rows, PART * tolerance, |knot| LONGEST * tolerance / knot.twist)
}

/// Longest chord in texels where the surface beside it has a twist of one tolerance per texel.
///
/// A triangle that is one step of the lattice wide, 1/16 of a texel, is off by a quarter of twist
/// times length times width. This may be at most half of the tolerance.
pub const LONGEST: f64 = 32.0;

/// Returns the fewest points of a line, first and last included, whose chords pass all others in
/// every row within the tolerance. No chord is longer than `longest` allows for any knot that it
/// leaves behind. Of several ways with equally many points, returns the one with the most even
/// chords.
fn fewest(rows: &[&[Knot]], tolerance: f64, longest: impl Fn(&Knot) -> f64) -> Vec<usize> {
    let count = rows[0].len();
    let longest = |at: usize| rows.iter().map(|row| longest(&row[at])).fold(f64::INFINITY, f64::min);
    // For each point: number of chords to it, sum of their squared lengths, and previous point.
    let mut best = vec![(usize::MAX, f64::INFINITY, 0); count];
    best[0] = (0, 0.0, 0);
    // Least and greatest slope that passes all points so far, in each row.
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
