//! Dilation and erosion: the greatest and the least height around every dual cell.
//!
//! * Kolb and Rezk-Salama 2005, "Efficient empty space skipping for per-pixel displacement
//!   mapping".
//! * Szirmay-Kalos and Umenhoffer 2008, "Displacement mapping on the GPU: state of the art",
//!   section 4.3.2.
//! * van Herk 1992, "A fast algorithm for local minimum and maximum filters on rectangular and
//!   octagonal kernels", and Gil and Werman 1993, "Computing 2-D min, median, and max filters":
//!   three comparisons a texel and axis at any radius.
//!
//! # Guarantee
//!
//! *From anywhere over dual cell `(i, j)`, the surface at most `radius` texels away along both axes
//! is nowhere below the cell's `erosion` and nowhere above its `dilation`; both are attained.*
//!
//! Proof. These places make up the square of cells `i - radius ..= i + radius` by
//! `j - radius ..= j + radius`. A bilinear patch is a mean of its corners with weights that are not
//! negative, so over whole cells the surface takes its extremes at texels. The texels of that
//! square are `i - radius ..= i + radius + 1` by the like, wrapped as the map is. Their extremes
//! are stored. They are taken axis by axis, which is the same, because the window is a product of
//! intervals. Nothing rounds: in `f32` the bound is exact. With `bits` the bound holds for the
//! surface of the heights decoded from that many bits, and is as exact. Rounding to the nearest
//! never swaps two heights, so the extremes of rounded heights are the rounded extremes.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, MAX_SIDE, Rounding, Watch, Wrap};

use super::{BITS, Kind, Reach, to_nearest};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// The kind `dilation-erosion`.
pub const KIND: Kind = Kind {
    name: "dilation-erosion",
    summary: "least and greatest height within a radius of every dual cell",
    revision: 1,
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement mapping on the GPU; Kolb and Rezk-Salama \
                2005, Efficient empty space skipping",
        section: "4.3.2",
    },
    params: PARAMS,
    guarantee: "From anywhere over a dual cell, the bilinear surface within the radius along both axes is \
        nowhere below the erosion and nowhere above the dilation; both are attained. Exact in f32 and in as \
        many bits as the heights have.",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 2)],
    reach: |settings| Reach::Texels(settings.count(RADIUS).saturating_add(1)),
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Index of the parameter `radius`.
const RADIUS: usize = 0;

const PARAMS: &[Param] = &[
    Param {
        name: "radius",
        summary: "distance around a dual cell within which heights count, along both axes",
        unit: "texels",
        min: 0.0,
        max: MAX_SIDE as f32,
        default: 8.0,
        integer: true,
        names: &[],
    },
    BITS_OF_HEIGHTS,
];

/// Index of the parameter `bits`.
const BITS_PLACE: usize = 1;

/// Parameter for the bits of the extremes, which are rounded instead of the heights: the same
/// values, without a second map.
const BITS_OF_HEIGHTS: Param = Param { summary: "bits of the heights: 8 or 16, 0 for floats", ..BITS };

/// Least and greatest height around every dual cell, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct WindowBounds {
    /// Least heights: the erosion.
    pub min: Vec<f32>,
    /// Greatest heights: the dilation.
    pub max: Vec<f32>,
}

/// Computes the extremes of the surface over every dual cell grown by `radius` texels. A larger
/// radius takes no longer. Besides its two planes of results it takes one plane of memory (and 16
/// bytes a row, for each 512 columns).
///
/// # Errors
///
/// When it is cancelled.
pub fn window_bounds(map: &HeightMap, radius: u32, watch: &Watch) -> Result<WindowBounds, Cancelled> {
    let lower = |a: f32, b: f32| if a < b { a } else { b };
    let higher = |a: f32, b: f32| if a > b { a } else { b };
    let mut along_rows = vec![0.0; map.texels().len()];
    let (first, second) = (watch.piece(0.0, 0.5), watch.piece(0.5, 1.0));
    Ok(WindowBounds {
        min: extremes(map, radius, lower, f32::INFINITY, &mut along_rows, &first)?,
        max: extremes(map, radius, higher, f32::NEG_INFINITY, &mut along_rows, &second)?,
    })
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let radius = settings.count(RADIUS);
    let mut bounds = window_bounds(source.map, radius, watch)?;
    let channels = [
        Channel { name: "erosion", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Down },
        Channel { name: "dilation", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Up },
    ];
    sink.begin(&Texture {
        name: "",
        size: [source.map.width(), source.map.height(), 1],
        mips: Vec::new(),
        channels: channels.to_vec(),
        notes: vec![
            (
                "texels",
                "dual cells: texel (i, j) lies between the heights (i, j) and (i + 1, j + 1)".to_owned(),
            ),
            ("radius", format!("{radius} texels beyond the cell, along both axes")),
        ],
    })?;
    let bits = settings.count(BITS_PLACE);
    Ok(to_nearest(sink, &channels, bits, &mut [&mut bounds.min, &mut bounds.max])?)
}

/// Columns that a task of the vertical pass processes, so that the rows of a window stay cached.
const STRIP: usize = 512;

/// Texels between two progress reports: well below a millisecond of work.
const BATCH: usize = 1 << 16;

