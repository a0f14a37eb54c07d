//! The archive: the same bytes from the same files, whoever packs them and when.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use flate2::{Compression, GzBuilder};
use sha2::{Digest, Sha256};
use tar::{Builder, Header};

use super::at;

/// Packs a folder under `name` into a `.tar.gz`, in the order of names, without owners and times. Returns the
/// SHA-256 of the file in hexadecimal digits.
pub fn write(folder: &Path, name: &str, file: &Path) -> Result<String, String> {
    let mut paths = Vec::new();
    collect(folder, &mut paths)?;
    paths.sort();
    let out = File::create(file).map_err(at(file))?;
    let mut tar = Builder::new(GzBuilder::new().mtime(0).write(out, Compression::best()));
    for path in paths {
        let bytes = fs::read(&path).map_err(at(&path))?;
        let inside = path.strip_prefix(folder).map_err(|error| error.to_string())?;
        let mut header = Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(if inside == Path::new("relief") { 0o755 } else { 0o644 });
        header.set_mtime(0);
        tar.append_data(&mut header, Path::new(name).join(inside), &*bytes).map_err(at(file))?;
    }
    tar.into_inner().and_then(flate2::write::GzEncoder::finish).map_err(at(file))?;
    let digest = Sha256::digest(fs::read(file).map_err(at(file))?);
    Ok(digest.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Adds the files below a folder.
fn collect(folder: &Path, paths: &mut Vec<PathBuf>) -> Result<(), String> {
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let path = entry.map_err(at(folder))?.path();
        if path.is_dir() {
            collect(&path, paths)?;
        } else {
            paths.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_files_give_the_same_archive() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let packed = |name: &str, order: &[&str]| {
            let inside = folder.path().join(name);
            fs::create_dir_all(inside.join("man")).expect("a folder");
            for file in order {
                fs::write(inside.join(file), file).expect("a file");
            }
            let file = folder.path().join(format!("{name}.tar.gz"));
            (write(&inside, "relief-1", &file).expect("an archive"), fs::read(file).expect("its bytes"))
        };
        let one = packed("one", &["relief", "man/relief.1", "README.md"]);
        assert_eq!(one, packed("two", &["README.md", "man/relief.1", "relief"]));
        assert_ne!(one.0, packed("three", &["relief", "README.md"]).0);

        let mut archive = tar::Archive::new(flate2::read::GzDecoder::new(&*one.1));
        let entries = archive.entries().expect("entries").map(|entry| {
            let header = entry.expect("an entry").header().clone();
            (header.path().expect("a path").into_owned(), header.mode().expect("a mode"))
        });
        let expected = [("README.md", 0o644), ("man/relief.1", 0o644), ("relief", 0o755)];
        let expected = expected.map(|(file, mode)| (Path::new("relief-1").join(file), mode));
        assert_eq!(entries.collect::<Vec<_>>(), expected);
    }
}
