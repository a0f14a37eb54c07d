// The functions that reach a mark. Written by `cargo xtask link`; do not edit.

use super::Marked;
use crate::cpu::generated::*;
use crate::cpu::runtime as rt;
use crate::cpu::runtime::{Convert as _, SquareRoot as _};

impl Marked<'_> {
    pub(super) fn v_entered_once(
        &self,
        path_17: Path,
        grid_5: Grid,
        above: rt::Scalar<f32>,
        below: rt::Scalar<f32>,
        above_gap: rt::Scalar<f32>,
        below_gap: rt::Scalar<f32>,
        so_far: rt::Vec3<u32>,
    ) -> SearchResult {
        let mut near_2: rt::Scalar<f32>;
        let mut far_2: rt::Scalar<f32>;
        let mut near_gap: rt::Scalar<f32>;
        let mut far_gap: rt::Scalar<f32>;
        let mut cost_1: rt::Vec3<u32>;
        let mut local_4: rt::Scalar<bool>;

        near_2 = above;
        far_2 = below;
        near_gap = above_gap;
        far_gap = below_gap;
        cost_1 = so_far;
        let wide = (grid_5.step.x().abs() + grid_5.step.y().abs());
        'naga_break: loop {
            'naga_continue: {
                let _e19 = far_2;
                let _e20 = near_2;
                if rt::Scalar::into_branch_condition((wide * (_e19 - _e20)).elementwise_gt(rt::Scalar(3f32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = cost_1;
                    cost_1 = (_e25 + STEP);
                    let _e28 = near_2;
                    let _e29 = far_2;
                    let middle_1 = (rt::Scalar(0.5f32) * (_e28 + _e29));
                    self.v_mark_turn(middle_1);
                    let _e33 = near_2;
                    let _e34 = far_2;
                    self.v_mark_bracket(_e33, _e34);
                    let _e35 = near_2;
                    if rt::Scalar::into_branch_condition(middle_1.elementwise_gt(_e35)) {
                        let _e39 = far_2;
                        local_4 = middle_1.elementwise_lt(_e39);
                    } else {
                        local_4 = rt::Scalar(false);
                    }
                    let _e42 = local_4;
                    if rt::Scalar::into_branch_condition((!_e42)) {
                        break 'naga_break;
                    }
                    let _e44 = self.v_path_gap(path_17, middle_1);
                    let _e45 = cost_1;
                    cost_1 = (_e45 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e44.elementwise_le(rt::Scalar(0f32))) {
                        far_2 = middle_1;
                        far_gap = _e44;
                    } else {
                        near_2 = middle_1;
                        near_gap = _e44;
                    }
                }
            }
        }
        let _e51 = near_2;
        let _e52 = far_2;
        let _e53 = near_gap;
        let _e54 = far_gap;
        let _e55 = cost_1;
        return <SearchResult>::new(FOUND_BRACKET, _e51, _e52, _e53, _e54, _e55);
    }
    pub(super) fn v_refine_binary(
        &self,
        path_35: Path,
        found_5: SearchResult,
        params_21: rt::Vec4<f32>,
    ) -> Hit {
        let mut near_8: rt::Scalar<f32>;
        let mut far_8: rt::Scalar<f32>;
        let mut cost_9: rt::Vec3<u32>;
        let mut local_36: rt::Scalar<bool>;
        let mut crossed: rt::Scalar<bool>;
        let mut k_3: rt::Scalar<f32> = rt::Scalar(0f32);

        let _e3 = self.v_has_interval(found_5);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_35, found_5, params_21);
            return _e5;
        }
        near_8 = rt::Scalar(found_5.near);
        far_8 = rt::Scalar(found_5.far);
        cost_9 = found_5.cost;
        if rt::Scalar::into_branch_condition((!rt::Scalar(found_5.status).elementwise_eq(FOUND_BRACKET))) {
            let _e18 = far_8;
            let _e19 = self.v_path_height(path_35, _e18);
            local_36 = _e19.elementwise_le(rt::Scalar(0.000001f32));
        } else {
            local_36 = rt::Scalar(true);
        }
        let _e23 = local_36;
        crossed = _e23;
        'naga_break: loop {
            'naga_continue: {
                let _e27 = k_3;
                if rt::Scalar::into_branch_condition(_e27.elementwise_lt(params_21.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e30 = cost_9;
                    cost_9 = (_e30 + STEP);
                    let _e33 = near_8;
                    let _e34 = far_8;
                    let middle_4 = (rt::Scalar(0.5f32) * (_e33 + _e34));
                    self.v_mark_turn(middle_4);
                    let _e38 = near_8;
                    let _e39 = far_8;
                    self.v_mark_bracket(_e38, _e39);
                    self.v_mark_sample(middle_4);
                    let _e40 = cost_9;
                    let _e42 = self.v_field_cost_stage(rt::Scalar(path_35.level));
                    cost_9 = (_e40 + _e42);
                    let _e44 = self.v_path_gap(path_35, middle_4);
                    if rt::Scalar::into_branch_condition(_e44.elementwise_le(rt::Scalar(0f32))) {
                        far_8 = middle_4;
                        crossed = rt::Scalar(true);
                    } else {
                        near_8 = middle_4;
                    }
                    let _e48 = k_3;
                    k_3 = (_e48 + rt::Scalar(1f32));
                }
            }
        }
        let _e51 = crossed;
        if rt::Scalar::into_branch_condition((!_e51)) {
            let _e53 = cost_9;
            let _e54 = self.v_miss(_e53);
            return _e54;
        }
        let _e55 = near_8;
        let _e56 = far_8;
        let _e61 = cost_9;
        let _e62 = self.v_hit_on_path(path_35, (rt::Scalar(0.5f32) * (_e55 + _e56)), rt::Scalar(0u32), _e61);
        return _e62;
    }
    pub(super) fn v_refine_half_texel(
        &self,
        path_36: Path,
        found_6: SearchResult,
        params_22: rt::Vec4<f32>,
    ) -> Hit {
        let mut part_3: rt::Scalar<f32> = rt::Scalar(0.5f32);

        if rt::Scalar::into_branch_condition(rt::Scalar(found_6.status).elementwise_ne(FOUND_BELOW)) {
            let _e6 = self.v_refine_none(path_36, found_6, params_22);
            return _e6;
        }
        let _e9 = self.v_height_size(rt::Scalar(path_36.level));
        let speed_2 = (path_36.duv * _e9).length();
        if rt::Scalar::into_branch_condition((!(speed_2 * rt::Scalar(path_36.exit)).elementwise_gt(rt::Scalar(0.5f32)))) {
            let _e17 = self.v_refine_none(path_36, found_6, params_22);
            return _e17;
        }
        let half = (rt::Scalar(0.5f32) / speed_2);
        let backward = (rt::Scalar(found_6.far) - half).max(rt::Scalar(0f32));
        let forward_2 = (rt::Scalar(found_6.far) + half).min(rt::Scalar(path_36.exit));
        let _e28 = self.v_path_gap(path_36, backward);
        let before_4 = _e28.abs();
        let _e30 = self.v_path_gap(path_36, forward_2);
        let behind_1 = _e30.abs();
        if rt::Scalar::into_branch_condition((before_4 + behind_1).elementwise_gt(rt::Scalar(0f32))) {
            part_3 = (before_4 / (before_4 + behind_1));
        }
        self.v_mark_bracket(backward, forward_2);
        self.v_mark_chord(backward, before_4, forward_2, (rt::Scalar(0f32) - behind_1));
        let cost_29 = ((found_6.cost + HEIGHTS_READ) + HEIGHTS_READ);
        let _e47 = part_3;
        let _e51 = self.v_hit_on_path(path_36, (backward + ((forward_2 - backward) * _e47)), rt::Scalar(0u32), cost_29);
        return _e51;
    }
    pub(super) fn v_refine_offset(
        &self,
        path_37: Path,
        found_7: SearchResult,
        params_23: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_24: rt::Scalar<f32>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_7.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_7.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_37, found_7);
        let _e9 = self.v_path_uv(path_37, _e8);
        let _e11 = self.v_height_at(_e9, rt::Scalar(path_37.level));
        self.v_mark_plane(_e8, _e11, rt::Scalar(0f32));
        let _e13 = self.v_path_slope(path_37, _e8);
        t_24 = _e8;
        if rt::Scalar::into_branch_condition(_e13.elementwise_ne(rt::Scalar(0f32))) {
            let _e17 = self.v_path_height(path_37, _e8);
            t_24 = (_e8 + ((_e11 - _e17) / _e13));
        }
        let _e21 = t_24;
        let _e31 = self.v_hit_on_path(path_37, _e21, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_7.status).elementwise_eq(FOUND_EXHAUSTED)), (found_7.cost + HEIGHTS_READ));
        return _e31;
    }
    pub(super) fn v_refine_offset_limited(
        &self,
        path_38: Path,
        found_8: SearchResult,
        params_24: rt::Vec4<f32>,
    ) -> Hit {
        let mut hit: Hit;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_8.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_8.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_38, found_8);
        let _e9 = self.v_path_uv(path_38, _e8);
        let _e11 = self.v_height_at(_e9, rt::Scalar(path_38.level));
        self.v_mark_plane(_e8, _e11, rt::Scalar(0f32));
        let _e13 = self.v_path_height(path_38, _e8);
        let rise_m = ((_e11 - _e13) * path_38.metric.w());
        let exhausted_2 = rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_8.status).elementwise_eq(FOUND_EXHAUSTED));
        let _e28 = self.v_hit_on_path(path_38, (_e8 - rise_m), exhausted_2, (found_8.cost + HEIGHTS_READ));
        hit = _e28;
        let _e31 = rt::Scalar(hit.found);
        if rt::Scalar::into_branch_condition(_e31.elementwise_eq(rt::Scalar(1u32))) {
            rt::Scalar(hit.height) = _e11;
        }
        let _e35 = hit;
        return _e35;
    }
    pub(super) fn v_refine_patch(
        &self,
        path_39: Path,
        found_9: SearchResult,
        params_25: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_25: rt::Scalar<f32>;
        let mut cell_32: rt::Vec2<f32>;
        let mut cost_10: rt::Vec3<u32>;
        let mut local_37: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_9.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_9.cost);
            return _e7;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(found_9.status).elementwise_eq(FOUND_EXHAUSTED)) {
            let _e14 = self.v_hit_on_path(path_39, rt::Scalar(found_9.near), rt::Scalar(1u32), found_9.cost);
            return _e14;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(found_9.status).elementwise_eq(FOUND_STARTED_BELOW)) {
            let _e21 = self.v_hit_on_path(path_39, rt::Scalar(found_9.near), rt::Scalar(0u32), found_9.cost);
            return _e21;
        }
        let _e22 = self.v_grid_of(path_39);
        t_25 = rt::Scalar(found_9.near);
        let _e27 = t_25;
        let _e30 = self.v_cell_of((_e22.origin + (_e22.step * _e27)));
        cell_32 = _e30;
        cost_10 = found_9.cost;
        let _e35 = cost_10.x();
        let limit_2 = (_e35 + params_25.x().to_u32());
        'naga_break: loop {
            'naga_continue: {
                let _e40 = cost_10.x();
                if rt::Scalar::into_branch_condition(_e40.elementwise_lt(limit_2)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e42 = cost_10;
                    cost_10 = (_e42 + STEP);
                    let _e45 = t_25;
                    self.v_mark_turn(_e45);
                    let _e46 = cell_32;
                    let _e47 = self.v_cell_leave(_e22, _e46);
                    let end_5 = _e47.x().min(_e47.y()).min(rt::Scalar(found_9.far));
                    let _e53 = t_25;
                    let span_7 = (end_5 - _e53).max(rt::Scalar(0f32));
                    let _e57 = cell_32;
                    let _e58 = t_25;
                    self.v_mark_patch(_e57, _e58, end_5);
                    let _e59 = cell_32;
                    let _e60 = t_25;
                    let _e61 = self.v_cell_gap(path_39, _e22, _e59, _e60);
                    let _e62 = cost_10;
                    cost_10 = (_e62 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e61.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e68 = t_25;
                        let _e70 = cost_10;
                        let _e71 = self.v_hit_on_path(path_39, _e68, rt::Scalar(0u32), _e70);
                        return _e71;
                    }
                    let _e72 = self.v_first_root(_e61, span_7);
                    if rt::Scalar::into_branch_condition(_e72.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e75 = t_25;
                        let _e78 = cost_10;
                        let _e79 = self.v_hit_on_path(path_39, (_e75 + _e72), rt::Scalar(0u32), _e78);
                        return _e79;
                    }
                    if rt::Scalar::into_branch_condition(end_5.elementwise_ge(rt::Scalar(found_9.far))) {
                        if rt::Scalar::into_branch_condition((!rt::Scalar(found_9.status).elementwise_eq(FOUND_BRACKET))) {
                            local_37 = rt::Scalar(found_9.status).elementwise_eq(FOUND_BELOW);
                        } else {
                            local_37 = rt::Scalar(true);
                        }
                        let _e92 = local_37;
                        if rt::Scalar::into_branch_condition(_e92) {
                            let _e95 = cost_10;
                            let _e96 = self.v_hit_on_path(path_39, rt::Scalar(found_9.far), rt::Scalar(0u32), _e95);
                            return _e96;
                        }
                        let _e97 = cost_10;
                        let _e98 = self.v_miss(_e97);
                        return _e98;
                    }
                    let _e99 = cell_32;
                    let _e100 = self.v_cell_next(_e22, _e99, _e47);
                    cell_32 = _e100;
                    let _e101 = t_25;
                    t_25 = _e101.max(end_5);
                }
            }
        }
        let _e103 = t_25;
        let _e105 = cost_10;
        let _e106 = self.v_hit_on_path(path_39, _e103, rt::Scalar(1u32), _e105);
        return _e106;
    }
    pub(super) fn v_refine_secant(
        &self,
        path_40: Path,
        found_10: SearchResult,
        params_26: rt::Vec4<f32>,
    ) -> Hit {
        let mut near_9: rt::Scalar<f32>;
        let mut far_9: rt::Scalar<f32>;
        let mut near_gap_2: rt::Scalar<f32>;
        let mut far_gap_2: rt::Scalar<f32>;
        let mut cost_11: rt::Vec3<u32>;
        let mut t_26: rt::Scalar<f32>;
        let mut k_4: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e3 = self.v_has_interval(found_10);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_40, found_10, params_26);
            return _e5;
        }
        near_9 = rt::Scalar(found_10.near);
        far_9 = rt::Scalar(found_10.far);
        near_gap_2 = rt::Scalar(found_10.near_gap);
        far_gap_2 = rt::Scalar(found_10.far_gap);
        cost_11 = found_10.cost;
        if rt::Scalar::into_branch_condition(rt::Scalar(found_10.status).elementwise_ne(FOUND_BRACKET)) {
            let _e19 = near_9;
            let _e20 = self.v_path_gap(path_40, _e19);
            near_gap_2 = _e20;
            let _e21 = far_9;
            let _e22 = self.v_path_gap(path_40, _e21);
            far_gap_2 = _e22;
            let _e23 = cost_11;
            let _e25 = self.v_field_cost_stage(rt::Scalar(path_40.level));
            let _e28 = self.v_field_cost_stage(rt::Scalar(path_40.level));
            cost_11 = ((_e23 + _e25) + _e28);
            let _e30 = far_gap_2;
            if rt::Scalar::into_branch_condition(_e30.elementwise_gt(rt::Scalar(0f32))) {
                let _e33 = cost_11;
                let _e34 = self.v_miss(_e33);
                return _e34;
            }
        }
        let _e35 = far_9;
        t_26 = _e35;
        'naga_break: loop {
            'naga_continue: {
                let _e39 = k_4;
                if rt::Scalar::into_branch_condition(_e39.elementwise_le(params_26.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e42 = cost_11;
                    cost_11 = (_e42 + STEP);
                    let _e45 = t_26;
                    self.v_mark_turn(_e45);
                    let _e46 = near_9;
                    let _e47 = far_9;
                    self.v_mark_bracket(_e46, _e47);
                    let _e48 = near_9;
                    let _e49 = near_gap_2;
                    let _e50 = far_9;
                    let _e51 = far_gap_2;
                    self.v_mark_chord(_e48, _e49, _e50, _e51);
                    let _e52 = near_gap_2;
                    let _e53 = far_gap_2;
                    let drop = (_e52 - _e53);
                    if rt::Scalar::into_branch_condition((!drop.elementwise_gt(rt::Scalar(0f32)))) {
                        break 'naga_break;
                    }
                    let _e58 = near_9;
                    let _e59 = far_9;
                    let _e60 = near_9;
                    let _e62 = near_gap_2;
                    t_26 = (_e58 + ((_e59 - _e60) * (_e62 / drop)));
                    let _e66 = k_4;
                    if rt::Scalar::into_branch_condition(_e66.elementwise_lt(params_26.x())) {
                        let _e69 = t_26;
                        self.v_mark_sample(_e69);
                        let _e70 = t_26;
                        let _e71 = self.v_path_gap(path_40, _e70);
                        let _e72 = cost_11;
                        let _e74 = self.v_field_cost_stage(rt::Scalar(path_40.level));
                        cost_11 = (_e72 + _e74);
                        if rt::Scalar::into_branch_condition(_e71.elementwise_le(rt::Scalar(0f32))) {
                            let _e78 = t_26;
                            far_9 = _e78;
                            far_gap_2 = _e71;
                        } else {
                            let _e79 = t_26;
                            near_9 = _e79;
                            near_gap_2 = _e71;
                        }
                    }
                    let _e80 = k_4;
                    k_4 = (_e80 + rt::Scalar(1f32));
                }
            }
        }
        let _e83 = t_26;
        let _e85 = cost_11;
        let _e86 = self.v_hit_on_path(path_40, _e83, rt::Scalar(0u32), _e85);
        return _e86;
    }
    pub(super) fn v_refine_slope(
        &self,
        path_41: Path,
        found_11: SearchResult,
        params_27: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_27: rt::Scalar<f32>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_11.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_11.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_41, found_11);
        let _e9 = self.v_path_uv(path_41, _e8);
        let _e11 = self.v_height_and_slope(_e9, rt::Scalar(path_41.level));
        self.v_mark_plane(_e8, _e11.x(), <rt::Vec2<f32>>::from_scalars(_e11.y(), _e11.z()).dot(path_41.duv));
        let _e19 = self.v_path_height(path_41, _e8);
        let rise_2 = (_e11.x() - _e19);
        t_27 = _e8;
        if rt::Scalar::into_branch_condition(params_27.x().elementwise_gt(rt::Scalar(0.5f32))) {
            let _e25 = self.v_path_slope(path_41, _e8);
            let closing = (_e25 - ((_e11.y() * path_41.duv.x()) + (_e11.z() * path_41.duv.y())));
            if rt::Scalar::into_branch_condition(closing.elementwise_lt(rt::Scalar(0f32))) {
                t_27 = (_e8 + (rise_2 / closing));
            }
        } else {
            let _e46 = self.v_normal_z(path_41, <rt::Vec2<f32>>::from_scalars(_e11.y(), _e11.z()));
            t_27 = (_e8 - ((rise_2 * path_41.metric.w()) * _e46));
        }
        let _e49 = t_27;
        let _e59 = self.v_hit_on_path(path_41, _e49, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_11.status).elementwise_eq(FOUND_EXHAUSTED)), (found_11.cost + HEIGHTS_READ));
        return _e59;
    }
    pub(super) fn v_refine_slope_iterative(
        &self,
        path_42: Path,
        found_12: SearchResult,
        params_28: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_28: rt::Scalar<f32>;
        let mut cost_12: rt::Vec3<u32>;
        let mut k_5: rt::Scalar<f32> = rt::Scalar(0f32);

        if rt::Scalar::into_branch_condition(rt::Scalar(found_12.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_12.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_42, found_12);
        t_28 = _e8;
        cost_12 = found_12.cost;
        'naga_break: loop {
            'naga_continue: {
                let _e14 = k_5;
                if rt::Scalar::into_branch_condition(_e14.elementwise_lt(params_28.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e17 = cost_12;
                    cost_12 = (_e17 + STEP);
                    let _e20 = t_28;
                    self.v_mark_turn(_e20);
                    let _e21 = t_28;
                    let _e22 = self.v_path_uv(path_42, _e21);
                    let _e24 = self.v_height_and_slope(_e22, rt::Scalar(path_42.level));
                    let _e25 = cost_12;
                    cost_12 = (_e25 + HEIGHTS_READ);
                    let _e28 = t_28;
                    self.v_mark_plane(_e28, _e24.x(), <rt::Vec2<f32>>::from_scalars(_e24.y(), _e24.z()).dot(path_42.duv));
                    let _e36 = t_28;
                    let _e37 = self.v_path_height(path_42, _e36);
                    let rise_3 = (_e24.x() - _e37);
                    if rt::Scalar::into_branch_condition(params_28.y().elementwise_gt(rt::Scalar(0.5f32))) {
                        let _e42 = t_28;
                        let _e43 = self.v_path_slope(path_42, _e42);
                        let closing_1 = (_e43 - ((_e24.y() * path_42.duv.x()) + (_e24.z() * path_42.duv.y())));
                        if rt::Scalar::into_branch_condition(closing_1.elementwise_lt(rt::Scalar(0f32))) {
                            let _e56 = t_28;
                            t_28 = (_e56 + (rise_3 / closing_1));
                        }
                    } else {
                        let _e59 = t_28;
                        let _e66 = self.v_normal_z(path_42, <rt::Vec2<f32>>::from_scalars(_e24.y(), _e24.z()));
                        t_28 = (_e59 - ((rise_3 * path_42.metric.w()) * _e66));
                    }
                    let _e69 = t_28;
                    t_28 = _e69.clamp(rt::Scalar(0f32), rt::Scalar(path_42.exit));
                    let _e73 = k_5;
                    k_5 = (_e73 + rt::Scalar(1f32));
                }
            }
        }
        let _e76 = t_28;
        let _e83 = cost_12;
        let _e84 = self.v_hit_on_path(path_42, _e76, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_12.status).elementwise_eq(FOUND_EXHAUSTED)), _e83);
        return _e84;
    }
    pub(super) fn v_refine_stage(&self, path_45: Path, found_15: SearchResult) -> Hit {
        let _e6 = rt::Scalar(self.surface_settings.choices[7usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[7usize].params;
                let _e12 = self.v_refine_none(path_45, found_15, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[7usize].params;
                let _e18 = self.v_refine_offset(path_45, found_15, _e17);
                return _e18;
            }
            2u32 => {
                let _e23 = self.surface_settings.choices[7usize].params;
                let _e24 = self.v_refine_offset_limited(path_45, found_15, _e23);
                return _e24;
            }
            3u32 => {
                let _e29 = self.surface_settings.choices[7usize].params;
                let _e30 = self.v_refine_slope(path_45, found_15, _e29);
                return _e30;
            }
            4u32 => {
                let _e35 = self.surface_settings.choices[7usize].params;
                let _e36 = self.v_refine_slope_iterative(path_45, found_15, _e35);
                return _e36;
            }
            5u32 => {
                let _e41 = self.surface_settings.choices[7usize].params;
                let _e42 = self.v_refine_binary(path_45, found_15, _e41);
                return _e42;
            }
            6u32 => {
                let _e47 = self.surface_settings.choices[7usize].params;
                let _e48 = self.v_refine_secant(path_45, found_15, _e47);
                return _e48;
            }
            7u32 => {
                let _e53 = self.surface_settings.choices[7usize].params;
                let _e54 = self.v_refine_true_secant(path_45, found_15, _e53);
                return _e54;
            }
            8u32 => {
                let _e59 = self.surface_settings.choices[7usize].params;
                let _e60 = self.v_refine_patch(path_45, found_15, _e59);
                return _e60;
            }
            9u32 => {
                let _e65 = self.surface_settings.choices[7usize].params;
                let _e66 = self.v_refine_half_texel(path_45, found_15, _e65);
                return _e66;
            }
            _ => {
                let _e71 = self.surface_settings.choices[7usize].params;
                let _e72 = self.v_refine_trilinear(path_45, found_15, _e71);
                return _e72;
            }
        }
    }
    pub(super) fn v_refine_true_secant(
        &self,
        path_43: Path,
        found_13: SearchResult,
        params_29: rt::Vec4<f32>,
    ) -> Hit {
        let mut before_2: rt::Scalar<f32>;
        let mut last: rt::Scalar<f32>;
        let mut before_gap: rt::Scalar<f32>;
        let mut last_gap: rt::Scalar<f32>;
        let mut cost_13: rt::Vec3<u32>;
        let mut k_6: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e3 = self.v_has_interval(found_13);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_43, found_13, params_29);
            return _e5;
        }
        before_2 = rt::Scalar(found_13.near);
        last = rt::Scalar(found_13.far);
        before_gap = rt::Scalar(found_13.near_gap);
        last_gap = rt::Scalar(found_13.far_gap);
        cost_13 = found_13.cost;
        if rt::Scalar::into_branch_condition(rt::Scalar(found_13.status).elementwise_ne(FOUND_BRACKET)) {
            let _e19 = before_2;
            let _e20 = self.v_path_gap(path_43, _e19);
            before_gap = _e20;
            let _e21 = last;
            let _e22 = self.v_path_gap(path_43, _e21);
            last_gap = _e22;
            let _e23 = cost_13;
            let _e25 = self.v_field_cost_stage(rt::Scalar(path_43.level));
            let _e28 = self.v_field_cost_stage(rt::Scalar(path_43.level));
            cost_13 = ((_e23 + _e25) + _e28);
            let _e30 = last_gap;
            if rt::Scalar::into_branch_condition(_e30.elementwise_gt(rt::Scalar(0f32))) {
                let _e33 = cost_13;
                let _e34 = self.v_miss(_e33);
                return _e34;
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e37 = k_6;
                if rt::Scalar::into_branch_condition(_e37.elementwise_le(params_29.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e40 = cost_13;
                    cost_13 = (_e40 + STEP);
                    let _e43 = last;
                    self.v_mark_turn(_e43);
                    let _e44 = before_2;
                    let _e45 = before_gap;
                    let _e46 = last;
                    let _e47 = last_gap;
                    self.v_mark_chord(_e44, _e45, _e46, _e47);
                    let _e48 = before_gap;
                    let _e49 = last_gap;
                    let change = (_e48 - _e49);
                    if rt::Scalar::into_branch_condition(change.elementwise_eq(rt::Scalar(0f32))) {
                        break 'naga_break;
                    }
                    let _e53 = last;
                    let _e54 = last;
                    let _e55 = before_2;
                    let _e57 = last_gap;
                    let t_45 = (_e53 + ((_e54 - _e55) * (_e57 / change))).clamp(rt::Scalar(found_13.near), rt::Scalar(found_13.far));
                    let _e64 = last;
                    before_2 = _e64;
                    let _e65 = last_gap;
                    before_gap = _e65;
                    last = t_45;
                    let _e66 = k_6;
                    if rt::Scalar::into_branch_condition(_e66.elementwise_lt(params_29.x())) {
                        self.v_mark_sample(t_45);
                        let _e69 = self.v_path_gap(path_43, t_45);
                        last_gap = _e69;
                        let _e70 = cost_13;
                        let _e72 = self.v_field_cost_stage(rt::Scalar(path_43.level));
                        cost_13 = (_e70 + _e72);
                    }
                    let _e74 = k_6;
                    k_6 = (_e74 + rt::Scalar(1f32));
                }
            }
        }
        let _e77 = last;
        let _e79 = cost_13;
        let _e80 = self.v_hit_on_path(path_43, _e77, rt::Scalar(0u32), _e79);
        return _e80;
    }
    pub(super) fn v_search_cells(
        &self,
        path_46: Path,
        params_31: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_33: rt::Vec2<f32>;
        let mut t_29: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_14: rt::Vec3<u32> = NO_COST;

        let _e2 = self.v_grid_of(path_46);
        let _e4 = self.v_cell_of(_e2.origin);
        cell_33 = _e4;
        let limit_3 = params_31.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e13 = cost_14.x();
                if rt::Scalar::into_branch_condition(_e13.elementwise_lt(limit_3)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e15 = cost_14;
                    cost_14 = (_e15 + STEP);
                    let _e18 = t_29;
                    self.v_mark_turn(_e18);
                    let _e19 = cell_33;
                    let _e20 = t_29;
                    let _e21 = self.v_cell_gap(path_46, _e2, _e19, _e20);
                    let _e22 = cost_14;
                    cost_14 = (_e22 + HEIGHTS_READ);
                    let _e25 = cell_33;
                    let _e26 = self.v_cell_leave(_e2, _e25);
                    let end_6 = _e26.x().min(_e26.y()).min(rt::Scalar(path_46.exit));
                    let _e32 = t_29;
                    let span_8 = (end_6 - _e32).max(rt::Scalar(0f32));
                    let _e36 = cell_33;
                    let _e37 = t_29;
                    self.v_mark_patch(_e36, _e37, end_6);
                    let _e38 = self.v_falls_in_cell(_e21, span_8);
                    if rt::Scalar::into_branch_condition(_e38) {
                        let _e39 = t_29;
                        let _e41 = cost_14.x();
                        let _e44 = cost_14;
                        let _e45 = self.v_found_in_cell(_e21, _e39, span_8, _e41.elementwise_eq(rt::Scalar(1u32)), _e44);
                        return _e45;
                    }
                    if rt::Scalar::into_branch_condition(end_6.elementwise_ge(rt::Scalar(path_46.exit))) {
                        let _e49 = t_29;
                        let _e52 = self.v_quadratic(_e21, span_8);
                        let _e53 = cost_14;
                        return <SearchResult>::new(FOUND_MISS, _e49, rt::Scalar(path_46.exit), _e21.x(), _e52, _e53);
                    }
                    let _e55 = cell_33;
                    let _e56 = self.v_cell_next(_e2, _e55, _e26);
                    cell_33 = _e56;
                    let _e57 = t_29;
                    t_29 = _e57.max(end_6);
                }
            }
        }
        let _e60 = t_29;
        let _e62 = cost_14;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e60, rt::Scalar(path_46.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e62);
    }
    pub(super) fn v_search_cone(
        &self,
        path_48: Path,
        params_32: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_34: rt::Vec2<f32>;
        let mut t_31: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_15: rt::Vec3<u32> = NO_COST;
        let mut next_3: rt::Scalar<f32>;

        let _e2 = self.v_grid_of(path_48);
        let forward_3 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_34 = _e9;
        let limit_4 = params_32.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e18 = cost_15.x();
                if rt::Scalar::into_branch_condition(_e18.elementwise_lt(limit_4)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = cost_15;
                    cost_15 = (_e20 + STEP);
                    let _e23 = t_31;
                    self.v_mark_turn(_e23);
                    let _e25 = cost_15.x();
                    let first_9 = _e25.elementwise_eq(rt::Scalar(0u32));
                    let _e28 = cell_34;
                    let _e29 = self.v_whole_cell(_e28);
                    let _e31 = self.v_height_cell(_e29, rt::Scalar(path_48.level));
                    let _e32 = cost_15;
                    cost_15 = (_e32 + HEIGHTS_READ);
                    let _e35 = cell_34;
                    let _e36 = self.v_cell_leave(_e2, _e35);
                    let end_8 = _e36.x().min(_e36.y()).min(rt::Scalar(path_48.exit));
                    let _e42 = t_31;
                    let span_9 = (end_8 - _e42).max(rt::Scalar(0f32));
                    let _e47 = cell_34;
                    let _e50 = t_31;
                    let at_8 = ((_e2.origin - _e47) + (_e2.step * _e50));
                    let _e53 = self.v_nearest_corner(at_8);
                    let _e54 = self.v_corner_height(_e31, _e53);
                    let _e55 = t_31;
                    next_3 = _e55;
                    let _e57 = t_31;
                    let _e58 = self.v_path_height(path_48, _e57);
                    if rt::Scalar::into_branch_condition(_e58.elementwise_gt(_e54)) {
                        let _e60 = cell_34;
                        let texel_8 = (_e60 + _e53);
                        let _e62 = self.v_cone_slope(path_48, texel_8);
                        let _e63 = cost_15;
                        let _e65 = self.v_map_read(path_48, rt::Scalar(1u32));
                        cost_15 = (_e63 + _e65);
                        if rt::Scalar::into_branch_condition(_e62.elementwise_ge(rt::Scalar(0f32))) {
                            let _e73 = self.v_height_size(rt::Scalar(path_48.level));
                            self.v_mark_cone(((texel_8 + rt::Vec2::splat_from_scalar(rt::Scalar(0.5f32))) / _e73), _e54, _e62);
                            let _e75 = t_31;
                            let _e76 = t_31;
                            let _e77 = self.v_stays_inside(path_48, _e2, texel_8, _e54, _e62, _e76);
                            next_3 = (_e75 + _e77);
                        }
                    }
                    let _e79 = next_3;
                    if rt::Scalar::into_branch_condition(_e79.elementwise_lt(end_8)) {
                        let _e81 = cell_34;
                        let _e82 = t_31;
                        self.v_mark_patch(_e81, _e82, end_8);
                        let _e83 = cell_34;
                        let _e84 = t_31;
                        let _e85 = self.v_gap_to(path_48, _e2, _e83, _e31, _e84);
                        let _e86 = self.v_falls_in_cell(_e85, span_9);
                        if rt::Scalar::into_branch_condition(_e86) {
                            let _e87 = t_31;
                            let _e88 = cost_15;
                            let _e89 = self.v_found_in_cell(_e85, _e87, span_9, first_9, _e88);
                            return _e89;
                        }
                        let _e90 = t_31;
                        next_3 = _e90.max(end_8);
                    }
                    let _e92 = next_3;
                    if rt::Scalar::into_branch_condition(_e92.elementwise_ge(rt::Scalar(path_48.exit))) {
                        let _e96 = t_31;
                        let _e98 = cost_15;
                        return <SearchResult>::new(FOUND_MISS, _e96, rt::Scalar(path_48.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e98);
                    }
                    let _e102 = cell_34;
                    let _e103 = next_3;
                    let _e104 = self.v_cell_after(_e2, _e102, _e36, forward_3, _e103);
                    cell_34 = _e104;
                    let _e105 = next_3;
                    t_31 = _e105;
                }
            }
        }
        let _e107 = t_31;
        let _e109 = cost_15;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e107, rt::Scalar(path_48.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e109);
    }
    pub(super) fn v_search_cone_moved(
        &self,
        path_49: Path,
        params_33: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut t_32: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_10: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_3: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_16: rt::Vec3<u32> = NO_COST;
        let mut k_7: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut local_39: rt::Scalar<bool>;

        let aside_1 = path_49.duv.length();
        'naga_break: loop {
            'naga_continue: {
                let _e14 = k_7;
                if rt::Scalar::into_branch_condition(_e14.elementwise_lt(params_33.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e17 = cost_16;
                    cost_16 = (_e17 + STEP);
                    let _e20 = t_32;
                    self.v_mark_turn(_e20);
                    let _e21 = t_32;
                    self.v_mark_sample(_e21);
                    let _e22 = t_32;
                    let _e23 = self.v_path_gap(path_49, _e22);
                    let _e24 = cost_16;
                    cost_16 = (_e24 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e23.elementwise_le(rt::Scalar(0f32))) {
                        let _e29 = t_32;
                        if rt::Scalar::into_branch_condition(_e29.elementwise_eq(rt::Scalar(0f32))) {
                            local_39 = _e23.elementwise_lt(rt::Scalar(0f32));
                        } else {
                            local_39 = rt::Scalar(false);
                        }
                        let _e37 = local_39;
                        if rt::Scalar::into_branch_condition(_e37) {
                            let _e39 = cost_16;
                            return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), _e23, _e23, _e39);
                        }
                        let _e44 = near_10;
                        let _e45 = t_32;
                        let _e46 = near_gap_3;
                        let _e47 = cost_16;
                        return <SearchResult>::new(FOUND_BRACKET, _e44, _e45, _e46, _e23, _e47);
                    }
                    let _e49 = t_32;
                    near_10 = _e49;
                    near_gap_3 = _e23;
                    let _e50 = t_32;
                    let _e51 = self.v_path_uv(path_49, _e50);
                    let _e53 = self.v_search_texel_between(path_49, _e51, rt::Scalar(0i32));
                    let _e55 = self.v_slope_of(_e53.x());
                    let _e56 = cost_16;
                    let _e58 = self.v_map_read(path_49, rt::Scalar(4u32));
                    cost_16 = (_e56 + _e58);
                    if rt::Scalar::into_branch_condition(_e55.elementwise_lt(rt::Scalar(0f32))) {
                        break 'naga_break;
                    }
                    let _e62 = t_32;
                    let _e63 = self.v_path_uv(path_49, _e62);
                    let _e64 = t_32;
                    let _e65 = self.v_path_height(path_49, _e64);
                    self.v_mark_cone(_e63, (_e65 - _e23), _e55);
                    let _e68 = t_32;
                    let rest_3 = (rt::Scalar(path_49.exit) - _e68);
                    let _e70 = t_32;
                    let _e71 = self.v_path_slope(path_49, _e70);
                    let rise_5 = (_e71 + (path_49.h.z().min(rt::Scalar(0f32)) * rest_3));
                    let terms_1 = (path_49.h.x().abs() + (rt::Scalar(path_49.exit) * (path_49.h.y().abs() + (rt::Scalar(path_49.exit) * path_49.h.z().abs()))));
                    let far_13 = (((path_49.uv.abs() + (path_49.duv.abs() * rt::Scalar(path_49.exit))) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) * _e55);
                    let lost_2 = (rt::Scalar(0.0000009536743f32) * ((terms_1 + far_13.x()) + far_13.y()));
                    let nearing = ((_e55 * aside_1) - rise_5);
                    let closing_2 = (nearing + (rt::Scalar(0.0000009536743f32) * nearing));
                    if rt::Scalar::into_branch_condition(closing_2.elementwise_le(rt::Scalar(0f32))) {
                        let _e119 = t_32;
                        let _e121 = cost_16;
                        return <SearchResult>::new(FOUND_MISS, _e119, rt::Scalar(path_49.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e121);
                    }
                    let _e125 = t_32;
                    t_32 = (_e125 + ((_e23 - lost_2).max(rt::Scalar(0f32)) / closing_2));
                    let _e131 = t_32;
                    if rt::Scalar::into_branch_condition(_e131.elementwise_ge(rt::Scalar(path_49.exit))) {
                        let _e135 = near_10;
                        let _e137 = cost_16;
                        return <SearchResult>::new(FOUND_MISS, _e135, rt::Scalar(path_49.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e137);
                    }
                    let _e141 = k_7;
                    k_7 = (_e141 + rt::Scalar(1f32));
                }
            }
        }
        let _e145 = t_32;
        let _e147 = t_32;
        let _e148 = self.v_path_height(path_49, _e147);
        let _e149 = cost_16;
        return <SearchResult>::new(FOUND_ABOVE, _e145, rt::Scalar(path_49.exit), _e148, rt::Scalar(0f32), _e149);
    }
    pub(super) fn v_search_dilation_erosion(
        &self,
        path_50: Path,
        params_34: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_35: rt::Vec2<f32>;
        let mut t_33: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut safe_: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_17: rt::Vec3<u32> = NO_COST;
        let mut next_4: rt::Scalar<f32>;
        let mut looks: rt::Scalar<bool>;
        let mut local_40: rt::Scalar<bool>;
        let mut local_41: rt::Scalar<bool>;
        let mut local_42: rt::Scalar<bool>;
        let mut local_43: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_50);
        let _e4 = self.v_height_texels(rt::Scalar(path_50.level));
        let forward_4 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e11 = self.v_cell_of(_e2.origin);
        cell_35 = _e11;
        let limit_5 = params_34.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e22 = cost_17.x();
                if rt::Scalar::into_branch_condition(_e22.elementwise_lt(limit_5)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = cost_17;
                    cost_17 = (_e24 + STEP);
                    let _e27 = t_33;
                    self.v_mark_turn(_e27);
                    let _e28 = cell_35;
                    let _e29 = self.v_cell_leave(_e2, _e28);
                    let end_9 = _e29.x().min(_e29.y()).min(rt::Scalar(path_50.exit));
                    let _e35 = t_33;
                    let span_10 = (end_9 - _e35).max(rt::Scalar(0f32));
                    let _e39 = t_33;
                    next_4 = _e39;
                    looks = params_34.y().elementwise_gt(rt::Scalar(0.5f32));
                    let _e45 = cell_35;
                    let _e46 = self.v_whole_cell(_e45);
                    let _e49 = self.v_image_of(_e46.x(), _e4.x());
                    let _e52 = self.v_image_of(_e46.y(), _e4.y());
                    if rt::Scalar::into_branch_condition((!_e49.y().elementwise_eq(rt::Scalar(2i32)))) {
                        local_40 = _e52.y().elementwise_eq(rt::Scalar(2i32));
                    } else {
                        local_40 = rt::Scalar(true);
                    }
                    let _e63 = local_40;
                    if rt::Scalar::into_branch_condition(_e63) {
                        looks = rt::Scalar(true);
                    } else {
                        let _e71 = self.v_search_texel(path_50, <rt::Vec2<i32>>::from_scalars(_e49.x(), _e52.x()), rt::Scalar(0i32), rt::Scalar(path_50.level).to_i32());
                        let _e72 = cost_17;
                        let _e74 = self.v_map_read(path_50, rt::Scalar(1u32));
                        cost_17 = (_e72 + _e74);
                        let _e76 = cell_35;
                        let _e80 = cell_35;
                        self.v_mark_box((_e76 - rt::Vec2::splat_from_scalar(params_34.z())), ((_e80 + rt::Vec2::splat_from_scalar(params_34.z())) + rt::Vec2::splat_from_scalar(rt::Scalar(1f32))), _e71.y());
                        let _e88 = cell_35;
                        let _e90 = self.v_leaves_window(_e2, _e88, params_34.z());
                        let _e93 = t_33;
                        let reach_4 = (_e90.min(rt::Scalar(path_50.exit)) - _e93).max(rt::Scalar(0f32));
                        let _e97 = t_33;
                        let furthest = (_e97 + reach_4);
                        let rounded = (path_50.h.x().abs() + (furthest * (path_50.h.y().abs() + (furthest * path_50.h.z().abs()))));
                        let _e112 = t_33;
                        let _e113 = self.v_path_height(path_50, _e112);
                        let _e119 = t_33;
                        let _e120 = self.v_path_slope(path_50, _e119);
                        let gap_3 = <rt::Vec3<f32>>::from_scalars(((_e113 - _e71.y()) - (rt::Scalar(0.0000009536743f32) * rounded)), _e120, path_50.h.z());
                        if rt::Scalar::into_branch_condition(gap_3.x().elementwise_gt(rt::Scalar(0f32))) {
                            let _e127 = t_33;
                            safe_ = _e127;
                            let _e128 = t_33;
                            next_4 = (_e128 + reach_4);
                            let _e130 = self.v_least_at(gap_3, reach_4);
                            let _e131 = self.v_quadratic(gap_3, _e130);
                            if rt::Scalar::into_branch_condition(_e131.elementwise_le(rt::Scalar(0f32))) {
                                let _e134 = t_33;
                                let _e135 = self.v_first_root(gap_3, reach_4);
                                next_4 = (_e134 + _e135.min(reach_4));
                            }
                        }
                        let _e138 = looks;
                        if rt::Scalar::into_branch_condition((!_e138)) {
                            let _e142 = next_4;
                            local_41 = _e142.elementwise_lt(end_9);
                        } else {
                            local_41 = rt::Scalar(false);
                        }
                        let _e145 = local_41;
                        if rt::Scalar::into_branch_condition(_e145) {
                            let _e148 = self.v_path_height(path_50, end_9);
                            local_42 = _e148.elementwise_lt(_e71.x());
                        } else {
                            local_42 = rt::Scalar(false);
                        }
                        let _e152 = local_42;
                        if rt::Scalar::into_branch_condition(_e152) {
                            let _e153 = safe_;
                            let _e154 = cost_17;
                            let _e155 = self.v_bracket_between(path_50, _e153, end_9, _e154);
                            return _e155;
                        }
                    }
                    let _e156 = next_4;
                    if rt::Scalar::into_branch_condition((!_e156.elementwise_lt(end_9))) {
                        let _e161 = t_33;
                        local_43 = (!end_9.elementwise_gt(_e161));
                    } else {
                        local_43 = rt::Scalar(true);
                    }
                    let _e165 = local_43;
                    if rt::Scalar::into_branch_condition(_e165) {
                        let _e166 = looks;
                        if rt::Scalar::into_branch_condition(_e166) {
                            let _e167 = cost_17;
                            cost_17 = (_e167 + HEIGHTS_READ);
                            let _e170 = cell_35;
                            let _e171 = t_33;
                            self.v_mark_patch(_e170, _e171, end_9);
                            let _e173 = self.v_height_cell(_e46, rt::Scalar(path_50.level));
                            let _e174 = cell_35;
                            let _e175 = t_33;
                            let _e176 = self.v_gap_to(path_50, _e2, _e174, _e173, _e175);
                            let _e177 = self.v_falls_in_cell(_e176, span_10);
                            if rt::Scalar::into_branch_condition(_e177) {
                                let _e178 = t_33;
                                let _e179 = t_33;
                                let _e182 = cost_17;
                                let _e183 = self.v_found_in_cell(_e176, _e178, span_10, _e179.elementwise_eq(rt::Scalar(0f32)), _e182);
                                return _e183;
                            }
                        }
                        let _e184 = t_33;
                        next_4 = _e184.max(end_9);
                    }
                    let _e186 = next_4;
                    if rt::Scalar::into_branch_condition(_e186.elementwise_ge(rt::Scalar(path_50.exit))) {
                        let _e190 = t_33;
                        let _e192 = cost_17;
                        return <SearchResult>::new(FOUND_MISS, _e190, rt::Scalar(path_50.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e192);
                    }
                    let _e196 = cell_35;
                    let _e197 = next_4;
                    let _e198 = self.v_cell_after(_e2, _e196, _e29, forward_4, _e197);
                    cell_35 = _e198;
                    let _e199 = next_4;
                    t_33 = _e199;
                }
            }
        }
        let _e201 = t_33;
        let _e203 = cost_17;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e201, rt::Scalar(path_50.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e203);
    }
    pub(super) fn v_search_frustum(
        &self,
        path_51: Path,
        params_35: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_36: rt::Vec2<f32>;
        let mut t_34: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_18: rt::Vec3<u32> = NO_COST;
        let mut next_5: rt::Scalar<f32>;
        let mut slope_5: rt::Scalar<f32>;
        let mut local_44: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_51);
        let forward_5 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_36 = _e9;
        let limit_6 = params_35.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e18 = cost_18.x();
                if rt::Scalar::into_branch_condition(_e18.elementwise_lt(limit_6)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = cost_18;
                    cost_18 = (_e20 + STEP);
                    let _e23 = t_34;
                    self.v_mark_turn(_e23);
                    let _e25 = cost_18.x();
                    let first_10 = _e25.elementwise_eq(rt::Scalar(0u32));
                    let _e28 = cell_36;
                    let _e29 = self.v_whole_cell(_e28);
                    let _e31 = self.v_height_cell(_e29, rt::Scalar(path_51.level));
                    let _e32 = cost_18;
                    cost_18 = (_e32 + HEIGHTS_READ);
                    let _e35 = cell_36;
                    let _e36 = self.v_cell_leave(_e2, _e35);
                    let end_10 = _e36.x().min(_e36.y()).min(rt::Scalar(path_51.exit));
                    let _e42 = t_34;
                    let span_11 = (end_10 - _e42).max(rt::Scalar(0f32));
                    let top_9 = _e31.x().max(_e31.y()).max(_e31.z().max(_e31.w()));
                    let _e53 = t_34;
                    let _e54 = self.v_path_height(path_51, _e53);
                    let _e56 = t_34;
                    let _e57 = self.v_path_slope(path_51, _e56);
                    let above_4 = <rt::Vec3<f32>>::from_scalars((_e54 - top_9), _e57, path_51.h.z());
                    let _e64 = t_34;
                    let _e68 = t_34;
                    let of_heights_1 = (rt::Scalar(0.0000009536743f32) * (path_51.h.x().abs() + (_e64 * (path_51.h.y().abs() + (_e68 * path_51.h.z().abs())))));
                    let _e78 = t_34;
                    next_5 = _e78.max(end_10);
                    slope_5 = rt::Scalar(-1f32);
                    let _e83 = self.v_least_at(above_4, span_11);
                    let _e84 = self.v_quadratic(above_4, _e83);
                    if rt::Scalar::into_branch_condition(_e84.elementwise_gt(of_heights_1)) {
                        local_44 = above_4.x().elementwise_gt(of_heights_1);
                    } else {
                        local_44 = rt::Scalar(false);
                    }
                    let _e91 = local_44;
                    if rt::Scalar::into_branch_condition(_e91) {
                        if rt::Scalar::into_branch_condition(end_10.elementwise_lt(rt::Scalar(path_51.exit))) {
                            let _e94 = cell_36;
                            let _e95 = self.v_whole_cell(_e94);
                            let _e96 = self.v_frustum_slope(path_51, _e95, forward_5);
                            slope_5 = _e96;
                            let _e97 = slope_5;
                            if rt::Scalar::into_branch_condition(_e97.elementwise_ge(rt::Scalar(0f32))) {
                                let _e100 = cost_18;
                                let _e102 = self.v_map_read(path_51, rt::Scalar(1u32));
                                cost_18 = (_e100 + _e102);
                            }
                        }
                    } else {
                        let _e104 = cell_36;
                        let _e105 = t_34;
                        self.v_mark_patch(_e104, _e105, end_10);
                        let _e106 = cell_36;
                        let _e107 = t_34;
                        let _e108 = self.v_gap_to(path_51, _e2, _e106, _e31, _e107);
                        let _e109 = self.v_falls_in_cell(_e108, span_11);
                        if rt::Scalar::into_branch_condition(_e109) {
                            let _e110 = t_34;
                            let _e111 = cost_18;
                            let _e112 = self.v_found_in_cell(_e108, _e110, span_11, first_10, _e111);
                            return _e112;
                        }
                    }
                    let _e113 = slope_5;
                    if rt::Scalar::into_branch_condition(_e113.elementwise_ge(rt::Scalar(0f32))) {
                        let _e116 = cell_36;
                        let _e117 = slope_5;
                        self.v_mark_frustum(_e116, top_9, _e117);
                        let _e119 = cell_36;
                        let _e122 = t_34;
                        let at_9 = ((_e2.origin - _e119) + (_e2.step * _e122));
                        let left_4 = at_9.select((<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)) - at_9), forward_5);
                        let _e134 = t_34;
                        let far_14 = ((_e2.origin.abs() + (_e2.step.abs() * _e134)) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)));
                        let _e142 = slope_5;
                        let lost_3 = (<rt::Vec2<f32>>::from_scalars(of_heights_1, of_heights_1) + ((rt::Scalar(0.0000009536743f32) * _e142) * far_14));
                        let _e148 = t_34;
                        let rest_4 = (rt::Scalar(path_51.exit) - _e148);
                        let _e150 = slope_5;
                        let _e155 = self.v_stays_above(above_4, _e150, left_4.x(), _e2.step.x(), lost_3.x(), rest_4);
                        let _e156 = slope_5;
                        let _e161 = self.v_stays_above(above_4, _e156, left_4.y(), _e2.step.y(), lost_3.y(), rest_4);
                        let _e162 = next_5;
                        let _e163 = t_34;
                        next_5 = _e162.max((_e163 + _e155.min(_e161)));
                    }
                    let _e167 = next_5;
                    if rt::Scalar::into_branch_condition(_e167.elementwise_ge(rt::Scalar(path_51.exit))) {
                        let _e171 = t_34;
                        let _e173 = cost_18;
                        return <SearchResult>::new(FOUND_MISS, _e171, rt::Scalar(path_51.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e173);
                    }
                    let _e177 = slope_5;
                    if rt::Scalar::into_branch_condition(_e177.elementwise_ge(rt::Scalar(0f32))) {
                        let _e180 = cell_36;
                        let _e181 = next_5;
                        let _e182 = self.v_cell_after(_e2, _e180, _e36, forward_5, _e181);
                        cell_36 = _e182;
                    } else {
                        let _e183 = cell_36;
                        let _e184 = self.v_cell_next(_e2, _e183, _e36);
                        cell_36 = _e184;
                    }
                    let _e185 = next_5;
                    t_34 = _e185;
                }
            }
        }
        let _e187 = t_34;
        let _e189 = cost_18;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e187, rt::Scalar(path_51.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e189);
    }
    pub(super) fn v_search_linear(
        &self,
        path_55: Path,
        params_38: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut near_11: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_4: rt::Scalar<f32>;
        let mut cost_20: rt::Vec3<u32>;
        let mut k_9: rt::Scalar<f32> = rt::Scalar(1f32);

        let cosine = (path_55.h.y().abs() * path_55.metric.w()).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let steps = rt::Scalar(1f32).max(((params_38.x() * params_38.y().mix_scalar(rt::Scalar(1f32), cosine)) * rt::Scalar(path_55.share)).ceil());
        let _e24 = self.v_path_gap(path_55, rt::Scalar(0f32));
        near_gap_4 = _e24;
        let _e27 = self.v_field_cost_stage(rt::Scalar(path_55.level));
        cost_20 = _e27;
        let _e29 = near_gap_4;
        if rt::Scalar::into_branch_condition(_e29.elementwise_lt(rt::Scalar(0f32))) {
            let _e33 = near_gap_4;
            let _e34 = near_gap_4;
            let _e35 = cost_20;
            return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), _e33, _e34, _e35);
        }
        'naga_break: loop {
            'naga_continue: {
                let _e41 = k_9;
                if rt::Scalar::into_branch_condition(_e41.elementwise_le(steps)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e43 = cost_20;
                    cost_20 = (_e43 + STEP);
                    let _e47 = k_9;
                    let t_46 = (rt::Scalar(path_55.exit) * (_e47 / steps));
                    self.v_mark_turn(t_46);
                    self.v_mark_sample(t_46);
                    let _e50 = self.v_path_gap(path_55, t_46);
                    let _e51 = cost_20;
                    let _e53 = self.v_field_cost_stage(rt::Scalar(path_55.level));
                    cost_20 = (_e51 + _e53);
                    if rt::Scalar::into_branch_condition(_e50.elementwise_le(rt::Scalar(0f32))) {
                        let _e58 = near_11;
                        let _e59 = near_gap_4;
                        let _e60 = cost_20;
                        return <SearchResult>::new(FOUND_BRACKET, _e58, t_46, _e59, _e50, _e60);
                    }
                    near_11 = t_46;
                    near_gap_4 = _e50;
                    let _e62 = k_9;
                    k_9 = (_e62 + rt::Scalar(1f32));
                }
            }
        }
        let _e66 = near_11;
        let _e67 = near_11;
        let _e68 = near_gap_4;
        let _e69 = near_gap_4;
        let _e70 = cost_20;
        return <SearchResult>::new(FOUND_MISS, _e66, _e67, _e68, _e69, _e70);
    }
    pub(super) fn v_search_pyramid(
        &self,
        path_57: Path,
        params_40: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut top_3: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut level_29: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut cell_37: rt::Vec2<i32>;
        let mut parent: rt::Vec2<i32> = <rt::Vec2<i32>>::from_scalars(rt::Scalar(-1i32), rt::Scalar(-1i32));
        let mut t_36: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_21: rt::Vec3<u32> = NO_COST;
        let mut local_45: rt::Scalar<bool>;
        let mut local_46: rt::Scalar<bool>;
        let mut local_47: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_57);
        let _e4 = self.v_height_texels(rt::Scalar(path_57.level));
        let long = (_e2.step.x().abs().max(_e2.step.y().abs()) * rt::Scalar(path_57.exit));
        'naga_break: loop {
            'naga_continue: {
                let _e18 = top_3;
                if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e18).elementwise_lt(_e4.x().max(_e4.y()))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = top_3;
                    top_3 = (_e25 + rt::Scalar(1u32));
                    let _e28 = level_29;
                    if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e28).to_f32().elementwise_lt(long)) {
                        let _e33 = level_29;
                        level_29 = (_e33 + rt::Scalar(1u32));
                    }
                }
            }
        }
        let _e37 = self.v_cell_of(_e2.origin);
        cell_37 = _e37.to_i32();
        let limit_9 = params_40.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e51 = cost_21.x();
                if rt::Scalar::into_branch_condition(_e51.elementwise_lt(limit_9)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e53 = cost_21;
                    cost_21 = (_e53 + STEP);
                    let _e56 = t_36;
                    self.v_mark_turn(_e56);
                    let _e58 = cell_37.x();
                    let _e60 = self.v_image_of(_e58, _e4.x());
                    let _e62 = cell_37.y();
                    let _e64 = self.v_image_of(_e62, _e4.y());
                    let place_7 = <rt::Vec2<i32>>::from_scalars(_e60.x(), _e64.x());
                    let _e68 = level_29;
                    let above_level = (_e68 + rt::Scalar(1u32));
                    let over = <rt::Vec2<i32>>::from_scalars((place_7.x() >> above_level), (place_7.y() >> above_level));
                    let _e77 = parent.x();
                    if rt::Scalar::into_branch_condition(_e77.elementwise_ge(rt::Scalar(0i32))) {
                        let _e83 = parent.x();
                        if rt::Scalar::into_branch_condition((!_e83.elementwise_ne(over.x()))) {
                            let _e90 = parent.y();
                            local_46 = _e90.elementwise_ne(over.y());
                        } else {
                            local_46 = rt::Scalar(true);
                        }
                        let _e94 = local_46;
                        local_45 = _e94;
                    } else {
                        local_45 = rt::Scalar(false);
                    }
                    let left_5 = local_45;
                    if rt::Scalar::into_branch_condition(left_5) {
                        let _e99 = level_29;
                        let _e100 = top_3;
                        local_47 = _e99.elementwise_lt(_e100);
                    } else {
                        local_47 = rt::Scalar(false);
                    }
                    let _e103 = local_47;
                    if rt::Scalar::into_branch_condition(_e103) {
                        level_29 = above_level;
                    }
                    let _e105 = cell_37.x();
                    let _e107 = level_29;
                    let _e108 = self.v_node_extent(_e105, _e60, _e4.x(), _e107);
                    let _e110 = cell_37.y();
                    let _e112 = level_29;
                    let _e113 = self.v_node_extent(_e110, _e64, _e4.y(), _e112);
                    let _e118 = self.v_leaves_extent(_e2.origin.x(), _e2.step.x(), _e108);
                    let _e123 = self.v_leaves_extent(_e2.origin.y(), _e2.step.y(), _e113);
                    let end_11 = _e118.min(_e123).min(rt::Scalar(path_57.exit));
                    let _e127 = t_36;
                    let span_12 = (end_11 - _e127).max(rt::Scalar(0f32));
                    let low_6 = <rt::Vec2<i32>>::from_scalars(_e108.x(), _e113.x());
                    let last_6 = <rt::Vec2<i32>>::from_scalars((_e108.y() - rt::Scalar(1i32)), (_e113.y() - rt::Scalar(1i32)));
                    let _e141 = level_29;
                    if rt::Scalar::into_branch_condition(_e141.elementwise_eq(rt::Scalar(0u32))) {
                        let _e144 = cost_21;
                        cost_21 = (_e144 + HEIGHTS_READ);
                        let _e147 = cell_37;
                        let _e149 = t_36;
                        self.v_mark_patch(_e147.to_f32(), _e149, end_11);
                        let _e150 = cell_37;
                        let _e152 = cell_37;
                        let _e154 = self.v_object_cell_stage(_e152, rt::Scalar(path_57.level));
                        let _e155 = t_36;
                        let _e156 = self.v_gap_to(path_57, _e2, _e150.to_f32(), _e154, _e155);
                        let _e157 = self.v_falls_in_cell(_e156, span_12);
                        if rt::Scalar::into_branch_condition(_e157) {
                            let _e158 = t_36;
                            let _e159 = t_36;
                            let _e162 = cost_21;
                            let _e163 = self.v_found_in_cell(_e156, _e158, span_12, _e159.elementwise_eq(rt::Scalar(0f32)), _e162);
                            return _e163;
                        }
                    } else {
                        let _e164 = cost_21;
                        let _e166 = self.v_map_read(path_57, rt::Scalar(1u32));
                        cost_21 = (_e164 + _e166);
                        let _e169 = level_29;
                        let _e172 = level_29;
                        let node_1 = <rt::Vec2<i32>>::from_scalars((place_7.x() >> _e169), (place_7.y() >> _e172));
                        let _e176 = level_29;
                        let _e182 = self.v_search_texel(path_57, node_1, rt::Scalar(0i32), ((_e176 + rt::Scalar(path_57.level)).to_i32() - rt::Scalar(1i32)));
                        let highest_1 = _e182.y();
                        self.v_mark_box(low_6.to_f32(), (last_6 + rt::Vec2::splat_from_scalar(rt::Scalar(1i32))).to_f32(), highest_1);
                        let _e189 = t_36;
                        let furthest_1 = (_e189 + span_12);
                        let rounded_1 = (path_57.h.x().abs() + (furthest_1 * (path_57.h.y().abs() + (furthest_1 * path_57.h.z().abs()))));
                        let _e204 = t_36;
                        let _e205 = self.v_path_height(path_57, _e204);
                        let _e210 = t_36;
                        let _e211 = self.v_path_slope(path_57, _e210);
                        let gap_5 = <rt::Vec3<f32>>::from_scalars(((_e205 - highest_1) - (rt::Scalar(0.0000009536743f32) * rounded_1)), _e211, path_57.h.z());
                        let _e215 = self.v_falls_in_cell(gap_5, span_12);
                        if rt::Scalar::into_branch_condition(_e215) {
                            if rt::Scalar::into_branch_condition(gap_5.x().elementwise_gt(rt::Scalar(0f32))) {
                                let _e219 = t_36;
                                let _e220 = self.v_first_root(gap_5, span_12);
                                t_36 = (_e219 + _e220.min(span_12));
                            }
                            let _e225 = t_36;
                            let _e228 = self.v_cell_of((_e2.origin + (_e2.step * _e225)));
                            cell_37 = _e228.to_i32().clamp(low_6, last_6);
                            let _e231 = level_29;
                            level_29 = (_e231 - rt::Scalar(1u32));
                            parent = <rt::Vec2<i32>>::from_scalars(rt::Scalar(-1i32), rt::Scalar(-1i32));
                            break 'naga_continue;
                        }
                    }
                    if rt::Scalar::into_branch_condition(end_11.elementwise_ge(rt::Scalar(path_57.exit))) {
                        let _e240 = t_36;
                        let _e242 = cost_21;
                        return <SearchResult>::new(FOUND_MISS, _e240, rt::Scalar(path_57.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e242);
                    }
                    let _e250 = self.v_cell_of((_e2.origin + (_e2.step * end_11)));
                    cell_37 = _e250.to_i32().clamp(low_6, last_6);
                    if rt::Scalar::into_branch_condition(_e118.elementwise_le(end_11)) {
                        cell_37.set_x((low_6.x() - rt::Scalar(1i32)).select(_e108.y(), _e2.step.x().elementwise_gt(rt::Scalar(0f32))));
                    }
                    if rt::Scalar::into_branch_condition(_e123.elementwise_le(end_11)) {
                        cell_37.set_y((low_6.y() - rt::Scalar(1i32)).select(_e113.y(), _e2.step.y().elementwise_gt(rt::Scalar(0f32))));
                    }
                    let _e276 = level_29;
                    let _e281 = level_29;
                    parent = <rt::Vec2<i32>>::from_scalars((place_7.x() >> (_e276 + rt::Scalar(1u32))), (place_7.y() >> (_e281 + rt::Scalar(1u32))));
                    let _e286 = t_36;
                    t_36 = _e286.max(end_11);
                }
            }
        }
        let _e289 = t_36;
        let _e291 = cost_21;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e289, rt::Scalar(path_57.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e291);
    }
    pub(super) fn v_search_pyramid_texels(
        &self,
        path_58: Path,
        params_41: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut level_31: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut texel_4: rt::Vec2<i32>;
        let mut t_37: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_22: rt::Vec3<u32> = NO_COST;
        let mut finest_1: rt::Scalar<u32>;
        let mut highest: rt::Scalar<f32>;
        let mut sinks: rt::Scalar<f32>;

        let _e3 = self.v_height_texels(rt::Scalar(path_58.level));
        let _e6 = self.v_height_size(rt::Scalar(path_58.level));
        let origin_2 = (path_58.uv * _e6);
        let _e10 = self.v_height_size(rt::Scalar(path_58.level));
        let step_2 = (path_58.duv * _e10);
        'naga_break: loop {
            'naga_continue: {
                let _e14 = level_31;
                if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e14).elementwise_lt(_e3.x().max(_e3.y()))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e21 = level_31;
                    level_31 = (_e21 + rt::Scalar(1u32));
                }
            }
        }
        let _e24 = self.v_cell_of(origin_2);
        texel_4 = _e24.to_i32();
        let limit_10 = params_41.x().to_u32();
        let _e35 = level_31;
        finest_1 = params_41.y().to_u32().min(_e35);
        if rt::Scalar::into_branch_condition(rt::Scalar(path_58.ray).elementwise_eq(RAY_SHADOW)) {
            finest_1 = rt::Scalar(0u32);
        }
        'naga_break: loop {
            'naga_continue: {
                let _e43 = cost_22.x();
                if rt::Scalar::into_branch_condition(_e43.elementwise_lt(limit_10)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e45 = cost_22;
                    cost_22 = (_e45 + STEP);
                    let _e48 = t_37;
                    self.v_mark_turn(_e48);
                    let _e50 = texel_4.x();
                    let _e52 = self.v_wrap_index(_e50, _e3.x());
                    let _e54 = texel_4.y();
                    let _e56 = self.v_wrap_index(_e54, _e3.y());
                    let place_8 = <rt::Vec2<i32>>::from_scalars(_e52, _e56);
                    highest = rt::Scalar(0f32);
                    let _e60 = level_31;
                    if rt::Scalar::into_branch_condition(_e60.elementwise_eq(rt::Scalar(0u32))) {
                        let _e63 = cost_22;
                        cost_22 = (_e63 + HEIGHT_READ);
                        let _e68 = rt::texture::Read::read_texel((&self.height_map), place_8, 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
                        highest = _e68.x();
                    } else {
                        let _e71 = level_31;
                        let _e74 = level_31;
                        let node_2 = <rt::Vec2<i32>>::from_scalars((place_8.x() >> _e71), (place_8.y() >> _e74));
                        let _e77 = cost_22;
                        let _e79 = self.v_map_read(path_58, rt::Scalar(1u32));
                        cost_22 = (_e77 + _e79);
                        let _e82 = level_31;
                        let _e86 = self.v_search_texel(path_58, node_2, rt::Scalar(0i32), (_e82.to_i32() - rt::Scalar(1i32)));
                        highest = _e86.y();
                    }
                    let _e89 = texel_4.x();
                    let _e91 = level_31;
                    let _e92 = self.v_texel_extent(_e89, _e3.x(), _e91);
                    let _e94 = texel_4.y();
                    let _e96 = level_31;
                    let _e97 = self.v_texel_extent(_e94, _e3.y(), _e96);
                    let _e100 = self.v_leaves_extent(origin_2.x(), step_2.x(), _e92);
                    let _e103 = self.v_leaves_extent(origin_2.y(), step_2.y(), _e97);
                    let leave_8 = <rt::Vec2<f32>>::from_scalars(_e100, _e103);
                    let _e110 = t_37;
                    let end_12 = leave_8.x().min(leave_8.y()).min(rt::Scalar(path_58.exit)).max(_e110);
                    let _e112 = t_37;
                    let _e113 = self.v_path_height(path_58, _e112);
                    let _e114 = highest;
                    let _e116 = t_37;
                    let _e117 = self.v_path_slope(path_58, _e116);
                    let gap_6 = <rt::Vec3<f32>>::from_scalars((_e113 - _e114), _e117, path_58.h.z());
                    sinks = rt::Scalar(0f32);
                    if rt::Scalar::into_branch_condition(gap_6.x().elementwise_gt(rt::Scalar(0f32))) {
                        let _e126 = t_37;
                        let _e128 = self.v_first_root(gap_6, (end_12 - _e126));
                        sinks = _e128;
                    }
                    let low_7 = <rt::Vec2<i32>>::from_scalars(_e92.x(), _e97.x());
                    let last_8 = <rt::Vec2<i32>>::from_scalars((_e92.y() - rt::Scalar(1i32)), (_e97.y() - rt::Scalar(1i32)));
                    let _e144 = highest;
                    self.v_mark_columns(low_7.to_f32(), (last_8 + rt::Vec2::splat_from_scalar(rt::Scalar(1i32))).to_f32(), _e144);
                    let _e145 = sinks;
                    if rt::Scalar::into_branch_condition(_e145.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e148 = t_37;
                        let _e149 = sinks;
                        t_37 = (_e148 + _e149);
                        let _e151 = level_31;
                        let _e152 = finest_1;
                        if rt::Scalar::into_branch_condition(_e151.elementwise_eq(_e152)) {
                            let _e155 = t_37;
                            let _e156 = cost_22;
                            return <SearchResult>::new(FOUND_BELOW, rt::Scalar(0f32), _e155, rt::Scalar(0f32), rt::Scalar(0f32), _e156);
                        }
                        let _e161 = level_31;
                        level_31 = (_e161 - rt::Scalar(1u32));
                        let _e164 = t_37;
                        let _e167 = self.v_cell_of((origin_2 + (step_2 * _e164)));
                        texel_4 = _e167.to_i32().clamp(low_7, last_8);
                    } else {
                        if rt::Scalar::into_branch_condition(end_12.elementwise_ge(rt::Scalar(path_58.exit))) {
                            let _e173 = t_37;
                            let _e175 = cost_22;
                            return <SearchResult>::new(FOUND_MISS, _e173, rt::Scalar(path_58.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e175);
                        }
                        let _e181 = self.v_cell_of((origin_2 + (step_2 * end_12)));
                        texel_4 = _e181.to_i32().clamp(low_7, last_8);
                        if rt::Scalar::into_branch_condition(leave_8.x().elementwise_le(end_12)) {
                            texel_4.set_x((low_7.x() - rt::Scalar(1i32)).select(_e92.y(), step_2.x().elementwise_gt(rt::Scalar(0f32))));
                        }
                        if rt::Scalar::into_branch_condition(leave_8.y().elementwise_le(end_12)) {
                            texel_4.set_y((low_7.y() - rt::Scalar(1i32)).select(_e97.y(), step_2.y().elementwise_gt(rt::Scalar(0f32))));
                        }
                        t_37 = end_12;
                    }
                }
            }
        }
        let _e207 = t_37;
        let _e209 = cost_22;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e207, rt::Scalar(path_58.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e209);
    }
    pub(super) fn v_search_relaxed_cone(
        &self,
        path_59: Path,
        params_42: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_38: rt::Vec2<f32>;
        let mut t_38: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_12: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_5: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_23: rt::Vec3<u32> = NO_COST;
        let mut local_49: rt::Scalar<bool>;
        let mut start_1: rt::Scalar<f32>;
        let mut gap: rt::Scalar<f32>;
        let mut next_6: rt::Scalar<f32>;
        let mut local_50: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_59);
        let forward_6 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let aside_2 = path_59.duv.length();
        let _e11 = self.v_path_slope(path_59, rt::Scalar(0f32));
        let terms_2 = (path_59.h.x().abs() + (rt::Scalar(path_59.exit) * path_59.h.y().abs()));
        let _e33 = self.v_height_size(rt::Scalar(path_59.level));
        let far_16 = (((_e2.origin.abs() + (_e2.step.abs() * rt::Scalar(path_59.exit))) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) / _e33);
        let _e36 = self.v_cell_of(_e2.origin);
        cell_38 = _e36;
        let limit_11 = params_42.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e49 = cost_23.x();
                if rt::Scalar::into_branch_condition(_e49.elementwise_lt(limit_11)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e51 = cost_23;
                    cost_23 = (_e51 + STEP);
                    let _e54 = t_38;
                    self.v_mark_turn(_e54);
                    let _e55 = cell_38;
                    let _e56 = self.v_cell_leave(_e2, _e55);
                    let end_13 = _e56.x().min(_e56.y()).min(rt::Scalar(path_59.exit));
                    let _e62 = t_38;
                    let span_13 = (end_13 - _e62).max(rt::Scalar(0f32));
                    let _e66 = cell_38;
                    let _e67 = cell_38;
                    let _e68 = self.v_whole_cell(_e67);
                    let _e70 = self.v_height_cell(_e68, rt::Scalar(path_59.level));
                    let _e71 = t_38;
                    let _e72 = self.v_gap_to(path_59, _e2, _e66, _e70, _e71);
                    let _e73 = cost_23;
                    cost_23 = (_e73 + HEIGHTS_READ);
                    let _e76 = t_38;
                    self.v_mark_sample(_e76);
                    if rt::Scalar::into_branch_condition(_e72.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e80 = near_12;
                        let _e81 = t_38;
                        if rt::Scalar::into_branch_condition(_e80.elementwise_lt(_e81)) {
                            let _e85 = near_gap_5;
                            local_49 = _e85.elementwise_gt(rt::Scalar(0f32));
                        } else {
                            local_49 = rt::Scalar(false);
                        }
                        let _e89 = local_49;
                        if rt::Scalar::into_branch_condition(_e89) {
                            let _e90 = near_12;
                            let _e91 = t_38;
                            let _e92 = near_gap_5;
                            let _e94 = cost_23;
                            let _e95 = self.v_entered_once(path_59, _e2, _e90, _e91, _e92, _e72.x(), _e94);
                            return _e95;
                        }
                        let _e96 = t_38;
                        let _e97 = t_38;
                        let _e100 = cost_23;
                        let _e101 = self.v_found_in_cell(_e72, _e96, span_13, _e97.elementwise_eq(rt::Scalar(0f32)), _e100);
                        return _e101;
                    }
                    let _e102 = t_38;
                    start_1 = _e102;
                    gap = _e72.x();
                    if rt::Scalar::into_branch_condition(params_42.y().elementwise_gt(rt::Scalar(0.5f32))) {
                        let _e109 = cell_38;
                        let _e110 = t_38;
                        self.v_mark_patch(_e109, _e110, end_13);
                        let _e111 = self.v_falls_in_cell(_e72, span_13);
                        if rt::Scalar::into_branch_condition(_e111) {
                            let _e112 = t_38;
                            let _e113 = t_38;
                            let _e116 = cost_23;
                            let _e117 = self.v_found_in_cell(_e72, _e112, span_13, _e113.elementwise_eq(rt::Scalar(0f32)), _e116);
                            return _e117;
                        }
                        let _e118 = t_38;
                        start_1 = _e118.max(end_13);
                        let _e120 = self.v_quadratic(_e72, span_13);
                        gap = _e120;
                    }
                    let _e121 = start_1;
                    if rt::Scalar::into_branch_condition(_e121.elementwise_ge(rt::Scalar(path_59.exit))) {
                        let _e125 = t_38;
                        let _e127 = cost_23;
                        return <SearchResult>::new(FOUND_MISS, _e125, rt::Scalar(path_59.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e127);
                    }
                    let _e131 = start_1;
                    near_12 = _e131;
                    let _e132 = gap;
                    near_gap_5 = _e132;
                    let _e133 = cell_38;
                    let _e135 = cell_38;
                    let _e138 = start_1;
                    let _e141 = self.v_nearest_corner(((_e2.origin - _e135) + (_e2.step * _e138)));
                    let _e143 = self.v_cone_slope(path_59, (_e133 + _e141));
                    let _e144 = cost_23;
                    let _e146 = self.v_map_read(path_59, rt::Scalar(1u32));
                    cost_23 = (_e144 + _e146);
                    let _e148 = start_1;
                    next_6 = _e148;
                    if rt::Scalar::into_branch_condition(_e143.elementwise_ge(rt::Scalar(0f32))) {
                        let _e152 = start_1;
                        let _e153 = self.v_path_uv(path_59, _e152);
                        let _e154 = start_1;
                        let _e155 = self.v_path_height(path_59, _e154);
                        let _e156 = gap;
                        self.v_mark_cone(_e153, (_e155 - _e156), _e143);
                        let nearing_1 = ((_e143 * aside_2) - _e11);
                        let closing_4 = (nearing_1 + (rt::Scalar(0.0000009536743f32) * nearing_1));
                        let _e163 = gap;
                        let room = (_e163 - (rt::Scalar(0.0000009536743f32) * (terms_2 + (_e143 * (far_16.x() + far_16.y())))));
                        next_6 = rt::Scalar(300000000000000000000000000000000000000f32);
                        if rt::Scalar::into_branch_condition(closing_4.elementwise_gt(rt::Scalar(0f32))) {
                            let _e175 = start_1;
                            next_6 = (_e175 + (room.max(rt::Scalar(0f32)) / closing_4));
                        }
                    }
                    if rt::Scalar::into_branch_condition(params_42.y().elementwise_lt(rt::Scalar(0.5f32))) {
                        let _e185 = next_6;
                        let _e186 = t_38;
                        local_50 = (!(_e185 - _e186).elementwise_gt((rt::Scalar(0.0000009536743f32) * rt::Scalar(path_59.exit))));
                    } else {
                        local_50 = rt::Scalar(false);
                    }
                    let _e194 = local_50;
                    if rt::Scalar::into_branch_condition(_e194) {
                        let _e196 = t_38;
                        let _e198 = gap;
                        let _e199 = cost_23;
                        return <SearchResult>::new(FOUND_ABOVE, _e196, rt::Scalar(path_59.exit), _e198, rt::Scalar(0f32), _e199);
                    }
                    let _e202 = next_6;
                    if rt::Scalar::into_branch_condition(_e202.elementwise_ge(rt::Scalar(path_59.exit))) {
                        let _e206 = self.v_path_gap(path_59, rt::Scalar(path_59.exit));
                        let _e207 = cost_23;
                        cost_23 = (_e207 + HEIGHTS_READ);
                        if rt::Scalar::into_branch_condition(_e206.elementwise_le(rt::Scalar(0f32))) {
                            let _e212 = start_1;
                            let _e214 = gap;
                            let _e215 = cost_23;
                            let _e216 = self.v_entered_once(path_59, _e2, _e212, rt::Scalar(path_59.exit), _e214, _e206, _e215);
                            return _e216;
                        }
                        let _e218 = start_1;
                        let _e220 = cost_23;
                        return <SearchResult>::new(FOUND_MISS, _e218, rt::Scalar(path_59.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e220);
                    }
                    let _e224 = cell_38;
                    let _e225 = next_6;
                    let _e226 = self.v_cell_after(_e2, _e224, _e56, forward_6, _e225);
                    cell_38 = _e226;
                    let _e227 = next_6;
                    t_38 = _e227;
                }
            }
        }
        let _e229 = t_38;
        let _e231 = cost_23;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e229, rt::Scalar(path_59.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e231);
    }
    pub(super) fn v_search_relaxed_cone_resting(
        &self,
        path_60: Path,
        params_43: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_39: rt::Vec2<f32>;
        let mut t_39: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_13: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_6: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_24: rt::Vec3<u32> = NO_COST;
        let mut local_51: rt::Scalar<bool>;
        let mut next_7: rt::Scalar<f32>;

        let _e2 = self.v_grid_of(path_60);
        let forward_7 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_39 = _e9;
        let limit_12 = params_43.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e22 = cost_24.x();
                if rt::Scalar::into_branch_condition(_e22.elementwise_lt(limit_12)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = cost_24;
                    cost_24 = (_e24 + STEP);
                    let _e27 = t_39;
                    self.v_mark_turn(_e27);
                    let _e28 = cell_39;
                    let _e29 = self.v_whole_cell(_e28);
                    let _e31 = self.v_height_cell(_e29, rt::Scalar(path_60.level));
                    let _e32 = cost_24;
                    cost_24 = (_e32 + HEIGHTS_READ);
                    let _e35 = cell_39;
                    let _e36 = self.v_cell_leave(_e2, _e35);
                    let end_14 = _e36.x().min(_e36.y()).min(rt::Scalar(path_60.exit));
                    let _e42 = t_39;
                    let span_14 = (end_14 - _e42).max(rt::Scalar(0f32));
                    let _e46 = cell_39;
                    let _e47 = t_39;
                    let _e48 = self.v_gap_to(path_60, _e2, _e46, _e31, _e47);
                    let _e49 = t_39;
                    self.v_mark_sample(_e49);
                    if rt::Scalar::into_branch_condition(_e48.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e53 = near_13;
                        let _e54 = t_39;
                        if rt::Scalar::into_branch_condition(_e53.elementwise_lt(_e54)) {
                            let _e58 = near_gap_6;
                            local_51 = _e58.elementwise_gt(rt::Scalar(0f32));
                        } else {
                            local_51 = rt::Scalar(false);
                        }
                        let _e62 = local_51;
                        if rt::Scalar::into_branch_condition(_e62) {
                            let _e63 = near_13;
                            let _e64 = t_39;
                            let _e65 = near_gap_6;
                            let _e67 = cost_24;
                            let _e68 = self.v_entered_once(path_60, _e2, _e63, _e64, _e65, _e48.x(), _e67);
                            return _e68;
                        }
                        let _e69 = t_39;
                        let _e70 = t_39;
                        let _e73 = cost_24;
                        let _e74 = self.v_found_in_cell(_e48, _e69, span_14, _e70.elementwise_eq(rt::Scalar(0f32)), _e73);
                        return _e74;
                    }
                    let _e75 = cell_39;
                    let _e76 = t_39;
                    self.v_mark_patch(_e75, _e76, end_14);
                    let _e77 = self.v_falls_in_cell(_e48, span_14);
                    if rt::Scalar::into_branch_condition(_e77) {
                        let _e78 = t_39;
                        let _e79 = t_39;
                        let _e82 = cost_24;
                        let _e83 = self.v_found_in_cell(_e48, _e78, span_14, _e79.elementwise_eq(rt::Scalar(0f32)), _e82);
                        return _e83;
                    }
                    let _e84 = t_39;
                    let start_2 = _e84.max(end_14);
                    if rt::Scalar::into_branch_condition(start_2.elementwise_ge(rt::Scalar(path_60.exit))) {
                        let _e89 = t_39;
                        let _e91 = cost_24;
                        return <SearchResult>::new(FOUND_MISS, _e89, rt::Scalar(path_60.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e91);
                    }
                    near_13 = start_2;
                    let _e95 = self.v_quadratic(_e48, span_14);
                    near_gap_6 = _e95;
                    let _e97 = cell_39;
                    let _e102 = self.v_nearest_corner(((_e2.origin - _e97) + (_e2.step * start_2)));
                    let _e103 = self.v_corner_height(_e31, _e102);
                    next_7 = start_2;
                    let _e105 = self.v_path_height(path_60, start_2);
                    if rt::Scalar::into_branch_condition(_e105.elementwise_gt(_e103)) {
                        let _e107 = cell_39;
                        let texel_9 = (_e107 + _e102);
                        let _e109 = self.v_cone_slope(path_60, texel_9);
                        let _e110 = cost_24;
                        let _e112 = self.v_map_read(path_60, rt::Scalar(1u32));
                        cost_24 = (_e110 + _e112);
                        if rt::Scalar::into_branch_condition(_e109.elementwise_ge(rt::Scalar(0f32))) {
                            let _e120 = self.v_height_size(rt::Scalar(path_60.level));
                            self.v_mark_cone(((texel_9 + rt::Vec2::splat_from_scalar(rt::Scalar(0.5f32))) / _e120), _e103, _e109);
                            let _e122 = self.v_stays_inside(path_60, _e2, texel_9, _e103, _e109, start_2);
                            next_7 = (start_2 + _e122);
                        }
                    }
                    let _e124 = next_7;
                    if rt::Scalar::into_branch_condition(_e124.elementwise_ge(rt::Scalar(path_60.exit))) {
                        let _e128 = self.v_path_gap(path_60, rt::Scalar(path_60.exit));
                        let _e129 = cost_24;
                        cost_24 = (_e129 + HEIGHTS_READ);
                        if rt::Scalar::into_branch_condition(_e128.elementwise_le(rt::Scalar(0f32))) {
                            let _e135 = near_gap_6;
                            let _e136 = cost_24;
                            let _e137 = self.v_entered_once(path_60, _e2, start_2, rt::Scalar(path_60.exit), _e135, _e128, _e136);
                            return _e137;
                        }
                        let _e140 = cost_24;
                        return <SearchResult>::new(FOUND_MISS, start_2, rt::Scalar(path_60.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e140);
                    }
                    let _e144 = cell_39;
                    let _e145 = next_7;
                    let _e146 = self.v_cell_after(_e2, _e144, _e36, forward_7, _e145);
                    cell_39 = _e146;
                    let _e147 = next_7;
                    t_39 = _e147;
                }
            }
        }
        let _e149 = t_39;
        let _e151 = cost_24;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e149, rt::Scalar(path_60.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e151);
    }
    pub(super) fn v_search_sphere(
        &self,
        path_62: Path,
        params_45: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_40: rt::Vec2<f32>;
        let mut t_41: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_26: rt::Vec3<u32> = NO_COST;
        let mut next_8: rt::Scalar<f32>;
        let mut local_52: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_62);
        let forward_8 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_path_slope(path_62, rt::Scalar(0f32));
        let _e12 = self.v_path_slope(path_62, rt::Scalar(path_62.exit));
        let climb_1 = _e9.abs().max(_e12.abs());
        let fastest = <rt::Vec3<f32>>::new_21(path_62.duv, climb_1).length();
        let speed_4 = (fastest + (rt::Scalar(0.0000009536743f32) * fastest));
        let far_17 = (path_62.uv.abs() + (path_62.duv.abs() * rt::Scalar(path_62.exit)));
        let height_terms = (path_62.h.x().abs() + (rt::Scalar(path_62.exit) * (path_62.h.y().abs() + (rt::Scalar(path_62.exit) * path_62.h.z().abs()))));
        let lost_4 = (rt::Scalar(0.0000009536743f32) * (((far_17.x() + far_17.y()) + height_terms) + rt::Scalar(1f32)));
        let _e52 = self.v_cell_of(_e2.origin);
        cell_40 = _e52;
        let limit_14 = params_45.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e61 = cost_26.x();
                if rt::Scalar::into_branch_condition(_e61.elementwise_lt(limit_14)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e63 = cost_26;
                    cost_26 = (_e63 + STEP);
                    let _e66 = t_41;
                    self.v_mark_turn(_e66);
                    let _e67 = cell_40;
                    let _e68 = self.v_cell_leave(_e2, _e67);
                    let end_16 = _e68.x().min(_e68.y()).min(rt::Scalar(path_62.exit));
                    let _e74 = t_41;
                    let span_15 = (end_16 - _e74).max(rt::Scalar(0f32));
                    let _e78 = t_41;
                    let _e79 = self.v_path_uv(path_62, _e78);
                    let _e80 = t_41;
                    let _e81 = self.v_path_height(path_62, _e80);
                    let _e83 = self.v_distance_at(path_62, _e79, _e81, params_45.z());
                    let free = (_e83 - lost_4);
                    let _e85 = cost_26;
                    let _e87 = self.v_map_read(path_62, rt::Scalar(4u32));
                    let _e90 = self.v_map_read(path_62, rt::Scalar(4u32));
                    cost_26 = ((_e85 + _e87) + _e90);
                    let _e92 = t_41;
                    next_8 = _e92;
                    if rt::Scalar::into_branch_condition(free.elementwise_gt(rt::Scalar(0f32))) {
                        let _e96 = t_41;
                        self.v_mark_ball(_e96, free);
                        let _e97 = t_41;
                        next_8 = (_e97 + (free / speed_4));
                    }
                    if rt::Scalar::into_branch_condition(params_45.y().elementwise_lt(rt::Scalar(0.5f32))) {
                        let _e103 = next_8;
                        let _e104 = t_41;
                        if rt::Scalar::into_branch_condition((!(_e103 - _e104).elementwise_gt((rt::Scalar(0.0000009536743f32) * rt::Scalar(path_62.exit))))) {
                            let _e112 = t_41;
                            let _e114 = cost_26;
                            return <SearchResult>::new(FOUND_ABOVE, _e112, rt::Scalar(path_62.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e114);
                        }
                    } else {
                        let _e118 = next_8;
                        if rt::Scalar::into_branch_condition((!_e118.elementwise_lt(end_16))) {
                            let _e123 = t_41;
                            local_52 = (!end_16.elementwise_gt(_e123));
                        } else {
                            local_52 = rt::Scalar(true);
                        }
                        let _e127 = local_52;
                        if rt::Scalar::into_branch_condition(_e127) {
                            let _e128 = cost_26;
                            cost_26 = (_e128 + HEIGHTS_READ);
                            let _e131 = cell_40;
                            let _e132 = t_41;
                            self.v_mark_patch(_e131, _e132, end_16);
                            let _e133 = cell_40;
                            let _e134 = cell_40;
                            let _e135 = self.v_whole_cell(_e134);
                            let _e137 = self.v_height_cell(_e135, rt::Scalar(path_62.level));
                            let _e138 = t_41;
                            let _e139 = self.v_gap_to(path_62, _e2, _e133, _e137, _e138);
                            let _e140 = self.v_falls_in_cell(_e139, span_15);
                            if rt::Scalar::into_branch_condition(_e140) {
                                let _e141 = t_41;
                                let _e142 = t_41;
                                let _e145 = cost_26;
                                let _e146 = self.v_found_in_cell(_e139, _e141, span_15, _e142.elementwise_eq(rt::Scalar(0f32)), _e145);
                                return _e146;
                            }
                            let _e147 = t_41;
                            next_8 = _e147.max(end_16);
                        }
                    }
                    let _e149 = next_8;
                    if rt::Scalar::into_branch_condition(_e149.elementwise_ge(rt::Scalar(path_62.exit))) {
                        let _e153 = t_41;
                        let _e155 = cost_26;
                        return <SearchResult>::new(FOUND_MISS, _e153, rt::Scalar(path_62.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e155);
                    }
                    let _e159 = cell_40;
                    let _e160 = next_8;
                    let _e161 = self.v_cell_after(_e2, _e159, _e68, forward_8, _e160);
                    cell_40 = _e161;
                    let _e162 = next_8;
                    t_41 = _e162;
                }
            }
        }
        let _e164 = t_41;
        let _e166 = cost_26;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e164, rt::Scalar(path_62.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e166);
    }
    pub(super) fn v_search_stage(&self, path_74: Path) -> SearchResult {
        let _e5 = rt::Scalar(self.surface_settings.choices[6usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[6usize].params;
                let _e11 = self.v_search_none(path_74, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[6usize].params;
                let _e17 = self.v_search_linear(path_74, _e16);
                return _e17;
            }
            2u32 => {
                let _e22 = self.surface_settings.choices[6usize].params;
                let _e23 = self.v_search_cells(path_74, _e22);
                return _e23;
            }
            3u32 => {
                let _e28 = self.surface_settings.choices[6usize].params;
                let _e29 = self.v_search_frustum(path_74, _e28);
                return _e29;
            }
            4u32 => {
                let _e34 = self.surface_settings.choices[6usize].params;
                let _e35 = self.v_search_cone(path_74, _e34);
                return _e35;
            }
            5u32 => {
                let _e40 = self.surface_settings.choices[6usize].params;
                let _e41 = self.v_search_pyramid(path_74, _e40);
                return _e41;
            }
            6u32 => {
                let _e46 = self.surface_settings.choices[6usize].params;
                let _e47 = self.v_search_pyramid_texels(path_74, _e46);
                return _e47;
            }
            7u32 => {
                let _e52 = self.surface_settings.choices[6usize].params;
                let _e53 = self.v_search_dilation_erosion(path_74, _e52);
                return _e53;
            }
            8u32 => {
                let _e58 = self.surface_settings.choices[6usize].params;
                let _e59 = self.v_search_sphere(path_74, _e58);
                return _e59;
            }
            9u32 => {
                let _e64 = self.surface_settings.choices[6usize].params;
                let _e65 = self.v_search_cone_moved(path_74, _e64);
                return _e65;
            }
            10u32 => {
                let _e70 = self.surface_settings.choices[6usize].params;
                let _e71 = self.v_search_relaxed_cone(path_74, _e70);
                return _e71;
            }
            11u32 => {
                let _e76 = self.surface_settings.choices[6usize].params;
                let _e77 = self.v_search_relaxed_cone_resting(path_74, _e76);
                return _e77;
            }
            12u32 => {
                let _e82 = self.surface_settings.choices[6usize].params;
                let _e83 = self.v_search_voxels(path_74, _e82);
                return _e83;
            }
            13u32 => {
                let _e88 = self.surface_settings.choices[6usize].params;
                let _e89 = self.v_search_generalised(path_74, _e88);
                return _e89;
            }
            14u32 => {
                let _e94 = self.surface_settings.choices[6usize].params;
                let _e95 = self.v_search_view_dependent(path_74, _e94);
                return _e95;
            }
            15u32 => {
                let _e100 = self.surface_settings.choices[6usize].params;
                let _e101 = self.v_search_view_dependent_free(path_74, _e100);
                return _e101;
            }
            16u32 => {
                let _e106 = self.surface_settings.choices[6usize].params;
                let _e107 = self.v_search_translucent(path_74, _e106);
                return _e107;
            }
            17u32 => {
                let _e112 = self.surface_settings.choices[6usize].params;
                let _e113 = self.v_search_shell_map(path_74, _e112);
                return _e113;
            }
            18u32 => {
                let _e118 = self.surface_settings.choices[6usize].params;
                let _e119 = self.v_search_view_dependent_svd(path_74, _e118);
                return _e119;
            }
            _ => {
                let _e124 = self.surface_settings.choices[6usize].params;
                let _e125 = self.v_search_view_dependent_clusters(path_74, _e124);
                return _e125;
            }
        }
    }
    pub(super) fn v_search_view_dependent(
        &self,
        path_66: Path,
        params_48: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_2: JoinedViews;
        let mut k_12: rt::Scalar<u32> = rt::Scalar(0u32);

        self.v_mark_turn(rt::Scalar(0f32));
        let _e4 = self.v_path_axes(path_66, params_48.w());
        let _e5 = self.v_views_around(_e4, params_48);
        let _e10 = self.v_map_read(path_66, (rt::Scalar(_e5.pairs) * rt::Scalar(8u32)));
        let cost_31 = (STEP + _e10);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e4.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_66.exit), rt::Scalar(path_66.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e23 = self.v_path_uv(path_66, rt::Scalar(_e4.start));
        let _e25 = self.v_height_texels(rt::Scalar(path_66.level));
        let _e26 = self.v_texels_around(_e23, _e25);
        let _e27 = self.v_no_views();
        joined_2 = _e27;
        'naga_break: loop {
            'naga_continue: {
                let _e31 = k_12;
                if rt::Scalar::into_branch_condition(_e31.elementwise_lt(rt::Scalar(_e5.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e34 = k_12;
                    let _e35 = self.v_view_pair(_e5, _e34);
                    let _e36 = joined_2;
                    let _e37 = k_12;
                    let _e40 = self.v_ways_of_bend(path_66, _e26, rt::Scalar(_e35.layer), rt::Scalar(_e35.bend));
                    let _e41 = self.v_with_pair(_e36, _e5, _e37, _e40);
                    joined_2 = _e41;
                    let _e42 = k_12;
                    k_12 = (_e42 + rt::Scalar(1u32));
                }
            }
        }
        let _e45 = joined_2;
        let _e46 = self.v_joined_way(_e45, _e5);
        let _e47 = self.v_hit_on_way(path_66, _e4, _e46, cost_31);
        return _e47;
    }
    pub(super) fn v_search_view_dependent_clusters(
        &self,
        path_73: Path,
        params_53: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_4: JoinedViews;
        let mut k_14: rt::Scalar<u32> = rt::Scalar(0u32);

        self.v_mark_turn(rt::Scalar(0f32));
        let _e4 = self.v_path_axes(path_73, params_53.w());
        if rt::Scalar::into_branch_condition(rt::Scalar(_e4.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_73.exit), rt::Scalar(path_73.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e15 = self.v_views_around(_e4, params_53);
        let _e17 = self.v_path_uv(path_73, rt::Scalar(_e4.start));
        let _e19 = self.v_height_texels(rt::Scalar(path_73.level));
        let _e20 = self.v_texels_around(_e17, _e19);
        let _e21 = self.v_search_layers(path_73);
        let _e22 = self.v_no_views();
        joined_4 = _e22;
        'naga_break: loop {
            'naga_continue: {
                let _e26 = k_14;
                if rt::Scalar::into_branch_condition(_e26.elementwise_lt(rt::Scalar(_e15.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e29 = k_14;
                    let _e30 = self.v_view_pair(_e15, _e29);
                    let _e31 = self.v_clustered_ways(path_73, _e20, _e30, params_53, _e21);
                    let _e32 = joined_4;
                    let _e33 = k_14;
                    let _e34 = self.v_with_pair(_e32, _e15, _e33, _e31);
                    joined_4 = _e34;
                    let _e35 = k_14;
                    k_14 = (_e35 + rt::Scalar(1u32));
                }
            }
        }
        let _e49 = self.v_texel_reads(path_73, ((rt::Scalar(_e15.pairs) * rt::Scalar(4u32)) * (rt::Scalar(1u32) + ((_e21 - rt::Scalar(1u32)) * rt::Scalar(5u32)))));
        let cost_33 = (STEP + _e49);
        let _e51 = joined_4;
        let _e52 = self.v_joined_way(_e51, _e15);
        let _e53 = self.v_hit_on_way(path_73, _e4, _e52, cost_33);
        return _e53;
    }
    pub(super) fn v_search_view_dependent_free(
        &self,
        path_67: Path,
        params_49: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut local_54: rt::Scalar<bool>;
        let mut local_55: rt::Scalar<bool>;
        let mut local_56: rt::Scalar<bool>;
        let mut local_57: rt::Scalar<bool>;
        let mut local_58: rt::Scalar<bool>;

        self.v_mark_turn(rt::Scalar(0f32));
        let _e4 = self.v_path_axes(path_67, params_49.w());
        let _e7 = self.v_height_size(rt::Scalar(path_67.level));
        let place_9 = (path_67.uv * _e7);
        let _e9 = self.v_cell_of(place_9);
        let inside_2 = (place_9 - _e9);
        let near_14 = inside_2.x().min((rt::Scalar(1f32) - inside_2.x())).min(inside_2.y().min((rt::Scalar(1f32) - inside_2.y())));
        let rounded_2 = (rt::Scalar(0.0000009536743f32) * (place_9.x().abs().max(place_9.y().abs()) + rt::Scalar(1f32)));
        let _e32 = self.v_height_size(rt::Scalar(path_67.level));
        let _e33 = self.v_is_in_footprint(_e9, _e32);
        if rt::Scalar::into_branch_condition(path_67.h.x().elementwise_eq(rt::Scalar(1f32))) {
            local_54 = rt::Scalar(_e4.comes_in).elementwise_eq(rt::Scalar(1u32));
        } else {
            local_54 = rt::Scalar(false);
        }
        let _e44 = local_54;
        if rt::Scalar::into_branch_condition(_e44) {
            local_55 = near_14.elementwise_gt(rounded_2);
        } else {
            local_55 = rt::Scalar(false);
        }
        let _e49 = local_55;
        if rt::Scalar::into_branch_condition(_e49) {
            local_56 = _e33;
        } else {
            local_56 = rt::Scalar(false);
        }
        let is_known = local_56;
        if rt::Scalar::into_branch_condition((!(!is_known))) {
            if rt::Scalar::into_branch_condition(params_49.z().elementwise_eq(rt::Scalar(1f32))) {
                local_58 = path_67.h.z().elementwise_ne(rt::Scalar(0f32));
            } else {
                local_58 = rt::Scalar(false);
            }
            let _e68 = local_58;
            local_57 = _e68;
        } else {
            local_57 = rt::Scalar(true);
        }
        let _e70 = local_57;
        if rt::Scalar::into_branch_condition(_e70) {
            return <SearchResult>::new(FOUND_ABOVE, rt::Scalar(0f32), rt::Scalar(path_67.exit), rt::Scalar(0f32), rt::Scalar(1f32), STEP);
        }
        let _e78 = self.v_whole_cell(_e9);
        let _e79 = self.v_free_way_of_step(path_67, _e4, _e78, params_49);
        let free_1 = (_e79 / rt::Scalar(_e4.fall));
        let _e88 = self.v_map_read(path_67, rt::Scalar(1u32));
        return <SearchResult>::new(FOUND_ABOVE, free_1.min(rt::Scalar(path_67.exit)), rt::Scalar(path_67.exit), rt::Scalar(0f32), rt::Scalar(1f32), (STEP + _e88));
    }
    pub(super) fn v_search_view_dependent_svd(
        &self,
        path_72: Path,
        params_52: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_3: JoinedViews;
        let mut k_13: rt::Scalar<u32> = rt::Scalar(0u32);

        self.v_mark_turn(rt::Scalar(0f32));
        let _e4 = self.v_path_axes(path_72, params_52.w());
        if rt::Scalar::into_branch_condition(rt::Scalar(_e4.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_72.exit), rt::Scalar(path_72.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e15 = self.v_views_around(_e4, params_52);
        let _e17 = self.v_path_uv(path_72, rt::Scalar(_e4.start));
        let _e19 = self.v_height_texels(rt::Scalar(path_72.level));
        let _e20 = self.v_texels_around(_e17, _e19);
        let _e21 = self.v_search_layers(path_72);
        let _e22 = self.v_no_views();
        joined_3 = _e22;
        'naga_break: loop {
            'naga_continue: {
                let _e26 = k_13;
                if rt::Scalar::into_branch_condition(_e26.elementwise_lt(rt::Scalar(_e15.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e29 = k_13;
                    let _e30 = self.v_view_pair(_e15, _e29);
                    let _e31 = self.v_summed_ways(path_72, _e20, _e30, params_52, _e21);
                    let _e32 = joined_3;
                    let _e33 = k_13;
                    let _e34 = self.v_with_pair(_e32, _e15, _e33, _e31);
                    joined_3 = _e34;
                    let _e35 = k_13;
                    k_13 = (_e35 + rt::Scalar(1u32));
                }
            }
        }
        let _e43 = self.v_texel_reads(path_72, ((rt::Scalar(_e15.pairs) * _e21) * rt::Scalar(8u32)));
        let cost_32 = (STEP + _e43);
        let _e45 = joined_3;
        let _e46 = self.v_joined_way(_e45, _e15);
        let _e47 = self.v_hit_on_way(path_72, _e4, _e46, cost_32);
        return _e47;
    }
}
