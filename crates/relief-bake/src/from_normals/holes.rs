//! Texels of a normal map that hold no normal: background, and normals mixed with it.

use super::error::SHORTEST;
use super::slopes::{NormalFaults, is_unit, length};

/// If all three components lie between these, they belong to no unit vector, whose least component
/// is at most 0.577. Rounding and compression move background less far. Longer vectors are from no
/// picture, but are vectors of any length.
const ENDS: std::ops::RangeInclusive<f32> = 0.8..=1.01;

/// Opacity is a mask if at least this part of it is 0 or 1. A picture of heights has more values
/// between.
const MASK: f64 = 0.9;

/// Rows of texels beside a hole that may be mixed with it: a block of JPEG.
const MIXED: usize = 8;

/// If all but this part of the other normals have length 1, normals beside a hole of another length
/// are mixed.
const FEW: f64 = 0.05;

/// Texels that hold a normal, and counts of the others.
pub(super) struct Holes {
    pub known: Vec<bool>,
    /// Counts of holes; the others are 0.
    pub faults: NormalFaults,
}

impl Holes {
    pub fn find([width, _]: [u32; 2], normals: &[[f32; 3]], opacity: Option<&[f32]>) -> Self {
        let width = width as usize;
        let mask = opacity.filter(|opacity| is_mask(opacity));
        let mut faults = NormalFaults::default();
        let mut not_unit = 0;
        let mut known = vec![true; normals.len()];
        let mut edge = Vec::new();
        for (at, &normal) in normals.iter().enumerate() {
            let count = if mask.is_some_and(|mask| mask[at] < 0.5) {
                &mut faults.transparent
            } else if !(length(normal).is_finite() && length(normal) >= SHORTEST) {
                &mut faults.without_direction
            } else if normal.iter().all(|x| ENDS.contains(&x.abs())) {
                &mut faults.background
            } else {
                not_unit += usize::from(!is_unit(normal));
                continue;
            };
            *count += 1;
            known[at] = false;
            edge.push(at);
        }
        let seen = normals.len() - edge.len();
        if not_unit as f64 <= FEW * seen as f64 {
            faults.mixed = grow(&mut known, edge, normals, width);
        }
        let first = known.iter().position(|known| !known);
        faults.first_hole = first.map(|at| [(at % width) as u32, (at / width) as u32]);
        Self { known, faults }
    }
}

/// Returns whether opacity separates texels with a normal from those without.
fn is_mask(opacity: &[f32]) -> bool {
    let clear = opacity.iter().filter(|opacity| **opacity <= 0.0).count();
    let full = opacity.iter().filter(|opacity| **opacity >= 0.999).count();
    clear > 0 && full > 0 && (clear + full) as f64 >= MASK * opacity.len() as f64
}

/// Turns texels beside holes into holes unless their length is 1. Returns their number.
fn grow(known: &mut [bool], mut edge: Vec<usize>, normals: &[[f32; 3]], width: usize) -> usize {
    let height = normals.len() / width;
    let mut mixed = 0;
    for _ in 0..MIXED {
        let mut next = Vec::new();
        for at in edge {
            let (column, row) = (at % width, at / width);
            for j in row.saturating_sub(1)..(row + 2).min(height) {
                for i in column.saturating_sub(1)..(column + 2).min(width) {
                    let at = j * width + i;
                    if known[at] && !is_unit(normals[at]) {
                        known[at] = false;
                        next.push(at);
                    }
                }
            }
        }
        mixed += next.len();
        edge = next;
    }
    mixed
}
