//! A triangle of the motif cut at the faces of a tetrahedron.
//!
//! The piece inside is convex. Its corners are corners of the triangle, places where an edge of the triangle
//! meets a face, and places where an edge of the tetrahedron meets the triangle. Each is known by signs of
//! determinants of given points, which are exact, so that all neighbours find the same corners.

use glam::{DVec2, DVec3};

use super::lattice::{Lattice, MotifTriangle, STEPS};
use super::predicates::{Point, volume};
use super::shell::{Shell, ShellCorner, TETRAHEDRA};

/// A corner of a piece.
#[derive(Clone, Copy, Debug)]
pub struct PieceCorner {
    pub position: DVec3,
    pub uv: DVec2,
    /// Weights of the base triangle's corners, in the shell's order.
    pub weights: [f64; 3],
    /// The motif's normal along `u`, `v` and the height.
    pub motif_normal: DVec3,
    /// The same in the world, of any length.
    pub normal: DVec3,
}

/// Pieces in a shell.
#[derive(Clone, Debug, Default)]
pub struct Pieces {
    pub corners: Vec<PieceCorner>,
    pub triangles: Vec<[u32; 3]>,
}

/// Edges of a tetrahedron by the places of their ends, and its faces, each beside its opposite corner.
const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];

/// Something lies exactly on something else: the motif must be moved.
struct Touches;

/// Puts the motif into a shell, in all tiles that it covers. `None` if something lies exactly on a face.
pub fn pieces(shell: &Shell, lattice: &Lattice) -> Option<Pieces> {
    let mut pieces = Pieces::default();
    let [low, high] = shell.extent();
    let [least, greatest] = lattice.extent;
    let tiles = |axis: usize| {
        let first = (low[axis] - greatest[axis]).div_euclid(STEPS);
        first..=(high[axis] - least[axis]).div_euclid(STEPS)
    };
    if lattice.triangles.is_empty() {
        return Some(pieces);
    }
    for j in tiles(1) {
        for i in tiles(0) {
            let in_tile = |at: [i64; 2]| [at[0] - i * STEPS, at[1] - j * STEPS];
            let cells = TETRAHEDRA.map(|corners| Cell::new(shell, corners, [i, j]));
            for triangle in lattice.within(in_tile(low), in_tile(high)) {
                for cell in &cells {
                    cut(shell, cell, triangle, &mut pieces).ok()?;
                }
            }
        }
    }
    Some(pieces)
}

/// A tetrahedron of a shell as a tile sees it.
struct Cell {
    corners: [ShellCorner; 4],
    points: [Point; 4],
    positions: [DVec3; 4],
    uvs: [DVec2; 4],
    /// The side of each face on which its opposite corner lies.
    inside: [bool; 4],
    normals: [DVec3; 3],
}

impl Cell {
    fn new(shell: &Shell, corners: [ShellCorner; 4], tile: [i64; 2]) -> Self {
        let points = corners.map(|corner| shell.point(corner, tile));
        let inside = [0, 1, 2, 3].map(|at| {
            let [a, b, c] = FACES[at].map(|corner| points[corner]);
            volume(a, b, c, points[at]) > 0
        });
        Self {
            corners,
            points,
            positions: corners.map(|corner| shell.position(corner)),
            uvs: corners.map(|corner| shell.uv(corner)),
            inside,
            normals: shell.normals_in(&corners),
        }
    }

    /// A corner of a piece by the weights of the cell's corners.
    fn corner(&self, weights: [f64; 4], position: DVec3, motif_normal: DVec3) -> PieceCorner {
        let mut of_base = [0.0; 3];
        for (corner, weight) in self.corners.iter().zip(weights) {
            of_base[corner.of] += weight;
        }
        let uv = self.uvs.iter().zip(weights).map(|(uv, weight)| *uv * weight).sum();
        let each = self.normals.iter().zip(motif_normal.to_array());
        let normal = each.map(|(column, part)| *column * part).sum();
        PieceCorner { position, uv, weights: of_base, motif_normal, normal }
    }
}

