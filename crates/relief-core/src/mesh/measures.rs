//! What a mesh is like: sizes, charts, edges, tiles, the angles between its normals, and where it folds.

use super::topology::{HalfEdge, Sets, half_edges, weld};
use super::{Mesh, Vertex};
use glam::{DVec3, Vec2, Vec3};

/// The least angle in degrees between normals that differ.
pub(super) const HARD_DEG: f64 = 0.1;

/// The least, the mean and the greatest of something.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The least.
    pub least: f64,
    /// The mean.
    pub mean: f64,
    /// The greatest.
    pub greatest: f64,
}

/// What [`Mesh::measures`] finds. Edges are counted between points, whatever vertices lie on them.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMeasures {
    /// The least and the greatest coordinates, in metres.
    pub bounds_m: [Vec3; 2],
    /// Vertices.
    pub vertices: usize,
    /// Different positions of vertices.
    pub points: usize,
    /// Triangles.
    pub triangles: usize,
    /// Parts that are connected in the texture: triangles that share edges with their texture coordinates.
    pub charts: usize,
    /// Triangles on which the texture is mirrored.
    pub mirrored: usize,
    /// Edges.
    pub edges: usize,
    /// Edges of one triangle.
    pub open_edges: usize,
    /// Edges of more than two triangles.
    pub branching_edges: usize,
    /// Edges on whose two sides texture coordinates differ.
    pub seams: usize,
    /// Edges on whose two sides normals differ.
    pub hard_edges: usize,
    /// Metres of a tile along `u` and along `v`, over the vertices.
    pub tile_m: [Spread; 2],
    /// The greatest angle in degrees between normals of a triangle, over the triangles.
    pub normal_angle_deg: Spread,
    /// The offsets in metres, inward and outward, between which no triangle is folded
    /// ([`Mesh::unfolded_range`]): infinite where none ever folds, both 0 where one is folded already.
    pub unfolded_m: [f64; 2],
    /// Triangles that are folded without any displacement.
    pub folded: usize,
}

impl Mesh {
    /// Measures the mesh. Takes about 60 bytes a triangle and 50 a vertex.
    pub fn measures(&self) -> MeshMeasures {
        let point_of = weld(self.vertices.iter().map(|vertex| vertex.position));
        let points = point_of.iter().enumerate().filter(|(at, point)| *at == **point as usize).count();
        let of_corner = |corner: u32| self.triangles[corner as usize / 3][corner as usize % 3];
        let halves =
            half_edges(self.triangles.iter().map(|corners| corners.map(|index| point_of[index as usize])));
        let mut charts = Sets::new(self.triangles.len());
        let [mut edges, mut open_edges, mut branching_edges, mut seams, mut hard_edges] = [0; 5];
        for edge in halves.chunk_by(|a, b| a.points == b.points) {
            edges += 1;
            open_edges += usize::from(edge.len() == 1);
            branching_edges += usize::from(edge.len() > 2);
            let ends = |half: &HalfEdge| {
                let corners = half.corners(|corner| point_of[of_corner(corner) as usize]);
                corners.map(|corner| &self.vertices[of_corner(corner) as usize])
            };
            let differ = |differ: fn(&Vertex, &Vertex) -> bool, pair: &[HalfEdge]| {
                let (a, b) = (ends(&pair[0]), ends(&pair[1]));
                (0..2).any(|end| differ(a[end], b[end]))
            };
            let is_seam = |pair: &[HalfEdge]| differ(|a, b| a.uv != b.uv, pair);
            let is_hard = |pair: &[HalfEdge]| differ(|a, b| angle_deg(a.normal, b.normal) > HARD_DEG, pair);
            seams += usize::from(edge.windows(2).any(is_seam));
            hard_edges += usize::from(edge.windows(2).any(is_hard));
            for pair in edge.windows(2).filter(|pair| !is_seam(pair)) {
                charts.join(pair[0].triangle() as u32, pair[1].triangle() as u32);
            }
        }
        let corners = || (0..self.triangles.len() as u32).map(|triangle| self.corners(triangle));
        let widest = |corners: [&Vertex; 3]| {
            let [a, b, c] = corners.map(|corner| corner.normal);
            angle_deg(a, b).max(angle_deg(b, c)).max(angle_deg(c, a))
        };
        let nothing = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        let grow = |[least, most]: [Vec3; 2], vertex: &Vertex| {
            [least.min(vertex.position), most.max(vertex.position)]
        };
        let lengths = |vector: fn(&Vertex) -> Vec3| {
            spread(self.vertices.iter().map(|vertex| vector(vertex).as_dvec3().length()))
        };
        MeshMeasures {
            bounds_m: if self.vertices.is_empty() {
                [Vec3::ZERO; 2]
            } else {
                self.vertices.iter().fold(nothing, grow)
            },
            vertices: self.vertices.len(),
            points,
            triangles: self.triangles.len(),
            charts: (0..self.triangles.len() as u32)
                .filter(|&triangle| charts.least(triangle) == triangle)
                .count(),
            mirrored: corners().filter(is_mirrored).count(),
            edges,
            open_edges,
            branching_edges,
            seams,
            hard_edges,
            tile_m: [lengths(|vertex| vertex.tangent), lengths(|vertex| vertex.bitangent)],
            normal_angle_deg: spread(corners().map(widest)),
            unfolded_m: self.unfolded_range(),
            folded: self.folded([0.0; 2]),
        }
    }
}

/// Whether `u` and `v` run clockwise on a triangle that is seen from the front: with `v` downward they do
/// unless they are mirrored.
fn is_mirrored(corners: &[&Vertex; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.uv);
    let [across, down]: [Vec2; 2] = [b - a, c - a];
    across.as_dvec2().perp_dot(down.as_dvec2()) > 0.0
}

fn angle_deg(a: Vec3, b: Vec3) -> f64 {
    let (a, b): (DVec3, DVec3) = (a.as_dvec3(), b.as_dvec3());
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

fn spread(values: impl ExactSizeIterator<Item = f64>) -> Spread {
    let count = values.len();
    if count == 0 {
        return Spread::default();
    }
    let start = (f64::INFINITY, 0.0, f64::NEG_INFINITY);
    let (least, sum, greatest) =
        values.fold(start, |(least, sum, most), value| (least.min(value), sum + value, most.max(value)));
    Spread { least, mean: sum / count as f64, greatest }
}
