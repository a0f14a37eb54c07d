//! Displaced surface: positions and normals of its points.

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::mesh::{BasePoint, Vertex};

use crate::{Directions, Shading, point};

/// Height map with the options of displacement.
#[derive(Clone, Debug)]
pub struct Relief {
    map: HeightMap,
    /// Coarser maps of the same relief, each half as wide and high as the one before.
    coarser: Vec<HeightMap>,
    /// Whether holes of the map count.
    has_holes: bool,
    directions: Directions,
    shading: Shading,
}

/// Base point with its lift and its level of the map.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    pub base: BasePoint,
    /// Height of the smooth base above it in metres.
    pub lift_m: f64,
    /// Level of the map. A fraction mixes two levels.
    pub level: f64,
}

impl SurfacePoint {
    /// Creates a point on level 0, without a lift.
    pub fn new(base: BasePoint) -> Self {
        Self { base, lift_m: 0.0, level: 0.0 }
    }
}

/// Displacement of a point.
#[derive(Clone, Copy, Debug)]
pub struct Displacement {
    /// Displacement in metres.
    pub metres: f64,
    /// Derivatives of the height by `u` and `v`.
    pub slope: [f64; 2],
}

impl Displacement {
    /// Returns the displacement with another length in metres.
    pub fn at_metres(self, metres: f64) -> Self {
        Self { metres, ..self }
    }
}

/// Extent of the map under a triangle.
#[derive(Clone, Copy, Debug)]
pub struct MapExtent {
    /// Least and greatest height.
    pub heights: [f64; 2],
    /// Greatest rise from a texel to the next one, along both axes.
    pub steepest: [f64; 2],
}

/// Frame of the base at a point, for shading: the frames of its corners, interpolated.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Normal, of any length.
    pub normal: DVec3,
    /// Derivatives of the position by `u` and `v`.
    pub tangents: [DVec3; 2],
    /// Derivatives of the direction of displacement by `u` and `v`.
    pub turns: [DVec3; 2],
}

impl Frame {
    /// Returns the frame at barycentric weights of a triangle.
    #[inline(always)]
    pub fn weighted([a, b, c]: &[Self; 3], weights: [f64; 3]) -> Self {
        let sum = |a: DVec3, b: DVec3, c: DVec3| a * weights[0] + b * weights[1] + c * weights[2];
        let of_tangents = |axis: usize| sum(a.tangents[axis], b.tangents[axis], c.tangents[axis]);
        let of_turns = |axis: usize| sum(a.turns[axis], b.turns[axis], c.turns[axis]);
        Self {
            normal: sum(a.normal, b.normal, c.normal),
            tangents: [of_tangents(0), of_tangents(1)],
            turns: [of_turns(0), of_turns(1)],
        }
    }
}

/// Greatest tolerance, as a height of the map. All heights are nearer.
const MOST_TOLERANCE: f64 = 1e6;

/// Returns a unit normal, turned about the axes of a texture. The tangents of the angles are
/// `rises` in metres over the lengths of the tangents: first along `u`, then perpendicular to that.
fn turned(up: DVec3, tangents: [DVec3; 2], rises: [f64; 2], handed: f64) -> DVec3 {
    let level = tangents.map(|tangent| tangent - up * up.dot(tangent));
    let along = level[0].normalize_or_zero();
    let down = along.cross(up) * handed;
    let slopes = [0, 1].map(|axis| rises[axis] / level[axis].length());
    up - along * slopes[0] - down * slopes[1]
}

/// Returns the twist of a cell. Two triangles are off by a quarter of it in their middle.
pub fn twist_of(cell: [f32; 4]) -> f64 {
    let [h00, h10, h01, h11] = cell.map(f64::from);
    (h00 - h10 - h01 + h11).abs()
}

/// Returns the place of texture coordinates in a map, in texels from the centre of the first texel.
fn place_in(map: &HeightMap, uv: DVec2) -> [f64; 2] {
    [uv.x * f64::from(map.width()) - 0.5, uv.y * f64::from(map.height()) - 0.5]
}

