//! Layout of a GLB: its contents and their offsets.

use std::collections::BTreeMap;

use glam::Vec3;

use super::super::{MeshCounts, check_counts};
use super::materials::GlbMaterials;
use super::vertex::{Quantization, attributes};
use super::{HEADERS, INDEX};
use crate::WriteProblem;

/// Bytes reserved for the least and the greatest position of a level, which are known last: six
/// numbers and their punctuation.
const BOUNDS_BYTES: usize = 160;

/// Placeholder for the least and the greatest position.
const PLACEHOLDER: &str = "@";

/// Material of a mesh without any.
const GREY: &str = r#"{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0}}"#;

/// Description of a GLB to write: its levels of detail, the finest first, and the storage of their
/// vertices.
///
/// One level is a mesh. The extension `MSFT_lod` of the first level's node names the other ones.
/// `MSFT_screencoverage` in the node's extras gives the part of the picture's area down to which
/// each is shown. Programs that do not support the extension show the first.
#[derive(Clone, Debug, PartialEq)]
pub struct GlbLayout {
    /// Levels of detail, at least one.
    pub levels: Vec<GlbLevel>,
    /// Storage of vertices in integers; none for 32-bit floats.
    pub quantization: Option<Quantization>,
    /// Whether triangles are stored as one strip a level, which needs fewer indices.
    ///
    /// Triangles of a block that touch follow each other, where possible. A repeated index turns
    /// the strip or joins two parts; readers find triangles without an area there. A strip decodes
    /// to the triangles of the blocks, with their orientation, but without those that name a vertex
    /// twice.
    pub strips: bool,
    /// Node of the mesh.
    pub node: GlbNode,
    /// Materials; none for a single grey one.
    pub materials: Option<GlbMaterials>,
}

/// Position of a GLB's mesh, and its extras.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GlbNode {
    /// Translation of the mesh by the node, in metres.
    pub translation_m: [f64; 3],
    /// Extras of the node by name, each as JSON text.
    pub extras: BTreeMap<&'static str, String>,
}

/// Greatest number of indices of a strip per triangle: three, and two to join it to the strip
/// before.
const MOST_OF_STRIP: u64 = 5;

/// Level of detail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlbLevel {
    /// Numbers of vertices and triangles.
    pub counts: MeshCounts,
    /// Part of the picture's area, from 0 to 1, down to which the level is shown.
    pub coverage: f64,
}

/// Pixels of the picture for which levels are chosen, 1920 x 1080.
const PIXELS: f64 = 1920.0 * 1080.0;

/// Mean number of pixels that a triangle of a level may cover before the next finer level is shown.
const PIXELS_PER_TRIANGLE: f64 = 4.0;

impl GlbLevel {
    /// Creates levels with the given counts, the finest first. Each level is shown down to the
    /// coverage at which the triangles of the next one cover four pixels on average, in a picture
    /// of 1920 x 1080. Each coverage is at most half of the one before; the last is 0.
    pub fn of(counts: &[MeshCounts]) -> Vec<Self> {
        let mut before = 1.0_f64;
        let next = counts.iter().skip(1).map(Some).chain([None]);
        let level = |(&counts, next): (&MeshCounts, Option<&MeshCounts>)| {
            let enough = next.map_or(0.0, |next| next.triangles as f64 * PIXELS_PER_TRIANGLE / PIXELS);
            before = enough.min(before / 2.0);
            Self { counts, coverage: before }
        };
        counts.iter().zip(next).map(level).collect()
    }
}

impl GlbLayout {
    /// Creates a layout of one mesh, stored in floats.
    pub fn of(counts: MeshCounts) -> Self {
        let levels = vec![GlbLevel { counts, coverage: 0.0 }];
        Self { levels, quantization: None, strips: false, node: GlbNode::default(), materials: None }
    }

    /// Bytes of the file: exact, but an upper bound for strips.
    pub fn bytes(&self) -> u64 {
        self.before() + self.buffer(&self.indices(MOST_OF_STRIP))
    }

