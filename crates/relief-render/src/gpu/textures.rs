//! Upload of maps to textures.

use std::borrow::Cow;

use relief_core::area_mean::coarser_size;
use relief_core::encoding::half;
use relief_core::{BakedMap, HeightMap, MapTexels, Rounding, TexelMask, Wrap};
use relief_shaders::MapSlot;
use relief_shaders::wgsl::Sampling;
use wgpu::{
    AddressMode, Extent3d, FilterMode, Sampler, SamplerDescriptor, TexelCopyBufferLayout,
    TexelCopyTextureInfo, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};

use super::{Gpu, GpuError};
use crate::mipmaps::Mipmaps;

/// Bytes that are handed to the driver at once, and the size of its staging memory. With smaller
/// uploads the CPU waits more often.
pub const STAGING_BYTES: usize = 16 << 20;

/// Format of the maps that fast sampling filters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 32-bit floats, unchanged.
    F32,
    /// 16-bit floats, which every GPU can filter.
    F16,
}

impl Precision {
    /// Returns the precision of maps for a sampling.
    pub fn of(gpu: &Gpu, sampling: Sampling) -> Self {
        if sampling == Sampling::Fast && !gpu.filters_f32() { Precision::F16 } else { Precision::F32 }
    }
}

/// Uploads a height map with a number of its mip levels.
pub fn heights(
    gpu: &Gpu,
    map: &HeightMap,
    levels: u32,
    precision: Precision,
) -> Result<TextureView, GpuError> {
    let size = [map.width(), map.height()];
    gpu.check_texture("height map", size)?;
    let format = match precision {
        Precision::F32 => TextureFormat::R32Float,
        Precision::F16 => TextureFormat::R16Float,
    };
    let texture = texture(gpu, "height map", size, [1, levels], format);
    upload_level(gpu, &texture, 0, size, &stored(map.texels(), precision))?;
    for (level, map) in (1..levels).zip(if levels > 1 { map.coarser() } else { &[] }) {
        upload_level(gpu, &texture, level, [map.width(), map.height()], &stored(map.texels(), precision))?;
    }
    Ok(view(&texture, false))
}

/// Uploads the holes of a map, a byte a texel; a single texel if there are none.
pub fn holes(gpu: &Gpu, holes: Option<&TexelMask>) -> Result<TextureView, GpuError> {
    let size = holes.map_or([1, 1], |holes| [holes.width(), holes.height()]);
    gpu.check_texture("holes", size)?;
    let mut texels = Vec::new();
    let count = size[0] as usize * size[1] as usize;
    texels.try_reserve_exact(count).map_err(|_| GpuError::OutOfMemory)?;
    let places = (0..size[1]).flat_map(|row| (0..size[0]).map(move |column| (column, row)));
    texels.extend(places.map(|(column, row)| {
        if holes.is_some_and(|holes| holes.contains(column, row)) { u8::MAX } else { 0 }
    }));
    Ok(view(&flat(gpu, "holes", size, TextureFormat::R8Unorm, &texels)?, false))
}

/// Uploads a colour or normal map with its levels; a single texel if there is none.
pub fn picture(
    gpu: &Gpu,
    what: &'static str,
    picture: Option<&Mipmaps>,
    precision: Precision,
    layers: bool,
) -> Result<TextureView, GpuError> {
    const BLANK: &[[f32; 4]] = &[[0.0; 4]];
    let (size, all, levels, texels) = match picture {
        Some(levels) => (levels.size(), levels.layers(), levels.levels(), levels.finest()),
        None => ([1, 1], 1, 1, BLANK),
    };
    let [width, height] = size;
    let area = u64::from(width) * u64::from(height);
    // The finest level may have a single layer, if no other is ever read.
    let finest = [1, all].into_iter().find(|layers| texels.len() as u64 == area * *layers as u64);
    if texels.is_empty() || finest.is_none() {
        return Err(GpuError::WrongLength { what, width, height, given: texels.len() });
    }
    gpu.check_texture(what, size)?;
    let format = match precision {
        Precision::F32 => TextureFormat::Rgba32Float,
        Precision::F16 => TextureFormat::Rgba16Float,
    };
    let texture = texture(gpu, what, size, [all as u32, levels], format);
    upload_level(gpu, &texture, 0, size, &stored(texels.as_flattened(), precision))?;
    let (mut size, mut rest) = (size, picture.map_or(&[][..], Mipmaps::coarser));
    for level in 1..levels {
        size = coarser_size(size);
        let (texels, after) = rest.split_at(size[0] as usize * size[1] as usize * all);
        upload_level(gpu, &texture, level, size, &stored(texels.as_flattened(), precision))?;
        rest = after;
    }
    Ok(view(&texture, layers))
}

