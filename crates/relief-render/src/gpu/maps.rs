//! Settings and maps on the GPU: bind group 0 of every program.

use relief_core::{BakedMap, MapTexels};
use relief_shaders::MapSlot;
use relief_shaders::cpu::Settings;
use wgpu::{
    AddressMode, BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingResource, BindingType, BufferBindingType, BufferUsages, Extent3d,
    FilterMode, SamplerBindingType, SamplerDescriptor, ShaderStages, TexelCopyBufferLayout,
    TexelCopyTextureInfo, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType,
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

fn array_binding(sample_type: TextureSampleType) -> BindingType {
    BindingType::Texture { sample_type, view_dimension: TextureViewDimension::D2Array, multisampled: false }
}

/// The layout of group 0.
pub(super) fn layout(gpu: &Gpu, sampling: Sampling) -> BindGroupLayout {
    let stages = ShaderStages::FRAGMENT | ShaderStages::COMPUTE;
    let fast = sampling == Sampling::Fast;
    let sampled = TextureSampleType::Float { filterable: fast };
    let mut entries = vec![binding(0, stages, buffer_binding(BufferBindingType::Uniform))];
    entries.extend((1..=2).map(|number| binding(number, stages, texture_binding(sampled))));
    entries.push(binding(3, stages, array_binding(sampled)));
    if fast {
        entries.push(binding(4, stages, BindingType::Sampler(SamplerBindingType::Filtering)));
    }
    // Loaded, never sampled.
    let loaded = array_binding(TextureSampleType::Float { filterable: false });
    entries.extend(MapSlot::ALL.map(|slot| binding(slot.binding(), stages, loaded)));
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
    let height = flat(gpu, "height map", [map.width(), map.height()], TextureFormat::R32Float, texels)?;
    let height = height.create_view(&TextureViewDescriptor::default());
    let color =
        colors(gpu, "colour map", job.color_map_or_blank())?.create_view(&TextureViewDescriptor::default());
    let normal = array_view(&colors(gpu, "normal map", job.normal_map_or_blank())?);
    let sampler = (sampling == Sampling::Fast).then(|| sampler(gpu, &job.settings));
    let mut entries = vec![BindGroupEntry { binding: 0, resource: settings.as_entire_binding() }];
    for (number, view) in [(1, &height), (2, &color), (3, &normal)] {
        entries.push(BindGroupEntry { binding: number, resource: BindingResource::TextureView(view) });
    }
    let mut slots = Vec::new();
    for slot in MapSlot::ALL {
        slots.push((slot.binding(), array_view(&baked(gpu, slot, job.maps.get(slot))?)));
    }
    for (number, view) in &slots {
        entries.push(BindGroupEntry { binding: *number, resource: BindingResource::TextureView(view) });
    }
    if let Some(sampler) = &sampler {
        entries.push(BindGroupEntry { binding: 4, resource: BindingResource::Sampler(sampler) });
    }
    Ok(gpu.device.create_bind_group(&BindGroupDescriptor { label: Some("maps"), layout, entries: &entries }))
}

/// Refuses a job whose maps cannot be uploaded.
pub(super) fn check(gpu: &Gpu, job: &Job) -> Result<(), GpuError> {
    gpu.check_texture("height map", job.height_map.width(), job.height_map.height())?;
    for (what, map) in [("colour map", job.color_map), ("normal map", job.normal_map)] {
        let Some(TexelMap { width, height, texels }) = map else {
            continue;
        };
        if texels.is_empty() || texels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(GpuError::WrongLength { what, width, height, given: texels.len() });
        }
        gpu.check_texture(what, width, height)?;
    }
    for map in MapSlot::ALL.into_iter().filter_map(|slot| job.maps.get(slot)) {
        let [width, height] = map.layout().size;
        gpu.check_texture("baked map", width, height)?;
    }
    Ok(())
}

fn colors(gpu: &Gpu, label: &str, map: TexelMap) -> Result<Texture, GpuError> {
    let texels = bytemuck::cast_slice(map.texels);
    flat(gpu, label, [map.width, map.height], TextureFormat::Rgba32Float, texels)
}

