//! Settings of a comparison, and their checks.

use relief_core::{ByteSize, HeightMap, Lanes, MapFormat};
use relief_scene::{BackendChoice, DEFAULT_MAX_MEMORY, Look, Sampling, Scene};
use relief_shaders::Choice;
use relief_shaders::field::Solids;

use crate::contender::Contender;
use crate::error::CompareError;

/// Backend that renders pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MachineBackend {
    /// The CPU.
    Cpu,
    /// A GPU, or a software implementation if there is none.
    Gpu,
}

/// Backend and sampling of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// Backend.
    pub backend: MachineBackend,
    /// Sampling of textures; `fast` is only for GPUs.
    pub sampling: Sampling,
}

impl Machine {
    /// The CPU, which samples exactly.
    pub const CPU: Self = Self { backend: MachineBackend::Cpu, sampling: Sampling::Exact };

    /// Returns a GPU with the given sampling.
    pub const fn gpu(sampling: Sampling) -> Self {
        Self { backend: MachineBackend::Gpu, sampling }
    }

    pub(crate) fn backend_choice(self) -> BackendChoice {
        match self.backend {
            MachineBackend::Cpu => BackendChoice::Cpu,
            MachineBackend::Gpu => BackendChoice::Gpu,
        }
    }

    /// Returns the name of the backend.
    pub(crate) fn name(self) -> &'static str {
        self.backend_choice().name()
    }
}

/// Comparison of methods on a scene. [`new`](Self::new) sets the defaults of `relief compare`.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Name of the height map, for tables.
    pub name: String,
    /// Scene with camera and light. All methods share the selections of its surfaces other than
    /// geometry, search and refinement. A surface's own method is used only if a compared method
    /// cannot be. With several surfaces only pictures are compared, since rays and hits belong to
    /// one map.
    pub scene: Scene,
    /// Methods to compare.
    pub contenders: Vec<Contender>,
    /// Numbers of steps. Methods without steps are compared once. Empty: each method's default.
    pub steps: Vec<u32>,
    /// Formats of baked maps. Methods that read none are compared once. Empty: 32-bit floats.
    pub map_formats: Vec<MapFormat>,
    /// Shadows of pictures, from [`shadow`](crate::shadow). Empty: the scene's.
    pub shadows: Vec<Choice>,
    /// Distances of the camera from its target in metres, along the view. Empty: the scene's own.
    pub distances_m: Vec<f64>,
    /// Angles between rays and the normal in degrees, from 0 to below 90, for flat surfaces.
    pub angles_deg: Vec<f64>,
    /// Metres of displacement between heights 0 and 1. Empty: the scene's own.
    pub scales_m: Vec<f64>,
    /// Longer sides, in texels, of the height map's levels to compare. Empty: the finest level.
    pub map_sides: Vec<u32>,
    /// Number of rays per method and angle; 0 for pictures only.
    pub rays: u32,
    /// Machines that render pictures; empty for rays only.
    pub machines: Vec<Machine>,
    /// Samples per pixel of the frames that count as free of flicker; none if flicker is not
    /// measured.
    pub flicker_samples: Option<u32>,
    /// Timing of frames; none if they are not timed.
    pub timing: Option<Timing>,
    /// Look whose light and background the displayed pictures have. They are rendered again for it:
    /// errors are measured in the scene's own light. None: pictures are displayed as compared.
    pub shown_look: Option<Look>,
    /// SIMD width of the CPU: number of rays traced at once.
    pub lanes: Lanes,
    /// Memory limit for rays and pictures, not counting the maps.
    pub max_memory: ByteSize,
}

/// Bytes of a ray with its path, its true hit and a method's hit; bytes of a picture's pixel during
/// the whole comparison; and bytes of a pixel that is stored for the page.
const BYTES_PER_RAY: u64 = 512;
const BYTES_PER_PIXEL: u64 = 768;
const BYTES_PER_SHOWN_PIXEL: u64 = 16;

/// Greatest number of texels that a ray may cross on its way through the displacement, since
/// searches step through them.
const MOST_TEXELS: f64 = (1 << 18) as f64;

/// Greatest displacement, in longer sides of a tile.
const MOST_TILES: f64 = 1000.0;

