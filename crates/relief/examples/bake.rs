//! Bakes a cone map and writes it to a file.

use std::error::Error;

use relief::bake::{Collected, bake, kind};
use relief::io::write_exr;
use relief::{HeightMap, Metric, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let wave = |i: u32, j: u32| 0.5 + 0.3 * (i as f32 * 0.2).sin() * (j as f32 * 0.1).cos();
    let heights = HeightMap::from_fn(128, 128, Wrap::Clamp, wave)?;

    // A tile of one metre, and 5 cm between the lowest and the highest texel.
    let metric = Metric { tile_m: [1.0, 1.0], scale_m: 0.05 };
    let cone = kind("cone")?;
    let mut settings = cone.defaults();
    settings.set("apex", 1.0)?;
    let mut baked = Collected::default();
    bake(cone, &heights, metric, &settings, &Watch::none(), &mut baked)?;

    for map in &baked.textures {
        let [width, height, _] = map.texture.size;
        let names = map.texture.channels.iter().map(|channel| channel.name);
        let texels = map.levels[0].iter().map(Vec::as_slice);
        let file = std::env::temp_dir().join("relief-cone.exr");
        write_exr(&file, width, height, &names.zip(texels).collect::<Vec<_>>())?;
        println!("{width}x{height} cones in {}", file.display());
    }
    Ok(())
}
