//! Halving of base triangles along sides that are too long: see `Creases` and `near`.

use std::collections::{HashMap, HashSet};

use relief_core::Watch;
use relief_core::mesh::{Mesh, Vertex};

use super::creases::Creases;
use crate::error::MOST;
use crate::surface::Relief;
use crate::{Mesher, MesherError, point};

/// Number of triangles that are cut between two checks for cancellation.
const TRIANGLES_PER_CHECK: usize = 1 << 16;

/// Limits of triangles and memory, and the source of cancellation.
#[derive(Clone, Copy, Debug)]
pub struct Limits<'a> {
    /// Greatest number of triangles.
    pub most: u64,
    /// Greatest memory in bytes.
    pub max_bytes: u64,
    pub watch: Watch<'a>,
}

impl Limits<'_> {
    fn check(&self, triangles: u64) -> Result<(), MesherError> {
        let Self { most, max_bytes, .. } = *self;
        match triangles {
            too_many if too_many > MOST => Err(MesherError::TooLarge { vertices: 0, triangles }),
            too_many if too_many > most => Err(MesherError::MoreThan { most }),
            too_many if too_many.saturating_mul(Mesher::BYTES_PER_TRIANGLE) > max_bytes => {
                Err(MesherError::NoMemory { limit: max_bytes })
            }
            _ => Ok(()),
        }
    }

    fn check_cancelled(&self) -> Result<(), MesherError> {
        Ok(self.watch.check()?)
    }
}

/// Two positions of a mesh.
type Ends = [u32; 2];

/// Barycentric weights of a part's corners in the whole triangle: sums of powers of a half, and so
/// exact.
pub type PartWeights = [[f64; 3]; 3];

/// Mesh with halved sides.
#[derive(Debug)]
pub struct Halved {
    pub mesh: Mesh,
    /// The two vertices between which each vertex lies, beginning with the first vertex that was
    /// added.
    pub parents: Vec<[u32; 2]>,
    /// Triangle of the whole mesh to which each triangle belongs, in rising order.
    pub whole: Vec<u32>,
    /// Weights of each triangle's corners in that whole triangle.
    pub weights: Vec<PartWeights>,
}

/// Mesh while it is halved.
pub struct Halves<'a> {
    relief: &'a Relief,
    vertices: Vec<Vertex>,
    /// Position of each vertex, and the number of positions.
    points: Vec<u32>,
    count: u32,
    parents: Vec<[u32; 2]>,
    /// Vertex between two vertices of a triangle, and position between two positions.
    middles: HashMap<[u32; 2], u32>,
    middle_points: HashMap<[u32; 2], u32>,
}

/// Returns an error if a mesh has more long sides than can be halved.
pub fn check(mesh: &Mesh, relief: &Relief, limits: &Limits) -> Result<(), MesherError> {
    // Before memory is taken for the halves.
    let place = |vertex: u32| relief.place(mesh.vertices()[vertex as usize].uv.as_dvec2());
    let fewest = mesh.triangles().iter().map(|corners| Creases::fewest(corners.map(place)));
    limits.check(fewest.fold(0, u64::saturating_add))
}

/// Halves the sides of a mesh until none is too long. `long` returns the long sides of some
/// triangles, by the positions at their ends. Returns `None` if there is no such side. A side is
/// halved in all triangles that have it.
pub fn halved(
    mesh: &Mesh,
    relief: &Relief,
    limits: &Limits,
    long: impl Fn(&Halves, &[[u32; 3]]) -> HashSet<Ends>,
) -> Result<Option<Halved>, MesherError> {
    let points = mesh.welded();
    let mut halves = Halves {
        relief,
        vertices: mesh.vertices().to_vec(),
        count: points.len() as u32,
        points,
        parents: Vec::new(),
        middles: HashMap::new(),
        middle_points: HashMap::new(),
    };
    let mut triangles = mesh.triangles().to_vec();
    let mut whole: Vec<u32> = (0..triangles.len() as u32).collect();
    let mut weights = vec![point::CORNERS; triangles.len()];
    loop {
        let long = long(&halves, &triangles);
        if long.is_empty() {
            break;
        }
        let parts =
            |corners: &[u32; 3]| 1 + halves.are_long(*corners, &long).map(u64::from).iter().sum::<u64>();
        let count = triangles.iter().map(parts).sum();
        limits.check(count)?;
        let mut finer = Vec::with_capacity(count as usize);
        let mut parts = Vec::with_capacity(count as usize);
        let mut finer_weights = Vec::with_capacity(count as usize);
        for (at, ((corners, whole), weights)) in triangles.into_iter().zip(whole).zip(weights).enumerate() {
            if at % TRIANGLES_PER_CHECK == 0 {
                limits.check_cancelled()?;
            }
            let first = finer.len();
            halves.cut(corners, &long, &mut finer);
            parts.resize(finer.len(), whole);
            finer_weights.extend(finer[first..].iter().map(|part| halves.weights(corners, weights, *part)));
        }
        (triangles, whole, weights) = (finer, parts, finer_weights);
    }
    if halves.parents.is_empty() {
        return Ok(None);
    }
    let Halves { vertices, parents, .. } = halves;
    Ok(Some(Halved { mesh: Mesh::new(vertices, triangles)?, parents, whole, weights }))
}

