//! Loading of scenes: defaults, checks and files.

use super::builder::{DEFAULT_EYE, DEFAULT_FOV, DEFAULT_SIZE};
use super::error::{SceneError, ValueError, ValueProblem};
use super::framing::Framing;
use super::maps::{BYTES_PER_TRIANGLE, Maps};
use super::metres::check_metres;
use super::picture_size::check_size;
use super::surface_parts::Parts;
use super::surface_selection::SceneContext;
use super::{
    DEFAULT_MAX_MEMORY, DEFAULT_SAMPLES, LightSpec, Look, MeshChoice, ProjectionChoice, Scene, SceneBuilder,
    SceneSpec, SurfaceSpec,
};
use crate::depth_buffer::DepthBuffer;
use crate::environment::Environment;
use crate::light::{Light, LightError, SUN_DEG};
use crate::shadow_map::shadow_map_side;
use glam::{DVec3, Vec3};
use relief_core::ByteSize;
use relief_core::camera::{Camera, CameraError, Projection};
use relief_core::mesh::Builtin;
use relief_io::{Files, ReadNote};
use relief_shaders::{AMBIENT, LIGHT_FACES, STAGES, Selection};

/// Bytes per pixel of the band of rows that is being rendered: results on the GPU, their copies,
/// and the part of the picture to be written.
const BYTES_PER_PIXEL: u64 = 256;

/// Bytes per surface besides its maps and its mesh: its description, settings, and the backends'
/// data for them. The first surface is part of the constant memory.
const BYTES_PER_SURFACE: u64 = 64 << 10;

/// Assumed size of a picture of size `map` before its map is read. Skies and shadow maps depend on
/// it.
const LARGE_SIZE: [u32; 2] = [4096; 2];

/// Pixels of a band of rows. A very wide picture has bands of one row.
const BAND_PIXELS: u64 = 1 << 18;

/// Index of a surface if there are several, its description, and its parts that need no file.
type SurfaceParts = (Option<usize>, SurfaceSpec, Parts);

impl SceneSpec {
    /// Checks everything that needs no file. A scene file is checked this way before flags override
    /// it.
    ///
    /// # Errors
    ///
    /// When a value is out of range, or when keys exclude or need each other.
    pub fn check(&self) -> Result<(), ValueError> {
        self.check_look()?;
        self.viewer.check()?;
        // Maps of one texel, a sky and squares stand in for the files, so that the builder's own
        // checks run, too, in little memory.
        let mut surfaces = Vec::new();
        for part in self.each_with_parts() {
            let (number, surface, parts) = part?;
            let made = surface.on_a_square(parts).and_then(|parts| surface.stand_in(parts));
            surfaces.push(made.map_err(|error| error.of_surface(number))?);
        }
        let mut builder = self.builder(surfaces)?;
        if self.environment.is_some() {
            builder = builder.environment(Environment::sky());
        }
        builder.build().map(drop)
    }

    /// Returns the chosen variants of each surface, without a file being read. What mesh files or folders of
    /// textures say is not in it.
    ///
    /// # Errors
    ///
    /// When a surface has values that do not go together, see [`Self::check`].
    pub fn selections(&self) -> Result<Vec<Selection>, ValueError> {
        self.each_with_parts().map(|part| part.map(|(.., parts)| *parts.selection())).collect()
    }

    /// Reads all files and returns the complete scene, with the keys that mesh files hold for their
    /// surfaces (see [`Self::with_keys_of_meshes`]).
    ///
    /// Relative paths start at the current folder. [`read_scene`](crate::read_scene) has already
    /// resolved the paths of a scene file against its folder.
    ///
    /// # Errors
    ///
    /// When there is no height map, the names in a folder of textures are unclear, a value is out of
    /// range, a method is not available, a file cannot be read, or maps and picture need more than
    /// `max_memory`. The last is detected before that memory is allocated.
    pub fn load(&self) -> Result<Scene, SceneError> {
        self.load_from(&Files::Disk)
    }

    /// Returns the complete scene like [`Self::load`], with its files from `files`.
    ///
    /// # Errors
    ///
    /// See [`Self::load`].
    pub fn load_from(&self, files: &Files) -> Result<Scene, SceneError> {
        let (whole, notes) = self.whole(files)?;
        whole.load_whole(files, notes)
    }

    /// Returns the description with the files of folders of textures and the keys of mesh files, and notes on
    /// them.
    pub(super) fn whole(&self, files: &Files) -> Result<(Self, Vec<ReadNote>), SceneError> {
        self.check_surfaces()?;
        let (spec, notes) = self.with_texture_sets(files)?;
        Ok((spec.with_keys_of(files)?, notes))
    }

