//! Mesh with the least error within a triangle budget.

use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Watch};

use crate::{Certificate, MeshSettings, Mesher, MesherError};

/// Tries after which the best so far is taken.
const TRIES: u32 = 10;

/// Share of the triangle budget at which the search for a tolerance ends.
const ENOUGH: f64 = 0.98;

/// Tolerance of the first try, as a part of the map's scale.
const FIRST: f64 = 0.01;

/// Greatest factor by which the tolerance changes from one try to the next.
const MOST_STEP: f64 = 32.0;

impl Mesher {
    /// Makes the mesh of least error that has at most `most` triangles.
    ///
    /// Searches for the tolerance that gives `most` triangles or a few fewer. `settings` says
    /// everything else, as for [`within`](MeshSettings::within); its own tolerance is ignored.
    ///
    /// # Errors
    ///
    /// Fails as [`watched`](Self::watched) does, and when even the coarsest mesh has more than
    /// `most` triangles.
    pub fn with_at_most(
        mesh: &Mesh,
        map: &HeightMap,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let scale_m = map.scale_m();
        let mut error_m = if scale_m > 0.0 { FIRST * scale_m } else { 1.0 };
        // The greatest tolerance with too many triangles, and the least with few enough.
        let (mut fine, mut coarse) = (None, None);
        let mut best: Option<Self> = None;
        for turn in 0..TRIES {
            let [from, to] = [turn, turn + 1].map(|turn| turn as f32 / TRIES as f32);
            let watch = watch.piece(from, to);
            let settings = MeshSettings { error_m, ..*settings };
            match Self::of_at_most(mesh, map, &settings, most, &watch) {
                Ok(made) => {
                    let triangles = made.triangles() as f64;
                    coarse = Some(error_m);
                    best = Some(made);
                    if triangles >= ENOUGH * most as f64 {
                        break;
                    }
                    // Half of the tolerance takes about twice as many triangles.
                    let guess = error_m * (triangles / most as f64).max(1.0 / MOST_STEP) / 1.01;
                    error_m = between(guess, fine, coarse);
                }
                Err(MesherError::MoreThan { .. }) => {
                    fine = Some(error_m);
                    error_m = between(2.0 * error_m, fine, coarse);
                }
                // The tolerance is below what is possible.
                Err(MesherError::TooFine { .. } | MesherError::NotReached { .. }) if best.is_some() => {
                    fine = Some(error_m);
                    error_m = between(2.0 * error_m, fine, coarse);
                }
                Err(error) => return Err(error),
            }
            if best.as_ref().and_then(Self::certificate).is_some_and(Certificate::is_exact) {
                break;
            }
        }
        best.map_or_else(
            || Self::of_at_most(mesh, map, &MeshSettings { error_m: f64::MAX, ..*settings }, most, watch),
            Ok,
        )
    }
}

/// Returns the next tolerance to try: `guess` if it lies well between the known bounds, else their
/// geometric mean.
fn between(guess: f64, fine: Option<f64>, coarse: Option<f64>) -> f64 {
    match (fine, coarse) {
        (Some(fine), Some(coarse)) if !(fine * 1.002..coarse / 1.002).contains(&guess) => {
            (fine * coarse).sqrt()
        }
        _ => guess,
    }
}
