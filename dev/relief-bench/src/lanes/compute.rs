//! Searches and refinements over lanes, beside the same shaders in a compute pass of the machine's adapter,
//! which on machines without a GPU is a software one on the same cores.

use std::sync::Arc;

use rayon::prelude::*;
use relief_core::{HeightMap, Lanes, MapFormat, Wrap};
use relief_render::gpu::{AdapterChoice, Gpu, Prober};
use relief_shaders::Selection;
use relief_shaders::cpu::{BLOCK, HitBlock, MethodTracer, Path, PathBlock};
use relief_shaders::wgsl::Sampling;
use relief_tests::baked::{maps_in, slots};
use relief_tests::one_source::cases::bare_surface;

use super::frames::fastest;
use super::rays::{ground, view};
use super::stages::{METHODS, SIDE, block_of, selection};
use crate::table::table;
use crate::trace::view::SCALE_M;

/// The widths that are compared.
const WIDTHS: [Lanes; 2] = [Lanes::Eight, Lanes::Sixteen];

/// How many times faster than the adapter's exact sampling both widths are to be, and than its fast sampling
/// each.
const AIMS: [[f64; 2]; 2] = [[5.0, 5.0], [1.0, 1.8]];

/// What is measured of a method, in nanoseconds a ray.
struct Measured {
    lanes: [f64; 2],
    /// With exact and with fast sampling.
    adapter: [f64; 2],
}

pub fn run(rounds: u16) -> Result<(), String> {
    let gpu = match Gpu::new(AdapterChoice::Any) {
        Ok(gpu) => gpu,
        Err(error) => {
            println!("Compute passes are left out: {error}\n");
            return Ok(());
        }
    };
    let device = gpu.description().to_owned();
    let mut prober = Prober::new(gpu);
    let map =
        ground(SIDE, Wrap::Clamp)?.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())?;
    let map = Arc::new(map);
    let view: Vec<Path> = view(&map)?.iter().map(Path::from).collect();
    let mut rows = table(&[
        "method",
        "ns, 8 lanes",
        "ns, 16",
        "adapter, exact",
        "fast",
        "exact over lanes",
        "fast over lanes",
    ]);
    let mut missed = Vec::new();
    for (name, _) in METHODS {
        let selection = selection(name)?;
        let Measured { lanes, adapter } = measured(&mut prober, &map, &selection, &view, rounds)?;
        for (sampling, (adapter, aims)) in ["exact", "fast"].into_iter().zip(adapter.iter().zip(AIMS)) {
            for (width, (lanes, aim)) in WIDTHS.into_iter().zip(lanes.iter().zip(aims)) {
                if adapter / lanes < aim {
                    missed.push(format!("{name} over {width} lanes beside {sampling} sampling"));
                }
            }
        }
        let [exact, fast] = adapter.map(|adapter| lanes.map(|lanes| format!("{:.2}", adapter / lanes)));
        rows.add_row([
            name.to_owned(),
            format!("{:.1}", lanes[0]),
            format!("{:.1}", lanes[1]),
            format!("{:.1}", adapter[0]),
            format!("{:.1}", adapter[1]),
            exact.join(" / "),
            fast.join(" / "),
        ]);
    }
    println!(
        "Compute passes over the view's {} paths, on {device}, beside lanes on {} threads: nanoseconds a \
         path, the fastest of {rounds} rounds.\n\n{rows}\n\n\
         Aim: {} and {} times with exact sampling, {} and {} with fast. {}\n",
        view.len(),
        rayon::current_num_threads(),
        AIMS[0][0],
        AIMS[0][1],
        AIMS[1][0],
        AIMS[1][1],
        if missed.is_empty() {
            "Reached everywhere.".to_owned()
        } else {
            format!("Missed: {}.", missed.join("; "))
        }
    );
    Ok(())
}

/// A method over the paths on both, which find the same.
fn measured(
    prober: &mut Prober,
    map: &Arc<HeightMap>,
    selection: &Selection,
    paths: &[Path],
    rounds: u16,
) -> Result<Measured, String> {
    let blocks: Vec<(PathBlock, u16)> = paths.chunks(BLOCK).map(block_of).collect();
    let baked = maps_in(MapFormat::F32, map, selection);
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    let mut hits = WIDTHS.map(|_| vec![HitBlock::default(); blocks.len()]);
    let [eight, sixteen] = &mut hits;
    let over = |lanes: Lanes, hits: &mut [HitBlock]| {
        let each = blocks.par_iter().zip(hits).with_min_len(256);
        each.for_each(|((block, which), hits)| tracer.trace_block(block, *which, lanes, hits));
    };
    let (mut over_eight, mut over_sixteen) = (|| over(WIDTHS[0], eight), || over(WIDTHS[1], sixteen));
    let lanes = fastest(rounds, [&mut over_eight, &mut over_sixteen]);
    let surface = bare_surface(Arc::clone(map), *selection, maps_in(MapFormat::F32, map, selection));
    let found = prober.trace(&surface, Sampling::Exact, paths).map_err(|error| error.to_string())?;
    let others = |hits: &[HitBlock]| {
        found.iter().enumerate().filter(|(at, hit)| **hit != hits[at / BLOCK].get(at % BLOCK)).count()
    };
    let others = hits.iter().map(|hits| others(hits)).max().unwrap_or_default();
    if others > 0 {
        return Err(format!("{others} of {} paths end elsewhere in the compute pass", paths.len()));
    }
    let of_a_path = |seconds: f64| seconds * 1e9 / paths.len() as f64;
    let mut adapter = [0.0; 2];
    for (adapter, sampling) in adapter.iter_mut().zip([Sampling::Exact, Sampling::Fast]) {
        let taken = prober.trace_time(&surface, sampling, paths, rounds);
        *adapter = of_a_path(taken.map_err(|error| error.to_string())?.as_secs_f64());
    }
    Ok(Measured { lanes: lanes.map(of_a_path), adapter })
}
