//! Colours of numbers.

/// Sequence of colours whose lightness grows steadily. It can be read without colour vision and
/// printed in grey; equal steps of a number look alike everywhere. Rainbows have neither property.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Palette {
    /// From dark violet over green to yellow (Smith and van der Walt 2015). No colour of it is
    /// black or white, so both can mark pixels without a number.
    Viridis,
    /// From black over purple to pale yellow, by the same authors. Differences of pictures are
    /// shown by it, as by the authors of FLIP: where nothing differs, the picture is black.
    Magma,
}

impl Palette {
    /// Returns the sRGB colour of a place from 0 to 1. Places outside are clamped; NaN is 0.
    pub fn at(self, place: f32) -> [u8; 3] {
        let gradient = match self {
            Palette::Viridis => colorous::VIRIDIS,
            Palette::Magma => colorous::MAGMA,
        };
        // NaN is not above 0.
        let place = if place > 0.0 { place.min(1.0) } else { 0.0 };
        gradient.eval_continuous(place.into()).as_array()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greater_numbers_are_lighter() {
        for palette in [Palette::Viridis, Palette::Magma] {
            let luma = |place: f32| {
                let [r, g, b] = palette.at(place).map(f32::from);
                0.2126 * r + 0.7152 * g + 0.0722 * b
            };
            let lumas: Vec<f32> = (0..=32).map(|step| luma(step as f32 / 32.0)).collect();
            assert!(lumas.windows(2).all(|pair| pair[0] < pair[1]), "{palette:?}: {lumas:?}");
            assert_eq!(palette.at(f32::NAN), palette.at(0.0));
            assert_eq!([palette.at(-1.0), palette.at(2.0)], [palette.at(0.0), palette.at(1.0)]);
        }
        assert_eq!([Palette::Viridis.at(0.0), Palette::Viridis.at(1.0)], [[68, 1, 84], [253, 231, 37]]);
    }
}
