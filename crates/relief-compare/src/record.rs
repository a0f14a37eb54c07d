//! What a comparison finds, as numbers: the same for programs, tables and pages.

use relief_core::metrics::{CostReport, CostSpread, ErrorReport};
use serde::{Deserialize, Serialize};

use crate::contender::labelled;
use crate::spread::SURE;

/// What a comparison finds.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Records {
    /// What was compared, and how.
    pub about: About,
    /// Methods along rays at given angles.
    pub rays: Vec<RayRecord>,
    /// Methods in pictures.
    pub pictures: Vec<PictureRecord>,
    /// What could not be compared.
    pub left_out: Vec<LeftOut>,
}

/// What was compared, and how.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// The map's name; of several surfaces the first one's.
    pub map: String,
    /// Columns and rows of that map.
    pub map_size: [u32; 2],
    /// Metres of a tile along `u` and `v`.
    pub tile_m: [f64; 2],
    /// How many surfaces the scene has.
    pub surfaces: usize,
    /// The program and its version.
    pub program: String,
    /// The command that made it; empty where a program did.
    pub command: String,
    /// What computed it: of each backend what it is.
    pub machines: Vec<MachineRecord>,
    /// What a reference picture is, in words.
    pub reference: String,
}

/// A backend and what it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MachineRecord {
    /// `cpu` or `gpu`.
    pub backend: String,
    /// `exact` or `fast`.
    pub sampling: String,
    /// The number of threads, or the adapter and its driver; or why there is none.
    pub device: String,
}

/// A method, as records name it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodRecord {
    /// Its name.
    pub method: String,
    /// How many steps it takes, where it is compared over these.
    pub steps: Option<u32>,
    /// The parameter that says so.
    pub steps_key: Option<String>,
    /// How the values of its baked maps are stored, where it is compared over that; else as 32-bit floats.
    pub map_format: Option<String>,
    /// Its shadow, where pictures are compared over these.
    pub shadow: Option<String>,
    /// The variant of each stage that finds hits.
    pub geometry: String,
    /// The search.
    pub search: String,
    /// The refinement.
    pub refine: String,
    /// What it promises for view rays.
    pub promise: String,
    /// Columns and rows of the height map; of several surfaces the first one's.
    pub map_size: [u32; 2],
    /// Texels of all height maps.
    pub map_texels: u64,
    /// Metres between heights 0 and 1; of several surfaces the first one's.
    pub scale_m: f64,
    /// Bytes of the baked maps that it reads besides the heights.
    pub map_bytes: u64,
    /// Seconds that baking these took; 0 where it reads none.
    pub bake_seconds: f64,
}

/// A method along rays at an angle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RayRecord {
    /// The method.
    #[serde(flatten)]
    pub method: MethodRecord,
    /// Degrees between ray and normal.
    pub angle_deg: f64,
    /// How wrong it is.
    #[serde(flatten)]
    pub error: ErrorRecord,
    /// What it costs.
    #[serde(flatten)]
    pub cost: CostRecord,
}

/// A method in a picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PictureRecord {
    /// The method.
    #[serde(flatten)]
    pub method: MethodRecord,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// `exact` or `fast`.
    pub sampling: String,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// Samples of a pixel.
    pub samples: u32,
    /// Metres between the eye and the point that it looks at, where these are compared.
    pub distance_m: Option<f64>,
    /// Mean FLIP to the reference.
    pub flip: f64,
    /// Structural similarity to the reference.
    pub ssim: f64,
    /// Peak signal to noise ratio in decibels; none where the pictures are the same.
    pub psnr_db: Option<f64>,
    /// Root of the mean squared error of the linear colours.
    pub rms: f64,
    /// The same between two frames a tenth of a pixel apart, less that of many samples a pixel.
    pub flicker_rms: Option<f64>,
    /// Mean FLIP between these, less that of many samples a pixel.
    pub flicker_flip: Option<f64>,
    /// How wrong the hits of its pixels' centres are; nothing where several surfaces hide each other.
    #[serde(flatten)]
    pub error: Option<ErrorRecord>,
    /// What these cost where the surface is; nothing of displaced triangles, which are not searched, and of
    /// the exact method on the CPU, where a tracer of its own answers.
    #[serde(flatten)]
    pub cost: Option<CostRecord>,
    /// Mean of the greatest number of reads in tiles of 8 x 4 pixels, for which a GPU's wave waits.
    pub wave_reads: Option<f64>,
    /// How long frames take, where that was measured.
    #[serde(flatten)]
    pub times: Option<TimeRecord>,
}

