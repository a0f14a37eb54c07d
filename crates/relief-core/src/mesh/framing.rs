//! Conversion of a mesh from a file to a mesh with normals and true tangent frames.
//!
//! Source of the frames: Szirmay-Kalos and Umenhoffer 2008, section 2, equations 4 to 7, for each
//! triangle. Each corner gets the mean of its triangles' frames, weighted by their angles.

use super::raw::{Framed, FramingError, MAX_METRES, RawCorner, RawMesh};
use super::topology::{HalfEdge, Sets, half_edges};
use super::{Mesh, MeshError, Vertex};
use crate::TangentFrame;
use glam::{DVec2, DVec3, Vec2, Vec3};
use std::collections::HashMap;

/// Ratio of a triangle's doubled area to its longest side squared, below which rounding determines
/// the direction of its normal or of its texture.
const SLIVER: f64 = 1e-6;

/// Rounding of an `f32`, relative.
const ROUNDING: f64 = f32::EPSILON as f64;

/// Relative difference in texture space up to which two sides of an edge count as one.
const SAME_EDGE: f64 = 1e-4;

/// Length of a sum of normals or tangents, relative to the greatest possible one, below which they
/// cancel out.
const CANCELLED: f64 = 1e-3;

/// Part of a mesh's area up to which triangles without a frame of their own or a neighbour's are
/// specks that cuts and rounding leave. Nobody sees which way a relief runs on them.
const SPECKS: f64 = 1e-6;

/// Contribution of a triangle to the averages at its corners.
struct Face {
    frame: TangentFrame,
    weights: [f64; 3],
}

impl RawMesh {
    /// Returns the mesh with normals and tangent frames.
    ///
    /// * Equal positions become one point. Triangles without an area are removed and counted. So
    ///   are triangles that repeat an earlier one, with the same corners and front.
    /// * **Normals** are normalised. A corner without one gets the mean of the normals of all
    ///   triangles at its point, weighted by their angles there. So relief has no gaps along edges.
    ///   If these cancel out, as on sheets with two fronts, the triangle's own normal is used.
    /// * **Tangents and bitangents** are the derivatives of the position by `u` and `v`, as long as
    ///   one tile. They are means, weighted by angles, over the triangles that share the corner's
    ///   normal and the texture. The directions, turned into the plane at right angles to the
    ///   normal, and the numbers of tiles per metre are averaged separately.
    /// * A texture continues across an edge if both sides have the same orientation and the same
    ///   vector from end to end. So mirrored halves have separate frames with opposite handedness.
    ///   If a tiled texture is cut, as at the back of a cylinder, both sides share one frame. If
    ///   the sides are rotated or stretched relative to each other, they have two.
    /// * Triangles whose texture coordinates have no area take the frames of their neighbours. Specks
    ///   without such a neighbour, a millionth of the mesh's area in all, take any frame.
    ///
    /// These frames carry lengths, which displacement needs. They differ from the orthonormal
    /// frames of MikkTSpace, in which many tangent-space normal maps are baked. On a texture
    /// without shear both have the same directions, but MikkTSpace's lengths do not match a tile.
    ///
    /// Framing takes at most [`Self::BYTES_PER_TRIANGLE`] and [`Self::BYTES_PER_POSITION`]. Equal
    /// meshes give equal bits.
    ///
    /// # Errors
    ///
    /// * A corner has an index that does not exist, or numbers that are not finite or too large.
    /// * No triangle has an area.
    /// * Triangles have no texture coordinates, or texture coordinates without an area and no
    ///   neighbour to take a frame from.
    /// * A tile of the texture is shorter than 1e-19 m.
    pub fn framed(mut self) -> Result<Framed, FramingError> {
        self.check()?;
        let (numbers, [degenerate, double]) = self.weld_and_drop();
        let count = self.triangles.len();
        if count == 0 {
            return Err(FramingError::NoTriangles);
        }
        let has_no_uv = |corners: &&[RawCorner; 3]| corners.iter().any(|corner| corner.uv == RawCorner::NONE);
        let missing = self.triangles.iter().filter(has_no_uv).count();
        if missing > 0 {
            return Err(FramingError::NoTextureCoordinates { missing, triangles: count });
        }
        let framing = Framing { normals: self.normals_of_points(), raw: &self };
        let (vertices, triangles) = framing.vertices_and_triangles()?;
        if let Some(at) = vertices.iter().position(|vertex| !vertex.has_lengths()) {
            return Err(MeshError::ShortTile(at).into());
        }
        Ok(Framed { mesh: Mesh::new(vertices, triangles)?, numbers, degenerate, double })
    }

