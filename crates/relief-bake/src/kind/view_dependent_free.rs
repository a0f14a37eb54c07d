//! The way on which rays are free by place, azimuth, elevation and bend: a view-dependent map as a
//! bound. Published here first.
//!
//! # What is stored
//!
//! A texel stands for all paths that come in at height 1 over its square, in one step of each axis of
//! [`Axes`](crate::view_dependent::Axes). It holds a way on which none of them meets the relief, as a
//! part of the longest of their whole ways. A layer holds a direction, and in it the bends lie below
//! each other. With one bend it stands for straight paths alone.
//!
//! # Guarantee
//!
//! *No path of the cell touches the bilinear surface, in any wrap, before the stored way.*
//!
//! Proof. Let `F` be the way along a path as a part of the way after which a straight path of the same
//! slope is at height 0, and `L` the length of that way along the base. The longest way of the cell is
//! divided into pieces. While the paths are on a piece,
//!
//! 1. *they are over a box.* A path is `F L` from where it came in, in its direction. Over the cell
//!    and the piece `F L` lies between the products of the least and of the greatest. Cosine and sine
//!    over the cell's azimuths are bounded by their values at its ends, and by 1 or -1 where it holds
//!    such an angle. The square that the paths come in over is added.
//! 2. *the relief is at most the greatest texel of the dual cells that the box touches*, since a patch
//!    is nowhere above its corners. The wrap gives the texels beyond the edges.
//! 3. *the paths are at least at the least height of all of them.* The height `1 - F + β F²` grows with
//!    `β`, so it is least for the least `β`; over the piece it is least at an end or where that path
//!    turns up.
//!
//! So where the least height is greater than the greatest texel, no path meets the relief on that
//! piece. The first piece where it is not is halved a few times by the same test. What is stored is
//! 0.998 of where the last piece that passed ends, rounded down.
//!
//! *Rounding.* What is taken off is more than shaders err in turning a part of the way into a place on
//! the ray. The ranges of a cell are wider than the cell by 2e-5 of each axis, and boxes by a
//! thousandth of a texel. That is more than shaders err in telling a path's cell, but for the square.
//! Where a path comes in nearer to a square's side than rounding can tell, they do not use the map.

use relief_core::registry::{Param, Publication};
use relief_core::{Rounding, Watch};

use super::{BITS, Kind, Reach};
use crate::quantise::unorm;
use crate::view_dependent::{AXES_PARAMS, all_free_ways, axes_of, texture, unchecked_axes};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// Parameter for the bits of stored values, rounded down. They bound heights as they are.
const BITS_DOWN: Param =
    Param { summary: "bits of the stored values, rounded down: 8 or 16, 0 for floats", ..BITS };

/// Cells that are computed at a time.
const TOGETHER: usize = 16;

/// The kind `view-dependent-free`.
pub const KIND: Kind = Kind {
    name: "view-dependent-free",
    summary: "for each texel's square and step of direction, the way on which all rays are free",
    revision: 1,
    publication: Publication { paper: "Relief", section: "" },
    params: &[AXES_PARAMS[0], AXES_PARAMS[1], AXES_PARAMS[2], AXES_PARAMS[3], BITS_DOWN],
    guarantee: "No path that comes in at height 1 over a texel's square, within a step of each axis, touches \
        the bilinear surface before the way that is stored, as a part of the longest whole way in that step \
        of bends.",
    is_picture: false,
    of_volume: false,
    shapes: |[width, height], settings| {
        let axes = unchecked_axes(settings);
        vec![Shape::slices("", [width, height.saturating_mul(axes.bends)], axes.layers(), 1)]
    },
    reach: |_| Reach::Everything,
    working_maps: |settings| 3.0 * TOGETHER as f32 + settings.get(2),
    bake,
};

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let axes = axes_of(settings, KIND.name)?;
    let channel = Channel { name: "free", unit: "1", range: [0.0, 1.0], rounding: Rounding::Down };
    sink.begin(&texture(source, &axes, channel))?;
    let cells: Vec<_> = (0..axes.layers())
        .flat_map(|layer| (0..axes.bends).map(move |bend| axes.ranges(layer, bend)))
        .collect();
    let bends = axes.bends as usize;
    let bits = settings.count(4);
    let mut layer = Vec::new();
    for (number, together) in cells.chunks(TOGETHER).enumerate() {
        watch.at((number * TOGETHER) as f32 / cells.len() as f32)?;
        for ways in all_free_ways(source.map, together, watch)? {
            layer.extend(ways.into_iter().map(|way| unorm(way, bits, Rounding::Down)));
            if layer.len() == source.map.texels().len() * bends {
                sink.slice(&[&layer])?;
                layer.clear();
            }
        }
    }
    Ok(())
}
