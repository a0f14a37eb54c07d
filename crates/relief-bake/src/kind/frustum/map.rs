//! Frustum maps, as searches read them.

use relief_core::{HeightMap, HeightMapError, Wrap};

/// Tops and least slopes of all dual cells: see the [module](super).
#[derive(Clone, Debug, PartialEq)]
pub struct FrustumMap {
    size: [u32; 2],
    wrap: Wrap,
    top: Vec<f32>,
    slopes: [Vec<f32>; 4],
}

/// Frustum over one cell, in a quadrant, for a ray that is over the cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Top: above it a ray over the rectangle is above the surface.
    pub top: f32,
    /// Least slope, in heights a texel of Chebyshev distance from the rectangle.
    pub slope: f32,
    /// First column and row of the frustum's rectangle, in cells, not wrapped; minus infinity where
    /// it extends for ever.
    pub low: [f64; 2],
    /// End of the rectangle; infinity where it extends for ever.
    pub high: [f64; 2],
}

/// Reason why planes are no frustum map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrustumMapError {
    /// The size is invalid for a map.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// A plane has another number of cells than the map.
    #[error("a frustum map of {cells} cells needs five planes of as many values, one has {given}")]
    Length {
        /// Cells of the map.
        cells: usize,
        /// Values of the plane.
        given: usize,
    },
    /// A top or a slope is NaN, infinite or negative.
    #[error("a top or a slope is {value}: it must be finite and not negative")]
    Value {
        /// Value given.
        value: f32,
    },
}

/// Returns the index of a quadrant among the four planes of slopes: forward along both axes,
/// backward along `u`, along `v`, along both. `forward` says whether it goes forward along `u` and
/// along `v`.
pub fn quadrant(forward: [bool; 2]) -> usize {
    usize::from(!forward[0]) + 2 * usize::from(!forward[1])
}

impl FrustumMap {
    /// Creates a frustum map from baked planes, which have one value per dual cell. A dual cell
    /// `(i, j)` lies between the centres of texels `(i, j)` and `(i + 1, j + 1)`.
    ///
    /// `size` is the height map's columns and rows, and `wrap` is its wrap. There is a dual cell
    /// for each texel. Planes are stored row by row from the top.
    ///
    /// `top` is the greatest of a cell's four heights, as texels give them. `slopes` has a plane
    /// for each quadrant, in the order of [`quadrant`], in heights per texel. Over the quadrant the
    /// surface lies at most at `top + slope * d`. There `d` is the Chebyshev distance from the cell
    /// in texels.
    ///
    /// # Errors
    ///
    /// When the size is invalid for a map, a plane is too short or too long, or a value is negative
    /// or not finite.
    pub fn new(
        size: [u32; 2],
        wrap: Wrap,
        top: Vec<f32>,
        slopes: [Vec<f32>; 4],
    ) -> Result<Self, FrustumMapError> {
        HeightMap::check_size(size[0], size[1])?;
        let cells = size[0] as usize * size[1] as usize;
        for plane in slopes.iter().chain([&top]) {
            if plane.len() != cells {
                return Err(FrustumMapError::Length { cells, given: plane.len() });
            }
            if let Some(&value) = plane.iter().find(|value| !(value.is_finite() && **value >= 0.0)) {
                return Err(FrustumMapError::Value { value });
            }
        }
        Ok(Self { size, wrap, top, slopes })
    }

    /// Wraps the planes computed for a map.
    pub(super) fn of_map(map: &HeightMap, top: Vec<f32>, slopes: [Vec<f32>; 4]) -> Self {
        Self { size: [map.width(), map.height()], wrap: map.wrap(), top, slopes }
    }

    /// Returns the tops of all dual cells, in heights, row by row from the top.
    pub fn top(&self) -> &[f32] {
        &self.top
    }

    /// Returns the least slopes of all dual cells in a quadrant, in heights per texel, row by row.
    /// `forward` says whether the quadrant goes forward along `u` and along `v`.
    pub fn slopes(&self, forward: [bool; 2]) -> &[f32] {
        &self.slopes[quadrant(forward)]
    }

    /// Returns the planes as [`new`](Self::new) takes them: tops in heights, and slopes in heights
    /// per texel in the order of [`quadrant`].
    pub fn into_planes(self) -> (Vec<f32>, [Vec<f32>; 4]) {
        (self.top, self.slopes)
    }

    /// Returns the frustum for a ray over a dual cell, which may lie outside of the map. `forward`
    /// says along which axes the ray goes forward.
    ///
    /// Cells outside are images of cells inside, moved or mirrored. Under `mirror`, a mirrored cell
    /// has the quadrants of the other side. Only the half cells before texel 0, between cell 0 and
    /// its image, need more:
    ///
    /// * Under `clamp` the first and the last cell extend outward for ever, as their rectangles do.
    ///   The surface out there is the surface at the outermost texel, `f(x, y) = f(0, y)`, and
    ///   `(0, y)` is over cell 0's column. Both points have the same distance, along `y`. So the
    ///   inequality at `(0, y)` is also the inequality at `(x, y)`.
    /// * Under `mirror`, cell -1 from texel -1 to texel 0, both the same, is flat along the axis. A
    ///   ray in it that goes toward cell 0 is given cell 0 with that half cell added to its
    ///   rectangle, `[-1, 1]`; over it, too, `f(x, y) = f(0, y)`. A ray that goes the other way is
    ///   given the mirror image of that rectangle.
    pub fn at(&self, cell: [i64; 2], forward: [bool; 2]) -> Frustum {
        let u = Folded::new(self.wrap, self.size[0], cell[0], forward[0]);
        let v = Folded::new(self.wrap, self.size[1], cell[1], forward[1]);
        let place = v.cell as usize * self.size[0] as usize + u.cell as usize;
        Frustum {
            top: self.top[place],
            slope: self.slopes[quadrant([u.forward, v.forward])][place],
            low: [u.low, v.low],
            high: [u.high, v.high],
        }
    }
}

/// One axis of a cell outside of the map, with the cell inside whose image it is.
struct Folded {
    cell: u32,
    /// Whether forward along the axis is forward in the cell inside.
    forward: bool,
    low: f64,
    high: f64,
}

impl Folded {
    fn new(wrap: Wrap, size: u32, cell: i64, forward: bool) -> Self {
        let side = i64::from(size);
        let (low, high) = (cell as f64, cell as f64 + 1.0);
        match wrap {
            Wrap::Repeat => Self { cell: cell.rem_euclid(side) as u32, forward, low, high },
            Wrap::Clamp => {
                let inside = cell.clamp(0, side - 1);
                Self {
                    cell: inside as u32,
                    forward,
                    low: if inside == 0 { f64::NEG_INFINITY } else { inside as f64 },
                    high: if inside == side - 1 { f64::INFINITY } else { inside as f64 + 1.0 },
                }
            }
            Wrap::Mirror => {
                let folded = cell.rem_euclid(2 * side);
                if folded < side {
                    Self { cell: folded as u32, forward, low, high }
                } else if folded < 2 * side - 1 {
                    Self { cell: (2 * side - 2 - folded) as u32, forward: !forward, low, high }
                } else if forward {
                    Self { cell: 0, forward: true, low, high: high + 1.0 }
                } else {
                    Self { cell: 0, forward: true, low: low - 1.0, high }
                }
            }
        }
    }
}