/// Timing of frames. All methods take turns, so that a temporary slowdown of the machine affects
/// all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// Number of frames of each method that count.
    pub frames: u32,
    /// Number of turns before them that do not count.
    pub warm: u32,
    /// Number of pixels of a timed frame, as a multiple of a picture's.
    pub pixels: u32,
}

/// Default angles.
const ANGLES_DEG: [f64; 4] = [10.0, 30.0, 60.0, 85.0];

/// Default number of rays per method and angle.
const RAYS: u32 = 20_000;

/// Default samples of frames without flicker.
const FLICKER_SAMPLES: u32 = 256;

/// Default number of timed frames, and default multiple of their pixels.
const TIMED_FRAMES: u32 = 7;
const TIMED_PIXELS: u32 = 8;

impl Comparison {
    /// Creates a comparison of the [usual](Contender::usual) methods on a scene, with the defaults
    /// of `relief compare`.
    ///
    /// `name` is the height map's name, for tables. Displacement and camera are the scene's own.
    ///
    /// By default 20,000 rays are compared at each of 10, 30, 60 and 85 degrees from the surface's
    /// normal. Pictures are rendered on the CPU. For flicker they are compared with frames of 256
    /// samples per pixel. 7 frames of each method are timed, with 8 times the pixels of a picture.
    pub fn new(name: impl Into<String>, scene: Scene) -> Self {
        Self {
            name: name.into(),
            scene,
            contenders: Contender::usual(),
            steps: Vec::new(),
            map_formats: Vec::new(),
            shadows: Vec::new(),
            distances_m: Vec::new(),
            angles_deg: ANGLES_DEG.to_vec(),
            scales_m: Vec::new(),
            map_sides: Vec::new(),
            rays: RAYS,
            machines: vec![Machine::CPU],
            shown_look: None,
            flicker_samples: Some(FLICKER_SAMPLES),
            timing: Some(Timing { frames: TIMED_FRAMES, warm: 1, pixels: TIMED_PIXELS }),
            lanes: Lanes::widest(),
            max_memory: DEFAULT_MAX_MEMORY,
        }
    }

    /// Checks that all numbers are possible.
    ///
    /// # Errors
    ///
    /// When a number is not possible, there is nothing to compare, or memory exceeds its limit.
    pub fn check(&self) -> Result<(), CompareError> {
        if self.contenders.is_empty() {
            return Err(CompareError::Nothing("methods"));
        }
        if self.rays == 0 && self.machines.is_empty() {
            return Err(CompareError::Nothing("rays and no pictures"));
        }
        if let Some(Timing { frames, pixels, .. }) = self.timing {
            for (what, value) in
                [("the number of timed frames", frames), ("the factor on their pixels", pixels)]
            {
                if value == 0 {
                    return Err(CompareError::Value { what, value: 0.0, must: "above 0" });
                }
            }
        }
        for &value in &self.angles_deg {
            if !(0.0..90.0).contains(&value) {
                let must = "from 0 to below 90 degrees";
                return Err(CompareError::Value { what: "an angle", value, must });
            }
        }
        for (what, values) in [("a scale", &self.scales_m), ("a distance", &self.distances_m)] {
            for &value in values {
                if !(value > 0.0 && value.is_finite()) {
                    return Err(CompareError::Value { what, value, must: "above 0 m" });
                }
            }
        }
        self.check_ways()?;
        if self.scene.camera().is_orthographic() && !self.distances_m.is_empty() {
            return Err(CompareError::Orthographic);
        }
        let levels = self.map_sides.len().max(1);
        for surface in self.scene.surfaces() {
            if surface.solids() != Solids::Heights {
                return Err(CompareError::Solid(surface.solids().in_words()));
            }
            if surface.object().is_some() {
                return Err(CompareError::Object);
            }
            self.levels(surface.height_map())?;
        }
        let (needed, limit) = (self.bytes(levels)?, self.max_memory);
        if needed <= limit.0 { Ok(()) } else { Err(CompareError::TooMuchMemory { needed, limit }) }
    }

