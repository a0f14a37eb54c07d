//! Bounds by which the four patches around a texel's centre, which hold its apexes, limit its
//! relaxed cone.
//!
//! Let `q` lie in patch `X`, the apex `p` in the quarter of patch `Y` that belongs to the texel,
//! `(x, y) = q - p` in texels, `r` its length in metres. A falling pair rises by at most `A - Dxy`.
//! Here `A` is the height of `X` extended over `p` above `Y` there, and `D` the twist of `X`.
//!
//! * `X = Y`: `A` is 0. `xy / r` grows with either factor, and so is greatest at the corners of the
//!   boxes. Along the ray the patch is a parabola that begins with the slope `g`. Where it falls,
//!   its mean slope is at most `g/2`.
//! * `X` beside `Y`: let `t` be the distance of `p` from the edge between. Then `A = J t`, where
//!   `J` is the excess of the rise of `Y` over the rise of `X` across the edge, linear along it;
//!   and `r ≥ t`.
//! * `X` opposite to `Y`: let `(s, t)` be the offsets of `p` from the centre. Then
//!   `A = J s + K t + E s t`, where `J` and `K` are the excess of the rises of `Y` over the rises
//!   of `X` at the centre, and `E` is the difference of their twists. And `r` is at least the
//!   distance of `p` from the centre.
//! * With `X` another patch than `Y`, the way from `p` enters `X` at some `e`. Up to there it rises
//!   at most as the patches before do, along ways that do not lead back from `X` to `Y`. Behind `e`
//!   the surface is a parabola that falls at its end. So its mean slope is at most half of its
//!   loss, `-Dxy / r` with `(x, y) = q - e`, and half of the slope at `e`. The slope from `p` to
//!   `q` is a mean of both.
//!
//! A level patch falls nowhere.

/// Returns an upper bound, in heights per metre, of the slope from the apexes to falling points of
/// the four patches. `near` are the 3 by 3 heights around the centre, `half` is half the side of
/// the box of apexes in texels.
pub(super) fn own_bound(near: &[[f64; 3]; 3], texel_m: [f64; 2], half: f64) -> f64 {
    let quadrants = [[1, 1], [-1, 1], [1, -1], [-1, -1]];
    quadrants.into_iter().map(|signs| quadrant_bound(near, signs, texel_m, half)).fold(0.0, f64::max)
}

/// Returns the bound of the patch in one quadrant.
fn quadrant_bound(near: &[[f64; 3]; 3], [sx, sy]: [i64; 2], [ax, ay]: [f64; 2], half: f64) -> f64 {
    // Neighbourhood, mirrored so that the patch is to the right of the centre and below it.
    let at = |i: i64, j: i64| near[(1 + sy * j) as usize][(1 + sx * i) as usize];
    if at(0, 0) == at(1, 0) && at(0, 0) == at(0, 1) && at(0, 0) == at(1, 1) {
        return 0.0;
    }
    let twist = (at(0, 0) - at(1, 0)) + (at(1, 1) - at(0, 1));
    // Greatest `-Dxy / r` for offsets up to `ahead` in the directions of the patch, or one of them
    // up to `back` against it.
    let bent = |ahead: [f64; 2], back: [f64; 2]| {
        let reach = |x: f64, y: f64| if x * y == 0.0 { 0.0 } else { x * y / length(x * ax, y * ay) };
        if twist < 0.0 {
            -twist * reach(ahead[0], ahead[1]).max(reach(back[0], back[1]))
        } else {
            twist * reach(ahead[0], back[1]).max(reach(back[0], ahead[1]))
        }
    };
    let slope_x = |v: f64| (at(1, 0) - at(0, 0)) + twist * v;
    let slope_y = |u: f64| (at(0, 1) - at(0, 0)) + twist * u;
    let size = |slope: &dyn Fn(f64) -> f64| slope(0.0).abs().max(slope(half).abs());
    let same = bent([1.0, 1.0], [half, half]).min(0.5 * length(size(&slope_x) / ax, size(&slope_y) / ay));
    if half == 0.0 {
        return same;
    }
    // Rises of the patches to the left and above towards this one, along the edge from the centre.
    let left = |v: f64| (at(0, 0) - at(-1, 0)) * (1.0 - v) + (at(0, 1) - at(-1, 1)) * v;
    let above = |u: f64| (at(0, 0) - at(0, -1)) * (1.0 - u) + (at(1, 0) - at(1, -1)) * u;
    let jump_x = (left(0.0) - slope_x(0.0)).max(left(half) - slope_x(half)).max(0.0);
    let jump_y = (above(0.0) - slope_y(0.0)).max(above(half) - slope_y(half)).max(0.0);
    // Greatest rise of the patch with that upper left corner along ways that do not lead back.
    let rise = |[i, j]: [i64; 2], ahead: [bool; 2]| {
        let most = |slopes: [f64; 2], is_ahead: bool| {
            let [x, y] = if is_ahead { slopes } else { slopes.map(f64::abs) };
            x.max(y).max(0.0)
        };
        let along_x = most([at(i + 1, j) - at(i, j), at(i + 1, j + 1) - at(i, j + 1)], ahead[0]);
        let along_y = most([at(i, j + 1) - at(i, j), at(i + 1, j + 1) - at(i + 1, j)], ahead[1]);
        length(along_x / ax, along_y / ay)
    };
    // Greatest rises of the ways that enter the patch, from beside it and from opposite.
    let enter = |ahead: [bool; 2]| bent([1.0, 1.0], [1.0, 1.0]).min(0.5 * rise([0, 0], ahead));
    let from_x = rise([-1, 0], [true, false]).max(enter([true, false]));
    let from_y = rise([0, -1], [false, true]).max(enter([false, true]));
    let from_both = [[-1, -1], [-1, 0], [0, -1]].map(|patch| rise(patch, [true, true]));
    let from_both = from_both.into_iter().fold(enter([true, true]), f64::max);
    let beside_x = (jump_x / ax + bent([1.0 + half, 1.0], [0.0, half])).min(from_x);
    let beside_y = (jump_y / ay + bent([1.0, 1.0 + half], [half, 0.0])).min(from_y);
    let opposite_twist = (at(0, 0) - at(-1, 0)) + (at(-1, -1) - at(0, -1));
    let corner_x = (at(0, 0) - at(-1, 0) - slope_x(0.0)).max(0.0);
    let corner_y = (at(0, 0) - at(0, -1) - slope_y(0.0)).max(0.0);
    let lift = (twist - opposite_twist).max(0.0) * half * half / length(half * ax, half * ay);
    let opposite = length(corner_x / ax, corner_y / ay) + lift + bent([1.0 + half, 1.0 + half], [0.0, 0.0]);
    same.max(beside_x).max(beside_y).max(opposite.min(from_both))
}

/// Length of a vector, less careful than `hypot`, and quicker: what underflows is level ground.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}
