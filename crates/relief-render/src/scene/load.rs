//! From a description to a scene: defaults, checks, files.

use super::builder::{DEFAULT_EYE, DEFAULT_FOV, DEFAULT_METHOD, of_selection};
use super::error::{SceneError, ValueError, ValueProblem};
use super::{LightSpec, MAX_IMAGE_SIDE, Scene, SceneBuilder, SceneSpec};
use crate::camera::{Camera, CameraError};
use crate::light::{Light, LightError};
use crate::material::Material;
use crate::mesh::Mesh;
use glam::{DVec3, Vec2, Vec3};
use relief_core::{ByteSize, HeightMap};
use relief_io::{Convention, HeightOptions};
use relief_shaders::Selection;
use std::path::Path;

/// The memory that maps and picture may take when nothing else is said.
pub const DEFAULT_MAX_MEMORY: ByteSize = ByteSize(4 << 30);

/// Memory that rendering takes for a pixel: its results on the GPU, their copy, and the picture to be written.
const BYTES_PER_PIXEL: u64 = 192;

/// Memory that a texel of a height map takes while it is rendered: itself, and the exact tracer's hierarchy or what a GPU
/// holds of it.
const BYTES_PER_HEIGHT: u64 = 4 + 7;

/// Memory that a texel of a height map takes more where the search reads a baked map: that map, and what is at hand while
/// it is baked.
const BYTES_PER_BAKED: u64 = 16 + 5 * 4 + 6;

/// Memory that a texel of a normal map takes: as read, and as the shaders take it, of which reading sees the first part.
const NORMAL_BYTES: [u64; 2] = [12, 16];

/// The displacement between heights 0 and 1 when neither the scene nor the height map's file says anything, in metres.
const DEFAULT_SCALE_M: f64 = 0.05;

/// The largest length and coordinate in metres, a million kilometres. The shaders multiply four of them in `f32`: much
/// larger ones overflow there, and the picture would be empty without a word.
const MAX_METRES: f64 = 1e9;

/// The most tiles along an axis, and its inverse the fewest. Beyond it `f32` does not tell the texels of a tile apart, and
/// much farther it overflows.
const MAX_TILES: f32 = 1e6;

/// What of a description needs no file, completed and checked.
struct Parts {
    mesh: Mesh,
    camera: Camera,
    lights: Option<Vec<Light>>,
    material: Material,
    selection: Selection,
    /// Unless the height map's file is to say it.
    scale_m: Option<f64>,
    /// Minus the scale if none.
    bias_m: Option<f64>,
}

impl SceneSpec {
    /// Whether everything that needs no file is possible. A scene file is checked so before flags are laid over it.
    ///
    /// # Errors
    ///
    /// When a value is out of range, or keys are given that exclude or need each other.
    pub fn check(&self) -> Result<(), ValueError> {
        let parts = self.parts()?;
        // A map of one texel stands in for the file, so that the builder's own checks are made as well.
        let problem = |problem: relief_core::HeightMapError| ValueProblem::from(problem).of("height");
        let flat = HeightMap::new(1, 1, vec![0.0], self.wrap.unwrap_or_default()).map_err(problem)?;
        self.builder(parts, flat)?.build().map(drop)
    }

    /// Reads the files and completes the scene. Relative paths start at the current folder; those of a scene file were
    /// made to start at its own when it was read.
    ///
    /// # Errors
    ///
    /// When there is no height map, a value is out of range, a method is not available, a file cannot be read, or maps and
    /// picture need more than `max_memory`, which is found out before that memory is taken.
    pub fn load(&self) -> Result<Scene, SceneError> {
        let parts = self.parts()?;
        let height = self.height.as_ref().ok_or(SceneError::NoHeightMap)?;
        let mut left = self.memory_beside_the_picture()?;
        let options = HeightOptions {
            channel: self.channel.clone(),
            convention: if self.depth == Some(true) { Convention::Depth } else { Convention::Height },
            range: self.range,
            raw: self.raw,
            fill: self.fill.unwrap_or_default(),
            wrap: self.wrap.unwrap_or_default(),
            max_bytes: left,
        };
        let height_map = relief_io::read_height(height, &options)?;
        left = self.memory_beside_the_map(height, &height_map, &parts.selection, left)?;
        let mut builder = self.builder(parts, height_map)?;
        if let Some(path) = &self.color {
            let color = relief_io::read_picture(path, left)?;
            left = left.saturating_sub(16 * u64::from(color.width) * u64::from(color.height));
            builder = builder.color(color);
        }
        if let Some(path) = &self.normal {
            let [read, converted] = NORMAL_BYTES;
            let green = self.green.unwrap_or_default();
            builder = builder.normal_map(relief_io::read_normal_map(
                path,
                green,
                left / (read + converted) * read,
            )?);
        }
        Ok(builder.build()?)
    }

