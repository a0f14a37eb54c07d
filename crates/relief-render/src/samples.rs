//! Positions and weights of the samples of a pixel.
//!
//! `n` samples lie on `n` columns and `n` rows of the pixel, one on each: an edge along either axis
//! is resolved into `n + 1` steps. The samples are the points of a lattice with `n + 1` points,
//! without the one in its corner. Of all such lattices, the one is taken whose points keep the
//! greatest distance, also to the points of adjacent pixels.

use relief_scene::MAX_SAMPLES;

/// A sample of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Offset from the pixel's centre, in pixels.
    pub offset: [f32; 2],
    /// Share of the sample in the pixel's colour, from 0 to 1.
    pub weight: f32,
}

impl Sample {
    /// The only sample of a pixel, at its centre.
    pub const CENTRE: Sample = Sample { offset: [0.0; 2], weight: 1.0 };
}

/// Returns the `count` samples of every pixel, from 1 to [`MAX_SAMPLES`]. With `centre`, and more
/// than one sample, the pixel's centre follows as the last one, with weight 0.
pub fn samples(count: u32, centre: bool) -> Vec<Sample> {
    if count <= 1 {
        return vec![Sample::CENTRE];
    }
    let count = count.min(MAX_SAMPLES);
    let modulus = count + 1;
    let factor = best_factor(modulus);
    let place = |step: u32| ((f64::from(step) - 0.5) / f64::from(count) - 0.5) as f32;
    let weight = (1.0 / f64::from(count)) as f32;
    let on_lattice = (1..=count).map(|step| {
        let across = (u64::from(step) * u64::from(factor) % u64::from(modulus)) as u32;
        Sample { offset: [place(step), place(across)], weight }
    });
    on_lattice.chain(centre.then_some(Sample { weight: 0.0, ..Sample::CENTRE })).collect()
}

/// Returns the factor of the lattice `(k, factor k)` of `modulus` points that are farthest apart.
fn best_factor(modulus: u32) -> u32 {
    let coprime = |factor: &u32| gcd(*factor, modulus) == 1;
    let by_distance = (1..modulus).filter(coprime).map(|factor| (least_distance2(modulus, factor), factor));
    // Ties go to the smaller factor.
    let better = |best: (u64, u32), next: (u64, u32)| if next.0 > best.0 { next } else { best };
    by_distance.fold((0, 1), better).1
}

/// The square of the least distance of points of a lattice that repeats in all directions.
fn least_distance2(modulus: u32, factor: u32) -> u64 {
    let modulus = u64::from(modulus);
    let near = |step: u64| step.min(modulus - step);
    let distance2 = |step: u64| near(step).pow(2) + near(step * u64::from(factor) % modulus).pow(2);
    (1..modulus).map(distance2).min().unwrap_or(0)
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_and_row_of_the_pixel_has_one_sample() {
        for count in (1..=70).chain([256, MAX_SAMPLES]) {
            let all = samples(count, false);
            assert_eq!(all.len(), count as usize);
            for axis in 0..2 {
                let strata = |sample: &Sample| ((sample.offset[axis] + 0.5) * count as f32).floor() as u32;
                let mut found: Vec<u32> = all.iter().map(strata).collect();
                found.sort_unstable();
                assert!(found.into_iter().eq(0..count), "{count} along {axis}");
                let mean = all.iter().map(|sample| sample.offset[axis]).sum::<f32>() / count as f32;
                assert!(mean.abs() < 1e-6, "{count}: {mean}");
            }
            let weight = all.iter().map(|sample| sample.weight).sum::<f32>();
            assert!((weight - 1.0).abs() < 1e-5, "{count}: {weight}");
        }
        assert_eq!(samples(1, true), [Sample::CENTRE]);
        assert_eq!(samples(4, true)[4], Sample { offset: [0.0; 2], weight: 0.0 });
    }

    #[test]
    fn samples_keep_their_distance() {
        for count in [4, 16, 64, 256] {
            let all = samples(count, false);
            let wrapped = |along: f32| (along - along.round()).abs();
            let distance = |a: &Sample, b: &Sample| {
                wrapped(a.offset[0] - b.offset[0]).hypot(wrapped(a.offset[1] - b.offset[1]))
            };
            let pairs = all.iter().enumerate().flat_map(|(at, a)| all[..at].iter().map(move |b| (a, b)));
            let least = pairs.map(|(a, b)| distance(a, b)).fold(1.0, f32::min);
            // Points of the densest packing would be 1.07 / sqrt(n) apart.
            assert!(least > 0.6 / (count as f32).sqrt(), "{count}: {least}");
        }
    }
}
