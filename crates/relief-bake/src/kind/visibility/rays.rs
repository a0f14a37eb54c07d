//! First hits along one azimuth, for every texel and several elevations.

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};

use crate::sheared_lines::{Lines, Stretch};

/// Column near which the surface may stand above a ray.
#[derive(Clone, Copy, Debug)]
struct Record {
    position: usize,
    /// Height, less the height that a ray gains on the way from position 0.
    height: f64,
}

/// Columns that are higher, in a ray's frame, than all nearer ones; the farthest first.
#[derive(Default)]
struct Records {
    stack: Vec<Record>,
}

impl Records {
    /// Adds a column nearer than all others. Returns the nearest higher column, `usize::MAX` for
    /// none.
    fn push(&mut self, position: usize, height: f64) -> usize {
        while self.stack.last().is_some_and(|last| last.height <= height) {
            self.stack.pop();
        }
        let higher = self.stack.last().map_or(usize::MAX, |last| last.position);
        self.stack.push(Record { position, height });
        higher
    }

    /// Returns the nearest column above a height.
    fn above(&self, height: f64) -> Option<usize> {
        const STEPS: usize = 8;
        let near = self.stack.iter().rev().take(STEPS).find(|record| record.height > height);
        let record = near.or_else(|| {
            let above = self.stack.partition_point(|record| record.height > height);
            self.stack.get(above.wrapping_sub(1))
        });
        record.map(|record| record.position)
    }
}

/// Buffers of a task.
#[derive(Default)]
struct Scratch {
    records: Records,
    highest: Vec<f32>,
    /// Next higher column in the rays' frame, for every column.
    higher: Vec<usize>,
}

/// Computes the distance in steps to the first hit for every texel and ray; infinite for none
/// within the ray's reach. Ray `k` has its distance at
/// `(slot * rays.len() + k) * length + position`.
pub(super) fn first_hits(
    lines: &Lines,
    rays: &[SlopedRay],
    hits: &mut [f32],
    watch: &Watch,
) -> Result<(), Cancelled> {
    let aside = 0.5 + lines.slope.abs();
    let chunks = hits.par_chunks_mut(rays.len() * lines.length);
    chunks.enumerate().try_for_each_init(Scratch::default, |scratch, (slot, hits)| {
        watch.at(0.8 * slot as f32 / lines.count as f32)?;
        for stretch in lines.stretches(slot) {
            let most = rays.iter().map(|ray| ray.reach).max().unwrap_or(0);
            let end = (stretch.to + most).min(lines.length + lines.reach);
            let columns = stretch.from..end;
            scratch.highest.clear();
            scratch.highest.extend(columns.map(|p| lines.highest(stretch.line, p, aside)));
            for (ray, hits) in rays.iter().zip(hits.chunks_exact_mut(lines.length)) {
                sweep(lines, &stretch, ray, scratch, hits);
            }
        }
        Ok(())
    })
}

/// Rise of a ray, and its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlopedRay {
    /// Slope in heights a step; positive.
    pub slope: f64,
    /// Length in steps.
    pub reach: usize,
}

/// Finds the first hits of a ray's slope along a stretch. `highest[k]` is the highest point near
/// the line at position `stretch.from + k`.
fn sweep(lines: &Lines, stretch: &Stretch, ray: &SlopedRay, scratch: &mut Scratch, hits: &mut [f32]) {
    let Scratch { records, highest, higher } = scratch;
    records.stack.clear();
    let end = highest.len().min(stretch.to - stretch.from + ray.reach);
    higher.clear();
    higher.resize(end, usize::MAX);
    let level = |k: usize| f64::from(highest[k]) - ray.slope * k as f64;
    for k in (0..end).rev() {
        let p = stretch.from + k;
        if p < stretch.to
            && let Some(row) = lines.row(stretch, p)
        {
            let walk = Walk { lines, ray, p, own: f64::from(lines.texel(p, row)) };
            let candidate = records.above(walk.own - ray.slope * k as f64);
            hits[p] = walk.first_hit(stretch, candidate, level, higher) as f32;
        }
        higher[k] = records.push(k, level(k));
    }
}

/// Ray of one texel.
struct Walk<'a> {
    lines: &'a Lines<'a>,
    ray: &'a SlopedRay,
    p: usize,
    own: f64,
}

