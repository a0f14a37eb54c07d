//! Materials of a GLB, with their pictures.

use std::sync::Arc;

use png::{BitDepth, ColorType, Encoder};
use relief_core::Wrap;
use relief_core::mesh::MeshBlock;
use serde_json::{Value, json};

use super::layout::GlbLayout;
use crate::{MeshMaterial, Picture, WriteProblem, linear_to_srgb};

/// Greatest deviation, in each number, of a transform from one that only rotates and scales.
const NEAR: f64 = 1e-4;

/// Materials of a mesh to write as GLB: their names, base colours, masks and pictures, which are
/// stored as PNG of 8 bits a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct GlbMaterials {
    materials: Vec<MeshMaterial>,
    /// Material of each triangle of the base mesh. Empty if all have the first one.
    of_base: Vec<u32>,
    /// Number of triangles of each level with each material.
    pub(super) counts: Vec<Vec<u64>>,
    /// Pictures, each once, with their PNG files.
    pictures: Vec<(Arc<Picture>, Vec<u8>)>,
}

impl GlbMaterials {
    /// Creates a set of materials. `of_base` holds the material's index for each base triangle;
    /// empty if all have the first one.
    ///
    /// # Errors
    ///
    /// When there is no material; when a triangle's material does not exist; when a picture's
    /// transform cannot be expressed in glTF; or when a picture's number of texels does not match
    /// its sides.
    pub fn new(materials: Vec<MeshMaterial>, of_base: Vec<u32>) -> Result<Self, WriteProblem> {
        let problem = |what: &str| Err(WriteProblem::NotStorable(what.to_owned()));
        if materials.is_empty() || of_base.iter().any(|number| *number as usize >= materials.len()) {
            return problem("a triangle has a material that does not exist");
        }
        let mut pictures: Vec<(Arc<Picture>, Vec<u8>)> = Vec::new();
        for material in &materials {
            let Some(picture) = &material.picture else { continue };
            if transform_of(material).is_none() {
                return problem("the picture of a material is slanted, which glTF cannot express");
            }
            if !pictures.iter().any(|(known, _)| Arc::ptr_eq(known, picture)) {
                pictures.push((Arc::clone(picture), encoded(picture)?));
            }
        }
        Ok(Self { materials, of_base, counts: Vec::new(), pictures })
    }

    /// Whether triangles have different materials.
    pub fn has_several(&self) -> bool {
        !self.of_base.is_empty()
    }

    /// Counts the triangles of a block of a level by material; level 0 is the finest.
    pub fn count(&mut self, level: usize, block: &MeshBlock) {
        if self.counts.len() <= level {
            self.counts.resize(level + 1, vec![0; self.materials.len()]);
        }
        for at in 0..block.triangles.len() {
            let material = self.of_triangle(block, at);
            self.counts[level][material] += 1;
        }
    }

    /// Material of a triangle of a block. Triangles that belong to no base triangle have the first
    /// one.
    pub(super) fn of_triangle(&self, block: &MeshBlock, at: usize) -> usize {
        let owner = block.owners.get(at).copied().unwrap_or(MeshBlock::NO_OWNER);
        self.of_base.get(owner as usize).map_or(0, |number| *number as usize)
    }

    /// Checks that the triangles of all levels have been counted if they have several materials,
    /// and are not stored as strips.
    pub(super) fn check(&self, layout: &GlbLayout) -> Result<(), WriteProblem> {
        if !self.has_several() {
            return Ok(());
        }
        let counted: Vec<u64> = self.counts.iter().map(|counts| counts.iter().sum()).collect();
        let wanted: Vec<u64> = layout.levels.iter().map(|level| level.counts.triangles).collect();
        if layout.strips || counted != wanted {
            let what = "triangles of several materials must be counted, and cannot be stored as strips";
            return Err(WriteProblem::NotStorable(what.to_owned()));
        }
        Ok(())
    }

    /// Bytes of the pictures in the buffer.
    pub(super) fn bytes(&self) -> u64 {
        self.pictures.iter().map(|(_, png)| png.len() as u64).sum()
    }

    /// Pictures as PNG, padded to a multiple of 4 bytes.
    pub(super) fn pictures(&self) -> impl Iterator<Item = &Vec<u8>> {
        self.pictures.iter().map(|(_, png)| png)
    }

    /// Whether a picture has coordinates other than the mesh's.
    pub(super) fn has_transforms(&self) -> bool {
        self.materials.iter().any(|of| of.picture.is_some() && of.transform != MeshMaterial::IDENTITY)
    }

    /// Number of a material's texture.
    fn texture(&self, at: usize) -> usize {
        self.materials[..at].iter().filter(|before| before.picture.is_some()).count()
    }

