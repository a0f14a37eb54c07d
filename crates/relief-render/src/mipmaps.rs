//! Mip chains of colour and normal maps.

use std::sync::Arc;

use relief_bake::kind::normal::{Axes, Derivative, normals};
use relief_core::area_mean::{coarser, coarser_of, coarser_size, level_count};
use relief_core::{HeightMap, Metric, Watch};
use relief_io::Picture;
use relief_scene::material_maps::MaterialMaps;

/// Least `z` of a unit normal from which slopes are computed. Slopes are at most 20, as steep as 87
/// degrees.
const LEAST_UPRIGHT: f32 = 0.05;

/// A colour or normal map, with or without coarser mip levels.
///
/// Normal maps have two layers in their coarser levels. Normals are `n` and slopes `s`, with `n =
/// (-sx, -sy, 1) nz`. The layers are the means `(nx, ny, nz, sx)` and `(sx² nz, sx sy nz, sy² nz,
/// sy)` over a texel's area. From these follows how the normals look from the side.
#[derive(Clone, Debug, PartialEq)]
pub struct Mipmaps {
    size: [u32; 2],
    layers: usize,
    /// The finest level, with a single layer. If `None`, the finest level is the first of `levels`.
    finest: Option<Arc<Picture>>,
    /// The levels that follow, one after the other, layer by layer. Each level has half the sides
    /// of the one before, rounded down but at least 1, and holds means over areas.
    levels: Vec<[f32; 4]>,
}

/// Returns both layers of a normal map's texel.
fn moments(normal: [f32; 3]) -> [f32; 8] {
    let [x, y, z] = normal;
    let length = (x * x + y * y + z * z).sqrt();
    let of_length = if length > 0.0 { length } else { 1.0 };
    let upright = (z / of_length).max(LEAST_UPRIGHT);
    let [along_x, along_y] = [x, y].map(|part| -part / of_length / upright);
    let [xx, xy, yy] = [along_x * along_x, along_x * along_y, along_y * along_y].map(|part| part * upright);
    [x, y, z, along_x, xx, xy, yy, along_y]
}

/// Returns `level` and all coarser levels, each in layers of four channels.
fn chain<const N: usize>(mut level: Vec<[f32; N]>, mut size: [u32; 2]) -> Vec<[f32; 4]> {
    let mut levels = Vec::new();
    loop {
        for layer in 0..N / 4 {
            levels.extend(level.iter().map(|texel| texel.as_chunks::<4>().0[layer]));
        }
        if size == [1, 1] {
            return levels;
        }
        level = coarser(&level, size);
        size = coarser_size(size);
    }
}

impl Mipmaps {
    /// Wraps a picture without coarser levels.
    pub fn finest_only(picture: Arc<Picture>) -> Self {
        let size = [picture.width, picture.height];
        Self { size, layers: 1, finest: Some(picture), levels: Vec::new() }
    }

    /// Creates a colour map with all coarser levels. A picture whose number of texels does not fit
    /// its sides gets no levels; backends handle it.
    pub fn of(picture: Arc<Picture>) -> Self {
        Self::with_levels(picture, |texel| texel)
    }

    /// Creates a tangent-space normal map with all coarser levels. A malformed picture is handled
    /// as by [`Mipmaps::of`].
    pub fn of_normals(picture: Arc<Picture>) -> Self {
        Self::with_levels(picture, |[x, y, z, _]| moments([x, y, z]))
    }

    /// Creates the coarser levels from the means of `of` over the texels, in layers of four
    /// channels.
    fn with_levels<const N: usize>(picture: Arc<Picture>, of: impl Fn([f32; 4]) -> [f32; N] + Sync) -> Self {
        let size = [picture.width, picture.height];
        if !is_whole(&picture) || size == [1, 1] {
            return Self::finest_only(picture);
        }
        let levels = chain(coarser_of(|at| of(picture.texels[at]), size), coarser_size(size));
        Self { layers: N / 4, levels, ..Self::finest_only(picture) }
    }

    /// Creates the normals of a height map in tangent space, from the map's second level on. `y`
    /// points along falling `v`. `metric` gives the lengths of a tile and of the scale. Returns
    /// `None` for a map of a single texel.
    pub fn of_heights(map: &HeightMap, metric: Metric) -> Option<Self> {
        let size = [map.width(), map.height()];
        if size == [1, 1] {
            return None;
        }
        let watch = Watch::none();
        let (planes, _) = normals(map, metric, Derivative::Central, Axes::Tangent, &watch).ok()?;
        let second = coarser_of(|at| moments(std::array::from_fn(|part| planes[part][at])), size);
        drop(planes);
        let size = coarser_size(size);
        Some(Self { size, layers: 2, finest: None, levels: chain(second, size) })
    }

