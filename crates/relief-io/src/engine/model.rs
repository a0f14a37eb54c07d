//! Mesh with the material of an engine, as glTF.

use std::path::Path;

use relief_core::Wrap;
use relief_core::mesh::Mesh;
use serde_json::{Map, Value, json};

use super::VertexFrames;
use crate::{WriteError, WriteProblem, write_atomically};

/// Textures of a plane's material: names of files beside the glTF.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelTextures {
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

/// Mesh with a material.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineModel {
    /// Name of the material.
    pub name: String,
    /// The mesh.
    pub shape: EngineShape,
    /// Displacement of height 1 above height 0, in metres.
    pub scale_m: f64,
    /// Displacement of height 0, in metres.
    pub bias_m: f64,
    /// Continuation of the textures beyond their edges.
    pub wrap: Wrap,
    /// Textures of the material.
    pub textures: ModelTextures,
}

/// Mesh of an [`EngineModel`].
#[derive(Clone, Debug, PartialEq)]
pub enum EngineShape {
    /// Plane of one tile, which lies around the origin and faces up along `y`.
    Plane {
        /// Lengths along `u`, which is along `x`, and `v`, which is along `z`, in metres.
        tile_m: [f64; 2],
        /// Cells along each side, 1 to 255, so that 16 bits number the vertices.
        cells: u32,
    },
    /// Another mesh. It gets the attributes `_TILE` and `_CURVATURE` of [`VertexFrames`], too.
    Mesh(Mesh),
}

/// Most cells along a side of a plane.
const MOST_CELLS: u32 = 255;

/// Attributes of a vertex: names, glTF's types and numbers of floats.
const ATTRIBUTES: [(&str, &str, usize); 6] = [
    ("POSITION", "VEC3", 3),
    ("NORMAL", "VEC3", 3),
    ("TANGENT", "VEC4", 4),
    ("TEXCOORD_0", "VEC2", 2),
    ("_TILE", "VEC2", 2),
    ("_CURVATURE", "VEC3", 3),
];

/// Number of the attributes of a plane, whose frame is everywhere the same.
const OF_PLANE: usize = 4;

/// Writes a model as glTF with its vertices in the file `buffer`, which lies beside the glTF under
/// the name `buffer_name`. Textures are named in it, not written.
///
/// # Errors
///
/// When a plane has no cells or more than 255, when a mesh has no triangles or is longer than 4 GiB, or
/// when a file cannot be written.
pub fn write_engine_model(
    model: &EngineModel,
    gltf: &Path,
    buffer: &Path,
    buffer_name: &str,
) -> Result<(), WriteError> {
    model.shape.check().map_err(|what| WriteProblem::NotStorable(what).at(gltf))?;
    let contents = model.shape.buffer();
    write_atomically(buffer, |out| out.write_all(&contents.bytes))?;
    let text = format!("{:#}\n", model.json(buffer_name, &contents));
    write_atomically(gltf, |out| out.write_all(text.as_bytes()))
}

/// Vertices, one after the other, and then the corners of the triangles.
struct Contents {
    bytes: Vec<u8>,
    vertices: usize,
    corners: usize,
    /// Least and greatest positions.
    bounds: [[f32; 3]; 2],
}

impl EngineShape {
    fn check(&self) -> Result<(), String> {
        match self {
            Self::Plane { cells, .. } if !(1..=MOST_CELLS).contains(cells) => {
                Err(format!("a plane has 1 to {MOST_CELLS} cells along a side, not {cells}"))
            }
            Self::Mesh(mesh) if mesh.triangles().is_empty() => Err("the mesh has no triangles".to_owned()),
            Self::Mesh(mesh) => {
                let (vertices, corners) = (mesh.vertices().len() as u64, 3 * mesh.triangles().len() as u64);
                let bytes = vertices * self.vertex_bytes() as u64 + corners * self.index_bytes() as u64;
                match u32::try_from(bytes) {
                    Ok(_) => Ok(()),
                    Err(_) => Err(format!("the mesh takes {bytes} bytes, and a glTF buffer ends at 4 GiB")),
                }
            }
            Self::Plane { .. } => Ok(()),
        }
    }

