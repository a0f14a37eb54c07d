//! Places on the surface, drawn where a bound may have forgotten them.

use relief_core::HeightMap;

use relief_core::rng::Rng;

/// By how much the surface may seem to pass a bound that it touches, in heights: a bilinear height in `f64`
/// goes through six roundings of numbers of at most 1.
pub const ROUNDING: f64 = 1e-15;

/// A place on the surface: a dual cell, not wrapped, and where in it, from 0 to 1 along both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The dual cell.
    pub cell: [i64; 2],
    /// Where in the cell.
    pub within: [f64; 2],
}

impl Place {
    /// A place that a bound may have forgotten: corners, edges and diagonals of cells as often as their
    /// insides, up to two tiles outside of the map.
    pub fn draw(rng: &mut Rng, map: &HeightMap) -> Self {
        let cell = [map.width(), map.height()].map(|side| {
            let tile = if rng.below(2) == 0 { i64::from(rng.below(5)) - 2 } else { 0 };
            let cell = if rng.below(4) == 0 { rng.pick(&[0, side - 1]) } else { rng.below(side) };
            i64::from(cell) + tile * i64::from(side) - i64::from(rng.below(2))
        });
        let (x, y) = (rng.unit(), rng.unit());
        let corner = |rng: &mut Rng| f64::from(rng.below(2));
        let within = match rng.below(5) {
            0 => [x, y],
            1 => [corner(rng), corner(rng)],
            2 => [corner(rng), y],
            3 => [x, corner(rng)],
            _ => [x, rng.pick(&[x, 1.0 - x])],
        };
        Self { cell, within }
    }

    /// Where it is, in cells from texel `(0, 0)`.
    pub fn at(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.cell[axis] as f64 + self.within[axis])
    }

    /// The height of the surface there.
    pub fn height(&self, map: &HeightMap) -> f64 {
        let [h00, h10, h01, h11] = map.cell(self.cell[0], self.cell[1]).map(f64::from);
        let [x, y] = self.within;
        (1.0 - y) * ((1.0 - x) * h00 + x * h10) + y * ((1.0 - x) * h01 + x * h11)
    }
}
