//! Links to scenes: what they need of given files, and which of these are still missing.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use relief_io::{Files, MemoryFiles};
use relief_scene::SceneSpec;
use relief_session::{Link, LinkError, LinkedFile};

use crate::given::{Given, inside};

/// Digits of a hash in a link.
const HASH_DIGITS: usize = 16;

/// A file that a link names and that has not come yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Where the scene has it.
    pub path: PathBuf,
    hash: String,
}

/// Returns the text of a link to a scene, with all files of the groups that it names files of. Groups are
/// counted anew from 1.
///
/// # Errors
///
/// When it would be too long.
pub fn link_to(spec: &SceneSpec, given: &Given, files: &MemoryFiles) -> Result<String, LinkError> {
    let mut spec = spec.clone();
    let used: BTreeSet<String> = spec.files().filter_map(|file| group_of(file, given.root())).collect();
    let numbers: BTreeMap<String, usize> = used.into_iter().zip(1..).collect();
    let renumbered = |path: &Path| {
        let inside = path.strip_prefix(given.root()).ok()?;
        let number = numbers.get(&group_of(path, given.root())?)?;
        Some(given.root().join(number.to_string()).join(inside.iter().skip(1).collect::<PathBuf>()))
    };
    let of_group = files.paths().filter_map(|path| {
        let hash = hash_of(files.get(path)?);
        Some(LinkedFile { path: renumbered(path)?.to_str()?.to_owned(), hash })
    });
    let linked = of_group.collect();
    for file in spec.files_mut() {
        if let Some(path) = renumbered(file) {
            *file = path;
        }
    }
    Link { spec, files: linked }.to_text()
}

/// Reads a link, and returns its scene with the files that it needs. Other files are of the sample.
///
/// # Errors
///
/// When it is no link, or names a file that is neither given nor of the sample.
pub fn read_link(text: &str, given: &Given, files: &Files) -> Result<(SceneSpec, Vec<Wanted>), LinkError> {
    let Link { spec, files: linked } = Link::read(text)?;
    let is_given = |path: &Path| {
        path.strip_prefix(given.root()).is_ok_and(|rest| rest.to_str().and_then(inside).is_some())
    };
    let mut wanted = Vec::with_capacity(linked.len());
    for LinkedFile { path, hash } in linked {
        let path = PathBuf::from(path);
        if !is_given(&path) {
            return Err(LinkError::Damaged(format!("{}: it is no path of a dropped file", path.display())));
        }
        wanted.push(Wanted { path, hash });
    }
    for file in spec.files() {
        let is_wanted = wanted.iter().any(|wanted| wanted.path.starts_with(file));
        if !is_wanted && (is_given(file) || files.stamp(file).is_none()) {
            return Err(LinkError::Damaged(format!("{}: there is no such sample", file.display())));
        }
    }
    Ok((spec, wanted))
}

/// Puts files where a link wants them, by their content, and forgets what is there. Returns the paths that
/// were found.
pub fn put(wanted: &mut Vec<Wanted>, come: &[PathBuf], files: &mut MemoryFiles) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for file in come {
        let Some(bytes) = files.get(file).cloned() else { continue };
        let hash = hash_of(&bytes);
        wanted.retain(|wanted| {
            let is_put = wanted.hash == hash && files.insert(&wanted.path, bytes.clone()).is_ok();
            if is_put {
                found.push(wanted.path.clone());
            }
            !is_put
        });
    }
    found
}

/// The part of a path below the folder of given files that counts its group.
fn group_of(path: &Path, root: &Path) -> Option<String> {
    Some(path.strip_prefix(root).ok()?.iter().next()?.to_str()?.to_owned())
}

fn hash_of(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex()[..HASH_DIGITS].to_owned()
}
