//! Planes: rectangles whose texture lies straight, cut along the lines of texels.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Mesh, Vertex};

use crate::error::MOST;
use crate::surface::{Frame, Relief};
use crate::{MeshSettings, MesherError, point};

/// Cells of a tile along a side.
const TILE: usize = 128;

/// How much the corners of a rectangle may differ from one, as a part of its sides.
const ROUNDING: f64 = 1e-5;

/// A rectangle, with the lines across it. Its vertices are where these meet: the same whichever tile asks.
#[derive(Debug)]
pub struct Plane {
    corner: DVec3,
    /// The derivatives of the position by `u` and `v`.
    tangents: [DVec3; 2],
    normal: DVec3,
    /// Texture coordinates of the corner.
    from: DVec2,
    /// The places of the lines across `u` and `v`, counted in texels, `i + ½` the centre of texel `i`.
    lines: [Vec<f64>; 2],
    sides: [f64; 2],
    /// Whether triangles are turned over, as seen along growing `u` and `v`.
    is_turned: bool,
}

/// A tile: the first and the last line across `u` and across `v`.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub first: [usize; 2],
    pub last: [usize; 2],
}

impl Plane {
    /// The plane that a mesh is, if it is two triangles that make a rectangle with straight texture.
    pub fn of_mesh(
        mesh: &Mesh,
        relief: &Relief,
        settings: &MeshSettings,
    ) -> Result<Option<Self>, MesherError> {
        let Some(rectangle) = Rectangle::of_mesh(mesh) else { return Ok(None) };
        let Rectangle { corner, tangents, normal, uvs: [from, to], is_turned } = rectangle;
        let sides = relief.sides();
        let range = [0, 1].map(|axis| [from[axis] * sides[axis], to[axis] * sides[axis]]);
        // Before memory is taken for so many lines.
        let step = (settings.edges.step)(settings);
        let most = range.map(|[from, to]| ((to - from) / step + 2.0) as u64);
        let vertices = most[0].saturating_mul(most[1]);
        if vertices > MOST || vertices.saturating_mul(2) > 2 * MOST {
            return Err(MesherError::TooLarge { vertices, triangles: vertices.saturating_mul(2) });
        }
        let lines = range.map(|[from, to]| (settings.edges.lines)(from, to, settings));
        Ok(Some(Self { corner, tangents, normal, from, lines, sides, is_turned }))
    }

    /// Tiles along `u` and `v`.
    fn tiles(&self) -> [usize; 2] {
        [0, 1].map(|axis| (self.lines[axis].len() - 1).div_ceil(TILE))
    }

    pub fn tile_count(&self) -> u32 {
        let [across, down] = self.tiles();
        (across * down) as u32
    }

    pub fn tile(&self, number: u32) -> Tile {
        let across = self.tiles()[0];
        let place = [number as usize % across, number as usize / across];
        let first = place.map(|place| place * TILE);
        Tile { first, last: [0, 1].map(|axis| (first[axis] + TILE).min(self.lines[axis].len() - 1)) }
    }

    /// The lines of a tile.
    pub fn lines(&self, tile: &Tile) -> [&[f64]; 2] {
        [0, 1].map(|axis| &self.lines[axis][tile.first[axis]..=tile.last[axis]])
    }

    /// The first lines whose vertices are a tile's own: those before belong to its neighbours.
    fn own(tile: &Tile) -> [usize; 2] {
        tile.first.map(|first| if first == 0 { 0 } else { first + 1 })
    }

    /// Whether the vertex where two lines of a tile meet is the tile's own.
    pub fn is_own(tile: &Tile, [i, j]: [usize; 2]) -> bool {
        let [first_i, first_j] = Self::own(tile);
        i >= first_i && j >= first_j
    }

    /// How many vertices a tile has of its own.
    pub fn own_count(tile: &Tile) -> u64 {
        let own = Self::own(tile);
        (0..2).map(|axis| (tile.last[axis] + 1 - own[axis]) as u64).product()
    }

    /// The number of the vertex where two lines meet: tile by tile, and in a tile row by row.
    pub fn number(&self, [i, j]: [usize; 2]) -> u32 {
        let across = self.tiles()[0];
        let place = [i, j].map(|line| line.saturating_sub(1) / TILE);
        let tile = self.tile((place[1] * across + place[0]) as u32);
        let [first_i, first_j] = Self::own(&tile);
        let (width, height) = (tile.last[0] + 1 - first_i, tile.last[1] + 1 - first_j);
        (first_j * self.lines[0].len() + first_i * height + (j - first_j) * width + i - first_i) as u32
    }

    pub fn is_turned(&self) -> bool {
        self.is_turned
    }

