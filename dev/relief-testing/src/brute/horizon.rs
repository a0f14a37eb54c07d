//! The horizon of one texel, from every cell on its ray.

use relief_core::HeightMap;

/// A ray along the base plane from a texel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HorizonRay {
    /// Change of the place a step, in texels; the faster axis moves by one.
    pub step: [f64; 2],
    /// Length of a step in metres.
    pub step_m: f64,
}

impl HorizonRay {
    /// The ray at an angle from `+u` towards `+v` that is measured in metres, for texels of that size in
    /// metres.
    pub fn new(angle: f64, texel_m: [f64; 2]) -> Self {
        let exact = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
        let along = [exact(angle.cos()) / texel_m[0], exact(angle.sin()) / texel_m[1]];
        let most = along[0].abs().max(along[1].abs());
        let whole = |x: f64| if (x.abs() - 1.0).abs() < 1e-12 { x.signum() } else { x };
        Self { step: along.map(|x| whole(x / most)), step_m: 1.0 / most }
    }
}

/// The greatest slope, in heights a step, under which the centre of a texel sees a point of the bilinear
/// surface that is at most `reach` steps away along the ray; `highest` is the map's highest texel. Exact, in
/// `f64`; ends early where even the highest texel could not raise it.
pub fn slope(map: &HeightMap, texel: [u32; 2], ray: &HorizonRay, reach: f64, highest: f64) -> f64 {
    let start = texel.map(i64::from);
    let own = f64::from(map.texel(start[0], start[1]));
    let [dx, dy] = ray.step;
    let mut crossed = [0u32; 2];
    let (mut from, mut best) = (0.0, f64::NEG_INFINITY);
    while from < reach - 1e-9 {
        let next = [dx, dy].map(f64::abs);
        let leave = [0, 1].map(|axis| f64::from(crossed[axis] + 1) / next[axis]);
        let to = leave[0].min(leave[1]).min(reach);
        for axis in 0..2 {
            crossed[axis] += u32::from(leave[axis] - to < 1e-9);
        }
        if to - from < 1e-9 {
            continue;
        }
        let middle = 0.5 * (from + to);
        let cell = [dx * middle, dy * middle].map(f64::floor);
        let [h00, h10, h01, h11] =
            map.cell(start[0] + cell[0] as i64, start[1] + cell[1] as i64).map(f64::from);
        let (bx, by, twist) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        // Over the ray the surface is a + b t + c t² above the texel.
        let [x, y] = [-cell[0], -cell[1]];
        let a = if from == 0.0 { 0.0 } else { h00 + bx * x + by * y + twist * x * y - own };
        let b = bx * dx + by * dy + twist * (x * dy + y * dx);
        let c = twist * dx * dy;
        let at = |t: f64| a / t + b + c * t;
        best = best.max(at(to)).max(if from == 0.0 { b } else { at(from) });
        let turn = (a / c).sqrt();
        if a < 0.0 && c < 0.0 && turn > from && turn < to {
            best = best.max(at(turn));
        }
        from = to;
        if (highest - own) <= best * from {
            break;
        }
    }
    best
}
