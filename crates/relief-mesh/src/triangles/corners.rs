//! Vertices of a base: their directions of displacement, and the frames that shade them.

use std::collections::HashMap;

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::{BasePoint, Mesh, Vertex};

use super::{Numbered, surface_bits};
use crate::surface::Frame;
use crate::{Directions, direction, point};

/// Longest direction of displacement at a hard edge, in lengths of a normal. Longer ones would turn
/// sharp edges into spikes.
const LONGEST: f64 = 2.0;

/// Stands for a vertex that no triangle has.
const UNUSED: u32 = u32::MAX;

/// Vertices of a base.
#[derive(Debug)]
pub struct Corners {
    vertices: Vec<Vertex>,
    /// Whether directions between are interpolated by angles.
    is_by_angle: bool,
    /// Direction of displacement of each vertex; empty where it is the normal.
    directions: Vec<Vec3>,
    /// Base points, including vertices between others; empty where there are none of these.
    between: Vec<BasePoint>,
    /// Derivatives of the directions by `u` and `v`.
    turns: Vec<[Vec3; 2]>,
    /// Vertex whose texture coordinates define the displacement of each vertex; empty where it is
    /// the vertex itself.
    leaders: Vec<u32>,
    /// Vertices that triangles use, in the order in which they are written.
    pub used: Vec<u32>,
    /// Index of each vertex in `used`.
    numbers: Vec<u32>,
    /// Number of the first vertex at the same position with the same normal, for each vertex.
    smooth: Vec<u32>,
    /// Whether all vertices at a position are one, as in a solid.
    is_shared: bool,
}

impl Corners {
    /// Finds the corners of a mesh. In a welded mesh with `shared`, all vertices at a position
    /// become one.
    pub fn new(mesh: &Mesh, point_of: &[u32], [is_welded, shared]: [bool; 2], along: Directions) -> Self {
        let vertices = mesh.vertices().to_vec();
        let directions = if is_welded { welded_directions(mesh, point_of) } else { Vec::new() };
        let (between, turns, leaders, used) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (numbers, smooth) = (Vec::new(), Vec::new());
        let is_by_angle = along == Directions::Angle;
        let mut corners = Self {
            vertices,
            is_by_angle,
            directions,
            between,
            turns,
            leaders,
            used,
            numbers,
            smooth,
            is_shared: false,
        };
        corners.keep(mesh.triangles());
        if is_welded {
            corners.leaders = first_used(point_of, &corners.used);
        }
        if is_welded && shared {
            corners.share();
        }
        corners.turns = corners.turns_of(mesh);
        corners
    }

    /// Numbers the vertices that some triangles use, and no others. References to other vertices
    /// stay valid.
    pub fn keep(&mut self, triangles: &[[u32; 3]]) {
        let vertices = &self.vertices;
        let mut is_used = vec![false; vertices.len()];
        for &vertex in triangles.as_flattened() {
            is_used[vertex as usize] = true;
        }
        self.used = (0..vertices.len() as u32).filter(|&at| is_used[at as usize]).collect();
        self.numbers = vec![UNUSED; vertices.len()];
        for (number, &vertex) in self.used.iter().enumerate() {
            self.numbers[vertex as usize] = number as u32;
        }
        let mut first = HashMap::new();
        let smooth = vertices.iter().zip(&self.numbers).map(|(vertex, &number)| match number {
            UNUSED => UNUSED,
            number => *first.entry(surface_bits(vertex)).or_insert(number),
        });
        self.smooth = smooth.collect();
    }

    /// Replaces all vertices at a position by the first of them.
    fn share(&mut self) {
        self.is_shared = true;
        let all = std::mem::take(&mut self.used);
        self.used = all.iter().copied().filter(|&vertex| self.leader(vertex) == vertex).collect();
        for (number, &vertex) in self.used.iter().enumerate() {
            self.numbers[vertex as usize] = number as u32;
        }
        for &vertex in &all {
            self.numbers[vertex as usize] = self.numbers[self.leader(vertex) as usize];
        }
        self.smooth.clone_from(&self.numbers);
    }