    /// Loads a scene that is [whole](Self::whole), with notes on what was read before.
    pub(super) fn load_whole(&self, files: &Files, mut notes: Vec<ReadNote>) -> Result<Scene, SceneError> {
        let each = self.each_with_parts().collect::<Result<Vec<_>, _>>()?;
        // All else is known to be valid before any file is read.
        self.check()?;
        let limit = self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY);
        let asked = light_views(each.iter().map(|(.., parts)| parts.selection()));
        let beside_surfaces = limit.0.saturating_sub(self.surface_bytes());
        let left = if self.is_of_map_size() {
            beside_surfaces
        } else {
            let size = self.pixels().unwrap_or(DEFAULT_SIZE);
            self.memory_beside_the_picture(beside_surfaces, size, asked, limit)?
        };
        let mut maps = Maps::new(files, limit, left);
        let environment = match &self.environment {
            Some(path) => Some(maps.environment(path)?),
            None => None,
        };
        let (mut surfaces, mut walls) = (Vec::new(), Vec::new());
        let (samples, context) = (self.samples.unwrap_or(DEFAULT_SAMPLES), self.context());
        for (number, spec, parts) in each {
            let surface = spec.load(parts, number, &mut maps)?;
            if spec.has_walls() {
                walls.push(spec.load_walls(&surface, samples, &context, &mut maps)?);
            }
            surfaces.push(surface);
        }
        // The size `map` is known only now, so its memory is subtracted now.
        let of_map = match &surfaces[..] {
            [surface] if self.is_of_map_size() => Some(self.map_size(surface)?),
            _ => None,
        };
        let left = match of_map {
            Some(size) => self.memory_beside_the_picture(maps.left(), size, asked, limit)?,
            None => maps.left(),
        };
        surfaces.extend(walls);
        let mut builder = self.builder(surfaces)?;
        if let Some([width, height]) = of_map {
            builder = builder.size(width, height);
        }
        if let Some(environment) = environment {
            builder = builder.environment(environment);
        }
        let scene = builder.geometry_memory(ByteSize(left)).build()?;
        notes.extend(maps.into_notes());
        Ok(Scene { notes, ..scene })
    }

    /// Returns the values that surfaces depend on.
    fn context(&self) -> SceneContext {
        SceneContext {
            look: self.look(),
            has_environment: self.environment.is_some(),
            several: self.surfaces.len() > 1,
            size: self.pixels().unwrap_or(if self.is_of_map_size() { LARGE_SIZE } else { DEFAULT_SIZE }),
        }
    }

    /// Returns every surface with its parts that need no file, and with its index if there are
    /// several.
    fn each_with_parts(&self) -> impl Iterator<Item = Result<SurfaceParts, ValueError>> {
        let several = !self.surfaces.is_empty();
        let context = self.context();
        self.each_surface().into_iter().enumerate().map(move |(number, mut surface)| {
            let number = several.then_some(number);
            surface.drop_maps();
            let parts = surface
                .parts(self.samples.unwrap_or(DEFAULT_SAMPLES), &context)
                .map_err(|error| error.of_surface(number))?;
            Ok((number, surface, parts))
        })
    }

    /// Returns the bytes for surfaces and built-in meshes. Each surface has a mesh of its own.
    fn surface_bytes(&self) -> u64 {
        let bytes = Builtin::ALL.map(|builtin| {
            builtin.build([1.0; 2]).map_or(0, |mesh| BYTES_PER_TRIANGLE * mesh.triangles().len() as u64)
        });
        let of_mesh = |choice: Option<&MeshChoice>| match choice {
            Some(MeshChoice::Builtin(builtin)) => Builtin::ALL
                .into_iter()
                .zip(bytes)
                .find(|(known, _)| known == builtin)
                .map_or(0, |(_, bytes)| bytes),
            _ => 0,
        };
        let each = self.surfaces.iter().map(|own| own.mesh.as_ref().or(self.surface.mesh.as_ref()));
        let of_meshes: u64 = each.map(of_mesh).sum();
        BYTES_PER_SURFACE * (self.surfaces.len() as u64).saturating_sub(1) + of_meshes
    }

    /// Refuses more surfaces than fit into memory, before anything is built.
    fn check_surfaces(&self) -> Result<(), SceneError> {
        let (needed, limit) = (self.surface_bytes(), self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY));
        if needed > limit.0 {
            return Err(SceneError::TooManySurfaces { count: self.surfaces.len(), needed, limit });
        }
        Ok(())
    }

    /// Subtracts from `left` bytes the memory of a picture of that size and of its shadow maps.
    /// `asked` is the longest side of these maps in texels and the number of cascades, where
    /// surfaces need them.
    fn memory_beside_the_picture(
        &self,
        left: u64,
        size: [u32; 2],
        asked: Option<[u32; 2]>,
        limit: ByteSize,
    ) -> Result<u64, SceneError> {
        let [width, height] = size;
        let whole = u64::from(width) * u64::from(height);
        let pixels = whole.min(BAND_PIXELS.max(u64::from(width)));
        let needed = pixels.saturating_mul(BYTES_PER_PIXEL);
        let left =
            left.checked_sub(needed).ok_or(SceneError::TooMuchMemory { width, height, needed, limit })?;
        let needed = self.shadow_map_bytes(asked, size)?;
        left.checked_sub(needed).ok_or(SceneError::TooMuchForShadowMaps { needed, left, limit })
    }

    /// Returns the bytes of the picture and of its shadow maps, for surfaces with these selections.
    pub(super) fn bytes_beside_surfaces(&self, selections: &[Selection]) -> Result<u64, SceneError> {
        let (all, size) = (u64::MAX, self.pixels().unwrap_or(DEFAULT_SIZE));
        let left =
            self.memory_beside_the_picture(all, size, light_views(selections.iter()), ByteSize(all))?;
        Ok(all - left)
    }

    /// Returns the largest possible size of all shadow maps in bytes.
    fn shadow_map_bytes(&self, asked: Option<[u32; 2]>, size: [u32; 2]) -> Result<u64, ValueError> {
        let Some([most, cascades]) = asked else { return Ok(0) };
        let side = shadow_map_side(most, size);
        let views: u64 = match self.lights()? {
            // All lights of a look are directional.
            None => {
                let count = self.look().parts().light_count().max(usize::from(self.light.is_some()));
                u64::from(cascades) * count as u64
            }
            Some(lights) => lights
                .iter()
                .map(|light| match light {
                    Light::Directional { .. } => u64::from(cascades),
                    Light::Point { .. } => LIGHT_FACES as u64,
                })
                .sum(),
        };
        // One more is the depth buffer with which a GPU draws them.
        Ok((views + 1) * u64::from(side) * u64::from(side) * size_of::<f32>() as u64)
    }

    pub(super) fn builder(&self, surfaces: Vec<super::Surface>) -> Result<SceneBuilder, ValueError> {
        check_metres("eye", self.eye.as_ref().map_or(&[], |eye| eye))?;
        check_metres("view-height", self.view_height.as_slice())?;
        check_metres("near", self.near.as_slice())?;
        check_metres("far", self.far.filter(|far| *far != f64::INFINITY).as_slice())?;
        check_metres("target", self.target.as_ref().map_or(&[], |target| target))?;
        for light in self.lights.iter().flatten() {
            check_metres("lights", light.position.as_ref().map_or(&[], |position| position))?;
            check_metres("lights", light.radius.as_slice())?;
        }
        if self.is_of_map_size() {
            self.check_map_size()?;
        }
        self.pixels().map(check_size).transpose()?;
        let mut builder = self
            .camera(SceneBuilder::showing(surfaces))?
            .look_beside_surfaces(self.look())
            .light_angle(self.light_angle.unwrap_or(SUN_DEG))
            .depth_buffer(DepthBuffer {
                clip: self.clip.unwrap_or_default(),
                near_m: self.near,
                far_m: self.far,
            })
            .samples(self.samples.unwrap_or(DEFAULT_SAMPLES))
            .backend(self.backend.unwrap_or_default())
            .sampling(self.sampling.unwrap_or_default());
        if let Some(lights) = self.lights()? {
            builder = builder.lights(lights);
        }
        if let Some(toward) = self.light {
            builder = builder.light_toward(toward.into());
        }
        if let Some(exposure) = self.exposure {
            builder = builder.exposure(exposure);
        }
        if let Some(tone) = self.tone {
            builder = builder.tone(tone);
        }
        if let Some(ambient) = self.ambient_color {
            builder = builder.ambient(ambient.into());
        }
        if let Some(background) = self.background {
            builder = builder.background(background);
        }
        if let Some([width, height]) = self.pixels() {
            builder = builder.size(width, height);
        }
        if self.is_of_map_size() {
            // The scene fills the picture to its border in all looks.
            builder = builder.framing(Framing::Visible);
        }
        Ok(builder)
    }

    /// Sets the described camera.
    fn camera(&self, builder: SceneBuilder) -> Result<SceneBuilder, ValueError> {
        let fov = self.fov.unwrap_or(DEFAULT_FOV);
        let projection = self.projection.unwrap_or_default();
        match projection {
            ProjectionChoice::Perspective if self.view_height.is_some() => {
                return Err(ValueProblem::Needs("projection orthographic").of("view-height"));
            }
            ProjectionChoice::Orthographic if self.fov.is_some() => {
                return Err(ValueProblem::Excludes("projection orthographic").of("fov"));
            }
            _ => {}
        }
        if self.eye.is_none() && self.target.is_none() {
            if self.view_height.is_some() {
                return Err(ValueProblem::Needs("eye").of("view-height"));
            }
            let view = self.view.unwrap_or(self.look().parts().view);
            return Ok(match projection {
                ProjectionChoice::Perspective => builder.fitted_camera(view, fov),
                ProjectionChoice::Orthographic => builder.fitted_orthographic_camera(view),
            });
        }
        if self.view.is_some() {
            return Err(ValueProblem::Excludes("eye and target").of("view"));
        }
        let projection = match (projection, self.view_height) {
            (ProjectionChoice::Perspective, _) => Projection::Perspective { fov_degrees: fov },
            (ProjectionChoice::Orthographic, Some(height_m)) => Projection::Orthographic { height_m },
            (ProjectionChoice::Orthographic, None) => {
                return Err(ValueProblem::Needs("view-height").of("projection"));
            }
        };
        let eye = self.eye.map_or(DEFAULT_EYE, DVec3::from);
        let target = self.target.map_or(DVec3::ZERO, DVec3::from);
        let camera = Camera::with(eye, target, projection).map_err(|error| {
            let key = match error {
                CameraError::BadFov(_) => "fov",
                CameraError::BadHeight(_) => "view-height",
                _ if self.eye.is_some() => "eye",
                _ => "target",
            };
            ValueProblem::from(error).of(key)
        })?;
        Ok(builder.camera(camera))
    }

    /// Refuses a look whose parts are all overridden.
    fn check_look(&self) -> Result<(), ValueError> {
        let Some(look) = self.look else { return Ok(()) };
        let names_ambient = |surface: &SurfaceSpec| surface.stages.contains_key(STAGES[AMBIENT].key);
        let has_camera = self.view.is_some() || self.eye.is_some() || self.target.is_some();
        // A direction keeps the colour of the look's light.
        let has_lights = self.lights.is_some();
        let has_sky = self.ambient_color.is_some() && self.each_surface().iter().all(names_ambient);
        let has_display = self.background.is_some() && self.exposure.is_some() && self.tone.is_some();
        if look != Look::Plain && has_camera && has_lights && has_sky && has_display {
            return Err(ValueProblem::NothingOfLook(look).of("look"));
        }
        Ok(())
    }

    /// Returns the look. Default: [`Look::OF_PICTURES`].
    pub(super) fn look(&self) -> Look {
        self.look.unwrap_or(Look::OF_PICTURES)
    }

    /// Returns the lights, or `None` for the look's.
    fn lights(&self) -> Result<Option<Vec<Light>>, ValueError> {
        let angle = self.light_angle.unwrap_or(SUN_DEG);
        let problem = |key| move |error| ValueProblem::from(error).of(key);
        // An angle that applies to no light is checked, too.
        let only = Light::directional(self.light.map_or(DVec3::Y, DVec3::from), Vec3::ONE);
        only.map_err(problem("light"))?.with_diameter(angle).map_err(problem("light-angle"))?;
        match (self.light, &self.lights) {
            (Some(_), Some(_)) => Err(ValueProblem::Excludes("lights").of("light")),
            // The look's light, from that direction.
            (_, None) => Ok(None),
            (None, Some(lights)) => {
                let lights = lights.iter().map(|light| light.light(angle));
                let lights = lights.collect::<Result<_, ValueProblem>>();
                lights.map(Some).map_err(|problem| problem.of("lights"))
            }
        }
    }
}