impl Walk<'_> {
    /// Returns the distance to the first hit. `candidate` is the first column, counted from the
    /// stretch's begin, beside which the surface may be above the ray. `level` are the highest
    /// points there in the ray's frame, and `higher` the next higher column of each.
    fn first_hit(
        &self,
        stretch: &Stretch,
        candidate: Option<usize>,
        level: impl Fn(usize) -> f64,
        higher: &[usize],
    ) -> f64 {
        let start = self.p - stretch.from;
        let last = higher.len().min(start + self.ray.reach + 1);
        if start + 1 >= last {
            return f64::INFINITY;
        }
        // The way to the first column is always solved: there the ray is on the surface.
        if let Some(t) = self.step(stretch, 0) {
            return t;
        }
        let Some(candidate) = candidate else { return f64::INFINITY };
        let own = self.own - self.ray.slope * start as f64;
        let mut k = candidate.saturating_sub(1).max(start + 1);
        while k + 1 < last {
            if level(k) > own || level(k + 1) > own {
                if let Some(t) = self.step(stretch, k - start) {
                    return t;
                }
                k += 1;
                continue;
            }
            // Between two columns below the ray the surface is below it, too. Columns up to the
            // next higher one are no higher than this.
            let mut next = higher[k + 1];
            while next < last && level(next) <= own {
                next = higher[next];
            }
            if next >= last {
                break;
            }
            k = next - 1;
        }
        f64::INFINITY
    }

    /// Returns the first hit between `steps` and `steps + 1` steps.
    fn step(&self, stretch: &Stretch, steps: usize) -> Option<f64> {
        let slope = self.lines.slope;
        let (from, to) = (steps as f64, (steps + 1) as f64);
        // Rows counted from the texel, and the texel's row on its unfolded line.
        let base = stretch.line + self.lines.shift(self.p);
        let rows = [slope * from, slope * to];
        let (low, high) = (rows[0].min(rows[1]).floor(), rows[0].max(rows[1]).ceil());
        if high - low <= 1.0 {
            return self.piece(steps, base, low, from, to);
        }
        // The line between two rows is crossed on the way.
        let crossing = ((low + 1.0) / slope).clamp(from, to);
        let (first, second) = if slope > 0.0 { (low, low + 1.0) } else { (low + 1.0, low) };
        self.piece(steps, base, first, from, crossing)
            .or_else(|| self.piece(steps, base, second, crossing, to))
    }

    /// Returns the first hit in the cell that begins `row` rows beside the texel, between `from`
    /// and `to`.
    fn piece(&self, steps: usize, base: i64, row: f64, from: f64, to: f64) -> Option<f64> {
        let slope = self.lines.slope;
        let [h00, h10, h01, h11] = self.lines.cell(self.p + steps, base + row as i64).map(f64::from);
        let (u, v) = (from - steps as f64, slope * from - row);
        let (bu, bv, twist) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        // The ray's height above the surface after τ steps in the cell is c0 + c1 τ + c2 τ².
        let c0 = self.own + self.ray.slope * from - (h00 + bu * u + bv * v + twist * u * v);
        let c1 = self.ray.slope - (bu + bv * slope + twist * (v + u * slope));
        let c2 = -twist * slope;
        if from == 0.0 {
            return leaves(c1, c2, to);
        }
        first_root(c0, c1, c2, to - from).map(|tau| from + tau)
    }
}

/// Returns the first root of `c1 τ + c2 τ²` in `[0, length]` behind which it is negative. A ray
/// that leaves the surface hits it at its start only if it goes below it.
fn leaves(c1: f64, c2: f64, length: f64) -> Option<f64> {
    if c1 < 0.0 || (c1 == 0.0 && c2 < 0.0) {
        return Some(0.0);
    }
    let root = -c1 / c2;
    (c2 < 0.0 && root <= length).then_some(root)
}

/// Returns the first `τ` in `[0, length]` where `c0 + c1 τ + c2 τ²` is not positive.
fn first_root(c0: f64, c1: f64, c2: f64, length: f64) -> Option<f64> {
    if c0 <= 0.0 {
        return Some(0.0);
    }
    let ends_above = c0 + length * (c1 + length * c2) > 0.0;
    let turns_inside = c2 > 0.0 && c1 < 0.0 && -c1 < 2.0 * c2 * length;
    if ends_above && !turns_inside {
        return None;
    }
    let disc = c1 * c1 - 4.0 * c0 * c2;
    if disc < 0.0 {
        return (!ends_above).then_some(length);
    }
    // With c0 positive the first positive root is this one for any c2; where c1 is negative nothing
    // cancels.
    let root = if c1 <= 0.0 { 2.0 * c0 / (disc.sqrt() - c1) } else { -0.5 * (c1 + disc.sqrt()) / c2 };
    Some(root.clamp(0.0, length))
}
