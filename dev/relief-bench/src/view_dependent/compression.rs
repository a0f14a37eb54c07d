//! Compressed view-dependent maps beside plain ones: error over bytes and over what is read.

use std::time::Instant;

use rayon::prelude::*;
use relief_bake::{WantedMap, baked_map, kind};
use relief_core::exact::cell_walk;
use relief_core::rng::Rng;
use relief_core::{BakedMap, HeightMap, Lanes, MapFormat, MapIdentity, Metric, Path, Watch};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_tests::baked::{maps_in, slots};

use super::{SIDE, maps, ray, with_axes};
use crate::table::table;

/// Sizes of plain maps: azimuths, elevations and bends.
const PLAIN: [[u32; 3]; 9] = [
    [4, 2, 1],
    [4, 4, 1],
    [8, 4, 1],
    [8, 8, 1],
    [16, 8, 1],
    [16, 16, 1],
    [16, 8, 4],
    [16, 16, 4],
    [16, 16, 16],
];

/// A compressed map: its method, size, rank, clusters and bits.
type Compressed = (&'static str, [u32; 3], u32, u32, u32);

const SVD: &str = "view-dependent-svd";
const CLUSTERS: &str = "view-dependent-clusters";

const COMPRESSED: [Compressed; 18] = [
    (SVD, [16, 16, 1], 4, 0, 8),
    (SVD, [16, 16, 1], 8, 0, 8),
    (SVD, [16, 16, 1], 16, 0, 8),
    (SVD, [16, 16, 1], 32, 0, 8),
    (SVD, [16, 16, 1], 32, 0, 16),
    (SVD, [16, 16, 1], 64, 0, 8),
    (SVD, [16, 16, 1], 128, 0, 8),
    (SVD, [16, 16, 1], 128, 0, 16),
    (SVD, [16, 16, 16], 8, 0, 8),
    (SVD, [16, 16, 16], 32, 0, 8),
    (SVD, [16, 16, 16], 128, 0, 8),
    (CLUSTERS, [16, 16, 1], 8, 8, 8),
    (CLUSTERS, [16, 16, 1], 8, 64, 8),
    (CLUSTERS, [16, 16, 1], 12, 64, 8),
    (CLUSTERS, [16, 16, 1], 12, 64, 16),
    (CLUSTERS, [16, 16, 1], 12, 256, 8),
    (CLUSTERS, [16, 16, 16], 12, 8, 8),
    (CLUSTERS, [16, 16, 16], 12, 64, 8),
];

/// Prints a table for each of two maps.
pub fn run(rays: usize) -> Result<(), String> {
    for (name, map) in maps()?.into_iter().filter(|(name, _)| ["rock023", "cobbles"].contains(name)) {
        let mut rows = table(&[
            "method",
            "azimuths x elevations x bends",
            "terms",
            "clusters",
            "bits",
            "map, MB",
            "baked in, s",
            "bytes read",
            "off by 1/2 texel, straight",
            "bent",
            "median, texels, straight",
            "rays a second",
        ]);
        for size in PLAIN {
            let selection = with_axes("view-dependent", size)?;
            rows.add_row(row_of(&map, &selection, ["view-dependent", "", "", "8"], size, rays)?);
        }
        for (method, size, rank, clusters, bits) in COMPRESSED {
            let mut selection = with_axes(method, size)?;
            let set = |selection: &mut Selection, key: &str, value: u32| {
                selection.set(key, f64::from(value)).map_err(|error| error.to_string())
            };
            set(&mut selection, "search.rank", rank)?;
            if clusters > 0 {
                set(&mut selection, "search.clusters", clusters)?;
            }
            let clusters = if clusters > 0 { clusters.to_string() } else { String::new() };
            let texts = [method, &rank.to_string(), &clusters, &bits.to_string()];
            rows.add_row(row_of(&map, &selection, texts, size, rays)?);
        }
        println!("{name}, {SIDE}x{SIDE}\n\n{rows}\n");
    }
    Ok(())
}

/// A map's row. The bake uses all cores, rays one.
fn row_of(
    map: &HeightMap,
    selection: &Selection,
    [method, rank, clusters, bits]: [&str; 4],
    size: [u32; 3],
    rays: usize,
) -> Result<Vec<String>, String> {
    let started = Instant::now();
    let (baked, value_bytes) = match bits {
        "16" => (of_16_bits(map, selection)?, 2),
        _ => (maps_in(MapFormat::Unorm8, map, selection), 1),
    };
    let bake_s = started.elapsed().as_secs_f64();
    let layouts = baked.iter().map(BakedMap::layout);
    let bytes: u64 = layouts.map(|layout| layout.texels() * u64::from(layout.channels) * value_bytes).sum();
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    let (mut off, mut median, mut read, mut seconds) = (Vec::new(), 0.0, 0.0, 0.0);
    for is_bent in [false, true] {
        let mut rng = Rng::new(3);
        let paths: Vec<Path> = (0..rays).map(|_| ray(&mut rng, is_bent)).collect();
        let mut hits = vec![tracer.first_hit(&paths[0]); paths.len()];
        let started = Instant::now();
        tracer.first_hits(&paths, Lanes::widest(), &mut hits);
        seconds += started.elapsed().as_secs_f64();
        read += hits.iter().map(|hit| f64::from(hit.cost.bytes)).sum::<f64>();
        let mut aside: Vec<f64> = paths
            .par_iter()
            .zip(&hits)
            .map(|(path, hit)| {
                let truth = cell_walk(map, path).hit;
                match (hit.found, truth.found) {
                    (true, true) => {
                        (hit.t - truth.t).abs() * path.duv[0].hypot(path.duv[1]) * f64::from(SIDE)
                    }
                    (false, false) => 0.0,
                    _ => f64::INFINITY,
                }
            })
            .collect();
        let wrong = aside.iter().filter(|&&aside| aside > 0.5).count();
        off.push(format!("{:.1} %", 100.0 * wrong as f64 / rays as f64));
        aside.sort_by(f64::total_cmp);
        if !is_bent {
            median = aside[rays / 2];
        }
    }
    let size = size.map(|count| count.to_string()).join(" x ");
    let mut row = [method, &size, rank, clusters, bits].map(str::to_owned).to_vec();
    row.extend([format!("{:.2}", bytes as f64 / 1e6), format!("{bake_s:.2}")]);
    row.push(format!("{:.0}", read / (2 * rays) as f64));
    row.extend(off);
    row.extend([format!("{median:.3}"), format!("{:.2} million", 2.0 * rays as f64 / seconds / 1e6)]);
    Ok(row)
}

/// The maps with factors of 16 bits, as floats. They take the place of maps of 8 bits, which methods ask for.
fn of_16_bits(map: &HeightMap, selection: &Selection) -> Result<Vec<BakedMap>, String> {
    let bake_one = |need: relief_shaders::MapNeed| {
        let kind = kind(need.input.kind).map_err(|error| error.to_string())?;
        let mut settings = kind.defaults();
        for (name, value) in &need.settings {
            let value = if *name == "bits" { 16.0 } else { f64::from(*value) };
            settings.set(name, value).map_err(|error| error.to_string())?;
        }
        let (texture, levels) = (need.input.texture, need.input.levels);
        let (metric, format) = (need.metric(Metric::UNIT), MapFormat::F32);
        let wanted = WantedMap { kind, texture, settings, metric, levels, height_level: 0, format };
        let baked = baked_map(map, &wanted, &Watch::none()).map_err(|error| error.to_string())?;
        let mut identity: MapIdentity = baked.identity().clone();
        identity.settings.iter_mut().filter(|(name, _)| name == "bits").for_each(|(_, bits)| *bits = 8.0);
        let (layout, codes, texels) = (*baked.layout(), *baked.codes(), baked.texels().clone());
        BakedMap::new(identity, layout, codes, texels).map_err(|error| error.to_string())
    };
    selection.map_needs().into_iter().map(bake_one).collect()
}
