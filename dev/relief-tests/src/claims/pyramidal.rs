//! Oh, Ki and Lee 2006, *Pyramidal Displacement Mapping*.

use super::{Claim, GRAZING, Measure, ORDER, plain, with};

/// A claim about the order that holds.
const PYRAMIDAL: Claim = Claim { paper: "Oh, Ki and Lee 2006", ..ORDER };

/// Claims of the paper about itself and others.
pub const CLAIMS: &[Claim] = &[
    Claim {
        section: "1, Figures 5, 19 and 23",
        text: "no intersection is missed at grazing angles where occlusion mapping misses some",
        better: plain("pyramidal-bilinear"),
        worse: plain("occlusion"),
        factor: 0.1,
        measure: Measure::Passed,
        angles: GRAZING,
        ..PYRAMIDAL
    },
    Claim {
        section: "1, Figures 5, 19 and 23",
        text: "no intersection is missed at grazing angles where relief mapping misses some",
        better: plain("pyramidal-bilinear"),
        worse: plain("relief"),
        factor: 0.1,
        measure: Measure::Passed,
        angles: GRAZING,
        ..PYRAMIDAL
    },
    Claim {
        section: "3.3, Figures 14 to 17",
        text: "interpolation over half a texel comes nearer than texels as columns",
        better: plain("pyramidal-bilinear"),
        worse: plain("pyramidal"),
        ..PYRAMIDAL
    },
    Claim {
        section: "3.3, Figure 16",
        text: "that interpolation is correct: a hundredth as many hits are off as of texels as columns",
        better: plain("pyramidal-bilinear"),
        worse: plain("pyramidal"),
        factor: 0.01,
        measure: Measure::Off,
        holds: false,
        ..PYRAMIDAL
    },
    Claim {
        section: "3.4, Figure 18",
        text: "stopping at a coarser level takes fewer reads",
        better: with("pyramidal", &[("search.level", 3.0)]),
        worse: plain("pyramidal"),
        factor: 0.75,
        measure: Measure::Reads,
        ..PYRAMIDAL
    },
];
