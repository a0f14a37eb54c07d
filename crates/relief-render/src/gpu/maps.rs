//! Settings and maps on the GPU: bind group 0 of every program.

use relief_shaders::cpu::Settings;
use wgpu::{
    AddressMode, BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingResource, BindingType, BufferBindingType, BufferUsages, Extent3d,
    FilterMode, SamplerBindingType, SamplerDescriptor, ShaderStages, TexelCopyBufferLayout,
    TexelCopyTextureInfo, TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType,
    TextureUsages, TextureView, TextureViewDescriptor, TextureViewDimension,
};

use super::device::STAGING_BYTES;
use super::{Gpu, GpuError, Sampling};
use crate::job::{Job, TexelMap};

/// One entry of a layout, not an array.
pub(super) fn binding(number: u32, visibility: ShaderStages, ty: BindingType) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry { binding: number, visibility, ty, count: None }
}

pub(super) fn buffer_binding(ty: BufferBindingType) -> BindingType {
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

pub(super) fn texture_binding(sample_type: TextureSampleType) -> BindingType {
    BindingType::Texture { sample_type, view_dimension: TextureViewDimension::D2, multisampled: false }
}

/// The layout of group 0.
pub(super) fn layout(gpu: &Gpu, sampling: Sampling) -> BindGroupLayout {
    let stages = ShaderStages::FRAGMENT | ShaderStages::COMPUTE;
    let fast = sampling == Sampling::Fast;
    let map = texture_binding(TextureSampleType::Float { filterable: fast });
    let mut entries = vec![binding(0, stages, buffer_binding(BufferBindingType::Uniform))];
    entries.extend((1..=3).map(|number| binding(number, stages, map)));
    if fast {
        entries.push(binding(4, stages, BindingType::Sampler(SamplerBindingType::Filtering)));
    }
    // Loaded, never sampled.
    entries.push(binding(5, stages, texture_binding(TextureSampleType::Float { filterable: false })));
    gpu.device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some("maps"), entries: &entries })
}

/// Uploads a job's settings and maps.
pub(super) fn upload(
    gpu: &Gpu,
    job: &Job,
    layout: &BindGroupLayout,
    sampling: Sampling,
) -> Result<BindGroup, GpuError> {
    let settings = gpu.filled("settings", &[job.settings], BufferUsages::UNIFORM)?;
    let map = job.height_map;
    let texels = bytemuck::cast_slice(map.texels());
    let height = texture(gpu, "height map", map.width(), map.height(), TextureFormat::R32Float, texels)?;
    let color = colors(gpu, "colour map", job.color_map_or_blank())?;
    let normal = colors(gpu, "normal map", job.normal_map_or_blank())?;
    let search = colors(gpu, "search's map", job.search_map_or_blank())?;
    let sampler = (sampling == Sampling::Fast).then(|| sampler(gpu, &job.settings));
    let mut entries = vec![BindGroupEntry { binding: 0, resource: settings.as_entire_binding() }];
    for (number, view) in [(1, &height), (2, &color), (3, &normal), (5, &search)] {
        entries.push(BindGroupEntry { binding: number, resource: BindingResource::TextureView(view) });
    }
    if let Some(sampler) = &sampler {
        entries.push(BindGroupEntry { binding: 4, resource: BindingResource::Sampler(sampler) });
    }
    Ok(gpu.device.create_bind_group(&BindGroupDescriptor { label: Some("maps"), layout, entries: &entries }))
}

/// Refuses a job whose maps cannot be uploaded.
pub(super) fn check(gpu: &Gpu, job: &Job) -> Result<(), GpuError> {
    gpu.check_texture("height map", job.height_map.width(), job.height_map.height())?;
    let maps =
        [("colour map", job.color_map), ("normal map", job.normal_map), ("search's map", job.search_map)];
    for (what, map) in maps {
        let Some(TexelMap { width, height, texels }) = map else {
            continue;
        };
        if texels.is_empty() || texels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(GpuError::WrongLength { what, width, height, given: texels.len() });
        }
        gpu.check_texture(what, width, height)?;
    }
    Ok(())
}

fn colors(gpu: &Gpu, label: &str, map: TexelMap) -> Result<TextureView, GpuError> {
    let texels = bytemuck::cast_slice(map.texels);
    texture(gpu, label, map.width, map.height, TextureFormat::Rgba32Float, texels)
}

/// A texture of whole rows of texels, uploaded some rows at a time.
fn texture(
    gpu: &Gpu,
    label: &str,
    width: u32,
    height: u32,
    format: TextureFormat,
    texels: &[u8],
) -> Result<TextureView, GpuError> {
    let texture = gpu.device.create_texture(&TextureDescriptor {
        label: Some(label),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let row_bytes = texels.len() / height as usize;
    let rows = (STAGING_BYTES / row_bytes).max(1);
    for (number, chunk) in texels.chunks(rows * row_bytes).enumerate() {
        if number > 0 {
            gpu.flush()?;
        }
        let mut target = TexelCopyTextureInfo::from(texture.as_image_copy());
        target.origin.y = (number * rows) as u32;
        let from =
            TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes as u32), rows_per_image: None };
        let size = Extent3d { width, height: (chunk.len() / row_bytes) as u32, depth_or_array_layers: 1 };
        gpu.queue.write_texture(target, chunk, from, size);
    }
    Ok(texture.create_view(&TextureViewDescriptor::default()))
}

/// The sampler of fast sampling, which continues maps as their wrap says.
fn sampler(gpu: &Gpu, settings: &Settings) -> wgpu::Sampler {
    let mode = match settings.wrap {
        1 => AddressMode::ClampToEdge,
        2 => AddressMode::MirrorRepeat,
        _ => AddressMode::Repeat,
    };
    gpu.device.create_sampler(&SamplerDescriptor {
        label: Some("maps"),
        address_mode_u: mode,
        address_mode_v: mode,
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    })
}
