//! Materials of a GLB, with their pictures.

use std::sync::Arc;

use png::{BitDepth, ColorType, Encoder};
use relief_core::Wrap;
use relief_core::mesh::MeshBlock;
use serde_json::{Map, Value, json};

use super::layout::GlbLayout;
use crate::{Curve, MaterialValues, MeshMaterial, Picture, WriteProblem, linear_to_srgb};

/// Greatest deviation, in each number, of a transform from one that only rotates and scales.
const NEAR: f64 = 1e-4;

/// Greatest distance of a channel from a whole number of 255 that counts as that number.
const LEAST_CHANGE: f32 = 1e-3;

/// Materials of a mesh to write as GLB: their names, base colours, masks, values and pictures.
/// Pictures are stored as PNG of 8 bits a channel; pictures other than of colours and emission have 16
/// if 8 would change them.
#[derive(Clone, Debug, PartialEq)]
pub struct GlbMaterials {
    materials: Vec<MeshMaterial>,
    /// Material of each triangle of the base mesh. Empty if all have the first one.
    of_base: Vec<u32>,
    /// Number of triangles of each level with each material.
    pub(super) counts: Vec<Vec<u64>>,
    /// Pictures, each once by each curve, with their PNG files.
    pictures: Vec<(Arc<Picture>, Curve, Vec<u8>)>,
}

/// Texture of a material.
struct Texture<'a> {
    picture: &'a Arc<Picture>,
    curve: Curve,
    wrap: [Wrap; 2],
    use_of: Use,
}

/// Use of a texture by its material.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    Color,
    MetallicRoughness,
    Normal,
    Occlusion,
    Emission,
}

