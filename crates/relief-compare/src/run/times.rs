//! Timing of frames. The parts of a frame are separated by timing frames without them: bump mapping
//! without light, then with light, then the method, then its shadows.

use std::time::Duration;

use relief_core::MapFormat;
use relief_render::{FrameTime, PassTimes, Renderer};
use relief_scene::Scene;
use relief_shaders::Selection;

use super::Work;
use super::pictures::Shot;
use super::subject::with_selections;
use crate::comparison::{Comparison, Timing};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::record::TimeRecord;
use crate::spread::Median;

/// Name of the method that traces nothing.
const BUMP: &str = "bump";

/// Clocks: the machine's around whole frames, and the GPU's for passes.
const WALL: &str = "wall";
const PASSES: &str = "wall, timestamps of passes";

/// Scene that is timed repeatedly.
struct Timed {
    name: String,
    scene: Scene,
    format: MapFormat,
    times: Vec<FrameTime>,
}

impl Timed {
    /// Milliseconds of the frame in a turn.
    fn ms(&self, turn: usize) -> f64 {
        self.times.get(turn).map_or(0.0, |time| milliseconds(time.elapsed))
    }

    fn frame(&self) -> Median {
        Median::of((0..self.times.len()).map(|turn| self.ms(turn)).collect())
    }

    /// Extra time of the frames over another scene's in the same turns. It is the time of the pass
    /// in which they differ if a GPU's clock times it, otherwise of the whole frame.
    fn beyond(&self, other: &Timed, pass: fn(&PassTimes) -> Duration) -> Median {
        let of_pass = |of: &FrameTime| of.passes.as_ref().map(|passes| milliseconds(pass(passes)));
        let turns = self.times.iter().zip(&other.times);
        let each: Option<Vec<f64>> =
            turns.map(|(own, other)| Some(of_pass(own)? - of_pass(other)?)).collect();
        let whole = || (0..self.times.len()).map(|turn| self.ms(turn) - other.ms(turn)).collect();
        Median::of(each.unwrap_or_else(whole))
    }

    /// Median milliseconds of a pass, if all were timed.
    fn passes(&self, of: fn(&PassTimes) -> Duration) -> Option<f64> {
        let each: Option<Vec<f64>> = self
            .times
            .iter()
            .map(|time| time.passes.as_ref().map(|passes| milliseconds(of(passes))))
            .collect();
        each.filter(|each| !each.is_empty()).map(|each| Median::of(each).middle)
    }
}

/// Time of the tracing pass.
fn trace(passes: &PassTimes) -> Duration {
    passes.trace
}

/// Time of the shading pass.
fn shade(passes: &PassTimes) -> Duration {
    passes.shade
}

fn milliseconds(duration: Duration) -> f64 {
    1e3 * duration.as_secs_f64()
}

impl Comparison {
    /// Times the methods on a machine, and returns one record for each in their order; none if
    /// frames are not timed.
    pub(super) fn times(
        &self,
        shot: &Shot,
        contenders: &[Contender],
        renderer: &mut Renderer,
        Work { baked, watch, .. }: &mut Work,
    ) -> Result<Vec<Option<TimeRecord>>, CompareError> {
        let none = vec![None; contenders.len()];
        let Some(timing) = self.timing else { return Ok(none) };
        let bump = Contender::named(BUMP)?;
        // Some surfaces do not support bump mapping: shells are either searched or absent.
        let Ok(plain) = bump.on_all(&shot.subject.surfaces) else { return Ok(none) };
        let plain = without_shadows(&plain.selections);
        let timed = |of: &Contender, selections: &[Selection], is_lit: bool| -> Result<Timed, CompareError> {
            let scene = timed_scene(shot, selections, timing, is_lit)?;
            Ok(Timed { name: of.label(), scene, format: of.format(), times: Vec::new() })
        };
        let mut all = vec![timed(&bump, &plain, false)?, timed(&bump, &plain, true)?];
        for contender in contenders {
            let selections = contender.on_all(&shot.subject.surfaces)?.selections;
            all.push(timed(contender, &without_shadows(&selections), true)?);
            all.push(timed(contender, &selections, true)?);
        }
        for turn in 0..timing.warm + timing.frames {
            for timed in &mut all {
                watch.check()?;
                let mut frame = || {
                    let time = renderer.time(&timed.scene, baked.maps(timed.format), &watch.quiet());
                    time.map_err(|error| CompareError::of_picture(&timed.name, error))
                };
                // The first frame of a scene prepares it, and wakes up an idle GPU.
                frame()?;
                let time = frame()?;
                if turn >= timing.warm {
                    timed.times.push(time);
                }
            }
        }
        let [base, lit, methods @ ..] = &all[..] else { return Ok(none) };
        let records = methods.as_chunks::<2>().0.iter().map(|[searched, shadowed]| {
            let (frame, displacement) = (shadowed.frame(), searched.beyond(lit, trace));
            let (shade, shadow) = (lit.beyond(base, shade), shadowed.beyond(searched, shade));
            let differences = [("displacement_ms", displacement), ("shade_ms", shade), ("shadow_ms", shadow)];
            let is_noise = |(_, median): &(&str, Median)| median.low <= 0.0;
            let trace_pass_ms = shadowed.passes(trace);
            Some(TimeRecord {
                clock: if trace_pass_ms.is_some() { PASSES } else { WALL }.to_owned(),
                timed_size: shadowed.scene.size(),
                frame_ms: frame.middle,
                frame_low_ms: frame.low,
                frame_high_ms: frame.high,
                displacement_ms: displacement.middle,
                displacement_low_ms: displacement.low,
                displacement_high_ms: displacement.high,
                base_ms: base.frame().middle,
                shade_ms: shade.middle,
                shadow_ms: shadow.middle,
                confidence: frame.confidence,
                below_noise: differences
                    .into_iter()
                    .filter(is_noise)
                    .map(|(key, _)| key.to_owned())
                    .collect(),
                trace_pass_ms,
                shade_pass_ms: shadowed.passes(self::shade),
            })
        });
        Ok(records.collect())
    }
}

/// Returns the scene to time: larger, and with one sample per pixel.
fn timed_scene(
    shot: &Shot,
    selections: &[Selection],
    timing: Timing,
    is_lit: bool,
) -> Result<Scene, CompareError> {
    let factor = f64::from(timing.pixels).sqrt();
    let [columns, rows] = shot.scene.size().map(|side| (f64::from(side) * factor).round() as u32);
    let scene = with_selections(&shot.scene, &shot.subject.surfaces, selections, 1)?;
    let mut scene = scene.to_builder().size(columns, rows);
    if !is_lit {
        scene = scene.lights(Vec::new());
    }
    Ok(scene.build()?)
}

/// Removes shadows from selections.
fn without_shadows(selections: &[Selection]) -> Vec<Selection> {
    selections.iter().map(Selection::without_shadows).collect()
}
