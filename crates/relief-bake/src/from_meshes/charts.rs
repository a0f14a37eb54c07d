//! The triangle of the simple mesh on which, or beside which, each texel lies.
//!
//! Lengths here are in texels: the centre of texel `(i, j)` lies at `(i, j)`, as whole numbers.
//! Every triangle is moved by whole tiles so that it begins near the map. It reaches beyond the
//! map's edges as its texture coordinates do; the wrap says which texels lie there.

use relief_core::mesh::{BasePoint, Mesh};
use relief_core::{Watch, Wrap};

use super::{FromMeshesError, MAX_TILES, MeshPair};

/// Tolerance in tiles for texture coordinates outside of a clamped map: rounding.
const OUTSIDE: f64 = 1e-5;

/// Greatest distance from a triangle of texels that are read where the surface on it is
/// interpolated.
const REACH: f64 = std::f64::consts::SQRT_2;

/// Nearer than this a texel lies on the triangle: rounding.
const ON: f64 = 1e-9;

/// Least weight of a corner inside of a triangle, not at its border.
const WITHIN: f64 = 1e-6;

/// Positions closer than this part of the mesh's diagonal are the same.
const SAME: f64 = 1e-5;

/// Size in texels of the triangle through whose corners a plane is continued beside a chart.
const PLANE: f64 = 0.5;

/// Distance inside of a chart, in texels, at which its border is sampled. At the border itself a
/// line may pass beside a mesh that ends there.
pub(super) const OFF_BORDER: f64 = 1.0 / 64.0;

/// Greatest weight of a height in a continued plane. With more, a sliver of a triangle says
/// nothing.
const MAX_WEIGHT: f64 = 8.0;

/// No triangle.
const NONE: u32 = u32::MAX;

/// The triangle of a texel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Owner {
    pub triangle: u32,
    /// Column and row of the texel where the triangle lies, not wrapped.
    at: [i32; 2],
    /// Distance from the triangle in texels, 0 on it.
    pub distance: f32,
}

/// Parts of a map that the simple mesh covers.
pub(super) struct Charts {
    pub size: [u32; 2],
    /// Row by row from the top.
    pub owners: Vec<Owner>,
    /// Texels on several triangles at different places.
    pub overlaps: u64,
    /// Triangles without an area in the texture.
    pub without_area: u64,
    wrap: Wrap,
}

/// A triangle in the texture.
struct Chart {
    corners: [[f64; 2]; 3],
    /// Twice the area, with the sign of its turn.
    area: f64,
}

impl Owner {
    const NOBODY: Self = Self { triangle: NONE, at: [0; 2], distance: f32::INFINITY };

    /// Returns the owner, if the texel has a triangle.
    pub fn on(&self) -> Option<&Self> {
        (self.triangle != NONE).then_some(self)
    }

    pub fn is_inside(&self) -> bool {
        self.distance == 0.0
    }

    /// Returns the point `beyond` texels behind a point of the border, on the way from the texel's
    /// centre.
    pub fn inside(&self, border: [f64; 2], beyond: f64) -> [f64; 2] {
        let way = minus(border, self.centre());
        let length = way[0].hypot(way[1]);
        [0, 1].map(|axis| border[axis] + way[axis] / length * beyond)
    }

    /// The centre of the texel where the triangle lies.
    pub fn centre(&self) -> [f64; 2] {
        self.at.map(f64::from)
    }
}

impl Charts {
    pub fn new(
        mesh: &Mesh,
        pair: &MeshPair,
        diagonal_m: f64,
        watch: &Watch,
    ) -> Result<Self, FromMeshesError> {
        let [width, height] = pair.size;
        let texels = width as usize * height as usize;
        let owners = vec![Owner::NOBODY; texels];
        let mut charts = Self { size: pair.size, owners, overlaps: 0, without_area: 0, wrap: pair.wrap };
        let mut is_overlap = vec![false; texels];
        let count = mesh.triangles().len() as u32;
        let same_m = SAME * diagonal_m;
        for triangle in 0..count {
            check(mesh, triangle, pair.wrap)?;
            let Some(chart) = charts.chart(mesh, triangle) else {
                charts.without_area += 1;
                continue;
            };
            let [columns, rows] = [0, 1].map(|axis| chart.span(axis));
            for row in rows[0]..=rows[1] {
                if row % 64 == 0 || row == rows[0] && triangle % 1024 == 0 {
                    watch.at(triangle as f32 / count as f32)?;
                }
                for column in columns[0]..=columns[1] {
                    let Some(at) = charts.texel([column, row]) else { continue };
                    let point = [column, row].map(f64::from);
                    let distance = chart.distance(point);
                    let owner = charts.owners[at];
                    if distance == 0.0 && owner.is_inside() {
                        let is_within = chart.weights(point).iter().all(|weight| *weight > WITHIN);
                        if is_within && !is_overlap[at] {
                            let [here, there] = [
                                charts.base(mesh, triangle, point),
                                charts.base(mesh, owner.triangle, owner.centre()),
                            ];
                            is_overlap[at] = (here.position - there.position).length() > same_m;
                        }
                    } else if distance < f64::from(owner.distance) {
                        let distance = distance as f32;
                        charts.owners[at] = Owner { triangle, at: [column, row], distance };
                    }
                }
            }
        }
        if !charts.owners.iter().any(Owner::is_inside) {
            return Err(FromMeshesError::NoTexel);
        }
        charts.overlaps = is_overlap.iter().filter(|is_overlap| **is_overlap).count() as u64;
        Ok(charts)
    }

