//! Textures of a material in a folder, recognised by their names.
//!
//! `names.rs` has the table of endings and their schemes. Contents of files are not read.

mod choose;
mod error;
mod file_name;
mod names;
mod role;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};

pub use self::error::TextureSetError;
pub use self::role::TextureRole;

pub(crate) use self::names::is_height_word;

use self::choose::{Candidate, choose};
use self::error::MOST_ENTRIES;
use self::file_name::{FileName, RESOLUTION_OR_TILE};
use crate::{Format, GreenSign, Source};

/// Most pictures without a role that an error names.
const MOST_UNNAMED: usize = 4;

/// Texture whose role is recognised.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundTexture {
    /// Path of the file.
    pub path: PathBuf,
    /// Role of the texture.
    pub role: TextureRole,
    /// Direction of green, of a normal map whose name tells it.
    pub green: Option<GreenSign>,
    /// Number of the UDIM tile in the name.
    pub udim: Option<u32>,
}

/// Reason why a file is not in a set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LeftReason {
    /// The file is not named as a picture that is read.
    NotPicture,
    /// The name has no ending of a texture.
    NotRecognised,
    /// Another file was taken for the role.
    Taken(PathBuf),
    /// A finer file was taken for the role, judged by the resolutions in the names.
    Coarser(PathBuf),
    /// A normal map with the other direction of green was taken.
    OtherGreen(PathBuf),
    /// Another height map is equally good, so that neither was taken.
    EquallyGood(PathBuf),
    /// The file is of another UDIM tile.
    OtherTile(u32),
    /// Other textures give all that this one gives.
    Given(Vec<PathBuf>),
}

impl fmt::Display for LeftReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPicture => f.write_str("is not named as a picture that is read"),
            Self::NotRecognised => f.write_str("has no name of a texture"),
            Self::Taken(by) => write!(f, "{} was taken for its role", file_name(by)),
            Self::Coarser(by) => write!(f, "{} is finer", file_name(by)),
            Self::OtherGreen(by) => write!(f, "{} has the other direction of green", file_name(by)),
            Self::EquallyGood(other) => write!(f, "{} is equally good", file_name(other)),
            Self::OtherTile(tile) => write!(f, "is of the UDIM tile {tile}"),
            Self::Given(by) => {
                let names: Vec<String> = by.iter().map(|path| file_name(path)).collect();
                write!(f, "its values are in {}", names.join(", "))
            }
        }
    }
}

/// Textures of one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureSet {
    /// Name that the files share, or the folder's if they are named by their roles alone.
    pub name: String,
    /// Textures in the order of their roles, one for each role.
    pub textures: Vec<FoundTexture>,
    /// Other files of the folder in the order of their names, hidden ones left out.
    pub left: Vec<(PathBuf, LeftReason)>,
}

impl TextureSet {
    /// Returns the texture of a role. None if the set has none; see [`channel`](Self::channel) for
    /// packed maps.
    pub fn texture(&self, role: TextureRole) -> Option<&FoundTexture> {
        self.textures.iter().find(|texture| texture.role == role)
    }

    /// Returns the packed map that gives a role, and the channel: 0 is red, 3 is alpha. None if no
    /// packed map gives it, or if the set has a texture of this role alone, which goes before it.
    pub fn channel(&self, role: TextureRole) -> Option<(&FoundTexture, usize)> {
        if self.texture(role).is_some() {
            return None;
        }
        self.textures.iter().find_map(|texture| {
            let (channel, _) = texture.role.channels().iter().find(|(_, gives)| *gives == role)?;
            Some((texture, *channel))
        })
    }

    /// Returns the set with a file for a role, in place of the set's own. A height map replaces a depth
    /// map, and the other way round; roughness replaces glossiness likewise. Other files are not read
    /// here, and maps of one role go before packed ones.
    #[must_use]
    pub fn with(mut self, role: TextureRole, path: PathBuf) -> Self {
        let rivals =
            [[TextureRole::Height, TextureRole::Depth], [TextureRole::Roughness, TextureRole::Glossiness]];
        let replaces = |other: TextureRole| {
            other == role || rivals.iter().any(|pair| pair.contains(&role) && pair.contains(&other))
        };
        self.textures.retain(|texture| {
            let is_kept = !replaces(texture.role);
            if !is_kept && texture.path != path {
                self.left.push((texture.path.clone(), LeftReason::Taken(path.clone())));
            }
            is_kept
        });
        self.left.retain(|(left, _)| *left != path);
        self.left.sort_by(|(one, _), (other, _)| one.cmp(other));
        self.textures.push(FoundTexture { path, role, green: None, udim: None });
        self.textures.sort_by_key(|texture| texture.role);
        self
    }

