//! Writer of OBJ.

use std::fmt::Write;
use std::io;

use relief_core::mesh::MeshBlock;

use super::{FileFrame, MeshCounts, Regions, turned_over};

/// Least bytes of a vertex and of a face: `v 0 0 0`, `vt 0 0`, `vn 0 0 0`, and `f 1/1/1 2/2/2
/// 3/3/3`.
const LEAST: [u64; 2] = [24, 20];

pub fn least_bytes(MeshCounts { vertices, triangles }: MeshCounts) -> u64 {
    LEAST[0] * vertices + LEAST[1] * triangles
}

pub fn block(block: &MeshBlock, frame: &FileFrame, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut text = String::with_capacity(96 * block.vertices.len() + 48 * block.triangles.len());
    // Writing into memory does not fail.
    for vertex in &block.vertices {
        let [x, y, z] = frame.point(vertex.position, 1.0).to_array();
        let [nx, ny, nz] = frame.up.stored(vertex.normal).to_array();
        let _ = writeln!(text, "v {x} {y} {z}");
        let _ = writeln!(text, "vt {} {}", vertex.uv.x, turned_over(vertex.uv.y));
        let _ = writeln!(text, "vn {nx} {ny} {nz}");
    }
    for corners in &block.triangles {
        let [a, b, c] = corners.map(|corner| u64::from(corner) + 1);
        let _ = writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}");
    }
    regions.write(0, text.as_bytes())
}
