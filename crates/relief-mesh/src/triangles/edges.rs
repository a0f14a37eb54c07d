//! Edges of a base, with their points.

use std::collections::HashMap;

use rayon::prelude::*;
use relief_core::mesh::Mesh;

use super::corners::Corners;
use super::{Numbered, counted};
use crate::{MesherError, point};

/// Edge between two vertices. If another triangle has other vertices at the same positions, its
/// side is another edge at the same *seam*.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// Vertices, ordered by the bits of their positions.
    ends: [u32; 2],
    seam: u32,
    /// Number of its first inner point.
    first: u32,
    /// Number of the first inner point of the first edge at the seam with the same normals at its
    /// ends.
    smooth: u32,
    /// Lift of the smooth base along the edge, in metres: see [`Mesh::lifts`].
    lift: f32,
}

/// All edges between two positions.
#[derive(Clone, Copy, Debug)]
struct Seam {
    /// Number of parts of each edge.
    parts: u32,
    /// The first edge.
    first: u32,
    /// Steps along the edges, some of them points; 0 where parts are equal.
    size: u32,
    /// Index of the first point's step in [`Edges::steps`].
    first_step: u32,
}

/// Division of the edges of a seam.
#[derive(Clone, Debug)]
pub enum Division {
    /// In equal parts.
    Even(u64),
    /// At some of `size` equal steps, rising, between the ends.
    Steps { size: u32, steps: Vec<u16> },
}

impl Division {
    /// No points.
    pub const WHOLE: Self = Self::Even(1);
}

#[derive(Debug)]
pub struct Edges {
    edges: Vec<Edge>,
    seams: Vec<Seam>,
    /// Steps of the points of seams that are not divided evenly.
    steps: Vec<u16>,
    sides: Vec<[u32; 3]>,
    /// Which edges have points of their own; empty if all have.
    is_used: Vec<bool>,
    /// Whether all edges at a seam use the points of the first.
    is_shared: bool,
    /// Number after the last inner point.
    end: u64,
}

/// Side of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Side {
    /// Positions of its ends.
    pub points: [u32; 2],
    /// Vertices there, ordered by the bits of their positions.
    pub ends: [u32; 2],
    /// `3 * triangle + side`.
    pub number: u32,
}

impl Edges {
    /// Finds the edges of a mesh. `divide` returns the division of a seam, given the ordered ends
    /// of its edges.
    pub fn new(
        mesh: &Mesh,
        point_of: &[u32],
        corners: &Corners,
        divide: impl Fn(&[[u32; 2]]) -> Result<Division, MesherError> + Sync,
    ) -> Result<Self, MesherError> {
        let count = mesh.triangles().len();
        if count > (u32::MAX / 3) as usize {
            return Err(MesherError::TooLarge { vertices: 0, triangles: count as u64 });
        }
        let all = sorted_sides(mesh, point_of);
        let lifts = mesh.lifts();
        let mut edges: Vec<Edge> = Vec::with_capacity(count + count / 2);
        let mut seams: Vec<Seam> = Vec::with_capacity(count + count / 2);
        let mut sides = vec![[0; 3]; count];
        for (at, side) in all.iter().enumerate() {
            let before = at.checked_sub(1).map(|before| &all[before]);
            let is_new_seam = before.is_none_or(|before| before.points != side.points);
            if is_new_seam {
                seams.push(Seam { parts: 1, first: edges.len() as u32, size: 0, first_step: 0 });
            }
            let (triangle, place) = (side.number as usize / 3, side.number as usize % 3);
            if is_new_seam || before.is_none_or(|before| before.ends != side.ends) {
                let seam = seams.len() - 1;
                let lift = lifts[triangle][(place + 2) % 3];
                edges.push(Edge { ends: side.ends, seam: seam as u32, first: 0, smooth: 0, lift });
            }
            sides[triangle][place] = edges.len() as u32 - 1;
        }
        let ends: Vec<[u32; 2]> = edges.iter().map(|edge| edge.ends).collect();
        let divided: Result<Vec<Division>, MesherError> = (0..seams.len())
            .into_par_iter()
            .map(|seam| {
                let first = seams[seam].first as usize;
                let end = seams.get(seam + 1).map_or(ends.len(), |next| next.first as usize);
                let [a, b] = ends[first].map(|end| point_of[end as usize]);
                // An edge without a length has no points but its ends.
                if a == b { Ok(Division::WHOLE) } else { divide(&ends[first..end]) }
            })
            .collect();
        let mut all_steps = Vec::new();
        for (seam, division) in seams.iter_mut().zip(divided?) {
            match division {
                Division::Even(parts) => seam.parts = counted(parts)?,
                Division::Steps { size, steps } => {
                    seam.parts = steps.len() as u32 + 1;
                    (seam.size, seam.first_step) = (size, counted(all_steps.len() as u64)?);
                    all_steps.extend(steps);
                }
            }
        }
        let mut edges =
            Self { edges, seams, steps: all_steps, sides, is_used: Vec::new(), is_shared: false, end: 0 };
        edges.is_shared = corners.is_shared();
        edges.number(corners)?;
        Ok(edges)
    }

