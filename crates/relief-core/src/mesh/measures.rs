//! Measurements of a mesh: sizes, charts, edges, tiles, the angles between its normals, and folds.

use super::topology::{HalfEdge, Sets, half_edges, weld};
use super::{Mesh, Vertex};
use glam::{DVec3, Vec2, Vec3};

/// Least angle in degrees between normals that count as different.
pub(super) const HARD_DEG: f64 = 0.1;

/// Least, mean and greatest value of a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Least value.
    pub least: f64,
    /// Mean.
    pub mean: f64,
    /// Greatest value.
    pub greatest: f64,
}

/// Measurements of a mesh by [`Mesh::measures`]. Edges are counted between points, not vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMeasures {
    /// Least and greatest coordinates, in metres.
    pub bounds_m: [Vec3; 2],
    /// Number of vertices.
    pub vertices: usize,
    /// Number of different positions of vertices.
    pub points: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of charts: parts that are connected in the texture. Connected triangles share an edge
    /// with the same texture coordinates.
    pub charts: usize,
    /// Number of triangles on which the texture is mirrored.
    pub mirrored: usize,
    /// Number of edges.
    pub edges: usize,
    /// Number of edges of one triangle only.
    pub open_edges: usize,
    /// Number of edges of more than two triangles.
    pub branching_edges: usize,
    /// Number of edges whose sides have different texture coordinates.
    pub seams: usize,
    /// Number of edges whose sides have different normals.
    pub hard_edges: usize,
    /// Length of a tile along `u` and along `v` in metres, over the vertices.
    pub tile_m: [Spread; 2],
    /// Greatest angle in degrees between normals of a triangle, over the triangles.
    pub normal_angle_deg: Spread,
    /// Offsets in metres, inward and outward, between which no triangle is folded
    /// ([`Mesh::unfolded_range`]). They are infinite if none ever folds, and both 0 if one is
    /// folded already.
    pub unfolded_m: [f64; 2],
    /// Number of triangles that are folded without any displacement.
    pub folded: usize,
}

impl Mesh {
    /// Measures the mesh. It takes about 60 bytes per triangle and 50 per vertex.
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

/// Whether the texture is mirrored on a triangle. The corners, counter-clockwise from the front,
/// then run clockwise in the texture, whose `v` points downward.
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
