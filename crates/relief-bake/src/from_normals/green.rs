//! The direction in which green points, found by which of both fits a relief better.

use relief_core::Watch;

use super::error::FromNormalsError;
use super::integrate::{IntegratedHeights, Integration};
use super::known::{heights_from_known_slopes, roughly};
use super::slopes::NormalSlopes;

/// Below this confidence the direction is chance; white noise reaches a hundredth of it or so.
const UNSURE: f64 = 0.05;

/// Differences below this part of the slopes are rounding: a relief that varies along one axis
/// alone fits both ways.
const ROUNDING: f64 = 1e-4;

/// Direction of green in a tangent-space normal map.
///
/// Slopes of a relief have no curl. With one of them turned over they have a curl, unless the
/// relief varies along one axis alone. The misfit ([`IntegratedHeights::misfit`]) is the part of
/// the slopes that fits no relief. For the right direction it is zero but for noise and cliffs. For
/// the wrong one it is about half of the square of the slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GreenFit {
    /// Whether green points down in the picture (DirectX). An unsure map is taken to point up.
    pub is_down: bool,
    /// Confidence from 0 to 1: the difference of the two squared misfits over their sum.
    pub confidence: f64,
    /// Misfits with green up and with green down.
    pub misfits: [f64; 2],
}

impl GreenFit {
    /// Returns whether the map says which way green points.
    pub fn is_sure(&self) -> bool {
        self.confidence >= UNSURE
    }

    fn new(misfits: [f64; 2], steepness: f64) -> Self {
        let [up, down] = misfits.map(|misfit| misfit * misfit);
        let sum = up + down + (ROUNDING * steepness).powi(2);
        let confidence = if sum > 0.0 { (up - down).abs() / sum } else { 0.0 };
        Self { is_down: down < up && confidence >= UNSURE, confidence, misfits }
    }
}

/// Integrates slopes of normals that were read with green up, whichever way it points. Both
/// directions are tried, and the slopes that fit better are returned. Takes twice the time of one
/// direction and 4 bytes a texel more.
///
/// # Errors
///
/// Fails as [`heights_from_known_slopes`] does.
pub fn heights_from_either_green(
    slopes: NormalSlopes,
    how: &Integration,
    watch: &Watch,
) -> Result<(IntegratedHeights, NormalSlopes, GreenFit), FromNormalsError> {
    let has_holes = slopes.known.is_some();
    let ends = if has_holes { [0.2, 0.4] } else { [0.5, 1.0] };
    let up = roughly(&slopes, how, &watch.piece(0.0, ends[0]))?;
    let slopes = slopes.turned_over();
    let down = roughly(&slopes, how, &watch.piece(ends[0], ends[1]))?;
    let fit = GreenFit::new([up.misfit, down.misfit], slopes.steepness());
    let (heights, slopes) = if fit.is_down { (down, slopes) } else { (up, slopes.turned_over()) };
    if !has_holes {
        return Ok((heights, slopes, fit));
    }
    drop(heights);
    let heights = heights_from_known_slopes(&slopes, how, &watch.piece(ends[1], 1.0))?;
    Ok((heights, slopes, fit))
}
