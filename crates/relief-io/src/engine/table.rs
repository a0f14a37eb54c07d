//! Table of the engines.

use super::{Engine, EngineSetting, EngineTexture, HeightUse, SettingValue, SurfaceChannel, TextureContent};
use crate::{Convention, Format, GreenSign};

use SurfaceChannel::{Metalness, Occlusion, Roughness, Smoothness, Unused};
use TextureContent::{Color, Emission, Height, Normal, Surface};

/// Occlusion, roughness and metalness, as glTF, Unreal and Godot read them.
const ORM: TextureContent = Surface(&[Occlusion, Roughness, Metalness]);

/// Channels of Unity's mask map. The detail mask, in blue, is not used.
const MASK: TextureContent = Surface(&[Metalness, Occlusion, Unused, Smoothness]);

const fn png(content: TextureContent, ending: &'static str, slot: &'static str) -> EngineTexture {
    EngineTexture { content, prefix: "", ending, format: Format::Png, bits: 8, slot, import: "" }
}

impl EngineTexture {
    const fn of_16_bits(self) -> Self {
        Self { bits: 16, ..self }
    }

    const fn after(self, prefix: &'static str) -> Self {
        Self { prefix, ..self }
    }

    const fn import(self, import: &'static str) -> Self {
        Self { import, ..self }
    }
}

const fn setting(name: &'static str, value: SettingValue) -> EngineSetting {
    EngineSetting { name, value }
}

