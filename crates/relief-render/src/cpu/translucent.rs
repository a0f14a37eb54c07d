//! Light gathered through translucent surfaces, in front of what is opaque.

use relief_core::raycast::Sides;
use relief_shaders::cpu::{Gathered, PixelOut};

use super::prepared_surface::{Base, PreparedSurface, ShaderRay};

/// Segment of a shell: where it begins on the ray, its triangle and side, and its number there.
#[derive(Clone, Copy)]
struct ShellSegment {
    start: f32,
    triangle: u32,
    side: f32,
    number: u32,
}

impl ShellSegment {
    /// Compares the places of two segments on the ray. Of those that begin together, the lower triangle comes
    /// first, then the side that is not turned over.
    fn compare(&self, other: &Self) -> std::cmp::Ordering {
        let rest = |of: &Self| (of.triangle, of.side < 0.0, of.number);
        self.start.total_cmp(&other.start).then(rest(self).cmp(&rest(other)))
    }
}

/// Returns a shaded pixel as it is seen through the translucent surfaces. `point` is its column and row.
pub fn composed(translucent: &[PreparedSurface], point: [f32; 2], behind: PixelOut) -> PixelOut {
    let opaque = (behind.hit == 1).then_some(behind.depth);
    let gathered = |surface: &PreparedSurface| surface.gathered(surface.ray_through(point), opaque);
    let mut seen: Vec<(&PreparedSurface, Gathered)> =
        translucent.iter().map(|surface| (surface, gathered(surface))).collect();
    // From the farthest to the nearest. Of those that begin together, the first lies nearest.
    seen.reverse();
    seen.sort_by(|one, other| other.1.entry.total_cmp(&one.1.entry));
    seen.into_iter().fold(behind, |pixel, (surface, seen)| PixelOut {
        color: surface.program.seen_through(pixel.color, seen),
        transmittance: pixel.transmittance * seen.transmittance,
        ..pixel
    })
}

impl PreparedSurface<'_> {
    /// Gathers the light of a translucent surface on a ray, up to an opaque hit at that depth.
    fn gathered(&self, aim: ShaderRay, opaque: Option<f32>) -> Gathered {
        let mut seen = self.program.begin_gathering(aim.direction, opaque);
        for ShellSegment { triangle, side, number, .. } in self.segments(aim, seen.reach_m) {
            if !self.program.goes_on(&seen) {
                break;
            }
            let pixel = self.pixel(triangle, side, aim);
            seen = self.program.gather(seen, pixel, self.program.enter(pixel), number);
        }
        seen
    }

    /// Returns the part of light that comes through a translucent surface along a ray, up to a depth.
    pub fn lets_through(&self, aim: ShaderRay, depth_m: f32) -> f32 {
        let mut seen = self.program.begin_gathering(aim.direction, Some(depth_m));
        for ShellSegment { triangle, side, number, .. } in self.segments(aim, seen.reach_m) {
            let pixel = self.pixel(triangle, side, aim);
            seen = self.program.let_through(seen, pixel, self.program.enter(pixel), number);
        }
        seen.transmittance
    }

    /// Returns the segments of all shells on a ray that begin before `reach_m`, in order.
    fn segments(&self, aim: ShaderRay, reach_m: f32) -> Vec<ShellSegment> {
        let mut segments = Vec::new();
        let Base::Shells(caster) = &self.base else { return segments };
        let sides: &[f32] = if self.sides == Sides::Both { &[1.0, -1.0] } else { &[1.0] };
        caster.each(&aim.ray(), |triangle| {
            for &side in sides {
                let pixel = self.pixel(triangle, side, aim);
                let at = self.program.enter(pixel);
                for number in 0..at.segments {
                    let path = self.program.segment(pixel, at, number);
                    if path.exit > 0.0 && path.start < reach_m {
                        segments.push(ShellSegment { start: path.start, triangle, side, number });
                    }
                }
            }
            f64::INFINITY
        });
        segments.sort_unstable_by(ShellSegment::compare);
        segments
    }
}