    /// Returns the set without the texture of a role.
    #[must_use]
    pub fn without(mut self, role: TextureRole) -> Self {
        self.textures.retain(|texture| texture.role != role);
        self
    }

    /// Returns the height map, or the depth map of a set without one.
    ///
    /// # Errors
    ///
    /// When the set has no height map, or several that are equally good.
    pub fn height(&self) -> Result<&FoundTexture, TextureSetError> {
        let of_depth = || self.texture(TextureRole::Depth);
        if let Some(texture) = self.texture(TextureRole::Height).or_else(of_depth) {
            return Ok(texture);
        }
        let rivals = self.left.iter().filter(|(_, reason)| matches!(reason, LeftReason::EquallyGood(_)));
        let files: Vec<String> = rivals.map(|(path, _)| file_name(path)).collect();
        let name = self.name.clone();
        if files.is_empty() {
            let unnamed = self.left.iter().filter(|(_, why)| *why == LeftReason::NotRecognised);
            let named = |texture: &FoundTexture| format!("{} ({})", file_name(&texture.path), texture.role);
            return Err(TextureSetError::NoHeight {
                name,
                recognised: self.textures.iter().map(named).collect(),
                unnamed: unnamed.map(|(path, _)| file_name(path)).take(MOST_UNNAMED).collect(),
            });
        }
        Err(TextureSetError::SeveralHeights { name, files })
    }
}

/// Finds the textures of a material in a folder, by the endings of their names. Subfolders and
/// hidden files are not searched.
///
/// It knows the endings that ambientCG, Poly Haven, Substance, Unreal, Unity, Blender's Node
/// Wrangler and Poliigon use, and German words. Of several files for a role the finest is taken,
/// judged by the resolution in the name, then the format that loses least. OpenGL's normal maps go
/// before DirectX's, and maps of one role before packed ones.
///
/// `udim` chooses a UDIM tile. It is needed if the names have several tiles; files without a tile
/// belong to all.
///
/// # Errors
///
/// When the folder cannot be read, has more than 4096 entries, has no picture or the pictures of
/// several materials, or when the tile is missing. A set without a height map is no error here, but
/// of [`TextureSet::height`].
///
/// # Examples
///
/// ```
/// use relief_io::{GreenSign, TextureRole, find_textures};
///
/// # let folder = tempfile::tempdir()?;
/// # let folder = folder.path();
/// for map in ["Color", "Displacement", "NormalDX", "NormalGL", "Roughness"] {
///     std::fs::write(folder.join(format!("Bricks090_2K-PNG_{map}.png")), "")?;
/// }
/// let set = find_textures(folder, None)?;
/// assert_eq!(set.name, "Bricks090");
/// assert!(set.height()?.path.ends_with("Bricks090_2K-PNG_Displacement.png"));
/// let normals = set.texture(TextureRole::Normal).ok_or("no normals")?;
/// assert_eq!(normals.green, Some(GreenSign::PlusY));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn find_textures<'a>(
    folder: impl Into<Source<'a>>,
    udim: Option<u32>,
) -> Result<TextureSet, TextureSetError> {
    let source = folder.into();
    let folder = source.name();
    let mut left = Vec::new();
    let mut files = Vec::new();
    let mut has_picture = false;
    for path in entries(source)? {
        let is_file = || source.with_name(&path).is_file().is_ok_and(|is_file| is_file);
        let format = Format::by_name(&path).filter(|format| *format != Format::Raw && is_file());
        let name = path.file_stem().and_then(|stem| FileName::read(&stem.to_string_lossy()));
        has_picture |= format.is_some();
        match (format, name) {
            (None, _) => left.push((path, LeftReason::NotPicture)),
            (_, None) => left.push((path, LeftReason::NotRecognised)),
            (Some(format), Some(name)) => files.push(Candidate { path, format, name }),
        }
    }
    if !has_picture {
        return Err(TextureSetError::NoPicture { folder: folder.to_owned() });
    }
    let name = name_of_set(source, &files)?;
    let files = files_of_tile(folder, files, udim, &mut left)?;
    let textures = choose(files, &mut left);
    left.sort_by(|(one, _), (other, _)| one.cmp(other));
    Ok(TextureSet { name, textures, left })
}

