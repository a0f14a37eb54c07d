//! A picture by an exported shader, on a device that takes SPIR-V as it is.

use std::borrow::Cow;
use std::collections::BTreeMap;

use relief_export::{Exported, File};
use relief_render::block_on;
use relief_render::gpu::Gpu;
use relief_render::job::Job;
use relief_render::wgpu::{
    self, ShaderModule, ShaderModuleDescriptor, ShaderSource, TextureFormat, TextureUsages,
};
use serde_json::Value as Json;

use super::bound::{Resource, layout, resource};
use crate::compilers::{GLSLANG, run};

/// A shading language in which a program may take an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// As it is.
    Wgsl,
    /// As it is.
    Spirv,
    /// Compiled to SPIR-V by somebody else's compiler.
    Glsl,
    /// The same.
    Hlsl,
}

impl Language {
    fn target(self) -> &'static str {
        match self {
            Language::Wgsl => "wgsl",
            Language::Spirv => "spirv",
            Language::Glsl => "glsl",
            Language::Hlsl => "hlsl",
        }
    }
}

/// A software device of the tests' own.
pub struct Device {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
}

impl Device {
    /// One that takes SPIR-V; none where there is no software adapter.
    pub fn open() -> Option<Self> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            backends: wgpu::Backends::VULKAN,
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        let adapters = block_on(instance.enumerate_adapters(wgpu::Backends::VULKAN));
        let is_software = |adapter: &wgpu::Adapter| adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let adapter = adapters.into_iter().find(is_software)?;
        let descriptor = wgpu::DeviceDescriptor {
            required_features: adapter.features() & wgpu::Features::PASSTHROUGH_SHADERS,
            ..Default::default()
        };
        let (device, queue) = block_on(adapter.request_device(&descriptor)).ok()?;
        Some(Self { device, queue })
    }

    /// The same for the project's own renderer.
    pub fn gpu(&self) -> Gpu {
        Gpu::of_device(self.device.clone(), self.queue.clone(), "the tests' own")
    }

    pub(super) fn wgsl(&self, bytes: &[u8]) -> ShaderModule {
        let source = ShaderSource::Wgsl(String::from_utf8_lossy(bytes).into_owned().into());
        self.device.create_shader_module(ShaderModuleDescriptor { label: None, source })
    }

    pub(super) fn spirv(&self, bytes: &[u8], entry: &str) -> ShaderModule {
        let word = |four: &[u8]| u32::from_le_bytes([four[0], four[1], four[2], four[3]]);
        let words: Vec<u32> = bytes.chunks_exact(4).map(word).collect();
        let name = Cow::Borrowed(entry);
        let entry_point = wgpu::PassthroughShaderEntryPoint { name, workgroup_size: (0, 0, 0) };
        let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
            entry_points: Cow::Owned(vec![entry_point]),
            spirv: Some(Cow::Owned(words)),
            ..Default::default()
        };
        // SAFETY: a compiler wrote the words, and `spirv-val` accepts them.
        #[allow(unsafe_code)]
        unsafe {
            self.device.create_shader_module_passthrough(descriptor)
        }
    }
}

/// SPIR-V of a stage of a file in another language.
fn compiled(file: &File, stage: &str, entry: &str, language: Language) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut text = String::from_utf8_lossy(&file.bytes).into_owned();
    if language == Language::Glsl {
        // OpenGL's textures have samplers, which the device has not where texels alone are loaded; and
        // Vulkan's GLSL counts vertices under other names.
        text = text.replacen('\n', "\n#extension GL_EXT_samplerless_texture_functions : require\n", 1);
        text = text.replace("uniform sampler2D", "uniform texture2D");
        text = text.replace("gl_VertexID", "gl_VertexIndex").replace("gl_InstanceID", "gl_InstanceIndex");
    }
    std::fs::write(folder.path().join(&file.name), text).expect("the folder is writable");
    let short = if stage == "vertex" { "vert" } else { "frag" };
    let mut arguments = vec!["-V", "-S", short, "-o", "out.spv"];
    if language == Language::Hlsl {
        arguments.extend(["-D", "-e", entry]);
    }
    arguments.push(&file.name);
    run(folder.path(), GLSLANG, arguments).unwrap_or_else(|error| panic!("{}: {error}", file.name));
    std::fs::read(folder.path().join("out.spv")).expect("it was compiled")
}

