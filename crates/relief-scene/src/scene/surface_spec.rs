//! Descriptions of surfaces, with gaps.

use super::MeshChoice;
use super::keys::{length, lengths, numbers, parsed, range};
use super::settings::settings;
use relief_core::Wrap;
use relief_core::mesh::UvProjection;
use relief_io::{GivenUnits, GreenSign, HeightRange, RawLayout, Up};
use relief_shaders::{
    AMBIENT, DETAIL, Entry, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES,
};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// A surface as a scene file or a program describes it: what is not said is `None` and has a default.
///
/// The keys of a scene file are the fields' names with `-` for `_`, and for each stage its key with the name
/// of a variant.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SurfaceSpec {
    /// The height map's file. There is no surface without one.
    pub height: Option<PathBuf>,
    /// The file of an object of images with depth, in place of height map and mesh. Of what else there is to
    /// say it has a place, a method, settings and a material.
    pub object: Option<PathBuf>,
    /// The channel of the file that holds the height.
    pub channel: Option<String>,
    /// Whether the file holds depth: white is deep. By default it holds height.
    pub depth: Option<bool>,
    /// The file's values that become heights 0 and 1: two numbers, or `auto` for the least and the greatest
    /// value. By default integers take 0 and their type's maximum, floats and elevation models `auto`.
    #[serde(deserialize_with = "range")]
    pub range: Option<HeightRange>,
    /// The value of texels without one, as the file stores it, beside the value that the file declares. By
    /// default that one alone.
    pub nodata: Option<f64>,
    /// The unit of the heights, as in `"cm"`, or the units of the heights and of the ground, as in `"cm,ft"`.
    /// By default the units that the file says.
    #[serde(deserialize_with = "parsed")]
    pub unit: Option<GivenUnits>,
    /// Size and byte order of a headerless file, as in `"403x344,le"`.
    #[serde(deserialize_with = "parsed")]
    pub raw: Option<RawLayout>,
    /// Whether texels without a value are filled from their surroundings. Default: elevation models and maps
    /// with `nodata` are filled, and
    /// [`HeightMap::filled_texels`](relief_core::HeightMap::filled_texels) counts the texels. In other files
    /// such a texel is an error.
    pub fill: Option<bool>,
    /// Whether texels without a value are holes, which show what is behind them: rays pass dual cells with
    /// such a texel. By default they are not. Where they are, texels without a value are filled in files of
    /// all kinds unless `fill` says otherwise: shadows, light from all around and baked maps see these
    /// heights.
    pub holes: Option<bool>,
    /// How the maps go on beyond their edges: `repeat`, `clamp` or `mirror`. By default elevation models are
    /// clamped, others repeated.
    #[serde(deserialize_with = "parsed")]
    pub wrap: Option<Wrap>,
    /// Metres of displacement between heights 0 and 1. By default in proportion to the mesh's tile where the
    /// height map's file states metres, or a quarter of its shorter side where these make it deeper than any
    /// ground; else 0.05.
    #[serde(deserialize_with = "length")]
    pub scale: Option<f64>,
    /// Displacement of height 0 in metres. By default minus the scale: the relief is carved into the surface.
    #[serde(deserialize_with = "length")]
    pub bias: Option<f64>,
    /// Factor on the scale, whether that is given or not, and on a bias that is not given. From 1e-6 to 1e6,
    /// by default 1.
    pub exaggerate: Option<f64>,
    /// Whether normals that are derived from the heights end at creases, where heights change from slope to
    /// slope at once, and are not smeared over them. By default they are smooth.
    pub creases: Option<bool>,
    /// The colour picture's file. By default none.
    pub color: Option<PathBuf>,
    /// The normal map's file. By default none.
    pub normal: Option<PathBuf>,
    /// Where the normal map's green points: `+y` (default) up in the picture, `-y` down.
    #[serde(deserialize_with = "parsed")]
    pub green: Option<GreenSign>,
    /// Metres of a tile along `u` and `v`. By default as the height map's file states them, else its texels
    /// are square.
    #[serde(deserialize_with = "lengths")]
    pub tile_size: Option<[f64; 2]>,
    /// The base mesh: `plane` (default), which has the height map's proportions, `square`, `cube`,
    /// `cylinder`, `sphere`, `torus`, or a file that [`read_mesh`](relief_io::read_mesh) reads.
    #[serde(deserialize_with = "parsed")]
    pub mesh: Option<MeshChoice>,
    /// How texture coordinates are made for the mesh of a file: `box`, `cylinder` or `sphere`. By default
    /// they are the file's.
    #[serde(deserialize_with = "parsed")]
    pub project: Option<UvProjection>,
    /// Which axis of the mesh's file points up: `y` or `z`. By default as a file of Relief says itself, else
    /// `z` in STL and `y` in all others.
    #[serde(deserialize_with = "parsed")]
    pub mesh_up: Option<Up>,
    /// Tiles along `u` and `v`. By default 1 and 1.
    #[serde(deserialize_with = "numbers")]
    pub tile: Option<[f32; 2]>,
    /// Where the mesh's origin lies, in metres. By default the world's origin.
    #[serde(deserialize_with = "lengths")]
    pub position: Option<[f64; 3]>,
    /// Degrees by which the mesh is turned about `x`, then about `y`, then about `z`. By default 0 each.
    #[serde(deserialize_with = "numbers")]
    pub rotation: Option<[f64; 3]>,
    /// How many times as large the mesh is, its tiles with it; the relief's metres stay. By default 1. Its
    /// older name `size` is read in `[[surfaces]]`; the scene's own `size` is the picture's.
    #[serde(alias = "size")]
    pub mesh_scale: Option<f64>,
    /// The method's name. By default `exact`.
    pub method: Option<String>,
    /// Names of variants by their stages' keys. `search` and `refine` come together, in place of `method`,
    /// and so does `geometry`.
    #[serde(skip)]
    pub stages: BTreeMap<String, String>,
    /// Settings of what is run, by names such as `search.steps`.
    #[serde(deserialize_with = "settings")]
    pub set: BTreeMap<String, f64>,
    /// The material. By default grey.
    pub material: Option<MaterialSpec>,
    /// The part of the light that is refracted, not scattered, from 0 to 1. By default 0. Where it is more,
    /// the ambient light is `environment` unless another is named.
    pub transmission: Option<f32>,
    /// The index of refraction, from 1 to 4. By default 1.5.
    pub ior: Option<f32>,
    /// Whether triangles seen from behind are drawn. By default they are not.
    pub two_sided: Option<bool>,
}

