//! Comparison of an object with the mesh that it was captured from.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::camera::Ray;
use relief_core::object::{ImageObject, JumpCells, View};
use relief_core::rng::Rng;

use crate::{CaptureError, DEFAULT_JUMP_TEXELS, Measured};

/// Most pictures that are compared, and longest side of each in pixels.
pub const MAX_PICTURES: [u32; 2] = [4096, 4096];

/// Seed of the directions, the same for all objects.
const SEED: u64 = 2001;

/// Number of random candidates for each direction. The candidate farthest from all earlier
/// directions is chosen.
const CANDIDATES: u32 = 16;

/// Settings of a comparison of an object with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verification {
    /// Number of pictures. Their directions are [`even_directions`].
    pub views: u32,
    /// Side of each picture in pixels. A picture is as wide as the ball.
    pub size: u32,
    /// Treatment of cells whose heights jump.
    pub cells: JumpCells,
    /// Difference above which cells jump, in texels.
    pub jump_texels: f64,
}

impl Default for Verification {
    /// Returns settings for 32 pictures of 128 x 128 pixels.
    fn default() -> Self {
        Self { views: 32, size: 128, cells: JumpCells::default(), jump_texels: DEFAULT_JUMP_TEXELS }
    }
}

/// Returns `count` directions over the whole sphere: random, but evenly spread, and the same each
/// time.
///
/// Each is the best of some candidates (Mitchell 1991). An object's errors depend on the direction.
/// With even directions, the mean of a few pictures is nearer to the mean of many.
pub fn even_directions(count: u32) -> Vec<DVec3> {
    let mut rng = Rng::new(SEED);
    let mut directions: Vec<DVec3> = Vec::with_capacity(count as usize);
    for _ in 0..count {
        let nearest = |to: DVec3| directions.iter().map(|other| other.dot(to)).fold(-1.0, f64::max);
        let mut best = (f64::INFINITY, DVec3::X);
        for _ in 0..CANDIDATES {
            let candidate = rng.direction();
            let near = nearest(candidate);
            if near < best.0 {
                best = (near, candidate);
            }
        }
        directions.push(best.1);
    }
    directions
}

/// Counts of a picture, or of a row.
#[derive(Clone, Copy, Default)]
struct Counts {
    both: u64,
    either: u64,
    /// Sum of the distances between both, in metres, over the pixels that show both.
    apart_m: f64,
}

impl Counts {
    fn and(self, other: Self) -> Self {
        Self {
            both: self.both + other.both,
            either: self.either + other.either,
            apart_m: self.apart_m + other.apart_m,
        }
    }

    /// Pixels that show both, divided by pixels that show either. 1 if no pixel shows any.
    fn iou(&self) -> f64 {
        if self.either == 0 { 1.0 } else { self.both as f64 / self.either as f64 }
    }

    fn error_percent(&self, radius: f64) -> Option<f64> {
        (self.both > 0).then(|| 100.0 * self.apart_m / self.both as f64 / (2.0 * radius))
    }
}

/// Function that returns the parameter of a ray's first hit with a mesh.
pub(crate) type FirstHit<'a> = dyn Fn(&Ray) -> Option<f64> + Sync + 'a;

/// Compares an object with a mesh in pictures with parallel rays through a ball, from
/// [`even_directions`].
///
/// The rays hit both sides of the mesh's triangles. `None` if no picture is requested.
pub(crate) fn measure(
    first: &FirstHit<'_>,
    object: &ImageObject,
    (centre, radius): (DVec3, f64),
    verification: &Verification,
    watch: &Watch,
) -> Result<Option<Measured>, CaptureError> {
    let Verification { views, size, cells, jump_texels } = *verification;
    let [most_views, most_size] = MAX_PICTURES;
    if views == 0 {
        return Ok(None);
    }
    if views > most_views || size == 0 || size > most_size {
        return Err(CaptureError::BadPictures { views, size });
    }
    let directions = even_directions(views);
    let done = AtomicU64::new(0);
    let of_view = |(number, from): (usize, &DVec3)| {
        let view = View::orthographic(centre, radius, *from, None, [size; 2]);
        let view = view.map_err(|problem| CaptureError::View { number: number + 1, problem })?;
        let mut counts = Counts::default();
        for y in 0..size {
            watch.check()?;
            let row = (0..size).map(|x| pixel(first, object, &view, [x, y]));
            counts = row.fold(counts, Counts::and);
        }
        let part = done.fetch_add(1, Ordering::Relaxed) + 1;
        watch.at(part as f32 / views as f32)?;
        Ok(counts)
    };
    let counts = directions.par_iter().enumerate().map(of_view).collect::<Result<Vec<_>, CaptureError>>()?;
    let all = counts.iter().copied().fold(Counts::default(), Counts::and);
    let worst = |a: &usize, b: &usize| counts[*a].iou().total_cmp(&counts[*b].iou());
    let worst = (0..counts.len()).min_by(worst).unwrap_or_default();
    let errors = counts.iter().filter_map(|counts| counts.error_percent(radius));
    Ok(Some(Measured {
        views,
        size,
        cells,
        jump_texels,
        iou: all.iou(),
        depth_error_percent: all.error_percent(radius),
        worst_from: directions[worst],
        worst_iou: counts[worst].iou(),
        worst_depth_error_percent: errors.reduce(f64::max),
    }))
}

/// Counts of one pixel.
fn pixel(first: &FirstHit<'_>, object: &ImageObject, view: &View, [x, y]: [u32; 2]) -> Counts {
    let [u, v] = [x, y].map(|at| (f64::from(at) + 0.5) / f64::from(view.size()[0]));
    let ray = view.ray(u, v);
    let mesh = first(&ray);
    let object = object.first_hit(&ray).map(|hit| hit.t);
    match (mesh, object) {
        (Some(mesh), Some(object)) => Counts { both: 1, either: 1, apart_m: (mesh - object).abs() },
        (None, None) => Counts::default(),
        _ => Counts { either: 1, ..Counts::default() },
    }
}
