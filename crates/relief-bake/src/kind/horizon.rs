//! Horizons: the elevation of the relief around every texel.
//!
//! Max 1988, *Horizon mapping: shadows for bump-mapped surfaces*; Szirmay-Kalos and Umenhoffer
//! 2008, section 6.1. The sweep is by Timonen and Westerholm 2010, *Scalable height field
//! self-shadowing*: one pass of sheared lines an azimuth, with an upper hull that grows towards the
//! texels, O(1) a texel. Two things are added. First, the tangent is taken from the texel itself
//! and not from the line that passes it. The texel is raised or lowered by as much as the line
//! passes it on an even slope. Second, the first [`NEAR_STEPS`] steps, where the half texel between
//! the two matters, are read from the texel's own ray, in closed form.
//!
//! # What is stored
//!
//! The map holds the sine of the elevation of the horizon about the base plane, in `[0, 1]`:
//! `s / sqrt(1 + s²)`. Here `s` is the greatest slope, in metres a metre, under which the texel's
//! centre sees a point of the surface. It is at least 0, because below the base plane there is no
//! sky. Slice `k` of `N` looks at the azimuth `2πk / N`, in metres from `+u` towards `+v`. A
//! direction `(x, y)` of the tangent plane in metres lies at `x / tile_m[0]`, `y / tile_m[1]` in
//! texture coordinates.
//!
//! The surface continues by its wrap: the ray looks beyond the edge of the map, also under clamp.
//!
//! # Guarantee
//!
//! Let one step along the ray be the way to the next column (row) of texel centres along the axis
//! that it crosses faster. Let `l` be its length in metres, and `p <= 1` its way along the other
//! axis in texels. Let `G` be the greatest difference of neighbouring texels along that other axis
//! in metres. Then the stored slope `s` and the true one `S`, of all points up to the reach of `R`
//! steps, satisfy
//!
//! `S - e <= s <= S' + e`, `e = G (2 + p) / (2 n l)`, `n = `[`NEAR_STEPS`],
//!
//! with `S'` the same for a reach of `2 R`, since a line is searched up to where its last texel's
//! reach ends. `R` is `tiles` times the map's side along the faster axis, at least 64. The surface
//! beyond `R` is missed; it stands at most `scale_m / (R l)` high, as a slope. Under repeat nothing
//! is missed where the way comes back to its texel within `R` steps: along both axes, and along the
//! diagonals of a square map of square texels. The argument:
//!
//! * *Near*, up to `n` steps. In each dual cell the surface over the texel's own ray is quadratic,
//!   and the greatest slope of a quadratic is known. This is exact up to `n / 2` steps. From there
//!   on only the ends of each cell count. Inside of the cell the surface is above the chord of the
//!   ends by at most `|d| p / 4`. The twist `d` of a cell is at most `2 G`, as it is a difference
//!   of two differences along the other axis. The excess `2 G p / 4`, seen from at least `n / 2`
//!   steps away, is a slope of at most `G p / (n l)`, which is within `e`, as `p <= 1`.
//! * *Far*, from `n` steps on. The line passes the texel at most half a texel beside its ray, where
//!   the surface is at most `G / 2` higher or lower. The texel looks from as much higher or lower
//!   as an even slope would be there, at most `G / 2`, too. On an even slope both are equal, and
//!   nothing is off. Between the columns `c` and `c + 1` the surface at row `y` is
//!   `(1-τ) f(c, y) + τ f(c+1, y)`. There the line has gone `pτ` rows since the first column and
//!   will go `p (1-τ)` to the second. So the surface on it differs from the chord of the two
//!   samples by at most `2 τ (1-τ) p G <= p G / 2`. Seen over `n` steps or more, all together are
//!   `e`. A tangent to the upper hull of the samples is the greatest slope towards any point of
//!   their chords.
//! * *Rounding.* Heights are in `[0, 1]` and lerped in `f32`. Samples, hull and tangent each lose a
//!   few times 2⁻²³ of a height over at least one step: at most `1e-5 scale_m / l` in all, for
//!   lines of up to 2¹⁴ texels.
//!
//! Where texels do not differ much from their neighbours, `e` is small. Where they do, the horizon
//! is mostly near. With a relief of a tenth of the tile the error's median is below 0.001 degrees.
//! Its 95th percentile is 0.2 to 0.4 degrees on natural ground and 0.9 on white noise. The error is
//! largest for the shadows of lone spikes a texel wide.

use relief_core::registry::Publication;
use relief_core::{HeightMap, Metric, Rounding, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{AZIMUTHS, TILES, texture};
pub use crate::horizon_sweep::NEAR_STEPS;
use crate::horizon_sweep::Sweep;
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// The kind `horizon`.
pub const KIND: Kind = Kind {
    name: "horizon",
    summary: "sine of the horizon's elevation in some azimuths, for shadows of any light",
    revision: 2,
    publication: Publication {
        paper: "Max 1988; Timonen and Westerholm 2010; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.1",
    },
    params: &[AZIMUTHS, TILES, BITS_TO_NEAREST],
    guarantee: "for the bilinear surface, as slope: off by at most 1.5 times the difference of neighbouring \
                texels over 8 steps' length; what is beyond the reach stands at most the scale over the \
                reach high",
    is_picture: false,
    of_volume: false,
    shapes: |size, settings| vec![Shape::slices("", size, settings.count(0), 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| 1.75,
    bake,
};

/// Receives the number of an azimuth and the sines of the horizons there, which it may change.
pub type Take<'a> = dyn FnMut(u32, &mut [f32]) -> Result<(), BakeError> + 'a;

/// Computes the sines, from 0 to 1, of the horizons' elevations in `azimuths` azimuths. Each
/// azimuth is handed to `take`, row by row from the top. `tiles` is the reach in tiles. See the
/// [module](self) for their meaning and accuracy.
///
/// Besides the input, the working set is the map of sines and another quarter of the map, whatever
/// the number of azimuths. Each thread takes 16 lines of the map with their reach, and 50 of its
/// rows. The time is in proportion to the texels. For clamped maps much longer than wide it is in
/// proportion to the square of the long side.
///
/// # Errors
///
/// When the bake is cancelled, or `take` fails.
pub fn horizons(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    watch: &Watch,
    take: &mut Take,
) -> Result<(), BakeError> {
    let mut sweep = Sweep::new(map, metric, azimuths, tiles);
    let mut sines = vec![0.0; map.texels().len()];
    for azimuth in 0..azimuths {
        let copy = |[plane]: [&mut [f32]; 1], sines: &[f32]| plane.copy_from_slice(sines);
        sweep.azimuth(azimuth, [&mut sines], watch, copy)?;
        take(azimuth, &mut sines)?;
    }
    Ok(())
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, tiles, bits) = (settings.count(0), settings.count(1), settings.count(2));
    let channels = [Channel { name: "sine", unit: "1", range: [0.0, 1.0], rounding: Rounding::Nearest }];
    sink.begin(&texture(source, azimuths, azimuths, channels.to_vec()))?;
    horizons(source.map, source.metric, azimuths, tiles, watch, &mut |_, sines| {
        Ok(to_nearest(sink, &channels, bits, &mut [sines])?)
    })
}
