//! Choice of one texture for each role.

use std::cmp::Reverse;
use std::path::PathBuf;

use super::file_name::FileName;
use super::{FoundTexture, LeftReason, TextureRole};
use crate::{Format, GreenSign};

/// File whose role is recognised.
#[derive(Debug)]
pub struct Candidate {
    pub path: PathBuf,
    pub format: Format,
    pub name: FileName,
}

impl Candidate {
    pub fn role(&self) -> TextureRole {
        self.name.row.role
    }

    /// Returns what decides before resolution and format: whether the file is of its own tile,
    /// whether the role is at the end of its name, and the rank of the ending.
    fn fit(&self) -> (bool, bool, i8) {
        (self.name.tile.is_some(), self.name.is_at_end, self.name.row.rank)
    }

    /// Returns the order of choice; the greatest is taken.
    fn order(&self) -> impl Ord + use<> {
        let green = match self.name.row.green {
            Some(GreenSign::PlusY) => 2,
            Some(GreenSign::MinusY) => 1,
            None => 0,
        };
        (green, self.fit(), self.name.texels, Reverse(loss(self.format)))
    }

    /// Whether nothing in the names says which of two files is better.
    fn rivals(&self, other: &Self) -> bool {
        let same_size = match (self.name.texels, other.name.texels) {
            (Some(one), Some(other)) => one == other,
            _ => true,
        };
        let same_format = self.name.row.ending != other.name.row.ending || self.format == other.format;
        self.fit() == other.fit() && same_size && same_format
    }

    fn into_texture(self) -> FoundTexture {
        let FileName { row, tile, .. } = self.name;
        FoundTexture { path: self.path, role: row.role, green: row.green, udim: tile }
    }
}

/// Returns a number for what a format loses: floats lose least, JPEG most.
fn loss(format: Format) -> u8 {
    match format {
        Format::Exr => 0,
        Format::Tiff => 1,
        Format::Png => 2,
        Format::Pgm => 3,
        Format::Hdr => 4,
        Format::Webp => 5,
        Format::Jpeg => 6,
        Format::Raw => 7,
    }
}

/// Takes one file for each role, and leaves the others. Height maps that are equally good are all
/// left. The files must be in the order of their names.
pub fn choose(mut files: Vec<Candidate>, left: &mut Vec<(PathBuf, LeftReason)>) -> Vec<FoundTexture> {
    files.sort_by_key(|file| (file.role(), Reverse(file.order())));
    let mut textures = Vec::new();
    let mut files = files.into_iter().peekable();
    while let Some(best) = files.next() {
        let mut others = Vec::new();
        while let Some(other) = files.next_if(|file| file.role() == best.role()) {
            others.push(other);
        }
        let is_relief = matches!(best.role(), TextureRole::Height | TextureRole::Depth);
        let rival = others.iter().find(|other| is_relief && best.rivals(other));
        if let Some(rival) = rival {
            left.push((best.path.clone(), LeftReason::EquallyGood(rival.path.clone())));
        }
        let is_taken = rival.is_none();
        for other in others {
            let reason = if !is_taken && best.rivals(&other) {
                LeftReason::EquallyGood(best.path.clone())
            } else {
                reason(&best, &other)
            };
            left.push((other.path, reason));
        }
        if is_taken {
            textures.push(best.into_texture());
        }
    }
    leave_given(textures, left)
}

/// Returns the reason why `best` was taken in place of `other`.
fn reason(best: &Candidate, other: &Candidate) -> LeftReason {
    let by = best.path.clone();
    match (best.name.row.green, other.name.row.green) {
        (Some(green), Some(left)) if green != left => LeftReason::OtherGreen(by),
        _ if best.name.texels > other.name.texels && other.name.texels.is_some() => LeftReason::Coarser(by),
        _ => LeftReason::Taken(by),
    }
}

/// Packed roles, in the order in which they are used.
const PACKED: [TextureRole; 3] = [TextureRole::Orm, TextureRole::MaskMap, TextureRole::MetallicSmoothness];

/// Leaves textures all of whose values other textures give. Maps of one role go before packed ones.
fn leave_given(mut textures: Vec<FoundTexture>, left: &mut Vec<(PathBuf, LeftReason)>) -> Vec<FoundTexture> {
    let order = [TextureRole::Depth, TextureRole::Glossiness].into_iter().chain(PACKED);
    // Packed maps that were judged and stay.
    let mut kept: Vec<TextureRole> = Vec::new();
    for role in order {
        let Some(at) = textures.iter().position(|texture| texture.role == role) else { continue };
        let needed: &[(usize, TextureRole)] = match role {
            TextureRole::Depth => &[(0, TextureRole::Height)],
            TextureRole::Glossiness => &[(0, TextureRole::Roughness)],
            packed => packed.channels(),
        };
        let giver = |needed: TextureRole| {
            textures.iter().find(|texture| {
                let is_packed = kept.contains(&texture.role);
                texture.role != role
                    && (is_same(texture.role, needed)
                        || is_packed
                            && texture.role.channels().iter().any(|(_, gives)| is_same(*gives, needed)))
            })
        };
        let givers: Option<Vec<PathBuf>> =
            needed.iter().map(|(_, needed)| giver(*needed).map(|texture| texture.path.clone())).collect();
        match givers {
            Some(mut givers) => {
                givers.dedup();
                left.push((textures.remove(at).path, LeftReason::Given(givers)));
            }
            None if PACKED.contains(&role) => kept.push(role),
            None => {}
        }
    }
    textures
}

/// Whether two roles have the same meaning. Roughness is glossiness, and height depth, inverted.
fn is_same(one: TextureRole, other: TextureRole) -> bool {
    let plain = |role| match role {
        TextureRole::Glossiness => TextureRole::Roughness,
        TextureRole::Depth => TextureRole::Height,
        role => role,
    };
    plain(one) == plain(other)
}