/// Blinn-Phong material. Missing values come from
/// [`Material::default`](crate::material::Material::default), except a diffuse of 0.8 under a colour map.
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
}

/// The ambient light that shows the surroundings.
pub(super) fn environment() -> &'static str {
    STAGES[AMBIENT].first(Entry::sees_surroundings).map_or("", |(_, entry)| entry.name)
}

/// Key of the level of detail. Objects have one level alone.
const DETAIL_KEY: &str = STAGES[DETAIL].key;

/// Whether that is the key of one of the stages that a method names.
fn is_of_method(key: &str) -> bool {
    [GEOMETRY, SLICES, OBJECT, SEARCH, REFINE].iter().any(|stage| STAGES[*stage].key == key)
}

impl SurfaceSpec {
    /// This description with everything that `over` says in place of what it said itself.
    ///
    /// What belongs to something replaced goes with it: another height file drops how the old one was to be
    /// read (`channel`, `depth`, `range`, `nodata`, `unit`, `raw`, `fill`), another normal map drops `green`,
    /// another mesh
    /// `project` and `mesh-up`, another method or stage its own settings, another shadow its search, another
    /// ambient light than `environment` what is refracted and what is refracted another ambient light, and a
    /// scale without a bias the old bias.
    #[must_use]
    pub fn overridden_by(mut self, over: SurfaceSpec) -> SurfaceSpec {
        if over.height.is_some() {
            (self.channel, self.depth, self.raw, self.fill) = (None, None, None, None);
            (self.range, self.nodata, self.unit) = (None, None, None);
        }
        if over.object.is_some() {
            self.forget_relief();
        } else if over.height.is_some() || over.mesh.is_some() {
            self.object = None;
        }
        if over.normal.is_some() {
            self.green = None;
        }
        if over.mesh.is_some() {
            (self.project, self.mesh_up) = (None, None);
        }
        if over.scale.is_some() {
            self.bias = None;
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
            object: over.object.or(self.object),
            channel: over.channel.or(self.channel),
            depth: over.depth.or(self.depth),
            range: over.range.or(self.range),
            nodata: over.nodata.or(self.nodata),
            unit: over.unit.or(self.unit),
            raw: over.raw.or(self.raw),
            fill: over.fill.or(self.fill),
            holes: over.holes.or(self.holes),
            wrap: over.wrap.or(self.wrap),
            scale: over.scale.or(self.scale),
            bias: over.bias.or(self.bias),
            exaggerate: over.exaggerate.or(self.exaggerate),
            creases: over.creases.or(self.creases),
            color: over.color.or(self.color),
            normal: over.normal.or(self.normal),
            green: over.green.or(self.green),
            mesh: over.mesh.or(self.mesh),
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
            material: over.material.or(self.material),
            transmission: over.transmission.or(self.transmission),
            ior: over.ior.or(self.ior),
            two_sided: over.two_sided.or(self.two_sided),
        }
    }

