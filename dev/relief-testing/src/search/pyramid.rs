//! The search through a maximum pyramid: quadtree traversal that passes over a node above its maximum, goes
//! down into a node that it dips into, and up again where it leaves the parent (Tevs, Ihrke and Seidel 2008;
//! Szirmay-Kalos and Umenhoffer 2008, section 4.3.3).

use relief_core::{HeightMap, MaxPyramid, Path, Wrap};

use super::{CellRay, Searched};

/// The first hit of a path with a finite exit.
pub fn search(map: &HeightMap, pyramid: &MaxPyramid, path: &Path) -> Searched {
    let ray = CellRay::new(map, path);
    let (forward, end) = (ray.forward(), path.exit);
    let top = pyramid.levels() - 1;
    let (mut t, mut cell, mut level) = (0.0, ray.cell_at(0.0), top);
    let mut steps = 0;
    loop {
        steps += 1;
        let [low, high] = extent(map, cell, level);
        let leaves = ray.leaves(low.map(|line| line as f64), high.map(|line| line as f64));
        let leave = leaves[0].min(leaves[1]).min(end).max(t);
        let width = pyramid.size(level).map_or(1, |[width, _]| width);
        let node = (pyramid.row(cell[1]) >> level) * width + (pyramid.column(cell[0]) >> level);
        let highest = f64::from(pyramid.nodes(level)[node as usize]);
        if let Some(dip) = ray.reaches(highest, t, leave) {
            if level > 0 {
                // Down, to the child in which it dips in.
                t = dip;
                level -= 1;
                let near = ray.cell_at(t);
                cell = [0, 1].map(|axis| near[axis].clamp(low[axis], high[axis] - 1));
                continue;
            }
            if let Some(hit) = ray.patch(cell, t, leave) {
                return ray.hit(hit, steps);
            }
        }
        if leave >= end {
            return CellRay::miss(steps);
        }
        let near = ray.cell_at(leave);
        let parent = extent(map, cell, (level + 1).min(top));
        for axis in 0..2 {
            let within = near[axis].clamp(low[axis], high[axis] - 1);
            let beyond = if forward[axis] { high[axis] } else { low[axis] - 1 };
            cell[axis] = if leaves[axis] <= leave { beyond } else { within };
        }
        t = leave;
        if (0..2).any(|axis| !(parent[0][axis]..parent[1][axis]).contains(&cell[axis])) {
            level = (level + 1).min(top);
        }
    }
}

/// The first cells, and those after the last, of the node over a cell, not wrapped: columns, rows.
fn extent(map: &HeightMap, cell: [i64; 2], level: usize) -> [[i64; 2]; 2] {
    let axes = [0, 1].map(|axis| {
        let side = i64::from([map.width(), map.height()][axis]);
        let node = |local: i64| {
            let first = local >> level << level;
            [first, (first + (1 << level)).min(side)]
        };
        match map.wrap() {
            Wrap::Repeat => {
                let local = cell[axis].rem_euclid(side);
                node(local).map(|line| line + cell[axis] - local)
            }
            Wrap::Clamp if (0..side).contains(&cell[axis]) => node(cell[axis]),
            Wrap::Clamp => [cell[axis], cell[axis] + 1],
            Wrap::Mirror => {
                let local = cell[axis].rem_euclid(2 * side);
                let tile = cell[axis] - local;
                if local < side {
                    node(local).map(|line| line + tile)
                } else if local < 2 * side - 1 {
                    // Cell `c` is mirrored to `2 side - 2 - c`; cell `side - 1` is its own image.
                    let [first, end] = node(2 * side - 2 - local);
                    [2 * side - 1 - end.min(side - 1), 2 * side - 1 - first].map(|line| line + tile)
                } else {
                    [cell[axis], cell[axis] + 1]
                }
            }
        }
    });
    [[axes[0][0], axes[1][0]], [axes[0][1], axes[1][1]]]
}
