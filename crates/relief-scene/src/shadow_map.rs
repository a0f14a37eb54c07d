//! Sizes of shadow maps and of their filters, in texels.
//!
//! A shadow map follows the size of the picture, up to the setting `shadow.size`.

/// Texels of a shadow map for each pixel of the frame's longer side: 2048 texels for 800 pixels.
/// With [`STEPS`], frames from 673 pixels on get maps of 2048 texels.
const TEXELS_A_PIXEL: f64 = 2.56;

/// Side in texels for the smallest frames. Edges of shadows cover a larger part of a small frame,
/// so its texels are finer relative to its pixels.
const SMALLEST: f64 = 256.0;

/// Steps of a quarter octave. A frame that is resized slightly keeps its maps.
const STEPS: [f64; 4] = [1.0, 1.189_207_115_002_721, std::f64::consts::SQRT_2, 1.681_792_830_507_429];

/// Returns the side in texels of the square shadow maps for a picture of `frame` columns and rows.
///
/// The side is about 2.56 texels for each pixel of the longer side, rounded up to a quarter octave,
/// and at least 256. It is at most `most`, the setting `shadow.size`.
pub fn shadow_map_side(most: u32, frame: [u32; 2]) -> u32 {
    let asked = f64::from(frame[0].max(frame[1])) * TEXELS_A_PIXEL;
    let octaves = std::iter::successors(Some(SMALLEST), |side| Some(2.0 * side));
    let mut sides = octaves.flat_map(|octave| STEPS.map(|step| (octave * step).round()));
    sides.find(|side| *side >= asked.min(most.into())).map_or(most, |side| most.min(side as u32))
}

/// Returns the width of a shadow filter, in texels of a map with `side` texels a side.
///
/// `texels` is the width chosen for a map of `most` texels a side. The filter keeps its width in
/// the scene. It stays at least one texel wide if it was, so that edges are averaged over
/// neighbours.
pub fn filter_texels(texels: f32, most: u32, side: u32) -> f32 {
    if side == most {
        return texels;
    }
    (texels * side as f32 / most as f32).max(texels.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_side_follows_the_longer_side_of_the_frame_up_to_the_setting() {
        let frames = [[96, 72], [72, 96], [160, 90], [400, 3], [1, 574], [673, 1], [800, 600], [8192, 8192]];
        let sides = frames.map(|frame| shadow_map_side(2048, frame));
        assert_eq!(sides, [256, 256, 431, 1024, 1722, 2048, 2048, 2048]);
        assert_eq!(shadow_map_side(16_384, [8192, 8192]), 16_384);
        assert_eq!(shadow_map_side(16_384, [1000, 10]), 2896);
    }

    #[test]
    fn small_frames_and_small_settings_have_their_least_and_their_most() {
        assert_eq!([[1, 1], [40, 40], [100, 75]].map(|frame| shadow_map_side(2048, frame)), [256; 3]);
        assert_eq!([16, 17, 250, 256].map(|most| shadow_map_side(most, [4000, 4000])), [16, 17, 250, 256]);
        assert_eq!([16, 100, 255].map(|most| shadow_map_side(most, [1, 1])), [16, 100, 255]);
        assert_eq!(shadow_map_side(300, [101, 72]), 300);
    }

    #[test]
    fn the_side_grows_in_steps_of_a_quarter_octave() {
        let sides: Vec<u32> = (1..6000).map(|side| shadow_map_side(16_384, [side, side])).collect();
        assert!(sides.is_sorted());
        for (side, pixels) in sides.iter().zip(1..) {
            assert!(
                (2.56 * f64::from(pixels)).min(16_384.0) <= f64::from(*side),
                "{side} texels for {pixels} pixels"
            );
            assert!(
                *side <= (3.05 * f64::from(pixels)).max(257.0) as u32,
                "{side} texels for {pixels} pixels"
            );
        }
        let mut steps = sides;
        steps.dedup();
        assert_eq!(steps.len(), 25, "{steps:?}");
    }

    #[test]
    fn a_filter_is_as_wide_in_the_scene_and_at_least_a_texel() {
        assert_eq!(filter_texels(8.0, 2048, 512), 2.0);
        assert_eq!(filter_texels(8.0, 2048, 2048), 8.0);
        assert_eq!(filter_texels(1.0, 2048, 256), 1.0);
        assert_eq!(filter_texels(3.0, 2048, 256), 1.0);
        assert_eq!(filter_texels(0.5, 2048, 256), 0.5);
        assert_eq!(filter_texels(0.0, 2048, 256), 0.0);
    }
}
