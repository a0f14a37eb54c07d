//! Meshes as Godot's own resources, which its editor and its exported games read without an import.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use glam::Vec3;
use relief_core::mesh::Mesh;

use super::VertexFrames;
use crate::WriteProblem;

/// What the arrays of a surface hold: positions, normals, tangents, texture coordinates, `CUSTOM0` of
/// four floats, `CUSTOM1` of two, and indices, in the second version of the layout.
const FORMAT: u64 = 1 | 2 | 4 | 16 | 64 | 128 | 4096 | (7 << 13) | (5 << 16) | (1 << 35);

/// Most vertices that 16 bits number.
const MOST_OF_16_BITS: usize = 1 << 16;

/// Returns the text of an `ArrayMesh`, for a file that ends in `.tres`. `CUSTOM0` holds the length of a tile
/// along `u` and `v` and the first two numbers of the curvature, `CUSTOM1` the third and 0
/// ([`VertexFrames`]). `material` is the file of its material, beside the mesh's own.
///
/// # Errors
///
/// When the mesh has no triangles, or more corners or vertices than Godot counts.
///
/// ```
/// let mesh = relief_core::mesh::square(1)?;
/// let text = relief_io::godot_mesh(&mesh, None)?;
/// assert!(text.starts_with("[gd_resource type=\"ArrayMesh\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn godot_mesh(mesh: &Mesh, material: Option<&str>) -> Result<String, WriteProblem> {
    let (vertices, corners) = (mesh.vertices(), mesh.triangles().as_flattened());
    if corners.is_empty() || i32::try_from(corners.len().max(vertices.len())).is_err() {
        let what = format!("Godot's meshes have 1 to 2^31 - 1 corners, not {}", corners.len());
        return Err(WriteProblem::NotStorable(what));
    }
    let frames = VertexFrames::of(mesh);
    let positions = || vertices.iter().map(|vertex| vertex.position);
    let mut vertex_data: Vec<u8> =
        positions().flat_map(|at| at.to_array()).flat_map(f32::to_le_bytes).collect();
    let mut attributes: Vec<u8> = Vec::new();
    let of_frames = frames.tangents.iter().zip(&frames.tiles_m).zip(&frames.curvatures);
    for (vertex, ((tangent, [along_u, along_v]), [x, y, z])) in vertices.iter().zip(of_frames) {
        let [tx, ty, tz, sign] = *tangent;
        let codes = [octahedral(vertex.normal), octahedral_tangent(Vec3::new(tx, ty, tz), sign)];
        vertex_data.extend(codes.into_iter().flatten().flat_map(u16::to_le_bytes));
        let [u, v] = vertex.uv.to_array();
        let values = [u, v, *along_u, *along_v, *x, *y, *z, 0.0];
        attributes.extend(values.into_iter().flat_map(f32::to_le_bytes));
    }
    // Godot's front faces run clockwise.
    let turned = corners.iter().rev();
    let indices: Vec<u8> = match vertices.len() {
        ..=MOST_OF_16_BITS => turned.flat_map(|corner| (*corner as u16).to_le_bytes()).collect(),
        _ => turned.flat_map(|corner| corner.to_le_bytes()).collect(),
    };
    let least = positions().fold(Vec3::INFINITY, Vec3::min);
    let size = positions().fold(Vec3::NEG_INFINITY, Vec3::max) - least;
    let numbers = [least, size].map(|of| of.to_array()).concat();
    let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
    let bytes = |bytes: &[u8]| format!("PackedByteArray(\"{}\")", BASE64_STANDARD.encode(bytes));
    let mut text = "[gd_resource type=\"ArrayMesh\" format=4]\n\n".to_owned();
    if let Some(material) = material {
        let path = material.replace('\\', "\\\\").replace('"', "\\\"");
        let _ = writeln!(text, "[ext_resource type=\"Material\" path=\"{path}\" id=\"material\"]\n");
    }
    text += "[resource]\n_surfaces = [{\n";
    let mut member = |name: &str, value: String, end: &str| _ = writeln!(text, "\"{name}\": {value}{end}");
    member("aabb", format!("AABB({})", numbers.join(", ")), ",");
    member("attribute_data", bytes(&attributes), ",");
    member("format", FORMAT.to_string(), ",");
    member("index_count", corners.len().to_string(), ",");
    member("index_data", bytes(&indices), ",");
    if material.is_some() {
        member("material", "ExtResource(\"material\")".to_owned(), ",");
    }
    member("primitive", "3".to_owned(), ",");
    member("uv_scale", "Vector4(0, 0, 0, 0)".to_owned(), ",");
    member("vertex_count", vertices.len().to_string(), ",");
    member("vertex_data", bytes(&vertex_data), "");
    Ok(text + "}]\n")
}

