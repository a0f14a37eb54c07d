//! Figures of a comparison, the same for programs, tables and pages.

use relief_core::metrics::{CostReport, CostSpread, ErrorReport};
use serde::{Deserialize, Serialize};

use crate::contender::labelled;
use crate::spread::SURE;

/// All figures of a comparison.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Records {
    /// Description of the comparison.
    pub about: About,
    /// Results of methods along rays at given angles.
    pub rays: Vec<RayRecord>,
    /// Results of methods in pictures.
    pub pictures: Vec<PictureRecord>,
    /// Methods and figures that could not be compared.
    pub left_out: Vec<LeftOut>,
}

/// Description of a comparison.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// Name of the height map; of the first one if there are several surfaces.
    pub map: String,
    /// Columns and rows of that map.
    pub map_size: [u32; 2],
    /// Size of a tile along `u` and `v` in metres.
    pub tile_m: [f64; 2],
    /// Number of surfaces in the scene.
    pub surfaces: usize,
    /// Program with its version.
    pub program: String,
    /// Command that made the comparison; empty if a program did.
    pub command: String,
    /// Backends that were used, with their devices.
    pub machines: Vec<MachineRecord>,
    /// Description of the reference pictures in words.
    pub reference: String,
}

/// Backend with its device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MachineRecord {
    /// `cpu` or `gpu`.
    pub backend: String,
    /// `exact` or `fast`.
    pub sampling: String,
    /// Number of threads, or adapter with its driver; or the reason why there is none.
    pub device: String,
}

/// Method with its settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodRecord {
    /// Name of the method.
    pub method: String,
    /// Number of steps, if methods are compared by steps.
    pub steps: Option<u32>,
    /// Parameter of the number of steps.
    pub steps_key: Option<String>,
    /// Format of its baked maps, if methods are compared by format. None: 32-bit floats.
    pub map_format: Option<String>,
    /// Shadow, if pictures are compared by shadow.
    pub shadow: Option<String>,
    /// Variant of the stage `geometry`.
    pub geometry: String,
    /// Variant of the stage `search`.
    pub search: String,
    /// Variant of the stage `refine`.
    pub refine: String,
    /// Guarantee for view rays.
    pub promise: String,
    /// Columns and rows of the height map; of the first one if there are several surfaces.
    pub map_size: [u32; 2],
    /// Number of texels of all height maps.
    pub map_texels: u64,
    /// Metres between heights 0 and 1; of the first map if there are several surfaces.
    pub scale_m: f64,
    /// Bytes of the baked maps that the method reads besides the heights.
    pub map_bytes: u64,
    /// Seconds for baking these maps; 0 if it reads none.
    pub bake_seconds: f64,
}

/// Results of a method along rays at an angle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RayRecord {
    /// Method with its settings.
    #[serde(flatten)]
    pub method: MethodRecord,
    /// Angle between ray and normal in degrees.
    pub angle_deg: f64,
    /// Errors of the hits.
    #[serde(flatten)]
    pub error: ErrorRecord,
    /// Cost of the rays.
    #[serde(flatten)]
    pub cost: CostRecord,
}

/// Results of a method in a picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PictureRecord {
    /// Method with its settings.
    #[serde(flatten)]
    pub method: MethodRecord,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// `exact` or `fast`.
    pub sampling: String,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// Samples per pixel.
    pub samples: u32,
    /// Metres between the camera and its target, if distances are compared.
    pub distance_m: Option<f64>,
    /// Mean FLIP difference from the reference.
    pub flip: f64,
    /// Structural similarity to the reference.
    pub ssim: f64,
    /// Peak signal-to-noise ratio in decibels; none if the pictures are equal.
    pub psnr_db: Option<f64>,
    /// Root mean square error of the linear colours.
    pub rms: f64,
    /// Root mean square difference between two frames a tenth of a pixel apart, less the difference
    /// between the reference's, which have many samples a pixel.
    pub flicker_rms: Option<f64>,
    /// Mean FLIP between the same two frames, less the FLIP between the reference's.
    pub flicker_flip: Option<f64>,
    /// Errors of the hits at the pixels' centres; none if several surfaces hide each other.
    #[serde(flatten)]
    pub error: Option<ErrorRecord>,
    /// Cost of the hits on the surface. None for displaced triangles, which are not searched, and
    /// for the exact method on the CPU, which has its own tracer.
    #[serde(flatten)]
    pub cost: Option<CostRecord>,
    /// Mean over tiles of 8 x 4 pixels of the greatest number of reads in the tile, for which a
    /// GPU's wave waits.
    pub wave_reads: Option<f64>,
    /// Times of frames, if they were measured.
    #[serde(flatten)]
    pub times: Option<TimeRecord>,
}

