//! Grids over parametrised surfaces, from which the built-in meshes are built.

use super::{Mesh, Vertex};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A point of a parametrised surface with its derivatives.
#[derive(Clone, Copy)]
pub(super) struct SurfacePoint {
    pub position: DVec3,
    /// Unit outward normal.
    pub normal: DVec3,
    /// Derivative of the position by `u`.
    pub du: DVec3,
    /// Derivative of the position by `v`.
    pub dv: DVec3,
    pub uv: DVec2,
}

/// A mesh under construction.
#[derive(Default)]
pub(super) struct Builder {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
}

impl Builder {
    /// Adds a vertex and returns its index.
    pub fn vertex(&mut self, point: SurfacePoint) -> u32 {
        // The largest built-in mesh, a plane or torus of MAX_DIVISIONS², is far below 2^32
        // vertices.
        let index = self.vertices.len() as u32;
        self.vertices.push(Vertex {
            position: point.position.as_vec3(),
            normal: point.normal.as_vec3(),
            tangent: point.du.as_vec3(),
            bitangent: point.dv.as_vec3(),
            uv: point.uv.as_vec2(),
        });
        index
    }

    /// Adds a triangle, counter-clockwise seen from outside.
    pub fn triangle(&mut self, corners: [u32; 3]) {
        self.triangles.push(corners);
    }

    /// Adds a grid of `columns` x `rows` quads. Vertex `(i, j)`, with `i` along growing `u` and `j`
    /// along growing `v`, is `point(i, j)`.
    pub fn grid(&mut self, columns: u32, rows: u32, point: impl Fn(u32, u32) -> SurfacePoint) {
        let first = self.vertices.len() as u32;
        for j in 0..=rows {
            for i in 0..=columns {
                self.vertex(point(i, j));
            }
        }
        for j in 0..rows {
            for i in 0..columns {
                let top_left = first + j * (columns + 1) + i;
                let bottom_left = top_left + columns + 1;
                self.triangle([top_left, bottom_left, bottom_left + 1]);
                self.triangle([top_left, bottom_left + 1, top_left + 1]);
            }
        }
    }

    /// Returns the finished mesh.
    pub fn finish(self) -> Mesh {
        Mesh { vertices: self.vertices, triangles: self.triangles }
    }
}

/// Sine and cosine of division `i` of `n` around a circle. It starts at `-π`, so that the middle of
/// a texture, `u = ½`, is at angle 0. Divisions 0 and `n` give the same bits, so that a closed
/// surface has no crack.
pub(super) fn turn(i: u32, n: u32) -> (f64, f64) {
    (TAU * f64::from(i % n) / f64::from(n) - PI).sin_cos()
}

/// Signed distance of division `i` of `n` of a unit length from the middle. Divisions `i` and
/// `n - i` are exact opposites, so that faces meet exactly in either direction.
pub(super) fn from_middle(i: u32, n: u32) -> f64 {
    (2.0 * f64::from(i) - f64::from(n)) / (2.0 * f64::from(n))
}

/// Position of division `i` of `n`, from 0 at the first to 1 at the last.
pub(super) fn part(i: u32, n: u32) -> f64 {
    f64::from(i) / f64::from(n)
}
