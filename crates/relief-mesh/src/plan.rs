//! Plan of the blocks in which a mesh is made, counted before any is made.

use std::ops::Range;

use crate::MesherError;
use crate::error::MOST;
use crate::interior::Pattern;
use crate::patch::Patch;
use crate::plane::{Adapted, Grid, Solid};
use crate::triangles::{self, Triangles};

/// Number of vertices and triangles together at which a block ends.
const BLOCK: u64 = 1 << 15;

/// Walls of a block, of four corners and two triangles each.
const WALLS: usize = BLOCK as usize / 6;

/// Content of a block.
#[derive(Clone, Debug)]
pub enum Work {
    /// Vertices at corners of the base.
    Corners(Range<u32>),
    /// Vertices along edges of the base.
    Edges(Range<u32>),
    /// Steps of patches, from one patch and step to another.
    Patches { from: [u32; 2], to: [u32; 2], first_inner: u32, first_vertex: u32 },
    /// Filled patches.
    Filled(Range<u32>),
    /// A tile of a plane.
    Tile(u32),
    /// Walls and a bottom under a plane, by the number of their first vertex.
    Solid(u32),
    /// Vertices of an underside.
    Below(Range<u32>),
    /// Triangles of an underside.
    Underside(Range<u32>),
    /// Walls between a border and an underside.
    Walls(Range<u32>),
    /// Vertices that part pieces of a plane which touch at a point.
    Copies(Range<u32>),
    /// Bottom below another block, by its index.
    Beneath(u32),
    /// Walls along the outline of a plane.
    Outline(Range<u32>),
}

/// Plan of blocks.
#[derive(Debug)]
pub struct Plan {
    pub blocks: Vec<Work>,
    pub vertices: u64,
    pub triangles: u64,
    /// Number of vertices and triangles of the largest block.
    pub largest: u64,
}

impl Default for Plan {
    fn default() -> Self {
        Self { blocks: Vec::new(), vertices: 0, triangles: 0, largest: BLOCK }
    }
}

impl Plan {
    fn check(&self) -> Result<(), MesherError> {
        let Self { vertices, triangles, .. } = *self;
        if vertices.max(triangles) > MOST {
            return Err(MesherError::TooLarge { vertices, triangles });
        }
        Ok(())
    }

    fn add(&mut self, work: Work, size: u64) {
        self.largest = self.largest.max(size);
        self.blocks.push(work);
    }

    /// Plans vertices or triangles that are made one by one.
    fn each(&mut self, count: u32, work: impl Fn(Range<u32>) -> Work) {
        for first in (0..count).step_by(BLOCK as usize) {
            let last = count.min(first + BLOCK as u32);
            self.add(work(first..last), u64::from(last - first));
        }
    }

    /// Plans items of different sizes, as many in a block as fill it.
    fn grouped(&mut self, count: u32, size_of: impl Fn(u32) -> u64, work: impl Fn(Range<u32>) -> Work) {
        let (mut first, mut size) = (0, 0);
        for at in 0..count {
            size += size_of(at);
            if size >= BLOCK || at + 1 == count {
                self.add(work(first..at + 1), size);
                (first, size) = (at + 1, 0);
            }
        }
    }

    /// Plans vertices along edges, or along sides of tiles. `points` returns their number.
    fn edges(&mut self, count: u32, points: impl Fn(u32) -> u32) {
        self.grouped(count, |edge| points(edge).into(), Work::Edges);
    }

