//! Texels on the faces of a cube.

use glam::DVec3;
use rayon::prelude::*;

/// Returns all six faces with `side` texels a side, at least 2. A texel, row by row, holds `light`
/// in its direction and a 0.
///
/// The outer texels lie on the edges of the cube. Faces that share a direction have exactly the
/// same one.
pub fn faces(side: u32, light: impl Fn(DVec3) -> [f32; 3] + Sync) -> Vec<[f32; 4]> {
    let face = side as usize * side as usize;
    let texel = |at: usize| {
        let (row, column) = (at % face / side as usize, at % side as usize);
        let [red, green, blue] = light(direction(at / face, column, row, side as usize));
        [red, green, blue, 0.0]
    };
    (0..6 * face).into_par_iter().map(texel).collect()
}

/// Returns the unit direction of a texel. It is computed from whole numbers that are the same on
/// every face that shares it.
fn direction(face: usize, column: usize, row: usize, side: usize) -> DVec3 {
    let last = side as f64 - 1.0;
    let [a, b] = [column, row].map(|at| 2.0 * at as f64 - last);
    let place = match face {
        0 => [last, -b, -a],
        1 => [-last, -b, a],
        2 => [a, last, b],
        3 => [a, -last, -b],
        4 => [a, -b, last],
        _ => [-a, -b, -last],
    };
    DVec3::from(place).normalize()
}
