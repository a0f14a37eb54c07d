//! One axis of two grids of texels over the same square: the map's and a level's.

/// Sides of the map and of a level, and whether both are tiled. Otherwise their edge texels
/// continue for ever, which within the square is what `mirror` does, too.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// Texels of the map.
    pub fine: u32,
    /// Texels of the level.
    pub coarse: u32,
    /// Whether the first texel follows the last.
    pub repeats: bool,
}

/// Position of a point between two of the level's texels.
#[derive(Clone, Copy, Debug)]
pub struct CellPoint {
    /// Cell between them.
    pub cell: usize,
    /// Part of the way from the first to the second, from 0 to 1.
    pub within: f64,
}

impl Axis {
    /// Returns the number of the level's texels.
    pub fn nodes(&self) -> usize {
        self.coarse as usize
    }

    /// Returns the number of the level's cells: between neighbours, and in a tiled level between
    /// the last and the first, too. A single texel has one.
    pub fn cells(&self) -> usize {
        if self.repeats { self.nodes() } else { (self.nodes() - 1).max(1) }
    }

    /// Returns the texels at both ends of one of the level's cells.
    pub fn ends(&self, cell: usize) -> [usize; 2] {
        let next = cell + 1;
        [cell, if next < self.nodes() { next } else { 0 }]
    }

    /// Returns the points at which integrals over the axis are sampled, and the length that each
    /// stands for. Points are counted in texels of the map from the first centre. Between the
    /// centres of either grid, where both surfaces are linear, these are the two points of Gauss
    /// and Legendre. Integrals of products of two are then exact.
    pub fn points(&self) -> Vec<[f64; 2]> {
        let (fine, coarse) = (u64::from(self.fine), u64::from(self.coarse));
        // In these units a texel of the map is 2 `coarse` long, and a texel of the level 2 `fine`.
        let of_map = (0..fine).map(|texel| (2 * texel + 1) * coarse);
        let of_level = (0..coarse).map(|texel| (2 * texel + 1) * fine);
        let mut knots: Vec<u64> = of_map.chain(of_level).chain([0, 2 * fine * coarse]).collect();
        knots.sort_unstable();
        knots.dedup();
        let unit = (2 * coarse) as f64;
        let points = |knots: &[u64]| {
            let [from, to] = [knots[0], knots[1]].map(|knot| knot as f64 / unit - 0.5);
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            [-1.0, 1.0].map(|side| [middle + side * half / 3f64.sqrt(), half])
        };
        knots.windows(2).flat_map(points).collect()
    }

    /// Returns the position in the level of a point at `at` in the map, counted in texels from the
    /// first centre.
    pub fn place(&self, at: f64) -> CellPoint {
        let coarse = f64::from(self.coarse);
        let at = (at + 0.5) * coarse / f64::from(self.fine) - 0.5;
        if self.repeats {
            let at = if at < 0.0 { at + coarse } else { at };
            let cell = (at as usize).min(self.cells() - 1);
            return CellPoint { cell, within: (at - cell as f64).min(1.0) };
        }
        let at = at.clamp(0.0, coarse - 1.0);
        let cell = (at as usize).min(self.cells() - 1);
        CellPoint { cell, within: at - cell as f64 }
    }

    /// Returns the texels of the map before and after such a point, and the part of the way between
    /// them.
    pub fn between(&self, at: f64) -> ([u32; 2], f64) {
        let (before, last) = (at.floor(), i64::from(self.fine) - 1);
        let wrapped = |texel: i64| {
            let texel = if self.repeats { texel.rem_euclid(last + 1) } else { texel.clamp(0, last) };
            texel as u32
        };
        ([wrapped(before as i64), wrapped(before as i64 + 1)], at - before)
    }
}

/// Points of an axis at which integrals over it are sampled: see [`Axis::points`].
#[derive(Debug)]
pub struct Samples {
    /// Texels of the map before and after each point, from cell to cell of the level.
    pub texels: Vec<[u32; 2]>,
    /// Part of the way between these texels.
    pub between: Vec<f64>,
    /// Part of the way through the level's cell.
    pub within: Vec<f64>,
    /// Length that the point stands for, in texels of the map.
    pub length: Vec<f64>,
    /// First point of each of the level's cells, and the end of the last cell's points.
    first: Vec<usize>,
}

impl Samples {
    /// Computes the points of an axis.
    pub fn new(axis: Axis) -> Self {
        let mut points: Vec<(CellPoint, f64, f64)> =
            axis.points().into_iter().map(|[at, length]| (axis.place(at), at, length)).collect();
        points.sort_by(|(a, ..), (b, ..)| a.cell.cmp(&b.cell).then(a.within.total_cmp(&b.within)));
        let first = |cell| points.partition_point(|(place, ..)| place.cell < cell);
        let texels = points.iter().map(|(_, at, _)| axis.between(*at));
        let (texels, between): (Vec<[u32; 2]>, Vec<f64>) = texels.unzip();
        Self {
            texels,
            between,
            within: points.iter().map(|(place, ..)| place.within).collect(),
            length: points.iter().map(|(.., length)| *length).collect(),
            first: (0..=axis.cells()).map(first).collect(),
        }
    }

    /// Returns the numbers of the points in one of the level's cells.
    pub fn of_cell(&self, cell: usize) -> std::ops::Range<usize> {
        self.first[cell]..self.first[cell + 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_lies_in_its_cell_and_all_lengths_are_the_axis() {
        for (fine, coarse) in [(1, 1), (2, 1), (5, 2), (7, 3), (16, 8), (16, 4), (31, 1)] {
            for repeats in [false, true] {
                let axis = Axis { fine, coarse, repeats };
                let samples = Samples::new(axis);
                let length: f64 = samples.length.iter().sum();
                assert!((length - f64::from(fine)).abs() < 1e-12, "{axis:?}");
                let points: usize = (0..axis.cells()).map(|cell| samples.of_cell(cell).len()).sum();
                assert_eq!(points, samples.texels.len(), "{axis:?}");
                assert!(samples.within.iter().all(|within| (0.0..=1.0).contains(within)), "{axis:?}");
                for cell in 0..axis.cells() {
                    let [before, after] = axis.ends(cell);
                    assert!(before < axis.nodes() && after < axis.nodes());
                }
            }
        }
    }
}
