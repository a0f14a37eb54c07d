//! Times over the covered pixels and over the triangles: Szirmay-Kalos and Umenhoffer 2008, section 7, which
//! has displaced vertices cost by triangles, seen or not, and fragments by covered pixels.

use relief_compare::{Contender, Records, Timing};
use relief_core::camera::Camera;
use relief_scene::Sampling;
use relief_tests::accuracy::maps;

use super::{Arguments, compared, contender, on_square};
use crate::table::table;

/// Pictures of the same view, each of four times as many pixels as the one before.
const SIZES: [[u32; 2]; 4] = [[80, 60], [160, 120], [320, 240], [640, 480]];

/// How many times as far away the eye is in pictures that show less and less of the same triangles.
const DISTANCES: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

/// Texels between vertices: 131,072, 32,768, 8,192 and 2,048 triangles of a map of 256 x 256.
const TEXELS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

fn contenders() -> Result<Vec<Contender>, String> {
    let mut contenders = vec![contender("bump", &[])?, contender("relief", &[])?, contender("cone", &[])?];
    for texels in TEXELS {
        contenders.push(contender("vertex", &[("geometry.texels", texels)])?);
    }
    Ok(contenders)
}

/// Prints a table over sizes and one over distances, for each machine.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let comparison = |size: [u32; 2]| {
        let named =
            maps().into_iter().find(|named| named.name == "cobbles").ok_or("the sample map is missing")?;
        let mut comparison = on_square(named.name, named.map, size, arguments.machines(&[Sampling::Exact]))?;
        (comparison.rays, comparison.contenders) = (0, contenders()?);
        comparison.timing = Some(Timing { frames: arguments.frames, warm: 2, pixels: 1 });
        Ok::<_, String>(comparison)
    };
    let mut by_size = Vec::new();
    for size in SIZES {
        by_size.push((format!("{}x{}", size[0], size[1]), compared(&comparison(size)?)?));
    }
    let mut by_distance = Vec::new();
    for times in DISTANCES {
        let mut comparison = comparison(SIZES[2])?;
        let camera = comparison.scene.camera();
        let (eye, target) = (camera.eye(), camera.target());
        let farther: Camera =
            camera.moved(target + (eye - target) * times, target).map_err(|error| error.to_string())?;
        comparison.scene.set_camera(farther);
        by_distance.push((format!("{times} times as far"), compared(&comparison)?));
    }
    println!(
        "Milliseconds of a frame, of cobbles on a square without shadows, the triangles kept from frame to \
         frame\n"
    );
    for machine in by_size[0].1.about.machines.clone() {
        let on = (machine.backend.as_str(), machine.sampling.as_str());
        println!("{}, {} sampling, on {}\n", machine.backend, machine.sampling, machine.device);
        println!("{}\n", frames(&by_size, on));
        println!("{}\n", frames(&by_distance, on));
    }
    Ok(())
}

/// Milliseconds of frames, a column for each of some records.
fn frames(columns: &[(String, Records)], on: (&str, &str)) -> comfy_table::Table {
    let header: Vec<&str> =
        ["method"].into_iter().chain(columns.iter().map(|(name, _)| name.as_str())).collect();
    let mut rows = table(&header);
    let Some((_, first)) = columns.first() else { return rows };
    let names =
        first.pictures.iter().filter(|record| (record.backend.as_str(), record.sampling.as_str()) == on);
    for name in names.map(|record| record.method.label()) {
        let cells = columns.iter().map(|(_, records)| {
            let found = records.pictures.iter().find(|record| {
                record.method.label() == name && (record.backend.as_str(), record.sampling.as_str()) == on
            });
            found.and_then(|record| record.times.as_ref()).map_or("-".to_owned(), |times| {
                format!("{:.2} ({:.2} to {:.2})", times.frame_ms, times.frame_low_ms, times.frame_high_ms)
            })
        });
        rows.add_row([name.clone()].into_iter().chain(cells));
    }
    rows
}
