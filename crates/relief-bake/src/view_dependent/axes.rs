//! Axes of view-dependent maps: azimuth, elevation and bend of paths that come in at the top.
//!
//! A path that comes in at height 1 and falls there has the height `1 - F + β F²`. `F` is the way
//! along it as a part of the way after which a straight path of the same slope is at height 0. `L`
//! is the length of that way along the base, in tiles. The path ends at height 0 or, if it bends up
//! from there on (`β ≥ ¼`), at height 1, after [`whole_way`].

use std::f64::consts::TAU;

use relief_core::{Path, PathMetric};

/// Bend at which a path just touches height 0. Paths of a greater bend come back to height 1.
pub const TOUCHING: f64 = 0.25;

/// Axes of a map, and their numbers of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Azimuths, at least 1: equal steps of the whole circle, from `+u` towards `+v`, in tiles.
    pub azimuths: u32,
    /// Elevations, at least 1: equal steps of [`elevation`](Axes::elevation).
    pub elevations: u32,
    /// Bends: 1 for straight paths, or equal steps of [`bend`].
    pub bends: u32,
    /// Depth of the relief, as a part of a tile's side, for which the middle elevation is 45
    /// degrees.
    pub depth: f64,
}

/// Ranges of the paths in a cell of all axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathRanges {
    /// Azimuth in turns.
    pub turn: [f64; 2],
    /// `L` in tiles; the greatest may be infinite.
    pub length: [f64; 2],
    /// `β`; both may be infinite.
    pub bend: [f64; 2],
    /// Greatest whole way `F` of the step of bends: ways are stored as parts of it.
    pub longest: f64,
}

/// Amount by which ranges are widened on each axis, which is 1 long: far more than shaders'
/// angles and quotients are off.
const SLACK: f64 = 2e-5;

impl Axes {
    /// Returns the number of layers: azimuths times elevations.
    pub fn layers(&self) -> u32 {
        self.azimuths * self.elevations
    }

    /// Returns the elevation of a path, from 0, upright, to 1, level, by its length `L` in tiles.
    pub fn elevation(&self, length: f64) -> f64 {
        length / (length + self.depth)
    }

    /// Returns the length `L` at an elevation; infinite from 1 on.
    fn length(&self, elevation: f64) -> f64 {
        if elevation < 1.0 { self.depth * elevation / (1.0 - elevation) } else { f64::INFINITY }
    }

    /// Returns the path in the middle of a cell that comes in at `uv`, with `F` as its parameter,
    /// and its [`whole_way`], at which it ends.
    pub fn path(&self, uv: [f64; 2], layer: u32, bend: u32) -> Path {
        let [azimuth, elevation] = [layer / self.elevations, layer % self.elevations];
        let angle = TAU * (f64::from(azimuth) + 0.5) / f64::from(self.azimuths);
        let length = self.length((f64::from(elevation) + 0.5) / f64::from(self.elevations));
        let bend = match self.bends {
            1 => 0.0,
            bends => bend_at(2.0 * (f64::from(bend) + 0.5) / f64::from(bends) - 1.0),
        };
        Path {
            uv,
            duv: [length * angle.cos(), length * angle.sin()],
            h: [1.0, -1.0, bend],
            exit: whole_way(bend),
            base: 0.0,
            metric: PathMetric::unit(1.0),
        }
    }

    /// Returns the ranges of a cell, a little widened.
    pub fn ranges(&self, layer: u32, bend: u32) -> PathRanges {
        let step =
            |number: u32, count: u32| [number, number + 1].map(|side| f64::from(side) / f64::from(count));
        let widened = |[low, high]: [f64; 2]| [low - SLACK, high + SLACK];
        let elevation = widened(step(layer % self.elevations, self.elevations));
        let (bend, longest) = match self.bends {
            1 => ([0.0; 2], 1.0),
            bends => {
                let place = |at: f64| (2.0 * at - 1.0).clamp(-1.0, 1.0);
                let sides = step(bend, bends);
                (widened(sides).map(|at| bend_at(place(at))), longest(sides.map(place)))
            }
        };
        PathRanges {
            turn: widened(step(layer / self.elevations, self.azimuths)),
            length: elevation.map(|elevation| self.length(elevation.max(0.0))),
            bend,
            longest,
        }
    }
}

/// Returns the place of a bend `β` on its axis, from -1 to 1: ½ at [`TOUCHING`].
pub fn bend(bend: f64) -> f64 {
    bend / (TOUCHING + bend.abs())
}

/// Returns the bend at a place on its axis, from -1 to 1; infinite at both ends.
fn bend_at(place: f64) -> f64 {
    TOUCHING * place / (1.0 - place.abs())
}

/// Returns the greatest whole way of paths whose bends lie between two places on their axis.
fn longest([low, high]: [f64; 2]) -> f64 {
    // Up to ½ paths reach height 0, the last of them after twice the way of a straight one.
    if high <= 0.5 + 1e-9 {
        return 2.0 / (1.0 + (1.0 - high / (1.0 - high.abs())).max(0.0).sqrt());
    }
    1.0 / bend_at(low.max(0.5))
}

/// Returns the way `F` of a path to height 0, or back to height 1.
pub fn whole_way(bend: f64) -> f64 {
    if bend < TOUCHING { 2.0 / (1.0 + (1.0 - 4.0 * bend).sqrt()) } else { 1.0 / bend }
}

impl PathRanges {
    /// Returns the least height of all these paths on a part of their ways `F`.
    pub fn least_height(&self, [begin, end]: [f64; 2]) -> f64 {
        let bend = self.bend[0];
        // The height 1 - F + β F² grows with β. It is least at an end, or where a path turns up.
        let turns = if bend > 0.0 { 0.5 / bend } else { f64::INFINITY };
        let least = turns.clamp(begin, end);
        if least > 0.0 { 1.0 - least + bend * least * least } else { 1.0 }
    }

    /// Returns the least and the greatest place of these paths along `u` and along `v`, in tiles
    /// from where they come in, on a part of their ways `F`.
    pub fn places(&self, [begin, end]: [f64; 2]) -> [[f64; 2]; 2] {
        let (near, far) = (begin * self.length[0], if end > 0.0 { end * self.length[1] } else { 0.0 });
        self.directions().map(|[low, high]| {
            [
                if low < 0.0 { low * far } else { low * near },
                if high > 0.0 { high * far } else { high * near },
            ]
        })
    }

    /// Returns the least and the greatest part of a step that goes along `u` and along `v`.
    fn directions(&self) -> [[f64; 2]; 2] {
        let [from, to] = self.turn;
        [0.0, 0.25].map(|axis| {
            // The cosine of the angle from the axis, whose direction is at `axis` turns.
            let ends = [from, to].map(|turn| (TAU * (turn - axis)).cos());
            let holds = |place: f64| (from - place).ceil() <= (to - place).floor();
            let high = if holds(axis) { 1.0 } else { ends[0].max(ends[1]) };
            let low = if holds(axis + 0.5) { -1.0 } else { ends[0].min(ends[1]) };
            [low, high]
        })
    }
}
