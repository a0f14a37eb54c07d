//! How dense translucent volumes are.

use super::{Surface, SurfaceSpec, ValueError, error::ValueProblem};

/// Setting of the search for translucent volumes that `extinction` stands for.
const EXTINCTION: &str = "search.extinction";

/// Extinctions that are accepted, per metre.
pub(super) const EXTINCTIONS: std::ops::RangeInclusive<f64> = 0.0..=1e12;

/// Extinction of a translucent volume times its scale, if none is given.
const EXTINCTION_OF_SCALE: f64 = 8.0;

/// Scale in metres below which volumes are not denser, so that their extinction is accepted.
const LEAST_SCALE_M: f64 = 1e-9;

impl SurfaceSpec {
    /// Returns a translucent surface with its extinction. Without one its volume hides most of what is
    /// behind, and threads that fill a part of it let light through.
    pub(super) fn with_extinction(&self, surface: Surface, scale_m: f64) -> Result<Surface, ValueError> {
        let mut selection = *surface.selection();
        let is_set = self.set.contains_key(EXTINCTION);
        let extinction = match self.extinction {
            _ if !selection.is_translucent() => return Ok(surface),
            Some(_) if is_set => return Err(ValueProblem::Excludes(EXTINCTION).of("extinction")),
            None if is_set => return Ok(surface),
            given => given.unwrap_or(EXTINCTION_OF_SCALE / scale_m.max(LEAST_SCALE_M)),
        };
        check_extinction(extinction)?;
        selection.set(EXTINCTION, extinction).map_err(|_| of_range(extinction))?;
        Ok(surface.with_selection(selection))
    }
}

/// Refuses an extinction that no setting takes.
pub(super) fn check_extinction(extinction: f64) -> Result<(), ValueError> {
    if EXTINCTIONS.contains(&extinction) { Ok(()) } else { Err(of_range(extinction)) }
}

fn of_range(value: f64) -> ValueError {
    ValueProblem::Number { value, must: "from 0 to 1e12 per metre" }.of("extinction")
}
