//! Descriptions of surfaces, as in scene files. Missing values have defaults.

use super::keys::{base, length, lengths, numbers, parsed, range};
use super::settings::settings;
use super::texture_set::is_no_map;
use super::{BaseThickness, MaterialSpec, MeshChoice, RampChoice};
use crate::motif::VectorAxes;
use relief_core::Wrap;
use relief_core::mesh::UvProjection;
use relief_io::{GivenUnits, GreenSign, HeightRange, RawLayout, Up};
use relief_shaders::{
    AMBIENT, DETAIL, Entry, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES,
};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Description of a surface, from a scene file or a program. A value that is `None` has a default.
///
/// The keys of a scene file are the fields' names with `-` for `_`. Each stage has a key, too,
/// whose value is the name of a variant.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SurfaceSpec {
    /// File of the height map. Required, unless `volume`, `motif`, `object` or the file of a mesh is given.
    pub height: Option<PathBuf>,
    /// File of a volume, in place of a height map: grass, mail or cloth on the mesh. Scale, bias, tile and
    /// wrap mean the same as for heights.
    pub volume: Option<PathBuf>,
    /// File of a motif, in place of a height map: a closed mesh in the space of a tile, which repeats on the
    /// mesh. `x` and `z` are `u` and `v`, `y` is the height, all from 0 to 1. Or a vector displacement map.
    pub motif: Option<PathBuf>,
    /// What the channels of a vector displacement map are that is given as `motif`. Default: `tnb`, tangent,
    /// normal and bitangent.
    #[serde(deserialize_with = "parsed")]
    pub axes: Option<VectorAxes>,
    /// Folder of textures: the maps of a material, recognised by their names (see
    /// [`find_textures`](relief_io::find_textures)). Maps that are given go before them. A map of
    /// colour, normals or material that is given as [`NO_MAP`](crate::NO_MAP), `none`, is dropped.
    pub textures: Option<PathBuf>,
    /// Number of the UDIM tile whose textures are taken, from 1001 on. Needed if the folder has several.
    pub udim: Option<u32>,
    /// File of a depth object, in place of height map and mesh. Such a surface also takes a
    /// placement, a method, settings and a material.
    pub object: Option<PathBuf>,
    /// Channel of the height map's file. Default: the only channel, or grey.
    pub channel: Option<String>,
    /// Whether the file holds depth, with white deepest. Default: `false`, white is highest.
    pub depth: Option<bool>,
    /// Values of the file that become heights 0 and 1: two numbers, or `auto` for the least and the
    /// greatest value.
    ///
    /// Default: 0 and the type's maximum for integers, `auto` for floats and elevation models.
    #[serde(deserialize_with = "range")]
    pub range: Option<HeightRange>,
    /// Elevations in metres that heights 0 and 1 stand for, the second above the first. They replace
    /// the file's own. Default: the file's, if it states metres.
    #[serde(deserialize_with = "lengths")]
    pub elevation: Option<[f64; 2]>,
    /// Stored value that marks texels without a value, in addition to the value that the file
    /// declares. Default: only the declared one.
    pub nodata: Option<f64>,
    /// Unit of the heights, as in `"cm"`, or units of the heights and of the ground, as in
    /// `"cm,ft"`. Default: the units that the file states.
    #[serde(deserialize_with = "parsed")]
    pub unit: Option<GivenUnits>,
    /// Size and byte order of a headerless file, as in `"403x344,le"`.
    #[serde(deserialize_with = "parsed")]
    pub raw: Option<RawLayout>,
    /// Whether texels without a value are filled from neighbouring texels.
    /// [`HeightMap::filled_texels`](relief_core::HeightMap::filled_texels) counts them.
    ///
    /// Default: `true` for elevation models, with `nodata`, and with `holes`. In other files such a
    /// texel is an error.
    pub fill: Option<bool>,
    /// Whether texels without a value are holes: rays pass dual cells with such a texel, and the
    /// picture shows what is behind. Default: `false`.
    ///
    /// With holes, such texels are filled in files of all kinds unless `fill` is `false`. Shadows,
    /// ambient light and baked maps use the filled heights.
    pub holes: Option<bool>,
    /// Wrap of the maps beyond their edges: `repeat`, `clamp` or `mirror`. Default: `clamp` for
    /// elevation models, otherwise `repeat`.
    #[serde(deserialize_with = "parsed")]
    pub wrap: Option<Wrap>,
    /// Displacement in metres between heights 0 and 1.
    ///
    /// Default: 0.05, unless the file states metres. Then it is in proportion to the mesh's tile.
    /// If that is deeper than any ground, it is a quarter of the tile's shorter side.
    #[serde(deserialize_with = "length")]
    pub scale: Option<f64>,
    /// Displacement of height 0 in metres. Default: minus the scale, so that the relief is carved
    /// into the surface.
    #[serde(deserialize_with = "length")]
    pub bias: Option<f64>,
    /// Factor on the scale, given or not, and on a bias that is not given. From 1e-6 to 1e6.
    /// Default: 1.
    pub exaggerate: Option<f64>,
    /// Optical depth of a metre of way in a translucent volume, where the volume is 1, from 0 on: after a way
    /// of `1 / extinction` a share of `1 / e` of the light is left.
    ///
    /// Default: 8 over the scale, unless the method's setting is given. Needs the method `translucent`.
    pub extinction: Option<f64>,
    /// Whether normals that are derived from the heights end at creases, where the slope changes
    /// abruptly. Default: `false`, normals are smooth across creases.
    pub creases: Option<bool>,
    /// File of the colour map. Default: none.
    pub color: Option<PathBuf>,
    /// Colours by height, in place of a colour map: `terrain`, `viridis`, `grey`, or a file for
    /// [`read_color_table`](relief_io::read_color_table). Default: none.
    #[serde(deserialize_with = "parsed")]
    pub ramp: Option<RampChoice>,
    /// File of the tangent-space normal map. Default: none.
    pub normal: Option<PathBuf>,
    /// Direction of the normal map's green: `+y` (default) up in the picture, `-y` down.
    #[serde(deserialize_with = "parsed")]
    pub green: Option<GreenSign>,
    /// File of the roughness map, in its first channel: 0 is smooth, 1 rough. Default: none.
    ///
    /// This and the maps that follow need the shading `metallic-roughness`. They hold plain
    /// numbers, not colours, and have the colour map's coordinates and wrap.
    pub roughness: Option<PathBuf>,
    /// File of the metalness map, in its first channel: 1 is metal. Default: none.
    pub metallic: Option<PathBuf>,
    /// File of the occlusion map, in its first channel: the part of the light from all around that
    /// arrives. Default: none.
    pub occlusion: Option<PathBuf>,
    /// File of occlusion, roughness and metalness in red, green and blue. Engines call it ORM or
    /// ARM. A map of its own replaces a channel. Default: none.
    pub orm: Option<PathBuf>,
    /// File of the mask map of Unity's HDRP: metalness in red, occlusion in green, smoothness in
    /// opacity. Default: none.
    pub mask_map: Option<PathBuf>,
    /// File of metalness in red and smoothness in opacity, as in Unity's standard material.
    /// Default: none.
    pub metallic_smoothness: Option<PathBuf>,
    /// File of the glossiness or smoothness map, in its first channel: 1 less the roughness. Default:
    /// none.
    pub glossiness: Option<PathBuf>,
    /// File of the emission map, a picture in sRGB: the light that the surface gives by itself.
    /// Default: none.
    pub emission: Option<PathBuf>,
    /// Size of a tile in metres along `u` and `v`. Default: as the height map's file states,
    /// otherwise such that texels are square.
    #[serde(deserialize_with = "lengths")]
    pub tile_size: Option<[f64; 2]>,
    /// Base mesh: `plane` (default), `square`, `cube`, `cylinder`, `sphere`, `torus`, or a file for
    /// [`read_mesh`](relief_io::read_mesh). The plane has the height map's proportions.
    #[serde(deserialize_with = "parsed")]
    pub mesh: Option<MeshChoice>,
    /// Whether walls and a bottom close the relief of a plane to a block. Default: `false`.
    ///
    /// The surface is then `prism` unless another one is named, and the wrap is `clamp` unless the
    /// plane has several tiles. The walls follow the described surfaces in
    /// [`Scene::surfaces`](super::Scene::surfaces).
    pub walls: Option<bool>,
    /// Thickness of the block below the lowest texel: a length, or a part of the plane's shorter side
    /// such as `"5%"`. Needs `walls`. Default: 5 %.
    #[serde(deserialize_with = "base")]
    pub base: Option<BaseThickness>,
    /// Projection that replaces the texture coordinates of a mesh file: `box`, `cylinder` or
    /// `sphere`. Default: the file's coordinates.
    #[serde(deserialize_with = "parsed")]
    pub project: Option<UvProjection>,
    /// Axis of the mesh's file that points up: `y` or `z`. Default: as stated by a file of Relief,
    /// otherwise `z` in STL and `y` in other formats.
    #[serde(deserialize_with = "parsed")]
    pub mesh_up: Option<Up>,
    /// Number of tiles along `u` and `v`, from 1e-6 to 1e6. Default: 1 and 1.
    #[serde(deserialize_with = "numbers")]
    pub tile: Option<[f32; 2]>,
    /// Position of the mesh's origin in metres. Default: the world's origin.
    #[serde(deserialize_with = "lengths")]
    pub position: Option<[f64; 3]>,
    /// Rotation in degrees about `x`, then `y`, then `z`. Default: 0 each.
    #[serde(deserialize_with = "numbers")]
    pub rotation: Option<[f64; 3]>,
    /// Factor on the size of the mesh and its tiles, from 1e-6 to 1e6. The relief's depth in metres
    /// does not change. Default: 1.
    ///
    /// In `[[surfaces]]` its older name `size` is read, too. The scene's own `size` is the
    /// picture's.
    #[serde(alias = "size")]
    pub mesh_scale: Option<f64>,
    /// Name of the method. Default: `exact`; `depth-object` for objects, `bump` for a mesh without
    /// a height map.
    pub method: Option<String>,
    /// Names of variants by the keys of their stages. `search` and `refine` come together, in place
    /// of `method`. `geometry` is in place of `method`, too.
    #[serde(skip)]
    pub stages: BTreeMap<String, String>,
    /// Settings of the chosen variants, by names such as `search.steps`.
    #[serde(deserialize_with = "settings")]
    pub set: BTreeMap<String, f64>,
    /// Material. Default: grey.
    pub material: Option<MaterialSpec>,
    /// Part of the light that is refracted instead of scattered, from 0 to 1. Default: 0. If it is
    /// more, the default ambient variant is `environment`.
    pub transmission: Option<f32>,
    /// Index of refraction, from 1 to 4. Default: 1.5.
    pub ior: Option<f32>,
    /// Whether triangles seen from behind are drawn. Default: `false`.
    pub two_sided: Option<bool>,
}

