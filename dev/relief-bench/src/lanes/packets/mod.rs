//! The exact tracer one by one and in packets, beside Embree's packets where Embree is installed.

mod program;

use std::hint::black_box;

use cpu_time::ThreadTime;
use relief_core::exact::{ExactHit, FastTracer, HitPacket, PathPacket};
use relief_core::{HeightMap, Lanes, Path, Wrap};

use super::rays::{ground, scattered, shadows, view};
use crate::table::table;
use crate::trace::view::{SCALE_M, SIZE};
use program::Embree;

/// Texels along the sides of the maps.
const SIDES: [u32; 2] = [512, 2048];

/// Packets that are made before time is measured: so few that they and their answers are in the nearest
/// cache, as in a renderer. Embree's program does the same.
const BATCH: usize = 16;

/// How many times as many rays as Embree.
const AIM_SIXTEEN: f64 = 1.1;
const AIM_EIGHT: f64 = 1.0;
const AIM_SCATTERED: f64 = 1.3;
const AIM_LARGE: f64 = 1.5;

/// How many times faster than Embree's set-up.
const AIM_SETUP: f64 = 50.0;

const SETS: [&str; 3] = ["view", "shadow", "scattered"];

pub fn run(rounds: u16) -> Result<(), String> {
    let header = ["map", "rays", "lanes", "one by one", "packets", "times", "Embree", "width", "to Embree"];
    let mut hits = table(&header);
    let mut blocked =
        table(&["map", "rays", "lanes", "one by one", "packets", "times", "Embree", "to Embree"]);
    let mut setup = table(&["map", "ms", "Embree ms", "times"]);
    let mut missed = Vec::new();
    for side in SIDES {
        let map = ground(side, Wrap::Clamp)?;
        let tracer = FastTracer::new(&map);
        let view = view(&map)?;
        let sets = [&view, &shadows(&map, &tracer, &view), &scattered()];
        let embree = beside(&map, &sets);
        if let Err(reason) = &embree {
            println!("Not measured beside Embree: {reason}\n");
        }
        // There are none of fewer lanes.
        for lanes in Lanes::available().filter(|lanes| *lanes >= Lanes::Eight) {
            let theirs =
                embree.as_ref().ok().map(|embree| embree.measured(&SETS, lanes, rounds)).transpose()?;
            for (name, paths) in SETS.into_iter().zip(sets) {
                let ours = measured(&tracer, paths, lanes, rounds)?;
                let of_embree = theirs.as_ref().and_then(|answer| answer.sets.get(name));
                let named = |rate: f64| format!("{:.1}", rate / 1e6);
                let or_none = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
                let first = |[one, packets]: [f64; 2]| {
                    let map = format!("{side}²");
                    let times = format!("{:.2}", packets / one);
                    [map, name.to_owned(), lanes.to_string(), named(one), named(packets), times]
                };
                // Whoever knows that rays are scattered takes them one by one, of us and of Embree.
                let best =
                    |[one, packets]: [f64; 2]| if name == SETS[2] { one.max(packets) } else { packets };
                let over = of_embree.map(|rates| best(ours.found) / rates.intersected);
                hits.add_row(first(ours.found).into_iter().chain([
                    or_none(of_embree.map(|rates| named(rates.intersected))),
                    or_none(of_embree.map(|rates| rates.width.to_string())),
                    or_none(over.map(|over| format!("{over:.2}"))),
                ]));
                blocked.add_row(first(ours.blocked).into_iter().chain([
                    or_none(of_embree.map(|rates| named(rates.occluded))),
                    or_none(of_embree.map(|rates| format!("{:.2}", best(ours.blocked) / rates.occluded))),
                ]));
                let aim = match name {
                    "view" if side > SIDES[0] => Some(AIM_LARGE),
                    "view" if lanes == Lanes::Sixteen => Some(AIM_SIXTEEN),
                    "view" => Some(AIM_EIGHT),
                    "scattered" => Some(AIM_SCATTERED),
                    _ => None,
                };
                if let Some((aim, over)) = aim.zip(over)
                    && over < aim
                {
                    missed.push(format!("{name} {side}², {lanes} lanes: {over:.2} of {aim}"));
                }
            }
            if lanes == Lanes::widest() {
                let seconds = set_up(&map, rounds)?;
                let over = theirs.map(|answer| answer.build_s).map(|theirs| (theirs, theirs / seconds));
                let [theirs, times] = match over {
                    Some((theirs, over)) => [format!("{:.0}", 1e3 * theirs), format!("{over:.0}")],
                    None => ["-"; 2].map(str::to_owned),
                };
                setup.add_row([format!("{side}²"), format!("{:.2}", 1e3 * seconds), theirs, times]);
                if let Some((_, over)) = over
                    && over < AIM_SETUP
                {
                    missed.push(format!("set-up {side}²: {over:.0} of {AIM_SETUP}"));
                }
            }
        }
    }
    println!(
        "First hits, million rays a second of processor time on one thread, the best of {rounds} rounds; all \
         answers of packets have the bits of those one by one. The picture is {}x{}, in blocks of 4 x 4 \
         pixels.\n\n\
         {hits}\n\nWhether anything is in the way:\n\n{blocked}\n\nSet-up:\n\n{setup}\n",
        SIZE[0], SIZE[1]
    );
    let verdict = if missed.is_empty() { "None is missed".to_owned() } else { missed.join("; ") };
    println!("Aims beside Embree: {verdict}.");
    Ok(())
}

