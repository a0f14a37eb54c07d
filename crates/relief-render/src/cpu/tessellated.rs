//! Tessellation of base meshes on the CPU, by the functions that GPUs run.
//!
//! The passes follow the shaders' root `tessellate`. Each is a loop here, with the same results as
//! on the GPU.

use std::borrow::Cow;
use std::sync::Arc;

use rayon::prelude::*;
use relief_shaders::cpu::{
    BasePatch, BaseSite, BaseVertex, Corner, DicePlace, DiceRows, Frame, Shell, Sweep, Tessellator, Vec2,
    Vec3, Voxel,
};
use relief_shaders::wgsl::{TESSELLATE_COARSEST as COARSEST, TESSELLATE_INSIDE as INSIDE};

use crate::frame_cache::cached;
use crate::job::{Job, JobSurface};
use crate::prepare::Triangles;
use crate::prepare::{TessellatedBase, Tessellation};

/// Numbers of points and triangles of a base edge or a base triangle, and of all before it.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    points: u32,
    triangles: u32,
    points_before: u32,
    triangles_before: u32,
}

/// Base mesh with its numbers of points and triangles.
struct Counted<'a> {
    tessellator: Tessellator<'a>,
    base: &'a TessellatedBase,
    voxels: Vec<Voxel>,
    /// Number of parts of each edge.
    parts: Vec<u32>,
    /// Tallies of edges, then of triangles.
    tallies: Vec<Tally>,
    points: u32,
    triangles: u32,
    /// Number of doublings by which the grid is coarser.
    level: u32,
}

/// Triangles that fill a base triangle.
#[derive(Debug, Default)]
struct Filled {
    faces: Vec<[u32; 3]>,
    /// Barycentric weights of the points inside, by number. Empty for a pattern, which gives them
    /// for each number.
    weights: Vec<Vec3<f32>>,
}

/// Cache of the triangles of the last job, by their source.
#[derive(Debug, Default)]
pub struct TessellatedCache {
    known: Vec<(Arc<Triangles>, Arc<Triangles>)>,
}

impl TessellatedCache {
    /// Returns the job with its bases tessellated.
    pub fn job<'a>(&mut self, job: &'a Job) -> Cow<'a, Job> {
        if job.surfaces.iter().all(|surface| surface.triangles.tessellation().is_none()) {
            self.known.clear();
            return Cow::Borrowed(job);
        }
        let (mut job, mut made) = (job.clone(), Vec::new());
        for surface in &mut job.surfaces {
            if let Some(tessellation) = surface.triangles.tessellation() {
                let make = || Arc::new(triangles(surface, job.frame, tessellation));
                surface.triangles = cached(&mut made, &self.known, &surface.triangles, make);
            }
        }
        self.known = made;
        Cow::Owned(job)
    }
}

/// Tessellates and displaces a surface's base for a view.
pub fn triangles(surface: &JobSurface, frame: Frame, tessellation: &Tessellation) -> Triangles {
    let Tessellation { base, grid } = tessellation;
    let tessellator = Tessellator::new(&surface.bound(surface.settings, frame, None), *grid);
    let counted = Counted::new(tessellator, base, [grid.most_points, grid.most_triangles]);
    let filled: Vec<Filled> =
        (0..base.patches.len() as u32).into_par_iter().map(|patch| counted.filled(patch)).collect();
    let vertices = base.vertices.len() as u32;
    let corners = (0..vertices + counted.points).into_par_iter().map(|point| counted.corner(point, &filled));
    let corners: Vec<Corner> = corners.collect();
    let faces = filled.into_iter().flat_map(|filled| filled.faces);
    Triangles::new(corners, faces.zip(std::iter::repeat(Shell::whole())))
}