/// A texture of one layer and level.
fn flat(
    gpu: &Gpu,
    label: &str,
    size: [u32; 2],
    format: TextureFormat,
    texels: &[u8],
) -> Result<Texture, GpuError> {
    let texture = texture(gpu, label, size, [1, 1], format);
    upload_level(gpu, &texture, 0, size, texels)?;
    Ok(texture)
}

/// The texture of a baked map; without one a single texel.
fn baked(gpu: &Gpu, slot: MapSlot, map: Option<&BakedMap>) -> Result<Texture, GpuError> {
    let Some(map) = map else {
        return flat(gpu, slot.name(), [1, 1], TextureFormat::R32Float, &[0; 4]);
    };
    let layout = map.layout();
    let (texels, format): (&[u8], TextureFormat) = match (map.texels(), layout.channels) {
        (MapTexels::F32(values), 1) => (bytemuck::cast_slice(values), TextureFormat::R32Float),
        (MapTexels::F32(values), 2) => (bytemuck::cast_slice(values), TextureFormat::Rg32Float),
        (MapTexels::F32(values), _) => (bytemuck::cast_slice(values), TextureFormat::Rgba32Float),
        (MapTexels::F16(values), 1) => (bytemuck::cast_slice(values), TextureFormat::R16Float),
        (MapTexels::F16(values), 2) => (bytemuck::cast_slice(values), TextureFormat::Rg16Float),
        (MapTexels::F16(values), _) => (bytemuck::cast_slice(values), TextureFormat::Rgba16Float),
        (MapTexels::Unorm8(values), 1) => (values, TextureFormat::R8Unorm),
        (MapTexels::Unorm8(values), 2) => (values, TextureFormat::Rg8Unorm),
        (MapTexels::Unorm8(values), _) => (values, TextureFormat::Rgba8Unorm),
    };
    let texture = texture(gpu, slot.name(), layout.size, [layout.layers, layout.levels], format);
    let bytes = layout.channels as usize * layout.format.bytes() as usize;
    for (level, place) in map.places().iter().enumerate() {
        let end = place.start + place.width * place.height * layout.layers as usize;
        let size = layout.level_size(level as u32);
        upload_level(gpu, &texture, level as u32, size, &texels[place.start * bytes..end * bytes])?;
    }
    Ok(texture)
}

fn array_view(texture: &Texture) -> TextureView {
    let dimension = Some(TextureViewDimension::D2Array);
    texture.create_view(&TextureViewDescriptor { dimension, ..Default::default() })
}

fn texture(
    gpu: &Gpu,
    label: &str,
    [width, height]: [u32; 2],
    [layers, levels]: [u32; 2],
    format: TextureFormat,
) -> Texture {
    gpu.device.create_texture(&TextureDescriptor {
        label: Some(label),
        size: Extent3d { width, height, depth_or_array_layers: layers },
        mip_level_count: levels,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

/// Uploads all layers of a level, row by row, some rows at a time.
fn upload_level(
    gpu: &Gpu,
    texture: &Texture,
    level: u32,
    [width, height]: [u32; 2],
    texels: &[u8],
) -> Result<(), GpuError> {
    let layers = texture.depth_or_array_layers();
    let row_bytes = texels.len() / (height as usize * layers as usize);
    let rows = (STAGING_BYTES / row_bytes).max(1);
    let mut waiting = 0;
    for (layer, texels) in texels.chunks(row_bytes * height as usize).enumerate() {
        for (number, chunk) in texels.chunks(rows * row_bytes).enumerate() {
            if waiting > 0 && waiting + chunk.len() > STAGING_BYTES {
                gpu.flush()?;
                waiting = 0;
            }
            waiting += chunk.len();
            let mut target = TexelCopyTextureInfo::from(texture.as_image_copy());
            target.mip_level = level;
            (target.origin.y, target.origin.z) = ((number * rows) as u32, layer as u32);
            let from = TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row_bytes as u32),
                rows_per_image: None,
            };
            let size = Extent3d { width, height: (chunk.len() / row_bytes) as u32, depth_or_array_layers: 1 };
            gpu.queue.write_texture(target, chunk, from, size);
        }
    }
    Ok(())
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
