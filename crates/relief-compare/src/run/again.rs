//! A second look at methods between which the first times decide by too little.

use relief_core::Watch;

use crate::choose::undecided;
use crate::comparison::{Comparison, Timing};
use crate::error::CompareError;
use crate::record::{PictureRecord, Records, TimeRecord};
use crate::{Contender, Goal};

/// A second look has at least that many times the frames of the first.
const FRAMES: u32 = 3;

/// It has up to that many times the frames of the first where they are short.
const MOST_FRAMES: u32 = 15;

/// Milliseconds that all frames of a second look take together, where they are short.
const SHORT_MS: f64 = 3000.0;

impl Comparison {
    /// Times those methods once more, with three to fifteen times the frames, between which a [`Goal`] was
    /// decided by too little: so few methods that they stay close in time to each other. Their times become
    /// those of this look, but that an upper end is no less than the median of the look before: so a budget
    /// is kept whether the machine is as quick as then or as now. Says how many methods were timed.
    ///
    /// # Errors
    ///
    /// As [`Self::run`], whose records these must be.
    pub fn look_again(
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
            // The contenders have theirs.
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

/// How many frames of each of these methods the second look has, where the first one had `before`. Many, if
/// they are short: the more there are, the better is known which of two near times is the shorter.
fn frames(before: u32, records: &Records, labels: &[String]) -> u32 {
    let looked_at = records.pictures.iter().filter(|record| labels.contains(&record.method.label()));
    let one_of_each: f64 =
        looked_at.filter_map(|record| record.times.as_ref()).map(|times| times.frame_ms).sum();
    let short = (SHORT_MS / one_of_each.max(f64::MIN_POSITIVE)) as u32;
    short.clamp(before.saturating_mul(FRAMES), before.saturating_mul(MOST_FRAMES))
}

/// Whether two pictures show the same in the same place.
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
    fn short_frames_are_looked_at_more_often() {
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
