//! The first hit of paths by place, azimuth, elevation and bend: a view-dependent displacement map.
//!
//! * Wang, Wang, Tong, Lin, Hu, Guo and Shum 2003, "View-dependent displacement mapping".
//! * Szirmay-Kalos and Umenhoffer 2008, section 6.3.
//!
//! # What is stored
//!
//! A layer holds a direction, and in it the bends lie below each other. A texel holds the way of the
//! path that comes in at its centre, in the middle of the steps of [`Axes`], to the first hit, as a
//! part of the path's whole way. 1 says that it meets nothing.
//!
//! # Guarantee
//!
//! *A stored value is the exact tracer's, to the nearest code.* Hits on the last two hundredth
//! and fiftieth part of the way are stored as the code before 1.

use rayon::prelude::*;
use relief_core::exact::cell_walk;
use relief_core::registry::Publication;
use relief_core::{HeightMap, Rounding, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::view_dependent::{AXES_PARAMS, Axes, axes_of, texture, unchecked_axes};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// Farthest hit as a part of the whole way: the last code but one of 8 bits.
pub const LAST_HIT: f32 = 254.0 / 255.0;

/// Factor on the whole way to where a path is searched: more than rounding of its end.
const BEYOND: f64 = 1.0 + 1e-6;

/// The kind `view-dependent`.
pub const KIND: Kind = Kind {
    name: "view-dependent",
    summary: "for each texel and direction, the way of a ray to its first hit: a look-up finds a hit",
    revision: 1,
    publication: Publication {
        paper: "Wang et al. 2003, View-dependent displacement mapping; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.3",
    },
    params: &[AXES_PARAMS[0], AXES_PARAMS[1], AXES_PARAMS[2], AXES_PARAMS[3], BITS_TO_NEAREST],
    guarantee: "From a texel's centre, in the middle of a step of each axis, the first hit with the bilinear \
        surface is at the part of the path's whole way that is stored, to the nearest code.",
    is_picture: false,
    of_volume: false,
    shapes: |[width, height], settings| {
        let axes = unchecked_axes(settings);
        vec![Shape::slices("", [width, height.saturating_mul(axes.bends)], axes.layers(), 1)]
    },
    reach: |_| Reach::Everything,
    working_maps: |settings| 1.0 + settings.get(2),
    bake,
};

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let axes = axes_of(settings, KIND.name)?;
    let channel = Channel { name: "way", unit: "1", range: [0.0, 1.0], rounding: Rounding::Nearest };
    sink.begin(&texture(source, &axes, channel))?;
    let mut ways = vec![0.0; source.map.texels().len() * axes.bends as usize];
    for layer in 0..axes.layers() {
        let part = |layer: u32| layer as f32 / axes.layers() as f32;
        first_hits(source.map, &axes, layer, &watch.piece(part(layer), part(layer + 1)), &mut ways)?;
        to_nearest(sink, &[channel], settings.count(4), &mut [&mut ways])?;
    }
    Ok(())
}

/// Sets the parts of the whole ways to the first hits of a layer, bend after bend, row by row.
fn first_hits(
    map: &HeightMap,
    axes: &Axes,
    layer: u32,
    watch: &Watch,
    ways: &mut [f32],
) -> Result<(), BakeError> {
    let size = [map.width(), map.height()];
    watch.at(0.0)?;
    ways.par_chunks_mut(size[0] as usize).enumerate().try_for_each(|(line, ways)| {
        watch.check()?;
        let [bend, row] = [line as u32 / size[1], line as u32 % size[1]];
        let from_centre = axes.path([0.0; 2], layer, bend);
        // A path that ends at height 0 must not end above it by rounding.
        let exit = from_centre.exit * BEYOND;
        for (column, way) in ways.iter_mut().enumerate() {
            let uv = [column as u32, row].map(|at| f64::from(at) + 0.5);
            let uv = [uv[0] / f64::from(size[0]), uv[1] / f64::from(size[1])];
            let hit = cell_walk(map, &relief_core::Path { uv, exit, ..from_centre }).hit;
            *way = if hit.found { ((hit.t / from_centre.exit) as f32).min(LAST_HIT) } else { 1.0 };
        }
        Ok::<(), BakeError>(())
    })
}
