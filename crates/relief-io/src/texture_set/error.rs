//! Errors of finding a set of textures.

use std::io;
use std::path::PathBuf;

use relief_core::registry::listed;

/// Most entries of a folder that is searched.
pub(super) const MOST_ENTRIES: usize = 4096;

/// Reason why a folder gives no set of textures.
#[derive(Debug, thiserror::Error)]
pub enum TextureSetError {
    /// The folder cannot be read, or is no folder.
    #[error("{}: cannot be read as a folder ({source}): give a folder of textures", folder.display())]
    Folder {
        /// The path given.
        folder: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// The folder has too many entries.
    #[error(
        "{}: has more than {MOST_ENTRIES} entries: put the textures into a folder of their own",
        folder.display()
    )]
    TooMany {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder has no picture, judged by the names.
    #[error(
        "{}: has no file that is named as a picture, such as .png, .jpg, .exr or .tif: \
         give a folder of textures",
        folder.display()
    )]
    NoPicture {
        /// The folder.
        folder: PathBuf,
    },
    /// The names belong to several sets.
    #[error(
        "{}: has textures of several sets, {}: put each set into a folder of its own",
        folder.display(),
        listed(names)
    )]
    SeveralSets {
        /// The folder.
        folder: PathBuf,
        /// Names of the sets.
        names: Vec<String>,
    },
    /// The set has several UDIM tiles and none was chosen.
    #[error("{}: has the UDIM tiles {}: choose one", folder.display(), listed(&texts(tiles)))]
    ChooseTile {
        /// The folder.
        folder: PathBuf,
        /// Numbers of the tiles.
        tiles: Vec<u32>,
    },
    /// The set lacks the UDIM tile that was chosen.
    #[error(
        "{}: has no texture of the UDIM tile {tile}; {}",
        folder.display(),
        if tiles.is_empty() { "its names have no tiles: give no number".to_owned() }
        else { format!("its tiles are {}: choose one", listed(&texts(tiles))) }
    )]
    UnknownTile {
        /// The folder.
        folder: PathBuf,
        /// Number that was given.
        tile: u32,
        /// Numbers of the tiles that are there.
        tiles: Vec<u32>,
    },
    /// The set has no height map.
    #[error(
        "the set '{name}' has no height map, which is needed; {}: {}",
        if recognised.is_empty() { "no name was recognised".to_owned() }
        else { format!("it has {}", listed(recognised)) },
        match &unnamed[..] {
            [] => "add one, named as NAME_height.png".to_owned(),
            [one] => format!("if {one} is the height map, name it as the height, or rename it as in \
                              NAME_height.png"),
            several => format!("if one of {} is the height map, name it as the height, or rename it as in \
                                NAME_height.png", listed(several)),
        }
    )]
    NoHeight {
        /// Name of the set.
        name: String,
        /// Files that were recognised, with their roles.
        recognised: Vec<String>,
        /// Pictures whose names tell no role, at most four.
        unnamed: Vec<String>,
    },
    /// Several height maps are equally good.
    #[error(
        "the set '{name}' has several height maps, {}: remove all but one, or name the one to use",
        listed(files)
    )]
    SeveralHeights {
        /// Name of the set.
        name: String,
        /// Names of the files.
        files: Vec<String>,
    },
}

fn texts(numbers: &[u32]) -> Vec<String> {
    numbers.iter().map(u32::to_string).collect()
}