/// A stage's module and its entry point.
fn stage(
    device: &Device,
    exported: &Exported,
    files: &Json,
    name: &str,
    language: Language,
) -> (ShaderModule, String) {
    let files = files.as_array().expect("files").iter();
    let mut entries = files.flat_map(|file| {
        let entries = file["entry_points"].as_array().expect("entry points");
        entries.iter().map(move |entry| (file, entry))
    });
    let (file, entry) = entries.find(|(_, entry)| entry["stage"] == name).expect("the stage");
    let entry = entry["name"].as_str().expect("a name");
    let file = exported.files.iter().find(|written| file["file"] == written.name.as_str()).expect("the file");
    let module = match language {
        Language::Wgsl => device.wgsl(&file.bytes),
        Language::Spirv => device.spirv(&file.bytes, entry),
        Language::Glsl | Language::Hlsl => device.spirv(&compiled(file, name, entry, language), entry),
    };
    (module, entry.to_owned())
}

/// Group and number of a binding of a file.
fn place(binding: &Json) -> (u32, u32) {
    let number = |key: &str| binding[key].as_u64().map(|number| number as u32);
    match binding["register"].as_str() {
        Some(register) => (number("space").expect("a space"), register[1..].parse().expect("a register")),
        None => {
            let group = number("group").or(number("set")).unwrap_or(0);
            (group, number("binding").expect("a number"))
        }
    }
}

/// The linear colours of a job's picture, row by row, by an export of its only surface, whose manifest is its
/// last file.
///
/// # Panics
///
/// When the manifest does not suffice.
pub fn draw(device: &Device, exported: &Exported, job: &Job, language: Language) -> Vec<[f32; 4]> {
    let manifest = exported.files.last().expect("a manifest");
    let manifest: Json = serde_json::from_slice(&manifest.bytes).expect("JSON");
    let targets = manifest["targets"].as_array().expect("targets");
    let target = targets.iter().find(|target| target["target"] == language.target()).expect("the target");
    let Device { device: gpu, queue } = device;
    let mut groups: BTreeMap<u32, BTreeMap<u32, &Json>> = BTreeMap::new();
    for file in target["files"].as_array().expect("files") {
        for here in file["bindings"].as_array().expect("bindings") {
            let (group, number) = place(here);
            let bindings = manifest["bindings"].as_array().expect("bindings");
            let binding = bindings.iter().find(|binding| binding["name"] == here["name"]);
            groups.entry(group).or_default().insert(number, binding.expect("the binding"));
        }
    }
    let mut layouts = Vec::new();
    let mut bound = Vec::new();
    for group in 0..=groups.keys().copied().max().unwrap_or(0) {
        let bindings = groups.get(&group);
        let bindings: Vec<_> = bindings.into_iter().flatten().collect();
        let entries: Vec<_> = bindings.iter().map(|(number, binding)| layout(binding, **number)).collect();
        let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries };
        let layout = gpu.create_bind_group_layout(&descriptor);
        let made: Vec<(u32, Resource)> = bindings
            .iter()
            .map(|(number, binding)| (**number, resource(gpu, queue, &manifest, binding, job)))
            .collect();
        let entries: Vec<_> = made
            .iter()
            .map(|(binding, resource)| wgpu::BindGroupEntry {
                binding: *binding,
                resource: match resource {
                    Resource::Buffer(buffer) => buffer.as_entire_binding(),
                    Resource::View(view) => wgpu::BindingResource::TextureView(view),
                },
            })
            .collect();
        let descriptor = wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries };
        bound.push(gpu.create_bind_group(&descriptor));
        layouts.push(layout);
    }
    let how = &manifest["draw"];
    let is_two_sided = job.surfaces[0].two_sided;
    let cull = match how["cull"].as_str().expect("faces") {
        "front" => Some(wgpu::Face::Front),
        _ => (!is_two_sided).then_some(wgpu::Face::Back),
    };
    let pipeline = pipeline(device, exported, &target["files"], &layouts, cull, language);
    let per_triangle = how["vertices_per_triangle"].as_u64().expect("a number") as u32;
    let vertices = per_triangle * job.surfaces[0].triangles.len() as u32;
    let has_backs = is_two_sided && how["instances"].as_str().expect("instances").ends_with('2');
    picture(device, &pipeline, &bound, [vertices, 1 + u32::from(has_backs)], [job.width, job.height])
}

