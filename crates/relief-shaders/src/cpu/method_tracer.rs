//! Rays through a method.

use relief_core::{BakedMap, HeightMap, Hit, Lanes, Metric, Path};

use super::{BLOCK, HitBlock, PathBlock};
use super::{Bound, ColorTexture, Frame, HeightTexture, HoleTexture, Program, SurfaceSettings};
use crate::{MapError, Selection, SlotMaps};

/// A method, ready to trace rays through a height map: what a shader finds, without a picture.
///
/// A [`Path`] is rounded to `f32`, as shaders have it. How near the answers come to the truth is what the
/// method's [guarantees](crate::Selection::guarantee) say; [`FastTracer`](relief_core::exact::FastTracer) has
/// the truth.
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
    /// The method over that height map, on a surface of that metric, with the baked maps that it reads. Maps
    /// that it does not read may be among them.
    ///
    /// # Errors
    ///
    /// When a map that the method reads is missing, or is another one than it reads; the error says in what.
    pub fn new(
        heights: &'a HeightMap,
        metric: Metric,
        selection: &Selection,
        maps: impl IntoIterator<Item = &'a BakedMap> + Clone,
    ) -> Result<Self, MapError> {
        Ok(Self::over(heights, selection, selection.slot_maps(maps, heights, metric)?))
    }

    /// The same over maps that are known to be the right ones: nothing is checked, and wrong maps give wrong
    /// answers.
    pub fn over(heights: &'a HeightMap, selection: &Selection, maps: SlotMaps<'a>) -> Self {
        let levels = selection.levels_of(heights);
        let program = Program::new(&Bound {
            frame: Frame::none(),
            surface_settings: SurfaceSettings::tracing(heights, selection, &maps),
            height_map: HeightTexture::new(heights, levels),
            hole_map: HoleTexture::new(None),
            color_map: ColorTexture::BLANK,
            normal_map: ColorTexture::BLANK,
            maps,
        });
        Self { program, levels }
    }

    /// Where a path ends by this method.
    #[inline]
    pub fn first_hit(&self, path: &Path) -> Hit {
        Hit::from(&self.program.trace(super::Path::from(path)))
    }

    /// Where each of some paths ends, many at once in lanes of that width: the answers of
    /// [`first_hit`](Self::first_hit), with the same bits. Paths that are near each other are the faster
    /// the nearer they stand in the slice. Where the machine lacks the width they go one by one.
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

    /// Where those paths of a block end that `which` has bits for: the answers of
    /// [`first_hits`](Self::first_hits), which puts its paths into such blocks. That takes up to a quarter
    /// of the time of a plain search over sixteen lanes, and a program with blocks of its own saves it.
    #[inline]
    pub fn trace_block(&self, paths: &PathBlock, which: u16, lanes: Lanes, hits: &mut HitBlock) {
        self.program.trace_block(paths, which, lanes, hits);
    }

    /// Where a path ends in a [level](HeightMap::level) of the height map. Beyond the coarsest level that one
    /// is traced; a method whose detail is `none` has the finest alone.
    #[inline]
    pub fn first_hit_in(&self, level: u32, path: &Path) -> Hit {
        let level = level.min(self.levels - 1);
        Hit::from(&self.program.trace(super::Path { level, ..path.into() }))
    }
}
