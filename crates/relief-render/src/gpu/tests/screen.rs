//! Pictures for screens: exposure, tone curve and sRGB on the GPU beside the CPU's.

use std::sync::Arc;

use relief_core::mesh::square;
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::Picture;
use relief_maps::Maps;
use relief_scene::background::Background;
use relief_scene::environment::Environment;
use relief_scene::tone::Tone;
use relief_scene::{Scene, SceneBuilder, Surface};
use relief_shaders::wgsl::Sampling;

use super::software;
use crate::block_on;
use crate::{Renderer, picture};

fn scene() -> SceneBuilder {
    let heights = HeightMap::from_fn(16, 16, Wrap::Repeat, |i, j| ((i * 5 + j * 3) % 11) as f32 / 10.0);
    let heights = heights.expect("heights").with_displacement(0.2, 0.0).expect("a scale");
    // More rows than a band has.
    Scene::builder(Surface::new(square(1).expect("a mesh"), heights)).size(700, 420)
}

/// The greatest difference of a byte on the screen from the CPU's, with another tone curve there.
fn greatest_difference(renderer: &mut Renderer, scene: &Scene, tone: Tone) -> u8 {
    let mut maps = Maps::in_memory();
    let drawn = block_on(renderer.screen_async(scene, &mut maps, &Watch::none())).expect("a picture");
    let (screen, info) = drawn.expect("it is on a GPU");
    assert_eq!((screen.len(), info.backend), (4 * 700 * 420, "gpu"));
    let scene = scene.to_builder().tone(tone).build().expect("a scene");
    let rendered = renderer.render(&scene, &mut maps, &Watch::none()).expect("a rendering");
    let expected = picture::srgb8(&rendered.rendering, &scene);
    let pairs = screen.chunks_exact(4).zip(expected.chunks_exact(3));
    pairs
        .map(|(shown, expected)| {
            assert_eq!(shown[3], 255);
            (0..3).map(|at| shown[at].abs_diff(expected[at])).max().unwrap_or(0)
        })
        .max()
        .unwrap_or(0)
}

#[test]
fn the_screen_shows_the_picture_within_a_step() {
    let Some(gpu) = software() else { return };
    let mut renderer = Renderer::on_gpu(gpu, Sampling::Exact);
    let texel = |at: u32| [(at % 128) as f32 / 40.0, 0.7, (at / 128) as f32 / 90.0, 1.0];
    let sky = Picture { width: 128, height: 64, texels: (0..128 * 64).map(texel).collect() };
    let sky = Arc::new(Environment::from_equirectangular(&sky).expect("surroundings"));
    let gradient = Background::Gradient([[0.2, 0.4, 1.5].into(), [0.6, 0.0, 0.01].into()]);
    let cases = [
        scene().background(gradient).tone(Tone::None).exposure(-1.0),
        scene().background(gradient).tone(Tone::Agx).exposure(2.5).samples(2),
        scene().environment(sky).background(Background::Environment).tone(Tone::Agx).exposure(0.5),
    ];
    for (number, case) in cases.into_iter().enumerate() {
        let scene = case.build().expect("a scene");
        let own = greatest_difference(&mut renderer, &scene, scene.tone());
        assert!(own <= 1, "scene {number}: {own}");
        // A forgotten or a needless curve is seen.
        let other = if scene.tone() == Tone::Agx { Tone::None } else { Tone::Agx };
        let other = greatest_difference(&mut renderer, &scene, other);
        assert!(other > 5, "scene {number}: {other} by another curve");
    }
}
