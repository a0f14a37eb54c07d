//! Renders a woven cloth on a torus: a volume on a surface.

use std::error::Error;
use std::f64::consts::PI;

use relief::glam::Vec2;
use relief::io::{PngColour, write_png8};
use relief::maps::Maps;
use relief::mesh::torus;
use relief::render::{picture, render};
use relief::scene::{Look, Scene, Surface};
use relief::shaders::Selection;
use relief::{HeightMap, Volume, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    // The depth inside of a thread, in tiles: it runs along one direction, over and under those across.
    let thread = |along: f64, across: f64, h: f64, over: f64| {
        let number = (2.0 * across).floor();
        let side = if number % 2.0 == 0.0 { over } else { -over };
        let height = 0.5 + 0.17 * side * (2.0 * PI * along).sin();
        0.16 - (across - (number + 0.5) / 2.0).hypot(0.5 * (h - height))
    };
    let weave = |[u, v, h]: [f64; 3]| 0.5 + 32.0 * thread(u, v, h, 1.0).max(thread(v, u, h, -1.0));
    // 3 cm high, on the mesh.
    let cloth = Volume::from_fn([64, 64, 32], Wrap::Repeat, weave)?.with_displacement(0.03, 0.0)?;

    let mut method = Selection::method("voxels")?;
    method.choose("surface", "tetrahedra")?;
    let level = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat)?;
    let torus = torus(96, 48)?.tiled(Vec2::new(12.0, 5.0))?;
    let surface = Surface::new(torus, level).with_volume(cloth).with_selection(method).with_two_sided(true);
    let scene = Scene::builder(surface).look(Look::Studio).size(320, 240).samples(1).build()?;

    let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none())?;
    let rgb = picture::srgb8(&rendered.rendering, &scene);
    let file = std::env::temp_dir().join("relief-cloth.png");
    write_png8(&file, 320, 240, PngColour::Rgb, &rgb)?;

    let hits = rendered.rendering.pixels.iter().filter(|pixel| pixel.hit == 1).count();
    println!("{}: {hits} of {} pixels show a thread", file.display(), rendered.rendering.pixels.len());
    Ok(())
}
