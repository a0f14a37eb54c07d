//! Test of a mesh for cracks.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use glam::Vec3;
use relief_core::mesh::Mesh;

use crate::point;

/// Result of a crack test.
///
/// An edge is identified by the bits of its ends' positions. A triangle runs along each of its
/// sides in one of two ways. Where the surface continues, an edge has two sides, which run opposite
/// ways. Sides whose ends have the same position are ignored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cracks {
    /// Number of tested triangles.
    pub triangles: u64,
    /// Edges with one side: the border of a sheet, or a crack.
    pub open: u64,
    /// Edges with more than two sides, or with two that run the same way.
    pub branching: u64,
    /// Components that are connected by edges.
    pub pieces: u64,
}

impl Cracks {
    /// Returns whether each side of a triangle has an opposite, so that there is an inside and an
    /// outside.
    pub fn is_closed(&self) -> bool {
        self.open == 0 && self.branching == 0
    }
}

/// An edge by the bits of its ends, the lesser first.
type Ends = [[u32; 3]; 2];

/// Number of an edge's sides that run forth and back, and a component of the mesh at the edge.
#[derive(Clone, Copy, Debug, Default)]
struct Sides {
    ways: [u32; 2],
    piece: u32,
}

impl Sides {
    fn is_whole(&self) -> bool {
        self.ways == [1, 1]
    }
}

/// Test for cracks in triangles that arrive in parts.
///
/// An edge with both sides in one part is finished. Other edges are stored until a later part has
/// their second side, so that memory grows with the borders between parts. A mesh added in one part
/// is tested completely. In a mesh of several parts, further sides of a finished edge may come in a
/// later part. They count as an edge of their own, and the branch is missed.
#[derive(Clone, Debug, Default)]
pub struct CrackTest {
    edges: Map<Ends, Sides>,
    pieces: Sets,
    /// Components without unfinished edges.
    whole: u64,
    triangles: u64,
}

/// Part of a mesh, tested by itself. [`CrackTest::add`] joins parts.
#[derive(Clone, Debug, Default)]
pub struct CrackPart {
    /// Unfinished edges.
    edges: Vec<(Ends, Sides)>,
    /// Number of components that these edges belong to.
    pieces: u32,
    whole: u64,
    triangles: u64,
}

impl CrackTest {
    /// Returns the cracks of a whole mesh.
    pub fn of_mesh(mesh: &Mesh) -> Cracks {
        let positions: Vec<Vec3> = mesh.vertices().iter().map(|vertex| vertex.position).collect();
        Self::of_part(CrackPart::of(&positions, mesh.triangles()))
    }

    /// Returns the cracks of triangles, given by the positions of their corners.
    pub fn of_triangles(triangles: impl IntoIterator<Item = [Vec3; 3]>) -> Cracks {
        let positions: Vec<Vec3> = triangles.into_iter().flatten().collect();
        let corners: Vec<[u32; 3]> =
            (0..positions.len() as u32 / 3).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect();
        Self::of_part(CrackPart::of(&positions, &corners))
    }

    fn of_part(part: CrackPart) -> Cracks {
        let mut test = Self::default();
        test.add(part);
        test.finish()
    }

    /// Adds a part.
    pub fn add(&mut self, part: CrackPart) {
        self.triangles += part.triangles;
        self.whole += part.whole;
        let first = self.pieces.add(part.pieces);
        for (ends, sides) in part.edges {
            let here = Sides { piece: first + sides.piece, ..sides };
            let known = self.edges.entry(ends).or_insert(Sides { ways: [0; 2], piece: here.piece });
            known.ways = [known.ways[0] + here.ways[0], known.ways[1] + here.ways[1]];
            self.pieces.join(known.piece, here.piece);
            if known.is_whole() {
                self.edges.remove(&ends);
            }
        }
    }

    /// Returns the result, once all parts are added.
    pub fn finish(mut self) -> Cracks {
        let open = self.edges.values().filter(|sides| sides.ways[0] + sides.ways[1] == 1).count() as u64;
        let branching = self.edges.len() as u64 - open;
        let pieces = self.whole + self.pieces.count();
        Cracks { triangles: self.triangles, open, branching, pieces }
    }
}

