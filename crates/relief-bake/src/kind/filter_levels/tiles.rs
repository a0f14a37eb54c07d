//! Tiles of a level, which are solved independently. Threads share nothing, and matrices are small.

use super::axis::Axis;

/// Texels of a level along a side of a tile.
const SIDE: usize = 48;

/// Texels beyond a tile that are solved with it. The error at their end, where neighbours are held
/// fixed, falls to about a quarter from texel to texel.
const OVERLAP: usize = 3;

/// Texels of a tile along an axis, and the cells with these texels as corners.
pub struct Span {
    /// Texels of the level, including those solved with the tile.
    pub nodes: Vec<usize>,
    /// Indices among them of the tile's own texels.
    pub own: std::ops::Range<usize>,
    /// Cells with these texels as corners.
    pub cells: Vec<SpanCell>,
    /// Index of each node's predecessor; without one, its own.
    pub before: Vec<usize>,
    /// Index of each node's successor; without one, its own.
    pub after: Vec<usize>,
}

/// Cell of a tile.
pub struct SpanCell {
    /// Number in the level.
    pub cell: usize,
    /// Indices of its ends among the tile's nodes.
    pub ends: [Option<usize>; 2],
    /// Whether no other tile counts it.
    pub is_own: bool,
}

impl Span {
    /// Returns the spans of an axis. An axis that is no longer than a tile has one span, which
    /// closes where the map is tiled.
    pub fn all(axis: Axis) -> Vec<Self> {
        let nodes = axis.nodes();
        if nodes <= SIDE {
            return vec![Self::whole(axis)];
        }
        (0..nodes).step_by(SIDE).map(|start| Self::part(axis, start)).collect()
    }

    fn whole(axis: Axis) -> Self {
        let (nodes, last) = (axis.nodes(), axis.nodes() - 1);
        let cell = |cell| SpanCell { cell, ends: axis.ends(cell).map(Some), is_own: true };
        let closed = |beyond: usize, place: usize| if axis.repeats { beyond } else { place };
        Self {
            nodes: (0..nodes).collect(),
            own: 0..nodes,
            cells: (0..axis.cells()).map(cell).collect(),
            before: (0..nodes).map(|at| at.checked_sub(1).unwrap_or(closed(last, at))).collect(),
            after: (0..nodes).map(|at| if at < last { at + 1 } else { closed(0, at) }).collect(),
        }
    }

    fn part(axis: Axis, start: usize) -> Self {
        let nodes = axis.nodes();
        let end = nodes.min(start + SIDE);
        // Shifted by the number of nodes, so that nothing is negative.
        let inside = |at: &usize| axis.repeats || (nodes..2 * nodes).contains(at);
        let (from, to) = (nodes + start - OVERLAP.min(nodes), nodes + end + OVERLAP);
        let shifted: Vec<usize> = (from..to).filter(inside).collect();
        let first = shifted[0];
        let place = |at: usize| at.checked_sub(first).filter(|place| *place < shifted.len());
        let has_cell = |at: &usize| inside(at) && (axis.repeats || at - nodes < axis.cells());
        let cells = (first - 1..first + shifted.len()).filter(has_cell).map(|at| SpanCell {
            cell: at % nodes,
            ends: [place(at), place(at + 1)],
            is_own: (nodes + start..nodes + end).contains(&at),
        });
        let last = shifted.len() - 1;
        Self {
            own: nodes + start - first..nodes + end - first,
            cells: cells.collect(),
            before: (0..=last).map(|at| at.saturating_sub(1)).collect(),
            after: (0..=last).map(|at| last.min(at + 1)).collect(),
            nodes: shifted.iter().map(|at| at % nodes).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_node_and_cell_is_one_tiles_own() {
        for coarse in [1, 2, 3, 47, 48, 49, 50, 96, 97, 500] {
            for repeats in [false, true] {
                let axis = Axis { fine: 2 * coarse, coarse, repeats };
                let (mut nodes, mut cells) = (vec![0; axis.nodes()], vec![0; axis.cells()]);
                for span in Span::all(axis) {
                    span.own.clone().for_each(|place| nodes[span.nodes[place]] += 1);
                    for SpanCell { cell, ends, is_own } in &span.cells {
                        cells[*cell] += usize::from(*is_own);
                        for (place, node) in ends.iter().zip(axis.ends(*cell)) {
                            assert!(place.is_none_or(|place| span.nodes[place] == node), "{axis:?}");
                        }
                    }
                    // All cells around a tile's own texels are there with both of their ends.
                    let whole = |at: usize| {
                        span.cells.iter().any(|c| c.cell == at && c.ends.iter().all(Option::is_some))
                    };
                    for node in span.own.clone().map(|place| span.nodes[place]) {
                        assert!(node >= axis.cells() || whole(node), "{axis:?} {node}");
                        assert!(node == 0 || whole(node - 1), "{axis:?} {node}");
                    }
                }
                assert!(nodes.iter().chain(&cells).all(|&count| count == 1), "{axis:?}");
            }
        }
    }
}
