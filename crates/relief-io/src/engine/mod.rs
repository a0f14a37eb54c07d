//! Conventions of engines for the textures of a material: green, channels, bits, names, and what
//! becomes of heights.
//!
//! `table.rs` has a row for each engine, with the sources of its facts.

mod frames;
mod godot_mesh;
mod model;
mod table;

use relief_core::registry::UnknownName;

pub use self::frames::VertexFrames;
pub use self::godot_mesh::godot_mesh;
pub use self::model::{EngineModel, EngineShape, ModelTextures, percent_encoded, write_engine_model};
pub use self::table::ENGINES;

use crate::{Convention, Format, GreenSign};

/// Engine, with the textures that its standard material takes.
#[derive(Debug, PartialEq, Eq)]
pub struct Engine {
    /// Name, as in `unreal`.
    pub name: &'static str,
    /// Name in prose, with the version whose documentation was read.
    pub title: &'static str,
    /// Direction of green in normal maps.
    pub green: GreenSign,
    /// Textures that a material takes, one for each content.
    pub textures: &'static [EngineTexture],
    /// What the engine does with heights.
    pub height: HeightUse,
    /// Settings beside the height texture, which hold its scale.
    pub settings: &'static [EngineSetting],
    /// Cells along each side of the plane with the material that is written as glTF. `None` for
    /// engines whose materials come from no glTF.
    pub plane_cells: Option<u32>,
    /// Addresses of the documents and sources that the row was checked against.
    pub sources: &'static [&'static str],
}

/// Texture that an engine takes.
#[derive(Debug, PartialEq, Eq)]
pub struct EngineTexture {
    /// What the texture holds.
    pub content: TextureContent,
    /// Text before the material's name in the name of the file.
    pub prefix: &'static str,
    /// Text after the material's name in the name of the file.
    pub ending: &'static str,
    /// Format of the file.
    pub format: Format,
    /// Bits of a sample.
    pub bits: u32,
    /// Slot of the material that takes the texture.
    pub slot: &'static str,
    /// What must be set when the texture is imported. Empty if nothing.
    pub import: &'static str,
}

/// Content of an engine's texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureContent {
    /// Base colour in sRGB, with opacity where the material has it.
    Color,
    /// Normals in tangent space.
    Normal,
    /// Occlusion, roughness and metalness, by the channels red, green, blue and opacity.
    Surface(&'static [SurfaceChannel]),
    /// Heights, or depths where the convention says so.
    Height(Convention),
    /// Colour of the light that the surface emits, in sRGB.
    Emission,
}

/// Value of a material in a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceChannel {
    /// Ambient occlusion: 1 is open.
    Occlusion,
    /// Roughness: 0 is smooth.
    Roughness,
    /// Smoothness: 1 less the roughness.
    Smoothness,
    /// Metalness: 1 is metal.
    Metalness,
    /// Channel that the engine does not read; it is 0.
    Unused,
}

/// What an engine does with heights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeightUse {
    /// It moves points of the mesh.
    Displacement,
    /// It shifts texture coordinates.
    Parallax,
    /// Nothing; the texture is for other programs.
    Nothing,
}

/// Setting of an engine's material that depends on the scale of the heights.
#[derive(Debug, PartialEq, Eq)]
pub struct EngineSetting {
    /// Name of the setting.
    pub name: &'static str,
    /// What its value is.
    pub value: SettingValue,
}

/// Meaning of a setting's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingValue {
    /// Displacement of height 1 above height 0, in metres times this factor.
    Scale(u32),
    /// Displacement of height 0, in metres times this factor.
    Lowest(u32),
    /// Displacement of height 1, in metres times this factor.
    Highest(u32),
    /// Height that is not displaced, from 0 to 1 if the surface lies inside the relief.
    Level,
    /// Depth of the relief as a part of the tile's width, times this factor.
    PartOfTile(u32),
}

impl Engine {
    /// Finds an engine by its name.
    ///
    /// # Errors
    ///
    /// When no engine has this name; the error has the nearest name and all names.
    ///
    /// # Examples
    ///
    /// ```
    /// use relief_io::{Engine, GreenSign};
    ///
    /// let unreal = Engine::named("unreal")?;
    /// assert_eq!(unreal.green, GreenSign::MinusY);
    /// let error = Engine::named("unrael").err().map(|error| error.to_string());
    /// assert!(error.is_some_and(|text| text.contains("did you mean 'unreal'")));
    /// # Ok::<(), relief_core::registry::UnknownName>(())
    /// ```
    pub fn named(name: &str) -> Result<&'static Engine, UnknownName> {
        let found = ENGINES.iter().find(|engine| engine.name == name);
        found.ok_or_else(|| UnknownName::new("engine", name, ENGINES.iter().map(|engine| engine.name)))
    }
}

