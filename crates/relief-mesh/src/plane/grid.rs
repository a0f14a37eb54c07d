//! Planes as grids: lines across both axes, and a vertex at each of their crossings.

use glam::Vec3;
use relief_core::mesh::Vertex;

use super::{BorderPoint, Rectangle};
use crate::edge::Evenly;
use crate::error::MOST;
use crate::surface::Relief;
use crate::{MeshSettings, MesherError};

/// Cells of a tile along a side.
const TILE: usize = 128;

/// Rectangle with the lines across it. Its vertices are the crossings, with the same bits in every
/// tile.
#[derive(Debug)]
pub struct Grid {
    rectangle: Rectangle,
    /// Places of the lines across `u` and `v` in texels: `i + ½` is the centre of texel `i`.
    lines: [Vec<f64>; 2],
}

/// Tile by the first and the last line across `u` and across `v`.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub first: [usize; 2],
    pub last: [usize; 2],
}

impl Grid {
    /// Creates the grid over a rectangle.
    pub fn new(
        rectangle: Rectangle,
        relief: &Relief,
        evenly: &Evenly,
        settings: &MeshSettings,
    ) -> Result<Self, MesherError> {
        let range = rectangle.range(relief, settings.part)?;
        // Before memory is taken for the lines.
        let step = (evenly.step)(settings);
        let most = range.map(|[from, to]| ((to - from) / step + 2.0) as u64);
        let vertices = most[0].saturating_mul(most[1]);
        if vertices > MOST || vertices.saturating_mul(2) > 2 * MOST {
            return Err(MesherError::TooLarge { vertices, triangles: vertices.saturating_mul(2) });
        }
        let lines = range.map(|[from, to]| (evenly.lines)(from, to, settings));
        Ok(Self { rectangle, lines })
    }

    /// Returns the number of tiles along `u` and `v`.
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

    /// Returns the lines of a tile.
    pub fn lines(&self, tile: &Tile) -> [&[f64]; 2] {
        [0, 1].map(|axis| &self.lines[axis][tile.first[axis]..=tile.last[axis]])
    }

    /// Returns the first lines whose vertices belong to a tile. Vertices on earlier lines belong to
    /// its neighbours.
    fn own(tile: &Tile) -> [usize; 2] {
        tile.first.map(|first| if first == 0 { 0 } else { first + 1 })
    }

    /// Returns whether the vertex at the crossing of two lines belongs to a tile.
    pub fn is_own(tile: &Tile, [i, j]: [usize; 2]) -> bool {
        let [first_i, first_j] = Self::own(tile);
        i >= first_i && j >= first_j
    }

    /// Returns the number of vertices that belong to a tile.
    pub fn own_count(tile: &Tile) -> u64 {
        let own = Self::own(tile);
        (0..2).map(|axis| (tile.last[axis] + 1 - own[axis]) as u64).product()
    }

    /// Returns the number of the vertex at a crossing: tile by tile, and in a tile row by row.
    pub fn number(&self, [i, j]: [usize; 2]) -> u32 {
        let across = self.tiles()[0];
        let place = [i, j].map(|line| line.saturating_sub(1) / TILE);
        let tile = self.tile((place[1] * across + place[0]) as u32);
        let [first_i, first_j] = Self::own(&tile);
        let (width, height) = (tile.last[0] + 1 - first_i, tile.last[1] + 1 - first_j);
        (first_j * self.lines[0].len() + first_i * height + (j - first_j) * width + i - first_i) as u32
    }

    pub fn is_turned(&self) -> bool {
        self.rectangle.is_turned
    }

    /// Returns the rectangle.
    pub fn rectangle(&self) -> &Rectangle {
        &self.rectangle
    }

    /// Returns the border, in the order of [`Solid`](super::Solid).
    pub fn walls(&self, relief: &Relief) -> [Vec<BorderPoint>; 4] {
        let [last_i, last_j] = self.lines.each_ref().map(|lines| lines.len() - 1);
        let point = |lines: [usize; 2]| {
            let place = self.place(lines);
            (place, relief.height(place), self.number(lines))
        };
        [
            (0..=last_i).map(|i| point([i, 0])).collect(),
            (0..=last_j).map(|j| point([last_i, j])).collect(),
            (0..=last_i).rev().map(|i| point([i, last_j])).collect(),
            (0..=last_j).rev().map(|j| point([0, j])).collect(),
        ]
    }

    /// Returns the place of a crossing in texels: `i + ½` is the centre of texel `i`.
    pub fn place(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        [self.lines[0][i], self.lines[1][j]]
    }

    /// Returns the position of a crossing.
    #[inline(always)]
    pub fn position(&self, relief: &Relief, lines: [usize; 2]) -> Vec3 {
        let place = self.place(lines);
        self.rectangle.position(relief, place, relief.height(place))
    }

    /// Returns the vertex at a crossing.
    #[inline(always)]
    pub fn vertex(&self, relief: &Relief, lines: [usize; 2]) -> Vertex {
        self.rectangle.vertex(relief, self.place(lines))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edge::Divides;
    use crate::{Directions, Shading};
    use glam::{Quat, Vec2};
    use relief_core::mesh::{Mesh, Placement, cube, rectangle};
    use relief_core::{HeightMap, Wrap};

    fn grid(rectangle: Rectangle, relief: &Relief) -> Grid {
        let settings = MeshSettings::default();
        let Divides::Evenly(evenly) = settings.edges.divides else { panic!("not even") };
        Grid::new(rectangle, relief, &evenly, &settings).expect("small")
    }

    #[test]
    fn planes_are_distinguished_from_other_meshes() {
        let map = HeightMap::from_fn(300, 7, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let relief = Relief::new(&map, Directions::Raw, Shading::Exact);
        let plane = |mesh: &Mesh| Rectangle::of_mesh(mesh).map(|found| grid(found, &relief));
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
        let relief = Relief::new(&map, Directions::Raw, Shading::Exact);
        let mesh = rectangle([1.0, 1.0], 1).expect("a mesh");
        let plane = grid(Rectangle::of_mesh(&mesh).expect("a plane"), &relief);
        assert_eq!(plane.tile_count(), 6);
        let mut next = 0;
        for number in 0..plane.tile_count() {
            let tile = plane.tile(number);
            let before = next;
            for j in tile.first[1]..=tile.last[1] {
                for i in tile.first[0]..=tile.last[0] {
                    if Grid::is_own(&tile, [i, j]) {
                        assert_eq!(plane.number([i, j]), next);
                        next += 1;
                    } else {
                        assert!(plane.number([i, j]) < before);
                    }
                }
            }
            assert_eq!(u64::from(next - before), Grid::own_count(&tile));
        }
        assert_eq!(next, 302 * 202);
    }
}
