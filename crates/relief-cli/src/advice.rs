//! Which flag mends what a library refuses. The libraries say what is wrong; they know no flags.

use std::io::ErrorKind;

use relief_core::mesh::FramingError;
use relief_io::ReadProblem;
use relief_render::scene::SceneError;
use relief_render::{Reason, RenderError};

/// An error's text, with what to do about it.
pub fn with(error: &impl ToString, advice: Option<&str>) -> String {
    let text = error.to_string();
    advice.map_or(text.clone(), |advice| format!("{text}: {advice}"))
}

/// What lets a height map be read.
pub fn of_read(problem: &ReadProblem) -> Option<&'static str> {
    match problem {
        ReadProblem::Unrecognised => {
            Some("headerless 16-bit samples are read with --raw 1024x1024,le (or be)")
        }
        ReadProblem::NeedsRawLayout => Some("--raw 1024x1024,le (or be) gives them"),
        ReadProblem::RawSize { .. } => Some("--raw gives them"),
        ReadProblem::ChooseChannel { .. } | ReadProblem::NotGrey { .. } => Some("--channel NAME does"),
        ReadProblem::Holes { .. } => Some("--fill does"),
        _ => of_picture(problem),
    }
}

/// What lets a picture or a normal map be read. How their files are read cannot be chosen.
pub fn of_picture(problem: &ReadProblem) -> Option<&'static str> {
    match problem {
        ReadProblem::TooMuchMemory { .. } => Some("--max-memory raises it"),
        ReadProblem::Mask { problem, .. } => of_picture(problem),
        _ => None,
    }
}

/// What lets a mesh be read.
pub fn of_mesh(problem: &ReadProblem) -> Option<&'static str> {
    match problem {
        ReadProblem::MeshMemory { .. } => Some("--max-memory raises it"),
        ReadProblem::Mesh(FramingError::NoTextureCoordinates { .. } | FramingError::NoTextureArea { .. }) => {
            Some("--project box, cylinder or sphere makes texture coordinates")
        }
        ReadProblem::Part { problem, .. } => of_mesh(problem),
        _ => None,
    }
}

/// What mends a scene.
pub fn of_scene(error: &SceneError) -> Option<&'static str> {
    match error {
        SceneError::NoHeightMap(_) => Some("give --height FILE, or the key in the scene file"),
        SceneError::TooMuchMemory { .. }
        | SceneError::TooMuchToTrace { .. }
        | SceneError::TooMuchForLights { .. } => Some("--max-memory raises it"),
        SceneError::Read(error) => of_read(&error.problem),
        SceneError::Picture(error) => of_picture(&error.problem),
        SceneError::Mesh(error) => of_mesh(&error.problem),
        SceneError::Io { source, .. }
            if matches!(source.kind(), ErrorKind::InvalidData | ErrorKind::FileTooLarge) =>
        {
            Some("a height map is given with --height")
        }
        _ => None,
    }
}

/// What lets a scene be rendered.
pub fn of_render(error: &RenderError) -> Option<&'static str> {
    match error {
        RenderError::FastOnCpu { no_gpu: true } => Some("no GPU was found: use --sampling exact"),
        RenderError::FastOnCpu { no_gpu: false } => Some("use --sampling exact"),
        RenderError::NoGpuBackend => Some("build with the feature 'gpu', or use --backend cpu"),
        _ => None,
    }
}

/// What would have led to another backend.
pub fn of_reason(reason: &Reason) -> Option<&'static str> {
    match reason {
        Reason::SoftwareOnly(_) => Some("--backend gpu takes it"),
        _ => None,
    }
}
