//! A second look at methods between which the first times decide by too little.

use crate::choose::undecided;
use crate::comparison::{Comparison, Timing, Watch};
use crate::error::CompareError;
use crate::record::{PictureRecord, Records, TimeRecord};
use crate::{Contender, Goal};

/// How many times as many frames it takes.
const FRAMES: u32 = 3;

impl Comparison {
    /// Times those methods once more, with more frames, between which a [`Goal`] was decided by too little:
    /// so few that they stay close in time to each other. Their times become those of this look, but that an
    /// upper end is no less than the median of the look before: so a budget is kept whether the machine is as
    /// quick as then or as now. Says how many methods were timed.
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
            timing: Some(Timing { frames: FRAMES * timing.frames, ..timing }),
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

/// Whether two pictures show the same in the same place.
fn is_same(a: &PictureRecord, b: &PictureRecord) -> bool {
    let of = |record: &PictureRecord| {
        let method = &record.method;
        (method.label(), method.map_size, method.scale_m.to_bits(), record.distance_m.map(f64::to_bits))
    };
    (of(a), &a.backend, &a.sampling) == (of(b), &b.backend, &b.sampling)
}