    /// For each point, the sum of its triangles' unit normals weighted by angles, and the sum of
    /// the weights. Empty if every corner has a normal.
    fn normals_of_points(&self) -> Vec<(DVec3, f64)> {
        if self.triangles.iter().flatten().all(|corner| self.stored_normal(corner).is_some()) {
            return Vec::new();
        }
        let mut sums = vec![(DVec3::ZERO, 0.0); self.positions.len()];
        for corners in &self.triangles {
            let normal = self.cross(corners).normalize_or_zero();
            for (corner, weight) in corners.iter().zip(self.weights(corners)) {
                let (sum, weights) = &mut sums[corner.position as usize];
                *sum += normal * weight;
                *weights += weight;
            }
        }
        sums
    }

    /// Normalised normal of a corner, if the file has one.
    fn stored_normal(&self, corner: &RawCorner) -> Option<DVec3> {
        self.normals.get(corner.normal as usize)?.as_dvec3().try_normalize()
    }

    /// Angles of a triangle in radians. They are nearly 0 for a sliver, since rounding determines
    /// its normal.
    fn weights(&self, corners: &[RawCorner; 3]) -> [f64; 3] {
        let points = corners.map(|corner| self.positions[corner.position as usize].as_dvec3());
        let sides = [0, 1, 2].map(|place| points[(place + 1) % 3] - points[place]);
        let longest = sides.iter().map(|side| side.length_squared()).fold(0.0, f64::max);
        let twice_area = sides[0].cross(sides[1]).length();
        let factor = if twice_area <= SLIVER * longest { SLIVER } else { 1.0 };
        [0, 1, 2].map(|place| {
            let (forth, back) = (sides[place], -sides[(place + 2) % 3]);
            factor * forth.cross(back).length().atan2(forth.dot(back))
        })
    }

    fn uv(&self, corner: &RawCorner) -> DVec2 {
        self.uvs[corner.uv as usize].as_dvec2()
    }
}

/// A checked mesh during the computation of its frames.
struct Framing<'a> {
    raw: &'a RawMesh,
    normals: Vec<(DVec3, f64)>,
}

