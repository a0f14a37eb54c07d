//! The search through a quadrant frustum map.

use relief_core::{HeightMap, Path};

use super::{CellRay, Searched, first_root};
use crate::probes::frustum::Frustum;

/// The first hit of a path with a finite exit; `read` is the frustum for a ray over a cell, not wrapped, in a
/// quadrant.
pub fn search(map: &HeightMap, path: &Path, read: impl Fn([i64; 2], [bool; 2]) -> Frustum) -> Searched {
    let ray = CellRay::new(map, path);
    let (forward, end) = (ray.forward(), path.exit);
    let (mut t, mut cell) = (0.0, ray.cell_at(0.0));
    let mut steps = 0;
    loop {
        steps += 1;
        let frustum = read(cell, forward);
        let leaves = ray.leaves(frustum.low, frustum.high);
        let leave = leaves[0].min(leaves[1]).min(end).max(t);
        let (near, next);
        if ray.reaches(frustum.top, t, leave).is_none() {
            let mut safe = end;
            for (axis, leaves) in leaves.into_iter().enumerate() {
                let rise = frustum.slope * ray.speed[axis].abs();
                if rise > 0.0 {
                    let [h0, h1, h2] = ray.height(t);
                    let gap = [h0 - frustum.top + rise * (leaves - t), h1 - rise, h2];
                    safe = first_root(gap, end - t).map_or(safe, |after| safe.min(t + after));
                } else if let Some(level) = ray.reaches(frustum.top, t, end)
                    && frustum.slope == 0.0
                {
                    safe = safe.min(level);
                }
            }
            next = safe.max(leave);
            near = ray.cell_at(next);
        } else {
            let own = ray.leaves(cell.map(|at| at as f64), cell.map(|at| at as f64 + 1.0));
            let leave = own[0].min(own[1]).min(end).max(t);
            if let Some(hit) = ray.patch(cell, t, leave) {
                return ray.hit(hit, steps);
            }
            next = leave;
            near = cell;
        }
        if next >= end {
            return CellRay::miss(steps);
        }
        // Rounding may see the ray on the near side of a line that it has just crossed: it has left the cell
        // all the same.
        let own = ray.leaves(cell.map(|at| at as f64), cell.map(|at| at as f64 + 1.0));
        for axis in 0..2 {
            let onward = if forward[axis] { 1 } else { -1 };
            let left = cell[axis] + if own[axis] <= next { onward } else { 0 };
            cell[axis] = if forward[axis] { left.max(near[axis]) } else { left.min(near[axis]) };
        }
        t = next;
    }
}
