//! Whether one tracer's answer is as good as exact.
//!
//! Hits are not compared by `t` alone: where a path grazes the surface, `t` and even hit or miss hang on the
//! last bit. An answer is accepted when it is the exact answer for a surface that differs by no more than a
//! given height: the path touches the surface at the hit, to that height, and is nowhere deeper below it
//! before.

use std::fmt;

use relief_core::exact::{ExactHit, least_gap};
use relief_core::{HeightMap, Path};

/// Fault of an answer, with all that is needed to examine it.
#[derive(Clone, Debug)]
pub struct Disagreement {
    /// In a word.
    pub what: &'static str,
    /// By how many heights the answer is off: the residual at the hit, or the depth of what was passed over.
    pub heights: f64,
    /// The path.
    pub path: Path,
    /// The answer that was taken for true.
    pub truth: ExactHit,
    /// The answer that was judged.
    pub other: ExactHit,
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, heights, path, truth, other } = self;
        write!(f, "{what} by {heights:e} heights\n  {path:?}\n  truth {truth:?}\n  other {other:?}")
    }
}

/// Agreement, or the reason why two answers that differ may.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Both miss, or both hit at the same `t` to within the tolerance over the slope.
    Agree,
    /// They differ as to hit or miss, or hit at different places, but the path grazes the surface within the
    /// tolerance.
    Grazing,
}

/// Judges an answer by the truth; `tolerance` is in heights.
///
/// # Errors
///
/// When the answer is wrong by more than the tolerance.
pub fn judge(
    map: &HeightMap,
    path: &Path,
    truth: &ExactHit,
    other: &ExactHit,
    tolerance: f64,
) -> Result<Verdict, Box<Disagreement>> {
    let wrong =
        |what, heights| Box::new(Disagreement { what, heights, path: *path, truth: *truth, other: *other });
    let (a, b) = (&truth.hit, &other.hit);
    if a.exhausted || b.exhausted {
        return if a.exhausted == b.exhausted {
            Ok(Verdict::Agree)
        } else {
            Err(wrong("given up by one only", 0.0))
        };
    }
    if !b.found {
        if !a.found {
            return Ok(Verdict::Agree);
        }
        // What lies behind the true hit may be deeper, but the path has come out of the surface by then or
        // hits for good.
        let end = if path.exit.is_finite() { path.exit } else { a.t + (1.0 + a.t) };
        let depth = -least_gap(map, path, 0.0, end);
        return if depth <= tolerance { Ok(Verdict::Grazing) } else { Err(wrong("a hit is missed", depth)) };
    }
    if !(0.0..=path.exit).contains(&b.t) {
        return Err(wrong("the hit is not on the path", f64::INFINITY));
    }
    let [u, v, h] = path.at(b.t);
    let residual = h - map.height_at(u, v);
    // A path may begin below the surface; everywhere else the residual counts on both sides.
    if residual > tolerance || (b.t > 0.0 && residual < -tolerance) {
        return Err(wrong("the hit is off the surface", residual.abs()));
    }
    let beside = [(u - b.uv[0]).abs(), (v - b.uv[1]).abs(), (map.height_at(u, v) - b.height).abs()];
    if beside.into_iter().fold(0.0, f64::max) > tolerance {
        return Err(wrong("the hit is not where its t says", beside[2]));
    }
    if a.found && (a.t - b.t).abs() * truth.slope.abs().max(other.slope.abs()) <= 2.0 * tolerance {
        return Ok(Verdict::Agree);
    }
    let depth = if b.t > 0.0 { -least_gap(map, path, 0.0, b.t) } else { 0.0 };
    if depth > tolerance {
        return Err(wrong("the hit is late", depth));
    }
    Ok(Verdict::Grazing)
}

/// Numbers of answers of each kind in a series of judgements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Rays that hit in truth.
    pub hits: usize,
    /// Rays that miss in truth.
    pub misses: usize,
    /// Rays on which the answers differ as far as grazing allows.
    pub grazing: usize,
}

impl Tally {
    /// The sum of two tallies.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            hits: self.hits + other.hits,
            misses: self.misses + other.misses,
            grazing: self.grazing + other.grazing,
        }
    }
}
