//! How far an object is from the mesh that it was captured from.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::camera::Ray;
use relief_core::object::{ImageObject, JumpCells, View};
use relief_core::rng::Rng;

use crate::{CaptureError, DEFAULT_JUMP_TEXELS, Measured};

/// The most pictures that are compared, and the most pixels of a side of each.
pub const MAX_PICTURES: [u32; 2] = [4096, 4096];

/// The seed of the directions: the same for all objects.
const SEED: u64 = 2001;

/// Of how many random directions each is the one that is farthest from all before it.
const CANDIDATES: u32 = 16;

/// How an object is compared with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verification {
    /// Pictures, from [`even_directions`].
    pub views: u32,
    /// Pixels of a side of each, which is as wide as the ball.
    pub size: u32,
    /// What cells are where heights jump.
    pub cells: JumpCells,
    /// By how many texels cells differ that jump.
    pub jump_texels: f64,
}

impl Default for Verification {
    /// 32 pictures of 128 x 128 pixels.
    fn default() -> Self {
        Self { views: 32, size: 128, cells: JumpCells::default(), jump_texels: DEFAULT_JUMP_TEXELS }
    }
}

/// So many directions over the whole sphere, as random as they can be where none comes near another: the same
/// ones each time.
///
/// Each is the best of some candidates (Mitchell 1991). An object's errors depend on the direction, and the
/// mean of a few pictures is nearer to that of many where no side is seen twice as often as another.
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

/// What is counted of a picture, or of a row.
#[derive(Clone, Copy, Default)]
struct Counts {
    both: u64,
    either: u64,
    /// Metres between both, over the pixels that show both.
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

    /// Pixels that show both of those that show one; all where none shows any.
    fn iou(&self) -> f64 {
        if self.either == 0 { 1.0 } else { self.both as f64 / self.either as f64 }
    }

    fn error_percent(&self, radius: f64) -> Option<f64> {
        (self.both > 0).then(|| 100.0 * self.apart_m / self.both as f64 / (2.0 * radius))
    }
}

/// Where a ray first meets a mesh, by its parameter.
pub(crate) type FirstHit<'a> = dyn Fn(&Ray) -> Option<f64> + Sync + 'a;

/// Compares an object with a mesh by parallel rays through a ball, from [`even_directions`].
///
/// The rays see both sides of the mesh's triangles. None where no picture is asked for.
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

/// What one pixel shows of both.
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
