//! Writer of binary STL, in millimetres, as printers expect.

use std::io;

use relief_core::mesh::MeshBlock;

use super::super::stl::MILLIMETRES;
use super::{FileFrame, MeshCounts, Regions, floats};

/// Bytes of the comment at the beginning. It must not begin with the word that marks text files.
const HEADER: usize = 80;

/// Bytes of a triangle: its normal, three corners, and two more bytes.
const TRIANGLE: u64 = 50;

pub fn bytes(counts: MeshCounts) -> u64 {
    HEADER as u64 + 4 + TRIANGLE * counts.triangles
}

pub fn begin(counts: MeshCounts, comment: &str, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut header = comment.as_bytes().to_vec();
    header.resize(HEADER, 0);
    // It was checked that the number fits.
    header.extend((counts.triangles as u32).to_le_bytes());
    regions.write(0, &header)
}

pub fn block(block: &MeshBlock, frame: &FileFrame, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut bytes = Vec::with_capacity(TRIANGLE as usize * block.corners.len());
    for points in block.positions() {
        let points = points.map(|point| frame.point(point, MILLIMETRES));
        let [a, b, c] = points.map(|point| point.as_dvec3());
        floats(&mut bytes, (b - a).cross(c - a).normalize_or_zero().as_vec3().to_array());
        points.iter().for_each(|point| floats(&mut bytes, point.to_array()));
        bytes.extend([0; 2]);
    }
    regions.write(0, &bytes)
}
