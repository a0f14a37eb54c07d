//! Surfaces whose maps are found in a folder, by their names.

use std::path::{Path, PathBuf};

use relief_io::{Files, FoundTexture, ReadNote, Remark, TextureRole, TextureSet, find_textures, omissions};
use relief_shaders::{SHADE, STAGES};

use super::material_spec::metallic_roughness;
use super::{SceneError, SceneSpec, SurfaceSpec};
use crate::material::ShadingModel;

impl SceneSpec {
    /// Returns the description with the files of its texture sets as maps of its surfaces, and a note
    /// on every set. Maps that are given go before a set's.
    ///
    /// # Errors
    ///
    /// When a folder cannot be read, its names are unclear, or a surface would have no height map.
    pub(super) fn with_texture_sets(&self, files: &Files) -> Result<(Self, Vec<ReadNote>), SceneError> {
        let mut notes = Vec::new();
        let mut spec = self.clone();
        if spec.surfaces.is_empty() {
            spec.surface = spec.surface.with_texture_set(files, &mut notes)?;
            return Ok((spec, notes));
        }
        // Surfaces have the common keys, and so the common set, unless they have one of their own.
        let each = self.each_surface().into_iter();
        let found =
            each.map(|surface| surface.with_texture_set(files, &mut notes)).collect::<Result<Vec<_>, _>>()?;
        for (own, found) in spec.surfaces.iter_mut().zip(found) {
            if found.textures.is_some() {
                *own = found;
            }
        }
        spec.surface.textures = None;
        notes.dedup();
        Ok((spec, notes))
    }
}

impl SurfaceSpec {
    /// Returns the description with the files of its texture set as maps.
    fn with_texture_set(&self, files: &Files, notes: &mut Vec<ReadNote>) -> Result<Self, SceneError> {
        let mut spec = self.clone();
        let dropped = spec.drop_maps();
        let Some(folder) = &self.textures else { return Ok(spec) };
        let set = find_textures(files.source(folder), self.udim)?;
        let mut taken = Vec::new();
        let mut left = Vec::new();
        // Blinn-Phong reads no map of a material.
        let is_plain = spec.stages.get(STAGES[SHADE].key).is_some_and(|name| name != metallic_roughness())
            || spec.shading_model()? == Some(ShadingModel::BlinnPhong);
        if spec.height.is_none() && !spec.is_mesh_alone() {
            set.height()?;
        }
        for texture in &set.textures {
            let of_relief =
                [TextureRole::Color, TextureRole::Height, TextureRole::Depth, TextureRole::Normal];
            let Some(key) = key_of(texture.role) else {
                left.push((texture, "is not read"));
                continue;
            };
            if is_plain && !of_relief.contains(&texture.role) {
                left.push((texture, "is not read by the shading"));
            } else if texture.role == TextureRole::Color && spec.ramp.is_some() {
                left.push((texture, "is replaced by colours by height"));
            } else if dropped.contains(&texture.role) {
                left.push((texture, "is dropped"));
            } else if key(&mut spec).is_some() {
                left.push((texture, "is replaced by a given map"));
            } else {
                *key(&mut spec) = Some(texture.path.clone());
                taken.push(texture);
                match texture.role {
                    TextureRole::Normal => spec.green = spec.green.or(texture.green),
                    TextureRole::Depth => spec.depth = spec.depth.or(Some(true)),
                    _ => {}
                }
            }
        }
        notes.push(Remark::new(&omissions::TEXTURE_SET, said(&set, &taken, &mut spec)).of(folder));
        notes.extend(
            said_left(&set, &left).map(|text| Remark::new(&omissions::LEFT_TEXTURES, text).of(folder)),
        );
        Ok(spec)
    }
}

impl SurfaceSpec {
    /// Removes the maps that are given as [`NO_MAP`], and returns their roles.
    pub(super) fn drop_maps(&mut self) -> Vec<TextureRole> {
        let is_dropped = |role: &TextureRole| {
            key_of(*role).is_some_and(|key| key(self).take_if(|file| is_no_map(file)).is_some())
        };
        DROPPED.into_iter().filter(is_dropped).collect()
    }
}

/// Name in place of a map's file: the surface has no such map, even if a folder of textures has one.
pub const NO_MAP: &str = "none";