/// Computes the `pick` over every window of a map; any height is picked over `worst`. `along_rows`
/// is scratch for a plane.
fn extremes(
    map: &HeightMap,
    radius: u32,
    pick: impl Fn(f32, f32) -> f32 + Copy + Sync,
    worst: f32,
    along_rows: &mut [f32],
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let (width, height) = (map.width() as usize, map.height() as usize);
    let columns = Windows::new(map.wrap(), map.width(), radius);
    let rows = Windows::new(map.wrap(), map.height(), radius);
    let done = AtomicUsize::new(0);
    let at = |texels: usize| {
        let done = done.fetch_add(texels, Ordering::Relaxed) + texels;
        watch.at(done as f32 / (2 * width * height) as f32)
    };

    let band = width * BATCH.div_ceil(width);
    along_rows.par_chunks_mut(band).zip(map.texels().par_chunks(band)).try_for_each(|(picked, texels)| {
        let mut padded = vec![0.0; columns.texels.len()];
        for (picked, texels) in picked.chunks_mut(width).zip(texels.chunks(width)) {
            for (texel, column) in padded.iter_mut().zip(&columns.texels) {
                *texel = texels[*column as usize];
            }
            pick_row(&padded, columns.length, pick, worst, picked);
        }
        at(picked.len())
    })?;

    let along_rows = &*along_rows;
    let mut picked = vec![0.0; width * height];
    let blocks = BATCH.div_ceil(STRIP * rows.length);
    strips(&mut picked, width, blocks * rows.length).into_par_iter().try_for_each(|mut strip| {
        let columns = strip.rows[0].len();
        let mut best = vec![worst; columns];
        for (block, out) in strip.rows.chunks_mut(rows.length).enumerate() {
            let first = strip.first_row + block * rows.length;
            let source = |row: usize| {
                let start = rows.texels[first + row] as usize * width + strip.first_column;
                &along_rows[start..start + columns]
            };
            best.fill(worst);
            for row in (0..rows.length).rev() {
                pick_each(&mut best, source(row), pick);
                if let Some(out) = out.get_mut(row) {
                    out.copy_from_slice(&best);
                }
                if row % (BATCH / STRIP) == 0 {
                    at(0)?;
                }
            }
            best.fill(worst);
            for (row, out) in out.iter_mut().enumerate().skip(1) {
                pick_each(&mut best, source(rows.length + row - 1), pick);
                pick_each(out, &best, pick);
                if row % (BATCH / STRIP) == 0 {
                    at(0)?;
                }
            }
            at(out.iter().map(|row| row.len()).sum())?;
        }
        Ok(())
    })?;
    Ok(picked)
}

/// Windows of one axis.
struct Windows {
    /// Number of texels of a window.
    length: usize,
    /// Texels, wrapped, from the first window's first to the last window's last. Window `i` is
    /// `length` of them from index `i` on.
    texels: Vec<u32>,
}

impl Windows {
    fn new(wrap: Wrap, size: u32, radius: u32) -> Self {
        // A window of more than two tiles holds every texel, in any wrap.
        let radius = radius.min(size);
        let length = 2 * radius as usize + 2;
        let last = i64::from(size) + i64::from(radius);
        let texels = (-i64::from(radius)..=last).map(|texel| wrap.index(texel, size)).collect();
        Self { length, texels }
    }
}

/// Computes the `pick` of every window of `length` texels, in blocks of `length` windows. The part
/// of a window in its own block is picked backward from the block's end, the part in the next block
/// forward from there.
fn pick_row(texels: &[f32], length: usize, pick: impl Fn(f32, f32) -> f32, worst: f32, picked: &mut [f32]) {
    for (block, picked) in picked.chunks_mut(length).enumerate() {
        let (own, next) = texels[block * length..].split_at(length);
        let mut best = own[picked.len()..].iter().copied().fold(worst, &pick);
        for (out, texel) in picked.iter_mut().zip(own).rev() {
            best = pick(best, *texel);
            *out = best;
        }
        let mut best = worst;
        for (out, texel) in picked[1..].iter_mut().zip(next) {
            best = pick(best, *texel);
            *out = pick(*out, best);
        }
    }
}

fn pick_each(best: &mut [f32], others: &[f32], pick: impl Fn(f32, f32) -> f32) {
    for (best, other) in best.iter_mut().zip(others) {
        *best = pick(*best, *other);
    }
}

/// Rectangle of a plane, as slices of its rows.
struct Strip<'a> {
    first_column: usize,
    first_row: usize,
    rows: Vec<&'a mut [f32]>,
}

/// Divides a plane of that width into rectangles of [`STRIP`] columns and `rows` rows, at 16 bytes
/// a row of each.
fn strips(plane: &mut [f32], width: usize, rows: usize) -> Vec<Strip<'_>> {
    let mut strips = Vec::new();
    for (band, plane) in plane.chunks_mut(width * rows).enumerate() {
        let first = strips.len();
        for row in plane.chunks_mut(width) {
            for (column, piece) in row.chunks_mut(STRIP).enumerate() {
                if strips.len() == first + column {
                    strips.push(Strip {
                        first_column: column * STRIP,
                        first_row: band * rows,
                        rows: Vec::new(),
                    });
                }
                strips[first + column].rows.push(piece);
            }
        }
    }
    strips
}
