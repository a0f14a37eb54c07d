//! A tree of leaf cards around a crown, on a stem, and its colours.

use std::fmt::Write;

use super::lathe::directions;
use super::lattice::{fractal_noise, mix, mix_colour, random, signed, smooth_step};
use super::picture::Grid;

/// Leaf cards.
const CARDS: u32 = 2000;

/// Directions around an axis that each side of the stem spans.
const STEM_STEP: usize = 4;

/// Radius of the stem, and its lower and its upper end, in metres.
const STEM: [f64; 3] = [0.06, -0.6, 0.4];

/// Half the width of the crown along the axes, and the height of its middle, in metres.
const CROWN: ([f64; 3], f64) = ([0.6, 0.55, 0.6], 0.45);

/// Texels of a side of the picture, and how many leaves it has along each side. The last of its rows is
/// bark.
const SIDE: u32 = 128;
const CELLS: u32 = 8;

const LEAF: [[f64; 3]; 3] = [[88.0, 132.0, 44.0], [58.0, 104.0, 36.0], [128.0, 150.0, 56.0]];
const RIB: [f64; 3] = [158.0, 178.0, 104.0];
const BARK: [[f64; 3]; 2] = [[86.0, 66.0, 48.0], [52.0, 40.0, 30.0]];

type Vector = [f64; 3];

/// Random numbers, one after another.
struct Random(u32);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 += 1;
        random(self.0, 0, 5)
    }

    /// A unit vector, all directions equally likely.
    fn direction(&mut self) -> Vector {
        loop {
            let at = [self.unit(), self.unit(), self.unit()].map(|part| 2.0 * part - 1.0);
            let length = length(at);
            if length > 0.1 && length <= 1.0 {
                return at.map(|part| part / length);
            }
        }
    }
}

fn length([x, y, z]: Vector) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn sum(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

/// The corners of all quads, and the cell of the picture that each shows.
fn quads() -> Vec<([Vector; 4], u32)> {
    let mut random = Random(0);
    let quad = |corner: Vector, right: Vector, up: Vector| {
        [corner, sum(corner, right), sum(sum(corner, right), up), sum(corner, up)]
    };
    let leaf = |_| {
        // More leaves stand outside than within.
        let out = random.unit().sqrt().sqrt();
        let place: Vec<f64> =
            random.direction().iter().zip(CROWN.0).map(|(at, half)| at * half * out).collect();
        let (facing, size) = (random.direction(), mix(0.05, 0.09, random.unit()));
        let beside = loop {
            let beside = cross(facing, random.direction());
            if length(beside) > 0.1 {
                break beside;
            }
        };
        let right = beside.map(|part| part * size / length(beside));
        let up = cross(facing, right);
        let half = sum(right, up).map(|part| -0.5 * part);
        let corner = sum([place[0], place[1] + CROWN.1, place[2]], half);
        (quad(corner, right, up), (random.unit() * f64::from(CELLS * (CELLS - 1))) as u32)
    };
    let mut quads: Vec<_> = (0..CARDS).map(leaf).collect();
    let [radius, low, high] = STEM;
    let around: Vec<[f64; 2]> = directions().into_iter().step_by(STEM_STEP).collect();
    let side = |at: usize| {
        let [a, b] = [at, at + 1].map(|at| {
            let [x, z] = around[at % around.len()];
            [radius * x, low, 0.0 - radius * z]
        });
        let right = [0, 1, 2].map(|axis| b[axis] - a[axis]);
        (quad(a, right, [0.0, high - low, 0.0]), CELLS * (CELLS - 1) + at as u32 % CELLS)
    };
    quads.extend((0..around.len()).map(side));
    quads
}

/// The tree as an OBJ file.
pub fn mesh() -> String {
    let mut text = String::from("# A tree of leaf cards, 1.6 m high. Written by `cargo xtask data`.\n");
    let mut line = |line: std::fmt::Arguments| {
        // A string takes whatever is written.
        let _ = text.write_fmt(line);
        text.push('\n');
    };
    let quads = quads();
    for [x, y, z] in quads.iter().flat_map(|(corners, _)| corners) {
        line(format_args!("v {:.4} {:.4} {:.4}", x + 0.0, y + 0.0, z + 0.0));
    }
    // Half a texel within the cell, so that no other leaf shines through.
    let within = 0.5 / f64::from(SIDE);
    let cell = 1.0 / f64::from(CELLS);
    for at in 0..CELLS * CELLS {
        let (left, top) = (f64::from(at % CELLS) * cell, f64::from(at / CELLS) * cell);
        for [u, v] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            let [u, down] = [left + mix(within, cell - within, u), top + mix(within, cell - within, 1.0 - v)];
            line(format_args!("vt {u:.5} {:.5}", 1.0 - down));
        }
    }
    for (number, (_, cell)) in quads.iter().enumerate() {
        let corner = |at: usize| format!("{}/{}", 4 * number + at + 1, 4 * *cell as usize + at + 1);
        line(format_args!("f {} {} {} {}", corner(0), corner(1), corner(2), corner(3)));
    }
    text
}

/// Colours of the tree: leaves with ribs, and bark.
pub fn colours() -> Grid<[f64; 3]> {
    Grid::square(SIDE, |u, v| {
        let [x, y] = [u, v].map(|at| at * f64::from(CELLS));
        let (column, row) = (x as u32, y as u32);
        let (x, y) = (x - f64::from(column), y - f64::from(row));
        let shade = fractal_noise(u, v, 16, 3, 41);
        if row == CELLS - 1 {
            let groove = smooth_step(0.0, 0.6, fractal_noise(u, 0.25 * v, 32, 2, 43) + 0.3 * shade);
            return mix_colour(BARK[1], BARK[0], groove);
        }
        let of = |kind: u32| random(column, row, kind);
        let leaf = mix_colour(mix_colour(LEAF[0], LEAF[1], of(51)), LEAF[2], of(52) * of(53));
        let leaf = leaf.map(|part| part * (1.0 + 0.12 * shade + 0.1 * signed(column, row, 54)));
        // A rib along the diagonal, and the edge a little darker.
        let rib = 1.0 - smooth_step(0.02, 0.06, (x + y - 1.0).abs());
        let edge = (x - 0.5).abs().max((y - 0.5).abs());
        mix_colour(leaf, RIB, 0.6 * rib)
            .map(|part| (part * (1.0 - 0.25 * smooth_step(0.4, 0.5, edge))).min(255.0))
    })
}
