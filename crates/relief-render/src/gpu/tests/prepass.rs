//! Prepass that other programs run before their own passes: its depths are the `z` of pictures, to
//! the bit.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_shaders::Selection;
use relief_shaders::surface::Proposal;
use relief_shaders::wgsl::{BOX_VERTICES, Root, Sampling, assemble};
use wgpu::{
    BufferUsages, CompareFunction, Extent3d, Face, LoadOp, Operations, Origin3d,
    RenderPassDepthStencilAttachment, RenderPassDescriptor, StoreOp, TexelCopyBufferInfo,
    TexelCopyBufferLayout, TexelCopyTextureInfo, TextureAspect, TextureDescriptor, TextureDimension,
    TextureUsages,
};

use super::software;
use crate::Renderer;
use crate::block_on;
use crate::gpu::Gpu;
use crate::gpu::light_map::Frames;
use crate::gpu::pipelines::{DEPTH, nearest, raster};
use crate::gpu::programs::Layouts;
use crate::gpu::resident::{Common, Resident};
use crate::gpu::targets::Targets;
use crate::job::Job;
use crate::prepare::Preparer;
use crate::samples::samples;
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::torus;
use relief_scene::depth_buffer::{Clip, DepthBuffer};
use relief_scene::{Scene, Surface};

/// Columns and rows; a row of depths is as long as copies want it.
const SIZE: [u32; 2] = [128, 96];

fn scene(surface: &str, depth_buffer: DepthBuffer, projection: Projection) -> Scene {
    let wave = |x: u32, y: u32| (((x * 7 + y * 3) % 11) as f32) / 11.0;
    let map = HeightMap::from_fn(16, 16, Wrap::Repeat, wave).expect("a map");
    let map = map.with_displacement(0.05, -0.05).expect("lengths");
    let mesh = torus(24, 12).and_then(|mesh| mesh.tiled(Vec2::new(6.0, 3.0))).expect("a mesh");
    let mut selection = Selection::exact();
    selection.choose("surface", surface).expect("a listed name");
    let camera = Camera::with(DVec3::new(0.3, 0.8, 1.2), DVec3::ZERO, projection).expect("a camera");
    let builder = Scene::builder(Surface::new(mesh, Arc::new(map)).with_selection(selection));
    let builder = builder.camera(camera).samples(1).size(SIZE[0], SIZE[1]).depth_buffer(depth_buffer);
    builder.build().expect("a scene")
}