    /// Plans a mesh over triangles.
    pub fn triangles(&mut self, base: &Triangles, pattern: &Pattern) -> Result<(), MesherError> {
        self.each(base.corner_count(), Work::Corners);
        self.edges(base.edge_count(), |edge| base.points_of_edge(edge));
        self.vertices = base.border_count();
        let begun = |from: [u32; 2], inner: u64, vertices: u64| (from, inner as u32, vertices as u32);
        let (mut begin, mut size) = (begun([0, 0], 0, self.vertices), 0);
        for patch in 0..base.count() {
            let shape = base.patch(patch);
            let steps = (pattern.steps)(&shape);
            let mut inner = 0;
            for step in 0..steps {
                let counts = (pattern.counts)(&shape, step);
                inner += counts.points;
                self.vertices += counts.points;
                self.triangles += counts.triangles;
                self.check()?;
                size += counts.points + counts.triangles;
                let is_last = patch + 1 == base.count() && step + 1 == steps;
                if size >= BLOCK || is_last {
                    let (from, first_inner, first_vertex) = begin;
                    let to = [patch, step + 1];
                    self.add(Work::Patches { from, to, first_inner, first_vertex }, size);
                    (begin, size) = (begun(to, inner, self.vertices), 0);
                }
            }
        }
        Ok(())
    }

    /// Plans a mesh over filled triangles.
    pub fn filled(&mut self, filled: &triangles::Adapted) {
        let base = filled.base();
        self.each(base.corner_count(), Work::Corners);
        self.edges(base.edge_count(), |edge| base.points_of_edge(edge));
        self.vertices = filled.vertices();
        self.triangles = (0..base.count()).map(|patch| u64::from(filled.counts(patch)[1])).sum();
        let size = |patch: u32| filled.counts(patch).map(u64::from).iter().sum();
        self.grouped(base.count(), size, Work::Filled);
    }

    /// Plans a mesh over the filled tiles of a plane.
    pub fn adapted(&mut self, plane: &Adapted) {
        self.each(plane.corner_count(), Work::Corners);
        self.edges(plane.side_count(), |side| plane.points_of_side(side));
        self.vertices = plane.vertices();
        for tile in 0..plane.tile_count() {
            let [points, triangles] = plane.counts(tile).map(u64::from);
            self.triangles += triangles;
            self.add(Work::Tile(tile), points + triangles);
        }
    }

    /// Plans walls and a bottom after everything else.
    pub fn solid(&mut self, solid: &Solid) -> Result<(), MesherError> {
        let first = self.vertices;
        self.vertices += solid.vertices();
        self.triangles += solid.triangles();
        self.check()?;
        self.add(Work::Solid(first as u32), solid.vertices() + solid.triangles());
        Ok(())
    }

    /// Plans an underside and walls after everything else.
    pub fn underside(&mut self, base: &Triangles, solid: &triangles::Solid) -> Result<(), MesherError> {
        let of_walls: u64 = (0..solid.wall_count()).map(|wall| solid.wall_triangles(base, wall)).sum();
        self.vertices = solid.end();
        self.triangles += u64::from(solid.patch_count()) + of_walls;
        self.check()?;
        self.each(solid.corner_count(), Work::Below);
        self.each(solid.patch_count(), Work::Underside);
        let size = |wall: u32| 2 * solid.wall_triangles(base, wall);
        self.grouped(solid.wall_count(), size, Work::Walls);
        Ok(())
    }

    /// Returns the blocks that close the mesh that `blocks` make of a plane with holes.
    pub fn closing(blocks: &[Work], copies: u32, walls: u32) -> Vec<Work> {
        let mut plan = Self::default();
        plan.each(copies, Work::Copies);
        let above = (blocks.len() + plan.blocks.len()) as u32;
        plan.blocks.extend((0..above).map(Work::Beneath));
        for first in (0..walls).step_by(WALLS) {
            plan.blocks.push(Work::Outline(first..walls.min(first + WALLS as u32)));
        }
        plan.blocks
    }

    /// Plans a mesh over a grid on a plane.
    pub fn grid(&mut self, grid: &Grid, pattern: &Pattern) -> Result<(), MesherError> {
        for number in 0..grid.tile_count() {
            let tile = grid.tile(number);
            let shape = Patch::Tile(grid.lines(&tile));
            let counts = (pattern.counts)(&shape, 0);
            self.vertices += Grid::own_count(&tile);
            self.triangles += counts.triangles;
            self.check()?;
            self.add(Work::Tile(number), counts.points + counts.triangles);
        }
        Ok(())
    }
}
