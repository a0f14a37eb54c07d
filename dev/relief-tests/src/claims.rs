//! What the survey's section 4 says about the order of the methods, pair by pair, and whether it holds.

use relief_core::metrics::ErrorReport;
use relief_shaders::Selection;

use crate::accuracy::{ANGLES, Named, case, report};

/// A method with settings, such as `occlusion search.steps=64`.
#[derive(Clone, Copy, Debug)]
pub struct Contender {
    /// Name of the method.
    pub method: &'static str,
    /// Settings on top of the method's own.
    pub settings: &'static [(&'static str, f64)],
}

/// What is compared. Smaller is better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Median distance to the true hit, in texels.
    Median,
    /// 99th percentile of the distance, in texels.
    Tail,
    /// Share of rays that miss or hit more than half a texel too late: the first hit was passed.
    Passed,
}

/// A claim: at some angles `better` is nearer the truth than `worse`.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// Section of the survey.
    pub section: &'static str,
    /// The claim in words.
    pub text: &'static str,
    /// The method said to be better.
    pub better: Contender,
    /// The method said to be worse.
    pub worse: Contender,
    /// By what.
    pub measure: Measure,
    /// Where, in degrees from the normal.
    pub angles: &'static [f64],
    /// What was found when it was measured: whether the mean over the maps bears the claim out. A claim that
    /// does not hold is recorded here, with its figures in the table, and not forgotten.
    pub holds: bool,
}

const fn plain(method: &'static str) -> Contender {
    Contender { method, settings: &[] }
}

const fn with(method: &'static str, settings: &'static [(&'static str, f64)]) -> Contender {
    Contender { method, settings }
}

const STEEP: &[f64] = &[10.0, 30.0];
const GRAZING: &[f64] = &[85.0];
const ALL: &[f64] = &ANGLES;

/// The claims.
pub const CLAIMS: &[Claim] = &[
    Claim {
        section: "4.1.2",
        text: "parallax mapping is nearer than bump mapping away from grazing angles",
        better: plain("parallax"),
        worse: plain("bump"),
        measure: Measure::Median,
        angles: STEEP,
        holds: true,
    },
    Claim {
        section: "4.1.3",
        text: "offset limiting reduces the error of parallax mapping at grazing angles",
        better: plain("parallax-limited"),
        worse: plain("parallax"),
        measure: Measure::Median,
        angles: GRAZING,
        holds: false,
    },
    Claim {
        section: "4.1.3",
        text: "offset limiting keeps the worst offsets of parallax mapping at grazing angles small",
        better: plain("parallax-limited"),
        worse: plain("parallax"),
        measure: Measure::Tail,
        angles: GRAZING,
        holds: true,
    },
    Claim {
        section: "4.1.4",
        text: "the slope gives much better results than the offset with limiting",
        better: plain("parallax-slope"),
        worse: plain("parallax-limited"),
        measure: Measure::Median,
        angles: ALL,
        holds: false,
    },
    Claim {
        section: "4.1.4",
        text: "dividing by N·V, the slope gives better results than the offset away from grazing angles",
        better: with("parallax-slope", &[("refine.divide", 1.0)]),
        worse: plain("parallax"),
        measure: Measure::Median,
        angles: STEEP,
        holds: true,
    },
    Claim {
        section: "4.2.1",
        text: "iterating the slope correction significantly improves on doing it once",
        better: plain("parallax-iterative"),
        worse: plain("parallax-slope"),
        measure: Measure::Median,
        angles: ALL,
        holds: true,
    },
    Claim {
        section: "4.2.2",
        text: "binary search over the whole path may pass the first hit, which linear search guards against",
        better: plain("relief"),
        worse: plain("binary-search"),
        measure: Measure::Passed,
        angles: ALL,
        holds: true,
    },
    Claim {
        section: "4.2.3",
        text: "the true secant method converges faster than false position, in brackets of 32 linear steps",
        better: with("true-secant", &[("refine.steps", 4.0)]),
        worse: with("occlusion", &[("refine.steps", 4.0)]),
        measure: Measure::Median,
        angles: ALL,
        holds: false,
    },
    Claim {
        section: "4.3.1",
        text: "finer linear steps miss less",
        better: with("relief", &[("search.steps", 128.0)]),
        worse: with("relief", &[("search.steps", 32.0)]),
        measure: Measure::Passed,
        angles: ALL,
        holds: true,
    },
    Claim {
        section: "4.3.1",
        text: "more steps at oblique angles are worth it",
        better: with("occlusion", &[("search.grazing", 4.0)]),
        worse: plain("occlusion"),
        measure: Measure::Passed,
        angles: GRAZING,
        holds: true,
    },
    Claim {
        section: "4.3.1",
        text: "one secant step removes the stair-steps of linear search",
        better: with("occlusion", &[("refine.steps", 1.0)]),
        worse: plain("steep"),
        measure: Measure::Median,
        angles: ALL,
        holds: true,
    },
    Claim {
        section: "4.4",
        text: "a linear search makes the secant method find the first hit",
        better: plain("occlusion"),
        worse: plain("secant-search"),
        measure: Measure::Passed,
        angles: ALL,
        holds: true,
    },
    Claim {
        section: "4.4.2",
        text: "two secant steps come nearer than two halvings",
        better: with("occlusion", &[("refine.steps", 2.0)]),
        worse: with("relief", &[("refine.steps", 2.0)]),
        measure: Measure::Median,
        angles: ALL,
        holds: true,
    },
];

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
        self.better < self.worse
    }
}

impl Contender {
    /// Its stages.
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

impl std::fmt::Display for Contender {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.method)?;
        self.settings.iter().try_for_each(|(key, value)| write!(f, " {key}={value}"))
    }
}

fn measured(measure: Measure, report: &ErrorReport) -> f64 {
    match measure {
        Measure::Median => report.distance_texels.median,
        Measure::Tail => report.distance_texels.p99,
        Measure::Passed => report.missed + report.late,
    }
}

/// Measures every claim with that many rays a map and angle.
pub fn verdicts(maps: &[Named], rays: usize) -> Vec<Verdict> {
    CLAIMS
        .iter()
        .map(|claim| {
            let (first, second) = (claim.better.selection(), claim.worse.selection());
            let (mut better, mut worse, mut count) = (0.0, 0.0, 0.0);
            for named in maps {
                for &degrees in claim.angles {
                    let case = case(&named.map, degrees, rays);
                    better += measured(claim.measure, &report(&case, &first));
                    worse += measured(claim.measure, &report(&case, &second));
                    count += 1.0;
                }
            }
            Verdict { claim, better: better / count, worse: worse / count }
        })
        .collect()
}
