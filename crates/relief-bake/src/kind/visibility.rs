//! Precomputed visibility: the first hit from every texel in fixed directions.
//!
//! Heidrich, Daubert, Kautz and Seidel 2000, *Illuminating micro geometry based on precomputed
//! visibility*; Szirmay-Kalos and Umenhoffer 2008, section 6.2. Along a fixed azimuth and slope the
//! first hit is a next-greater-element query: in a frame that rises with the rays, the first column
//! that is higher than the texel. A stack of records along the sheared lines of the horizon's sweep
//! (see [`horizon`](super::horizon)) answers it in O(1). The remaining cells are solved: mostly one
//! or two, and on ridges along the ray as many as the ridge is long.
//!
//! # What is stored
//!
//! Slice `a * elevations + e` looks at azimuth `a`, at the angle `2π a / azimuths` in metres from
//! `+u` towards `+v`, under the elevation with `sin² = (e + ½) / elevations`. Every slice thus
//! stands for the same part of the cosine-weighted hemisphere about the base normal. Channels `u`
//! and `v` are the texture coordinates of the first hit in `[0, 1]`, wrapped into the map. `hit` is
//! 1, or 0 where the ray leaves the relief. A ray that starts into the surface sees its own texel.
//!
//! # Guarantee
//!
//! Hits are the exact first hits of the rays from the texels' centres with the bilinear surface,
//! solved in closed form in `f64` cell by cell. The exception is flips where the ray clears the
//! surface by no more than rounding, 1e-6 heights. The distance is then rounded to `f32`. The
//! record stack only says which cells may be skipped. Line `b` carries at column `c` the highest
//! point `A(c)` of the surface at most `½ + p` rows aside, where `p` is the rows that a ray moves a
//! step. A ray of the line is never more than half a row off it, so on the way to and from column
//! `c` it stays in those rows. Between the columns `c` and `c + 1` the surface at row `y` is a
//! mixture of the surface in the two columns,
//! `(1-τ) f(c, y) + τ f(c+1, y) <= (1-τ) A(c) + τ A(c+1)`. So where the ray is not below `A` in
//! both columns it is not below the surface between them. `A` is rounded in `f32`: a ray may dip
//! below the surface by 2e-7 heights unnoticed.
//!
//! A ray is followed until it is above the highest texel, or for `tiles` times the map's side along
//! the axis that it crosses faster, at least for 64 texels. Farther hits are not found.

mod gather;
mod rays;

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{HeightMap, Metric, Rounding, Watch, Wrap};

pub use gather::Visibility;

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{self, Direction, unit_vector};
use crate::sheared_lines::{Band, Plane, Rows};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

pub(super) const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "number of elevations in each azimuth, equally spaced in the squared sine",
    unit: "",
    min: 1.0,
    max: 64.0,
    default: 4.0,
    integer: true,
    names: &[],
};

pub(super) const TILES: Param =
    Param { summary: "length of a ray, in tiles", default: 4.0, ..azimuths::TILES };

/// Rows of the map that one task copies into place together.
const BAND: usize = 32;

/// The kind `visibility`.
pub const KIND: Kind = Kind {
    name: "visibility",
    summary: "the first point hit in each of some fixed directions, for shadows and bounced light",
    revision: 1,
    publication: Publication {
        paper: "Heidrich et al. 2000; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.2",
    },
    params: &[azimuths::AZIMUTHS, ELEVATIONS, TILES, BITS_TO_NEAREST],
    guarantee: "the exact first hit with the bilinear surface, to rounding of f32",
    is_picture: false,
    of_volume: false,
    shapes: |size, settings| vec![Shape::slices("", size, settings.count(0) * settings.count(1), 3)],
    reach: |_| Reach::Everything,
    working_maps: |settings| settings.count(1) as f32 + 5.5,
    bake,
};

/// First hits of all texels in one direction. The ray of a texel starts on the surface at the
/// texel's centre.
#[derive(Clone, Debug, PartialEq)]
pub struct View<'a> {
    /// Direction of unit length: along `+u`, along `+v` and up the base normal.
    pub direction: [f64; 3],
    /// Change of the texture coordinates a step.
    pub step_uv: [f64; 2],
    /// Steps to the first hit of every texel, row by row from the top; infinite for none.
    pub steps: &'a [f32],
    size: [u32; 2],
}

impl View<'_> {
    /// Returns the texture coordinates of the first hit of a texel's ray. The ray starts on the
    /// surface at the texel's centre and goes along [`direction`](Self::direction).
    ///
    /// A tile of the map is 0 to 1. Coordinates are not wrapped, so hits in other tiles lie
    /// outside. `None` if the ray leaves the relief or has no hit within its reach. The texel must
    /// be in the map.
    pub fn hit(&self, column: u32, row: u32) -> Option<[f64; 2]> {
        let [width, height] = self.size.map(f64::from);
        let steps = f64::from(self.steps[row as usize * self.size[0] as usize + column as usize]);
        steps.is_finite().then(|| {
            [
                (f64::from(column) + 0.5) / width + self.step_uv[0] * steps,
                (f64::from(row) + 0.5) / height + self.step_uv[1] * steps,
            ]
        })
    }

    /// Returns the texel nearest to the [`hit`](Self::hit) of a texel's ray, as
    /// `row * width + column`.
    ///
    /// `wrap` is the map's wrap, which brings hits in other tiles into the map. `None` if there is
    /// no hit: the texel sees the sky. The texel must be in the map.
    pub fn seen(&self, column: u32, row: u32, wrap: Wrap) -> Option<usize> {
        let [width, height] = self.size;
        let index = |at: f64, side: u32| wrap.index((at * f64::from(side)).floor() as i64, side) as usize;
        let [u, v] = self.hit(column, row)?;
        Some(index(v, height) * width as usize + index(u, width))
    }
}

