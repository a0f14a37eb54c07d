//! Seen normals: the relief's normals as an eye sees them from fixed directions.
//!
//! Becker and Max 1993, *Smooth transitions between bump rendering algorithms*, redistribute the
//! normals of a bump map: an eye then sees as much of each as it would of the displaced surface.
//! Szirmay-Kalos and Umenhoffer 2008, section 4.1.1. Both tabulate the distribution of the normals
//! by the direction of view. Here every texel has a table of its own, with the means over its area.
//!
//! # What is stored
//!
//! The texture has a quarter of the map's sides, rounded down, and mip levels, each a mean over
//! areas. All rays of a direction are parallel. They come from an eye at azimuth `a`, at the angle
//! `2π a / azimuths` in metres from `+u` towards `+v`, and at elevation `e`, whose sine is
//! `(e + 1) / elevations`. The last elevation looks straight down.
//!
//! A ray belongs to the texel over which it crosses the plane at the map's mean height. Its normal
//! is taken at the first hit, by central differences over two texels, or over less at the edge of a
//! clamped map. It is a unit vector in tangent space, `y` along falling `v`. Slice
//! `2 (a * elevations + e)` holds the means of `x`, `y`, `z` and `x²`. The next slice holds the
//! means of `xy`, `y²`, `xz` and `yz`. (`z²` is the rest to 1.)
//!
//! # Guarantee
//!
//! One ray is traced for each texel of the map. Its hit is the exact first hit to `f32` rounding of
//! the fast exact tracer. A mean over many texels is the mean of its rays; the area between the
//! rays is not sampled.

use relief_core::area_mean::{coarser, coarser_of, coarser_size, level_count};
use relief_core::encoding::seen_normal::{self, FIRST_LEVEL};
use relief_core::exact::FastTracer;
use relief_core::registry::{Param, Publication};
use relief_core::{HeightMap, Metric, Path, PathMetric, Rounding, Watch};

use super::visibility::ELEVATIONS;
use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{self, unit_vector};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// Values of a direction: the means of a normal's components and of their products.
const MEANS: usize = 8;

/// The kind `seen-normal`.
pub const KIND: Kind = Kind {
    name: "seen-normal",
    summary: "means of the normals that are visible from fixed directions, for distant surfaces",
    revision: 2,
    publication: Publication {
        paper: "Becker and Max 1993; Szirmay-Kalos and Umenhoffer 2008",
        section: "4.1.1",
    },
    params: &[
        Param {
            summary: "number of azimuths of the viewing directions",
            default: seen_normal::AZIMUTHS as f32,
            max: 64.0,
            ..azimuths::AZIMUTHS
        },
        Param {
            summary: "number of elevations in each azimuth, equally spaced in the sine",
            default: seen_normal::ELEVATIONS as f32,
            ..ELEVATIONS
        },
        BITS_TO_NEAREST,
    ],
    guarantee: "the mean over one ray a texel, each to its exact first hit, to rounding of f32",
    is_picture: false,
    of_volume: false,
    shapes: |size, settings| vec![shape(size, settings.count(0) * settings.count(1))],
    reach: |_| Reach::Everything,
    working_maps: |settings| (settings.count(0) * settings.count(1)) as f32 / 8.0 + 6.5,
    bake,
};

/// Shape with two slices a direction, and all levels.
fn shape(map: [u32; 2], directions: u32) -> Shape {
    let first = FIRST_LEVEL.min(level_count(map) - 1);
    let mut size = (0..first).fold(map, |size, _| coarser_size(size));
    let mut shape = Shape::slices("", size, 2 * directions, 4);
    while size != [1, 1] {
        size = coarser_size(size);
        shape.mips.push([size[0], size[1], 2 * directions]);
    }
    shape
}

/// Rays toward an eye.
struct Eye<'a> {
    map: &'a HeightMap,
    tracer: &'a FastTracer,
    metric: Metric,
    /// Way of a ray in texture coordinates while it sinks by a height of 1.
    down: [f64; 2],
    /// Height at which a texel's ray crosses over it.
    middle: f64,
}