    /// Creates the maps of a material, in one layer or, with emission, in two. `levels` says whether
    /// there are coarser ones.
    pub fn of_materials(maps: &MaterialMaps, levels: bool) -> Self {
        let size = maps.size();
        let layers = 1 + usize::from(maps.has_emission());
        let levels = match (levels, layers) {
            (true, 1) => chain(maps.texels().iter().map(|texel| texel.as_chunks::<4>().0[0]).collect(), size),
            (true, _) => chain(maps.texels().to_vec(), size),
            (false, _) => {
                let layer = |of| maps.texels().iter().map(move |texel| texel.as_chunks::<4>().0[of]);
                (0..layers).flat_map(layer).collect()
            }
        };
        Self { size, layers, finest: None, levels }
    }

    /// Returns columns and rows of the finest level.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the number of layers of the coarser levels.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// Returns the number of levels.
    pub fn levels(&self) -> u32 {
        if self.coarser().is_empty() { 1 } else { level_count(self.size) }
    }

    /// Returns the texels of the finest level, in one layer or in all.
    pub fn finest(&self) -> &[[f32; 4]] {
        match &self.finest {
            Some(picture) => &picture.texels,
            None => &self.levels[..self.own_finest()],
        }
    }

    /// Returns the texels of the coarser levels, one after the other.
    pub fn coarser(&self) -> &[[f32; 4]] {
        &self.levels[if self.finest.is_some() { 0 } else { self.own_finest() }..]
    }

    /// Number of texels of the finest level if it is stored in `levels`.
    fn own_finest(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize * self.layers
    }
}

/// Whether a picture is not empty and its number of texels fits its sides.
fn is_whole(picture: &Picture) -> bool {
    let texels = u64::from(picture.width) * u64::from(picture.height);
    texels != 0 && texels == picture.texels.len() as u64
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;

    use super::*;

    #[test]
    fn levels_follow_one_another() {
        let texel = |at: u32| [at as f32, 0.0, 1.0, 0.5];
        let picture = Picture { width: 5, height: 2, texels: (0..10).map(texel).collect() };
        let levels = Mipmaps::of(Arc::new(picture.clone()));
        assert_eq!((levels.levels(), levels.coarser().len()), (3, 2 + 1));
        // Rows of 0 to 4 and 5 to 9; each half has two and a half texels.
        assert_eq!(levels.coarser(), [[3.3, 0.0, 1.0, 0.5], [5.7, 0.0, 1.0, 0.5], [4.5, 0.0, 1.0, 0.5]]);
        assert_eq!(Mipmaps::finest_only(Arc::new(picture)).levels(), 1);
        for (width, height, texels) in [(5, 2, 9), (0, 0, 0), (0, 3, 0)] {
            let wrong = Picture { width, height, texels: vec![[0.0; 4]; texels] };
            assert_eq!(Mipmaps::of(Arc::new(wrong)).levels(), 1);
        }
    }

    #[test]
    fn means_of_normals_are_the_shorter_the_more_they_differ() {
        let ridge = |steep: f32| {
            let heights = HeightMap::from_fn(4, 4, Wrap::Repeat, |i, _| {
                [0.5, 0.5 + steep, 0.5, 0.5 - steep][i as usize]
            });
            Mipmaps::of_heights(&heights.expect("a map"), Metric { tile_m: [1.0, 1.0], scale_m: 1.0 })
        };
        let length = |texel: &[f32; 4]| texel[..3].iter().map(|part| part * part).sum::<f32>().sqrt();
        let [level, steep] = [ridge(0.0), ridge(0.25)].map(|levels| levels.expect("more than a texel"));
        assert_eq!(level.size(), [2, 2]);
        assert!(level.finest()[..4].iter().all(|texel| *texel == [0.0, 0.0, 1.0, 0.0]));
        assert!(length(&steep.coarser()[0]) < 0.9);
        let flat = HeightMap::new(1, 1, vec![0.5], Wrap::Clamp).expect("a map");
        assert_eq!(Mipmaps::of_heights(&flat, Metric::UNIT), None);
    }
}
