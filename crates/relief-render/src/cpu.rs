//! The CPU backend: the base mesh is ray cast, the translated shaders do the rest.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;
use relief_core::exact::FastTracer;
use relief_shaders::cpu::{Entered, Hit, PixelIn, PixelOut, Resources, Triangle};

use crate::camera::Ray;
use crate::job::{Job, Rendering};
use crate::raycast::{RayCaster, Sides};

/// Renders a job on all cores. `progress` is told the finished part, from 0 to 1, from any thread.
///
/// With a `tracer` it takes the place of search and refinement: the exact method runs the core's fast exact tracer.
pub fn render(
    job: &Job,
    base: &RayCaster,
    tracer: Option<&FastTracer>,
    progress: &(dyn Fn(f32) + Sync),
) -> Rendering {
    let resources = job.resources();
    let sides = if job.two_sided { Sides::Both } else { Sides::Front };
    let done = AtomicU32::new(0);
    let pixel = |x: u32, y: u32| {
        let point = [x as f32 + 0.5, y as f32 + 0.5];
        shade(&resources, job.triangles, base, sides, tracer, point).unwrap_or_else(uncovered)
    };
    let mut pixels = vec![uncovered(); job.width as usize * job.height as usize];
    // A picture without columns has no rows to go through either.
    pixels.par_chunks_mut(job.width.max(1) as usize).enumerate().for_each(|(y, row)| {
        for (shaded, x) in row.iter_mut().zip(0..) {
            *shaded = pixel(x, y as u32);
        }
        let rows = done.fetch_add(1, Ordering::Relaxed) + 1;
        progress(rows as f32 / job.height as f32);
    });
    Rendering { width: job.width, height: job.height, pixels }
}

/// A pixel that nothing covers.
fn uncovered() -> PixelOut {
    PixelOut::new([0.0; 4], 0u32, 0u32, [0.0; 2], 0.0, [0.0; 3], [0.0; 3], 0.0, 0.0, [0; 2], 0u32)
}

/// The first surface along the ray whose relief is hit.
fn shade(
    resources: &Resources,
    triangles: &[Triangle],
    base: &RayCaster,
    sides: Sides,
    tracer: Option<&FastTracer>,
    point: [f32; 2],
) -> Option<PixelOut> {
    let direction = resources.pixel_direction(point);
    let eye = resources.settings.eye;
    let ray = Ray {
        origin: [eye.x, eye.y, eye.z].map(f64::from).into(),
        direction: [direction.x, direction.y, direction.z].map(f64::from).into(),
    };
    base.hits(&ray, sides).find_map(|surface| {
        let side = if surface.front { 1.0 } else { -1.0 };
        let Triangle { a, b, c } = triangles[surface.triangle as usize];
        let pixel = resources.pixel_of(a, b, c, side, point);
        let shaded = match tracer {
            None => resources.shade_pixel(pixel),
            Some(tracer) => trace_exactly(resources, tracer, pixel),
        };
        (shaded.hit == 1).then_some(shaded)
    })
}

fn trace_exactly(resources: &Resources, tracer: &FastTracer, pixel: PixelIn) -> PixelOut {
    let at: Entered = resources.surface_stage(pixel);
    let hit = if at.valid == 1 { tracer.trace(&(&at.path).into()).hit } else { relief_core::Hit::miss(0) };
    resources.shade_hit(pixel, at, Hit::from(&hit))
}
