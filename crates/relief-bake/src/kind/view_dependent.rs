//! The first hit of paths by place, azimuth, elevation and bend: a view-dependent displacement map.
//!
//! * Wang, Wang, Tong, Lin, Hu, Guo and Shum 2003, "View-dependent displacement mapping".
//! * Wang and Dana 2005, "Compression of view dependent displacement maps".
//! * Szirmay-Kalos and Umenhoffer 2008, section 6.3.
//!
//! # What is stored
//!
//! A layer holds a direction, and in it the bends lie below each other. A texel holds the way of the
//! path that comes in at its centre, in the middle of the steps of [`Axes`], to the first hit, as a
//! part of the path's whole way. 1 says that it meets nothing.
//!
//! With a rank, each way is a sum of that many products: a factor of the texel times a factor of the
//! direction and bend. With clusters, each group of texels that are alike has factors of its own,
//! which are not negative. [`crate::view_dependent`] has the texture's layout.
//!
//! # Guarantee
//!
//! *A stored value is the exact tracer's, to the nearest code.* Hits on the last two hundredth
//! and fiftieth part of the way are stored as the code before 1.
//!
//! A sum of products is near these ways, without a bound. Without clusters, other sums of as many
//! products leave out squares that are less by a thousandth at most, before factors are rounded to
//! codes. Tests hold this; the decomposition starts from random directions and has no proof.

use rayon::prelude::*;
use relief_core::exact::cell_walk;
use relief_core::registry::{Param, Publication};
use relief_core::{HeightMap, MAX_SIDE, Rounding, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::view_dependent::{
    AXES_PARAMS, Axes, Compression, Matrix, axes_of, texture, unchecked_axes, write_compressed,
};
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
    params: &[
        AXES_PARAMS[0],
        AXES_PARAMS[1],
        AXES_PARAMS[2],
        AXES_PARAMS[3],
        BITS_TO_NEAREST,
        RANK,
        CLUSTERS,
    ],
    guarantee: "From a texel's centre, in the middle of a step of each axis, the first hit with the bilinear \
        surface is at the part of the path's whole way that is stored, to the nearest code. With a rank, \
        factors are stored, and the sums of their products are near that part, without a bound.",
    is_picture: false,
    of_volume: false,
    shapes: |[width, height], settings| {
        let axes = unchecked_axes(settings);
        let Some(compression) = unchecked_compression(settings) else {
            return vec![Shape::slices("", [width, height.saturating_mul(axes.bends)], axes.layers(), 1)];
        };
        let height = height.saturating_add(compression.rows_of_views(&axes, width));
        vec![Shape::slices("", [width, height], compression.layers(), 4)]
    },
    reach: |_| Reach::Everything,
    working_maps: |settings| match unchecked_compression(settings) {
        None => 1.0 + settings.get(2),
        // The ways, and again group by group; what the steps of a decomposition hold.
        Some(compression) => {
            let ways = (unchecked_axes(settings).layers() * settings.count(2)) as f32;
            let groups = if compression.clusters > 0 { ways } else { 0.0 };
            ways + groups + 4.0 * (compression.rank + compression.clusters + 32) as f32
        }
    },
    bake,
};

const RANK: Param = Param {
    name: "rank",
    summary: "products that are summed to each way, so that the map is smaller; 0 stores the ways themselves",
    unit: "",
    min: 0.0,
    max: 256.0,
    default: 0.0,
    integer: true,
    names: &[],
};

const CLUSTERS: Param = Param {
    name: "clusters",
    summary: "groups of texels, by k-means, each with factors of its own that are not negative; 0 for no \
        groups, but a singular value decomposition of all",
    ..RANK
};

/// Returns the compression of a kind's settings, without checking it.
fn unchecked_compression(settings: &Settings) -> Option<Compression> {
    let [rank, clusters] = [settings.count(5), settings.count(6)];
    (rank > 0).then_some(Compression { rank, clusters })
}

/// Returns the compression of a kind's settings.
fn compression_of(
    settings: &Settings,
    axes: &Axes,
    size: [u32; 2],
) -> Result<Option<Compression>, BakeError> {
    let impossible = |reason| Err(BakeError::Impossible { kind: KIND.name, reason });
    let Some(compression) = unchecked_compression(settings) else {
        return match settings.count(6) {
            0 => Ok(None),
            _ => impossible(
                "clusters need a rank: set how many products a way's sum has, such as 12".to_owned(),
            ),
        };
    };
    let views = axes.layers() * axes.bends;
    if compression.rank > views {
        return impossible(format!(
            "rank is {}, but it is at most {views}, the azimuths times elevations times bends: take a lower \
             rank, or more directions",
            compression.rank
        ));
    }
    let rows = compression.rows_of_views(axes, size[0]);
    if size[1].saturating_add(rows) > MAX_SIDE {
        return impossible(format!(
            "the factors of all directions, bends and clusters take {rows} rows of {} texels, but a map has \
             at most {MAX_SIDE}: take fewer clusters or directions",
            size[0]
        ));
    }
    Ok(Some(compression))
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let axes = axes_of(settings, KIND.name)?;
    let channel = Channel { name: "way", unit: "1", range: [0.0, 1.0], rounding: Rounding::Nearest };
    let size = [source.map.width(), source.map.height()];
    if let Some(compression) = compression_of(settings, &axes, size)? {
        return bake_compressed(source, &axes, compression, settings.count(4), watch, sink);
    }
    sink.begin(&texture(source, &axes, channel))?;
    let mut ways = vec![0.0; source.map.texels().len() * axes.bends as usize];
    for layer in 0..axes.layers() {
        let part = |layer: u32| layer as f32 / axes.layers() as f32;
        first_hits(source.map, &axes, layer, &watch.piece(part(layer), part(layer + 1)), &mut ways)?;
        to_nearest(sink, &[channel], settings.count(4), &mut [&mut ways])?;
    }
    Ok(())
}

/// Bakes factors whose products' sums are the ways.
fn bake_compressed(
    source: &BakeInput,
    axes: &Axes,
    compression: Compression,
    bits: u32,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let channels = ["term 0", "term 1", "term 2", "term 3"].map(|name| Channel {
        name,
        unit: "1",
        range: [0.0, 1.0],
        rounding: Rounding::Nearest,
    });
    let [columns, rows] = [source.map.width(), source.map.height()];
    let mut texture = texture(source, axes, channels[0]);
    texture.size = [columns, rows + compression.rows_of_views(axes, columns), compression.layers()];
    texture.channels = channels.to_vec();
    texture.notes.push(("rank", compression.rank.to_string()));
    texture.notes.push(("clusters", compression.clusters.to_string()));
    sink.begin(&texture)?;
    const OF_WAYS: f32 = 0.5;
    let texels = source.map.texels().len();
    let mut ways = Matrix::zero((axes.layers() * axes.bends) as usize, texels);
    let layers = ways.values.chunks_mut(texels * axes.bends as usize);
    for (layer, ways) in (0..axes.layers()).zip(layers) {
        let part = |layer: u32| OF_WAYS * layer as f32 / axes.layers() as f32;
        first_hits(source.map, axes, layer, &watch.piece(part(layer), part(layer + 1)), ways)?;
    }
    let watch = watch.piece(OF_WAYS, 1.0);
    write_compressed(ways, compression, columns, (&channels, bits), &watch, sink)
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
