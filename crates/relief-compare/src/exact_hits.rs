//! The exact hits of a picture's pixels, by which each pixel of a method is judged.

use std::sync::Arc;

use relief_core::exact::ExactHit;
use relief_core::metrics::{LATE_TEXELS, distance_texels};
use relief_core::{HeightMap, Hit, Lanes, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::false_color::{Judge, NO_SURFACE, NOT_COMPARABLE, Quantity};
use relief_scene::{Scene, Shown, Surface};
use relief_shaders::cpu::PixelOut;
use relief_shaders::field::Solids;
use relief_shaders::{DETAIL, Entry, STAGES};

use crate::case::judged;
use crate::contender::shadow;
use crate::error::CompareError;
use crate::record::ErrorRecord;
use crate::run::reference::{hit_of, in_tile_of, is_flat, selection, traced_exactly, truth};
use crate::run::subject::with_selections;

/// Exact hits at the centres of a picture's pixels.
///
/// On a flat mesh they are the hits of the method `exact` on the CPU. On others they are those that the exact
/// tracer of displaced meshes finds. They [judge](Judge) the hits of pictures of the same scene by other
/// methods, of the same size.
///
/// ```
/// use relief_compare::ExactHits;
/// use relief_core::{HeightMap, Lanes, Watch, Wrap, mesh::square};
/// use relief_maps::Maps;
/// use relief_render::render;
/// use relief_scene::{Scene, Surface};
///
/// let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
/// let surface = Surface::new(square(1)?, heights.with_displacement(0.05, -0.05)?);
/// let scene = Scene::builder(surface).size(32, 24).build()?;
/// let mut maps = Maps::in_memory();
/// let exact = ExactHits::new(&scene, Lanes::widest(), &mut maps, &Watch::none())?;
/// let pixels = render(&scene, &mut maps, &Watch::none())?.rendering.pixels;
/// // The scene's method is `exact`.
/// assert!((0..).zip(&pixels).all(|(at, pixel)| !(exact.error_texels(at, pixel) > 1e-3)));
/// assert_eq!(exact.errors(&pixels).passed, 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExactHits {
    map: Arc<HeightMap>,
    hits: Vec<ExactHit>,
}