    /// Returns whether all vertices at a position are one.
    pub fn is_shared(&self) -> bool {
        self.is_shared
    }

    /// Adds vertices half-way between others. The first ones are the vertices of a whole mesh, and
    /// each further one has two parents before it. They are not rounded, so that the surface does
    /// not change.
    #[must_use]
    pub fn between(mut self, whole: &Self, parents: &[[u32; 2]]) -> Self {
        let mut all: Vec<BasePoint> = (0..whole.vertices.len() as u32).map(|at| whole.base(at)).collect();
        self.turns[..all.len()].copy_from_slice(&whole.turns);
        for parents in parents {
            let [a, b] = parents.map(|parent| all[parent as usize]);
            let [turn_a, turn_b] = parents.map(|parent| self.turns[parent as usize]);
            self.turns[all.len()] = [0, 1].map(|axis| turn_a[axis] * 0.5 + turn_b[axis] * 0.5);
            all.push(BasePoint {
                position: a.position * 0.5 + b.position * 0.5,
                normal: self.direction_on_side([a.normal, b.normal], [0.5, 0.5]),
                uv: a.uv * 0.5 + b.uv * 0.5,
            });
        }
        self.between = all;
        self
    }

    /// Returns the number of vertices.
    pub fn count(&self) -> usize {
        self.vertices.len()
    }

    pub fn vertex(&self, vertex: u32) -> &Vertex {
        &self.vertices[vertex as usize]
    }

    /// Returns the vertex that defines the displacement of a vertex.
    pub fn leader(&self, vertex: u32) -> u32 {
        self.leaders.get(vertex as usize).copied().unwrap_or(vertex)
    }

    pub fn numbered(&self, vertex: u32) -> Numbered {
        let [number, smooth] = [&self.numbers, &self.smooth].map(|of| of[vertex as usize]);
        Numbered { number, smooth }
    }

    /// Returns the base point of a vertex, with its direction of displacement.
    pub fn base(&self, vertex: u32) -> BasePoint {
        if let Some(base) = self.between.get(vertex as usize) {
            return *base;
        }
        let mut base = BasePoint::from(self.vertex(vertex));
        if let Some(direction) = self.directions.get(vertex as usize) {
            base.normal = direction.as_dvec3();
        }
        base
    }

    /// Returns the direction of displacement, of any length, between the ends of a side, by their
    /// weights.
    pub fn direction_on_side(&self, [a, b]: [DVec3; 2], weights: [f64; 2]) -> DVec3 {
        if self.is_by_angle { direction::between([a, b], weights) } else { point::between(a, b, weights) }
    }

    /// Returns whether directions between are interpolated by angles, and not as sums.
    pub fn is_by_angle(&self) -> bool {
        self.is_by_angle
    }

    /// Returns the length of the longest direction of displacement.
    pub fn longest(&self) -> f64 {
        self.used.iter().map(|&vertex| self.base(vertex).normal.length()).fold(0.0, f64::max)
    }

    /// Returns the frame that shades a vertex.
    pub fn frame(&self, vertex: u32) -> Frame {
        let Vertex { normal, tangent, bitangent, .. } = self.vertex(vertex);
        Frame {
            normal: normal.as_dvec3(),
            tangents: [tangent, bitangent].map(|tangent| tangent.as_dvec3()),
            turns: self.turns[vertex as usize].map(|turn| turn.as_dvec3()),
        }
    }

