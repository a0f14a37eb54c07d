//! Sides of base triangles by what lies along them.

use glam::DVec3;
use relief_core::mesh::BasePoint;

use super::creases::Creases;
use super::edges::Division;
use crate::MeshSettings;
use crate::edge::{Along, Knot, LONGEST};
use crate::interior::{Gap, PAIR, along};
use crate::surface::{Relief, twist_of};

/// The part of the tolerance that the points of sides are chosen by.
const CHOSEN: f64 = 0.8;

/// The part of the tolerance that a triangle beside a chord may have of it: twice what the surface is off the
/// chord, because the triangle may lie on its other side by as much where it is a step wide, and what it is
/// bent by on its account.
const BESIDE: f64 = 0.9;

/// What a triangle is bent by at most, in what one of its sides is.
const BENT_BESIDE: f64 = 4.0 / 3.0;

/// An edge of a seam.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    pub ends: [BasePoint; 2],
    /// No triangle that has it has a longer direction of displacement.
    pub reach: f64,
}

/// What a side is on the map, once for each of its edges.
struct Profile {
    /// Where its ends are in the map, `i` the centre of texel `i`.
    places: [[f64; 2]; 2],
    /// How much the direction of displacement turns along it, in lengths of the longest.
    turn: f64,
}

/// Where the edges of a seam have points.
pub fn division(
    relief: &Relief,
    creases: &Creases,
    edges: &[Edge],
    choose: Along,
    settings: &MeshSettings,
) -> Division {
    let longest = edges.iter().map(|edge| edge.reach).fold(0.0, f64::max);
    if longest == 0.0 {
        return Division::WHOLE;
    }
    let profiles: Vec<Profile> = edges
        .iter()
        .map(|Edge { ends: [a, b], .. }| Profile {
            places: [a, b].map(|end| relief.place(end.uv)),
            turn: DVec3::distance(a.normal, b.normal) / longest,
        })
        .collect();
    let tolerance = relief.tolerance(settings.error_m, longest);
    let length = profiles.iter().map(Profile::length).fold(0.0, f64::max);
    let size = profiles.iter().map(|profile| creases.steps(profile.places)).fold(1, u32::max);
    let side = Side { relief, profiles, tolerance, length, size };
    let at_texels = side.knots();
    let rows: Vec<&[Knot]> = at_texels.rows.iter().map(Vec::as_slice).collect();
    let chosen: Vec<u32> =
        choose(&rows, CHOSEN * tolerance).into_iter().map(|knot| at_texels.steps[knot]).collect();
    let mut steps = Vec::with_capacity(chosen.len());
    for ends in chosen.windows(2) {
        side.split([ends[0], ends[1]], &mut steps);
    }
    // The last one is the side's end.
    steps.pop();
    Division::Steps { size: side.size, steps: steps.into_iter().map(|step| step as u16).collect() }
}

impl Profile {
    fn place(&self, part: f64) -> [f64; 2] {
        let [from, to] = self.places;
        [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part)
    }

    fn length(&self) -> f64 {
        let [from, to] = self.places;
        (to[0] - from[0]).hypot(to[1] - from[1])
    }
}

/// A side that is divided.
struct Side<'a> {
    relief: &'a Relief,
    profiles: Vec<Profile>,
    /// As a height of the map.
    tolerance: f64,
    /// The length of the longest profile, in texels.
    length: f64,
    /// Steps of its lattice.
    size: u32,
}

/// Steps of a side that may be points, and what the profiles have there.
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

    /// A knot every texel, and more where the surface is twisted beside it.
    fn knots(&self) -> Knots {
        let per_texel = (f64::from(self.size) / self.length.max(1.0)).max(1.0) as u32;
        // A power of two goes into the size.
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
            // As finely as a chord beside so much twist may have to be.
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

    /// The points of a chord, the last one among them: its end alone, if it keeps to the tolerance between
    /// the steps, too, and where directions turn.
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
                let turn = profile.turn * self.part(to - from);
                let bent = BENT_BESIDE * PAIR * (heights[1] - heights[0]).abs() * turn;
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
