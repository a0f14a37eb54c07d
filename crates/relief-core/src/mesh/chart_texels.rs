//! Texels of a map under the charts of a mesh with unique texture coordinates.

use glam::DVec2;

use super::Mesh;
use crate::{HeightMap, HeightMapError, TexelMask};

/// Distance in tiles by which texture coordinates may lie outside the map, because of rounding.
const OUTSIDE: f64 = 1e-5;

/// Number of texels beside a chart over which heights are extrapolated. Farther away they are
/// constant.
const CONTINUED: u32 = 2;

/// Placeholder for "no triangle".
const NONE: u32 = u32::MAX;

/// Texels of a map that a mesh with unique texture coordinates covers.
#[derive(Clone, Debug)]
pub struct ChartTexels {
    size: [u32; 2],
    /// Triangle under the centre of each texel, row by row from the top.
    triangles: Vec<u32>,
    /// Texels that are read for interpolation on the charts.
    read: TexelMask,
}

/// Why a mesh does not cover unique texels of a map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ChartError {
    /// The map's size is not accepted.
    #[error(transparent)]
    Map(#[from] HeightMapError),
    /// A triangle lies partly or wholly outside the map.
    #[error(
        "triangle {triangle} has texture coordinates outside 0 to 1: the mesh needs unique ones inside \
         this range, without tiling"
    )]
    Outside {
        /// Number of the first such triangle.
        triangle: u32,
    },
    /// Two triangles overlap on a texel.
    #[error(
        "triangles {} and {} both lie on texel ({}, {}): the mesh needs unique texture coordinates",
        triangles[0], triangles[1], texel[0], texel[1]
    )]
    Overlap {
        /// Numbers of the triangles.
        triangles: [u32; 2],
        /// Column and row of the first such texel of the second triangle.
        texel: [u32; 2],
    },
    /// No triangle covers a texel's centre.
    #[error("no triangle lies on any texel: the map is too small for the mesh")]
    NoTexel,
}

impl Mesh {
    /// Finds the texels that the mesh covers in a map of this size. It takes 5 bytes per texel.
    ///
    /// # Errors
    ///
    /// When a height map cannot have this size, texture coordinates lie outside 0 to 1, two
    /// triangles cover the same texel, or no triangle covers any.
    pub fn chart_texels(&self, size: [u32; 2]) -> Result<ChartTexels, ChartError> {
        let [width, height] = size;
        HeightMap::check_size(width, height)?;
        let mut triangles = vec![NONE; width as usize * height as usize];
        let mut read = vec![false; triangles.len()];
        for triangle in 0..self.triangles.len() as u32 {
            let uvs = self.corners(triangle).map(|corner| corner.uv.as_dvec2());
            let inside = -OUTSIDE..=1.0 + OUTSIDE;
            if uvs.iter().flat_map(DVec2::to_array).any(|part| !inside.contains(&part)) {
                return Err(ChartError::Outside { triangle });
            }
            // Corners in texels; whole numbers are the centres.
            let corners = uvs.map(|uv| uv * DVec2::new(width.into(), height.into()) - 0.5);
            let edges = edges(corners);
            let low = corners.into_iter().reduce(DVec2::min).unwrap_or_default();
            let high = corners.into_iter().reduce(DVec2::max).unwrap_or_default();
            let range = |low: f64, high: f64, count: u32| {
                let [first, last] = [low - 1.0, high + 1.0].map(|at| at.clamp(0.0, f64::from(count - 1)));
                first.ceil() as u32..=last.floor() as u32
            };
            for row in range(low.y, high.y, height) {
                for column in range(low.x, high.x, width) {
                    let centre = DVec2::new(column.into(), row.into());
                    let at = row as usize * width as usize + column as usize;
                    read[at] |= edges.iter().all(|edge| edge.reaches(centre));
                    if edges.iter().all(|edge| edge.holds(centre)) {
                        if triangles[at] != NONE {
                            let triangles = [triangles[at], triangle];
                            return Err(ChartError::Overlap { triangles, texel: [column, row] });
                        }
                        triangles[at] = triangle;
                    }
                }
            }
        }
        if triangles.iter().all(|triangle| *triangle == NONE) {
            return Err(ChartError::NoTexel);
        }
        let is_read = |column: u32, row: u32| read[row as usize * width as usize + column as usize];
        Ok(ChartTexels { size, triangles, read: TexelMask::from_fn(width, height, is_read) })
    }
}

