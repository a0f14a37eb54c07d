//! Bounds that show that a node requires no more: its height, hulls, and a plane above it.

use super::super::ahead::Run;
use super::{LANES, Node, NodeExtent, Search, TIE};
use crate::fixed_point::{EXACT, floor};
use crate::upper_hulls::HullVertex;
use crate::upper_planes::UpperPlane;

/// Factor that lowers products of slopes and distances by more than their rounding.
const NEARLY: f64 = 1.0 - 1.0 / (1u64 << 48) as f64;

/// Hull relative to the lanes.
#[derive(Clone, Copy)]
struct RelativeHull<'a> {
    hull: &'a [HullVertex],
    axis: usize,
    /// Amount by which the distance is less than the texels ahead.
    less: f64,
    /// Whether the hull requires the same slope as the node.
    is_all: bool,
}

impl Search<'_> {
    /// Returns the height of a node above the height at which it is as steep as each lane's best.
    /// It is positive where the node may be steeper.
    #[inline(always)]
    pub(super) fn excess(&self, extent: &NodeExtent) -> [f32; LANES] {
        let [near_u, near_v] = extent.near.map(|ahead| ahead as i32 as f32);
        let [far_u, far_v] = extent.far.map(|ahead| ahead as i32 as f32);
        let mut excess = [0.0; LANES];
        let lanes = self.shift.iter().zip(&self.top).zip(&self.cautious);
        for (excess, ((shift, top), cautious)) in excess.iter_mut().zip(lanes) {
            let (near, far) = (near_u + shift, far_u + shift);
            // Texels beside the diagonal count in a diagonal cell, too, from half a texel nearer.
            let beside = (near <= far_v + 1.0) & (near_v <= far + 1.0);
            let farther = if near > near_v { near } else { near_v };
            let distance = farther - if beside { 1.5 } else { 1.0 };
            let distance = if distance > 0.0 { distance } else { 0.0 };
            *excess = (extent.highest - top) - cautious * distance;
        }
        excess
    }

    /// Removes the lanes that have all of a node behind their cell. Removes also the lanes for
    /// which hulls and the plane above it show that nothing else of the node is steeper than their
    /// best. Returns whether any lane remains.
    // Most nodes do not come here, and the loop over nodes is faster without it.
    #[inline(never)]
    pub(super) fn may_be_steeper(
        &mut self,
        runs: &[Run; 2],
        node: Node,
        extent: &NodeExtent,
        lanes: &mut [bool; LANES],
    ) -> bool {
        for (lane, shift) in lanes.iter_mut().zip(&self.shift) {
            *lane &= extent.far[0] + *shift as i64 >= 0;
        }
        *lanes != [false; LANES]
            && self.may_rise_above_hulls(runs, node, lanes)
            && self.may_rise_above_plane(runs, node, extent, lanes)
    }

    /// Visits a node by the hulls of its profiles, and removes the lanes for which nothing else of
    /// it is steeper than their best. Returns whether any lane remains.
    ///
    /// No texel is nearer than along either axis, so the steepest slopes of both profiles are
    /// bounds. Where the quadrant holds all of the node, on one side of the diagonal, that axis
    /// *is* the distance. The hull then requires the same slope as the node, and the node need not
    /// be searched.
    #[inline(always)]
    fn may_rise_above_hulls(&mut self, runs: &[Run; 2], node: Node, lanes: &mut [bool; LANES]) -> bool {
        let size = [self.map.width(), self.map.height()];
        let (mut near, mut far, mut is_inside) = ([0; 2], [0; 2], true);
        for axis in 0..2 {
            let first = node.at[axis] << node.level;
            let last = (((node.at[axis] + 1) << node.level) - 1).min(size[axis] - 1);
            is_inside &= first >= runs[axis].first && last <= runs[axis].last;
            let (a, b) = (runs[axis].ahead(first), runs[axis].ahead(last));
            (near[axis], far[axis]) = (a.min(b), a.max(b));
        }
        // Of all lanes together.
        let shift = if self.forward[0] { 1 - LANES as i64 } else { 0 };
        near[0] += shift;
        far[0] += shift + LANES as i64 - 1;
        is_inside &= near[0] >= 0 && near[1] >= 0;
        for axis in 0..2 {
            let is_aside = near[axis] >= far[1 - axis] + 2;
            let (less, is_all) = (if is_aside { 1.0 } else { 1.5 }, is_aside && is_inside);
            if near[axis] < 2 {
                continue;
            }
            let Some(hull) = self.hulls.hull(node.level, node.at, axis) else { continue };
            self.keep_above_hull(runs, RelativeHull { hull, axis, less, is_all }, lanes);
            if is_all || *lanes == [false; LANES] {
                return false;
            }
        }
        true
    }

    /// Removes the lanes for which no vertex of a hull is steeper than their best. If the hull is
    /// exact, offers its slopes instead.
    #[inline(always)]
    fn keep_above_hull(&mut self, runs: &[Run; 2], relative: RelativeHull, lanes: &mut [bool; LANES]) {
        let mut is_above = [false; LANES];
        for vertex in relative.hull {
            let ahead = [runs[0].ahead(vertex.texel[0]), runs[1].ahead(vertex.texel[1])];
            let height = f64::from(vertex.height);
            let distance = ahead[relative.axis] as f64 - relative.less;
            let mut excess = [0.0; LANES];
            let mut any = false;
            for (lane, excess) in excess.iter_mut().enumerate() {
                let shift = if relative.axis == 0 { f64::from(self.shift[lane]) } else { 0.0 };
                let asked = self.slope[lane] * (distance + shift) * NEARLY;
                *excess = height - f64::from(self.top[lane]) - asked;
                any |= *excess > 0.0;
            }
            if !any {
                continue;
            }
            for (lane, is_above) in is_above.iter_mut().enumerate() {
                let shift = self.shift[lane];
                let by = if relative.axis == 0 { f64::from(shift) } else { 0.0 };
                let slope = (height - f64::from(self.top[lane])) / (distance + by);
                if slope > self.slope[lane] {
                    if relative.is_all {
                        self.offer(lane, slope, [ahead[0] + shift as i64, ahead[1]]);
                    } else if slope > self.slope[lane] * TIE {
                        *is_above = true;
                    } else {
                        self.is_tied[lane] = true;
                    }
                }
            }
        }
        for (lane, is_above) in lanes.iter_mut().zip(is_above) {
            *lane &= is_above;
        }
    }

    /// Removes the lanes for which nothing below the plane above a node is steeper than their best.
    /// Returns whether any lane remains.
    #[inline(always)]
    fn may_rise_above_plane(
        &mut self,
        runs: &[Run; 2],
        node: Node,
        extent: &NodeExtent,
        lanes: &mut [bool; LANES],
    ) -> bool {
        let Some(plane) = self.planes.plane(node.level, node.at) else { return true };
        let is_above = self.above_plane(runs, node, plane, extent, &self.fine_slope);
        for (lane, is_above) in lanes.iter_mut().zip(is_above) {
            *lane &= is_above;
        }
        if *lanes == [false; LANES] {
            return false;
        }
        let mut raised = [0.0; LANES];
        for (raised, slope) in raised.iter_mut().zip(&self.slope) {
            *raised = floor(slope * TIE);
        }
        let is_above = self.above_plane(runs, node, plane, extent, &raised);
        for ((lane, is_above), is_tied) in lanes.iter_mut().zip(is_above).zip(&mut self.is_tied) {
            *is_tied |= *lane & !is_above;
            *lane &= is_above;
        }
        *lanes != [false; LANES]
    }

    /// Returns the lanes in which a node may require more than those slopes by the plane above it.
    ///
    /// Over the cells around the node's texels the surface is below the plane, and so below the
    /// frustum where the plane is. The plane less the slope times `max(u, v)` is linear on either
    /// side of the diagonal. So it is greatest at a corner of the box of these cells, as far as it
    /// is in the quadrant, or where the diagonal crosses the box's rim. All numbers are multiples
    /// of one over [`GRID`](crate::fixed_point::GRID), to which top and slope are rounded down.
    /// Nothing else is rounded: the last bit separates a tie from a rise.
    #[inline(always)]
    fn above_plane(
        &self,
        runs: &[Run; 2],
        node: Node,
        plane: &UpperPlane,
        extent: &NodeExtent,
        slopes: &[f64; LANES],
    ) -> [bool; LANES] {
        let mut along = plane.along.map(f64::from);
        let mut zero = plane.height;
        let mut most = plane.height.abs() + 2.0;
        let (mut from, mut to) = ([0.0; 2], [0.0; 2]);
        for axis in 0..2 {
            along[axis] = if runs[axis].rising { along[axis] } else { -along[axis] };
            let first = runs[axis].ahead(node.at[axis] << node.level) as f64;
            (from[axis], to[axis]) = (extent.near[axis] as f64 - 1.0, extent.far[axis] as f64 + 1.0);
            zero -= along[axis] * first;
            most += along[axis].abs() * (first.abs() + from[axis].abs().max(to[axis].abs()) + LANES as f64);
        }
        let top = greater(from[1], 0.0);
        let mut is_above = [true; LANES];
        let lanes = self.shift.iter().zip(slopes).zip(&self.fine_top);
        for (is_above, ((shift, &slope), &height)) in is_above.iter_mut().zip(lanes) {
            let shift = f64::from(*shift);
            let (left, right) = (greater(from[0] + shift, 0.0), to[0] + shift);
            let over = |u: f64, v: f64| along[0] * (u - shift) + along[1] * v - slope * greater(u, v);
            let near = greater(over(left, top), over(right, top));
            let far = greater(over(left, to[1]), over(right, to[1]));
            let (enter, leave) = (greater(left, top), -greater(-right, -to[1]));
            let diagonal = greater(over(enter, enter), over(leave, leave));
            let diagonal = if enter <= leave { diagonal } else { f64::NEG_INFINITY };
            let highest = greater(greater(near, far), diagonal);
            let is_exact = most + slope * greater(right.abs(), to[1].abs()) < EXACT;
            *is_above = !(is_exact & (zero + highest + slope <= height));
        }
        is_above
    }
}

/// Returns the greater number, in the form that compiles to one instruction.
#[inline(always)]
fn greater(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}