    /// Checks that rays cross the displacement in a limited number of steps.
    fn check_ways(&self) -> Result<(), CompareError> {
        for surface in self.scene.surfaces() {
            let (map, [u, v]) = (surface.height_map(), surface.metric().tile_m);
            let deepest = MOST_TILES * u.max(v);
            if let Some(&value) = self.scales_m.iter().find(|scale| **scale > deepest) {
                let must = "at most 1,000 times the longer side of a tile";
                return Err(CompareError::Value { what: "a scale", value, must });
            }
            // With several surfaces no rays are compared.
            if self.rays == 0 || self.scene.surfaces().len() > 1 {
                continue;
            }
            let texel_m = (u / f64::from(map.width())).min(v / f64::from(map.height()));
            let own = [map.scale_m()];
            let scales: &[f64] = if self.scales_m.is_empty() { &own } else { &self.scales_m };
            let deepest = scales.iter().fold(0.0f64, |most, scale| most.max(scale.abs()));
            let is_too_long = |angle: &&f64| deepest * angle.to_radians().tan() > MOST_TEXELS * texel_m;
            if let Some(&value) = self.angles_deg.iter().find(is_too_long) {
                let must = "so small that a ray crosses at most 262,144 texels of the map on its way through \
                            the displacement; or make the displacement less deep";
                return Err(CompareError::Value { what: "an angle", value, must });
            }
        }
        Ok(())
    }

    /// Bytes for rays and pictures, with the given number of levels of the map.
    fn bytes(&self, levels: usize) -> Result<u64, CompareError> {
        let rays = u64::from(self.rays).saturating_mul(self.angles_deg.len() as u64);
        let pixels = self.scene.size().map(u64::from).iter().product::<u64>();
        let seen = levels * self.scales_m.len().max(1) * self.distances_m.len().max(1);
        let truths = self.shadows.len().max(1) as u64;
        let shown = (self.entrants()?.len() * seen * self.machines.len()) as u64 + seen as u64 * truths;
        let of_truths = BYTES_PER_PIXEL.saturating_mul(truths);
        let of_pixel = of_truths.saturating_add(BYTES_PER_SHOWN_PIXEL.saturating_mul(shown));
        let pictures = if self.machines.is_empty() { 0 } else { pixels.saturating_mul(of_pixel) };
        Ok(rays.saturating_mul(BYTES_PER_RAY).saturating_add(pictures))
    }

    /// Levels of the height map to compare.
    pub(crate) fn levels(&self, map: &HeightMap) -> Result<Vec<u32>, CompareError> {
        if self.map_sides.is_empty() {
            return Ok(vec![0]);
        }
        let sides: Vec<u32> = (0..map.levels())
            .map(|level| {
                let level = map.level(level);
                level.width().max(level.height())
            })
            .collect();
        let of = |&side: &u32| {
            let level = sides.iter().position(|known| *known == side);
            let size = [map.width(), map.height()];
            level.map(|level| level as u32).ok_or(CompareError::NoLevel { side, size, sides: sides.clone() })
        };
        self.map_sides.iter().map(of).collect()
    }

    /// Methods with every possible number of steps, format of maps and shadow.
    pub(crate) fn entrants(&self) -> Result<Vec<Contender>, CompareError> {
        let mut entrants = Vec::new();
        for contender in &self.contenders {
            let mut stepped = Vec::new();
            for &steps in &self.steps {
                stepped.extend(contender.with_steps(steps)?);
            }
            if stepped.is_empty() {
                stepped.push(contender.clone());
            }
            let shadowed = stepped.iter().flat_map(|contender| self.with_each_shadow(contender));
            entrants.extend(shadowed.flat_map(|contender| self.with_each_format(contender)));
        }
        Ok(entrants)
    }

    fn with_each_shadow(&self, contender: &Contender) -> Vec<Contender> {
        if self.shadows.is_empty() {
            return vec![contender.clone()];
        }
        self.shadows.iter().map(|&shadow| contender.with_shadow(shadow)).collect()
    }

    fn with_each_format(&self, contender: Contender) -> Vec<Contender> {
        let each = self.map_formats.iter().filter_map(|&format| contender.with_map_format(format));
        let each: Vec<Contender> = each.collect();
        if each.is_empty() { vec![contender] } else { each }
    }
}