fn beside(map: &HeightMap, sets: &[&Vec<Path>; SETS.len()]) -> Result<Embree, String> {
    let embree = Embree::new(map)?;
    for (name, paths) in SETS.iter().zip(sets) {
        let ray = |path: &Path| {
            let [u, v] = [path.uv[0] - 0.5, path.uv[1] - 0.5];
            let [height, rise] = [path.h[0] * SCALE_M, path.h[1] * SCALE_M];
            [u, height, v, path.duv[0], rise, path.duv[1], path.exit].map(|x| x as f32)
        };
        embree.add(name, paths.iter().map(ray))?;
    }
    Ok(embree)
}

/// Rays a second, one by one and in packets.
struct Ours {
    found: [f64; 2],
    blocked: [f64; 2],
}

fn measured(tracer: &FastTracer, paths: &[Path], lanes: Lanes, rounds: u16) -> Result<Ours, String> {
    let packets: Vec<PathPacket> = paths.chunks(PathPacket::LEN).map(PathPacket::new).collect();
    let mut answers = [HitPacket::MISSES; BATCH];
    for (paths, packets) in paths.chunks(BATCH * PathPacket::LEN).zip(packets.chunks(BATCH)) {
        tracer.trace_packets(packets, lanes, &mut answers);
        let found = answers.iter().flat_map(|packet| (0..PathPacket::LEN).map(|lane| packet.hit(lane)));
        if paths.iter().zip(found).any(|(path, found)| bits(&found) != bits(&tracer.trace(path))) {
            return Err("a packet's answer is not that of a single ray".to_owned());
        }
    }
    let best = |trace: &mut dyn FnMut() -> f64| {
        let seconds = (0..rounds).map(|_| trace());
        paths.len() as f64 / seconds.fold(f64::INFINITY, f64::min)
    };
    let one = best(&mut || {
        timed(paths, BATCH * PathPacket::LEN, |paths| {
            for path in paths {
                black_box(tracer.trace(path));
            }
        })
    });
    let together = best(&mut || {
        timed(&packets, BATCH, |packets| tracer.trace_packets(packets, lanes, black_box(&mut answers)))
    });
    let one_blocked = best(&mut || {
        timed(paths, BATCH * PathPacket::LEN, |paths| {
            for path in paths {
                black_box(tracer.is_blocked(path));
            }
        })
    });
    let together_blocked = best(&mut || {
        timed(&packets, BATCH, |packets| {
            for packets in packets.as_chunks::<BATCH>().0 {
                black_box(tracer.blocked_packets(packets, lanes));
            }
            for packet in packets.as_chunks::<BATCH>().1 {
                black_box(tracer.blocked_packets(std::array::from_ref(packet), lanes));
            }
        })
    });
    Ok(Ours { found: [one, together], blocked: [one_blocked, together_blocked] })
}

/// Seconds of processor time that some work takes over all items. It gets a batch of them at a time, which is
/// copied before time is measured and so is in the nearest cache.
fn timed<T: Clone>(items: &[T], batch: usize, mut work: impl FnMut(&[T])) -> f64 {
    let mut near = Vec::with_capacity(batch);
    let seconds = items.chunks(batch).map(|items| {
        near.clear();
        near.extend_from_slice(items);
        let start = ThreadTime::now();
        work(&near);
        start.elapsed().as_secs_f64()
    });
    seconds.sum()
}

/// All that an answer says, bit by bit.
fn bits(answer: &ExactHit) -> ([u64; 6], [i64; 2], [bool; 2], relief_core::Cost) {
    let ExactHit { hit, cell, slope, clearance } = answer;
    let numbers = [hit.t, hit.uv[0], hit.uv[1], hit.height, *slope, *clearance].map(f64::to_bits);
    (numbers, *cell, [hit.found, hit.exhausted], hit.cost)
}

/// Seconds of processor time to set up a tracer, on one thread.
fn set_up(map: &HeightMap, rounds: u16) -> Result<f64, String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(|error| error.to_string())?;
    let seconds = (0..rounds).map(|_| {
        pool.install(|| {
            let start = ThreadTime::now();
            black_box(FastTracer::new(map));
            start.elapsed().as_secs_f64()
        })
    });
    Ok(seconds.fold(f64::INFINITY, f64::min))
}
