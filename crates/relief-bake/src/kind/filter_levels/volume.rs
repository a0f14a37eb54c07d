//! Volume between the surface of a level and the map's, and the sums needed to lower it.

use rayon::prelude::*;
use relief_core::{HeightMap, Wrap};

use super::axis::{Axis, Samples};

/// Rows of points that one task sums up; sums of tasks are added in their order.
const ROWS: usize = 16;

/// Sums over the points of one of the level's cells. In all, `x` and `y` are the parts of the way
/// through the cell, and the point's area counts in texels of the map.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moments {
    /// Sum of the distance between the surfaces.
    pub volume: f64,
    /// Sums of `x^p y^q` over the distance, in `[q][p]`.
    pub weights: [[f64; 3]; 3],
    /// Sums of `x^p y^q` times the sign of the level less the map, in `[q][p]`.
    pub signs: [[f64; 2]; 2],
}

impl Moments {
    fn add(&mut self, other: &Self) {
        self.volume += other.volume;
        for (sum, value) in self.weights.as_flattened_mut().iter_mut().zip(other.weights.as_flattened()) {
            *sum += value;
        }
        for (sum, value) in self.signs.as_flattened_mut().iter_mut().zip(other.signs.as_flattened()) {
            *sum += value;
        }
    }
}

/// Map and the grid of one of its levels.
pub struct Surfaces<'a> {
    map: &'a HeightMap,
    /// Both axes.
    pub axes: [Axis; 2],
    points: [Samples; 2],
}

impl<'a> Surfaces<'a> {
    /// Prepares the surfaces of a map and a level of `size`.
    pub fn new(map: &'a HeightMap, size: [u32; 2]) -> Self {
        let repeats = map.wrap() == Wrap::Repeat;
        let axes = [(map.width(), size[0]), (map.height(), size[1])];
        let axes = axes.map(|(fine, coarse)| Axis { fine, coarse, repeats });
        Self { map, axes, points: axes.map(Samples::new) }
    }

    /// Returns the area of the square in texels of the map.
    pub fn area(&self) -> f64 {
        self.map.texels().len() as f64
    }

    /// Returns the sums of some cells of a row of cells, for a level of those heights. Distances
    /// below `smooth` count as `smooth` where they divide: signs are then parts of it.
    pub fn moments(&self, heights: &[f32], row: usize, cells: &[usize], smooth: f64) -> Vec<Moments> {
        let rows = self.points[1].of_cell(row);
        let of = |rows: std::ops::Range<usize>| {
            let mut sums = vec![Moments::default(); cells.len()];
            rows.for_each(|point| self.add_line(heights, row, point, cells, smooth, &mut sums));
            sums
        };
        if rows.len() <= ROWS {
            return of(rows);
        }
        let starts: Vec<usize> = rows.clone().step_by(ROWS).collect();
        let parts: Vec<Vec<Moments>> =
            starts.into_par_iter().map(|start| of(start..rows.end.min(start + ROWS))).collect();
        parts.into_iter().fold(vec![Moments::default(); cells.len()], |mut sums, part| {
            sums.iter_mut().zip(&part).for_each(|(sum, part)| sum.add(part));
            sums
        })
    }

