//! What is to be compared, and whether it can be.

use relief_core::{ByteSize, HeightMap, Lanes, MapFormat};
use relief_scene::{BackendChoice, DEFAULT_MAX_MEMORY, Look, Sampling, Scene};
use relief_shaders::Choice;

use crate::contender::Contender;
use crate::error::CompareError;

/// Where pictures are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MachineBackend {
    /// The CPU.
    Cpu,
    /// A GPU, or a program that plays one where there is no other.
    Gpu,
}

/// Where pictures are made, and how textures are read there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// The backend.
    pub backend: MachineBackend,
    /// The sampling; `fast` is a GPU's.
    pub sampling: Sampling,
}

impl Machine {
    /// The CPU, which samples exactly.
    pub const CPU: Self = Self { backend: MachineBackend::Cpu, sampling: Sampling::Exact };

    /// A GPU that samples so.
    pub const fn gpu(sampling: Sampling) -> Self {
        Self { backend: MachineBackend::Gpu, sampling }
    }

    pub(crate) fn backend_choice(self) -> BackendChoice {
        match self.backend {
            MachineBackend::Cpu => BackendChoice::Cpu,
            MachineBackend::Gpu => BackendChoice::Gpu,
        }
    }

    /// The name of its backend.
    pub(crate) fn name(self) -> &'static str {
        self.backend_choice().name()
    }
}

/// A scene, and what is to be compared on it. [`new`](Self::new) gives what `relief compare` takes by itself.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The name of the height map, for tables.
    pub name: String,
    /// The scene, with its camera and light. What its surfaces select besides geometry, search and refinement
    /// all methods share; their methods are not used where another can be. Of several surfaces the pictures
    /// are compared, and neither rays nor hits, which belong to one map.
    pub scene: Scene,
    /// The methods.
    pub contenders: Vec<Contender>,
    /// Numbers of steps; methods that have none are compared once. None: as many as each has by itself.
    pub steps: Vec<u32>,
    /// How the values of baked maps are stored; methods that read none are compared once. None: as 32-bit
    /// floats.
    pub map_formats: Vec<MapFormat>,
    /// Shadows of pictures, as [`shadow`](crate::shadow) gives them. None: those of the scene.
    pub shadows: Vec<Choice>,
    /// Metres between the eye and the point that it looks at, along the view. None: the scene's own.
    pub distances_m: Vec<f64>,
    /// Degrees between rays and the normal, from 0 to below 90, where the surface is flat.
    pub angles_deg: Vec<f64>,
    /// Metres of displacement between heights 0 and 1. None: the scene's own.
    pub scales_m: Vec<f64>,
    /// Longer sides of the levels of the height map that are compared, in texels. None: as it is.
    pub map_sides: Vec<u32>,
    /// Rays of a method at an angle; 0 for pictures alone.
    pub rays: u32,
    /// Where pictures are made; none for rays alone.
    pub machines: Vec<Machine>,
    /// Samples of a pixel in frames that are taken for free of flicker; none: flicker is not measured.
    pub flicker_samples: Option<u32>,
    /// How frames are timed; none: they are not.
    pub timing: Option<Timing>,
    /// The look whose light and background the pictures to be shown have. They are rendered once more for it:
    /// errors are measured in the scene's own light. None: pictures are shown as they are compared.
    pub shown_look: Option<Look>,
    /// How many rays the CPU traces at once.
    pub lanes: Lanes,
    /// The most memory that rays and pictures may take besides the maps.
    pub max_memory: ByteSize,
}

/// Bytes of a ray with its path, its truth and a method's hit; of a pixel of a picture while it is compared,
/// in all its steps; and of one that is kept for the page.
const BYTES_PER_RAY: u64 = 512;
const BYTES_PER_PIXEL: u64 = 768;
const BYTES_PER_SHOWN_PIXEL: u64 = 16;

/// The most texels that a ray may cross on its way through the displacement: searches step through them.
const MOST_TEXELS: f64 = (1 << 18) as f64;

/// The deepest displacement, in longer sides of a tile.
const MOST_TILES: f64 = 1000.0;

/// How frames are timed. All methods take turns, so that what slows the machine for a while slows all of
/// them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// Frames of each that count.
    pub frames: u32,
    /// Turns before these that do not.
    pub warm: u32,
    /// How many times as many pixels as its pictures they have.
    pub pixels: u32,
}

/// The angles that are compared when nothing else is said.
const ANGLES_DEG: [f64; 4] = [10.0, 30.0, 60.0, 85.0];

/// Rays of a method at an angle when nothing else is said.
const RAYS: u32 = 20_000;

/// Samples of frames without flicker when nothing else is said.
const FLICKER_SAMPLES: u32 = 256;

/// Frames that are timed when nothing else is said, and how many times as many pixels these have.
const TIMED_FRAMES: u32 = 7;
const TIMED_PIXELS: u32 = 8;

impl Comparison {
    /// All methods on a scene, at its own scale: 20,000 rays at each of 10, 30, 60 and 85 degrees,
    /// pictures on the CPU beside frames of 256 samples, and the times of 7 frames of 8 times as many pixels.
    pub fn new(name: impl Into<String>, scene: Scene) -> Self {
        Self {
            name: name.into(),
            scene,
            contenders: Contender::all(),
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

    /// Whether all numbers are possible.
    ///
    /// # Errors
    ///
    /// When one is not, there is nothing to compare, or it takes more memory than it may.
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
            if surface.object().is_some() {
                return Err(CompareError::Object);
            }
            self.levels(surface.height_map())?;
        }
        let (needed, limit) = (self.bytes(levels)?, self.max_memory);
        if needed <= limit.0 { Ok(()) } else { Err(CompareError::TooMuchMemory { needed, limit }) }
    }

    /// Whether rays come through the displacement in a number of steps that ends.
    fn check_ways(&self) -> Result<(), CompareError> {
        for surface in self.scene.surfaces() {
            let (map, [u, v]) = (surface.height_map(), surface.metric().tile_m);
            let deepest = MOST_TILES * u.max(v);
            if let Some(&value) = self.scales_m.iter().find(|scale| **scale > deepest) {
                let must = "at most 1,000 times the longer side of a tile";
                return Err(CompareError::Value { what: "a scale", value, must });
            }
            // Of several surfaces no rays are compared.
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
                            the displacement, or that must be less deep";
                return Err(CompareError::Value { what: "an angle", value, must });
            }
        }
        Ok(())
    }

    /// What rays and pictures take, of so many levels of the map.
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

    /// The levels of the height map that are compared.
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

    /// The methods, each with each number of steps that it may take, each format of its maps and each shadow.
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
