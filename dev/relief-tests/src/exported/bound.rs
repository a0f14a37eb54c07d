//! Buffers and textures for what a manifest binds.

use relief_core::MapTexels;
use relief_render::job::{Job, JobSurface};
use relief_render::mipmaps::Mipmaps;
use relief_render::wgpu::util::{BufferInitDescriptor, DeviceExt, TextureDataOrder};
use relief_render::wgpu::{
    BindGroupLayoutEntry, BindingType, Buffer, BufferBindingType, BufferUsages, Device, Extent3d, Queue,
    ShaderStages, TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};
use relief_shaders::MapSlot;
use serde_json::Value as Json;

use super::values::bytes_of;

/// Something to bind.
pub enum Resource {
    Buffer(Buffer),
    View(TextureView),
}

/// Resource for a binding.
///
/// # Panics
///
/// When the manifest asks for what there is not.
pub fn resource(device: &Device, queue: &Queue, manifest: &Json, binding: &Json, job: &Job) -> Resource {
    let usage = match binding["kind"].as_str() {
        Some("uniform") => BufferUsages::UNIFORM,
        Some("storage") => BufferUsages::STORAGE,
        Some("texture") => return Resource::View(texture(device, queue, binding, job)),
        other => panic!("nothing is {other:?} here"),
    };
    let contents = bytes_of(manifest, binding, job);
    let descriptor = BufferInitDescriptor { label: None, contents: &contents, usage };
    Resource::Buffer(device.create_buffer_init(&descriptor))
}

/// Returns its declaration to the device, under the given number.
///
/// # Panics
///
/// When it is of another kind.
pub fn layout(binding: &Json, number: u32) -> BindGroupLayoutEntry {
    let buffer = |ty| BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let ty = match binding["kind"].as_str() {
        Some("uniform") => buffer(BufferBindingType::Uniform),
        Some("storage") => buffer(BufferBindingType::Storage { read_only: true }),
        Some("texture") => BindingType::Texture {
            sample_type: TextureSampleType::Float { filterable: false },
            view_dimension: dimension(binding),
            multisampled: false,
        },
        other => panic!("nothing is {other:?} here"),
    };
    BindGroupLayoutEntry { binding: number, visibility: ShaderStages::VERTEX_FRAGMENT, ty, count: None }
}

fn dimension(binding: &Json) -> TextureViewDimension {
    match binding["texture"]["dimension"].as_str() {
        Some("2d-array") => TextureViewDimension::D2Array,
        _ => TextureViewDimension::D2,
    }
}

/// The texels of a texture: level by level, and in these layer by layer.
pub struct Texels {
    pub size: [u32; 2],
    pub layers: u32,
    pub levels: u32,
    pub format: TextureFormat,
    pub bytes: Vec<u8>,
}

impl Texels {
    /// Floats of a texel.
    pub fn channels(&self) -> u32 {
        self.format.components().into()
    }
}

/// A single texel of zeros, for what the settings say that there is none of.
fn blank(format: TextureFormat) -> Texels {
    let bytes = vec![0; format.block_copy_size(None).unwrap_or(4) as usize];
    Texels { size: [1, 1], layers: 1, levels: 1, format, bytes }
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn texture(device: &Device, queue: &Queue, binding: &Json, job: &Job) -> TextureView {
    let name = binding["name"].as_str().expect("a name");
    let texels = texels(name, job);
    let known = binding["texture"]["formats"].as_array().expect("formats");
    let format = format!("{:?}", texels.format).to_lowercase();
    assert!(known.iter().any(|known| *known == format), "{name} is {format}, not one of {known:?}");
    view_of(device, queue, &texels, dimension(binding))
}

/// A texture with those texels.
pub fn view_of(
    device: &Device,
    queue: &Queue,
    texels: &Texels,
    dimension: TextureViewDimension,
) -> TextureView {
    let [width, height] = texels.size;
    let descriptor = TextureDescriptor {
        label: None,
        size: Extent3d { width, height, depth_or_array_layers: texels.layers },
        mip_level_count: texels.levels,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: texels.format,
        usage: TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let texture =
        device.create_texture_with_data(queue, &descriptor, TextureDataOrder::MipMajor, &texels.bytes);
    let view = TextureViewDescriptor { dimension: Some(dimension), ..Default::default() };
    texture.create_view(&view)
}

fn texels(name: &str, job: &Job) -> Texels {
    texels_of(name, &job.surfaces[0])
}

/// The texels of a surface's texture of that name.
///
/// # Panics
///
/// When a map is not of 32 bits.
pub fn texels_of(name: &str, surface: &JobSurface) -> Texels {
    let picture = |picture: Option<&Mipmaps>| match picture {
        None => blank(TextureFormat::Rgba32Float),
        Some(levels) => Texels {
            size: levels.size(),
            layers: levels.layers() as u32,
            levels: levels.levels(),
            format: TextureFormat::Rgba32Float,
            bytes: floats([levels.finest(), levels.coarser()].concat().as_flattened()),
        },
    };
    let slot = MapSlot::ALL.into_iter().find(|slot| slot.name() == name);
    let held = surface.maps.iter().find(|(of, _)| Some(*of) == slot);
    match (name, held) {
        ("height_map", _) => {
            let map = &surface.height_map;
            let bytes = floats(map.texels());
            let size = [map.width(), map.height()];
            Texels { size, layers: 1, levels: 1, format: TextureFormat::R32Float, bytes }
        }
        ("color_map", _) => picture(surface.color.as_deref()),
        ("normal_map", _) => picture(surface.normal_map.as_deref()),
        ("material_map", _) => picture(surface.material_maps.as_deref()),
        ("hole_map", _) => blank(TextureFormat::R8Unorm),
        (_, Some((_, map))) => {
            let layout = map.layout();
            let MapTexels::F32(values) = map.texels() else { panic!("maps of 32 bits alone are drawn here") };
            let format = match layout.channels {
                1 => TextureFormat::R32Float,
                2 => TextureFormat::Rg32Float,
                _ => TextureFormat::Rgba32Float,
            };
            let (size, layers, levels) = (layout.size, layout.layers, layout.levels);
            Texels { size, layers, levels, format, bytes: floats(values) }
        }
        _ => blank(TextureFormat::R32Float),
    }
}
