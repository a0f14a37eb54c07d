//! Colours for the elevation model, by height.

use super::lattice::mix_colour;
use super::picture::Grid;

/// Heights, as parts of the map's range, and their colours: woods in the valleys, drier slopes, bare ridges.
const TINTS: [(f64, [f64; 3]); 6] = [
    (0.0, [86.0, 125.0, 84.0]),
    (0.14, [118.0, 150.0, 92.0]),
    (0.32, [178.0, 180.0, 118.0]),
    (0.52, [190.0, 158.0, 106.0]),
    (0.75, [150.0, 118.0, 92.0]),
    (1.0, [226.0, 220.0, 212.0]),
];

/// A colour map of half the elevation model's size: colour needs no more detail than that.
pub fn colours(elevation: &Grid<f64>) -> Grid<[f64; 3]> {
    let (width, height) = (elevation.width.div_ceil(2), elevation.height.div_ceil(2));
    let at = |column: u32, row: u32| {
        let (column, row) = (column.min(elevation.width - 1), row.min(elevation.height - 1));
        elevation.texels[(row * elevation.width + column) as usize]
    };
    let texels = (0..height)
        .flat_map(|row| (0..width).map(move |column| (2 * column, 2 * row)))
        .map(|(i, j)| tint((at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1)) / 4.0))
        .collect();
    Grid { width, height, texels }
}

fn tint(height: f64) -> [f64; 3] {
    let above = TINTS.iter().position(|(at, _)| *at >= height).unwrap_or(TINTS.len() - 1).max(1);
    let ((low, from), (high, to)) = (TINTS[above - 1], TINTS[above]);
    mix_colour(from, to, ((height - low) / (high - low)).clamp(0.0, 1.0))
}
