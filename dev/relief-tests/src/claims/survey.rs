//! Szirmay-Kalos and Umenhoffer 2008, *Displacement Mapping on the GPU - State of the Art*.

use super::{Claim, DESCENT, EXTREME_M, GRAZING, Measure, NORMAL_M, ORDER, STEEP, plain, with};

/// A claim about the order that holds.
const SURVEY: Claim = Claim { paper: "Szirmay-Kalos and Umenhoffer 2008", ..ORDER };

/// Claims of sections 4 and 7.
pub const CLAIMS: &[Claim] = &[
    Claim {
        section: "4.1.2",
        text: "parallax mapping is nearer than bump mapping away from grazing angles",
        better: plain("parallax"),
        worse: plain("bump"),
        angles: STEEP,
        ..SURVEY
    },
    Claim {
        section: "4.1.3",
        text: "offset limiting reduces the error of parallax mapping at grazing angles",
        better: plain("parallax-limited"),
        worse: plain("parallax"),
        angles: GRAZING,
        holds: false,
        ..SURVEY
    },
    Claim {
        section: "4.1.3",
        text: "offset limiting keeps the worst offsets of parallax mapping at grazing angles small",
        better: plain("parallax-limited"),
        worse: plain("parallax"),
        measure: Measure::Tail,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.1.4",
        text: "the slope gives much better results than the offset with limiting",
        better: plain("parallax-slope"),
        worse: plain("parallax-limited"),
        holds: false,
        ..SURVEY
    },
    Claim {
        section: "4.1.4",
        text: "dividing by N·V, the slope gives better results than the offset away from grazing angles",
        better: with("parallax-slope", &[("refine.divide", 1.0)]),
        worse: plain("parallax"),
        angles: STEEP,
        ..SURVEY
    },
    Claim {
        section: "4.2.1",
        text: "iterating the slope correction significantly improves on doing it once",
        better: plain("parallax-iterative"),
        worse: plain("parallax-slope"),
        ..SURVEY
    },
    Claim {
        section: "4.2.1",
        text: "at extreme displacement iterations do not converge as halvings do: one more moves hits",
        better: with("binary-search", &[("refine.steps", 32.0)]),
        worse: with("parallax-iterative", &[("refine.steps", 32.0)]),
        factor: 0.01,
        scale_m: EXTREME_M,
        measure: Measure::Unsettled,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.2.2",
        text: "binary search over the whole path may pass the first hit, which linear search guards against",
        better: plain("relief"),
        worse: plain("binary-search"),
        measure: Measure::Passed,
        ..SURVEY
    },
    Claim {
        section: "4.2.3",
        text: "the true secant method converges faster than false position, in brackets of 32 linear steps",
        better: with("true-secant", &[("refine.steps", 4.0)]),
        worse: with("occlusion", &[("refine.steps", 4.0)]),
        holds: false,
        ..SURVEY
    },
    Claim {
        section: "4.3.1",
        text: "finer linear steps miss less",
        better: with("relief", &[("search.steps", 128.0)]),
        worse: with("relief", &[("search.steps", 32.0)]),
        measure: Measure::Passed,
        ..SURVEY
    },
    Claim {
        section: "4.3.1",
        text: "more steps at oblique angles are worth it",
        better: with("occlusion", &[("search.grazing", 4.0)]),
        worse: plain("occlusion"),
        measure: Measure::Passed,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.1",
        text: "one secant step removes the stair-steps of linear search",
        better: with("occlusion", &[("refine.steps", 1.0)]),
        worse: plain("steep"),
        ..SURVEY
    },
    Claim {
        section: "4.4",
        text: "a linear search makes the secant method find the first hit",
        better: plain("occlusion"),
        worse: plain("secant-search"),
        measure: Measure::Passed,
        ..SURVEY
    },
    Claim {
        section: "4.4.2",
        text: "two secant steps come nearer than two halvings",
        better: with("occlusion", &[("refine.steps", 2.0)]),
        worse: with("relief", &[("refine.steps", 2.0)]),
        ..SURVEY
    },
    Claim {
        section: "4.3.1, Figure 20",
        text: "sixty-four layers have smaller steps than thirty-two",
        better: with("steep", &[("search.steps", 64.0)]),
        worse: plain("steep"),
        factor: 0.6,
        ..SURVEY
    },
    Claim {
        section: "4.3.2",
        text: "dilation and erosion maps skip empty space: fewer reads than a visit to every texel",
        better: plain("erosion-dilation"),
        worse: plain("exact"),
        measure: Measure::Reads,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.3",
        text: "a pyramid skips empty space: fewer reads than a visit to every texel",
        better: plain("quadtree"),
        worse: plain("exact"),
        measure: Measure::Reads,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.3",
        text: "a pyramid that never goes up again passes hits where rays leave a node unnoticed",
        better: plain("quadtree"),
        worse: plain(DESCENT),
        factor: 0.1,
        measure: Measure::Passed,
        ..SURVEY
    },
    Claim {
        section: "4.3.4",
        text: "a distance field skips empty space: fewer reads than a visit to every texel",
        better: plain("sphere-tracing"),
        worse: plain("exact"),
        measure: Measure::Reads,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.4, Figure 23",
        text: "sixty-four layers of a distance field are better than thirty-two: fewer reads",
        better: plain("sphere-tracing"),
        worse: with("sphere-tracing", &[("search.slices", 32.0)]),
        measure: Measure::Reads,
        ..SURVEY
    },
    Claim {
        section: "4.3.5",
        text: "cones need a plane where the distance field needs a volume: a tenth of its storage at most",
        better: plain("cone"),
        worse: plain("sphere-tracing"),
        factor: 0.1,
        measure: Measure::MapBytes,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.5",
        text: "cones skip empty space: fewer reads than a visit to every texel",
        better: plain("cone"),
        worse: plain("exact"),
        measure: Measure::Reads,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "4.3.5, Figure 25",
        text: "cone stepping comes nearer with every doubling of its count",
        better: with("cone-stepping", &[("search.steps", 64.0)]),
        worse: plain("cone-stepping"),
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "4.4.1, Figure 26",
        text: "four halvings after thirty-two layers come nearer than the layers alone",
        better: with("relief", &[("refine.steps", 4.0)]),
        worse: plain("steep"),
        factor: 0.2,
        ..SURVEY
    },
    Claim {
        section: "4.4.2, Figure 27",
        text: "one or two secant steps are sufficient: two leave a tenth more hits off than eight at most",
        better: with("occlusion", &[("refine.steps", 2.0)]),
        worse: with("occlusion", &[("refine.steps", 8.0)]),
        factor: 1.1,
        measure: Measure::Off,
        holds: false,
        ..SURVEY
    },
    Claim {
        section: "4.4.3, Figures 28 and 29",
        text: "with sixteen steps strict cones stop before the surface more often than relaxed ones",
        better: with("relaxed-cone-stepping", &[("search.limit", 32.0)]),
        worse: with("cone-stepping", &[("search.steps", 16.0)]),
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "6.3",
        text: "view-dependent maps give the highest quality: fewer hits are off than of relief mapping",
        better: plain("view-dependent"),
        worse: plain("relief"),
        measure: Measure::Off,
        holds: false,
        ..SURVEY
    },
    Claim {
        section: "6.3",
        text: "view-dependent maps take much storage: a map of cones has a tenth at most, beside few \
               directions",
        better: plain("cone"),
        worse: with("view-dependent", &[("search.azimuths", 8.0), ("search.elevations", 4.0)]),
        factor: 0.1,
        measure: Measure::MapBytes,
        angles: GRAZING,
        ..SURVEY
    },
    Claim {
        section: "6.3",
        text: "singular value decomposition compresses view-dependent maps: fewer hits are off than of as \
               many bytes",
        better: with("view-dependent-svd", &[("search.rank", 8.0)]),
        worse: with("view-dependent", &[("search.azimuths", 4.0), ("search.elevations", 2.0)]),
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "6.3",
        text: "so do k-means and non-negative factors: fewer hits are off than of as many bytes",
        better: with("view-dependent-clusters", &[("search.rank", 4.0), ("search.clusters", 16.0)]),
        worse: with("view-dependent", &[("search.azimuths", 4.0), ("search.elevations", 2.0)]),
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "7, Figure 34",
        text: "at normal displacement occlusion mapping is nearer than iterative parallax mapping",
        better: plain("occlusion"),
        worse: plain("parallax-iterative"),
        scale_m: NORMAL_M,
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "7, Figure 34",
        text: "at normal displacement iterative parallax mapping is nearer than parallax mapping",
        better: plain("parallax-iterative"),
        worse: plain("parallax"),
        scale_m: NORMAL_M,
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "7, Figure 35",
        text: "at extreme displacement, 32 steps each, relief mapping is nearer than cone stepping",
        better: plain("relief"),
        worse: plain("cone-stepping"),
        scale_m: EXTREME_M,
        measure: Measure::Off,
        ..SURVEY
    },
    Claim {
        section: "7, Figure 35",
        text: "at extreme displacement relaxed cones are nearer than linear search with halvings",
        better: plain("relaxed-cone-stepping"),
        worse: plain("relief"),
        scale_m: EXTREME_M,
        measure: Measure::Off,
        ..SURVEY
    },
];
