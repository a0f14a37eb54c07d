//! Blocks of paths, included once for each width.

use relief_core::FoundState;

use super::super::block::Together;
use super::*;

lanes! {
    /// Traces the paths of a block that `which` has bits for.
    pub(super) fn trace_block(r: &Resources<'_>, paths: &PathBlock, which: u16, hits: &mut HitBlock) {
        let mut rest = which;
        while let Some(Together { part, which, use_and_level }) = paths.next_together(LANES, &mut rest) {
            trace_part(r, paths, part, which, use_and_level, hits);
        }
    }
}

lanes! {
    /// Of the paths of a block that `which` has bits for, those on which the search for shadows finds
    /// nothing.
    pub(super) fn free_block(r: &Resources<'_>, paths: &PathBlock, which: u16) -> u16 {
        let (mut rest, mut free) = (which, 0);
        while let Some(Together { part, which, use_and_level }) = paths.next_together(LANES, &mut rest) {
            let path = path_of(paths, part, use_and_level);
            let found = generated::shadow_search_stage(r, lanes_of(which), &path);
            let missed = eq_u(found.status, splat_u(FoundState::Miss as u32));
            free |= ((bits_of(missed) & which) as u16) << (part * LANES);
        }
        free
    }
}

lanes! {
    /// Traces paths of one use and one level, in as many places of the block as there are lanes.
    fn trace_part(
        r: &Resources<'_>,
        paths: &PathBlock,
        part: usize,
        which: u32,
        use_and_level: [u32; 2],
        hits: &mut HitBlock
    ) {
        let path = path_of(paths, part, use_and_level);
        let which = lanes_of(which);
        let hit = generated::trace(r, which, &path);
        let put = |row: &mut [f32; super::super::BLOCK], values: F| {
            store(&mut row.as_chunks_mut().0[part], which, values);
        };
        put(&mut hits.uv[0], hit.uv.x);
        put(&mut hits.uv[1], hit.uv.y);
        put(&mut hits.height, hit.height);
        put(&mut hits.t, hit.t);
        let put = |row: &mut [u32; super::super::BLOCK], values: U| {
            store_u(&mut row.as_chunks_mut().0[part], which, values);
        };
        put(&mut hits.found, hit.found);
        put(&mut hits.exhausted, hit.exhausted);
        put(&mut hits.cost[0], hit.cost.x);
        put(&mut hits.cost[1], hit.cost.y);
        put(&mut hits.cost[2], hit.cost.z);
    }
}

lanes! {
    /// Paths of one use and one level.
    fn path_of(paths: &PathBlock, part: usize, [ray, level]: [u32; 2]) -> generated::Path {
        let row = |row: &[f32; super::super::BLOCK]| load(&row.as_chunks().0[part]);
        generated::Path {
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
        }
    }
}
