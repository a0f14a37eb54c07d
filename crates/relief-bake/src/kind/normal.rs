//! Normal maps, with moments of the slope for filtering.
//!
//! Szirmay-Kalos and Umenhoffer 2008, sections 2.1 and 2.2, eq. 9; for mip levels Dupuy et al. 2013
//! (LEADR).
//!
//! # What is stored
//!
//! The map holds the unit normal of the relief in the [`Metric`] at every texel centre. With slopes
//! `su` along `u` and `sv` along `v` (which points down in the picture), it is `(-su, sv, 1)` over
//! its length in tangent space. There `x` points along the tangent and `z` outward. `y` points up
//! in the picture, which is along `-B` (green as in OpenGL and glTF; the other sign is an option).
//! These are eq. 9's signs for a downward `v`. In world space, for the built-in plane, it is
//! `(-su, 1, -sv)`.
//!
//! At the edges of a clamped map differences are one-sided: from the edge's texel to the one
//! inside. So an even slope has the same normal everywhere, and tiles of a terrain meet without a
//! rim.
//!
//! Mip levels hold the normal of the *mean slope* and three more channels: the central second
//! moments of the slopes along `u` and `v` over the texel (`uu`, `uv`, `vv`, the same whatever
//! space and green). A shader adds them to the roughness of the material. They are 0 in level 0.
//! Sides halve, rounded down. Texels are weighted by area, so the last level holds mean and moments
//! of the whole map.
//!
//! # Guarantee
//!
//! Let heights be sampled from a smooth surface `h` in metres, with texels `a` by `b` metres. Away
//! from the edges of a clamped or mirrored map, the angle between the stored and the true normal is
//! at most `sqrt((a² max|h_uuu|)² + (b² max|h_vvv|)²) / 6` plus `4e-7` plus
//! `1.2e-7 (scale/a + scale/b)`. It falls with the square of the texel.
//!
//! *Proof.* By Taylor's theorem a central difference misses the slope by at most `a²/6 max|h_uuu|`.
//! The angle between the normals of two slopes is at most the distance of the slopes, because
//! `s ↦ (-s, 1)/|(-s, 1)|` has derivatives of at most 1: `1/(1+|s|²)` radially and `1/sqrt(1+|s|²)`
//! across. Heights rounded to `f32` are off by `2^-25`, which moves their difference by `2^-24` and
//! the slope by `2^-25 scale/a`. The subtraction and the two products add `2^-23` of the slope,
//! which turns the normal by less than that times `|s|/(1+|s|²)`. Dividing by the length adds three
//! roundings. With [`Derivative::Patches`] the slopes to either side, and their weights, differ in
//! proportion to the texel, so the order is the same with another constant. Opposite slopes cancel
//! there, and rounding adds up to `4e-7` times the steepest of them.
//!
//! Stored in `bits` the components are rounded to the nearest, each by at most `1 / (2^bits - 1)`.
//! The angle thus grows by at most `asin(sqrt(3) / (2^bits - 1))`: 0.39° with 8 bits, 0.0015° with
//! 16. (0 is no code: a flat map comes back tilted by `sqrt(2) / (2^bits - 1)`.) Nothing here is
//! one-sided, hence heights are not quantised first.
//!
//! # Cost
//!
//! The time is O(1) a texel. Memory is the six planes of level 0 (three without mips) beside the
//! map, then less.

mod moments;
mod slopes;

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, Metric, Rounding, Watch};

