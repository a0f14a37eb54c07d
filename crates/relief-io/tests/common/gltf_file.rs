//! Small glTF files, put together part by part.

use super::mesh_file::data_uri;

/// Numbers of an accessor.
pub enum Numbers<'a> {
    Floats(&'a [f32]),
    Bytes(&'a [u8]),
    Shorts(&'a [u16]),
}

/// A glTF whose buffer is inside of it: a square of 1 m in the plane of x and y, with the texture upright.
pub struct Gltf {
    buffer: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
    /// Attributes besides positions, normals and texture coordinates.
    pub attributes: String,
    /// More of the primitive.
    pub primitive: String,
    /// More of the node.
    pub node: String,
    /// More nodes.
    pub nodes: String,
    /// More of the mesh.
    pub mesh: String,
    /// More of the file.
    pub more: String,
}

impl Gltf {
    pub fn square() -> Self {
        Self::with_uvs(&[0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    }

    /// The square with those texture coordinates.
    pub fn with_uvs(uvs: &[f32]) -> Self {
        let mut gltf = Self {
            buffer: Vec::new(),
            views: Vec::new(),
            accessors: Vec::new(),
            attributes: String::new(),
            primitive: String::new(),
            node: String::new(),
            nodes: String::new(),
            mesh: String::new(),
            more: String::new(),
        };
        let positions = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
        gltf.add(Numbers::Floats(&positions), "VEC3", r#", "min": [0, 0, 0], "max": [1, 1, 0]"#);
        gltf.add(Numbers::Floats(&[0.0, 0.0, 1.0].repeat(4)), "VEC3", "");
        gltf.add(Numbers::Floats(uvs), "VEC2", "");
        gltf.add(Numbers::Shorts(&[0, 1, 2, 0, 2, 3]), "SCALAR", "");
        gltf
    }

    /// Adds an accessor, with more of its keys, and gives its number.
    pub fn add(&mut self, numbers: Numbers<'_>, kind: &str, more: &str) -> usize {
        let (component, bytes, count): (u32, Vec<u8>, usize) = match numbers {
            Numbers::Floats(list) => (5126, list.iter().flat_map(|n| n.to_le_bytes()).collect(), list.len()),
            Numbers::Bytes(list) => (5121, list.to_vec(), list.len()),
            Numbers::Shorts(list) => (5123, list.iter().flat_map(|n| n.to_le_bytes()).collect(), list.len()),
        };
        let parts = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        let (from, len, view) = (self.buffer.len(), bytes.len(), self.views.len());
        self.buffer.extend(bytes);
        self.views.push(format!(r#"{{"buffer": 0, "byteOffset": {from}, "byteLength": {len}}}"#));
        let count = count / parts;
        self.accessors.push(format!(
            r#"{{"bufferView": {view}, "componentType": {component}, "count": {count},
            "type": "{kind}"{more}}}"#
        ));
        view
    }

    /// The file.
    pub fn json(&self) -> Vec<u8> {
        let Self { attributes, primitive, node, nodes, mesh, more, .. } = self;
        let (uri, len) = (data_uri(&self.buffer), self.buffer.len());
        let (views, accessors) = (self.views.join(", "), self.accessors.join(", "));
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
            "nodes": [{{"mesh": 0{node}}}{nodes}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1,
            "TEXCOORD_0": 2{attributes}}}, "indices": 3{primitive}}}]{mesh}}}],
            "buffers": [{{"uri": "{uri}", "byteLength": {len}}}], "bufferViews": [{views}],
            "accessors": [{accessors}]{more}}}"#
        )
        .into_bytes()
    }
}
