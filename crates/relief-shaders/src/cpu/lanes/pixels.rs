//! Stages before and after search and refinement, for blocks of pixels, included once for each
//! width.

use super::super::block::{BLOCK, Row};
use super::super::task::{LightPoint, TriangleRays};
use super::pixel_stages::{
    PixelIn, enter_relief, hit_on_segment, load_entered, load_hit, load_path, pixel_direction, pixel_eye,
    place_on_segment, ray_to_light, segment_of, shade_hit, store_entered, store_hit, store_path,
    store_pixel_out, visible_light,
};
use super::*;

/// The parts of a block that hold some of its places. A part is as wide as the lanes.
fn parts(which: u16) -> impl Iterator<Item = (usize, u32)> {
    let every = u32::MAX >> (32 - LANES);
    (0..BLOCK / LANES)
        .map(move |part| (part, u32::from(which) >> (part * LANES) & every))
        .filter(|(_, bits)| *bits != 0)
}

lanes! {
    /// Does a task for the places that `which` has bits for.
    pub(super) fn run(r: &Resources<'_>, which: u16, task: Task<'_>) {
        match task {
            Task::Trace { paths, hits } => tracing::trace(r, which, paths, hits),
            Task::Free { paths, free } => *free = *free & !which | tracing::free(r, which, paths),
            Task::Enter { rays, at, paths } => {
                for (part, bits) in parts(which) {
                    let (lanes, pixel) = (lanes_of(bits), pixel_of(r, &rays, part));
                    let entered = enter_relief(r, lanes, &pixel);
                    store_entered(at, part, lanes, &entered);
                    let has_segment = and(lanes, not(eq_u(entered.segments, splat_u(0))));
                    if any(has_segment) {
                        let path = segment_of(r, has_segment, &pixel, &entered, 0);
                        store_path(paths, part, has_segment, &path);
                    }
                }
            }
            Task::Segment { rays, number, at, paths } => {
                for (part, bits) in parts(which) {
                    let (lanes, pixel) = (lanes_of(bits), pixel_of(r, &rays, part));
                    let path = segment_of(r, lanes, &pixel, &load_entered(at, part), number);
                    store_path(paths, part, lanes, &path);
                }
            }
            Task::Meet { rays, number, at, paths, hits, keys } => {
                for (part, bits) in parts(which) {
                    let (lanes, pixel) = (lanes_of(bits), pixel_of(r, &rays, part));
                    let (entered, path) = (load_entered(at, part), load_path(paths, part));
                    let hit = load_hit(hits, part);
                    let first = hit_on_segment(r, lanes, &pixel, &entered, &path, &hit, number);
                    store_hit(hits, part, lanes, &first.hit);
                    store(&mut keys.as_chunks_mut().0[part], lanes, first.key);
                }
            }
            Task::Place { rays, at, paths, hits, placed } => {
                for (part, bits) in parts(which) {
                    let (lanes, pixel) = (lanes_of(bits), pixel_of(r, &rays, part));
                    let (entered, path) = (load_entered(at, part), load_path(paths, part));
                    let hit = load_hit(hits, part);
                    let place = place_on_segment(r, lanes, &pixel, &entered, &path, &hit);
                    store_entered(placed, part, lanes, &place);
                }
            }
            Task::RaysToLight { to: LightPoint { light, point, count }, placed, hits, states, paths } => {
                for (part, bits) in parts(which) {
                    let (lanes, place) = (lanes_of(bits), load_entered(placed, part));
                    let hit = load_hit(hits, part);
                    let ray = ray_to_light(r, lanes, &place, &hit, light, point, count);
                    store_u(&mut states.as_chunks_mut().0[part], lanes, ray.state);
                    store_path(paths, part, lanes, &ray.path);
                }
            }
            Task::Visible { light, placed, hits, parts: of_light } => {
                for (part, bits) in parts(which) {
                    let (lanes, place) = (lanes_of(bits), load_entered(placed, part));
                    let visible = visible_light(r, lanes, &place, &load_hit(hits, part), light);
                    store(&mut of_light.as_chunks_mut().0[part], lanes, visible);
                }
            }
            Task::Shade { points, placed, hits, visible, pixels } => {
                for (part, bits) in parts(which) {
                    let (lanes, place) = (lanes_of(bits), load_entered(placed, part));
                    let zero = splat(0.0);
                    let of_light = visible.each_ref().map(|row| {
                        Vec4 { x: load(&row.as_chunks().0[part]), y: zero, z: zero, w: zero }
                    });
                    let origin = pixel_eye(r, point_of(points, part));
                    let hit = load_hit(hits, part);
                    let pixel = shade_hit(r, lanes, origin, &place, &hit, &of_light);
                    store_pixel_out(pixels, part, lanes, &pixel);
                }
            }
        }
    }
}

lanes! {
    fn point_of(points: &[Row<f32>; 2], part: usize) -> Vec2<F> {
        Vec2 { x: load(&points[0].as_chunks().0[part]), y: load(&points[1].as_chunks().0[part]) }
    }
}

lanes! {
    fn pixel_of(r: &Resources<'_>, rays: &TriangleRays<'_>, part: usize) -> PixelIn {
        let Triangle { a, b, c, shell } = *rays.triangle;
        let point = point_of(rays.points, part);
        let (origin, direction) = (pixel_eye(r, point), pixel_direction(r, point));
        PixelIn { origin, direction, side: rays.side, a, b, c, shell }
    }
}