    /// Adds the points of a line.
    fn add_line(
        &self,
        heights: &[f32],
        row: usize,
        point: usize,
        cells: &[usize],
        smooth: f64,
        sums: &mut [Moments],
    ) {
        let [across, down] = &self.points;
        let (width, nodes) = (self.map.width() as usize, self.axes[0].nodes());
        let [above, below] =
            down.texels[point].map(|texel| &self.map.texels()[texel as usize * width..][..width]);
        let [top, bottom] = self.axes[1].ends(row).map(|node| &heights[node * nodes..][..nodes]);
        let (between, y, length) = (down.between[point], down.within[point], down.length[point]);
        let mix = |a: f32, b: f32, part: f64| f64::from(a) + (f64::from(b) - f64::from(a)) * part;
        // Neighbouring points have texels in common.
        let height = |texel: u32| mix(above[texel as usize], below[texel as usize], between);
        let (mut last, mut ends) = ([u32::MAX; 2], [0.0; 2]);
        for (&cell, sum) in cells.iter().zip(sums) {
            let [left, right] = self.axes[0].ends(cell).map(|node| mix(top[node], bottom[node], y));
            let rise = right - left;
            let (mut volume, mut weights, mut signs) = (0.0, [0.0; 3], [0.0; 2]);
            let points = across.of_cell(cell);
            let places = across.texels[points.clone()].iter().zip(&across.between[points.clone()]);
            let places = places.zip(&across.within[points.clone()]).zip(&across.length[points]);
            for (((texels, part), &x), length) in places {
                if *texels != last {
                    let before = if texels[0] == last[1] { ends[1] } else { height(texels[0]) };
                    (last, ends) = (*texels, [before, height(texels[1])]);
                }
                let apart = left + rise * x - (ends[0] + (ends[1] - ends[0]) * part);
                let distance = apart.abs();
                let weight = length / if distance > smooth { distance } else { smooth };
                let sign = weight * apart;
                volume += length * distance;
                weights[0] += weight;
                weights[1] += weight * x;
                weights[2] += weight * x * x;
                signs[0] += sign;
                signs[1] += sign * x;
            }
            sum.volume += length * volume;
            let mut factor = length;
            for (q, row) in sum.weights.iter_mut().enumerate() {
                row.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += factor * weight);
                if let Some(row) = sum.signs.get_mut(q) {
                    row.iter_mut().zip(signs).for_each(|(sum, sign)| *sum += factor * sign);
                }
                factor *= y;
            }
        }
    }

    /// Returns the sums of all cells, row by row.
    fn all(&self, heights: &[f32]) -> Vec<Vec<Moments>> {
        let cells: Vec<usize> = (0..self.axes[0].cells()).collect();
        let rows = (0..self.axes[1].cells()).into_par_iter();
        rows.map(|row| self.moments(heights, row, &cells, f64::MIN_POSITIVE)).collect()
    }
}

/// Returns the volume between the surfaces of a map and of a level, or of any other map of the
/// level's size. It is the integral of their distance over the texture square, whose area is 1, in
/// heights. Multiply it by [`HeightMap::scale_m`] and by the area of the tile for cubic metres.
///
/// The integral is sampled at the four points of Gauss and Legendre of each rectangle between the
/// lines through the centres of either grid. Both surfaces are bilinear there. The sum is not exact
/// where they cross. For natural maps it is off by a hundredth or two; by up to a third where they
/// cross everywhere in the same way, as on a checkerboard.
///
/// Both surfaces are taken with the map's wrap.
pub fn difference_volume(map: &HeightMap, level: &HeightMap) -> f64 {
    let surfaces = Surfaces::new(map, [level.width(), level.height()]);
    let rows = surfaces.all(level.texels());
    rows.iter().flatten().map(|moments| moments.volume).sum::<f64>() / surfaces.area()
}

/// Returns the derivative of [`difference_volume`] by each of the level's texels, row by row from
/// the top. It is the integral of the texel's hat times the sign of the level less the map (Gumhold
/// and Hüttner 1999, eq. 12, in the limit of no step).
pub fn difference_volume_gradient(map: &HeightMap, level: &HeightMap) -> Vec<f64> {
    let surfaces = Surfaces::new(map, [level.width(), level.height()]);
    let nodes = surfaces.axes[0].nodes();
    let mut gradient = vec![0.0; level.texels().len()];
    for (row, cells) in surfaces.all(level.texels()).iter().enumerate() {
        for (cell, moments) in cells.iter().enumerate() {
            let columns = surfaces.axes[0].ends(cell);
            let hats = corners(moments.signs);
            for (row, hats) in surfaces.axes[1].ends(row).into_iter().zip(hats) {
                for (column, hat) in columns.into_iter().zip(hats) {
                    gradient[row * nodes + column] += hat / surfaces.area();
                }
            }
        }
    }
    gradient
}

/// Returns the sums of each corner's hat, by row and column, from the sums of `x^p y^q`.
pub fn corners(sums: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [above, below] = sums.map(|[one, x]| [one - x, x]);
    [[above[0] - below[0], above[1] - below[1]], below]
}
