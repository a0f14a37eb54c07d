//! Looks: default light, background, tone curve and camera of a picture.

use std::fmt;
use std::str::FromStr;

use glam::{DVec3, Vec3};
use relief_core::registry::UnknownName;
use relief_shaders::{AMBIENT, Choice, SHADE, SHADOW, STAGES, Selection};

use super::framing::Framing;
use super::material_spec::metallic_roughness;
use super::{Surface, View};
use crate::background::Background;
use crate::light::{Light, LightError, SUN_DEG};
use crate::material::ShadingModel;
use crate::tone::Tone;
use relief_core::camera::Camera;

/// Look of a scene: the defaults of light, sky, background, exposure, tone curve and camera.
///
/// Each part can be set separately and then replaces the look's part.
///
/// # Examples
///
/// ```
/// use relief_core::mesh::square;
/// use relief_scene::{Look, Scene, Surface};
///
/// let heights = relief_core::HeightMap::new(1, 1, vec![1.0], relief_core::Wrap::Repeat)?;
/// let surface = Surface::new(square(2)?, heights.with_displacement(0.1, -0.1)?);
/// let scene = Scene::builder(surface).look(Look::Studio).build()?;
/// assert_eq!(scene.lights().len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Look {
    /// Key light from the camera's upper left, a soft sky, and a bright backdrop.
    Studio,
    /// Low warm sun from the camera's upper left, a blue sky, and a backdrop in its colours.
    Sun,
    /// Bright sky without any other light. Shadows are soft and shallow.
    Overcast,
    /// White light from a fixed direction, constant ambient light, and a dark background. The
    /// camera looks from above a corner. Its pictures do not change from version to version.
    #[default]
    Plain,
}

/// Parts of a look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LookParts {
    /// Only light, if any.
    key: Option<KeyLight>,
    /// Linear ambient light.
    pub ambient: Vec3,
    /// Whether surfaces without a named ambient variant see a sky above and ground below, as far as
    /// the relief leaves them open. Otherwise the ambient light is constant.
    has_sky: bool,
    /// Whether surfaces without a named shading and without values of another one are shaded by
    /// roughness and metalness.
    shades_materials: bool,
    /// Whether surfaces cast shadows on each other if there are several.
    is_shared: bool,
    pub background: Background,
    pub exposure: f32,
    pub tone: Tone,
    pub view: View,
    /// Extent of the scene that a fitted camera shows.
    pub framing: Framing,
}

/// Light infinitely far away.
#[derive(Clone, Copy, Debug)]
struct KeyLight {
    /// Direction toward the light, of any length: right, up and toward the eye, or in world space.
    toward: DVec3,
    of_camera: bool,
    irradiance: Vec3,
}

/// Direction toward the light of [`Look::Plain`]: from the upper left of the built-in views.
pub(super) const PLAIN_LIGHT: DVec3 = DVec3::new(-0.6, 0.6, -0.1);

/// Ambient variants of a sky: with occlusion by the relief, or without.
const SKY: &str = "sky";
const HEMISPHERE: &str = "hemisphere";

/// Pixels of the picture's longer side per texel of the sky map. The sky is smooth, and finer maps
/// take longer to bake: a tenth of a second for the finest.
const SKY_PIXELS: u32 = 4;

/// Shadow variant by which surfaces cast shadows on each other.
const SHARED_SHADOW: &str = "map";

impl Look {
    /// All looks, in the order in which help lists them.
    pub const ALL: [Look; 4] = [Look::Studio, Look::Sun, Look::Overcast, Look::Plain];

    /// Default look of pictures and scene files.
    pub const OF_PICTURES: Look = Look::Studio;

