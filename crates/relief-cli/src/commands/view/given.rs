//! The files that the page may name: those that the user has given or dropped, and nothing else.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use relief_scene::SceneSpec;

/// Files and folders that may be read.
#[derive(Clone, Default)]
pub struct Given(Arc<Mutex<Vec<PathBuf>>>);

impl Given {
    /// Adds the files that a scene names.
    pub fn of(spec: &SceneSpec) -> Self {
        let given = Self::default();
        spec.files().for_each(|file| given.add(file));
        given
    }

    /// Adds a file, or a folder with all that lies in it.
    pub fn add(&self, path: &Path) {
        let real = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(real);
    }

    /// Refuses a scene that names another file.
    pub fn check(&self, spec: &SceneSpec) -> Result<(), String> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let is_given = |file: &Path| match file.canonicalize() {
            Ok(real) => known.iter().any(|known| real.starts_with(known)),
            // A file that is not there may be named as it was, and in no other way.
            Err(_) => known.iter().any(|known| file == known),
        };
        match spec.files().find(|file| !is_given(file)) {
            None => Ok(()),
            Some(file) => Err(format!(
                "{}: it was neither given nor dropped: drop the file onto the page",
                file.display()
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_given_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir_all(at("inner")).expect("writable");
        for name in ["given.png", "other.png", "inner/a.png"] {
            std::fs::write(at(name), "").expect("writable");
        }
        let names = |path: PathBuf| {
            let mut spec = SceneSpec::default();
            spec.surface.height = Some(path);
            spec
        };
        let given = Given::of(&names(at("given.png")));
        assert_eq!(given.check(&names(at("given.png"))), Ok(()));
        assert_eq!(given.check(&names(at("inner/../given.png"))), Ok(()));
        for other in ["other.png", "inner/a.png", "given.png/..", "missing.png"] {
            assert!(given.check(&names(at(other))).is_err(), "{other}");
        }
        given.add(&at("inner"));
        assert_eq!(given.check(&names(at("inner/a.png"))), Ok(()));
        assert!(given.check(&names(at("inner/../other.png"))).is_err());
        let lit = SceneSpec { environment: Some(at("other.png")), ..names(at("given.png")) };
        assert!(given.check(&lit).is_err());
    }
}