    /// What `max_memory` leaves for maps.
    fn memory_beside_the_picture(&self) -> Result<u64, SceneError> {
        let limit = self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY);
        let [width, height] = self.size.unwrap_or(super::builder::DEFAULT_SIZE);
        let pixels = u64::from(width) * u64::from(height);
        let needed = pixels.saturating_mul(BYTES_PER_PIXEL);
        limit.0.checked_sub(needed).ok_or(SceneError::TooMuchMemory { width, height, needed, limit })
    }

    /// What is left for colours and normals once there is room for a height map and what is built on it.
    fn memory_beside_the_map(
        &self,
        path: &Path,
        map: &HeightMap,
        selection: &Selection,
        left: u64,
    ) -> Result<u64, SceneError> {
        let (width, height) = (map.width(), map.height());
        let bytes = BYTES_PER_HEIGHT + BYTES_PER_BAKED * selection.map_needs().len() as u64;
        let needed = bytes * u64::from(width) * u64::from(height);
        left.checked_sub(needed).ok_or_else(|| {
            let limit = self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY);
            SceneError::TooMuchToTrace { path: path.to_owned(), width, height, needed, left, limit }
        })
    }

    fn parts(&self) -> Result<Parts, ValueError> {
        self.scale.map_or(Ok(()), check_scale)?;
        check_metres("bias", self.bias.as_slice())?;
        check_metres("eye", self.eye.as_ref().map_or(&[], |eye| eye))?;
        check_metres("target", self.target.as_ref().map_or(&[], |target| target))?;
        for position in self.lights.iter().flatten().filter_map(|light| light.position.as_ref()) {
            check_metres("lights", position)?;
        }
        if let Some([width, height]) = self.size
            && ![width, height].iter().all(|side| (1..=MAX_IMAGE_SIDE).contains(side))
        {
            return Err(ValueProblem::Size { width, height }.of("size"));
        }
        if let Some([low, high]) = self.range
            && !(low.is_finite() && high.is_finite() && low < high)
        {
            let (value, must) =
                if low.is_finite() { (high, "finite and above the first") } else { (low, "finite") };
            return Err(ValueProblem::Number { value, must }.of("range"));
        }
        let mesh =
            self.mesh.unwrap_or_default().build().map_err(|error| ValueProblem::from(error).of("mesh"))?;
        let mesh = match self.tile {
            Some(tile) => {
                let possible = 1.0 / MAX_TILES..=MAX_TILES;
                if let Some(&value) = tile.iter().find(|tiles| !possible.contains(tiles)) {
                    let must = "from 1e-6 to 1e6";
                    return Err(ValueProblem::Number { value: f64::from(value), must }.of("tile"));
                }
                mesh.tiled(Vec2::from(tile)).map_err(|error| ValueProblem::from(error).of("tile"))?
            }
            None => mesh,
        };
        Ok(Parts {
            mesh,
            camera: self.camera()?,
            lights: self.lights()?,
            material: self.material()?,
            selection: self.selection()?,
            scale_m: self.scale,
            bias_m: self.bias,
        })
    }

    fn builder(&self, parts: Parts, height_map: HeightMap) -> Result<SceneBuilder, ValueError> {
        let scale_m = parts.scale_m.or_else(|| stated_scale_m(&height_map, &parts.mesh));
        let scale_m = scale_m.unwrap_or(DEFAULT_SCALE_M);
        check_scale(scale_m)?;
        let height_map = height_map
            .with_displacement(scale_m, parts.bias_m.unwrap_or(-scale_m))
            .map_err(|error| ValueProblem::from(error).of("scale"))?;
        let mut builder = Scene::builder(height_map)
            .mesh(parts.mesh)
            .camera(parts.camera)
            .material(parts.material)
            .selection(parts.selection)
            .backend(self.backend.unwrap_or_default())
            .sampling(self.sampling.unwrap_or_default())
            .two_sided(self.two_sided.unwrap_or_default());
        if let Some(lights) = parts.lights {
            builder = builder.lights(lights);
        }
        if let Some(ambient) = self.ambient {
            builder = builder.ambient(ambient.into());
        }
        if let Some(background) = self.background {
            builder = builder.background(background.into());
        }
        if let Some([width, height]) = self.size {
            builder = builder.size(width, height);
        }
        Ok(builder)
    }

    fn camera(&self) -> Result<Camera, ValueError> {
        let eye = self.eye.map_or(DEFAULT_EYE, DVec3::from);
        let target = self.target.map_or(DVec3::ZERO, DVec3::from);
        Camera::new(eye, target, self.fov.unwrap_or(DEFAULT_FOV)).map_err(|error| {
            let key = match error {
                CameraError::BadFov(_) => "fov",
                _ if self.eye.is_some() => "eye",
                _ => "target",
            };
            ValueProblem::from(error).of(key)
        })
    }

    fn lights(&self) -> Result<Option<Vec<Light>>, ValueError> {
        match (self.light, &self.lights) {
            (Some(_), Some(_)) => Err(ValueProblem::Excludes("lights").of("light")),
            (Some(toward), None) => {
                let light = Light::directional(toward.into(), Vec3::ONE);
                Ok(Some(vec![light.map_err(|error| ValueProblem::from(error).of("light"))?]))
            }
            (None, Some(lights)) => {
                let lights: Result<Vec<Light>, ValueProblem> = lights.iter().map(LightSpec::light).collect();
                lights.map(Some).map_err(|problem| problem.of("lights"))
            }
            (None, None) => Ok(None),
        }
    }

    fn material(&self) -> Result<Material, ValueError> {
        let Some(spec) = &self.material else {
            return Ok(Material::default());
        };
        let default = Material::default();
        Material::new(
            spec.diffuse.map_or(default.diffuse(), Vec3::from),
            spec.specular.map_or(default.specular(), Vec3::from),
            spec.shininess.unwrap_or(default.shininess()),
        )
        .map_err(|error| ValueProblem::from(error).of("material"))
    }

    fn selection(&self) -> Result<Selection, ValueError> {
        let selection = match (&self.method, &self.search, &self.refine) {
            (method, None, None) => Selection::method(method.as_deref().unwrap_or(DEFAULT_METHOD)),
            (None, Some(search), Some(refine)) => Selection::pair(search, refine),
            (None, Some(_), None) => return Err(ValueProblem::Needs("refine").of("search")),
            (None, None, Some(_)) => return Err(ValueProblem::Needs("search").of("refine")),
            (Some(_), _, _) => return Err(ValueProblem::Excludes("search and refine").of("method")),
        };
        let mut selection = selection.map_err(of_selection)?;
        for (key, &value) in &self.set {
            selection.set(key, value).map_err(of_selection)?;
        }
        Ok(selection)
    }
}