impl CrackPart {
    /// Tests a part. `triangles` holds the corners of each triangle as indices into `positions`.
    /// Equal positions may occur more than once.
    pub fn of(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let mut known = Positions::with_capacity(positions.len());
        let numbers: Vec<u32> =
            positions.iter().map(|position| known.number(point::bits(*position))).collect();
        let (mut sets, mut around) = (Sets::default(), Vec::with_capacity(3 * triangles.len()));
        for corners in triangles {
            let triangle = sets.add(1);
            let [a, b, c] = *corners;
            let [a, b, c] = [numbers[a as usize], numbers[b as usize], numbers[c as usize]];
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if from != to {
                    let way = u32::from(from > to);
                    around.push(Side { ends: [from.min(to), from.max(to)], triangle, way });
                }
            }
        }
        let count = sets.0.len() as u64;
        let mut left: Vec<(Ends, Sides)> = Vec::new();
        for of_edge in by_ends(&around, known.bits.len()).chunk_by(|a, b| a.ends == b.ends) {
            let mut sides = Sides { ways: [0; 2], piece: of_edge[0].triangle };
            for side in of_edge {
                sides.ways[side.way as usize] += 1;
                sets.join(sides.piece, side.triangle);
            }
            if !sides.is_whole() {
                let mut ends = of_edge[0].ends.map(|place| known.bits[place as usize]);
                if ends[1] < ends[0] {
                    ends.swap(0, 1);
                    sides.ways.swap(0, 1);
                }
                left.push((ends, sides));
            }
        }
        let all = sets.count();
        left.sort_unstable_by_key(|(ends, _)| *ends);
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        for (_, sides) in &mut left {
            let next = numbers.len() as u32;
            sides.piece = *numbers.entry(sets.least(sides.piece)).or_insert(next);
        }
        let pieces = numbers.len() as u32;
        Self { edges: left, pieces, whole: all - u64::from(pieces), triangles: count }
    }
}

/// Positions by their bits, numbered in order of appearance.
struct Positions {
    numbers: Map<[u32; 3], u32>,
    bits: Vec<[u32; 3]>,
}

impl Positions {
    fn with_capacity(places: usize) -> Self {
        let numbers = Map::with_capacity_and_hasher(places, Default::default());
        Self { numbers, bits: Vec::with_capacity(places) }
    }

    fn number(&mut self, bits: [u32; 3]) -> u32 {
        *self.numbers.entry(bits).or_insert_with(|| {
            self.bits.push(bits);
            self.bits.len() as u32 - 1
        })
    }
}

/// Side of a triangle by the numbers of its ends' positions, the lesser first. `way` is 1 where it
/// runs from the greater to the lesser.
#[derive(Clone, Copy, Debug, Default)]
struct Side {
    ends: [u32; 2],
    triangle: u32,
    way: u32,
}

/// Returns the sides grouped by their ends. A counting sort by the first end leaves a few at a time
/// to sort by the other end.
fn by_ends(sides: &[Side], places: usize) -> Vec<Side> {
    let mut ends = vec![0_usize; places];
    for side in sides {
        ends[side.ends[0] as usize] += 1;
    }
    let mut sum = 0;
    for end in &mut ends {
        sum += *end;
        *end = sum;
    }
    let mut sorted = vec![Side::default(); sides.len()];
    for side in sides {
        let at = &mut ends[side.ends[0] as usize];
        *at -= 1;
        sorted[*at] = *side;
    }
    // Each place's sides begin now where its count ends.
    let nexts = ends.iter().skip(1).copied().chain([sides.len()]);
    for (from, to) in ends.iter().copied().zip(nexts) {
        sorted[from..to].sort_unstable_by_key(|side| (side.ends[1], side.triangle));
    }
    sorted
}

/// Disjoint sets of numbers (union-find).
#[derive(Clone, Debug, Default)]
struct Sets(Vec<u32>);

impl Sets {
    /// Adds `count` sets of one number each, and returns the first number.
    fn add(&mut self, count: u32) -> u32 {
        let first = self.0.len() as u32;
        self.0.extend(first..first + count);
        first
    }

