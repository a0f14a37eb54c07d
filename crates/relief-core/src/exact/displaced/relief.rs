//! The height map under a piece of a shell: cells, their patches, and bounds over ranges of cells.

use glam::DVec2;

use crate::{HeightMap, MaxPyramid, MinPyramid, Wrap};

/// A height map with bounds, and displacements in metres.
#[derive(Clone, Debug)]
pub(super) struct Relief {
    map: HeightMap,
    highest: MaxPyramid,
    lowest: MinPyramid,
    scale_m: f64,
    bias_m: f64,
}

/// Bilinear patch of one dual cell: texel heights as a function of the position in cells, counted
/// from the cell's corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    height: f64,
    along: DVec2,
    twist: f64,
    scale_m: f64,
    bias_m: f64,
}

impl Relief {
    pub fn new(map: &HeightMap, scale_m: f64, bias_m: f64) -> Self {
        let (highest, lowest) = (MaxPyramid::new(map), MinPyramid::new(map));
        Self { map: map.clone(), highest, lowest, scale_m, bias_m }
    }

    /// Columns and rows of the map.
    pub fn sides(&self) -> [u32; 2] {
        [self.map.width(), self.map.height()]
    }

    /// Texture coordinates converted to cells: whole numbers are the centres of texels.
    pub fn place(&self, uv: DVec2) -> DVec2 {
        let [width, height] = self.sides();
        uv * DVec2::new(width.into(), height.into()) - 0.5
    }

    /// First and last dual cell that an interval of positions touches, along one axis. Beyond the
    /// edge of a clamped map the outermost cells continue for ever.
    pub fn cells(&self, axis: usize, least: f64, greatest: f64) -> [i64; 2] {
        let first = least.floor() as i64;
        let last = (greatest.ceil() as i64 - 1).max(first);
        match self.map.wrap() {
            Wrap::Clamp => [first, last].map(|cell| cell.clamp(-1, i64::from(self.sides()[axis]) - 1)),
            Wrap::Repeat | Wrap::Mirror => [first, last],
        }
    }

    /// Lower and upper bound of the displacement over a range of cells, in metres.
    pub fn bounds(&self, first: [i64; 2], last: [i64; 2]) -> [f64; 2] {
        let texels = [self.lowest.bound(first, last).0, self.highest.bound(first, last).0];
        let [a, b] = texels.map(|texel| self.metres(texel.into()));
        [a.min(b), a.max(b)]
    }

    /// Displacement of a texel height, in metres.
    pub fn metres(&self, height: f64) -> f64 {
        self.bias_m + self.scale_m * height
    }

    /// Patch of a cell.
    pub fn cell(&self, [column, row]: [i64; 2]) -> Cell {
        let [h00, h10, h01, h11] = self.map.cell(column, row).map(f64::from);
        Cell {
            height: h00,
            along: DVec2::new(h10 - h00, h01 - h00),
            twist: (h00 - h10) + (h11 - h01),
            scale_m: self.scale_m,
            bias_m: self.bias_m,
        }
    }
}

impl Cell {
    /// Texel height at a position.
    pub fn height(&self, at: DVec2) -> f64 {
        self.blossom(at, at)
    }

    /// Displacement at a position, in metres, and its derivatives by the position.
    pub fn displacement(&self, at: DVec2) -> (f64, DVec2) {
        let slope = self.along + self.twist * DVec2::new(at.y, at.x);
        (self.metres(self.height(at)), self.scale_m * slope)
    }

    /// Blossom of the displacement, in metres. It is symmetric, affine in each of the two
    /// positions, and equal to the displacement if the positions are equal. Over a triangle the
    /// blossoms of all pairs of corners are the Bézier coefficients.
    pub fn displacement_blossom(&self, a: DVec2, b: DVec2) -> f64 {
        self.metres(self.blossom(a, b))
    }

    fn blossom(&self, a: DVec2, b: DVec2) -> f64 {
        let middle = 0.5 * (a + b);
        self.height + self.along.dot(middle) + 0.5 * self.twist * (a.x * b.y + a.y * b.x)
    }

    fn metres(&self, height: f64) -> f64 {
        self.bias_m + self.scale_m * height
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_carry_the_maps_surface() {
        for wrap in Wrap::ALL {
            let map = HeightMap::from_fn(5, 3, wrap, |i, j| ((7 * i + 3 * j) % 11) as f32 / 11.0);
            let relief = Relief::new(&map.expect("a valid map"), 0.3, -0.1);
            for step in 0..400 {
                let uv = DVec2::new(f64::from(step) * 0.0117 - 2.0, 1.7 - f64::from(step) * 0.0083);
                let place = relief.place(uv);
                let cell = [0, 1].map(|axis| relief.cells(axis, place[axis], place[axis])[0]);
                let within = place - DVec2::new(cell[0] as f64, cell[1] as f64);
                let patch = relief.cell(cell);
                let height = relief.map.height_at(uv.x, uv.y);
                assert!((patch.height(within) - height).abs() < 1e-14, "{wrap} {uv}");
                let (metres, slope) = patch.displacement(within);
                assert!((metres - (0.3 * height - 0.1)).abs() < 1e-14);
                let [low, high] = relief.bounds(cell, cell);
                assert!(low <= metres + 1e-15 && metres <= high + 1e-15);
                let step = DVec2::new(1e-3, 2e-3);
                let ahead = patch.displacement(within + step).0;
                assert!((ahead - metres - slope.dot(step)).abs() < 2e-6);
            }
        }
    }
}