fn check_scale(scale_m: f64) -> Result<(), ValueError> {
    if (0.0..=MAX_METRES).contains(&scale_m) {
        return Ok(());
    }
    Err(ValueProblem::Number { value: scale_m, must: "from 0 to 1e9 metres" }.of("scale"))
}

/// The displacement between heights 0 and 1 that gives the relief the proportions that the height map's file states: as deep to
/// a tile of the mesh as to one of its own.
fn stated_scale_m(map: &HeightMap, mesh: &Mesh) -> Option<f64> {
    let (tile_m, span_m) = map.stated_lengths_m()?;
    let [u, v] = mesh.tile_m();
    Some(span_m * (u / tile_m[0] * (v / tile_m[1])).sqrt())
}

/// Refuses lengths and coordinates that `f32` cannot reckon with.
fn check_metres(key: &'static str, lengths_m: &[f64]) -> Result<(), ValueError> {
    match lengths_m.iter().find(|length| !(-MAX_METRES..=MAX_METRES).contains(*length)) {
        Some(&value) => Err(ValueProblem::Number { value, must: "from -1e9 to 1e9 metres" }.of(key)),
        None => Ok(()),
    }
}

impl LightSpec {
    fn light(&self) -> Result<Light, ValueProblem> {
        let colour = Vec3::from(self.color.unwrap_or([1.0; 3]));
        let intensity = self.intensity.unwrap_or(1.0);
        if !(intensity >= 0.0 && intensity.is_finite()) {
            let must = "finite and not negative";
            return Err(ValueProblem::Number { value: f64::from(intensity), must });
        }
        let light = match (self.direction, self.position) {
            (Some(toward), None) => Light::directional(toward.into(), colour * intensity),
            (None, Some(position)) => Light::point(position.into(), colour * intensity),
            _ => Err(LightError::DirectionOrPosition),
        };
        Ok(light?)
    }
}
