//! Light from all directions, read from an equirectangular picture.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relief_core::area_mean::{coarser, coarser_size};
use relief_io::Picture;

/// Fewest columns of the finest and of the last level, as the smallest cube needs them.
const LEAST_WIDTH: u32 = 128;
/// See [`LEAST_WIDTH`].
const LAST_WIDTH: u32 = 64;

/// Equirectangular picture with mip levels, each half as wide and high as the one before.
pub struct Sphere {
    levels: Vec<Level>,
}

/// Mip level of an equirectangular picture.
pub struct Level {
    /// Vertical position of each row.
    pub rows: Vec<Row>,
    /// Sine and cosine of each column's angle to the right of the middle.
    pub columns: Vec<[f64; 2]>,
    /// Row by row from above: a texel's light times the part of the sphere that it covers, then
    /// that part.
    pub texels: Vec<[f32; 4]>,
}

/// Position of a row: components of a unit direction.
pub struct Row {
    /// Along `y`.
    pub up: f64,
    /// Horizontal length.
    pub flat: f64,
}

impl Level {
    fn new(texels: Vec<[f32; 4]>, [width, height]: [u32; 2]) -> Self {
        let row = |row: u32| {
            let (flat, up) = ((f64::from(row) + 0.5) / f64::from(height) * PI).sin_cos();
            Row { up, flat }
        };
        let column = |column: u32| {
            let (sin, cos) = (((f64::from(column) + 0.5) / f64::from(width) - 0.5) * TAU).sin_cos();
            [sin, cos]
        };
        Self { rows: (0..height).map(row).collect(), columns: (0..width).map(column).collect(), texels }
    }

    /// Returns the column at an angle in radians to the right of the middle. Whole numbers are
    /// centres of columns.
    pub fn column_of(&self, angle: f64) -> f64 {
        self.columns_of(angle + PI) - 0.5
    }

    /// Returns the number of columns that an angle in radians spans.
    pub fn columns_of(&self, angle: f64) -> f64 {
        angle / TAU * self.columns.len() as f64
    }

    /// Returns the light from a unit direction, interpolated between the four nearest texels.
    fn between(&self, toward: DVec3) -> [f64; 3] {
        let (columns, rows) = (self.columns.len(), self.rows.len());
        let across = self.column_of(toward.x.atan2(-toward.z));
        let down = toward.y.clamp(-1.0, 1.0).acos() / PI * rows as f64 - 0.5;
        let texel = |column: f64, row: f64| {
            let (row, last) = (row as isize, rows as isize - 1);
            // Beyond a pole, rows continue on the other side.
            let (row, turn) = if row < 0 {
                (-1 - row, columns / 2)
            } else if row > last {
                (2 * last + 1 - row, columns / 2)
            } else {
                (row, 0)
            };
            let column = (column as isize + turn as isize).rem_euclid(columns as isize);
            let [red, green, blue, part] = self.texels[row as usize * columns + column as usize];
            [red, green, blue].map(|light| f64::from(light) / f64::from(part))
        };
        let [left, above] = [across.floor(), down.floor()];
        let [x, y] = [across - left, down - above];
        let mut sum = [0.0; 3];
        for (dx, dy, weight) in [
            (0.0, 0.0, (1.0 - x) * (1.0 - y)),
            (1.0, 0.0, x * (1.0 - y)),
            (0.0, 1.0, (1.0 - x) * y),
            (1.0, 1.0, x * y),
        ] {
            for (sum, part) in sum.iter_mut().zip(texel(left + dx, above + dy)) {
                *sum += weight * part;
            }
        }
        sum
    }
}

impl Sphere {
    /// Bytes for each texel of the picture while the sphere is made and used, besides the picture:
    /// a level, all that follow, and the one in work.
    pub const BYTES: u64 = 16 * 4 / 3 + 4;

    /// Creates the levels from a picture of finite colours that is twice as wide as high. A small
    /// picture is enlarged by interpolation.
    pub fn of(picture: &Picture) -> Self {
        let mut size = [picture.width, picture.height];
        let mut texels = weighted(picture);
        if size[0] < LEAST_WIDTH {
            let small = Level::new(texels, size);
            size = [LEAST_WIDTH, LEAST_WIDTH / 2];
            texels = weighted(&enlarged(&small, size));
        }
        let mut levels = Vec::new();
        while size[0] >= LAST_WIDTH {
            let next = coarser(&texels, size);
            levels.push(Level::new(texels, size));
            (texels, size) = (next, coarser_size(size));
        }
        Self { levels }
    }

    /// Returns the number of columns of the finest level.
    pub fn width(&self) -> u32 {
        self.levels[0].columns.len() as u32
    }

    /// Returns the coarsest level with at least `columns` columns, or the finest.
    pub fn level(&self, columns: u32) -> &Level {
        let fine = |level: &&Level| level.columns.len() >= columns as usize;
        self.levels.iter().rev().find(fine).unwrap_or(&self.levels[0])
    }

    /// Returns the mean light over a small square around a unit direction. `side` is the square's
    /// side at distance 1.
    pub fn mean(&self, toward: DVec3, side: f64) -> [f32; 3] {
        // Three texels of the level are about as wide as the square.
        let level = self.level((2.0 * TAU / side) as u32);
        let (along, across) = toward.any_orthonormal_pair();
        let mut sum = [0.0; 3];
        for i in [-1.0, 0.0, 1.0] {
            for j in [-1.0, 0.0, 1.0] {
                let beside = along * (i * side / 3.0) + across * (j * side / 3.0);
                for (sum, part) in sum.iter_mut().zip(level.between((toward + beside).normalize())) {
                    *sum += part;
                }
            }
        }
        sum.map(|light| (light / 9.0) as f32)
    }
}

/// Returns the light of each texel times the part of the sphere that it covers, then that part.
fn weighted(picture: &Picture) -> Vec<[f32; 4]> {
    let height = f64::from(picture.height);
    let rows = picture.texels.chunks(picture.width.max(1) as usize).enumerate();
    let texels = rows.flat_map(|(row, texels)| {
        let [above, below] = [row, row + 1].map(|edge| (edge as f64 / height * PI).cos());
        let part = ((above - below) / 2.0 / f64::from(picture.width)) as f32;
        texels.iter().map(move |&[red, green, blue, _]| {
            let [red, green, blue] = [red, green, blue].map(|light| light.max(0.0) * part);
            [red, green, blue, part]
        })
    });
    texels.collect()
}

/// Interpolates a level at more texels.
fn enlarged(small: &Level, [width, height]: [u32; 2]) -> Picture {
    let large = Level::new(Vec::new(), [width, height]);
    let texels = large.rows.iter().flat_map(|row| {
        large.columns.iter().map(|[sin, cos]| {
            let toward = DVec3::new(sin * row.flat, row.up, -cos * row.flat);
            let [red, green, blue] = small.between(toward).map(|light| light as f32);
            [red, green, blue, 1.0]
        })
    });
    Picture { width, height, texels: texels.collect() }
}
