//! Search and refinement over lanes, beside one ray at a time.

use std::time::Instant;

use relief_core::{Cost, Hit, Lanes, MapFormat, Path, Wrap};
use relief_shaders::Selection;
use relief_shaders::cpu::{BLOCK, HitBlock, MethodTracer, PathBlock};
use relief_tests::baked::{maps_in, slots};

use super::frames::least;
use super::rays::{ground, scattered, view};
use crate::table::table;

/// Texels along a side of the map.
pub const SIDE: u32 = 512;

/// How many blocks are in the nearest cache together, with their hits.
const NEAR: usize = 16;

/// Compared widths. x86-64 has them all.
const WIDTHS: [Lanes; 3] = [Lanes::One, Lanes::Eight, Lanes::Sixteen];

/// Methods, and how many times faster they are to be over eight and over sixteen lanes.
pub const METHODS: [(&str, [f64; 2]); 5] = [
    ("relief", [3.5, 6.5]),
    ("occlusion", [3.5, 6.5]),
    ("exact", [3.5, 6.5]),
    ("cone", [3.5, 6.5]),
    ("frustum", [3.5, 4.5]),
];

/// The same of rays that are scattered.
const SCATTERED: [f64; 2] = [1.7, 2.7];

pub fn run(rounds: u16) -> Result<(), String> {
    let mut rows =
        table(&["rays", "wrap", "method", "ns one by one", "ns, 8 lanes", "ns, 16", "times", "aim"]);
    let (view, scattered) = (view(&ground(SIDE, Wrap::Clamp)?)?, scattered());
    for wrap in [Wrap::Clamp, Wrap::Repeat] {
        let map = ground(SIDE, wrap)?;
        for (name, aims) in METHODS {
            let selection = selection(name)?;
            let baked = maps_in(MapFormat::F32, &map, &selection);
            let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
            for (kind, paths, aims) in [("view", &view, aims), ("scattered", &scattered, SCATTERED)] {
                let [one, eight, sixteen] = measured(&tracer, paths, rounds)?;
                rows.add_row([
                    kind.to_owned(),
                    wrap.to_string(),
                    name.to_owned(),
                    format!("{one:.0}"),
                    format!("{eight:.0}"),
                    format!("{sixteen:.0}"),
                    format!("{:.2} / {:.2}", one / eight, one / sixteen),
                    format!("{} / {}", aims[0], aims[1]),
                ]);
            }
        }
    }
    println!("One thread, the fastest of {rounds} rounds.\n\n{rows}\n");
    Ok(())
}

/// A method as it is measured.
pub fn selection(name: &str) -> Result<Selection, String> {
    let mut selection = Selection::method(name).map_err(|error| error.to_string())?;
    if name == "relief" {
        selection.set("refine.steps", 5.0).map_err(|error| error.to_string())?;
    }
    Ok(selection)
}

/// Nanoseconds a ray one by one and over lanes, of blocks that are there before.
fn measured(tracer: &MethodTracer, paths: &[Path], rounds: u16) -> Result<[f64; 3], String> {
    let of_core: Vec<_> = paths.iter().map(relief_shaders::cpu::Path::from).collect();
    let blocks: Vec<(PathBlock, u16)> = of_core.chunks(BLOCK).map(block_of).collect();
    let mut hits = WIDTHS.map(|_| vec![HitBlock::default(); blocks.len()]);
    let mut ways = WIDTHS.into_iter().zip(&mut hits).map(|(lanes, hits)| {
        let blocks = &blocks;
        move || traced(tracer, lanes, blocks, hits)
    });
    let (Some(mut one), Some(mut eight), Some(mut sixteen)) = (ways.next(), ways.next(), ways.next()) else {
        return Err("three widths are compared".to_owned());
    };
    let least = least(rounds, [&mut one, &mut eight, &mut sixteen]);
    let [one, eight, sixteen] = &hits;
    let mut singly = vec![Hit::miss(Cost::default()); paths.len()];
    tracer.first_hits(paths, Lanes::One, &mut singly);
    let is_same = |blocks: &[HitBlock]| {
        (0..paths.len()).all(|at| singly[at] == Hit::from(&blocks[at / BLOCK].get(at % BLOCK)))
    };
    if [one, eight, sixteen].into_iter().all(|blocks| is_same(blocks)) {
        Ok(least.map(|seconds| seconds * 1e9 / paths.len() as f64))
    } else {
        Err("lanes give other hits than single rays".to_owned())
    }
}

/// Traces blocks; in how many seconds. As in the renderer, what goes into a tracer and comes out of it is in
/// the nearest cache: it is brought there, and taken away, while no time is measured.
fn traced(tracer: &MethodTracer, lanes: Lanes, blocks: &[(PathBlock, u16)], hits: &mut [HitBlock]) -> f64 {
    let mut seconds = 0.0;
    let mut near_hits = vec![HitBlock::default(); NEAR];
    for (blocks, hits) in blocks.chunks(NEAR).zip(hits.chunks_mut(NEAR)) {
        let near = blocks.to_vec();
        let near_hits = &mut near_hits[..hits.len()];
        let start = Instant::now();
        for ((block, which), hits) in near.iter().zip(&mut *near_hits) {
            tracer.trace_block(block, *which, lanes, hits);
        }
        seconds += start.elapsed().as_secs_f64();
        hits.clone_from_slice(near_hits);
    }
    seconds
}

/// At most sixteen paths as a block, and which places they have.
pub fn block_of(paths: &[relief_shaders::cpu::Path]) -> (PathBlock, u16) {
    let mut block = PathBlock::default();
    for (at, path) in paths.iter().enumerate() {
        block.set(at, path);
    }
    (block, u16::MAX >> (BLOCK - paths.len()))
}
