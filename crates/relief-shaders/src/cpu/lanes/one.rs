//! Tasks place by place, with single numbers.

use relief_core::FoundState;

use super::block::places;
use super::task::{LightPoint, Task, TriangleRays};
use crate::MAX_LIGHTS;
use crate::cpu::generated::Resources;
use crate::cpu::{PixelIn, Triangle, Vec4};

impl TriangleRays<'_> {
    fn pixel(&self, r: &Resources<'_>, at: usize) -> PixelIn {
        let Triangle { a, b, c, shell } = *self.triangle;
        r.pixel_of(a, b, c, shell, self.side, self.points.map(|row| row[at]))
    }
}

/// Does a task for the places that `which` has bits for.
pub(super) fn run(r: &Resources<'_>, which: u16, task: Task<'_>) {
    match task {
        Task::Trace { paths, hits } => {
            for place in places(which) {
                hits.set(place, &r.trace(paths.get(place)));
            }
        }
        Task::Free { paths, free } => {
            for place in places(which) {
                let found = r.shadow_search_stage(paths.get(place));
                let is_free = found.status == FoundState::Miss as u32;
                *free = *free & !(1 << place) | u16::from(is_free) << place;
            }
        }
        Task::Enter { rays, at, paths } => {
            for place in places(which) {
                let pixel = rays.pixel(r, place);
                let entered = r.enter_relief(pixel);
                at.set(place, &entered);
                if entered.segments > 0 {
                    paths.set(place, &r.segment_of(pixel, entered, 0u32));
                }
            }
        }
        Task::Segment { rays, number, at, paths } => {
            for place in places(which) {
                paths.set(place, &r.segment_of(rays.pixel(r, place), at.get(place), number));
            }
        }
        Task::Meet { rays, number, at, paths, hits, keys } => {
            for place in places(which) {
                let (entered, path, hit) = (at.get(place), paths.get(place), hits.get(place));
                let first = r.hit_on_segment(rays.pixel(r, place), entered, path, hit, number);
                hits.set(place, &first.hit);
                keys[place] = first.key;
            }
        }
        Task::Place { rays, at, paths, hits, placed } => {
            for place in places(which) {
                let (entered, path, hit) = (at.get(place), paths.get(place), hits.get(place));
                placed.set(place, &r.place_on_segment(rays.pixel(r, place), entered, path, hit));
            }
        }
        Task::RaysToLight { to: LightPoint { light, point, count }, placed, hits, states, paths } => {
            for place in places(which) {
                let ray = r.ray_to_light(placed.get(place), hits.get(place), light, point, count);
                states[place] = ray.state;
                paths.set(place, &ray.path);
            }
        }
        Task::Visible { light, placed, hits, parts } => {
            for place in places(which) {
                parts[place] = r.visible_light(placed.get(place), hits.get(place), light);
            }
        }
        Task::Shade { points, placed, hits, visible, pixels } => {
            for place in places(which) {
                let origin = r.pixel_eye(points.map(|row| row[place]));
                let of_light = |light: usize| Vec4::from([visible[light][place], 0.0, 0.0, 0.0]);
                let visible: [_; MAX_LIGHTS] = std::array::from_fn(of_light);
                pixels.set(place, &r.shade_hit(origin, placed.get(place), hits.get(place), visible));
            }
        }
    }
}
