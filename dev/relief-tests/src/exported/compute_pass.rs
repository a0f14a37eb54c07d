//! The compute pass of the tests' own that runs statements over many numbers.

use relief_export::ExportedFunctions;
use relief_render::job::JobSurface;
use relief_render::wgpu::{self, TextureViewDimension, util::DeviceExt};

use super::Device;
use super::bound::{texels_of, view_of};
use super::dialect::{Dialect, GROUP, glsl, hlsl, wgsl, without_derivatives};
use super::include::{self, Include};
use super::numbers::{RESULT, settings_of};
use super::text::{text_of, type_of};
use crate::compilers::{GLSLANG, run};

impl Device {
    /// Runs a body of statements once for each `count` numbers.
    pub(super) fn called(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        body: &str,
        count: usize,
        numbers: &[f32],
        dialect: Dialect,
    ) -> Vec<f32> {
        let Self { device, queue } = self;
        let module = self.module(exported, body, count, dialect);
        let views: Vec<_> = exported
            .manifest
            .bindings
            .iter()
            .map(|bound| {
                let name = bound.name.trim_start_matches(&format!("{}_", exported.manifest.prefix));
                let has_layers = bound.of.contains("array");
                let dimension =
                    if has_layers { TextureViewDimension::D2Array } else { TextureViewDimension::D2 };
                (bound.binding, view_of(device, queue, &texels_of(name, surface), dimension), dimension)
            })
            .collect();
        let textures = views.iter().map(|(binding, view, _)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: wgpu::BindingResource::TextureView(view),
        });
        let textures: Vec<_> = textures.collect();
        // What a body does not read is bound all the same.
        let of_texture = |(binding, _, dimension): &(u32, _, TextureViewDimension)| {
            let ty = wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: *dimension,
                multisampled: false,
            };
            laid_out(*binding, ty)
        };
        let buffer_of =
            |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        let kinds = [
            wgpu::BufferBindingType::Storage { read_only: true },
            wgpu::BufferBindingType::Storage { read_only: false },
            wgpu::BufferBindingType::Uniform,
        ];
        let of_buffers: Vec<_> =
            (0..).zip(kinds).map(|(binding, kind)| laid_out(binding, buffer_of(kind))).collect();
        let of_textures: Vec<_> = views.iter().map(of_texture).collect();
        let layouts = [&of_textures, &of_buffers].map(|entries| {
            let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries };
            device.create_bind_group_layout(&descriptor)
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layouts[0]), Some(&layouts[1])],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: Some(&layout),
            module: &module,
            entry_point: Some("main"),
            compilation_options: Default::default(),
            cache: None,
        });
        let bytes =
            |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents, usage })
        };
        let invocations = numbers.len() / count;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let results = buffer(&vec![0; 4 * RESULT * invocations], usage);
        let given = buffer(&bytes(numbers), wgpu::BufferUsages::STORAGE);
        let own = buffer(&settings_of(&exported.manifest, &surface.settings), wgpu::BufferUsages::UNIFORM);
        let group = |layout: &wgpu::BindGroupLayout, entries: &[wgpu::BindGroupEntry<'_>]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries })
        };
        let of = |binding, buffer: &wgpu::Buffer| (binding, buffer.clone());
        let buffers = [of(0, &given), of(1, &results), of(2, &own)];
        let buffers: Vec<_> = buffers
            .iter()
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let groups = [group(&layouts[0], &textures), group(&layouts[1], &buffers)];
        let readable = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: results.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        for (number, group) in (0..).zip(&groups) {
            pass.set_bind_group(number, group, &[]);
        }
        pass.dispatch_workgroups(invocations.div_ceil(GROUP) as u32, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&results, 0, &readable, 0, results.size());
        queue.submit([encoder.finish()]);
        readable.map_async(wgpu::MapMode::Read, .., |mapped| mapped.expect("the numbers are readable"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("the device works");
        let bytes = readable.get_mapped_range(..).expect("the numbers are mapped");
        bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
    }

    /// The compute shader around a body.
    fn module(
        &self,
        exported: &ExportedFunctions,
        body: &str,
        count: usize,
        dialect: Dialect,
    ) -> wgpu::ShaderModule {
        let settings = type_of(exported, "Settings");
        if dialect == Dialect::Wgsl {
            return self.wgsl(wgsl(&text_of(exported), &settings, body, count).as_bytes());
        }
        let file = &exported.files[1];
        let text = String::from_utf8(file.bytes.clone()).expect("a text");
        if dialect == Dialect::Unreal {
            let include = Include::new(&text);
            let [text, body] = include.in_compute(body);
            let words = include::compiled(&hlsl(&text, &settings, &body, count), "comp");
            return self.spirv(&words.unwrap_or_else(|error| panic!("{}: {error}", file.name)), "main");
        }
        let text = without_derivatives(&text);
        let (text, flags) = match dialect {
            Dialect::Glsl => (glsl(&text, &settings, body, count), &["-V", "-S", "comp"][..]),
            _ => (hlsl(&text, &settings, body, count), &["-D", "-V", "-Od", "-S", "comp", "-e", "main"][..]),
        };
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(folder.path().join("given"), text).expect("the folder is writable");
        run(folder.path(), GLSLANG, flags.iter().chain(&["-o", "out.spv", "given"]))
            .unwrap_or_else(|error| panic!("{}: {error}", file.name));
        self.spirv(&std::fs::read(folder.path().join("out.spv")).expect("it was compiled"), "main")
    }
}

/// A binding of compute passes.
fn laid_out(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}