    /// Bytes before the buffer.
    pub(super) fn before(&self) -> u64 {
        HEADERS[0] + self.json_bytes() + HEADERS[1]
    }

    /// Number of indices of each level, with `of_strip` for each triangle of a strip.
    fn indices(&self, of_strip: u64) -> Vec<u64> {
        let of_triangle = if self.strips { of_strip } else { 3 };
        self.levels.iter().map(|level| of_triangle * level.counts.triangles).collect()
    }

    /// Numbers of vertices and triangles of all levels.
    pub fn counts(&self) -> MeshCounts {
        let sum = |of: fn(&MeshCounts) -> u64| self.levels.iter().map(|level| of(&level.counts)).sum();
        MeshCounts { vertices: sum(|counts| counts.vertices), triangles: sum(|counts| counts.triangles) }
    }

    /// Checks whether a file can hold the levels.
    ///
    /// # Errors
    ///
    /// When there is no level; when one has no triangles, or counts beyond 32 bits; when a coverage
    /// is not from 0 to 1 or not less than the one before; or when the file would be longer than 4
    /// GiB.
    pub fn check(&self) -> Result<(), WriteProblem> {
        for level in &self.levels {
            check_counts(level.counts)?;
        }
        if let Some(materials) = &self.materials {
            materials.check(self)?;
        }
        let coverages: Vec<f64> = self.levels.iter().map(|level| level.coverage).collect();
        let in_range = coverages.iter().all(|coverage| (0.0..=1.0).contains(coverage));
        if self.levels.is_empty() || !in_range || coverages.windows(2).any(|pair| pair[1] >= pair[0]) {
            let what =
                "there must be a level of detail, and each must have a smaller coverage than the one before";
            return Err(WriteProblem::NotStorable(what.to_owned()));
        }
        // The length of strips is not known yet: one index a triangle is the least.
        let bytes = self.before() + self.buffer(&self.indices(1));
        if bytes > u64::from(u32::MAX) {
            let MeshCounts { vertices, triangles } = self.counts();
            return Err(WriteProblem::NotStorable(format!(
                "a mesh of {vertices} vertices and {triangles} triangles takes {bytes} bytes as GLB, which \
                 ends at 4 GiB: write a PLY, or make it coarser"
            )));
        }
        Ok(())
    }

    /// Bytes of a level's vertices and of its `indices` indices.
    fn sizes(&self, counts: MeshCounts, indices: u64) -> [u64; 2] {
        [attributes(self.quantization.as_ref()).1 * counts.vertices, INDEX * indices]
    }

    /// Bytes of the buffer, given the number of indices of each level.
    pub(super) fn buffer(&self, indices: &[u64]) -> u64 {
        self.pictures_at(indices) + self.materials.as_ref().map_or(0, GlbMaterials::bytes)
    }

    /// Offset of the pictures in the buffer, given the number of indices of each level.
    pub(super) fn pictures_at(&self, indices: &[u64]) -> u64 {
        self.offsets(self.levels.len(), indices)[0]
    }

    /// Primitives of a level: each material that is used, with its number of triangles.
    pub(super) fn parts(&self, level: usize) -> Vec<(usize, u64)> {
        let counts = self.materials.as_ref().and_then(|materials| materials.counts.get(level));
        match counts {
            Some(counts) => counts.iter().copied().enumerate().filter(|(_, count)| *count > 0).collect(),
            None => vec![(0, self.levels[level].counts.triangles)],
        }
    }

    /// Offsets of a level's vertices and indices in the buffer, given the number of indices of the
    /// levels before it. After the last level both are the end.
    pub(super) fn offsets(&self, level: usize, indices: &[u64]) -> [u64; 2] {
        let all = || self.levels.iter().zip(indices);
        let before = all().take(level).flat_map(|(level, indices)| self.sizes(level.counts, *indices)).sum();
        let of_vertices = self.levels.get(level).map_or(0, |level| self.sizes(level.counts, 0)[0]);
        [before, before + of_vertices]
    }

