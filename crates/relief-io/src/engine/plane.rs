//! Plane with the material of an engine, as glTF.

use std::path::Path;

use relief_core::Wrap;
use serde_json::{Map, Value, json};

use crate::{WriteError, WriteProblem, write_atomically};

/// Textures of a plane's material: names of files beside the glTF.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlaneTextures {
    /// Base colour. Without it the plane has the base colour 0.4.
    pub color: Option<String>,
    /// Whether the base colour has texels that are not opaque.
    pub has_opacity: bool,
    /// Normals, with green along falling `v`.
    pub normal: Option<String>,
    /// Occlusion, roughness and metalness in red, green and blue. Without it the plane has the
    /// roughness 0.5 and is no metal.
    pub surface: Option<String>,
    /// Whether the material has occlusion.
    pub has_occlusion: bool,
    /// Emission.
    pub emission: Option<String>,
    /// Factor on the emission, at least 1.
    pub emission_strength: f32,
    /// Heights, which glTF has no slot for. They are named in the material's `extras`.
    pub height: Option<String>,
}

/// Plane of one tile, which lies around the origin and faces up along `y`.
#[derive(Clone, Debug, PartialEq)]
pub struct EnginePlane {
    /// Name of the material.
    pub name: String,
    /// Lengths along `u`, which is along `x`, and `v`, which is along `z`, in metres.
    pub tile_m: [f64; 2],
    /// Displacement of height 1 above height 0, in metres.
    pub scale_m: f64,
    /// Displacement of height 0, in metres.
    pub bias_m: f64,
    /// Cells along each side, 1 to 255, so that 16 bits number the vertices.
    pub cells: u32,
    /// Continuation of the textures beyond their edges.
    pub wrap: Wrap,
    /// Textures of the material.
    pub textures: PlaneTextures,
}

/// Most cells along a side of a plane.
const MOST_CELLS: u32 = 255;

/// Bytes of a vertex: position, normal, tangent and texture coordinates.
const VERTEX_BYTES: usize = 4 * (3 + 3 + 4 + 2);

/// Writes a plane as glTF with its vertices in the file `buffer`, which lies beside the glTF under
/// the name `buffer_name`. Textures are named in it, not written.
///
/// # Errors
///
/// When the plane has no cells or more than 255, or when a file cannot be written.
pub fn write_engine_plane(
    plane: &EnginePlane,
    gltf: &Path,
    buffer: &Path,
    buffer_name: &str,
) -> Result<(), WriteError> {
    if !(1..=MOST_CELLS).contains(&plane.cells) {
        let what = format!("a plane has 1 to {MOST_CELLS} cells along a side, not {}", plane.cells);
        return Err(WriteProblem::NotStorable(what).at(gltf));
    }
    let bytes = plane.buffer();
    write_atomically(buffer, |out| out.write_all(&bytes))?;
    let text = format!("{:#}\n", plane.json(buffer_name, bytes.len()));
    write_atomically(gltf, |out| out.write_all(text.as_bytes()))
}

impl EnginePlane {
    /// Returns the number of vertices.
    fn vertices(&self) -> usize {
        (self.cells as usize + 1).pow(2)
    }

    /// Returns half of the sides along `x` and `z`.
    fn half(&self) -> [f32; 2] {
        self.tile_m.map(|side| 0.5 * side as f32)
    }

    /// Returns vertices, one after the other, and then the corners of the triangles.
    fn buffer(&self) -> Vec<u8> {
        let (cells, [half_x, half_z]) = (self.cells, self.half());
        let mut bytes = Vec::with_capacity(self.vertices() * (VERTEX_BYTES + 12));
        for row in 0..=cells {
            for column in 0..=cells {
                let [u, v] = [column, row].map(|at| at as f32 / cells as f32);
                let position = [half_x * (2.0 * u - 1.0), 0.0, half_z * (2.0 * v - 1.0)];
                let normal = [0.0, 1.0, 0.0];
                // The cross product of normal and tangent points along falling v, as green does.
                let tangent = [1.0, 0.0, 0.0, 1.0];
                let values = position.into_iter().chain(normal).chain(tangent).chain([u, v]);
                bytes.extend(values.flat_map(f32::to_le_bytes));
            }
        }
        let vertex = |row: u32, column: u32| (row * (cells + 1) + column) as u16;
        for row in 0..cells {
            for column in 0..cells {
                let [upper, right] = [vertex(row, column), vertex(row, column + 1)];
                let [lower, far] = [vertex(row + 1, column), vertex(row + 1, column + 1)];
                let corners = [upper, lower, right, right, lower, far];
                bytes.extend(corners.into_iter().flat_map(u16::to_le_bytes));
            }
        }
        bytes
    }

