//! Colours of differences.

/// Colours from no difference to the greatest, at equal distances. They get lighter throughout, so
/// that they can be read without colour vision.
const RAMP: [[u8; 3]; 9] = [
    [0, 0, 4],
    [28, 16, 68],
    [79, 18, 123],
    [129, 37, 129],
    [181, 54, 122],
    [229, 80, 100],
    [251, 135, 97],
    [254, 194, 135],
    [252, 253, 191],
];

/// Returns the colour of a difference from 0 to 1, in steps of a 64th: few colours make small
/// files.
pub fn heat(difference: f32) -> [u8; 3] {
    // NaN is not above 0.
    let difference = if difference > 0.0 { difference.min(1.0) } else { 0.0 };
    let stepped = (difference * 64.0).round() / 64.0;
    let place = stepped * (RAMP.len() - 1) as f32;
    let first = (place as usize).min(RAMP.len() - 2);
    let part = place - first as f32;
    [0, 1, 2].map(|channel| {
        let [a, b] = [first, first + 1].map(|at| f32::from(RAMP[at][channel]));
        (a + (b - a) * part).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greater_differences_are_lighter() {
        let luma = |difference: f32| {
            let [r, g, b] = heat(difference).map(f32::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let lumas: Vec<f32> = (0..=64).map(|step| luma(step as f32 / 64.0)).collect();
        assert!(lumas.windows(2).all(|pair| pair[0] < pair[1]), "{lumas:?}");
        assert_eq!((heat(0.0), heat(2.0), heat(f32::NAN)), (RAMP[0], RAMP[8], RAMP[0]));
    }
}