/// An edge of a triangle in texture space.
struct Edge {
    from: DVec2,
    along: DVec2,
    /// Sign that makes the inner side positive.
    sign: f64,
    /// Whether points on the edge belong to the triangle.
    is_own: bool,
}

/// Edges of a triangle of either orientation. Neighbours compute the same for a common edge: its
/// ends are ordered, and a point on it belongs to exactly one of them.
fn edges([a, b, c]: [DVec2; 3]) -> [Edge; 3] {
    let turn = if (b - a).perp_dot(c - a) < 0.0 { -1.0 } else { 1.0 };
    [[a, b], [b, c], [c, a]].map(|[from, to]| {
        let is_ordered = (from.x, from.y) <= (to.x, to.y);
        let [first, last] = if is_ordered { [from, to] } else { [to, from] };
        let sign = if is_ordered { turn } else { -turn };
        Edge { from: first, along: last - first, sign, is_own: sign > 0.0 }
    })
}

impl Edge {
    fn side(&self, point: DVec2) -> f64 {
        self.along.perp_dot(point - self.from) * self.sign
    }

    /// Whether a point is on the inner side.
    fn holds(&self, point: DVec2) -> bool {
        let side = self.side(point);
        side > 0.0 || (side == 0.0 && self.is_own && self.along != DVec2::ZERO)
    }

    /// Whether any point less than a texel away along both axes is on the inner side.
    fn reaches(&self, centre: DVec2) -> bool {
        self.side(centre) + self.along.x.abs() + self.along.y.abs() >= 0.0
    }
}

impl ChartTexels {
    /// Returns the texels that are read for interpolation between texel centres on a chart, and all
    /// texels up to `gutter` away from them, diagonally too. No other texel influences the mesh's
    /// picture in its finest level.
    pub fn with_gutter(&self, gutter: u32) -> TexelMask {
        let [width, height] = self.size;
        // The nearest read texel to the left or right in each row, then over rows.
        let far = u32::MAX;
        let mut near = vec![far; self.triangles.len()];
        let mut relax = |at: usize, before: Option<usize>| {
            if let Some(before) = before {
                near[at] = near[at].min(near[before].saturating_add(1));
            } else if self.read.contains((at % width as usize) as u32, (at / width as usize) as u32) {
                near[at] = 0;
            }
        };
        let place = |column: u32, row: u32| row as usize * width as usize + column as usize;
        for row in 0..height {
            for column in 0..width {
                relax(place(column, row), None);
                if column > 0 {
                    relax(place(column, row), Some(place(column - 1, row)));
                }
            }
            for column in (1..width).rev() {
                relax(place(column - 1, row), Some(place(column, row)));
            }
        }
        let near = near;
        let mut within = vec![false; near.len()];
        for column in 0..width {
            let mut last: Option<u32> = None;
            for row in 0..height {
                last = if near[place(column, row)] <= gutter { Some(row) } else { last };
                within[place(column, row)] = last.is_some_and(|last| row - last <= gutter);
            }
            let mut next: Option<u32> = None;
            for row in (0..height).rev() {
                next = if near[place(column, row)] <= gutter { Some(row) } else { next };
                within[place(column, row)] |= next.is_some_and(|next| next - row <= gutter);
            }
        }
        TexelMask::from_fn(width, height, |column, row| within[place(column, row)])
    }