impl EngineTexture {
    /// Returns the name of the file for a material. A prefix that the name already has is not
    /// repeated.
    pub fn file_name(&self, material: &str) -> String {
        let name = material.strip_prefix(self.prefix).unwrap_or(material);
        format!("{}{name}{}.{}", self.prefix, self.ending, self.format.name().to_lowercase())
    }

    /// Whether the samples are colours in sRGB. Otherwise they are plain numbers.
    pub fn is_srgb(&self) -> bool {
        matches!(self.content, TextureContent::Color | TextureContent::Emission)
    }
}

impl TextureContent {
    /// Returns the content in plain words.
    pub fn name(self) -> String {
        match self {
            Self::Color => "base colour".to_owned(),
            Self::Normal => "normals".to_owned(),
            Self::Surface(channels) => channels
                .iter()
                .zip(["red", "green", "blue", "opacity"])
                .filter(|(channel, _)| **channel != SurfaceChannel::Unused)
                .map(|(channel, place)| format!("{} in {place}", channel.name()))
                .collect::<Vec<_>>()
                .join(", "),
            Self::Height(Convention::Height) => "heights, white is high".to_owned(),
            Self::Height(Convention::Depth) => "depths, white is deep".to_owned(),
            Self::Emission => "emission".to_owned(),
        }
    }
}

impl SurfaceChannel {
    /// Returns the value in plain words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Occlusion => "occlusion",
            Self::Roughness => "roughness",
            Self::Smoothness => "smoothness",
            Self::Metalness => "metalness",
            Self::Unused => "nothing",
        }
    }
}

impl HeightUse {
    /// Returns the use in plain words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Displacement => "displacement",
            Self::Parallax => "parallax",
            Self::Nothing => "nothing",
        }
    }
}

impl SettingValue {
    /// Returns the value for heights with that scale and bias, on a tile `tile_m` metres wide.
    pub fn of(self, scale_m: f64, bias_m: f64, tile_m: f64) -> f64 {
        match self {
            Self::Scale(factor) => f64::from(factor) * scale_m,
            Self::Lowest(factor) => f64::from(factor) * bias_m,
            Self::Highest(factor) => f64::from(factor) * (bias_m + scale_m),
            Self::Level if scale_m == 0.0 => 0.0,
            Self::Level => -bias_m / scale_m,
            Self::PartOfTile(factor) => f64::from(factor) * scale_m / tile_m,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_hold_the_scale_in_the_unit_of_the_engine() {
        let values = |name: &str| {
            let engine = Engine::named(name).expect("a known engine");
            engine.settings.iter().map(|setting| setting.value.of(0.05, -0.05, 0.5)).collect::<Vec<_>>()
        };
        assert_eq!(values("unreal"), [5.0, 1.0]);
        assert_eq!(values("unity"), [-5.0, 0.0, 0.1]);
        assert_eq!(values("godot"), [10.0]);
        assert_eq!(values("three"), [0.05, -0.05]);
        assert_eq!(values("bevy"), [0.1]);
        assert_eq!(SettingValue::Level.of(0.0, 0.0, 1.0), 0.0);
    }

    #[test]
    fn rows_are_whole() {
        for engine in ENGINES {
            assert!(!engine.sources.is_empty(), "{}", engine.name);
            let mut names: Vec<String> =
                engine.textures.iter().map(|texture| texture.file_name("T_Wall")).collect();
            names.sort();
            names.dedup();
            assert_eq!(names.len(), 5, "{}", engine.name);
            assert_eq!(engine.settings.is_empty(), engine.height == HeightUse::Nothing, "{}", engine.name);
        }
        let unreal = Engine::named("unreal").expect("a known engine");
        assert_eq!(unreal.textures[0].file_name("T_Wall"), "T_Wall_BC.png");
        assert_eq!(unreal.textures[0].file_name("Wall"), "T_Wall_BC.png");
    }
}
