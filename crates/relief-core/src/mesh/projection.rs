//! Generated texture coordinates for meshes without them.

use super::cube::FACES;
use super::raw::{FramingError, RawCorner, RawMesh};
use crate::registry::UnknownName;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};
use std::fmt;
use std::str::FromStr;

/// Distance to an axis, relative to the distance along it, below which directions around it are
/// meaningless.
const ON_AXIS: f64 = 1e-6;

/// Method of generating texture coordinates. Each is centred on the mesh's bounding box, and lays a
/// texture as on the built-in shape with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UvProjection {
    /// From the six sides of a box. Each triangle is projected from the side that it faces most. A
    /// tile is as long as the longest side of the bounding box.
    Box,
    /// Around the `y` axis: `u` runs once around, with `½` at `+z`; `v` runs from the top to the
    /// bottom. Triangles that face up or down by more than 45° are projected from above or below,
    /// with a tile as long as the wider side.
    Cylinder,
    /// Like a map of the world: `u` runs once around the `y` axis, with `½` at `+z`; `v` runs from
    /// the north pole `+y` to the south pole.
    Sphere,
}

impl UvProjection {
    /// All projections, in the order of the help.
    pub const ALL: [UvProjection; 3] = [UvProjection::Box, UvProjection::Cylinder, UvProjection::Sphere];

    /// Returns the name of this projection, as scenes spell it: `box`, `cylinder` or `sphere`.
    pub const fn name(self) -> &'static str {
        match self {
            UvProjection::Box => "box",
            UvProjection::Cylinder => "cylinder",
            UvProjection::Sphere => "sphere",
        }
    }
}

impl fmt::Display for UvProjection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for UvProjection {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|projection| projection.name() == name);
        found.ok_or_else(|| {
            UnknownName::new("projection of texture coordinates", name, Self::ALL.map(Self::name))
        })
    }
}

/// Middle and side lengths of a mesh's bounding box.
struct Bounds {
    middle: DVec3,
    sides: DVec3,
}

impl RawMesh {
    /// Replaces the texture coordinates with generated ones. At the cut of a projection, as at the
    /// back of a sphere, coordinates go beyond 0 and 1, so that maps must repeat along `u`.
    ///
    /// # Errors
    ///
    /// As [`framed`](Self::framed), except for errors of texture coordinates.
    pub fn projected(mut self, projection: UvProjection) -> Result<Self, FramingError> {
        self.uvs.clear();
        self.triangles.iter_mut().flatten().for_each(|corner| corner.uv = RawCorner::NONE);
        self.check()?;
        let bounds = self.bounds();
        let mut uvs = Vec::with_capacity(3 * self.triangles.len());
        for corners in &self.triangles {
            let from_middle =
                corners.map(|corner| self.positions[corner.position as usize].as_dvec3() - bounds.middle);
            let normal = self.cross(corners).normalize_or_zero();
            let projected = match projection {
                UvProjection::Box => from_side(side_of(normal), from_middle, bounds.sides.max_element()),
                UvProjection::Cylinder => on_cylinder(normal, from_middle, &bounds),
                UvProjection::Sphere => on_sphere(from_middle),
            };
            uvs.extend(projected.map(|uv| uv.as_vec2()));
        }
        for (number, corner) in self.triangles.iter_mut().flatten().enumerate() {
            corner.uv = number as u32;
        }
        self.uvs = uvs;
        Ok(self)
    }

    fn bounds(&self) -> Bounds {
        let used =
            self.triangles.iter().flatten().map(|corner| self.positions[corner.position as usize].as_dvec3());
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (least, most) = used.fold(nothing, |(least, most), at| (least.min(at), most.max(at)));
        if least.x > most.x {
            return Bounds { middle: DVec3::ZERO, sides: DVec3::ZERO };
        }
        Bounds { middle: 0.5 * (least + most), sides: most - least }
    }
}

/// Directions of `u` and `v` on the side of a box that a normal points at. Ties go to the first
/// side.
fn side_of(normal: DVec3) -> (DVec3, DVec3) {
    let mut best = (f64::NEG_INFINITY, FACES[0]);
    for (du, dv) in FACES {
        let towards = dv.cross(du).dot(normal);
        if towards > best.0 {
            best = (towards, (du, dv));
        }
    }
    best.1
}

fn from_side((du, dv): (DVec3, DVec3), from_middle: [DVec3; 3], tile_m: f64) -> [DVec2; 3] {
    let tile_m = if tile_m > 0.0 { tile_m } else { 1.0 };
    from_middle.map(|at| DVec2::new(at.dot(du), at.dot(dv)) / tile_m + 0.5)
}

fn on_cylinder(normal: DVec3, from_middle: [DVec3; 3], bounds: &Bounds) -> [DVec2; 3] {
    let height = bounds.sides.y;
    if normal.y.abs() > FRAC_1_SQRT_2 || height <= 0.0 {
        let side = side_of(if normal.y < 0.0 { DVec3::NEG_Y } else { DVec3::Y });
        return from_side(side, from_middle, bounds.sides.x.max(bounds.sides.z));
    }
    let around = turns(from_middle);
    [0, 1, 2].map(|place| DVec2::new(around[place], 0.5 - from_middle[place].y / height))
}

fn on_sphere(from_middle: [DVec3; 3]) -> [DVec2; 3] {
    let around = turns(from_middle);
    [0, 1, 2].map(|place| {
        let at = from_middle[place];
        DVec2::new(around[place], at.x.hypot(at.z).atan2(at.y) / PI)
    })
}

/// Turns around the `y` axis from `-z` over `+z`, for three corners without a jump between them. A
/// corner on the axis gets the mean of the others.
fn turns(from_middle: [DVec3; 3]) -> [f64; 3] {
    let turn = |at: DVec3| at.x.atan2(at.z) / TAU + 0.5;
    let is_on_axis = |at: DVec3| at.x.hypot(at.z) <= ON_AXIS * at.length();
    let centre = turn(from_middle[0] + from_middle[1] + from_middle[2]);
    let near_centre = from_middle.map(|at| {
        let own = turn(at);
        (!is_on_axis(at)).then(|| own + (centre - own).round())
    });
    let others: Vec<f64> = near_centre.into_iter().flatten().collect();
    let mean = if others.is_empty() { centre } else { others.iter().sum::<f64>() / others.len() as f64 };
    near_centre.map(|turn| turn.unwrap_or(mean))
}
