//! The exact picture of a scene: its colours and its hits, by which pictures of methods are judged.

use relief_core::{Lanes, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::false_color::{Judge, NO_SURFACE, Quantity};
use relief_scene::{Scene, Shown, Surface};
use relief_shaders::cpu::PixelOut;
use relief_shaders::{Choice, Selection};

use crate::error::CompareError;
use crate::exact_hits::{ExactHits, check_surface};
use crate::picture::{Flip, Image, ImageError, PIXELS_PER_DEGREE, flip};
use crate::run::reference::selection;
use crate::run::shadow::{exact_shadows, with_samples};
use crate::run::subject::with_selections;

/// The exact picture of a scene: what `relief compare` compares pictures with.
///
/// It is drawn by the method `exact` on the CPU, with the surface `prism` on curved meshes, and with exact
/// shadows. It [judges](Judge) pictures of the same scene by other methods, of the same size.
///
/// ```
/// use relief_compare::ExactPicture;
/// use relief_compare::picture::Image;
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
/// let own = render(&scene, &mut maps, &Watch::none())?.rendering;
/// // The scene's method is `exact`.
/// assert_eq!(exact.flip(&Image::of(&own, &scene)?)?.mean(), 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExactPicture {
    hits: Option<ExactHits>,
    image: Image,
}

impl ExactPicture {
    /// Bytes of a pixel while the picture is drawn.
    pub const BYTES_PER_PIXEL: u64 = 320;

    /// Checks that a scene has an exact picture.
    ///
    /// # Errors
    ///
    /// When it has a depth object, a volume or a motif.
    pub fn check(scene: &Scene) -> Result<(), CompareError> {
        scene.surfaces().iter().try_for_each(check_surface)
    }

    /// Draws the exact picture of a scene. `lanes` is the SIMD width.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check) has them; and when the scene cannot be rendered, or the work is cancelled.
    pub fn new(scene: &Scene, lanes: Lanes, maps: &mut Maps, watch: &Watch) -> Result<Self, CompareError> {
        Self::check(scene)?;
        let shadows = exact_shadows(scene)?;
        let exact = exact_scene(scene, scene.surfaces(), &shadows, scene.samples())?;
        let mut renderer = Renderer::on_cpu();
        renderer.set_lanes(lanes);
        Self::drawn(&exact, scene.surfaces(), &mut renderer, maps, watch)
    }

    /// Draws a scene that is [exact](exact_scene) already. `surfaces` are those that are judged.
    pub(crate) fn drawn(
        exact: &Scene,
        surfaces: &[Surface],
        renderer: &mut Renderer,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<Self, CompareError> {
        watch.check()?;
        let rendered = renderer.render(exact, maps, watch);
        let rendering = rendered.map_err(|error| CompareError::of_picture("exact", error))?.rendering;
        let hits = match surfaces {
            [surface] => Some(ExactHits::of_picture(exact, surface, &rendering.pixels, watch)?),
            _ => None,
        };
        Ok(Self { hits, image: Image::of(&rendering, exact)? })
    }

    /// Returns the picture.
    pub fn image(&self) -> &Image {
        &self.image
    }

    /// Returns the hits; none with several surfaces, which hide each other.
    pub fn hits(&self) -> Option<&ExactHits> {
        self.hits.as_ref()
    }

    /// Returns the differences of a picture that an eye sees.
    ///
    /// # Errors
    ///
    /// When it has another size.
    pub fn flip(&self, picture: &Image) -> Result<Flip, ImageError> {
        flip(&self.image, picture, PIXELS_PER_DEGREE)
    }
}

impl Judge for ExactPicture {
    fn of_hit(&self, quantity: &Quantity, number: usize, pixel: &PixelOut) -> f32 {
        self.hits.as_ref().map_or(NO_SURFACE, |hits| hits.of_hit(quantity, number, pixel))
    }

    fn of_colors(&self, quantity: &Quantity, linear: &[[f32; 3]]) -> Vec<f32> {
        let compared =
            Image::new(self.image.size(), linear.to_vec()).and_then(|picture| match quantity.shown {
                Shown::Flip => self.flip(&picture).map(|flip| flip.differences),
                _ => self.image.differences(&picture),
            });
        compared.unwrap_or_else(|_| vec![NO_SURFACE; linear.len()])
    }
}

/// Returns a scene in which every surface is traced exactly, with these shadows.
pub(crate) fn exact_scene(
    scene: &Scene,
    surfaces: &[Surface],
    shadows: &[Choice],
    samples: u32,
) -> Result<Scene, CompareError> {
    let each = surfaces.iter().zip(shadows);
    let selections = each.map(|(of, shadow)| selection(of, with_samples(*shadow, samples)));
    let selections = selections.collect::<Result<Vec<Selection>, _>>()?;
    with_selections(scene, surfaces, &selections, samples)
}
