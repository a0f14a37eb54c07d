//! White noise: the roughest height map there is, on which searches that hope for smoothness fail.

use super::lattice::random;
use super::picture::Grid;

const SIDE: u32 = 128;

pub fn map() -> Grid<f64> {
    let side = f64::from(SIDE);
    Grid::square(SIDE, |u, v| random((u * side) as u32, (v * side) as u32, 1))
}