/// How long frames of one sample a pixel take.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TimeRecord {
    /// What told the time: the machine's clock around whole frames, and of passes the GPU's.
    pub clock: String,
    /// Columns and rows of the frames.
    pub timed_size: [u32; 2],
    /// Milliseconds of a whole frame: the median, and what the true median lies between, with that
    /// [`confidence`](Self::confidence).
    pub frame_ms: f64,
    /// Its lower end.
    pub frame_low_ms: f64,
    /// Its upper end.
    pub frame_high_ms: f64,
    /// Milliseconds that finding the surface takes: more than bump mapping without shadows does. By a GPU's
    /// clock, where it has one, of the pass that traces, as those of lighting and of shadows are of the pass
    /// that shades; else of the whole frame.
    pub displacement_ms: f64,
    /// Its lower end.
    pub displacement_low_ms: f64,
    /// Its upper end.
    pub displacement_high_ms: f64,
    /// Milliseconds of bump mapping without light.
    pub base_ms: f64,
    /// Milliseconds of lighting that.
    pub shade_ms: f64,
    /// Milliseconds of shadows; 0 where there are none.
    pub shadow_ms: f64,
    /// Milliseconds of the pass that rasterises and traces, by a GPU's own clock.
    pub trace_pass_ms: Option<f64>,
    /// Milliseconds of the pass that shades.
    pub shade_pass_ms: Option<f64>,
    /// In what part of all cases a true median lies between its ends, at least: 0.95 from six frames on. Of
    /// fewer the ends are the least and the greatest that was seen.
    #[serde(default)]
    pub confidence: f64,
    /// The keys of differences that may be 0 for all that is known: their lower ends are not above it.
    #[serde(default)]
    pub below_noise: Vec<String>,
}

impl TimeRecord {
    /// Whether the true medians lie between their ends in 95 of 100 cases.
    pub fn is_sure(&self) -> bool {
        self.confidence >= SURE
    }
}

/// How wrong hits are; shares are from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ErrorRecord {
    /// Rays that were compared.
    pub rays: usize,
    /// Share that passed the first hit: missed, or hit more than half a texel behind it.
    pub passed: f64,
    /// Share that was given as a miss and truly hits.
    pub missed: f64,
    /// Share that was given as a hit and truly misses.
    pub false_hits: f64,
    /// Share of hits more than half a texel behind the true one.
    pub late: f64,
    /// Share of hits more than half a texel before the true one.
    pub early: f64,
    /// Share that ran out of steps; they are judged by the last point that they reached.
    pub exhausted: f64,
    /// Distance from the true hit in texels: mean.
    pub mean_texels: f64,
    /// Median.
    pub median_texels: f64,
    /// 99th percentile.
    pub p99_texels: f64,
    /// Greatest.
    pub max_texels: f64,
    /// Difference of the depth in metres: 99th percentile.
    pub p99_depth_m: f64,
}

/// What rays cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CostRecord {
    /// Mean reads of a ray.
    pub reads: f64,
    /// 99th percentile.
    pub p99_reads: f64,
    /// Mean turns of loops.
    pub turns: f64,
    /// Mean bytes that reads fetch.
    pub bytes: f64,
}

/// What could not be compared.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOut {
    /// The method, or what else.
    pub what: String,
    /// Why.
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
    /// The name, with what it is compared over: steps, the format of its maps, its shadow.
    pub fn label(&self) -> String {
        labelled(&self.method, self.steps, self.map_format.as_deref(), self.shadow.as_deref())
    }

    /// The same without the shadow, of which rays of the view know nothing.
    pub fn label_of_rays(&self) -> String {
        labelled(&self.method, self.steps, self.map_format.as_deref(), None)
    }

    /// Bytes of baked maps for a texel of the height maps.
    pub fn bytes_a_texel(&self) -> f64 {
        self.map_bytes as f64 / self.map_texels as f64
    }
}
