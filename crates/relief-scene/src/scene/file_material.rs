//! Materials of a mesh's file as a surface shows them: their values and pictures, under the keys of
//! the surface.

use std::sync::Arc;

use glam::Vec3;
use relief_core::Wrap;
use relief_io::{MaterialTextures, MaterialValues, NormalTexture, Omission, Picture, Remark, omissions};
use relief_shaders::Selection;

use super::error::{SceneError, ValueError};
use super::maps::Maps;
use super::material_spec::reads_materials;
use super::surface_colors::DrawnMaterial;
use super::{ColorPlace, SurfaceSpec};
use crate::material::{MAX_EMISSION, MAX_IOR, Material};
use crate::material_maps::{MaterialMap, MaterialMaps, MaterialPictures};

/// Values of a material, with the maps and the normals that are shown of it.
type KnownMaps = (Arc<MaterialValues>, Option<Arc<MaterialMaps>>, Option<Arc<Picture>>);

/// Combines the materials of a mesh's file with the keys of a surface.
pub(super) struct FileMaterials<'a> {
    spec: &'a SurfaceSpec,
    selection: &'a Selection,
    /// Maps that were made, by the values of their material.
    known: Vec<KnownMaps>,
    remarks: Vec<Remark>,
}

impl<'a> FileMaterials<'a> {
    pub fn new(spec: &'a SurfaceSpec, selection: &'a Selection) -> Self {
        Self { spec, selection, known: Vec::new(), remarks: Vec::new() }
    }

    /// Returns notes on parts of the materials that are not shown, each once.
    pub fn into_remarks(self) -> Vec<Remark> {
        self.remarks
    }

    fn note(&mut self, what: impl Into<String>) {
        self.note_as(&omissions::UNSHOWN_MATERIAL, what);
    }

    fn note_as(&mut self, row: &'static Omission, what: impl Into<String>) {
        let remark = Remark::new(row, what);
        if !self.remarks.contains(&remark) {
            self.remarks.push(remark);
        }
    }

    /// Returns the material that is shown for one of the file's: the keys of the surface go first.
    pub fn material(&mut self, drawn: &DrawnMaterial) -> Result<Material, ValueError> {
        let color = (!self.spec.has_own_color()).then_some(drawn.diffuse);
        if !reads_materials(self.selection) {
            if drawn.values.light() != [0.0; 3] || drawn.values.textures.has_maps() {
                let what = "its metalness, roughness, occlusion and emission are not shown by the shading";
                self.note_as(&omissions::OTHER_PICTURES, what);
            }
            return self.spec.material_of(color, self.selection);
        }
        let values = &drawn.values;
        let own = self.spec.material.clone().unwrap_or_default();
        let has = |kinds: &[MaterialMap]| self.spec.gives(kinds);
        let has_roughness = has(&[
            MaterialMap::Packed,
            MaterialMap::Mask,
            MaterialMap::MetallicSmoothness,
            MaterialMap::Roughness,
            MaterialMap::Glossiness,
        ]);
        let has_metalness = has(&[
            MaterialMap::Packed,
            MaterialMap::Mask,
            MaterialMap::MetallicSmoothness,
            MaterialMap::Metallic,
        ]);
        // A map of the surface goes with a factor of the surface, which is 1 by default.
        let roughness = own.roughness.or((!has_roughness).then_some(values.roughness));
        let metallic = own.metallic.or((!has_metalness).then_some(values.metallic));
        let emission = own.emission.or_else(|| (!has(&[MaterialMap::Emission])).then(|| self.light(values)));
        let transmission = self.spec.transmission.unwrap_or(self.transmission(values));
        let ior = self.spec.ior.unwrap_or_else(|| self.ior(values, transmission));
        let material = super::MaterialSpec { roughness, metallic, emission, ..own };
        let spec = SurfaceSpec {
            material: Some(material),
            transmission: Some(transmission),
            ior: Some(ior),
            ..self.spec.clone()
        };
        spec.material_of(color, self.selection)
    }

    /// Light of a material, as far as pictures hold it.
    fn light(&mut self, values: &MaterialValues) -> [f32; 3] {
        let light = values.light();
        if light.iter().any(|part| *part > MAX_EMISSION) {
            self.note(format!("its emission is shown as {MAX_EMISSION}, the greatest of pictures"));
        }
        light.map(|part| part.min(MAX_EMISSION))
    }

    /// Transmission of a material, if the light from all around is known.
    fn transmission(&mut self, values: &MaterialValues) -> f32 {
        if values.transmission == 0.0 || self.selection.sees_environment() {
            return values.transmission;
        }
        if self.spec.transmission.is_none() {
            self.note(format!(
                "its transmission {} is not shown: refracted light needs an environment map",
                values.transmission
            ));
        }
        0.0
    }