impl ExactHits {
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
            [surface] => check_surface(surface).map(|()| surface),
            surfaces => Err(CompareError::NoExactHits(format!("a scene of {} surfaces", surfaces.len()))),
        }
    }

    /// Finds the exact hits of a scene's picture, on the finest level of the height map. `lanes` is the SIMD
    /// width.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check) has them; and when the scene cannot be rendered, or the work is
    /// cancelled.
    pub fn new(scene: &Scene, lanes: Lanes, maps: &mut Maps, watch: &Watch) -> Result<Self, CompareError> {
        let surface = Self::only(scene)?;
        let map = surface.height_map().clone();
        if !is_flat(surface.mesh()) {
            let hits = traced_exactly(surface, scene.camera(), scene.size(), watch)?;
            return Ok(Self { map, hits });
        }
        let mut exact = selection(surface, shadow("none")?)?;
        let finest = STAGES[DETAIL].first(Entry::is_idle).map_or("", |(_, entry)| entry.name);
        exact.choose(STAGES[DETAIL].key, finest)?;
        let scene = with_selections(scene, std::slice::from_ref(surface), &[exact], 1)?;
        let mut hits = Vec::with_capacity(scene.size().map(|side| side as usize).iter().product());
        let mut renderer = Renderer::on_cpu();
        renderer.set_lanes(lanes);
        let rendered = renderer.render_bands(&scene, maps, true, watch, &mut |band| {
            hits.extend(band.iter().map(|pixel| truth(hit_of(pixel))));
            Ok(())
        });
        rendered.map_err(|error| CompareError::of_picture("exact", error))?;
        Ok(Self { map, hits })
    }

    /// Takes the hits of an exact picture's pixels; on a curved mesh they are traced.
    pub(crate) fn of_picture(
        scene: &Scene,
        surface: &Surface,
        pixels: &[PixelOut],
        watch: &Watch,
    ) -> Result<Self, CompareError> {
        let hits = match is_flat(surface.mesh()) {
            true => pixels.iter().map(|pixel| truth(hit_of(pixel))).collect(),
            false => traced_exactly(surface, scene.camera(), scene.size(), watch)?,
        };
        Ok(Self { map: surface.height_map().clone(), hits })
    }

    /// Returns the exact hit of a pixel, counted row by row from the top; none where nothing is hit.
    pub fn hit(&self, number: usize) -> Option<&Hit> {
        self.hits.get(number).map(|exact| &exact.hit).filter(|hit| hit.found)
    }

    /// Returns the errors of a picture's hits.
    ///
    /// # Panics
    ///
    /// When the picture has another size.
    pub fn errors(&self, pixels: &[PixelOut]) -> ErrorRecord {
        self.judged(pixels).1
    }

    /// Returns a picture's hits, moved to the tiles of the exact ones, and their errors.
    pub(crate) fn judged(&self, pixels: &[PixelOut]) -> (Vec<Hit>, ErrorRecord) {
        let each = pixels.iter().zip(&self.hits);
        let hits: Vec<Hit> =
            each.map(|(pixel, exact)| in_tile_of(hit_of(pixel), &exact.hit, self.map.wrap())).collect();
        let errors = (&judged(&self.hits, &hits, &self.map)).into();
        (hits, errors)
    }

    /// Returns the distance of a method's hit from the exact one, in texels along the texture.
    /// `number` is the pixel's, row by row from the top. On repeated maps the distance is to the
    /// nearest tile.
    ///
    /// Returns [`NO_SURFACE`] where both miss, and [`NOT_COMPARABLE`] where one of them misses.
    pub fn error_texels(&self, number: usize, pixel: &PixelOut) -> f32 {
        let (hit, exact) = (hit_of(pixel), self.hit(number));
        match (exact, hit.found) {
            (None, false) => NO_SURFACE,
            (Some(exact), true) => {
                distance_texels(in_tile_of(hit, exact, self.map.wrap()).uv, exact.uv, &self.map) as f32
            }
            _ => NOT_COMPARABLE,
        }
    }

    /// Returns 1 where a ray has passed the exact hit: it misses it, or its own hit lies more than half a
    /// texel behind. Elsewhere 0, and [`NO_SURFACE`] where both miss.
    fn passed(&self, number: usize, pixel: &PixelOut) -> f32 {
        let (hit, exact) = (hit_of(pixel), self.hit(number));
        let is_passed = match exact {
            None if !hit.found => return NO_SURFACE,
            None => false,
            Some(_) if !hit.found => true,
            Some(exact) => {
                let distance = self.error_texels(number, pixel);
                f64::from(distance) > LATE_TEXELS && hit.t > exact.t
            }
        };
        f32::from(u8::from(is_passed))
    }
}

impl Judge for ExactHits {
    fn of_hit(&self, quantity: &Quantity, number: usize, pixel: &PixelOut) -> f32 {
        match quantity.shown {
            Shown::Passed => self.passed(number, pixel),
            _ => self.error_texels(number, pixel),
        }
    }

    fn of_colors(&self, _: &Quantity, linear: &[[f32; 3]]) -> Vec<f32> {
        vec![NO_SURFACE; linear.len()]
    }
}

/// Checks that the exact tracers know what a surface is.
pub(crate) fn check_surface(surface: &Surface) -> Result<(), CompareError> {
    match surface.solids() {
        _ if surface.object().is_some() => Err(CompareError::NoExactHits("a depth object".to_owned())),
        Solids::Heights => Ok(()),
        solids => Err(CompareError::NoExactHits(solids.in_words().to_owned())),
    }
}