/// All engines.
///
/// Samples of more than 8 bits are written only where the engine keeps them. Godot and browsers
/// reduce a PNG to 8 bits. Bevy before 0.20 reads a grey PNG of 16 bits as integers, which no
/// material can sample.
pub const ENGINES: &[Engine] = &[
    Engine {
        name: "unreal",
        title: "Unreal Engine 5",
        green: GreenSign::MinusY,
        textures: &[
            png(Color, "_BC", "Base Color").after("T_"),
            png(Normal, "_N", "Normal").after("T_").import("compression Normalmap"),
            png(ORM, "_ORM", "Ambient Occlusion, Roughness and Metallic, from red, green and blue")
                .after("T_")
                .import("compression Masks, sRGB off"),
            png(Height(Convention::Height), "_H", "Displacement, with tessellation enabled")
                .after("T_")
                .of_16_bits()
                .import("compression Grayscale, sRGB off"),
            png(Emission, "_E", "Emissive Color").after("T_"),
        ],
        height: HeightUse::Displacement,
        settings: &[
            setting("Displacement Scaling: Magnitude, in centimetres", SettingValue::Scale(100)),
            setting("Displacement Scaling: Center", SettingValue::Level),
        ],
        plane_cells: None,
        sources: &[
            "https://github.com/Allar/ue5-style-guide",
            "https://dev.epicgames.com/documentation/en-us/unreal-engine/python-api/class/\
             DisplacementScaling",
            "https://dev.epicgames.com/documentation/unreal-engine/API/Plugins/InterchangePipelines",
        ],
    },
    Engine {
        name: "unity",
        title: "Unity 6, URP and HDRP",
        green: GreenSign::PlusY,
        textures: &[
            png(Color, "_BaseMap", "Base Map"),
            png(Normal, "_Normal", "Normal Map").import("texture type Normal map"),
            png(MASK, "_MaskMap", "HDRP: Mask Map; URP: both Metallic Map and Occlusion Map")
                .import("sRGB off"),
            png(Height(Convention::Height), "_Height", "Height Map")
                .of_16_bits()
                .import("sRGB off, format R 16 bit"),
            png(Emission, "_Emission", "Emission Map"),
        ],
        height: HeightUse::Parallax,
        settings: &[
            setting("HDRP, Height Map: Min, in centimetres", SettingValue::Lowest(100)),
            setting("HDRP, Height Map: Max, in centimetres", SettingValue::Highest(100)),
            setting("URP, Height Map: scale, 0.005 to 0.08", SettingValue::PartOfTile(1)),
        ],
        plane_cells: None,
        sources: &[
            "https://docs.unity3d.com/Manual/urp/shaders-in-universalrp-channel-packed-texture.html",
            "https://docs.unity3d.com/Packages/com.unity.render-pipelines.high-definition@17.2/manual/\
             Displacement-Mode.html",
            "https://docs.unity3d.com/ScriptReference/TextureImporter-flipGreenChannel.html",
        ],
    },
    Engine {
        name: "godot",
        title: "Godot 4",
        green: GreenSign::PlusY,
        textures: &[
            png(Color, "_albedo", "ORMMaterial3D: albedo_texture"),
            png(Normal, "_normal", "normal_texture, with normal_enabled"),
            png(ORM, "_orm", "orm_texture"),
            png(Height(Convention::Height), "_height", "heightmap_texture, with heightmap_enabled"),
            png(Emission, "_emission", "emission_texture, with emission_enabled"),
        ],
        height: HeightUse::Parallax,
        settings: &[setting(
            "heightmap_scale, in hundredths of a tile's width",
            SettingValue::PartOfTile(100),
        )],
        plane_cells: None,
        sources: &[
            "https://docs.godotengine.org/en/stable/classes/class_ormmaterial3d.html",
            "https://docs.godotengine.org/en/stable/classes/class_basematerial3d.html",
            "https://github.com/godotengine/godot/blob/master/scene/resources/material.cpp",
            "https://github.com/godotengine/godot/blob/master/drivers/png/png_driver_common.cpp",
        ],
    },
    Engine {
        name: "three",
        title: "three.js",
        green: GreenSign::PlusY,
        textures: &[
            png(Color, "_basecolor", "map, in the colour space sRGB"),
            png(Normal, "_normal", "normalMap"),
            png(ORM, "_orm", "aoMap, roughnessMap and metalnessMap"),
            png(Height(Convention::Height), "_displacement", "displacementMap"),
            png(Emission, "_emissive", "emissiveMap, in the colour space sRGB"),
        ],
        height: HeightUse::Displacement,
        settings: &[
            setting("displacementScale", SettingValue::Scale(1)),
            setting("displacementBias", SettingValue::Lowest(1)),
        ],
        plane_cells: Some(128),
        sources: &["https://threejs.org/docs/pages/MeshStandardMaterial.html"],
    },
    Engine {
        name: "bevy",
        title: "Bevy",
        green: GreenSign::PlusY,
        textures: &[
            png(Color, "_base_color", "StandardMaterial: base_color_texture"),
            png(Normal, "_normal", "normal_map_texture").import("is_srgb = false"),
            png(ORM, "_orm", "metallic_roughness_texture and occlusion_texture, with metallic = 1")
                .import("is_srgb = false"),
            png(Height(Convention::Depth), "_depth_map", "depth_map").import("is_srgb = false"),
            png(Emission, "_emissive", "emissive_texture"),
        ],
        height: HeightUse::Parallax,
        settings: &[setting("parallax_depth_scale", SettingValue::PartOfTile(1))],
        plane_cells: Some(1),
        sources: &[
            "https://docs.rs/bevy/latest/bevy/pbr/struct.StandardMaterial.html",
            "https://github.com/bevyengine/bevy/blob/main/crates/bevy_image/src/image_texture_conversion.rs",
        ],
    },
    Engine {
        name: "gltf",
        title: "glTF 2.0",
        green: GreenSign::PlusY,
        textures: &[
            png(Color, "_basecolor", "baseColorTexture"),
            png(Normal, "_normal", "normalTexture"),
            png(ORM, "_orm", "occlusionTexture and metallicRoughnessTexture"),
            png(Height(Convention::Height), "_height", "none: a program beside it displaces").of_16_bits(),
            png(Emission, "_emissive", "emissiveTexture"),
        ],
        height: HeightUse::Nothing,
        settings: &[],
        plane_cells: Some(1),
        sources: &["https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html"],
    },
];