    /// Index of refraction by which a material reflects as its values say along the normal.
    fn ior(&mut self, values: &MaterialValues, transmission: f32) -> f32 {
        let greatest = Vec3::from(values.specular_color).max_element();
        let is_plain = values.specular == 1.0 && values.specular_color == [1.0; 3];
        if !is_plain && transmission > 0.0 {
            self.note("its specular factor and colour are not shown, as light is refracted");
        }
        let has_color = values.specular_color.iter().any(|part| *part != greatest);
        if has_color {
            self.note("the specular colour of its reflection is shown as grey");
        }
        if values.specular != 1.0 {
            self.note("its specular factor is shown along the normal only, not at grazing angles");
        }
        let ior = if is_plain || transmission > 0.0 {
            // 0 stands for a surface that reflects all light.
            if values.ior == 0.0 { f32::INFINITY } else { values.ior }
        } else {
            let plain = if values.ior == 0.0 { 1.0 } else { (values.ior - 1.0) / (values.ior + 1.0) };
            let part = (plain * plain * greatest).min(1.0) * values.specular;
            (1.0 + part.sqrt()) / (1.0 - part.sqrt())
        };
        if ior > MAX_IOR {
            self.note(format!("it reflects as an index of refraction of {MAX_IOR} does, the greatest"));
        }
        ior.clamp(1.0, MAX_IOR)
    }

    /// Completes one of the file's materials with what is shown of its values and pictures.
    pub fn complete(&mut self, drawn: &mut DrawnMaterial, maps: &mut Maps<'_>) -> Result<(), SceneError> {
        drawn.material = Some(self.material(drawn)?);
        if let Some((_, of_maps, normals)) =
            self.known.iter().find(|(values, ..)| Arc::ptr_eq(values, &drawn.values))
        {
            (drawn.maps, drawn.normals) = (of_maps.clone(), normals.clone());
            return Ok(());
        }
        let textures = &drawn.values.textures;
        let is_placed = drawn.place.rows == ColorPlace::default().rows;
        let of_file = textures.has_maps() && reads_materials(self.selection);
        if of_file && (self.spec.color.is_some() || self.spec.ramp.is_some()) && !is_placed {
            let what = "its pictures of roughness, metalness, occlusion and emission are left out";
            self.note(format!("{what}: they lie otherwise than the given colours"));
        } else if of_file {
            let wrap = drawn.place.wrap.map_or(Wrap::Repeat, |[along_u, _]| along_u);
            drawn.maps = maps.material(self.spec, wrap, Some(textures))?;
        }
        if let Some(normal) = &textures.normal
            && self.spec.normal.is_none()
        {
            if self.spec.height.is_some() {
                self.note("its picture of normals is not shown: the height map gives the normals");
            } else {
                maps.take_normals([normal.picture.width, normal.picture.height]);
                drawn.normals = Some(normals_of(normal));
            }
        }
        self.known.push((Arc::clone(&drawn.values), drawn.maps.clone(), drawn.normals.clone()));
        Ok(())
    }
}

/// Returns the normals of a picture as the shaders take them: four numbers a texel.
fn normals_of(normal: &NormalTexture) -> Arc<Picture> {
    let Picture { width, height, .. } = *normal.picture;
    let texels = normal.normals().into_iter().map(|[x, y, z]| [x, y, z, 0.0]).collect();
    Arc::new(Picture { width, height, texels })
}

/// Adds the pictures of a file's material to the given ones, which go first.
pub(super) fn add_pictures(pictures: &mut MaterialPictures, textures: &MaterialTextures) {
    let has = |kinds: &[MaterialMap], pictures: &MaterialPictures| {
        kinds.iter().any(|kind| pictures[*kind as usize].is_some())
    };
    let packed = [MaterialMap::Packed, MaterialMap::Mask, MaterialMap::MetallicSmoothness];
    let occludes = has(&[MaterialMap::Packed, MaterialMap::Mask, MaterialMap::Occlusion], pictures);
    if let Some(of) = &textures.metallic_roughness
        && !has(&packed, pictures)
    {
        let texels = of.texels.iter().map(|&[_, green, blue, _]| [1.0, green, blue, 1.0]).collect();
        pictures[MaterialMap::Packed as usize] = Some(Picture { width: of.width, height: of.height, texels });
    }
    if let Some(of) = &textures.occlusion
        && !occludes
    {
        let lit = |texel: &[f32; 4]| [1.0 + of.strength * (texel[0] - 1.0); 4];
        let Picture { width, height, .. } = *of.picture;
        let texels = of.picture.texels.iter().map(lit).collect();
        pictures[MaterialMap::Occlusion as usize] = Some(Picture { width, height, texels });
    }
    if let Some(of) = &textures.emission
        && !has(&[MaterialMap::Emission], pictures)
    {
        pictures[MaterialMap::Emission as usize] = Some(Picture::clone(of));
    }
}

impl SurfaceSpec {
    /// Whether the surface has a colour of its own, which goes before the file's.
    pub(super) fn has_own_color(&self) -> bool {
        let has_picture = self.color.is_some() || self.ramp.is_some();
        has_picture || self.material.as_ref().is_some_and(|own| own.diffuse.or(own.base).is_some())
    }

    /// Whether a map of one of these kinds is given.
    fn gives(&self, kinds: &[MaterialMap]) -> bool {
        let files = self.material_files();
        kinds.iter().any(|kind| files[*kind as usize].1.is_some())
    }
}
