//! The nearest hit is seen, not the hit on the nearest base polygon.

use std::path::Path;

use relief_core::Watch;
use relief_core::mesh::Builtin;
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, MeshChoice, SceneSpec, SurfaceSpec, read_scene};
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;

/// A shipped scene's surface that rises out of its base, on a torus or a sphere, alone or together.
fn pixels(meshes: &[Builtin], backend: BackendChoice) -> Vec<PixelOut> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cobbles.toml");
    let scene = read_scene(&path).expect("a shipped scene");
    let mut spec = scene.overridden_by(SceneSpec {
        backend: Some(backend),
        size: Some([160, 120].into()),
        samples: Some(1),
        ..SceneSpec::default()
    });
    spec.surface = SurfaceSpec { bias: Some(0.0), scale: Some(0.08), mesh: None, ..spec.surface };
    let surface =
        |mesh: &Builtin| SurfaceSpec { mesh: Some(MeshChoice::Builtin(*mesh)), ..SurfaceSpec::default() };
    spec.surfaces = meshes.iter().map(surface).collect();
    let scene = spec.load().expect("a shipped map");
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

#[test]
fn of_surfaces_that_go_through_each_other_the_nearest_is_seen() {
    for backend in [BackendChoice::Cpu, BackendChoice::Gpu] {
        if backend == BackendChoice::Gpu && !has_adapter() {
            continue;
        }
        let (torus, sphere) = (pixels(&[Builtin::Torus], backend), pixels(&[Builtin::Sphere], backend));
        let both = pixels(&[Builtin::Torus, Builtin::Sphere], backend);
        let [mut of_torus, mut of_sphere, mut wrong] = [0; 3];
        for ((torus, sphere), both) in torus.iter().zip(&sphere).zip(&both) {
            let depth = |pixel: &PixelOut| if pixel.hit == 1 { pixel.depth } else { f32::INFINITY };
            let nearest = depth(torus).min(depth(sphere));
            of_torus += usize::from(torus.hit == 1 && depth(torus) < depth(sphere));
            of_sphere += usize::from(sphere.hit == 1 && depth(sphere) < depth(torus));
            // Depths along the ray and depths of the displaced points differ a little on curved meshes.
            wrong += usize::from(both.hit == 1 && (both.depth - nearest).abs() > 0.02);
            wrong += usize::from((both.hit == 1) != (torus.hit == 1 || sphere.hit == 1));
        }
        println!("torus {of_torus}, sphere {of_sphere}, wrong {wrong}");
        assert!(of_torus > 500 && of_sphere > 500, "{of_torus} {of_sphere}");
        assert!(wrong * 500 < of_torus + of_sphere, "{wrong} of {}", of_torus + of_sphere);
    }
}
