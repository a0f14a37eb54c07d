//! Steepest slope from one apex to the falling part of a patch, in closed form.
//!
//! With the rise `f = A + Bx + Cy + Dxy` above the apex, `(x, y)` metres from it, the patch falls
//! away from the apex where `F = Bx + Cy + 2Dxy < 0`. There the slope `f/r` falls along every ray
//! from the apex, as `(f/r)' = (F/r - f/r) / r`, where it is positive. So its supremum is where the
//! ray enters the patch or where the patch begins to fall: on an edge, or on the curve of peaks
//! `F = 0`.
//!
//! `F` is bilinear. Where it is negative at no corner the patch does not fall: it may be level, or
//! touch `F = 0` at a corner or along an edge.
//!
//! * On an edge `F` is linear, and so is `f`: the slope has one maximum, and the falling part is a
//!   segment. Where `F` is 0 along a whole edge, the patch falls right beside it if it does at the
//!   opposite edge.
//! * On the curve, towards `(cos, sin)` with `g = B cos + C sin`, the radius is `-g / (2D sin cos)`
//!   and the slope `g/2 - 2AD sin cos / g`. Its derivative vanishes where
//!   `(B²C - 4ADB) + (2BC² - B³) t + (C³ - 2B²C) t² + (4ADC - BC²) t³ = 0`, `t = tan`. Where the
//!   curve leaves the patch it meets an edge.
//! * With the apex at a corner of the patch, `A` is 0 and the slope on the curve is `g/2`, greatest
//!   in the direction of `(B, C)`. Close to the apex nothing of this may be left to rounding, so it
//!   is found separately.

use crate::cone_search::{Patch, inside_segment, to_point};

/// Returns the supremum of the squared slopes to points of the patch at which it falls away from
/// the apex; 0 where there is none. `falls` are signs and sizes of `F` at the corners: see
/// [`super::fall::falls`].
pub(super) fn falling_slope2(patch: &Patch, falls: [f64; 4]) -> f64 {
    if falls.iter().all(|fall| *fall >= 0.0) {
        return 0.0;
    }
    let ([h00, h10, h01, h11], [f00, f10, f01, f11]) = (patch.rise, falls);
    let ([x0, y0], [ax, ay]) = (patch.corner, patch.size);
    let (x1, y1) = (x0 + ax, y0 + ay);
    let edges = falling_edge([h00, h10], [[f00, f10], [f01, f11]], [x0, x1], y0)
        .max(falling_edge([h01, h11], [[f01, f11], [f00, f10]], [x0, x1], y1))
        .max(falling_edge([h00, h01], [[f00, f01], [f10, f11]], [y0, y1], x0))
        .max(falling_edge([h10, h11], [[f10, f11], [f00, f01]], [y0, y1], x1));
    let d = ((h00 - h10) + (h11 - h01)) / (ax * ay);
    if d == 0.0 || falls.iter().all(|fall| *fall <= 0.0) {
        return edges;
    }
    let is_inside = |x: f64, y: f64| x > x0 && x < x1 && y > y0 && y < y1;
    if (x0 == 0.0 || x1 == 0.0) && (y0 == 0.0 || y1 == 0.0) {
        // Rises along the two edges that meet at the apex.
        let aside = if y0 == 0.0 { [h00, h10] } else { [h01, h11] };
        let ahead = if x0 == 0.0 { [h00, h01] } else { [h10, h11] };
        let (b, c) = ((aside[1] - aside[0]) / ax, (ahead[1] - ahead[0]) / ay);
        let gradient2 = b * b + c * c;
        let (x, y) = (-gradient2 / (2.0 * d * c), -gradient2 / (2.0 * d * b));
        // Towards the gradient, not against it.
        let is_peak = b * x > 0.0 && is_inside(x, y);
        return if is_peak { edges.max(0.25 * gradient2) } else { edges };
    }
    let (bx, by) = ((h10 - h00) / ax, (h01 - h00) / ay);
    let (b, c) = (bx - d * y0, by - d * x0);
    let a = h00 - bx * x0 - by * y0 + d * x0 * y0;
    let (bb, cc) = (b * b, c * c);
    let cubic =
        [b * (b * c - 4.0 * a * d), b * (2.0 * cc - bb), c * (cc - 2.0 * bb), c * (4.0 * a * d - b * c)];
    let mut best = edges;
    for t in real_roots(cubic).into_iter().flatten() {
        let x = -(b + c * t) / (2.0 * d * t);
        let y = t * x;
        if is_inside(x, y) {
            best = best.max(to_point(a + b * x + (c + d * x) * y, [x, y]));
        }
    }
    best
}