    /// Height in metres of the smooth base of the mesh above its triangles, for each texel, row by
    /// row from the top (see [`Mesh::lifts`]). Beside charts the height is extrapolated from the
    /// nearest triangle for two texels. Beyond that it is constant.
    ///
    /// Heights raised by this amount show the same over flat triangles as the original heights over
    /// the smooth base. Only details below the map's resolution differ: the lift bends between
    /// texels and has creases at edges.
    ///
    /// `mesh` must be the mesh of these texels. Panics if it has fewer triangles.
    pub fn lifts_m(&self, mesh: &Mesh) -> Vec<f32> {
        let lifts = mesh.lifts();
        let [width, height] = self.size;
        let of_triangle = |triangle: u32, at: usize| {
            let centre = DVec2::new((at % width as usize) as f64, (at / width as usize) as f64) + 0.5;
            let point = centre / DVec2::new(width.into(), height.into());
            let [a, b, c] = mesh.corners(triangle).map(|corner| corner.uv.as_dvec2());
            let (ab, ac, at) = (b - a, c - a, point - a);
            let area = ab.perp_dot(ac);
            let [wb, wc] = [at.perp_dot(ac) / area, ab.perp_dot(at) / area];
            let wa = 1.0 - wb - wc;
            let [bc, ca, ab] = lifts[triangle as usize].map(f64::from);
            let lift = bc * wb * wc + ca * wc * wa + ab * wa * wb;
            if lift.is_finite() { lift as f32 } else { 0.0 }
        };
        let mut nearest = self.triangles.clone();
        let mut values = vec![0.0f32; nearest.len()];
        // Goes from ring to ring around the charts.
        let mut ring: Vec<usize> = (0..nearest.len()).filter(|at| nearest[*at] != NONE).collect();
        for at in &ring {
            values[*at] = of_triangle(nearest[*at], *at);
        }
        let mut distance = 0;
        while !ring.is_empty() {
            distance += 1;
            let mut next = Vec::new();
            for at in ring {
                let (column, row) = (at % width as usize, at / width as usize);
                let beside = [
                    (column > 0).then(|| at - 1),
                    (column + 1 < width as usize).then_some(at + 1),
                    row.checked_sub(1).map(|_| at - width as usize),
                    (row + 1 < height as usize).then_some(at + width as usize),
                ];
                for to in beside.into_iter().flatten() {
                    if nearest[to] == NONE {
                        nearest[to] = nearest[at];
                        let is_near = distance <= CONTINUED;
                        values[to] = if is_near { of_triangle(nearest[at], to) } else { values[at] };
                        next.push(to);
                    }
                }
            }
            ring = next;
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Vertex, cube, rectangle, sphere, square, torus};
    use glam::{Vec2, Vec3};

    #[test]
    fn every_texel_of_a_whole_map_lies_on_one_triangle() {
        for (mesh, size) in [
            (square(1), [17, 9]),
            (square(7), [64, 64]),
            (rectangle([2.0, 1.0], 5), [31, 10]),
            (torus(24, 12), [48, 33]),
        ] {
            let mesh = mesh.expect("a mesh");
            let texels = mesh.chart_texels(size).expect("charts of its own");
            assert!(texels.triangles.iter().all(|triangle| *triangle != NONE), "{size:?}");
            assert_eq!(texels.with_gutter(0).count(), u64::from(size[0]) * u64::from(size[1]));
        }
    }

    #[test]
    fn maps_that_are_laid_on_twice_are_refused() {
        let size = [32, 32];
        let tiled = square(1).and_then(|mesh| mesh.tiled(Vec2::new(2.0, 1.0))).expect("a mesh");
        assert!(matches!(tiled.chart_texels(size), Err(ChartError::Outside { .. })));
        // All six sides lie on the whole map.
        let error = cube(1).expect("a mesh").chart_texels(size).map(drop);
        let is_of_sides = |triangles: &[u32; 2]| triangles[0] < 2 && triangles[1] >= 2;
        assert!(
            matches!(&error, Err(ChartError::Overlap { triangles, .. }) if is_of_sides(triangles)),
            "{error:?}"
        );
        let tiny = square(1).and_then(|mesh| mesh.tiled(Vec2::splat(1e-3))).expect("a mesh");
        assert_eq!(tiny.chart_texels([3, 3]).map(drop), Err(ChartError::NoTexel));
        let empty = square(1).expect("a mesh").chart_texels([0, 3]).map(drop);
        assert!(matches!(empty, Err(ChartError::Map(HeightMapError::Empty { .. }))));
    }

    /// A triangle in texture space.
    fn chart(uvs: [[f32; 2]; 3]) -> Mesh {
        let vertex = |uv: [f32; 2]| Vertex {
            position: Vec3::new(uv[0], 0.0, uv[1]),
            normal: Vec3::Y,
            tangent: Vec3::X,
            bitangent: Vec3::Z,
            uv: uv.into(),
        };
        Mesh::new(uvs.map(vertex).to_vec(), vec![[0, 1, 2]]).expect("a triangle")
    }

    #[test]
    fn a_gutter_holds_what_is_read_on_charts_and_so_many_texels_more() {
        let size = [40, 30];
        let mesh = chart([[0.22, 0.3], [0.61, 0.35], [0.4, 0.71]]);
        let texels = mesh.chart_texels(size).expect("a chart");
        // Texels that bilinear interpolation reads at many points of the chart.
        let mut touched = vec![false; 1200];
        for i in 0..=400 {
            for j in 0..=400 - i {
                let w = [i, j, 400 - i - j].map(|part| part as f32 / 400.0);
                let uv = mesh.interpolated(0, w).uv.as_dvec2();
                let at = uv * DVec2::new(40.0, 30.0) - 0.5;
                for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    touched[(at.y.floor() as usize + y) * 40 + at.x.floor() as usize + x] = true;
                }
            }
        }
        for gutter in 0..4u32 {
            let mask = texels.with_gutter(gutter);
            for (row, column) in (0..30u32).flat_map(|row| (0..40u32).map(move |column| (row, column))) {
                let near = |reach: u32| {
                    let beside = |at: u32, count: u32| at.saturating_sub(reach)..=(at + reach).min(count - 1);
                    beside(row, 30).any(|j| beside(column, 40).any(|i| touched[(j * 40 + i) as usize]))
                };
                let is_in = mask.contains(column, row);
                // Points of the chart that no sample has hit may touch one more texel.
                assert!(is_in || !near(gutter), "({column}, {row}) {gutter}");
                assert!(!is_in || near(gutter + 1), "({column}, {row}) {gutter}");
            }
            let expected = touched.iter().filter(|touched| **touched).count() as u64;
            assert!(gutter > 0 || mask.count().abs_diff(expected) < 8, "{} {expected}", mask.count());
        }
    }

