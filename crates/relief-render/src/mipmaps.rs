//! Pictures with their coarser levels.

use std::sync::Arc;

use relief_bake::kind::normal::{Axes, Derivative, normals};
use relief_core::area_mean::{coarser, coarser_of, coarser_size, level_count};
use relief_core::{HeightMap, Metric, Watch};
use relief_io::Picture;

/// The least part of a normal that stands upright when slopes are made of it: they are 20 at most, as steep
/// as 87 degrees.
const LEAST_UPRIGHT: f32 = 0.05;

/// A colour or normal map, with coarser levels or without.
///
/// Normal maps have two layers in their coarser levels. Of the normals `n` and the slopes `s` (`n` is
/// `(-sx, -sy, 1) nz`) in a texel's area they are the means `(nx, ny, nz, sx)` and `(sx² nz, sx sy nz,
/// sy² nz, sy)`, from which follows what an eye at the side sees of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Mipmaps {
    size: [u32; 2],
    layers: usize,
    /// The finest level, of a single layer; where there is none it is the first of the others.
    finest: Option<Arc<Picture>>,
    /// The levels that follow, one after the other, in each its layers: each level has half the sides of the
    /// one before, rounded down but at least 1, and means over areas.
    levels: Vec<[f32; 4]>,
}

/// Both layers of a texel of a normal map.
fn moments(normal: [f32; 3]) -> [f32; 8] {
    let [x, y, z] = normal;
    let length = (x * x + y * y + z * z).sqrt();
    let of_length = if length > 0.0 { length } else { 1.0 };
    let upright = (z / of_length).max(LEAST_UPRIGHT);
    let [along_x, along_y] = [x, y].map(|part| -part / of_length / upright);
    let [xx, xy, yy] = [along_x * along_x, along_x * along_y, along_y * along_y].map(|part| part * upright);
    [x, y, z, along_x, xx, xy, yy, along_y]
}

/// The levels from one on, each in layers of four channels.
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
    /// The picture as it is.
    pub fn finest_only(picture: Arc<Picture>) -> Self {
        let size = [picture.width, picture.height];
        Self { size, layers: 1, finest: Some(picture), levels: Vec::new() }
    }

    /// A colour map with all coarser levels. One that has not as many texels as its sides say stays as it is:
    /// what is to be done with it the backends say.
    pub fn of(picture: Arc<Picture>) -> Self {
        Self::with_levels(picture, |texel| texel)
    }

    /// A tangent-space normal map with all coarser levels; a malformed one as [`Mipmaps::of`] has it.
    pub fn of_normals(picture: Arc<Picture>) -> Self {
        Self::with_levels(picture, |[x, y, z, _]| moments([x, y, z]))
    }

    /// A picture with the means of what is made of its texels, in layers of four channels.
    fn with_levels<const N: usize>(picture: Arc<Picture>, of: impl Fn([f32; 4]) -> [f32; N] + Sync) -> Self {
        let size = [picture.width, picture.height];
        if !is_whole(&picture) || size == [1, 1] {
            return Self::finest_only(picture);
        }
        let levels = chain(coarser_of(|at| of(picture.texels[at]), size), coarser_size(size));
        Self { layers: N / 4, levels, ..Self::finest_only(picture) }
    }

    /// The normals of a height map in tangent space, `y` along falling `v`, from the map's second level on;
    /// none of a single texel.
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

    /// Columns and rows of the finest level.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// How many layers the coarser levels have.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// How many levels there are.
    pub fn levels(&self) -> u32 {
        if self.finest.is_some() && self.levels.is_empty() { 1 } else { level_count(self.size) }
    }

    /// The finest level, in one layer or in all.
    pub fn finest(&self) -> &[[f32; 4]] {
        match &self.finest {
            Some(picture) => &picture.texels,
            None => &self.levels[..self.own_finest()],
        }
    }

    /// The texels of the other levels, one after the other.
    pub fn coarser(&self) -> &[[f32; 4]] {
        &self.levels[if self.finest.is_some() { 0 } else { self.own_finest() }..]
    }

    /// How many texels the finest level has among the others.
    fn own_finest(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize * self.layers
    }
}

/// Whether a picture has as many texels as its sides say, and any.
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