    fn attributes(&self) -> &'static [(&'static str, &'static str, usize)] {
        match self {
            Self::Plane { .. } => &ATTRIBUTES[..OF_PLANE],
            Self::Mesh(_) => &ATTRIBUTES,
        }
    }

    fn vertex_bytes(&self) -> usize {
        4 * self.attributes().iter().map(|(.., floats)| floats).sum::<usize>()
    }

    fn index_bytes(&self) -> usize {
        match self {
            Self::Plane { .. } => 2,
            Self::Mesh(_) => 4,
        }
    }

    fn buffer(&self) -> Contents {
        match self {
            Self::Plane { tile_m, cells } => plane(*tile_m, *cells),
            Self::Mesh(mesh) => of_mesh(mesh),
        }
    }
}

fn plane(tile_m: [f64; 2], cells: u32) -> Contents {
    let [half_x, half_z] = tile_m.map(|side| 0.5 * side as f32);
    let mut bytes = Vec::new();
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
    Contents {
        bytes,
        vertices: (cells as usize + 1).pow(2),
        corners: 6 * (cells as usize).pow(2),
        bounds: [[-half_x, 0.0, -half_z], [half_x, 0.0, half_z]],
    }
}

fn of_mesh(mesh: &Mesh) -> Contents {
    let VertexFrames { tangents, tiles_m, curvatures } = VertexFrames::of(mesh);
    let frames = tangents.iter().zip(&tiles_m).zip(&curvatures);
    let mut bytes = Vec::new();
    let mut bounds = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for (vertex, ((tangent, tile), curvature)) in mesh.vertices().iter().zip(frames) {
        let (position, normal, uv) =
            (vertex.position.to_array(), vertex.normal.to_array(), vertex.uv.to_array());
        for (axis, at) in position.into_iter().enumerate() {
            bounds[0][axis] = bounds[0][axis].min(at);
            bounds[1][axis] = bounds[1][axis].max(at);
        }
        let values = position.iter().chain(&normal).chain(tangent).chain(&uv).chain(tile).chain(curvature);
        bytes.extend(values.flat_map(|value| value.to_le_bytes()));
    }
    let corners = mesh.triangles().as_flattened();
    bytes.extend(corners.iter().flat_map(|corner| corner.to_le_bytes()));
    Contents { bytes, vertices: mesh.vertices().len(), corners: corners.len(), bounds }
}

impl EngineModel {
    fn json(&self, buffer_name: &str, contents: &Contents) -> Value {
        let Contents { bytes, vertices, corners, bounds: [least, greatest] } = contents;
        let vertex_bytes = self.shape.vertex_bytes();
        let of_vertices = vertices * vertex_bytes;
        let (mut attributes, mut accessors, mut offset) = (Map::new(), Vec::new(), 0);
        for (number, (name, kind, floats)) in self.shape.attributes().iter().enumerate() {
            attributes.insert((*name).to_owned(), number.into());
            accessors.push(json!({
                "bufferView": 0, "byteOffset": offset, "componentType": 5126, "count": vertices, "type": kind,
            }));
            offset += 4 * floats;
        }
        accessors[0]["min"] = json!(least);
        accessors[0]["max"] = json!(greatest);
        let component = if self.shape.index_bytes() == 2 { 5123 } else { 5125 };
        let indices = accessors.len();
        accessors.push(json!({
            "bufferView": 1, "componentType": component, "count": corners, "type": "SCALAR",
        }));
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
                "attributes": attributes,
                "indices": indices,
                "material": 0,
            }] }],
            "materials": [material],
            "accessors": accessors,
            "bufferViews": [
                { "buffer": 0, "byteLength": of_vertices, "byteStride": vertex_bytes, "target": 34962 },
                {
                    "buffer": 0, "byteOffset": of_vertices, "byteLength": bytes.len() - of_vertices,
                    "target": 34963,
                },
            ],
            "buffers": [{ "uri": percent_encoded(buffer_name), "byteLength": bytes.len() }],
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
        let ModelTextures { color, has_opacity, normal, surface, has_occlusion, emission, height, .. } =
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

