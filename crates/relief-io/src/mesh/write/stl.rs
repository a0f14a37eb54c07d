//! Binary STL, in millimetres, as printers take it.

use std::io;

use relief_core::mesh::MeshBlock;

use super::super::stl::MILLIMETRES;
use super::{MeshCounts, Regions, Standing, floats};

/// The first bytes hold a comment. It may not begin with the word that marks texts.
const HEADER: usize = 80;

/// Bytes of a triangle: its normal, three corners, and two more.
const TRIANGLE: u64 = 50;

pub fn bytes(counts: MeshCounts) -> u64 {
    HEADER as u64 + 4 + TRIANGLE * counts.triangles
}

pub fn begin(counts: MeshCounts, comment: &str, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut header = comment.as_bytes().to_vec();
    header.resize(HEADER, 0);
    // It was checked that they are as few.
    header.extend((counts.triangles as u32).to_le_bytes());
    regions.write(0, &header)
}

pub fn block(block: &MeshBlock, standing: &Standing, regions: &mut Regions<'_, '_>) -> io::Result<()> {
    let mut bytes = Vec::with_capacity(TRIANGLE as usize * block.corners.len());
    for points in block.positions() {
        let points = points.map(|point| standing.point(point, MILLIMETRES));
        let [a, b, c] = points.map(|point| point.as_dvec3());
        floats(&mut bytes, (b - a).cross(c - a).normalize_or_zero().as_vec3().to_array());
        points.iter().for_each(|point| floats(&mut bytes, point.to_array()));
        bytes.extend([0; 2]);
    }
    regions.write(0, &bytes)
}
