//! Descriptions of scenes, with gaps.

use super::{BackendChoice, Sampling};
use crate::mesh::Builtin;
use relief_core::{ByteSize, Wrap};
use relief_io::{GreenSign, RawLayout};
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt::{self, Display};
use std::path::PathBuf;
use std::str::FromStr;

/// A scene as a scene file or the command line describes it: what is not said is `None` and has a default.
///
/// The keys of a scene file are the fields' names with `-` for `_`, and those are the flags of the command line.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SceneSpec {
    /// The height map's file. There is no scene without one.
    pub height: Option<PathBuf>,
    /// The channel of the file that holds the height.
    pub channel: Option<String>,
    /// Whether the file holds depth: white is deep. By default it holds height.
    pub depth: Option<bool>,
    /// The values that become heights 0 and 1. By default integers take 0 and their type's maximum, floats their
    /// least and greatest value.
    #[serde(deserialize_with = "numbers")]
    pub range: Option<[f64; 2]>,
    /// Size and byte order of a headerless file, as in `"403x344,le"`.
    #[serde(deserialize_with = "parsed")]
    pub raw: Option<RawLayout>,
    /// Whether texels without a value are filled from their surroundings. By default they are an error.
    pub fill: Option<bool>,
    /// How the maps go on beyond their edges: `repeat` (default), `clamp` or `mirror`.
    #[serde(deserialize_with = "parsed")]
    pub wrap: Option<Wrap>,
    /// Metres of displacement between heights 0 and 1. By default in proportion to the mesh's tile where the height map's file
    /// states metres, else 0.05.
    pub scale: Option<f64>,
    /// Displacement of height 0 in metres. By default minus the scale: the relief is carved into the surface.
    pub bias: Option<f64>,
    /// The colour picture's file. By default none.
    pub color: Option<PathBuf>,
    /// The normal map's file. By default none.
    pub normal: Option<PathBuf>,
    /// Where the normal map's green points: `+y` (default) up in the picture, `-y` down.
    #[serde(deserialize_with = "parsed")]
    pub green: Option<GreenSign>,
    /// The base mesh: `plane` (default), `cube`, `cylinder`, `sphere` or `torus`.
    #[serde(deserialize_with = "parsed")]
    pub mesh: Option<Builtin>,
    /// Tiles along `u` and `v`. By default 1 and 1.
    #[serde(deserialize_with = "numbers")]
    pub tile: Option<[f32; 2]>,
    /// The method's name. By default `exact`.
    pub method: Option<String>,
    /// The search's name, together with `refine` in place of `method`.
    pub search: Option<String>,
    /// The refinement's name, together with `search`.
    pub refine: Option<String>,
    /// Settings of the method, by names such as `search.steps`.
    #[serde(deserialize_with = "settings")]
    pub set: BTreeMap<String, f64>,
    /// Position of the eye in metres. By default (0.6, 0.9, 1.1).
    #[serde(deserialize_with = "numbers")]
    pub eye: Option<[f64; 3]>,
    /// The point looked at, in metres. By default the origin.
    #[serde(deserialize_with = "numbers")]
    pub target: Option<[f64; 3]>,
    /// Vertical field of view in degrees. By default 40.
    pub fov: Option<f64>,
    /// Width and height of the picture in pixels. By default 800 and 600.
    #[serde(deserialize_with = "numbers")]
    pub size: Option<[u32; 2]>,
    /// Direction toward the only light, white and of irradiance 1. By default (0.5, 0.8, 0.3).
    #[serde(deserialize_with = "numbers")]
    pub light: Option<[f64; 3]>,
    /// All lights, in place of `light`.
    pub lights: Option<Vec<LightSpec>>,
    /// Irradiance from everywhere, linear red, green, blue. By default 0.15 each.
    #[serde(deserialize_with = "numbers")]
    pub ambient: Option<[f32; 3]>,
    /// The material. By default light grey.
    pub material: Option<MaterialSpec>,
    /// Linear colour of pixels that show no surface. By default 0.05 each.
    #[serde(deserialize_with = "numbers")]
    pub background: Option<[f32; 3]>,
    /// What computes the picture: `auto` (default), `cpu` or `gpu`.
    #[serde(deserialize_with = "parsed")]
    pub backend: Option<BackendChoice>,
    /// How textures are read: `exact` (default) or `fast`.
    #[serde(deserialize_with = "parsed")]
    pub sampling: Option<Sampling>,
    /// Whether triangles seen from behind are drawn. By default they are not.
    pub two_sided: Option<bool>,
    /// The most memory that maps and picture may take. By default 4 GiB.
    #[serde(deserialize_with = "amount")]
    pub max_memory: Option<ByteSize>,
}

