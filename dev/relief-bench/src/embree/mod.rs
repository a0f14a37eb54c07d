//! `embree`: shells beside Embree over the triangles that they show, two a texel.

pub mod links;
mod ours;
mod python;
mod tessellation;

use std::path::PathBuf;

use clap::Args;
use glam::DVec3;
use relief_core::HeightMap;
use relief_core::camera::Ray;
use relief_core::mesh::{Mesh, torus};
use relief_core::rng::Rng;
use relief_tests::curved::{Curved, quantile};

use crate::python::require;
use crate::surfaces::Lies;
use crate::surfaces::bases::{TILES, cobbles};
use crate::table::table;
use ours::{Ours, Views};
use python::Answer;

/// Of how much less memory and time to prepare a shell is to take.
const AIM: f64 = 50.0;

/// From where the torus is seen.
const FROM: DVec3 = DVec3::new(0.6, 0.9, 1.1);

/// Columns and rows of the pictures whose rays are in no order, so that each ray meets other triangles.
const SCATTERED_SIZE: [u32; 2] = [32, 24];

/// Arguments of `embree`.
#[derive(Args)]
pub struct Arguments {
    /// A Python with numpy and embreex
    #[arg(long, default_value = "python3")]
    python: PathBuf,
    /// Methods of the shells
    #[arg(long, value_delimiter = ',', default_values = ["exact", "quadtree", "frustum"])]
    method: Vec<String>,
    /// Size of the picture, as WIDTHxHEIGHT
    #[arg(long, default_value = "800x600", value_parser = crate::cost::sides)]
    size: [u32; 2],
    /// Pictures of 32x24 pixels from random sides, whose rays are in no order
    #[arg(long, default_value_t = 400)]
    scattered: u32,
    /// Quads along the ring and around the tube of the torus
    #[arg(long, default_value = "32x16", value_parser = crate::cost::sides)]
    torus: [u32; 2],
    /// Where the relief lies
    #[arg(long, value_enum, default_value_t = Lies::Carved)]
    relief: Lies,
    /// Metres between the heights 0 and 1, on a torus that is 1 m large
    #[arg(long, default_value_t = 0.03)]
    scale: f64,
    /// Runs of each; medians count
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let map = cobbles()?;
    let tiles = [TILES.x as u32, TILES.y as u32];
    let [around, tube] = arguments.torus;
    let plain = torus(around, tube).map_err(|error| error.to_string())?;
    let tiled = plain.clone().tiled(TILES).map_err(|error| error.to_string())?;
    let once = repeated(&map, tiles)?;
    let relief = |mesh: &Mesh, map: &HeightMap| {
        let bias_m = arguments.relief.bias_m(arguments.scale);
        Curved::new(mesh.clone(), map, arguments.scale, bias_m)
    };
    let curved = relief(&tiled, &map);
    let triangles = tessellation::tessellated(&tiled, curved.map(), tiles)?;
    let views = views(arguments, &curved);

    let ours = [("tiled", curved.clone()), ("unique", relief(&plain, &once))];
    let ours = ours.map(|(name, curved)| {
        ours::measured(&curved, &arguments.method, &views, arguments.rounds).map(|measured| (name, measured))
    });
    let [tiled_ours, unique_ours] = ours;
    let ours = [tiled_ours?, unique_ours?];
    let answer = match require(&arguments.python, "import embreex, numpy", "embreex") {
        Err(reason) => {
            println!("Embree is left out: {reason}\n");
            None
        }
        Ok(()) => {
            let shuffled = shuffled(&views.picture);
            let sets = [
                ("picture", &views.picture[..]),
                ("shuffled", &shuffled[..]),
                ("scattered", &views.scattered[..]),
            ];
            Some(python::measured(&arguments.python, &triangles, &sets, arguments.rounds)?)
        }
    };
    print(arguments, &triangles, &ours, answer.as_ref());
    Ok(())
}

/// Map of several tiles of another one, with its texels.
fn repeated(map: &HeightMap, [across, down]: [u32; 2]) -> Result<HeightMap, String> {
    let texel = |i: u32, j: u32| map.texel(i.into(), j.into());
    let once = HeightMap::from_fn(across * map.width(), down * map.height(), map.wrap(), texel);
    once.map_err(|error| error.to_string())
}

/// Rays of one picture in order, and rays of many small pictures in no order.
fn views(arguments: &Arguments, curved: &Curved) -> Views {
    let rays = |camera: &relief_core::camera::Camera, [columns, rows]: [u32; 2]| -> Vec<Ray> {
        (0..columns * rows).map(|at| camera.ray(at % columns, at / columns, columns, rows)).collect()
    };
    let camera = curved.camera(FROM, 1.0);
    let mut rng = Rng::new(9);
    let cameras: Vec<_> = (0..arguments.scattered).map(|_| curved.random_camera(&mut rng, 1.0)).collect();
    let scattered: Vec<Ray> = cameras.iter().flat_map(|camera| rays(camera, SCATTERED_SIZE)).collect();
    Views {
        picture: rays(&camera, arguments.size),
        scattered: shuffled(&scattered),
        camera,
        size: arguments.size,
        cameras,
        small: SCATTERED_SIZE,
    }
}

/// The same rays in no order.
fn shuffled(rays: &[Ray]) -> Vec<Ray> {
    let (mut rng, mut rays) = (Rng::new(4), rays.to_vec());
    for last in (1..rays.len()).rev() {
        rays.swap(last, rng.below(last as u32 + 1) as usize);
    }
    rays
}

