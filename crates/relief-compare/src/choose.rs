//! Choice of the best method for a time budget, or for an error limit.

use crate::Contender;
use crate::record::{ErrorRecord, MethodRecord, Records};

/// Numbers of steps to choose from.
const STEPS: [u32; 6] = [8, 16, 32, 64, 128, 256];

/// Errors in texels below this count as rounding: among such methods the fastest is the best.
const ROUNDING_TEXELS: f64 = 1e-3;

/// Ratio of times below which one run does not decide, and greatest number of methods that are
/// timed again.
const NEAR: f64 = 1.1;
const MOST_UNDECIDED: usize = 8;

/// Goal of a choice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The least error within a budget of milliseconds a frame. The upper end of the median's 95 %
    /// interval counts, so that other runs stay within the budget, too.
    WithinMs(f64),
    /// The least time within an error limit in texels, which 99 of 100 rays meet at the worst
    /// angle.
    WithinTexels(f64),
}

/// Method that can be chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Description of the method.
    pub method: MethodRecord,
    /// Backend on which its frames were timed.
    pub backend: String,
    /// Sampling of textures on that backend.
    pub sampling: String,
    /// Error in texels that 99 of 100 rays do not exceed, at the worst angle, scale and level.
    /// Methods without rays are judged by pictures. Infinite if more than one ray in 100 misses, or
    /// hits where there is nothing.
    pub p99_texels: f64,
    /// Median time of a frame in milliseconds, at the worst scale, level and distance.
    pub frame_ms: f64,
    /// Lower end of the median's 95 % interval in milliseconds, at the worst of these.
    pub frame_low_ms: f64,
    /// Upper end of the same interval in milliseconds.
    pub frame_high_ms: f64,
}

/// Ranking of candidates, the best first.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranking {
    /// All candidates: first those that meet the goal, from the best on, then the others, from the
    /// nearest on.
    pub candidates: Vec<Candidate>,
    /// Number of candidates that meet the goal.
    pub meeting: usize,
}

impl Goal {
    /// Returns a candidate's value, its limit, and the figure to minimise.
    fn figures(self, candidate: &Candidate) -> (f64, f64, f64) {
        let Candidate { p99_texels, frame_ms, frame_high_ms, .. } = *candidate;
        match self {
            Goal::WithinMs(limit) => (frame_high_ms, limit, p99_texels.max(ROUNDING_TEXELS)),
            Goal::WithinTexels(limit) => (p99_texels, limit, frame_ms),
        }
    }

    /// Whether a candidate meets the goal.
    pub fn is_met_by(self, candidate: &Candidate) -> bool {
        let (value, limit, _) = self.figures(candidate);
        value <= limit
    }
}

/// Returns the given methods and, for those with steps, copies with fewer and more steps.
pub fn with_other_steps(contenders: &[Contender]) -> Vec<Contender> {
    let each = contenders.iter().flat_map(|contender| {
        let others = STEPS.into_iter().filter_map(|steps| contender.with_steps(steps).ok().flatten());
        std::iter::once(contender.clone()).chain(others)
    });
    each.collect()
}

/// Returns labels of methods whose times are too close to decide. For a budget, these are methods
/// near it that are at least as good as the best one safely within it, and that one. For an error
/// limit, these are the methods within it that take nearly the least time.
pub(crate) fn undecided(records: &Records, goal: Goal) -> Vec<String> {
    let mut candidates = choose(records, goal).candidates;
    match goal {
        Goal::WithinMs(limit) => {
            candidates.retain(|candidate| candidate.frame_ms <= NEAR * limit);
            let least = |candidate: &Candidate| goal.figures(candidate).2;
            candidates.sort_by(|a, b| least(a).total_cmp(&least(b)).then(a.frame_ms.total_cmp(&b.frame_ms)));
            let is_sure = |candidate: &Candidate| NEAR * candidate.frame_high_ms <= limit;
            let sure = candidates.iter().position(is_sure);
            candidates.truncate(sure.map_or(MOST_UNDECIDED, |sure| (sure + 1).min(MOST_UNDECIDED)));
        }
        Goal::WithinTexels(_) => {
            candidates.retain(|candidate| goal.is_met_by(candidate));
            let fastest = candidates.first().map_or(0.0, |best| best.frame_ms);
            candidates.retain(|candidate| candidate.frame_ms <= NEAR * fastest);
            candidates.truncate(MOST_UNDECIDED);
        }
    }
    candidates.iter().map(|candidate| candidate.method.label()).collect()
}

/// Error in texels that 99 of 100 rays do not exceed.
fn p99_error(error: &ErrorRecord) -> f64 {
    let without = error.missed + error.false_hits;
    if without > 0.01 { f64::INFINITY } else { error.p99_texels }
}

