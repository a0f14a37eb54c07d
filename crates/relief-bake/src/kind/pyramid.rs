//! Pyramid of least and greatest heights.
//!
//! * Oh, Ki and Lee 2006, "Pyramidal displacement mapping": a quadtree of the empty space above the
//!   surface.
//! * Tevs, Ihrke and Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable dynamic height
//!   field rendering": the maxima of texels, with bilinear patches between them.
//! * Szirmay-Kalos and Umenhoffer 2008, "Displacement mapping on the GPU: state of the art",
//!   section 4.3.3.
//!
//! These papers take the extremes of *texels*, which does not bound the surface between texel
//! centres. Level 0 here is taken over dual cells, unless the parameter `over` asks for the
//! published extremes. The pyramids themselves are [`relief_core::MinPyramid`] and
//! [`relief_core::MaxPyramid`]. Their docs state which cells a node covers where a side is no power
//! of two, and the treatment of cells outside of the map.
//!
//! # Guarantee
//!
//! *At every level the surface over the cells of a node is nowhere below its `min` and nowhere
//! above its `max`.*
//!
//! Proof. A patch is `(1-x)(1-y) h00 + x(1-y) h10 + (1-x)y h01 + xy h11` with `x, y` in `[0, 1]`.
//! The four weights are not negative and sum to 1, so it lies between the least and the greatest
//! corner, and level 0 holds exactly these. Every node above is the extreme of nodes below that
//! together cover its cells. Nothing is padded, so a node covers only cells of the map. Taking
//! extremes does not round: in `f32` the bound is exact, and over the cells of one node it is
//! attained, at a texel. With `bits`, heights are decoded from that many bits first, and each node
//! is one of them, so it is stored exactly.
//!
//! With the parameter `over` at 2, nodes include the extremes of the map's coarser levels, by the
//! cells that [`MaxPyramid::over_levels`] names. The guarantee then holds for the surface of each
//! of these levels. Area means do not fit into the bits of the heights, so such nodes are rounded
//! to their own side when they are stored.

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, MaxPyramid, MinPyramid, Rounding, Watch};

use super::{BITS, Kind, Reach};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// The kind `pyramid`.
pub const KIND: Kind = Kind {
    name: "pyramid",
    summary: "least and greatest height over squares of 1, 2, 4 ... dual cells, as a mip chain",
    revision: 1,
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement mapping on the GPU; Tevs, Ihrke and \
            Seidel 2008, Maximum mipmaps",
        section: "4.3.3",
    },
    params: PARAMS,
    guarantee: "The bilinear surface over the cells of a node is nowhere below its min and nowhere above its \
        max; both are attained. Exact in f32 and in as many bits as the heights have. Over the levels of \
        detail the same holds for the surface of each. Over texels, as published, nothing is promised \
        between their centres.",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![shape(size)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

const PARAMS: &[Param] = &[OVER, BITS];

/// Index of the parameter `over`.
const OVER_PLACE: usize = 0;

/// The value of `over` for dual cells.
pub const OVER_CELLS: u32 = 0;

/// The value of `over` for texels.
pub const OVER_TEXELS: u32 = 1;

/// The value of `over` for dual cells of all levels of detail.
pub const OVER_LEVELS: u32 = 2;

const OVER: Param = Param {
    name: "over",
    summary: "area of the nodes: 0 dual cells, whose extremes bound the surface, 1 texels, as published, \
        whose extremes do not, 2 dual cells of the map and of its levels of detail, which bound each surface",
    unit: "",
    min: 0.0,
    max: 2.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// Builds both pyramids of a map, 8/3 of its size in all.
///
/// # Errors
///
/// When it is cancelled.
pub fn pyramids(map: &HeightMap, watch: &Watch) -> Result<(MinPyramid, MaxPyramid), Cancelled> {
    let min = MinPyramid::watched(map, &watch.piece(0.0, 0.5))?;
    let max = MaxPyramid::watched(map, &watch.piece(0.5, 1.0))?;
    Ok((min, max))
}

/// Shape of both channels; each level has half the size of the previous one, rounded up.
fn shape([width, height]: [u32; 2]) -> Shape {
    let mut shape = Shape::slices("", [width, height], 1, 2);
    let mut size = [width, height];
    while size != [1, 1] {
        size = size.map(|side| side.div_ceil(2));
        shape.mips.push([size[0], size[1], 1]);
    }
    shape
}

/// Level of the extremes of squares of texels: least, greatest, and nodes in a row.
struct TexelLevel {
    least: Vec<f32>,
    greatest: Vec<f32>,
    width: usize,
}

impl TexelLevel {
    /// Builds the level above: half the size, rounded up.
    fn halved(&self) -> Self {
        let width = self.width.div_ceil(2);
        let height = (self.least.len() / self.width).div_ceil(2);
        let halved = |nodes: &[f32], pick: fn(f32, f32) -> f32| -> Vec<f32> {
            let mut above = vec![0.0; width * height];
            let pairs = above.par_chunks_mut(width).zip(nodes.par_chunks(2 * self.width));
            pairs.for_each(|(above, rows)| {
                let (top, rest) = rows.split_at(self.width);
                let bottom = if rest.is_empty() { top } else { rest };
                for (node, (a, b)) in above.iter_mut().zip(top.chunks(2).zip(bottom.chunks(2))) {
                    let all = a.iter().chain(b).copied();
                    *node = all.reduce(pick).unwrap_or(0.0);
                }
            });
            above
        };
        Self { least: halved(&self.least, f32::min), greatest: halved(&self.greatest, f32::max), width }
    }
}

/// Bakes the texels and the extremes of their squares, level by level.
fn bake_over_texels(map: &HeightMap, watch: &Watch, sink: &mut dyn Sink) -> Result<(), BakeError> {
    sink.begin(&texture(
        map,
        "texels: texel (i, j) of level 0 is the height (i, j), and does not bound the surface",
    ))?;
    let texels = || map.texels().to_vec();
    let mut level = TexelLevel { least: texels(), greatest: texels(), width: map.width() as usize };
    loop {
        sink.slice(&[&level.least, &level.greatest])?;
        if level.least.len() == 1 {
            return Ok(());
        }
        level = level.halved();
        watch.at(1.0 - level.least.len() as f32 / map.texels().len() as f32)?;
    }
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let over = settings.count(OVER_PLACE);
    if over == OVER_TEXELS {
        return bake_over_texels(source.map, watch, sink);
    }
    let (mut min, mut max) = pyramids(source.map, watch)?;
    if over == OVER_LEVELS {
        (min, max) = (min.over_levels(source.map), max.over_levels(source.map));
    }
    let cells = "dual cells: texel (i, j) of level 0 lies between the heights (i, j) and (i + 1, j + 1)";
    let levels = "; nodes bound the levels of detail, too";
    let texels = if over == OVER_LEVELS { [cells, levels].concat() } else { cells.to_owned() };
    sink.begin(&texture(source.map, &texels))?;
    for level in 0..max.levels() {
        sink.slice(&[min.nodes(level), max.nodes(level)])?;
    }
    Ok(())
}

/// Describes the texture of a map's extremes.
fn texture(map: &HeightMap, texels: &str) -> Texture {
    let Shape { name, size, mips, .. } = shape([map.width(), map.height()]);
    Texture {
        name,
        size,
        mips,
        channels: vec![
            Channel { name: "min", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Down },
            Channel { name: "max", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Up },
        ],
        notes: vec![
            ("texels", texels.to_owned()),
            ("mips", "each level has half the size of the one before, rounded up".to_owned()),
        ],
    }
}
