//! Filter levels: a chain of coarser height maps, each of them a bilinear surface of its own.
//!
//! * Gumhold and Hüttner 1999, "Multiresolution Rendering With Displacement Mapping": section 4.2
//!   for levels of the least difference volume, section 4.1 for maxima and minima.
//!
//! Sides halve, rounded down, until a level is a single texel. Level 0 is the map. Every level but
//! an average is computed from it, not from the previous level. A level's surface lies over the
//! same texture square as the map's and continues beyond it with the same wrap. Its heights are
//! from 0 to 1 with the map's scale and bias.
//!
//! # Guarantee
//!
//! * `average`: a texel is the mean of the map's texels over its area ([`HeightMap::level`], to
//!   rounding).
//! * `max`: *the level's surface is nowhere below the map's.* `min`: it is nowhere above.
//!
//!   Proof. A texel is the extreme of the map's surface over the texel's whole support: the square
//!   to the centres of the texels around it. A point of the level lies in one cell, and the cell in
//!   the supports of its four corners. So each of the four heights is at least as high as the map's
//!   surface at that point. The level's surface there is their mean, with weights that are not
//!   negative and sum to 1, so it is at least as high, too. Beyond the outermost centres of a map
//!   that is not tiled, both surfaces are as high as at these centres. The extreme of a bilinear
//!   surface over a rectangle lies at a corner of one of the pieces into which the cells cut it.
//!   Such a corner is a texel, or a point where an end of the support crosses a line between texels
//!   or another end. All of these are visited, so the bound is attained, to a rounding. Heights
//!   between texels are raised by more than the rounding of `f64` (never above their neighbours),
//!   and rounded up to `f32` and to codes. The usual maximum over the texel's own area holds only
//!   at its centre.
//! * `least-squares`: of all heights from 0 to 1, these have the least integral of the squared
//!   difference of the surfaces. The integrals of products of hats are exact, also where sides are
//!   odd.
//! * `variational`: the difference volume, as [`difference_volume()`] sums it, is at most the
//!   volume of `average` and of `least-squares`. Mostly it is near the least, which is convex and
//!   has no other minimum. The paper's descent with a numeric derivative reaches the same level.
//!
//! With `bits`, heights are quantised first, then the heights of levels: to the nearest, or to the
//! side of the extreme. The guarantees of the last two filters hold for the floats.
//!
//! # Cost
//!
//! A level takes O(texels of the map) time. Least squares and extremes take a few operations for
//! each texel; `variational` takes eleven passes over four points or more of each cell. Memory
//! counts besides the map, the result and the averages, which are a third of the map.
//! `least-squares` takes one and a quarter maps, `variational` as much, and some hundred kilobytes
//! a thread.

mod axis;
mod extremes;
mod least_squares;
mod system;
mod tiles;
mod variational;
mod volume;

use std::fmt;
use std::str::FromStr;

use relief_core::area_mean::coarser_size;
use relief_core::registry::{Param, Publication, UnknownName};
use relief_core::{HeightMap, Rounding, Watch};

use self::extremes::Side;
pub use self::volume::{difference_volume, difference_volume_gradient};
use super::{BITS, Kind, Reach};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture, quantise};

/// The kind `filter-levels`.
pub const KIND: Kind = Kind {
    name: "filter-levels",
    summary: "coarser heights, each level a surface of its own: nearest to the relief, or above or below it",
    revision: 1,
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "4.1, 4.2",
    },
    params: &[FILTER, BITS],
    guarantee: "With max, the bilinear surface of a level is nowhere below the map's, with min nowhere \
        above. With variational, the volume between the two is at most the volume with average or \
        least-squares. With least-squares, the integral of the squared difference is the least possible.",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![shape(size)],
    reach: |_| Reach::Everything,
    working_maps: |_| 2.5,
    bake,
};

const FILTER: Param = Param {
    name: "filter",
    summary: "filter of the levels: 0 average, the mean over a texel's area, 1 max, nowhere below the \
        surface, 2 min, nowhere above it, 3 least-squares, 4 variational, the least volume between the \
        surfaces",
    unit: "",
    min: 0.0,
    max: 4.0,
    default: 4.0,
    integer: true,
    names: &[],
};

/// Filter that computes a level.
///
/// The discriminants are the values of the setting `filter`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Filter {
    /// Mean over a texel's area.
    Average = 0,
    /// Surface nowhere below the map's, for rays from the front.
    Max = 1,
    /// Surface nowhere above the map's, for rays from the back.
    Min = 2,
    /// Least squared difference of the surfaces.
    LeastSquares = 3,
    /// Least volume between the surfaces.
    #[default]
    Variational = 4,
}