    fn json(&self, buffer_name: &str, length: usize) -> Value {
        let (vertices, [half_x, half_z]) = (self.vertices(), self.half());
        let corners = 6 * (self.cells as usize).pow(2);
        let of_vertices = vertices * VERTEX_BYTES;
        let accessor = |offset: usize, kind: &str| {
            json!({
                "bufferView": 0, "byteOffset": offset, "componentType": 5126, "count": vertices, "type": kind,
            })
        };
        let mut position = accessor(0, "VEC3");
        position["min"] = json!([-half_x, 0.0, -half_z]);
        position["max"] = json!([half_x, 0.0, half_z]);
        let (material, images) = self.material();
        let textures: Vec<Value> =
            (0..images.len()).map(|image| json!({ "sampler": 0, "source": image })).collect();
        let images: Vec<Value> = images.iter().map(|name| json!({ "uri": percent_encoded(name) })).collect();
        let mut root = json!({
            "asset": { "version": "2.0", "generator": concat!("relief ", env!("CARGO_PKG_VERSION")) },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
            "nodes": [{ "name": self.name, "mesh": 0 }],
            "meshes": [{ "name": self.name, "primitives": [{
                "attributes": { "POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3 },
                "indices": 4,
                "material": 0,
            }] }],
            "materials": [material],
            "accessors": [
                position,
                accessor(12, "VEC3"),
                accessor(24, "VEC4"),
                accessor(40, "VEC2"),
                { "bufferView": 1, "componentType": 5123, "count": corners, "type": "SCALAR" },
            ],
            "bufferViews": [
                { "buffer": 0, "byteLength": of_vertices, "byteStride": VERTEX_BYTES, "target": 34962 },
                {
                    "buffer": 0, "byteOffset": of_vertices, "byteLength": length - of_vertices,
                    "target": 34963,
                },
            ],
            "buffers": [{ "uri": percent_encoded(buffer_name), "byteLength": length }],
        });
        // Empty lists are not allowed.
        if !images.is_empty() {
            let wrap = match self.wrap {
                Wrap::Repeat => 10497,
                Wrap::Clamp => 33071,
                Wrap::Mirror => 33648,
            };
            root["samplers"] =
                json!([{ "magFilter": 9729, "minFilter": 9987, "wrapS": wrap, "wrapT": wrap }]);
            root["textures"] = textures.into();
            root["images"] = images.into();
        }
        if self.strength().is_some() {
            root["extensionsUsed"] = json!([STRENGTH]);
        }
        root
    }

    /// Returns the factor on the emission, if there is one above 1.
    fn strength(&self) -> Option<f32> {
        let of_map = self.textures.emission.as_ref().map(|_| self.textures.emission_strength);
        of_map.filter(|strength| *strength > 1.0)
    }

    /// Returns the material and the names of its images.
    fn material(&self) -> (Value, Vec<String>) {
        let PlaneTextures { color, has_opacity, normal, surface, has_occlusion, emission, height, .. } =
            &self.textures;
        let mut images = Vec::new();
        let mut texture = |name: &String| {
            images.push(name.clone());
            json!({ "index": images.len() - 1 })
        };
        let mut base = Map::new();
        match color {
            Some(color) => base.insert("baseColorTexture".to_owned(), texture(color)),
            None => base.insert("baseColorFactor".to_owned(), json!([0.4, 0.4, 0.4, 1.0])),
        };
        let mut material = json!({ "name": self.name });
        match surface {
            Some(surface) => {
                let texture = texture(surface);
                if *has_occlusion {
                    material["occlusionTexture"] = texture.clone();
                }
                base.insert("metallicRoughnessTexture".to_owned(), texture);
            }
            None => {
                base.insert("metallicFactor".to_owned(), json!(0.0));
                base.insert("roughnessFactor".to_owned(), json!(0.5));
            }
        }
        material["pbrMetallicRoughness"] = base.into();
        if let Some(normal) = normal {
            material["normalTexture"] = texture(normal);
        }
        if let Some(emission) = emission {
            material["emissiveTexture"] = texture(emission);
            material["emissiveFactor"] = json!([1.0, 1.0, 1.0]);
        }
        if let Some(strength) = self.strength() {
            material["extensions"] = json!({ STRENGTH: { "emissiveStrength": strength } });
        }
        if color.is_some() && *has_opacity {
            material["alphaMode"] = json!("MASK");
        }
        if let Some(height) = height {
            material["extras"] = json!({
                "displacement": {
                    "uri": percent_encoded(height), "scale_m": self.scale_m, "bias_m": self.bias_m,
                },
            });
        }
        (material, images)
    }
}

/// Extension for emission above 1.
const STRENGTH: &str = "KHR_materials_emissive_strength";

/// Writes a file's name as a URI.
fn percent_encoded(name: &str) -> String {
    let mut uri = String::with_capacity(name.len());
    for byte in name.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => uri.push(char::from(byte)),
            _ => uri += &format!("%{byte:02X}"),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use std::error::Error;

    use super::*;
    use crate::{MeshOptions, read_mesh};

    fn plane(cells: u32) -> EnginePlane {
        EnginePlane {
            name: "red wall".to_owned(),
            tile_m: [2.0, 0.5],
            scale_m: 0.05,
            bias_m: -0.05,
            cells,
            wrap: Wrap::Repeat,
            textures: PlaneTextures::default(),
        }
    }

    #[test]
    fn a_plane_is_read_back() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let [gltf, bin] = ["red wall.gltf", "red wall.bin"].map(|name| folder.path().join(name));
        for cells in [1, 4] {
            write_engine_plane(&plane(cells), &gltf, &bin, "red wall.bin")?;
            let mesh = read_mesh(&gltf, &MeshOptions::default())?.mesh;
            assert_eq!(mesh.triangles().len(), 2 * (cells * cells) as usize);
            for vertex in mesh.vertices() {
                let [x, _, z] = vertex.position.to_array();
                assert_eq!([vertex.uv.x, vertex.uv.y], [0.5 * x + 0.5, 2.0 * z + 0.5]);
                assert!(vertex.normal.y > 0.999 && vertex.tangent.x > 0.999);
            }
        }
        for cells in [0, 256] {
            assert!(write_engine_plane(&plane(cells), &gltf, &bin, "red wall.bin").is_err());
        }
        Ok(())
    }