    fn base(&self, [x, y]: [f64; 2]) -> BasePoint {
        let uv = DVec2::new(x / self.sides[0], y / self.sides[1]);
        let along = uv - self.from;
        let position = self.corner + self.tangents[0] * along.x + self.tangents[1] * along.y;
        BasePoint { position, normal: self.normal, uv }
    }

    fn place(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        [self.lines[0][i], self.lines[1][j]]
    }

    /// The position where two lines meet.
    pub fn position(&self, relief: &Relief, lines: [usize; 2]) -> Vec3 {
        let place = self.place(lines);
        point::stored(relief.displaced(&self.base(place), place.map(|at| at - 0.5), 0.0))
    }

    /// The vertex where two lines meet.
    pub fn vertex(&self, relief: &Relief, lines: [usize; 2]) -> Vertex {
        let place = self.place(lines);
        let (base, in_map) = (self.base(place), place.map(|at| at - 0.5));
        let position = relief.displaced(&base, in_map, 0.0);
        let frame = Frame { normal: self.normal, tangents: self.tangents, turns: [DVec3::ZERO; 2] };
        relief.vertex(position, &base, in_map, &frame, 0.0)
    }
}

/// A rectangle as two triangles make it.
struct Rectangle {
    corner: DVec3,
    tangents: [DVec3; 2],
    normal: DVec3,
    uvs: [DVec2; 2],
    is_turned: bool,
}

impl Rectangle {
    fn of_mesh(mesh: &Mesh) -> Option<Self> {
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
        // Seen along growing u and v a triangle runs one way or the other; both of them the same.
        let turn = |corners: &[&Vertex]| {
            let [a, b, c] = [0, 1, 2].map(|k| corners[k].uv.as_dvec2());
            (b - a).perp_dot(c - a)
        };
        let turns = [turn(&corners[..3]), turn(&corners[3..])];
        let area = (to - from).x * (to - from).y;
        // The corner that a half has not is its own, turned around the middle.
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Directions;
    use glam::{Quat, Vec2};
    use relief_core::mesh::{Placement, cube, rectangle};
    use relief_core::{HeightMap, Wrap};

    #[test]
    fn planes_are_told_from_other_meshes() {
        let map = HeightMap::from_fn(300, 7, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let relief = Relief::new(&map, Directions::Raw);
        let plane = |mesh: &Mesh| Plane::of_mesh(mesh, &relief, &MeshSettings::default()).expect("small");
        let mesh = rectangle([1.0, 0.3], 1).expect("a mesh");
        let found = plane(&mesh).expect("a plane");
        assert_eq!(found.lines.each_ref().map(Vec::len), [302, 9]);
        let placement = Placement { rotation_degrees: [20.0, 70.0, -35.0].into(), ..Placement::default() };
        assert!(plane(&mesh.clone().placed(&placement).expect("placed")).is_some());
        let tiled = plane(&mesh.clone().tiled(Vec2::new(3.0, 0.5)).expect("tiled")).expect("a plane");
        assert_eq!(tiled.lines.each_ref().map(Vec::len), [902, 5]);
        for other in [rectangle([1.0, 0.3], 2), cube(1)] {
            assert!(plane(&other.expect("a mesh")).is_none());
        }
        // One corner out of its place, and one with another normal.
        let mut vertices = mesh.vertices().to_vec();
        vertices[3].position.x += 0.01;
        assert!(plane(&Mesh::new(vertices.clone(), mesh.triangles().to_vec()).expect("a mesh")).is_none());
        vertices[3].position.x -= 0.01;
        vertices[3].normal = Quat::from_rotation_x(0.1) * vertices[3].normal;
        assert!(plane(&Mesh::new(vertices, mesh.triangles().to_vec()).expect("a mesh")).is_none());
    }

    #[test]
    fn vertices_are_numbered_tile_by_tile_without_a_gap() {
        let map = HeightMap::from_fn(300, 200, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let relief = Relief::new(&map, Directions::Raw);
        let mesh = rectangle([1.0, 1.0], 1).expect("a mesh");
        let plane =
            Plane::of_mesh(&mesh, &relief, &MeshSettings::default()).expect("small").expect("a plane");
        assert_eq!(plane.tile_count(), 6);
        let mut next = 0;
        for number in 0..plane.tile_count() {
            let tile = plane.tile(number);
            let before = next;
            for j in tile.first[1]..=tile.last[1] {
                for i in tile.first[0]..=tile.last[0] {
                    if Plane::is_own(&tile, [i, j]) {
                        assert_eq!(plane.number([i, j]), next);
                        next += 1;
                    } else {
                        assert!(plane.number([i, j]) < before);
                    }
                }
            }
            assert_eq!(u64::from(next - before), Plane::own_count(&tile));
        }
        assert_eq!(next, 302 * 202);
    }
}
