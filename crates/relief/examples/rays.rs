//! Traces rays exactly and by a method, and says how far apart the answers are.

use std::error::Error;

use relief::exact::FastTracer;
use relief::maps::Maps;
use relief::shaders::Selection;
use relief::shaders::cpu::MethodTracer;
use relief::{HeightMap, Metric, Path, Watch, Wrap};

fn main() -> Result<(), Box<dyn Error>> {
    let wave = |i: u32, j: u32| 0.5 + 0.4 * (i as f32 * 0.3).sin() * (j as f32 * 0.2).cos();
    let heights = HeightMap::from_fn(128, 128, Wrap::Repeat, wave)?;
    let truth = FastTracer::new(&heights);

    let mut maps = Maps::in_memory();
    for name in ["relief", "occlusion", "cone"] {
        let selection = Selection::method(name)?;
        // Cone stepping reads a baked map; the others read none.
        let provided = maps.provide(&selection, &heights, Metric::UNIT, &Watch::none())?;
        let baked: Vec<_> = provided.maps().iter().map(|(_, map)| &**map).collect();
        let method = MethodTracer::new(&heights, Metric::UNIT, &selection, baked)?;

        let (mut worst, mut reads) = (0.0f64, 0);
        for k in 0..100 {
            let from = f64::from(k) / 100.0;
            let path = Path::between([from, 0.1, 1.0], [from + 0.5, 0.4, 0.0]);
            let (exact, found) = (truth.trace(&path).hit, method.first_hit(&path));
            worst = worst.max((exact.t - found.t).abs());
            reads += found.cost.reads;
        }
        println!("{name}: at most {worst:.6} of the path from the truth, {} reads a ray", reads / 100);
    }
    Ok(())
}