impl Framing<'_> {
    /// A corner by its number, counted over all triangles.
    fn corner(&self, number: u32) -> &RawCorner {
        &self.raw.triangles[number as usize / 3][number as usize % 3]
    }

    /// Unit normal at a corner.
    fn normal(&self, number: u32) -> Vec3 {
        let corner = self.corner(number);
        let stored = self.raw.stored_normal(corner);
        let normal = stored.unwrap_or_else(|| {
            let (sum, weights) = self.normals[corner.position as usize];
            let own = || self.raw.cross(&self.raw.triangles[number as usize / 3]).normalize_or_zero();
            if sum.length() > CANCELLED * weights { sum.normalize() } else { own() }
        });
        normal.as_vec3()
    }

    fn uv(&self, number: u32) -> Vec2 {
        self.raw.uvs[self.corner(number).uv as usize] + Vec2::ZERO
    }

    /// Frame of a triangle, unless its texture coordinates have no area beyond rounding.
    fn face(&self, triangle: usize) -> Option<Face> {
        let corners = &self.raw.triangles[triangle];
        let points = corners.map(|corner| self.raw.positions[corner.position as usize].as_dvec3());
        let uvs = corners.map(|corner| self.raw.uv(&corner));
        let sides = [0, 1, 2].map(|place| uvs[(place + 1) % 3] - uvs[place]);
        let longest = sides.iter().map(|side| side.length()).fold(0.0, f64::max);
        let farthest = uvs.iter().map(|uv| uv.length()).fold(0.0, f64::max);
        let area = sides[0].perp_dot(sides[1]).abs();
        if area <= (SLIVER * longest).max(ROUNDING * farthest) * longest {
            return None;
        }
        let frame = TangentFrame::of_triangle(points, uvs).ok()?;
        let longest_tile = frame.tangent.length().max(frame.bitangent.length());
        (longest_tile <= MAX_METRES).then(|| Face { frame, weights: self.raw.weights(corners) })
    }

    /// Whether a texture continues from one side of an edge to the other. The triangles must run
    /// along the edge in opposite directions, as neighbours of one surface do. Their textures must
    /// have the same orientation and the same vector from end to end.
    fn goes_on(&self, [a, b]: [&HalfEdge; 2]) -> bool {
        let (Some(first), Some(second)) = (self.face(a.triangle()), self.face(b.triangle())) else {
            return false;
        };
        let [ends, others] = [a, b].map(|half| half.corners(|corner| self.corner(corner).position));
        let runs_against = (ends[0] == a.from) != (others[0] == b.from);
        if !runs_against || orientation(&first) != orientation(&second) {
            return false;
        }
        let way = |[from, to]: [u32; 2]| self.raw.uv(self.corner(to)) - self.raw.uv(self.corner(from));
        let farthest = |[from, to]: [u32; 2]| {
            self.raw.uv(self.corner(to)).length().max(self.raw.uv(self.corner(from)).length())
        };
        let slack = SAME_EDGE * way(ends).length() + 4.0 * ROUNDING * farthest(ends).max(farthest(others));
        (way(ends) - way(others)).length() <= slack
    }

    /// Sets of the corners that share a frame.
    fn fans(&self) -> Sets {
        let triangles = &self.raw.triangles;
        let halves = half_edges(triangles.iter().map(|corners| corners.map(|corner| corner.position)));
        let mut fans = Sets::new(3 * triangles.len());
        for edge in halves.chunk_by(|a, b| a.points == b.points) {
            for pair in edge.windows(2) {
                if !self.goes_on([&pair[0], &pair[1]]) {
                    continue;
                }
                let [ends, others] = [pair[0], pair[1]].map(|half| half.corners(|c| self.corner(c).position));
                for (a, b) in ends.into_iter().zip(others) {
                    if self.normal(a) == self.normal(b) {
                        fans.join(a, b);
                    }
                }
            }
        }
        fans
    }

    fn vertices_and_triangles(&self) -> Result<(Vec<Vertex>, Vec<[u32; 3]>), FramingError> {
        let count = self.raw.triangles.len();
        let mut fans = self.fans();
        let fan_of: Vec<u32> = (0..3 * count as u32).map(|corner| fans.least(corner)).collect();
        drop(fans);
        let key =
            |corner: u32| (fan_of[corner as usize], self.uv(corner).to_array().map(f32::to_bits), corner);
        let framed = (0..count).filter(|&triangle| self.face(triangle).is_some());
        let mut order: Vec<u32> =
            framed.flat_map(|triangle| [0, 1, 2].map(|k| (3 * triangle + k) as u32)).collect();
        order.sort_unstable_by_key(|&corner| key(corner));
        let (mut vertices, mut triangles) = (Vec::new(), vec![[u32::MAX; 3]; count]);
        for fan in order.chunk_by(|&a, &b| fan_of[a as usize] == fan_of[b as usize]) {
            let normal = self.normal(fan[0]);
            let [mut tangent, mut bitangent] = [Mean::around(normal), Mean::around(normal)];
            for &corner in fan {
                let Some(face) = self.face(corner as usize / 3) else { continue };
                let weight = face.weights[corner as usize % 3];
                tangent.add(face.frame.tangent, weight);
                bitangent.add(face.frame.bitangent, weight);
            }
            let (tangent, bitangent) = (tangent.vector(), bitangent.vector());
            for alike in fan.chunk_by(|&a, &b| self.uv(a) == self.uv(b)) {
                let uv = self.uv(alike[0]);
                let position = self.raw.positions[self.corner(alike[0]).position as usize];
                for &corner in alike {
                    triangles[corner as usize / 3][corner as usize % 3] = vertices.len() as u32;
                }
                vertices.push(Vertex { position, normal, tangent, bitangent, uv });
            }
        }
        if order.len() < 3 * count {
            self.fill_from_neighbours(&mut vertices, &mut triangles)?;
        }
        Ok((vertices, triangles))
    }

    /// Gives corners of triangles without an area in the texture a frame: from a vertex at the same
    /// point, or from another corner of the triangle. [`SPECKS`] take the first vertex' frame.
    fn fill_from_neighbours(
        &self,
        vertices: &mut Vec<Vertex>,
        triangles: &mut [[u32; 3]],
    ) -> Result<(), FramingError> {
        let bits = |vector: Vec3| vector.to_array().map(f32::to_bits);
        let mut known = HashMap::new();
        for (at, vertex) in vertices.iter().enumerate() {
            known.entry(bits(vertex.position)).or_insert(at);
        }
        let corners_of = |triangle: usize| [0, 1, 2].map(|place| (3 * triangle + place) as u32);
        let position = |corner: u32| self.raw.positions[self.corner(corner).position as usize];
        let at_points =
            |triangle: usize| corners_of(triangle).map(|corner| known.get(&bits(position(corner))).copied());
        let frameless = triangles.iter().enumerate().filter(|(_, places)| places[0] == u32::MAX);
        let alone: Vec<usize> = frameless
            .map(|(triangle, _)| triangle)
            .filter(|&triangle| at_points(triangle).iter().all(Option::is_none))
            .collect();
        if let Some(&first) = alone.first() {
            let area = |triangle: usize| self.raw.cross(&self.raw.triangles[triangle]).length();
            let whole: f64 = (0..triangles.len()).map(area).sum();
            if vertices.is_empty()
                || alone.iter().map(|&triangle| area(triangle)).sum::<f64>() > SPECKS * whole
            {
                return Err(FramingError::NoTextureArea { first, count: alone.len() });
            }
        }
        for (triangle, places) in triangles.iter_mut().enumerate().filter(|(_, places)| places[0] == u32::MAX)
        {
            let (corners, at_points) = (corners_of(triangle), at_points(triangle));
            let any = at_points.into_iter().flatten().next().unwrap_or(0);
            for ((corner, at_point), place) in corners.into_iter().zip(at_points).zip(places) {
                let Vertex { tangent, bitangent, .. } = vertices[at_point.unwrap_or(any)];
                let normal = self.normal(corner);
                let [tangent, bitangent] =
                    [tangent, bitangent].map(|along| turned(along.as_dvec3(), normal.as_dvec3()).as_vec3());
                *place = vertices.len() as u32;
                vertices.push(Vertex {
                    position: position(corner),
                    normal,
                    tangent,
                    bitangent,
                    uv: self.uv(corner),
                });
            }
        }
        Ok(())
    }
}