/// A light: exactly one of `direction` and `position` is given.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct LightSpec {
    /// Direction toward a light infinitely far away, of any length.
    #[serde(deserialize_with = "numbers")]
    pub direction: Option<[f64; 3]>,
    /// Position of a point light in metres.
    #[serde(deserialize_with = "numbers")]
    pub position: Option<[f64; 3]>,
    /// Linear red, green, blue. By default white.
    #[serde(deserialize_with = "numbers")]
    pub color: Option<[f32; 3]>,
    /// Factor on the colour: irradiance on a surface that faces the light (of a point light, at 1 m). By default 1.
    pub intensity: Option<f32>,
}

/// A Blinn-Phong material; what is not said is that of [`Material::default`](crate::material::Material::default).
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

impl SceneSpec {
    /// This description with everything that `over` says in place of what it said itself.
    ///
    /// What belongs to something replaced goes with it: another height file drops how the old one was to be read
    /// (`channel`, `depth`, `range`, `raw`, `fill`), another normal map drops `green`, another method or stage its own
    /// settings, `light` and `lights` each other, and a scale without a bias the old bias.
    #[must_use]
    pub fn overridden_by(mut self, over: SceneSpec) -> SceneSpec {
        if over.height.is_some() {
            (self.channel, self.depth, self.range, self.raw, self.fill) = (None, None, None, None, None);
        }
        if over.normal.is_some() {
            self.green = None;
        }
        if over.scale.is_some() {
            self.bias = None;
        }
        if over.light.is_some() || over.lights.is_some() {
            (self.light, self.lights) = (None, None);
        }
        self.drop_replaced_method(&over);
        let mut set = self.set;
        set.extend(over.set);
        SceneSpec {
            height: over.height.or(self.height),
            channel: over.channel.or(self.channel),
            depth: over.depth.or(self.depth),
            range: over.range.or(self.range),
            raw: over.raw.or(self.raw),
            fill: over.fill.or(self.fill),
            wrap: over.wrap.or(self.wrap),
            scale: over.scale.or(self.scale),
            bias: over.bias.or(self.bias),
            color: over.color.or(self.color),
            normal: over.normal.or(self.normal),
            green: over.green.or(self.green),
            mesh: over.mesh.or(self.mesh),
            tile: over.tile.or(self.tile),
            method: over.method.or(self.method),
            search: over.search.or(self.search),
            refine: over.refine.or(self.refine),
            set,
            eye: over.eye.or(self.eye),
            target: over.target.or(self.target),
            fov: over.fov.or(self.fov),
            size: over.size.or(self.size),
            light: over.light.or(self.light),
            lights: over.lights.or(self.lights),
            ambient: over.ambient.or(self.ambient),
            material: over.material.or(self.material),
            background: over.background.or(self.background),
            backend: over.backend.or(self.backend),
            sampling: over.sampling.or(self.sampling),
            two_sided: over.two_sided.or(self.two_sided),
            max_memory: over.max_memory.or(self.max_memory),
        }
    }

    /// Forgets the names and settings that `over` replaces. A stage that stays keeps its settings.
    fn drop_replaced_method(&mut self, over: &SceneSpec) {
        if over.method.is_some() {
            (self.search, self.refine) = (None, None);
            self.set.clear();
        }
        for (stage, replaced) in [("search.", &over.search), ("refine.", &over.refine)] {
            if replaced.is_some() {
                self.method = None;
                self.set.retain(|name, _| !name.starts_with(stage));
            }
        }
    }
}

/// Reads a value that is written as a name or another text.
fn parsed<'de, D, T>(deserializer: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: FromStr<Err: Display>,
{
    let text = String::deserialize(deserializer)?;
    text.parse().map(Some).map_err(de::Error::custom)
}

/// Reads exactly `N` numbers. (Arrays as such would take the first ones and ignore the rest.)
fn numbers<'de, D, T, const N: usize>(deserializer: D) -> Result<Option<[T; N]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let numbers = Vec::<T>::deserialize(deserializer)?;
    let given = numbers.len();
    let array =
        numbers.try_into().map_err(|_| de::Error::invalid_length(given, &format!("{N} numbers").as_str()));
    array.map(Some)
}

/// Reads `search.steps = 64` under `[set]`, which TOML takes as a table in a table.
fn settings<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, f64>, D::Error> {
    let stages = BTreeMap::<String, BTreeMap<String, f64>>::deserialize(deserializer)?;
    let flat = stages.into_iter().flat_map(|(stage, settings)| {
        settings.into_iter().map(move |(name, value)| (format!("{stage}.{name}"), value))
    });
    Ok(flat.collect())
}

/// Reads an amount of memory: a number of bytes, or a text such as `4GiB`.
fn amount<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<ByteSize>, D::Error> {
    struct Amount;

    impl Visitor<'_> for Amount {
        type Value = ByteSize;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("an amount of memory such as \"4GiB\"")
        }

        fn visit_i64<E: de::Error>(self, bytes: i64) -> Result<ByteSize, E> {
            bytes.to_string().parse().map_err(E::custom)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<ByteSize, E> {
            text.parse().map_err(E::custom)
        }
    }

    deserializer.deserialize_any(Amount).map(Some)
}
