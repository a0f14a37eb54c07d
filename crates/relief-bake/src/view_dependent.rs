//! View-dependent displacement maps: what paths that come in at the top of a relief meet, by place,
//! azimuth, elevation and bend.
//!
//! The kinds `view-dependent` and `view-dependent-free` use them.
//!
//! # Compressed maps
//!
//! With a rank, a map of ways has four terms a layer. The factors of texels lie in it as texels do.
//! Below them lie the factors of views, row after row. Bends run fastest, then elevations, then
//! azimuths. Two texels follow with the term's scale, `512 (a + b / 255)²`. With clusters, this
//! comes again for each of them, and a first layer has the number of each texel's cluster, divided
//! by 255. Without clusters a factor is stored as `(1 + f) / 2`. The way is the sum of all terms:
//! the product of the texel's factor, the view's factor and the scale. Sums from 1.125 on meet
//! nothing.

mod axes;
mod clusters;
mod compressed;
mod free;
mod matrix;
mod non_negative;
mod svd;

pub use clusters::clusters;
pub use compressed::{Compression, FACTORS, MOST_SCALE};
pub use matrix::Matrix;
pub use non_negative::{Factors, non_negative_factors};
pub use svd::{Svd, truncated_svd};

pub(crate) use compressed::write_compressed;

pub use axes::{Axes, PathRanges, TOUCHING, bend, whole_way};
pub use free::free_ways;

pub(crate) use free::all_free_ways;

use relief_core::registry::Param;

use crate::{BakeError, BakeInput, Settings, Texture};

/// Most layers, which every GPU takes.
const MOST_LAYERS: u32 = 256;

const AZIMUTHS: Param = Param {
    name: "azimuths",
    summary: "directions along the base plane",
    unit: "",
    min: 4.0,
    max: 64.0,
    default: 8.0,
    integer: true,
    names: &[],
};

const ELEVATIONS: Param = Param {
    name: "elevations",
    summary: "directions from upright to level; layers are azimuths times these",
    min: 2.0,
    ..AZIMUTHS
};

const BENDS: Param = Param {
    name: "bends",
    summary: "bends of paths, one below the other: 1 for straight paths, more for quadrics",
    min: 1.0,
    default: 1.0,
    ..AZIMUTHS
};

const DEPTH: Param = Param {
    name: "depth",
    summary: "depth of the relief for which the middle elevation is 45 degrees, as a part of a tile's side",
    unit: "tiles",
    min: 0.0001,
    max: 100.0,
    default: 0.1,
    integer: false,
    names: &[],
};

/// The first parameters of these kinds.
pub(crate) const AXES_PARAMS: [Param; 4] = [AZIMUTHS, ELEVATIONS, BENDS, DEPTH];

/// Returns the axes of a kind's settings, without checking them.
pub(crate) fn unchecked_axes(settings: &Settings) -> Axes {
    Axes {
        azimuths: settings.count(0),
        elevations: settings.count(1),
        bends: settings.count(2),
        depth: f64::from(settings.get(3)),
    }
}

/// Returns the axes of a kind's settings.
pub(crate) fn axes_of(settings: &Settings, kind: &'static str) -> Result<Axes, BakeError> {
    let axes = unchecked_axes(settings);
    if axes.layers() > MOST_LAYERS {
        let reason = format!(
            "azimuths times elevations are {}, but a map has at most {MOST_LAYERS} layers: take fewer",
            axes.layers()
        );
        return Err(BakeError::Impossible { kind, reason });
    }
    Ok(axes)
}

/// Describes the texture of such a map: a layer for each direction, in which bends lie below each
/// other.
pub(crate) fn texture(source: &BakeInput, axes: &Axes, channel: crate::Channel) -> Texture {
    let size = [source.map.width(), source.map.height() * axes.bends, axes.layers()];
    let notes = vec![
        ("azimuths", format!("{0}: 2 pi (k + 1/2) / {0}, in tiles from +u towards +v", axes.azimuths)),
        ("elevations", format!("{0}: L / (L + depth) = (k + 1/2) / {0}", axes.elevations)),
        ("bends", axes.bends.to_string()),
        ("depth", axes.depth.to_string()),
        ("wrap", source.map.wrap().name().to_owned()),
    ];
    Texture { name: "", size, mips: Vec::new(), channels: vec![channel], notes }
}
