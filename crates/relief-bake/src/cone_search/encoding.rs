//! Storage of cone ratios.

use relief_core::encoding::cone::{down, encode, half_ratio};
use relief_core::{HeightMap, Metric, Rounding};

use super::tie::raised;
use crate::{BakeError, Channel, Sink, Texture, quantise};

/// Relative rounding of a slope: in closed forms, the stored value and its decoding in `f32`.
const RELATIVE: f64 = 1e-6;
/// Rounding of a rise, in heights.
const RISE: f64 = 1e-15;
/// Least distance in texels of a point outside of an apex's own patch. A smaller number is as safe.
const NEAREST: f64 = 0.25;

/// Returns the ratio of a cone with a squared slope, rounded to the safe side. Slopes that count as
/// equally steep were not searched: see [`super::tie`].
pub fn ratio(slope2: f64, texel_m: [f64; 2]) -> f32 {
    let slope = raised(slope2, texel_m) * (1.0 + RELATIVE) + RISE / (NEAREST * texel_m[0].min(texel_m[1]));
    down((1.0 / slope).min(f64::from(f32::MAX)))
}

/// Hands ratios, encoded and rounded down to `bits` bits, to the sink.
pub fn texture(
    metric: &Metric,
    map: &HeightMap,
    channel: &'static str,
    mut ratios: Vec<f32>,
    bits: u32,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let half = half_ratio(metric);
    for value in &mut ratios {
        *value = quantise::unorm(encode(*value, half), bits, Rounding::Down);
    }
    sink.begin(&Texture {
        name: "",
        size: [map.width(), map.height(), 1],
        mips: Vec::new(),
        channels: vec![Channel { name: channel, unit: "1", range: [0.0, 1.0], rounding: Rounding::Down }],
        notes: vec![
            ("encoding", "ratio = half_ratio_m * v * v / (1 - v * v)".to_owned()),
            ("half_ratio_m", format!("{half:?}")),
            (
                "unit",
                "metres of tile_m from the axis for each unit of texel height above the apex".to_owned(),
            ),
            ("tile_m", format!("{:?} {:?}", metric.tile_m[0], metric.tile_m[1])),
        ],
    })?;
    Ok(sink.slice(&[&ratios])?)
}

#[cfg(test)]
mod tests {
    use relief_core::encoding::cone::decode;

    use super::*;

    #[test]
    fn stored_ratios_are_never_wider_and_lose_little() {
        for k in -160..200 {
            let ratio = 1.17f32.powi(k);
            for bits in [0, 8, 16] {
                let back = decode(quantise::unorm(encode(ratio, 0.125), bits, Rounding::Down), 0.125);
                assert!(back <= f64::from(ratio) && back.is_finite(), "{ratio} came back as {back}");
            }
            if (0.002..1.0).contains(&ratio) {
                let back = decode(quantise::unorm(encode(ratio, 0.125), 16, Rounding::Down), 0.125);
                assert!(back > 0.999 * f64::from(ratio), "{ratio} came back as {back}");
            }
        }
        assert_eq!(encode(0.0, 1.0), 0.0);
        assert!(encode(f32::MAX, 1.0) < 1.0);
    }

    #[test]
    fn a_flat_map_has_a_finite_cone() {
        let widest = ratio(0.0, [0.01, 0.02]);
        assert!(widest.is_finite() && widest > 1e11);
    }
}