/// Adds the part of a triangle in a cell.
fn cut(shell: &Shell, cell: &Cell, triangle: &MotifTriangle, pieces: &mut Pieces) -> Result<(), Touches> {
    // For each face the determinants of the triangle's corners.
    let mut sides = [[0i128; 3]; 4];
    for (face, sides) in sides.iter_mut().enumerate() {
        let [a, b, c] = FACES[face].map(|corner| cell.points[corner]);
        *sides = triangle.points.map(|point| volume(a, b, c, point));
        if sides.contains(&0) {
            return Err(Touches);
        }
        if sides.iter().all(|side| (*side > 0) != cell.inside[face]) {
            return Ok(());
        }
    }
    let is_inside = |face: usize, corner: usize| (sides[face][corner] > 0) == cell.inside[face];
    let mut piece = Piece { cell, triangle, sides: &sides, links: Vec::new() };
    // Along the triangle's edges.
    for edge in 0..3 {
        let (from, to) = (edge, (edge + 1) % 3);
        let (mut begin, mut end) = (None, None);
        if (0..4).all(|face| is_inside(face, from)) {
            begin = Some(Corner::OfTriangle(from));
        }
        if (0..4).all(|face| is_inside(face, to)) {
            end = Some(Corner::OfTriangle(to));
        }
        for face in 0..4 {
            if is_inside(face, from) != is_inside(face, to) && piece.meets_face(edge, face)? {
                let there = if is_inside(face, to) { &mut begin } else { &mut end };
                *there = Some(Corner::OnFace(edge, face));
            }
        }
        if let (Some(begin), Some(end)) = (begin, end) {
            piece.links.push((begin, end));
        }
    }
    let of_triangle = piece.links.len();
    // Along the faces.
    let corner_sides = piece.sides_of_cell()?;
    let mut met = [false; 6];
    for (edge, ends) in EDGES.iter().enumerate() {
        let [a, b] = ends.map(|corner| corner_sides[corner] > 0);
        met[edge] = a != b && piece.is_met(*ends)?;
    }
    for face in 0..4 {
        let on_face = |corner: &Corner| matches!(corner, Corner::OnFace(_, of) if *of == face);
        let of_links = piece.links[..of_triangle].iter().flat_map(|(begin, end)| [*begin, *end]);
        let mut there: Vec<Corner> = of_links.filter(on_face).collect();
        let of_edges = (0..6).filter(|edge| met[*edge] && EDGES[*edge].iter().all(|corner| *corner != face));
        there.extend(of_edges.map(Corner::OnEdge));
        if let [a, b] = there[..] {
            piece.links.push((a, b));
        }
    }
    let Some(ring) = piece.ring(of_triangle, &corner_sides) else { return Ok(()) };
    let first = pieces.corners.len() as u32;
    pieces.corners.extend(ring.iter().map(|corner| piece.placed(*corner, &corner_sides)));
    let is_turned = shell.is_mirrored != shell.is_inverted();
    for at in 1..ring.len() as u32 - 1 {
        let [b, c] = if is_turned { [at + 1, at] } else { [at, at + 1] };
        pieces.triangles.push([first, first + b, first + c]);
    }
    Ok(())
}

/// A corner of a piece, by what it lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Corner {
    /// A corner of the triangle.
    OfTriangle(usize),
    /// Where an edge of the triangle meets a face.
    OnFace(usize, usize),
    /// Where an edge of the tetrahedron meets the triangle.
    OnEdge(usize),
}

/// The part of a triangle in a cell.
struct Piece<'a> {
    cell: &'a Cell,
    triangle: &'a MotifTriangle,
    sides: &'a [[i128; 3]; 4],
    /// Sides of the piece. Those along the triangle's edges come first, and run as they do.
    links: Vec<(Corner, Corner)>,
}