fn pipeline(
    device: &Device,
    exported: &Exported,
    files: &Json,
    layouts: &[wgpu::BindGroupLayout],
    cull_mode: Option<wgpu::Face>,
    language: Language,
) -> wgpu::RenderPipeline {
    let layouts: Vec<_> = layouts.iter().map(Some).collect();
    let layout = device.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &layouts,
        immediate_size: 0,
    });
    let [vertex, fragment] =
        ["vertex", "fragment"].map(|name| stage(device, exported, files, name, language));
    device.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &vertex.0,
            entry_point: Some(&vertex.1),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState { cull_mode, ..Default::default() },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: TextureFormat::Depth32Float,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &fragment.0,
            entry_point: Some(&fragment.1),
            compilation_options: Default::default(),
            targets: &[Some(TextureFormat::Rgba32Float.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Draws the given numbers of vertices and instances, and reads the colours back.
pub(super) fn picture(
    Device { device, queue }: &Device,
    pipeline: &wgpu::RenderPipeline,
    bound: &[wgpu::BindGroup],
    [vertices, instances]: [u32; 2],
    [width, height]: [u32; 2],
) -> Vec<[f32; 4]> {
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let target = |format, usage| {
        device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: TextureUsages::RENDER_ATTACHMENT | usage,
            view_formats: &[],
        })
    };
    let color = target(TextureFormat::Rgba32Float, TextureUsages::COPY_SRC);
    let depth = target(TextureFormat::Depth32Float, TextureUsages::empty());
    let (view, depth) = (color.create_view(&Default::default()), depth.create_view(&Default::default()));
    let bytes_per_row = (16 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let readable = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(bytes_per_row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let cleared = |load| wgpu::Operations { load, store: wgpu::StoreOp::Store };
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: None,
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: cleared(wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT)),
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &depth,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    pass.set_pipeline(pipeline);
    for (number, group) in (0..).zip(bound) {
        pass.set_bind_group(number, group, &[]);
    }
    pass.draw(0..vertices, 0..instances);
    drop(pass);
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(bytes_per_row), rows_per_image: None };
    let copied = wgpu::TexelCopyBufferInfo { buffer: &readable, layout };
    encoder.copy_texture_to_buffer(color.as_image_copy(), copied, size);
    queue.submit([encoder.finish()]);
    readable.map_async(wgpu::MapMode::Read, .., |mapped| mapped.expect("the picture is readable"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("the device works");
    let mapped = readable.get_mapped_range(..).expect("the picture is mapped");
    let number = |four: &[u8]| f32::from_le_bytes([four[0], four[1], four[2], four[3]]);
    let row = |row: &[u8]| -> Vec<[f32; 4]> {
        let pixels = row[..16 * width as usize].chunks_exact(16);
        pixels.map(|pixel| [0, 4, 8, 12].map(|at| number(&pixel[at..at + 4]))).collect()
    };
    mapped.chunks_exact(bytes_per_row as usize).flat_map(row).collect()
}
