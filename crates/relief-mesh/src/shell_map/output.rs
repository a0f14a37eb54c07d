//! One mesh out of the pieces of all shells.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, MeshError, Vertex};

use super::cut::{PieceCorner, Pieces};
use super::shell::Shell;

/// A place with the motif's normal there, and the base's texture coordinates, by their bits.
type Key = ([u32; 3], [u32; 3], [u32; 2]);

/// What is shared by corners at one place.
#[derive(Default)]
pub struct Output {
    places: HashMap<[u32; 3], u32>,
    vertices: HashMap<Key, u32>,
    made: Vec<Vertex>,
    /// The place of each vertex, and the sum of the normals there.
    place_of: Vec<u32>,
    sums: HashMap<([u32; 3], [u32; 3]), DVec3>,
    keys: Vec<([u32; 3], [u32; 3])>,
    triangles: Vec<[u32; 3]>,
}

impl Output {
    /// Adds the pieces of a shell.
    pub fn add(&mut self, shell: &Shell, pieces: &Pieces) {
        let numbers: Vec<u32> = pieces.corners.iter().map(|corner| self.vertex(shell, corner)).collect();
        for corners in &pieces.triangles {
            let corners = corners.map(|corner| numbers[corner as usize]);
            let [a, b, c] = corners.map(|corner| self.place_of[corner as usize]);
            // Places that are the same in `f32` take their triangle's other edges together.
            if a != b && b != c && c != a {
                self.triangles.push(corners);
            }
        }
    }

    fn vertex(&mut self, shell: &Shell, corner: &PieceCorner) -> u32 {
        let position = corner.position.as_vec3() + Vec3::ZERO;
        let motif_normal = corner.motif_normal.as_vec3() + Vec3::ZERO;
        let bits = |of: Vec3| of.to_array().map(f32::to_bits);
        let uv = corner.uv.as_vec2();
        let shared = (bits(position), bits(motif_normal));
        *self.sums.entry(shared).or_default() += corner.normal.normalize_or_zero();
        let count = self.places.len() as u32;
        let place = *self.places.entry(shared.0).or_insert(count);
        let key = (shared.0, shared.1, uv.to_array().map(f32::to_bits));
        *self.vertices.entry(key).or_insert_with(|| {
            let [tangent, bitangent] = shell.tangents(corner.weights);
            self.made.push(Vertex { position, normal: Vec3::Y, tangent, bitangent, uv });
            self.place_of.push(place);
            self.keys.push(shared);
            self.made.len() as u32 - 1
        })
    }

    /// Whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The mesh, and its edges with an odd number of triangles.
    pub fn finish(mut self) -> Result<(Mesh, u64), MeshError> {
        for (vertex, key) in self.made.iter_mut().zip(&self.keys) {
            let sum = self.sums[key].normalize_or_zero().as_vec3();
            vertex.normal = if sum == Vec3::ZERO { Vec3::Y } else { sum };
        }
        let mut edges: HashMap<[u32; 2], bool> = HashMap::new();
        for corners in &self.triangles {
            let places = corners.map(|corner| self.place_of[corner as usize]);
            for at in 0..3 {
                let (a, b) = (places[at], places[(at + 1) % 3]);
                *edges.entry([a.min(b), a.max(b)]).or_default() ^= true;
            }
        }
        let open = edges.values().filter(|is_odd| **is_odd).count() as u64;
        Ok((Mesh::new(self.made, self.triangles)?, open))
    }
}
