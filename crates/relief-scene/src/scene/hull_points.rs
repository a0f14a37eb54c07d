//! Points whose convex hull contains a relief that is visible beside its mesh.

use glam::{DVec2, DVec3};
use relief_core::HeightMap;
use relief_core::mesh::{Mesh, Vertex};

/// Blocks of a map along an axis. More blocks follow the relief closer and give more points.
const BLOCKS: u32 = 64;

/// Approximate limit of points on triangles that span several blocks.
const MOST_POINTS: f64 = 262_144.0;

/// Least and greatest texel of each block of a map.
struct HeightBlocks<'a> {
    map: &'a HeightMap,
    /// Texels of a block along each axis.
    texels: [u32; 2],
    /// Blocks along each axis.
    count: [u32; 2],
    bounds: Vec<[f32; 2]>,
}

fn wider([low, high]: [f32; 2], [a, b]: [f32; 2]) -> [f32; 2] {
    [low.min(a), high.max(b)]
}

const NOTHING: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];

impl<'a> HeightBlocks<'a> {
    fn of(map: &'a HeightMap) -> Self {
        let size = [map.width(), map.height()];
        let texels = size.map(|side| side.div_ceil(BLOCKS));
        let count = [0, 1].map(|axis| size[axis].div_ceil(texels[axis]));
        let mut bounds = vec![NOTHING; (count[0] * count[1]) as usize];
        for (y, row) in map.texels().chunks(size[0] as usize).enumerate() {
            let first = (y as u32 / texels[1] * count[0]) as usize;
            for (x, block) in row.chunks(texels[0] as usize).enumerate() {
                let of_row = block.iter().fold(NOTHING, |of, texel| wider(of, [*texel; 2]));
                bounds[first + x] = wider(bounds[first + x], of_row);
            }
        }
        Self { map, texels, count, bounds }
    }

    /// Returns the least and the greatest height within a rectangle of texture coordinates.
    fn between(&self, low: DVec2, high: DVec2) -> [f32; 2] {
        let size = [self.map.width(), self.map.height()];
        let blocks = [0, 1].map(|axis| {
            let at = |place: f64| (place * f64::from(size[axis]) - 0.5).floor();
            let (first, last) = (at(low[axis]), at(high[axis]) + 1.0);
            let is_part = last - first < f64::from(size[axis]);
            if !is_part {
                return (0..self.count[axis]).collect::<Vec<u32>>();
            }
            let (first, last) = (first as i64, last as i64);
            let block = |texel: i64| self.map.wrap().index(texel, size[axis]) / self.texels[axis];
            let mut blocks: Vec<u32> = (first..=last).map(block).collect();
            blocks.dedup();
            blocks
        });
        let [columns, rows] = blocks;
        let of = |row: u32, column: u32| self.bounds[(row * self.count[0] + column) as usize];
        let of_row =
            |row: u32| columns.iter().fold(NOTHING, |so_far, column| wider(so_far, of(row, *column)));
        rows.iter().fold(NOTHING, |so_far, row| wider(so_far, of_row(*row)))
    }
}

/// Returns points whose convex hull contains a relief that is visible beside its mesh. With `both`,
/// the relief lies on the backs of the triangles as well.
pub(super) fn points_of_relief(mesh: &Mesh, map: &HeightMap, both: bool) -> Vec<DVec3> {
    let blocks = HeightBlocks::of(map);
    let heights_m = |of: [f32; 2]| {
        let [low, high] = of.map(|texel| map.bias_m() + map.scale_m() * f64::from(texel));
        if both { [low.min(-high), high.max(-low)] } else { [low, high] }
    };
    let mut points = Vec::new();
    let mut push = |position: DVec3, normal: DVec3, of: [f32; 2]| {
        points.extend(heights_m(of).map(|height_m| position + normal * height_m));
    };
    let uv = |vertex: &Vertex| vertex.uv.as_dvec2();
    let box_of = |corners: [&Vertex; 3]| {
        let [a, b, c] = corners.map(uv);
        (a.min(b).min(c), a.max(b).max(c))
    };
    let parts = |low: DVec2, high: DVec2| {
        let [across, down] = [0, 1].map(|axis| (high[axis] - low[axis]) * f64::from(blocks.count[axis]));
        across.max(down).ceil().clamp(1.0, f64::from(BLOCKS))
    };
    let all = || (0..mesh.triangles().len() as u32).map(|number| mesh.corners(number));
    let several = all().filter(|corners| {
        let (low, high) = box_of(*corners);
        parts(low, high) > 1.0
    });
    // A triangle divided into n parts along each side has about n² / 2 points, at two heights each.
    let most_parts = (MOST_POINTS / several.count().max(1) as f64).sqrt().floor().max(1.0);
    let mut of_vertex = vec![NOTHING; mesh.vertices().len()];
    for (triangle, corners) in mesh.triangles().iter().zip(all()) {
        let (low, high) = box_of(corners);
        let parts = parts(low, high).min(most_parts) as u32;
        if parts == 1 {
            let of_triangle = blocks.between(low, high);
            for &corner in triangle {
                of_vertex[corner as usize] = wider(of_vertex[corner as usize], of_triangle);
            }
            continue;
        }
        // The parts of the triangle around each lattice point meet there.
        let reach = (high - low) / f64::from(parts);
        for i in 0..=parts {
            for j in 0..=parts - i {
                let weights = [i, j, parts - i - j].map(|part| f64::from(part) / f64::from(parts));
                let mean = |of: fn(&Vertex) -> DVec3| {
                    corners.iter().zip(weights).map(|(vertex, weight)| of(vertex) * weight).sum::<DVec3>()
                };
                let at: DVec2 = corners.iter().zip(weights).map(|(vertex, weight)| uv(vertex) * weight).sum();
                let position = mean(|vertex| vertex.position.as_dvec3());
                let normal = mean(|vertex| vertex.normal.as_dvec3());
                push(position, normal, blocks.between(at - reach, at + reach));
            }
        }
    }
    for (vertex, of) in mesh.vertices().iter().zip(of_vertex) {
        if of[0] <= of[1] {
            push(vertex.position.as_dvec3(), vertex.normal.as_dvec3(), of);
        }
    }
    points
}
