//! Claims of the papers about the order of the methods, pair by pair, and whether they hold: a file a paper.

mod descent;
mod pyramidal;
mod slices;
mod survey;

use relief_compare::{Case, hits};
use relief_core::metrics::{ErrorReport, LATE_TEXELS};
use relief_core::{HeightMap, Hit, Lanes};
use relief_shaders::cpu::MethodTracer;
use relief_shaders::{Selection, SlotMaps};

use crate::accuracy::{ANGLES, Named, SCALE_M, case};
use crate::baked::{maps_for, slots};

pub use self::slices::{PictureClaim, PictureVerdict, picture_verdicts};

/// A method with settings, such as `occlusion search.steps=64`.
#[derive(Clone, Copy, Debug)]
pub struct Contender {
    /// Name of the method.
    pub method: &'static str,
    /// Settings on top of the method's own.
    pub settings: &'static [(&'static str, f64)],
}

/// Compared quantity. Smaller is better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Median distance to the true hit, in texels.
    Median,
    /// 99th percentile of the distance, in texels.
    Tail,
    /// Share of rays that miss or hit more than half a texel too late: the first hit was passed.
    Passed,
    /// Share of rays that miss, hit what is not there, or hit more than half a texel too late or too early.
    Off,
    /// Mean reads of a ray.
    Reads,
    /// Bytes of the baked maps that are read.
    MapBytes,
    /// Share of rays whose hit one more step of the refinement moves by more than half a texel.
    Unsettled,
}

/// A claim: at some angles `better` has less of something than a part of what `worse` has.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// The paper.
    pub paper: &'static str,
    /// Section or figure.
    pub section: &'static str,
    /// The claim in words.
    pub text: &'static str,
    /// The method said to be better.
    pub better: Contender,
    /// The method said to be worse.
    pub worse: Contender,
    /// The part of what the worse one has that the better one stays below.
    pub factor: f64,
    /// Metres of displacement on a tile of 1 m.
    pub scale_m: f64,
    /// By what.
    pub measure: Measure,
    /// Where, in degrees from the normal.
    pub angles: &'static [f64],
    /// Measured result: whether the mean over the maps bears the claim out. A claim that
    /// does not hold is recorded here, with its figures in the table, and not forgotten.
    pub holds: bool,
}

const fn plain(method: &'static str) -> Contender {
    Contender { method, settings: &[] }
}

/// The pyramid that is descended alone; it is no method, since it is wrong.
const DESCENT: &str = "a pyramid descended alone";

const fn with(method: &'static str, settings: &'static [(&'static str, f64)]) -> Contender {
    Contender { method, settings }
}

/// Where a claim does not say otherwise: it is about the order alone, at all angles, and holds.
const ORDER: Claim = Claim {
    paper: "",
    section: "",
    text: "",
    better: plain(""),
    worse: plain(""),
    factor: 1.0,
    scale_m: SCALE_M,
    measure: Measure::Median,
    angles: ALL,
    holds: true,
};

/// Metres of displacement that a tile of 1 m has as a rule, and of the deepest in the survey's pictures.
const NORMAL_M: f64 = 0.05;
const EXTREME_M: f64 = 0.3;

const STEEP: &[f64] = &[10.0, 30.0];
const GRAZING: &[f64] = &[85.0];
const ALL: &[f64] = &ANGLES;

/// A claim measured.
pub struct Verdict {
    /// The claim.
    pub claim: &'static Claim,
    /// Mean of the measure over maps and angles, of the method said to be better.
    pub better: f64,
    /// The same of the other.
    pub worse: f64,
}

impl Verdict {
    /// Whether what was measured bears the claim out.
    pub fn holds(&self) -> bool {
        self.better < self.claim.factor * self.worse
    }
}

impl Contender {
    /// Stages of the method.
    ///
    /// # Panics
    ///
    /// When the table above names what does not exist.
    pub fn selection(&self) -> Selection {
        let made = match self.method {
            // The pair that has no name of its own.
            "true-secant" => Selection::pair("linear", "true-secant"),
            method => Selection::method(method),
        };
        let mut selection = made.unwrap_or_else(|error| panic!("{error}"));
        for &(key, value) in self.settings {
            selection.set(key, value).unwrap_or_else(|error| panic!("{error}"));
        }
        selection
    }
}

impl Contender {
    /// Its stages with one more step of the refinement.
    fn with_another_step(&self) -> Selection {
        const STEPS: &str = "refine.steps";
        let set = self.settings.iter().find(|(key, _)| *key == STEPS);
        let (_, steps) = set.unwrap_or_else(|| panic!("{self}: its steps are not said"));
        let mut selection = self.selection();
        selection.set(STEPS, steps + 1.0).unwrap_or_else(|error| panic!("{error}"));
        selection
    }
}

impl std::fmt::Display for Contender {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.method)?;
        self.settings.iter().try_for_each(|(key, value)| write!(f, " {key}={value}"))
    }
}

