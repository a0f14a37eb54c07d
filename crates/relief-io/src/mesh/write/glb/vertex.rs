//! Storage of vertices.

use std::io;

use glam::DVec3;
use relief_core::mesh::{PositionGrid, Vertex};

use super::super::floats;

/// Codes of number types in glTF.
const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const FLOAT: u32 = 5126;

/// Least number of bits of positions at which normals and tangents have 16.
const FINE: u32 = 13;

/// Storage of a GLB's vertices in integers, by the extension `KHR_mesh_quantization`.
///
/// Positions are codes of a lattice, in 8 bits if these suffice, otherwise in 16. Scale and
/// translation of the node convert them to metres, exactly. Positions are not normalised, so
/// readers that ignore that flag give the same result. Normals and tangents have 8 bits if
/// positions have up to 12 (0.4° off at most), otherwise 16. Texture coordinates have 16 bits (off
/// by a part in 131,070 of the texture) if all lie in the texture. Otherwise they stay floats: a
/// transform of coordinates belongs to a texture, and there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantization {
    /// Lattice that positions are rounded to.
    pub grid: PositionGrid,
    /// Whether all texture coordinates are from 0 to 1, and stored in integers.
    pub uvs: bool,
}

/// One of the four attributes of a vertex.
#[derive(Clone, Copy, Debug)]
pub struct Attribute {
    pub name: &'static str,
    /// Offset in the vertex in bytes.
    pub offset: u64,
    component: u32,
    is_normalized: bool,
    form: &'static str,
}

impl Attribute {
    /// Beginning of the accessor's JSON, without the closing brace.
    pub fn accessor(&self, view: usize, count: u64) -> String {
        let Self { offset, component, form, .. } = self;
        let normalized = if self.is_normalized { r#""normalized":true,"# } else { "" };
        format!(r#"{{"bufferView":{view},"byteOffset":{offset},"componentType":{component},{normalized}"#)
            + &format!(r#""count":{count},"type":"{form}""#)
    }
}

/// Attributes of a vertex, and bytes of a vertex. Each begins at a multiple of four bytes.
pub fn attributes(quantization: Option<&Quantization>) -> ([Attribute; 4], u64) {
    let types = match quantization {
        None => [(FLOAT, 12), (FLOAT, 12), (FLOAT, 16), (FLOAT, 8)],
        Some(Quantization { grid, uvs }) => {
            let positions = if is_byte(grid) { (UNSIGNED_BYTE, 4) } else { (UNSIGNED_SHORT, 8) };
            let normals = if is_fine(grid) { (SHORT, 8) } else { (BYTE, 4) };
            [positions, normals, normals, if *uvs { (UNSIGNED_SHORT, 4) } else { (FLOAT, 8) }]
        }
    };
    let forms = [("POSITION", "VEC3"), ("NORMAL", "VEC3"), ("TANGENT", "VEC4"), ("TEXCOORD_0", "VEC2")];
    let mut end = 0;
    let attributes = [0, 1, 2, 3].map(|k| {
        let ((name, form), (component, bytes)) = (forms[k], types[k]);
        let offset = end;
        end += bytes;
        Attribute { name, offset, component, is_normalized: k > 0 && component != FLOAT, form }
    });
    (attributes, end)
}

fn is_byte(grid: &PositionGrid) -> bool {
    grid.bits() == 8
}

fn is_fine(grid: &PositionGrid) -> bool {
    grid.bits() >= FINE
}

/// Writes a vertex in floats.
pub fn plain(bytes: &mut Vec<u8>, vertex: &Vertex) {
    floats(bytes, vertex.position.to_array());
    floats(bytes, vertex.normal.to_array());
    floats(bytes, tangent(vertex));
    floats(bytes, vertex.uv.to_array());
}

/// Writes a vertex in integers, and returns the codes of its position.
pub fn quantized(bytes: &mut Vec<u8>, vertex: &Vertex, how: &Quantization) -> io::Result<[u16; 3]> {
    let beyond =
        |what: &str| io::Error::other(format!("{what} of a vertex lies outside the range of the layout"));
    let codes = how.grid.code(vertex.position).ok_or_else(|| beyond("the position"))?;
    let [x, y, z] = codes;
    for code in [x, y, z, 0] {
        if is_byte(&how.grid) {
            bytes.extend((code as u8).to_le_bytes());
        } else {
            bytes.extend(code.to_le_bytes());
        }
    }
    let [nx, ny, nz] = vertex.normal.to_array();
    for number in [nx, ny, nz, 0.0].into_iter().chain(tangent(vertex)) {
        // Numbers slightly out of range by rounding are clamped.
        if is_fine(&how.grid) {
            bytes.extend(((number * 32767.0).round() as i16).max(-i16::MAX).to_le_bytes());
        } else {
            bytes.extend(((number * 127.0).round() as i8).max(-i8::MAX).to_le_bytes());
        }
    }
    if !how.uvs {
        floats(bytes, vertex.uv.to_array());
        return Ok(codes);
    }
    for number in vertex.uv.to_array() {
        if !(0.0..=1.0).contains(&number) {
            return Err(beyond("a texture coordinate"));
        }
        bytes.extend(((number * 65535.0).round() as u16).to_le_bytes());
    }
    Ok(codes)
}

/// Returns the unit tangent perpendicular to the normal, and a sign. With it `normal x tangent`
/// points up in the picture, against growing `v`, as the bitangent of glTF's normal maps does.
pub fn tangent(vertex: &Vertex) -> [f32; 4] {
    let [normal, tangent, bitangent]: [DVec3; 3] =
        [vertex.normal, vertex.tangent, vertex.bitangent].map(|vector| vector.as_dvec3());
    let flat = tangent - normal * normal.dot(tangent);
    let along = flat.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
    let sign = if normal.cross(along).dot(bitangent) > 0.0 { -1.0 } else { 1.0 };
    let [x, y, z] = along.as_vec3().to_array();
    [x, y, z, sign]
}