/// Returns the greatest squared slope to the falling part of an edge from `from` to `to` along one
/// axis, `beside` away along the other. `rise` are the rises above the apex at its ends. `own` and
/// `opposite` are `F` there and at the ends of the opposite edge.
fn falling_edge(rise: [f64; 2], [own, opposite]: [[f64; 2]; 2], [from, to]: [f64; 2], beside: f64) -> f64 {
    let falls = if own == [0.0; 2] { opposite } else { own };
    if falls[0] >= 0.0 && falls[1] >= 0.0 {
        return 0.0;
    }
    // Place where `F` is 0, as a part of the edge.
    let turn = (falls[0] / (falls[0] - falls[1])).clamp(0.0, 1.0);
    let [begin, end] = [if falls[0] > 0.0 { turn } else { 0.0 }, if falls[1] > 0.0 { turn } else { 1.0 }];
    let rises = [begin, end].map(|part| rise[0] + (rise[1] - rise[0]) * part);
    let places = [begin, end].map(|part| from + (to - from) * part);
    let ends = to_point(rises[0], [places[0], beside]).max(to_point(rises[1], [places[1], beside]));
    ends.max(inside_segment(rises, places[0], places[1], beside))
}

/// Returns the real roots of a polynomial of degree 3 at most, lowest coefficient first. A few
/// correct digits suffice, since the roots are places of maxima.
fn real_roots([k0, k1, k2, k3]: [f64; 4]) -> [Option<f64>; 3] {
    let size = k0.abs().max(k1.abs()).max(k2.abs()).max(k3.abs());
    // Below this the third root is farther than anything visited.
    const FLAT: f64 = 1e-12;
    if k3.abs() <= FLAT * size {
        if k2.abs() <= FLAT * size {
            return [(k1 != 0.0).then(|| -k0 / k1), None, None];
        }
        let disc = k1 * k1 - 4.0 * k0 * k2;
        if disc < 0.0 {
            return [None; 3];
        }
        let q = -0.5 * (k1 + disc.sqrt().copysign(k1));
        return [Some(q / k2), (q != 0.0).then(|| k0 / q), None];
    }
    let (a, b, c) = (k2 / k3, k1 / k3, k0 / k3);
    let (q, r) = ((a * a - 3.0 * b) / 9.0, (a * (2.0 * a * a - 9.0 * b) + 27.0 * c) / 54.0);
    let polished = |x: f64| {
        let (value, slope) = (((x + a) * x + b) * x + c, (3.0 * x + 2.0 * a) * x + b);
        let step = value / slope;
        Some(if step.is_finite() { x - step } else { x })
    };
    if r * r < q * q * q {
        let angle = (r / (q * q * q).sqrt()).clamp(-1.0, 1.0).acos();
        [0.0, 1.0, -1.0].map(|turn| {
            polished(-2.0 * q.sqrt() * ((angle + turn * std::f64::consts::TAU) / 3.0).cos() - a / 3.0)
        })
    } else {
        let s = -(r.abs() + (r * r - q * q * q).sqrt()).cbrt().copysign(r);
        let t = if s == 0.0 { 0.0 } else { q / s };
        // A double root beside the single one, where the discriminant vanishes.
        [polished(s + t - a / 3.0), polished(-0.5 * (s + t) - a / 3.0), None]
    }
}

#[cfg(test)]
mod tests {
    use relief_core::rng::Rng;

    use super::*;

    #[test]
    fn real_roots_are_found() {
        let mut rng = Rng::new(4);
        for _ in 0..20_000 {
            let roots = [0; 3].map(|_| rng.between(-3.0, 3.0));
            let [p, q, r] = roots;
            let scale = rng.between(-2.0, 2.0);
            let cubic = [-p * q * r, p * q + q * r + r * p, -(p + q + r), 1.0].map(|k| k * scale);
            let found = real_roots(cubic);
            for root in roots {
                let nearest = found.into_iter().flatten().map(|x| (x - root).abs()).fold(9.0, f64::min);
                assert!(nearest < 1e-3, "{roots:?} scaled by {scale}: {found:?}");
            }
        }
        assert_eq!(real_roots([-6.0, 2.0, 0.0, 0.0])[0], Some(3.0));
        let mut both: Vec<f64> = real_roots([-2.0, 1.0, 1.0, 0.0]).into_iter().flatten().collect();
        both.sort_by(f64::total_cmp);
        assert_eq!(both, [-2.0, 1.0]);
    }