    /// The files that it names: maps and the mesh.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let mesh = match &self.mesh {
            Some(MeshChoice::File(path)) => Some(path),
            _ => None,
        };
        [self.height.as_ref(), self.object.as_ref(), self.color.as_ref(), self.normal.as_ref(), mesh]
            .into_iter()
            .flatten()
    }

    /// As [`files`](Self::files), to be named otherwise.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let mesh = match &mut self.mesh {
            Some(MeshChoice::File(path)) => Some(path),
            _ => None,
        };
        [self.height.as_mut(), self.object.as_mut(), self.color.as_mut(), self.normal.as_mut(), mesh]
            .into_iter()
            .flatten()
    }

    /// Forgets the relief and how it is found: all but the place, what is reflected, and shadows.
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

    /// The first key that is given and says something of a relief alone.
    pub(super) fn key_of_relief(&self) -> Option<&'static str> {
        let given = [
            ("height", self.height.is_some()),
            ("channel", self.channel.is_some()),
            ("depth", self.depth.is_some()),
            ("range", self.range.is_some()),
            ("nodata", self.nodata.is_some()),
            ("unit", self.unit.is_some()),
            ("raw", self.raw.is_some()),
            ("fill", self.fill.is_some()),
            ("holes", self.holes.is_some()),
            ("wrap", self.wrap.is_some()),
            ("scale", self.scale.is_some()),
            ("bias", self.bias.is_some()),
            ("exaggerate", self.exaggerate.is_some()),
            ("color", self.color.is_some()),
            ("normal", self.normal.is_some()),
            ("green", self.green.is_some()),
            ("tile-size", self.tile_size.is_some()),
            ("mesh", self.mesh.is_some()),
            ("project", self.project.is_some()),
            ("mesh-up", self.mesh_up.is_some()),
            ("tile", self.tile.is_some()),
            ("two-sided", self.two_sided.is_some()),
        ];
        given.into_iter().find_map(|(key, is_given)| is_given.then_some(key))
    }

    /// Whether the surroundings are to be seen by what is said of refraction.
    pub(super) fn asks_for_environment(&self) -> bool {
        self.transmission.is_some_and(|part| part > 0.0)
    }

    /// Whether an ambient light is named that sees no surroundings.
    pub(super) fn names_other_ambient(&self) -> bool {
        self.stages.get(STAGES[AMBIENT].key).is_some_and(|name| name != environment())
    }

    /// Forgets an ambient light that sees no surroundings, and its settings.
    pub(super) fn forget_ambient(&mut self) {
        if self.names_other_ambient() {
            let key = STAGES[AMBIENT].key;
            self.stages.remove(key);
            self.set.retain(|name, _| name.split('.').next() != Some(key));
        }
    }

    /// Forgets the names and settings that `over` replaces. A stage that stays keeps its settings.
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
        // A geometry is said in place of a search and a refinement, and these in its place.
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
