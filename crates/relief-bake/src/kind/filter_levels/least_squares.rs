//! Level whose surface has the least mean square difference from the map's.

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

use super::axis::Axis;

/// Most steps: the error falls to `sqrt(2/3)` of itself in each, and from 1 to below a rounding of
/// `f32`.
const STEPS: usize = 120;

/// A step that moves nothing by more than the distance of two `f32` below 1 is the last one.
const SMALLEST: f64 = 1.0 / (1 << 24) as f64;

/// Nesterov's momentum `(1 - sqrt(1/9)) / (1 + sqrt(1/9))`. Along an axis, the least eigenvalue of
/// the mass matrix of hats is at least `1/3`, by Gershgorin's circles, and the greatest at most 1.
/// For surfaces, the least eigenvalue is therefore at least `1/9`.
const MOMENTUM: f64 = 0.5;

/// Integrals along an axis, in texels of the level.
struct Integrals {
    /// Integrals of the square of each hat.
    own: Vec<f64>,
    /// Integrals of each hat times the next.
    next: Vec<f64>,
    /// Integrals of each hat times hats of the map: texels and values.
    with_map: Vec<Vec<(u32, f64)>>,
}

impl Integrals {
    /// Sums over points at which products of two hats are sampled exactly.
    fn new(axis: Axis) -> Self {
        let nodes = axis.nodes();
        let (mut own, mut next, mut with_map) = (vec![0.0; nodes], vec![0.0; nodes], vec![Vec::new(); nodes]);
        for [at, length] in axis.points() {
            let length = length * f64::from(axis.coarse) / f64::from(axis.fine);
            let place = axis.place(at);
            let ends = axis.ends(place.cell);
            let hats = [1.0 - place.within, place.within];
            let (texels, between) = axis.between(at);
            let texels = [(texels[0], 1.0 - between), (texels[1], between)];
            for (node, hat) in ends.into_iter().zip(hats) {
                own[node] += length * hat * hat;
                let row: &mut Vec<(u32, f64)> = &mut with_map[node];
                for (texel, value) in texels {
                    match row.iter_mut().rev().take(4).find(|(known, _)| *known == texel) {
                        Some((_, sum)) => *sum += length * hat * value,
                        None => row.push((texel, length * hat * value)),
                    }
                }
            }
            let product = length * hats[0] * hats[1];
            if ends[0] == ends[1] {
                own[ends[0]] += 2.0 * product;
            } else {
                next[ends[0]] += product;
            }
        }
        Self { own, next, with_map }
    }

    /// Returns the texel before one. For the first of a map that is not tiled, it is the last;
    /// their integral is 0.
    fn before(&self, node: usize) -> usize {
        node.checked_sub(1).unwrap_or(self.own.len() - 1)
    }

    fn after(&self, node: usize) -> usize {
        if node + 1 < self.own.len() { node + 1 } else { 0 }
    }

    /// Returns a texel, the one before and the one after, with the integrals of their hats times
    /// its hat.
    fn around(&self, node: usize) -> [(usize, f64); 3] {
        let before = self.before(node);
        [(before, self.next[before]), (node, self.own[node]), (self.after(node), self.next[node])]
    }
}

/// Returns the level's texels, row by row from the top. Of all heights from 0 to 1, these have the
/// least integral of the squared difference, to rounding. `start` are the texels of a level near
/// by.
pub fn level(map: &HeightMap, size: [u32; 2], start: &[f32], watch: &Watch) -> Result<Vec<f32>, Cancelled> {
    let repeats = map.wrap() == Wrap::Repeat;
    let across = Integrals::new(Axis { fine: map.width(), coarse: size[0], repeats });
    let down = Integrals::new(Axis { fine: map.height(), coarse: size[1], repeats });
    let width = size[0] as usize;
    let wanted = with_map(map, &across, &down, &watch.piece(0.0, 0.5))?;
    // Nesterov's method with projection: `x` are the heights, `y` where the next step begins.
    let (mut x, mut y) = (start.to_vec(), start.to_vec());
    let mut ahead = vec![0.0f32; x.len()];
    for step in 0..STEPS {
        watch.at(0.5 + 0.5 * step as f32 / STEPS as f32)?;
        let rows = x.par_chunks_mut(width).zip(ahead.par_chunks_mut(width)).zip(wanted.par_chunks(width));
        let change = rows
            .enumerate()
            .map_init(
                || vec![0.0f64; width],
                |line, (row, ((x, ahead), wanted))| {
                    line.fill(0.0);
                    for (at, integral) in down.around(row) {
                        for (sum, &value) in line.iter_mut().zip(&y[at * width..][..width]) {
                            *sum += integral * f64::from(value);
                        }
                    }
                    let own = &y[row * width..][..width];
                    let mut change = 0.0f64;
                    for (column, (x, ahead)) in x.iter_mut().zip(ahead).enumerate() {
                        let product: f64 =
                            across.around(column).into_iter().map(|(at, integral)| integral * line[at]).sum();
                        let (from, before) = (f64::from(own[column]), f64::from(*x));
                        let after = (from - (product - wanted[column])).clamp(0.0, 1.0);
                        change = change.max((after - from).abs());
                        *ahead = (after + MOMENTUM * (after - before)) as f32;
                        *x = after as f32;
                    }
                    change
                },
            )
            .reduce(|| 0.0, f64::max);
        std::mem::swap(&mut y, &mut ahead);
        if change <= SMALLEST {
            break;
        }
    }
    Ok(x)
}

/// Returns the integral of each of the level's surface hats times the map's surface, row by row
/// from the top.
fn with_map(
    map: &HeightMap,
    across: &Integrals,
    down: &Integrals,
    watch: &Watch,
) -> Result<Vec<f64>, Cancelled> {
    let (width, nodes) = (map.width() as usize, across.own.len());
    let mut wanted = vec![0.0; nodes * down.own.len()];
    let rows = down.with_map.len() as f32;
    wanted.par_chunks_mut(nodes).zip(&down.with_map).enumerate().try_for_each_init(
        || vec![0.0f64; width],
        |line, (row, (wanted, texels))| {
            watch.at(row as f32 / rows)?;
            line.fill(0.0);
            for &(texel, integral) in texels {
                for (sum, &height) in line.iter_mut().zip(&map.texels()[texel as usize * width..][..width]) {
                    *sum += integral * f64::from(height);
                }
            }
            for (wanted, texels) in wanted.iter_mut().zip(&across.with_map) {
                *wanted = texels.iter().map(|&(texel, integral)| integral * line[texel as usize]).sum();
            }
            Ok(())
        },
    )?;
    Ok(wanted)
}
