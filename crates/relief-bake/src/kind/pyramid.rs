//! The pyramid of least and greatest heights.
//!
//! * Oh, Ki and Lee 2006, "Pyramidal displacement mapping": a quadtree of the empty space above the surface.
//! * Tevs, Ihrke and Seidel 2008, "Maximum mipmaps for fast, accurate, and scalable dynamic height field
//!   rendering": the maxima of texels, with bilinear patches between them.
//! * Szirmay-Kalos and Umenhoffer 2008, "Displacement mapping on the GPU: state of the art", section 4.3.3.
//!
//! Those take the extremes of *texels*, which does not bound the surface between texel centres: level 0 here
//! is taken over dual cells. The pyramids themselves are [`relief_core::MinPyramid`] and
//! [`relief_core::MaxPyramid`]; see there for which cells a node covers where a side is no power of two, and
//! for cells outside of the map.
//!
//! # Guarantee
//!
//! *At every level the surface over the cells of a node is nowhere below its `min` and nowhere above its
//! `max`.*
//!
//! Proof. A patch is `(1-x)(1-y) h00 + x(1-y) h10 + (1-x)y h01 + xy h11` with `x, y` in `[0, 1]`: the four
//! weights are not negative and sum to 1, so it lies between the least and the greatest corner, and level 0
//! holds exactly these. Every node above is the extreme of nodes below that together cover its cells. Nothing
//! is padded, so nothing is covered that is not there. Taking extremes does not round: in `f32` the bound is
//! exact, and over the cells of one node it is attained, at a texel. With `bits`, heights are decoded from so
//! many bits first, and each node is one of them: stored in as many bits it is still exact.

use relief_core::registry::{Param, Publication};
use relief_core::{HeightMap, MaxPyramid, MinPyramid, Rounding};

use super::{BITS, Kind, Reach};
use crate::{BakeError, BakeInput, Cancelled, Channel, Progress, Settings, Shape, Sink, Texture};

/// The kind `pyramid`.
pub const KIND: Kind = Kind {
    name: "pyramid",
    summary: "least and greatest height over squares of 1, 2, 4 ... dual cells, as a mip chain",
    revision: 1,
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement mapping on the GPU; Tevs, Ihrke and Seidel 2008, Maximum mipmaps",
        section: "4.3.3",
    },
    params: PARAMS,
    guarantee: "The bilinear surface over the cells of a node is nowhere below its min and nowhere above its max; both \
        are attained. Exact in f32 and in as many bits as the heights have.",
    is_picture: false,
    shapes: |size, _| vec![shape(size)],
    reach: |_| Reach::Everything,
    bake,
};

const PARAMS: &[Param] = &[BITS];

/// Both pyramids of a map, 8/3 of its size in all.
///
/// # Errors
///
/// When it is cancelled.
pub fn pyramids(map: &HeightMap, progress: &Progress) -> Result<(MinPyramid, MaxPyramid), Cancelled> {
    let (first, second) = (progress.piece(0.0, 0.5), progress.piece(0.5, 1.0));
    let min = MinPyramid::try_new(map, |part| first.at(part))?;
    let max = MaxPyramid::try_new(map, |part| second.at(part))?;
    Ok((min, max))
}

/// Both channels, and each level half the size of the one before, rounded up.
fn shape([width, height]: [u32; 2]) -> Shape {
    let mut shape = Shape::slices("", [width, height], 1, 2);
    let mut size = [width, height];
    while size != [1, 1] {
        size = size.map(|side| side.div_ceil(2));
        shape.mips.push([size[0], size[1], 1]);
    }
    shape
}

fn bake(source: &BakeInput, _: &Settings, progress: &Progress, sink: &mut dyn Sink) -> Result<(), BakeError> {
    let (min, max) = pyramids(source.map, progress)?;
    let Shape { name, size, mips, .. } = shape([source.map.width(), source.map.height()]);
    sink.begin(&Texture {
        name,
        size,
        mips,
        channels: vec![
            Channel { name: "min", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Down },
            Channel { name: "max", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Up },
        ],
        notes: vec![
            (
                "texels",
                "dual cells: texel (i, j) of level 0 lies between the heights (i, j) and (i + 1, j + 1)"
                    .to_owned(),
            ),
            ("mips", "each level has half the size of the one before, rounded up".to_owned()),
        ],
    })?;
    for level in 0..max.levels() {
        sink.slice(&[min.nodes(level), max.nodes(level)])?;
    }
    Ok(())
}