/// The longest side of shadow maps in texels, and the number of cascades, where selections need them.
fn light_views<'a>(selections: impl Iterator<Item = &'a Selection>) -> Option<[u32; 2]> {
    selections.filter_map(Selection::light_views).reduce(|[a, b], [c, d]| [a.max(c), b.max(d)])
}

impl LightSpec {
    /// Returns the light. `angle` is the default diameter of a directional light in degrees.
    fn light(&self, angle: f64) -> Result<Light, ValueProblem> {
        let colour = Vec3::from(self.color.unwrap_or([1.0; 3]));
        let intensity = self.intensity.unwrap_or(1.0);
        if !(intensity >= 0.0 && intensity.is_finite()) {
            let must = "finite and not negative";
            return Err(ValueProblem::Number { value: f64::from(intensity), must });
        }
        Ok(match (self.direction, self.position) {
            (Some(_), None) if self.radius.is_some() => return Err(LightError::OtherSize.into()),
            (None, Some(_)) if self.angle.is_some() => return Err(LightError::OtherSize.into()),
            (Some(toward), None) => Light::directional(toward.into(), colour * intensity)?
                .with_diameter(self.angle.unwrap_or(angle))?,
            (None, Some(position)) => Light::point(position.into(), colour * intensity)?
                .with_radius(self.radius.unwrap_or_default())?,
            _ => return Err(LightError::DirectionOrPosition.into()),
        })
    }
}