/// Times of frames with one sample per pixel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TimeRecord {
    /// Clock: the machine's clock around whole frames, and the GPU's for passes.
    pub clock: String,
    /// Columns and rows of the timed frames.
    pub timed_size: [u32; 2],
    /// Median time of a whole frame in milliseconds. The true median lies in the following interval
    /// with [`confidence`](Self::confidence).
    pub frame_ms: f64,
    /// Lower end of the interval of `frame_ms`.
    pub frame_low_ms: f64,
    /// Upper end of the interval of `frame_ms`.
    pub frame_high_ms: f64,
    /// Milliseconds for finding the surface: the extra time over bump mapping, both without
    /// shadows. With a GPU's clock it is the time of the tracing pass (and the times of lighting
    /// and shadows are of the shading pass); otherwise of the whole frame.
    pub displacement_ms: f64,
    /// Lower end of the interval of `displacement_ms`.
    pub displacement_low_ms: f64,
    /// Upper end of the interval of `displacement_ms`.
    pub displacement_high_ms: f64,
    /// Milliseconds of bump mapping without light.
    pub base_ms: f64,
    /// Milliseconds of lighting for bump mapping.
    pub shade_ms: f64,
    /// Milliseconds of shadows; 0 if there are none.
    pub shadow_ms: f64,
    /// Milliseconds of the pass that rasterises and traces, by the GPU's own clock.
    pub trace_pass_ms: Option<f64>,
    /// Milliseconds of the pass that shades, by the GPU's own clock.
    pub shade_pass_ms: Option<f64>,
    /// Least probability that a true median lies in its interval: 0.95 from six frames on. With
    /// fewer frames the ends are the least and the greatest time measured.
    #[serde(default)]
    pub confidence: f64,
    /// Keys of differences that may be 0: the lower ends of their intervals are not above it.
    #[serde(default)]
    pub below_noise: Vec<String>,
}

impl TimeRecord {
    /// Whether true medians lie in their intervals in at least 95 of 100 cases.
    pub fn is_sure(&self) -> bool {
        self.confidence >= SURE
    }
}

/// Errors of hits; shares are from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ErrorRecord {
    /// Number of rays that were compared.
    pub rays: usize,
    /// Share of rays that passed the true hit: missed, or hit more than half a texel behind it.
    pub passed: f64,
    /// Share of rays that should hit, but were reported as misses.
    pub missed: f64,
    /// Share of rays that should miss, but were reported as hits.
    pub false_hits: f64,
    /// Share of hits more than half a texel behind the true one.
    pub late: f64,
    /// Share of hits more than half a texel before the true one.
    pub early: f64,
    /// Share of rays that ran out of steps; they are judged by the last point that they reached.
    pub exhausted: f64,
    /// Mean distance from the true hit in texels.
    pub mean_texels: f64,
    /// Median distance in texels.
    pub median_texels: f64,
    /// 99th percentile of the distance in texels.
    pub p99_texels: f64,
    /// Greatest distance in texels.
    pub max_texels: f64,
    /// 99th percentile of the difference in depth, in metres.
    pub p99_depth_m: f64,
}

/// Cost of rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CostRecord {
    /// Mean number of reads per ray.
    pub reads: f64,
    /// 99th percentile of the reads.
    pub p99_reads: f64,
    /// Mean number of steps of search and refinement per ray.
    pub turns: f64,
    /// Mean number of bytes that a ray's reads fetch.
    pub bytes: f64,
}

/// Method or figure that could not be compared.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Label of the method, or name of the figure.
    pub what: String,
    /// Reason.
    pub reason: String,
}

impl From<&ErrorReport> for ErrorRecord {
    fn from(report: &ErrorReport) -> Self {
        let ErrorReport { rays, missed, false_hits, late, early, exhausted, distance_texels, depth, .. } =
            *report;
        Self {
            rays,
            passed: missed + late,
            missed,
            false_hits,
            late,
            early,
            exhausted,
            mean_texels: distance_texels.mean,
            median_texels: distance_texels.median,
            p99_texels: distance_texels.p99,
            max_texels: distance_texels.max,
            p99_depth_m: depth.p99,
        }
    }
}

impl From<&CostReport> for CostRecord {
    fn from(report: &CostReport) -> Self {
        let CostSpread { mean: reads, p99: p99_reads, .. } = report.reads;
        Self { reads, p99_reads, turns: report.steps.mean, bytes: report.bytes.mean }
    }
}

impl MethodRecord {
    /// Returns the name with the settings by which it is compared: steps, format of maps, shadow.
    pub fn label(&self) -> String {
        labelled(&self.method, self.steps, self.map_format.as_deref(), self.shadow.as_deref())
    }

    /// Returns the label without the shadow, which does not affect view rays.
    pub fn label_of_rays(&self) -> String {
        labelled(&self.method, self.steps, self.map_format.as_deref(), None)
    }

    /// Returns the bytes of baked maps per texel of the height maps.
    pub fn bytes_a_texel(&self) -> f64 {
        self.map_bytes as f64 / self.map_texels as f64
    }
}
