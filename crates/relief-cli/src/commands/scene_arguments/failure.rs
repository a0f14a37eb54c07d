//! Failures of scenes, with the flag or the key to blame.

use relief_scene::{SceneError, ValueError, ValueProblem};

use crate::advice;
use crate::failure::Failure;

/// Turns a scene's error into a failure. A value that cannot be used came from the flags, since a
/// scene file's values are checked when it is read.
pub fn of_scene(error: SceneError) -> Failure {
    match error {
        SceneError::Value(ValueError { key, problem: ValueProblem::Needs(other), .. }) => {
            Failure::Usage(format!("--{key}: needs --{other} as well"))
        }
        // A flag holds for every surface, so the surface that the error names says nothing.
        SceneError::Value(ValueError { key, problem, .. }) => {
            Failure::Usage(format!("--{}: {problem}", blamed(key, &problem)))
        }
        SceneError::NoHeightMap(_) => Failure::Usage(advice::with_flag(&error, advice::of_scene(&error))),
        other => Failure::Work(advice::with_flag(&other, advice::of_scene(&other))),
    }
}

/// Returns the flag to blame for a value that cannot be used. Of stages that do not go together
/// this is the one that was given, not one whose variant follows from a default.
fn blamed(key: &'static str, problem: &ValueProblem) -> &'static str {
    let is_given = |key: &&str| {
        let flag = format!("--{key}");
        std::env::args_os().any(|word| {
            let word = word.to_string_lossy();
            word == flag || word.strip_prefix(&flag).is_some_and(|rest| rest.starts_with('='))
        })
    };
    let ValueProblem::Selection(error) = problem else { return key };
    if is_given(&key) {
        return key;
    }
    let others = error.keys().into_iter().chain(["method"]);
    others.into_iter().find(is_given).unwrap_or(key)
}

/// Turns a scene's error into a failure, for commands that take a scene file and no flags for its
/// keys.
pub fn of_scene_file(error: SceneError) -> Failure {
    Failure::Work(advice::with_key(&error, advice::of_scene(&error)))
}
