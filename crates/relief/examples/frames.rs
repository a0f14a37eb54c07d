//! Renders several surfaces, and more pictures than one: the renderer keeps what the pictures have in common.

use std::error::Error;

use relief::camera::Camera;
use relief::glam::DVec3;
use relief::maps::Maps;
use relief::mesh::{Placement, cube, square};
use relief::render::Renderer;
use relief::scene::{BackendChoice, Look, Sampling, Scene, Surface};
use relief::shaders::Selection;
use relief::{HeightMap, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let wave = |i: u32, j: u32| 0.5 + 0.5 * (i as f32 * 0.1).sin() * (j as f32 * 0.1).sin();
    let heights = HeightMap::from_fn(63, 63, Wrap::Repeat, wave)?.with_displacement(0.05, -0.05)?;
    let place = Placement { position_m: DVec3::new(0.2, 0.2, 0.0), size: 0.4, ..Placement::default() };
    let floor = Surface::new(square(1)?, heights.clone()).with_selection(Selection::exact());
    let block = Surface::new(cube(1)?.placed(&place)?, heights).with_selection(Selection::method("cone")?);
    let mut scene = Scene::builder(floor).surface(block).look(Look::Studio).size(320, 240).build()?;

    let mut maps = Maps::in_memory();
    let mut renderer = Renderer::new(BackendChoice::Auto, Sampling::Exact)?;
    for frame in 0..3 {
        let (sin, cos) = (0.3 * f64::from(frame)).sin_cos();
        scene.set_camera(Camera::new(DVec3::new(1.5 * sin, 1.0, 1.5 * cos), DVec3::ZERO, 40.0)?);
        let rendered = renderer.render(&scene, &mut maps, &Watch::none())?;
        println!("frame {frame}: {:.1} ms", 1e3 * rendered.info.elapsed.as_secs_f64());
    }
    Ok(())
}