impl Measure {
    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Measure::Median => "median texels",
            Measure::Tail => "p99 texels",
            Measure::Passed => "passed, share",
            Measure::Off => "off, share",
            Measure::Reads => "reads",
            Measure::MapBytes => "bytes of maps",
            Measure::Unsettled => "moved, share",
        }
    }

    fn of(self, report: &ErrorReport, map_bytes: u64) -> f64 {
        let passed = report.missed + report.late;
        match self {
            Measure::Median => report.distance_texels.median,
            Measure::Tail => report.distance_texels.p99,
            Measure::Passed => passed,
            Measure::Off => passed + report.early + report.false_hits,
            Measure::Reads => report.mean_reads,
            Measure::MapBytes => map_bytes as f64,
            Measure::Unsettled => f64::NAN,
        }
    }
}

/// All claims, paper by paper.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    survey::CLAIMS.iter().chain(pyramidal::CLAIMS)
}

/// What a contender has of a measure, added up over some cases.
fn total(contender: &Contender, measure: Measure, map: &HeightMap, cases: &[Case]) -> f64 {
    if contender.method == DESCENT {
        return cases.iter().map(|case| measure.of(&case.judge(&descent::hits(case)), 0)).sum();
    }
    let selection = contender.selection();
    let baked = maps_for(map, &selection);
    let bytes = baked.iter().map(|map| map.layout().bytes()).sum();
    let slots = slots(map, &selection, &baked);
    let traced = |selection: &Selection, slots: &SlotMaps, case: &Case| {
        hits(&MethodTracer::over(map, selection, *slots), &case.paths, Lanes::widest())
    };
    let of = |case: &Case| {
        let found = traced(&selection, &slots, case);
        if measure != Measure::Unsettled {
            return measure.of(&case.judge(&found), bytes);
        }
        moved(&found, &traced(&contender.with_another_step(), &slots, case), map)
    };
    cases.iter().map(of).sum()
}

/// The share of hits that are elsewhere, by more than half a texel, or are none.
fn moved(hits: &[Hit], others: &[Hit], map: &HeightMap) -> f64 {
    let texels = [map.width(), map.height()].map(f64::from);
    let is_elsewhere = |(a, b): &(&Hit, &Hit)| {
        let [u, v] = [0, 1].map(|axis| (a.uv[axis] - b.uv[axis]) * texels[axis]);
        a.found != b.found || (a.found && u.hypot(v) > LATE_TEXELS)
    };
    hits.iter().zip(others).filter(is_elsewhere).count() as f64 / hits.len().max(1) as f64
}

/// Measures every claim with that many rays a map and angle.
///
/// # Panics
///
/// When a map cannot be displaced so.
pub fn verdicts(maps: &[Named], rays: usize) -> Vec<Verdict> {
    let verdict = |claim: &'static Claim| {
        let mut sums = [0.0; 2];
        for Named { map, .. } in maps {
            let map = map.clone().with_displacement(claim.scale_m, -claim.scale_m).expect("a length");
            let cases: Vec<Case> = claim.angles.iter().map(|&degrees| case(&map, degrees, rays)).collect();
            for (sum, contender) in sums.iter_mut().zip([claim.better, claim.worse]) {
                *sum += total(&contender, claim.measure, &map, &cases);
            }
        }
        let [better, worse] = sums.map(|sum| sum / (maps.len() * claim.angles.len()) as f64);
        Verdict { claim, better, worse }
    };
    claims().map(verdict).collect()
}
