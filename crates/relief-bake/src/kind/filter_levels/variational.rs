//! Level with the least volume between its surface and the map's: iteratively reweighted least
//! squares.
//!
//! The volume `V = ∫ |f - f0|` is at most `∫ (d²/w + w) / 2` with `d = f - f0` and any `w`, and
//! equal to it for `w = |d|`. Least squares with the weights `1/|d|` of the last step therefore
//! lower it. Distances are held above a length that shrinks, so that weights stay finite. Each step
//! solves the weighted mass matrix of each tile. The steps start from the better of the average and
//! least squares. The result is the level of the least volume among the starts and all steps.

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch};

use super::system::System;
use super::tiles::Span;
use super::volume::Surfaces;

/// Steps, each over the whole map. Twelve would lower the volume by a thousandth more.
const STEPS: usize = 8;

/// Least distance in the first step, as a part of the mean distance.
const SMOOTH: f64 = 0.5;

/// Factor of this part from step to step.
const SHRINK: f64 = 0.6;

/// Returns the level's texels, row by row from the top: the ones of the least volume among the
/// starts and all later steps.
pub fn level(
    map: &HeightMap,
    size: [u32; 2],
    starts: [&[f32]; 2],
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let surfaces = Surfaces::new(map, size);
    let [across, down] = surfaces.axes.map(Span::all);
    let tiles = Tiles { surfaces: &surfaces, across, down };
    let count = (STEPS + starts.len() + 1) as f32;
    let pass = |number: usize| watch.piece(number as f32 / count, (number + 1) as f32 / count);
    let volumes = [tiles.volume(starts[0], &pass(0))?, tiles.volume(starts[1], &pass(1))?];
    let first = usize::from(volumes[1] < volumes[0]);
    let (mut best, mut least) = (starts[first].to_vec(), volumes[first]);
    let mut heights = best.clone();
    let mut smooth = SMOOTH * least / surfaces.area();
    for step in 0..STEPS {
        // Equal surfaces leave nothing to divide by.
        if smooth <= f64::from(f32::MIN_POSITIVE) {
            return Ok(best);
        }
        let (volume, next) = tiles.step(&heights, smooth, &pass(starts.len() + step))?;
        if volume < least {
            least = volume;
            best.copy_from_slice(&heights);
        }
        heights = next;
        smooth *= SHRINK;
    }
    let volume = tiles.volume(&heights, &pass(starts.len() + STEPS))?;
    Ok(if volume < least { heights } else { best })
}

/// Tiles of a level.
struct Tiles<'a> {
    surfaces: &'a Surfaces<'a>,
    across: Vec<Span>,
    down: Vec<Span>,
}

impl Tiles<'_> {
    /// Returns the volume, times the map's texels, between the map and a level of those heights.
    fn volume(&self, heights: &[f32], watch: &Watch) -> Result<f64, Cancelled> {
        let [columns, rows] = self.surfaces.axes.map(|axis| axis.cells());
        let cells: Vec<usize> = (0..columns).collect();
        let sums = (0..rows).into_par_iter().map(|row| {
            watch.at(row as f32 / rows as f32)?;
            let moments = self.surfaces.moments(heights, row, &cells, f64::MIN_POSITIVE);
            Ok(moments.iter().map(|moments| moments.volume).sum())
        });
        Ok(sums.collect::<Result<Vec<f64>, Cancelled>>()?.iter().sum())
    }

    /// Returns the volume before a step, and the heights after it.
    fn step(&self, heights: &[f32], smooth: f64, watch: &Watch) -> Result<(f64, Vec<f32>), Cancelled> {
        let tiles: Vec<(&Span, &Span)> =
            self.down.iter().flat_map(|down| self.across.iter().map(move |across| (across, down))).collect();
        let solved = tiles.par_iter().enumerate().map(|(at, (across, down))| {
            watch.at(at as f32 / tiles.len() as f32)?;
            Ok(self.solved(heights, smooth, across, down))
        });
        let solved = solved.collect::<Result<Vec<(f64, Vec<f32>)>, Cancelled>>()?;
        let nodes = self.surfaces.axes[0].nodes();
        let mut next = vec![0.0; heights.len()];
        for ((across, down), (_, own)) in tiles.iter().zip(&solved) {
            let first = across.nodes[across.own.start];
            for (place, own) in down.own.clone().zip(own.chunks(across.own.len())) {
                next[down.nodes[place] * nodes + first..][..own.len()].copy_from_slice(own);
            }
        }
        Ok((solved.iter().map(|(volume, _)| volume).sum(), next))
    }

    /// Returns the volume over a tile's own cells, and its own heights after a step.
    fn solved(&self, heights: &[f32], smooth: f64, across: &Span, down: &Span) -> (f64, Vec<f32>) {
        let cells: Vec<usize> = across.cells.iter().map(|cell| cell.cell).collect();
        let (mut system, mut volume) = (System::new(across, down), 0.0);
        for row in &down.cells {
            let moments = self.surfaces.moments(heights, row.cell, &cells, smooth);
            for (cell, moments) in across.cells.iter().zip(&moments) {
                if row.is_own && cell.is_own {
                    volume += moments.volume;
                }
                system.add(cell.ends, row.ends, moments);
            }
        }
        let nodes = self.surfaces.axes[0].nodes();
        let height = |column: usize, row: usize| heights[down.nodes[row] * nodes + across.nodes[column]];
        let change = system.solve(height);
        let mut own = Vec::with_capacity(across.own.len() * down.own.len());
        for row in down.own.clone() {
            for column in across.own.clone() {
                let moved = f64::from(height(column, row)) + change[row * across.nodes.len() + column];
                own.push(moved.clamp(0.0, 1.0) as f32);
            }
        }
        (volume, own)
    }
}
