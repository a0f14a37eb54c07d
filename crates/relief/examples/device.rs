//! Draws with a device of the program's own, into a texture that stays on it.

use std::error::Error;

use relief::maps::Maps;
use relief::mesh::square;
use relief::render::block_on;
use relief::render::gpu::Gpu;
use relief::render::{Renderer, wgpu};
use relief::scene::{Look, Sampling, Scene, Surface};
use relief::{HeightMap, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let instance = wgpu::Instance::default();
    let Ok(adapter) = block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())) else {
        println!("there is no GPU here");
        return Ok(());
    };
    let descriptor = wgpu::DeviceDescriptor {
        required_limits: wgpu::Limits::downlevel_defaults(),
        ..wgpu::DeviceDescriptor::default()
    };
    let (device, queue) = block_on(adapter.request_device(&descriptor))?;

    let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
    let surface = Surface::new(square(1)?, heights.with_displacement(0.05, 0.0)?);
    let scene = Scene::builder(surface).look(Look::Studio).size(320, 240).build()?;
    let mut renderer = Renderer::on_gpu(Gpu::of_device(device, queue, "ours"), Sampling::Exact);
    let mut maps = Maps::in_memory();
    let Some(texture) = block_on(renderer.draw(&scene, &mut maps, &Watch::none()))? else {
        return Err("a renderer on a GPU draws there".into());
    };
    println!("{}x{} pixels of {:?} to show", texture.width(), texture.height(), texture.format());
    Ok(())
}
