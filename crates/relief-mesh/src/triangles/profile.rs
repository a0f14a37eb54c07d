//! Division of sides of base triangles by the heights along them.

use glam::DVec3;
use relief_core::mesh::BasePoint;

use super::creases::{Creases, MOST_STEPS};
use super::edges::Division;
use super::shape::Shape;
use crate::Directions;
use crate::cubic::Cubic;
use crate::edge::{Along, Knot, LONGEST, divided};
use crate::interior::{Gap, Turning, along};
use crate::surface::{Relief, twist_of};

/// Part of the tolerance by which the points of sides are chosen.
const CHOSEN: f64 = 0.8;

/// Part of the tolerance that a triangle beside a chord may use for the chord. It covers twice the
/// distance of the surface from the chord, because the triangle may lie as far on the other side
/// where it is a step wide. It also covers the bend of the triangle along the chord.
const BESIDE: f64 = 0.9;

/// Greatest bend of a triangle, as a multiple of the bend of one of its sides.
const BENT_BESIDE: f64 = 4.0 / 3.0;

/// Part of the tolerance for the bend of a side over a step of its lattice.
const BENT_BY_A_STEP: f64 = 0.1;

/// Edge of a seam.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    pub ends: [BasePoint; 2],
    /// Shape of a smooth base along it, and the weights of its ends there.
    pub shape: Shape,
    pub part: [[f64; 3]; 2],
    /// Factor on its bend: see [`OneSide`](super::one_side::OneSide).
    pub factor: f64,
    /// Upper bound on the lengths of directions of displacement in its triangles.
    pub reach: f64,
}

/// Course of a side on the map, one for each of its edges.
struct Profile {
    /// Places of its ends in the map: the centre of texel `i` is at `i`.
    places: [[f64; 2]; 2],
    /// Turning of a triangle whose last two corners are the second end.
    turning: Turning,
}

/// Returns the division of the edges of a seam.
pub fn division(relief: &Relief, creases: &Creases, edges: &[Edge], choose: Along, error_m: f64) -> Division {
    let longest = edges.iter().map(|edge| edge.reach).fold(0.0, f64::max);
    if longest == 0.0 {
        return Division::WHOLE;
    }
    let height_m = relief.height_m(error_m, longest);
    let profile = |Edge { ends: [a, b], shape, part: [from, to], factor, .. }: &Edge| {
        let normals = [a.normal, b.normal, b.normal];
        let turning = turning(relief, normals, (longest, height_m), *shape);
        Profile {
            places: [a, b].map(|end| relief.place(end.uv)),
            turning: Turning { factor: *factor, part: [*from, *to, *to], ..turning },
        }
    };
    let profiles: Vec<Profile> = edges.iter().map(profile).collect();
    let tolerance = relief.tolerance(error_m, longest);
    let length = profiles.iter().map(Profile::length).fold(0.0, f64::max);
    let steps = |profile: &Profile| creases.steps(profile.places).max(profile.steps(tolerance));
    let size = profiles.iter().map(steps).fold(1, u32::max);
    let side = Side { relief, profiles, tolerance, length, size };
    let at_texels = side.knots();
    let rows: Vec<&[Knot]> = at_texels.rows.iter().map(Vec::as_slice).collect();
    let fixed = side.ends_of_holes(&at_texels.steps);
    let chosen = divided(choose, &rows, &fixed, CHOSEN * tolerance);
    let chosen: Vec<u32> = chosen.into_iter().map(|knot| at_texels.steps[knot]).collect();
    let mut steps = Vec::with_capacity(chosen.len());
    for ends in chosen.windows(2) {
        side.split([ends[0], ends[1]], &mut steps);
    }
    // The last step is the side's end.
    steps.pop();
    Division::Steps { size: side.size, steps: steps.into_iter().map(|step| step as u16).collect() }
}

/// Returns the turning of a triangle with these directions of displacement and this shape of the
/// base. `longest` is the length of the longest direction, `height_m` the unit of heights in
/// metres.
pub fn turning(
    relief: &Relief,
    directions: [DVec3; 3],
    (longest, height_m): (f64, f64),
    shape: Shape,
) -> Turning {
    let is_unit = relief.directions() != Directions::Raw;
    let directions = if is_unit { directions } else { directions.map(|along| along / longest) };
    let flat = Turning { is_unit, at_zero: relief.zero_m() / height_m, ..Turning::flat(directions) };
    match shape {
        Shape::Flat => flat,
        Shape::Lift(lifts_m) => Turning { lifts: lifts_m.map(|lift_m| lift_m / height_m), ..flat },
        Shape::Cubic(corners, sides) => {
            Turning { cubic: Some(Cubic::new(corners, sides).in_units_of(height_m)), ..flat }
        }
    }
}

impl Profile {
    fn place(&self, part: f64) -> [f64; 2] {
        let [from, to] = self.places;
        [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part)
    }

    /// Returns the number of steps that make the bend of level ground over one step negligible.
    fn steps(&self, tolerance: f64) -> u32 {
        let is_enough = |steps: &u32| {
            let step = 1.0 / f64::from(*steps);
            // The greatest change is at an end or in the middle.
            [0.0, 0.5 - 0.5 * step, 1.0 - step].into_iter().all(|from| {
                [0.0, 1.0].into_iter().all(|height| {
                    let [a, b] = [from, from + step].map(|part| ([1.0 - part, part, 0.0], height));
                    self.turning.bend([a, b, b]) <= BENT_BY_A_STEP * tolerance
                })
            })
        };
        let powers = (0..=MOST_STEPS.ilog2()).map(|power| 1 << power);
        powers.into_iter().find(is_enough).unwrap_or(MOST_STEPS)
    }