/// Whether the texture is not mirrored, seen from the front.
fn orientation(face: &Face) -> bool {
    face.frame.handedness() > 0.0
}

/// Mean of tangents: the mean direction at right angles to a normal, with the mean number of tiles
/// per metre. (A mean of the lengths would be dominated by the longest, where a texture is almost
/// infinitely narrow.)
struct Mean {
    normal: DVec3,
    directions: DVec3,
    tiles_per_metre: f64,
    weights: f64,
    first: DVec3,
}

impl Mean {
    fn around(normal: Vec3) -> Self {
        let nothing = DVec3::ZERO;
        Self {
            normal: normal.as_dvec3(),
            directions: nothing,
            tiles_per_metre: 0.0,
            weights: 0.0,
            first: nothing,
        }
    }

    fn add(&mut self, tangent: DVec3, weight: f64) {
        let direction = turned(tangent, self.normal).normalize_or_zero();
        if self.weights == 0.0 {
            self.first = direction;
        }
        self.directions += direction * weight;
        self.tiles_per_metre += weight / tangent.length();
        self.weights += weight;
    }

    /// The mean. If the directions cancel out, it has the first direction.
    fn vector(&self) -> Vec3 {
        let is_clear = self.directions.length() > CANCELLED * self.weights;
        let direction = if is_clear { self.directions.normalize() } else { self.first };
        (direction * (self.weights / self.tiles_per_metre)).as_vec3()
    }
}

/// Turns a vector to be at right angles to a normal, with its length kept. A vector along the
/// normal does not change.
fn turned(vector: DVec3, normal: DVec3) -> DVec3 {
    let length = vector.length();
    let across = vector - normal * normal.dot(vector);
    if across.length() > SLIVER * length { across.normalize() * length } else { vector }
}