/// Returns the name of a material that a file belongs to: its name without the ending that tells what
/// the texture holds, as in `wall` of `wall_height.png`. The whole name where that is all.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use relief_io::material_name;
///
/// assert_eq!(material_name(Path::new("maps/Bricks090_2K-PNG_Displacement.png")), "Bricks090");
/// assert_eq!(material_name(Path::new("rock023.png")), "rock023");
/// assert_eq!(material_name(Path::new("height.png")), "height");
/// ```
pub fn material_name(path: &Path) -> String {
    let name = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy();
    let stem = FileName::read(&name).map(|read| read.stem).filter(|stem| !stem.is_empty());
    stem.unwrap_or_else(|| name.into_owned())
}

/// Returns the entries of a folder that are neither folders nor hidden, in the order of their names.
fn entries(source: Source<'_>) -> Result<Vec<PathBuf>, TextureSetError> {
    let folder = source.name();
    let names = source.entries(MOST_ENTRIES + 1);
    let mut names = names.map_err(|source| TextureSetError::Folder { folder: folder.to_owned(), source })?;
    if names.len() > MOST_ENTRIES {
        return Err(TextureSetError::TooMany { folder: folder.to_owned() });
    }
    names.retain(|name| !name.to_string_lossy().starts_with('.'));
    let mut paths: Vec<PathBuf> = names.into_iter().map(|name| folder.join(name)).collect();
    paths.retain(|path| !source.with_name(path).is_folder());
    paths.sort();
    Ok(paths)
}

/// Returns the name that all files share.
fn name_of_set(source: Source<'_>, files: &[Candidate]) -> Result<String, TextureSetError> {
    let mut names: BTreeMap<&str, &str> = BTreeMap::new();
    for FileName { key, stem, .. } in files.iter().map(|file| &file.name) {
        if !key.is_empty() {
            names.entry(key).or_insert(stem);
        }
    }
    let folder = source.name().to_owned();
    let several = |names: Vec<String>| TextureSetError::SeveralSets { folder: folder.clone(), names };
    if names.len() > 1 {
        return Err(several(names.into_values().map(str::to_owned).collect()));
    }
    let folder_name = || file_name(&source.real_name());
    let name = names.into_values().next().map_or_else(folder_name, str::to_owned);
    // What follows the role tells copies of one file apart, or sets, as in `T_Sand_BC_01`.
    let mut roles: BTreeMap<&str, BTreeSet<TextureRole>> = BTreeMap::new();
    for file in files {
        roles.entry(&file.name.variant).or_default().insert(file.role());
    }
    roles.retain(|_, roles| roles.len() > 1);
    if roles.len() > 1 {
        let named = |variant: &str| format!("{name} {variant}").trim_end().to_owned();
        return Err(several(roles.into_keys().map(named).collect()));
    }
    Ok(name)
}

/// Returns the files of the tile that was chosen, and those without a tile.
fn files_of_tile(
    folder: &Path,
    mut files: Vec<Candidate>,
    udim: Option<u32>,
    left: &mut Vec<(PathBuf, LeftReason)>,
) -> Result<Vec<Candidate>, TextureSetError> {
    if files.iter().any(|file| file.name.tile.is_some()) {
        let unclear = |name: &&mut FileName| name.tile.is_none() && name.may_be_tile;
        for name in files.iter_mut().map(|file| &mut file.name).filter(unclear) {
            (name.tile, name.texels) = (Some(RESOLUTION_OR_TILE), None);
        }
    }
    let tiles: BTreeSet<u32> = files.iter().filter_map(|file| file.name.tile).collect();
    let listed = || tiles.iter().copied().collect();
    let Some(chosen) = udim else {
        if tiles.len() > 1 {
            return Err(TextureSetError::ChooseTile { folder: folder.to_owned(), tiles: listed() });
        }
        return Ok(files);
    };
    if !tiles.contains(&chosen) {
        return Err(TextureSetError::UnknownTile {
            folder: folder.to_owned(),
            tile: chosen,
            tiles: listed(),
        });
    }
    let mut kept = Vec::new();
    for file in files {
        match file.name.tile {
            Some(tile) if tile != chosen => left.push((file.path, LeftReason::OtherTile(tile))),
            _ => kept.push(file),
        }
    }
    Ok(kept)
}

/// Returns a path's last part, for messages.
fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
