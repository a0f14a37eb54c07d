//! Writer of binary PLY, little-endian.

use std::io;

use relief_core::mesh::MeshBlock;

use super::super::MeshFormat;
use super::super::up::{Up, comment};
use super::{FileFrame, MeshCounts, Regions, floats, turned_over};

/// Bytes of a vertex: position, normal, `s` and `t`.
const VERTEX: u64 = 32;

/// Bytes of a face: the number of corners, and their indices.
const FACE: u64 = 13;

fn header(MeshCounts { vertices, triangles }: MeshCounts, comment: &str) -> String {
    let properties =
        ["x", "y", "z", "nx", "ny", "nz", "s", "t"].map(|name| format!("property float {name}\n")).concat();
    format!(
        "ply\nformat binary_little_endian 1.0\ncomment {comment}\n\
         element vertex {vertices}\n{properties}element face {triangles}\n\
         property list uchar uint vertex_indices\nend_header\n"
    )
}

pub fn bytes(counts: MeshCounts) -> u64 {
    header(counts, &comment(MeshFormat::Ply, Up::Y)).len() as u64
        + VERTEX * counts.vertices
        + FACE * counts.triangles
}

pub fn begin(counts: MeshCounts, comment: &str, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    regions.write(0, header(counts, comment).as_bytes())?;
    regions.next[1] = regions.next[0] + VERTEX * counts.vertices;
    Ok(())
}

pub fn block(block: &MeshBlock, frame: &FileFrame, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut bytes = Vec::with_capacity(VERTEX as usize * block.vertices.len());
    for vertex in &block.vertices {
        floats(&mut bytes, frame.point(vertex.position, 1.0).to_array());
        floats(&mut bytes, frame.up.stored(vertex.normal).to_array());
        floats(&mut bytes, [vertex.uv.x, turned_over(vertex.uv.y)]);
    }
    regions.write(0, &bytes)?;
    bytes.clear();
    for corners in &block.triangles {
        bytes.push(3);
        bytes.extend(corners.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    regions.write(1, &bytes)
}