/// Returns the depth buffer after the prepass. It is cleared to the farthest depth.
fn depths(gpu: &Gpu, job: &Job, clip: Clip) -> Vec<f32> {
    let (surface, layouts) = (&job.surfaces[0], Layouts::new(gpu.device()));
    let count = surface.triangles.len() as u32;
    // Of boxes around shells the far sides are drawn: an eye inside of one sees these alone.
    let (root, vertices, faces) = match surface.selection.paths().proposal {
        Proposal::Polygons => (Root::Prepass, 3 * count, (!surface.two_sided).then_some(Face::Back)),
        Proposal::Shells => (Root::PrepassShells, BOX_VERTICES * count, Some(Face::Front)),
    };
    let text = assemble(&surface.selection, root, Sampling::Exact);
    let [width, height] = SIZE;
    let (compare, farthest) = match clip {
        Clip::Standard => (CompareFunction::Less, 1.0),
        Clip::Reversed => (CompareFunction::Greater, 0.0),
    };
    let test = wgpu::DepthStencilState { depth_compare: Some(compare), ..nearest(DEPTH) };
    let size = Extent3d { width, height, depth_or_array_layers: 1 };
    let bytes = u64::from(width) * u64::from(height) * 4;
    let readable = gpu.guarded(|| {
        let groups = [Some(layouts.maps(Sampling::Exact)), Some(&layouts.mesh)];
        let program = raster(gpu.device(), &text, root, &groups, faces, Some(test), &[]);
        let targets = Targets::new(gpu, SIZE, samples(1, true), false, 0, &layouts)?;
        let mut frames = Frames::new(gpu);
        frames.set(gpu, job.frame, &[]);
        let (frame, passes) = (frames.resource(), targets.passes());
        let common = Common { number: 0, frame, passes, builder: None, light_map: None };
        let mut resident = Resident::new(gpu);
        let maps = resident.maps(gpu, surface, Sampling::Exact, layouts.maps(Sampling::Exact), &common)?;
        let mesh = resident.mesh(gpu, surface, &layouts, None, &maps, None)?;
        let texture = gpu.device().create_texture(&TextureDescriptor {
            label: Some("prepass"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: TextureDimension::D2,
            format: DEPTH,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&Default::default());
        let readable = gpu.buffer("depths", bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        let ops = Operations { load: LoadOp::Clear(farthest), store: StoreOp::Store };
        let attachment =
            RenderPassDepthStencilAttachment { view: &view, depth_ops: Some(ops), stencil_ops: None };
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("prepass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(attachment),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_pipeline(&program);
        pass.set_bind_group(0, &maps.for_camera, &[0, targets.whole]);
        pass.set_bind_group(1, &mesh.group, &[]);
        pass.draw(0..vertices, 0..1 + u32::from(root == Root::PrepassShells && surface.two_sided));
        drop(pass);
        let from = TexelCopyTextureInfo {
            texture: &texture,
            mip_level: 0,
            origin: Origin3d::ZERO,
            aspect: TextureAspect::DepthOnly,
        };
        let layout =
            TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width * 4), rows_per_image: Some(height) };
        encoder.copy_texture_to_buffer(from, TexelCopyBufferInfo { buffer: &readable, layout }, size);
        gpu.queue().submit([encoder.finish()]);
        Ok(readable)
    });
    let readable = block_on(readable).expect("a prepass");
    let mut depths = Vec::new();
    let read = gpu.read(&readable, bytes, |bytes| {
        depths.extend(bytes.chunks_exact(4).map(|four| f32::from_le_bytes(four.try_into().expect("four"))));
    });
    block_on(read).expect("the depths");
    depths
}

#[test]
fn a_prepass_leaves_the_depths_of_the_pictures_to_the_bit() {
    let Some(gpu) = software() else { return };
    let perspective = Projection::Perspective { fov_degrees: 50.0 };
    let orthographic = Projection::Orthographic { height_m: 1.2 };
    let infinite = DepthBuffer { clip: Clip::Reversed, near_m: Some(0.1), far_m: Some(f64::INFINITY) };
    let narrow = DepthBuffer { near_m: Some(1.2), far_m: Some(1.4), ..DepthBuffer::default() };
    let reversed = DepthBuffer { clip: Clip::Reversed, ..DepthBuffer::default() };
    let cases = [
        ("plane", DepthBuffer::default(), perspective),
        ("prism", infinite, perspective),
        ("tetrahedra", reversed, orthographic),
        ("quadric-vertical", reversed, perspective),
        ("plane", DepthBuffer::default(), orthographic),
        ("prism", narrow, perspective),
    ];
    for (surface, depth_buffer, projection) in cases {
        let scene = scene(surface, depth_buffer, projection);
        let rendered = Renderer::on_gpu(gpu.clone(), Sampling::Exact);
        let rendered =
            { rendered }.render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture");
        let job = Preparer::default().job(&scene, &Watch::none()).expect("a job");
        let before = depths(&gpu, &job, depth_buffer.clip);
        let planes = depth_buffer.near_m.zip(depth_buffer.far_m);
        let mut covered = 0;
        for (pixel, before) in rendered.rendering.pixels.iter().zip(before) {
            if pixel.hit == 0 {
                assert_eq!(before, if depth_buffer.clip == Clip::Standard { 1.0 } else { 0.0 });
                continue;
            }
            covered += 1;
            assert_eq!(before.to_bits(), pixel.z.to_bits(), "{surface}: {before} and {}", pixel.z);
            if let Some((near, far)) = planes.filter(|(_, far)| far.is_finite()) {
                // The point is on its ray but for rounding.
                let depth = f64::from(pixel.depth).clamp(near, far);
                let of_z = near * far / (far - f64::from(pixel.z) * (far - near));
                assert!((of_z - depth).abs() < 2e-4, "{depth}: {of_z}");
            }
        }
        assert!(covered > 1000, "{surface}: {covered}");
    }
}
