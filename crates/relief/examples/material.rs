//! Bakes the maps of a material from its heights: height, normal and ambient occlusion, as PNG files.

use std::error::Error;

use relief::bake::{Collected, bake, kind};
use relief::io::{PngColour, write_png8, write_png16};
use relief::{HeightMap, Metric, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let stones = |i: u32, j: u32| ((i as f32 * 0.1).sin() * (j as f32 * 0.1).sin()).abs().sqrt();
    let heights = HeightMap::from_fn(126, 126, Wrap::Repeat, stones)?;
    let [width, height] = [heights.width(), heights.height()];
    let folder = std::env::temp_dir().join("relief-material");
    std::fs::create_dir_all(&folder)?;

    let levels: Vec<u16> = heights.texels().iter().map(|texel| (texel * 65535.0).round() as u16).collect();
    write_png16(&folder.join("height.png"), width, height, &levels)?;

    // A tile of half a metre, and 2 cm between heights 0 and 1.
    let metric = Metric { tile_m: [0.5, 0.5], scale_m: 0.02 };
    for name in ["normal", "occlusion"] {
        let kind = kind(name)?;
        let mut baked = Collected::default();
        bake(kind, &heights, metric, &kind.defaults(), &Watch::none(), &mut baked)?;
        let map = baked.textures.first().ok_or("a kind has a texture")?;
        // Values lie channel by channel; a PNG has the channels of a texel side by side.
        // A normal's first three are its axes; further ones describe coarser levels.
        let channels = &map.levels[0][..map.levels[0].len().min(3)];
        let mut codes = Vec::with_capacity(channels.len() * channels[0].len());
        for texel in 0..channels[0].len() {
            for (values, channel) in channels.iter().zip(&map.texture.channels) {
                let [black, white] = channel.range;
                codes.push((255.0 * (values[texel] - black) / (white - black)).round() as u8);
            }
        }
        let colour = if channels.len() == 1 { PngColour::Grey } else { PngColour::Rgb };
        write_png8(&folder.join(format!("{name}.png")), width, height, colour, &codes)?;
    }
    println!("height.png, normal.png and occlusion.png in {}", folder.display());
    Ok(())
}