    /// Returns a triangle where it lies on the map; none without an area.
    fn chart(&self, mesh: &Mesh, triangle: u32) -> Option<Chart> {
        let uvs = mesh.corners(triangle).map(|corner| corner.uv.as_dvec2().to_array());
        let corners = [0, 1].map(|axis| {
            let along = uvs.map(|uv| uv[axis]);
            let first = along.iter().copied().fold(f64::INFINITY, f64::min);
            // Mirrored tiles repeat by two.
            let moved = if self.wrap == Wrap::Clamp { 0.0 } else { 2.0 * (0.5 * first).floor() };
            along.map(|at| (at - moved) * f64::from(self.size[axis]) - 0.5)
        });
        let corners = [0, 1, 2].map(|corner| [corners[0][corner], corners[1][corner]]);
        let [a, b, c] = corners;
        let area = cross(minus(b, a), minus(c, a));
        (area.abs() > 1e-12).then_some(Chart { corners, area })
    }

    /// Returns the index of a texel whose column and row are not wrapped; none outside of a clamped
    /// map.
    fn texel(&self, at: [i32; 2]) -> Option<usize> {
        let is_in = |axis: usize| (0..i64::from(self.size[axis])).contains(&i64::from(at[axis]));
        if self.wrap == Wrap::Clamp && !(is_in(0) && is_in(1)) {
            return None;
        }
        let [column, row] = [0, 1].map(|axis| self.wrap.index(i64::from(at[axis]), self.size[axis]));
        Some(row as usize * self.size[0] as usize + column as usize)
    }

    /// Returns the index of the texel `by` columns and rows beside another, with the map's wrap.
    pub fn beside(&self, at: usize, by: [i64; 2]) -> usize {
        let width = self.size[0] as usize;
        let [column, row] = [at % width, at / width].map(|at| at as i64);
        let [column, row] =
            [self.wrap.index(column + by[0], self.size[0]), self.wrap.index(row + by[1], self.size[1])];
        row as usize * width + column as usize
    }

    /// Returns the base point of a triangle at a place on the map, which may lie beside the
    /// triangle.
    pub fn base(&self, mesh: &Mesh, triangle: u32, point: [f64; 2]) -> BasePoint {
        let weights = self.weights(mesh, triangle, point);
        BasePoint::weighted(mesh.corners(triangle).map(BasePoint::from), weights)
    }

    /// Returns the weights of a triangle's corners at a place on the map.
    pub fn weights(&self, mesh: &Mesh, triangle: u32, point: [f64; 2]) -> [f64; 3] {
        self.chart(mesh, triangle).map_or([1.0, 0.0, 0.0], |chart| chart.weights(point))
    }

    /// Returns the point of an owner's triangle that is nearest to the texel's centre.
    pub fn nearest(&self, mesh: &Mesh, owner: &Owner) -> [f64; 2] {
        let chart = self.chart(mesh, owner.triangle);
        chart.map_or(owner.centre(), |chart| chart.nearest(owner.centre()))
    }

