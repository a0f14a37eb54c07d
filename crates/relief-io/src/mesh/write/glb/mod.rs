//! Binary glTF 2.0: meshes of one material, one or several levels of detail. Of each level the vertices lie
//! side by side, its indices behind them.

mod layout;
mod vertex;

use std::io;

use glam::Vec3;
use relief_core::mesh::MeshBlock;

use super::{MeshCounts, Regions};

pub use layout::{GlbLayout, GlbLevel};
pub use vertex::Quantization;

/// Bytes of a triangle.
const TRIANGLE: u64 = 12;

/// Bytes before the JSON, and between it and the buffer: the file's header and both chunks'.
const HEADERS: [u64; 2] = [20, 8];

/// A file that is being written.
pub struct Glb<'a> {
    layout: &'a GlbLayout,
    /// Bytes of a vertex.
    vertex: u64,
    /// The level that comes, and what there is of it.
    level: usize,
    found: MeshCounts,
    /// The least and the greatest numbers of the positions of each level, as they are stored.
    bounds: Vec<[Vec3; 2]>,
}

impl<'a> Glb<'a> {
    pub fn begin(layout: &'a GlbLayout, regions: &mut Regions<'_, '_>) -> io::Result<Self> {
        // It was checked that these fit into 32 bits.
        let lengths = [layout.bytes(), layout.json_bytes()].map(|len| (len as u32).to_le_bytes());
        let mut head = b"glTF\x02\0\0\0".to_vec();
        head.extend(lengths[0]);
        head.extend(lengths[1]);
        head.extend(b"JSON");
        regions.write_at(0, &head)?;
        let mut chunk = (layout.buffer() as u32).to_le_bytes().to_vec();
        chunk.extend(b"BIN\0");
        regions.write_at(HEADERS[0] + layout.json_bytes(), &chunk)?;
        let vertex = vertex::attributes(layout.quantization.as_ref()).1;
        let bounds = vec![[Vec3::INFINITY, Vec3::NEG_INFINITY]; layout.levels.len()];
        let nothing = MeshCounts { vertices: 0, triangles: 0 };
        let glb = Self { layout, vertex, level: 0, found: nothing, bounds };
        glb.go_to(0, regions);
        Ok(glb)
    }

    /// Goes on at the beginning of a level.
    fn go_to(&self, level: usize, regions: &mut Regions<'_, '_>) {
        let buffer = HEADERS[0] + self.layout.json_bytes() + HEADERS[1];
        regions.next = self.layout.places(level).map(|place| buffer + place);
    }

    pub fn block(&mut self, block: &MeshBlock, regions: &mut Regions<'_, '_>) -> io::Result<()> {
        if self.found == self.layout.levels[self.level].counts && self.level + 1 < self.layout.levels.len() {
            self.level += 1;
            self.found = MeshCounts { vertices: 0, triangles: 0 };
            self.go_to(self.level, regions);
        }
        self.found.vertices += block.vertices.len() as u64;
        self.found.triangles += block.triangles.len() as u64;
        let MeshCounts { vertices, triangles } = self.layout.levels[self.level].counts;
        if self.found.vertices > vertices || self.found.triangles > triangles {
            return Err(io::Error::other("there is more of a level of detail than was promised"));
        }
        let mut bytes = Vec::with_capacity(self.vertex as usize * block.vertices.len());
        let [mut least, mut greatest] = self.bounds[self.level];
        for vertex in &block.vertices {
            let stored = match &self.layout.quantization {
                Some(how) => Vec3::from(vertex::quantized(&mut bytes, vertex, how)?.map(f32::from)),
                None => {
                    vertex::plain(&mut bytes, vertex);
                    vertex.position
                }
            };
            (least, greatest) = (least.min(stored), greatest.max(stored));
        }
        self.bounds[self.level] = [least, greatest];
        regions.write(0, &bytes)?;
        bytes.clear();
        bytes.extend(block.triangles.as_flattened().iter().flat_map(|corner| corner.to_le_bytes()));
        regions.write(1, &bytes)
    }

    /// Writes the JSON, when the least and the greatest position are known.
    pub fn finish(self, regions: &mut Regions<'_, '_>) -> io::Result<()> {
        regions.write_at(HEADERS[0], &self.layout.json_with(&self.bounds))
    }
}