impl Piece<'_> {
    /// The ends of an edge in an order that all neighbours agree on.
    fn ends(&self, edge: usize) -> [usize; 2] {
        let (from, to) = (edge, (edge + 1) % 3);
        if self.triangle.places[from] < self.triangle.places[to] { [from, to] } else { [to, from] }
    }

    /// The determinants of an edge with the sides of a face, for the corners across from them.
    fn with_sides(&self, edge: usize, face: usize) -> [i128; 3] {
        let [p, q] = self.ends(edge).map(|corner| self.triangle.points[corner]);
        let [a, b, c] = FACES[face].map(|corner| self.cell.points[corner]);
        [volume(p, q, b, c), volume(p, q, c, a), volume(p, q, a, b)]
    }

    /// Whether an edge, whose ends lie on either side of a face, goes through it.
    fn meets_face(&self, edge: usize, face: usize) -> Result<bool, Touches> {
        let around = self.with_sides(edge, face);
        if around.contains(&0) {
            return Err(Touches);
        }
        Ok(around.iter().all(|part| *part > 0) || around.iter().all(|part| *part < 0))
    }

    /// The determinants of the cell's corners with the triangle.
    fn sides_of_cell(&self) -> Result<[i128; 4], Touches> {
        let [p, q, r] = self.triangle.points;
        let sides = self.cell.points.map(|point| volume(p, q, r, point));
        if sides.contains(&0) { Err(Touches) } else { Ok(sides) }
    }

    /// The determinants of an edge of the cell with the triangle's edges, for the corners across from
    /// them.
    fn around(&self, ends: [usize; 2]) -> [i128; 3] {
        let [a, b] = ends.map(|corner| self.cell.points[corner]);
        let [p, q, r] = self.triangle.points;
        [volume(a, b, q, r), volume(a, b, r, p), volume(a, b, p, q)]
    }

    /// Whether an edge of the cell, whose ends lie on either side of the triangle, goes through it.
    fn is_met(&self, ends: [usize; 2]) -> Result<bool, Touches> {
        let around = self.around(ends);
        if around.contains(&0) {
            return Err(Touches);
        }
        Ok(around.iter().all(|part| *part > 0) || around.iter().all(|part| *part < 0))
    }

    /// The corners in the triangle's turn; `None` if there is no piece.
    fn ring(&self, of_triangle: usize, corner_sides: &[i128; 4]) -> Option<Vec<Corner>> {
        let first = *self.links.first()?;
        let (begin, mut at) = if of_triangle > 0 || self.runs_with_triangle(first, corner_sides) {
            first
        } else {
            (first.1, first.0)
        };
        let mut ring = vec![begin, at];
        let mut last = 0;
        while at != begin {
            let is_next =
                |number: usize| number != last && [self.links[number].0, self.links[number].1].contains(&at);
            let next = (0..self.links.len()).find(|number| is_next(*number))?;
            let (a, b) = self.links[next];
            at = if a == at { b } else { a };
            last = next;
            ring.push(at);
        }
        ring.pop();
        (ring.len() >= 3).then_some(ring)
    }

    /// Whether a side between two edges of the cell runs as the triangle turns.
    fn runs_with_triangle(&self, (from, to): (Corner, Corner), corner_sides: &[i128; 4]) -> bool {
        let (Corner::OnEdge(from), Corner::OnEdge(to)) = (from, to) else { return true };
        let ([a, b], [c, d]) = (EDGES[from], EDGES[to]);
        let shared = if c == a || d == a { a } else { b };
        let (x, y) = (a + b - shared, c + d - shared);
        let face = 6 - x - y - shared;
        let [px, py, ps, opposite] = [x, y, shared, face].map(|corner| self.cell.points[corner]);
        let looks_out = volume(px, py, ps, opposite) < 0;
        looks_out == (corner_sides[shared] > 0)
    }

    /// A corner at its place. Places on faces and edges are computed from these alone.
    fn placed(&self, corner: Corner, corner_sides: &[i128; 4]) -> PieceCorner {
        let Self { cell, triangle, .. } = self;
        match corner {
            Corner::OfTriangle(number) => {
                let weights = parts([0, 1, 2, 3].map(|face| {
                    let side = self.sides[face][number];
                    if cell.inside[face] { side } else { -side }
                }));
                let position = cell.positions.iter().zip(weights).map(|(at, weight)| *at * weight).sum();
                cell.corner(weights, position, triangle.normals[number])
            }
            Corner::OnFace(edge, face) => {
                let on_face = parts(self.with_sides(edge, face));
                let mut weights = [0.0; 4];
                let mut position = DVec3::ZERO;
                for (corner, weight) in FACES[face].into_iter().zip(on_face) {
                    weights[corner] = weight;
                    position += cell.positions[corner] * weight;
                }
                let ends = self.ends(edge);
                let [p, q] = parts(ends.map(|corner| self.sides[face][corner].abs()));
                // The nearer an end is to the face, the more it weighs.
                let normal = triangle.normals[ends[0]] * q + triangle.normals[ends[1]] * p;
                cell.corner(weights, position, normal)
            }
            Corner::OnEdge(edge) => {
                let ends = EDGES[edge];
                let [a, b] = parts(ends.map(|corner| corner_sides[corner].abs()));
                let mut weights = [0.0; 4];
                (weights[ends[0]], weights[ends[1]]) = (b, a);
                let position = cell.positions[ends[0]] * b + cell.positions[ends[1]] * a;
                let of_corners = parts(self.around(ends));
                let each = triangle.normals.iter().zip(of_corners);
                cell.corner(weights, position, each.map(|(normal, weight)| *normal * weight).sum())
            }
        }
    }
}

/// Numbers of one sign as parts of their sum.
fn parts<const N: usize>(numbers: [i128; N]) -> [f64; N] {
    let sum = numbers.iter().sum::<i128>() as f64;
    numbers.map(|number| number as f64 / sum)
}
