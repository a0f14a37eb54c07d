//! Descriptions of materials, as in scene files: values, and the files of material maps.

use super::error::{ValueError, ValueProblem};
use super::keys::numbers;
use super::surface_spec::SurfaceSpec;
use crate::material::{Material, MaterialError, ShadingModel};
use crate::material_maps::{MaterialMap, MaterialMaps};
use glam::Vec3;
use relief_io::{Remark, omissions};
use relief_shaders::{Entry, SHADE, STAGES, Selection};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Description of a material. Missing values come from
/// [`Material::default`](crate::material::Material::default), except that a colour map is
/// multiplied by 0.8 (Blinn-Phong) or 1, and that a map of roughness or metalness is multiplied
/// by 1.
///
/// `diffuse`, `specular` and `shininess` belong to the shading `blinn-phong`, all others to
/// `metallic-roughness`. A material has values of one of them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct MaterialSpec {
    /// Linear diffuse colour, each part from 0 to 1.
    #[serde(deserialize_with = "numbers")]
    pub diffuse: Option<[f32; 3]>,
    /// Linear specular colour, each part from 0 to 1.
    #[serde(deserialize_with = "numbers")]
    pub specular: Option<[f32; 3]>,
    /// Exponent of the highlight, a whole number from 1 to 1024.
    pub shininess: Option<u32>,
    /// Linear base colour, each part from 0 to 1. It multiplies the colour map.
    #[serde(deserialize_with = "numbers")]
    pub base: Option<[f32; 3]>,
    /// Roughness, from 0 to 1. It multiplies the roughness map.
    pub roughness: Option<f32>,
    /// Metalness, from 0 to 1. It multiplies the metalness map.
    pub metallic: Option<f32>,
    /// Light that the surface gives by itself: linear radiance, each part from 0 to 65504. It
    /// multiplies the emission map.
    #[serde(deserialize_with = "numbers")]
    pub emission: Option<[f32; 3]>,
}

impl MaterialSpec {
    /// Names of all values, as in scene files.
    pub const PARTS: [&'static str; 7] =
        ["diffuse", "specular", "shininess", "base", "roughness", "metallic", "emission"];

    /// Returns this description with the values of `over` in place of its own. Values of one shading
    /// drop values of the other.
    #[must_use]
    pub fn overridden_by(self, over: Self) -> Self {
        let own = if over.of_roughness().is_some() {
            Self { diffuse: None, specular: None, shininess: None, ..self }
        } else if over.of_blinn_phong().is_some() {
            Self { base: None, roughness: None, metallic: None, emission: None, ..self }
        } else {
            self
        };
        own.merged(over)
    }

    /// Returns the values of both descriptions; `over` goes first.
    #[must_use]
    pub fn merged(self, over: Self) -> Self {
        Self {
            diffuse: over.diffuse.or(self.diffuse),
            specular: over.specular.or(self.specular),
            shininess: over.shininess.or(self.shininess),
            base: over.base.or(self.base),
            roughness: over.roughness.or(self.roughness),
            metallic: over.metallic.or(self.metallic),
            emission: over.emission.or(self.emission),
        }
    }

    /// Returns the first given value of the shading `blinn-phong`.
    fn of_blinn_phong(&self) -> Option<&'static str> {
        let given = [self.diffuse.is_some(), self.specular.is_some(), self.shininess.is_some()];
        given.into_iter().zip(Self::PARTS).find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// Returns the first given value of the shading `metallic-roughness`.
    fn of_roughness(&self) -> Option<&'static str> {
        let given =
            [self.base.is_some(), self.roughness.is_some(), self.metallic.is_some(), self.emission.is_some()];
        given.into_iter().zip(&Self::PARTS[3..]).find_map(|(is_given, name)| is_given.then_some(*name))
    }
}

/// Returns the name of the shading that reads roughness and metalness.
pub(super) fn metallic_roughness() -> &'static str {
    STAGES[SHADE].first(Entry::reads_materials).map_or("", |(_, entry)| entry.name)
}

/// Returns whether a selection's shading reads roughness and metalness.
pub(super) fn reads_materials(selection: &Selection) -> bool {
    selection.choices[SHADE].entry.reads_materials()
}

impl SurfaceSpec {
    /// Returns the files of the material maps, by key, in the order of [`MaterialMap::ALL`].
    pub(super) fn material_files(&self) -> [(&'static str, &Option<PathBuf>); MaterialMap::ALL.len()] {
        [
            ("orm", &self.orm),
            ("mask-map", &self.mask_map),
            ("metallic-smoothness", &self.metallic_smoothness),
            ("occlusion", &self.occlusion),
            ("roughness", &self.roughness),
            ("glossiness", &self.glossiness),
            ("metallic", &self.metallic),
            ("emission", &self.emission),
        ]
    }

    /// Returns the key of the first material map.
    fn material_map(&self) -> Option<&'static str> {
        self.material_files().into_iter().find_map(|(key, file)| file.as_ref().map(|_| key))
    }