/// Returns the name of the ambient variant that reads the environment map.
pub(super) fn environment() -> &'static str {
    STAGES[AMBIENT].first(Entry::sees_surroundings).map_or("", |(_, entry)| entry.name)
}

/// Key of the stage `detail`, which objects do not have: their images have one level.
const DETAIL_KEY: &str = STAGES[DETAIL].key;

/// Returns whether `key` is the key of a stage that a method sets.
fn is_of_method(key: &str) -> bool {
    [GEOMETRY, SLICES, OBJECT, SEARCH, REFINE].iter().any(|stage| STAGES[*stage].key == key)
}

impl SurfaceSpec {
    /// Returns this description with the values of `over` in place of its own.
    ///
    /// Values that belong to a replaced value are dropped:
    ///
    /// * `height`, `volume` and `motif` replace each other. Another one drops `channel`, `depth`, `range`,
    ///   `elevation`, `nodata`, `unit`, `raw`, `fill` and `axes`.
    /// * `color` and `ramp` replace each other.
    /// * Another `normal` drops `green`; another `mesh` drops `project` and `mesh-up`.
    /// * Another method or stage drops its settings; another shadow drops its search; another method drops
    ///   `extinction`.
    /// * Another ambient variant than `environment` drops `transmission` and `ior`; `transmission` drops
    ///   another ambient variant.
    /// * `scale` without `bias` drops the old bias.
    #[must_use]
    pub fn overridden_by(mut self, over: SurfaceSpec) -> SurfaceSpec {
        let has_relief = over.height.is_some() || over.volume.is_some() || over.motif.is_some();
        if has_relief {
            (self.channel, self.depth, self.raw, self.fill) = (None, None, None, None);
            (self.range, self.nodata, self.unit) = (None, None, None);
            self.elevation = None;
            (self.height, self.volume, self.motif, self.axes) = (None, None, None, None);
        }
        if over.object.is_some() {
            self.forget_relief();
        } else if has_relief || over.mesh.is_some() {
            self.object = None;
        }
        if over.normal.is_some() {
            self.green = None;
        }
        if over.color.is_some() || over.ramp.is_some() {
            (self.color, self.ramp) = (None, None);
        }
        if over.mesh.is_some() {
            (self.project, self.mesh_up) = (None, None);
        }
        if over.scale.is_some() {
            self.bias = None;
        }
        if over.method.is_some() && over.method != self.method {
            self.extinction = None;
        }
        self.drop_replaced_stages(&over);
        if over.names_other_ambient() {
            (self.transmission, self.ior) = (None, None);
        } else if over.asks_for_environment() {
            self.forget_ambient();
        }
        let (mut stages, mut set) = (self.stages, self.set);
        stages.extend(over.stages);
        set.extend(over.set);
        SurfaceSpec {
            height: over.height.or(self.height),
            volume: over.volume.or(self.volume),
            motif: over.motif.or(self.motif),
            axes: over.axes.or(self.axes),
            object: over.object.or(self.object),
            channel: over.channel.or(self.channel),
            depth: over.depth.or(self.depth),
            range: over.range.or(self.range),
            elevation: over.elevation.or(self.elevation),
            nodata: over.nodata.or(self.nodata),
            unit: over.unit.or(self.unit),
            raw: over.raw.or(self.raw),
            fill: over.fill.or(self.fill),
            holes: over.holes.or(self.holes),
            wrap: over.wrap.or(self.wrap),
            scale: over.scale.or(self.scale),
            bias: over.bias.or(self.bias),
            exaggerate: over.exaggerate.or(self.exaggerate),
            extinction: over.extinction.or(self.extinction),
            creases: over.creases.or(self.creases),
            textures: over.textures.or(self.textures),
            udim: over.udim.or(self.udim),
            color: over.color.or(self.color),
            ramp: over.ramp.or(self.ramp),
            normal: over.normal.or(self.normal),
            green: over.green.or(self.green),
            roughness: over.roughness.or(self.roughness),
            metallic: over.metallic.or(self.metallic),
            occlusion: over.occlusion.or(self.occlusion),
            orm: over.orm.or(self.orm),
            mask_map: over.mask_map.or(self.mask_map),
            metallic_smoothness: over.metallic_smoothness.or(self.metallic_smoothness),
            glossiness: over.glossiness.or(self.glossiness),
            emission: over.emission.or(self.emission),
            mesh: over.mesh.or(self.mesh),
            walls: over.walls.or(self.walls),
            base: over.base.or(self.base),
            project: over.project.or(self.project),
            mesh_up: over.mesh_up.or(self.mesh_up),
            tile: over.tile.or(self.tile),
            tile_size: over.tile_size.or(self.tile_size),
            position: over.position.or(self.position),
            rotation: over.rotation.or(self.rotation),
            mesh_scale: over.mesh_scale.or(self.mesh_scale),
            method: over.method.or(self.method),
            stages,
            set,
            material: match (self.material, over.material) {
                (Some(own), Some(over)) => Some(own.overridden_by(over)),
                (own, over) => over.or(own),
            },
            transmission: over.transmission.or(self.transmission),
            ior: over.ior.or(self.ior),
            two_sided: over.two_sided.or(self.two_sided),
        }
    }