    /// Returns three points inside of an owner's triangle near a point of its border. With them
    /// come the weights with which a plane through them continues to the texel's centre. None where
    /// the triangle is a sliver.
    pub fn around(&self, mesh: &Mesh, owner: &Owner, border: [f64; 2]) -> Option<([[f64; 2]; 3], [f64; 3])> {
        let chart = self.chart(mesh, owner.triangle)?;
        let middle = [0, 1].map(|axis| chart.corners.iter().map(|corner| corner[axis]).sum::<f64>() / 3.0);
        let toward = |from: [f64; 2], to: [f64; 2], length: f64| {
            let way = minus(to, from);
            let part = (length / way[0].hypot(way[1])).min(0.5);
            [from[0] + part * way[0], from[1] + part * way[1]]
        };
        let start = toward(border, middle, OFF_BORDER);
        let corners = chart.corners.map(|corner| toward(start, corner, PLANE));
        let area = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
        let weights = Chart { corners, area }.weights(owner.centre());
        let is_sound = weights.iter().all(|weight| weight.abs() <= MAX_WEIGHT);
        is_sound.then_some((corners, weights))
    }

    /// Returns the base point at a place near a texel. The place lies on the owner's triangle, or
    /// on one that owns a texel around that place.
    pub fn base_at(&self, mesh: &Mesh, owner: &Owner, point: [f64; 2]) -> Option<BasePoint> {
        let holds = |triangle: u32, point: [f64; 2]| {
            self.chart(mesh, triangle).is_some_and(|chart| chart.distance(point) == 0.0)
        };
        if holds(owner.triangle, point) {
            return Some(self.base(mesh, owner.triangle, point));
        }
        let [column, row] = point.map(|at| at.floor() as i32);
        [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().find_map(|[right, down]| {
            let texel = [column + right, row + down];
            let other = self.owners[self.texel(texel)?].on()?;
            // The triangle may lie in another tile; a mirrored tile is not searched.
            let moved = [0, 1].map(|axis| other.centre()[axis] + point[axis] - f64::from(texel[axis]));
            let period = if self.wrap == Wrap::Mirror { 2 } else { 1 };
            let is_whole = [0, 1].iter().all(|&axis| {
                let moved = i64::from(other.at[axis]) - i64::from(texel[axis]);
                moved % (period * i64::from(self.size[axis])) == 0
            });
            (is_whole && holds(other.triangle, moved)).then(|| self.base(mesh, other.triangle, moved))
        })
    }
}

/// Refuses texture coordinates outside of a clamped map, and triangles over too many tiles.
fn check(mesh: &Mesh, triangle: u32, wrap: Wrap) -> Result<(), FromMeshesError> {
    let uvs = mesh.corners(triangle).map(|corner| corner.uv.as_dvec2().to_array());
    for axis in 0..2 {
        let [low, high] = uvs.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], uv| {
            [low.min(uv[axis]), high.max(uv[axis])]
        });
        if wrap == Wrap::Clamp && !(low >= -OUTSIDE && high <= 1.0 + OUTSIDE) {
            return Err(FromMeshesError::Outside { triangle });
        }
        if high - low > f64::from(MAX_TILES) {
            return Err(FromMeshesError::Tiled { triangle, tiles: (high - low).ceil() });
        }
    }
    Ok(())
}

impl Chart {
    /// Returns the first and the last texel along an axis that may lie near.
    fn span(&self, axis: usize) -> [i32; 2] {
        let along = self.corners.map(|corner| corner[axis]);
        let low = along.iter().copied().fold(f64::INFINITY, f64::min);
        let high = along.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        [(low - REACH).ceil() as i32, (high + REACH).floor() as i32]
    }

    /// Returns the weights of the corners at a place.
    fn weights(&self, point: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.corners;
        let wb = cross(minus(point, a), minus(c, a)) / self.area;
        let wc = cross(minus(b, a), minus(point, a)) / self.area;
        [1.0 - wb - wc, wb, wc]
    }

    /// Distance of a place from the triangle, 0 on it; infinite beyond reach.
    fn distance(&self, point: [f64; 2]) -> f64 {
        if self.weights(point).iter().all(|weight| *weight >= 0.0) {
            return 0.0;
        }
        let away = minus(self.nearest(point), point);
        match away[0].hypot(away[1]) {
            distance if distance < ON => 0.0,
            distance if distance < REACH => distance,
            _ => f64::INFINITY,
        }
    }

    /// The nearest point of the border.
    fn nearest(&self, point: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = self.corners;
        let mut best = (f64::INFINITY, a);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let (along, towards) = (minus(to, from), minus(point, from));
            let square = along[0] * along[0] + along[1] * along[1];
            let dot = towards[0] * along[0] + towards[1] * along[1];
            let part = if square > 0.0 { (dot / square).clamp(0.0, 1.0) } else { 0.0 };
            let at = [from[0] + part * along[0], from[1] + part * along[1]];
            let away = minus(at, point);
            let distance = away[0].hypot(away[1]);
            if distance < best.0 {
                best = (distance, at);
            }
        }
        best.1
    }
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