    /// Returns remarks on given values that change nothing, as their map is 0 everywhere, and the first
    /// file of the maps.
    pub(super) fn remarks_on_factors(&self, maps: &MaterialMaps) -> (&Path, Vec<Remark>) {
        let spec = self.material.clone().unwrap_or_default();
        let factors = [("roughness", spec.roughness, 1), ("metallic", spec.metallic, 2)];
        let idle = factors.into_iter().filter_map(|(name, factor, part)| {
            let value = factor.filter(|factor| *factor > 0.0)?;
            let is_zero = maps.texels().iter().all(|texel| texel[part] == 0.0);
            let what = "changes nothing: it multiplies a map that is 0 everywhere";
            is_zero.then(|| Remark::new(&omissions::IDLE_FACTOR, format!("{name} {value} {what}")))
        });
        let path = self.material_files().into_iter().find_map(|(_, file)| file.as_deref());
        (path.unwrap_or(Path::new("")), idle.collect())
    }

    /// Returns the shading model that the values of the material and its maps ask for. `None` if
    /// both suit.
    ///
    /// # Errors
    ///
    /// When values of both models are given, or values of another than the named shading.
    pub(super) fn shading_model(&self) -> Result<Option<ShadingModel>, ValueError> {
        let spec = self.material.clone().unwrap_or_default();
        let plain = spec.of_blinn_phong();
        let of_map = self.material_map();
        let rough = spec.of_roughness().or(of_map);
        let named = self.stages.get(STAGES[SHADE].key).map(String::as_str);
        let is_rough = named.map(|name| name == metallic_roughness());
        match (plain, rough) {
            (Some(plain), Some(rough)) => {
                Err(ValueProblem::MixedMaterial { plain, rough }.of(of_map.unwrap_or("material")))
            }
            (Some(plain), None) if is_rough == Some(true) => {
                Err(ValueProblem::NotOfShading { part: plain, shading: metallic_roughness() }.of("material"))
            }
            (None, Some(part)) if is_rough == Some(false) => {
                let shading = STAGES[SHADE].entries[0].name;
                Err(ValueProblem::NotOfShading { part, shading }.of(of_map.unwrap_or("material")))
            }
            (Some(_), None) => Ok(Some(ShadingModel::BlinnPhong)),
            (None, Some(_)) => Ok(Some(ShadingModel::MetallicRoughness)),
            (None, None) => Ok(None),
        }
    }

    /// Returns the material for a selection. `color` is the default of its colour.
    pub(super) fn material_of(
        &self,
        color: Option<Vec3>,
        selection: &Selection,
    ) -> Result<Material, ValueError> {
        let spec = self.material.clone().unwrap_or_default();
        let has_color_map = self.color.is_some() || self.ramp.is_some();
        let plain = if has_color_map { Material::under_colours() } else { Material::default() };
        let material = if reads_materials(selection) {
            let own = if has_color_map { Vec3::ONE } else { plain.diffuse() };
            let packed = [&self.orm, &self.mask_map, &self.metallic_smoothness];
            let with = |files: &[&Option<PathBuf>], default| {
                if files.iter().chain(&packed).any(|file| file.is_some()) { 1.0 } else { default }
            };
            Material::metallic_roughness(
                spec.base.map(Vec3::from).or(color).unwrap_or(own),
                spec.metallic.unwrap_or(with(&[&self.metallic], plain.metallic())),
                spec.roughness.unwrap_or(with(&[&self.roughness, &self.glossiness], plain.roughness())),
            )
        } else {
            Material::new(
                spec.diffuse.map(Vec3::from).or(color).unwrap_or(plain.diffuse()),
                spec.specular.map_or(plain.specular(), Vec3::from),
                spec.shininess.unwrap_or(plain.shininess()),
            )
        };
        let emission = spec.emission.map(Vec3::from);
        let emission = emission.unwrap_or(if self.emission.is_some() { Vec3::ONE } else { Vec3::ZERO });
        let material = material.and_then(|material| material.with_emission(emission));
        let material = material.map_err(|error| ValueProblem::from(error).of("material"))?;
        let material = if self.shading_model()?.is_none() { material.for_any_model() } else { material };
        let transmission = self.transmission.unwrap_or(plain.transmission());
        material.with_transmission(transmission, self.ior.unwrap_or(plain.ior())).map_err(|error| {
            let key = if matches!(error, MaterialError::BadIor(_)) { "ior" } else { "transmission" };
            ValueProblem::from(error).of(key)
        })
    }
}