/// Uploads the baked map of a slot; a single texel if none is read.
pub fn baked(gpu: &Gpu, slot: MapSlot, map: Option<&BakedMap>) -> Result<TextureView, GpuError> {
    let Some(map) = map else {
        return Ok(view(&flat(gpu, slot.name(), [1, 1], TextureFormat::R32Float, &[0; 4])?, true));
    };
    let layout = map.layout();
    gpu.check_texture("baked map", layout.size)?;
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
    for (level, place) in (0u32..).zip(map.places()) {
        let end = place.start + place.width * place.height * layout.layers as usize;
        let texels = &texels[place.start * bytes..end * bytes];
        upload_level(gpu, &texture, level, layout.level_size(level), texels)?;
    }
    Ok(view(&texture, true))
}

/// Creates the sampler of fast sampling, which continues maps by their wrap.
pub fn sampler(gpu: &Gpu, wrap: Wrap) -> Sampler {
    let mode = match wrap {
        Wrap::Repeat => AddressMode::Repeat,
        Wrap::Clamp => AddressMode::ClampToEdge,
        Wrap::Mirror => AddressMode::MirrorRepeat,
    };
    gpu.device().create_sampler(&SamplerDescriptor {
        label: Some("maps"),
        address_mode_u: mode,
        address_mode_v: mode,
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    })
}

fn stored(values: &[f32], precision: Precision) -> Cow<'_, [u8]> {
    match precision {
        Precision::F32 => Cow::Borrowed(bytemuck::cast_slice(values)),
        Precision::F16 => {
            let bytes = values.iter().flat_map(|value| half::bits(*value, Rounding::Nearest).to_ne_bytes());
            Cow::Owned(bytes.collect())
        }
    }
}

/// Creates and fills a texture of one layer and level.
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

/// Returns the view of all of a texture, as an array of layers or as its only layer.
pub fn view(texture: &Texture, layers: bool) -> TextureView {
    let dimension = if layers { TextureViewDimension::D2Array } else { TextureViewDimension::D2 };
    texture.create_view(&TextureViewDescriptor { dimension: Some(dimension), ..Default::default() })
}

fn texture(
    gpu: &Gpu,
    label: &str,
    [width, height]: [u32; 2],
    [layers, levels]: [u32; 2],
    format: TextureFormat,
) -> Texture {
    gpu.device().create_texture(&TextureDescriptor {
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

/// Uploads the layers of a level from the first on, some rows at a time.
fn upload_level(
    gpu: &Gpu,
    texture: &Texture,
    level: u32,
    [width, height]: [u32; 2],
    texels: &[u8],
) -> Result<(), GpuError> {
    let row_bytes = width as usize * texture.format().block_copy_size(None).unwrap_or(1) as usize;
    let rows = (STAGING_BYTES / row_bytes).max(1);
    let mut waiting = 0;
    for (layer, texels) in texels.chunks(row_bytes * height as usize).enumerate() {
        for (number, chunk) in texels.chunks(rows * row_bytes).enumerate() {
            if waiting > 0 && waiting + chunk.len() > STAGING_BYTES {
                gpu.flush()?;
                waiting = 0;
            }
            waiting += chunk.len();
            gpu.count(chunk.len());
            let mut target = TexelCopyTextureInfo::from(texture.as_image_copy());
            target.mip_level = level;
            (target.origin.y, target.origin.z) = ((number * rows) as u32, layer as u32);
            let from = TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row_bytes as u32),
                rows_per_image: None,
            };
            let size = Extent3d { width, height: (chunk.len() / row_bytes) as u32, depth_or_array_layers: 1 };
            gpu.queue().write_texture(target, chunk, from, size);
        }
    }
    Ok(())
}