pub use self::moments::Moments;
use self::moments::next_size;
pub use self::slopes::{Derivative, Slopes};
use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// The kind `normal`.
pub const KIND: Kind = Kind {
    name: "normal",
    summary: "unit normals, and in mip levels the moments of the slope that filtering needs",
    revision: 2,
    publication: Publication { paper: "Szirmay-Kalos and Umenhoffer 2008", section: "2.1, 2.2" },
    params: &[PATCHES, WORLD, GREEN_DOWN, MIPS, BITS_TO_NEAREST],
    guarantee: "within (texel² / 6) max|third derivative| of the angle of a smooth surface's normal",
    is_picture: true,
    of_volume: false,
    shapes: |size, settings| vec![shape(size, settings.count(MIPS_PLACE) != 0)],
    reach: |settings| if settings.count(MIPS_PLACE) == 0 { Reach::Texels(1) } else { Reach::Everything },
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Creates a parameter that is off, 0, or on, 1.
const fn switch(name: &'static str, summary: &'static str, default: f32) -> Param {
    Param { name, summary, unit: "", min: 0.0, max: 1.0, default, integer: true, names: &[] }
}

const PATCHES: Param =
    switch("patches", "1: the mean normal of the four bilinear patches; 0: central differences (eq. 9)", 0.0);
const WORLD: Param = switch("world", "1: in world space, for the built-in plane; 0: in tangent space", 0.0);
const GREEN_DOWN: Param =
    switch("green_down", "1: green points down in the picture (DirectX); 0: up (OpenGL, glTF)", 0.0);
/// Index of the parameter `mips`.
const MIPS_PLACE: usize = 3;

const MIPS: Param = switch("mips", "1: mip levels and the moments of the slope", 1.0);

/// Rows that a thread computes together.
const ROWS: usize = 16;

/// Axes in which normals are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axes {
    /// Tangent space: `x` along the tangent, `y` up in the picture, `z` outward.
    #[default]
    Tangent,
    /// Tangent space with `y` down in the picture, as in DirectX.
    TangentGreenDown,
    /// World space on the built-in plane: `u` along `x`, `v` along `z`, outward along `y`.
    World,
}

impl Axes {
    /// Returns the unit normal of a surface with those slopes along `u` and `v`.
    #[inline]
    pub fn normal(self, [along_u, along_v]: [f32; 2]) -> [f32; 3] {
        let upright = 1.0 / (1.0 + along_u * along_u + along_v * along_v).sqrt();
        let (x, down) = (-along_u * upright, -along_v * upright);
        match self {
            Axes::Tangent => [x, -down, upright],
            Axes::TangentGreenDown => [x, down, upright],
            Axes::World => [x, upright, down],
        }
    }
}

/// Planes of a vector's three components, row by row from the top.
pub type Planes = [Vec<f32>; 3];

/// Returns the normals at all texel centres of a map, and the least and the greatest slope along
/// `u` and `v`.
///
/// # Errors
///
/// When the bake is cancelled.
pub fn normals(
    map: &HeightMap,
    metric: Metric,
    derivative: Derivative,
    axes: Axes,
    watch: &Watch,
) -> Result<(Planes, [[f32; 2]; 2]), Cancelled> {
    let slopes = Slopes::new(map, metric, derivative);
    let width = map.width() as usize;
    let mut planes = [0; 3].map(|_| vec![0.0f32; map.texels().len()]);
    let [x, y, z] = &mut planes;
    let chunk = width * ROWS;
    let blocks = map.height().div_ceil(ROWS as u32) as f32;
    let nothing = [[f32::MAX, f32::MIN]; 2];
    let extremes = x
        .par_chunks_mut(chunk)
        .zip(y.par_chunks_mut(chunk))
        .zip(z.par_chunks_mut(chunk))
        .enumerate()
        .map_init(
            || [vec![0.0f32; width], vec![0.0f32; width]],
            |[along_u, along_v], (block, ((x, y), z))| {
                watch.at(block as f32 / blocks)?;
                let mut extremes = nothing;
                let rows = x.chunks_mut(width).zip(y.chunks_mut(width)).zip(z.chunks_mut(width));
                for (row, ((x, y), z)) in rows.enumerate() {
                    slopes.row(block * ROWS + row, along_u, along_v);
                    let places = x.iter_mut().zip(y).zip(z).zip(along_u.iter().zip(along_v.iter()));
                    for (((x, y), z), (&u, &v)) in places {
                        [*x, *y, *z] = axes.normal([u, v]);
                    }
                    extremes = wider(extremes, [spread(along_u), spread(along_v)]);
                }
                Ok(extremes)
            },
        )
        .try_reduce(|| nothing, |a, b| Ok(wider(a, b)))?;
    Ok((planes, extremes))
}

fn spread(values: &[f32]) -> [f32; 2] {
    let less = |a: f32, b: f32| if a < b { a } else { b };
    let more = |a: f32, b: f32| if a > b { a } else { b };
    // Lanes that do not wait for each other.
    let (whole, rest) = values.as_chunks::<8>();
    let (mut lows, mut highs) = ([f32::MAX; 8], [f32::MIN; 8]);
    for values in whole {
        for ((low, high), &value) in lows.iter_mut().zip(&mut highs).zip(values) {
            (*low, *high) = (less(*low, value), more(*high, value));
        }
    }
    let low = rest.iter().copied().chain(lows).fold(f32::MAX, less);
    [low, rest.iter().copied().chain(highs).fold(f32::MIN, more)]
}

