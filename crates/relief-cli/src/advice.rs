//! Which flag, or key of a scene file, mends what a library refuses. The libraries say what is wrong; they
//! know no flags.

use std::io::ErrorKind;

use relief_io::{ForeignFormat, ReadNote, ReadProblem, omissions};
use relief_render::{Reason, RenderError};
use relief_scene::SceneError;

/// An error's text, with what to do about it.
pub fn with(error: &impl ToString, advice: Option<&str>) -> String {
    let text = error.to_string();
    advice.map_or(text.clone(), |advice| format!("{text}: {advice}"))
}

/// An error's text, with the flag that mends it.
pub fn with_flag(error: &impl ToString, mend: Option<Mend>) -> String {
    with(error, mend.map(|mend| mend.flag))
}

/// An error's text, with the key of a scene file that mends it.
pub fn with_key(error: &impl ToString, mend: Option<Mend>) -> String {
    with(error, mend.map(|mend| mend.key))
}

/// What mends an error.
#[derive(Clone, Copy)]
pub struct Mend {
    /// The flag, for commands that have flags for what a scene file says.
    flag: &'static str,
    /// The key of the scene file, for commands that take a scene file alone.
    key: &'static str,
}

impl Mend {
    /// A flag that all commands have.
    const fn everywhere(flag: &'static str) -> Self {
        Self { flag, key: flag }
    }
}

/// What lets a height map be read.
pub fn of_read(problem: &ReadProblem) -> Option<Mend> {
    Some(match problem {
        ReadProblem::Unrecognised => Mend {
            flag: "headerless 16-bit samples are read with --raw 1024x1024,le (or be)",
            key: "headerless 16-bit samples are read with the key raw = \"1024x1024,le\" (or be)",
        },
        // Raw samples are unsigned: what marks no height is -32768.
        ReadProblem::Foreign(ForeignFormat::Srtm { side: 3601 }) => Mend {
            flag: "where no height is below 0, --raw 3601x3601,be --nodata 32768 reads it without its place",
            key: "where no height is below 0, the keys raw = \"3601x3601,be\" and nodata = 32768 read it without its \
                  place",
        },
        ReadProblem::Foreign(ForeignFormat::Srtm { .. }) => Mend {
            flag: "where no height is below 0, --raw 1201x1201,be --nodata 32768 reads it without its place",
            key: "where no height is below 0, the keys raw = \"1201x1201,be\" and nodata = 32768 read it without its \
                  place",
        },
        ReadProblem::NeedsRawLayout => Mend {
            flag: "--raw 1024x1024,le (or be) gives them",
            key: "the key raw = \"1024x1024,le\" (or be) gives them",
        },
        ReadProblem::RawSize { .. } => Mend { flag: "--raw gives them", key: "the key 'raw' gives them" },
        ReadProblem::ChooseChannel { .. } | ReadProblem::NotGrey { .. } => {
            Mend { flag: "--channel NAME does", key: "the key 'channel' does" }
        }
        ReadProblem::Holes { .. } => Mend { flag: "--fill does", key: "the key fill = true does" },
        _ => return of_picture(problem),
    })
}

/// What lets a picture or a normal map be read. How their files are read cannot be chosen.
pub fn of_picture(problem: &ReadProblem) -> Option<Mend> {
    match problem {
        ReadProblem::TooMuchMemory { .. } => Some(Mend::everywhere("--max-memory raises it")),
        ReadProblem::Mask { problem, .. } => of_picture(problem),
        _ => None,
    }
}

/// What reads a file in another way than a note says: what is written behind the note, with a flag or with
/// the key of a scene file.
pub fn of_note(note: &ReadNote) -> Option<[String; 2]> {
    let row = note.remark.row;
    let with = |number: &dyn Fn(&str) -> [String; 2]| note.remark.mend.as_deref().map(number);
    if *row == omissions::UNDECLARED_NODATA {
        with(&|number| [format!(" --nodata {number}"), format!(" nodata = {number}")])
    } else if *row == omissions::NARROW_RANGE {
        with(&|range| {
            [
                format!(": --range {range} gives it the whole depth, as --range auto does"),
                format!(": range = [{range}] gives it the whole depth, as range = \"auto\" does"),
            ]
        })
    } else if *row == omissions::FITTED_RANGE {
        with(&|range| [format!(", as with --range {range}"), format!(", as with range = [{range}]")])
    } else if *row == omissions::NAMED_LIKE_DEPTH {
        Some([" give --depth".to_owned(), " give depth = true".to_owned()])
    } else {
        None
    }
}

/// What lets a mesh be read.
pub fn of_mesh(problem: &ReadProblem) -> Option<Mend> {
    match problem {
        ReadProblem::MeshMemory { .. } => Some(Mend::everywhere("--max-memory raises it")),
        problem if problem.is_of_texture_coordinates() => Some(Mend {
            flag: "--project box, cylinder or sphere makes texture coordinates",
            key: "the key project = \"box\", \"cylinder\" or \"sphere\" makes texture coordinates",
        }),
        ReadProblem::Part { problem, .. } => of_mesh(problem),
        _ => None,
    }
}

/// What mends a scene.
pub fn of_scene(error: &SceneError) -> Option<Mend> {
    match error {
        SceneError::NoHeightMap(_) => Some(Mend {
            flag: "give --height FILE, or the key in the scene file",
            key: "as in height = \"wall.png\"",
        }),
        SceneError::TooMuchMemory { .. }
        | SceneError::TooManySurfaces { .. }
        | SceneError::TooMuchToTrace { .. }
        | SceneError::TooMuchForLights { .. } => Some(Mend::everywhere("--max-memory raises it")),
        SceneError::Read(error) => of_read(&error.problem),
        SceneError::Picture(error) => of_picture(&error.problem),
        SceneError::Mesh(error) => of_mesh(&error.problem),
        SceneError::Io { source, .. }
            if matches!(source.kind(), ErrorKind::InvalidData | ErrorKind::FileTooLarge) =>
        {
            Some(Mend {
                flag: "a height map is given with --height",
                key: "write a scene file that names the height map by the key 'height'",
            })
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
