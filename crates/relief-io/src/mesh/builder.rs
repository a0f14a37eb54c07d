//! Builder of a mesh while it is read, within a limit of memory.

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::{RawCorner, RawMesh};

use super::polygon::{self, Triangulated};
use super::up::Up;
use crate::{ReadProblem, Remark};

/// Memory of a normal and of texture coordinates, in lists that double as they grow.
const NORMAL_BYTES: u64 = 3 * size_of::<Vec3>() as u64;
const UV_BYTES: u64 = 3 * size_of::<Vec2>() as u64;

/// Collects positions, normals, texture coordinates and triangles, and counts the memory that they
/// take and will take.
pub(super) struct Builder {
    raw: RawMesh,
    /// Axis that points up in the file.
    pub up: Up,
    left: u64,
    limit: u64,
    /// Notes on the pictures in the file.
    pub notes: Vec<Remark>,
}

impl Builder {
    /// Creates an empty builder that may use `limit` bytes.
    pub fn new(limit: u64) -> Self {
        Self { raw: RawMesh::default(), up: Up::Y, left: limit, limit, notes: Vec::new() }
    }

    /// Counts bytes before they are allocated.
    pub fn take(&mut self, bytes: u64) -> Result<(), ReadProblem> {
        self.left = self.left.checked_sub(bytes).ok_or(ReadProblem::MeshMemory { limit: self.limit })?;
        Ok(())
    }

    /// Returns the bytes of something that is freed.
    pub fn give_back(&mut self, bytes: u64) {
        self.left = self.left.saturating_add(bytes).min(self.limit);
    }

    /// Bytes that may still be allocated.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Adds a position and returns its index.
    pub fn position(&mut self, position: Vec3) -> Result<u32, ReadProblem> {
        self.take(RawMesh::BYTES_PER_POSITION)?;
        let position = self.up.with_y_up(position);
        push(&mut self.raw.positions, position)
    }

    /// Adds a normal and returns its index.
    pub fn normal(&mut self, normal: Vec3) -> Result<u32, ReadProblem> {
        self.take(NORMAL_BYTES)?;
        let normal = self.up.with_y_up(normal);
        push(&mut self.raw.normals, normal)
    }

    /// Adds texture coordinates and returns their index.
    pub fn uv(&mut self, uv: Vec2) -> Result<u32, ReadProblem> {
        self.take(UV_BYTES)?;
        push(&mut self.raw.uvs, uv)
    }

    /// Adds a triangle.
    pub fn triangle(&mut self, corners: [RawCorner; 3]) -> Result<(), ReadProblem> {
        self.take(RawMesh::BYTES_PER_TRIANGLE)?;
        push(&mut self.raw.triangles, corners).map(drop)
    }

    /// Refuses faces of too many corners, before they are collected.
    pub fn check_corners(count: usize) -> Result<(), ReadProblem> {
        if count <= polygon::MAX_CORNERS {
            return Ok(());
        }
        let what = format!("a face of more than {} corners", polygon::MAX_CORNERS);
        Err(ReadProblem::Unsupported { what, advice: "cut it into triangles" })
    }

    /// Adds a face of at least three corners, whose positions exist.
    pub fn face(&mut self, corners: &[RawCorner]) -> Result<(), ReadProblem> {
        if let &[a, b, c] = corners {
            return self.triangle([a, b, c]);
        }
        let position = |corner: &RawCorner| {
            self.raw.positions.get(corner.position as usize).map_or(DVec3::ZERO, |point| point.as_dvec3())
        };
        let points: Vec<DVec3> = corners.iter().map(position).collect();
        match polygon::triangulate(&points) {
            Triangulated::Triangles(triangles) => {
                triangles.into_iter().try_for_each(|places| self.triangle(places.map(|place| corners[place])))
            }
            Triangulated::TooComplex => Err(ReadProblem::Unsupported {
                what: format!("a face of {} corners that is not convex", corners.len()),
                advice: "cut it into triangles",
            }),
        }
    }

    /// Returns the mesh.
    pub fn finish(self) -> RawMesh {
        self.raw
    }
}

/// Adds to a list and returns the index; an error, not an abort, if the system has no more memory.
fn push<T>(list: &mut Vec<T>, value: T) -> Result<u32, ReadProblem> {
    let place = list.len();
    if place == list.capacity() {
        let needed = (place as u64).saturating_mul(2 * size_of::<T>() as u64);
        list.try_reserve(1).map_err(|_| ReadProblem::OutOfMemory { needed })?;
    }
    list.push(value);
    // A mesh whose numbers exceed 32 bits is refused when its frames are computed.
    Ok(u32::try_from(place).unwrap_or(RawCorner::NONE))
}
