//! Every method on five maps, beside the exact answer.

use relief_compare::{Contender, RayRecord};
use relief_core::{HeightMap, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_tests::accuracy::sample_maps;
use relief_tests::data_dir;

use super::{compared, contender, on_square};
use crate::table::table;

/// A map with the level of it that is compared.
type Named = (&'static str, HeightMap);

/// A scan of rock of 1024x1024 texels, where it is at hand.
pub fn rock() -> Result<Option<HeightMap>, String> {
    let Some(folder) = data_dir() else { return Ok(None) };
    let options = HeightOptions { channel: Some("a".to_owned()), ..HeightOptions::default() };
    let rock = read_height(&folder.join("rock023_alb_ht.png"), &options);
    rock.map(Some).map_err(|error| error.to_string())
}

/// A scan of rock, an elevation model, cobbles, a logo and white noise; the scan where it is at hand.
pub fn maps() -> Result<Vec<Named>, String> {
    let sample = |name: &'static str, file: &str, wrap: Wrap| -> Result<Named, String> {
        let options = HeightOptions { wrap: Some(wrap), ..HeightOptions::default() };
        read_height(&sample_maps().join(file), &options)
            .map(|map| (name, map))
            .map_err(|error| error.to_string())
    };
    let mut maps = Vec::new();
    match rock()? {
        // As large as the scan that such tables were first made of.
        Some(rock) => maps.push(("rock023", rock.level(2))),
        None => println!("rock023 is left out: RELIEF_DATA names no folder of data.\n"),
    }
    maps.push(sample("jacksboro", "jacksboro.png", Wrap::Mirror)?);
    maps.push(sample("cobbles", "cobbles.png", Wrap::Repeat)?);
    maps.push(sample("logo", "logo.png", Wrap::Repeat)?);
    maps.push(sample("noise", "noise.png", Wrap::Repeat)?);
    Ok(maps)
}

/// All methods that search, and one with more steps.
fn contenders() -> Result<Vec<Contender>, String> {
    let mut contenders: Vec<Contender> = Contender::all().into_iter().filter(Contender::is_of_rays).collect();
    contenders.push(contender("relief", &[("search.steps", 128.0)])?);
    Ok(contenders)
}

/// Prints a table a map: means over four angles.
pub fn run(rays: u32) -> Result<(), String> {
    println!(
        "{rays} rays a map at each of 10, 30, 60 and 85 degrees; relief as deep as a tenth of the tile. \
         Means over the angles, and the 99th percentile at the worst.\n"
    );
    for (name, map) in maps()? {
        let size = [map.width(), map.height()];
        let mut comparison = on_square(name, map, [8, 8], Vec::new())?;
        (comparison.rays, comparison.contenders) = (rays, contenders()?);
        let records = compared(&comparison)?;
        let mut rows = table(&[
            "method",
            "promise",
            "reads",
            "turns",
            "miss %",
            "late %",
            "early %",
            "stopped %",
            "mean texels",
            "worst p99 texels",
            "map bytes a texel",
            "bake s",
        ]);
        for of_method in records.rays.chunk_by(|a, b| a.method.label() == b.method.label()) {
            let mean =
                |of: fn(&RayRecord) -> f64| of_method.iter().map(of).sum::<f64>() / of_method.len() as f64;
            let percent = |of: fn(&RayRecord) -> f64| format!("{:.3}", 100.0 * mean(of));
            let [first, ..] = of_method else { continue };
            let worst = of_method.iter().map(|record| record.error.p99_texels).fold(0.0, f64::max);
            rows.add_row([
                first.method.label(),
                first.method.promise.clone(),
                format!("{:.1}", mean(|record| record.cost.reads)),
                format!("{:.1}", mean(|record| record.cost.turns)),
                percent(|record| record.error.missed),
                percent(|record| record.error.late),
                percent(|record| record.error.early),
                percent(|record| record.error.exhausted),
                format!("{:.4}", mean(|record| record.error.mean_texels)),
                format!("{worst:.3}"),
                format!("{:.1}", first.method.bytes_a_texel()),
                format!("{:.3}", first.method.bake_seconds),
            ]);
        }
        println!("{name} ({}x{})\n{rows}\n", size[0], size[1]);
    }
    Ok(())
}
