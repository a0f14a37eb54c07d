//! Functions of shaders, called for many numbers by a compute pass of the tests' own.

use relief_render::wgpu;
use relief_render::wgpu::util::DeviceExt;

use super::Device;

/// Invocations of a workgroup.
const GROUP: u32 = 64;

impl Device {
    /// Returns the results of a program's function `value_of(number: u32) -> f32` for 0 up to a count.
    ///
    /// # Panics
    ///
    /// When the program is none that this device runs.
    pub fn computed(&self, program: &str, count: u32) -> Vec<f32> {
        let Self { device, queue } = self;
        let text = format!(
            "{program}\n@group(0) @binding(0) var<storage, read_write> values: array<f32>;\n\n\
             @compute @workgroup_size({GROUP})\n\
             fn compute_main(@builtin(global_invocation_id) at: vec3u) {{\n    \
             if (at.x < arrayLength(&values)) {{\n        values[at.x] = value_of(at.x);\n    }}\n}}\n"
        );
        let source = wgpu::ShaderSource::Wgsl(text.into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("compute_main"),
            compilation_options: Default::default(),
            cache: None,
        });
        let values = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: &vec![0; 4 * count as usize],
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        });
        let bound = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: values.as_entire_binding() }],
        });
        let readable = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: values.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bound, &[]);
        pass.dispatch_workgroups(count.div_ceil(GROUP), 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&values, 0, &readable, 0, values.size());
        queue.submit([encoder.finish()]);
        readable.map_async(wgpu::MapMode::Read, .., |mapped| mapped.expect("the numbers are readable"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("the device works");
        let bytes = readable.get_mapped_range(..).expect("the numbers are mapped");
        bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
    }
}
