//! Normals from the triangles of the finished mesh.

use glam::Vec3;

/// Sums of the normals of triangles around each smooth vertex.
#[derive(Debug)]
pub struct Normals(Vec<Vec3>);

/// Bytes per vertex.
pub const BYTES_PER_VERTEX: u64 = size_of::<Vec3>() as u64;

impl Normals {
    pub fn new(vertices: u64) -> Self {
        Self(vec![Vec3::ZERO; vertices as usize])
    }

    /// Adds triangles, by their corners' positions and smooth numbers.
    pub fn add(&mut self, positions: impl Iterator<Item = [Vec3; 3]>, smooth: &[[u32; 3]]) {
        for (points, corners) in positions.zip(smooth) {
            let sides = [0, 1, 2].map(|k| points[(k + 1) % 3].as_dvec3() - points[k].as_dvec3());
            let Some(normal) = sides[0].cross(sides[1]).try_normalize() else { continue };
            for k in 0..3 {
                let angle = sides[k].angle_between(-sides[(k + 2) % 3]);
                self.0[corners[k] as usize] += (normal * angle).as_vec3();
            }
        }
    }

    /// Returns the unit normal of a vertex. Returns `own` where there is none, or where normals
    /// cancel each other out.
    pub fn of(&self, smooth: u32, own: Vec3) -> Vec3 {
        self.0[smooth as usize].try_normalize().unwrap_or(own)
    }
}