/// Returns two numbers, the lower one first.
pub fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl Halves<'_> {
    /// Returns the place of a vertex in the map.
    fn place(&self, vertex: u32) -> [f64; 2] {
        self.relief.place(self.vertices[vertex as usize].uv.as_dvec2())
    }

    /// Returns the squared length of a side, in texels.
    fn square(&self, ends: [u32; 2]) -> f64 {
        let [a, b] = ends.map(|end| self.place(end));
        (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)
    }

    fn points_of(&self, ends: [u32; 2]) -> [u32; 2] {
        sorted(ends.map(|end| self.points[end as usize]))
    }

    /// Returns the sides of triangles that are too long, by their positions.
    pub fn sides(&self, triangles: &[[u32; 3]], is_long: impl Fn([u32; 2]) -> bool) -> HashSet<Ends> {
        let all = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let long = all.filter(|ends| is_long(*ends)).map(|ends| self.points_of(ends));
        // A side without a length has no middle.
        long.filter(|[a, b]| a != b).collect()
    }

    /// Returns the sides that are too long for their lattice.
    pub fn beyond(&self, creases: &Creases, triangles: &[[u32; 3]]) -> HashSet<Ends> {
        self.sides(triangles, |ends| creases.is_long(ends.map(|end| self.place(end))))
    }

    pub fn vertex(&self, vertex: u32) -> &Vertex {
        &self.vertices[vertex as usize]
    }

    /// Returns the vertex between two vertices.
    fn middle(&mut self, ends: [u32; 2]) -> u32 {
        let (ends, points) = (sorted(ends), self.points_of(ends));
        if let Some(middle) = self.middles.get(&ends) {
            return *middle;
        }
        let [a, b] = ends.map(|end| self.vertices[end as usize]);
        let number = self.vertices.len() as u32;
        self.vertices.push(Vertex {
            position: a.position * 0.5 + b.position * 0.5,
            normal: a.normal * 0.5 + b.normal * 0.5,
            tangent: a.tangent * 0.5 + b.tangent * 0.5,
            bitangent: a.bitangent * 0.5 + b.bitangent * 0.5,
            uv: a.uv * 0.5 + b.uv * 0.5,
        });
        let next = self.count;
        let point = *self.middle_points.entry(points).or_insert(next);
        self.count = self.count.max(point + 1);
        self.points.push(point);
        self.parents.push(ends);
        self.middles.insert(ends, number);
        number
    }

    /// Returns which sides of a triangle are long.
    fn are_long(&self, [a, b, c]: [u32; 3], long: &HashSet<Ends>) -> [bool; 3] {
        [[a, b], [b, c], [c, a]].map(|ends| long.contains(&self.points_of(ends)))
    }

    /// Returns the weights of the corners of a part that was cut out of a triangle with these
    /// weights.
    fn weights(&self, corners: [u32; 3], weights: PartWeights, part: [u32; 3]) -> PartWeights {
        part.map(|vertex| {
            let corner = |vertex: u32| corners.iter().position(|&corner| corner == vertex);
            if let Some(corner) = corner(vertex) {
                return weights[corner];
            }
            // The vertex is the middle of a side.
            let middle = (0..3).find(|&k| {
                let ends = sorted([corners[k], corners[(k + 1) % 3]]);
                self.middles.get(&ends) == Some(&vertex)
            });
            middle.map_or([0.0; 3], |k| {
                let [a, b] = [weights[k], weights[(k + 1) % 3]];
                [0, 1, 2].map(|of| 0.5 * a[of] + 0.5 * b[of])
            })
        })
    }

    /// Cuts a triangle at the middles of its long sides.
    fn cut(&mut self, [a, b, c]: [u32; 3], long: &HashSet<Ends>, into: &mut Vec<[u32; 3]>) {
        let is_long = self.are_long([a, b, c], long);
        // Turned so that the sides that are not cut come last.
        let turned = match is_long {
            [false, false, false] => return into.push([a, b, c]),
            [true, false, false] | [true, true, _] => [a, b, c],
            [false, true, _] => [b, c, a],
            [_, false, true] => [c, a, b],
        };
        let [a, b, c] = turned;
        let ab = self.middle([a, b]);
        match is_long.into_iter().filter(|is_long| *is_long).count() {
            1 => into.extend([[a, ab, c], [ab, b, c]]),
            2 => {
                let bc = self.middle([b, c]);
                into.push([ab, b, bc]);
                // The rest is cut along the shorter diagonal.
                if self.square([a, bc]) < self.square([ab, c]) {
                    into.extend([[a, ab, bc], [a, bc, c]]);
                } else {
                    into.extend([[a, ab, c], [ab, bc, c]]);
                }
            }
            _ => {
                let [bc, ca] = [self.middle([b, c]), self.middle([c, a])];
                into.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            }
        }
    }
}
