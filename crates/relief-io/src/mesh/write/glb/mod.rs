//! Writer of binary glTF 2.0: meshes of one or several levels of detail. The buffer holds, level by
//! level, interleaved vertices followed by indices, material by material; pictures are at the end.

mod layout;
mod materials;
mod strips;
mod vertex;

use std::io;

use glam::Vec3;
use relief_core::mesh::MeshBlock;

use super::{MeshCounts, Regions};

use self::strips::Strip;
pub use layout::{GlbLayout, GlbLevel, GlbNode};
pub use materials::GlbMaterials;
pub use vertex::{Quantization, tangent};

/// Bytes of an index.
const INDEX: u64 = 4;

/// Bytes before the JSON, and between it and the buffer: the headers of the file and of both
/// chunks.
const HEADERS: [u64; 2] = [20, 8];

/// GLB file that is being written.
pub struct Glb<'a> {
    layout: &'a GlbLayout,
    /// Bytes of a vertex, and bytes before the buffer.
    vertex: u64,
    before: u64,
    /// Current level, and the counts written of it.
    level: usize,
    written: MeshCounts,
    /// Number of indices written of each level.
    indices: Vec<u64>,
    /// Strip of the current level.
    strip: Strip,
    /// Least and greatest coordinates of the positions of each level, as they are stored.
    bounds: Vec<[Vec3; 2]>,
}

impl<'a> Glb<'a> {
    pub fn begin(layout: &'a GlbLayout, regions: &mut Regions<'_, '_>) -> Self {
        let vertex = vertex::attributes(layout.quantization.as_ref()).1;
        let bounds = vec![[Vec3::INFINITY, Vec3::NEG_INFINITY]; layout.levels.len()];
        let nothing = MeshCounts { vertices: 0, triangles: 0 };
        let (indices, strip) = (vec![0; layout.levels.len()], Strip::default());
        let before = layout.before();
        let glb = Self { layout, vertex, before, level: 0, written: nothing, indices, strip, bounds };
        glb.go_to(0, regions);
        glb
    }

    /// Moves the regions to the beginning of a level.
    fn go_to(&self, level: usize, regions: &mut Regions<'_, '_>) {
        let [vertices, mut indices] = self.layout.offsets(level, &self.indices).map(|at| self.before + at);
        regions.next = vec![vertices];
        for (_, triangles) in self.layout.parts(level) {
            regions.next.push(indices);
            indices += 3 * INDEX * triangles;
        }
    }

    pub fn block(&mut self, block: &MeshBlock, regions: &mut Regions<'_, '_>) -> io::Result<()> {
        if self.written == self.layout.levels[self.level].counts && self.level + 1 < self.layout.levels.len()
        {
            self.level += 1;
            self.written = MeshCounts { vertices: 0, triangles: 0 };
            self.strip = Strip::default();
            self.go_to(self.level, regions);
        }
        self.written.vertices += block.vertices.len() as u64;
        self.written.triangles += block.triangles.len() as u64;
        let MeshCounts { vertices, triangles } = self.layout.levels[self.level].counts;
        if self.written.vertices > vertices || self.written.triangles > triangles {
            return Err(io::Error::other(
                "a level of detail has more vertices or triangles than its counts say",
            ));
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
        let parts = self.layout.parts(self.level);
        if let Some(materials) = self.layout.materials.as_ref().filter(|_| parts.len() > 1) {
            self.indices[self.level] += 3 * block.triangles.len() as u64;
            for (region, (material, _)) in parts.iter().enumerate() {
                bytes.clear();
                let all = block.triangles.iter().enumerate();
                let own = all.filter(|(at, _)| materials.of_triangle(block, *at) == *material);
                bytes.extend(own.flat_map(|(_, corners)| corners).flat_map(|corner| corner.to_le_bytes()));
                regions.write(1 + region, &bytes)?;
            }
            return Ok(());
        }
        let of_strip = self.layout.strips.then(|| self.strip.extended(&block.triangles));
        let indices = of_strip.as_deref().unwrap_or(block.triangles.as_flattened());
        self.indices[self.level] += indices.len() as u64;
        if self.before + self.layout.buffer(&self.indices) > u64::from(u32::MAX) {
            return Err(io::Error::other("the strips need more than the 4 GiB that a GLB can hold"));
        }
        bytes.extend(indices.iter().flat_map(|corner| corner.to_le_bytes()));
        regions.write(1, &bytes)
    }

    /// Writes everything before the lists, since the least and the greatest positions and the
    /// indices are now known. Returns the number of indices of each level.
    pub fn finish(self, regions: &mut Regions<'_, '_>) -> io::Result<Vec<u64>> {
        let Self { layout, before, indices, bounds, .. } = self;
        if indices.contains(&0) {
            return Err(io::Error::other("no triangle has three different corners"));
        }
        // It was checked that both numbers fit into 32 bits.
        let bytes = |number: u64| (number as u32).to_le_bytes();
        let (json, buffer) = (layout.json_with(&bounds, &indices), layout.buffer(&indices));
        let mut head = b"glTF\x02\0\0\0".to_vec();
        head.extend(bytes(before + buffer));
        head.extend(bytes(json.len() as u64));
        head.extend(b"JSON");
        head.extend(json);
        head.extend(bytes(buffer));
        head.extend(b"BIN\0");
        regions.write_at(0, &head)?;
        let mut at = before + layout.pictures_at(&indices);
        for png in layout.materials.iter().flat_map(GlbMaterials::pictures) {
            regions.write_at(at, png)?;
            at += png.len() as u64;
        }
        Ok(indices)
    }
}
