//! Rays through a method.

use relief_core::{BakedMap, HeightMap, Hit, Lanes, Metric, MotifTree, Path, Volume};

use super::{BLOCK, Explanation, HitBlock, PathBlock};
use super::{Bound, ColorTexture, Frame, HeightTexture, HoleTexture, Program, SurfaceSettings};
use crate::field::Solids;
use crate::{MapError, MapSlot, Selection, SlotMaps};

/// A method that traces rays through a height map: the hits of its shader, without a picture.
///
/// A [`Path`] is rounded to `f32`, as in shaders. The method's
/// [guarantees](crate::Selection::guarantee) say how near the answers come to the truth;
/// [`FastTracer`](relief_core::exact::FastTracer) gives the truth.
///
/// ```
/// use relief_core::{HeightMap, Metric, Path, Wrap};
/// use relief_shaders::Selection;
/// use relief_shaders::cpu::MethodTracer;
///
/// let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| (i * j % 64) as f32 / 63.0)?;
/// let relief = Selection::method("relief")?;
/// let tracer = MethodTracer::new(&heights, Metric::UNIT, &relief, [])?;
/// let hit = tracer.first_hit(&Path::between([0.1, 0.2, 1.0], [0.9, 0.6, 0.0]));
/// assert!(hit.found && hit.cost.reads > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MethodTracer<'a> {
    program: Program<'a>,
    levels: u32,
}

impl<'a> MethodTracer<'a> {
    /// Creates a tracer of a method for the height map `heights`, on a surface with the metric
    /// `surface`, with the baked maps that it reads. Other maps may be among them.
    ///
    /// # Errors
    ///
    /// When a map that the method reads is missing or does not fit; the error names the difference.
    pub fn new(
        heights: &'a HeightMap,
        metric: Metric,
        selection: &Selection,
        maps: impl IntoIterator<Item = &'a BakedMap> + Clone,
    ) -> Result<Self, MapError> {
        Ok(Self::over(heights, selection, selection.slot_maps(maps, heights, metric)?))
    }

    /// Creates a tracer with maps that are known to fit. Nothing is checked, and wrong maps give
    /// wrong answers.
    pub fn over(heights: &'a HeightMap, selection: &Selection, maps: SlotMaps<'a>) -> Self {
        Self::with_settings(heights, selection, SurfaceSettings::tracing(heights, selection, &maps), maps)
    }

    /// Creates a tracer of a method for a volume, with the baked maps that it reads: they are baked
    /// from the volume's [atlas](Volume::atlas). The selection's field becomes a volume.
    ///
    /// # Errors
    ///
    /// When a map that the method reads is missing or does not fit; the error names the difference.
    pub fn of_volume(
        volume: &'a Volume,
        selection: &Selection,
        maps: impl IntoIterator<Item = &'a BakedMap> + Clone,
    ) -> Result<Self, MapError> {
        let selection = selection.with_solids(Solids::Volumes).with_volume_size(volume.size());
        let atlas = volume.atlas();
        let maps = selection.slot_maps(maps, atlas, Metric::UNIT)?;
        let settings = SurfaceSettings::tracing(atlas, &selection, &maps).with_volume(volume.layout());
        Ok(Self::with_settings(atlas, &selection, settings, maps))
    }

    /// Creates a tracer of a method for a motif, on a level map of one texel that repeats. The selection's
    /// field becomes a motif.
    pub fn of_motif(ground: &'a HeightMap, motif: &'a MotifTree, selection: &Selection) -> Self {
        let maps: SlotMaps<'a> = [(MapSlot::Object, &**motif.map())].into_iter().collect();
        Self::over(ground, &selection.with_solids(Solids::Motifs), maps)
    }

    fn with_settings(
        heights: &'a HeightMap,
        selection: &Selection,
        surface_settings: SurfaceSettings,
        maps: SlotMaps<'a>,
    ) -> Self {
        let levels = selection.levels_of(heights);
        let program = Program::new(&Bound {
            frame: Frame::none(),
            surface_settings,
            height_map: HeightTexture::new(heights, levels),
            hole_map: HoleTexture::new(None),
            color_map: ColorTexture::BLANK,
            normal_map: ColorTexture::BLANK,
            material_map: ColorTexture::BLANK,
            maps,
        });
        Self { program, levels }
    }

    /// Returns the method's hit on a path.
    #[inline]
    pub fn first_hit(&self, path: &Path) -> Hit {
        Hit::from(&self.program.trace(super::Path::from(path)))
    }

    /// Traces many paths at once in lanes of that width, with the very bits of
    /// [`first_hit`](Self::first_hit). Paths that are near each other are traced faster if they are
    /// near in the slice, too. If the machine lacks the width, they are traced one by one.
    ///
    /// # Panics
    ///
    /// When there are not as many hits as paths.
    pub fn first_hits(&self, paths: &[Path], lanes: Lanes, hits: &mut [Hit]) {
        assert_eq!(paths.len(), hits.len(), "a hit for each path");
        let (mut block, mut found) = (PathBlock::default(), HitBlock::default());
        for (paths, hits) in paths.chunks(BLOCK).zip(hits.chunks_mut(BLOCK)) {
            for (at, path) in paths.iter().enumerate() {
                block.set(at, &path.into());
            }
            let which = u16::MAX >> (BLOCK - paths.len());
            self.trace_block(&block, which, lanes, &mut found);
            for (at, hit) in hits.iter_mut().enumerate() {
                *hit = Hit::from(&found.get(at));
            }
        }
    }

    /// Traces the paths of a block that `which` has bits for, with the very bits of
    /// [`first_hits`](Self::first_hits). That function puts its paths into such blocks, which takes
    /// up to a quarter of the time of a plain search over sixteen lanes. A program with blocks of
    /// its own saves it.
    #[inline]
    pub fn trace_block(&self, paths: &PathBlock, which: u16, lanes: Lanes, hits: &mut HitBlock) {
        self.program.trace_block(paths, which, lanes, hits);
    }

    /// Returns the optical depth of a translucent volume along a path, whose parameter is in metres. Beyond
    /// 8, where hardly any light is left, a part of it may be missing. For the search `translucent`.
    pub fn optical_depth(&self, path: &Path) -> f32 {
        self.program.optical_depth(super::Path::from(path))
    }

    /// Returns the part of light that comes through an optical depth, from 0 on.
    pub fn transmittance(&self, optical_depth: f32) -> f32 {
        self.program.transmittance(optical_depth)
    }

    /// Returns the method's hit on a path with every turn of its loops, for a drawing.
    ///
    /// ```
    /// use relief_core::{HeightMap, Metric, Path, Wrap};
    /// use relief_shaders::Selection;
    /// use relief_shaders::cpu::MethodTracer;
    ///
    /// let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| (i * j % 64) as f32 / 63.0)?;
    /// let relief = Selection::method("relief")?;
    /// let tracer = MethodTracer::new(&heights, Metric::UNIT, &relief, [])?;
    /// let explanation = tracer.explain(&Path::between([0.1, 0.2, 1.0], [0.9, 0.6, 0.0]));
    /// assert_eq!(explanation.turns(), explanation.hit.cost.steps as usize);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn explain(&self, path: &Path) -> Explanation {
        self.program.explain(path)
    }

    /// Returns the method's hit on a path in a [level](HeightMap::level) of the height map. Beyond
    /// the coarsest level that one is traced; a method whose detail is `none` has only the finest.
    #[inline]
    pub fn first_hit_in(&self, level: u32, path: &Path) -> Hit {
        let level = level.min(self.levels - 1);
        Hit::from(&self.program.trace(super::Path { level, ..path.into() }))
    }
}
