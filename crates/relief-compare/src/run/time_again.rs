//! Second timing of methods whose first times are too close to decide.

use relief_core::Watch;

use crate::choose::undecided;
use crate::comparison::{Comparison, Timing};
use crate::error::CompareError;
use crate::record::{PictureRecord, Records, TimeRecord};
use crate::{Contender, Goal};

/// Least number of frames of the second timing, as a multiple of the first's.
const FRAMES: u32 = 3;

/// Greatest number of frames of the second timing, as a multiple of the first's, for short frames.
const MOST_FRAMES: u32 = 15;

/// Total milliseconds of the second timing for short frames.
const SHORT_MS: f64 = 3000.0;

impl Comparison {
    /// Times those methods again whose times are too close to decide a [`Goal`], with three to
    /// fifteen times the frames. These are few, so that they stay close in time to each other. The
    /// new times replace the old ones, except that an upper end is at least the old median. A
    /// budget is then met whether the machine is as fast as before or as now. Returns the number of
    /// methods.
    ///
    /// # Errors
    ///
    /// See [`Self::run`], which must have produced the records.
    pub fn time_again(
        &self,
        records: &mut Records,
        goal: Goal,
        watch: &Watch,
    ) -> Result<usize, CompareError> {
        let Some(timing) = self.timing else { return Ok(0) };
        let labels = undecided(records, goal);
        if labels.is_empty() {
            return Ok(0);
        }
        let frames = frames(timing.frames, records, &labels);
        let mut contenders: Vec<Contender> = self.entrants()?;
        contenders.retain(|contender| labels.contains(&contender.label()));
        let again = Comparison {
            contenders,
            // The contenders already have their steps, formats and shadows.
            steps: Vec::new(),
            map_formats: Vec::new(),
            shadows: Vec::new(),
            rays: 0,
            flicker_samples: None,
            timing: Some(Timing { frames, ..timing }),
            ..self.clone()
        };
        let seen = again.run(watch)?.records.pictures;
        for record in &mut records.pictures {
            let second = seen.iter().find(|other| is_same(record, other));
            let Some(second) = second.and_then(|other| other.times.clone()) else { continue };
            let first = record.times.as_ref().map_or(0.0, |times| times.frame_ms);
            let frame_high_ms = second.frame_high_ms.max(first);
            record.times = Some(TimeRecord { frame_high_ms, ..second });
        }
        Ok(labels.len())
    }
}

/// Number of frames of each method in the second timing, after `before` frames in the first. Short
/// frames are timed more often: more frames decide better which of two similar times is shorter.
fn frames(before: u32, records: &Records, labels: &[String]) -> u32 {
    let looked_at = records.pictures.iter().filter(|record| labels.contains(&record.method.label()));
    let one_of_each: f64 =
        looked_at.filter_map(|record| record.times.as_ref()).map(|times| times.frame_ms).sum();
    let short = (SHORT_MS / one_of_each.max(f64::MIN_POSITIVE)) as u32;
    short.clamp(before.saturating_mul(FRAMES), before.saturating_mul(MOST_FRAMES))
}

/// Whether two pictures have the same method, map, distance and machine.
fn is_same(a: &PictureRecord, b: &PictureRecord) -> bool {
    let of = |record: &PictureRecord| {
        let method = &record.method;
        (method.label(), method.map_size, method.scale_m.to_bits(), record.distance_m.map(f64::to_bits))
    };
    (of(a), &a.backend, &a.sampling) == (of(b), &b.backend, &b.sampling)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::MethodRecord;

    #[test]
    fn short_frames_are_timed_more_often() {
        let record = |name: &str, frame_ms| PictureRecord {
            method: MethodRecord { method: name.to_owned(), ..Default::default() },
            times: Some(TimeRecord { frame_ms, ..Default::default() }),
            ..Default::default()
        };
        let pictures = vec![record("bump", 4.0), record("cone", 36.0), record("exact", 400.0)];
        let records = Records { pictures, ..Default::default() };
        let of = |names: &[&str]| {
            frames(9, &records, &names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>())
        };
        assert_eq!(of(&["bump"]), 135);
        assert_eq!(of(&["bump", "cone"]), 75);
        assert_eq!(of(&["cone", "exact"]), 27);
        assert_eq!(of(&[]), 135);
    }
}