    /// Numbers the inner points of all edges, after the corners.
    fn number(&mut self, corners: &Corners) -> Result<(), MesherError> {
        let mut next = corners.used.len() as u64;
        let mut first_of: HashMap<[u32; 2], u32> = HashMap::new();
        let mut seam = u32::MAX;
        for number in 0..self.count() {
            let points = self.points(number);
            let first = self.edges[self.first_at_seam(number) as usize].first;
            let is_shared = self.shares(number);
            let edge = &mut self.edges[number as usize];
            if is_shared {
                (edge.first, edge.smooth) = (first, first);
                continue;
            }
            if edge.seam != seam {
                first_of.clear();
                seam = edge.seam;
            }
            edge.first = counted(next)?;
            let surface = edge.ends.map(|end| corners.numbered(end).smooth);
            edge.smooth = *first_of.entry(surface).or_insert(edge.first);
            next += u64::from(points);
        }
        counted(next)?;
        self.end = next;
        Ok(())
    }

    /// Leaves out all triangles but some, and the points of edges that none of these has. The
    /// division of seams does not change.
    pub fn keep(&mut self, triangles: &[u32], corners: &Corners) -> Result<(), MesherError> {
        self.sides = triangles.iter().map(|&triangle| self.sides(triangle)).collect();
        self.is_used = vec![false; self.edges.len()];
        for &edge in self.sides.as_flattened() {
            self.is_used[edge as usize] = true;
        }
        self.number(corners)
    }

    pub fn count(&self) -> u32 {
        self.edges.len() as u32
    }

    /// Returns the number of inner points of an edge.
    pub fn points(&self, edge: u32) -> u32 {
        let is_used = self.is_used.get(edge as usize).is_none_or(|is_used| *is_used);
        if is_used && !self.shares(edge) { self.parts(edge) - 1 } else { 0 }
    }

    /// Returns whether an edge uses the points of another one at the seam.
    fn shares(&self, edge: u32) -> bool {
        self.is_shared && self.first_at_seam(edge) != edge
    }

    pub fn end(&self) -> u64 {
        self.end
    }

    /// Returns the edges at the sides of a triangle.
    pub fn sides(&self, triangle: u32) -> [u32; 3] {
        self.sides[triangle as usize]
    }

    pub fn parts(&self, edge: u32) -> u32 {
        self.seams[self.edges[edge as usize].seam as usize].parts
    }

    /// Returns the number of steps before an inner point of an edge, and the number of all steps.
    pub fn place(&self, edge: u32, at: u32) -> [u32; 2] {
        let Seam { parts, size, first_step, .. } = self.seams[self.edges[edge as usize].seam as usize];
        if size == 0 { [at, parts] } else { [self.steps[(first_step + at) as usize - 1].into(), size] }
    }

    /// Returns the number of steps along an edge. Some of their ends are points.
    pub fn size(&self, edge: u32) -> u32 {
        let Seam { parts, size, .. } = self.seams[self.edges[edge as usize].seam as usize];
        if size == 0 { parts } else { size }
    }

    pub fn ends(&self, edge: u32) -> [u32; 2] {
        self.edges[edge as usize].ends
    }

    pub fn lift(&self, edge: u32) -> f64 {
        f64::from(self.edges[edge as usize].lift)
    }

    /// Returns the first edge between the same positions.
    pub fn first_at_seam(&self, edge: u32) -> u32 {
        self.seams[self.edges[edge as usize].seam as usize].first
    }

    /// Returns the numbers of the inner point of an edge with `at` parts before it.
    pub fn numbered(&self, edge: u32, at: u32) -> Numbered {
        let Edge { first, smooth, .. } = self.edges[edge as usize];
        Numbered { number: first + at - 1, smooth: smooth + at - 1 }
    }
}

/// Returns all sides of all triangles, grouped by their positions.
pub fn sorted_sides(mesh: &Mesh, point_of: &[u32]) -> Vec<Side> {
    let mut all = Vec::with_capacity(3 * mesh.triangles().len());
    for (triangle, corners) in mesh.triangles().iter().enumerate() {
        for place in 0..3 {
            let mut ends = [corners[place], corners[(place + 1) % 3]];
            let bits = |end: u32| (point::bits(mesh.vertices()[end as usize].position), end);
            if bits(ends[1]) < bits(ends[0]) {
                ends.swap(0, 1);
            }
            let points = ends.map(|end| point_of[end as usize]);
            all.push(Side { points, ends, number: (3 * triangle + place) as u32 });
        }
    }
    all.par_sort_unstable();
    all
}
