//! The displaced surface: where points go, and which normals they have.

use glam::DVec3;
use relief_core::HeightMap;
use relief_core::mesh::{BasePoint, Vertex};

use crate::{Directions, Shading, point};

/// A height map as it displaces.
#[derive(Clone, Debug)]
pub struct Relief {
    map: HeightMap,
    directions: Directions,
    shading: Shading,
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

impl Relief {
    pub fn new(map: &HeightMap, directions: Directions, shading: Shading) -> Self {
        Self { map: map.clone(), directions, shading }
    }

    /// Columns and rows of the map.
    pub fn sides(&self) -> [f64; 2] {
        [self.map.width(), self.map.height()].map(f64::from)
    }

    /// The place of texture coordinates in the map, counted in texels from the centre of the first one.
    pub fn place(&self, uv: [f64; 2]) -> [f64; 2] {
        let sides = self.sides();
        [0, 1].map(|axis| uv[axis] * sides[axis] - 0.5)
    }

    /// A base point displaced by the height at a place, and so many metres more.
    pub fn displaced(&self, base: &BasePoint, place: [f64; 2], more_m: f64) -> DVec3 {
        self.displaced_by(base, self.metres_at(place, more_m))
    }

    /// A base point displaced by so many metres.
    pub fn displaced_by(&self, base: &BasePoint, metres: f64) -> DVec3 {
        let normal = match self.directions {
            Directions::Raw => base.normal,
            Directions::Unit => base.normal.normalize_or_zero(),
        };
        BasePoint { normal, ..*base }.displaced(metres)
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

    /// The displacement by a height, in metres.
    pub fn metres(&self, height: f64) -> f64 {
        self.map.displacement_m(height)
    }

    fn metres_at(&self, [x, y]: [f64; 2], more_m: f64) -> f64 {
        self.metres(self.map.height_at_place(x, y)) + more_m
    }

    /// The vertex at a position whose base point, place on the map and frame those are: its normal is that of
    /// the displaced surface, its tangents are the derivatives of the position by `u` and `v`.
    ///
    /// With the displacement `D` along `M` they are `T + D_u M + D M_u`, and the same for `v`: equation 9 of
    /// Szirmay-Kalos and Umenhoffer 2008 without its last simplification, that `M` does not turn; the shading
    /// `derivative` has that, too. `T` is the base's derivative in the plane at right angles to its normal,
    /// so that where there is no relief the normal is the base's.
    pub fn vertex(
        &self,
        position: DVec3,
        base: &BasePoint,
        place: [f64; 2],
        frame: &Frame,
        more_m: f64,
    ) -> Vertex {
        let up = frame.normal.normalize_or_zero();
        let [x, y] = place;
        let (slope, sides, scale_m) = (self.map.slope_at_place(x, y), self.sides(), self.map.scale_m());
        let metres = if self.shading == Shading::Derivative { 0.0 } else { self.metres_at(place, more_m) };
        let length = base.normal.length();
        let derivative = |axis: usize| {
            let flat = frame.tangents[axis] - up * up.dot(frame.tangents[axis]);
            let rise = scale_m * slope[axis] * sides[axis];
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
