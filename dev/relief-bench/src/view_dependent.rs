//! `view-dependent`: view-dependent maps of several sizes beside other methods, and whether the bound holds.

mod compression;
mod torus;

use std::f64::consts::TAU;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;
use relief_core::exact::{cell_walk, least_gap};
use relief_core::rng::Rng;
use relief_core::{BakedMap, HeightMap, Hit, Lanes, MapFormat, MapTexels, Path, PathMetric, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_testing::maps::fractal;
use relief_tests::accuracy::sample_maps;
use relief_tests::baked::{maps_in, slots};

use crate::compare::maps::rock;
use crate::table::table;

/// Depth of the relief, as a part of a tile's side.
const DEPTH: f64 = 0.1;

/// Greatest angle between ray and normal, in degrees.
const MOST_DEGREES: f64 = 80.0;

/// Columns and rows of the maps.
const SIDE: u32 = 128;

/// Heights by which a ray may be below the surface before its hit, by the rounding of `f32`.
const ROUNDING: f64 = 4e-6;

/// Sizes of maps of hits: azimuths, elevations and bends.
const OF_HITS: [[u32; 3]; 4] = [[16, 8, 1], [16, 16, 1], [16, 8, 4], [16, 16, 4]];

/// Sizes of maps of free ways.
const OF_WAYS: [[u32; 3]; 5] = [[8, 8, 1], [16, 8, 1], [16, 16, 1], [16, 8, 4], [16, 8, 8]];

/// Other methods that are set beside them.
const OTHERS: [&str; 6] = ["relief", "occlusion", "cone", "frustum", "quadtree", "exact"];

/// Arguments of `view-dependent`.
#[derive(Args)]
pub struct Arguments {
    /// What is measured
    #[arg(value_enum, default_values = ["bound", "methods"])]
    parts: Vec<Part>,
    /// Rays over each map in each wrap, for the bound
    #[arg(long, value_name = "N", default_value_t = 670_000)]
    rays: usize,
    /// Rays over the map, in the table of methods
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    rays_of_methods: usize,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// Rays over free ways beside the truth: none may pass the surface
    Bound,
    /// Errors, reads, bytes and times of every size, beside other methods
    Methods,
    /// Compressed maps beside plain ones: errors over bytes
    Compression,
    /// On a torus, beside other methods and generalised maps
    Torus,
}

/// Prints the tables. Fails where a ray passes the surface on a free way.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let mut holds = true;
    for part in &arguments.parts {
        match part {
            Part::Bound => holds &= bound(arguments.rays)?,
            Part::Methods => methods(arguments.rays_of_methods)?,
            Part::Compression => compression::run(arguments.rays_of_methods)?,
            Part::Torus => torus::run()?,
        }
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A sample map, of [`SIDE`] columns and rows.
fn sample(file: &str) -> Result<HeightMap, String> {
    let map = read_height(&sample_maps().join(file), &HeightOptions::default()).map_err(|e| e.to_string())?;
    let (width, height) = (map.width(), map.height());
    let texel = |i: u32, j: u32| map.texel(i64::from(i * width / SIDE), i64::from(j * height / SIDE));
    HeightMap::from_fn(SIDE, SIDE, Wrap::Repeat, texel).map_err(|error| error.to_string())
}

/// The maps by name.
fn maps() -> Result<Vec<(&'static str, HeightMap)>, String> {
    let made = |texels: Vec<f32>| HeightMap::new(SIDE, SIDE, texels, Wrap::Repeat).map_err(|e| e.to_string());
    let count = (SIDE * SIDE) as usize;
    let mut rng = Rng::new(5);
    let noise = (0..count).map(|_| rng.unit() as f32).collect();
    let mut spikes = vec![0.0; count];
    for _ in 0..200 {
        spikes[rng.below(count as u32) as usize] = 1.0;
    }
    let mut maps = vec![
        ("jacksboro", sample("jacksboro.png")?),
        ("cobbles", sample("cobbles.png")?),
        ("fractal", made(fractal(7, SIDE, SIDE, 0.5))?),
        ("noise", made(noise)?),
        ("spikes", made(spikes)?),
        ("flat", made(vec![0.25; count])?),
    ];
    match rock()? {
        // Of 1024 columns and rows.
        Some(rock) => maps.insert(0, ("rock023", rock.level(3))),
        None => println!("rock023 is left out: RELIEF_DATA names no folder of data.\n"),
    }
    Ok(maps)
}

/// A ray from the relief's top, up to [`MOST_DEGREES`] from the normal. A bent one has `β` from -¼ to ¼: from
/// one that falls ever faster to one that just touches height 0.
fn ray(rng: &mut Rng, is_bent: bool) -> Path {
    let (angle, tilt) = (TAU * rng.unit(), (MOST_DEGREES * rng.unit()).to_radians());
    let length = DEPTH * tilt.tan();
    let bend = if is_bent { 0.5 * rng.unit() - 0.25 } else { 0.0 };
    let exit = 2.0 / (1.0 + (1.0 - 4.0 * bend).sqrt()) * (1.0 + 1e-6);
    // Of numbers as shaders have them.
    let to_f32 = |x: f64| f64::from(x as f32);
    Path {
        uv: [rng.unit(), rng.unit()].map(to_f32),
        duv: [length * angle.cos(), length * angle.sin()].map(to_f32),
        h: [1.0, -1.0, to_f32(bend)],
        exit: to_f32(exit),
        base: 0.0,
        metric: PathMetric::unit(DEPTH),
    }
}

/// A method with the steps of its map's axes.
fn with_axes(method: &str, [azimuths, elevations, bends]: [u32; 3]) -> Result<Selection, String> {
    let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
    for (name, count) in
        [("search.azimuths", azimuths), ("search.elevations", elevations), ("search.bends", bends)]
    {
        selection.set(name, f64::from(count)).map_err(|error| error.to_string())?;
    }
    Ok(selection)
}

/// Whether a ray was below the surface before its hit, or before its end without one.
fn is_late(map: &HeightMap, path: &Path, hit: &Hit) -> bool {
    let end = if hit.found { hit.t } else { path.exit };
    least_gap(map, path, 0.0, end * (1.0 - 1e-5)) < -ROUNDING
}

/// Whether a hit is more than half a texel from the true one, or one is there without the other.
fn is_off(map: &HeightMap, path: &Path, hit: &Hit) -> bool {
    let truth = cell_walk(map, path).hit;
    let aside = (hit.t - truth.t).abs() * path.duv[0].hypot(path.duv[1]) * f64::from(SIDE);
    hit.found != truth.found || (hit.found && aside > 0.5)
}

/// Rays over free ways, straight and bent.
fn bound(rays: usize) -> Result<bool, String> {
    let mut rows = table(&["map", "rays", "late", "late by ways an eighth too long"]);
    let selection = with_axes("view-dependent-free", [16, 8, 4])?;
    let mut holds = true;
    for (name, map) in maps()? {
        let (mut asked, mut late, mut noticed) = (0, 0, 0);
        for wrap in Wrap::ALL {
            let map = map.clone().with_wrap(wrap);
            let baked = maps_in(MapFormat::Unorm8, &map, &selection);
            let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
            let found: Vec<[usize; 2]> = (0..rays.div_ceil(1000))
                .into_par_iter()
                .map(|piece| {
                    let mut rng = Rng::new(piece as u64);
                    let paths: Vec<Path> = (0..1000).map(|k| ray(&mut rng, k % 2 == 1)).collect();
                    let hits = paths.iter().map(|path| tracer.first_hit(path));
                    let late = paths.iter().zip(hits).filter(|(path, hit)| is_late(&map, path, hit)).count();
                    [paths.len(), late]
                })
                .collect();
            asked += found.iter().map(|[rays, _]| rays).sum::<usize>();
            late += found.iter().map(|[_, late]| late).sum::<usize>();
            noticed += usize::from(wrap == Wrap::Repeat) * too_long(&map, &selection)?;
        }
        holds &= late == 0;
        rows.add_row([name.to_owned(), asked.to_string(), late.to_string(), noticed.to_string()]);
    }
    println!(
        "Free ways of 16 azimuths, 8 elevations and 4 bends: rays up to {MOST_DEGREES} degrees from the \
         normal, half of them bent, a third of them in each wrap; a relief as deep as a tenth of the tile. A \
         ray is late if it was more than {ROUNDING:e} of the depth below the surface before its hit.\n\n\
         {rows}\n"
    );
    Ok(holds)
}

/// The rays of ten thousand that are late where every way is an eighth of the whole way longer.
fn too_long(map: &HeightMap, selection: &Selection) -> Result<usize, String> {
    let longer = |known: BakedMap| {
        let MapTexels::Unorm8(codes) = known.texels() else {
            return Err("codes of 8 bits are expected".to_owned());
        };
        let codes = codes.iter().map(|code| code.saturating_add(32)).collect();
        let made = BakedMap::new(
            known.identity().clone(),
            *known.layout(),
            *known.codes(),
            MapTexels::Unorm8(codes),
        );
        made.map_err(|error| error.to_string())
    };
    let baked = maps_in(MapFormat::Unorm8, map, selection);
    let baked = baked.into_iter().map(longer).collect::<Result<Vec<_>, _>>()?;
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    let mut rng = Rng::new(1);
    let paths: Vec<Path> = (0..10_000).map(|k| ray(&mut rng, k % 2 == 1)).collect();
    Ok(paths.par_iter().filter(|path| is_late(map, path, &tracer.first_hit(path))).count())
}

/// Every size of map, and other methods.
fn methods(rays: usize) -> Result<(), String> {
    for (name, map) in maps()?.into_iter().take(3) {
        let mut rows = table(&[
            "method",
            "azimuths x elevations x bends",
            "map, MB",
            "baked in, s",
            "reads, straight",
            "bent",
            "off by 1/2 texel, straight",
            "bent",
            "late",
            "rays a second",
        ]);
        let sized = |method: &'static str, sizes: &'static [[u32; 3]]| {
            sizes.iter().map(move |size| (method, Some(*size)))
        };
        let all = sized("view-dependent", &OF_HITS)
            .chain(sized("view-dependent-free", &OF_WAYS))
            .chain(OTHERS.map(|method| (method, None)));
        for (method, size) in all {
            let (selection, format) = match size {
                Some(size) => (with_axes(method, size)?, MapFormat::Unorm8),
                None => (Selection::method(method).map_err(|error| error.to_string())?, MapFormat::F32),
            };
            let size = size.map_or_else(String::new, |size| size.map(|count| count.to_string()).join(" x "));
            rows.add_row([vec![method.to_owned(), size], row_of(&map, &selection, format, rays)].concat());
        }
        println!("{name}, {SIDE}x{SIDE}\n\n{rows}\n");
    }
    Ok(())
}

/// A method's row. Bakes use all cores, rays one.
fn row_of(map: &HeightMap, selection: &Selection, format: MapFormat, rays: usize) -> Vec<String> {
    let started = Instant::now();
    let baked = maps_in(format, map, selection);
    let bake_s = started.elapsed().as_secs_f64();
    let bytes = baked.iter().map(|map| map.layout().bytes()).sum::<u64>();
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    let (mut reads, mut off, mut late) = (Vec::new(), Vec::new(), 0);
    let mut seconds = 0.0;
    for is_bent in [false, true] {
        let mut rng = Rng::new(3);
        let paths: Vec<Path> = (0..rays).map(|_| ray(&mut rng, is_bent)).collect();
        let mut hits = vec![tracer.first_hit(&paths[0]); paths.len()];
        let started = Instant::now();
        tracer.first_hits(&paths, Lanes::widest(), &mut hits);
        seconds += started.elapsed().as_secs_f64();
        let sum = hits.iter().map(|hit| f64::from(hit.cost.reads)).sum::<f64>();
        reads.push(format!("{:.1}", sum / rays as f64));
        let both = || paths.par_iter().zip(&hits);
        let wrong = both().filter(|(path, hit)| is_off(map, path, hit)).count();
        off.push(format!("{:.1} %", 100.0 * wrong as f64 / rays as f64));
        late += both().filter(|(path, hit)| is_late(map, path, hit)).count();
    }
    let rate = 2.0 * rays as f64 / seconds;
    [
        vec![format!("{:.2}", bytes as f64 / 1e6), format!("{bake_s:.2}")],
        reads,
        off,
        vec![format!("{:.1} %", 50.0 * late as f64 / rays as f64), format!("{:.1} million", rate / 1e6)],
    ]
    .concat()
}
