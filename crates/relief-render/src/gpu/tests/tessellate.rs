//! Comparison of triangles made on a GPU and on the CPU.

use std::sync::Arc;

use relief_core::Watch;
use relief_maps::Maps;
use relief_shaders::cpu::{Corner, Face, Shared, read_all};
use relief_shaders::wgsl::Sampling;
use wgpu::{BufferUsages, Limits};

use super::super::{Gpu, GpuRenderer};
use super::{own, rendered, software};
use crate::Renderer;
use crate::block_on;
use crate::cpu::tessellated::tests::{BY_TEXELS, SWEPT, job_of, made, scene_of, surface_of};
use crate::job::Job;
use relief_core::mesh::{cube, rectangle, sphere, square, torus};

/// The triangles that a renderer made of the first surface.
fn made_by(renderer: &mut GpuRenderer, job: &Job) -> (Vec<Corner>, Vec<Face>) {
    renderer.render(job, Sampling::Exact, &Watch::none()).expect("a picture");
    let gpu = renderer.gpu().clone();
    let read = |buffer: &wgpu::Buffer| {
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let readable = gpu.buffer("read", buffer.size(), usage);
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &readable, 0, buffer.size());
        gpu.queue().submit([encoder.finish()]);
        let mut all = Vec::new();
        block_on(gpu.read(&readable, buffer.size(), |bytes| all.extend_from_slice(bytes))).expect("bytes");
        all
    };
    let [totals, corners, faces] = renderer.tessellation_buffers(0).expect("it is tessellated").map(read);
    let totals = read_all::<u32>(&totals);
    let [points, triangles] = [totals[12], totals[13]].map(|count| count as usize);
    assert_eq!(totals[0] as usize, 3 * triangles);
    let vertices = job.surfaces[0].triangles.tessellation().expect("it is one").base.vertices.len();
    let corners = read_all(&corners[..(vertices + points) * Corner::SIZE]);
    (corners, read_all(&faces[..triangles * Face::SIZE]))
}

#[test]
fn a_gpu_makes_the_same_triangles_as_the_cpu() {
    let Some(gpu) = software() else { return };
    let mut renderer = GpuRenderer::new(gpu);
    let (mut same, mut all) = (0, 0);
    let meshes = [cube(1), torus(12, 7), sphere(10, 5), square(1)].map(|mesh| mesh.expect("a mesh"));
    let all_of = |set| meshes.iter().map(move |mesh| surface_of(mesh.clone(), 1.5, set));
    // Triangles with too many voxels along a side to be swept have the pattern.
    let long = surface_of(rectangle([4.0, 0.02], 1).expect("a mesh"), 0.25, SWEPT);
    let job = job_of(&scene_of(long.clone(), [0.4, 0.3, 0.5], false));
    let on_side = made(&job).corners().iter().filter(|corner| corner.uv.y == 0.0).count();
    assert!(on_side > 1024, "{on_side}");
    for surface in [&[], SWEPT, BY_TEXELS].into_iter().flat_map(all_of).chain([long]) {
        for (eye, culls) in [([1.3, 0.9, 1.1], false), ([0.4, 0.3, 0.5], true), ([-0.2, 2.5, 0.1], true)] {
            let job = job_of(&scene_of(surface.clone(), eye, culls));
            let expected = made(&job);
            let (corners, faces) = made_by(&mut renderer, &job);
            assert!(!faces.is_empty() && faces == expected.faces(), "{eye:?}");
            assert_eq!(corners.len(), expected.corners().len());
            for (a, b) in corners.iter().zip(expected.corners()) {
                let [a, b] = [a.position, b.position].map(|of| [of.x, of.y, of.z]);
                let steps = a.iter().zip(&b).map(|(a, b)| {
                    let size = a.abs().max(b.abs()).max(0.01);
                    (a - b).abs() / (size * f32::EPSILON)
                });
                assert!(steps.fold(0.0, f32::max) <= 2.0, "{a:?} {b:?}");
                same += usize::from(a == b);
                all += 1;
            }
        }
    }
    assert!(same as f64 >= 0.9999 * all as f64, "{same} of {all}");
}

#[test]
fn a_gpu_without_room_coarsens_and_makes_views_anew() {
    let Some(gpu) = software() else { return };
    for set in [&[], SWEPT] {
        coarsens(gpu.clone(), set);
    }
}

fn coarsens(gpu: Gpu, set: &[(&str, f64)]) {
    let mut renderer = GpuRenderer::new(gpu);
    let surface = surface_of(torus(24, 12).expect("a mesh"), 1.0, set);
    let scene = scene_of(surface, [0.7, 0.5, 0.6], false);
    let mut counts = Vec::new();
    for kilobytes in [100_000, 1000, 100_000] {
        let memory = relief_core::ByteSize(kilobytes << 10);
        let job = job_of(&scene.to_builder().geometry_memory(memory).build().expect("a scene"));
        let (_, faces) = made_by(&mut renderer, &job);
        assert_eq!(faces, made(&job).faces());
        counts.push(faces.len());
    }
    assert!(counts[1] * 3 < counts[0] && counts[0] == counts[2], "{counts:?}");
    // The same picture again makes, uploads and compiles nothing.
    let job = job_of(&scene);
    for _ in 0..2 {
        renderer.render(&job, Sampling::Exact, &Watch::none()).expect("a picture");
    }
    assert_eq!((renderer.last_work().uploaded, renderer.last_work().compiled), (0, 0));
}

#[test]
fn a_gpu_that_binds_less_is_given_the_same_triangles() {
    let (Some(whole), Some(least)) = (software(), own(Limits::downlevel_defaults())) else { return };
    let surface = surface_of(torus(12, 7).expect("a mesh"), 2.0, &[]);
    let scene = scene_of(surface, [1.0, 0.8, 0.9], true);
    let [whole, least] = [whole, least].map(|gpu| {
        let mut renderer = Renderer::on_gpu(gpu, Sampling::Exact);
        Arc::new(rendered(&mut renderer, &scene, &mut Maps::in_memory()))
    });
    assert!(whole.pixels.iter().any(|pixel| pixel.hit == 1));
    assert_eq!(whole, least);
}
