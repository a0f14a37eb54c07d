//! Height maps that break what is only nearly right.

use relief_core::{HeightMap, Wrap};

use relief_core::rng::Rng;

/// An adversarial map: its name, and its texels in any wrap.
#[derive(Clone, Copy, Debug)]
pub struct NamedMap {
    /// Name of the map's pattern.
    pub name: &'static str,
    width: u32,
    height: u32,
    texels: fn(&mut Rng, [u32; 2]) -> Vec<f32>,
}

impl NamedMap {
    /// The map; the same texels every time.
    ///
    /// # Panics
    ///
    /// Never: all sizes of the list are valid and texels are clamped to `[0, 1]`.
    pub fn build(&self, wrap: Wrap) -> HeightMap {
        let seed =
            self.name.bytes().fold(0u64, |seed, byte| seed.wrapping_mul(31).wrapping_add(u64::from(byte)));
        let texels = (self.texels)(&mut Rng::new(seed), [self.width, self.height]);
        let texels = texels.into_iter().map(|texel| texel.clamp(0.0, 1.0)).collect();
        HeightMap::new(self.width, self.height, texels, wrap).expect("the sizes of the list are valid")
    }
}

/// Every adversarial map. Sizes are mixed on purpose: one texel, one row, one column, odd, prime, powers of
/// two.
pub const ALL: &[NamedMap] = &[
    NamedMap { name: "white noise 37x53", width: 37, height: 53, texels: white_noise },
    NamedMap { name: "white noise 128x128", width: 128, height: 128, texels: white_noise },
    NamedMap { name: "natural 128x128", width: 128, height: 128, texels: natural },
    NamedMap { name: "natural 101x67", width: 101, height: 67, texels: natural },
    NamedMap { name: "single spike 33x31", width: 33, height: 31, texels: spike },
    NamedMap { name: "needles in a pit 64x64", width: 64, height: 64, texels: needles },
    NamedMap { name: "constant half 16x9", width: 16, height: 9, texels: |_, size| vec![0.5; area(size)] },
    NamedMap { name: "constant top 8x8", width: 8, height: 8, texels: |_, size| vec![1.0; area(size)] },
    NamedMap { name: "constant bottom 5x3", width: 5, height: 3, texels: |_, size| vec![0.0; area(size)] },
    NamedMap { name: "ramp 32x17", width: 32, height: 17, texels: ramp },
    NamedMap { name: "checkerboard 24x24", width: 24, height: 24, texels: checkerboard },
    NamedMap { name: "steps 61x40", width: 61, height: 40, texels: steps },
    NamedMap { name: "one texel", width: 1, height: 1, texels: |_, _| vec![0.37] },
    NamedMap { name: "one row 1x29", width: 1, height: 29, texels: white_noise },
    NamedMap { name: "one column 31x1", width: 31, height: 1, texels: white_noise },
    NamedMap { name: "two texels 2x1", width: 2, height: 1, texels: ramp },
];

fn area(size: [u32; 2]) -> usize {
    size[0] as usize * size[1] as usize
}

fn each(size: [u32; 2], mut texel: impl FnMut(u32, u32) -> f32) -> Vec<f32> {
    (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (i, j))).map(|(i, j)| texel(i, j)).collect()
}

fn white_noise(rng: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    each(size, |_, _| rng.unit() as f32)
}

fn spike(_: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    each(size, |i, j| if [i, j] == [size[0] / 3, size[1] / 2] { 1.0 } else { 0.1 })
}

fn needles(rng: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    each(size, |_, _| if rng.below(40) == 0 { rng.between(0.2, 1.0) as f32 } else { 0.0 })
}

fn ramp(_: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    let last = (size[0] + size[1] - 2).max(1) as f32;
    each(size, |i, j| (i + j) as f32 / last)
}

fn checkerboard(_: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    each(size, |i, j| if (i + j) % 2 == 0 { 0.25 } else { 0.75 })
}

fn steps(_: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    each(size, |i, j| ((i / 7) % 3) as f32 * 0.25 + ((j / 5) % 2) as f32 * 0.5)
}

fn natural(rng: &mut Rng, size: [u32; 2]) -> Vec<f32> {
    fractal(rng.bits(), size[0], size[1], 0.55)
}

/// Fractal noise like weathered ground, that tiles: octaves of smoothly interpolated lattice noise, each
/// `roughness` as high as the one before and twice as fine, stretched to fill `[0, 1]`.
pub fn fractal(seed: u64, width: u32, height: u32, roughness: f32) -> Vec<f32> {
    let mut texels = vec![0.0f32; area([width, height])];
    let mut amplitude = 1.0;
    let mut cells = 2;
    let mut rng = Rng::new(seed);
    while cells <= width.max(height).next_power_of_two() / 2 {
        let lattice: Vec<f32> = (0..cells * cells).map(|_| rng.unit() as f32).collect();
        let at = |i: u32, j: u32| lattice[((j % cells) * cells + i % cells) as usize];
        for (texel, (x, y)) in
            texels.iter_mut().zip((0..height).flat_map(|y| (0..width).map(move |x| (x, y))))
        {
            let place = |along: u32, side: u32| {
                let place = along as f32 * cells as f32 / side as f32;
                let share = place.fract();
                (place as u32, share * share * (3.0 - 2.0 * share))
            };
            let ((i, u), (j, v)) = (place(x, width), place(y, height));
            let top = at(i, j) + (at(i + 1, j) - at(i, j)) * u;
            let bottom = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * u;
            *texel += amplitude * (top + (bottom - top) * v);
        }
        amplitude *= roughness;
        cells *= 2;
    }
    let (low, high) = texels.iter().fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
    let range = if high > low { high - low } else { 1.0 };
    texels.iter().map(|texel| (texel - low) / range).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_valid_distinct_and_repeatable() {
        for (at, map) in ALL.iter().enumerate() {
            let built = map.build(Wrap::Repeat);
            assert_eq!(built, map.build(Wrap::Repeat), "{}", map.name);
            assert!(ALL[..at].iter().all(|other| other.name != map.name), "{} is there twice", map.name);
        }
    }

    #[test]
    fn fractal_ground_fills_the_range_and_is_smoother_than_noise() {
        let texels = fractal(7, 64, 64, 0.5);
        let (low, high) = texels.iter().fold((1.0f32, 0.0f32), |(low, high), &x| (low.min(x), high.max(x)));
        assert_eq!((low, high), (0.0, 1.0));
        let step = texels.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f32>() / texels.len() as f32;
        assert!(step < 0.1, "mean step {step}; white noise has 0.33");
    }
}
