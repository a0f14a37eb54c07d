//! Closed tubes: rings of points, joined by triangles.

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::{Mesh, Vertex};

/// End of a tube.
#[derive(Clone, Copy)]
pub(super) enum End {
    /// A flat cap around this point.
    Cap(DVec3),
    /// A tip at this point.
    Tip(DVec3),
}

/// Closed parts of a mesh under construction.
#[derive(Default)]
pub(super) struct Parts {
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
}

/// A number that goes from 0 to 1 and back while `at` goes from 0 to `whole`.
fn there_and_back(at: usize, whole: usize) -> f32 {
    1.0 - (1.0 - 2.0 * at as f32 / whole as f32).abs()
}

impl Parts {
    /// Adds a tube of rings with as many points each. With `ends` it is closed by them, otherwise the
    /// last ring is joined to the first. An even number of points a ring, and of rings in a closed
    /// tube, keeps texture coordinates apart.
    pub fn tube(&mut self, rings: &[Vec<DVec3>], ends: Option<[End; 2]>) {
        let first = self.triangles.len();
        let sides = rings.first().map_or(0, Vec::len);
        let start = self.positions.len();
        for (at, ring) in rings.iter().enumerate() {
            let along = match ends {
                Some(_) => 0.1 + 0.8 * at as f32 / (rings.len() - 1).max(1) as f32,
                None => there_and_back(at, rings.len()),
            };
            for (side, point) in ring.iter().enumerate() {
                self.positions.push(point.as_vec3());
                self.uvs.push(Vec2::new(along, there_and_back(side, sides)));
            }
        }
        let corner = |ring: usize, side: usize| (start + ring % rings.len() * sides + side % sides) as u32;
        let joined = if ends.is_some() { rings.len() - 1 } else { rings.len() };
        for ring in 0..joined {
            for side in 0..sides {
                let [a, b] = [corner(ring, side), corner(ring, side + 1)];
                let [c, d] = [corner(ring + 1, side + 1), corner(ring + 1, side)];
                self.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        for (end, along, ring) in
            ends.into_iter().flatten().zip([0.0, 1.0]).zip([0, rings.len() - 1]).map(|((a, b), c)| (a, b, c))
        {
            let (End::Cap(point) | End::Tip(point)) = end;
            let centre = self.positions.len() as u32;
            self.positions.push(point.as_vec3());
            self.uvs.push(Vec2::new(along, 0.5));
            for side in 0..sides {
                let [a, b] = [corner(ring, side), corner(ring, side + 1)];
                self.triangles.push(if ring == 0 { [b, a, centre] } else { [a, b, centre] });
            }
        }
        // Six times the volume inside is positive if the triangles look outward.
        let at = |corner: u32| self.positions[corner as usize].as_dvec3();
        let volume =
            self.triangles[first..].iter().map(|corners| corners.map(at)).map(|[a, b, c]| a.dot(b.cross(c)));
        if volume.sum::<f64>() < 0.0 {
            self.triangles[first..].iter_mut().for_each(|corners| corners.swap(1, 2));
        }
    }

    /// Returns all parts as one mesh with smooth normals.
    pub fn finish(self) -> Mesh {
        let mut normals = vec![DVec3::ZERO; self.positions.len()];
        for corners in &self.triangles {
            let [a, b, c] = corners.map(|corner| self.positions[corner as usize].as_dvec3());
            let normal = (b - a).cross(c - a);
            corners.iter().for_each(|corner| normals[*corner as usize] += normal);
        }
        let vertices = self.positions.iter().zip(&self.uvs).zip(normals).map(|((position, uv), normal)| {
            let normal = normal.try_normalize().unwrap_or(DVec3::Y);
            let tangent = normal.any_orthonormal_vector();
            Vertex {
                position: *position,
                normal: normal.as_vec3(),
                tangent: tangent.as_vec3(),
                bitangent: tangent.cross(normal).as_vec3(),
                uv: *uv,
            }
        });
        let mesh = Mesh::new(vertices.collect(), self.triangles);
        // All corners are vertices of the lists, all numbers are finite, and triangles were counted
        // before any was made.
        mesh.unwrap_or_else(|error| unreachable!("{error}"))
    }
}