    /// Returns the name of this look, as files and the command spell it: `studio` to `plain`.
    pub const fn name(self) -> &'static str {
        match self {
            Look::Studio => "studio",
            Look::Sun => "sun",
            Look::Overcast => "overcast",
            Look::Plain => "plain",
        }
    }

    /// Returns the look's lights for a camera. Most looks place their light relative to the camera.
    pub fn lights(self, camera: &Camera) -> Vec<Light> {
        self.parts().lights(camera, SUN_DEG, None).expect("the lights of looks are possible")
    }

    /// Returns the look's background.
    pub fn background(self) -> Background {
        self.parts().background
    }

    pub(crate) const fn parts(self) -> LookParts {
        let studio = LookParts {
            key: Some(KeyLight {
                toward: DVec3::new(-0.75, 0.4, 0.48),
                of_camera: true,
                irradiance: Vec3::new(1.2, 1.09, 0.92),
            }),
            ambient: Vec3::new(0.42, 0.51, 0.64),
            has_sky: true,
            shades_materials: true,
            is_shared: true,
            background: Background::GRADIENT,
            exposure: 0.0,
            tone: Tone::Agx,
            view: View::ThreeQuarter,
            framing: Framing::Visible,
        };
        match self {
            Look::Studio => studio,
            Look::Sun => LookParts {
                key: Some(KeyLight {
                    toward: DVec3::new(-0.78, 0.34, 0.3),
                    of_camera: true,
                    irradiance: Vec3::new(1.9, 1.45, 0.95),
                }),
                ambient: Vec3::new(0.20, 0.29, 0.46),
                background: Background::Gradient([Vec3::new(0.30, 0.48, 0.80), Vec3::new(0.80, 0.86, 0.92)]),
                ..studio
            },
            Look::Overcast => LookParts { key: None, ambient: Vec3::new(1.0, 1.04, 1.08), ..studio },
            Look::Plain => LookParts {
                key: Some(KeyLight { toward: PLAIN_LIGHT, of_camera: false, irradiance: Vec3::ONE }),
                ambient: Vec3::splat(0.12),
                has_sky: false,
                shades_materials: false,
                is_shared: false,
                background: Background::Color(Vec3::splat(0.05)),
                exposure: 0.0,
                tone: Tone::None,
                view: View::Corner,
                framing: Framing::Volume,
            },
        }
    }

    /// Returns whether materials that suit all shading models are shaded by roughness and
    /// metalness.
    pub(super) fn shades_materials(self) -> bool {
        self.parts().shades_materials
    }

    /// Sets this look's sky in a selection without a named ambient variant, at a resolution for a
    /// picture of `size` pixels. A mesh without a relief does not occlude the sky.
    pub(super) fn light_from_sky(self, selection: &mut Selection, has_relief: bool, size: [u32; 2]) {
        if self.parts().has_sky {
            choose(selection, AMBIENT, if has_relief { &[SKY, HEMISPHERE] } else { &[HEMISPHERE] });
            lower(selection, AMBIENT, "side", power_of_two(size, SKY_PIXELS));
        }
    }

    /// Sets the shadow variant for several surfaces in a selection without a named shadow.
    pub(super) fn share_shadows(self, selection: &mut Selection, size: [u32; 2]) {
        if self.parts().is_shared {
            choose(selection, SHADOW, &[SHARED_SHADOW]);
            lower(selection, SHADOW, "size", power_of_two(size, 1).saturating_mul(2));
        }
    }

    /// Sets shading, sky and shadows for surfaces made by programs. Their first variants count as not
    /// named.
    pub(super) fn adapt(self, surfaces: &mut [Surface], size: [u32; 2]) {
        let several = surfaces.len() > 1;
        for surface in surfaces {
            let mut selection = *surface.selection();
            let [is_free, is_alone, is_unshaded] =
                [AMBIENT, SHADOW, SHADE].map(|stage| selection.choices[stage].number == 0);
            let is_rough = match surface.material().model() {
                Some(model) => model == ShadingModel::MetallicRoughness,
                None => self.shades_materials(),
            };
            if is_unshaded && is_rough {
                choose(&mut selection, SHADE, &[metallic_roughness()]);
            }
            if is_free {
                self.light_from_sky(&mut selection, surface.height_map().scale_m() > 0.0, size);
            }
            if several && is_alone {
                self.share_shadows(&mut selection, size);
            }
            *surface = surface.clone().with_selection(selection);
        }
    }
}

/// Returns the greatest power of two that is at most the picture's longer side over `part`.
fn power_of_two(size: [u32; 2], part: u32) -> u32 {
    1 << (size[0].max(size[1]) / part).max(1).ilog2()
}

/// Lowers a parameter of a stage to `value` or its minimum, if the variant has it.
fn lower(selection: &mut Selection, stage: usize, name: &str, value: u32) {
    let Choice { entry, params, .. } = &mut selection.choices[stage];
    if let Some((place, param)) = entry.param(name) {
        params[place] = params[place].min((value as f32).max(param.min));
    }
}

/// Chooses the first of these variants that fits the rest of the selection, if any does.
fn choose(selection: &mut Selection, stage: usize, names: &[&str]) {
    let before = selection.check();
    let found = names.iter().find_map(|name| {
        let mut trial = *selection;
        trial.choose(STAGES[stage].key, name).ok()?;
        // Other errors are reported elsewhere.
        let goes = trial.check();
        (goes.is_ok() || goes == before).then_some(trial)
    });
    *selection = found.unwrap_or(*selection);
}

impl LookParts {
    /// Returns the lights for a camera, with an apparent diameter in degrees. `toward` replaces the
    /// direction, in world space. A look without a light then gets a white one of irradiance 1.
    ///
    /// # Errors
    ///
    /// When the direction is 0 or not finite, or the diameter is out of range.
    pub fn lights(
        &self,
        camera: &Camera,
        diameter_deg: f64,
        toward: Option<DVec3>,
    ) -> Result<Vec<Light>, LightError> {
        let irradiance = self.key.map_or(Vec3::ONE, |key| key.irradiance);
        let given = toward.map(|toward| KeyLight { toward, of_camera: false, irradiance });
        let light = |key: KeyLight| {
            let KeyLight { toward, of_camera, irradiance } = key;
            let [right, up, back] = [camera.right(), camera.up(), -camera.forward()];
            let toward = if of_camera { right * toward.x + up * toward.y + back * toward.z } else { toward };
            Light::directional(toward, irradiance)?.with_diameter(diameter_deg)
        };
        given.or(self.key).map(light).into_iter().collect()
    }

    /// Returns the number of lights.
    pub fn light_count(&self) -> usize {
        self.key.iter().count()
    }
}

impl fmt::Display for Look {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Look {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|look| look.name() == name);
        found.ok_or_else(|| UnknownName::new("look", name, Self::ALL.map(Self::name)))
    }
}