/// A unit vector on the faces of an octahedron that is folded flat, from 0 to 1.
fn folded(of: Vec3) -> [f32; 2] {
    let n = of / (of.x.abs() + of.y.abs() + of.z.abs());
    let side = |number: f32| if number >= 0.0 { 1.0 } else { -1.0 };
    let [x, y] = match n.z >= 0.0 {
        true => [n.x, n.y],
        false => [(1.0 - n.y.abs()) * side(n.x), (1.0 - n.x.abs()) * side(n.y)],
    };
    [x * 0.5 + 0.5, y * 0.5 + 0.5]
}

fn codes(of: [f32; 2]) -> [u16; 2] {
    of.map(|part| (part * 65535.0).clamp(0.0, 65535.0) as u16)
}

fn octahedral(normal: Vec3) -> [u16; 2] {
    codes(folded(normal))
}

/// A tangent whose sign lies in the half of the second code.
fn octahedral_tangent(tangent: Vec3, sign: f32) -> [u16; 2] {
    let [x, y] = folded(tangent);
    // Without it, half of 0 could not be told from its negative.
    let y = y.max(1.0 / 32767.0) * 0.5 + 0.5;
    codes([x, if sign >= 0.0 { y } else { 1.0 - y }])
}

#[cfg(test)]
mod tests {
    use super::*;

    // Bytes that Godot 4.6 saved of the same vectors.
    #[test]
    fn directions_have_godots_codes() {
        assert_eq!(octahedral(Vec3::Z), [0x7fff, 0x7fff]);
        assert_eq!(octahedral(Vec3::new(0.6, 0.0, -0.8)), [0xffff, 0xc923]);
        assert_eq!(octahedral(Vec3::Y), [0x7fff, 0xffff]);
        assert_eq!(octahedral_tangent(Vec3::X, 1.0), [0xffff, 0xbfff]);
        assert_eq!(octahedral_tangent(Vec3::Y, -1.0), [0x7fff, 0]);
        assert_eq!(octahedral_tangent(Vec3::Z, 1.0), [0x7fff, 0xbfff]);
    }

    #[test]
    fn lists_have_the_lengths_of_the_format() -> Result<(), Box<dyn std::error::Error>> {
        let mesh = relief_core::mesh::sphere(16, 8)?;
        let text = godot_mesh(&mesh, Some("stone.tres"))?;
        assert!(text.contains("path=\"stone.tres\"") && text.contains("\"material\": ExtResource"));
        let bytes = |name: &str| -> Vec<u8> {
            let (_, rest) = text.split_once(&format!("\"{name}\": PackedByteArray(\"")).expect("a list");
            BASE64_STANDARD.decode(rest.split('"').next().expect("its end")).expect("base 64")
        };
        let vertices = mesh.vertices().len();
        assert_eq!(bytes("vertex_data").len(), vertices * (12 + 8));
        assert_eq!(bytes("attribute_data").len(), vertices * 32);
        assert_eq!(bytes("index_data").len(), mesh.triangles().len() * 6);
        assert_eq!(FORMAT, 34_360_127_703);
        let empty = Mesh::new(Vec::new(), Vec::new())?;
        assert!(godot_mesh(&empty, None).is_err());
        Ok(())
    }
}