impl<'a> Counted<'a> {
    /// Counts a base on the finest grid with at most `most` points and triangles.
    fn new(tessellator: Tessellator<'a>, base: &'a TessellatedBase, most: [u32; 2]) -> Self {
        let voxels = base.vertices.par_iter().map(|vertex| tessellator.voxel_of(vertex.position));
        let voxels: Vec<Voxel> = voxels.collect();
        let is_seen = |patch: &BasePatch| {
            let corners = three(patch.corners).map(|corner| base.vertices[corner as usize]);
            !tessellator.is_left_out(corners, [patch.low_m, patch.high_m])
        };
        let is_seen: Vec<bool> = base.patches.par_iter().map(is_seen).collect();
        let is_made = |patch: u32| is_seen.get(patch as usize).is_none_or(|is_seen| *is_seen);
        let mut counted = Self {
            tessellator,
            base,
            voxels,
            parts: Vec::new(),
            tallies: Vec::new(),
            points: 0,
            triangles: 0,
            level: 0,
        };
        for level in 0..=COARSEST {
            counted.count(level, &is_made);
            let sum = |of: fn(&Tally) -> u32| counted.tallies.iter().map(|tally| u64::from(of(tally))).sum();
            let all: [u64; 2] = [sum(|tally| tally.points), sum(|tally| tally.triangles)];
            if all.iter().zip(most).all(|(all, most)| *all <= u64::from(most)) {
                break;
            }
        }
        for tally in &mut counted.tallies {
            (tally.points_before, tally.triangles_before) = (counted.points, counted.triangles);
            counted.points += tally.points;
            counted.triangles += tally.triangles;
        }
        counted
    }

    /// Counts the base on the grid of a level.
    fn count(&mut self, level: u32, is_made: &(impl Fn(u32) -> bool + Sync)) {
        let (tessellator, base) = (self.tessellator, self.base);
        self.level = level;
        let voxels = &self.voxels;
        let parts = base.edges.par_iter().map(|edge| {
            let ends = [edge.ends.x, edge.ends.y].map(|end| voxels[end as usize]);
            tessellator.parts_between(ends, edge.along, level)
        });
        self.parts = parts.collect();
        let edges = base.edges.par_iter().zip(&self.parts).map(|(edge, parts)| {
            let is_made = is_made(edge.patches.x) || is_made(edge.patches.y);
            Tally { points: if is_made { parts - 1 } else { 0 }, ..Tally::default() }
        });
        let patches = (0..base.patches.len() as u32).into_par_iter().map(|patch| {
            if !is_made(patch) {
                return Tally::default();
            }
            let (points, triangles) = match self.sweep(patch) {
                Some(sweep) => {
                    let points = tessellator.swept_points(sweep);
                    // Every corner of the triangles lies inside or on the border.
                    (points, 2 * points + self.parts_of(patch).iter().sum::<u32>() - 2)
                }
                None => {
                    let rows = self.rows(patch);
                    (tessellator.points(rows), tessellator.triangles(rows))
                }
            };
            Tally { points, triangles, ..Tally::default() }
        });
        let tallies = edges.chain(patches).collect();
        self.tallies = tallies;
    }

    /// Returns the numbers of parts of a base triangle's sides.
    fn parts_of(&self, patch: u32) -> [u32; 3] {
        three(self.base.patches[patch as usize].edges).map(|edge| self.parts[edge as usize])
    }

    /// Returns the pattern of a base triangle.
    fn rows(&self, patch: u32) -> DiceRows {
        self.tessellator.rows(self.parts_of(patch))
    }

    /// Returns the sweep of a base triangle, if it is swept.
    fn sweep(&self, patch: u32) -> Option<Sweep> {
        let corners = three(self.base.patches[patch as usize].corners);
        self.tessellator.sweep(corners.map(|corner| self.voxels[corner as usize]), self.level)
    }

    /// Triangles that fill a base triangle.
    fn filled(&self, patch: u32) -> Filled {
        let triangles = self.tallies[self.parts.len() + patch as usize].triangles;
        if triangles == 0 {
            return Filled::default();
        }
        let Some(sweep) = self.sweep(patch) else {
            let rows = self.rows(patch);
            let faces = (0..triangles).map(|number| self.face(patch, rows, number)).collect();
            return Filled { faces, weights: Vec::new() };
        };
        let (tessellator, mut filled) = (self.tessellator, Filled::default());
        let mut column = tessellator.swept_column(sweep, 0, 0);
        for strip in 0..sweep.end.x {
            let next = tessellator.swept_column(sweep, strip + 1, filled.weights.len() as u32);
            filled.weights.extend(tessellator.swept_weights(sweep, next));
            let pieces = tessellator.swept_triangles(sweep, [column, next]).into_iter();
            filled.faces.extend(pieces.map(|piece| piece.map(|[side, at]| self.number(patch, side, at))));
            column = next;
        }
        filled
    }