    /// Bytes of the JSON in the file.
    pub(super) fn json_bytes(&self) -> u64 {
        let bounds = self.levels.len() * (BOUNDS_BYTES - PLACEHOLDER.len());
        ((self.json(&self.indices(MOST_OF_STRIP)).len() + bounds) as u64).next_multiple_of(4)
    }

    /// The JSON with the least and the greatest positions and the indices of the levels, padded to
    /// its length in the file.
    pub(super) fn json_with(&self, bounds: &[[Vec3; 2]], indices: &[u64]) -> Vec<u8> {
        let mut json = self.json(indices);
        for corners in bounds {
            let [least, greatest] = corners.map(|corner| {
                // Codes are written as integers.
                let is_whole = self.quantization.is_some();
                let numbers = corner
                    .to_array()
                    .map(|number| if is_whole { format!("{number}") } else { format!("{number:e}") });
                numbers.join(",")
            });
            json = json.replacen(PLACEHOLDER, &format!(r#","min":[{least}],"max":[{greatest}]"#), 1);
        }
        let mut json = json.into_bytes();
        json.resize(self.json_bytes() as usize, b' ');
        json
    }

    /// The JSON for the given number of indices of each level, with placeholders for the least and
    /// the greatest positions.
    fn json(&self, indices: &[u64]) -> String {
        let (lists, vertex_bytes) = attributes(self.quantization.as_ref());
        let (mut meshes, mut views, mut accessors) = (Vec::new(), Vec::new(), Vec::new());
        for (at, GlbLevel { counts, .. }) in self.levels.iter().enumerate() {
            let MeshCounts { vertices, .. } = *counts;
            let ([vertices_at, indices_at], count) = (self.offsets(at, indices), indices[at]);
            let sizes = self.sizes(*counts, count);
            let mode = if self.strips { r#","mode":5"# } else { "" };
            let first = accessors.len();
            let named = [0, 1, 2, 3].map(|k| format!(r#""{}":{}"#, lists[k].name, first + k)).join(",");
            let parts = self.parts(at);
            let primitive = |(part, (material, _)): (usize, &(usize, u64))| {
                format!(r#"{{"attributes":{{{named}}},"#)
                    + &format!(r#""indices":{},"material":{material}{mode}}}"#, first + 4 + part)
            };
            let primitives: Vec<String> = parts.iter().enumerate().map(primitive).collect();
            meshes.push(format!(r#"{{"primitives":[{}]}}"#, primitives.join(",")));
            views.push(
                format!(r#"{{"buffer":0,"byteOffset":{vertices_at},"byteLength":{},"#, sizes[0])
                    + &format!(r#""byteStride":{vertex_bytes},"target":34962}}"#),
            );
            views.push(
                format!(r#"{{"buffer":0,"byteOffset":{indices_at},"byteLength":{},"#, sizes[1])
                    + r#""target":34963}"#,
            );
            for (k, list) in lists.iter().enumerate() {
                let place = if k == 0 { PLACEHOLDER } else { "" };
                accessors.push(list.accessor(2 * at, vertices) + place + "}");
            }
            let mut from = 0;
            for (_, triangles) in &parts {
                let of_part = if parts.len() > 1 { 3 * triangles } else { count };
                let offset =
                    if from > 0 { format!(r#""byteOffset":{},"#, INDEX * from) } else { String::new() };
                accessors.push(
                    format!(r#"{{"bufferView":{},{offset}"componentType":5125,"#, 2 * at + 1)
                        + &format!(r#""count":{of_part},"type":"SCALAR"}}"#),
                );
                from += of_part;
            }
        }
        let (materials, of_pictures) = match &self.materials {
            Some(materials) => (materials.json(), materials.json_of_pictures(views.len())),
            None => (GREY.to_owned(), String::new()),
        };
        if let Some(materials) = &self.materials {
            views.extend(materials.views(self.pictures_at(indices)));
        }
        let version = env!("CARGO_PKG_VERSION");
        format!(r#"{{"asset":{{"version":"2.0","generator":"relief {version}"}},"#)
            + &self.extensions()
            + &format!(r#""scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],"#, self.nodes())
            + &format!(r#""materials":[{materials}],{of_pictures}"#)
            + &format!(r#""meshes":[{}],"#, meshes.join(","))
            + &format!(r#""buffers":[{{"byteLength":{}}}],"#, self.buffer(indices))
            + &format!(r#""bufferViews":[{}],"accessors":[{}]}}"#, views.join(","), accessors.join(","))
    }

    /// Extensions that are used, and those that are required to read the file.
    fn extensions(&self) -> String {
        let quantization = self.quantization.map(|_| r#""KHR_mesh_quantization""#);
        let lods = (self.levels.len() > 1).then_some(r#""MSFT_lod""#);
        let is_moved = self.materials.as_ref().is_some_and(GlbMaterials::has_transforms);
        let transforms = is_moved.then_some(r#""KHR_texture_transform""#);
        let of_materials = self.materials.iter().flat_map(GlbMaterials::extensions);
        let of_materials: Vec<String> = of_materials.map(|name| format!("\"{name}\"")).collect();
        let used = [quantization, lods, transforms].into_iter().flatten();
        let used: Vec<&str> = used.chain(of_materials.iter().map(String::as_str)).collect();
        let required = quantization.map(|name| format!(r#""extensionsRequired":[{name}],"#));
        if used.is_empty() {
            return String::new();
        }
        format!(r#""extensionsUsed":[{}],{}"#, used.join(","), required.unwrap_or_default())
    }

    /// Nodes, one for each level.
    fn nodes(&self) -> String {
        let moved = self.node.translation_m;
        let is_moved = moved != [0.0; 3];
        let place = match self.quantization {
            Some(Quantization { grid, .. }) => {
                let (step, origin) = (grid.step_m(), grid.origin_m().to_array());
                let at = [0, 1, 2].map(|axis| format!("{:e}", origin[axis] + moved[axis]));
                format!(r#","scale":[{step:e},{step:e},{step:e}],"translation":[{}]"#, at.join(","))
            }
            None if is_moved => {
                format!(r#","translation":[{}]"#, moved.map(|number| format!("{number:e}")).join(","))
            }
            None => String::new(),
        };
        let node = |at: usize| {
            let lods = if at == 0 && self.levels.len() > 1 { self.lods() } else { String::new() };
            format!(r#"{{"mesh":{at}{place}{lods}{}}}"#, self.extras(at))
        };
        (0..self.levels.len()).map(node).collect::<Vec<_>>().join(",")
    }

    /// Extras of a level's node: the extras of the mesh, and the coverage of each level.
    fn extras(&self, level: usize) -> String {
        // The placeholder must not occur in them.
        let clean = |text: &String| text.replace(PLACEHOLDER, "\\u0040");
        let said = self.node.extras.iter().map(|(name, text)| format!(r#""{name}":{}"#, clean(text)));
        let coverages = || {
            let each: Vec<String> = self.levels.iter().map(|level| format!("{:e}", level.coverage)).collect();
            format!(r#""MSFT_screencoverage":[{}]"#, each.join(","))
        };
        let of_lods = (level == 0 && self.levels.len() > 1).then(coverages);
        let all: Vec<String> = said.chain(of_lods).collect();
        if all.is_empty() { String::new() } else { format!(r#","extras":{{{}}}"#, all.join(",")) }
    }

    /// Extension that names the other levels.
    fn lods(&self) -> String {
        let ids: Vec<String> = (1..self.levels.len()).map(|level| level.to_string()).collect();
        format!(r#","extensions":{{"MSFT_lod":{{"ids":[{}]}}}}"#, ids.join(","))
    }
}