/// Writes a file's name as a part of a URI.
pub fn percent_encoded(name: &str) -> String {
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

    fn model(cells: u32) -> EngineModel {
        EngineModel {
            name: "red wall".to_owned(),
            shape: EngineShape::Plane { tile_m: [2.0, 0.5], cells },
            scale_m: 0.05,
            bias_m: -0.05,
            wrap: Wrap::Repeat,
            textures: ModelTextures::default(),
        }
    }

    fn contents() -> Contents {
        Contents { bytes: Vec::new(), vertices: 0, corners: 0, bounds: [[0.0; 3]; 2] }
    }

    #[test]
    fn a_mesh_is_read_back_with_its_frames() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let [gltf, bin] = ["ball.gltf", "ball.bin"].map(|name| folder.path().join(name));
        let mesh = relief_core::mesh::torus(16, 8)?;
        let model = EngineModel { shape: EngineShape::Mesh(mesh.clone()), ..model(1) };
        write_engine_model(&model, &gltf, &bin, "ball.bin")?;
        // The reader numbers vertices anew.
        let corners = |mesh: &Mesh| -> Vec<_> {
            let all = mesh.triangles().as_flattened().iter();
            all.map(|corner| mesh.vertices()[*corner as usize].position).collect()
        };
        assert_eq!(corners(&read_mesh(&gltf, &MeshOptions::default())?.mesh), corners(&mesh));
        let text: Value = serde_json::from_slice(&std::fs::read(&gltf)?)?;
        let bytes = std::fs::read(&bin)?;
        let accessor = |name: &str| {
            let number = text["meshes"][0]["primitives"][0]["attributes"][name].as_u64().expect("a number");
            text["accessors"][number as usize].clone()
        };
        let frames = VertexFrames::of(&mesh);
        let stride = text["bufferViews"][0]["byteStride"].as_u64().expect("a number") as usize;
        let offset = accessor("_CURVATURE")["byteOffset"].as_u64().expect("a number") as usize;
        for (vertex, curvature) in frames.curvatures.iter().enumerate() {
            let at = vertex * stride + offset;
            let read: Vec<f32> =
                bytes[at..at + 12].as_chunks().0.iter().map(|of| f32::from_le_bytes(*of)).collect();
            assert_eq!(read, curvature);
        }
        assert_eq!(accessor("_TILE")["type"], "VEC2");
        let empty = EngineShape::Mesh(Mesh::new(Vec::new(), Vec::new())?);
        assert!(write_engine_model(&EngineModel { shape: empty, ..model }, &gltf, &bin, "ball.bin").is_err());
        Ok(())
    }

    #[test]
    fn a_plane_is_read_back() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let [gltf, bin] = ["red wall.gltf", "red wall.bin"].map(|name| folder.path().join(name));
        for cells in [1, 4] {
            write_engine_model(&model(cells), &gltf, &bin, "red wall.bin")?;
            let mesh = read_mesh(&gltf, &MeshOptions::default())?.mesh;
            assert_eq!(mesh.triangles().len(), 2 * (cells * cells) as usize);
            for vertex in mesh.vertices() {
                let [x, _, z] = vertex.position.to_array();
                assert_eq!([vertex.uv.x, vertex.uv.y], [0.5 * x + 0.5, 2.0 * z + 0.5]);
                assert!(vertex.normal.y > 0.999 && vertex.tangent.x > 0.999);
            }
        }
        for cells in [0, 256] {
            assert!(write_engine_model(&model(cells), &gltf, &bin, "red wall.bin").is_err());
        }
        Ok(())
    }

    #[test]
    fn a_material_names_what_there_is() {
        let bare = model(1).json("a.bin", &contents());
        assert_eq!(bare["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
        assert!(bare.get("images").is_none() && bare.get("extensionsUsed").is_none());
        let named = |name: &str| Some(format!("{name} 1.png"));
        let textures = ModelTextures {
            color: named("c"),
            has_opacity: true,
            normal: named("n"),
            surface: named("orm"),
            has_occlusion: true,
            emission: named("e"),
            emission_strength: 4.0,
            height: named("h"),
        };
        let whole = EngineModel { textures, ..model(1) }.json("a.bin", &contents());
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