/// Returns the textures of a material, in the order in which they are numbered.
fn textures(material: &MeshMaterial) -> Vec<Texture<'_>> {
    let of = &material.values.textures;
    let normal = of.normal.as_ref();
    let all = [
        (Use::Color, material.picture.as_ref(), Curve::Srgb),
        (Use::MetallicRoughness, of.metallic_roughness.as_ref(), Curve::Linear),
        (Use::Normal, normal.map(|of| &of.picture), Curve::Linear),
        (Use::Occlusion, of.occlusion.as_ref().map(|of| &of.picture), Curve::Linear),
        (Use::Emission, of.emission.as_ref(), Curve::Srgb),
    ];
    let of_normal = normal.map_or(material.wrap, |of| of.wrap);
    let mut used = Vec::new();
    for (use_of, picture, curve) in all {
        let wrap = if use_of == Use::Normal { of_normal } else { material.wrap };
        used.extend(picture.map(|picture| Texture { picture, curve, wrap, use_of }));
    }
    used
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
        let mut pictures: Vec<(Arc<Picture>, Curve, Vec<u8>)> = Vec::new();
        for material in &materials {
            if material.has_placed_pictures() && transform_of(material).is_none() {
                return problem("the picture of a material is slanted, which glTF cannot express");
            }
            for Texture { picture, curve, .. } in textures(material) {
                let is = |(known, with, _): &(Arc<Picture>, Curve, _)| {
                    Arc::ptr_eq(known, picture) && *with == curve
                };
                if !pictures.iter().any(is) {
                    pictures.push((Arc::clone(picture), curve, encoded(picture, curve)?));
                }
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
        self.pictures.iter().map(|(.., png)| png.len() as u64).sum()
    }

    /// Pictures as PNG, padded to a multiple of 4 bytes.
    pub(super) fn pictures(&self) -> impl Iterator<Item = &Vec<u8>> {
        self.pictures.iter().map(|(.., png)| png)
    }

    /// Whether a picture has coordinates other than the mesh's.
    pub(super) fn has_transforms(&self) -> bool {
        let is_moved = |of: &MeshMaterial| of.has_placed_pictures() && of.transform != MeshMaterial::IDENTITY;
        self.materials.iter().any(is_moved)
    }

    /// Names of the extensions of materials that are used.
    pub(super) fn extensions(&self) -> Vec<&'static str> {
        let is_used = |name: &&str| self.materials.iter().any(|of| extensions(of).contains_key(*name));
        [EMISSION, IOR, SPECULAR, TRANSMISSION].into_iter().filter(is_used).collect()
    }

    /// Number of a material's first texture.
    fn first_texture(&self, at: usize) -> usize {
        self.materials[..at].iter().map(|before| textures(before).len()).sum()
    }

    /// Materials as JSON, separated by commas.
    pub(super) fn json(&self) -> String {
        let each = self.materials.iter().enumerate().map(|(at, material)| {
            let values = &material.values;
            let metallic = if values.metallic == 0.0 { json!(0) } else { json!(values.metallic) };
            let mut base = json!({ "baseColorFactor": material.factor, "metallicFactor": metallic });
            if values.roughness != 1.0 {
                base["roughnessFactor"] = json!(values.roughness);
            }
            let mut of = json!({});
            let moved = transform_of(material).filter(|_| material.transform != MeshMaterial::IDENTITY);
            for (index, Texture { use_of, .. }) in (self.first_texture(at)..).zip(textures(material)) {
                let mut info = json!({ "index": index });
                if let Some(moved) = moved.as_ref().filter(|_| use_of != Use::Normal) {
                    info["extensions"] = json!({ "KHR_texture_transform": moved });
                }
                let textures = &values.textures;
                match (use_of, &textures.occlusion, &textures.normal) {
                    (Use::Occlusion, Some(occlusion), _) if occlusion.strength != 1.0 => {
                        info["strength"] = json!(occlusion.strength);
                    }
                    (Use::Normal, _, Some(normal)) if normal.scale != 1.0 => {
                        info["scale"] = json!(normal.scale);
                    }
                    _ => {}
                }
                match use_of {
                    Use::Color => base["baseColorTexture"] = info,
                    Use::MetallicRoughness => base["metallicRoughnessTexture"] = info,
                    Use::Normal => of["normalTexture"] = info,
                    Use::Occlusion => of["occlusionTexture"] = info,
                    Use::Emission => of["emissiveTexture"] = info,
                }
            }
            of["pbrMetallicRoughness"] = base;
            if values.emission != [0.0; 3] {
                of["emissiveFactor"] = json!(values.emission);
            }
            let extensions = extensions(material);
            if !extensions.is_empty() {
                of["extensions"] = Value::Object(extensions);
            }
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
        let all = || self.materials.iter().flat_map(textures);
        if all().next().is_none() {
            return String::new();
        }
        let image_of = |texture: &Texture<'_>| {
            let is = |(known, curve, _): &(Arc<Picture>, Curve, _)| {
                Arc::ptr_eq(known, texture.picture) && *curve == texture.curve
            };
            self.pictures.iter().position(is).unwrap_or_default()
        };
        let textures: Vec<Value> = all()
            .enumerate()
            .map(|(at, texture)| json!({ "sampler": at, "source": image_of(&texture) }))
            .collect();
        let code = |wrap: Wrap| match wrap {
            Wrap::Repeat => 10497,
            Wrap::Clamp => 33071,
            Wrap::Mirror => 33648,
        };
        let sampler = |texture: Texture<'_>| {
            let [u, v] = texture.wrap.map(code);
            json!({ "magFilter": 9729, "minFilter": 9987, "wrapS": u, "wrapT": v })
        };
        let samplers: Vec<Value> = all().map(sampler).collect();
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

/// Extensions of materials.
const EMISSION: &str = "KHR_materials_emissive_strength";
const IOR: &str = "KHR_materials_ior";
const SPECULAR: &str = "KHR_materials_specular";
const TRANSMISSION: &str = "KHR_materials_transmission";

/// Returns the extensions that a material needs.
fn extensions(material: &MeshMaterial) -> Map<String, Value> {
    let (values, plain) = (&material.values, MaterialValues::default());
    let mut all = Map::new();
    if values.emission_strength != plain.emission_strength {
        all.insert(EMISSION.to_owned(), json!({ "emissiveStrength": values.emission_strength }));
    }
    if values.ior != plain.ior {
        all.insert(IOR.to_owned(), json!({ "ior": values.ior }));
    }
    if values.specular != plain.specular || values.specular_color != plain.specular_color {
        let of = json!({ "specularFactor": values.specular, "specularColorFactor": values.specular_color });
        all.insert(SPECULAR.to_owned(), of);
    }
    if values.transmission != plain.transmission {
        all.insert(TRANSMISSION.to_owned(), json!({ "transmissionFactor": values.transmission }));
    }
    all
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

/// Encodes a picture as PNG, padded with zeros to a multiple of 4 bytes. Opaque pictures have no alpha
/// channel. By the sRGB curve there are 8 bits a channel; linear pictures have 16 if 8 would change
/// them.
fn encoded(picture: &Picture, curve: Curve) -> Result<Vec<u8>, WriteProblem> {
    let problem = |error: png::EncodingError| WriteProblem::NotStorable(error.to_string());
    let code = |part: f32| (255.0 * part.clamp(0.0, 1.0)).round() as u8;
    let srgb = |part: f32| (255.0 * linear_to_srgb(f64::from(part).clamp(0.0, 1.0))).round() as u8;
    let is_opaque = picture.texels.iter().all(|texel| texel[3] >= 1.0);
    let channels = if is_opaque { 3 } else { 4 };
    let is_changed = |part: &f32| (255.0 * part - (255.0 * part).round()).abs() > LEAST_CHANGE;
    let is_deep = curve == Curve::Linear && picture.texels.iter().flatten().any(is_changed);
    let mut texels = Vec::with_capacity(channels * picture.texels.len());
    for [red, green, blue, opacity] in &picture.texels {
        let colors = [*red, *green, *blue];
        if is_deep {
            let deep = |part: f32| ((65535.0 * part.clamp(0.0, 1.0)).round() as u16).to_be_bytes();
            texels.extend(colors.into_iter().flat_map(deep));
            texels.extend(deep(*opacity).into_iter().filter(|_| !is_opaque));
            continue;
        }
        texels.extend(colors.map(|part| if curve == Curve::Srgb { srgb(part) } else { code(part) }));
        texels.extend((!is_opaque).then(|| code(*opacity)));
    }
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(if is_opaque { ColorType::Rgb } else { ColorType::Rgba });
    encoder.set_depth(if is_deep { BitDepth::Sixteen } else { BitDepth::Eight });
    let mut writer = encoder.write_header().map_err(problem)?;
    writer.write_image_data(&texels).map_err(problem)?;
    writer.finish().map_err(problem)?;
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    Ok(bytes)
}