/// Returns whether a map's file stands for no map.
pub(super) fn is_no_map(file: &Path) -> bool {
    file == Path::new(NO_MAP)
}

/// Roles of maps that can be dropped: all but heights, which a surface needs.
const DROPPED: [TextureRole; 10] = [
    TextureRole::Color,
    TextureRole::Normal,
    TextureRole::Roughness,
    TextureRole::Glossiness,
    TextureRole::Metallic,
    TextureRole::Occlusion,
    TextureRole::Emission,
    TextureRole::Orm,
    TextureRole::MetallicSmoothness,
    TextureRole::MaskMap,
];

/// A key of a surface that names a file.
type FileKey = fn(&mut SurfaceSpec) -> &mut Option<PathBuf>;

impl SurfaceSpec {
    /// Returns the key's value for textures of a role; none if no key takes them.
    pub fn map_of(&mut self, role: TextureRole) -> Option<&mut Option<PathBuf>> {
        key_of(role).map(|key| key(self))
    }

    /// Removes all maps but the heights: they belong to other heights.
    pub fn forget_maps(&mut self) {
        for key in DROPPED.into_iter().filter_map(key_of) {
            *key(self) = None;
        }
        (self.textures, self.green) = (None, None);
    }
}

/// Returns the key for textures of a role.
fn key_of(role: TextureRole) -> Option<FileKey> {
    let key: FileKey = match role {
        TextureRole::Color => |spec| &mut spec.color,
        TextureRole::Height | TextureRole::Depth => |spec| &mut spec.height,
        TextureRole::Normal => |spec| &mut spec.normal,
        TextureRole::Roughness => |spec| &mut spec.roughness,
        TextureRole::Glossiness => |spec| &mut spec.glossiness,
        TextureRole::Metallic => |spec| &mut spec.metallic,
        TextureRole::Occlusion => |spec| &mut spec.occlusion,
        TextureRole::Emission => |spec| &mut spec.emission,
        TextureRole::Orm => |spec| &mut spec.orm,
        TextureRole::MetallicSmoothness => |spec| &mut spec.metallic_smoothness,
        TextureRole::MaskMap => |spec| &mut spec.mask_map,
        TextureRole::Opacity | TextureRole::Specular => return None,
    };
    Some(key)
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Returns what was taken from a set, as a sentence.
fn said(set: &TextureSet, taken: &[&FoundTexture], spec: &mut SurfaceSpec) -> String {
    let from = |texture: &&FoundTexture| {
        format!("{} from {}", given_by(texture.role, spec), file_name(&texture.path))
    };
    let each: Vec<String> = taken.iter().map(from).collect();
    let what = if each.is_empty() { "nothing".to_owned() } else { each.join(", ") };
    format!("the textures {}: {what}", set.name)
}

/// Returns what a texture gives, in words: of a packed one, the channels that no map of its own
/// replaces.
fn given_by(role: TextureRole, spec: &mut SurfaceSpec) -> String {
    let channels = role.channels();
    let mut is_replaced = |channel: TextureRole| {
        let same = match channel {
            TextureRole::Roughness | TextureRole::Glossiness => {
                [TextureRole::Roughness, TextureRole::Glossiness]
            }
            other => [other; 2],
        };
        same.into_iter().filter_map(key_of).any(|key| key(spec).is_some())
    };
    let kept = channels.iter().map(|(_, channel)| *channel).filter(|channel| !is_replaced(*channel));
    let kept: Vec<&str> = kept.map(TextureRole::name).collect();
    match kept.len() {
        count if count == channels.len() => role.to_string(),
        0 => "nothing (other maps replace its channels)".to_owned(),
        _ => kept.join(" and "),
    }
}

/// Returns what was left of a set, as a sentence. `None` if nothing was.
fn said_left(set: &TextureSet, left: &[(&FoundTexture, &str)]) -> Option<String> {
    let of_scene =
        left.iter().map(|(texture, why)| format!("{} ({} {why})", file_name(&texture.path), texture.role));
    let of_set = set.left.iter().map(|(path, why)| format!("{} ({why})", file_name(path)));
    let each: Vec<String> = of_scene.chain(of_set).collect();
    (!each.is_empty()).then(|| format!("left out of the textures {}: {}", set.name, each.join(", ")))
}
