//! Levels of a photograph and of heights.

use rayon::prelude::*;

/// Parts of a line's places that a place of a shorter line covers.
fn parts(from: usize, to: usize, at: usize) -> impl Iterator<Item = (usize, f64)> {
    let ratio = from as f64 / to as f64;
    let [start, end] = [at, at + 1].map(|at| at as f64 * ratio);
    (start as usize..from.min(end.ceil() as usize)).map(move |place| {
        let part = (end.min(place as f64 + 1.0) - start.max(place as f64)).max(0.0);
        (place, part / ratio)
    })
}

/// Returns the means of a plane over the texels of a smaller one.
pub(super) fn averaged(plane: &[f32], from: [usize; 2], to: [usize; 2]) -> Vec<f32> {
    let mut out = vec![0.0; to[0] * to[1]];
    out.par_chunks_mut(to[0]).enumerate().for_each(|(j, out)| {
        for (i, out) in out.iter_mut().enumerate() {
            let mut sum = 0.0;
            for (row, part_v) in parts(from[1], to[1], j) {
                for (column, part_u) in parts(from[0], to[0], i) {
                    sum += part_u * part_v * f64::from(plane[row * from[0] + column]);
                }
            }
            *out = sum as f32;
        }
    });
    out
}

/// Returns a plane of heights on finer texels, bilinearly. `tiles` says whether it goes on at its
/// other side.
pub(super) fn refined(plane: &[f64], from: [usize; 2], to: [usize; 2], tiles: bool, factor: f64) -> Vec<f64> {
    let place = |axis: usize, at: usize| {
        let side = from[axis] as i64;
        let x = (at as f64 + 0.5) * from[axis] as f64 / to[axis] as f64 - 0.5;
        let first = x.floor();
        let within = |at: i64| if tiles { at.rem_euclid(side) } else { at.clamp(0, side - 1) } as usize;
        (within(first as i64), within(first as i64 + 1), x - first)
    };
    let columns: Vec<_> = (0..to[0]).map(|at| place(0, at)).collect();
    let mut out = vec![0.0; to[0] * to[1]];
    out.par_chunks_mut(to[0]).enumerate().for_each(|(j, out)| {
        let (above, below, part_v) = place(1, j);
        let [above, below] = [above, below].map(|row| &plane[row * from[0]..][..from[0]]);
        for (out, &(left, right, part_u)) in out.iter_mut().zip(&columns) {
            let at = |row: &[f64]| row[left] + part_u * (row[right] - row[left]);
            *out = factor * (at(above) + part_v * (at(below) - at(above)));
        }
    });
    out
}
