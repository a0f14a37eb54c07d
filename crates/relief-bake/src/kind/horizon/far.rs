//! What is far: the upper hull of each line, grown towards the texel that looks at it.

use rayon::prelude::*;

use super::lines::Lines;
use crate::{Cancelled, Progress};

/// A vertex of the hull.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    position: f32,
    height: f32,
    /// Slope towards the next farther vertex; less than that of any nearer vertex. `-∞` at the last.
    slope: f32,
}

/// The upper convex hull of the heights seen so far, the farthest first.
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

    /// The slope of the tangent to the hull from a point in front of it.
    ///
    /// From near to far the vertices are seen under a slope that first rises and then falls. Texels are close to
    /// their line, so the top is almost always a few vertices away; else it is found by halving, so that no map makes
    /// it slow.
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

/// For every texel the greatest slope, in heights a step, under which it sees the line that passes it, from `nearest`
/// steps away on; at `slot * length + position`.
pub(super) fn slopes(
    lines: &Lines,
    nearest: usize,
    slopes: &mut [f32],
    progress: &Progress,
) -> Result<(), Cancelled> {
    let end = lines.length + lines.reach;
    let scratch = || (Hull::default(), Vec::new());
    slopes.par_chunks_mut(lines.length).enumerate().try_for_each_init(scratch, |scratch, (slot, slopes)| {
        let (hull, heights) = scratch;
        progress.at(0.5 * slot as f32 / lines.count as f32)?;
        for stretch in lines.stretches(slot) {
            let first = stretch.from + nearest;
            lines.samples(stretch.line, first, end.min(stretch.to + lines.reach), heights);
            hull.vertices.clear();
            for (k, &height) in heights.iter().enumerate().rev() {
                hull.push((first + k) as f32, height);
                let p = stretch.from + k;
                if p < stretch.to
                    && let Some(row) = lines.row(&stretch, p)
                {
                    slopes[p] = hull.tangent(p as f32, lines.texel(p, row));
                }
            }
        }
        Ok(())
    })
}