impl Eye<'_> {
    /// Returns the normal that is seen over a point, and the products of its components.
    fn seen(&self, uv: [f64; 2]) -> [f32; MEANS] {
        let start = [0, 1].map(|axis| uv[axis] - self.down[axis] * (1.0 - self.middle));
        let path = Path {
            uv: start,
            duv: self.down,
            h: [1.0, -1.0, 0.0],
            exit: 1.0,
            base: 0.0,
            metric: PathMetric::unit(1.0),
        };
        let hit = self.tracer.trace(&path).hit;
        // A ray along the lowest level may leave it by a rounding.
        let [x, y, z] = self.normal(if hit.found { hit.uv } else { uv });
        [x, y, z, x * x, x * y, y * y, x * z, y * z].map(|mean| mean as f32)
    }

    /// Returns the unit normal at a point.
    fn normal(&self, [u, v]: [f64; 2]) -> [f64; 3] {
        let [du, dv] = [1.0 / f64::from(self.map.width()), 1.0 / f64::from(self.map.height())];
        let rise_u = self.map.height_at(u + du, v) - self.map.height_at(u - du, v);
        let rise_v = self.map.height_at(u, v + dv) - self.map.height_at(u, v - dv);
        let Metric { tile_m, scale_m } = self.metric;
        let apart = self.map.texels_apart_at(u, v);
        let x = -rise_u * scale_m / (apart[0] * du * tile_m[0]);
        let y = rise_v * scale_m / (apart[1] * dv * tile_m[1]);
        let length = (x * x + y * y + 1.0).sqrt();
        [x / length, y / length, 1.0 / length]
    }
}

/// The working set is the second level of the texture, 4 maps with the default directions, and 6.5
/// maps more.
fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, elevations, bits) = (settings.count(0), settings.count(1), settings.count(2));
    let (map, metric) = (source.map, source.metric);
    let channels = ["x or xy", "y or yy", "z or xz", "xx or yz"].map(|name| Channel {
        name,
        unit: "1",
        range: [-1.0, 1.0],
        rounding: Rounding::Nearest,
    });
    let full = azimuths::texture(source, azimuths, 2 * azimuths * elevations, channels.to_vec());
    let Shape { size, mips, .. } = shape([map.width(), map.height()], azimuths * elevations);
    let mut texture = Texture { size, mips, ..full };
    texture.notes.push(("elevations", format!("{elevations}: sin = (e + 1) / {elevations}")));
    sink.begin(&texture)?;

    let tracer = FastTracer::new(map);
    let middle = f64::from(map.mean());
    let directions = azimuths * elevations;
    let mut size = [texture.size[0], texture.size[1]];
    let mut level = Vec::new();
    for direction in 0..directions {
        watch.at(direction as f32 / directions as f32)?;
        let (azimuth, elevation) = (direction / elevations, direction % elevations);
        let up = f64::from(elevation + 1) / f64::from(elevations);
        let flat = (1.0 - up * up).max(0.0).sqrt() / up;
        let [cos, sin] = unit_vector(azimuth, azimuths);
        let along = [cos * flat / metric.tile_m[0], sin * flat / metric.tile_m[1]];
        let down = along.map(|x| -x * metric.scale_m);
        let means = finest(&Eye { map, tracer: &tracer, metric, down, middle });
        hand_out(&means, &channels, bits, sink)?;
        level.push(coarser(&means, size));
    }
    while size != [1, 1] {
        size = coarser_size(size);
        for means in &mut level {
            hand_out(means, &channels, bits, sink)?;
            *means = coarser(means, size);
        }
    }
    Ok(())
}

/// Hands both slices of a direction to the sink.
fn hand_out(
    means: &[[f32; MEANS]],
    channels: &[Channel],
    bits: u32,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    for half in 0..2 {
        let plane = |part: usize| means.iter().map(|mean| mean[4 * half + part]).collect();
        let mut planes: [Vec<f32>; 4] = std::array::from_fn(plane);
        to_nearest(sink, channels, bits, &mut planes.each_mut().map(Vec::as_mut_slice))?;
    }
    Ok(())
}

/// Computes the finest level of a direction.
fn finest(eye: &Eye) -> Vec<[f32; MEANS]> {
    let size = [eye.map.width(), eye.map.height()];
    let levels = level_count(size);
    let width = size[0] as usize;
    let place = |at: usize| {
        let [i, j] = [at % width, at / width].map(|index| index as f64 + 0.5);
        [i / f64::from(size[0]), j / f64::from(size[1])]
    };
    if levels == 1 {
        return vec![eye.seen(place(0))];
    }
    let means = coarser_of(|at| eye.seen(place(at)), size);
    if levels > FIRST_LEVEL { coarser(&means, coarser_size(size)) } else { means }
}
