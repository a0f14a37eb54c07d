//! Relief on Bevy's `StandardMaterial`: silhouettes, depth, and shadows that are cast and received.
//!
//! Copy this file and `relief_functions.rs` beside your `main.rs`, and the other files to your assets.
//!
//! SPDX-License-Identifier: MIT OR Apache-2.0

use bevy::gltf::GltfPlugin;
use bevy::mesh::{MeshVertexAttribute, MeshVertexBufferLayoutRef, VertexFormat};
use bevy::pbr::{ExtendedMaterial, MaterialExtension, MaterialExtensionKey, MaterialExtensionPipeline};
use bevy::prelude::*;
use bevy::render::render_resource::{RenderPipelineDescriptor, SpecializedMeshPipelineError};
use bevy::shader::ShaderRef;

pub use crate::relief_functions::{Relief, ReliefSettings};
use crate::relief_functions::{HAS_CURVATURE, HAS_LIGHT, HAS_SIZE};

/// A `StandardMaterial` with a relief on it. Of the base it takes colour, metal, roughness, occlusion,
/// emission and `unlit`, as numbers and as textures; it is drawn forward, front faces alone.
pub type ReliefMaterial = ExtendedMaterial<StandardMaterial, Relief>;

/// The material's shader among the assets. It imports `relief.wesl`.
const SHADER: &str = "relief_material.wesl";

/// The lengths of a tile of the height map along u and along v at a vertex: `_TILE` in glTF.
pub const ATTRIBUTE_TILE: MeshVertexAttribute =
    MeshVertexAttribute::new("ReliefTile", 2_204_761_931, VertexFormat::Float32x2);

/// The curvature of the mesh at a vertex: `_CURVATURE` in glTF.
pub const ATTRIBUTE_CURVATURE: MeshVertexAttribute =
    MeshVertexAttribute::new("ReliefCurvature", 2_204_761_932, VertexFormat::Float32x3);

/// The relief's material. Meshes from glTF keep their frames with [`gltf_plugin`].
pub struct ReliefPlugin;

impl Plugin for ReliefPlugin {
    fn build(&self, app: &mut App) {
        app.add_plugins(MaterialPlugin::<ReliefMaterial>::default());
    }
}

/// The reader of glTF, with the attributes of the meshes that `relief engine` writes:
/// `DefaultPlugins.set(gltf_plugin())`.
pub fn gltf_plugin() -> GltfPlugin {
    // glTF's first underscore is not part of the name here.
    GltfPlugin::default()
        .add_custom_vertex_attribute("TILE", ATTRIBUTE_TILE)
        .add_custom_vertex_attribute("CURVATURE", ATTRIBUTE_CURVATURE)
}

impl MaterialExtension for Relief {
    fn vertex_shader() -> ShaderRef {
        SHADER.into()
    }

    fn fragment_shader() -> ShaderRef {
        SHADER.into()
    }

    fn prepass_vertex_shader() -> ShaderRef {
        SHADER.into()
    }

    fn prepass_fragment_shader() -> ShaderRef {
        SHADER.into()
    }

    // Shadow maps run fragment shaders of masked materials alone.
    fn alpha_mode() -> Option<AlphaMode> {
        Some(AlphaMode::Mask(0.5))
    }

    fn specialize(
        _: &MaterialExtensionPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        layout: &MeshVertexBufferLayoutRef,
        _: MaterialExtensionKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        let mut attributes = vec![
            Mesh::ATTRIBUTE_POSITION.at_shader_location(0),
            Mesh::ATTRIBUTE_NORMAL.at_shader_location(1),
            Mesh::ATTRIBUTE_UV_0.at_shader_location(2),
        ];
        let frames = [Mesh::ATTRIBUTE_TANGENT, ATTRIBUTE_TILE, ATTRIBUTE_CURVATURE];
        let has_frames = frames.iter().all(|attribute| layout.0.contains(attribute.id));
        if has_frames {
            attributes.extend((3..).zip(frames).map(|(place, of)| of.at_shader_location(place)));
        }
        descriptor.vertex.buffers = vec![layout.0.get_layout(&attributes)?];
        let given = [
            ("RELIEF_FRAMES", has_frames),
            ("RELIEF_CURVATURE", HAS_CURVATURE),
            ("RELIEF_LIGHT", HAS_LIGHT),
            ("RELIEF_SIZE", HAS_SIZE),
        ];
        let names = || given.iter().filter(|(_, is_given)| *is_given).map(|(name, _)| (*name).into());
        descriptor.vertex.shader_defs.extend(names());
        if let Some(fragment) = &mut descriptor.fragment {
            fragment.shader_defs.extend(names());
        }
        Ok(())
    }
}
