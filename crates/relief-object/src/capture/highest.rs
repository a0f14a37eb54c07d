//! Highest point of a mesh in each texel.

use glam::DVec3;

/// Highest point of a triangle in a texel, and the number of the triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highest {
    /// Texture coordinates in texels, and height.
    pub at: DVec3,
    /// Number of the triangle.
    pub triangle: u32,
}

/// Most corners of a triangle that is cut at four lines.
const MOST_CORNERS: usize = 7;

/// A convex polygon: a part of a triangle.
#[derive(Clone, Copy)]
struct Polygon {
    corners: [DVec3; MOST_CORNERS],
    count: usize,
}

impl Polygon {
    fn of(triangle: &[DVec3; 3]) -> Self {
        let mut corners = [DVec3::ZERO; MOST_CORNERS];
        corners[..3].copy_from_slice(triangle);
        Self { corners, count: 3 }
    }

    /// Part of the polygon on which `sign` times the coordinate is at most `sign` times `line`.
    fn cut(&self, axis: usize, sign: f64, line: f64) -> Self {
        let mut cut = Self { corners: [DVec3::ZERO; MOST_CORNERS], count: 0 };
        let beyond = |corner: DVec3| sign * (corner[axis] - line);
        let mut add = |corner: DVec3| {
            if cut.count < MOST_CORNERS {
                cut.corners[cut.count] = corner;
                cut.count += 1;
            }
        };
        for at in 0..self.count {
            let (corner, next) = (self.corners[at], self.corners[(at + 1) % self.count]);
            let (a, b) = (beyond(corner), beyond(next));
            if a <= 0.0 {
                add(corner);
            }
            if a < 0.0 && b > 0.0 || a > 0.0 && b < 0.0 {
                let mut point = corner + (next - corner) * (a / (a - b));
                point[axis] = line;
                add(point);
            }
        }
        cut
    }

    /// Whether the polygon reaches into the open interval along an axis.
    fn reaches_into(&self, axis: usize, low: f64, high: f64) -> bool {
        let along = self.corners[..self.count].iter().map(|corner| corner[axis]);
        let [least, most] =
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], at| [a.min(at), b.max(at)]);
        least < high && most > low
    }
}

/// Raises the texels of an image to the highest points of the triangles in them. Triangles are
/// given by their corners in texels and heights; some may be left out. Texels that a triangle only
/// touches from outside are not raised.
pub fn raise(
    [columns, rows]: [u32; 2],
    triangles: impl Iterator<Item = [DVec3; 3]>,
    is_left_out: impl Fn(u32) -> bool,
    texels: &mut [Option<Highest>],
) {
    let first = |least: f64| least.floor().max(0.0) as u32;
    let end = |most: f64, side: u32| (most.ceil().max(0.0) as u32).min(side);
    for (number, corners) in triangles.enumerate().filter(|(number, _)| !is_left_out(*number as u32)) {
        let [low, high] = corners[1..]
            .iter()
            .fold([corners[0]; 2], |[low, high], corner| [low.min(*corner), high.max(*corner)]);
        let range = |axis: usize, side: u32| first(low[axis])..end(high[axis], side);
        for y in range(1, rows) {
            let (top, bottom) = (f64::from(y), f64::from(y + 1));
            let strip = Polygon::of(&corners).cut(1, -1.0, top).cut(1, 1.0, bottom);
            if !strip.reaches_into(1, top, bottom) {
                continue;
            }
            for x in range(0, columns) {
                let (left, right) = (f64::from(x), f64::from(x + 1));
                let part = strip.cut(0, -1.0, left).cut(0, 1.0, right);
                if !part.reaches_into(0, left, right) {
                    continue;
                }
                let corners = &part.corners[..part.count];
                let Some(at) = corners.iter().copied().reduce(|a, b| if b.z > a.z { b } else { a }) else {
                    continue;
                };
                let texel = &mut texels[(y * columns + x) as usize];
                if texel.is_none_or(|before| at.z > before.at.z) {
                    *texel = Some(Highest { at, triangle: number as u32 });
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn raised(size: [u32; 2], corners: [[f64; 3]; 3]) -> Vec<f64> {
        let mut texels = vec![None; (size[0] * size[1]) as usize];
        raise(size, std::iter::once(corners.map(DVec3::from)), |_| false, &mut texels);
        texels.iter().map(|texel| texel.map_or(0.0, |highest: Highest| highest.at.z)).collect()
    }

    #[test]
    fn a_slope_is_as_high_as_the_upper_side_of_each_texel() {
        // Height grows by a tenth per texel along x.
        let raised = raised([4, 2], [[0.0, 0.0, 0.1], [8.0, 0.0, 0.9], [0.0, 8.0, 0.1]]);
        for (at, height) in raised.iter().enumerate() {
            assert!((height - (0.2 + 0.1 * (at % 4) as f64)).abs() < 1e-12, "{at}: {height}");
        }
    }

    #[test]
    fn what_is_smaller_than_a_texel_is_seen() {
        let small = [[1.1, 0.3, 0.5], [1.2, 0.3, 0.7], [1.1, 0.35, 0.6]];
        assert_eq!(raised([3, 1], small), [0.0, 0.7, 0.0]);
        // The triangle seen from its edge: a line from one texel into the next.
        let line = [[0.5, 0.5, 0.2], [1.5, 0.5, 0.4], [1.0, 0.5, 0.9]];
        let both = raised([3, 1], line);
        assert!((both[0] - 0.9).abs() < 1e-12 && (both[1] - 0.9).abs() < 1e-12 && both[2] == 0.0);
    }

    #[test]
    fn texels_that_are_only_touched_are_left_out() {
        let square = [[1.0, 0.0, 0.5], [2.0, 0.0, 0.5], [1.0, 1.0, 0.5]];
        assert_eq!(raised([3, 2], square), [0.0, 0.5, 0.0, 0.0, 0.0, 0.0]);
    }
}
