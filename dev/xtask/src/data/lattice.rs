//! Repeatable randomness on a lattice that repeats with the tile.

/// A number in `[0, 1)` for a lattice point, without visible pattern.
pub fn random(x: u32, y: u32, seed: u32) -> f64 {
    let mut bits = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77) ^ seed.wrapping_mul(0xc2b2_ae3d);
    for (shift, factor) in [(16, 0x7feb_352d_u32), (15, 0x846c_a68b), (17, 0xed5a_d4bb)] {
        bits = (bits ^ (bits >> shift)).wrapping_mul(factor);
    }
    f64::from(bits ^ (bits >> 14)) / 4_294_967_296.0
}

/// A number in `[-1, 1)` for a lattice point.
pub fn signed(x: u32, y: u32, seed: u32) -> f64 {
    2.0 * random(x, y, seed) - 1.0
}

/// 0 up to `from`, 1 beyond `to`, a smooth slope between.
pub fn smooth_step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

pub fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

pub fn mix_colour(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    [mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)]
}

/// A smooth random field with values about `[-1, 1]` and features of size `1 / period`; it repeats in the
/// unit square.
pub fn gradient_noise(u: f64, v: f64, period: u32, seed: u32) -> f64 {
    let (x, y) = (u * f64::from(period), v * f64::from(period));
    let (x0, y0) = (x.floor(), y.floor());
    let (fx, fy) = (x - x0, y - y0);
    let wrapped = |cell: f64, step: u32| (cell as i64 + i64::from(step)).rem_euclid(i64::from(period)) as u32;
    let corner = |i: u32, j: u32| {
        let (a, b) = (wrapped(x0, i), wrapped(y0, j));
        let (gx, gy) = (signed(a, b, seed), signed(a, b, seed ^ 0x5bd1_e995));
        gx * (fx - f64::from(i)) + gy * (fy - f64::from(j))
    };
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let (wx, wy) = (fade(fx), fade(fy));
    1.5 * mix(mix(corner(0, 0), corner(1, 0), wx), mix(corner(0, 1), corner(1, 1), wx), wy)
}

/// Gradient noise on `octaves` scales, each half as large and half as strong as the one before.
pub fn fractal_noise(u: f64, v: f64, period: u32, octaves: u32, seed: u32) -> f64 {
    (0..octaves)
        .map(|octave| gradient_noise(u, v, period << octave, seed + octave) / f64::from(1u32 << octave))
        .sum()
}

/// The shortest way from `a` to `b` on a circle of length 1.
pub fn wrapped_difference(a: f64, b: f64) -> f64 {
    let difference = b - a;
    difference - (difference + 0.5).floor()
}
