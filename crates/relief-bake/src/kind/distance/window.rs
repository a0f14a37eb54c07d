//! Squared distance transform of a line by windows, for distances of few samples.

/// Samples whose windows are searched together.
const BLOCK: usize = 32;

/// Steps between two tests whether nothing nearer is left.
const STRIDE: usize = 4;

/// Returns an upper bound of the steps that the mean block of a line needs to either side.
///
/// `values` has `margin` more samples at either end; `step_squared` is their squared distance.
pub fn mean_steps(values: &[f32], margin: usize, step_squared: f32) -> f32 {
    let inner = &values[margin..values.len() - margin];
    let steps = |block: &[f32]| (highest(block) / step_squared).sqrt().min(margin as f32);
    inner.chunks(BLOCK).map(steps).sum::<f32>() / inner.len().div_ceil(BLOCK) as f32
}

/// Computes `out[i] = min over k of values[margin + i + k] + step² k²` for `k` from `-margin` to
/// `margin`.
pub fn transform(values: &[f32], margin: usize, step_squared: f32, out: &mut [f32]) {
    for (block, out) in out.chunks_mut(BLOCK).enumerate() {
        let first = margin + block * BLOCK;
        let Ok(whole) = <&mut [f32; BLOCK]>::try_from(&mut *out) else {
            let mut best = [0.0; BLOCK];
            let part = &mut best[..out.len()];
            part.copy_from_slice(&values[first..first + part.len()]);
            search_window(values, first, margin, step_squared, part);
            out.copy_from_slice(part);
            continue;
        };
        let mut best = [0.0; BLOCK];
        best.copy_from_slice(&values[first..first + BLOCK]);
        search_window(values, first, margin, step_squared, &mut best);
        *whole = best;
    }
}

/// Lowers `best` to the least over the samples around it, nearest first, until none left can be
/// lower.
#[inline(always)]
fn search_window(values: &[f32], first: usize, margin: usize, step_squared: f32, best: &mut [f32]) {
    let mut k = 1;
    while k <= margin && step_squared * (k * k) as f32 <= highest(best) {
        for k in k..=margin.min(k + STRIDE - 1) {
            let rise = step_squared * (k * k) as f32;
            let before = &values[first - k..first - k + best.len()];
            let after = &values[first + k..first + k + best.len()];
            for ((best, &before), &after) in best.iter_mut().zip(before).zip(after) {
                let near = if before < after { before } else { after } + rise;
                *best = if near < *best { near } else { *best };
            }
        }
        k += STRIDE;
    }
}

/// Returns the highest of some values that are not negative.
#[inline(always)]
fn highest(values: &[f32]) -> f32 {
    let higher = |a: f32, b: f32| if b > a { b } else { a };
    // Lanes that do not wait for each other.
    let (whole, rest) = values.as_chunks::<8>();
    let mut most = [0.0; 8];
    for values in whole {
        for (most, &value) in most.iter_mut().zip(values) {
            *most = higher(*most, value);
        }
    }
    rest.iter().copied().chain(most).fold(0.0, higher)
}