    #[test]
    fn texels_are_lifted_as_the_mesh_is() {
        let mesh = torus(16, 8).expect("a mesh");
        let size = [128, 64];
        let texels = mesh.chart_texels(size).expect("charts of its own");
        let values = texels.lifts_m(&mesh);
        let most = values.iter().fold(0.0f32, |most, value| most.max(*value));
        // Along the tube's circle of 8 edges: r (1 - cos 22.5°).
        assert!((0.008..0.02).contains(&most), "{most}");
        for (at, value) in values.iter().enumerate() {
            let corners = mesh.corners(texels.triangles[at]);
            let triangle = texels.triangles[at];
            // Recomputed by a search for the weights.
            let uv = Vec2::new((at % 128) as f32 + 0.5, (at / 128) as f32 + 0.5) / Vec2::new(128.0, 64.0);
            let [a, b, c] = corners.map(|corner| corner.uv);
            let area = (b - a).perp_dot(c - a);
            let w = [(b - uv).perp_dot(c - uv), (c - uv).perp_dot(a - uv), (a - uv).perp_dot(b - uv)];
            let w = w.map(|part| part / area);
            let [bc, ca, ab] = mesh.lifts()[triangle as usize];
            let expected = bc * w[1] * w[2] + ca * w[2] * w[0] + ab * w[0] * w[1];
            assert!((value - expected).abs() < 1e-6, "{at}: {value} {expected}");
        }
        assert!(sphere(16, 8).expect("a mesh").chart_texels(size).is_ok());
        let flat = chart([[0.2, 0.2], [0.8, 0.2], [0.5, 0.7]]);
        let texels = flat.chart_texels([16, 16]).expect("a chart");
        assert!(texels.lifts_m(&flat).iter().all(|value| *value == 0.0));
    }
}