    fn vertex(&self, vertex: u32, seen: u32) -> BaseSite {
        let at = |vertex: u32| -> BaseVertex { self.base.vertices[vertex as usize] };
        self.tessellator.site_of_vertex(at(vertex), at(seen), self.voxels[seen as usize])
    }

    fn share(&self, vertex: u32) -> f32 {
        self.voxels[vertex as usize].share
    }

    /// Returns the point of an edge with `at` parts before it.
    fn on_edge(&self, edge: u32, at: u32) -> BaseSite {
        let (of, parts) = (&self.base.edges[edge as usize], self.parts[edge as usize]);
        let ends = [self.vertex(of.ends.x, of.seen.x), self.vertex(of.ends.y, of.seen.y)];
        let shares = Vec2 { x: self.share(of.seen.x), y: self.share(of.seen.y) };
        self.tessellator.site_between(ends, shares, [at, parts])
    }

    /// Returns the point with a number inside a base triangle.
    fn inside(&self, patch: u32, number: u32, filled: &Filled) -> BaseSite {
        let corners = three(self.base.patches[patch as usize].corners);
        let weights = filled.weights.get(number as usize).copied().unwrap_or_else(|| {
            let rows = self.rows(patch);
            self.tessellator.point(rows, self.tessellator.place(rows, number)).weights
        });
        let [x, y, z] = corners.map(|corner| self.share(corner));
        let sites = corners.map(|corner| self.vertex(corner, corner));
        self.tessellator.site_inside(sites, Vec3 { x, y, z }, weights)
    }

    /// Returns the corner with a number. The base's vertices come first, then points on edges, then
    /// inner points.
    fn corner(&self, point: u32, filled: &[Filled]) -> Corner {
        let vertices = &self.base.vertices;
        let site = match (point as usize).checked_sub(vertices.len()) {
            None => self.vertex(point, vertices[point as usize].seen),
            Some(point) => {
                let point = point as u32;
                let place = self.tallies.partition_point(|tally| tally.points_before <= point) - 1;
                let number = point - self.tallies[place].points_before;
                match place.checked_sub(self.parts.len()) {
                    None => self.on_edge(place as u32, number + 1),
                    Some(patch) => self.inside(patch as u32, number, &filled[patch]),
                }
            }
        };
        self.tessellator.displaced(site)
    }

    /// Returns the number of a base triangle's point, on a side or inside.
    fn number(&self, patch: u32, side: u32, at: u32) -> u32 {
        let of = &self.base.patches[patch as usize];
        let first = self.base.vertices.len() as u32;
        if side == INSIDE {
            return first + self.tallies[self.parts.len() + patch as usize].points_before + at;
        }
        let corner = three(of.corners)[side as usize];
        if at == 0 {
            return corner;
        }
        let edge = three(of.edges)[side as usize] as usize;
        let is_forth = self.base.edges[edge].ends.x == corner;
        let along = if is_forth { at } else { self.parts[edge] - at };
        first + self.tallies[edge].points_before + along - 1
    }

    /// Returns the corners of a pattern's triangle.
    fn face(&self, patch: u32, rows: DiceRows, number: u32) -> [u32; 3] {
        let cut = self.tessellator.triangle(rows, number);
        [cut.a, cut.b, cut.c].map(|place: DicePlace| {
            let point = self.tessellator.point(rows, place);
            self.number(patch, point.side, point.at)
        })
    }
}

fn three(of: Vec3<u32>) -> [u32; 3] {
    [of.x, of.y, of.z]
}

#[cfg(test)]
pub(crate) mod tests;