/// Returns the height at texture coordinates, and its derivatives by `u` and `v`.
#[inline(always)]
fn height_and_slope_in(map: &HeightMap, uv: DVec2) -> [f64; 3] {
    let (height, [along, down]) = per_tile(map, place_in(map, uv));
    [height, along, down]
}

/// Returns the height at a place, counted from the centre of the first texel, and its derivatives
/// by `u` and `v`.
#[inline(always)]
fn per_tile(map: &HeightMap, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
    let (height, [across, down]) = map.height_and_slope_at_place(x, y);
    (height, [across * f64::from(map.width()), down * f64::from(map.height())])
}

impl Relief {
    pub fn new(map: &HeightMap, directions: Directions, shading: Shading) -> Self {
        Self { map: map.clone(), coarser: Vec::new(), has_holes: false, directions, shading }
    }

    /// Sets whether holes of the map count, if it has any.
    #[must_use]
    pub fn with_holes(self, do_count: bool) -> Self {
        Self { has_holes: do_count && self.map.holes().is_some(), ..self }
    }

    /// Returns whether there are holes that count.
    pub fn has_holes(&self) -> bool {
        self.has_holes
    }

    /// Returns whether the cell at a place, counted from the centre of the first texel, is a hole
    /// that counts.
    pub fn is_hole(&self, [x, y]: [f64; 2]) -> bool {
        self.has_holes && self.map.is_hole(x.floor() as i64, y.floor() as i64)
    }

    /// Adds coarser levels.
    #[must_use]
    pub fn with_levels(self, coarser: &[HeightMap]) -> Self {
        Self { coarser: coarser.to_vec(), ..self }
    }

    /// Returns whether there are coarser levels.
    pub fn has_levels(&self) -> bool {
        !self.coarser.is_empty()
    }

    /// Returns the levels of the height map, the finest first.
    pub fn levels(&self) -> impl Iterator<Item = &HeightMap> {
        std::iter::once(&self.map).chain(&self.coarser)
    }

    /// Returns the numbers of columns and rows of the map.
    pub fn sides(&self) -> [f64; 2] {
        [self.map.width(), self.map.height()].map(f64::from)
    }

    /// Returns a point displaced by the height of its level.
    #[inline(always)]
    pub fn displaced(&self, point: &SurfacePoint) -> DVec3 {
        self.displaced_by(&point.base, self.metres_at(point))
    }

    /// Returns a base point displaced by `metres`.
    #[inline(always)]
    pub fn displaced_by(&self, base: &BasePoint, metres: f64) -> DVec3 {
        BasePoint { normal: self.direction(base.normal), ..*base }.displaced(metres)
    }

    /// Returns the direction in which a point with that normal is displaced.
    #[inline(always)]
    pub fn direction(&self, normal: DVec3) -> DVec3 {
        match self.directions {
            Directions::Raw => normal,
            Directions::Unit | Directions::Angle => normal.normalize_or_zero(),
        }
    }

    /// Returns the kind of directions of displacement.
    pub fn directions(&self) -> Directions {
        self.directions
    }

    /// Returns the directions at the corners of a triangle, if directions between are their
    /// weighted sums.
    pub fn interpolated(&self, normals: [DVec3; 3]) -> Option<[DVec3; 3]> {
        (self.directions == Directions::Raw).then_some(normals)
    }

    /// Returns the distance that one metre of displacement covers along a normal of that length.
    pub fn reach(&self, normal: f64) -> f64 {
        match self.directions {
            Directions::Raw => normal,
            Directions::Unit | Directions::Angle => 1.0,
        }
    }

    /// Returns the height map.
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// Returns the height at a place, where `i + ½` is the centre of texel `i`.
    #[inline(always)]
    pub fn height(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at_place(x - 0.5, y - 0.5)
    }

    /// Returns the height at texture coordinates.
    pub fn height_at_uv(&self, uv: DVec2) -> f64 {
        self.height_at(self.place(uv))
    }

