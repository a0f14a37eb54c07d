//! Comparison of shells on a GPU, where rays traverse a BVH, and on the CPU, where blocks of rays
//! do.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_shaders::wgsl::Sampling;

use super::software;
use crate::Renderer;
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::torus;
use relief_scene::{Scene, Surface};

/// A torus whose relief rises and falls, seen from there.
fn scene(surface: &str, eye: DVec3, projection: Projection, two_sided: bool) -> Scene {
    let wave = |x: u32, y: u32| (((x * 7 + y * 3) % 11) as f32) / 11.0;
    let map = HeightMap::from_fn(32, 32, Wrap::Repeat, wave).expect("a map");
    let map = map.with_displacement(0.06, -0.03).expect("lengths");
    let mesh = torus(24, 12).and_then(|mesh| mesh.tiled(Vec2::new(6.0, 3.0))).expect("a mesh");
    let mut selection = Selection::method("quadtree").expect("a listed name");
    selection.choose("surface", surface).expect("a listed name");
    let camera = Camera::with(eye, DVec3::new(0.3, 0.0, 0.1), projection).expect("a camera");
    let surface = Surface::new(mesh, Arc::new(map)).with_selection(selection).with_two_sided(two_sided);
    Scene::builder(surface).camera(camera).samples(1).size(160, 120).build().expect("a scene")
}

/// Returns the bits of a pixel's values.
fn shown(pixel: &PixelOut) -> ([u32; 4], [u32; 6]) {
    let PixelOut { hit, uv, height, t, z, position, reads, steps, bytes, .. } = pixel;
    ([*hit, *reads, *steps, *bytes], [uv.x, uv.y, *height, *t, *z, position.x].map(f32::to_bits))
}

#[test]
fn a_hierarchy_finds_what_blocks_of_rays_find_to_the_bit() {
    let Some(gpu) = software() else { return };
    let perspective = Projection::Perspective { fov_degrees: 60.0 };
    let orthographic = Projection::Orthographic { height_m: 1.2 };
    let outside = DVec3::new(0.3, 0.8, 1.2);
    // Within the tube, and where the relief is.
    let [within, in_relief] = [DVec3::new(0.35, 0.0, 0.0), DVec3::new(0.52, 0.01, 0.0)];
    let cases = [
        ("prism", outside, perspective, false),
        ("prism", within, perspective, true),
        ("prism", in_relief, perspective, true),
        ("prism", outside, orthographic, true),
        ("tetrahedra", outside, orthographic, false),
        ("tetrahedra", within, perspective, true),
    ];
    for (surface, eye, projection, two_sided) in cases {
        let scene = scene(surface, eye, projection, two_sided);
        let pictures = [Renderer::on_gpu(gpu.clone(), Sampling::Exact), Renderer::on_cpu()].map(|renderer| {
            let picture = { renderer }.render(&scene, &mut Maps::in_memory(), &Watch::none());
            picture.expect("a picture").rendering.pixels
        });
        let [on_gpu, on_cpu] = &pictures;
        let covered = on_cpu.iter().filter(|pixel| pixel.hit == 1).count();
        assert!(covered > 3000, "{surface}: {covered}");
        let others = on_gpu.iter().zip(on_cpu).filter(|(one, other)| shown(one) != shown(other)).count();
        assert_eq!(others, 0, "{surface} from {eye}: of {covered}");
    }
}