impl Filter {
    /// Every filter, in the order of the setting's values.
    pub const ALL: [Filter; 5] =
        [Filter::Average, Filter::Max, Filter::Min, Filter::LeastSquares, Filter::Variational];

    /// Returns its name.
    pub const fn name(self) -> &'static str {
        match self {
            Filter::Average => "average",
            Filter::Max => "max",
            Filter::Min => "min",
            Filter::LeastSquares => "least-squares",
            Filter::Variational => "variational",
        }
    }

    /// Returns the side to which heights are rounded.
    pub const fn rounding(self) -> Rounding {
        match self {
            Filter::Max => Rounding::Up,
            Filter::Min => Rounding::Down,
            Filter::Average | Filter::LeastSquares | Filter::Variational => Rounding::Nearest,
        }
    }
}

impl fmt::Display for Filter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Filter {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let unknown = || UnknownName::new("filter", name, Filter::ALL.map(Filter::name));
        Filter::ALL.into_iter().find(|filter| filter.name() == name).ok_or_else(unknown)
    }
}

/// Computes a level of a map; level 0 is the map itself. Each level has half the sides of the
/// previous one, rounded down, and at least 1. Beyond the single texel, levels stay that texel. The
/// level lies as the map lies ([`HeightMap::wrap`], [`HeightMap::scale_m`], [`HeightMap::bias_m`]),
/// without its metadata. It can replace the map wherever a coarser one is wanted.
///
/// # Errors
///
/// When it is cancelled.
pub fn filter_level(
    map: &HeightMap,
    level: u32,
    filter: Filter,
    watch: &Watch,
) -> Result<HeightMap, BakeError> {
    let average = map.level(level);
    if level == 0 {
        return Ok(average);
    }
    let size = [average.width(), average.height()];
    let texels = match filter {
        Filter::Average => return Ok(average),
        Filter::Max => extremes::level(map, size, Side::Above, watch)?,
        Filter::Min => extremes::level(map, size, Side::Below, watch)?,
        Filter::LeastSquares => least_squares::level(map, size, average.texels(), watch)?,
        Filter::Variational => {
            let squares = least_squares::level(map, size, average.texels(), &watch.piece(0.0, 0.2))?;
            variational::level(map, size, [average.texels(), &squares], &watch.piece(0.2, 1.0))?
        }
    };
    watch.at(1.0)?;
    let level = HeightMap::new(size[0], size[1], texels, map.wrap())?;
    Ok(level.with_displacement(map.scale_m(), map.bias_m())?)
}

/// Computes all levels of a map, from the map itself to a single texel: see [`filter_level`].
///
/// # Errors
///
/// When it is cancelled.
pub fn filter_levels(map: &HeightMap, filter: Filter, watch: &Watch) -> Result<Vec<HeightMap>, BakeError> {
    let count = map.levels();
    (0..count).map(|level| filter_level(map, level, filter, &part(watch, level, count))).collect()
}

/// Returns the watch of one level among several. Each level reads the whole map, except the first,
/// which is the map.
fn part<'a>(watch: &Watch<'a>, level: u32, count: u32) -> Watch<'a> {
    let computed = (count - 1).max(1) as f32;
    watch.piece(level.saturating_sub(1) as f32 / computed, (level as f32 / computed).min(1.0))
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (map, bits) = (source.map, settings.count(1));
    let filter = Filter::ALL[settings.count(0) as usize];
    let Shape { name, size, mips, .. } = shape([map.width(), map.height()]);
    let channel = Channel { name: "height", unit: "heights", range: [0.0, 1.0], rounding: filter.rounding() };
    let notes = vec![
        ("filter", filter.to_string()),
        ("mips", "each level has half the size of the one before, rounded down".to_owned()),
    ];
    sink.begin(&Texture { name, size, mips, channels: vec![channel], notes })?;
    sink.slice(&[map.texels()])?;
    let count = map.levels();
    for level in 1..count {
        let level = filter_level(map, level, filter, &part(watch, level, count))?;
        let mut texels = level.into_texels();
        if bits != 0 {
            texels.iter_mut().for_each(|texel| *texel = quantise::unorm(*texel, bits, filter.rounding()));
        }
        sink.slice(&[&texels])?;
    }
    Ok(())
}

/// Shape of one channel; each level has half the size of the previous one, rounded down.
fn shape([width, height]: [u32; 2]) -> Shape {
    let mut shape = Shape::slices("", [width, height], 1, 1);
    let mut size = [width, height];
    while size != [1, 1] {
        size = coarser_size(size);
        shape.mips.push([size[0], size[1], 1]);
    }
    shape
}
