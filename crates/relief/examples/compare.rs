//! Compares two methods with the exact answer and writes the page that shows it.

use std::error::Error;

use relief::compare::{Comparison, Contender, page};
use relief::mesh::square;
use relief::scene::{Scene, Surface};
use relief::{HeightMap, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
    let surface = Surface::new(square(1)?, heights.with_displacement(0.05, -0.05)?);
    let mut comparison = Comparison::new("steps", Scene::builder(surface).size(64, 48).build()?);
    comparison.contenders = vec![Contender::named("relief")?, Contender::named("cone")?];
    comparison.rays = 500;
    (comparison.flicker_samples, comparison.timing) = (None, None);
    let compared = comparison.run(&Watch::none())?;

    for record in &compared.records.rays {
        let (method, error) = (&record.method.method, record.error.p99_texels);
        println!("{method}, rays at {} degrees: 99 % within {error:.3} texels", record.angle_deg);
    }
    let file = std::env::temp_dir().join("relief-comparison.html");
    std::fs::write(&file, page(&compared)?)?;
    println!("the page is {}", file.display());
    Ok(())
}
