//! Advice on errors of the libraries: the flag, or the key of a scene file, that helps. The
//! libraries say what is wrong; they know no flags.

use std::io::ErrorKind;

use relief_io::{ForeignFormat, ReadNote, ReadProblem, TextureSetError, omissions};
use relief_mesh::motif::VectorSheetError;
use relief_render::{Reason, RenderError};
use relief_scene::SceneError;
use relief_scene::motif::{MotifFileError, MotifProblem};

/// Returns an error's text with advice.
pub fn with(error: &impl ToString, advice: Option<&str>) -> String {
    let text = error.to_string();
    advice.map_or(text.clone(), |advice| format!("{text}: {advice}"))
}

/// Returns an error's text with the flag that helps.
pub fn with_flag(error: &impl ToString, mend: Option<Advice>) -> String {
    with(error, mend.map(|mend| mend.flag))
}

/// Returns an error's text with the scene key that helps.
pub fn with_key(error: &impl ToString, mend: Option<Advice>) -> String {
    with(error, mend.map(|mend| mend.key))
}

/// Advice on an error.
#[derive(Clone, Copy)]
pub struct Advice {
    /// Text with a flag, for commands that have flags for the keys of a scene file.
    flag: &'static str,
    /// Text with a key of the scene file, for commands that take a scene file alone.
    key: &'static str,
}

impl Advice {
    /// Creates advice with a flag that all commands have.
    const fn everywhere(flag: &'static str) -> Self {
        Self { flag, key: flag }
    }
}

/// Returns what lets a height map be read.
pub fn of_read(problem: &ReadProblem) -> Option<Advice> {
    Some(match problem {
        ReadProblem::Unrecognised => Advice {
            flag: "for headerless 16-bit samples, use --raw 1024x1024,le (or be)",
            key: "for headerless 16-bit samples, use the key raw = \"1024x1024,le\" (or be)",
        },
        // Raw samples are unsigned, so the value that marks no height is 32768, not -32768.
        ReadProblem::Foreign(ForeignFormat::Srtm { side: 3601 }) => Advice {
            flag: "where no height is below 0, --raw 3601x3601,be --nodata 32768 reads it without its place",
            key: "where no height is below 0, the keys raw = \"3601x3601,be\" and nodata = 32768 read it \
                  without its place",
        },
        ReadProblem::Foreign(ForeignFormat::Srtm { .. }) => Advice {
            flag: "where no height is below 0, --raw 1201x1201,be --nodata 32768 reads it without its place",
            key: "where no height is below 0, the keys raw = \"1201x1201,be\" and nodata = 32768 read it \
                  without its place",
        },
        ReadProblem::NeedsRawLayout => Advice {
            flag: "use --raw 1024x1024,le (or be)",
            key: "use the key raw = \"1024x1024,le\" (or be)",
        },
        ReadProblem::RawSize { .. } => Advice { flag: "use --raw", key: "use the key 'raw'" },
        ReadProblem::ChooseChannel { .. } => {
            Advice { flag: "use --channel NAME", key: "use the key 'channel'" }
        }
        ReadProblem::NotGrey { .. } => Advice {
            flag: "use --channel NAME; --motif of `relief render` and `relief mesh` takes vector \
                   displacement maps",
            key: "use the key 'channel'",
        },
        ReadProblem::Holes { .. } => Advice { flag: "use --fill", key: "use the key fill = true" },
        _ => return of_picture(problem),
    })
}

/// Returns what lets a picture or a normal map be read. Their reading has no options.
pub fn of_picture(problem: &ReadProblem) -> Option<Advice> {
    match problem {
        ReadProblem::TooMuchMemory { .. } | ReadProblem::VolumeMemory { .. } => {
            Some(Advice::everywhere("use --max-memory"))
        }
        ReadProblem::Mask { problem, .. } => of_picture(problem),
        _ => None,
    }
}

/// Returns what is written behind a note: the flag, and the key of a scene file, that reads the
/// file in another way.
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
    } else if *row == omissions::BANDED {
        let text = "; `relief height deband` turns them into slopes";
        Some([text.to_owned(), text.to_owned()])
    } else if *row == omissions::DEEP_RELIEF {
        Some([
            ": give a smaller --scale; for ground give its metres instead, with --elevation LOW,HIGH and \
             --tile-size U,V"
                .to_owned(),
            ": give a smaller scale; for ground give its metres instead, with the keys elevation and \
             tile-size"
                .to_owned(),
        ])
    } else if *row == omissions::FOLDED_SHELLS {
        Some([
            ": give more tiles with --tile, a smaller --scale, or another --bias".to_owned(),
            ": give more tiles with tile, a smaller scale, or another bias".to_owned(),
        ])
    } else if *row == omissions::OTHER_GREEN {
        Some([
            ": if it is a DirectX map, give --green -y".to_owned(),
            ": if it is a DirectX map, give green = \"-y\"".to_owned(),
        ])
    } else if *row == omissions::OUTSIDE_TABLE {
        Some([
            ": state the elevations of heights 0 and 1 with --elevation LOW,HIGH".to_owned(),
            ": state the elevations of heights 0 and 1 with the key elevation".to_owned(),
        ])
    } else if *row == omissions::NAMED_LIKE_DEPTH {
        Some([" give --depth".to_owned(), " give depth = true".to_owned()])
    } else {
        None
    }
}

