//! Oh, Ki and Lee 2006, *Pyramidal Displacement Mapping*.

use super::{ALL, Claim, GRAZING, Measure, plain, with};
use crate::accuracy::SCALE_M;

const PYRAMIDAL: &str = "Oh, Ki and Lee 2006";

/// What it says of itself and of others.
pub const CLAIMS: &[Claim] = &[
    Claim {
        paper: PYRAMIDAL,
        section: "1, Figures 5, 19 and 23",
        text: "no intersection is missed at grazing angles where occlusion mapping misses some",
        better: plain("pyramidal-bilinear"),
        worse: plain("occlusion"),
        factor: 0.1,
        scale_m: SCALE_M,
        measure: Measure::Passed,
        angles: GRAZING,
        holds: true,
    },
    Claim {
        paper: PYRAMIDAL,
        section: "1, Figures 5, 19 and 23",
        text: "no intersection is missed at grazing angles where relief mapping misses some",
        better: plain("pyramidal-bilinear"),
        worse: plain("relief"),
        factor: 0.1,
        scale_m: SCALE_M,
        measure: Measure::Passed,
        angles: GRAZING,
        holds: true,
    },
    Claim {
        paper: PYRAMIDAL,
        section: "3.3, Figures 14 to 17",
        text: "interpolation over half a texel comes nearer than texels as columns",
        better: plain("pyramidal-bilinear"),
        worse: plain("pyramidal"),
        factor: 1.0,
        scale_m: SCALE_M,
        measure: Measure::Median,
        angles: ALL,
        holds: true,
    },
    Claim {
        paper: PYRAMIDAL,
        section: "3.3, Figure 16",
        text: "that interpolation is correct: no more hits are off than a hundredth of those of texels as columns",
        better: plain("pyramidal-bilinear"),
        worse: plain("pyramidal"),
        factor: 0.01,
        scale_m: SCALE_M,
        measure: Measure::Off,
        angles: ALL,
        holds: false,
    },
    Claim {
        paper: PYRAMIDAL,
        section: "3.4, Figure 18",
        text: "stopping at a coarser level takes fewer reads",
        better: with("pyramidal", &[("search.level", 3.0)]),
        worse: plain("pyramidal"),
        factor: 0.75,
        scale_m: SCALE_M,
        measure: Measure::Reads,
        angles: ALL,
        holds: true,
    },
];