    /// Returns the derivatives of the directions. They are constant over a triangle, or by angles
    /// differ at its corners. A vertex has their mean over the triangles around its position that
    /// have the same frame, weighted by area.
    fn turns_of(&self, mesh: &Mesh) -> Vec<[Vec3; 2]> {
        let frame_bits = |vertex: &Vertex| {
            let Vertex { position, normal, tangent, bitangent, .. } = vertex;
            [*position, *normal, *tangent, *bitangent].map(point::bits)
        };
        let mut places = HashMap::with_capacity(self.vertices.len());
        let mut sums: Vec<([DVec3; 2], f64)> = Vec::new();
        let place_of: Vec<u32> = self
            .vertices
            .iter()
            .map(|vertex| {
                *places.entry(frame_bits(vertex)).or_insert_with(|| {
                    sums.push(([DVec3::ZERO; 2], 0.0));
                    sums.len() as u32 - 1
                })
            })
            .collect();
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|vertex| self.base(vertex));
            let [d1, d2]: [DVec2; 2] = [b.uv - a.uv, c.uv - a.uv];
            let area = (b.position - a.position).cross(c.position - a.position).length();
            let in_texture = d1.perp_dot(d2);
            let turns_at = |at: DVec3| {
                let [n1, n2] = if self.is_by_angle {
                    let [to_a, to_b, to_c] = [a, b, c].map(|corner| {
                        direction::toward(at.normalize_or_zero(), corner.normal.normalize_or_zero())
                    });
                    [to_b - to_a, to_c - to_a]
                } else {
                    [b.normal - a.normal, c.normal - a.normal]
                };
                [(n1 * d2.y - n2 * d1.y) / in_texture, (n2 * d1.x - n1 * d2.x) / in_texture]
            };
            for vertex in corners {
                let turns = turns_at(self.base(*vertex).normal);
                // Triangles without an area in the texture define no derivatives.
                if !turns.iter().all(|turn| turn.is_finite()) {
                    continue;
                }
                let (sum, weights) = &mut sums[place_of[*vertex as usize] as usize];
                *sum = [sum[0] + turns[0] * area, sum[1] + turns[1] * area];
                *weights += area;
            }
        }
        let mean = |place: &u32| {
            let (sum, weights) = sums[*place as usize];
            sum.map(|sum| if weights > 0.0 { (sum / weights).as_vec3() } else { Vec3::ZERO })
        };
        place_of.iter().map(mean).collect()
    }
}

/// Returns the first vertex in use at the position of each vertex.
fn first_used(point_of: &[u32], used: &[u32]) -> Vec<u32> {
    let mut first = vec![UNUSED; point_of.len()];
    for &vertex in used {
        let of_point = &mut first[point_of[vertex as usize] as usize];
        *of_point = vertex.min(*of_point);
    }
    point_of.iter().map(|&point| first[point as usize]).collect()
}

/// Returns one direction of displacement for each position. Where all normals there are the same,
/// it is that normal. At hard edges it follows from the sum `S` of the normals, weighted by the
/// angles of their triangles. Its length is such that the faces on both sides move by the
/// displacement: `S W / |S|²`, `W` the sum of the weights. It is at most twice as long as a normal.
fn welded_directions(mesh: &Mesh, point_of: &[u32]) -> Vec<Vec3> {
    let vertices = mesh.vertices();
    let differs = |at: usize| vertices[at].normal != vertices[point_of[at] as usize].normal;
    let mut is_hard = vec![false; vertices.len()];
    for at in (0..vertices.len()).filter(|&at| differs(at)) {
        is_hard[point_of[at] as usize] = true;
    }
    let mut sums: HashMap<u32, (DVec3, f64)> = HashMap::new();
    for corners in mesh.triangles() {
        let points = corners.map(|vertex| vertices[vertex as usize].position.as_dvec3());
        for (k, &vertex) in corners.iter().enumerate() {
            let point = point_of[vertex as usize];
            if is_hard[point as usize] {
                let angle = (points[(k + 1) % 3] - points[k]).angle_between(points[(k + 2) % 3] - points[k]);
                let angle = if angle.is_finite() { angle } else { 0.0 };
                let (sum, weights) = sums.entry(point).or_default();
                *sum += vertices[vertex as usize].normal.as_dvec3() * angle;
                *weights += angle;
            }
        }
    }
    let direction = |at: usize| match sums.get(&point_of[at]) {
        Some((sum, weights)) => {
            let along = sum.try_normalize().unwrap_or(vertices[at].normal.as_dvec3());
            (along * (weights / sum.length()).clamp(1.0, LONGEST)).as_vec3()
        }
        None => vertices[at].normal,
    };
    (0..vertices.len()).map(direction).collect()
}
