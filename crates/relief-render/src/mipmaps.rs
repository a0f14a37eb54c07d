//! Pictures with their coarser levels.

use std::sync::Arc;

use relief_bake::kind::normal::{Axes, Derivative, normals};
use relief_core::area_mean::{coarser, coarser_size, level_count};
use relief_core::{HeightMap, Metric};
use relief_io::Picture;

/// A colour or normal map, with coarser levels or without.
#[derive(Clone, Debug, PartialEq)]
pub struct Mipmaps {
    finest: Arc<Picture>,
    /// The levels that follow, one after the other, each with half the sides of the one before, rounded down
    /// but at least 1: means over areas.
    coarser: Vec<[f32; 4]>,
}

impl Mipmaps {
    /// The picture as it is.
    pub fn finest_only(picture: Arc<Picture>) -> Self {
        Self { finest: picture, coarser: Vec::new() }
    }

    /// The picture with all coarser levels. One that has not as many texels as its sides say stays as it is:
    /// what is to be done with it the backends say.
    pub fn of(picture: Arc<Picture>) -> Self {
        let mut size = [picture.width, picture.height];
        let texels = size.map(u64::from).iter().product::<u64>();
        if texels == 0 || texels != picture.texels.len() as u64 {
            return Self::finest_only(picture);
        }
        let mut levels: Vec<[f32; 4]> = Vec::new();
        let mut before = None;
        while size != [1, 1] {
            let finer: &[[f32; 4]] = before.map_or(&picture.texels, |start: usize| &levels[start..]);
            let next = coarser(finer, size);
            before = Some(levels.len());
            levels.extend(next);
            size = coarser_size(size);
        }
        Self { finest: picture, coarser: levels }
    }

    /// The means of a height map's normals in tangent space, `y` along falling `v`, from the map's second
    /// level on; none of a single texel.
    pub fn of_normals(map: &HeightMap, metric: Metric) -> Option<Self> {
        let size = [map.width(), map.height()];
        if size == [1, 1] {
            return None;
        }
        let progress = relief_bake::Progress::none();
        let (planes, _) = normals(map, metric, Derivative::Central, Axes::Tangent, &progress).ok()?;
        let [x, y, z] = planes.map(|plane| coarser(plane.as_chunks::<1>().0, size));
        let texels = x.iter().zip(&y).zip(&z).map(|(([x], [y]), [z])| [*x, *y, *z, 0.0]).collect();
        let [width, height] = coarser_size(size);
        Some(Self::of(Arc::new(Picture { width, height, texels })))
    }

    /// Columns and rows of the finest level.
    pub fn size(&self) -> [u32; 2] {
        [self.finest.width, self.finest.height]
    }

    /// How many levels there are.
    pub fn levels(&self) -> u32 {
        if self.coarser.is_empty() { 1 } else { level_count(self.size()) }
    }

    /// The finest level.
    pub fn finest(&self) -> &Picture {
        &self.finest
    }

    /// The texels of the other levels, one after the other.
    pub fn coarser(&self) -> &[[f32; 4]] {
        &self.coarser
    }
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
        // Rows of 0 to 4 and 5 to 9, of which each half has two and a half texels.
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
            Mipmaps::of_normals(&heights.expect("a map"), Metric { tile_m: [1.0, 1.0], scale_m: 1.0 })
        };
        let length = |texel: &[f32; 4]| texel[..3].iter().map(|part| part * part).sum::<f32>().sqrt();
        let [level, steep] = [ridge(0.0), ridge(0.25)].map(|levels| levels.expect("more than a texel"));
        assert_eq!(level.size(), [2, 2]);
        assert!(
            level.finest().texels.iter().chain(level.coarser()).all(|texel| *texel == [0.0, 0.0, 1.0, 0.0])
        );
        assert!(length(&steep.coarser()[0]) < 0.9);
        let flat = HeightMap::new(1, 1, vec![0.5], Wrap::Clamp).expect("a map");
        assert_eq!(Mipmaps::of_normals(&flat, Metric::UNIT), None);
    }
}