    fn least(&mut self, number: u32) -> u32 {
        let mut at = number;
        while self.0[at as usize] != at {
            let above = self.0[at as usize];
            self.0[at as usize] = self.0[above as usize];
            at = above;
        }
        at
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.least(a), self.least(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    fn count(&mut self) -> u64 {
        self.0.iter().enumerate().filter(|(at, least)| *at as u32 == **least).count() as u64
    }
}

type Map<K, V> = HashMap<K, V, BuildHasherDefault<Mixing>>;

/// Hasher for bits of positions. They are many, and nobody chooses them to collide.
#[derive(Clone, Copy, Debug, Default)]
struct Mixing(u64);

impl Hasher for Mixing {
    fn finish(&self) -> u64 {
        // The low bits choose the place in a map.
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(word.into());
    }

    fn write_u64(&mut self, word: u64) {
        const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
        self.0 = (self.0.rotate_left(29) ^ word).wrapping_mul(ODD);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::mesh::{cube, square};

    fn points(mesh: &Mesh) -> Vec<[Vec3; 3]> {
        let position = |corner: u32| mesh.vertices()[corner as usize].position;
        mesh.triangles().iter().map(|corners| corners.map(position)).collect()
    }

    #[test]
    fn closed_open_and_branching_meshes_are_distinguished() {
        let closed = CrackTest::of_mesh(&cube(3).expect("a mesh"));
        assert_eq!(closed, Cracks { triangles: 108, open: 0, branching: 0, pieces: 1 });
        assert!(closed.is_closed());
        let sheet = CrackTest::of_mesh(&square(4).expect("a mesh"));
        assert_eq!((sheet.open, sheet.branching, sheet.pieces, sheet.is_closed()), (16, 0, 1, false));
        let cube = points(&cube(1).expect("a mesh"));
        let mut turned = cube.clone();
        turned[0].swap(0, 1);
        assert_eq!(CrackTest::of_triangles(turned).branching, 3);
        let twice: Vec<_> = cube.iter().chain(&cube).copied().collect();
        assert_eq!(CrackTest::of_triangles(twice).branching, 18);
        let beside: Vec<_> = cube.iter().map(|corners| corners.map(|point| point + 3.0 * Vec3::X)).collect();
        let two = CrackTest::of_triangles(cube.iter().chain(&beside).copied());
        assert_eq!((two.pieces, two.is_closed()), (2, true));
        assert_eq!(CrackTest::of_triangles([]), Cracks::default());
    }

    #[test]
    fn a_vertex_moved_by_one_ulp_is_a_crack() {
        let mesh = points(&cube(4).expect("a mesh"));
        for triangle in [0, 17, 100] {
            for corner in 0..3 {
                let mut moved = mesh.clone();
                let point = &mut moved[triangle][corner];
                point.y = f32::from_bits(point.y.to_bits() + 1);
                assert_eq!(CrackTest::of_triangles(moved).open, 4, "{triangle} {corner}");
            }
        }
    }

    #[test]
    fn parts_make_what_the_whole_does() {
        for mesh in [cube(5).expect("a mesh"), square(7).expect("a mesh")] {
            let all = points(&mesh);
            let whole = CrackTest::of_triangles(all.iter().copied());
            for size in [1, 3, 50] {
                let mut test = CrackTest::default();
                for part in all.chunks(size) {
                    let positions: Vec<Vec3> = part.as_flattened().to_vec();
                    let corners: Vec<[u32; 3]> =
                        (0..part.len() as u32).map(|at| [0, 1, 2].map(|corner| 3 * at + corner)).collect();
                    test.add(CrackPart::of(&positions, &corners));
                }
                assert_eq!(test.finish(), whole, "{size}");
            }
        }
    }

    #[test]
    fn triangles_without_an_area_are_no_cracks() {
        let [a, b, c, d] = [Vec3::ZERO, Vec3::X, Vec3::Y, 0.5 * Vec3::X];
        // A flat triangle between two halves: without it there are cracks.
        let parts = [[a, d, c], [d, b, c], [a, b, d]];
        let rest = [[b, a, c]];
        assert!(CrackTest::of_triangles(parts.into_iter().chain(rest)).is_closed());
        assert!(!CrackTest::of_triangles(parts[..2].iter().chain(&rest).copied()).is_closed());
        assert!(CrackTest::of_triangles(parts.into_iter().chain(rest).chain([[a, a, b]])).open == 0);
    }
}