    /// Returns the paths of all files: maps, object and mesh.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let mesh = match &self.mesh {
            Some(MeshChoice::File(path)) => Some(path),
            _ => None,
        };
        let ramp = match &self.ramp {
            Some(RampChoice::File(path)) => Some(path),
            _ => None,
        };
        [
            self.height.as_ref(),
            self.volume.as_ref(),
            self.motif.as_ref(),
            self.object.as_ref(),
            self.color.as_ref(),
            ramp,
            self.textures.as_ref(),
            self.normal.as_ref(),
            self.roughness.as_ref(),
            self.metallic.as_ref(),
            self.occlusion.as_ref(),
            self.orm.as_ref(),
            self.mask_map.as_ref(),
            self.metallic_smoothness.as_ref(),
            self.glossiness.as_ref(),
            self.emission.as_ref(),
            mesh,
        ]
        .into_iter()
        .flatten()
        .filter(|file| !is_no_map(file))
    }

    /// Returns the paths of all files for changing them.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let mesh = match &mut self.mesh {
            Some(MeshChoice::File(path)) => Some(path),
            _ => None,
        };
        let ramp = match &mut self.ramp {
            Some(RampChoice::File(path)) => Some(path),
            _ => None,
        };
        [
            self.height.as_mut(),
            self.volume.as_mut(),
            self.motif.as_mut(),
            self.object.as_mut(),
            self.color.as_mut(),
            ramp,
            self.textures.as_mut(),
            self.normal.as_mut(),
            self.roughness.as_mut(),
            self.metallic.as_mut(),
            self.occlusion.as_mut(),
            self.orm.as_mut(),
            self.mask_map.as_mut(),
            self.metallic_smoothness.as_mut(),
            self.glossiness.as_mut(),
            self.emission.as_mut(),
            mesh,
        ]
        .into_iter()
        .flatten()
        .filter(|file| !is_no_map(file))
    }

    /// Drops everything about the relief. Placement, material, shadow and ambient light stay.
    fn forget_relief(&mut self) {
        let known = std::mem::take(self);
        let stages = known.stages.into_iter().filter(|(key, _)| !is_of_method(key) && key != DETAIL_KEY);
        *self = SurfaceSpec {
            position: known.position,
            rotation: known.rotation,
            mesh_scale: known.mesh_scale,
            material: known.material,
            transmission: known.transmission,
            ior: known.ior,
            stages: stages.collect(),
            ..SurfaceSpec::default()
        };
    }

    /// Returns the first given key that only heights can have, and neither volumes nor motifs.
    pub(super) fn key_of_heights(&self) -> Option<&'static str> {
        let given = [
            ("height", self.height.is_some()),
            ("channel", self.channel.is_some()),
            ("depth", self.depth.is_some()),
            ("range", self.range.is_some()),
            ("elevation", self.elevation.is_some()),
            ("nodata", self.nodata.is_some()),
            ("unit", self.unit.is_some()),
            ("raw", self.raw.is_some()),
            ("fill", self.fill.is_some()),
            ("holes", self.holes.is_some()),
            ("textures", self.textures.is_some()),
            ("udim", self.udim.is_some()),
            ("ramp", self.ramp.is_some()),
            ("normal", self.normal.is_some()),
            ("green", self.green.is_some()),
            ("creases", self.creases.is_some()),
            ("walls", self.walls.is_some()),
            ("base", self.base.is_some()),
        ];
        given.iter().find_map(|&(key, is_given)| is_given.then_some(key))
    }

    /// Returns the first given key that only a relief can have.
    pub(super) fn key_of_relief(&self) -> Option<&'static str> {
        let given = [
            ("height", self.height.is_some()),
            ("volume", self.volume.is_some()),
            ("motif", self.motif.is_some()),
            ("axes", self.axes.is_some()),
            ("channel", self.channel.is_some()),
            ("depth", self.depth.is_some()),
            ("range", self.range.is_some()),
            ("elevation", self.elevation.is_some()),
            ("nodata", self.nodata.is_some()),
            ("unit", self.unit.is_some()),
            ("raw", self.raw.is_some()),
            ("fill", self.fill.is_some()),
            ("holes", self.holes.is_some()),
            ("wrap", self.wrap.is_some()),
            ("scale", self.scale.is_some()),
            ("bias", self.bias.is_some()),
            ("exaggerate", self.exaggerate.is_some()),
            ("extinction", self.extinction.is_some()),
            ("textures", self.textures.is_some()),
            ("udim", self.udim.is_some()),
            ("color", self.color.is_some()),
            ("ramp", self.ramp.is_some()),
            ("normal", self.normal.is_some()),
            ("green", self.green.is_some()),
            ("roughness", self.roughness.is_some()),
            ("metallic", self.metallic.is_some()),
            ("occlusion", self.occlusion.is_some()),
            ("orm", self.orm.is_some()),
            ("mask-map", self.mask_map.is_some()),
            ("metallic-smoothness", self.metallic_smoothness.is_some()),
            ("glossiness", self.glossiness.is_some()),
            ("emission", self.emission.is_some()),
            ("tile-size", self.tile_size.is_some()),
            ("mesh", self.mesh.is_some()),
            ("walls", self.walls.is_some()),
            ("base", self.base.is_some()),
            ("project", self.project.is_some()),
            ("mesh-up", self.mesh_up.is_some()),
            ("tile", self.tile.is_some()),
            ("two-sided", self.two_sided.is_some()),
        ];
        given.into_iter().find_map(|(key, is_given)| is_given.then_some(key))
    }

    /// Returns whether the surface refracts light, which needs the environment map.
    pub(super) fn asks_for_environment(&self) -> bool {
        self.transmission.is_some_and(|part| part > 0.0)
    }

    /// Returns whether an ambient variant is named that does not read the environment map.
    pub(super) fn names_other_ambient(&self) -> bool {
        self.stages.get(STAGES[AMBIENT].key).is_some_and(|name| name != environment())
    }

    /// Drops an ambient variant that does not read the environment map, with its settings.
    pub(super) fn forget_ambient(&mut self) {
        if self.names_other_ambient() {
            let key = STAGES[AMBIENT].key;
            self.stages.remove(key);
            self.set.retain(|name, _| name.split('.').next() != Some(key));
        }
    }

    /// Drops the variants and settings that `over` replaces. A stage that stays keeps its settings.
    fn drop_replaced_stages(&mut self, over: &SurfaceSpec) {
        let of = |name: &str, key: &str| name.split_once('.').is_some_and(|(stage, _)| stage == key);
        if over.method.is_some() {
            self.stages.retain(|key, _| !is_of_method(key));
            self.set.retain(|name, _| !name.split_once('.').is_some_and(|(stage, _)| is_of_method(stage)));
        }
        for key in over.stages.keys() {
            if is_of_method(key) {
                self.method = None;
            }
            self.set.retain(|name, _| !of(name, key));
        }
        // A geometry excludes a search and a refinement, and the other way round.
        let [geometry, search, refine] = [GEOMETRY, SEARCH, REFINE].map(|stage| STAGES[stage].key);
        let says = |key: &str| over.stages.contains_key(key);
        let replaced = match (says(geometry), says(search) || says(refine)) {
            (true, false) => &[search, refine][..],
            (false, true) => &[geometry],
            _ => &[],
        };
        for key in replaced {
            self.stages.remove(*key);
            self.set.retain(|name, _| !of(name, key));
        }
        let [shadow, search] = [SHADOW, SHADOW_SEARCH].map(|stage| STAGES[stage].key);
        if over.stages.contains_key(shadow) {
            self.stages.remove(search);
            self.set.retain(|name, _| !of(name, search));
        }
    }
}
