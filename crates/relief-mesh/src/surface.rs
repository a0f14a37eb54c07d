//! The displaced surface: where points go, and which normals they have.

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::mesh::{BasePoint, Vertex};

use crate::{Directions, Shading, point};

/// A height map as it displaces.
#[derive(Clone, Debug)]
pub struct Relief {
    map: HeightMap,
    /// Coarser ones of the same relief, each half as wide and high as the one before.
    coarser: Vec<HeightMap>,
    directions: Directions,
    shading: Shading,
}

/// A base point as it is displaced.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    pub base: BasePoint,
    /// The metres that the smooth base lies above it.
    pub lift_m: f64,
    /// The level of the map that is seen there; what lies between two of them is in between.
    pub level: f64,
}

impl Placed {
    /// A point where the map itself is seen.
    pub fn new(base: BasePoint) -> Self {
        Self { base, lift_m: 0.0, level: 0.0 }
    }
}

/// The base's frame at a point, to shade it by: numbers of its corners, interpolated.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// The normal, of any length.
    pub normal: DVec3,
    /// The derivatives of the position by `u` and `v`.
    pub tangents: [DVec3; 2],
    /// The derivatives of the direction of displacement by `u` and `v`.
    pub turns: [DVec3; 2],
}

impl Frame {
    /// The frame at the barycentric weights of a triangle.
    pub fn weighted(corners: [Self; 3], weights: [f64; 3]) -> Self {
        let sum = |of: &dyn Fn(&Self) -> DVec3| {
            let [a, b, c] = [0, 1, 2].map(|k| of(&corners[k]) * weights[k]);
            a + b + c
        };
        Self {
            normal: sum(&|frame| frame.normal),
            tangents: [0, 1].map(|axis| sum(&|frame| frame.tangents[axis])),
            turns: [0, 1].map(|axis| sum(&|frame| frame.turns[axis])),
        }
    }
}

/// The greatest tolerance, as a height of the map: all heights are nearer.
const MOST_TOLERANCE: f64 = 1e6;

/// How much a cell is twisted: two triangles lie off by a quarter of it in their middle.
pub fn twist_of(cell: [f32; 4]) -> f64 {
    let [h00, h10, h01, h11] = cell.map(f64::from);
    (h00 - h10 - h01 + h11).abs()
}

/// The place of texture coordinates in a map, counted in texels from the centre of the first one.
fn place_in(map: &HeightMap, uv: DVec2) -> [f64; 2] {
    [uv.x * f64::from(map.width()) - 0.5, uv.y * f64::from(map.height()) - 0.5]
}

impl Relief {
    pub fn new(map: &HeightMap, directions: Directions, shading: Shading) -> Self {
        Self { map: map.clone(), coarser: Vec::new(), directions, shading }
    }

    /// The same with coarser levels.
    #[must_use]
    pub fn with_levels(self, coarser: &[HeightMap]) -> Self {
        Self { coarser: coarser.to_vec(), ..self }
    }

    /// Whether there are coarser levels.
    pub fn has_levels(&self) -> bool {
        !self.coarser.is_empty()
    }

    /// The levels of the height map, from the finest on.
    pub fn levels(&self) -> impl Iterator<Item = &HeightMap> {
        std::iter::once(&self.map).chain(&self.coarser)
    }

    /// Columns and rows of the map.
    pub fn sides(&self) -> [f64; 2] {
        [self.map.width(), self.map.height()].map(f64::from)
    }

    /// A base point displaced by the height that is seen there.
    pub fn displaced(&self, placed: &Placed) -> DVec3 {
        self.displaced_by(&placed.base, self.metres_at(placed))
    }

    /// A base point displaced by so many metres.
    pub fn displaced_by(&self, base: &BasePoint, metres: f64) -> DVec3 {
        BasePoint { normal: self.direction(base.normal), ..*base }.displaced(metres)
    }

    /// Along what a point with that normal is displaced.
    pub fn direction(&self, normal: DVec3) -> DVec3 {
        match self.directions {
            Directions::Raw => normal,
            Directions::Unit => normal.normalize_or_zero(),
        }
    }

    /// The directions at the corners of a triangle, where those between are sums of them by their weights.
    pub fn interpolated(&self, normals: [DVec3; 3]) -> Option<[DVec3; 3]> {
        (self.directions == Directions::Raw).then_some(normals)
    }

    /// How far one metre of displacement goes along a normal of that length.
    pub fn reach(&self, normal: f64) -> f64 {
        match self.directions {
            Directions::Raw => normal,
            Directions::Unit => 1.0,
        }
    }

    /// The height map.
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// The height at a place where `i + ½` is the centre of texel `i`.
    pub fn height(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at_place(x - 0.5, y - 0.5)
    }

