//! Bind group layouts, from the shaders' table of bindings.

use relief_shaders::bindings::{BINDINGS, Binding, BindingKind};
use relief_shaders::wgsl::Sampling;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingResource, BindingType, BufferBindingType, Device, SamplerBindingType,
    ShaderStages, StorageTextureAccess, TextureFormat, TextureSampleType, TextureViewDimension,
};

/// Format of pictures that stay on the GPU: linear colours.
pub const PICTURE: TextureFormat = TextureFormat::Rgba16Float;

/// Variables with a separate piece for each pass, in the order of their bindings.
const PER_PASS: [&str; 2] = ["frame", "pass_settings"];

/// Creates the layout of bindings of one group. With exact sampling there is no sampler.
pub fn layout(device: &Device, label: &str, bindings: &[&Binding], sampling: Sampling) -> BindGroupLayout {
    let entries: Vec<BindGroupLayoutEntry> =
        bindings.iter().filter_map(|binding| entry(binding, sampling)).collect();
    device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
}

/// Returns the bindings of group 0, which every program has.
pub fn shared() -> Vec<&'static Binding> {
    BINDINGS.iter().filter(|binding| binding.group == 0).collect()
}

/// Returns the bindings with the given names.
pub fn named(names: &[&str]) -> Vec<&'static Binding> {
    names.iter().filter_map(|name| Binding::named(name)).collect()
}

fn entry(binding: &Binding, sampling: Sampling) -> Option<BindGroupLayoutEntry> {
    let pixels = ShaderStages::FRAGMENT | ShaderStages::COMPUTE;
    let every = ShaderStages::VERTEX_FRAGMENT | ShaderStages::COMPUTE;
    let fast = sampling == Sampling::Fast;
    let texture = |sample_type, layers: bool| BindingType::Texture {
        sample_type,
        view_dimension: if layers { TextureViewDimension::D2Array } else { TextureViewDimension::D2 },
        multisampled: false,
    };
    let has_dynamic_offset = PER_PASS.contains(&binding.name);
    let buffer = |ty| BindingType::Buffer { ty, has_dynamic_offset, min_binding_size: None };
    let (visibility, ty) = match binding.kind {
        BindingKind::Uniform(_) => (every, buffer(BufferBindingType::Uniform)),
        BindingKind::Storage { read_only: true, .. } => {
            (every, buffer(BufferBindingType::Storage { read_only: true }))
        }
        BindingKind::Storage { read_only: false, .. } => {
            (ShaderStages::COMPUTE, buffer(BufferBindingType::Storage { read_only: false }))
        }
        BindingKind::Texture { layers, filtered } => {
            (pixels, texture(TextureSampleType::Float { filterable: fast && filtered }, layers))
        }
        BindingKind::IntegerTexture => (pixels, texture(TextureSampleType::Sint, false)),
        BindingKind::Sampler if fast => (pixels, BindingType::Sampler(SamplerBindingType::Filtering)),
        BindingKind::Sampler => return None,
        BindingKind::Picture => {
            let ty = BindingType::StorageTexture {
                access: StorageTextureAccess::WriteOnly,
                format: PICTURE,
                view_dimension: TextureViewDimension::D2,
            };
            (ShaderStages::COMPUTE, ty)
        }
    };
    Some(BindGroupLayoutEntry { binding: binding.number, visibility, ty, count: None })
}

/// Creates a bind group from pairs of variable and resource.
pub fn group(
    device: &Device,
    label: &str,
    layout: &BindGroupLayout,
    bound: &[(&str, BindingResource)],
) -> BindGroup {
    let entries: Vec<BindGroupEntry> = bound
        .iter()
        .filter_map(|(name, resource)| {
            let binding = Binding::named(name)?.number;
            Some(BindGroupEntry { binding, resource: resource.clone() })
        })
        .collect();
    device.create_bind_group(&BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}
