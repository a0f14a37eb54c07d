//! Meshes turned on a lathe: a column and a pot.

use std::fmt::Write;

/// Quads around the axis: a power of two from 4 on.
const AROUND: usize = 32;

/// Radius and height of points along a column of 1 m, from the ground up to the middle of its top.
const COLUMN: &[[f64; 2]] = &[
    [0.18, 0.0],
    [0.185, 0.035],
    [0.16, 0.065],
    [0.14, 0.085],
    [0.132, 0.12],
    [0.13, 0.3],
    [0.126, 0.5],
    [0.12, 0.7],
    [0.112, 0.87],
    [0.125, 0.91],
    [0.16, 0.94],
    [0.18, 0.965],
    [0.175, 0.985],
    [0.13, 1.0],
    [0.06, 1.0],
    [0.0, 1.0],
];

/// The same of a pot of 0.8 m with a thick wall: up on the outside, over the rim and down on the inside.
const POT: &[[f64; 2]] = &[
    [0.14, 0.0],
    [0.16, 0.03],
    [0.24, 0.14],
    [0.31, 0.3],
    [0.3, 0.44],
    [0.22, 0.57],
    [0.155, 0.66],
    [0.17, 0.74],
    [0.215, 0.79],
    [0.195, 0.805],
    [0.15, 0.77],
    [0.115, 0.67],
    [0.17, 0.56],
    [0.25, 0.43],
    [0.255, 0.3],
    [0.19, 0.16],
    [0.06, 0.09],
];

/// The column as an OBJ file.
pub fn column() -> String {
    obj("A column, 1 m high, turned on a lathe.", &smooth(COLUMN, 2))
}

/// The pot as an OBJ file.
pub fn pot() -> String {
    obj("A pot, 0.8 m high, turned on a lathe.", &smooth(POT, 3))
}

/// Smooth line through points (Catmull and Rom 1974), with a number of pieces from each to the next.
fn smooth(points: &[[f64; 2]], pieces: usize) -> Vec<[f64; 2]> {
    let last = points.len() - 1;
    let mut line = Vec::new();
    for from in 0..last {
        let [a, b, c, d] =
            [from.saturating_sub(1), from, from + 1, (from + 2).min(last)].map(|at| points[at]);
        line.extend((0..pieces).map(|piece| {
            let t = piece as f64 / pieces as f64;
            [0, 1].map(|axis| {
                let (a, b, c, d) = (a[axis], b[axis], c[axis], d[axis]);
                let cubic = 3.0 * (b - c) + d - a;
                b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * cubic))
            })
        }));
    }
    line.push(points[last]);
    line
}

/// Cosines and sines of directions all around an axis. Angles are halved by square roots alone.
pub fn directions() -> Vec<[f64; 2]> {
    let mut quarter = vec![[1.0, 0.0], [0.0, 1.0]];
    while 4 * (quarter.len() - 1) < AROUND {
        let between = |pair: &[[f64; 2]]| {
            let sum: [f64; 2] = [pair[0][0] + pair[1][0], pair[0][1] + pair[1][1]];
            let length = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt();
            [pair[0], [sum[0] / length, sum[1] / length]]
        };
        let finer = quarter.windows(2).flat_map(between);
        quarter = finer.chain([[0.0, 1.0]]).collect();
    }
    quarter.pop();
    let turned = |turns: usize| {
        let turn = move |[x, y]: [f64; 2]| match turns {
            0 => [x, y],
            1 => [-y, x],
            2 => [-x, -y],
            _ => [y, -x],
        };
        quarter.clone().into_iter().map(turn)
    };
    (0..4).flat_map(turned).collect()
}

/// A profile turned around the `y` axis. Texture coordinates go once around and once along the profile, whose
/// first point lies at the bottom of the texture.
fn obj(comment: &str, profile: &[[f64; 2]]) -> String {
    let directions = directions();
    let mut lengths = vec![0.0];
    for pair in profile.windows(2) {
        let [dr, dy] = [0, 1].map(|axis| pair[1][axis] - pair[0][axis]);
        lengths.push(lengths[lengths.len() - 1] + (dr * dr + dy * dy).sqrt());
    }
    let whole = lengths[lengths.len() - 1];
    let mut text = format!("# {comment} Written by `cargo xtask data`.\n");
    let mut line = |line: std::fmt::Arguments| {
        // A string takes whatever is written.
        let _ = text.write_fmt(line);
        text.push('\n');
    };
    for [radius, height] in profile {
        for [cos, sin] in &directions {
            line(format_args!("v {:.5} {height:.5} {:.5}", radius * cos + 0.0, 0.0 - radius * sin));
        }
    }
    for length in &lengths {
        for step in 0..=AROUND {
            line(format_args!("vt {:.5} {:.5}", step as f64 / AROUND as f64, length / whole));
        }
    }
    for ring in 0..profile.len() - 1 {
        for step in 0..AROUND {
            let corner = |ring: usize, step: usize| {
                let [vertex, coordinates] = [ring * AROUND + step % AROUND, ring * (AROUND + 1) + step];
                format!("{}/{}", vertex + 1, coordinates + 1)
            };
            let [a, b] = [corner(ring, step), corner(ring, step + 1)];
            let [c, d] = [corner(ring + 1, step + 1), corner(ring + 1, step)];
            if profile[ring + 1][0] > 0.0 {
                line(format_args!("f {a} {b} {c} {d}"));
            } else {
                line(format_args!("f {a} {b} {c}"));
            }
        }
    }
    text
}