    /// The height at texture coordinates.
    pub fn height_at_uv(&self, uv: DVec2) -> f64 {
        self.height_at(self.place(uv))
    }

    /// The place of texture coordinates in the map, counted in texels from the centre of the first one.
    pub fn place(&self, uv: DVec2) -> [f64; 2] {
        place_in(&self.map, uv)
    }

    /// The height at a place that is counted so.
    pub fn height_at(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at_place(x, y)
    }

    /// A tolerance in metres as a height of the map, where a direction of displacement has that length.
    pub fn tolerance(&self, error_m: f64, normal: f64) -> f64 {
        (error_m / (self.map.scale_m() * self.reach(normal))).min(MOST_TOLERANCE)
    }

    /// The greatest twist of all cells.
    pub fn greatest_twist(&self) -> f64 {
        let map = &self.map;
        let of_row =
            |j: i64| (-1..i64::from(map.width())).map(|i| twist_of(map.cell(i, j))).fold(0.0, f64::max);
        (-1..i64::from(map.height())).into_par_iter().map(of_row).reduce(|| 0.0, f64::max)
    }

    /// A point as it lies at a height of the map.
    pub fn at_height(&self, placed: &Placed, height: f64) -> Placed {
        let own = self.metres(self.height_at_uv(placed.base.uv));
        Placed { lift_m: self.metres(height) - own, level: 0.0, ..*placed }
    }

    /// The displacement by a height, in metres.
    pub fn metres(&self, height: f64) -> f64 {
        self.map.displacement_m(height)
    }

    fn metres_at(&self, placed: &Placed) -> f64 {
        let height = self.mixed(placed.level, |map| {
            let [x, y] = place_in(map, placed.base.uv);
            [map.height_at_place(x, y); 2]
        });
        self.metres(height[0]) + placed.lift_m
    }

    /// The derivatives of the height by `u` and `v`.
    fn slope(&self, placed: &Placed) -> [f64; 2] {
        self.mixed(placed.level, |map| {
            let [x, y] = place_in(map, placed.base.uv);
            let [across, down] = map.slope_at_place(x, y);
            [across * f64::from(map.width()), down * f64::from(map.height())]
        })
    }

    /// What two levels say, mixed.
    fn mixed(&self, level: f64, of: impl Fn(&HeightMap) -> [f64; 2]) -> [f64; 2] {
        let at = |level: usize| level.checked_sub(1).map_or(&self.map, |coarser| &self.coarser[coarser]);
        let level = level.clamp(0.0, self.coarser.len() as f64);
        let part = level.fract();
        let fine = of(at(level as usize));
        if part == 0.0 {
            return fine;
        }
        let coarse = of(at(level as usize + 1));
        [0, 1].map(|k| fine[k] + (coarse[k] - fine[k]) * part)
    }

    /// The vertex at a position whose base point and frame those are: its normal is that of the displaced
    /// surface, its tangents are the derivatives of the position by `u` and `v`.
    ///
    /// With the displacement `D` along `M` they are `T + D_u M + D M_u`, and the same for `v`: equation 9 of
    /// Szirmay-Kalos and Umenhoffer 2008 without its last simplification, that `M` does not turn; the shading
    /// `derivative` has that, too. `T` is the base's derivative in the plane at right angles to its normal,
    /// so that where there is no relief the normal is the base's.
    pub fn vertex(&self, position: DVec3, placed: &Placed, frame: &Frame) -> Vertex {
        let up = frame.normal.normalize_or_zero();
        let base = &placed.base;
        let (slope, scale_m) = (self.slope(placed), self.map.scale_m());
        let metres = if self.shading == Shading::Derivative { 0.0 } else { self.metres_at(placed) };
        let length = base.normal.length();
        let derivative = |axis: usize| {
            let flat = frame.tangents[axis] - up * up.dot(frame.tangents[axis]);
            let rise = scale_m * slope[axis];
            let (direction, turn) = match self.directions {
                Directions::Unit if length > 0.0 => {
                    let direction = base.normal / length;
                    let turn = frame.turns[axis];
                    (direction, (turn - direction * direction.dot(turn)) / length)
                }
                _ => (base.normal, frame.turns[axis]),
            };
            flat + rise * direction + metres * turn
        };
        let [along, down] = [derivative(0), derivative(1)];
        let is_mirrored = frame.tangents[1].cross(frame.tangents[0]).dot(up) < 0.0;
        let normal = down.cross(along) * if is_mirrored { -1.0 } else { 1.0 };
        Vertex {
            position: point::stored(position),
            normal: normal.try_normalize().unwrap_or(up).as_vec3(),
            tangent: along.as_vec3(),
            bitangent: down.as_vec3(),
            uv: base.uv.as_vec2(),
        }
    }
}