    /// Returns the place of texture coordinates in the map, in texels from the centre of the first
    /// texel.
    pub fn place(&self, uv: DVec2) -> [f64; 2] {
        place_in(&self.map, uv)
    }

    /// Returns the height at a place that is counted from the centre of the first texel.
    pub fn height_at(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at_place(x, y)
    }

    /// Returns a tolerance in metres as a height of the map, for a direction of displacement of
    /// that length.
    pub fn tolerance(&self, error_m: f64, normal: f64) -> f64 {
        (error_m / (self.map.scale_m() * self.reach(normal))).min(MOST_TOLERANCE)
    }

    /// Returns a height of the map in metres, for a direction of displacement of that length. It is
    /// consistent with [`tolerance`](Self::tolerance).
    pub fn height_m(&self, error_m: f64, normal: f64) -> f64 {
        (self.map.scale_m() * self.reach(normal)).max(error_m / MOST_TOLERANCE)
    }

    /// Returns the displacement at height 0 in metres.
    pub fn zero_m(&self) -> f64 {
        self.map.displacement_m(0.0)
    }

    /// Returns the extent of the map in the rectangle around a triangle. Places of the corners are
    /// counted from the centre of the first texel.
    pub fn extent_under(&self, places: [[f64; 2]; 3]) -> MapExtent {
        let range = [0, 1].map(|axis| {
            let all = places.map(|place| place[axis]);
            let least = all.into_iter().fold(f64::INFINITY, f64::min).floor();
            let greatest = all.into_iter().fold(f64::NEG_INFINITY, f64::max).floor() + 1.0;
            // A wider range repeats the whole map; mirrored, twice of it.
            let most = 2.0 * f64::from([self.map.width(), self.map.height()][axis]) + 1.0;
            (least as i64, greatest.min(least + most) as i64)
        });
        let [(from_i, to_i), (from_j, to_j)] = range;
        let mut extent = MapExtent { heights: [f64::INFINITY, f64::NEG_INFINITY], steepest: [0.0; 2] };
        for j in from_j..=to_j {
            for i in from_i..=to_i {
                let [h00, h10, h01, _] = self.map.cell(i, j).map(f64::from);
                extent.heights = [extent.heights[0].min(h00), extent.heights[1].max(h00)];
                let rises = [h10 - h00, h01 - h00];
                extent.steepest = [0, 1].map(|axis| extent.steepest[axis].max(rises[axis].abs()));
            }
        }
        extent
    }

    /// Returns the greatest twist of all cells.
    pub fn greatest_twist(&self) -> f64 {
        let map = &self.map;
        let of_row =
            |j: i64| (-1..i64::from(map.width())).map(|i| twist_of(map.cell(i, j))).fold(0.0, f64::max);
        (-1..i64::from(map.height())).into_par_iter().map(of_row).reduce(|| 0.0, f64::max)
    }

    /// Returns the displacement by a height in metres.
    pub fn metres(&self, height: f64) -> f64 {
        self.map.displacement_m(height)
    }

    #[inline(always)]
    fn metres_at(&self, point: &SurfacePoint) -> f64 {
        let height_in = |map: &HeightMap| {
            let [x, y] = place_in(map, point.base.uv);
            map.height_at_place(x, y)
        };
        let height = if self.has_levels() {
            self.mixed(point.level, |map| [height_in(map)])[0]
        } else {
            height_in(&self.map)
        };
        self.metres(height) + point.lift_m
    }

    /// Returns the displacement of a point.
    #[inline(always)]
    pub fn displacement(&self, point: &SurfacePoint) -> Displacement {
        let uv = point.base.uv;
        let [height, along, down] = if self.has_levels() {
            self.mixed(point.level, |map| height_and_slope_in(map, uv))
        } else {
            height_and_slope_in(&self.map, uv)
        };
        Displacement { metres: self.metres(height) + point.lift_m, slope: [along, down] }
    }

