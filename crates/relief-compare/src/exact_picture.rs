//! The exact hits of a picture's pixels, by which each pixel of a method is judged.

use relief_core::metrics::distance_texels;
use relief_core::{HeightMap, Lanes, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::false_color::{NO_SURFACE, NOT_COMPARABLE};
use relief_scene::{Scene, Surface};
use relief_shaders::cpu::PixelOut;
use relief_shaders::field::Solids;
use relief_shaders::{DETAIL, Entry, STAGES};

use crate::contender::shadow;
use crate::error::CompareError;
use crate::run::reference::{hit_of, in_tile_of, is_flat, selection, traced_exactly};
use crate::run::subject::with_selections;

/// Exact hits at the centres of a picture's pixels, on the finest level of the height map.
///
/// On a flat mesh they are the hits of the method `exact` on the CPU. On others they are those that
/// the exact tracer of displaced meshes finds.
///
/// ```
/// use relief_compare::ExactPicture;
/// use relief_core::{HeightMap, Lanes, Watch, Wrap, mesh::square};
/// use relief_maps::Maps;
/// use relief_render::render;
/// use relief_scene::{Scene, Surface};
///
/// let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
/// let surface = Surface::new(square(1)?, heights.with_displacement(0.05, -0.05)?);
/// let scene = Scene::builder(surface).size(32, 24).build()?;
/// let mut maps = Maps::in_memory();
/// let exact = ExactPicture::new(&scene, Lanes::widest(), &mut maps, &Watch::none())?;
/// let pixels = render(&scene, &mut maps, &Watch::none())?.rendering.pixels;
/// // The scene's method is `exact`.
/// assert!((0..).zip(&pixels).all(|(at, pixel)| !(exact.error_texels(at, pixel) > 1e-3)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExactPicture {
    map: std::sync::Arc<HeightMap>,
    /// Texture coordinates of each pixel's hit.
    hits: Vec<Option<[f64; 2]>>,
}

impl ExactPicture {
    /// Bytes of a pixel while the hits are found.
    pub const BYTES_PER_PIXEL: u64 = 160;

    /// Checks that the exact hits of a scene are known.
    ///
    /// # Errors
    ///
    /// When the scene has several surfaces, which hide each other, a depth object, a volume or a motif.
    pub fn check(scene: &Scene) -> Result<(), CompareError> {
        Self::only(scene).map(|_| ())
    }

    fn only(scene: &Scene) -> Result<&Surface, CompareError> {
        match scene.surfaces() {
            [surface] if surface.object().is_some() => {
                Err(CompareError::NoExactHits("a depth object".to_owned()))
            }
            [surface] if surface.solids() != Solids::Heights => {
                Err(CompareError::NoExactHits(surface.solids().in_words().to_owned()))
            }
            [surface] => Ok(surface),
            surfaces => Err(CompareError::NoExactHits(format!("a scene of {} surfaces", surfaces.len()))),
        }
    }

    /// Finds the exact hits of a scene's picture on the CPU. `lanes` is the SIMD width.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check) has them; and when the scene cannot be rendered, or the work is
    /// cancelled.
    pub fn new(scene: &Scene, lanes: Lanes, maps: &mut Maps, watch: &Watch) -> Result<Self, CompareError> {
        let surface = Self::only(scene)?;
        let map = surface.height_map().clone();
        if !is_flat(surface.mesh()) {
            watch.check()?;
            let truth = traced_exactly(surface, scene.camera(), scene.size())?;
            let hits = truth.iter().map(|truth| truth.hit.found.then_some(truth.hit.uv)).collect();
            return Ok(Self { map, hits });
        }
        let mut exact = selection(surface, shadow("none")?)?;
        let finest = STAGES[DETAIL].first(Entry::is_idle).map_or("", |(_, entry)| entry.name);
        exact.choose(STAGES[DETAIL].key, finest)?;
        let scene = with_selections(scene, std::slice::from_ref(surface), &[exact], 1)?;
        let mut renderer = Renderer::on_cpu();
        renderer.set_lanes(lanes);
        let mut hits = Vec::with_capacity(scene.size().map(|side| side as usize).iter().product());
        let rendered = renderer.render_bands(&scene, maps, true, watch, &mut |band| {
            let found = |pixel: &PixelOut| (pixel.hit != 0).then(|| hit_of(pixel).uv);
            hits.extend(band.iter().map(found));
            Ok(())
        });
        rendered.map_err(|error| CompareError::of_picture("exact", error))?;
        Ok(Self { map, hits })
    }

    /// Returns the distance of a method's hit from the exact one, in texels along the texture.
    /// `number` is the pixel's, row by row from the top. On repeated maps the distance is to the
    /// nearest tile.
    ///
    /// Returns [`NO_SURFACE`] where both miss, and [`NOT_COMPARABLE`] where one of them misses.
    pub fn error_texels(&self, number: usize, pixel: &PixelOut) -> f32 {
        let hit = hit_of(pixel);
        match (self.hits.get(number).copied().flatten(), hit.found) {
            (None, false) => NO_SURFACE,
            (Some(uv), true) => {
                let truth = relief_core::Hit { uv, ..hit };
                distance_texels(in_tile_of(hit, &truth, self.map.wrap()).uv, uv, &self.map) as f32
            }
            _ => NOT_COMPARABLE,
        }
    }
}
