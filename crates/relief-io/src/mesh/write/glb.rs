//! Binary glTF 2.0: one mesh of one material, its vertices side by side in one buffer, its indices behind
//! them.

use std::io;

use glam::{DVec3, Vec3};
use relief_core::mesh::{MeshBlock, Vertex};

use super::{MeshCounts, Regions, floats};

/// Bytes of a vertex: position, normal, tangent with its sign, texture coordinates.
const VERTEX: u64 = 48;

/// Bytes of a triangle.
const TRIANGLE: u64 = 12;

/// Bytes before the JSON, and between it and the buffer: the file's header and both chunks'.
const HEADERS: [u64; 2] = [20, 8];

/// Room for the least and the greatest position, which are known last: six numbers and their punctuation.
const ROOM: usize = 160;

/// What stands for them until then.
const PLACE: &str = "@";

/// The JSON, with a place for the least and the greatest position.
fn json(MeshCounts { vertices, triangles }: MeshCounts) -> String {
    let (indices, of_vertices, of_indices) = (3 * triangles, VERTEX * vertices, TRIANGLE * triangles);
    let total = of_vertices + of_indices;
    let accessor = |offset: u64, form: &str| {
        format!(r#"{{"bufferView":0,"byteOffset":{offset},"componentType":5126,"count":{vertices},"#)
            + &format!(r#""type":"{form}""#)
    };
    let [positions, normals, tangents, uvs] =
        [(0, "VEC3"), (12, "VEC3"), (24, "VEC4"), (40, "VEC2")].map(|(offset, form)| accessor(offset, form));
    let version = env!("CARGO_PKG_VERSION");
    format!(r#"{{"asset":{{"version":"2.0","generator":"relief {version}"}},"#)
        + r#""scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"#
        + r#""materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0}}],"#
        + r#""meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3},"#
        + r#""indices":4,"material":0}]}],"#
        + &format!(r#""buffers":[{{"byteLength":{total}}}],"#)
        + &format!(r#""bufferViews":[{{"buffer":0,"byteLength":{of_vertices},"byteStride":{VERTEX},"#)
        + r#""target":34962},"#
        + &format!(r#"{{"buffer":0,"byteOffset":{of_vertices},"byteLength":{of_indices},"#)
        + r#""target":34963}],"#
        + &format!(r#""accessors":[{positions}{PLACE}}},{normals}}},{tangents}}},{uvs}}},"#)
        + &format!(r#"{{"bufferView":1,"componentType":5125,"count":{indices},"type":"SCALAR"}}]}}"#)
}

/// Bytes of the JSON in the file.
fn json_bytes(counts: MeshCounts) -> u64 {
    ((json(counts).len() - PLACE.len() + ROOM) as u64).next_multiple_of(4)
}

pub fn bytes(counts: MeshCounts) -> u64 {
    let buffer = VERTEX * counts.vertices + TRIANGLE * counts.triangles;
    HEADERS[0] + json_bytes(counts) + HEADERS[1] + buffer
}

/// A file that is being written.
pub struct Glb {
    counts: MeshCounts,
    bounds: [Vec3; 2],
}

impl Glb {
    pub fn begin(counts: MeshCounts, regions: &mut Regions<'_, '_>) -> io::Result<Self> {
        // It was checked that these fit into 32 bits.
        let lengths = [bytes(counts), json_bytes(counts)].map(|len| (len as u32).to_le_bytes());
        let mut head = b"glTF\x02\0\0\0".to_vec();
        head.extend(lengths[0]);
        head.extend(lengths[1]);
        head.extend(b"JSON");
        regions.write_at(0, &head)?;
        regions.next[0] = HEADERS[0] + json_bytes(counts);
        let buffer = VERTEX * counts.vertices + TRIANGLE * counts.triangles;
        let mut chunk = (buffer as u32).to_le_bytes().to_vec();
        chunk.extend(b"BIN\0");
        regions.write(0, &chunk)?;
        regions.next[1] = regions.next[0] + VERTEX * counts.vertices;
        Ok(Self { counts, bounds: [Vec3::INFINITY, Vec3::NEG_INFINITY] })
    }

    pub fn block(&mut self, block: &MeshBlock, regions: &mut Regions<'_, '_>) -> io::Result<()> {
        let mut bytes = Vec::with_capacity(VERTEX as usize * block.vertices.len());
        for vertex in &block.vertices {
            let [least, greatest] = self.bounds;
            self.bounds = [least.min(vertex.position), greatest.max(vertex.position)];
            floats(&mut bytes, vertex.position.to_array());
            floats(&mut bytes, vertex.normal.to_array());
            floats(&mut bytes, tangent(vertex));
            floats(&mut bytes, vertex.uv.to_array());
        }
        regions.write(0, &bytes)?;
        bytes.clear();
        bytes.extend(block.triangles.as_flattened().iter().flat_map(|corner| corner.to_le_bytes()));
        regions.write(1, &bytes)
    }

    /// Writes the JSON, when the least and the greatest position are known.
    pub fn finish(self, regions: &mut Regions<'_, '_>) -> io::Result<()> {
        let [least, greatest] = self.bounds.map(|bound| bound.to_array().map(|number| format!("{number:e}")));
        let bounds = format!(r#","min":[{}],"max":[{}]"#, least.join(","), greatest.join(","));
        let mut json = json(self.counts).replace(PLACE, &bounds).into_bytes();
        json.resize(json_bytes(self.counts) as usize, b' ');
        regions.write_at(HEADERS[0], &json)
    }
}

/// The unit tangent at right angles to the normal, and the sign by which `normal x tangent` points up in the
/// picture, against growing `v`: that of the bitangent of glTF's normal maps.
fn tangent(vertex: &Vertex) -> [f32; 4] {
    let [normal, tangent, bitangent]: [DVec3; 3] =
        [vertex.normal, vertex.tangent, vertex.bitangent].map(|vector| vector.as_dvec3());
    let flat = tangent - normal * normal.dot(tangent);
    let along = flat.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
    let sign = if normal.cross(along).dot(bitangent) > 0.0 { -1.0 } else { 1.0 };
    let [x, y, z] = along.as_vec3().to_array();
    [x, y, z, sign]
}
