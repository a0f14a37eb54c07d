//! Light gathered through precomputed visibility.

use rayon::prelude::*;
use relief_core::{HeightMap, Metric, Watch};

use super::views;
use crate::BakeError;

/// No texel is hit: the ray leaves the relief.
const SKY: u32 = u32::MAX;

/// The nearest texel to the first hit, for every texel and direction.
///
/// Light is gathered about the base normal. All directions weigh the same, since they are spread
/// over the hemisphere in proportion to the cosine, and the weights of a texel sum to 1. So a
/// gather is a mean, which neither makes nor loses energy. Inside of a furnace, where the sky and
/// every texel have the same radiance, every texel receives exactly this radiance.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    directions: Vec<[f64; 3]>,
    /// Texels direction after direction, row by row from the top.
    seen: Vec<u32>,
    texels: usize,
}

impl Visibility {
    /// Bakes the visibility of a map in `azimuths` times `elevations` directions within `tiles`
    /// tiles. Takes 4 bytes a texel and direction.
    ///
    /// # Errors
    ///
    /// When memory does not suffice, or the bake is cancelled.
    pub fn bake(
        map: &HeightMap,
        metric: Metric,
        directions: [u32; 2],
        tiles: u32,
        watch: &Watch,
    ) -> Result<Self, BakeError> {
        let texels = map.texels().len();
        let slices = u64::from(directions[0]) * u64::from(directions[1]);
        let mut seen = Vec::new();
        usize::try_from(u128::from(slices) * texels as u128)
            .ok()
            .and_then(|count| seen.try_reserve_exact(count).ok())
            .ok_or_else(|| BakeError::Impossible {
                kind: super::KIND.name,
                reason: format!("{slices} directions of {texels} texels do not fit in memory: use fewer"),
            })?;
        let mut all = Vec::new();
        let [width, height] = [map.width(), map.height()];
        views(map, metric, directions, tiles, watch, &mut |view| {
            all.push(view.direction);
            let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
            seen.extend(
                texels.map(|(column, row)| {
                    view.seen(column, row, map.wrap()).map_or(SKY, |texel| texel as u32)
                }),
            );
            Ok(())
        })?;
        Ok(Self { directions: all, seen, texels })
    }

    /// Returns the directions, of unit length: along `+u`, along `+v` and up the base normal.
    pub fn directions(&self) -> &[[f64; 3]] {
        &self.directions
    }

    /// Returns the texel that a texel sees in a direction; `None` for the sky. Both texels are
    /// numbers `row * width + column`. `direction` is an index in [`directions`](Self::directions).
    pub fn seen(&self, texel: usize, direction: usize) -> Option<usize> {
        let seen = self.seen[direction * self.texels + texel];
        (seen != SKY).then_some(seen as usize)
    }

    /// Returns the light that every texel receives from a sky and from other texels: the irradiance
    /// over π, about the base normal. `sky` has one radiance a direction, `texels` one radiance a
    /// texel; otherwise the result is `None`.
    pub fn gather(&self, sky: &[f32], texels: &[f32]) -> Option<Vec<f32>> {
        if sky.len() != self.directions.len() || texels.len() != self.texels {
            return None;
        }
        /// Texels that one task gathers for, direction by direction, so that the hits are read in
        /// order.
        const BLOCK: usize = 4096;
        let mut received = vec![0.0f32; self.texels];
        received.par_chunks_mut(BLOCK).enumerate().for_each(|(block, received)| {
            for (direction, &sky) in sky.iter().enumerate() {
                let from = direction * self.texels + block * BLOCK;
                for (received, &seen) in received.iter_mut().zip(&self.seen[from..]) {
                    *received += if seen == SKY { sky } else { texels[seen as usize] };
                }
            }
            let weight = self.directions.len() as f32;
            received.iter_mut().for_each(|received| *received /= weight);
        });
        Some(received)
    }

    /// Returns the light that every texel receives from that sky after `bounces` reflections off
    /// texels of that albedo, each in `[0, 1]`. With 0 bounces it is the sky's light alone. `None`
    /// as for [`Self::gather`].
    pub fn bounce(&self, sky: &[f32], albedo: &[f32], bounces: u32) -> Option<Vec<f32>> {
        if albedo.len() != self.texels {
            return None;
        }
        let mut received = self.gather(sky, &vec![0.0; self.texels])?;
        for _ in 0..bounces {
            let sent: Vec<f32> = received.iter().zip(albedo).map(|(light, albedo)| light * albedo).collect();
            received = self.gather(sky, &sent)?;
        }
        Some(received)
    }
}