/// Ranks the methods among some records whose frames were timed.
pub fn choose(records: &Records, goal: Goal) -> Ranking {
    let mut candidates: Vec<Candidate> = Vec::new();
    for picture in &records.pictures {
        let Some(times) = &picture.times else { continue };
        let label = picture.method.label();
        let is_same = |known: &Candidate| {
            (&known.method.label(), &known.backend, &known.sampling)
                == (&label, &picture.backend, &picture.sampling)
        };
        if let Some(known) = candidates.iter_mut().find(|known| is_same(known)) {
            known.frame_ms = known.frame_ms.max(times.frame_ms);
            known.frame_low_ms = known.frame_low_ms.max(times.frame_low_ms);
            known.frame_high_ms = known.frame_high_ms.max(times.frame_high_ms);
            continue;
        }
        let of_rays = picture.method.label_of_rays();
        let rays = records.rays.iter().filter(|record| record.method.label() == of_rays);
        let of_rays = rays.map(|record| p99_error(&record.error)).reduce(f64::max);
        let of_pictures = || {
            let pictures = records.pictures.iter().filter(|record| record.method.label() == label);
            // A method that was not judged has an infinite error.
            let errors = pictures.map(|record| record.error.as_ref().map_or(f64::INFINITY, p99_error));
            errors.fold(0.0, f64::max)
        };
        candidates.push(Candidate {
            method: picture.method.clone(),
            backend: picture.backend.clone(),
            sampling: picture.sampling.clone(),
            p99_texels: of_rays.unwrap_or_else(of_pictures),
            frame_ms: times.frame_ms,
            frame_low_ms: times.frame_low_ms,
            frame_high_ms: times.frame_high_ms,
        });
    }
    candidates.sort_by(|a, b| {
        let key = |candidate| {
            let (value, limit, least) = goal.figures(candidate);
            // Candidates that miss the goal are ordered by their distance from it.
            if value <= limit { (0, least, value) } else { (1, value, least) }
        };
        let ((a_misses, a, a_next), (b_misses, b, b_next)) = (key(a), key(b));
        a_misses.cmp(&b_misses).then(a.total_cmp(&b)).then(a_next.total_cmp(&b_next))
    });
    let meeting = candidates.iter().filter(|candidate| goal.is_met_by(candidate)).count();
    Ranking { candidates, meeting }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{ErrorRecord, PictureRecord, RayRecord, TimeRecord};

    /// Records of methods with their errors at two angles and their frames' times.
    fn records(methods: &[(&str, [f64; 2], f64)]) -> Records {
        let mut records = Records::default();
        for (name, errors, frame_ms) in methods {
            let method = MethodRecord { method: (*name).to_owned(), ..Default::default() };
            for p99_texels in *errors {
                let error = ErrorRecord { p99_texels, ..Default::default() };
                records.rays.push(RayRecord { method: method.clone(), error, ..Default::default() });
            }
            let (frame_ms, frame_high_ms) = (*frame_ms, 1.1 * frame_ms);
            let times = Some(TimeRecord { frame_ms, frame_high_ms, ..Default::default() });
            records.pictures.push(PictureRecord { method, times, ..Default::default() });
        }
        records
    }

    fn names(tried: &Ranking) -> Vec<&str> {
        tried.candidates.iter().map(|candidate| candidate.method.method.as_str()).collect()
    }

    #[test]
    fn the_best_within_the_limit_comes_first_and_then_the_nearest() {
        let records = records(&[
            ("bump", [9.0, 90.0], 1.0),
            ("steep", [1.0, 4.0], 3.0),
            ("cone", [0.0, 0.1], 6.0),
            ("exact", [0.0, 0.1], 8.0),
        ]);
        let tried = choose(&records, Goal::WithinMs(5.0));
        assert_eq!((names(&tried), tried.meeting), (vec!["steep", "bump", "cone", "exact"], 2));
        // Of the errors at several angles the worst counts.
        let tried = choose(&records, Goal::WithinTexels(1.0));
        assert_eq!((names(&tried), tried.meeting), (vec!["cone", "exact", "steep", "bump"], 2));
        let tried = choose(&records, Goal::WithinTexels(0.01));
        assert_eq!((names(&tried)[0], tried.meeting), ("cone", 0));
        assert_eq!(choose(&Records::default(), Goal::WithinMs(1.0)).candidates, []);
        // A median whose interval exceeds the budget is not within it.
        assert_eq!(choose(&records, Goal::WithinMs(3.2)).meeting, 1);
        // Of two methods as good as exact the faster one is better.
        let tried = choose(&records, Goal::WithinMs(10.0));
        assert_eq!(names(&tried)[..2], ["cone", "exact"]);
    }

    #[test]
    fn methods_near_the_budget_or_the_fastest_are_undecided() {
        let records = records(&[
            ("bump", [90.0, 90.0], 1.0),
            ("worse", [40.0, 40.0], 2.9),
            ("steep", [4.0, 4.0], 2.0),
            ("relief", [1.0, 1.0], 3.1),
            ("cone", [0.1, 0.1], 3.2),
            ("exact", [0.0, 0.0], 8.0),
        ]);
        // The best method safely within the budget ends the list; worse ones are irrelevant.
        assert_eq!(undecided(&records, Goal::WithinMs(3.0)), ["cone", "relief", "steep"]);
        assert_eq!(undecided(&records, Goal::WithinMs(0.1)), [""; 0]);
        assert_eq!(undecided(&records, Goal::WithinTexels(2.0)), ["relief", "cone"]);
    }

    #[test]
    fn misses_are_not_near() {
        let mut records = records(&[("short", [0.0, 0.0], 1.0), ("cone", [0.1, 0.1], 2.0)]);
        records.rays[1].error.missed = 0.02;
        let tried = choose(&records, Goal::WithinTexels(1.0));
        assert_eq!((names(&tried), tried.meeting), (vec!["cone", "short"], 1));
        assert_eq!(tried.candidates[1].p99_texels, f64::INFINITY);
    }
}
