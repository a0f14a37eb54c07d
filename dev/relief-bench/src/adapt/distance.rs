//! Distance of a height map from any triangles over it, at samples.

use glam::DVec2;
use rayon::prelude::*;
use relief_core::HeightMap;

/// A triangle: places in texels, whole numbers their centres, and heights.
pub type Piece = [(DVec2, f64); 3];

/// Distances at samples.
#[derive(Clone, Copy, Debug, Default)]
pub struct Distance {
    pub greatest: f64,
    squares: f64,
    count: u64,
}

impl Distance {
    /// The root of the mean square.
    pub fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }

    fn with(self, other: Self) -> Self {
        Self {
            greatest: self.greatest.max(other.greatest),
            squares: self.squares + other.squares,
            count: self.count + other.count,
        }
    }
}

/// The distances at `per_texel`² places a texel, those on edges once for each triangle.
pub fn distance(map: &HeightMap, pieces: &[Piece], per_texel: u32) -> Distance {
    pieces
        .par_iter()
        .map(|piece| of_piece(map, piece, f64::from(per_texel)))
        .reduce(Distance::default, Distance::with)
}

fn of_piece(map: &HeightMap, &[(a, za), (b, zb), (c, zc)]: &Piece, n: f64) -> Distance {
    let mut distance = Distance::default();
    let area = (b - a).perp_dot(c - a);
    if area == 0.0 {
        return distance;
    }
    let low = (a.min(b).min(c) * n).ceil();
    let high = (a.max(b).max(c) * n).floor();
    for j in low.y as i64..=high.y as i64 {
        for i in low.x as i64..=high.x as i64 {
            let at = DVec2::new(i as f64, j as f64) / n;
            let [of_b, of_c] = [(at - a).perp_dot(c - a) / area, (b - a).perp_dot(at - a) / area];
            let of_a = 1.0 - of_b - of_c;
            if of_a.min(of_b).min(of_c) >= -1e-12 {
                let gap = map.height_at_place(at.x, at.y) - (of_a * za + of_b * zb + of_c * zc);
                distance.greatest = distance.greatest.max(gap.abs());
                distance.squares += gap * gap;
                distance.count += 1;
            }
        }
    }
    distance
}
