//! The far part of horizons: the upper hull of each line, grown towards the texel that looks at it.

use std::ops::Range;

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};

use crate::sheared_lines::{Lines, SKEW, Slab, Stretch};

/// Vertex of the hull.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    position: f32,
    height: f32,
    /// Slope towards the next farther vertex, less than the slope of any nearer vertex. `-∞` at the
    /// last.
    slope: f32,
}

/// Upper convex hull of the heights so far, the farthest first.
#[derive(Default)]
struct Hull {
    vertices: Vec<Vertex>,
}

impl Hull {
    /// Adds a point in front of all others.
    #[inline]
    fn push(&mut self, position: f32, height: f32) {
        while let Some(last) = self.vertices.last() {
            let (along, up) = (last.position - position, last.height - height);
            if up > last.slope * along {
                self.vertices.push(Vertex { position, height, slope: up / along });
                return;
            }
            // The farthest vertex has the slope -∞ and is never removed.
            self.vertices.pop();
        }
        self.vertices.push(Vertex { position, height, slope: f32::NEG_INFINITY });
    }

    /// Returns the slope of the tangent to the hull from a point in front of it.
    ///
    /// From near to far, the slopes to the vertices first rise and then fall. Texels are close to
    /// their line, so the top is almost always a few vertices away. Otherwise it is found by
    /// halving, so that no map makes it slow.
    #[inline]
    fn tangent(&self, position: f32, height: f32) -> f32 {
        const STEPS: usize = 8;
        let rises = |vertex: &Vertex| vertex.height - height < vertex.slope * (vertex.position - position);
        let near = self.vertices.iter().rev().take(STEPS).find(|vertex| !rises(vertex));
        let top = near.or_else(|| {
            let from_far = self.vertices.partition_point(|vertex| !rises(vertex));
            self.vertices.get(from_far.wrapping_sub(1))
        });
        top.map_or(f32::NEG_INFINITY, |top| (top.height - height) / (top.position - position))
    }
}

/// Lines that one task follows: as many as a cache line has texels, for lines across the map's
/// rows.
const LANES: usize = 16;

/// Buffers of a task for a few lines: the heights of their texels, and the heights sampled along
/// them.
#[derive(Default)]
struct Scratch {
    hull: Hull,
    origins: Vec<f32>,
    heights: Vec<f32>,
}

/// Fills the slab with the greatest slope, in heights a step, to the line that passes each texel,
/// from `nearest` steps away on.
pub(super) fn slopes(lines: &Lines, nearest: usize, slab: &mut Slab, watch: &Watch) -> Result<(), Cancelled> {
    let (first, count) = (slab.slots.start, slab.slots.len());
    let blocks = slab.values.par_chunks_mut(LANES * slab.stride).enumerate();
    blocks.try_for_each_init(Scratch::default, |scratch, (block, slopes)| {
        let slot = block * LANES;
        watch.at(0.5 * slot as f32 / count as f32)?;
        let lanes = LANES.min(count - slot);
        along_lines(lines, nearest, first + slot..first + slot + lanes, scratch, slopes, slab.stride);
        Ok(())
    })
}

/// Computes the slopes of some slots, each in `row` values.
fn along_lines(
    lines: &Lines,
    nearest: usize,
    slots: Range<usize>,
    scratch: &mut Scratch,
    slopes: &mut [f32],
    row: usize,
) {
    let Scratch { hull, origins, heights } = scratch;
    // The stride keeps lanes of a map of a power of two from falling into the same cache lines.
    let origins_stride = lines.length + SKEW;
    origins.resize(slots.len() * origins_stride, 0.0);
    lines.origins(slots.start, origins_stride, origins);
    // Lines as far from each other as their slots are read together.
    let mut stretches: Vec<(i64, usize, Stretch)> = Vec::new();
    for (lane, slot) in slots.enumerate() {
        let of_slot = lines.stretches(slot).into_iter();
        stretches.extend(of_slot.map(|stretch| (stretch.line - lane as i64, lane, stretch)));
    }
    stretches.sort_unstable_by_key(|&(beside, lane, _)| (beside, lane));
    let end = lines.length + lines.reach;
    let span = |stretch: &Stretch| stretch.from + nearest..end.min(stretch.to + lines.reach);
    for group in stretches.chunk_by(|a, b| a.0 == b.0) {
        let spans = group.iter().map(|(.., stretch)| span(stretch));
        let all = spans.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end)).unwrap_or_default();
        let stride = all.len() + SKEW;
        heights.resize(group.len() * stride, 0.0);
        lines.samples(group[0].2.line, all.start, all.end, stride, heights);
        for ((_, lane, stretch), heights) in group.iter().zip(heights.chunks_exact(stride)) {
            let (span, origins) = (span(stretch), &origins[lane * origins_stride..]);
            let slopes = &mut slopes[lane * row..];
            hull.vertices.clear();
            for (position, &height) in span.clone().zip(&heights[span.start - all.start..]).rev() {
                hull.push(position as f32, height);
                let p = position - nearest;
                if p < stretch.to && lines.row(stretch, p).is_some() {
                    slopes[p] = hull.tangent(p as f32, origins[p]);
                }
            }
        }
    }
}
