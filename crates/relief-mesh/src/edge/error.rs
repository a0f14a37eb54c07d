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

fn side(knots: &[Knot], tolerance: f64) -> Vec<usize> {
    fewest(knots, PART * tolerance, |knot| LONGEST * tolerance / knot.twist)
}

/// How many texels long a chord may be where the surface beside it has a twist of one tolerance a texel: a
/// triangle that is a step of the lattice wide, 1/16 of a texel, lies off by a quarter of the twist times
/// length and width, which is to be at most half of the tolerance.
pub const LONGEST: f64 = 32.0;

/// The fewest of some points of a line, the first and the last among them, whose chords pass all others
/// within the tolerance, and are no longer than `longest` says for each knot that they leave behind; of the
/// ways with as many points the one whose chords are the most even.
fn fewest(knots: &[Knot], tolerance: f64, longest: impl Fn(&Knot) -> f64) -> Vec<usize> {
    // The number of chords to a point, the sum of their squared lengths, and the point before.
    let mut best = vec![(usize::MAX, f64::INFINITY, 0); knots.len()];
    best[0] = (0, 0.0, 0);
    for from in 0..knots.len() {
        let (chords, squares, _) = best[from];
        let start = knots[from];
        let (mut least, mut greatest, mut most) = (f64::NEG_INFINITY, f64::INFINITY, longest(&start));
        for to in from + 1..knots.len() {
            let knot = knots[to];
            let length = knot.place - start.place;
            // A chord to the next point is always possible.
            if length > most && to > from + 1 {
                break;
            }
            let rise = knot.height - start.height;
            let slope = rise / length;
            if (least..=greatest).contains(&slope) || to == from + 1 {
                let way = (chords + 1, squares + length * length, from);
                if (way.0, way.1) < (best[to].0, best[to].1) {
                    best[to] = way;
                }
            }
            least = least.max((rise - tolerance) / length);
            greatest = greatest.min((rise + tolerance) / length);
            if least > greatest {
                break;
            }
            most = most.min(longest(&knot));
        }
    }
    let mut chosen = vec![knots.len() - 1];
    while let Some(&last) = chosen.last().filter(|&&last| last != 0) {
        chosen.push(best[last].2);
    }
    chosen.reverse();
    chosen
}
