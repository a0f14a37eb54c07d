//! A renderer of its own with wgpu, whose fragment function calls a method: a floor of waves, as PNG.

use std::error::Error;

use relief::export::{FunctionOptions, functions};
use relief::io::{PngColour, write_png8};
use relief::render::block_on;
use relief::render::wgpu::{self, util::DeviceExt};
use relief::shaders::Selection;
use relief::{HeightMap, Wrap};

const SIDE: u32 = 256;

/// The program's own shader: a floor 2 m wide, seen from `EYE`. What it calls stands before it.
const OWN: &str = "
@group(1) @binding(0) var<uniform> settings: ReliefSettings;

const EYE = vec3f(0.0, 1.4, 1.9);

struct Seen {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
}

@vertex
fn corner(@builtin(vertex_index) number: u32) -> Seen {
    let side = vec2f(f32(number & 1u), f32(number >> 1u)) * 2.0 - 1.0;
    let position = vec3f(side.x, 0.0, side.y);
    // A camera that looks at the origin, 45 degrees wide.
    let back = normalize(EYE);
    let right = vec3f(1.0, 0.0, 0.0);
    let way = position - EYE;
    let at = vec3f(dot(way, right), dot(way, cross(back, right)), dot(way, back));
    return Seen(vec4f(at.xy * 2.4, 0.5, -at.z), position);
}

@fragment
fn shade(seen: Seen) -> @location(0) vec4f {
    // Along +u and +v are x and z; the normal is y.
    let view = normalize(seen.position - EYE).xzy;
    let at = ReliefPoint(0.5 * seen.position.xz + 0.5, view, vec2f(2.0, 2.0));
    let hit = relief_hit(settings, at);
    if (!hit.hit) {
        discard;
    }
    let sun = normalize(vec3f(-0.8, 0.2, 0.35));
    let light = relief_light(settings, at, hit, sun) * max(dot(hit.normal, sun), 0.0);
    return vec4f(vec3f(0.05 + 0.9 * light), 1.0);
}";

fn main() -> Result<(), Box<dyn Error>> {
    let waves = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|at| at as f32 / 128.0 * std::f32::consts::TAU);
        0.5 + 0.25 * ((3.0 * x).sin() + (2.0 * y + (2.0 * x).sin()).cos())
    };
    let heights = HeightMap::from_fn(128, 128, Wrap::Clamp, waves)?;
    let mut selection = Selection::method("relief")?;
    selection.choose("shadow", "ray")?;
    let exported = functions(&selection, &FunctionOptions { wrap: Some(Wrap::Clamp), ..Default::default() })?;
    let text = String::from_utf8_lossy(&exported.files[0].bytes).into_owned() + OWN;

    // The settings, at the places that the manifest states.
    let mut settings = vec![0; exported.manifest.settings_size as usize];
    for setting in &exported.manifest.settings {
        let bytes: Vec<u8> = match setting.name.as_str() {
            "scale" => 0.25_f32.to_le_bytes().to_vec(),
            "bias" => (-0.25_f32).to_le_bytes().to_vec(),
            "height_size" => [128_u32, 128].iter().flat_map(|side| side.to_le_bytes()).collect(),
            // Parameters of the method have a value to begin with.
            _ => setting.value.unwrap_or(0.0).to_le_bytes().to_vec(),
        };
        settings[setting.offset as usize..][..bytes.len()].copy_from_slice(&bytes);
    }

    let instance = wgpu::Instance::default();
    let Ok(adapter) = block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())) else {
        println!("there is no GPU here");
        return Ok(());
    };
    let (device, queue) = block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_limits: wgpu::Limits::downlevel_defaults(),
        ..Default::default()
    }))?;
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    let format = wgpu::TextureFormat::Rgba8UnormSrgb;
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("corner"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("shade"),
            compilation_options: Default::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    });

    let texture = |size: u32, format, usage| wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: size, height: size, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    };
    let map = device.create_texture_with_data(
        &queue,
        &texture(128, wgpu::TextureFormat::R32Float, wgpu::TextureUsages::TEXTURE_BINDING),
        wgpu::util::TextureDataOrder::LayerMajor,
        &heights.texels().iter().flat_map(|height| height.to_le_bytes()).collect::<Vec<u8>>(),
    );
    let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: None,
        contents: &settings,
        usage: wgpu::BufferUsages::UNIFORM,
    });
    let view = map.create_view(&Default::default());
    let groups = [wgpu::BindingResource::TextureView(&view), buffer.as_entire_binding()];
    let groups: Vec<wgpu::BindGroup> = (0..)
        .zip(groups)
        .map(|(group, resource)| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(group),
                entries: &[wgpu::BindGroupEntry { binding: 0, resource }],
            })
        })
        .collect();

    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let picture = device.create_texture(&texture(SIDE, format, usage));
    let read = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(4 * SIDE * SIDE),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let shown = picture.create_view(&Default::default());
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &shown,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    for (number, group) in (0..).zip(&groups) {
        pass.set_bind_group(number, group, &[]);
    }
    pass.draw(0..4, 0..1);
    drop(pass);
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIDE), rows_per_image: None };
    encoder.copy_texture_to_buffer(
        picture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &read, layout },
        picture.size(),
    );
    queue.submit([encoder.finish()]);
    read.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let bytes = read.get_mapped_range(..)?;
    let rgb: Vec<u8> =
        bytes.as_chunks::<4>().0.iter().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let file = std::env::temp_dir().join("relief-functions.png");
    write_png8(&file, SIDE, SIDE, PngColour::Rgb, &rgb)?;
    println!("{}", file.display());
    Ok(())
}