/// Returns what lets a mesh be read.
pub fn of_mesh(problem: &ReadProblem) -> Option<Advice> {
    match problem {
        ReadProblem::MeshMemory { .. } => Some(Advice::everywhere("use --max-memory")),
        problem if problem.is_of_texture_coordinates() => Some(Advice {
            flag: "use --project box, cylinder or sphere",
            key: "use the key project = \"box\", \"cylinder\" or \"sphere\"",
        }),
        ReadProblem::Part { problem, .. } => of_mesh(problem),
        _ => None,
    }
}

/// Returns what lets a motif be read.
pub fn of_motif(error: &MotifFileError) -> Option<Advice> {
    match error {
        MotifFileError::Read(error) => match &error.problem {
            ReadProblem::NoColour { .. } => Some(Advice {
                flag: "a height map is given in place of --motif, not by it",
                key: "a height map is given by the key height",
            }),
            problem => of_mesh(problem),
        },
        MotifFileError::Invalid { problem, .. } => match problem {
            MotifProblem::HeightMap => Some(Advice {
                flag: "give it in place of --motif",
                key: "use the key height in place of motif",
            }),
            MotifProblem::Memory { .. } => {
                Some(Advice::everywhere("use --max-memory, or make the map smaller"))
            }
            MotifProblem::Sheet(VectorSheetError::Far { .. }) => {
                Some(Advice { flag: "give a smaller --scale", key: "give a smaller scale" })
            }
            MotifProblem::AxesOfMesh => Some(Advice { flag: "leave --axes out", key: "leave axes out" }),
            _ => None,
        },
    }
}

/// Returns what lets a scene be loaded.
pub fn of_scene(error: &SceneError) -> Option<Advice> {
    match error {
        SceneError::NoHeightMap(_) => Some(Advice {
            flag: "give --height FILE, or the key in the scene file",
            key: "as in height = \"wall.png\"",
        }),
        SceneError::TooMuchMemory { .. }
        | SceneError::TooManySurfaces { .. }
        | SceneError::TooMuchToTrace { .. }
        | SceneError::TooMuchForShadowMaps { .. } => Some(Advice::everywhere("use --max-memory")),
        SceneError::Textures(error) => of_textures(error),
        SceneError::Read(error) => of_read(&error.problem),
        SceneError::Picture(error) => of_picture(&error.problem),
        SceneError::Ramp { .. } => Some(Advice {
            flag: "if its heights 0 and 1 stand for elevations, state them with --elevation LOW,HIGH; if its \
                   values are metres themselves, use --unit m",
            key: "if its heights 0 and 1 stand for elevations, state them with the key elevation = [LOW, \
                  HIGH]; if its values are metres themselves, use the key unit = \"m\"",
        }),
        SceneError::Mesh(error) => of_mesh(&error.problem),
        SceneError::Motif(error) => of_motif(error),
        SceneError::Io { source, .. }
            if matches!(source.kind(), ErrorKind::InvalidData | ErrorKind::FileTooLarge) =>
        {
            Some(Advice {
                flag: "to render a height map, use --height",
                key: "write a scene file that names the height map with the key 'height'",
            })
        }
        _ => None,
    }
}

/// Returns what lets a folder of textures be read.
pub fn of_textures(error: &TextureSetError) -> Option<Advice> {
    match error {
        TextureSetError::ChooseTile { .. } | TextureSetError::UnknownTile { .. } => {
            Some(Advice { flag: "use --udim", key: "use the key udim" })
        }
        TextureSetError::NoHeight { unnamed, .. } if !unnamed.is_empty() => {
            Some(Advice { flag: "use --height FILE", key: "use the key height" })
        }
        _ => None,
    }
}

/// Returns what lets a scene be rendered.
pub fn of_render(error: &RenderError) -> Option<&'static str> {
    match error {
        RenderError::FastOnCpu { no_gpu: true } => Some("no GPU was found: use --sampling exact"),
        RenderError::FastOnCpu { no_gpu: false } => Some("use --sampling exact"),
        RenderError::NoGpuBackend => Some("build with the feature 'gpu', or use --backend cpu"),
        _ => None,
    }
}

/// Returns what would lead to another backend.
pub fn of_reason(reason: &Reason) -> Option<&'static str> {
    match reason {
        Reason::SoftwareOnly(_) => Some("--backend gpu takes it all the same"),
        _ => None,
    }
}