    /// Materials as JSON, separated by commas.
    pub(super) fn json(&self) -> String {
        let each = self.materials.iter().enumerate().map(|(at, material)| {
            let mut base = json!({ "baseColorFactor": material.factor, "metallicFactor": 0 });
            if material.picture.is_some() {
                let mut info = json!({ "index": self.texture(at) });
                if let Some(moved) =
                    transform_of(material).filter(|_| material.transform != MeshMaterial::IDENTITY)
                {
                    info["extensions"] = json!({ "KHR_texture_transform": moved });
                }
                base["baseColorTexture"] = info;
            }
            let mut of = json!({ "pbrMetallicRoughness": base });
            if let Some(name) = &material.name {
                of["name"] = json!(&**name);
            }
            if let Some(cutoff) = material.cutoff {
                of["alphaMode"] = json!("MASK");
                of["alphaCutoff"] = json!(cutoff);
            }
            clean(&of)
        });
        each.collect::<Vec<String>>().join(",")
    }

    /// Textures, samplers and images as JSON. Buffer views of images are numbered from `first`.
    pub(super) fn json_of_pictures(&self, first: usize) -> String {
        let with_picture = || self.materials.iter().filter_map(|of| Some((of, of.picture.as_ref()?)));
        if with_picture().next().is_none() {
            return String::new();
        }
        let image_of = |picture: &Arc<Picture>| {
            self.pictures.iter().position(|(known, _)| Arc::ptr_eq(known, picture)).unwrap_or_default()
        };
        let textures: Vec<Value> = with_picture()
            .enumerate()
            .map(|(at, (_, picture))| json!({ "sampler": at, "source": image_of(picture) }))
            .collect();
        let code = |wrap: Wrap| match wrap {
            Wrap::Repeat => 10497,
            Wrap::Clamp => 33071,
            Wrap::Mirror => 33648,
        };
        let sampler = |(of, _): (&MeshMaterial, _)| {
            let [u, v] = of.wrap.map(code);
            json!({ "magFilter": 9729, "minFilter": 9987, "wrapS": u, "wrapT": v })
        };
        let samplers: Vec<Value> = with_picture().map(sampler).collect();
        let images: Vec<Value> = (first..first + self.pictures.len())
            .map(|view| json!({ "bufferView": view, "mimeType": "image/png" }))
            .collect();
        let [textures, samplers, images] = [textures, samplers, images].map(|all| clean(&json!(all)));
        format!(r#""textures":{textures},"samplers":{samplers},"images":{images},"#)
    }

    /// Buffer views of the pictures; the first one begins at offset `at`.
    pub(super) fn views(&self, mut at: u64) -> Vec<String> {
        let view = |png: &Vec<u8>| {
            let first = at;
            at += png.len() as u64;
            format!(r#"{{"buffer":0,"byteOffset":{first},"byteLength":{}}}"#, png.len())
        };
        self.pictures().map(view).collect()
    }
}

/// JSON text in which the placeholder does not occur.
fn clean(value: &Value) -> String {
    value.to_string().replace('@', "\\u0040")
}

/// Translation, rotation and scale of a material's picture (KHR_texture_transform); none if it is
/// slanted.
fn transform_of(material: &MeshMaterial) -> Option<Value> {
    let [[a, b, x], [c, d, y]] = material.transform.map(|row| row.map(f64::from));
    let along_u = a.hypot(c);
    let turn = if along_u > 0.0 { (-c).atan2(a) } else { b.atan2(d) };
    let along_v = b * turn.sin() + d * turn.cos();
    let size = along_u.abs().max(along_v.abs()).max(1.0);
    let is_slanted = (b * turn.cos() - d * turn.sin()).abs() > NEAR * size;
    let is_finite = [a, b, c, d, x, y].iter().all(|number| number.is_finite());
    (is_finite && !is_slanted)
        .then(|| json!({ "offset": [x, y], "rotation": turn, "scale": [along_u, along_v] }))
}

/// Encodes a picture as PNG of 8 bits a channel, padded with zeros to a multiple of 4 bytes. Opaque
/// ones have no alpha channel.
fn encoded(picture: &Picture) -> Result<Vec<u8>, WriteProblem> {
    let problem = |error: png::EncodingError| WriteProblem::NotStorable(error.to_string());
    let code = |part: f32| (255.0 * part.clamp(0.0, 1.0)).round() as u8;
    let srgb = |part: f32| (255.0 * linear_to_srgb(f64::from(part).clamp(0.0, 1.0))).round() as u8;
    let is_opaque = picture.texels.iter().all(|texel| texel[3] >= 1.0);
    let channels = if is_opaque { 3 } else { 4 };
    let mut texels = Vec::with_capacity(channels * picture.texels.len());
    for [red, green, blue, opacity] in &picture.texels {
        texels.extend([*red, *green, *blue].map(srgb));
        texels.extend((!is_opaque).then(|| code(*opacity)));
    }
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(if is_opaque { ColorType::Rgb } else { ColorType::Rgba });
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(problem)?;
    writer.write_image_data(&texels).map_err(problem)?;
    writer.finish().map_err(problem)?;
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    Ok(bytes)
}
