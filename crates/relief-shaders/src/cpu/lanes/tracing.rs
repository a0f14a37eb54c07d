//! Search and refinement of blocks of paths, included once for each width.

use relief_core::FoundState;

use super::super::block::{BLOCK, LaneGroup};
use super::*;

lanes! {
    /// Traces the paths of a block that `which` has bits for.
    pub(super) fn trace(r: &Resources<'_>, which: u16, paths: &PathBlock, hits: &mut HitBlock) {
        let mut rest = which;
        while let Some(LaneGroup { part, which, use_and_level }) = paths.next_group(LANES, &mut rest) {
            let which = lanes_of(which);
            let hit = stages::trace(r, which, &path_of(paths, part, use_and_level));
            let put = |row: &mut [f32; BLOCK], values: F| {
                store(&mut row.as_chunks_mut().0[part], which, values);
            };
            put(&mut hits.uv[0], hit.uv.x);
            put(&mut hits.uv[1], hit.uv.y);
            put(&mut hits.height, hit.height);
            put(&mut hits.t, hit.t);
            let put = |row: &mut [u32; BLOCK], values: U| {
                store_u(&mut row.as_chunks_mut().0[part], which, values);
            };
            put(&mut hits.found, hit.found);
            put(&mut hits.exhausted, hit.exhausted);
            put(&mut hits.cost[0], hit.cost.x);
            put(&mut hits.cost[1], hit.cost.y);
            put(&mut hits.cost[2], hit.cost.z);
        }
    }
}

lanes! {
    /// Returns bits of the paths of a block on which the search for shadows finds nothing, among
    /// those that `which` has bits for.
    pub(super) fn free(r: &Resources<'_>, which: u16, paths: &PathBlock) -> u16 {
        let (mut rest, mut free) = (which, 0);
        while let Some(LaneGroup { part, which, use_and_level }) = paths.next_group(LANES, &mut rest) {
            let path = path_of(paths, part, use_and_level);
            let found = stages::shadow_search_stage(r, lanes_of(which), &path);
            let missed = eq_u(found.status, splat_u(FoundState::Miss as u32));
            free |= ((bits_of(missed) & which) as u16) << (part * LANES);
        }
        free
    }
}

lanes! {
    /// Loads paths of one purpose and one level.
    fn path_of(paths: &PathBlock, part: usize, [ray, level]: [u32; 2]) -> stages::Path {
        let row = |row: &[f32; BLOCK]| load(&row.as_chunks().0[part]);
        stages::Path {
            uv: Vec2 { x: row(&paths.uv[0]), y: row(&paths.uv[1]) },
            duv: Vec2 { x: row(&paths.duv[0]), y: row(&paths.duv[1]) },
            h: Vec3 { x: row(&paths.h[0]), y: row(&paths.h[1]), z: row(&paths.h[2]) },
            exit: row(&paths.exit),
            base: row(&paths.base),
            metric: Vec4 {
                x: row(&paths.metric[0]),
                y: row(&paths.metric[1]),
                z: row(&paths.metric[2]),
                w: row(&paths.metric[3]),
            },
            ray,
            level,
            start: row(&paths.start),
            share: row(&paths.share),
            bend: row(&paths.bend),
        }
    }
}
