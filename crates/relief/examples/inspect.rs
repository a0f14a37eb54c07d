//! Loads a height map from a file, and from the file's bytes, and says what it holds.

use std::error::Error;

use relief::io::{HeightOptions, Source, inspect, read_height, write_png16};

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::temp_dir().join("relief-heights.png");
    let samples: Vec<u16> = (0..64 * 48).map(|at| 500 * (at % 64) + 100 * (at / 64)).collect();
    write_png16(&file, 64, 48, &samples)?;

    let options = HeightOptions::default();
    let info = inspect(&file, &options)?;
    println!("{}x{} texels, {}", info.width, info.height, info.format.name());
    if let Some(values) = info.values {
        println!("{} levels from {:?}", values.levels, values.range);
        println!("tiles along u and v: {:?}", values.tiling.map(|tiling| tiling.tiles));
    }

    let heights = read_height(&file, &options)?;
    println!("height at the middle: {:.3}", heights.height_at(0.5, 0.5));
    let bytes = std::fs::read(&file)?;
    assert_eq!(read_height(Source::bytes("heights.png", &bytes), &options)?, heights);
    Ok(())
}
