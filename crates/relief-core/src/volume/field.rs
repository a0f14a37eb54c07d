//! The trilinear field between the voxels' centres.

use super::Volume;

/// The values at the corners of a dual cell, as the coefficients of `x`, `y` and `z`, each from 0 to 1 in the
/// cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeCell {
    /// The values at `z = 0`: at `(0, 0)`, `(1, 0)`, `(0, 1)` and `(1, 1)`.
    pub low: [f64; 4],
    /// The values at `z = 1`, in the same order.
    pub high: [f64; 4],
}

impl VolumeCell {
    /// The field at a place in the cell.
    pub fn value(&self, [x, y, z]: [f64; 3]) -> f64 {
        mix(bilinear(&self.low, x, y), bilinear(&self.high, x, y), z)
    }

    /// The derivatives of the field along `x`, `y` and `z`, per cell.
    pub fn gradient(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let along_x = |h: &[f64; 4]| mix(h[1] - h[0], h[3] - h[2], y);
        let along_y = |h: &[f64; 4]| mix(h[2] - h[0], h[3] - h[1], x);
        [
            mix(along_x(&self.low), along_x(&self.high), z),
            mix(along_y(&self.low), along_y(&self.high), z),
            bilinear(&self.high, x, y) - bilinear(&self.low, x, y),
        ]
    }
}

impl Volume {
    /// The corners of dual cell `(i, j, k)`.
    pub fn cell(&self, [i, j, k]: [i64; 3]) -> VolumeCell {
        let slice = |k: i64| {
            [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| f64::from(self.voxel(i, j, k)))
        };
        VolumeCell { low: slice(k), high: slice(k + 1) }
    }

    /// The field at texture coordinates and height `[u, v, h]`, in `[0, 1]`.
    pub fn value_at(&self, at: [f64; 3]) -> f64 {
        let (cell, part) = self.cell_at(at);
        self.cell(cell).value(part)
    }

    /// The derivatives of the field along `u`, `v` and `h` at `[u, v, h]`. On a face between two cells the
    /// cell behind the face counts, along rising `u`, `v` and `h`.
    pub fn gradient_at(&self, at: [f64; 3]) -> [f64; 3] {
        let (cell, part) = self.cell_at(at);
        let slopes = self.cell(cell).gradient(part);
        std::array::from_fn(|axis| slopes[axis] * f64::from(self.size()[axis]))
    }

    /// The dual cell of a place, and where the place lies in it.
    fn cell_at(&self, at: [f64; 3]) -> ([i64; 3], [f64; 3]) {
        let place: [f64; 3] = std::array::from_fn(|axis| at[axis] * f64::from(self.size()[axis]) - 0.5);
        (place.map(|at| at.floor() as i64), place.map(|at| at - at.floor()))
    }
}

fn mix(a: f64, b: f64, part: f64) -> f64 {
    a + (b - a) * part
}

fn bilinear(h: &[f64; 4], x: f64, y: f64) -> f64 {
    mix(mix(h[0], h[1], x), mix(h[2], h[3], x), y)
}
