//! Renders a scene and saves the picture as PNG.

use std::error::Error;

use relief::glam::Vec2;
use relief::io::{PngColour, write_png8};
use relief::maps::Maps;
use relief::mesh::torus;
use relief::render::{picture, render};
use relief::scene::{Look, Scene, Surface};
use relief::shaders::Selection;
use relief::{HeightMap, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let bumps = |i: u32, j: u32| ((i as f32 * 0.1).sin() * (j as f32 * 0.1).sin()).abs().sqrt();
    // 2 cm between the lowest and the highest texel; the lowest lies on the mesh.
    let heights = HeightMap::from_fn(63, 63, Wrap::Repeat, bumps)?.with_displacement(0.02, 0.0)?;
    let surface = Surface::new(torus(96, 48)?.tiled(Vec2::new(6.0, 2.0))?, heights)
        .with_selection(Selection::method("cone")?);
    let scene = Scene::builder(surface).look(Look::Studio).size(320, 240).build()?;

    let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none())?;
    let rgb = picture::srgb8(&rendered.rendering, &scene);
    let file = std::env::temp_dir().join("relief-torus.png");
    write_png8(&file, 320, 240, PngColour::Rgb, &rgb)?;
    println!("{}, made on the {}, {}", file.display(), rendered.info.backend, rendered.info.device);

    let hits = rendered.rendering.pixels.iter().filter(|pixel| pixel.hit == 1).count();
    println!("{hits} of {} pixels show the surface", rendered.rendering.pixels.len());
    Ok(())
}