/// Computes the views in `azimuths` times `elevations` directions, azimuth by azimuth and from the
/// lowest elevation, and hands each to `take`. `tiles` is the reach in tiles. See the
/// [module](self) for their meaning and accuracy.
///
/// The working set is two maps of `f32` besides the input, and one for each elevation, for any
/// number of azimuths.
///
/// # Errors
///
/// When memory does not suffice, the bake is cancelled, or `take` fails.
pub fn views(
    map: &HeightMap,
    metric: Metric,
    [azimuths, elevations]: [u32; 2],
    tiles: u32,
    watch: &Watch,
    take: &mut dyn FnMut(&View) -> Result<(), BakeError>,
) -> Result<(), BakeError> {
    let rows = Rows::with_transpose(map);
    let (width, texels) = (map.width() as usize, map.texels().len());
    let mut sheared = Vec::new();
    let size = texels.checked_mul(elevations as usize);
    size.filter(|&size| sheared.try_reserve_exact(size).is_ok()).ok_or_else(|| BakeError::Impossible {
        kind: KIND.name,
        reason: format!("{elevations} elevations of {texels} texels do not fit in memory: use fewer"),
    })?;
    sheared.resize(texels * elevations as usize, 0.0f32);
    let mut steps = vec![0.0; texels];
    let (low, high) = map.texels().iter().fold((1.0f32, 0.0f32), |(low, high), &x| (low.min(x), high.max(x)));
    for azimuth in 0..azimuths {
        let piece = watch.piece(azimuth as f32 / azimuths as f32, (azimuth + 1) as f32 / azimuths as f32);
        let direction = Direction::azimuth(azimuth, azimuths, metric.texel_m(map));
        let limit = rows.reach(&direction, tiles.max(1));
        let squares: Vec<f64> =
            (0..elevations).map(|e| (f64::from(e) + 0.5) / f64::from(elevations)).collect();
        let rays: Vec<rays::SlopedRay> = squares
            .iter()
            .map(|square| {
                let slope = (square / (1.0 - square)).sqrt() * direction.step_m / metric.scale_m;
                let out = f64::from(high - low) / slope;
                // Two more steps: the column beyond which the ray is out, and rounding.
                rays::SlopedRay { slope, reach: (out + 2.0).min(limit as f64) as usize }
            })
            .collect();
        let reach = rays.iter().map(|ray| ray.reach).max().unwrap_or(0);
        let lines = rows.lines(&direction, reach + 1);
        rays::first_hits(&lines, &rays, &mut sheared, &piece)?;
        let [cos, sin] = unit_vector(azimuth, azimuths);
        for (e, square) in squares.iter().enumerate() {
            let plane = Plane {
                texels: &sheared,
                stride: rays.len() * lines.length,
                offset: e * lines.length,
                slots: 0..lines.count,
            };
            steps.par_chunks_mut(BAND * width).enumerate().for_each(|(number, steps)| {
                let top = number * BAND;
                let Some(mut band) = Band::new(&lines, top..top + steps.len() / width, &plane.slots) else {
                    return;
                };
                band.unshear(&lines, &plane);
                for run in &band.runs {
                    let start = run.row * width;
                    let steps = &mut steps[start + run.columns.start..start + run.columns.end];
                    steps.copy_from_slice(band.row(run));
                }
            });
            let (flat, up) = ((1.0 - square).sqrt(), square.sqrt());
            let [du, dv] = direction.step;
            take(&View {
                direction: [cos * flat, sin * flat, up],
                step_uv: [du / f64::from(map.width()), dv / f64::from(map.height())],
                steps: &steps,
                size: [map.width(), map.height()],
            })?;
        }
    }
    Ok(())
}

/// The working set is two maps, one more for each elevation, and three for the sink.
fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, elevations) = (settings.count(0), settings.count(1));
    let (tiles, bits) = (settings.count(2), settings.count(3));
    let map = source.map;
    let channel = |name, unit| Channel { name, unit, range: [0.0, 1.0], rounding: Rounding::Nearest };
    let channels = [channel("u", "tiles"), channel("v", "tiles"), channel("hit", "1")];
    let mut texture = azimuths::texture(source, azimuths, azimuths * elevations, channels.to_vec());
    texture.notes.push(("elevations", format!("{elevations}: sin^2 = (e + 0.5) / {elevations}")));
    sink.begin(&texture)?;
    let mut planes = [0; 3].map(|_| vec![0.0f32; map.texels().len()]);
    views(map, source.metric, [azimuths, elevations], tiles, watch, &mut |view| {
        let width = map.width() as usize;
        let [u, v, seen] = planes.each_mut().map(|plane| plane.par_chunks_mut(width));
        u.zip(v).zip(seen).enumerate().for_each(|(row, ((u, v), seen))| {
            for (column, ((u, v), seen)) in u.iter_mut().zip(v).zip(seen).enumerate() {
                let hit = view.hit(column as u32, row as u32);
                let [at_u, at_v] = hit.unwrap_or([0.0; 2]).map(|at| wrapped(map, at) as f32);
                [*u, *v, *seen] = [at_u, at_v, if hit.is_some() { 1.0 } else { 0.0 }];
            }
        });
        Ok(to_nearest(sink, &channels, bits, &mut planes.each_mut().map(Vec::as_mut_slice))?)
    })
}

/// Returns the texture coordinate inside of the map that stands for `at`.
fn wrapped(map: &HeightMap, at: f64) -> f64 {
    match map.wrap() {
        Wrap::Repeat => at.rem_euclid(1.0),
        Wrap::Clamp => at.clamp(0.0, 1.0),
        Wrap::Mirror => 1.0 - (at.rem_euclid(2.0) - 1.0).abs(),
    }
}
