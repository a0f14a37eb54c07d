//! The apexes of a texel, and the steepest slope from any of them to a cell.

use super::search::{Field, MARGIN, Seen, Viewer, is_pruned};
use super::slope::{Patch, inside_segment, to_point};

/// Half the side of a texel, in texels: the box of apexes of the `footprint`.
const HALF: f64 = 0.5;

/// Where the apexes of a texel are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::kind) enum Region {
    /// At its centre.
    Centre,
    /// Anywhere in its square.
    Footprint,
}

/// A point of the surface in the texel's square.
#[derive(Clone, Copy, Debug, Default)]
struct Apex {
    /// Place in texels from the texel's centre.
    at: [f64; 2],
    height: f64,
}

/// The apexes of one texel that suffice: see [`super::footprint_slopes2`]'s proof.
#[derive(Clone, Debug)]
pub(in crate::kind) struct Apexes {
    pub viewer: Viewer,
    texel_m: [f64; 2],
    /// Heights of the 3 by 3 points at -½, 0 and ½ around the centre (all the centre's own without a footprint).
    grid: [[f64; 3]; 3],
    region: Region,
}

/// The points of the rim in order, as columns and rows of the grid.
const RIM: [[usize; 2]; 8] = [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]];

impl Apexes {
    pub fn new(field: &Field, texel: [i64; 2], region: Region) -> Self {
        let near = |i: i64, j: i64| f64::from(field.map.texel(texel[0] + i, texel[1] + j));
        let mut grid = [[near(0, 0); 3]; 3];
        if region == Region::Footprint {
            let texels = [-1, 0, 1].map(|j| [-1, 0, 1].map(|i| near(i, j)));
            let columns = texels.map(|[a, b, c]| [0.5 * (a + b), b, 0.5 * (b + c)]);
            for k in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|row: usize| columns[row][k]);
                (grid[0][k], grid[1][k], grid[2][k]) = (0.5 * (a + b), b, 0.5 * (b + c));
            }
        }
        let low = grid.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let half = if region == Region::Footprint { HALF } else { 0.0 };
        Self { viewer: Viewer { texel, half, low }, texel_m: field.texel_m, grid, region }
    }

    /// Height of the surface at the points -½, 0 and ½ texels from the centre.
    pub fn grid(&self) -> &[[f64; 3]; 3] {
        &self.grid
    }

    fn apex(&self, [column, row]: [usize; 2]) -> Apex {
        let place = |k: usize| (k as f64 - 1.0) * self.viewer.half;
        Apex { at: [place(column), place(row)], height: self.grid[row][column] }
    }

    /// Squared metres from a box of offsets in texels to the box of apexes.
    pub fn distance2(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let half = self.viewer.half;
        let gap = |axis: usize| (from[axis] - half).max(-half - to[axis]).max(0.0) * self.texel_m[axis];
        gap(0) * gap(0) + gap(1) * gap(1)
    }

    /// Squared slope of the patch itself around the apexes: of every direction for a footprint, of those into the cell
    /// for a centre. `seen` is one of the four cells around the centre.
    pub fn own_slope2(&self, seen: &Seen) -> f64 {
        let [h00, h10, h01, h11] = seen.heights;
        let [ax, ay] = self.texel_m;
        // The corner that is the centre, and the far end of the part of the cell that is in the texel.
        let corner = seen.offset.map(|offset| if offset == 0 { 0.0 } else { 1.0 });
        let along_x = |v: f64| ((h10 - h00) * (1.0 - v) + (h11 - h01) * v) / ax;
        let along_y = |u: f64| ((h01 - h00) * (1.0 - u) + (h11 - h10) * u) / ay;
        match self.region {
            Region::Centre => {
                let into = |slope: f64, corner: f64| if corner == 0.0 { slope } else { -slope };
                let (x, y) = (into(along_x(corner[1]), corner[0]), into(along_y(corner[0]), corner[1]));
                // A gradient that leaves the cell is left to the cell's edges.
                if x > 0.0 && y > 0.0 { x * x + y * y } else { 0.0 }
            }
            Region::Footprint => {
                let steepest = |slope: &dyn Fn(f64) -> f64, corner: f64| {
                    let (a, b) = (slope(corner), slope(0.5));
                    (a * a).max(b * b)
                };
                steepest(&along_x, corner[1]) + steepest(&along_y, corner[0])
            }
        }
    }

    /// Raises `best` to the squared slope of the steepest rise from an apex to a point of the cell: to its corner `h00`
    /// and the two edges and the inside that begin there, or to all of it. A slope in a patch that holds the apex itself
    /// is left to [`Self::own_slope2`].
    pub fn raise(&self, seen: &Seen, whole: bool, best: &mut f64) {
        let highest = seen.heights.iter().copied().fold(0.0, f64::max);
        let from = seen.offset.map(|offset| offset as f64);
        let to = from.map(|from| from + 1.0);
        if is_pruned(highest - self.viewer.low, self.distance2(from, to), *best) {
            return;
        }
        match self.region {
            Region::Centre => self.raise_from(&self.apex([1, 1]), seen, highest, whole, best),
            Region::Footprint => {
                for point in RIM {
                    self.raise_from(&self.apex(point), seen, highest, whole, best);
                }
                self.raise_from_rim([from[0], from[1]], seen.heights[0], best);
                if whole {
                    self.raise_from_rim([to[0], from[1]], seen.heights[1], best);
                    self.raise_from_rim([from[0], to[1]], seen.heights[2], best);
                    self.raise_from_rim([to[0], to[1]], seen.heights[3], best);
                }
            }
        }
    }

    fn raise_from(&self, apex: &Apex, seen: &Seen, highest: f64, whole: bool, best: &mut f64) {
        let [ax, ay] = self.texel_m;
        let x0 = (seen.offset[0] as f64 - apex.at[0]) * ax;
        let y0 = (seen.offset[1] as f64 - apex.at[1]) * ay;
        let (x1, y1) = (x0 + ax, y0 + ay);
        let gap = [x0.max(-x1).max(0.0), y0.max(-y1).max(0.0)];
        if is_pruned(highest - apex.height, gap[0] * gap[0] + gap[1] * gap[1], *best) {
            return;
        }
        let rise = seen.heights.map(|height| height - apex.height);
        let corners = [[x0, y0], [x1, y0], [x0, y1], [x1, y1]];
        let slopes = [0, 1, 2, 3].map(|k: usize| to_point(rise[k], corners[k]));
        // A point of the cell rises by a mean of its corners' rises, and no corner is farther than it by more than the
        // diagonal: it is steeper than the steepest corner by at most the diagonal over its own distance.
        let steepest = slopes.iter().copied().fold(0.0, f64::max);
        let (gap2, diagonal2) = (gap[0] * gap[0] + gap[1] * gap[1], ax * ax + ay * ay);
        if gap2 > 0.0 && steepest * MARGIN * (1.0 + (diagonal2 / gap2).sqrt()).powi(2) <= *best {
            return;
        }
        let mut top = if whole { steepest } else { slopes[0] };
        top = top.max(inside_segment([rise[0], rise[1]], x0, x1, y0));
        top = top.max(inside_segment([rise[0], rise[2]], y0, y1, x0));
        if whole {
            top = top.max(inside_segment([rise[2], rise[3]], x0, x1, y1));
            top = top.max(inside_segment([rise[1], rise[3]], y0, y1, x1));
        }
        top = top.max(Patch { corner: [x0, y0], size: [ax, ay], rise }.inside());
        *best = best.max(top);
    }

    /// Raises `best` to the squared slope to a vertex from the steepest point inside the eight pieces of the rim.
    fn raise_from_rim(&self, vertex: [f64; 2], height: f64, best: &mut f64) {
        if is_pruned(height - self.viewer.low, self.distance2(vertex, vertex), *best) {
            return;
        }
        for (k, &point) in RIM.iter().enumerate() {
            let (a, b) = (self.apex(point), self.apex(RIM[(k + 1) % RIM.len()]));
            let along = usize::from(a.at[0] == b.at[0]);
            let place = |apex: &Apex, axis: usize| (apex.at[axis] - vertex[axis]) * self.texel_m[axis];
            let beside = place(&a, 1 - along);
            let rise = [height - a.height, height - b.height];
            if is_pruned(rise[0].max(rise[1]), beside * beside, *best) {
                continue;
            }
            *best = best.max(inside_segment(rise, place(&a, along), place(&b, along), beside));
        }
    }
}