fn wider(a: [[f32; 2]; 2], b: [[f32; 2]; 2]) -> [[f32; 2]; 2] {
    [0, 1].map(|axis| [a[axis][0].min(b[axis][0]), a[axis][1].max(b[axis][1])])
}

/// Returns the channels, for slopes between those extremes. A variance is at most a quarter of the
/// squared range (Popoviciu), a covariance at most the root of the product of two.
fn channels(extremes: [[f32; 2]; 2], mips: bool) -> Vec<Channel> {
    let channel = |name, range| Channel { name, unit: "1", range, rounding: Rounding::Nearest };
    let half = extremes.map(|[low, high]| if high > low { 0.5 * (high - low) * (1.0 + 1e-5) } else { 1.0 });
    let mut all = vec![channel("x", [-1.0, 1.0]), channel("y", [-1.0, 1.0]), channel("z", [-1.0, 1.0])];
    if mips {
        all.push(channel("slope_uu", [0.0, half[0] * half[0]]));
        all.push(channel("slope_uv", [-half[0] * half[1], half[0] * half[1]]));
        all.push(channel("slope_vv", [0.0, half[1] * half[1]]));
    }
    all
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let [patches, world, green_down, mips] = [0, 1, 2, MIPS_PLACE].map(|place| settings.count(place) != 0);
    let bits = settings.count(4);
    let derivative = if patches { Derivative::Patches } else { Derivative::Central };
    let axes = match (world, green_down) {
        (true, _) => Axes::World,
        (false, true) => Axes::TangentGreenDown,
        (false, false) => Axes::Tangent,
    };
    let map = source.map;
    let size = [map.width() as usize, map.height() as usize];
    let (planes, extremes) = normals(map, source.metric, derivative, axes, &watch.piece(0.0, 0.5))?;
    let channels = channels(extremes, mips);
    sink.begin(&texture(map, axes, channels.clone()))?;
    let [mut x, mut y, mut z] = planes;
    if !mips {
        return Ok(to_nearest(sink, &channels, bits, &mut [&mut x, &mut y, &mut z])?);
    }
    let mut none = [0; 3].map(|_| vec![0.0f32; x.len()]);
    let [uu, uv, vv] = &mut none;
    to_nearest(sink, &channels, bits, &mut [&mut x, &mut y, &mut z, uu, uv, vv])?;
    drop((x, y, z, none));
    if size == [1, 1] {
        return Ok(());
    }
    let slopes = Slopes::new(map, source.metric, derivative);
    let mut level = Moments::of_slopes(&slopes, size, &watch.piece(0.5, 0.9))?;
    loop {
        let next = if level.size == [1, 1] { None } else { Some(level.halved(&watch.piece(0.9, 1.0))?) };
        let [u, v] = &mut level.mean;
        let mut upright = vec![0.0; u.len()];
        for ((u, v), upright) in u.iter_mut().zip(v.iter_mut()).zip(&mut upright) {
            [*u, *v, *upright] = axes.normal([*u, *v]);
        }
        let [uu, uv, vv] = &mut level.second;
        to_nearest(sink, &channels, bits, &mut [u, v, &mut upright, uu, uv, vv])?;
        match next {
            Some(next) => level = next,
            None => return Ok(()),
        }
    }
}

/// Shape of the texture; the channels of the moments come with mip levels.
fn shape([width, height]: [u32; 2], mips: bool) -> Shape {
    let mut shape = Shape::slices("", [width, height], 1, if mips { 6 } else { 3 });
    let mut size = [width as usize, height as usize];
    while mips && size != [1, 1] {
        size = next_size(size);
        shape.mips.push([size[0] as u32, size[1] as u32, 1]);
    }
    shape
}

fn texture(map: &HeightMap, axes: Axes, channels: Vec<Channel>) -> Texture {
    let Shape { name, size, mips, .. } = shape([map.width(), map.height()], channels.len() > 3);
    let space = match axes {
        Axes::Tangent => "tangent, +y up in the picture",
        Axes::TangentGreenDown => "tangent, +y down in the picture",
        Axes::World => "world of the built-in plane",
    };
    Texture { name, size, mips, channels, notes: vec![("space", space.to_owned())] }
}