    fn length(&self) -> f64 {
        let [from, to] = self.places;
        (to[0] - from[0]).hypot(to[1] - from[1])
    }
}

/// Side to be divided.
struct Side<'a> {
    relief: &'a Relief,
    profiles: Vec<Profile>,
    /// Tolerance as a height of the map.
    tolerance: f64,
    /// Length of the longest profile, in texels.
    length: f64,
    /// Number of steps of its lattice.
    size: u32,
}

/// Steps of a side that may become points, and the profiles' knots there.
struct Knots {
    steps: Vec<u32>,
    rows: Vec<Vec<Knot>>,
}

impl Side<'_> {
    fn part(&self, step: u32) -> f64 {
        f64::from(step) / f64::from(self.size)
    }

    fn height(&self, profile: &Profile, step: u32) -> f64 {
        self.relief.height_at(profile.place(self.part(step)))
    }

    /// Returns the knots at which a hole begins or ends.
    fn ends_of_holes(&self, steps: &[u32]) -> Vec<usize> {
        if !self.relief.has_holes() {
            return Vec::new();
        }
        let is_hole = |profile: &Profile, at: usize| {
            let middle = 0.5 * (self.part(steps[at]) + self.part(steps[at + 1]));
            self.relief.is_hole(profile.place(middle))
        };
        let ends = |at: &usize| {
            self.profiles.iter().any(|profile| is_hole(profile, at - 1) != is_hole(profile, *at))
        };
        (1..steps.len() - 1).filter(ends).collect()
    }

    /// Returns a knot every texel, and more where the surface beside it is twisted.
    fn knots(&self) -> Knots {
        let per_texel = (f64::from(self.size) / self.length.max(1.0)).max(1.0) as u32;
        // A power of two divides the size.
        let stride = if per_texel.is_power_of_two() { per_texel } else { per_texel.next_power_of_two() / 2 };
        let mut steps = Vec::new();
        let mut twists: Vec<Vec<f64>> = vec![Vec::new(); self.profiles.len()];
        for first in (0..self.size).step_by(stride as usize) {
            let twist = |profile: &Profile| {
                let at = |sixths: f64| {
                    let part = self.part(first) + self.part(stride) * sixths / 6.0;
                    let [x, y] = profile.place(part);
                    twist_of(self.relief.map().cell(x.floor() as i64, y.floor() as i64))
                };
                at(1.0).max(at(3.0)).max(at(5.0))
            };
            let of_profiles: Vec<f64> = self.profiles.iter().map(twist).collect();
            let most = of_profiles.iter().copied().fold(0.0, f64::max);
            // As finely as a chord beside this twist may need.
            let pieces = (most / (LONGEST * self.tolerance)).ceil().clamp(1.0, f64::from(stride)) as u32;
            let every = stride / pieces.next_power_of_two().min(stride);
            for step in (first..first + stride).step_by(every as usize) {
                steps.push(step);
                for (row, twist) in twists.iter_mut().zip(&of_profiles) {
                    row.push(*twist);
                }
            }
        }
        steps.push(self.size);
        let rows = self.profiles.iter().zip(twists).map(|(profile, twists)| {
            let knot = |(&step, twist): (&u32, f64)| Knot {
                place: self.part(step) * self.length,
                height: self.height(profile, step),
                twist,
            };
            steps.iter().zip(twists.into_iter().chain([0.0])).map(knot).collect()
        });
        let rows = rows.collect();
        Knots { steps, rows }
    }

    /// Adds the points of a chord, the last one being its end. The end alone is enough if the chord
    /// keeps to the tolerance between the steps, too, and where directions turn.
    fn split(&self, [from, to]: [u32; 2], into: &mut Vec<u32>) {
        let middle = (to - from > 1).then(|| {
            self.profiles.iter().find_map(|profile| {
                let heights = [from, to].map(|step| self.height(profile, step));
                let places = [from, to].map(|step| profile.place(self.part(step)));
                let found = along(places, heights, |place| {
                    let cell = place.map(|at| at.floor() as i64);
                    (cell, self.relief.map().cell(cell[0], cell[1]).map(f64::from))
                });
                let Gap { height: gap, place: at } = found.worst()?;
                let corner = |end: usize| {
                    let part = self.part([from, to][end]);
                    ([1.0 - part, part, 0.0], heights[end])
                };
                let bent = BENT_BESIDE * profile.turning.bend([corner(0), corner(1), corner(1)]);
                let off = 2.0 * gap.abs();
                if off + bent <= BESIDE * self.tolerance {
                    return None;
                }
                if bent > off {
                    return Some(from + (to - from) / 2);
                }
                let step = from + (f64::from(to - from) * at).round() as u32;
                Some(step.clamp(from + 1, to - 1))
            })
        });
        match middle.flatten() {
            Some(middle) => {
                self.split([from, middle], into);
                self.split([middle, to], into);
            }
            None => into.push(to),
        }
    }
}