    /// Returns the displacement at a place of a map without coarser levels, where `i + ½` is the
    /// centre of texel `i`.
    #[inline(always)]
    pub fn displacement_at(&self, [x, y]: [f64; 2]) -> Displacement {
        let (height, slope) = per_tile(&self.map, [x - 0.5, y - 0.5]);
        Displacement { metres: self.metres(height), slope }
    }

    /// Returns the values of two levels, mixed, or of the map where there is one level.
    fn mixed<const N: usize>(&self, level: f64, of: impl Fn(&HeightMap) -> [f64; N]) -> [f64; N] {
        let at = |level: usize| level.checked_sub(1).map_or(&self.map, |coarser| &self.coarser[coarser]);
        let level = level.clamp(0.0, self.coarser.len() as f64);
        let part = level.fract();
        let mut mixed = of(at(level as usize));
        if part == 0.0 {
            return mixed;
        }
        let coarse = of(at(level as usize + 1));
        for k in 0..N {
            mixed[k] += (coarse[k] - mixed[k]) * part;
        }
        mixed
    }

    /// Returns the vertex of a base point, displaced and shaded in its frame.
    #[inline(always)]
    pub fn vertex_of(&self, base: &BasePoint, displacement: Displacement, frame: &Frame) -> Vertex {
        self.shaded(self.displaced_by(base, displacement.metres), base, displacement, frame)
    }

    /// Returns the vertex at a position that another side of a seam defines. `point` and `frame`
    /// are its own.
    pub fn vertex_at(&self, position: DVec3, point: &SurfacePoint, frame: &Frame) -> Vertex {
        self.shaded(position, &point.base, self.displacement(point), frame)
    }

    /// Returns the vertex at a position. Its normal is the normal of the displaced surface, its
    /// tangents are the derivatives of the position by `u` and `v`.
    ///
    /// With the displacement `D` along `M` they are `T + D_u M + D M_u`, and likewise for `v`. This
    /// is equation 9 of Szirmay-Kalos and Umenhoffer 2008 without its last simplification, that `M`
    /// does not turn. The shading `derivative` makes that simplification, too, and `rotation` turns
    /// `M` by the slopes alone. With `base` they are the base's. `T` is the base's derivative in the
    /// plane perpendicular to its normal, so that the normal is the base's where there is no relief.
    #[inline(always)]
    fn shaded(&self, position: DVec3, base: &BasePoint, displacement: Displacement, frame: &Frame) -> Vertex {
        let up = frame.normal.normalize_or_zero();
        let scale_m = self.map.scale_m();
        let is_level = matches!(self.shading, Shading::Derivative | Shading::Rotation);
        let metres = if is_level { 0.0 } else { displacement.metres };
        let length = if self.directions == Directions::Raw { 0.0 } else { base.normal.length() };
        let derivative = |axis: usize| {
            let flat = frame.tangents[axis] - up * up.dot(frame.tangents[axis]);
            if self.shading == Shading::Base {
                return flat;
            }
            let rise = scale_m * displacement.slope[axis];
            let (mut direction, mut turn) = (base.normal, frame.turns[axis]);
            if length > 0.0 {
                direction /= length;
                turn = (turn - direction * direction.dot(turn)) / length;
            }
            flat + rise * direction + metres * turn
        };
        let [along, down] = [derivative(0), derivative(1)];
        let is_mirrored = frame.tangents[1].cross(frame.tangents[0]).dot(up) < 0.0;
        let handed = if is_mirrored { -1.0 } else { 1.0 };
        let normal = if self.shading == Shading::Base {
            up
        } else if self.shading == Shading::Rotation {
            let rises = displacement.slope.map(|slope| scale_m * slope);
            turned(up, frame.tangents, rises, handed)
        } else {
            down.cross(along) * handed
        };
        Vertex {
            position: point::stored(position),
            normal: normal.try_normalize().unwrap_or(up).as_vec3(),
            tangent: along.as_vec3(),
            bitangent: down.as_vec3(),
            uv: base.uv.as_vec2(),
        }
    }
}
