//! Planes: rectangles with straight texture, cut along the lines of texels.

mod adapted;
mod grid;
mod solid;
mod span;

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Mesh, Vertex};

pub use adapted::Adapted;
pub use grid::{Grid, Tile};
pub use solid::{BorderPoint, Faces, Solid};

use crate::error::MOST;
use crate::mesher::Bottom;
use crate::surface::{Displacement, Frame, Relief};
use crate::{MesherError, Part, point};

/// Texels of a tile along a side.
const TILE: f64 = 128.0;

/// Greatest deviation of the corners from a rectangle, as a part of its sides.
const ROUNDING: f64 = 1e-5;

/// Rectangle made of two triangles.
#[derive(Debug)]
pub struct Rectangle {
    corner: DVec3,
    /// Derivatives of the position by `u` and `v`.
    tangents: [DVec3; 2],
    normal: DVec3,
    /// Texture coordinates of the corner, and of the opposite corner.
    uvs: [DVec2; 2],
    /// Whether triangles are turned over, as seen along growing `u` and `v`.
    pub is_turned: bool,
}

impl Rectangle {
    /// Returns the rectangle of a mesh, if it is two triangles that make one, with straight
    /// texture.
    pub fn of_mesh(mesh: &Mesh) -> Option<Self> {
        let [first, second] = mesh.triangles() else { return None };
        let vertex = |at: &u32| &mesh.vertices()[*at as usize];
        let corners: Vec<&Vertex> = first.iter().chain(second).map(vertex).collect();
        let normal = corners[0].normal;
        let uvs = corners.iter().map(|corner| corner.uv.as_dvec2());
        let [from, to] = uvs.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[least, greatest], uv| {
            [least.min(uv), greatest.max(uv)]
        });
        let at = |u: f64, v: f64| {
            let mut there = corners.iter().filter(|corner| corner.uv.as_dvec2() == DVec2::new(u, v));
            let position = there.next()?.position;
            there.all(|corner| corner.position == position).then_some(position.as_dvec3())
        };
        let [corner, right, below, across] =
            [at(from.x, from.y)?, at(to.x, from.y)?, at(from.x, to.y)?, at(to.x, to.y)?];
        let sides = [right - corner, below - corner];
        let size = sides[0].length() + sides[1].length();
        let up = sides[1].cross(sides[0]);
        let is_straight = (corner + sides[0] + sides[1] - across).length() <= ROUNDING * size
            && sides[0].dot(sides[1]).abs() <= ROUNDING * sides[0].length() * sides[1].length()
            && corners.iter().all(|corner| corner.normal == normal)
            && up.normalize_or_zero().cross(normal.as_dvec3()).length() <= ROUNDING;
        // As seen along growing u and v a triangle turns one way or the other; both must turn the
        // same way.
        let turn = |corners: &[&Vertex]| {
            let [a, b, c] = [0, 1, 2].map(|k| corners[k].uv.as_dvec2());
            (b - a).perp_dot(c - a)
        };
        let turns = [turn(&corners[..3]), turn(&corners[3..])];
        let area = (to - from).x * (to - from).y;
        // The corner that a half lacks is its own corner, turned around the middle.
        let left_out = |half: &[&Vertex]| {
            let sum: DVec2 = half.iter().map(|corner| corner.uv.as_dvec2()).sum();
            2.0 * (from + to) - sum
        };
        let is_whole = turns[0] * turns[1] > 0.0
            && turns.iter().all(|turn| turn.abs() == area)
            && left_out(&corners[..3]) + left_out(&corners[3..]) == from + to;
        (is_straight && is_whole && up != DVec3::ZERO).then(|| Self {
            corner,
            tangents: [sides[0] / (to - from).x, sides[1] / (to - from).y],
            normal: normal.as_dvec3(),
            uvs: [from, to],
            is_turned: turns[0] > 0.0,
        })
    }

    /// Returns the length of the direction of displacement.
    pub fn reach(&self) -> f64 {
        self.normal.length()
    }

    /// Returns the range of a part along `u` and `v` in texels: `i + ½` is the centre of texel `i`.
    /// Parts meet at centres.
    pub fn range(&self, relief: &Relief, part: Part) -> Result<[[f64; 2]; 2], MesherError> {
        let sides = relief.sides();
        let mut range = [[0.0; 2]; 2];
        for axis in 0..2 {
            let [from, to] = [0, 1].map(|end| self.uvs[end][axis] * sides[axis]);
            let (of, at) = (part.of[axis], part.at[axis]);
            if at >= of {
                return Err(MesherError::NoPart { part });
            }
            let cut = |number: u32| match number {
                0 => from,
                last if last == of => to,
                _ => centre(from + (to - from) * f64::from(number) / f64::from(of)),
            };
            range[axis] = [cut(at), cut(at + 1)];
            // Parts of less than a texel have no centre at which to meet.
            if of > 1 && (to - from) / f64::from(of) < 2.0 {
                return Err(MesherError::TooManyParts { part });
            }
        }
        Ok(range)
    }

    /// Cuts a part into tiles of texels, two triangles each. Lines between tiles go through the
    /// same centres in every part.
    pub fn tiles(&self, relief: &Relief, part: Part) -> Result<Mesh, MesherError> {
        let range = self.range(relief, part)?;
        // Before memory is taken for the vertices.
        let most = range.map(|[from, to]| ((to - from) / TILE) as u64 + 2);
        let vertices = most[0].saturating_mul(most[1]);
        if vertices > MOST / 2 {
            return Err(MesherError::TooLarge { vertices, triangles: vertices.saturating_mul(2) });
        }
        let lines = range.map(|[from, to]| {
            let first = (from / TILE).floor();
            let inside = (0..).map(|k| (first + f64::from(k)) * TILE + 0.5).take_while(|at| *at < to);
            let inside = inside.filter(|at| *at > from);
            [from].into_iter().chain(inside).chain([to]).collect::<Vec<f64>>()
        });
        let tangents = self.tangents.map(|tangent| tangent.as_vec3());
        let normal = self.normal.as_vec3();
        let mut vertices = Vec::with_capacity(lines[0].len() * lines[1].len());
        for &y in &lines[1] {
            for &x in &lines[0] {
                let BasePoint { position, uv, .. } = self.base(relief, [x, y]);
                let [tangent, bitangent] = tangents;
                let position = point::stored(position);
                vertices.push(Vertex { position, normal, tangent, bitangent, uv: uv.as_vec2() });
            }
        }
        let across = lines[0].len() as u32;
        let mut triangles = Vec::with_capacity(2 * vertices.len());
        for row in 0..lines[1].len() as u32 - 1 {
            for column in 0..across - 1 {
                let here = row * across + column;
                let below = here + across;
                for mut corners in [[here, below, below + 1], [here, below + 1, here + 1]] {
                    if self.is_turned {
                        corners.swap(1, 2);
                    }
                    triangles.push(corners);
                }
            }
        }
        Ok(Mesh::new(vertices, triangles)?)
    }

    #[inline(always)]
    fn base(&self, relief: &Relief, [x, y]: [f64; 2]) -> BasePoint {
        let sides = relief.sides();
        let uv = DVec2::new(x / sides[0], y / sides[1]);
        let along = uv - self.uvs[0];
        let position = self.corner + self.tangents[0] * along.x + self.tangents[1] * along.y;
        BasePoint { position, normal: self.normal, uv }
    }

    /// Returns the texture coordinates of a place.
    fn uv(&self, relief: &Relief, place: [f64; 2]) -> DVec2 {
        self.base(relief, place).uv
    }

    /// Returns the plane of a bottom that is displaced by `metres`.
    pub fn bottom(&self, relief: &Relief, metres: f64) -> Bottom {
        let up = self.normal.normalize_or_zero();
        let base = BasePoint { position: self.corner, normal: self.normal, uv: self.uvs[0] };
        let height_m = (relief.displaced_by(&base, metres) - self.corner).dot(up);
        Bottom { corner: self.corner, up, height_m }
    }

    /// Returns the shorter side of a texel in metres.
    pub fn texel_m(&self, relief: &Relief) -> f64 {
        let sides = relief.sides();
        [0, 1]
            .map(|axis| self.tangents[axis].length() / sides[axis])
            .into_iter()
            .fold(f64::INFINITY, f64::min)
    }

    /// Returns the position of a place, displaced by `metres`.
    #[inline(always)]
    fn displaced(&self, relief: &Relief, place: [f64; 2], metres: f64) -> Vec3 {
        point::stored(relief.displaced_by(&self.base(relief, place), metres))
    }

    /// Returns the position of a place at a height of the map.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, place: [f64; 2], height: f64) -> Vec3 {
        self.displaced(relief, place, relief.metres(height))
    }

    /// Returns the vertex of a place on the relief.
    #[inline(always)]
    pub fn vertex(&self, relief: &Relief, place: [f64; 2]) -> Vertex {
        self.vertex_of(relief, place, relief.displacement_at(place))
    }

    /// Returns the vertex of a place at a height of the map.
    pub fn vertex_at(&self, relief: &Relief, place: [f64; 2], height: f64) -> Vertex {
        self.vertex_of(relief, place, relief.displacement_at(place).at_metres(relief.metres(height)))
    }

    #[inline(always)]
    fn vertex_of(&self, relief: &Relief, place: [f64; 2], displacement: Displacement) -> Vertex {
        let frame = Frame { normal: self.normal, tangents: self.tangents, turns: [DVec3::ZERO; 2] };
        relief.vertex_of(&self.base(relief, place), displacement, &frame)
    }
}

/// Returns the centre of a texel that is nearest to a place.
fn centre(place: f64) -> f64 {
    (place - 0.5).round() + 0.5
}