    #[test]
    fn the_closed_form_finds_what_sampling_finds() {
        let mut rng = Rng::new(2);
        let mut mixed = 0;
        for _ in 0..4000 {
            let corner = [rng.between(-3.5, 2.5), rng.between(-3.5, 2.5)];
            let size = [1.0, rng.between(0.5, 1.5)];
            let rise = [0; 4].map(|_| rng.between(-0.5, 1.0));
            let patch = Patch { corner, size, rise };
            if (0..2).all(|axis| corner[axis] < 0.1 && corner[axis] + size[axis] > -0.1) {
                continue;
            }
            let fall_at = |u: f64, v: f64| {
                let [h00, h10, h01, h11] = rise;
                let along_x = ((h10 - h00) * (1.0 - v) + (h11 - h01) * v) / size[0];
                let along_y = ((h01 - h00) * (1.0 - u) + (h11 - h10) * u) / size[1];
                along_x * (corner[0] + u * size[0]) + along_y * (corner[1] + v * size[1])
            };
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
            let found = falling_slope2(&patch, corners.map(|[u, v]| fall_at(u, v)));
            const SIDE: usize = 80;
            let (mut sampled, mut falling) = (0.0f64, 0);
            for i in 0..=SIDE {
                for j in 0..=SIDE {
                    let (u, v) = (i as f64 / SIDE as f64, j as f64 / SIDE as f64);
                    let (x, y) = (corner[0] + u * size[0], corner[1] + v * size[1]);
                    let [h00, h10, h01, h11] = rise;
                    if fall_at(u, v) < 0.0 {
                        let f = (h00 * (1.0 - u) + h10 * u) * (1.0 - v) + (h01 * (1.0 - u) + h11 * u) * v;
                        sampled = sampled.max(to_point(f, [x, y]));
                        falling += 1;
                    }
                }
            }
            mixed += u32::from(falling > 0 && falling < (SIDE + 1) * (SIDE + 1));
            assert!(sampled <= found * (1.0 + 1e-12) + 1e-15, "{patch:?}: {sampled} sampled, {found} found");
            assert!(
                sampled.sqrt() >= found.sqrt() * 0.93 - 0.03,
                "{patch:?}: {sampled} sampled, {found} found"
            );
        }
        assert!(mixed > 500, "only {mixed} patches fall in part");
    }

    #[test]
    fn from_a_corner_the_closed_form_finds_what_sampling_finds() {
        let mut rng = Rng::new(3);
        let mut peaks = 0;
        for _ in 0..4000 {
            let (size, at) = ([1.0, rng.between(0.5, 1.5)], [0; 2].map(|_| rng.pick(&[0.0, 1.0])));
            let corner = [0, 1].map(|axis: usize| -at[axis] * size[axis]);
            let mut rise = [0; 4].map(|_| rng.between(-0.2, 1.0));
            rise[at[0] as usize + 2 * at[1] as usize] = 0.0;
            let [h00, h10, h01, h11] = rise;
            let height =
                |u: f64, v: f64| (h00 * (1.0 - u) + h10 * u) * (1.0 - v) + (h01 * (1.0 - u) + h11 * u) * v;
            let place = |u: f64, v: f64| [corner[0] + u * size[0], corner[1] + v * size[1]];
            let fall_at = |u: f64, v: f64| {
                let [x, y] = place(u, v);
                let along_x = ((h10 - h00) * (1.0 - v) + (h11 - h01) * v) / size[0];
                let along_y = ((h01 - h00) * (1.0 - u) + (h11 - h10) * u) / size[1];
                along_x * x + along_y * y
            };
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
            let found = falling_slope2(&Patch { corner, size, rise }, corners.map(|[u, v]| fall_at(u, v)));
            const SIDE: usize = 200;
            let mut sampled = 0.0f64;
            for i in 0..=SIDE {
                for j in 0..=SIDE {
                    let (u, v) = (i as f64 / SIDE as f64, j as f64 / SIDE as f64);
                    if fall_at(u, v) < 0.0 {
                        sampled = sampled.max(to_point(height(u, v), place(u, v)));
                    }
                }
            }
            peaks += u32::from(found > 0.0);
            assert!(sampled <= found * (1.0 + 1e-9), "{rise:?} at {at:?}: {sampled} sampled, {found} found");
            assert!(
                sampled.sqrt() >= found.sqrt() - 0.02,
                "{rise:?} at {at:?}: {sampled} sampled, {found} found"
            );
        }
        assert!(peaks > 300, "only {peaks} patches fall above the apex");
    }
}
