//! Errors of the mesher, with the flag that helps.

use relief_core::ByteSize;
use relief_mesh::MesherError;

use crate::failure::Failure;
use crate::interrupt;

/// Advice if a mesh is too large.
pub const COARSER: &str = "a larger --error, --texels or --pixels makes the mesh coarser, --tiles cuts it";

/// Turns a mesher's error into a failure. Its lengths are multiplied by `size`.
pub fn of_larger(error: MesherError, size: f64) -> Failure {
    of_mesher(match error {
        MesherError::BadTolerance { error_m } => MesherError::BadTolerance { error_m: error_m * size },
        MesherError::TooFine { error_m, least_m } => {
            MesherError::TooFine { error_m: error_m * size, least_m: least_m * size }
        }
        MesherError::NotReached { error_m, reached_m } => {
            MesherError::NotReached { error_m: error_m * size, reached_m: reached_m * size }
        }
        MesherError::BadSolid { solid_m } => MesherError::BadSolid { solid_m: solid_m * size },
        other => other,
    })
}

/// Turns a mesher's error into a failure.
pub fn of_mesher(error: MesherError) -> Failure {
    match error {
        MesherError::NoTexels => Failure::Usage(format!("--texels: {error}")),
        MesherError::Pair { .. } => Failure::usage(error),
        MesherError::NoView { .. } => Failure::Usage(format!("{error}: give one with --view SCENE.toml")),
        MesherError::BadWeights { .. } | MesherError::Weighted { .. } => {
            Failure::Usage(format!("--weights: {error}"))
        }
        MesherError::FineView { .. } => Failure::Work(format!("--pixels: {error}")),
        MesherError::BadView { .. } => Failure::Work(format!("--view: {error}")),
        MesherError::BadTolerance { .. } => Failure::Usage(format!("--error: {error}")),
        MesherError::TooFine { .. } | MesherError::NotReached { .. } => {
            Failure::Work(format!("--error: {error}: give a larger one, or --texels 1"))
        }
        MesherError::OnPlanesAlone { .. } => {
            Failure::Work(format!("{error}: leave it out, or divide the mesh's edges evenly with --texels N"))
        }
        MesherError::SideOfFold { .. } => Failure::Work(format!("--side: {error}: give a smaller --scale")),
        MesherError::SideOfSeams { .. } => Failure::Work(format!(
            "--side: {error}: use a map that repeats itself (--wrap, --tile), or leave gaps with --seams keep"
        )),
        MesherError::PartOfNoPlane | MesherError::TooManyParts { .. } => {
            Failure::Work(format!("--tiles: {error}"))
        }
        MesherError::BadSolid { .. }
        | MesherError::SolidOfClosed
        | MesherError::SolidOfView
        | MesherError::SolidBranches { .. }
        | MesherError::SolidTouches { .. } => Failure::Work(format!("--solid: {error}")),
        MesherError::SolidOfHoles => {
            Failure::Work(format!("--solid: {error}: leave --holes out, then holes are filled"))
        }
        MesherError::SolidOfSeams { .. } => Failure::Work(format!("--solid: {error}: give --seams weld")),
        MesherError::AllHoles => Failure::Work(format!("--holes: {error}")),
        MesherError::MoreThan { .. } => Failure::Work(format!("--triangles: {error}")),
        MesherError::NoMemory { limit } => Failure::Work(format!(
            "the mesh takes more than the {} allowed: --max-memory raises the limit, {COARSER}",
            ByteSize(limit)
        )),
        MesherError::TooLarge { .. } => Failure::Work(format!("{error}: {COARSER}")),
        MesherError::Cancelled(_) => interrupt::cancelled(),
        other => Failure::work(other),
    }
}
