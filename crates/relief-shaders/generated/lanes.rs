// The stages over lanes. Written by `cargo xtask link`; do not edit.

use super::*;

#[derive(Clone, Copy)]
pub struct Around {
    pub columns: Vec2<I>,
    pub rows: Vec2<I>,
    pub part: Vec2<F>,
}
lanes! { fn sel_around(m: M, a: &Around, b: &Around) -> Around {
    Around {
        columns: Vec2 { x: sel_i(m, a.columns.x, b.columns.x), y: sel_i(m, a.columns.y, b.columns.y) },
        rows: Vec2 { x: sel_i(m, a.rows.x, b.rows.x), y: sel_i(m, a.rows.y, b.rows.y) },
        part: Vec2 { x: sel(m, a.part.x, b.part.x), y: sel(m, a.part.y, b.part.y) },
    }
} }
lanes! { fn zero_around() -> Around {
    Around {
        columns: Vec2 { x: splat_i(0i32), y: splat_i(0i32) },
        rows: Vec2 { x: splat_i(0i32), y: splat_i(0i32) },
        part: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct CellPart {
    pub cell: Vec3<F>,
    pub begin: F,
    pub end: F,
    pub leave: Vec3<F>,
    pub empty: F,
    pub past_turn: U,
    pub is_last: U,
}
lanes! { fn sel_cell_part(m: M, a: &CellPart, b: &CellPart) -> CellPart {
    CellPart {
        cell: Vec3 { x: sel(m, a.cell.x, b.cell.x), y: sel(m, a.cell.y, b.cell.y), z: sel(m, a.cell.z, b.cell.z) },
        begin: sel(m, a.begin, b.begin),
        end: sel(m, a.end, b.end),
        leave: Vec3 { x: sel(m, a.leave.x, b.leave.x), y: sel(m, a.leave.y, b.leave.y), z: sel(m, a.leave.z, b.leave.z) },
        empty: sel(m, a.empty, b.empty),
        past_turn: sel_u(m, a.past_turn, b.past_turn),
        is_last: sel_u(m, a.is_last, b.is_last),
    }
} }
lanes! { fn zero_cell_part() -> CellPart {
    CellPart {
        cell: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        begin: splat(0f32),
        end: splat(0f32),
        leave: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        empty: splat(0f32),
        past_turn: splat_u(0u32),
        is_last: splat_u(0u32),
    }
} }

#[derive(Clone, Copy)]
pub struct Hit {
    pub found: U,
    pub exhausted: U,
    pub uv: Vec2<F>,
    pub height: F,
    pub t: F,
    pub cost: Vec3<U>,
}
lanes! { fn sel_hit(m: M, a: &Hit, b: &Hit) -> Hit {
    Hit {
        found: sel_u(m, a.found, b.found),
        exhausted: sel_u(m, a.exhausted, b.exhausted),
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        height: sel(m, a.height, b.height),
        t: sel(m, a.t, b.t),
        cost: Vec3 { x: sel_u(m, a.cost.x, b.cost.x), y: sel_u(m, a.cost.y, b.cost.y), z: sel_u(m, a.cost.z, b.cost.z) },
    }
} }
lanes! { fn zero_hit() -> Hit {
    Hit {
        found: splat_u(0u32),
        exhausted: splat_u(0u32),
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        height: splat(0f32),
        t: splat(0f32),
        cost: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) },
    }
} }

#[derive(Clone, Copy)]
pub struct FourTerms {
    pub first: Vec4<F>,
    pub second: Vec4<F>,
    pub third: Vec4<F>,
    pub fourth: Vec4<F>,
}
lanes! { fn sel_four_terms(m: M, a: &FourTerms, b: &FourTerms) -> FourTerms {
    FourTerms {
        first: Vec4 { x: sel(m, a.first.x, b.first.x), y: sel(m, a.first.y, b.first.y), z: sel(m, a.first.z, b.first.z), w: sel(m, a.first.w, b.first.w) },
        second: Vec4 { x: sel(m, a.second.x, b.second.x), y: sel(m, a.second.y, b.second.y), z: sel(m, a.second.z, b.second.z), w: sel(m, a.second.w, b.second.w) },
        third: Vec4 { x: sel(m, a.third.x, b.third.x), y: sel(m, a.third.y, b.third.y), z: sel(m, a.third.z, b.third.z), w: sel(m, a.third.w, b.third.w) },
        fourth: Vec4 { x: sel(m, a.fourth.x, b.fourth.x), y: sel(m, a.fourth.y, b.fourth.y), z: sel(m, a.fourth.z, b.fourth.z), w: sel(m, a.fourth.w, b.fourth.w) },
    }
} }
lanes! { fn zero_four_terms() -> FourTerms {
    FourTerms {
        first: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        second: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        third: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        fourth: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Grid {
    pub origin: Vec2<F>,
    pub step: Vec2<F>,
}
lanes! { fn sel_grid(m: M, a: &Grid, b: &Grid) -> Grid {
    Grid {
        origin: Vec2 { x: sel(m, a.origin.x, b.origin.x), y: sel(m, a.origin.y, b.origin.y) },
        step: Vec2 { x: sel(m, a.step.x, b.step.x), y: sel(m, a.step.y, b.step.y) },
    }
} }
lanes! { fn zero_grid() -> Grid {
    Grid {
        origin: Vec2 { x: splat(0f32), y: splat(0f32) },
        step: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct JoinedViews {
    pub first: Vec2<F>,
    pub low: Vec2<F>,
    pub high: Vec2<F>,
}
lanes! { fn sel_joined_views(m: M, a: &JoinedViews, b: &JoinedViews) -> JoinedViews {
    JoinedViews {
        first: Vec2 { x: sel(m, a.first.x, b.first.x), y: sel(m, a.first.y, b.first.y) },
        low: Vec2 { x: sel(m, a.low.x, b.low.x), y: sel(m, a.low.y, b.low.y) },
        high: Vec2 { x: sel(m, a.high.x, b.high.x), y: sel(m, a.high.y, b.high.y) },
    }
} }
lanes! { fn zero_joined_views() -> JoinedViews {
    JoinedViews {
        first: Vec2 { x: splat(0f32), y: splat(0f32) },
        low: Vec2 { x: splat(0f32), y: splat(0f32) },
        high: Vec2 { x: splat(0f32), y: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct Path {
    pub uv: Vec2<F>,
    pub duv: Vec2<F>,
    pub h: Vec3<F>,
    pub exit: F,
    pub base: F,
    pub metric: Vec4<F>,
    pub ray: u32,
    pub level: u32,
    pub start: F,
    pub share: F,
    pub bend: F,
}
lanes! { fn sel_path(m: M, a: &Path, b: &Path) -> Path {
    Path {
        uv: Vec2 { x: sel(m, a.uv.x, b.uv.x), y: sel(m, a.uv.y, b.uv.y) },
        duv: Vec2 { x: sel(m, a.duv.x, b.duv.x), y: sel(m, a.duv.y, b.duv.y) },
        h: Vec3 { x: sel(m, a.h.x, b.h.x), y: sel(m, a.h.y, b.h.y), z: sel(m, a.h.z, b.h.z) },
        exit: sel(m, a.exit, b.exit),
        base: sel(m, a.base, b.base),
        metric: Vec4 { x: sel(m, a.metric.x, b.metric.x), y: sel(m, a.metric.y, b.metric.y), z: sel(m, a.metric.z, b.metric.z), w: sel(m, a.metric.w, b.metric.w) },
        ray: a.ray,
        level: a.level,
        start: sel(m, a.start, b.start),
        share: sel(m, a.share, b.share),
        bend: sel(m, a.bend, b.bend),
    }
} }
lanes! { fn zero_path() -> Path {
    Path {
        uv: Vec2 { x: splat(0f32), y: splat(0f32) },
        duv: Vec2 { x: splat(0f32), y: splat(0f32) },
        h: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        exit: splat(0f32),
        base: splat(0f32),
        metric: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        ray: 0u32,
        level: 0u32,
        start: splat(0f32),
        share: splat(0f32),
        bend: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct MotifHit {
    pub t: F,
    pub cost: Vec3<U>,
}
lanes! { fn sel_motif_hit(m: M, a: &MotifHit, b: &MotifHit) -> MotifHit {
    MotifHit {
        t: sel(m, a.t, b.t),
        cost: Vec3 { x: sel_u(m, a.cost.x, b.cost.x), y: sel_u(m, a.cost.y, b.cost.y), z: sel_u(m, a.cost.z, b.cost.z) },
    }
} }
lanes! { fn zero_motif_hit() -> MotifHit {
    MotifHit {
        t: splat(0f32),
        cost: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) },
    }
} }

#[derive(Clone, Copy)]
pub struct MotifRay {
    pub origin: Vec3<F>,
    pub inverse: Vec3<F>,
    pub axis: U,
    pub shear: Vec3<F>,
}
lanes! { fn sel_motif_ray(m: M, a: &MotifRay, b: &MotifRay) -> MotifRay {
    MotifRay {
        origin: Vec3 { x: sel(m, a.origin.x, b.origin.x), y: sel(m, a.origin.y, b.origin.y), z: sel(m, a.origin.z, b.origin.z) },
        inverse: Vec3 { x: sel(m, a.inverse.x, b.inverse.x), y: sel(m, a.inverse.y, b.inverse.y), z: sel(m, a.inverse.z, b.inverse.z) },
        axis: sel_u(m, a.axis, b.axis),
        shear: Vec3 { x: sel(m, a.shear.x, b.shear.x), y: sel(m, a.shear.y, b.shear.y), z: sel(m, a.shear.z, b.shear.z) },
    }
} }
lanes! { fn zero_motif_ray() -> MotifRay {
    MotifRay {
        origin: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        inverse: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        axis: splat_u(0u32),
        shear: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct PathAxes {
    pub comes_in: U,
    pub turn: F,
    pub elevation: F,
    pub bend: F,
    pub start: F,
    pub whole: F,
    pub fall: F,
}
lanes! { fn sel_path_axes(m: M, a: &PathAxes, b: &PathAxes) -> PathAxes {
    PathAxes {
        comes_in: sel_u(m, a.comes_in, b.comes_in),
        turn: sel(m, a.turn, b.turn),
        elevation: sel(m, a.elevation, b.elevation),
        bend: sel(m, a.bend, b.bend),
        start: sel(m, a.start, b.start),
        whole: sel(m, a.whole, b.whole),
        fall: sel(m, a.fall, b.fall),
    }
} }
lanes! { fn zero_path_axes() -> PathAxes {
    PathAxes {
        comes_in: splat_u(0u32),
        turn: splat(0f32),
        elevation: splat(0f32),
        bend: splat(0f32),
        start: splat(0f32),
        whole: splat(0f32),
        fall: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct Quartic {
    pub a: F,
    pub b: F,
    pub c: F,
    pub d: F,
    pub e: F,
}
lanes! { fn sel_quartic(m: M, a: &Quartic, b: &Quartic) -> Quartic {
    Quartic {
        a: sel(m, a.a, b.a),
        b: sel(m, a.b, b.b),
        c: sel(m, a.c, b.c),
        d: sel(m, a.d, b.d),
        e: sel(m, a.e, b.e),
    }
} }
lanes! { fn zero_quartic() -> Quartic {
    Quartic {
        a: splat(0f32),
        b: splat(0f32),
        c: splat(0f32),
        d: splat(0f32),
        e: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct RootInCell {
    pub root: F,
    pub gap: F,
}
lanes! { fn sel_root_in_cell(m: M, a: &RootInCell, b: &RootInCell) -> RootInCell {
    RootInCell {
        root: sel(m, a.root, b.root),
        gap: sel(m, a.gap, b.gap),
    }
} }
lanes! { fn zero_root_in_cell() -> RootInCell {
    RootInCell {
        root: splat(0f32),
        gap: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct SearchResult {
    pub status: U,
    pub near: F,
    pub far: F,
    pub near_gap: F,
    pub far_gap: F,
    pub cost: Vec3<U>,
}
lanes! { fn sel_search_result(m: M, a: &SearchResult, b: &SearchResult) -> SearchResult {
    SearchResult {
        status: sel_u(m, a.status, b.status),
        near: sel(m, a.near, b.near),
        far: sel(m, a.far, b.far),
        near_gap: sel(m, a.near_gap, b.near_gap),
        far_gap: sel(m, a.far_gap, b.far_gap),
        cost: Vec3 { x: sel_u(m, a.cost.x, b.cost.x), y: sel_u(m, a.cost.y, b.cost.y), z: sel_u(m, a.cost.z, b.cost.z) },
    }
} }
lanes! { fn zero_search_result() -> SearchResult {
    SearchResult {
        status: splat_u(0u32),
        near: splat(0f32),
        far: splat(0f32),
        near_gap: splat(0f32),
        far_gap: splat(0f32),
        cost: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) },
    }
} }

#[derive(Clone, Copy)]
pub struct ViewPair {
    pub layer: I,
    pub bend: F,
}
lanes! { fn sel_view_pair(m: M, a: &ViewPair, b: &ViewPair) -> ViewPair {
    ViewPair {
        layer: sel_i(m, a.layer, b.layer),
        bend: sel(m, a.bend, b.bend),
    }
} }
lanes! { fn zero_view_pair() -> ViewPair {
    ViewPair {
        layer: splat_i(0i32),
        bend: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct ViewsAround {
    pub pairs: U,
    pub before: F,
    pub azimuths: F,
    pub below: F,
    pub elevations: F,
    pub lower: F,
    pub part: Vec3<F>,
}
lanes! { fn sel_views_around(m: M, a: &ViewsAround, b: &ViewsAround) -> ViewsAround {
    ViewsAround {
        pairs: sel_u(m, a.pairs, b.pairs),
        before: sel(m, a.before, b.before),
        azimuths: sel(m, a.azimuths, b.azimuths),
        below: sel(m, a.below, b.below),
        elevations: sel(m, a.elevations, b.elevations),
        lower: sel(m, a.lower, b.lower),
        part: Vec3 { x: sel(m, a.part.x, b.part.x), y: sel(m, a.part.y, b.part.y), z: sel(m, a.part.z, b.part.z) },
    }
} }
lanes! { fn zero_views_around() -> ViewsAround {
    ViewsAround {
        pairs: splat_u(0u32),
        before: splat(0f32),
        azimuths: splat(0f32),
        below: splat(0f32),
        elevations: splat(0f32),
        lower: splat(0f32),
        part: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct VoxelCell {
    pub low: Vec4<F>,
    pub high: Vec4<F>,
}
lanes! { fn sel_voxel_cell(m: M, a: &VoxelCell, b: &VoxelCell) -> VoxelCell {
    VoxelCell {
        low: Vec4 { x: sel(m, a.low.x, b.low.x), y: sel(m, a.low.y, b.low.y), z: sel(m, a.low.z, b.low.z), w: sel(m, a.low.w, b.low.w) },
        high: Vec4 { x: sel(m, a.high.x, b.high.x), y: sel(m, a.high.y, b.high.y), z: sel(m, a.high.z, b.high.z), w: sel(m, a.high.w, b.high.w) },
    }
} }
lanes! { fn zero_voxel_cell() -> VoxelCell {
    VoxelCell {
        low: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
        high: Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) },
    }
} }

#[derive(Clone, Copy)]
pub struct VoxelPath {
    pub origin: Vec3<F>,
    pub step: Vec3<F>,
    pub bend: F,
}
lanes! { fn sel_voxel_path(m: M, a: &VoxelPath, b: &VoxelPath) -> VoxelPath {
    VoxelPath {
        origin: Vec3 { x: sel(m, a.origin.x, b.origin.x), y: sel(m, a.origin.y, b.origin.y), z: sel(m, a.origin.z, b.origin.z) },
        step: Vec3 { x: sel(m, a.step.x, b.step.x), y: sel(m, a.step.y, b.step.y), z: sel(m, a.step.z, b.step.z) },
        bend: sel(m, a.bend, b.bend),
    }
} }
lanes! { fn zero_voxel_path() -> VoxelPath {
    VoxelPath {
        origin: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        step: Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) },
        bend: splat(0f32),
    }
} }

#[derive(Clone, Copy)]
pub struct WayToSolid {
    pub is_solid: U,
    pub way: F,
}
lanes! { fn sel_way_to_solid(m: M, a: &WayToSolid, b: &WayToSolid) -> WayToSolid {
    WayToSolid {
        is_solid: sel_u(m, a.is_solid, b.is_solid),
        way: sel(m, a.way, b.way),
    }
} }
lanes! { fn zero_way_to_solid() -> WayToSolid {
    WayToSolid {
        is_solid: splat_u(0u32),
        way: splat(0f32),
    }
} }

lanes! { fn quadratic(r: &Resources<'_>, c_a0: Vec3<F>, s_a1: F) -> F {
    return add(c_a0.x, mul(s_a1, add(c_a0.y, mul(s_a1, c_a0.z))));
} }
lanes! { fn first_root(r: &Resources<'_>, within: M, c_a0: Vec3<F>, span_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut a_v0: F = splat(3e38f32);
    let mut b_v1: F = splat(3e38f32);
    let discriminant_10 = sub(mul(c_a0.y, c_a0.y), mul(mul(splat(4.0f32), c_a0.z), c_a0.x));
    let (b1, c2) = (ex, ge(discriminant_10, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let root_13 = sqrt(discriminant_10);
        let q_23 = mul(splat((-0.5f32)), add(c_a0.y, sel(ge(c_a0.y, splat(0.0f32)), root_13, sub(splat(0.0f32), root_13))));
        let c3 = ne(c_a0.z, splat(0.0f32));
        a_v0 = sel(c3, div(q_23, c_a0.z), a_v0);
        let c4 = ne(q_23, splat(0.0f32));
        b_v1 = sel(c4, div(c_a0.x, q_23), b_v1);
        let e_37 = a_v0;
        let e_38 = a_v0;
        a_v0 = sel(ge(e_38, splat(0.0f32)), e_37, splat(3e38f32));
        let e_43 = b_v1;
        let e_44 = b_v1;
        b_v1 = sel(ge(e_44, splat(0.0f32)), e_43, splat(3e38f32));
        let e_49 = a_v0;
        let e_50 = b_v1;
        let first_51 = min(e_49, e_50);
        let (b5, c6) = (ex, le(first_51, span_a1));
        ex = and(b5, c6);
        if any(ex) {
            ret = first_51;
            ex = no_lane();
        }
        ex = and_not(b5, c6);
    }
    let x7 = ex;
    ex = and_not(b1, c2);
    ex = or(ex, x7);
    if none(ex) { return ret; }
    let e_53 = quadratic(r, c_a0, span_a1);
    let c8 = le(e_53, splat(0.0f32));
    ret = sel(and(ex, c8), span_a1, ret);
    ex = and_not(ex, c8);
    return sel(ex, splat(3e38f32), ret);
} }
lanes! { fn along_slice(r: &Resources<'_>, h_a0: Vec4<F>, at_a1: Vec2<F>, dx_a2: F, dy_a3: F) -> Vec3<F> {
    let bx_6 = sub(h_a0.y, h_a0.x);
    let by_9 = sub(h_a0.z, h_a0.x);
    let twist_16 = add(sub(h_a0.x, h_a0.y), sub(h_a0.w, h_a0.z));
    return Vec3 { x: add(add(add(h_a0.x, mul(bx_6, at_a1.x)), mul(by_9, at_a1.y)), mul(mul(twist_16, at_a1.x), at_a1.y)), y: add(add(mul(bx_6, dx_a2), mul(by_9, dy_a3)), mul(twist_16, add(mul(at_a1.x, dy_a3), mul(at_a1.y, dx_a2)))), z: mul(mul(twist_16, dx_a2), dy_a3) };
} }
lanes! { fn cell_of(r: &Resources<'_>, point_a0: Vec2<F>) -> Vec2<F> {
    return Vec2 { x: min_with(max_with(floor(point_a0.x), splat((-1073741800.0f32))), splat(1073741800.0f32)), y: min_with(max_with(floor(point_a0.y), splat((-1073741800.0f32))), splat(1073741800.0f32)) };
} }
lanes! { fn unfolded(r: &Resources<'_>, i_a0: I, n_a1: i32, period_a2: i32) -> I {
    return sel_i(lt_i(i_a0, splat_i(n_a1)), i_a0, sub_i(splat_i(period_a2.wrapping_sub(1i32)), i_a0));
} }
lanes! { fn continued_pair(r: &Resources<'_>, within: M, i_a0: I, n_a1: i32, wrap_a2: u32) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut both_v0: M = splat_m(false);
    if (wrap_a2 == 1u32) {
        return Vec2 { x: min_i(max_i(i_a0, splat_i(0i32)), splat_i(n_a1.wrapping_sub(1i32))), y: min_i(max_i(add_i(i_a0, splat_i(1i32)), splat_i(0i32)), splat_i(n_a1.wrapping_sub(1i32))) };
    }
    both_v0 = and(ge_i(i_a0, splat_i(0i32)), lt_i(add_i(i_a0, splat_i(1i32)), splat_i(n_a1)));
    let e_24 = both_v0;
    let c1 = e_24;
    ret = Vec2 { x: i_a0, y: add_i(i_a0, splat_i(1i32)) };
    ex = and_not(ex, c1);
    let period_32 = (if (wrap_a2 == 0u32) { n_a1 } else { 2i32.wrapping_mul(n_a1) });
    if none(ex) { return ret; }
    let rest_33 = rem_i(i_a0, splat_i(period_32));
    let first_37 = sel_i(lt_i(rest_33, splat_i(0i32)), add_i(rest_33, splat_i(period_32)), rest_33);
    let second_44 = sel_i(eq_i(add_i(first_37, splat_i(1i32)), splat_i(period_32)), splat_i(0i32), add_i(first_37, splat_i(1i32)));
    let e_45 = unfolded(r, first_37, n_a1, period_32);
    let e_46 = unfolded(r, second_44, n_a1, period_32);
    let y2 = Vec2 { x: e_45, y: e_46 };
    return Vec2 { x: sel_i(ex, y2.x, ret.x), y: sel_i(ex, y2.y, ret.y) };
} }
lanes! { fn wrap_pair(r: &Resources<'_>, within: M, i_a0: I, n_a1: i32) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let e_5 = continued_pair(r, ex, i_a0, n_a1, r.surface_settings.wrap);
    return e_5;
} }
lanes! { fn texels_around(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, n_a1: Vec2<i32>) -> Around {
    let mut ex = within;
    let mut ret: Around = zero_around();
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, splat((n_a1.x as f32))), splat(0.5f32)), y: sub(mul(uv_a0.y, splat((n_a1.y as f32))), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let i_9 = Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) };
    let e_12 = wrap_pair(r, ex, i_9.x, n_a1.x);
    let e_15 = wrap_pair(r, ex, i_9.y, n_a1.y);
    return Around { columns: e_12, rows: e_15, part: Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) }, };
} }
lanes! { fn bilinear(r: &Resources<'_>, h00_a0: Vec4<F>, h10_a1: Vec4<F>, h01_a2: Vec4<F>, h11_a3: Vec4<F>, part_a4: Vec2<F>) -> Vec4<F> {
    let top_8 = Vec4 { x: add(h00_a0.x, mul(sub(h10_a1.x, h00_a0.x), part_a4.x)), y: add(h00_a0.y, mul(sub(h10_a1.y, h00_a0.y), part_a4.x)), z: add(h00_a0.z, mul(sub(h10_a1.z, h00_a0.z), part_a4.x)), w: add(h00_a0.w, mul(sub(h10_a1.w, h00_a0.w), part_a4.x)) };
    let bottom_12 = Vec4 { x: add(h01_a2.x, mul(sub(h11_a3.x, h01_a2.x), part_a4.x)), y: add(h01_a2.y, mul(sub(h11_a3.y, h01_a2.y), part_a4.x)), z: add(h01_a2.z, mul(sub(h11_a3.z, h01_a2.z), part_a4.x)), w: add(h01_a2.w, mul(sub(h11_a3.w, h01_a2.w), part_a4.x)) };
    return Vec4 { x: add(top_8.x, mul(sub(bottom_12.x, top_8.x), part_a4.y)), y: add(top_8.y, mul(sub(bottom_12.y, top_8.y), part_a4.y)), z: add(top_8.z, mul(sub(bottom_12.z, top_8.z), part_a4.y)), w: add(top_8.w, mul(sub(bottom_12.w, top_8.w), part_a4.y)) };
} }
lanes! { fn decoded(r: &Resources<'_>, texel_a0: Vec4<F>, map_a1: &single::MapSettings) -> Vec4<F> {
    if (map_a1.coded == 1u32) {
        return Vec4 { x: add(splat(map_a1.low.x), mul(splat(map_a1.step.x), floor(add(mul(texel_a0.x, splat(255.0f32)), splat(0.5f32))))), y: add(splat(map_a1.low.y), mul(splat(map_a1.step.y), floor(add(mul(texel_a0.y, splat(255.0f32)), splat(0.5f32))))), z: add(splat(map_a1.low.z), mul(splat(map_a1.step.z), floor(add(mul(texel_a0.z, splat(255.0f32)), splat(0.5f32))))), w: add(splat(map_a1.low.w), mul(splat(map_a1.step.w), floor(add(mul(texel_a0.w, splat(255.0f32)), splat(0.5f32))))) };
    }
    return texel_a0;
} }
lanes! { fn eighth_turn(r: &Resources<'_>, tangent_a0: F) -> F {
    let s_1 = mul(tangent_a0, tangent_a0);
    let series_14 = add(splat(0.999866f32), mul(s_1, add(splat((-0.3302995f32)), mul(s_1, add(splat(0.180141f32), mul(s_1, add(splat((-0.085133f32)), mul(s_1, splat(0.0208351f32)))))))));
    return mul(mul(tangent_a0, series_14), splat(0.15915494f32));
} }
lanes! { fn turn_of(r: &Resources<'_>, within: M, v_a0: Vec2<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut turn_v0: F = splat(0f32);
    let x_2 = abs(v_a0.x);
    let y_4 = abs(v_a0.y);
    let c1 = not(gt(add(x_2, y_4), splat(0.0f32)));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let e_13 = eighth_turn(r, div(min(x_2, y_4), max(x_2, y_4)));
    turn_v0 = e_13;
    let c2 = gt(y_4, x_2);
    let e_16 = turn_v0;
    turn_v0 = sel(c2, sub(splat(0.25f32), e_16), turn_v0);
    let c3 = lt(v_a0.x, splat(0.0f32));
    let e_22 = turn_v0;
    turn_v0 = sel(c3, sub(splat(0.5f32), e_22), turn_v0);
    let c4 = lt(v_a0.y, splat(0.0f32));
    let e_28 = turn_v0;
    turn_v0 = sel(c4, sub(splat(1.0f32), e_28), turn_v0);
    let e_31 = turn_v0;
    let e_32 = turn_v0;
    return sel(ex, sel(ge(e_32, splat(1.0f32)), splat(0.0f32), e_31), ret);
} }
stage! { pub(super) fn wrapped_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let n_2 = r.height_texels(level_a1);
    let k_3 = (level_a1 as i32);
    let i_6 = wrap_pair(r, ex, cell_a0.x, n_2.x);
    let j_9 = wrap_pair(r, ex, cell_a0.y, n_2.y);
    let e_14 = height_texel(&r.height_map, i_6.x, j_9.x, k_3);
    let e_20 = height_texel(&r.height_map, i_6.y, j_9.x, k_3);
    let e_26 = height_texel(&r.height_map, i_6.x, j_9.y, k_3);
    let e_32 = height_texel(&r.height_map, i_6.y, j_9.y, k_3);
    return Vec4 { x: e_14.x, y: e_20.x, z: e_26.x, w: e_32.x };
} }
lanes! { fn height_at(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: u32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_2 = r.height_size(level_a1);
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, splat(e_2.x)), splat(0.5f32)), y: sub(mul(uv_a0.y, splat(e_2.y)), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let f_9 = Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) };
    let h_11 = height_cell(r, ex, Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) }, level_a1);
    let top_18 = add(h_11.x, mul(sub(h_11.y, h_11.x), f_9.x));
    let bottom_25 = add(h_11.z, mul(sub(h_11.w, h_11.z), f_9.x));
    return add(top_18, mul(sub(bottom_25, top_18), f_9.y));
} }
lanes! { fn voxel_path(r: &Resources<'_>, path_a0: &Path) -> VoxelPath {
    let size_1 = r.volume_size();
    return VoxelPath { origin: Vec3 { x: sub(mul(path_a0.uv.x, splat(size_1.x)), splat(0.5f32)), y: sub(mul(path_a0.uv.y, splat(size_1.y)), splat(0.5f32)), z: sub(mul(path_a0.h.x, splat(size_1.z)), splat(0.5f32)) }, step: Vec3 { x: mul(path_a0.duv.x, splat(size_1.x)), y: mul(path_a0.duv.y, splat(size_1.y)), z: mul(path_a0.h.y, splat(size_1.z)) }, bend: mul(path_a0.h.z, splat(size_1.z)), };
} }
lanes! { fn turning_point(r: &Resources<'_>, within: M, way_a0: &VoxelPath) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let c1 = eq(way_a0.bend, splat(0.0f32));
    ret = splat(3e38f32);
    ex = and_not(ex, c1);
    let t_12 = div(sub(splat(0.0f32), way_a0.step.z), mul(splat(2.0f32), way_a0.bend));
    return sel(ex, sel(gt(t_12, splat(0.0f32)), t_12, splat(3e38f32)), ret);
} }
lanes! { fn search_texel_llls(r: &Resources<'_>, within: M, path_a0: &Path, place_a1: Vec2<I>, layer_a2: I, level_a3: i32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    if (path_a0.ray == 1u32) {
        let texel_8 = map_texel_of_each(&r.shadow_search_map, ex, place_a1.x, place_a1.y, layer_a2, splat_i(level_a3));
        let e_13 = decoded(r, texel_8, &r.surface_settings.maps[2]);
        return e_13;
    }
    let e_15 = map_texel_of_each(&r.search_map, ex, place_a1.x, place_a1.y, layer_a2, splat_i(level_a3));
    let e_20 = decoded(r, e_15, &r.surface_settings.maps[1]);
    return e_20;
} }
lanes! { fn search_texel_llsl(r: &Resources<'_>, within: M, path_a0: &Path, place_a1: Vec2<I>, layer_a2: i32, level_a3: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    if (path_a0.ray == 1u32) {
        let texel_8 = map_texel_of_each(&r.shadow_search_map, ex, place_a1.x, place_a1.y, splat_i(layer_a2), level_a3);
        let e_13 = decoded(r, texel_8, &r.surface_settings.maps[2]);
        return e_13;
    }
    let e_15 = map_texel_of_each(&r.search_map, ex, place_a1.x, place_a1.y, splat_i(layer_a2), level_a3);
    let e_20 = decoded(r, e_15, &r.surface_settings.maps[1]);
    return e_20;
} }
lanes! { fn search_texel_llss(r: &Resources<'_>, path_a0: &Path, place_a1: Vec2<I>, layer_a2: i32, level_a3: i32) -> Vec4<F> {
    if (path_a0.ray == 1u32) {
        let texel_8 = map_texel(&r.shadow_search_map, place_a1.x, place_a1.y, layer_a2, level_a3);
        let e_13 = decoded(r, texel_8, &r.surface_settings.maps[2]);
        return e_13;
    }
    let e_15 = map_texel(&r.search_map, place_a1.x, place_a1.y, layer_a2, level_a3);
    let e_20 = decoded(r, e_15, &r.surface_settings.maps[1]);
    return e_20;
} }
lanes! { fn slice_begin(r: &Resources<'_>, slice_a0: I) -> Vec2<I> {
    let size_5 = Vec3 { x: (r.surface_settings.volume.x as i32), y: (r.surface_settings.volume.y as i32), z: (r.surface_settings.volume.z as i32) };
    let in_row_10 = (r.surface_settings.volume.w as i32);
    let k_15 = min_i(max_i(slice_a0, splat_i(0i32)), splat_i(size_5.z.wrapping_sub(1i32)));
    let row_21 = i_of_f(div(add(f_of_i(k_15), splat(0.5f32)), splat((in_row_10 as f32))));
    return Vec2 { x: mul_i(sub_i(k_15, mul_i(row_21, splat_i(in_row_10))), splat_i(size_5.x)), y: mul_i(row_21, splat_i(size_5.y)) };
} }
lanes! { fn continued_index(r: &Resources<'_>, within: M, i_a0: I, n_a1: i32, wrap_a2: u32) -> I {
    let mut ex = within;
    let mut ret: I = splat_i(0i32);
    let mut both_v0: M = splat_m(false);
    if (wrap_a2 == 1u32) {
        return min_i(max_i(i_a0, splat_i(0i32)), splat_i(n_a1.wrapping_sub(1i32)));
    }
    both_v0 = and(ge_i(i_a0, splat_i(0i32)), lt_i(i_a0, splat_i(n_a1)));
    let e_15 = both_v0;
    let c1 = e_15;
    ret = i_a0;
    ex = and_not(ex, c1);
    let period_20 = (if (wrap_a2 == 0u32) { n_a1 } else { 2i32.wrapping_mul(n_a1) });
    if none(ex) { return ret; }
    let rest_21 = rem_i(i_a0, splat_i(period_20));
    let e_26 = unfolded(r, sel_i(lt_i(rest_21, splat_i(0i32)), add_i(rest_21, splat_i(period_20)), rest_21), n_a1, period_20);
    return sel_i(ex, e_26, ret);
} }
lanes! { fn wrap_index(r: &Resources<'_>, within: M, i_a0: I, n_a1: i32) -> I {
    let mut ex = within;
    let mut ret: I = splat_i(0i32);
    let e_5 = continued_index(r, ex, i_a0, n_a1, r.surface_settings.wrap);
    return e_5;
} }
lanes! { fn wrap_cell(r: &Resources<'_>, within: M, i_a0: I, n_a1: i32) -> I {
    let mut ex = within;
    let mut ret: I = splat_i(0i32);
    if (r.surface_settings.wrap == 0u32) {
        let e_7 = wrap_index(r, ex, i_a0, n_a1);
        return e_7;
    }
    let pair_8 = wrap_pair(r, ex, i_a0, n_a1);
    return min_i(pair_8.x, pair_8.y);
} }
lanes! { fn voxel_texel(r: &Resources<'_>, within: M, cell_a0: Vec3<I>) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let size_5 = Vec3 { x: (r.surface_settings.volume.x as i32), y: (r.surface_settings.volume.y as i32), z: (r.surface_settings.volume.z as i32) };
    let e_7 = slice_begin(r, cell_a0.z);
    let e_10 = wrap_cell(r, ex, cell_a0.x, size_5.x);
    let e_13 = wrap_cell(r, ex, cell_a0.y, size_5.y);
    return Vec2 { x: add_i(e_7.x, e_10), y: add_i(e_7.y, e_13) };
} }
lanes! { fn rises_on(r: &Resources<'_>, within: M, way_a0: &VoxelPath, has_turned_a1: M) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let c1 = has_turned_a1;
    ret = gt(way_a0.bend, splat(0.0f32));
    ex = and_not(ex, c1);
    both_v1 = and(eq(way_a0.step.z, splat(0.0f32)), gt(way_a0.bend, splat(0.0f32)));
    let e_22 = both_v1;
    both_v0 = or(gt(way_a0.step.z, splat(0.0f32)), e_22);
    let e_24 = both_v0;
    return sel_m(ex, e_24, ret);
} }
lanes! { fn meets_plane(r: &Resources<'_>, within: M, way_a0: &VoxelPath, plane_a1: F, rises_a2: M, has_turned_a3: M) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let gap_6 = sub(plane_a1, way_a0.origin.z);
    let discriminant_16 = add(mul(way_a0.step.z, way_a0.step.z), mul(mul(splat(4.0f32), way_a0.bend), gap_6));
    let c1 = not(ge(discriminant_16, splat(0.0f32)));
    ret = splat(3e38f32);
    ex = and_not(ex, c1);
    let root_25 = sel(rises_a2, sqrt(discriminant_16), sub(splat(0.0f32), sqrt(discriminant_16)));
    let c2 = has_turned_a3;
    ret = sel(and(ex, c2), div(sub(root_25, way_a0.step.z), mul(splat(2.0f32), way_a0.bend)), ret);
    ex = and_not(ex, c2);
    let both_35 = add(way_a0.step.z, root_25);
    return sel(ex, sel(ne(both_35, splat(0.0f32)), div(mul(splat(2.0f32), gap_6), both_35), splat(3e38f32)), ret);
} }
lanes! { fn voxel_leave(r: &Resources<'_>, within: M, way_a0: &VoxelPath, cell_a1: Vec3<F>, reach_a2: F, has_turned_a3: M) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let none_6 = Vec2 { x: 0.0f32, y: 0.0f32 };
    let last_11 = Vec2 { x: add(splat(1.0f32), reach_a2), y: add(splat(1.0f32), reach_a2) };
    let ahead_22 = Vec2 { x: add(cell_a1.x, sel(gt(way_a0.step.x, splat(none_6.x)), last_11.x, sub(splat(0.0f32), reach_a2))), y: add(cell_a1.y, sel(gt(way_a0.step.y, splat(none_6.y)), last_11.y, sub(splat(0.0f32), reach_a2))) };
    let beside_28 = Vec2 { x: div(sub(ahead_22.x, way_a0.origin.x), way_a0.step.x), y: div(sub(ahead_22.y, way_a0.origin.y), way_a0.step.y) };
    let across_36 = Vec2 { x: sel(gt(abs(way_a0.step.x), splat(none_6.x)), beside_28.x, splat(3e38f32)), y: sel(gt(abs(way_a0.step.y), splat(none_6.y)), beside_28.y, splat(3e38f32)) };
    let rises_37 = rises_on(r, ex, way_a0, has_turned_a3);
    let plane_44 = add(cell_a1.z, sel(rises_37, add(splat(1.0f32), reach_a2), sub(splat(0.0f32), reach_a2)));
    let e_45 = meets_plane(r, ex, way_a0, plane_44, rises_37, has_turned_a3);
    return Vec3 { x: across_36.x, y: across_36.y, z: e_45 };
} }
lanes! { fn part_from_llllll(r: &Resources<'_>, within: M, path_a0: &Path, way_a1: &VoxelPath, turn_a2: F, cell_a3: Vec3<F>, begin_a4: F, past_turn_a5: U) -> CellPart {
    let mut ex = within;
    let mut ret: CellPart = zero_cell_part();
    let e_7 = voxel_texel(r, ex, Vec3 { x: i_of_f(cell_a3.x), y: i_of_f(cell_a3.y), z: i_of_f(cell_a3.z) });
    let e_10 = search_texel_llss(r, path_a0, e_7, 0i32, 0i32);
    let empty_13 = sub(e_10.x, splat(1.0f32));
    let leave_18 = voxel_leave(r, ex, way_a1, cell_a3, max_with(empty_13, splat(0.0f32)), eq_u(past_turn_a5, splat_u(1u32)));
    let side_23 = min(min(leave_18.x, leave_18.y), leave_18.z);
    let last_29 = sel(eq_u(past_turn_a5, splat_u(1u32)), path_a0.exit, min(turn_a2, path_a0.exit));
    let end_31 = max(min(side_23, last_29), begin_a4);
    return CellPart { cell: cell_a3, begin: begin_a4, end: end_31, leave: leave_18, empty: empty_13, past_turn: past_turn_a5, is_last: sel_u(ge(end_31, path_a0.exit), splat_u(1u32), splat_u(0u32)), };
} }
lanes! { fn part_from_llllls(r: &Resources<'_>, within: M, path_a0: &Path, way_a1: &VoxelPath, turn_a2: F, cell_a3: Vec3<F>, begin_a4: F, past_turn_a5: u32) -> CellPart {
    let mut ex = within;
    let mut ret: CellPart = zero_cell_part();
    let e_7 = voxel_texel(r, ex, Vec3 { x: i_of_f(cell_a3.x), y: i_of_f(cell_a3.y), z: i_of_f(cell_a3.z) });
    let e_10 = search_texel_llss(r, path_a0, e_7, 0i32, 0i32);
    let empty_13 = sub(e_10.x, splat(1.0f32));
    let leave_18 = voxel_leave(r, ex, way_a1, cell_a3, max_with(empty_13, splat(0.0f32)), splat_m((past_turn_a5 == 1u32)));
    let side_23 = min(min(leave_18.x, leave_18.y), leave_18.z);
    let last_29 = sel(splat_m((past_turn_a5 == 1u32)), path_a0.exit, min(turn_a2, path_a0.exit));
    let end_31 = max(min(side_23, last_29), begin_a4);
    return CellPart { cell: cell_a3, begin: begin_a4, end: end_31, leave: leave_18, empty: empty_13, past_turn: splat_u(past_turn_a5), is_last: sel_u(ge(end_31, path_a0.exit), splat_u(1u32), splat_u(0u32)), };
} }
lanes! { fn part_from_llllss(r: &Resources<'_>, within: M, path_a0: &Path, way_a1: &VoxelPath, turn_a2: F, cell_a3: Vec3<F>, begin_a4: f32, past_turn_a5: u32) -> CellPart {
    let mut ex = within;
    let mut ret: CellPart = zero_cell_part();
    let e_7 = voxel_texel(r, ex, Vec3 { x: i_of_f(cell_a3.x), y: i_of_f(cell_a3.y), z: i_of_f(cell_a3.z) });
    let e_10 = search_texel_llss(r, path_a0, e_7, 0i32, 0i32);
    let empty_13 = sub(e_10.x, splat(1.0f32));
    let leave_18 = voxel_leave(r, ex, way_a1, cell_a3, max_with(empty_13, splat(0.0f32)), splat_m((past_turn_a5 == 1u32)));
    let side_23 = min(min(leave_18.x, leave_18.y), leave_18.z);
    let last_29 = sel(splat_m((past_turn_a5 == 1u32)), path_a0.exit, min(turn_a2, path_a0.exit));
    let end_31 = max(min(side_23, last_29), splat(begin_a4));
    return CellPart { cell: cell_a3, begin: splat(begin_a4), end: end_31, leave: leave_18, empty: empty_13, past_turn: splat_u(past_turn_a5), is_last: sel_u(ge(end_31, path_a0.exit), splat_u(1u32), splat_u(0u32)), };
} }
lanes! { fn voxel_place_on(r: &Resources<'_>, way_a0: &VoxelPath, t_a1: F) -> Vec3<F> {
    return Vec3 { x: add(way_a0.origin.x, mul(add(way_a0.step.x, splat(0.0f32)), t_a1)), y: add(way_a0.origin.y, mul(add(way_a0.step.y, splat(0.0f32)), t_a1)), z: add(way_a0.origin.z, mul(add(way_a0.step.z, mul(way_a0.bend, t_a1)), t_a1)) };
} }
lanes! { fn first_part(r: &Resources<'_>, within: M, path_a0: &Path, way_a1: &VoxelPath, turn_a2: F) -> CellPart {
    let mut ex = within;
    let mut ret: CellPart = zero_cell_part();
    let e_4 = voxel_place_on(r, way_a1, splat(0.0f32));
    let e_8 = part_from_llllss(r, ex, path_a0, way_a1, turn_a2, Vec3 { x: floor(e_4.x), y: floor(e_4.y), z: floor(e_4.z) }, 0.0f32, 0u32);
    return e_8;
} }
lanes! { fn gap_in_cell(r: &Resources<'_>, way_a0: &VoxelPath, cell_a1: Vec3<F>, corners_a2: &VoxelCell, t_a3: F, span_a4: F) -> Quartic {
    let e_5 = voxel_place_on(r, way_a0, t_a3);
    let at_6 = Vec3 { x: sub(e_5.x, cell_a1.x), y: sub(e_5.y, cell_a1.y), z: sub(e_5.z, cell_a1.z) };
    let slope_14 = mul(add(way_a0.step.z, mul(mul(splat(2.0f32), way_a0.bend), t_a3)), span_a4);
    let bend_17 = mul(way_a0.bend, mul(span_a4, span_a4));
    let dx_20 = mul(way_a0.step.x, span_a4);
    let dy_23 = mul(way_a0.step.y, span_a4);
    let low_26 = along_slice(r, Vec4 { x: corners_a2.low.x, y: corners_a2.low.y, z: corners_a2.low.z, w: corners_a2.low.w }, Vec2 { x: at_6.x, y: at_6.y }, dx_20, dy_23);
    let e_29 = along_slice(r, Vec4 { x: corners_a2.high.x, y: corners_a2.high.y, z: corners_a2.high.z, w: corners_a2.high.w }, Vec2 { x: at_6.x, y: at_6.y }, dx_20, dy_23);
    let rise_30 = Vec3 { x: sub(e_29.x, low_26.x), y: sub(e_29.y, low_26.y), z: sub(e_29.z, low_26.z) };
    return Quartic { a: sub(splat(0.5f32), add(low_26.x, mul(rise_30.x, at_6.z))), b: sub(splat(0.0f32), add(add(low_26.y, mul(rise_30.y, at_6.z)), mul(rise_30.x, slope_14))), c: sub(splat(0.0f32), add(add(add(low_26.z, mul(rise_30.z, at_6.z)), mul(rise_30.y, slope_14)), mul(rise_30.x, bend_17))), d: sub(splat(0.0f32), add(mul(rise_30.z, slope_14), mul(rise_30.y, bend_17))), e: sub(splat(0.0f32), mul(rise_30.z, bend_17)), };
} }
lanes! { fn slice_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, slice_a1: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let size_6 = Vec3 { x: (r.surface_settings.volume.x as i32), y: (r.surface_settings.volume.y as i32), z: (r.surface_settings.volume.z as i32) };
    let begin_7 = slice_begin(r, slice_a1);
    let e_13 = wrap_pair(r, ex, cell_a0.x, size_6.x);
    let i_14 = Vec2 { x: add_i(begin_7.x, e_13.x), y: add_i(begin_7.x, e_13.y) };
    let e_20 = wrap_pair(r, ex, cell_a0.y, size_6.y);
    let j_21 = Vec2 { x: add_i(begin_7.y, e_20.x), y: add_i(begin_7.y, e_20.y) };
    let e_27 = height_texel(&r.height_map, i_14.x, j_21.x, 0i32);
    let e_34 = height_texel(&r.height_map, i_14.y, j_21.x, 0i32);
    let e_41 = height_texel(&r.height_map, i_14.x, j_21.y, 0i32);
    let e_48 = height_texel(&r.height_map, i_14.y, j_21.y, 0i32);
    return Vec4 { x: e_27.x, y: e_34.x, z: e_41.x, w: e_48.x };
} }
lanes! { fn voxel_cell(r: &Resources<'_>, within: M, cell_a0: Vec3<I>) -> VoxelCell {
    let mut ex = within;
    let mut ret: VoxelCell = zero_voxel_cell();
    let e_3 = slice_cell(r, ex, Vec2 { x: cell_a0.x, y: cell_a0.y }, cell_a0.z);
    let e_8 = slice_cell(r, ex, Vec2 { x: cell_a0.x, y: cell_a0.y }, add_i(cell_a0.z, splat_i(1i32)));
    return VoxelCell { low: e_3, high: e_8, };
} }
lanes! { fn voxel_cell_at(r: &Resources<'_>, way_a0: &VoxelPath, cell_a1: Vec3<F>, reach_a2: F, t_a3: F) -> Vec3<F> {
    let far_4 = Vec3 { x: reach_a2, y: reach_a2, z: reach_a2 };
    let e_5 = voxel_place_on(r, way_a0, t_a3);
    return Vec3 { x: min(max(floor(e_5.x), sub(cell_a1.x, far_4.x)), add(cell_a1.x, far_4.x)), y: min(max(floor(e_5.y), sub(cell_a1.y, far_4.y)), add(cell_a1.y, far_4.y)), z: min(max(floor(e_5.z), sub(cell_a1.z, far_4.z)), add(cell_a1.z, far_4.z)) };
} }
lanes! { fn next_voxel_cell(r: &Resources<'_>, within: M, way_a0: &VoxelPath, cell_a1: Vec3<F>, reach_a2: F, leave_a3: Vec3<F>, rises_a4: M, t_a5: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut next_v0: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut both_v1: M = splat_m(false);
    let e_6 = voxel_cell_at(r, way_a0, cell_a1, reach_a2, t_a5);
    next_v0 = e_6;
    let far_9 = add(reach_a2, splat(1.0f32));
    both_v1 = and(le(leave_a3.x, leave_a3.y), le(leave_a3.x, leave_a3.z));
    let e_19 = both_v1;
    let (b1, c2) = (ex, e_19);
    ex = and(b1, c2);
    if any(ex) {
        next_v0.x = sel(ex, add(cell_a1.x, sel(gt(way_a0.step.x, splat(0.0f32)), far_9, sub(splat(0.0f32), far_9))), next_v0.x);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        let (b3, c4) = (ex, le(leave_a3.y, leave_a3.z));
        ex = and(b3, c4);
        if any(ex) {
            next_v0.y = sel(ex, add(cell_a1.y, sel(gt(way_a0.step.y, splat(0.0f32)), far_9, sub(splat(0.0f32), far_9))), next_v0.y);
        }
        ex = and_not(b3, c4);
        if any(ex) {
            next_v0.z = sel(ex, add(cell_a1.z, sel(rises_a4, far_9, sub(splat(0.0f32), far_9))), next_v0.z);
        }
        ex = b3;
    }
    ex = b1;
    let e_49 = next_v0;
    return e_49;
} }
lanes! { fn next_part(r: &Resources<'_>, within: M, path_a0: &Path, way_a1: &VoxelPath, turn_a2: F, before_a3: &CellPart) -> CellPart {
    let mut ex = within;
    let mut ret: CellPart = zero_cell_part();
    let mut both_v0: M = splat_m(false);
    let reach_6 = max_with(before_a3.empty, splat(0.0f32));
    let has_turned_9 = eq_u(before_a3.past_turn, splat_u(1u32));
    let side_16 = min(min(before_a3.leave.x, before_a3.leave.y), before_a3.leave.z);
    both_v0 = and(not(has_turned_9), gt(side_16, min(turn_a2, path_a0.exit)));
    let e_24 = both_v0;
    let (b1, c2) = (ex, e_24);
    ex = and(b1, c2);
    if any(ex) {
        let e_26 = voxel_cell_at(r, way_a1, Vec3 { x: before_a3.cell.x, y: before_a3.cell.y, z: before_a3.cell.z }, reach_6, before_a3.end);
        let e_28 = part_from_llllls(r, ex, path_a0, way_a1, turn_a2, e_26, before_a3.end, 1u32);
        ret = e_28;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_30 = rises_on(r, ex, way_a1, has_turned_9);
    let next_31 = next_voxel_cell(r, ex, way_a1, Vec3 { x: before_a3.cell.x, y: before_a3.cell.y, z: before_a3.cell.z }, reach_6, Vec3 { x: before_a3.leave.x, y: before_a3.leave.y, z: before_a3.leave.z }, e_30, before_a3.end);
    let e_33 = part_from_llllll(r, ex, path_a0, way_a1, turn_a2, next_31, before_a3.end, before_a3.past_turn);
    return sel_cell_part(ex, &e_33, &ret);
} }
lanes! { fn path_uv(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> Vec2<F> {
    return Vec2 { x: add(path_a0.uv.x, mul(path_a0.duv.x, t_a1)), y: add(path_a0.uv.y, mul(path_a0.duv.y, t_a1)) };
} }
lanes! { fn path_height(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> F {
    return add(path_a0.h.x, mul(t_a1, add(path_a0.h.y, mul(t_a1, path_a0.h.z))));
} }
lanes! { fn path_slope(r: &Resources<'_>, path_a0: &Path, t_a1: F) -> F {
    return add(path_a0.h.y, mul(mul(splat(2.0f32), t_a1), path_a0.h.z));
} }
lanes! { fn field_heights_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_3 = path_height(r, path_a0, t_a1);
    let e_4 = path_uv(r, path_a0, t_a1);
    let e_6 = height_at(r, ex, e_4, path_a0.level);
    return sub(e_3, e_6);
} }
lanes! { fn in_slice(r: &Resources<'_>, corners_a0: Vec4<F>, part_a1: Vec2<F>) -> F {
    let top_8 = add(corners_a0.x, mul(sub(corners_a0.y, corners_a0.x), part_a1.x));
    let bottom_15 = add(corners_a0.z, mul(sub(corners_a0.w, corners_a0.z), part_a1.x));
    return add(top_8, mul(sub(bottom_15, top_8), part_a1.y));
} }
lanes! { fn field_at_voxel(r: &Resources<'_>, within: M, place_a0: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let first_1 = Vec3 { x: floor(place_a0.x), y: floor(place_a0.y), z: floor(place_a0.z) };
    let part_2 = Vec3 { x: sub(place_a0.x, first_1.x), y: sub(place_a0.y, first_1.y), z: sub(place_a0.z, first_1.z) };
    let cell_4 = voxel_cell(r, ex, Vec3 { x: i_of_f(first_1.x), y: i_of_f(first_1.y), z: i_of_f(first_1.z) });
    let low_7 = in_slice(r, Vec4 { x: cell_4.low.x, y: cell_4.low.y, z: cell_4.low.z, w: cell_4.low.w }, Vec2 { x: part_2.x, y: part_2.y });
    let e_10 = in_slice(r, Vec4 { x: cell_4.high.x, y: cell_4.high.y, z: cell_4.high.z, w: cell_4.high.w }, Vec2 { x: part_2.x, y: part_2.y });
    return add(low_7, mul(sub(e_10, low_7), part_2.z));
} }
lanes! { fn voxel_place(r: &Resources<'_>, at_a0: Vec3<F>) -> Vec3<F> {
    let e_1 = r.volume_size();
    return Vec3 { x: sub(mul(at_a0.x, splat(e_1.x)), splat(0.5f32)), y: sub(mul(at_a0.y, splat(e_1.y)), splat(0.5f32)), z: sub(mul(at_a0.z, splat(e_1.z)), splat(0.5f32)) };
} }
lanes! { fn field_at(r: &Resources<'_>, within: M, at_a0: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_1 = voxel_place(r, at_a0);
    let e_2 = field_at_voxel(r, ex, e_1);
    return e_2;
} }
lanes! { fn field_volume_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_3 = path_uv(r, path_a0, t_a1);
    let e_4 = path_height(r, path_a0, t_a1);
    let e_6 = field_at(r, ex, Vec3 { x: e_3.x, y: e_3.y, z: e_4 });
    return sub(splat(0.5f32), e_6);
} }
lanes! { fn field_motif_gap(r: &Resources<'_>, path_a0: &Path, t_a1: F, params_a2: Vec4<f32>) -> F {
    return splat(1.0f32);
} }
lanes! { fn field_gap_stage(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    match r.surface_settings.choices[4].number {
        0u32 => {
            let e_12 = field_heights_gap(r, ex, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_12;
        }
        1u32 => {
            let e_18 = field_volume_gap(r, ex, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_18;
        }
        _ => {
            let e_24 = field_motif_gap(r, path_a0, t_a1, r.surface_settings.choices[4].params);
            return e_24;
        }
    }
} }
lanes! { fn path_gap(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let e_2 = field_gap_stage(r, ex, path_a0, t_a1);
    return e_2;
} }
lanes! { fn bracket_between(r: &Resources<'_>, within: M, path_a0: &Path, near_a1: F, far_a2: F, cost_a3: Vec3<U>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut both_v0: M = splat_m(false);
    let gap_4 = path_gap(r, ex, path_a0, near_a1);
    both_v0 = and(eq(near_a1, splat(0.0f32)), lt(gap_4, splat(0.0f32)));
    let e_12 = both_v0;
    let (b1, c2) = (ex, e_12);
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(5u32), near: splat(0.0f32), far: splat(0.0f32), near_gap: gap_4, far_gap: gap_4, cost: Vec3 { x: add_u(cost_a3.x, splat_u(1u32)), y: add_u(cost_a3.y, splat_u(0u32)), z: add_u(cost_a3.z, splat_u(16u32)) }, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_20 = path_gap(r, ex, path_a0, far_a2);
    return sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: near_a1, far: far_a2, near_gap: gap_4, far_gap: e_20, cost: Vec3 { x: add_u(add_u(cost_a3.x, splat_u(1u32)), splat_u(1u32)), y: add_u(add_u(cost_a3.y, splat_u(0u32)), splat_u(0u32)), z: add_u(add_u(cost_a3.z, splat_u(16u32)), splat_u(16u32)) }, }, &ret);
} }
lanes! { fn cell_after(r: &Resources<'_>, grid_a0: &Grid, cell_a1: Vec2<F>, leave_a2: Vec2<F>, forward_a3: Vec2<M>, t_a4: F) -> Vec2<F> {
    let near_9 = cell_of(r, Vec2 { x: add(grid_a0.origin.x, mul(grid_a0.step.x, t_a4)), y: add(grid_a0.origin.y, mul(grid_a0.step.y, t_a4)) });
    let ahead_20 = Vec2 { x: max(near_9.x, add(cell_a1.x, sel(le(leave_a2.x, t_a4), splat(1.0f32), splat(0.0f32)))), y: max(near_9.y, add(cell_a1.y, sel(le(leave_a2.y, t_a4), splat(1.0f32), splat(0.0f32)))) };
    let behind_31 = Vec2 { x: min(near_9.x, sub(cell_a1.x, sel(le(leave_a2.x, t_a4), splat(1.0f32), splat(0.0f32)))), y: min(near_9.y, sub(cell_a1.y, sel(le(leave_a2.y, t_a4), splat(1.0f32), splat(0.0f32)))) };
    return Vec2 { x: sel(forward_a3.x, ahead_20.x, behind_31.x), y: sel(forward_a3.y, ahead_20.y, behind_31.y) };
} }
lanes! { fn gap_to(r: &Resources<'_>, path_a0: &Path, grid_a1: &Grid, cell_a2: Vec2<F>, h_a3: Vec4<F>, t_a4: F) -> Vec3<F> {
    let bx_7 = sub(h_a3.y, h_a3.x);
    let by_10 = sub(h_a3.z, h_a3.x);
    let twist_17 = add(sub(h_a3.x, h_a3.y), sub(h_a3.w, h_a3.z));
    let at_22 = Vec2 { x: add(sub(grid_a1.origin.x, cell_a2.x), mul(grid_a1.step.x, t_a4)), y: add(sub(grid_a1.origin.y, cell_a2.y), mul(grid_a1.step.y, t_a4)) };
    let z_32 = add(path_a0.h.x, mul(t_a4, add(path_a0.h.y, mul(t_a4, path_a0.h.z))));
    let dz_40 = add(path_a0.h.y, mul(mul(splat(2.0f32), t_a4), path_a0.h.z));
    return Vec3 { x: sub(z_32, add(add(add(h_a3.x, mul(bx_7, at_22.x)), mul(by_10, at_22.y)), mul(mul(twist_17, at_22.x), at_22.y))), y: sub(dz_40, add(add(mul(bx_7, grid_a1.step.x), mul(by_10, grid_a1.step.y)), mul(twist_17, add(mul(at_22.x, grid_a1.step.y), mul(at_22.y, grid_a1.step.x))))), z: sub(path_a0.h.z, mul(mul(twist_17, grid_a1.step.x), grid_a1.step.y)) };
} }
lanes! { fn object_none_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn cell_of_images(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    if (r.surface_settings.cells == 0u32) {
        let e_7 = height_cell(r, ex, cell_a0, level_a1);
        return e_7;
    }
    if (r.surface_settings.cells == 2u32) {
        let h_13 = height_cell(r, ex, cell_a0, level_a1);
        let most_20 = max(max(h_13.x, h_13.y), max(h_13.z, h_13.w));
        let least_27 = min(min(h_13.x, h_13.y), min(h_13.z, h_13.w));
        let c1 = gt(sub(most_20, least_27), splat(r.surface_settings.jump));
        ret = Vec4 { x: most_20, y: most_20, z: most_20, w: most_20 };
        ex = and_not(ex, c1);
        let y2 = h_13;
        return Vec4 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y), z: sel(ex, y2.z, ret.z), w: sel(ex, y2.w, ret.w) };
    }
    let dual_40 = Vec2 { x: shr_i(cell_a0.x, splat_u(1u32)), y: shr_i(cell_a0.y, splat_u(1u32)) };
    if none(ex) { return ret; }
    let h_41 = height_cell(r, ex, dual_40, level_a1);
    let most_48 = max(max(h_41.x, h_41.y), max(h_41.z, h_41.w));
    let least_55 = min(min(h_41.x, h_41.y), min(h_41.z, h_41.w));
    let right_62 = eq_i(sub_i(sub_i(cell_a0.x, dual_40.x), dual_40.x), splat_i(1i32));
    let lower_69 = eq_i(sub_i(sub_i(cell_a0.y, dual_40.y), dual_40.y), splat_i(1i32));
    if !(r.surface_settings.cells == 3u32) {
        both_v0 = gt(sub(most_48, least_55), splat(r.surface_settings.jump));
    } else {
        both_v0 = splat_m(true);
    }
    let e_84 = both_v0;
    let c3 = e_84;
    let nearest_91 = sel(lower_69, sel(right_62, h_41.w, h_41.z), sel(right_62, h_41.y, h_41.x));
    let y4 = Vec4 { x: nearest_91, y: nearest_91, z: nearest_91, w: nearest_91 };
    ret = Vec4 { x: sel(and(ex, c3), y4.x, ret.x), y: sel(and(ex, c3), y4.y, ret.y), z: sel(and(ex, c3), y4.z, ret.z), w: sel(and(ex, c3), y4.w, ret.w) };
    ex = and_not(ex, c3);
    let top_97 = mul(splat(0.5f32), add(h_41.x, h_41.y));
    let bottom_102 = mul(splat(0.5f32), add(h_41.z, h_41.w));
    let left_107 = mul(splat(0.5f32), add(h_41.x, h_41.z));
    let side_112 = mul(splat(0.5f32), add(h_41.y, h_41.w));
    let middle_115 = mul(splat(0.5f32), add(top_97, bottom_102));
    let y5 = Vec4 { x: sel(lower_69, sel(right_62, middle_115, left_107), sel(right_62, top_97, h_41.x)), y: sel(lower_69, sel(right_62, side_112, middle_115), sel(right_62, h_41.y, top_97)), z: sel(lower_69, sel(right_62, bottom_102, h_41.z), sel(right_62, middle_115, left_107)), w: sel(lower_69, sel(right_62, h_41.w, bottom_102), sel(right_62, side_112, middle_115)) };
    return Vec4 { x: sel(ex, y5.x, ret.x), y: sel(ex, y5.y, ret.y), z: sel(ex, y5.z, ret.z), w: sel(ex, y5.w, ret.w) };
} }
lanes! { fn object_depth_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_images(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn cell_of_mask(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let h_2 = height_cell(r, ex, cell_a0, level_a1);
    return Vec4 { x: sel(gt(h_2.x, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), y: sel(gt(h_2.y, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), z: sel(gt(h_2.z, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)), w: sel(gt(h_2.w, splat(1e-5f32)), splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn object_hull_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = cell_of_mask(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_blend_cell(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32, params_a2: Vec4<f32>) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_3 = height_cell(r, ex, cell_a0, level_a1);
    return e_3;
} }
lanes! { fn object_cell_stage(r: &Resources<'_>, within: M, cell_a0: Vec2<I>, level_a1: u32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    match r.surface_settings.choices[3].number {
        0u32 => {
            let e_12 = object_none_cell(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_12;
        }
        1u32 => {
            let e_18 = object_depth_cell(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_18;
        }
        2u32 => {
            let e_24 = object_hull_cell(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_24;
        }
        _ => {
            let e_30 = object_blend_cell(r, ex, cell_a0, level_a1, r.surface_settings.choices[3].params);
            return e_30;
        }
    }
} }
lanes! { fn cell_gap(r: &Resources<'_>, within: M, path_a0: &Path, grid_a1: &Grid, cell_a2: Vec2<F>, t_a3: F) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let e_4 = whole_cell(r, ex, cell_a2);
    let e_6 = object_cell_stage(r, ex, e_4, path_a0.level);
    let e_7 = gap_to(r, path_a0, grid_a1, cell_a2, e_6, t_a3);
    return e_7;
} }
lanes! { fn cell_leave(r: &Resources<'_>, grid_a0: &Grid, cell_a1: Vec2<F>) -> Vec2<F> {
    let ahead_13 = Vec2 { x: sel(gt(grid_a0.step.x, splat(0.0f32)), splat(1.0f32), splat(0.0f32)), y: sel(gt(grid_a0.step.y, splat(0.0f32)), splat(1.0f32), splat(0.0f32)) };
    let leave_18 = Vec2 { x: div(sub(add(cell_a1.x, ahead_13.x), grid_a0.origin.x), grid_a0.step.x), y: div(sub(add(cell_a1.y, ahead_13.y), grid_a0.origin.y), grid_a0.step.y) };
    return Vec2 { x: sel(gt(abs(grid_a0.step.x), splat(0.0f32)), leave_18.x, splat(3e38f32)), y: sel(gt(abs(grid_a0.step.y), splat(0.0f32)), leave_18.y, splat(3e38f32)) };
} }
lanes! { fn cell_next(r: &Resources<'_>, within: M, grid_a0: &Grid, cell_a1: Vec2<F>, leave_a2: Vec2<F>) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut next_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    next_v0 = cell_a1;
    let c1 = le(leave_a2.x, leave_a2.y);
    next_v0.x = sel(c1, add(cell_a1.x, sel(gt(grid_a0.step.x, splat(0.0f32)), splat(1.0f32), splat((-1.0f32)))), next_v0.x);
    next_v0.y = sel(not(c1), add(cell_a1.y, sel(gt(grid_a0.step.y, splat(0.0f32)), splat(1.0f32), splat((-1.0f32)))), next_v0.y);
    let e_27 = next_v0;
    return e_27;
} }
lanes! { fn grid_of(r: &Resources<'_>, path_a0: &Path) -> Grid {
    let size_2 = r.height_size(path_a0.level);
    let e_4 = r.object_parts_stage(path_a0.level);
    let parts_5 = (e_4 as f32);
    return Grid { origin: Vec2 { x: mul(sub(mul(path_a0.uv.x, splat(size_2.x)), splat(0.5f32)), splat(parts_5)), y: mul(sub(mul(path_a0.uv.y, splat(size_2.y)), splat(0.5f32)), splat(parts_5)) }, step: Vec2 { x: mul(mul(path_a0.duv.x, splat(size_2.x)), splat(parts_5)), y: mul(mul(path_a0.duv.y, splat(size_2.y)), splat(parts_5)) }, };
} }
lanes! { fn factor_place(r: &Resources<'_>, number_a0: I, n_a1: Vec2<i32>) -> Vec2<I> {
    let row_8 = i_of_f(div(add(f_of_i(number_a0), splat(0.5f32)), splat((n_a1.x as f32))));
    return Vec2 { x: sub_i(number_a0, mul_i(row_8, splat_i(n_a1.x))), y: add_i(splat_i(n_a1.y), row_8) };
} }
lanes! { fn term_scales_llsl(r: &Resources<'_>, within: M, path_a0: &Path, number_a1: I, n_a2: Vec2<i32>, layer_a3: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let level_5 = (path_a0.level as i32);
    let e_6 = factor_place(r, number_a1, n_a2);
    let high_7 = search_texel_llls(r, ex, path_a0, e_6, layer_a3, level_5);
    let e_10 = factor_place(r, add_i(number_a1, splat_i(1i32)), n_a2);
    let low_11 = search_texel_llls(r, ex, path_a0, e_10, layer_a3, level_5);
    let root_14 = Vec4 { x: add(high_7.x, mul(low_11.x, splat(0.003921569f32))), y: add(high_7.y, mul(low_11.y, splat(0.003921569f32))), z: add(high_7.z, mul(low_11.z, splat(0.003921569f32))), w: add(high_7.w, mul(low_11.w, splat(0.003921569f32))) };
    return Vec4 { x: mul(mul(root_14.x, root_14.x), splat(512.0f32)), y: mul(mul(root_14.y, root_14.y), splat(512.0f32)), z: mul(mul(root_14.z, root_14.z), splat(512.0f32)), w: mul(mul(root_14.w, root_14.w), splat(512.0f32)) };
} }
lanes! { fn term_scales_lssl(r: &Resources<'_>, within: M, path_a0: &Path, number_a1: i32, n_a2: Vec2<i32>, layer_a3: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let level_5 = (path_a0.level as i32);
    let e_6 = factor_place(r, splat_i(number_a1), n_a2);
    let high_7 = search_texel_llls(r, ex, path_a0, e_6, layer_a3, level_5);
    let e_10 = factor_place(r, splat_i(number_a1.wrapping_add(1i32)), n_a2);
    let low_11 = search_texel_llls(r, ex, path_a0, e_10, layer_a3, level_5);
    let root_14 = Vec4 { x: add(high_7.x, mul(low_11.x, splat(0.003921569f32))), y: add(high_7.y, mul(low_11.y, splat(0.003921569f32))), z: add(high_7.z, mul(low_11.z, splat(0.003921569f32))), w: add(high_7.w, mul(low_11.w, splat(0.003921569f32))) };
    return Vec4 { x: mul(mul(root_14.x, root_14.x), splat(512.0f32)), y: mul(mul(root_14.y, root_14.y), splat(512.0f32)), z: mul(mul(root_14.z, root_14.z), splat(512.0f32)), w: mul(mul(root_14.w, root_14.w), splat(512.0f32)) };
} }
stage! { fn clustered_way(r: &Resources<'_>, within: M, path_a0: &Path, texel_a1: Vec2<I>, pair_a2: &ViewPair, params_a3: Vec4<f32>, layers_a4: U) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v0: Vec2<F> = Vec2 { x: splat(0.0f32), y: splat(0.0f32) };
    let mut layer_v1: I = splat_i(1i32);
    let n_6 = r.height_texels(path_a0.level);
    let level_8 = (path_a0.level as i32);
    let bends_10 = (params_a3.z as i32);
    let count_15 = ((params_a3.x * params_a3.y) as i32).wrapping_mul(bends_10);
    let e_17 = search_texel_llss(r, path_a0, texel_a1, 0i32, level_8);
    let cluster_24 = i_of_f(floor(add(mul(e_17.x, splat(255.0f32)), splat(0.5f32))));
    let first_27 = mul_i(cluster_24, splat_i(count_15.wrapping_add(2i32)));
    let lower_view_33 = add_i(add_i(first_27, mul_i(pair_a2.layer, splat_i(bends_10))), i_of_f(pair_a2.bend));
    let of_lower_34 = factor_place(r, lower_view_33, n_6);
    let of_upper_36 = factor_place(r, add_i(lower_view_33, splat_i(bends_10)), n_6);
    let b2 = ex;
    'l1: loop {
        let e_43 = layer_v1;
        let c3 = lt_i(e_43, i_of_u(layers_a4));
        ex = and(ex, c3);
        let e_46 = layer_v1;
        if none(ex) { break 'l1; }
        let e_47 = search_texel_llls(r, ex, path_a0, texel_a1, e_46, level_8);
        let e_49 = layer_v1;
        let e_50 = term_scales_llsl(r, ex, path_a0, add_i(first_27, splat_i(count_15)), n_6, e_49);
        let scaled_51 = Vec4 { x: mul(e_47.x, e_50.x), y: mul(e_47.y, e_50.y), z: mul(e_47.z, e_50.z), w: mul(e_47.w, e_50.w) };
        let e_52 = layer_v1;
        let lower_53 = search_texel_llls(r, ex, path_a0, of_lower_34, e_52, level_8);
        let e_54 = layer_v1;
        let upper_55 = search_texel_llls(r, ex, path_a0, of_upper_36, e_54, level_8);
        let e_56 = both_v0;
        let (m4, y5) = (ex, Vec2 { x: add(e_56.x, mul(lower_53.x, scaled_51.x)), y: add(e_56.y, mul(upper_55.x, scaled_51.x)) });
        both_v0 = Vec2 { x: sel(m4, y5.x, both_v0.x), y: sel(m4, y5.y, both_v0.y) };
        let e_63 = both_v0;
        let (m6, y7) = (ex, Vec2 { x: add(e_63.x, mul(lower_53.y, scaled_51.y)), y: add(e_63.y, mul(upper_55.y, scaled_51.y)) });
        both_v0 = Vec2 { x: sel(m6, y7.x, both_v0.x), y: sel(m6, y7.y, both_v0.y) };
        let e_70 = both_v0;
        let (m8, y9) = (ex, Vec2 { x: add(e_70.x, mul(lower_53.z, scaled_51.z)), y: add(e_70.y, mul(upper_55.z, scaled_51.z)) });
        both_v0 = Vec2 { x: sel(m8, y9.x, both_v0.x), y: sel(m8, y9.y, both_v0.y) };
        let e_77 = both_v0;
        let (m10, y11) = (ex, Vec2 { x: add(e_77.x, mul(lower_53.w, scaled_51.w)), y: add(e_77.y, mul(upper_55.w, scaled_51.w)) });
        both_v0 = Vec2 { x: sel(m10, y11.x, both_v0.x), y: sel(m10, y11.y, both_v0.y) };
        let e_84 = layer_v1;
        layer_v1 = add_i(e_84, splat_i(1i32));
    }
    ex = b2;
    let e_87 = both_v0;
    return e_87;
} }
lanes! { fn flagged_ways(r: &Resources<'_>, lower_a0: F, upper_a1: F) -> Vec4<F> {
    let is_lower_3 = lt(lower_a0, splat(1.125f32));
    let is_upper_5 = lt(upper_a1, splat(1.125f32));
    return Vec4 { x: sel(is_lower_3, min_with(max_with(lower_a0, splat(0.0f32)), splat(0.99607843f32)), splat(0.0f32)), y: sel(is_lower_3, splat(1.0f32), splat(0.0f32)), z: sel(is_upper_5, min_with(max_with(upper_a1, splat(0.0f32)), splat(0.99607843f32)), splat(0.0f32)), w: sel(is_upper_5, splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn joined_texels(r: &Resources<'_>, lower_a0: Vec4<F>, upper_a1: Vec4<F>, part_a2: Vec2<F>) -> Vec4<F> {
    let e_5 = flagged_ways(r, lower_a0.x, upper_a1.x);
    let e_8 = flagged_ways(r, lower_a0.y, upper_a1.y);
    let e_11 = flagged_ways(r, lower_a0.z, upper_a1.z);
    let e_14 = flagged_ways(r, lower_a0.w, upper_a1.w);
    let e_15 = bilinear(r, e_5, e_8, e_11, e_14, part_a2);
    return e_15;
} }
lanes! { fn clustered_ways(r: &Resources<'_>, within: M, path_a0: &Path, around_a1: &Around, pair_a2: &ViewPair, params_a3: Vec4<f32>, layers_a4: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let t00_10 = clustered_way(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: around_a1.rows.x }, pair_a2, params_a3, layers_a4);
    let t10_16 = clustered_way(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: around_a1.rows.x }, pair_a2, params_a3, layers_a4);
    let t01_22 = clustered_way(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: around_a1.rows.y }, pair_a2, params_a3, layers_a4);
    let t11_28 = clustered_way(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: around_a1.rows.y }, pair_a2, params_a3, layers_a4);
    let e_40 = joined_texels(r, Vec4 { x: t00_10.x, y: t10_16.x, z: t01_22.x, w: t11_28.x }, Vec4 { x: t00_10.y, y: t10_16.y, z: t01_22.y, w: t11_28.y }, Vec2 { x: around_a1.part.x, y: around_a1.part.y });
    return e_40;
} }
lanes! { fn object_texel(r: &Resources<'_>, place_a0: Vec2<I>) -> Vec4<F> {
    let e_4 = map_texel(&r.object_map, place_a0.x, place_a0.y, 0i32, 0i32);
    return e_4;
} }
lanes! { fn slope_of(r: &Resources<'_>, within: M, value_a0: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let squared_3 = mul(mul(splat(0.125f32), value_a0), value_a0);
    let c1 = gt(squared_3, splat(0.0f32));
    ret = div(mul(sub(splat(1.0f32), value_a0), add(splat(1.0f32), value_a0)), squared_3);
    ex = and_not(ex, c1);
    return sel(ex, splat((-1.0f32)), ret);
} }
lanes! { fn cone_slope(r: &Resources<'_>, within: M, path_a0: &Path, texel_a1: Vec2<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let n_3 = r.height_texels(path_a0.level);
    let place_4 = whole_cell(r, ex, texel_a1);
    let e_7 = wrap_index(r, ex, place_4.x, n_3.x);
    let e_10 = wrap_index(r, ex, place_4.y, n_3.y);
    let wrapped_11 = Vec2 { x: e_7, y: e_10 };
    let e_15 = search_texel_llss(r, path_a0, wrapped_11, 0i32, (path_a0.level as i32));
    let e_17 = slope_of(r, ex, e_15.x);
    return e_17;
} }
lanes! { fn corner_height(r: &Resources<'_>, heights_a0: Vec4<F>, corner_a1: Vec2<F>) -> F {
    let above_7 = sel(gt(corner_a1.x, splat(0.5f32)), heights_a0.y, heights_a0.x);
    let below_13 = sel(gt(corner_a1.x, splat(0.5f32)), heights_a0.w, heights_a0.z);
    return sel(gt(corner_a1.y, splat(0.5f32)), below_13, above_7);
} }
lanes! { fn height_and_slope(r: &Resources<'_>, within: M, uv_a0: Vec2<F>, level_a1: u32) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let size_2 = r.height_size(level_a1);
    let point_7 = Vec2 { x: sub(mul(uv_a0.x, splat(size_2.x)), splat(0.5f32)), y: sub(mul(uv_a0.y, splat(size_2.y)), splat(0.5f32)) };
    let cell_8 = cell_of(r, point_7);
    let f_9 = Vec2 { x: sub(point_7.x, cell_8.x), y: sub(point_7.y, cell_8.y) };
    let h_11 = height_cell(r, ex, Vec2 { x: i_of_small(cell_8.x), y: i_of_small(cell_8.y) }, level_a1);
    let top_18 = add(h_11.x, mul(sub(h_11.y, h_11.x), f_9.x));
    let bottom_25 = add(h_11.z, mul(sub(h_11.w, h_11.z), f_9.x));
    let left_32 = add(h_11.x, mul(sub(h_11.z, h_11.x), f_9.y));
    let right_39 = add(h_11.y, mul(sub(h_11.w, h_11.y), f_9.y));
    return Vec3 { x: add(top_18, mul(sub(bottom_25, top_18), f_9.y)), y: mul(sub(right_39, left_32), splat(size_2.x)), z: mul(sub(bottom_25, top_18), splat(size_2.y)) };
} }
lanes! { fn search_texel_between_lll(r: &Resources<'_>, within: M, path_a0: &Path, uv_a1: Vec2<F>, layer_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = r.height_texels(path_a0.level);
    let at_5 = texels_around(r, ex, uv_a1, e_4);
    let level_7 = (path_a0.level as i32);
    let e_13 = search_texel_llls(r, ex, path_a0, Vec2 { x: at_5.columns.x, y: at_5.rows.x }, layer_a2, level_7);
    let e_19 = search_texel_llls(r, ex, path_a0, Vec2 { x: at_5.columns.y, y: at_5.rows.x }, layer_a2, level_7);
    let e_25 = search_texel_llls(r, ex, path_a0, Vec2 { x: at_5.columns.x, y: at_5.rows.y }, layer_a2, level_7);
    let e_31 = search_texel_llls(r, ex, path_a0, Vec2 { x: at_5.columns.y, y: at_5.rows.y }, layer_a2, level_7);
    let e_33 = bilinear(r, e_13, e_19, e_25, e_31, Vec2 { x: at_5.part.x, y: at_5.part.y });
    return e_33;
} }
lanes! { fn search_texel_between_lls(r: &Resources<'_>, within: M, path_a0: &Path, uv_a1: Vec2<F>, layer_a2: i32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = r.height_texels(path_a0.level);
    let at_5 = texels_around(r, ex, uv_a1, e_4);
    let level_7 = (path_a0.level as i32);
    let e_13 = search_texel_llss(r, path_a0, Vec2 { x: at_5.columns.x, y: at_5.rows.x }, layer_a2, level_7);
    let e_19 = search_texel_llss(r, path_a0, Vec2 { x: at_5.columns.y, y: at_5.rows.x }, layer_a2, level_7);
    let e_25 = search_texel_llss(r, path_a0, Vec2 { x: at_5.columns.x, y: at_5.rows.y }, layer_a2, level_7);
    let e_31 = search_texel_llss(r, path_a0, Vec2 { x: at_5.columns.y, y: at_5.rows.y }, layer_a2, level_7);
    let e_33 = bilinear(r, e_13, e_19, e_25, e_31, Vec2 { x: at_5.part.x, y: at_5.part.y });
    return e_33;
} }
lanes! { fn distance_at(r: &Resources<'_>, within: M, path_a0: &Path, uv_a1: Vec2<F>, height_a2: F, slices_a3: f32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let place_10 = min(max_with(sub(mul(height_a2, splat(slices_a3)), splat(0.5f32)), splat(0.0f32)), splat((slices_a3 - 1.0f32)));
    let below_11 = floor(place_10);
    let e_13 = search_texel_between_lll(r, ex, path_a0, uv_a1, i_of_f(below_11));
    let e_21 = search_texel_between_lll(r, ex, path_a0, uv_a1, i_of_f(min(add(below_11, splat(1.0f32)), splat((slices_a3 - 1.0f32)))));
    return add(e_13.x, mul(sub(e_21.x, e_13.x), sub(place_10, below_11)));
} }
stage! { fn entered_once(r: &Resources<'_>, within: M, path_a0: &Path, grid_a1: &Grid, above_a2: F, below_a3: F, above_gap_a4: F, below_gap_a5: F, so_far_a6: Vec3<U>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut near_v0: F = splat(0f32);
    let mut far_v1: F = splat(0f32);
    let mut near_gap_v2: F = splat(0f32);
    let mut far_gap_v3: F = splat(0f32);
    let mut cost_v4: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v5: M = splat_m(false);
    near_v0 = above_a2;
    far_v1 = below_a3;
    near_gap_v2 = above_gap_a4;
    far_gap_v3 = below_gap_a5;
    cost_v4 = so_far_a6;
    let wide_18 = add(abs(grid_a1.step.x), abs(grid_a1.step.y));
    let b2 = ex;
    'l1: loop {
        let e_19 = far_v1;
        let e_20 = near_v0;
        let c3 = gt(mul(wide_18, sub(e_19, e_20)), splat(3.0f32));
        ex = and(ex, c3);
        let e_25 = cost_v4;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_25.x, splat_u(0u32)), y: add_u(e_25.y, splat_u(1u32)), z: add_u(e_25.z, splat_u(0u32)) });
        cost_v4 = Vec3 { x: sel_u(m4, y5.x, cost_v4.x), y: sel_u(m4, y5.y, cost_v4.y), z: sel_u(m4, y5.z, cost_v4.z) };
        let e_28 = near_v0;
        let e_29 = far_v1;
        let middle_32 = mul(splat(0.5f32), add(e_28, e_29));
        let e_33 = near_v0;
        let e_37 = far_v1;
        both_v5 = and(gt(middle_32, e_33), lt(middle_32, e_37));
        let e_40 = both_v5;
        let c6 = not(e_40);
        ex = and_not(ex, c6);
        if none(ex) { break 'l1; }
        let gap_42 = path_gap(r, ex, path_a0, middle_32);
        let e_43 = cost_v4;
        let (m7, y8) = (ex, Vec3 { x: add_u(e_43.x, splat_u(1u32)), y: add_u(e_43.y, splat_u(0u32)), z: add_u(e_43.z, splat_u(16u32)) });
        cost_v4 = Vec3 { x: sel_u(m7, y8.x, cost_v4.x), y: sel_u(m7, y8.y, cost_v4.y), z: sel_u(m7, y8.z, cost_v4.z) };
        let c9 = le(gap_42, splat(0.0f32));
        far_v1 = sel(and(ex, c9), middle_32, far_v1);
        far_gap_v3 = sel(and(ex, c9), gap_42, far_gap_v3);
        near_v0 = sel(and(ex, not(c9)), middle_32, near_v0);
        near_gap_v2 = sel(and(ex, not(c9)), gap_42, near_gap_v2);
    }
    ex = b2;
    let e_49 = near_v0;
    let e_50 = far_v1;
    let e_51 = near_gap_v2;
    let e_52 = far_gap_v3;
    let e_53 = cost_v4;
    return SearchResult { status: splat_u(3u32), near: e_49, far: e_50, near_gap: e_51, far_gap: e_52, cost: e_53, };
} }
lanes! { fn quartic_slope(r: &Resources<'_>, q_a0: &Quartic, x_a1: F) -> F {
    return add(q_a0.b, mul(x_a1, add(mul(splat(2.0f32), q_a0.c), mul(x_a1, add(mul(splat(3.0f32), q_a0.d), mul(x_a1, mul(splat(4.0f32), q_a0.e)))))));
} }
stage! { fn extremum_between(r: &Resources<'_>, within: M, q_a0: &Quartic, from_x_a1: F, to_x_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut low_v0: F = splat(0f32);
    let mut high_v1: F = splat(0f32);
    let mut k_v2: u32 = 0u32;
    low_v0 = from_x_a1;
    high_v1 = to_x_a2;
    let e_5 = quartic_slope(r, q_a0, from_x_a1);
    let rises_7 = gt(e_5, splat(0.0f32));
    'l1: loop {
        let e_10 = k_v2;
        if (e_10 < 24u32) {
        } else {
            break 'l1;
        }
        let e_13 = low_v0;
        let e_14 = high_v1;
        let middle_17 = mul(splat(0.5f32), add(e_13, e_14));
        let e_18 = quartic_slope(r, q_a0, middle_17);
        let c2 = eq_m(gt(e_18, splat(0.0f32)), rises_7);
        low_v0 = sel(c2, middle_17, low_v0);
        high_v1 = sel(not(c2), middle_17, high_v1);
        let e_22 = k_v2;
        k_v2 = e_22.wrapping_add(1u32);
    }
    let e_25 = high_v1;
    return e_25;
} }
lanes! { fn least_at(r: &Resources<'_>, within: M, c_a0: Vec3<F>, span_a1: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let c1 = gt(c_a0.z, splat(0.0f32));
    ret = min(max_with(div(sub(splat(0.0f32), c_a0.y), mul(splat(2.0f32), c_a0.z)), splat(0.0f32)), span_a1);
    ex = and_not(ex, c1);
    return sel(ex, span_a1, ret);
} }
lanes! { fn falls_in_cell(r: &Resources<'_>, within: M, c_a0: Vec3<F>, span_a1: F) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, not(le(c_a0.x, splat(0.0f32))));
    ex = and(b1, c2);
    if any(ex) {
        let e_8 = least_at(r, ex, c_a0, span_a1);
        let e_9 = quadratic(r, c_a0, e_8);
        both_v0 = sel_m(ex, le(e_9, splat(0.0f32)), both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(true), both_v0);
    }
    ex = b1;
    let e_13 = both_v0;
    return e_13;
} }
lanes! { fn motif_texel(r: &Resources<'_>, place_a0: U) -> Vec4<F> {
    let row_2 = shr_u(place_a0, i_of_u(splat_u(10u32)));
    let e_9 = object_texel(r, Vec2 { x: i_of_u(sub_u(place_a0, mul_u(row_2, splat_u(1024u32)))), y: i_of_u(row_2) });
    return e_9;
} }
lanes! { fn miss(r: &Resources<'_>, cost_a0: Vec3<U>) -> Hit {
    return Hit { found: splat_u(0u32), exhausted: splat_u(0u32), uv: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, height: splat(0.0f32), t: splat(0.0f32), cost: cost_a0, };
} }
lanes! { fn leaves_at_exit(r: &Resources<'_>, within: M, path_a0: &Path) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let e_2 = path_height(r, path_a0, path_a0.exit);
    let (b1, c2) = (ex, not(gt(e_2, splat(1e-6f32))));
    ex = and(b1, c2);
    if any(ex) {
        let e_9 = r.field_is_ground_stage(path_a0.level);
        both_v0 = sel_m(ex, splat_m(!e_9), both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(true), both_v0);
    }
    ex = b1;
    let e_12 = both_v0;
    return e_12;
} }
lanes! { fn hit_on_path(r: &Resources<'_>, within: M, path_a0: &Path, t_a1: F, exhausted_a2: U, cost_a3: Vec3<U>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, gt(t_a1, path_a0.exit));
    ex = and(b1, c2);
    if any(ex) {
        let e_8 = leaves_at_exit(r, ex, path_a0);
        both_v0 = sel_m(ex, e_8, both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b1;
    let e_10 = both_v0;
    let (b3, c4) = (ex, e_10);
    ex = and(b3, c4);
    if any(ex) {
        let e_11 = miss(r, cost_a3);
        ret = e_11;
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    let inside_14 = min(max_with(t_a1, splat(0.0f32)), path_a0.exit);
    if none(ex) { return ret; }
    let e_16 = path_uv(r, path_a0, inside_14);
    let e_17 = path_height(r, path_a0, inside_14);
    return sel_hit(ex, &Hit { found: splat_u(1u32), exhausted: exhausted_a2, uv: e_16, height: e_17, t: inside_14, cost: cost_a3, }, &ret);
} }
lanes! { fn starting_point(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut both_v0: M = splat_m(false);
    let c1 = eq_u(found_a1.status, splat_u(6u32));
    ret = path_a0.base;
    ex = and_not(ex, c1);
    both_v0 = or(eq_u(found_a1.status, splat_u(3u32)), eq_u(found_a1.status, splat_u(2u32)));
    let e_16 = both_v0;
    let c2 = e_16;
    ret = sel(and(ex, c2), found_a1.far, ret);
    ex = and_not(ex, c2);
    return sel(ex, found_a1.near, ret);
} }
lanes! { fn refine_none(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let exhausted_13 = sel_u(eq_u(found_a1.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32));
    if none(ex) { return ret; }
    let e_14 = starting_point(r, ex, path_a0, found_a1);
    let e_16 = hit_on_path(r, ex, path_a0, e_14, exhausted_13, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
    return sel_hit(ex, &e_16, &ret);
} }
lanes! { fn refine_offset(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut t_v0: F = splat(0f32);
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let start_8 = starting_point(r, ex, path_a0, found_a1);
    let e_9 = path_uv(r, path_a0, start_8);
    let level_11 = height_at(r, ex, e_9, path_a0.level);
    let slope_12 = path_slope(r, path_a0, start_8);
    t_v0 = start_8;
    let (b3, c4) = (ex, ne(slope_12, splat(0.0f32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_16 = path_height(r, path_a0, start_8);
        t_v0 = sel(ex, add(start_8, div(sub(level_11, e_16), slope_12)), t_v0);
    }
    ex = b3;
    let e_20 = t_v0;
    let e_30 = hit_on_path(r, ex, path_a0, e_20, sel_u(eq_u(found_a1.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32)), Vec3 { x: add_u(found_a1.cost.x, splat_u(1u32)), y: add_u(found_a1.cost.y, splat_u(0u32)), z: add_u(found_a1.cost.z, splat_u(16u32)) });
    return sel_hit(ex, &e_30, &ret);
} }
lanes! { fn refine_offset_limited(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut hit_v0: Hit = zero_hit();
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let start_8 = starting_point(r, ex, path_a0, found_a1);
    let e_9 = path_uv(r, path_a0, start_8);
    let level_11 = height_at(r, ex, e_9, path_a0.level);
    let e_12 = path_height(r, path_a0, start_8);
    let rise_m_16 = mul(sub(level_11, e_12), path_a0.metric.w);
    let exhausted_22 = sel_u(eq_u(found_a1.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32));
    let e_27 = hit_on_path(r, ex, path_a0, sub(start_8, rise_m_16), exhausted_22, Vec3 { x: add_u(found_a1.cost.x, splat_u(1u32)), y: add_u(found_a1.cost.y, splat_u(0u32)), z: add_u(found_a1.cost.z, splat_u(16u32)) });
    hit_v0 = e_27;
    let e_30 = hit_v0.found;
    let c3 = eq_u(e_30, splat_u(1u32));
    hit_v0.height = sel(c3, level_11, hit_v0.height);
    let e_34 = hit_v0;
    return sel_hit(ex, &e_34, &ret);
} }
lanes! { fn normal_z(r: &Resources<'_>, path_a0: &Path, slope_a1: Vec2<F>) -> F {
    let area_9 = sub(mul(path_a0.metric.x, path_a0.metric.z), mul(path_a0.metric.y, path_a0.metric.y));
    let squared_29 = div(add(sub(mul(mul(slope_a1.x, slope_a1.x), path_a0.metric.z), mul(mul(mul(splat(2.0f32), slope_a1.x), slope_a1.y), path_a0.metric.y)), mul(mul(slope_a1.y, slope_a1.y), path_a0.metric.x)), area_9);
    return div(splat(1.0f32), sqrt(add(splat(1.0f32), mul(mul(path_a0.metric.w, path_a0.metric.w), squared_29))));
} }
lanes! { fn refine_slope(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut t_v0: F = splat(0f32);
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let start_8 = starting_point(r, ex, path_a0, found_a1);
    let e_9 = path_uv(r, path_a0, start_8);
    let plane_11 = height_and_slope(r, ex, e_9, path_a0.level);
    let e_13 = path_height(r, path_a0, start_8);
    let rise_14 = sub(plane_11.x, e_13);
    t_v0 = start_8;
    if (params_a2.x > 0.5f32) {
        let e_19 = path_slope(r, path_a0, start_8);
        let closing_29 = sub(e_19, add(mul(plane_11.y, path_a0.duv.x), mul(plane_11.z, path_a0.duv.y)));
        let c3 = lt(closing_29, splat(0.0f32));
        t_v0 = sel(c3, add(start_8, div(rise_14, closing_29)), t_v0);
    } else {
        let e_40 = normal_z(r, path_a0, Vec2 { x: plane_11.y, y: plane_11.z });
        t_v0 = sub(start_8, mul(mul(rise_14, path_a0.metric.w), e_40));
    }
    let e_43 = t_v0;
    let e_53 = hit_on_path(r, ex, path_a0, e_43, sel_u(eq_u(found_a1.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32)), Vec3 { x: add_u(found_a1.cost.x, splat_u(1u32)), y: add_u(found_a1.cost.y, splat_u(0u32)), z: add_u(found_a1.cost.z, splat_u(16u32)) });
    return sel_hit(ex, &e_53, &ret);
} }
stage! { fn refine_slope_iterative(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut t_v0: F = splat(0f32);
    let mut cost_v1: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut k_v2: f32 = 0.0f32;
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_8 = starting_point(r, ex, path_a0, found_a1);
    t_v0 = e_8;
    cost_v1 = Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z };
    'l3: loop {
        let e_14 = k_v2;
        if (e_14 < params_a2.x) {
        } else {
            break 'l3;
        }
        let e_17 = cost_v1;
        cost_v1 = Vec3 { x: add_u(e_17.x, splat_u(0u32)), y: add_u(e_17.y, splat_u(1u32)), z: add_u(e_17.z, splat_u(0u32)) };
        let e_20 = t_v0;
        let e_21 = path_uv(r, path_a0, e_20);
        let plane_23 = height_and_slope(r, ex, e_21, path_a0.level);
        let e_24 = cost_v1;
        cost_v1 = Vec3 { x: add_u(e_24.x, splat_u(1u32)), y: add_u(e_24.y, splat_u(0u32)), z: add_u(e_24.z, splat_u(16u32)) };
        let e_28 = t_v0;
        let e_29 = path_height(r, path_a0, e_28);
        let rise_30 = sub(plane_23.x, e_29);
        if (params_a2.y > 0.5f32) {
            let e_34 = t_v0;
            let e_35 = path_slope(r, path_a0, e_34);
            let closing_45 = sub(e_35, add(mul(plane_23.y, path_a0.duv.x), mul(plane_23.z, path_a0.duv.y)));
            let c4 = lt(closing_45, splat(0.0f32));
            let e_48 = t_v0;
            t_v0 = sel(c4, add(e_48, div(rise_30, closing_45)), t_v0);
        } else {
            let e_51 = t_v0;
            let e_58 = normal_z(r, path_a0, Vec2 { x: plane_23.y, y: plane_23.z });
            t_v0 = sub(e_51, mul(mul(rise_30, path_a0.metric.w), e_58));
        }
        let e_61 = t_v0;
        t_v0 = min(max_with(e_61, splat(0.0f32)), path_a0.exit);
        let e_65 = k_v2;
        k_v2 = (e_65 + 1.0f32);
    }
    let e_68 = t_v0;
    let e_75 = cost_v1;
    let e_76 = hit_on_path(r, ex, path_a0, e_68, sel_u(eq_u(found_a1.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32)), e_75);
    return sel_hit(ex, &e_76, &ret);
} }
lanes! { fn has_interval(r: &Resources<'_>, within: M, found_a0: &SearchResult) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut both_v2: M = splat_m(false);
    let (b1, c2) = (ex, gt(found_a0.far, found_a0.near));
    ex = and(b1, c2);
    if any(ex) {
        both_v1 = or(eq_u(found_a0.status, splat_u(3u32)), eq_u(found_a0.status, splat_u(6u32)));
        let e_16 = both_v1;
        both_v2 = or(e_16, eq_u(found_a0.status, splat_u(1u32)));
        let e_24 = both_v2;
        both_v0 = sel_m(ex, e_24, both_v0);
    }
    ex = and_not(b1, c2);
    if any(ex) {
        both_v0 = sel_m(ex, splat_m(false), both_v0);
    }
    ex = b1;
    let e_26 = both_v0;
    return e_26;
} }
stage! { fn refine_binary(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut near_v0: F = splat(0f32);
    let mut far_v1: F = splat(0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v3: M = splat_m(false);
    let mut crossed_v4: M = splat_m(false);
    let mut k_v5: f32 = 0.0f32;
    let e_3 = has_interval(r, ex, found_a1);
    let (b1, c2) = (ex, not(e_3));
    ex = and(b1, c2);
    if any(ex) {
        let e_5 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = e_5;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    near_v0 = found_a1.near;
    far_v1 = found_a1.far;
    cost_v2 = Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z };
    if none(ex) { return ret; }
    let (b3, c4) = (ex, not(eq_u(found_a1.status, splat_u(3u32))));
    ex = and(b3, c4);
    if any(ex) {
        let e_18 = far_v1;
        let e_19 = path_height(r, path_a0, e_18);
        both_v3 = sel_m(ex, le(e_19, splat(1e-6f32)), both_v3);
    }
    ex = and_not(b3, c4);
    if any(ex) {
        both_v3 = sel_m(ex, splat_m(true), both_v3);
    }
    ex = b3;
    let e_23 = both_v3;
    crossed_v4 = e_23;
    'l5: loop {
        let e_27 = k_v5;
        if (e_27 < params_a2.x) {
        } else {
            break 'l5;
        }
        let e_30 = cost_v2;
        cost_v2 = Vec3 { x: add_u(e_30.x, splat_u(0u32)), y: add_u(e_30.y, splat_u(1u32)), z: add_u(e_30.z, splat_u(0u32)) };
        let e_33 = near_v0;
        let e_34 = far_v1;
        let middle_37 = mul(splat(0.5f32), add(e_33, e_34));
        let e_38 = cost_v2;
        let e_40 = r.field_cost_stage(path_a0.level);
        cost_v2 = Vec3 { x: add_u(e_38.x, splat_u(e_40.x)), y: add_u(e_38.y, splat_u(e_40.y)), z: add_u(e_38.z, splat_u(e_40.z)) };
        let e_42 = path_gap(r, ex, path_a0, middle_37);
        let c6 = le(e_42, splat(0.0f32));
        far_v1 = sel(c6, middle_37, far_v1);
        crossed_v4 = sel_m(c6, splat_m(true), crossed_v4);
        near_v0 = sel(not(c6), middle_37, near_v0);
        let e_46 = k_v5;
        k_v5 = (e_46 + 1.0f32);
    }
    let e_49 = crossed_v4;
    let (b7, c8) = (ex, not(e_49));
    ex = and(b7, c8);
    if any(ex) {
        let e_51 = cost_v2;
        let e_52 = miss(r, e_51);
        ret = sel_hit(ex, &e_52, &ret);
        ex = no_lane();
    }
    ex = and_not(b7, c8);
    let e_53 = near_v0;
    let e_54 = far_v1;
    let e_59 = cost_v2;
    if none(ex) { return ret; }
    let e_60 = hit_on_path(r, ex, path_a0, mul(splat(0.5f32), add(e_53, e_54)), splat_u(0u32), e_59);
    return sel_hit(ex, &e_60, &ret);
} }
stage! { fn refine_secant(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut near_v0: F = splat(0f32);
    let mut far_v1: F = splat(0f32);
    let mut near_gap_v2: F = splat(0f32);
    let mut far_gap_v3: F = splat(0f32);
    let mut cost_v4: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut t_v5: F = splat(0f32);
    let mut k_v6: F = splat(1.0f32);
    let e_3 = has_interval(r, ex, found_a1);
    let (b1, c2) = (ex, not(e_3));
    ex = and(b1, c2);
    if any(ex) {
        let e_5 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = e_5;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    near_v0 = found_a1.near;
    far_v1 = found_a1.far;
    near_gap_v2 = found_a1.near_gap;
    far_gap_v3 = found_a1.far_gap;
    cost_v4 = Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z };
    if none(ex) { return ret; }
    let (b3, c4) = (ex, ne_u(found_a1.status, splat_u(3u32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_19 = near_v0;
        let e_20 = path_gap(r, ex, path_a0, e_19);
        near_gap_v2 = sel(ex, e_20, near_gap_v2);
        let e_21 = far_v1;
        let e_22 = path_gap(r, ex, path_a0, e_21);
        far_gap_v3 = sel(ex, e_22, far_gap_v3);
        let e_23 = cost_v4;
        let e_25 = r.field_cost_stage(path_a0.level);
        let e_28 = r.field_cost_stage(path_a0.level);
        let (m5, y6) = (ex, Vec3 { x: add_u(add_u(e_23.x, splat_u(e_25.x)), splat_u(e_28.x)), y: add_u(add_u(e_23.y, splat_u(e_25.y)), splat_u(e_28.y)), z: add_u(add_u(e_23.z, splat_u(e_25.z)), splat_u(e_28.z)) });
        cost_v4 = Vec3 { x: sel_u(m5, y6.x, cost_v4.x), y: sel_u(m5, y6.y, cost_v4.y), z: sel_u(m5, y6.z, cost_v4.z) };
        let e_30 = far_gap_v3;
        let (b7, c8) = (ex, gt(e_30, splat(0.0f32)));
        ex = and(b7, c8);
        if any(ex) {
            let e_33 = cost_v4;
            let e_34 = miss(r, e_33);
            ret = sel_hit(ex, &e_34, &ret);
            ex = no_lane();
        }
        ex = and_not(b7, c8);
    }
    let x9 = ex;
    ex = and_not(b3, c4);
    ex = or(ex, x9);
    let e_35 = far_v1;
    t_v5 = e_35;
    if none(ex) { return ret; }
    let b11 = ex;
    'l10: loop {
        let e_39 = k_v6;
        let c12 = le(e_39, splat(params_a2.x));
        ex = and(ex, c12);
        let e_42 = cost_v4;
        let (m13, y14) = (ex, Vec3 { x: add_u(e_42.x, splat_u(0u32)), y: add_u(e_42.y, splat_u(1u32)), z: add_u(e_42.z, splat_u(0u32)) });
        cost_v4 = Vec3 { x: sel_u(m13, y14.x, cost_v4.x), y: sel_u(m13, y14.y, cost_v4.y), z: sel_u(m13, y14.z, cost_v4.z) };
        let e_45 = near_gap_v2;
        let e_46 = far_gap_v3;
        let drop_47 = sub(e_45, e_46);
        let c15 = not(gt(drop_47, splat(0.0f32)));
        ex = and_not(ex, c15);
        let e_51 = near_v0;
        let e_52 = far_v1;
        let e_53 = near_v0;
        let e_55 = near_gap_v2;
        t_v5 = sel(ex, add(e_51, mul(sub(e_52, e_53), div(e_55, drop_47))), t_v5);
        let e_59 = k_v6;
        if none(ex) { break 'l10; }
        let (b16, c17) = (ex, lt(e_59, splat(params_a2.x)));
        ex = and(b16, c17);
        if any(ex) {
            let e_62 = t_v5;
            let gap_63 = path_gap(r, ex, path_a0, e_62);
            let e_64 = cost_v4;
            let e_66 = r.field_cost_stage(path_a0.level);
            let (m18, y19) = (ex, Vec3 { x: add_u(e_64.x, splat_u(e_66.x)), y: add_u(e_64.y, splat_u(e_66.y)), z: add_u(e_64.z, splat_u(e_66.z)) });
            cost_v4 = Vec3 { x: sel_u(m18, y19.x, cost_v4.x), y: sel_u(m18, y19.y, cost_v4.y), z: sel_u(m18, y19.z, cost_v4.z) };
            let c20 = le(gap_63, splat(0.0f32));
            let e_70 = t_v5;
            far_v1 = sel(and(ex, c20), e_70, far_v1);
            far_gap_v3 = sel(and(ex, c20), gap_63, far_gap_v3);
            let e_71 = t_v5;
            near_v0 = sel(and(ex, not(c20)), e_71, near_v0);
            near_gap_v2 = sel(and(ex, not(c20)), gap_63, near_gap_v2);
        }
        ex = b16;
        let e_72 = k_v6;
        k_v6 = add(e_72, splat(1.0f32));
    }
    ex = b11;
    let e_75 = t_v5;
    let e_77 = cost_v4;
    let e_78 = hit_on_path(r, ex, path_a0, e_75, splat_u(0u32), e_77);
    return sel_hit(ex, &e_78, &ret);
} }
stage! { fn refine_true_secant(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut before_v0: F = splat(0f32);
    let mut last_v1: F = splat(0f32);
    let mut before_gap_v2: F = splat(0f32);
    let mut last_gap_v3: F = splat(0f32);
    let mut cost_v4: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut k_v5: F = splat(1.0f32);
    let e_3 = has_interval(r, ex, found_a1);
    let (b1, c2) = (ex, not(e_3));
    ex = and(b1, c2);
    if any(ex) {
        let e_5 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = e_5;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    before_v0 = found_a1.near;
    last_v1 = found_a1.far;
    before_gap_v2 = found_a1.near_gap;
    last_gap_v3 = found_a1.far_gap;
    cost_v4 = Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z };
    if none(ex) { return ret; }
    let (b3, c4) = (ex, ne_u(found_a1.status, splat_u(3u32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_19 = before_v0;
        let e_20 = path_gap(r, ex, path_a0, e_19);
        before_gap_v2 = sel(ex, e_20, before_gap_v2);
        let e_21 = last_v1;
        let e_22 = path_gap(r, ex, path_a0, e_21);
        last_gap_v3 = sel(ex, e_22, last_gap_v3);
        let e_23 = cost_v4;
        let e_25 = r.field_cost_stage(path_a0.level);
        let e_28 = r.field_cost_stage(path_a0.level);
        let (m5, y6) = (ex, Vec3 { x: add_u(add_u(e_23.x, splat_u(e_25.x)), splat_u(e_28.x)), y: add_u(add_u(e_23.y, splat_u(e_25.y)), splat_u(e_28.y)), z: add_u(add_u(e_23.z, splat_u(e_25.z)), splat_u(e_28.z)) });
        cost_v4 = Vec3 { x: sel_u(m5, y6.x, cost_v4.x), y: sel_u(m5, y6.y, cost_v4.y), z: sel_u(m5, y6.z, cost_v4.z) };
        let e_30 = last_gap_v3;
        let (b7, c8) = (ex, gt(e_30, splat(0.0f32)));
        ex = and(b7, c8);
        if any(ex) {
            let e_33 = cost_v4;
            let e_34 = miss(r, e_33);
            ret = sel_hit(ex, &e_34, &ret);
            ex = no_lane();
        }
        ex = and_not(b7, c8);
    }
    let x9 = ex;
    ex = and_not(b3, c4);
    ex = or(ex, x9);
    if none(ex) { return ret; }
    let b11 = ex;
    'l10: loop {
        let e_37 = k_v5;
        let c12 = le(e_37, splat(params_a2.x));
        ex = and(ex, c12);
        let e_40 = cost_v4;
        let (m13, y14) = (ex, Vec3 { x: add_u(e_40.x, splat_u(0u32)), y: add_u(e_40.y, splat_u(1u32)), z: add_u(e_40.z, splat_u(0u32)) });
        cost_v4 = Vec3 { x: sel_u(m13, y14.x, cost_v4.x), y: sel_u(m13, y14.y, cost_v4.y), z: sel_u(m13, y14.z, cost_v4.z) };
        let e_43 = before_gap_v2;
        let e_44 = last_gap_v3;
        let change_45 = sub(e_43, e_44);
        let c15 = eq(change_45, splat(0.0f32));
        ex = and_not(ex, c15);
        let e_48 = last_v1;
        let e_49 = last_v1;
        let e_50 = before_v0;
        let e_52 = last_gap_v3;
        let t_58 = min(max(add(e_48, mul(sub(e_49, e_50), div(e_52, change_45))), found_a1.near), found_a1.far);
        let e_59 = last_v1;
        before_v0 = e_59;
        let e_60 = last_gap_v3;
        before_gap_v2 = e_60;
        last_v1 = sel(ex, t_58, last_v1);
        let e_61 = k_v5;
        if none(ex) { break 'l10; }
        let (b16, c17) = (ex, lt(e_61, splat(params_a2.x)));
        ex = and(b16, c17);
        if any(ex) {
            let e_64 = path_gap(r, ex, path_a0, t_58);
            last_gap_v3 = sel(ex, e_64, last_gap_v3);
            let e_65 = cost_v4;
            let e_67 = r.field_cost_stage(path_a0.level);
            let (m18, y19) = (ex, Vec3 { x: add_u(e_65.x, splat_u(e_67.x)), y: add_u(e_65.y, splat_u(e_67.y)), z: add_u(e_65.z, splat_u(e_67.z)) });
            cost_v4 = Vec3 { x: sel_u(m18, y19.x, cost_v4.x), y: sel_u(m18, y19.y, cost_v4.y), z: sel_u(m18, y19.z, cost_v4.z) };
        }
        ex = b16;
        let e_69 = k_v5;
        k_v5 = add(e_69, splat(1.0f32));
    }
    ex = b11;
    let e_72 = last_v1;
    let e_74 = cost_v4;
    let e_75 = hit_on_path(r, ex, path_a0, e_72, splat_u(0u32), e_74);
    return sel_hit(ex, &e_75, &ret);
} }
stage! { fn refine_patch(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut alive = ex;
    let mut t_v0: F = splat(0f32);
    let mut cell_v1: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v3: M = splat_m(false);
    let (b1, c2) = (ex, eq_u(found_a1.status, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_7 = miss(r, Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = e_7;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let (b3, c4) = (ex, eq_u(found_a1.status, splat_u(4u32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_14 = hit_on_path(r, ex, path_a0, found_a1.near, splat_u(1u32), Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = sel_hit(ex, &e_14, &ret);
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    if none(ex) { return ret; }
    let (b5, c6) = (ex, eq_u(found_a1.status, splat_u(5u32)));
    ex = and(b5, c6);
    if any(ex) {
        let e_21 = hit_on_path(r, ex, path_a0, found_a1.near, splat_u(0u32), Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z });
        ret = sel_hit(ex, &e_21, &ret);
        ex = no_lane();
    }
    ex = and_not(b5, c6);
    if none(ex) { return ret; }
    let grid_22 = grid_of(r, path_a0);
    t_v0 = found_a1.near;
    let e_27 = t_v0;
    let e_30 = cell_of(r, Vec2 { x: add(grid_22.origin.x, mul(grid_22.step.x, e_27)), y: add(grid_22.origin.y, mul(grid_22.step.y, e_27)) });
    cell_v1 = e_30;
    cost_v2 = Vec3 { x: found_a1.cost.x, y: found_a1.cost.y, z: found_a1.cost.z };
    let e_35 = cost_v2.x;
    let limit_38 = add_u(e_35, splat_u((params_a2.x as u32)));
    let b8 = ex;
    'l7: loop {
        let e_40 = cost_v2.x;
        let c9 = lt_u(e_40, limit_38);
        ex = and(ex, c9);
        let e_42 = cost_v2;
        let (m10, y11) = (ex, Vec3 { x: add_u(e_42.x, splat_u(0u32)), y: add_u(e_42.y, splat_u(1u32)), z: add_u(e_42.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m10, y11.x, cost_v2.x), y: sel_u(m10, y11.y, cost_v2.y), z: sel_u(m10, y11.z, cost_v2.z) };
        let e_45 = cell_v1;
        if none(ex) { break 'l7; }
        let leave_46 = cell_leave(r, &grid_22, e_45);
        let end_51 = min(min(leave_46.x, leave_46.y), found_a1.far);
        let e_52 = t_v0;
        let span_55 = max_with(sub(end_51, e_52), splat(0.0f32));
        let e_56 = cell_v1;
        let e_57 = t_v0;
        let c_58 = cell_gap(r, ex, path_a0, &grid_22, e_56, e_57);
        let e_59 = cost_v2;
        let (m12, y13) = (ex, Vec3 { x: add_u(e_59.x, splat_u(1u32)), y: add_u(e_59.y, splat_u(0u32)), z: add_u(e_59.z, splat_u(16u32)) });
        cost_v2 = Vec3 { x: sel_u(m12, y13.x, cost_v2.x), y: sel_u(m12, y13.y, cost_v2.y), z: sel_u(m12, y13.z, cost_v2.z) };
        let (b14, c15) = (ex, le(c_58.x, splat(0.0f32)));
        ex = and(b14, c15);
        if any(ex) {
            let e_65 = t_v0;
            let e_67 = cost_v2;
            let e_68 = hit_on_path(r, ex, path_a0, e_65, splat_u(0u32), e_67);
            ret = sel_hit(ex, &e_68, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b14, c15);
        if none(ex) { break 'l7; }
        let s_69 = first_root(r, ex, c_58, span_55);
        let (b16, c17) = (ex, lt(s_69, splat(3e38f32)));
        ex = and(b16, c17);
        if any(ex) {
            let e_72 = t_v0;
            let e_75 = cost_v2;
            let e_76 = hit_on_path(r, ex, path_a0, add(e_72, s_69), splat_u(0u32), e_75);
            ret = sel_hit(ex, &e_76, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b16, c17);
        if none(ex) { break 'l7; }
        let (b18, c19) = (ex, ge(end_51, found_a1.far));
        ex = and(b18, c19);
        if any(ex) {
            both_v3 = or(eq_u(found_a1.status, splat_u(3u32)), eq_u(found_a1.status, splat_u(2u32)));
            let e_89 = both_v3;
            let (b20, c21) = (ex, e_89);
            ex = and(b20, c21);
            if any(ex) {
                let e_92 = cost_v2;
                let e_93 = hit_on_path(r, ex, path_a0, found_a1.far, splat_u(0u32), e_92);
                ret = sel_hit(ex, &e_93, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b20, c21);
            let e_94 = cost_v2;
            let e_95 = miss(r, e_94);
            ret = sel_hit(ex, &e_95, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b18, c19);
        let e_96 = cell_v1;
        if none(ex) { break 'l7; }
        let e_97 = cell_next(r, ex, &grid_22, e_96, leave_46);
        cell_v1 = e_97;
        let e_98 = t_v0;
        t_v0 = sel(ex, max(e_98, end_51), t_v0);
    }
    ex = and(b8, alive);
    let e_100 = t_v0;
    let e_102 = cost_v2;
    if none(ex) { return ret; }
    let e_103 = hit_on_path(r, ex, path_a0, e_100, splat_u(1u32), e_102);
    return sel_hit(ex, &e_103, &ret);
} }
lanes! { fn refine_half_texel(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let mut part_v0: F = splat(0.5f32);
    let (b1, c2) = (ex, ne_u(found_a1.status, splat_u(2u32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_6 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = e_6;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let e_9 = r.height_size(path_a0.level);
    let e_10 = Vec2 { x: mul(path_a0.duv.x, splat(e_9.x)), y: mul(path_a0.duv.y, splat(e_9.y)) };
    let speed_11 = sqrt(add(mul(e_10.x, e_10.x), mul(e_10.y, e_10.y)));
    if none(ex) { return ret; }
    let (b3, c4) = (ex, not(gt(mul(speed_11, path_a0.exit), splat(0.5f32))));
    ex = and(b3, c4);
    if any(ex) {
        let e_17 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = sel_hit(ex, &e_17, &ret);
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    let half_19 = div(splat(0.5f32), speed_11);
    let backward_23 = max_with(sub(found_a1.far, half_19), splat(0.0f32));
    let forward_27 = min(add(found_a1.far, half_19), path_a0.exit);
    if none(ex) { return ret; }
    let e_28 = path_gap(r, ex, path_a0, backward_23);
    let before_29 = abs(e_28);
    let e_30 = path_gap(r, ex, path_a0, forward_27);
    let behind_31 = abs(e_30);
    let c5 = gt(add(before_29, behind_31), splat(0.0f32));
    part_v0 = sel(c5, div(before_29, add(before_29, behind_31)), part_v0);
    let cost_43 = Vec3 { x: add_u(add_u(found_a1.cost.x, splat_u(1u32)), splat_u(1u32)), y: add_u(add_u(found_a1.cost.y, splat_u(0u32)), splat_u(0u32)), z: add_u(add_u(found_a1.cost.z, splat_u(16u32)), splat_u(16u32)) };
    let e_45 = part_v0;
    let e_49 = hit_on_path(r, ex, path_a0, add(backward_23, mul(sub(forward_27, backward_23), e_45)), splat_u(0u32), cost_43);
    return sel_hit(ex, &e_49, &ret);
} }
lanes! { fn greatest_value(r: &Resources<'_>, cell_a0: &VoxelCell) -> F {
    let most_3 = Vec4 { x: max(cell_a0.low.x, cell_a0.high.x), y: max(cell_a0.low.y, cell_a0.high.y), z: max(cell_a0.low.z, cell_a0.high.z), w: max(cell_a0.low.w, cell_a0.high.w) };
    return max(max(most_3.x, most_3.y), max(most_3.z, most_3.w));
} }
lanes! { fn is_above_zero(r: &Resources<'_>, q_a0: &Quartic) -> M {
    let p1_5 = add(q_a0.a, mul(splat(0.25f32), q_a0.b));
    let p2_14 = add(add(q_a0.a, mul(splat(0.5f32), q_a0.b)), div(q_a0.c, splat(6.0f32)));
    let p3_27 = add(add(add(q_a0.a, mul(splat(0.75f32), q_a0.b)), mul(splat(0.5f32), q_a0.c)), mul(splat(0.25f32), q_a0.d));
    let p4_36 = add(add(add(add(q_a0.a, q_a0.b), q_a0.c), q_a0.d), q_a0.e);
    return gt(min(min(min(q_a0.a, p1_5), min(p2_14, p3_27)), p4_36), splat(0.0f32));
} }
lanes! { fn inflections(r: &Resources<'_>, within: M, q_a0: &Quartic) -> Vec2<F> {
    let mut ex = within;
    let mut ret: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let b_3 = mul(splat(3.0f32), q_a0.d);
    let a_6 = mul(splat(6.0f32), q_a0.e);
    let discriminant_12 = sub(mul(b_3, b_3), mul(mul(splat(4.0f32), a_6), q_a0.c));
    let c1 = not(ge(discriminant_12, splat(0.0f32)));
    ret = Vec2 { x: splat(1.0f32), y: splat(1.0f32) };
    ex = and_not(ex, c1);
    let root_19 = sqrt(discriminant_12);
    let s_27 = mul(splat((-0.5f32)), add(b_3, sel(ge(b_3, splat(0.0f32)), root_19, sub(splat(0.0f32), root_19))));
    let first_32 = sel(ne(a_6, splat(0.0f32)), div(s_27, a_6), splat(1.0f32));
    let second_38 = sel(ne(s_27, splat(0.0f32)), div(q_a0.c, s_27), splat(1.0f32));
    both_v0 = and(gt(first_32, splat(0.0f32)), lt(first_32, splat(1.0f32)));
    let e_46 = both_v0;
    let x_48 = sel(e_46, first_32, splat(1.0f32));
    both_v1 = and(gt(second_38, splat(0.0f32)), lt(second_38, splat(1.0f32)));
    let e_56 = both_v1;
    let y_58 = sel(e_56, second_38, splat(1.0f32));
    let y2 = Vec2 { x: min(x_48, y_58), y: max(x_48, y_58) };
    return Vec2 { x: sel(ex, y2.x, ret.x), y: sel(ex, y2.y, ret.y) };
} }
lanes! { fn quartic_at(r: &Resources<'_>, q_a0: &Quartic, x_a1: F) -> F {
    return add(q_a0.a, mul(x_a1, add(q_a0.b, mul(x_a1, add(q_a0.c, mul(x_a1, add(q_a0.d, mul(x_a1, q_a0.e))))))));
} }
stage! { fn root_between(r: &Resources<'_>, within: M, q_a0: &Quartic, above_a1: F, below_a2: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut near_v0: F = splat(0f32);
    let mut far_v1: F = splat(0f32);
    let mut k_v2: u32 = 0u32;
    near_v0 = above_a1;
    far_v1 = below_a2;
    'l1: loop {
        let e_7 = k_v2;
        if (e_7 < 24u32) {
        } else {
            break 'l1;
        }
        let e_10 = near_v0;
        let e_11 = far_v1;
        let middle_14 = mul(splat(0.5f32), add(e_10, e_11));
        let e_15 = quartic_at(r, q_a0, middle_14);
        let c2 = gt(e_15, splat(0.0f32));
        near_v0 = sel(c2, middle_14, near_v0);
        far_v1 = sel(not(c2), middle_14, far_v1);
        let e_18 = k_v2;
        k_v2 = e_18.wrapping_add(1u32);
    }
    let e_21 = far_v1;
    return e_21;
} }
stage! { fn first_root_of_quartic(r: &Resources<'_>, within: M, q_a0: &Quartic) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut alive = ex;
    let mut begin_v0: F = splat(0.0f32);
    let mut k_v1: U = splat_u(0u32);
    let mut both_v2: M = splat_m(false);
    let c1 = not(gt(q_a0.a, splat(0.0f32)));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let e_6 = is_above_zero(r, q_a0);
    let c2 = e_6;
    ret = sel(and(ex, c2), splat(3e38f32), ret);
    ex = and_not(ex, c2);
    if none(ex) { return ret; }
    let inner_8 = inflections(r, ex, q_a0);
    let b4 = ex;
    'l3: loop {
        let e_13 = k_v1;
        let c5 = lt_u(e_13, splat_u(3u32));
        ex = and(ex, c5);
        let e_17 = k_v1;
        let e_23 = k_v1;
        let end_26 = sel(eq_u(e_23, splat_u(0u32)), inner_8.x, sel(eq_u(e_17, splat_u(1u32)), inner_8.y, splat(1.0f32)));
        let e_27 = begin_v0;
        if none(ex) { break 'l3; }
        let (b6, c7) = (ex, gt(end_26, e_27));
        ex = and(b6, c7);
        if any(ex) {
            let e_29 = begin_v0;
            let first_30 = quartic_slope(r, q_a0, e_29);
            let last_31 = quartic_slope(r, q_a0, end_26);
            both_v2 = and(lt(first_30, splat(0.0f32)), gt(last_31, splat(0.0f32)));
            let e_39 = both_v2;
            let (b8, c9) = (ex, e_39);
            ex = and(b8, c9);
            if any(ex) {
                let e_40 = begin_v0;
                let least_41 = extremum_between(r, ex, q_a0, e_40, end_26);
                let e_42 = quartic_at(r, q_a0, least_41);
                let (b10, c11) = (ex, not(gt(e_42, splat(0.0f32))));
                ex = and(b10, c11);
                if any(ex) {
                    let e_46 = begin_v0;
                    let e_47 = root_between(r, ex, q_a0, e_46, least_41);
                    ret = sel(ex, e_47, ret);
                    alive = and_not(alive, ex);
                    ex = no_lane();
                }
                ex = and_not(b10, c11);
            }
            let x12 = ex;
            ex = and_not(b8, c9);
            ex = or(ex, x12);
            let e_48 = quartic_at(r, q_a0, end_26);
            let (b13, c14) = (ex, not(gt(e_48, splat(0.0f32))));
            ex = and(b13, c14);
            if any(ex) {
                let e_52 = begin_v0;
                let e_53 = root_between(r, ex, q_a0, e_52, end_26);
                ret = sel(ex, e_53, ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b13, c14);
        }
        let x15 = ex;
        ex = and_not(b6, c7);
        ex = or(ex, x15);
        let e_54 = begin_v0;
        begin_v0 = max(e_54, end_26);
        let e_56 = k_v1;
        k_v1 = add_u(e_56, splat_u(1u32));
        if none(ex) { break 'l3; }
    }
    ex = and(b4, alive);
    return sel(ex, splat(3e38f32), ret);
} }
lanes! { fn root_in_voxel_cell(r: &Resources<'_>, within: M, way_a0: &VoxelPath, cell_a1: Vec3<F>, t_a2: F, span_a3: F) -> RootInCell {
    let mut ex = within;
    let mut ret: RootInCell = zero_root_in_cell();
    let corners_5 = voxel_cell(r, ex, Vec3 { x: i_of_f(cell_a1.x), y: i_of_f(cell_a1.y), z: i_of_f(cell_a1.z) });
    let e_6 = greatest_value(r, &corners_5);
    let (b1, c2) = (ex, lt(e_6, splat(0.5f32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = RootInCell { root: splat(3e38f32), gap: splat(1.0f32), };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let gap_12 = gap_in_cell(r, way_a0, cell_a1, &corners_5, t_a2, span_a3);
    let e_13 = first_root_of_quartic(r, ex, &gap_12);
    return sel_root_in_cell(ex, &RootInCell { root: e_13, gap: gap_12.a, }, &ret);
} }
stage! { fn first_root_on_path(r: &Resources<'_>, within: M, path_a0: &Path, from_t_a1: F, to_t_a2: F, limit_a3: u32) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut has_turned_v0: M = splat_m(false);
    let mut t_v1: F = splat(0f32);
    let mut cell_v2: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut cost_v3: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let way_4 = voxel_path(r, path_a0);
    let turn_5 = turning_point(r, ex, &way_4);
    has_turned_v0 = ge(from_t_a1, turn_5);
    t_v1 = from_t_a1;
    let e_9 = t_v1;
    let e_10 = voxel_place_on(r, &way_4, e_9);
    cell_v2 = Vec3 { x: floor(e_10.x), y: floor(e_10.y), z: floor(e_10.z) };
    let b2 = ex;
    'l1: loop {
        let e_16 = cost_v3.y;
        let c3 = lt_u(e_16, splat_u(limit_a3));
        ex = and(ex, c3);
        let e_18 = cost_v3;
        let (m4, y5) = (ex, Vec3 { x: add_u(add_u(e_18.x, splat_u(0u32)), splat_u(1u32)), y: add_u(add_u(e_18.y, splat_u(1u32)), splat_u(0u32)), z: add_u(add_u(e_18.z, splat_u(0u32)), splat_u(32u32)) });
        cost_v3 = Vec3 { x: sel_u(m4, y5.x, cost_v3.x), y: sel_u(m4, y5.y, cost_v3.y), z: sel_u(m4, y5.z, cost_v3.z) };
        let e_24 = has_turned_v0;
        let end_of_part_25 = sel(e_24, to_t_a2, min(turn_5, to_t_a2));
        let e_26 = cell_v2;
        let e_28 = has_turned_v0;
        if none(ex) { break 'l1; }
        let leave_29 = voxel_leave(r, ex, &way_4, e_26, splat(0.0f32), e_28);
        let side_34 = min(min(leave_29.x, leave_29.y), leave_29.z);
        let e_36 = t_v1;
        let end_37 = max(min(side_34, end_of_part_25), e_36);
        let e_38 = cell_v2;
        let e_39 = t_v1;
        let e_40 = t_v1;
        let found_42 = root_in_voxel_cell(r, ex, &way_4, e_38, e_39, sub(end_37, e_40));
        let (b6, c7) = (ex, lt(found_42.root, splat(3e38f32)));
        ex = and(b6, c7);
        if any(ex) {
            let e_47 = t_v1;
            let e_48 = t_v1;
            let e_50 = t_v1;
            let e_55 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: e_47, far: add(e_48, mul(found_42.root, sub(end_37, e_50))), near_gap: found_42.gap, far_gap: splat(0.0f32), cost: e_55, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b6, c7);
        if none(ex) { break 'l1; }
        let (b8, c9) = (ex, ge(end_37, to_t_a2));
        ex = and(b8, c9);
        if any(ex) {
            let e_60 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: end_37, far: end_37, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_60, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        if none(ex) { break 'l1; }
        let (b10, c11) = (ex, gt(side_34, end_of_part_25));
        ex = and(b10, c11);
        if any(ex) {
            has_turned_v0 = sel_m(ex, splat_m(true), has_turned_v0);
        }
        ex = and_not(b10, c11);
        if any(ex) {
            let e_66 = cell_v2;
            let e_68 = has_turned_v0;
            let e_69 = rises_on(r, ex, &way_4, e_68);
            let e_70 = next_voxel_cell(r, ex, &way_4, e_66, splat(0.0f32), leave_29, e_69, end_37);
            let (m12, y13) = (ex, e_70);
            cell_v2 = Vec3 { x: sel(m12, y13.x, cell_v2.x), y: sel(m12, y13.y, cell_v2.y), z: sel(m12, y13.z, cell_v2.z) };
        }
        ex = b10;
        t_v1 = sel(ex, end_37, t_v1);
    }
    ex = and(b2, alive);
    let e_72 = t_v1;
    let e_73 = t_v1;
    let e_74 = cost_v3;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_72, far: e_73, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_74, }, &ret);
} }
lanes! { fn refine_trilinear(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult, params_a2: Vec4<f32>) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let e_3 = has_interval(r, ex, found_a1);
    let (b1, c2) = (ex, not(e_3));
    ex = and(b1, c2);
    if any(ex) {
        let e_5 = refine_none(r, ex, path_a0, found_a1, params_a2);
        ret = e_5;
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let root_10 = first_root_on_path(r, ex, path_a0, found_a1.near, found_a1.far, (params_a2.x as u32));
    let cost_13 = Vec3 { x: add_u(found_a1.cost.x, root_10.cost.x), y: add_u(found_a1.cost.y, root_10.cost.y), z: add_u(found_a1.cost.z, root_10.cost.z) };
    let (b3, c4) = (ex, eq_u(root_10.status, splat_u(3u32)));
    ex = and(b3, c4);
    if any(ex) {
        let e_19 = hit_on_path(r, ex, path_a0, root_10.far, splat_u(0u32), cost_13);
        ret = sel_hit(ex, &e_19, &ret);
        ex = no_lane();
    }
    ex = and_not(b3, c4);
    if none(ex) { return ret; }
    let (b5, c6) = (ex, eq_u(found_a1.status, splat_u(3u32)));
    ex = and(b5, c6);
    if any(ex) {
        let e_30 = hit_on_path(r, ex, path_a0, found_a1.far, sel_u(eq_u(root_10.status, splat_u(4u32)), splat_u(1u32), splat_u(0u32)), cost_13);
        ret = sel_hit(ex, &e_30, &ret);
        ex = no_lane();
    }
    ex = and_not(b5, c6);
    if none(ex) { return ret; }
    let e_31 = miss(r, cost_13);
    return sel_hit(ex, &e_31, &ret);
} }
lanes! { fn refine_stage(r: &Resources<'_>, within: M, path_a0: &Path, found_a1: &SearchResult) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    match r.surface_settings.choices[7].number {
        0u32 => {
            let e_12 = refine_none(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_12;
        }
        1u32 => {
            let e_18 = refine_offset(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_18;
        }
        2u32 => {
            let e_24 = refine_offset_limited(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_24;
        }
        3u32 => {
            let e_30 = refine_slope(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_30;
        }
        4u32 => {
            let e_36 = refine_slope_iterative(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_36;
        }
        5u32 => {
            let e_42 = refine_binary(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_42;
        }
        6u32 => {
            let e_48 = refine_secant(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_48;
        }
        7u32 => {
            let e_54 = refine_true_secant(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_54;
        }
        8u32 => {
            let e_60 = refine_patch(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_60;
        }
        9u32 => {
            let e_66 = refine_half_texel(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_66;
        }
        _ => {
            let e_72 = refine_trilinear(r, ex, path_a0, found_a1, r.surface_settings.choices[7].params);
            return e_72;
        }
    }
} }
lanes! { fn search_none(r: &Resources<'_>, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    return SearchResult { status: splat_u(6u32), near: splat(0.0f32), far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) }, };
} }
stage! { fn search_linear(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut near_v0: F = splat(0.0f32);
    let mut near_gap_v1: F = splat(0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut k_v3: F = splat(1.0f32);
    let cosine_10 = min_with(max_with(mul(abs(path_a0.h.y), path_a0.metric.w), splat(0.0f32)), splat(1.0f32));
    let steps_20 = max_with(ceil(mul(mul(splat(params_a1.x), add(mul(splat(params_a1.y), sub(splat(1.0f32), cosine_10)), mul(splat(1.0f32), cosine_10))), path_a0.share)), splat(1.0f32));
    let e_24 = path_gap(r, ex, path_a0, splat(0.0f32));
    near_gap_v1 = e_24;
    let e_27 = r.field_cost_stage(path_a0.level);
    cost_v2 = Vec3 { x: splat_u(e_27.x), y: splat_u(e_27.y), z: splat_u(e_27.z) };
    let e_29 = near_gap_v1;
    let (b1, c2) = (ex, lt(e_29, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_33 = near_gap_v1;
        let e_34 = near_gap_v1;
        let e_35 = cost_v2;
        ret = SearchResult { status: splat_u(5u32), near: splat(0.0f32), far: splat(0.0f32), near_gap: e_33, far_gap: e_34, cost: e_35, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let b4 = ex;
    'l3: loop {
        let e_41 = k_v3;
        let c5 = le(e_41, steps_20);
        ex = and(ex, c5);
        let e_43 = cost_v2;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_43.x, splat_u(0u32)), y: add_u(e_43.y, splat_u(1u32)), z: add_u(e_43.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m6, y7.x, cost_v2.x), y: sel_u(m6, y7.y, cost_v2.y), z: sel_u(m6, y7.z, cost_v2.z) };
        let e_47 = k_v3;
        let t_49 = mul(path_a0.exit, div(e_47, steps_20));
        if none(ex) { break 'l3; }
        let gap_50 = path_gap(r, ex, path_a0, t_49);
        let e_51 = cost_v2;
        let e_53 = r.field_cost_stage(path_a0.level);
        let (m8, y9) = (ex, Vec3 { x: add_u(e_51.x, splat_u(e_53.x)), y: add_u(e_51.y, splat_u(e_53.y)), z: add_u(e_51.z, splat_u(e_53.z)) });
        cost_v2 = Vec3 { x: sel_u(m8, y9.x, cost_v2.x), y: sel_u(m8, y9.y, cost_v2.y), z: sel_u(m8, y9.z, cost_v2.z) };
        let (b10, c11) = (ex, le(gap_50, splat(0.0f32)));
        ex = and(b10, c11);
        if any(ex) {
            let e_58 = near_v0;
            let e_59 = near_gap_v1;
            let e_60 = cost_v2;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: e_58, far: t_49, near_gap: e_59, far_gap: gap_50, cost: e_60, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b10, c11);
        near_v0 = sel(ex, t_49, near_v0);
        near_gap_v1 = sel(ex, gap_50, near_gap_v1);
        let e_62 = k_v3;
        k_v3 = add(e_62, splat(1.0f32));
        if none(ex) { break 'l3; }
    }
    ex = and(b4, alive);
    let e_66 = near_v0;
    let e_67 = near_v0;
    let e_68 = near_gap_v1;
    let e_69 = near_gap_v1;
    let e_70 = cost_v2;
    return sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_66, far: e_67, near_gap: e_68, far_gap: e_69, cost: e_70, }, &ret);
} }
lanes! { fn found_in_cell(r: &Resources<'_>, within: M, c_a0: Vec3<F>, t_a1: F, span_a2: F, first_a3: M, cost_a4: Vec3<U>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut both_v0: M = splat_m(false);
    let (b1, c2) = (ex, le(c_a0.x, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        both_v0 = and(first_a3, lt(c_a0.x, splat(0.0f32)));
        let e_14 = both_v0;
        let (b3, c4) = (ex, e_14);
        ex = and(b3, c4);
        if any(ex) {
            ret = SearchResult { status: splat_u(5u32), near: splat(0.0f32), far: splat(0.0f32), near_gap: c_a0.x, far_gap: c_a0.x, cost: cost_a4, };
            ex = no_lane();
        }
        ex = and_not(b3, c4);
        ret = sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: t_a1, far: t_a1, near_gap: c_a0.x, far_gap: c_a0.x, cost: cost_a4, }, &ret);
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let s_25 = least_at(r, ex, c_a0, span_a2);
    let e_29 = quadratic(r, c_a0, s_25);
    return sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: t_a1, far: add(t_a1, s_25), near_gap: c_a0.x, far_gap: e_29, cost: cost_a4, }, &ret);
} }
stage! { fn search_cells(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let grid_2 = grid_of(r, path_a0);
    let e_4 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_4;
    let limit_11 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_13 = cost_v2.x;
        let c3 = lt_u(e_13, splat_u(limit_11));
        ex = and(ex, c3);
        let e_15 = cost_v2;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_15.x, splat_u(0u32)), y: add_u(e_15.y, splat_u(1u32)), z: add_u(e_15.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m4, y5.x, cost_v2.x), y: sel_u(m4, y5.y, cost_v2.y), z: sel_u(m4, y5.z, cost_v2.z) };
        let e_18 = cell_v0;
        let e_19 = t_v1;
        if none(ex) { break 'l1; }
        let c_20 = cell_gap(r, ex, path_a0, &grid_2, e_18, e_19);
        let e_21 = cost_v2;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_21.x, splat_u(1u32)), y: add_u(e_21.y, splat_u(0u32)), z: add_u(e_21.z, splat_u(16u32)) });
        cost_v2 = Vec3 { x: sel_u(m6, y7.x, cost_v2.x), y: sel_u(m6, y7.y, cost_v2.y), z: sel_u(m6, y7.z, cost_v2.z) };
        let e_24 = cell_v0;
        let leave_25 = cell_leave(r, &grid_2, e_24);
        let end_30 = min(min(leave_25.x, leave_25.y), path_a0.exit);
        let e_31 = t_v1;
        let span_34 = max_with(sub(end_30, e_31), splat(0.0f32));
        let e_35 = falls_in_cell(r, ex, c_20, span_34);
        let (b8, c9) = (ex, e_35);
        ex = and(b8, c9);
        if any(ex) {
            let e_36 = t_v1;
            let e_38 = cost_v2.x;
            let e_41 = cost_v2;
            let e_42 = found_in_cell(r, ex, c_20, e_36, span_34, eq_u(e_38, splat_u(1u32)), e_41);
            ret = sel_search_result(ex, &e_42, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        if none(ex) { break 'l1; }
        let (b10, c11) = (ex, ge(end_30, path_a0.exit));
        ex = and(b10, c11);
        if any(ex) {
            let e_46 = t_v1;
            let e_49 = quadratic(r, c_20, span_34);
            let e_50 = cost_v2;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_46, far: path_a0.exit, near_gap: c_20.x, far_gap: e_49, cost: e_50, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b10, c11);
        let e_52 = cell_v0;
        if none(ex) { break 'l1; }
        let e_53 = cell_next(r, ex, &grid_2, e_52, leave_25);
        cell_v0 = e_53;
        let e_54 = t_v1;
        t_v1 = sel(ex, max(e_54, end_30), t_v1);
    }
    ex = and(b2, alive);
    let e_57 = t_v1;
    let e_59 = cost_v2;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_57, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_59, }, &ret);
} }
lanes! { fn image_of(r: &Resources<'_>, within: M, cell_a0: I, n_a1: i32) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut both_v0: M = splat_m(false);
    both_v0 = and(ge_i(cell_a0, splat_i(0i32)), lt_i(cell_a0, splat_i(n_a1)));
    let e_8 = both_v0;
    let c1 = e_8;
    ret = Vec2 { x: cell_a0, y: splat_i(0i32) };
    ex = and_not(ex, c1);
    if (r.surface_settings.wrap == 1u32) {
        let y2 = Vec2 { x: min_i(max_i(cell_a0, splat_i(0i32)), splat_i(n_a1.wrapping_sub(1i32))), y: splat_i(2i32) };
        return Vec2 { x: sel_i(ex, y2.x, ret.x), y: sel_i(ex, y2.y, ret.y) };
    }
    if (r.surface_settings.wrap == 0u32) {
        if none(ex) { return ret; }
        let y3 = Vec2 { x: rem_i(add_i(rem_i(cell_a0, splat_i(n_a1)), splat_i(n_a1)), splat_i(n_a1)), y: splat_i(0i32) };
        return Vec2 { x: sel_i(ex, y3.x, ret.x), y: sel_i(ex, y3.y, ret.y) };
    }
    let period_33 = 2i32.wrapping_mul(n_a1);
    if none(ex) { return ret; }
    let folded_36 = rem_i(add_i(rem_i(cell_a0, splat_i(period_33)), splat_i(period_33)), splat_i(period_33));
    let c4 = lt_i(folded_36, splat_i(n_a1));
    let y5 = Vec2 { x: folded_36, y: splat_i(0i32) };
    ret = Vec2 { x: sel_i(and(ex, c4), y5.x, ret.x), y: sel_i(and(ex, c4), y5.y, ret.y) };
    ex = and_not(ex, c4);
    let c6 = eq_i(folded_36, splat_i(period_33.wrapping_sub(1i32)));
    let y7 = Vec2 { x: splat_i(0i32), y: splat_i(2i32) };
    ret = Vec2 { x: sel_i(and(ex, c6), y7.x, ret.x), y: sel_i(and(ex, c6), y7.y, ret.y) };
    ex = and_not(ex, c6);
    let y8 = Vec2 { x: sub_i(splat_i(period_33.wrapping_sub(2i32)), folded_36), y: splat_i(1i32) };
    return Vec2 { x: sel_i(ex, y8.x, ret.x), y: sel_i(ex, y8.y, ret.y) };
} }
lanes! { fn frustum_slope(r: &Resources<'_>, within: M, path_a0: &Path, cell_a1: Vec2<I>, forward_a2: Vec2<M>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut both_v0: M = splat_m(false);
    let n_4 = r.height_texels(path_a0.level);
    let u_7 = image_of(r, ex, cell_a1.x, n_4.x);
    let v_10 = image_of(r, ex, cell_a1.y, n_4.y);
    both_v0 = or(eq_i(u_7.y, splat_i(2i32)), eq_i(v_10.y, splat_i(2i32)));
    let e_21 = both_v0;
    let c1 = e_21;
    ret = splat((-1.0f32));
    ex = and_not(ex, c1);
    if none(ex) { return ret; }
    let slopes_29 = search_texel_llss(r, path_a0, Vec2 { x: u_7.x, y: v_10.x }, 0i32, (path_a0.level as i32));
    let right_34 = eq_m(forward_a2.x, eq_i(u_7.y, splat_i(0i32)));
    let down_39 = eq_m(forward_a2.y, eq_i(v_10.y, splat_i(0i32)));
    return sel(ex, sel(down_39, sel(right_34, slopes_29.x, slopes_29.y), sel(right_34, slopes_29.z, slopes_29.w)), ret);
} }
lanes! { fn map_read(r: &Resources<'_>, path_a0: &Path, texels_a1: U) -> Vec3<U> {
    let slot_7 = (if (path_a0.ray == 1u32) { 2u32 } else { 1u32 });
    return Vec3 { x: splat_u(1u32), y: splat_u(0u32), z: mul_u(texels_a1, splat_u(r.surface_settings.maps[slot_7 as usize].texel_bytes)) };
} }
lanes! { fn stays_above(r: &Resources<'_>, within: M, above_a0: Vec3<F>, slope_a1: F, left_a2: F, speed_a3: F, lost_a4: F, span_a5: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let rise_7 = mul(slope_a1, abs(speed_a3));
    let gap_11 = sub(add(above_a0.x, mul(slope_a1, left_a2)), lost_a4);
    let c1 = le(gap_11, splat(0.0f32));
    ret = splat(0.0f32);
    ex = and_not(ex, c1);
    let closing_22 = add(sub(rise_7, above_a0.y), mul(splat(9.536743e-7f32), add(rise_7, abs(above_a0.y))));
    if none(ex) { return ret; }
    let (b2, c3) = (ex, ne(above_a0.z, splat(0.0f32)));
    ex = and(b2, c3);
    if any(ex) {
        let e_30 = first_root(r, ex, Vec3 { x: gap_11, y: sub(splat(0.0f32), closing_22), z: above_a0.z }, span_a5);
        ret = sel(ex, e_30, ret);
        ex = no_lane();
    }
    ex = and_not(b2, c3);
    let c4 = gt(closing_22, splat(0.0f32));
    ret = sel(and(ex, c4), div(gap_11, closing_22), ret);
    ex = and_not(ex, c4);
    return sel(ex, splat(3e38f32), ret);
} }
stage! { fn search_frustum(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut next_v3: F = splat(0f32);
    let mut slope_v4: F = splat(0f32);
    let mut both_v5: M = splat_m(false);
    let grid_2 = grid_of(r, path_a0);
    let forward_7 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let e_9 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_9;
    let limit_16 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_18 = cost_v2.x;
        let c3 = lt_u(e_18, splat_u(limit_16));
        ex = and(ex, c3);
        let e_20 = cost_v2;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_20.x, splat_u(0u32)), y: add_u(e_20.y, splat_u(1u32)), z: add_u(e_20.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m4, y5.x, cost_v2.x), y: sel_u(m4, y5.y, cost_v2.y), z: sel_u(m4, y5.z, cost_v2.z) };
        let e_24 = cost_v2.x;
        let first_26 = eq_u(e_24, splat_u(0u32));
        let e_27 = cell_v0;
        if none(ex) { break 'l1; }
        let e_28 = whole_cell(r, ex, e_27);
        let heights_30 = height_cell(r, ex, e_28, path_a0.level);
        let e_31 = cost_v2;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_31.x, splat_u(1u32)), y: add_u(e_31.y, splat_u(0u32)), z: add_u(e_31.z, splat_u(16u32)) });
        cost_v2 = Vec3 { x: sel_u(m6, y7.x, cost_v2.x), y: sel_u(m6, y7.y, cost_v2.y), z: sel_u(m6, y7.z, cost_v2.z) };
        let e_34 = cell_v0;
        let leave_35 = cell_leave(r, &grid_2, e_34);
        let end_40 = min(min(leave_35.x, leave_35.y), path_a0.exit);
        let e_41 = t_v1;
        let span_44 = max_with(sub(end_40, e_41), splat(0.0f32));
        let top_51 = max(max(heights_30.x, heights_30.y), max(heights_30.z, heights_30.w));
        let e_52 = t_v1;
        let e_53 = path_height(r, path_a0, e_52);
        let e_55 = t_v1;
        let e_56 = path_slope(r, path_a0, e_55);
        let above_59 = Vec3 { x: sub(e_53, top_51), y: e_56, z: path_a0.h.z };
        let e_63 = t_v1;
        let e_67 = t_v1;
        let of_heights_76 = mul(splat(9.536743e-7f32), add(abs(path_a0.h.x), mul(e_63, add(abs(path_a0.h.y), mul(e_67, abs(path_a0.h.z))))));
        let e_77 = t_v1;
        next_v3 = max(e_77, end_40);
        slope_v4 = splat((-1.0f32));
        let e_82 = least_at(r, ex, above_59, span_44);
        let e_83 = quadratic(r, above_59, e_82);
        both_v5 = and(gt(e_83, of_heights_76), gt(above_59.x, of_heights_76));
        let e_90 = both_v5;
        let (b8, c9) = (ex, e_90);
        ex = and(b8, c9);
        if any(ex) {
            let (b10, c11) = (ex, lt(end_40, path_a0.exit));
            ex = and(b10, c11);
            if any(ex) {
                let e_93 = cell_v0;
                let e_94 = whole_cell(r, ex, e_93);
                let e_95 = frustum_slope(r, ex, path_a0, e_94, forward_7);
                slope_v4 = sel(ex, e_95, slope_v4);
                let e_96 = slope_v4;
                let (b12, c13) = (ex, ge(e_96, splat(0.0f32)));
                ex = and(b12, c13);
                if any(ex) {
                    let e_99 = cost_v2;
                    let e_101 = map_read(r, path_a0, splat_u(1u32));
                    let (m14, y15) = (ex, Vec3 { x: add_u(e_99.x, e_101.x), y: add_u(e_99.y, e_101.y), z: add_u(e_99.z, e_101.z) });
                    cost_v2 = Vec3 { x: sel_u(m14, y15.x, cost_v2.x), y: sel_u(m14, y15.y, cost_v2.y), z: sel_u(m14, y15.z, cost_v2.z) };
                }
                ex = b12;
            }
            ex = b10;
        }
        ex = and_not(b8, c9);
        if any(ex) {
            let e_103 = cell_v0;
            let e_104 = t_v1;
            let c_105 = gap_to(r, path_a0, &grid_2, e_103, heights_30, e_104);
            let e_106 = falls_in_cell(r, ex, c_105, span_44);
            let (b16, c17) = (ex, e_106);
            ex = and(b16, c17);
            if any(ex) {
                let e_107 = t_v1;
                let e_108 = cost_v2;
                let e_109 = found_in_cell(r, ex, c_105, e_107, span_44, first_26, e_108);
                ret = sel_search_result(ex, &e_109, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b16, c17);
        }
        ex = or(ex, and(b8, c9));
        let e_110 = slope_v4;
        if none(ex) { break 'l1; }
        let (b18, c19) = (ex, ge(e_110, splat(0.0f32)));
        ex = and(b18, c19);
        if any(ex) {
            let e_114 = cell_v0;
            let e_117 = t_v1;
            let at_119 = Vec2 { x: add(sub(grid_2.origin.x, e_114.x), mul(grid_2.step.x, e_117)), y: add(sub(grid_2.origin.y, e_114.y), mul(grid_2.step.y, e_117)) };
            let left_124 = Vec2 { x: sel(forward_7.x, sub(splat(1.0f32), at_119.x), at_119.x), y: sel(forward_7.y, sub(splat(1.0f32), at_119.y), at_119.y) };
            let e_129 = t_v1;
            let far_135 = Vec2 { x: add(add(abs(grid_2.origin.x), mul(abs(grid_2.step.x), e_129)), splat(1.0f32)), y: add(add(abs(grid_2.origin.y), mul(abs(grid_2.step.y), e_129)), splat(1.0f32)) };
            let e_137 = slope_v4;
            let e_139 = mul(splat(9.536743e-7f32), e_137);
            let lost_141 = Vec2 { x: add(of_heights_76, mul(e_139, far_135.x)), y: add(of_heights_76, mul(e_139, far_135.y)) };
            let e_143 = t_v1;
            let rest_144 = sub(path_a0.exit, e_143);
            let e_145 = slope_v4;
            let u_150 = stays_above(r, ex, above_59, e_145, left_124.x, grid_2.step.x, lost_141.x, rest_144);
            let e_151 = slope_v4;
            let v_156 = stays_above(r, ex, above_59, e_151, left_124.y, grid_2.step.y, lost_141.y, rest_144);
            let e_157 = next_v3;
            let e_158 = t_v1;
            next_v3 = sel(ex, max(e_157, add(e_158, min(u_150, v_156))), next_v3);
        }
        ex = b18;
        let e_162 = next_v3;
        let (b20, c21) = (ex, ge(e_162, path_a0.exit));
        ex = and(b20, c21);
        if any(ex) {
            let e_166 = t_v1;
            let e_168 = cost_v2;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_166, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_168, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b20, c21);
        let e_172 = slope_v4;
        if none(ex) { break 'l1; }
        let (b22, c23) = (ex, ge(e_172, splat(0.0f32)));
        ex = and(b22, c23);
        if any(ex) {
            let e_175 = cell_v0;
            let e_176 = next_v3;
            let e_177 = cell_after(r, &grid_2, e_175, leave_35, forward_7, e_176);
            let (m24, y25) = (ex, e_177);
            cell_v0 = Vec2 { x: sel(m24, y25.x, cell_v0.x), y: sel(m24, y25.y, cell_v0.y) };
        }
        ex = and_not(b22, c23);
        if any(ex) {
            let e_178 = cell_v0;
            let e_179 = cell_next(r, ex, &grid_2, e_178, leave_35);
            let (m26, y27) = (ex, e_179);
            cell_v0 = Vec2 { x: sel(m26, y27.x, cell_v0.x), y: sel(m26, y27.y, cell_v0.y) };
        }
        ex = b22;
        let e_180 = next_v3;
        t_v1 = sel(ex, e_180, t_v1);
    }
    ex = and(b2, alive);
    let e_182 = t_v1;
    let e_184 = cost_v2;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_182, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_184, }, &ret);
} }
lanes! { fn nearest_corner(r: &Resources<'_>, at_a0: Vec2<F>) -> Vec2<F> {
    return Vec2 { x: sel(ge(at_a0.x, splat(0.5f32)), splat(1.0f32), splat(0.0f32)), y: sel(ge(at_a0.y, splat(0.5f32)), splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn stays_inside(r: &Resources<'_>, within: M, path_a0: &Path, grid_a1: &Grid, offset_a2: Vec2<F>, apex_a3: F, slope_a4: F, t_a5: F) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut most_v0: F = splat(0f32);
    let mut both_v1: M = splat_m(false);
    let mut leave_v2: F = splat(3e38f32);
    let rest_7 = sub(path_a0.exit, t_a5);
    let e_8 = path_height(r, path_a0, t_a5);
    let height_9 = sub(e_8, apex_a3);
    let terms_20 = add(abs(path_a0.h.y), mul(mul(splat(2.0f32), path_a0.exit), abs(path_a0.h.z)));
    let e_21 = path_slope(r, path_a0, t_a5);
    let rise_30 = sub(add(e_21, mul(min_with(path_a0.h.z, splat(0.0f32)), rest_7)), mul(splat(9.536743e-7f32), terms_20));
    most_v0 = rest_7;
    let c1 = lt(rise_30, splat(0.0f32));
    let e_34 = most_v0;
    most_v0 = sel(c1, min(e_34, div(height_9, sub(splat(0.0f32), rise_30))), most_v0);
    let e_39 = most_v0;
    let end_40 = add(t_a5, e_39);
    let e_52 = r.height_size(path_a0.level);
    let far_53 = Vec2 { x: div(add(add(abs(grid_a1.origin.x), mul(abs(grid_a1.step.x), end_40)), splat(1.0f32)), splat(e_52.x)), y: div(add(add(abs(grid_a1.origin.y), mul(abs(grid_a1.step.y), end_40)), splat(1.0f32)), splat(e_52.y)) };
    let of_heights_68 = mul(splat(9.536743e-7f32), add(abs(path_a0.h.x), mul(end_40, add(abs(path_a0.h.y), mul(end_40, abs(path_a0.h.z))))));
    let lost_75 = add(of_heights_68, mul(mul(splat(9.536743e-7f32), slope_a4), add(far_53.x, far_53.y)));
    let gap_78 = sub(height_9, mul(splat(2.0f32), lost_75));
    let e_85 = r.height_size(path_a0.level);
    let aside_86 = Vec2 { x: div(add(sub(grid_a1.origin.x, offset_a2.x), mul(grid_a1.step.x, t_a5)), splat(e_85.x)), y: div(add(sub(grid_a1.origin.y, offset_a2.y), mul(grid_a1.step.y, t_a5)), splat(e_85.y)) };
    let c_93 = mul(sub(mul(slope_a4, sqrt(add(mul(aside_86.x, aside_86.x), mul(aside_86.y, aside_86.y)))), gap_78), add(mul(slope_a4, sqrt(add(mul(aside_86.x, aside_86.x), mul(aside_86.y, aside_86.y)))), gap_78));
    both_v1 = or(le(gap_78, splat(0.0f32)), ge(c_93, splat(0.0f32)));
    let e_102 = both_v1;
    let c2 = e_102;
    ret = splat(0.0f32);
    ex = and_not(ex, c2);
    let b_109 = sub(mul(mul(slope_a4, slope_a4), add(add(mul(aside_86.x, path_a0.duv.x), mul(aside_86.y, path_a0.duv.y)), splat(0.0f32))), mul(gap_78, rise_30));
    let a_116 = sub(mul(mul(slope_a4, slope_a4), add(add(mul(path_a0.duv.x, path_a0.duv.x), mul(path_a0.duv.y, path_a0.duv.y)), splat(0.0f32))), mul(rise_30, rise_30));
    let discriminant_119 = sub(mul(b_109, b_109), mul(a_116, c_93));
    if none(ex) { return ret; }
    let (b3, c4) = (ex, ge(discriminant_119, splat(0.0f32)));
    ex = and(b3, c4);
    if any(ex) {
        let root_124 = sqrt(discriminant_119);
        let c5 = ge(b_109, splat(0.0f32));
        leave_v2 = sel(and(ex, c5), div(sub(splat(0.0f32), c_93), add(b_109, root_124)), leave_v2);
        let c6 = gt(a_116, splat(0.0f32));
        leave_v2 = sel(and(ex, and(not(c5), c6)), div(sub(root_124, b_109), a_116), leave_v2);
    }
    ex = b3;
    let e_135 = leave_v2;
    let e_136 = most_v0;
    leave_v2 = min(e_135, e_136);
    let e_139 = leave_v2;
    let e_145 = leave_v2;
    let e_141 = Vec2 { x: add(aside_86.x, mul(path_a0.duv.x, e_139)), y: add(aside_86.y, mul(path_a0.duv.y, e_139)) };
    let c7 = le(add(mul(slope_a4, sqrt(add(mul(e_141.x, e_141.x), mul(e_141.y, e_141.y)))), lost_75), add(height_9, mul(rise_30, e_145)));
    let e_149 = leave_v2;
    ret = sel(and(ex, c7), e_149, ret);
    ex = and_not(ex, c7);
    return sel(ex, splat(0.0f32), ret);
} }
stage! { fn search_cone(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut next_v3: F = splat(0f32);
    let grid_2 = grid_of(r, path_a0);
    let forward_7 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let e_9 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_9;
    let limit_16 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_18 = cost_v2.x;
        let c3 = lt_u(e_18, splat_u(limit_16));
        ex = and(ex, c3);
        let e_20 = cost_v2;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_20.x, splat_u(0u32)), y: add_u(e_20.y, splat_u(1u32)), z: add_u(e_20.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m4, y5.x, cost_v2.x), y: sel_u(m4, y5.y, cost_v2.y), z: sel_u(m4, y5.z, cost_v2.z) };
        let e_24 = cost_v2.x;
        let first_26 = eq_u(e_24, splat_u(0u32));
        let e_27 = cell_v0;
        if none(ex) { break 'l1; }
        let e_28 = whole_cell(r, ex, e_27);
        let heights_30 = height_cell(r, ex, e_28, path_a0.level);
        let e_31 = cost_v2;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_31.x, splat_u(1u32)), y: add_u(e_31.y, splat_u(0u32)), z: add_u(e_31.z, splat_u(16u32)) });
        cost_v2 = Vec3 { x: sel_u(m6, y7.x, cost_v2.x), y: sel_u(m6, y7.y, cost_v2.y), z: sel_u(m6, y7.z, cost_v2.z) };
        let e_34 = cell_v0;
        let leave_35 = cell_leave(r, &grid_2, e_34);
        let end_40 = min(min(leave_35.x, leave_35.y), path_a0.exit);
        let e_41 = t_v1;
        let span_44 = max_with(sub(end_40, e_41), splat(0.0f32));
        let e_46 = cell_v0;
        let e_49 = t_v1;
        let at_51 = Vec2 { x: add(sub(grid_2.origin.x, e_46.x), mul(grid_2.step.x, e_49)), y: add(sub(grid_2.origin.y, e_46.y), mul(grid_2.step.y, e_49)) };
        let corner_52 = nearest_corner(r, at_51);
        let apex_53 = corner_height(r, heights_30, corner_52);
        let e_54 = t_v1;
        next_v3 = e_54;
        let e_56 = t_v1;
        let e_57 = path_height(r, path_a0, e_56);
        let (b8, c9) = (ex, gt(e_57, apex_53));
        ex = and(b8, c9);
        if any(ex) {
            let e_59 = cell_v0;
            let texel_60 = Vec2 { x: add(e_59.x, corner_52.x), y: add(e_59.y, corner_52.y) };
            let slope_61 = cone_slope(r, ex, path_a0, texel_60);
            let e_62 = cost_v2;
            let e_64 = map_read(r, path_a0, splat_u(1u32));
            let (m10, y11) = (ex, Vec3 { x: add_u(e_62.x, e_64.x), y: add_u(e_62.y, e_64.y), z: add_u(e_62.z, e_64.z) });
            cost_v2 = Vec3 { x: sel_u(m10, y11.x, cost_v2.x), y: sel_u(m10, y11.y, cost_v2.y), z: sel_u(m10, y11.z, cost_v2.z) };
            let (b12, c13) = (ex, ge(slope_61, splat(0.0f32)));
            ex = and(b12, c13);
            if any(ex) {
                let e_68 = t_v1;
                let e_69 = t_v1;
                let e_70 = stays_inside(r, ex, path_a0, &grid_2, texel_60, apex_53, slope_61, e_69);
                next_v3 = sel(ex, add(e_68, e_70), next_v3);
            }
            ex = b12;
        }
        ex = b8;
        let e_72 = next_v3;
        let (b14, c15) = (ex, lt(e_72, end_40));
        ex = and(b14, c15);
        if any(ex) {
            let e_74 = cell_v0;
            let e_75 = t_v1;
            let c_76 = gap_to(r, path_a0, &grid_2, e_74, heights_30, e_75);
            let e_77 = falls_in_cell(r, ex, c_76, span_44);
            let (b16, c17) = (ex, e_77);
            ex = and(b16, c17);
            if any(ex) {
                let e_78 = t_v1;
                let e_79 = cost_v2;
                let e_80 = found_in_cell(r, ex, c_76, e_78, span_44, first_26, e_79);
                ret = sel_search_result(ex, &e_80, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b16, c17);
            let e_81 = t_v1;
            next_v3 = sel(ex, max(e_81, end_40), next_v3);
        }
        let x18 = ex;
        ex = and_not(b14, c15);
        ex = or(ex, x18);
        let e_83 = next_v3;
        if none(ex) { break 'l1; }
        let (b19, c20) = (ex, ge(e_83, path_a0.exit));
        ex = and(b19, c20);
        if any(ex) {
            let e_87 = t_v1;
            let e_89 = cost_v2;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_87, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_89, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b19, c20);
        let e_93 = cell_v0;
        let e_94 = next_v3;
        if none(ex) { break 'l1; }
        let e_95 = cell_after(r, &grid_2, e_93, leave_35, forward_7, e_94);
        cell_v0 = e_95;
        let e_96 = next_v3;
        t_v1 = sel(ex, e_96, t_v1);
    }
    ex = and(b2, alive);
    let e_98 = t_v1;
    let e_100 = cost_v2;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_98, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_100, }, &ret);
} }
lanes! { fn node_extent(r: &Resources<'_>, within: M, cell_a0: I, image_a1: Vec2<I>, n_a2: i32, level_a3: U) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut both_v0: M = splat_m(false);
    let first_6 = shl_i(shr_i(image_a1.x, level_a3), level_a3);
    let side_8 = shl_i(splat_i(1i32), level_a3);
    let c1 = eq_i(image_a1.y, splat_i(0i32));
    let low_14 = sub_i(cell_a0, sub_i(image_a1.x, first_6));
    ret = Vec2 { x: low_14, y: add_i(low_14, min_i(side_8, sub_i(splat_i(n_a2), first_6))) };
    ex = and_not(ex, c1);
    let c2 = eq_i(image_a1.y, splat_i(1i32));
    let high_26 = add_i(add_i(cell_a0, sub_i(image_a1.x, first_6)), splat_i(1i32));
    let y3 = Vec2 { x: sub_i(high_26, min_i(side_8, sub_i(splat_i(n_a2.wrapping_sub(1i32)), first_6))), y: high_26 };
    ret = Vec2 { x: sel_i(and(ex, c2), y3.x, ret.x), y: sel_i(and(ex, c2), y3.y, ret.y) };
    ex = and_not(ex, c2);
    both_v0 = and(gt_u(level_a3, splat_u(0u32)), splat_m((r.surface_settings.wrap == 1u32)));
    let e_43 = both_v0;
    let c4 = e_43;
    let y5 = Vec2 { x: sel_i(ge_i(cell_a0, splat_i(n_a2)), splat_i(n_a2), splat_i((-1073741824i32))), y: sel_i(ge_i(cell_a0, splat_i(n_a2)), splat_i(1073741824i32), splat_i(0i32)) };
    ret = Vec2 { x: sel_i(and(ex, c4), y5.x, ret.x), y: sel_i(and(ex, c4), y5.y, ret.y) };
    ex = and_not(ex, c4);
    let y6 = Vec2 { x: cell_a0, y: add_i(cell_a0, splat_i(1i32)) };
    return Vec2 { x: sel_i(ex, y6.x, ret.x), y: sel_i(ex, y6.y, ret.y) };
} }
lanes! { fn leaves_extent(r: &Resources<'_>, within: M, origin_a0: F, step_a1: F, extent_a2: Vec2<I>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let c1 = gt(step_a1, splat(0.0f32));
    ret = div(sub(f_of_i(extent_a2.y), origin_a0), step_a1);
    ex = and_not(ex, c1);
    let c2 = lt(step_a1, splat(0.0f32));
    ret = sel(and(ex, c2), div(sub(f_of_i(extent_a2.x), origin_a0), step_a1), ret);
    ex = and_not(ex, c2);
    return sel(ex, splat(3e38f32), ret);
} }
stage! { fn search_pyramid(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut top_v0: u32 = 0u32;
    let mut level_v1: U = splat_u(0u32);
    let mut cell_v2: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut parent_v3: Vec2<I> = Vec2 { x: splat_i((-1i32)), y: splat_i((-1i32)) };
    let mut t_v4: F = splat(0.0f32);
    let mut cost_v5: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v6: M = splat_m(false);
    let mut both_v7: M = splat_m(false);
    let mut both_v8: M = splat_m(false);
    let grid_2 = grid_of(r, path_a0);
    let n_4 = r.height_texels(path_a0.level);
    let long_13 = mul(max(abs(grid_2.step.x), abs(grid_2.step.y)), path_a0.exit);
    'l1: loop {
        let e_18 = top_v0;
        if (1i32.unbounded_shl(e_18) < n_4.x.max(n_4.y)) {
        } else {
            break 'l1;
        }
        let e_25 = top_v0;
        top_v0 = e_25.wrapping_add(1u32);
        let e_28 = level_v1;
        let c2 = lt(f_of_i(shl_i(splat_i(1i32), e_28)), long_13);
        let e_33 = level_v1;
        level_v1 = sel_u(c2, add_u(e_33, splat_u(1u32)), level_v1);
    }
    let e_37 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v2 = Vec2 { x: i_of_small(e_37.x), y: i_of_small(e_37.y) };
    let limit_49 = (params_a1.x as u32);
    let b5 = ex;
    let mut live6 = ex;
    'l3: loop {
        't4: {
            let e_51 = cost_v5.x;
            let c7 = lt_u(e_51, splat_u(limit_49));
            live6 = and_not(live6, and_not(ex, c7));
            ex = and(ex, c7);
            let e_53 = cost_v5;
            let (m8, y9) = (ex, Vec3 { x: add_u(e_53.x, splat_u(0u32)), y: add_u(e_53.y, splat_u(1u32)), z: add_u(e_53.z, splat_u(0u32)) });
            cost_v5 = Vec3 { x: sel_u(m8, y9.x, cost_v5.x), y: sel_u(m8, y9.y, cost_v5.y), z: sel_u(m8, y9.z, cost_v5.z) };
            let e_57 = cell_v2.x;
            if none(ex) { break 't4; }
            let u_59 = image_of(r, ex, e_57, n_4.x);
            let e_61 = cell_v2.y;
            let v_63 = image_of(r, ex, e_61, n_4.y);
            let place_66 = Vec2 { x: u_59.x, y: v_63.x };
            let e_67 = level_v1;
            let above_level_69 = add_u(e_67, splat_u(1u32));
            let over_74 = Vec2 { x: shr_i(place_66.x, above_level_69), y: shr_i(place_66.y, above_level_69) };
            let e_76 = parent_v3.x;
            let e_82 = parent_v3.x;
            let e_89 = parent_v3.y;
            both_v7 = or(ne_i(e_82, over_74.x), ne_i(e_89, over_74.y));
            let e_93 = both_v7;
            both_v6 = and(ge_i(e_76, splat_i(0i32)), e_93);
            let left_95 = both_v6;
            let e_98 = level_v1;
            let e_99 = top_v0;
            both_v8 = and(left_95, lt_u(e_98, splat_u(e_99)));
            let e_102 = both_v8;
            let c10 = e_102;
            level_v1 = sel_u(and(ex, c10), above_level_69, level_v1);
            let e_104 = cell_v2.x;
            let e_106 = level_v1;
            let columns_107 = node_extent(r, ex, e_104, u_59, n_4.x, e_106);
            let e_109 = cell_v2.y;
            let e_111 = level_v1;
            let rows_112 = node_extent(r, ex, e_109, v_63, n_4.y, e_111);
            let leave_u_117 = leaves_extent(r, ex, grid_2.origin.x, grid_2.step.x, columns_107);
            let leave_v_122 = leaves_extent(r, ex, grid_2.origin.y, grid_2.step.y, rows_112);
            let end_125 = min(min(leave_u_117, leave_v_122), path_a0.exit);
            let e_126 = t_v4;
            let span_129 = max_with(sub(end_125, e_126), splat(0.0f32));
            let low_132 = Vec2 { x: columns_107.x, y: rows_112.x };
            let last_139 = Vec2 { x: sub_i(columns_107.y, splat_i(1i32)), y: sub_i(rows_112.y, splat_i(1i32)) };
            let e_140 = level_v1;
            let (b11, c12) = (ex, eq_u(e_140, splat_u(0u32)));
            ex = and(b11, c12);
            if any(ex) {
                let e_143 = cost_v5;
                let (m13, y14) = (ex, Vec3 { x: add_u(e_143.x, splat_u(1u32)), y: add_u(e_143.y, splat_u(0u32)), z: add_u(e_143.z, splat_u(16u32)) });
                cost_v5 = Vec3 { x: sel_u(m13, y14.x, cost_v5.x), y: sel_u(m13, y14.y, cost_v5.y), z: sel_u(m13, y14.z, cost_v5.z) };
                let e_146 = cell_v2;
                let e_148 = cell_v2;
                let e_150 = object_cell_stage(r, ex, e_148, path_a0.level);
                let e_151 = t_v4;
                let c_152 = gap_to(r, path_a0, &grid_2, Vec2 { x: f_of_i(e_146.x), y: f_of_i(e_146.y) }, e_150, e_151);
                let e_153 = falls_in_cell(r, ex, c_152, span_129);
                let (b15, c16) = (ex, e_153);
                ex = and(b15, c16);
                if any(ex) {
                    let e_154 = t_v4;
                    let e_155 = t_v4;
                    let e_158 = cost_v5;
                    let e_159 = found_in_cell(r, ex, c_152, e_154, span_129, eq(e_155, splat(0.0f32)), e_158);
                    ret = sel_search_result(ex, &e_159, &ret);
                    alive = and_not(alive, ex);
                    live6 = and_not(live6, ex);
                    ex = no_lane();
                }
                ex = and_not(b15, c16);
            }
            let x17 = ex;
            ex = and_not(b11, c12);
            if any(ex) {
                let e_160 = cost_v5;
                let e_162 = map_read(r, path_a0, splat_u(1u32));
                let (m18, y19) = (ex, Vec3 { x: add_u(e_160.x, e_162.x), y: add_u(e_160.y, e_162.y), z: add_u(e_160.z, e_162.z) });
                cost_v5 = Vec3 { x: sel_u(m18, y19.x, cost_v5.x), y: sel_u(m18, y19.y, cost_v5.y), z: sel_u(m18, y19.z, cost_v5.z) };
                let e_165 = level_v1;
                let e_168 = level_v1;
                let node_170 = Vec2 { x: shr_i(place_66.x, e_165), y: shr_i(place_66.y, e_168) };
                let e_172 = level_v1;
                let e_178 = search_texel_llsl(r, ex, path_a0, node_170, 0i32, sub_i(i_of_u(add_u(e_172, splat_u(path_a0.level))), splat_i(1i32)));
                let e_180 = t_v4;
                let furthest_181 = add(e_180, span_129);
                let rounded_194 = add(abs(path_a0.h.x), mul(furthest_181, add(abs(path_a0.h.y), mul(furthest_181, abs(path_a0.h.z)))));
                let e_195 = t_v4;
                let e_196 = path_height(r, path_a0, e_195);
                let e_201 = t_v4;
                let e_202 = path_slope(r, path_a0, e_201);
                let gap_205 = Vec3 { x: sub(sub(e_196, e_178.y), mul(splat(9.536743e-7f32), rounded_194)), y: e_202, z: path_a0.h.z };
                let e_206 = falls_in_cell(r, ex, gap_205, span_129);
                let (b20, c21) = (ex, e_206);
                ex = and(b20, c21);
                if any(ex) {
                    let (b22, c23) = (ex, gt(gap_205.x, splat(0.0f32)));
                    ex = and(b22, c23);
                    if any(ex) {
                        let e_210 = t_v4;
                        let e_211 = first_root(r, ex, gap_205, span_129);
                        t_v4 = sel(ex, add(e_210, min(e_211, span_129)), t_v4);
                    }
                    ex = b22;
                    let e_216 = t_v4;
                    let e_219 = cell_of(r, Vec2 { x: add(grid_2.origin.x, mul(grid_2.step.x, e_216)), y: add(grid_2.origin.y, mul(grid_2.step.y, e_216)) });
                    let (m24, y25) = (ex, Vec2 { x: min_i(max_i(i_of_small(e_219.x), low_132.x), last_139.x), y: min_i(max_i(i_of_small(e_219.y), low_132.y), last_139.y) });
                    cell_v2 = Vec2 { x: sel_i(m24, y25.x, cell_v2.x), y: sel_i(m24, y25.y, cell_v2.y) };
                    let e_222 = level_v1;
                    level_v1 = sel_u(ex, sub_u(e_222, splat_u(1u32)), level_v1);
                    let (m26, y27) = (ex, Vec2 { x: splat_i((-1i32)), y: splat_i((-1i32)) });
                    parent_v3 = Vec2 { x: sel_i(m26, y27.x, parent_v3.x), y: sel_i(m26, y27.y, parent_v3.y) };
                    ex = no_lane();
                }
                ex = and_not(b20, c21);
            }
            ex = or(ex, x17);
            if none(ex) { break 't4; }
            let (b28, c29) = (ex, ge(end_125, path_a0.exit));
            ex = and(b28, c29);
            if any(ex) {
                let e_231 = t_v4;
                let e_233 = cost_v5;
                ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_231, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_233, }, &ret);
                alive = and_not(alive, ex);
                live6 = and_not(live6, ex);
                ex = no_lane();
            }
            ex = and_not(b28, c29);
            if none(ex) { break 't4; }
            let e_241 = cell_of(r, Vec2 { x: add(grid_2.origin.x, mul(grid_2.step.x, end_125)), y: add(grid_2.origin.y, mul(grid_2.step.y, end_125)) });
            let (m30, y31) = (ex, Vec2 { x: min_i(max_i(i_of_small(e_241.x), low_132.x), last_139.x), y: min_i(max_i(i_of_small(e_241.y), low_132.y), last_139.y) });
            cell_v2 = Vec2 { x: sel_i(m30, y31.x, cell_v2.x), y: sel_i(m30, y31.y, cell_v2.y) };
            let c32 = le(leave_u_117, end_125);
            cell_v2.x = sel_i(and(ex, c32), sel_i(gt(grid_2.step.x, splat(0.0f32)), columns_107.y, sub_i(low_132.x, splat_i(1i32))), cell_v2.x);
            let c33 = le(leave_v_122, end_125);
            cell_v2.y = sel_i(and(ex, c33), sel_i(gt(grid_2.step.y, splat(0.0f32)), rows_112.y, sub_i(low_132.y, splat_i(1i32))), cell_v2.y);
            let e_267 = level_v1;
            let e_272 = level_v1;
            let (m34, y35) = (ex, Vec2 { x: shr_i(place_66.x, add_u(e_267, splat_u(1u32))), y: shr_i(place_66.y, add_u(e_272, splat_u(1u32))) });
            parent_v3 = Vec2 { x: sel_i(m34, y35.x, parent_v3.x), y: sel_i(m34, y35.y, parent_v3.y) };
            let e_277 = t_v4;
            t_v4 = sel(ex, max(e_277, end_125), t_v4);
        }
        ex = live6;
        if none(ex) { break 'l3; }
    }
    ex = and(b5, alive);
    let e_280 = t_v4;
    let e_282 = cost_v5;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_280, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_282, }, &ret);
} }
lanes! { fn texel_extent(r: &Resources<'_>, within: M, texel_a0: I, n_a1: i32, level_a2: U) -> Vec2<I> {
    let mut ex = within;
    let mut ret: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut both_v0: M = splat_m(false);
    let place_3 = wrap_index(r, ex, texel_a0, n_a1);
    let first_5 = shl_i(shr_i(place_3, level_a2), level_a2);
    let last_9 = min_i(add_i(first_5, shl_i(splat_i(1i32), level_a2)), splat_i(n_a1));
    both_v0 = or(eq_i(texel_a0, place_3), splat_m((r.surface_settings.wrap == 0u32)));
    let e_20 = both_v0;
    let c1 = e_20;
    ret = Vec2 { x: add_i(sub_i(texel_a0, place_3), first_5), y: add_i(sub_i(texel_a0, place_3), last_9) };
    ex = and_not(ex, c1);
    if (r.surface_settings.wrap == 2u32) {
        let period_32 = 2i32.wrapping_mul(n_a1);
        if none(ex) { return ret; }
        let folded_35 = rem_i(add_i(rem_i(texel_a0, splat_i(period_32)), splat_i(period_32)), splat_i(period_32));
        let c2 = lt_i(folded_35, splat_i(n_a1));
        let y3 = Vec2 { x: add_i(sub_i(texel_a0, place_3), first_5), y: add_i(sub_i(texel_a0, place_3), last_9) };
        ret = Vec2 { x: sel_i(and(ex, c2), y3.x, ret.x), y: sel_i(and(ex, c2), y3.y, ret.y) };
        ex = and_not(ex, c2);
        let y4 = Vec2 { x: add_i(sub_i(add_i(texel_a0, place_3), last_9), splat_i(1i32)), y: add_i(sub_i(add_i(texel_a0, place_3), first_5), splat_i(1i32)) };
        return Vec2 { x: sel_i(ex, y4.x, ret.x), y: sel_i(ex, y4.y, ret.y) };
    }
    let y5 = Vec2 { x: texel_a0, y: add_i(texel_a0, splat_i(1i32)) };
    return Vec2 { x: sel_i(ex, y5.x, ret.x), y: sel_i(ex, y5.y, ret.y) };
} }
stage! { fn search_pyramid_texels(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut level_v0: U = splat_u(0u32);
    let mut texel_v1: Vec2<I> = Vec2 { x: splat_i(0i32), y: splat_i(0i32) };
    let mut t_v2: F = splat(0.0f32);
    let mut cost_v3: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut finest_v4: U = splat_u(0u32);
    let mut highest_v5: F = splat(0f32);
    let mut sinks_v6: F = splat(0f32);
    let n_3 = r.height_texels(path_a0.level);
    let e_6 = r.height_size(path_a0.level);
    let origin_7 = Vec2 { x: mul(path_a0.uv.x, splat(e_6.x)), y: mul(path_a0.uv.y, splat(e_6.y)) };
    let e_10 = r.height_size(path_a0.level);
    let step_11 = Vec2 { x: mul(path_a0.duv.x, splat(e_10.x)), y: mul(path_a0.duv.y, splat(e_10.y)) };
    let b2 = ex;
    'l1: loop {
        let e_14 = level_v0;
        let c3 = lt_i(shl_i(splat_i(1i32), e_14), splat_i(n_3.x.max(n_3.y)));
        ex = and(ex, c3);
        let e_21 = level_v0;
        level_v0 = sel_u(ex, add_u(e_21, splat_u(1u32)), level_v0);
        if none(ex) { break 'l1; }
    }
    ex = b2;
    let e_24 = cell_of(r, origin_7);
    texel_v1 = Vec2 { x: i_of_small(e_24.x), y: i_of_small(e_24.y) };
    let limit_32 = (params_a1.x as u32);
    let e_35 = level_v0;
    finest_v4 = min_u(splat_u((params_a1.y as u32)), e_35);
    if (path_a0.ray == 1u32) {
        finest_v4 = splat_u(0u32);
    }
    let b5 = ex;
    'l4: loop {
        let e_43 = cost_v3.x;
        let c6 = lt_u(e_43, splat_u(limit_32));
        ex = and(ex, c6);
        let e_45 = cost_v3;
        let (m7, y8) = (ex, Vec3 { x: add_u(e_45.x, splat_u(0u32)), y: add_u(e_45.y, splat_u(1u32)), z: add_u(e_45.z, splat_u(0u32)) });
        cost_v3 = Vec3 { x: sel_u(m7, y8.x, cost_v3.x), y: sel_u(m7, y8.y, cost_v3.y), z: sel_u(m7, y8.z, cost_v3.z) };
        let e_49 = texel_v1.x;
        if none(ex) { break 'l4; }
        let e_51 = wrap_index(r, ex, e_49, n_3.x);
        let e_53 = texel_v1.y;
        let e_55 = wrap_index(r, ex, e_53, n_3.y);
        let place_56 = Vec2 { x: e_51, y: e_55 };
        highest_v5 = splat(0.0f32);
        let e_59 = level_v0;
        let (b9, c10) = (ex, eq_u(e_59, splat_u(0u32)));
        ex = and(b9, c10);
        if any(ex) {
            let e_62 = cost_v3;
            let (m11, y12) = (ex, Vec3 { x: add_u(e_62.x, splat_u(1u32)), y: add_u(e_62.y, splat_u(0u32)), z: add_u(e_62.z, splat_u(4u32)) });
            cost_v3 = Vec3 { x: sel_u(m11, y12.x, cost_v3.x), y: sel_u(m11, y12.y, cost_v3.y), z: sel_u(m11, y12.z, cost_v3.z) };
            let e_67 = height_texel(&r.height_map, place_56.x, place_56.y, 0i32);
            highest_v5 = sel(ex, e_67.x, highest_v5);
        }
        ex = and_not(b9, c10);
        if any(ex) {
            let e_70 = level_v0;
            let e_73 = level_v0;
            let node_75 = Vec2 { x: shr_i(place_56.x, e_70), y: shr_i(place_56.y, e_73) };
            let e_76 = cost_v3;
            let e_78 = map_read(r, path_a0, splat_u(1u32));
            let (m13, y14) = (ex, Vec3 { x: add_u(e_76.x, e_78.x), y: add_u(e_76.y, e_78.y), z: add_u(e_76.z, e_78.z) });
            cost_v3 = Vec3 { x: sel_u(m13, y14.x, cost_v3.x), y: sel_u(m13, y14.y, cost_v3.y), z: sel_u(m13, y14.z, cost_v3.z) };
            let e_81 = level_v0;
            let e_85 = search_texel_llsl(r, ex, path_a0, node_75, 0i32, sub_i(i_of_u(e_81), splat_i(1i32)));
            highest_v5 = sel(ex, e_85.y, highest_v5);
        }
        ex = b9;
        let e_88 = texel_v1.x;
        let e_90 = level_v0;
        let columns_91 = texel_extent(r, ex, e_88, n_3.x, e_90);
        let e_93 = texel_v1.y;
        let e_95 = level_v0;
        let rows_96 = texel_extent(r, ex, e_93, n_3.y, e_95);
        let e_99 = leaves_extent(r, ex, origin_7.x, step_11.x, columns_91);
        let e_102 = leaves_extent(r, ex, origin_7.y, step_11.y, rows_96);
        let leave_103 = Vec2 { x: e_99, y: e_102 };
        let e_109 = t_v2;
        let end_110 = max(min(min(leave_103.x, leave_103.y), path_a0.exit), e_109);
        let e_111 = t_v2;
        let e_112 = path_height(r, path_a0, e_111);
        let e_113 = highest_v5;
        let e_115 = t_v2;
        let e_116 = path_slope(r, path_a0, e_115);
        let gap_119 = Vec3 { x: sub(e_112, e_113), y: e_116, z: path_a0.h.z };
        sinks_v6 = splat(0.0f32);
        let (b15, c16) = (ex, gt(gap_119.x, splat(0.0f32)));
        ex = and(b15, c16);
        if any(ex) {
            let e_125 = t_v2;
            let e_127 = first_root(r, ex, gap_119, sub(end_110, e_125));
            sinks_v6 = sel(ex, e_127, sinks_v6);
        }
        ex = b15;
        let low_130 = Vec2 { x: columns_91.x, y: rows_96.x };
        let last_137 = Vec2 { x: sub_i(columns_91.y, splat_i(1i32)), y: sub_i(rows_96.y, splat_i(1i32)) };
        let e_138 = sinks_v6;
        let (b17, c18) = (ex, lt(e_138, splat(3e38f32)));
        ex = and(b17, c18);
        if any(ex) {
            let e_141 = t_v2;
            let e_142 = sinks_v6;
            t_v2 = sel(ex, add(e_141, e_142), t_v2);
            let e_144 = level_v0;
            let e_145 = finest_v4;
            let (b19, c20) = (ex, eq_u(e_144, e_145));
            ex = and(b19, c20);
            if any(ex) {
                let e_148 = t_v2;
                let e_149 = cost_v3;
                ret = sel_search_result(ex, &SearchResult { status: splat_u(2u32), near: splat(0.0f32), far: e_148, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_149, }, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b19, c20);
            let e_154 = level_v0;
            level_v0 = sel_u(ex, sub_u(e_154, splat_u(1u32)), level_v0);
            let e_157 = t_v2;
            let e_160 = cell_of(r, Vec2 { x: add(origin_7.x, mul(step_11.x, e_157)), y: add(origin_7.y, mul(step_11.y, e_157)) });
            let (m21, y22) = (ex, Vec2 { x: min_i(max_i(i_of_small(e_160.x), low_130.x), last_137.x), y: min_i(max_i(i_of_small(e_160.y), low_130.y), last_137.y) });
            texel_v1 = Vec2 { x: sel_i(m21, y22.x, texel_v1.x), y: sel_i(m21, y22.y, texel_v1.y) };
        }
        let x23 = ex;
        ex = and_not(b17, c18);
        if any(ex) {
            let (b24, c25) = (ex, ge(end_110, path_a0.exit));
            ex = and(b24, c25);
            if any(ex) {
                let e_166 = t_v2;
                let e_168 = cost_v3;
                ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_166, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_168, }, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b24, c25);
            let e_174 = cell_of(r, Vec2 { x: add(origin_7.x, mul(step_11.x, end_110)), y: add(origin_7.y, mul(step_11.y, end_110)) });
            let (m26, y27) = (ex, Vec2 { x: min_i(max_i(i_of_small(e_174.x), low_130.x), last_137.x), y: min_i(max_i(i_of_small(e_174.y), low_130.y), last_137.y) });
            texel_v1 = Vec2 { x: sel_i(m26, y27.x, texel_v1.x), y: sel_i(m26, y27.y, texel_v1.y) };
            let c28 = le(leave_103.x, end_110);
            texel_v1.x = sel_i(and(ex, c28), sel_i(gt(step_11.x, splat(0.0f32)), columns_91.y, sub_i(low_130.x, splat_i(1i32))), texel_v1.x);
            let c29 = le(leave_103.y, end_110);
            texel_v1.y = sel_i(and(ex, c29), sel_i(gt(step_11.y, splat(0.0f32)), rows_96.y, sub_i(low_130.y, splat_i(1i32))), texel_v1.y);
            t_v2 = sel(ex, end_110, t_v2);
        }
        ex = or(ex, x23);
        if none(ex) { break 'l4; }
    }
    ex = and(b5, alive);
    let e_200 = t_v2;
    let e_202 = cost_v3;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_200, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_202, }, &ret);
} }
lanes! { fn leaves_window(r: &Resources<'_>, grid_a0: &Grid, cell_a1: Vec2<F>, radius_a2: f32) -> F {
    let wide_3 = Vec2 { x: radius_a2, y: radius_a2 };
    let leave_low_5 = cell_leave(r, grid_a0, Vec2 { x: sub(cell_a1.x, splat(wide_3.x)), y: sub(cell_a1.y, splat(wide_3.y)) });
    let leave_high_7 = cell_leave(r, grid_a0, Vec2 { x: add(cell_a1.x, splat(wide_3.x)), y: add(cell_a1.y, splat(wide_3.y)) });
    let leave_13 = Vec2 { x: sel(gt(grid_a0.step.x, splat(0.0f32)), leave_high_7.x, leave_low_5.x), y: sel(gt(grid_a0.step.y, splat(0.0f32)), leave_high_7.y, leave_low_5.y) };
    return min(leave_13.x, leave_13.y);
} }
stage! { fn search_dilation_erosion(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut safe_v2: F = splat(0.0f32);
    let mut cost_v3: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut next_v4: F = splat(0f32);
    let mut looks_v5: M = splat_m(false);
    let mut both_v6: M = splat_m(false);
    let mut both_v7: M = splat_m(false);
    let mut both_v8: M = splat_m(false);
    let mut both_v9: M = splat_m(false);
    let grid_2 = grid_of(r, path_a0);
    let n_4 = r.height_texels(path_a0.level);
    let forward_9 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let e_11 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_11;
    let limit_20 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_22 = cost_v3.x;
        let c3 = lt_u(e_22, splat_u(limit_20));
        ex = and(ex, c3);
        let e_24 = cost_v3;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_24.x, splat_u(0u32)), y: add_u(e_24.y, splat_u(1u32)), z: add_u(e_24.z, splat_u(0u32)) });
        cost_v3 = Vec3 { x: sel_u(m4, y5.x, cost_v3.x), y: sel_u(m4, y5.y, cost_v3.y), z: sel_u(m4, y5.z, cost_v3.z) };
        let e_27 = cell_v0;
        if none(ex) { break 'l1; }
        let leave_28 = cell_leave(r, &grid_2, e_27);
        let end_33 = min(min(leave_28.x, leave_28.y), path_a0.exit);
        let e_34 = t_v1;
        let span_37 = max_with(sub(end_33, e_34), splat(0.0f32));
        let e_38 = t_v1;
        next_v4 = e_38;
        looks_v5 = splat_m((params_a1.y > 0.5f32));
        let e_44 = cell_v0;
        let place_45 = whole_cell(r, ex, e_44);
        let u_48 = image_of(r, ex, place_45.x, n_4.x);
        let v_51 = image_of(r, ex, place_45.y, n_4.y);
        both_v6 = or(eq_i(u_48.y, splat_i(2i32)), eq_i(v_51.y, splat_i(2i32)));
        let e_62 = both_v6;
        let (b6, c7) = (ex, e_62);
        ex = and(b6, c7);
        if any(ex) {
            looks_v5 = sel_m(ex, splat_m(true), looks_v5);
        }
        ex = and_not(b6, c7);
        if any(ex) {
            let bounds_70 = search_texel_llss(r, path_a0, Vec2 { x: u_48.x, y: v_51.x }, 0i32, (path_a0.level as i32));
            let e_71 = cost_v3;
            let e_73 = map_read(r, path_a0, splat_u(1u32));
            let (m8, y9) = (ex, Vec3 { x: add_u(e_71.x, e_73.x), y: add_u(e_71.y, e_73.y), z: add_u(e_71.z, e_73.z) });
            cost_v3 = Vec3 { x: sel_u(m8, y9.x, cost_v3.x), y: sel_u(m8, y9.y, cost_v3.y), z: sel_u(m8, y9.z, cost_v3.z) };
            let e_75 = cell_v0;
            let e_77 = leaves_window(r, &grid_2, e_75, params_a1.z);
            let e_80 = t_v1;
            let reach_83 = max_with(sub(min(e_77, path_a0.exit), e_80), splat(0.0f32));
            let e_84 = t_v1;
            let furthest_85 = add(e_84, reach_83);
            let rounded_98 = add(abs(path_a0.h.x), mul(furthest_85, add(abs(path_a0.h.y), mul(furthest_85, abs(path_a0.h.z)))));
            let e_99 = t_v1;
            let e_100 = path_height(r, path_a0, e_99);
            let e_106 = t_v1;
            let e_107 = path_slope(r, path_a0, e_106);
            let gap_110 = Vec3 { x: sub(sub(e_100, bounds_70.y), mul(splat(9.536743e-7f32), rounded_98)), y: e_107, z: path_a0.h.z };
            let (b10, c11) = (ex, gt(gap_110.x, splat(0.0f32)));
            ex = and(b10, c11);
            if any(ex) {
                let e_114 = t_v1;
                safe_v2 = sel(ex, e_114, safe_v2);
                let e_115 = t_v1;
                next_v4 = sel(ex, add(e_115, reach_83), next_v4);
                let e_117 = least_at(r, ex, gap_110, reach_83);
                let e_118 = quadratic(r, gap_110, e_117);
                let (b12, c13) = (ex, le(e_118, splat(0.0f32)));
                ex = and(b12, c13);
                if any(ex) {
                    let e_121 = t_v1;
                    let e_122 = first_root(r, ex, gap_110, reach_83);
                    next_v4 = sel(ex, add(e_121, min(e_122, reach_83)), next_v4);
                }
                ex = b12;
            }
            ex = b10;
            let e_125 = looks_v5;
            let e_129 = next_v4;
            both_v7 = and(not(e_125), lt(e_129, end_33));
            let e_132 = both_v7;
            let (b14, c15) = (ex, e_132);
            ex = and(b14, c15);
            if any(ex) {
                let e_135 = path_height(r, path_a0, end_33);
                both_v8 = sel_m(ex, lt(e_135, bounds_70.x), both_v8);
            }
            ex = and_not(b14, c15);
            if any(ex) {
                both_v8 = sel_m(ex, splat_m(false), both_v8);
            }
            ex = b14;
            let e_139 = both_v8;
            let (b16, c17) = (ex, e_139);
            ex = and(b16, c17);
            if any(ex) {
                let e_140 = safe_v2;
                let e_141 = cost_v3;
                let e_142 = bracket_between(r, ex, path_a0, e_140, end_33, e_141);
                ret = sel_search_result(ex, &e_142, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b16, c17);
        }
        ex = or(ex, and(b6, c7));
        let e_143 = next_v4;
        let e_148 = t_v1;
        both_v9 = or(lt(e_143, end_33), not(gt(end_33, e_148)));
        let e_152 = both_v9;
        if none(ex) { break 'l1; }
        let (b18, c19) = (ex, e_152);
        ex = and(b18, c19);
        if any(ex) {
            let e_153 = looks_v5;
            let (b20, c21) = (ex, e_153);
            ex = and(b20, c21);
            if any(ex) {
                let e_154 = cost_v3;
                let (m22, y23) = (ex, Vec3 { x: add_u(e_154.x, splat_u(1u32)), y: add_u(e_154.y, splat_u(0u32)), z: add_u(e_154.z, splat_u(16u32)) });
                cost_v3 = Vec3 { x: sel_u(m22, y23.x, cost_v3.x), y: sel_u(m22, y23.y, cost_v3.y), z: sel_u(m22, y23.z, cost_v3.z) };
                let heights_158 = height_cell(r, ex, place_45, path_a0.level);
                let e_159 = cell_v0;
                let e_160 = t_v1;
                let c_161 = gap_to(r, path_a0, &grid_2, e_159, heights_158, e_160);
                let e_162 = falls_in_cell(r, ex, c_161, span_37);
                let (b24, c25) = (ex, e_162);
                ex = and(b24, c25);
                if any(ex) {
                    let e_163 = t_v1;
                    let e_164 = t_v1;
                    let e_167 = cost_v3;
                    let e_168 = found_in_cell(r, ex, c_161, e_163, span_37, eq(e_164, splat(0.0f32)), e_167);
                    ret = sel_search_result(ex, &e_168, &ret);
                    alive = and_not(alive, ex);
                    ex = no_lane();
                }
                ex = and_not(b24, c25);
            }
            let x26 = ex;
            ex = and_not(b20, c21);
            ex = or(ex, x26);
            let e_169 = t_v1;
            next_v4 = sel(ex, max(e_169, end_33), next_v4);
        }
        let x27 = ex;
        ex = and_not(b18, c19);
        ex = or(ex, x27);
        let e_171 = next_v4;
        if none(ex) { break 'l1; }
        let (b28, c29) = (ex, ge(e_171, path_a0.exit));
        ex = and(b28, c29);
        if any(ex) {
            let e_175 = t_v1;
            let e_177 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_175, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_177, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b28, c29);
        let e_181 = cell_v0;
        let e_182 = next_v4;
        if none(ex) { break 'l1; }
        let e_183 = cell_after(r, &grid_2, e_181, leave_28, forward_9, e_182);
        cell_v0 = e_183;
        let e_184 = next_v4;
        t_v1 = sel(ex, e_184, t_v1);
    }
    ex = and(b2, alive);
    let e_186 = t_v1;
    let e_188 = cost_v3;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_186, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_188, }, &ret);
} }
stage! { fn search_sphere(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut cost_v2: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut next_v3: F = splat(0f32);
    let mut both_v4: M = splat_m(false);
    let grid_2 = grid_of(r, path_a0);
    let forward_7 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let e_9 = path_slope(r, path_a0, splat(0.0f32));
    let e_12 = path_slope(r, path_a0, path_a0.exit);
    let climb_14 = max(abs(e_9), abs(e_12));
    let e_16 = Vec3 { x: path_a0.duv.x, y: path_a0.duv.y, z: climb_14 };
    let fastest_17 = sqrt(add(add(mul(e_16.x, e_16.x), mul(e_16.y, e_16.y)), mul(e_16.z, e_16.z)));
    let speed_20 = add(fastest_17, mul(splat(9.536743e-7f32), fastest_17));
    let far_27 = Vec2 { x: add(abs(path_a0.uv.x), mul(abs(path_a0.duv.x), path_a0.exit)), y: add(abs(path_a0.uv.y), mul(abs(path_a0.duv.y), path_a0.exit)) };
    let height_terms_42 = add(abs(path_a0.h.x), mul(path_a0.exit, add(abs(path_a0.h.y), mul(path_a0.exit, abs(path_a0.h.z)))));
    let lost_50 = mul(splat(9.536743e-7f32), add(add(add(far_27.x, far_27.y), height_terms_42), splat(1.0f32)));
    let e_52 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_52;
    let limit_59 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_61 = cost_v2.x;
        let c3 = lt_u(e_61, splat_u(limit_59));
        ex = and(ex, c3);
        let e_63 = cost_v2;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_63.x, splat_u(0u32)), y: add_u(e_63.y, splat_u(1u32)), z: add_u(e_63.z, splat_u(0u32)) });
        cost_v2 = Vec3 { x: sel_u(m4, y5.x, cost_v2.x), y: sel_u(m4, y5.y, cost_v2.y), z: sel_u(m4, y5.z, cost_v2.z) };
        let e_66 = cell_v0;
        if none(ex) { break 'l1; }
        let leave_67 = cell_leave(r, &grid_2, e_66);
        let end_72 = min(min(leave_67.x, leave_67.y), path_a0.exit);
        let e_73 = t_v1;
        let span_76 = max_with(sub(end_72, e_73), splat(0.0f32));
        let e_77 = t_v1;
        let e_78 = path_uv(r, path_a0, e_77);
        let e_79 = t_v1;
        let e_80 = path_height(r, path_a0, e_79);
        let e_82 = distance_at(r, ex, path_a0, e_78, e_80, params_a1.z);
        let free_83 = sub(e_82, lost_50);
        let e_84 = cost_v2;
        let e_86 = map_read(r, path_a0, splat_u(4u32));
        let e_89 = map_read(r, path_a0, splat_u(4u32));
        let (m6, y7) = (ex, Vec3 { x: add_u(add_u(e_84.x, e_86.x), e_89.x), y: add_u(add_u(e_84.y, e_86.y), e_89.y), z: add_u(add_u(e_84.z, e_86.z), e_89.z) });
        cost_v2 = Vec3 { x: sel_u(m6, y7.x, cost_v2.x), y: sel_u(m6, y7.y, cost_v2.y), z: sel_u(m6, y7.z, cost_v2.z) };
        let e_91 = t_v1;
        next_v3 = e_91;
        let c8 = gt(free_83, splat(0.0f32));
        let e_95 = t_v1;
        next_v3 = sel(c8, add(e_95, div(free_83, speed_20)), next_v3);
        if (params_a1.y < 0.5f32) {
            let e_101 = next_v3;
            let e_102 = t_v1;
            let (b9, c10) = (ex, not(gt(sub(e_101, e_102), mul(splat(9.536743e-7f32), path_a0.exit))));
            ex = and(b9, c10);
            if any(ex) {
                let e_110 = t_v1;
                let e_112 = cost_v2;
                ret = sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: e_110, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_112, }, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b9, c10);
        } else {
            let e_116 = next_v3;
            let e_121 = t_v1;
            both_v4 = or(lt(e_116, end_72), not(gt(end_72, e_121)));
            let e_125 = both_v4;
            let (b11, c12) = (ex, e_125);
            ex = and(b11, c12);
            if any(ex) {
                let e_126 = cost_v2;
                let (m13, y14) = (ex, Vec3 { x: add_u(e_126.x, splat_u(1u32)), y: add_u(e_126.y, splat_u(0u32)), z: add_u(e_126.z, splat_u(16u32)) });
                cost_v2 = Vec3 { x: sel_u(m13, y14.x, cost_v2.x), y: sel_u(m13, y14.y, cost_v2.y), z: sel_u(m13, y14.z, cost_v2.z) };
                let e_129 = cell_v0;
                let e_130 = cell_v0;
                let e_131 = whole_cell(r, ex, e_130);
                let e_133 = height_cell(r, ex, e_131, path_a0.level);
                let e_134 = t_v1;
                let c_135 = gap_to(r, path_a0, &grid_2, e_129, e_133, e_134);
                let e_136 = falls_in_cell(r, ex, c_135, span_76);
                let (b15, c16) = (ex, e_136);
                ex = and(b15, c16);
                if any(ex) {
                    let e_137 = t_v1;
                    let e_138 = t_v1;
                    let e_141 = cost_v2;
                    let e_142 = found_in_cell(r, ex, c_135, e_137, span_76, eq(e_138, splat(0.0f32)), e_141);
                    ret = sel_search_result(ex, &e_142, &ret);
                    alive = and_not(alive, ex);
                    ex = no_lane();
                }
                ex = and_not(b15, c16);
                let e_143 = t_v1;
                next_v3 = sel(ex, max(e_143, end_72), next_v3);
            }
            let x17 = ex;
            ex = and_not(b11, c12);
            ex = or(ex, x17);
        }
        let e_145 = next_v3;
        if none(ex) { break 'l1; }
        let (b18, c19) = (ex, ge(e_145, path_a0.exit));
        ex = and(b18, c19);
        if any(ex) {
            let e_149 = t_v1;
            let e_151 = cost_v2;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_149, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_151, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b18, c19);
        let e_155 = cell_v0;
        let e_156 = next_v3;
        if none(ex) { break 'l1; }
        let e_157 = cell_after(r, &grid_2, e_155, leave_67, forward_7, e_156);
        cell_v0 = e_157;
        let e_158 = next_v3;
        t_v1 = sel(ex, e_158, t_v1);
    }
    ex = and(b2, alive);
    let e_160 = t_v1;
    let e_162 = cost_v2;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_160, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_162, }, &ret);
} }
stage! { fn search_cone_moved(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut t_v0: F = splat(0.0f32);
    let mut near_v1: F = splat(0.0f32);
    let mut near_gap_v2: F = splat(0.0f32);
    let mut cost_v3: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut k_v4: F = splat(0.0f32);
    let mut both_v5: M = splat_m(false);
    let aside_3 = sqrt(add(mul(path_a0.duv.x, path_a0.duv.x), mul(path_a0.duv.y, path_a0.duv.y)));
    let b2 = ex;
    'l1: loop {
        let e_14 = k_v4;
        let c3 = lt(e_14, splat(params_a1.x));
        ex = and(ex, c3);
        let e_17 = cost_v3;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_17.x, splat_u(0u32)), y: add_u(e_17.y, splat_u(1u32)), z: add_u(e_17.z, splat_u(0u32)) });
        cost_v3 = Vec3 { x: sel_u(m4, y5.x, cost_v3.x), y: sel_u(m4, y5.y, cost_v3.y), z: sel_u(m4, y5.z, cost_v3.z) };
        let e_20 = t_v0;
        if none(ex) { break 'l1; }
        let gap_21 = path_gap(r, ex, path_a0, e_20);
        let e_22 = cost_v3;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_22.x, splat_u(1u32)), y: add_u(e_22.y, splat_u(0u32)), z: add_u(e_22.z, splat_u(16u32)) });
        cost_v3 = Vec3 { x: sel_u(m6, y7.x, cost_v3.x), y: sel_u(m6, y7.y, cost_v3.y), z: sel_u(m6, y7.z, cost_v3.z) };
        let (b8, c9) = (ex, le(gap_21, splat(0.0f32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_27 = t_v0;
            both_v5 = and(eq(e_27, splat(0.0f32)), lt(gap_21, splat(0.0f32)));
            let e_35 = both_v5;
            let (b10, c11) = (ex, e_35);
            ex = and(b10, c11);
            if any(ex) {
                let e_37 = cost_v3;
                ret = sel_search_result(ex, &SearchResult { status: splat_u(5u32), near: splat(0.0f32), far: splat(0.0f32), near_gap: gap_21, far_gap: gap_21, cost: e_37, }, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b10, c11);
            let e_42 = near_v1;
            let e_43 = t_v0;
            let e_44 = near_gap_v2;
            let e_45 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: e_42, far: e_43, near_gap: e_44, far_gap: gap_21, cost: e_45, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        let e_47 = t_v0;
        near_v1 = e_47;
        near_gap_v2 = gap_21;
        let e_48 = t_v0;
        if none(ex) { break 'l1; }
        let e_49 = path_uv(r, path_a0, e_48);
        let e_51 = search_texel_between_lls(r, ex, path_a0, e_49, 0i32);
        let slope_53 = slope_of(r, ex, e_51.x);
        let e_54 = cost_v3;
        let e_56 = map_read(r, path_a0, splat_u(4u32));
        let (m12, y13) = (ex, Vec3 { x: add_u(e_54.x, e_56.x), y: add_u(e_54.y, e_56.y), z: add_u(e_54.z, e_56.z) });
        cost_v3 = Vec3 { x: sel_u(m12, y13.x, cost_v3.x), y: sel_u(m12, y13.y, cost_v3.y), z: sel_u(m12, y13.z, cost_v3.z) };
        let c14 = lt(slope_53, splat(0.0f32));
        ex = and_not(ex, c14);
        let e_61 = t_v0;
        let rest_62 = sub(path_a0.exit, e_61);
        let e_63 = t_v0;
        if none(ex) { break 'l1; }
        let e_64 = path_slope(r, path_a0, e_63);
        let rise_70 = add(e_64, mul(min_with(path_a0.h.z, splat(0.0f32)), rest_62));
        let terms_85 = add(abs(path_a0.h.x), mul(path_a0.exit, add(abs(path_a0.h.y), mul(path_a0.exit, abs(path_a0.h.z)))));
        let far_97 = Vec2 { x: mul(add(add(abs(path_a0.uv.x), mul(abs(path_a0.duv.x), path_a0.exit)), splat(1.0f32)), slope_53), y: mul(add(add(abs(path_a0.uv.y), mul(abs(path_a0.duv.y), path_a0.exit)), splat(1.0f32)), slope_53) };
        let lost_103 = mul(splat(9.536743e-7f32), add(add(terms_85, far_97.x), far_97.y));
        let nearing_105 = sub(mul(slope_53, aside_3), rise_70);
        let closing_108 = add(nearing_105, mul(splat(9.536743e-7f32), nearing_105));
        let (b15, c16) = (ex, le(closing_108, splat(0.0f32)));
        ex = and(b15, c16);
        if any(ex) {
            let e_112 = t_v0;
            let e_114 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_112, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_114, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b15, c16);
        let e_118 = t_v0;
        t_v0 = sel(ex, add(e_118, div(max_with(sub(gap_21, lost_103), splat(0.0f32)), closing_108)), t_v0);
        let e_124 = t_v0;
        if none(ex) { break 'l1; }
        let (b17, c18) = (ex, ge(e_124, path_a0.exit));
        ex = and(b17, c18);
        if any(ex) {
            let e_128 = near_v1;
            let e_130 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_128, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_130, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b17, c18);
        let e_134 = k_v4;
        k_v4 = add(e_134, splat(1.0f32));
        if none(ex) { break 'l1; }
    }
    ex = and(b2, alive);
    let e_138 = t_v0;
    let e_140 = t_v0;
    if none(ex) { return ret; }
    let e_141 = path_height(r, path_a0, e_140);
    let e_142 = cost_v3;
    return sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: e_138, far: path_a0.exit, near_gap: e_141, far_gap: splat(0.0f32), cost: e_142, }, &ret);
} }
stage! { fn search_relaxed_cone(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut near_v2: F = splat(0.0f32);
    let mut near_gap_v3: F = splat(0.0f32);
    let mut cost_v4: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v5: M = splat_m(false);
    let mut start_v6: F = splat(0f32);
    let mut gap_v7: F = splat(0f32);
    let mut next_v8: F = splat(0f32);
    let mut both_v9: M = splat_m(false);
    let grid_2 = grid_of(r, path_a0);
    let forward_7 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let aside_9 = sqrt(add(mul(path_a0.duv.x, path_a0.duv.x), mul(path_a0.duv.y, path_a0.duv.y)));
    let rise_11 = path_slope(r, path_a0, splat(0.0f32));
    let terms_20 = add(abs(path_a0.h.x), mul(path_a0.exit, abs(path_a0.h.y)));
    let e_33 = r.height_size(path_a0.level);
    let far_34 = Vec2 { x: div(add(add(abs(grid_2.origin.x), mul(abs(grid_2.step.x), path_a0.exit)), splat(1.0f32)), splat(e_33.x)), y: div(add(add(abs(grid_2.origin.y), mul(abs(grid_2.step.y), path_a0.exit)), splat(1.0f32)), splat(e_33.y)) };
    let e_36 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_36;
    let limit_47 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_49 = cost_v4.x;
        let c3 = lt_u(e_49, splat_u(limit_47));
        ex = and(ex, c3);
        let e_51 = cost_v4;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_51.x, splat_u(0u32)), y: add_u(e_51.y, splat_u(1u32)), z: add_u(e_51.z, splat_u(0u32)) });
        cost_v4 = Vec3 { x: sel_u(m4, y5.x, cost_v4.x), y: sel_u(m4, y5.y, cost_v4.y), z: sel_u(m4, y5.z, cost_v4.z) };
        let e_54 = cell_v0;
        if none(ex) { break 'l1; }
        let leave_55 = cell_leave(r, &grid_2, e_54);
        let end_60 = min(min(leave_55.x, leave_55.y), path_a0.exit);
        let e_61 = t_v1;
        let span_64 = max_with(sub(end_60, e_61), splat(0.0f32));
        let e_65 = cell_v0;
        let e_66 = cell_v0;
        let e_67 = whole_cell(r, ex, e_66);
        let e_69 = height_cell(r, ex, e_67, path_a0.level);
        let e_70 = t_v1;
        let c_71 = gap_to(r, path_a0, &grid_2, e_65, e_69, e_70);
        let e_72 = cost_v4;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_72.x, splat_u(1u32)), y: add_u(e_72.y, splat_u(0u32)), z: add_u(e_72.z, splat_u(16u32)) });
        cost_v4 = Vec3 { x: sel_u(m6, y7.x, cost_v4.x), y: sel_u(m6, y7.y, cost_v4.y), z: sel_u(m6, y7.z, cost_v4.z) };
        let (b8, c9) = (ex, le(c_71.x, splat(0.0f32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_78 = near_v2;
            let e_79 = t_v1;
            let e_83 = near_gap_v3;
            both_v5 = and(lt(e_78, e_79), gt(e_83, splat(0.0f32)));
            let e_87 = both_v5;
            let (b10, c11) = (ex, e_87);
            ex = and(b10, c11);
            if any(ex) {
                let e_88 = near_v2;
                let e_89 = t_v1;
                let e_90 = near_gap_v3;
                let e_92 = cost_v4;
                let e_93 = entered_once(r, ex, path_a0, &grid_2, e_88, e_89, e_90, c_71.x, e_92);
                ret = sel_search_result(ex, &e_93, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b10, c11);
            let e_94 = t_v1;
            let e_95 = t_v1;
            let e_98 = cost_v4;
            let e_99 = found_in_cell(r, ex, c_71, e_94, span_64, eq(e_95, splat(0.0f32)), e_98);
            ret = sel_search_result(ex, &e_99, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        let e_100 = t_v1;
        start_v6 = e_100;
        gap_v7 = c_71.x;
        if (params_a1.y > 0.5f32) {
            if none(ex) { break 'l1; }
            let e_107 = falls_in_cell(r, ex, c_71, span_64);
            let (b12, c13) = (ex, e_107);
            ex = and(b12, c13);
            if any(ex) {
                let e_108 = t_v1;
                let e_109 = t_v1;
                let e_112 = cost_v4;
                let e_113 = found_in_cell(r, ex, c_71, e_108, span_64, eq(e_109, splat(0.0f32)), e_112);
                ret = sel_search_result(ex, &e_113, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b12, c13);
            let e_114 = t_v1;
            start_v6 = max(e_114, end_60);
            if none(ex) { break 'l1; }
            let e_116 = quadratic(r, c_71, span_64);
            gap_v7 = e_116;
        }
        let e_117 = start_v6;
        if none(ex) { break 'l1; }
        let (b14, c15) = (ex, ge(e_117, path_a0.exit));
        ex = and(b14, c15);
        if any(ex) {
            let e_121 = t_v1;
            let e_123 = cost_v4;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_121, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_123, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b14, c15);
        let e_127 = start_v6;
        near_v2 = e_127;
        let e_128 = gap_v7;
        near_gap_v3 = e_128;
        let e_129 = cell_v0;
        let e_131 = cell_v0;
        let e_134 = start_v6;
        if none(ex) { break 'l1; }
        let e_137 = nearest_corner(r, Vec2 { x: add(sub(grid_2.origin.x, e_131.x), mul(grid_2.step.x, e_134)), y: add(sub(grid_2.origin.y, e_131.y), mul(grid_2.step.y, e_134)) });
        let slope_139 = cone_slope(r, ex, path_a0, Vec2 { x: add(e_129.x, e_137.x), y: add(e_129.y, e_137.y) });
        let e_140 = cost_v4;
        let e_142 = map_read(r, path_a0, splat_u(1u32));
        let (m16, y17) = (ex, Vec3 { x: add_u(e_140.x, e_142.x), y: add_u(e_140.y, e_142.y), z: add_u(e_140.z, e_142.z) });
        cost_v4 = Vec3 { x: sel_u(m16, y17.x, cost_v4.x), y: sel_u(m16, y17.y, cost_v4.y), z: sel_u(m16, y17.z, cost_v4.z) };
        let e_144 = start_v6;
        next_v8 = e_144;
        let (b18, c19) = (ex, ge(slope_139, splat(0.0f32)));
        ex = and(b18, c19);
        if any(ex) {
            let nearing_149 = sub(mul(slope_139, aside_9), rise_11);
            let closing_152 = add(nearing_149, mul(splat(9.536743e-7f32), nearing_149));
            let e_153 = gap_v7;
            let room_161 = sub(e_153, mul(splat(9.536743e-7f32), add(terms_20, mul(slope_139, add(far_34.x, far_34.y)))));
            next_v8 = sel(ex, splat(3e38f32), next_v8);
            let c20 = gt(closing_152, splat(0.0f32));
            let e_165 = start_v6;
            next_v8 = sel(and(ex, c20), add(e_165, div(max_with(room_161, splat(0.0f32)), closing_152)), next_v8);
        }
        ex = b18;
        if (params_a1.y < 0.5f32) {
            let e_175 = next_v8;
            let e_176 = t_v1;
            both_v9 = not(gt(sub(e_175, e_176), mul(splat(9.536743e-7f32), path_a0.exit)));
        } else {
            both_v9 = splat_m(false);
        }
        let e_184 = both_v9;
        let (b21, c22) = (ex, e_184);
        ex = and(b21, c22);
        if any(ex) {
            let e_186 = t_v1;
            let e_188 = gap_v7;
            let e_189 = cost_v4;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: e_186, far: path_a0.exit, near_gap: e_188, far_gap: splat(0.0f32), cost: e_189, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b21, c22);
        let e_192 = next_v8;
        if none(ex) { break 'l1; }
        let (b23, c24) = (ex, ge(e_192, path_a0.exit));
        ex = and(b23, c24);
        if any(ex) {
            let last_196 = path_gap(r, ex, path_a0, path_a0.exit);
            let e_197 = cost_v4;
            let (m25, y26) = (ex, Vec3 { x: add_u(e_197.x, splat_u(1u32)), y: add_u(e_197.y, splat_u(0u32)), z: add_u(e_197.z, splat_u(16u32)) });
            cost_v4 = Vec3 { x: sel_u(m25, y26.x, cost_v4.x), y: sel_u(m25, y26.y, cost_v4.y), z: sel_u(m25, y26.z, cost_v4.z) };
            let (b27, c28) = (ex, le(last_196, splat(0.0f32)));
            ex = and(b27, c28);
            if any(ex) {
                let e_202 = start_v6;
                let e_204 = gap_v7;
                let e_205 = cost_v4;
                let e_206 = entered_once(r, ex, path_a0, &grid_2, e_202, path_a0.exit, e_204, last_196, e_205);
                ret = sel_search_result(ex, &e_206, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b27, c28);
            let e_208 = start_v6;
            let e_210 = cost_v4;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_208, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_210, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b23, c24);
        let e_214 = cell_v0;
        let e_215 = next_v8;
        if none(ex) { break 'l1; }
        let e_216 = cell_after(r, &grid_2, e_214, leave_55, forward_7, e_215);
        cell_v0 = e_216;
        let e_217 = next_v8;
        t_v1 = sel(ex, e_217, t_v1);
    }
    ex = and(b2, alive);
    let e_219 = t_v1;
    let e_221 = cost_v4;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_219, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_221, }, &ret);
} }
stage! { fn search_relaxed_cone_resting(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cell_v0: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v1: F = splat(0.0f32);
    let mut near_v2: F = splat(0.0f32);
    let mut near_gap_v3: F = splat(0.0f32);
    let mut cost_v4: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v5: M = splat_m(false);
    let mut next_v6: F = splat(0f32);
    let grid_2 = grid_of(r, path_a0);
    let forward_7 = Vec2 { x: ge(grid_2.step.x, splat(0.0f32)), y: ge(grid_2.step.y, splat(0.0f32)) };
    let e_9 = cell_of(r, Vec2 { x: grid_2.origin.x, y: grid_2.origin.y });
    cell_v0 = e_9;
    let limit_20 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_22 = cost_v4.x;
        let c3 = lt_u(e_22, splat_u(limit_20));
        ex = and(ex, c3);
        let e_24 = cost_v4;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_24.x, splat_u(0u32)), y: add_u(e_24.y, splat_u(1u32)), z: add_u(e_24.z, splat_u(0u32)) });
        cost_v4 = Vec3 { x: sel_u(m4, y5.x, cost_v4.x), y: sel_u(m4, y5.y, cost_v4.y), z: sel_u(m4, y5.z, cost_v4.z) };
        let e_27 = cell_v0;
        if none(ex) { break 'l1; }
        let e_28 = whole_cell(r, ex, e_27);
        let heights_30 = height_cell(r, ex, e_28, path_a0.level);
        let e_31 = cost_v4;
        let (m6, y7) = (ex, Vec3 { x: add_u(e_31.x, splat_u(1u32)), y: add_u(e_31.y, splat_u(0u32)), z: add_u(e_31.z, splat_u(16u32)) });
        cost_v4 = Vec3 { x: sel_u(m6, y7.x, cost_v4.x), y: sel_u(m6, y7.y, cost_v4.y), z: sel_u(m6, y7.z, cost_v4.z) };
        let e_34 = cell_v0;
        let leave_35 = cell_leave(r, &grid_2, e_34);
        let end_40 = min(min(leave_35.x, leave_35.y), path_a0.exit);
        let e_41 = t_v1;
        let span_44 = max_with(sub(end_40, e_41), splat(0.0f32));
        let e_45 = cell_v0;
        let e_46 = t_v1;
        let c_47 = gap_to(r, path_a0, &grid_2, e_45, heights_30, e_46);
        let (b8, c9) = (ex, le(c_47.x, splat(0.0f32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_51 = near_v2;
            let e_52 = t_v1;
            let e_56 = near_gap_v3;
            both_v5 = and(lt(e_51, e_52), gt(e_56, splat(0.0f32)));
            let e_60 = both_v5;
            let (b10, c11) = (ex, e_60);
            ex = and(b10, c11);
            if any(ex) {
                let e_61 = near_v2;
                let e_62 = t_v1;
                let e_63 = near_gap_v3;
                let e_65 = cost_v4;
                let e_66 = entered_once(r, ex, path_a0, &grid_2, e_61, e_62, e_63, c_47.x, e_65);
                ret = sel_search_result(ex, &e_66, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b10, c11);
            let e_67 = t_v1;
            let e_68 = t_v1;
            let e_71 = cost_v4;
            let e_72 = found_in_cell(r, ex, c_47, e_67, span_44, eq(e_68, splat(0.0f32)), e_71);
            ret = sel_search_result(ex, &e_72, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        if none(ex) { break 'l1; }
        let e_73 = falls_in_cell(r, ex, c_47, span_44);
        let (b12, c13) = (ex, e_73);
        ex = and(b12, c13);
        if any(ex) {
            let e_74 = t_v1;
            let e_75 = t_v1;
            let e_78 = cost_v4;
            let e_79 = found_in_cell(r, ex, c_47, e_74, span_44, eq(e_75, splat(0.0f32)), e_78);
            ret = sel_search_result(ex, &e_79, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b12, c13);
        let e_80 = t_v1;
        let start_81 = max(e_80, end_40);
        if none(ex) { break 'l1; }
        let (b14, c15) = (ex, ge(start_81, path_a0.exit));
        ex = and(b14, c15);
        if any(ex) {
            let e_85 = t_v1;
            let e_87 = cost_v4;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_85, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_87, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b14, c15);
        near_v2 = start_81;
        if none(ex) { break 'l1; }
        let e_91 = quadratic(r, c_47, span_44);
        near_gap_v3 = e_91;
        let e_93 = cell_v0;
        let corner_98 = nearest_corner(r, Vec2 { x: add(sub(grid_2.origin.x, e_93.x), mul(grid_2.step.x, start_81)), y: add(sub(grid_2.origin.y, e_93.y), mul(grid_2.step.y, start_81)) });
        let apex_99 = corner_height(r, heights_30, corner_98);
        next_v6 = start_81;
        let e_101 = path_height(r, path_a0, start_81);
        let (b16, c17) = (ex, gt(e_101, apex_99));
        ex = and(b16, c17);
        if any(ex) {
            let e_103 = cell_v0;
            let texel_104 = Vec2 { x: add(e_103.x, corner_98.x), y: add(e_103.y, corner_98.y) };
            let slope_105 = cone_slope(r, ex, path_a0, texel_104);
            let e_106 = cost_v4;
            let e_108 = map_read(r, path_a0, splat_u(1u32));
            let (m18, y19) = (ex, Vec3 { x: add_u(e_106.x, e_108.x), y: add_u(e_106.y, e_108.y), z: add_u(e_106.z, e_108.z) });
            cost_v4 = Vec3 { x: sel_u(m18, y19.x, cost_v4.x), y: sel_u(m18, y19.y, cost_v4.y), z: sel_u(m18, y19.z, cost_v4.z) };
            let (b20, c21) = (ex, ge(slope_105, splat(0.0f32)));
            ex = and(b20, c21);
            if any(ex) {
                let e_112 = stays_inside(r, ex, path_a0, &grid_2, texel_104, apex_99, slope_105, start_81);
                next_v6 = sel(ex, add(start_81, e_112), next_v6);
            }
            ex = b20;
        }
        ex = b16;
        let e_114 = next_v6;
        let (b22, c23) = (ex, ge(e_114, path_a0.exit));
        ex = and(b22, c23);
        if any(ex) {
            let last_118 = path_gap(r, ex, path_a0, path_a0.exit);
            let e_119 = cost_v4;
            let (m24, y25) = (ex, Vec3 { x: add_u(e_119.x, splat_u(1u32)), y: add_u(e_119.y, splat_u(0u32)), z: add_u(e_119.z, splat_u(16u32)) });
            cost_v4 = Vec3 { x: sel_u(m24, y25.x, cost_v4.x), y: sel_u(m24, y25.y, cost_v4.y), z: sel_u(m24, y25.z, cost_v4.z) };
            let (b26, c27) = (ex, le(last_118, splat(0.0f32)));
            ex = and(b26, c27);
            if any(ex) {
                let e_125 = near_gap_v3;
                let e_126 = cost_v4;
                let e_127 = entered_once(r, ex, path_a0, &grid_2, start_81, path_a0.exit, e_125, last_118, e_126);
                ret = sel_search_result(ex, &e_127, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b26, c27);
            let e_130 = cost_v4;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: start_81, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_130, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b22, c23);
        let e_134 = cell_v0;
        let e_135 = next_v6;
        if none(ex) { break 'l1; }
        let e_136 = cell_after(r, &grid_2, e_134, leave_35, forward_7, e_135);
        cell_v0 = e_136;
        let e_137 = next_v6;
        t_v1 = sel(ex, e_137, t_v1);
    }
    ex = and(b2, alive);
    let e_139 = t_v1;
    let e_141 = cost_v4;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_139, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_141, }, &ret);
} }
stage! { fn search_voxels(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut has_turned_v0: M = splat_m(false);
    let mut t_v1: F = splat(0.0f32);
    let mut cell_v2: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let mut cost_v3: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut both_v4: M = splat_m(false);
    let way_2 = voxel_path(r, path_a0);
    let turn_3 = turning_point(r, ex, &way_2);
    let e_8 = t_v1;
    let e_9 = voxel_place_on(r, &way_2, e_8);
    cell_v2 = Vec3 { x: floor(e_9.x), y: floor(e_9.y), z: floor(e_9.z) };
    let limit_15 = (params_a1.x as u32);
    let b2 = ex;
    'l1: loop {
        let e_17 = cost_v3.y;
        let c3 = lt_u(e_17, splat_u(limit_15));
        ex = and(ex, c3);
        let e_19 = cell_v2;
        if none(ex) { break 'l1; }
        let e_21 = voxel_texel(r, ex, Vec3 { x: i_of_f(e_19.x), y: i_of_f(e_19.y), z: i_of_f(e_19.z) });
        let e_24 = search_texel_llss(r, path_a0, e_21, 0i32, 0i32);
        let e_26 = cost_v3;
        let e_30 = map_read(r, path_a0, splat_u(1u32));
        let (m4, y5) = (ex, Vec3 { x: add_u(add_u(e_26.x, splat_u(0u32)), e_30.x), y: add_u(add_u(e_26.y, splat_u(1u32)), e_30.y), z: add_u(add_u(e_26.z, splat_u(0u32)), e_30.z) });
        cost_v3 = Vec3 { x: sel_u(m4, y5.x, cost_v3.x), y: sel_u(m4, y5.y, cost_v3.y), z: sel_u(m4, y5.z, cost_v3.z) };
        let reach_35 = max_with(sub(e_24.x, splat(1.0f32)), splat(0.0f32));
        let e_39 = has_turned_v0;
        let end_of_part_40 = sel(e_39, path_a0.exit, min(turn_3, path_a0.exit));
        let e_41 = cell_v2;
        let e_42 = has_turned_v0;
        let leave_43 = voxel_leave(r, ex, &way_2, e_41, reach_35, e_42);
        let side_48 = min(min(leave_43.x, leave_43.y), leave_43.z);
        let e_50 = t_v1;
        let end_51 = max(min(side_48, end_of_part_40), e_50);
        let (b6, c7) = (ex, lt(e_24.x, splat(0.5f32)));
        ex = and(b6, c7);
        if any(ex) {
            let e_54 = cost_v3;
            let (m8, y9) = (ex, Vec3 { x: add_u(e_54.x, splat_u(1u32)), y: add_u(e_54.y, splat_u(0u32)), z: add_u(e_54.z, splat_u(32u32)) });
            cost_v3 = Vec3 { x: sel_u(m8, y9.x, cost_v3.x), y: sel_u(m8, y9.y, cost_v3.y), z: sel_u(m8, y9.z, cost_v3.z) };
            let e_57 = cell_v2;
            let e_58 = t_v1;
            let e_59 = t_v1;
            let found_61 = root_in_voxel_cell(r, ex, &way_2, e_57, e_58, sub(end_51, e_59));
            let (b10, c11) = (ex, lt(found_61.root, splat(3e38f32)));
            ex = and(b10, c11);
            if any(ex) {
                let e_70 = t_v1;
                both_v4 = and(lt(found_61.gap, splat(0.0f32)), eq(e_70, splat(0.0f32)));
                let begins_inside_74 = both_v4;
                let status_77 = sel_u(begins_inside_74, splat_u(5u32), splat_u(3u32));
                let e_78 = t_v1;
                let e_80 = t_v1;
                let far_83 = add(e_78, mul(found_61.root, sub(end_51, e_80)));
                let e_84 = t_v1;
                let e_89 = cost_v3;
                ret = sel_search_result(ex, &SearchResult { status: status_77, near: e_84, far: far_83, near_gap: found_61.gap, far_gap: min_with(found_61.gap, splat(0.0f32)), cost: e_89, }, &ret);
                alive = and_not(alive, ex);
                ex = no_lane();
            }
            ex = and_not(b10, c11);
        }
        let x12 = ex;
        ex = and_not(b6, c7);
        ex = or(ex, x12);
        if none(ex) { break 'l1; }
        let (b13, c14) = (ex, ge(end_51, path_a0.exit));
        ex = and(b13, c14);
        if any(ex) {
            let e_94 = cost_v3;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: end_51, far: end_51, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_94, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b13, c14);
        if none(ex) { break 'l1; }
        let (b15, c16) = (ex, gt(side_48, end_of_part_40));
        ex = and(b15, c16);
        if any(ex) {
            has_turned_v0 = sel_m(ex, splat_m(true), has_turned_v0);
            let e_100 = cell_v2;
            let e_101 = voxel_cell_at(r, &way_2, e_100, reach_35, end_51);
            let (m17, y18) = (ex, e_101);
            cell_v2 = Vec3 { x: sel(m17, y18.x, cell_v2.x), y: sel(m17, y18.y, cell_v2.y), z: sel(m17, y18.z, cell_v2.z) };
        }
        ex = and_not(b15, c16);
        if any(ex) {
            let e_102 = cell_v2;
            let e_103 = has_turned_v0;
            let e_104 = rises_on(r, ex, &way_2, e_103);
            let e_105 = next_voxel_cell(r, ex, &way_2, e_102, reach_35, leave_43, e_104, end_51);
            let (m19, y20) = (ex, e_105);
            cell_v2 = Vec3 { x: sel(m19, y20.x, cell_v2.x), y: sel(m19, y20.y, cell_v2.y), z: sel(m19, y20.z, cell_v2.z) };
        }
        ex = b15;
        t_v1 = sel(ex, end_51, t_v1);
    }
    ex = and(b2, alive);
    let e_107 = t_v1;
    let e_108 = t_v1;
    let e_109 = cost_v3;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_107, far: e_108, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_109, }, &ret);
} }
stage! { fn way_to_solid(r: &Resources<'_>, within: M, path_a0: &Path, place_a1: Vec3<F>, direction_a2: Vec3<F>, params_a3: Vec4<f32>) -> WayToSolid {
    let mut ex = within;
    let mut ret: WayToSolid = zero_way_to_solid();
    let mut sum_v0: F = splat(0.0f32);
    let mut weights_v1: F = splat(0.0f32);
    let mut k_v2: u32 = 0u32;
    let e_4 = r.volume_size();
    let last_7 = (e_4.z - 1.0f32);
    let inside_12 = Vec3 { x: place_a1.x, y: place_a1.y, z: min(max_with(place_a1.z, splat(0.0f32)), splat(last_7)) };
    let first_13 = Vec3 { x: floor(inside_12.x), y: floor(inside_12.y), z: floor(inside_12.z) };
    let part_14 = Vec3 { x: sub(inside_12.x, first_13.x), y: sub(inside_12.y, first_13.y), z: sub(inside_12.z, first_13.z) };
    let e_15 = r.volume_size();
    let size_17 = Vec2 { x: (e_15.x as i32), y: (e_15.y as i32) };
    let cell_18 = Vec3 { x: i_of_f(first_13.x), y: i_of_f(first_13.y), z: i_of_f(first_13.z) };
    let columns_21 = wrap_pair(r, ex, cell_18.x, size_17.x);
    let rows_24 = wrap_pair(r, ex, cell_18.y, size_17.y);
    let elevation_38 = min(max_with(mul(add(splat(0.5f32), mul(splat(0.5f32), direction_a2.z)), splat((params_a3.z - 1.0f32))), splat(0.0f32)), splat((params_a3.z - 1.0f32)));
    let below_43 = min(floor(elevation_38), splat((params_a3.z - 2.0f32)));
    let e_45 = turn_of(r, ex, Vec2 { x: direction_a2.x, y: direction_a2.y });
    let turn_47 = mul(e_45, splat(params_a3.y));
    let before_48 = floor(turn_47);
    let most_51 = (params_a3.w * 0.998f32);
    'l1: loop {
        let e_58 = k_v2;
        if (e_58 < 8u32) {
        } else {
            break 'l1;
        }
        let e_61 = k_v2;
        let is_next_65 = ((e_61 & 1u32) == 1u32);
        let e_66 = k_v2;
        let is_above_70 = ((e_66 & 2u32) == 2u32);
        let e_71 = k_v2;
        let is_upper_75 = ((e_71 & 4u32) == 4u32);
        let behind_83 = sel(ge(add(before_48, splat(1.0f32)), splat(params_a3.y)), splat(0.0f32), add(before_48, splat(1.0f32)));
        let azimuth_84 = sel(splat_m(is_next_65), behind_83, before_48);
        let layer_92 = i_of_f(add(add(mul(azimuth_84, splat(params_a3.z)), below_43), splat((if is_above_70 { 1.0f32 } else { 0.0f32 }))));
        let of_azimuth_97 = sel(splat_m(is_next_65), sub(turn_47, before_48), sub(splat(1.0f32), sub(turn_47, before_48)));
        let of_elevation_102 = sel(splat_m(is_above_70), sub(elevation_38, below_43), sub(splat(1.0f32), sub(elevation_38, below_43)));
        let of_slice_107 = sel(splat_m(is_upper_75), part_14.z, sub(splat(1.0f32), part_14.z));
        let weight_109 = mul(mul(of_azimuth_97, of_elevation_102), of_slice_107);
        let begin_115 = slice_begin(r, add_i(cell_18.z, splat_i((if is_upper_75 { 1i32 } else { 0i32 }))));
        let e_121 = search_texel_llls(r, ex, path_a0, Vec2 { x: add_i(begin_115.x, columns_21.x), y: add_i(begin_115.y, rows_24.x) }, layer_92, 0i32);
        let e_128 = search_texel_llls(r, ex, path_a0, Vec2 { x: add_i(begin_115.x, columns_21.y), y: add_i(begin_115.y, rows_24.x) }, layer_92, 0i32);
        let e_135 = search_texel_llls(r, ex, path_a0, Vec2 { x: add_i(begin_115.x, columns_21.x), y: add_i(begin_115.y, rows_24.y) }, layer_92, 0i32);
        let e_142 = search_texel_llls(r, ex, path_a0, Vec2 { x: add_i(begin_115.x, columns_21.y), y: add_i(begin_115.y, rows_24.y) }, layer_92, 0i32);
        let ways_144 = Vec4 { x: e_121.x, y: e_128.x, z: e_135.x, w: e_142.x };
        let beside_149 = Vec2 { x: sub(splat(1.0f32), part_14.x), y: part_14.x };
        let e_152 = sub(splat(1.0f32), part_14.y);
        let corners_157 = Vec4 { x: mul(mul(beside_149.x, e_152), weight_109), y: mul(mul(beside_149.y, e_152), weight_109), z: mul(mul(beside_149.x, part_14.y), weight_109), w: mul(mul(beside_149.y, part_14.y), weight_109) };
        let limit_158 = Vec4 { x: most_51, y: most_51, z: most_51, w: most_51 };
        let none_163 = Vec4 { x: 0.0f32, y: 0.0f32, z: 0.0f32, w: 0.0f32 };
        let solid_165 = Vec4 { x: sel(lt(ways_144.x, splat(limit_158.x)), corners_157.x, splat(none_163.x)), y: sel(lt(ways_144.y, splat(limit_158.y)), corners_157.y, splat(none_163.y)), z: sel(lt(ways_144.z, splat(limit_158.z)), corners_157.z, splat(none_163.z)), w: sel(lt(ways_144.w, splat(limit_158.w)), corners_157.w, splat(none_163.w)) };
        let way_166 = Vec4 { x: mul(solid_165.x, ways_144.x), y: mul(solid_165.y, ways_144.y), z: mul(solid_165.z, ways_144.z), w: mul(solid_165.w, ways_144.w) };
        let e_167 = weights_v1;
        weights_v1 = add(e_167, add(add(solid_165.x, solid_165.y), add(solid_165.z, solid_165.w)));
        let e_176 = sum_v0;
        sum_v0 = add(e_176, add(add(way_166.x, way_166.y), add(way_166.z, way_166.w)));
        let e_185 = k_v2;
        k_v2 = e_185.wrapping_add(1u32);
    }
    let e_188 = weights_v1;
    let (b2, c3) = (ex, ge(e_188, splat(0.5f32)));
    ex = and(b2, c3);
    if any(ex) {
        let e_192 = sum_v0;
        let e_193 = weights_v1;
        ret = WayToSolid { is_solid: splat_u(1u32), way: div(e_192, e_193), };
        ex = no_lane();
    }
    ex = and_not(b2, c3);
    return sel_way_to_solid(ex, &WayToSolid { is_solid: splat_u(0u32), way: splat(params_a3.w), }, &ret);
} }
stage! { fn search_generalised(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut t_v0: F = splat(0.0f32);
    let mut cost_v1: Vec3<U> = Vec3 { x: splat_u(1u32), y: splat_u(0u32), z: splat_u(32u32) };
    let mut looked_v2: U = splat_u(0u32);
    let walk_2 = voxel_path(r, path_a0);
    let e_7 = t_v0;
    let e_8 = voxel_place_on(r, &walk_2, e_7);
    let e_9 = field_at_voxel(r, ex, e_8);
    let (b1, c2) = (ex, gt(e_9, splat(0.5f32)));
    ex = and(b1, c2);
    if any(ex) {
        let e_13 = t_v0;
        let e_14 = t_v0;
        let e_15 = cost_v1;
        ret = SearchResult { status: splat_u(5u32), near: e_13, far: e_14, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_15, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    let e_19 = r.volume_size();
    let last_22 = (e_19.z - 1.0f32);
    let limit_24 = (params_a1.x as u32);
    if none(ex) { return ret; }
    let b4 = ex;
    'l3: loop {
        let e_27 = looked_v2;
        let c5 = lt_u(e_27, splat_u(limit_24));
        ex = and(ex, c5);
        let e_33 = t_v0;
        let toward_38 = Vec3 { x: add(walk_2.step.x, splat(0.0f32)), y: add(walk_2.step.y, splat(0.0f32)), z: add(walk_2.step.z, mul(mul(splat(2.0f32), walk_2.bend), e_33)) };
        let speed_39 = sqrt(add(add(mul(toward_38.x, toward_38.x), mul(toward_38.y, toward_38.y)), mul(toward_38.z, toward_38.z)));
        let direction_41 = Vec3 { x: div(toward_38.x, speed_39), y: div(toward_38.y, speed_39), z: div(toward_38.z, speed_39) };
        let e_42 = t_v0;
        if none(ex) { break 'l3; }
        let place_43 = voxel_place_on(r, &walk_2, e_42);
        let beyond_48 = sub(place_43.z, min(max_with(place_43.z, splat(0.0f32)), splat(last_22)));
        let is_inward_52 = lt(mul(beyond_48, direction_41.z), splat(0.0f32));
        let before_57 = sel(is_inward_52, abs(div(beyond_48, direction_41.z)), splat(0.0f32));
        let ahead_60 = way_to_solid(r, ex, path_a0, Vec3 { x: add(place_43.x, mul(direction_41.x, before_57)), y: add(place_43.y, mul(direction_41.y, before_57)), z: add(place_43.z, mul(direction_41.z, before_57)) }, direction_41, params_a1);
        let e_61 = cost_v1;
        let e_65 = map_read(r, path_a0, splat_u(32u32));
        let (m6, y7) = (ex, Vec3 { x: add_u(add_u(e_61.x, splat_u(0u32)), e_65.x), y: add_u(add_u(e_61.y, splat_u(1u32)), e_65.y), z: add_u(add_u(e_61.z, splat_u(0u32)), e_65.z) });
        cost_v1 = Vec3 { x: sel_u(m6, y7.x, cost_v1.x), y: sel_u(m6, y7.y, cost_v1.y), z: sel_u(m6, y7.z, cost_v1.z) };
        let e_67 = looked_v2;
        looked_v2 = add_u(e_67, splat_u(1u32));
        let e_70 = t_v0;
        let far_74 = add(e_70, div(add(before_57, ahead_60.way), speed_39));
        let (b8, c9) = (ex, not(lt(far_74, path_a0.exit)));
        ex = and(b8, c9);
        if any(ex) {
            let e_81 = cost_v1;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: path_a0.exit, far: path_a0.exit, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_81, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        if none(ex) { break 'l3; }
        let (b10, c11) = (ex, eq_u(ahead_60.is_solid, splat_u(1u32)));
        ex = and(b10, c11);
        if any(ex) {
            let e_92 = t_v0;
            let e_95 = cost_v1;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: max(sub(far_74, div(splat(0.5f32), speed_39)), e_92), far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(1.0f32), cost: e_95, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b10, c11);
        t_v0 = sel(ex, far_74, t_v0);
        if none(ex) { break 'l3; }
    }
    ex = and(b4, alive);
    let e_100 = t_v0;
    let e_101 = t_v0;
    let e_102 = cost_v1;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_100, far: e_101, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_102, }, &ret);
} }
lanes! { fn upright(r: &Resources<'_>, uv_a0: Vec2<F>) -> Vec2<F> {
    let tile_1 = Vec2 { x: floor(uv_a0.x), y: floor(uv_a0.y) };
    let is_odd_11 = Vec2 { x: gt(sub(tile_1.x, mul(splat(2.0f32), floor(mul(tile_1.x, splat(0.5f32))))), splat(0.5f32)), y: gt(sub(tile_1.y, mul(splat(2.0f32), floor(mul(tile_1.y, splat(0.5f32))))), splat(0.5f32)) };
    if (r.surface_settings.wrap != 2u32) {
        return Vec2 { x: splat(1.0f32), y: splat(1.0f32) };
    }
    return Vec2 { x: sel(is_odd_11.x, splat((-1.0f32)), splat(1.0f32)), y: sel(is_odd_11.y, splat((-1.0f32)), splat(1.0f32)) };
} }
lanes! { fn path_axes(r: &Resources<'_>, within: M, path_a0: &Path, depth_a1: f32) -> PathAxes {
    let mut ex = within;
    let mut ret: PathAxes = zero_path_axes();
    let mut start_v0: F = splat(0.0f32);
    let mut fall_v1: F = splat(0f32);
    let mut way_v2: F = splat(0f32);
    let mut both_v3: M = splat_m(false);
    let mut both_v4: M = splat_m(false);
    let below_5 = sub(path_a0.h.x, splat(1.0f32));
    fall_v1 = sub(splat(0.0f32), path_a0.h.y);
    let (b1, c2) = (ex, lt(below_5, splat(0.0f32)));
    ex = and(b1, c2);
    if any(ex) {
        let discriminant_25 = sub(mul(path_a0.h.y, path_a0.h.y), mul(mul(splat(4.0f32), path_a0.h.z), below_5));
        fall_v1 = sel(ex, sqrt(max_with(discriminant_25, splat(0.0f32))), fall_v1);
        let e_31 = fall_v1;
        start_v0 = sel(ex, div(mul(splat(2.0f32), below_5), sub(e_31, path_a0.h.y)), start_v0);
    }
    ex = b1;
    let e_38 = fall_v1;
    let e_39 = fall_v1;
    let bend_41 = div(path_a0.h.z, mul(e_38, e_39));
    let speed_43 = sqrt(add(mul(path_a0.duv.x, path_a0.duv.x), mul(path_a0.duv.y, path_a0.duv.y)));
    way_v2 = div(splat(1.0f32), bend_41);
    let c3 = lt(bend_41, splat(0.25f32));
    way_v2 = sel(c3, div(splat(2.0f32), add(splat(1.0f32), sqrt(sub(splat(1.0f32), mul(splat(4.0f32), bend_41))))), way_v2);
    let e_58 = way_v2;
    let e_59 = fall_v1;
    let whole_60 = div(e_58, e_59);
    let e_61 = fall_v1;
    both_v3 = and(gt(e_61, splat(0.0f32)), gt(whole_60, splat(0.0f32)));
    let e_69 = both_v3;
    let e_72 = start_v0;
    both_v4 = and(e_69, ge(e_72, mul(whole_60, splat((-1.001f32)))));
    let comes_in_77 = both_v4;
    let e_84 = start_v0;
    let e_87 = upright(r, Vec2 { x: add(path_a0.uv.x, mul(path_a0.duv.x, e_84)), y: add(path_a0.uv.y, mul(path_a0.duv.y, e_84)) });
    let e_89 = turn_of(r, ex, Vec2 { x: mul(path_a0.duv.x, e_87.x), y: mul(path_a0.duv.y, e_87.y) });
    let e_90 = fall_v1;
    let e_102 = start_v0;
    let e_103 = fall_v1;
    return PathAxes { comes_in: sel_u(comes_in_77, splat_u(1u32), splat_u(0u32)), turn: e_89, elevation: div(speed_43, add(speed_43, mul(splat(depth_a1), e_90))), bend: add(splat(0.5f32), mul(splat(0.5f32), div(bend_41, add(splat(0.25f32), abs(bend_41))))), start: e_102, whole: whole_60, fall: e_103, };
} }
lanes! { fn views_around(r: &Resources<'_>, axes_a0: &PathAxes, params_a1: Vec4<f32>) -> ViewsAround {
    let elevation_11 = min(max_with(sub(mul(axes_a0.elevation, splat(params_a1.y)), splat(0.5f32)), splat(0.0f32)), splat((params_a1.y - 1.0f32)));
    let below_16 = min(floor(elevation_11), splat((params_a1.y - 2.0f32)));
    let bend_26 = min(max_with(sub(mul(axes_a0.bend, splat(params_a1.z)), splat(0.5f32)), splat(0.0f32)), splat((params_a1.z - 1.0f32)));
    let lower_33 = min(floor(bend_26), splat((params_a1.z - 2.0f32).max(0.0f32)));
    let turn_38 = sub(mul(axes_a0.turn, splat(params_a1.x)), splat(0.5f32));
    let before_39 = floor(turn_38);
    return ViewsAround { pairs: splat_u((if (params_a1.z == 1.0f32) { 2u32 } else { 4u32 })), before: before_39, azimuths: splat(params_a1.x), below: below_16, elevations: splat(params_a1.y), lower: lower_33, part: Vec3 { x: sub(turn_38, before_39), y: sub(elevation_11, below_16), z: sub(bend_26, lower_33) }, };
} }
lanes! { fn no_views(r: &Resources<'_>) -> JoinedViews {
    return JoinedViews { first: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, low: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, high: Vec2 { x: splat(0.0f32), y: splat(0.0f32) }, };
} }
lanes! { fn view_pair(r: &Resources<'_>, views_a0: &ViewsAround, k_a1: U) -> ViewPair {
    let mut azimuth_v0: F = splat(0f32);
    let is_next_5 = eq_u(and_u(k_a1, splat_u(1u32)), splat_u(1u32));
    azimuth_v0 = add(views_a0.before, sel(is_next_5, splat(1.0f32), splat(0.0f32)));
    let e_12 = azimuth_v0;
    let e_13 = azimuth_v0;
    let e_16 = azimuth_v0;
    azimuth_v0 = sel(lt(e_16, splat(0.0f32)), add(e_13, views_a0.azimuths), e_12);
    let e_20 = azimuth_v0;
    let e_21 = azimuth_v0;
    let e_24 = azimuth_v0;
    azimuth_v0 = sel(ge(e_24, views_a0.azimuths), sub(e_21, views_a0.azimuths), e_20);
    let e_28 = azimuth_v0;
    let layer_33 = i_of_f(add(mul(e_28, views_a0.elevations), views_a0.below));
    return ViewPair { layer: layer_33, bend: add(views_a0.lower, sel(gt_u(k_a1, splat_u(1u32)), splat(1.0f32), splat(0.0f32))), };
} }
lanes! { fn with_pair(r: &Resources<'_>, within: M, joined_a0: &JoinedViews, views_a1: &ViewsAround, k_a2: U, ways_a3: Vec4<F>) -> JoinedViews {
    let mut ex = within;
    let mut ret: JoinedViews = zero_joined_views();
    let of_below_6 = Vec2 { x: ways_a3.x, y: ways_a3.y };
    let of_azimuth_14 = Vec2 { x: add(of_below_6.x, mul(sub(ways_a3.z, of_below_6.x), views_a1.part.y)), y: add(of_below_6.y, mul(sub(ways_a3.w, of_below_6.y), views_a1.part.y)) };
    let of_bend_21 = Vec2 { x: add(joined_a0.first.x, mul(sub(of_azimuth_14.x, joined_a0.first.x), views_a1.part.x)), y: add(joined_a0.first.y, mul(sub(of_azimuth_14.y, joined_a0.first.y), views_a1.part.x)) };
    let (b1, c2) = (ex, eq_u(k_a2, splat_u(1u32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = JoinedViews { first: of_azimuth_14, low: of_bend_21, high: of_bend_21, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    return sel_joined_views(ex, &JoinedViews { first: of_azimuth_14, low: Vec2 { x: joined_a0.low.x, y: joined_a0.low.y }, high: of_bend_21, }, &ret);
} }
lanes! { fn row_of_bend(r: &Resources<'_>, row_a0: I, bend_a1: F, rows_a2: i32) -> I {
    return add_i(row_a0, mul_i(i_of_f(bend_a1), splat_i(rows_a2)));
} }
lanes! { fn ways_of_texel(r: &Resources<'_>, within: M, path_a0: &Path, texel_a1: Vec2<I>, layer_a2: I) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let level_4 = (path_a0.level as i32);
    let e_5 = search_texel_llls(r, ex, path_a0, texel_a1, layer_a2, level_4);
    let e_9 = search_texel_llls(r, ex, path_a0, texel_a1, add_i(layer_a2, splat_i(1i32)), level_4);
    let is_below_12 = lt(e_5.x, splat(0.998f32));
    let is_above_14 = lt(e_9.x, splat(0.998f32));
    return Vec4 { x: sel(is_below_12, e_5.x, splat(0.0f32)), y: sel(is_below_12, splat(1.0f32), splat(0.0f32)), z: sel(is_above_14, e_9.x, splat(0.0f32)), w: sel(is_above_14, splat(1.0f32), splat(0.0f32)) };
} }
lanes! { fn ways_of_bend(r: &Resources<'_>, within: M, path_a0: &Path, around_a1: &Around, layer_a2: I, bend_a3: F) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_5 = r.height_texels(path_a0.level);
    let first_9 = row_of_bend(r, around_a1.rows.x, bend_a3, e_5.y);
    let second_12 = row_of_bend(r, around_a1.rows.y, bend_a3, e_5.y);
    let e_16 = ways_of_texel(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: first_9 }, layer_a2);
    let e_20 = ways_of_texel(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: first_9 }, layer_a2);
    let e_24 = ways_of_texel(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: second_12 }, layer_a2);
    let e_28 = ways_of_texel(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: second_12 }, layer_a2);
    let e_30 = bilinear(r, e_16, e_20, e_24, e_28, Vec2 { x: around_a1.part.x, y: around_a1.part.y });
    return e_30;
} }
lanes! { fn hit_on_way(r: &Resources<'_>, within: M, path_a0: &Path, axes_a1: &PathAxes, way_a2: Vec2<F>, cost_a3: Vec3<U>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let t_10 = add(axes_a1.start, mul(div(way_a2.x, way_a2.y), axes_a1.whole));
    both_v0 = or(lt(way_a2.y, splat(0.5f32)), lt(t_10, splat(0.0f32)));
    let e_20 = both_v0;
    both_v1 = or(e_20, gt(t_10, path_a0.exit));
    let e_27 = both_v1;
    let (b1, c2) = (ex, e_27);
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(0u32), near: path_a0.exit, far: path_a0.exit, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: cost_a3, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    return sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: t_10, far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(1.0f32), cost: cost_a3, }, &ret);
} }
lanes! { fn joined_way(r: &Resources<'_>, joined_a0: &JoinedViews, views_a1: &ViewsAround) -> Vec2<F> {
    return Vec2 { x: add(joined_a0.low.x, mul(sub(joined_a0.high.x, joined_a0.low.x), views_a1.part.z)), y: add(joined_a0.low.y, mul(sub(joined_a0.high.y, joined_a0.low.y), views_a1.part.z)) };
} }
stage! { fn search_view_dependent(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut joined_v0: JoinedViews = zero_joined_views();
    let mut k_v1: U = splat_u(0u32);
    let axes_3 = path_axes(r, ex, path_a0, params_a1.w);
    let views_4 = views_around(r, &axes_3, params_a1);
    let e_9 = map_read(r, path_a0, mul_u(views_4.pairs, splat_u(8u32)));
    let cost_10 = Vec3 { x: add_u(splat_u(0u32), e_9.x), y: add_u(splat_u(1u32), e_9.y), z: add_u(splat_u(0u32), e_9.z) };
    let (b1, c2) = (ex, eq_u(axes_3.comes_in, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(0u32), near: path_a0.exit, far: path_a0.exit, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: Vec3 { x: splat_u(0u32), y: splat_u(1u32), z: splat_u(0u32) }, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_22 = path_uv(r, path_a0, axes_3.start);
    let e_24 = r.height_texels(path_a0.level);
    let around_25 = texels_around(r, ex, e_22, e_24);
    let e_26 = no_views(r);
    joined_v0 = e_26;
    let b4 = ex;
    'l3: loop {
        let e_30 = k_v1;
        let c5 = lt_u(e_30, views_4.pairs);
        ex = and(ex, c5);
        let e_33 = k_v1;
        if none(ex) { break 'l3; }
        let pair_34 = view_pair(r, &views_4, e_33);
        let e_35 = joined_v0;
        let e_36 = k_v1;
        let e_39 = ways_of_bend(r, ex, path_a0, &around_25, pair_34.layer, pair_34.bend);
        let e_40 = with_pair(r, ex, &e_35, &views_4, e_36, e_39);
        joined_v0 = sel_joined_views(ex, &e_40, &joined_v0);
        let e_41 = k_v1;
        k_v1 = add_u(e_41, splat_u(1u32));
    }
    ex = b4;
    let e_44 = joined_v0;
    let e_45 = joined_way(r, &e_44, &views_4);
    let e_46 = hit_on_way(r, ex, path_a0, &axes_3, e_45, cost_10);
    return sel_search_result(ex, &e_46, &ret);
} }
lanes! { fn is_in_footprint(r: &Resources<'_>, within: M, square_a0: Vec2<F>, size_a1: Vec2<f32>) -> M {
    let mut ex = within;
    let mut ret: M = splat_m(false);
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut both_v2: M = splat_m(false);
    let mut both_v3: M = splat_m(false);
    both_v0 = and(ge(square_a0.x, splat(0.0f32)), ge(square_a0.y, splat(0.0f32)));
    let e_11 = both_v0;
    both_v1 = and(e_11, lt(square_a0.x, splat(size_a1.x)));
    let e_18 = both_v1;
    both_v2 = and(e_18, lt(square_a0.y, splat(size_a1.y)));
    let holds_square_25 = both_v2;
    both_v3 = or(holds_square_25, splat_m((r.surface_settings.wrap != 1u32)));
    let e_35 = both_v3;
    return e_35;
} }
lanes! { fn step_of_axis(r: &Resources<'_>, place_a0: F, count_a1: f32) -> F {
    return min(max_with(floor(mul(place_a0, splat(count_a1))), splat(0.0f32)), splat((count_a1 - 1.0f32)));
} }
lanes! { fn longest_of_step(r: &Resources<'_>, within: M, bend_a0: F, count_a1: f32) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    if (count_a1 == 1.0f32) {
        return splat(1.0f32);
    }
    let low_9 = sub(div(mul(splat(2.0f32), bend_a0), splat(count_a1)), splat(1.0f32));
    let high_12 = add(low_9, splat((2.0f32 / count_a1)));
    let c1 = lt(high_12, splat(0.500001f32));
    ret = div(splat(2.0f32), add(splat(1.0f32), sqrt(max_with(sub(splat(1.0f32), div(high_12, sub(splat(1.0f32), abs(high_12)))), splat(0.0f32)))));
    ex = and_not(ex, c1);
    let least_29 = max_with(low_9, splat(0.5f32));
    return sel(ex, div(mul(splat(4.0f32), sub(splat(1.0f32), least_29)), least_29), ret);
} }
lanes! { fn free_way_of_step(r: &Resources<'_>, within: M, path_a0: &Path, axes_a1: &PathAxes, square_a2: Vec2<I>, params_a3: Vec4<f32>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let n_5 = r.height_texels(path_a0.level);
    let azimuth_8 = step_of_axis(r, axes_a1.turn, params_a3.x);
    let elevation_11 = step_of_axis(r, axes_a1.elevation, params_a3.y);
    let bend_14 = step_of_axis(r, axes_a1.bend, params_a3.z);
    let e_17 = wrap_index(r, ex, square_a2.y, n_5.y);
    let row_19 = row_of_bend(r, e_17, bend_14, n_5.y);
    let e_22 = wrap_index(r, ex, square_a2.x, n_5.x);
    let at_23 = Vec2 { x: e_22, y: row_19 };
    let e_30 = search_texel_llls(r, ex, path_a0, at_23, i_of_f(add(mul(azimuth_8, splat(params_a3.y)), elevation_11)), (path_a0.level as i32));
    let e_33 = longest_of_step(r, ex, bend_14, params_a3.z);
    return mul(e_30.x, e_33);
} }
lanes! { fn search_view_dependent_free(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let mut both_v2: M = splat_m(false);
    let mut both_v3: M = splat_m(false);
    let mut both_v4: M = splat_m(false);
    let axes_3 = path_axes(r, ex, path_a0, params_a1.w);
    let e_6 = r.height_size(path_a0.level);
    let place_7 = Vec2 { x: mul(path_a0.uv.x, splat(e_6.x)), y: mul(path_a0.uv.y, splat(e_6.y)) };
    let square_8 = cell_of(r, place_7);
    let inside_9 = Vec2 { x: sub(place_7.x, square_8.x), y: sub(place_7.y, square_8.y) };
    let near_20 = min(min(inside_9.x, sub(splat(1.0f32), inside_9.x)), min(inside_9.y, sub(splat(1.0f32), inside_9.y)));
    let rounded_29 = mul(splat(9.536743e-7f32), add(max(abs(place_7.x), abs(place_7.y)), splat(1.0f32)));
    let e_31 = r.height_size(path_a0.level);
    let is_in_map_32 = is_in_footprint(r, ex, square_8, e_31);
    both_v0 = and(eq(path_a0.h.x, splat(1.0f32)), eq_u(axes_3.comes_in, splat_u(1u32)));
    let e_43 = both_v0;
    both_v1 = and(e_43, gt(near_20, rounded_29));
    let e_48 = both_v1;
    both_v2 = and(e_48, is_in_map_32);
    let is_known_52 = both_v2;
    if (params_a1.z == 1.0f32) {
        both_v4 = ne(path_a0.h.z, splat(0.0f32));
    } else {
        both_v4 = splat_m(false);
    }
    let e_67 = both_v4;
    both_v3 = or(not(is_known_52), e_67);
    let e_69 = both_v3;
    let (b1, c2) = (ex, e_69);
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(1u32), near: splat(0.0f32), far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(1.0f32), cost: Vec3 { x: splat_u(0u32), y: splat_u(1u32), z: splat_u(0u32) }, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let e_77 = whole_cell(r, ex, square_8);
    let e_78 = free_way_of_step(r, ex, path_a0, &axes_3, e_77, params_a1);
    let free_80 = div(e_78, axes_3.fall);
    let e_87 = map_read(r, path_a0, splat_u(1u32));
    return sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: min(free_80, path_a0.exit), far: path_a0.exit, near_gap: splat(0.0f32), far_gap: splat(1.0f32), cost: Vec3 { x: add_u(splat_u(0u32), e_87.x), y: add_u(splat_u(1u32), e_87.y), z: add_u(splat_u(0u32), e_87.z) }, }, &ret);
} }
stage! { fn search_translucent(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut part_v0: CellPart = zero_cell_part();
    let mut cost_v1: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let way_2 = voxel_path(r, path_a0);
    let turn_3 = turning_point(r, ex, &way_2);
    let limit_5 = (params_a1.z as u32);
    let e_6 = first_part(r, ex, path_a0, &way_2, turn_3);
    part_v0 = e_6;
    let b2 = ex;
    'l1: loop {
        let e_11 = cost_v1.y;
        let c3 = lt_u(e_11, splat_u(limit_5));
        ex = and(ex, c3);
        let e_13 = cost_v1;
        if none(ex) { break 'l1; }
        let e_17 = map_read(r, path_a0, splat_u(1u32));
        let (m4, y5) = (ex, Vec3 { x: add_u(add_u(e_13.x, splat_u(0u32)), e_17.x), y: add_u(add_u(e_13.y, splat_u(1u32)), e_17.y), z: add_u(add_u(e_13.z, splat_u(0u32)), e_17.z) });
        cost_v1 = Vec3 { x: sel_u(m4, y5.x, cost_v1.x), y: sel_u(m4, y5.y, cost_v1.y), z: sel_u(m4, y5.z, cost_v1.z) };
        let e_20 = part_v0.empty;
        let (b6, c7) = (ex, lt(e_20, splat(0.0f32)));
        ex = and(b6, c7);
        if any(ex) {
            let e_25 = part_v0.begin;
            let e_27 = part_v0.begin;
            let e_28 = cost_v1;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(1u32), near: e_25, far: e_27, near_gap: splat(0.0f32), far_gap: splat(1.0f32), cost: e_28, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b6, c7);
        let e_33 = part_v0.is_last;
        if none(ex) { break 'l1; }
        let (b8, c9) = (ex, eq_u(e_33, splat_u(1u32)));
        ex = and(b8, c9);
        if any(ex) {
            let e_38 = part_v0.end;
            let e_40 = part_v0.end;
            let e_41 = cost_v1;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: e_38, far: e_40, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_41, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        let e_45 = part_v0;
        if none(ex) { break 'l1; }
        let e_46 = next_part(r, ex, path_a0, &way_2, turn_3, &e_45);
        part_v0 = sel_cell_part(ex, &e_46, &part_v0);
    }
    ex = and(b2, alive);
    let e_49 = part_v0.begin;
    let e_51 = part_v0.begin;
    let e_52 = cost_v1;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_49, far: e_51, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_52, }, &ret);
} }
lanes! { fn with_axis_last(r: &Resources<'_>, within: M, v_a0: Vec3<F>, axis_a1: U) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let c1 = eq_u(axis_a1, splat_u(0u32));
    ret = Vec3 { x: v_a0.y, y: v_a0.z, z: v_a0.x };
    ex = and_not(ex, c1);
    let c2 = eq_u(axis_a1, splat_u(1u32));
    let y3 = Vec3 { x: v_a0.z, y: v_a0.x, z: v_a0.y };
    ret = Vec3 { x: sel(and(ex, c2), y3.x, ret.x), y: sel(and(ex, c2), y3.y, ret.y), z: sel(and(ex, c2), y3.z, ret.z) };
    ex = and_not(ex, c2);
    let y4 = v_a0;
    return Vec3 { x: sel(ex, y4.x, ret.x), y: sel(ex, y4.y, ret.y), z: sel(ex, y4.z, ret.z) };
} }
lanes! { fn motif_ray(r: &Resources<'_>, within: M, origin_a0: Vec3<F>, step_a1: Vec3<F>) -> MotifRay {
    let mut ex = within;
    let mut ret: MotifRay = zero_motif_ray();
    let mut axis_v0: U = splat_u(0u32);
    let size_2 = Vec3 { x: abs(step_a1.x), y: abs(step_a1.y), z: abs(step_a1.z) };
    axis_v0 = sel_u(gt(size_2.y, size_2.z), splat_u(1u32), splat_u(2u32));
    let e_10 = axis_v0;
    axis_v0 = sel_u(gt(size_2.x, max(size_2.y, size_2.z)), splat_u(0u32), e_10);
    let e_18 = axis_v0;
    let way_19 = with_axis_last(r, ex, step_a1, e_18);
    let least_23 = Vec3 { x: 1e-30f32, y: 1e-30f32, z: 1e-30f32 };
    let inverse_34 = Vec3 { x: sel(gt(size_2.x, splat(least_23.x)), div(splat(1.0f32), step_a1.x), splat(3e38f32)), y: sel(gt(size_2.y, splat(least_23.y)), div(splat(1.0f32), step_a1.y), splat(3e38f32)), z: sel(gt(size_2.z, splat(least_23.z)), div(splat(1.0f32), step_a1.z), splat(3e38f32)) };
    let e_35 = axis_v0;
    return MotifRay { origin: origin_a0, inverse: inverse_34, axis: e_35, shear: Vec3 { x: div(way_19.x, way_19.z), y: div(way_19.y, way_19.z), z: div(splat(1.0f32), way_19.z) }, };
} }
lanes! { fn meets_box(r: &Resources<'_>, ray_a0: &MotifRay, low_a1: Vec3<F>, high_a2: Vec3<F>, near_a3: F, far_a4: F) -> M {
    let a_8 = Vec3 { x: mul(sub(low_a1.x, ray_a0.origin.x), ray_a0.inverse.x), y: mul(sub(low_a1.y, ray_a0.origin.y), ray_a0.inverse.y), z: mul(sub(low_a1.z, ray_a0.origin.z), ray_a0.inverse.z) };
    let b_12 = Vec3 { x: mul(sub(high_a2.x, ray_a0.origin.x), ray_a0.inverse.x), y: mul(sub(high_a2.y, ray_a0.origin.y), ray_a0.inverse.y), z: mul(sub(high_a2.z, ray_a0.origin.z), ray_a0.inverse.z) };
    let first_13 = Vec3 { x: min(a_8.x, b_12.x), y: min(a_8.y, b_12.y), z: min(a_8.z, b_12.z) };
    let last_14 = Vec3 { x: max(a_8.x, b_12.x), y: max(a_8.y, b_12.y), z: max(a_8.z, b_12.z) };
    let enter_20 = max(max(first_13.x, first_13.y), max(first_13.z, near_a3));
    let leave_26 = min(min(last_14.x, last_14.y), min(last_14.z, far_a4));
    return le(enter_20, leave_26);
} }
lanes! { fn seen_beside(r: &Resources<'_>, within: M, ray_a0: &MotifRay, corner_a1: Vec3<F>) -> Vec3<F> {
    let mut ex = within;
    let mut ret: Vec3<F> = Vec3 { x: splat(0f32), y: splat(0f32), z: splat(0f32) };
    let at_5 = with_axis_last(r, ex, Vec3 { x: sub(corner_a1.x, ray_a0.origin.x), y: sub(corner_a1.y, ray_a0.origin.y), z: sub(corner_a1.z, ray_a0.origin.z) }, ray_a0.axis);
    return Vec3 { x: sub(at_5.x, mul(ray_a0.shear.x, at_5.z)), y: sub(at_5.y, mul(ray_a0.shear.y, at_5.z)), z: at_5.z };
} }
lanes! { fn meets_triangle(r: &Resources<'_>, within: M, ray_a0: &MotifRay, first_a1: Vec3<F>, second_a2: Vec3<F>, third_a3: Vec3<F>) -> F {
    let mut ex = within;
    let mut ret: F = splat(0f32);
    let mut both_v0: M = splat_m(false);
    let mut both_v1: M = splat_m(false);
    let a_4 = seen_beside(r, ex, ray_a0, first_a1);
    let b_5 = seen_beside(r, ex, ray_a0, second_a2);
    let c_6 = seen_beside(r, ex, ray_a0, third_a3);
    let left_16 = Vec3 { x: mul(c_6.x, b_5.y), y: mul(a_4.x, c_6.y), z: mul(b_5.x, a_4.y) };
    let right_26 = Vec3 { x: mul(c_6.y, b_5.x), y: mul(a_4.y, c_6.x), z: mul(b_5.y, a_4.x) };
    let sides_27 = Vec3 { x: sub(left_16.x, right_26.x), y: sub(left_16.y, right_26.y), z: sub(left_16.z, right_26.z) };
    let slack_32 = Vec3 { x: mul(add(abs(left_16.x), abs(right_26.x)), splat(5e-7f32)), y: mul(add(abs(left_16.y), abs(right_26.y)), splat(5e-7f32)), z: mul(add(abs(left_16.z), abs(right_26.z)), splat(5e-7f32)) };
    let most_33 = Vec3 { x: add(sides_27.x, slack_32.x), y: add(sides_27.y, slack_32.y), z: add(sides_27.z, slack_32.z) };
    let least_34 = Vec3 { x: sub(sides_27.x, slack_32.x), y: sub(sides_27.y, slack_32.y), z: sub(sides_27.z, slack_32.z) };
    let is_front_41 = ge(min(min(most_33.x, most_33.y), most_33.z), splat(0.0f32));
    let is_back_48 = le(max(max(least_34.x, least_34.y), least_34.z), splat(0.0f32));
    let all_53 = add(add(sides_27.x, sides_27.y), sides_27.z);
    both_v0 = or(is_front_41, is_back_48);
    let e_58 = both_v0;
    both_v1 = or(not(e_58), eq(all_53, splat(0.0f32)));
    let e_66 = both_v1;
    let c1 = e_66;
    ret = splat(3e38f32);
    ex = and_not(ex, c1);
    let along_79 = div(add(add(mul(sides_27.x, a_4.z), mul(sides_27.y, b_5.z)), mul(sides_27.z, c_6.z)), all_53);
    let least_z_84 = min(min(a_4.z, b_5.z), c_6.z);
    let most_z_89 = max(max(a_4.z, b_5.z), c_6.z);
    return sel(ex, mul(min(max(along_79, least_z_84), most_z_89), ray_a0.shear.z), ret);
} }
stage! { fn first_of_leaf(r: &Resources<'_>, within: M, ray_a0: &MotifRay, leaf_a1: U, near_a2: F, far_a3: F) -> MotifHit {
    let mut ex = within;
    let mut ret: MotifHit = zero_motif_hit();
    let mut found_v0: F = splat(3e38f32);
    let mut cost_v1: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut triangle_v2: U = splat_u(0u32);
    let mut both_v3: M = splat_m(false);
    triangle_v2 = leaf_a1;
    let b2 = ex;
    'l1: loop {
        let e_9 = triangle_v2;
        let c3 = ne_u(e_9, splat_u(0u32));
        ex = and(ex, c3);
        let e_12 = triangle_v2;
        if none(ex) { break 'l1; }
        let a_13 = motif_texel(r, e_12);
        let e_14 = triangle_v2;
        let b_17 = motif_texel(r, add_u(e_14, splat_u(1u32)));
        let e_18 = triangle_v2;
        let c_21 = motif_texel(r, add_u(e_18, splat_u(2u32)));
        let e_22 = cost_v1;
        let (m4, y5) = (ex, Vec3 { x: add_u(e_22.x, splat_u(1u32)), y: add_u(e_22.y, splat_u(0u32)), z: add_u(e_22.z, splat_u(48u32)) });
        cost_v1 = Vec3 { x: sel_u(m4, y5.x, cost_v1.x), y: sel_u(m4, y5.y, cost_v1.y), z: sel_u(m4, y5.z, cost_v1.z) };
        let t_28 = meets_triangle(r, ex, ray_a0, Vec3 { x: a_13.x, y: a_13.y, z: a_13.z }, Vec3 { x: b_17.x, y: b_17.y, z: b_17.z }, Vec3 { x: c_21.x, y: c_21.y, z: c_21.z });
        let e_32 = found_v0;
        both_v3 = and(ge(t_28, near_a2), lt(t_28, min(e_32, far_a3)));
        let e_36 = both_v3;
        let c6 = e_36;
        found_v0 = sel(and(ex, c6), t_28, found_v0);
        let e_37 = triangle_v2;
        triangle_v2 = sel_u(eq(a_13.w, splat(0.0f32)), splat_u(0u32), add_u(e_37, splat_u(3u32)));
    }
    ex = b2;
    let e_45 = found_v0;
    let e_46 = cost_v1;
    return MotifHit { t: e_45, cost: e_46, };
} }
stage! { fn first_of_motif(r: &Resources<'_>, within: M, ray_a0: &MotifRay, near_a1: F, far_a2: F, before_a3: Vec3<U>, limit_a4: u32) -> MotifHit {
    let mut ex = within;
    let mut ret: MotifHit = zero_motif_hit();
    let mut cost_v0: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut found_v1: F = splat(3e38f32);
    let mut node_v2: U = splat_u(1u32);
    let mut both_v3: M = splat_m(false);
    let mut next_v4: U = splat_u(0u32);
    cost_v0 = before_a3;
    let b2 = ex;
    'l1: loop {
        let e_10 = node_v2;
        let e_16 = cost_v0.y;
        both_v3 = and(ne_u(e_10, splat_u(0u32)), lt_u(e_16, splat_u(limit_a4)));
        let e_19 = both_v3;
        let c3 = e_19;
        ex = and(ex, c3);
        let e_20 = node_v2;
        if none(ex) { break 'l1; }
        let low_21 = motif_texel(r, e_20);
        let e_22 = node_v2;
        let high_25 = motif_texel(r, add_u(e_22, splat_u(1u32)));
        let e_26 = cost_v0;
        let (m4, y5) = (ex, Vec3 { x: add_u(add_u(e_26.x, splat_u(0u32)), splat_u(1u32)), y: add_u(add_u(e_26.y, splat_u(1u32)), splat_u(0u32)), z: add_u(add_u(e_26.z, splat_u(0u32)), splat_u(32u32)) });
        cost_v0 = Vec3 { x: sel_u(m4, y5.x, cost_v0.x), y: sel_u(m4, y5.y, cost_v0.y), z: sel_u(m4, y5.z, cost_v0.z) };
        let e_31 = found_v1;
        let best_32 = min(e_31, far_a2);
        next_v4 = u_of_f(low_21.w);
        let e_38 = meets_box(r, ray_a0, Vec3 { x: low_21.x, y: low_21.y, z: low_21.z }, Vec3 { x: high_25.x, y: high_25.y, z: high_25.z }, near_a1, best_32);
        let (b6, c7) = (ex, e_38);
        ex = and(b6, c7);
        if any(ex) {
            let (b8, c9) = (ex, eq(high_25.w, splat(0.0f32)));
            ex = and(b8, c9);
            if any(ex) {
                let e_42 = node_v2;
                next_v4 = sel_u(ex, add_u(e_42, splat_u(2u32)), next_v4);
            }
            ex = and_not(b8, c9);
            if any(ex) {
                let of_leaf_47 = first_of_leaf(r, ex, ray_a0, u_of_f(high_25.w), near_a1, best_32);
                let e_48 = found_v1;
                found_v1 = sel(ex, min(e_48, of_leaf_47.t), found_v1);
                let e_51 = cost_v0;
                let (m10, y11) = (ex, Vec3 { x: add_u(e_51.x, of_leaf_47.cost.x), y: add_u(e_51.y, of_leaf_47.cost.y), z: add_u(e_51.z, of_leaf_47.cost.z) });
                cost_v0 = Vec3 { x: sel_u(m10, y11.x, cost_v0.x), y: sel_u(m10, y11.y, cost_v0.y), z: sel_u(m10, y11.z, cost_v0.z) };
            }
            ex = b8;
        }
        ex = b6;
        let e_54 = next_v4;
        node_v2 = e_54;
    }
    ex = b2;
    let e_55 = found_v1;
    let e_56 = cost_v0;
    return MotifHit { t: e_55, cost: e_56, };
} }
stage! { fn search_shell_map(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut alive = ex;
    let mut cost_v0: Vec3<U> = Vec3 { x: splat_u(0u32), y: splat_u(0u32), z: splat_u(0u32) };
    let mut tile_v1: Vec2<F> = Vec2 { x: splat(0f32), y: splat(0f32) };
    let mut t_v2: F = splat(0.0f32);
    let step_5 = Vec3 { x: path_a0.duv.x, y: path_a0.duv.y, z: path_a0.h.y };
    let slack_15 = div(splat(2e-5f32), max(max(abs(step_5.x), abs(step_5.y)), abs(step_5.z)));
    let limit_17 = (params_a1.x as u32);
    tile_v1 = Vec2 { x: floor(path_a0.uv.x), y: floor(path_a0.uv.y) };
    let b2 = ex;
    'l1: loop {
        let e_26 = cost_v0.y;
        let c3 = lt_u(e_26, splat_u(limit_17));
        ex = and(ex, c3);
        let e_28 = tile_v1;
        let ahead_41 = Vec2 { x: add(e_28.x, sel(gt(path_a0.duv.x, splat(0.0f32)), splat(1.0f32), splat(0.0f32))), y: add(e_28.y, sel(gt(path_a0.duv.y, splat(0.0f32)), splat(1.0f32), splat(0.0f32))) };
        let beside_45 = Vec2 { x: div(sub(ahead_41.x, path_a0.uv.x), path_a0.duv.x), y: div(sub(ahead_41.y, path_a0.uv.y), path_a0.duv.y) };
        let leave_55 = Vec2 { x: sel(gt(abs(path_a0.duv.x), splat(0.0f32)), beside_45.x, splat(3e38f32)), y: sel(gt(abs(path_a0.duv.y), splat(0.0f32)), beside_45.y, splat(3e38f32)) };
        let e_61 = t_v2;
        let end_62 = max(min(min(leave_55.x, leave_55.y), path_a0.exit), e_61);
        let e_63 = t_v2;
        if none(ex) { break 'l1; }
        let e_64 = path_uv(r, path_a0, e_63);
        let e_65 = tile_v1;
        let e_67 = t_v2;
        let e_68 = path_height(r, path_a0, e_67);
        let ray_70 = motif_ray(r, ex, Vec3 { x: sub(e_64.x, e_65.x), y: sub(e_64.y, e_65.y), z: e_68 }, step_5);
        let e_73 = t_v2;
        let e_76 = cost_v0;
        let found_77 = first_of_motif(r, ex, &ray_70, sub(splat(0.0f32), slack_15), add(sub(end_62, e_73), slack_15), e_76, limit_17);
        let (m4, y5) = (ex, Vec3 { x: found_77.cost.x, y: found_77.cost.y, z: found_77.cost.z });
        cost_v0 = Vec3 { x: sel_u(m4, y5.x, cost_v0.x), y: sel_u(m4, y5.y, cost_v0.y), z: sel_u(m4, y5.z, cost_v0.z) };
        let (b6, c7) = (ex, lt(found_77.t, splat(3e38f32)));
        ex = and(b6, c7);
        if any(ex) {
            let e_82 = t_v2;
            let at_87 = min(max_with(add(e_82, found_77.t), splat(0.0f32)), path_a0.exit);
            let e_89 = cost_v0;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(3u32), near: at_87, far: at_87, near_gap: splat(0.0f32), far_gap: splat(0.0f32), cost: e_89, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b6, c7);
        if none(ex) { break 'l1; }
        let (b8, c9) = (ex, not(lt(end_62, path_a0.exit)));
        ex = and(b8, c9);
        if any(ex) {
            let e_97 = cost_v0;
            ret = sel_search_result(ex, &SearchResult { status: splat_u(0u32), near: end_62, far: end_62, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_97, }, &ret);
            alive = and_not(alive, ex);
            ex = no_lane();
        }
        ex = and_not(b8, c9);
        let next_112 = Vec2 { x: sel(gt(path_a0.duv.x, splat(0.0f32)), splat(1.0f32), splat((-1.0f32))), y: sel(gt(path_a0.duv.y, splat(0.0f32)), splat(1.0f32), splat((-1.0f32))) };
        let c10 = le(leave_55.x, leave_55.y);
        let e_118 = tile_v1.x;
        tile_v1.x = sel(c10, add(e_118, next_112.x), tile_v1.x);
        let e_123 = tile_v1.y;
        tile_v1.y = sel(not(c10), add(e_123, next_112.y), tile_v1.y);
        t_v2 = sel(ex, end_62, t_v2);
        if none(ex) { break 'l1; }
    }
    ex = and(b2, alive);
    let e_127 = t_v2;
    let e_128 = t_v2;
    let e_129 = cost_v0;
    return sel_search_result(ex, &SearchResult { status: splat_u(4u32), near: e_127, far: e_128, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: e_129, }, &ret);
} }
lanes! { fn search_layers(r: &Resources<'_>, path_a0: &Path) -> U {
    let slot_6 = (if (path_a0.ray == 1u32) { 2u32 } else { 1u32 });
    return splat_u(r.surface_settings.maps[slot_6 as usize].layers);
} }
lanes! { fn signed_factors(r: &Resources<'_>, within: M, path_a0: &Path, texel_a1: Vec2<I>, layer_a2: I, level_a3: i32) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let e_4 = search_texel_llls(r, ex, path_a0, texel_a1, layer_a2, level_a3);
    return Vec4 { x: sub(mul(splat(2.0f32), e_4.x), splat(1.0f32)), y: sub(mul(splat(2.0f32), e_4.y), splat(1.0f32)), z: sub(mul(splat(2.0f32), e_4.z), splat(1.0f32)), w: sub(mul(splat(2.0f32), e_4.w), splat(1.0f32)) };
} }
lanes! { fn four_terms(r: &Resources<'_>, t00_a0: Vec4<F>, t10_a1: Vec4<F>, t01_a2: Vec4<F>, t11_a3: Vec4<F>) -> FourTerms {
    return FourTerms { first: Vec4 { x: t00_a0.x, y: t10_a1.x, z: t01_a2.x, w: t11_a3.x }, second: Vec4 { x: t00_a0.y, y: t10_a1.y, z: t01_a2.y, w: t11_a3.y }, third: Vec4 { x: t00_a0.z, y: t10_a1.z, z: t01_a2.z, w: t11_a3.z }, fourth: Vec4 { x: t00_a0.w, y: t10_a1.w, z: t01_a2.w, w: t11_a3.w }, };
} }
lanes! { fn with_terms(r: &Resources<'_>, before_a0: Vec4<F>, texels_a1: &FourTerms, view_a2: Vec4<F>) -> Vec4<F> {
    let one_6 = Vec4 { x: add(before_a0.x, mul(texels_a1.first.x, view_a2.x)), y: add(before_a0.y, mul(texels_a1.first.y, view_a2.x)), z: add(before_a0.z, mul(texels_a1.first.z, view_a2.x)), w: add(before_a0.w, mul(texels_a1.first.w, view_a2.x)) };
    let two_10 = Vec4 { x: add(one_6.x, mul(texels_a1.second.x, view_a2.y)), y: add(one_6.y, mul(texels_a1.second.y, view_a2.y)), z: add(one_6.z, mul(texels_a1.second.z, view_a2.y)), w: add(one_6.w, mul(texels_a1.second.w, view_a2.y)) };
    let three_14 = Vec4 { x: add(two_10.x, mul(texels_a1.third.x, view_a2.z)), y: add(two_10.y, mul(texels_a1.third.y, view_a2.z)), z: add(two_10.z, mul(texels_a1.third.z, view_a2.z)), w: add(two_10.w, mul(texels_a1.third.w, view_a2.z)) };
    return Vec4 { x: add(three_14.x, mul(texels_a1.fourth.x, view_a2.w)), y: add(three_14.y, mul(texels_a1.fourth.y, view_a2.w)), z: add(three_14.z, mul(texels_a1.fourth.z, view_a2.w)), w: add(three_14.w, mul(texels_a1.fourth.w, view_a2.w)) };
} }
stage! { fn summed_ways(r: &Resources<'_>, within: M, path_a0: &Path, around_a1: &Around, pair_a2: &ViewPair, params_a3: Vec4<f32>, layers_a4: U) -> Vec4<F> {
    let mut ex = within;
    let mut ret: Vec4<F> = Vec4 { x: splat(0f32), y: splat(0f32), z: splat(0f32), w: splat(0f32) };
    let mut lower_v0: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    let mut upper_v1: Vec4<F> = Vec4 { x: splat(0.0f32), y: splat(0.0f32), z: splat(0.0f32), w: splat(0.0f32) };
    let mut layer_v2: I = splat_i(0i32);
    let n_6 = r.height_texels(path_a0.level);
    let level_8 = (path_a0.level as i32);
    let bends_10 = (params_a3.z as i32);
    let lower_view_15 = add_i(mul_i(pair_a2.layer, splat_i(bends_10)), i_of_f(pair_a2.bend));
    let of_lower_16 = factor_place(r, lower_view_15, n_6);
    let of_upper_18 = factor_place(r, add_i(lower_view_15, splat_i(bends_10)), n_6);
    let scale_number_23 = ((params_a3.x * params_a3.y) as i32).wrapping_mul(bends_10);
    let b2 = ex;
    'l1: loop {
        let e_38 = layer_v2;
        let c3 = lt_i(e_38, i_of_u(layers_a4));
        ex = and(ex, c3);
        let e_41 = layer_v2;
        if none(ex) { break 'l1; }
        let scales_42 = term_scales_lssl(r, ex, path_a0, scale_number_23, n_6, e_41);
        let e_43 = layer_v2;
        let e_44 = signed_factors(r, ex, path_a0, of_lower_16, e_43, level_8);
        let a_45 = Vec4 { x: mul(e_44.x, scales_42.x), y: mul(e_44.y, scales_42.y), z: mul(e_44.z, scales_42.z), w: mul(e_44.w, scales_42.w) };
        let e_46 = layer_v2;
        let e_47 = signed_factors(r, ex, path_a0, of_upper_18, e_46, level_8);
        let b_48 = Vec4 { x: mul(e_47.x, scales_42.x), y: mul(e_47.y, scales_42.y), z: mul(e_47.z, scales_42.z), w: mul(e_47.w, scales_42.w) };
        let e_54 = layer_v2;
        let e_55 = signed_factors(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: around_a1.rows.x }, e_54, level_8);
        let e_61 = layer_v2;
        let e_62 = signed_factors(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: around_a1.rows.x }, e_61, level_8);
        let e_68 = layer_v2;
        let e_69 = signed_factors(r, ex, path_a0, Vec2 { x: around_a1.columns.x, y: around_a1.rows.y }, e_68, level_8);
        let e_75 = layer_v2;
        let e_76 = signed_factors(r, ex, path_a0, Vec2 { x: around_a1.columns.y, y: around_a1.rows.y }, e_75, level_8);
        let texels_77 = four_terms(r, e_55, e_62, e_69, e_76);
        let e_78 = lower_v0;
        let e_79 = with_terms(r, e_78, &texels_77, a_45);
        let (m4, y5) = (ex, e_79);
        lower_v0 = Vec4 { x: sel(m4, y5.x, lower_v0.x), y: sel(m4, y5.y, lower_v0.y), z: sel(m4, y5.z, lower_v0.z), w: sel(m4, y5.w, lower_v0.w) };
        let e_80 = upper_v1;
        let e_81 = with_terms(r, e_80, &texels_77, b_48);
        let (m6, y7) = (ex, e_81);
        upper_v1 = Vec4 { x: sel(m6, y7.x, upper_v1.x), y: sel(m6, y7.y, upper_v1.y), z: sel(m6, y7.z, upper_v1.z), w: sel(m6, y7.w, upper_v1.w) };
        let e_82 = layer_v2;
        layer_v2 = add_i(e_82, splat_i(1i32));
    }
    ex = b2;
    let e_85 = lower_v0;
    let e_86 = upper_v1;
    let e_88 = joined_texels(r, e_85, e_86, Vec2 { x: around_a1.part.x, y: around_a1.part.y });
    return e_88;
} }
lanes! { fn texel_reads(r: &Resources<'_>, path_a0: &Path, reads_a1: U) -> Vec3<U> {
    let e_2 = map_read(r, path_a0, reads_a1);
    return Vec3 { x: add_u(e_2.x, sub_u(reads_a1, splat_u(1u32))), y: add_u(e_2.y, splat_u(0u32)), z: add_u(e_2.z, splat_u(0u32)) };
} }
stage! { fn search_view_dependent_svd(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut joined_v0: JoinedViews = zero_joined_views();
    let mut k_v1: U = splat_u(0u32);
    let axes_3 = path_axes(r, ex, path_a0, params_a1.w);
    let (b1, c2) = (ex, eq_u(axes_3.comes_in, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(0u32), near: path_a0.exit, far: path_a0.exit, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: Vec3 { x: splat_u(0u32), y: splat_u(1u32), z: splat_u(0u32) }, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let views_14 = views_around(r, &axes_3, params_a1);
    let e_16 = path_uv(r, path_a0, axes_3.start);
    let e_18 = r.height_texels(path_a0.level);
    let around_19 = texels_around(r, ex, e_16, e_18);
    let layers_20 = search_layers(r, path_a0);
    let e_21 = no_views(r);
    joined_v0 = e_21;
    let b4 = ex;
    'l3: loop {
        let e_25 = k_v1;
        let c5 = lt_u(e_25, views_14.pairs);
        ex = and(ex, c5);
        let e_28 = k_v1;
        if none(ex) { break 'l3; }
        let e_29 = view_pair(r, &views_14, e_28);
        let ways_30 = summed_ways(r, ex, path_a0, &around_19, &e_29, params_a1, layers_20);
        let e_31 = joined_v0;
        let e_32 = k_v1;
        let e_33 = with_pair(r, ex, &e_31, &views_14, e_32, ways_30);
        joined_v0 = sel_joined_views(ex, &e_33, &joined_v0);
        let e_34 = k_v1;
        k_v1 = add_u(e_34, splat_u(1u32));
    }
    ex = b4;
    let e_42 = texel_reads(r, path_a0, mul_u(mul_u(views_14.pairs, layers_20), splat_u(8u32)));
    let cost_43 = Vec3 { x: add_u(splat_u(0u32), e_42.x), y: add_u(splat_u(1u32), e_42.y), z: add_u(splat_u(0u32), e_42.z) };
    let e_44 = joined_v0;
    let e_45 = joined_way(r, &e_44, &views_14);
    let e_46 = hit_on_way(r, ex, path_a0, &axes_3, e_45, cost_43);
    return sel_search_result(ex, &e_46, &ret);
} }
stage! { fn search_view_dependent_clusters(r: &Resources<'_>, within: M, path_a0: &Path, params_a1: Vec4<f32>) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    let mut joined_v0: JoinedViews = zero_joined_views();
    let mut k_v1: U = splat_u(0u32);
    let axes_3 = path_axes(r, ex, path_a0, params_a1.w);
    let (b1, c2) = (ex, eq_u(axes_3.comes_in, splat_u(0u32)));
    ex = and(b1, c2);
    if any(ex) {
        ret = SearchResult { status: splat_u(0u32), near: path_a0.exit, far: path_a0.exit, near_gap: splat(1.0f32), far_gap: splat(1.0f32), cost: Vec3 { x: splat_u(0u32), y: splat_u(1u32), z: splat_u(0u32) }, };
        ex = no_lane();
    }
    ex = and_not(b1, c2);
    if none(ex) { return ret; }
    let views_14 = views_around(r, &axes_3, params_a1);
    let e_16 = path_uv(r, path_a0, axes_3.start);
    let e_18 = r.height_texels(path_a0.level);
    let around_19 = texels_around(r, ex, e_16, e_18);
    let layers_20 = search_layers(r, path_a0);
    let e_21 = no_views(r);
    joined_v0 = e_21;
    let b4 = ex;
    'l3: loop {
        let e_25 = k_v1;
        let c5 = lt_u(e_25, views_14.pairs);
        ex = and(ex, c5);
        let e_28 = k_v1;
        if none(ex) { break 'l3; }
        let e_29 = view_pair(r, &views_14, e_28);
        let ways_30 = clustered_ways(r, ex, path_a0, &around_19, &e_29, params_a1, layers_20);
        let e_31 = joined_v0;
        let e_32 = k_v1;
        let e_33 = with_pair(r, ex, &e_31, &views_14, e_32, ways_30);
        joined_v0 = sel_joined_views(ex, &e_33, &joined_v0);
        let e_34 = k_v1;
        k_v1 = add_u(e_34, splat_u(1u32));
    }
    ex = b4;
    let e_48 = texel_reads(r, path_a0, mul_u(mul_u(views_14.pairs, splat_u(4u32)), add_u(splat_u(1u32), mul_u(sub_u(layers_20, splat_u(1u32)), splat_u(5u32)))));
    let cost_49 = Vec3 { x: add_u(splat_u(0u32), e_48.x), y: add_u(splat_u(1u32), e_48.y), z: add_u(splat_u(0u32), e_48.z) };
    let e_50 = joined_v0;
    let e_51 = joined_way(r, &e_50, &views_14);
    let e_52 = hit_on_way(r, ex, path_a0, &axes_3, e_51, cost_49);
    return sel_search_result(ex, &e_52, &ret);
} }
lanes! { fn search_stage(r: &Resources<'_>, within: M, path_a0: &Path) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    match r.surface_settings.choices[6].number {
        0u32 => {
            let e_11 = search_none(r, path_a0, r.surface_settings.choices[6].params);
            return e_11;
        }
        1u32 => {
            let e_17 = search_linear(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_17;
        }
        2u32 => {
            let e_23 = search_cells(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_23;
        }
        3u32 => {
            let e_29 = search_frustum(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_29;
        }
        4u32 => {
            let e_35 = search_cone(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_35;
        }
        5u32 => {
            let e_41 = search_pyramid(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_41;
        }
        6u32 => {
            let e_47 = search_pyramid_texels(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_47;
        }
        7u32 => {
            let e_53 = search_dilation_erosion(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_53;
        }
        8u32 => {
            let e_59 = search_sphere(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_59;
        }
        9u32 => {
            let e_65 = search_cone_moved(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_65;
        }
        10u32 => {
            let e_71 = search_relaxed_cone(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_71;
        }
        11u32 => {
            let e_77 = search_relaxed_cone_resting(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_77;
        }
        12u32 => {
            let e_83 = search_voxels(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_83;
        }
        13u32 => {
            let e_89 = search_generalised(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_89;
        }
        14u32 => {
            let e_95 = search_view_dependent(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_95;
        }
        15u32 => {
            let e_101 = search_view_dependent_free(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_101;
        }
        16u32 => {
            let e_107 = search_translucent(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_107;
        }
        17u32 => {
            let e_113 = search_shell_map(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_113;
        }
        18u32 => {
            let e_119 = search_view_dependent_svd(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_119;
        }
        _ => {
            let e_125 = search_view_dependent_clusters(r, ex, path_a0, r.surface_settings.choices[6].params);
            return e_125;
        }
    }
} }
stage! { pub(super) fn trace(r: &Resources<'_>, within: M, path_a0: &Path) -> Hit {
    let mut ex = within;
    let mut ret: Hit = zero_hit();
    let e_1 = search_stage(r, ex, path_a0);
    let e_2 = refine_stage(r, ex, path_a0, &e_1);
    return e_2;
} }
stage! { pub(super) fn shadow_search_stage(r: &Resources<'_>, within: M, path_a0: &Path) -> SearchResult {
    let mut ex = within;
    let mut ret: SearchResult = zero_search_result();
    match r.surface_settings.choices[10].number {
        0u32 => {
            let e_11 = search_none(r, path_a0, r.surface_settings.choices[10].params);
            return e_11;
        }
        1u32 => {
            let e_17 = search_linear(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_17;
        }
        2u32 => {
            let e_23 = search_cells(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_23;
        }
        3u32 => {
            let e_29 = search_frustum(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_29;
        }
        4u32 => {
            let e_35 = search_cone(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_35;
        }
        5u32 => {
            let e_41 = search_pyramid(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_41;
        }
        6u32 => {
            let e_47 = search_pyramid_texels(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_47;
        }
        7u32 => {
            let e_53 = search_dilation_erosion(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_53;
        }
        8u32 => {
            let e_59 = search_sphere(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_59;
        }
        9u32 => {
            let e_65 = search_cone_moved(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_65;
        }
        10u32 => {
            let e_71 = search_relaxed_cone(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_71;
        }
        11u32 => {
            let e_77 = search_relaxed_cone_resting(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_77;
        }
        12u32 => {
            let e_83 = search_voxels(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_83;
        }
        13u32 => {
            let e_89 = search_generalised(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_89;
        }
        14u32 => {
            let e_95 = search_view_dependent(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_95;
        }
        15u32 => {
            let e_101 = search_view_dependent_free(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_101;
        }
        16u32 => {
            let e_107 = search_translucent(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_107;
        }
        17u32 => {
            let e_113 = search_shell_map(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_113;
        }
        18u32 => {
            let e_119 = search_view_dependent_svd(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_119;
        }
        _ => {
            let e_125 = search_view_dependent_clusters(r, ex, path_a0, r.surface_settings.choices[10].params);
            return e_125;
        }
    }
} }