    #[test]
    fn a_material_names_what_there_is() {
        let bare = plane(1).json("a.bin", 100);
        assert_eq!(bare["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
        assert!(bare.get("images").is_none() && bare.get("extensionsUsed").is_none());
        let named = |name: &str| Some(format!("{name} 1.png"));
        let textures = PlaneTextures {
            color: named("c"),
            has_opacity: true,
            normal: named("n"),
            surface: named("orm"),
            has_occlusion: true,
            emission: named("e"),
            emission_strength: 4.0,
            height: named("h"),
        };
        let whole = EnginePlane { textures, ..plane(1) }.json("a.bin", 100);
        let material = &whole["materials"][0];
        let image = |slot: &Value| {
            let index = slot["index"].as_u64().expect("a texture") as usize;
            whole["images"][index]["uri"].as_str().map(str::to_owned)
        };
        let base = &material["pbrMetallicRoughness"];
        assert_eq!(image(&base["baseColorTexture"]).as_deref(), Some("c%201.png"));
        assert_eq!(image(&base["metallicRoughnessTexture"]).as_deref(), Some("orm%201.png"));
        assert_eq!(image(&material["occlusionTexture"]).as_deref(), Some("orm%201.png"));
        assert_eq!(image(&material["normalTexture"]).as_deref(), Some("n%201.png"));
        assert_eq!(image(&material["emissiveTexture"]).as_deref(), Some("e%201.png"));
        assert_eq!(material["extensions"][STRENGTH]["emissiveStrength"], 4.0);
        assert_eq!(material["extras"]["displacement"]["uri"], "h%201.png");
        assert_eq!(material["alphaMode"], "MASK");
    }
}