fn print(
    arguments: &Arguments,
    triangles: &tessellation::Triangles,
    ours: &[(&str, Vec<Ours>); 2],
    answer: Option<&Answer>,
) {
    let mut table = table(&[
        "texture",
        "tracer",
        "memory bytes",
        "Embree's over it",
        "preparation ms",
        "Embree's over it",
        "rays/s, picture",
        "shuffled",
        "scattered",
        "hits otherwise",
        "depth p50",
        "p99",
    ]);
    let count = triangles.corners.len();
    let [width, height] = arguments.size;
    println!(
        "A torus of {}x{} quads with {}x{} tiles of cobbles, {}: {count} triangles, two a texel. One thread, \
         processor time, medians of {} runs. Picture: {width}x{height} pixels in rows. Scattered: {} \
         pictures of {}x{} from random sides.",
        arguments.torus[0],
        arguments.torus[1],
        TILES.x,
        TILES.y,
        arguments.relief.name(),
        arguments.rounds,
        arguments.scattered,
        SCATTERED_SIZE[0],
        SCATTERED_SIZE[1],
    );
    let rate = |rate: Option<f64>| rate.map_or("-".to_owned(), |rate| format!("{rate:.0}"));
    let mut missed = Vec::new();
    for (texture, measured) in ours {
        for one in measured {
            let over = answer
                .map(|answer| [answer.bytes / one.bytes as f64, answer.build_s[0] / one.prepared_s.median()]);
            if *texture == "tiled" && over.is_some_and(|over| over.iter().any(|over| *over < AIM)) {
                missed.push(one.name.clone());
            }
            let over = over.map_or(["-"; 2].map(str::to_owned), |over| over.map(|over| format!("{over:.1}")));
            let [bytes_over, time_over] = over;
            let beside = answer.map(|answer| differences(&one.depths, &answer.sets["picture"].1));
            let beside = beside.map(|[otherwise, middle, far]| {
                let scaled = |metres: f64| format!("{:.4}", metres / arguments.scale);
                [format!("{:.3} %", 100.0 * otherwise), scaled(middle), scaled(far)]
            });
            let first = [
                (*texture).to_owned(),
                one.name.clone(),
                one.bytes.to_string(),
                bytes_over,
                one.prepared_s.times(1e3).to_string(),
                time_over,
                rate(Some(one.picture.median())),
                rate(one.shuffled.as_ref().map(|rate| rate.median())),
                rate(Some(one.scattered.median())),
            ];
            table.add_row(first.into_iter().chain(beside.unwrap_or(["-"; 3].map(str::to_owned))));
        }
    }
    if let Some(answer) = answer {
        let of = |set: &str| rate(answer.sets.get(set).map(|(rate, _)| *rate));
        let [cpu_s, wall_s] = answer.build_s;
        let numbers = [
            "either".to_owned(),
            format!("Embree (embreex {})", answer.version),
            format!("{:.0}", answer.bytes),
            "1".to_owned(),
            format!("{:.1} (wall {:.1})", 1e3 * cpu_s, 1e3 * wall_s),
            "1".to_owned(),
            of("picture"),
            of("shuffled"),
            of("scattered"),
        ];
        table.add_row(numbers.into_iter().chain(["-"; 3].map(str::to_owned)));
        println!("Embree holds {:.1} bytes a triangle, with its points.", answer.bytes / count as f64);
    }
    println!("\n{table}\n");
    if answer.is_some() {
        println!(
            "Aim: a {AIM}th of Embree's memory and preparation over the tiled texture. {}",
            if missed.is_empty() { "Reached.".to_owned() } else { format!("Missed: {}.", missed.join(", ")) }
        );
    }
}

/// The share of rays that hit for one only, and the median and 99th percentile of how far hits are apart.
fn differences(ours: &[Option<f64>], theirs: &[f32]) -> [f64; 3] {
    // What Embree does not hit is as far as a number can be.
    let theirs: Vec<Option<f64>> =
        theirs.iter().map(|depth| (*depth < 1e9).then_some(f64::from(*depth))).collect();
    let pairs = || ours.iter().zip(&theirs);
    let otherwise = pairs().filter(|(a, b)| a.is_some() != b.is_some()).count();
    let apart: Vec<f64> = pairs().filter_map(|(a, b)| Some(((*a)? - (*b)?).abs())).collect();
    [otherwise as f64 / ours.len().max(1) as f64, quantile(&apart, 0.5), quantile(&apart, 0.99)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use relief_core::Wrap;

    #[test]
    fn differences_see_what_is_changed() {
        let ours = [Some(1.0), None, Some(2.0), Some(3.0)];
        assert_eq!(differences(&ours, &[1.0, f32::INFINITY, 2.0, 3.0]), [0.0; 3]);
        let [otherwise, middle, far] = differences(&ours, &[1.25, 5.0, 2.0, 1e30]);
        assert_eq!((otherwise, middle, far), (0.5, 0.25, 0.25));
    }

    #[test]
    fn a_map_that_is_repeated_has_the_same_heights() {
        let map = HeightMap::from_fn(3, 2, Wrap::Repeat, |i, j| 0.1 * (i + 3 * j) as f32);
        let map = map.expect("a map");
        let once = repeated(&map, [2, 3]).expect("a map");
        assert_eq!([once.width(), once.height()], [6, 6]);
        let scale = DVec2::new(2.0, 3.0);
        for [u, v] in [[0.1, 0.2], [0.95, 0.4], [0.51, 0.99]] {
            assert!((once.height_at(u, v) - map.height_at(u * scale.x, v * scale.y)).abs() < 1e-6);
        }
    }
}
