//! Folders of sources, and the counts of a whole tree.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::phrases::{self, PHRASES};
use crate::rust::{self, Kind};
use crate::sentences::{self, Lengths};

/// Folders that hold no sources: builds, generated files, and packages of other people.
const LEFT_OUT: [&str; 4] = ["target", "generated", "node_modules", "vendor"];

/// The files below `folder` with one of the extensions, sorted by path. Hidden folders, builds and
/// generated files are left out.
///
/// # Errors
///
/// When a folder cannot be read.
pub fn files(folder: &Path, extensions: &[&str]) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder)? {
            let entry = entry?;
            let path = entry.path();
            let name = entry.file_name();
            let name = name.to_string_lossy();
            if entry.file_type()?.is_dir() {
                if !name.starts_with('.') && !LEFT_OUT.contains(&&*name) {
                    folders.push(path);
                }
            } else if extensions.iter().any(|wanted| path.extension().is_some_and(|is| is == *wanted)) {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// The words of a tree.
#[derive(Clone, Debug, Default)]
pub struct Counts {
    /// Lines of Rust and WESL that hold a comment or a part of one.
    pub comment_lines: usize,
    /// Worn phrases in these comments, in the order of [`PHRASES`].
    pub in_comments: [usize; PHRASES.len()],
    /// Worn phrases in string literals.
    pub in_literals: [usize; PHRASES.len()],
    /// Sentence lengths of the markdown files in the tree's root, by file name.
    pub pages: Vec<(String, Lengths)>,
}

impl Counts {
    /// Counts the tree below `folder`.
    ///
    /// # Errors
    ///
    /// When a folder or a file cannot be read.
    pub fn of(folder: &Path) -> io::Result<Self> {
        let mut counts = Self::default();
        for file in files(folder, &["rs", "wesl"])? {
            for passage in rust::passages(&read(&file)?) {
                let counted = match passage.kind {
                    Kind::Literal => &mut counts.in_literals,
                    _ => {
                        counts.comment_lines += passage.lines();
                        &mut counts.in_comments
                    }
                };
                for worn in phrases::worn(&passage.text) {
                    counted[worn.phrase] += 1;
                }
            }
        }
        for file in files(folder, &["md"])?.iter().filter(|file| file.parent() == Some(folder)) {
            let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
            counts.pages.push((name, sentences::lengths(&sentences::sentences(&read(file)?))));
        }
        Ok(counts)
    }

    /// Worn phrases in comments per 1,000 comment lines.
    pub fn per_thousand(&self) -> f64 {
        1000.0 * self.in_comments.iter().sum::<usize>() as f64 / self.comment_lines.max(1) as f64
    }
}

/// The text of a file; what is no UTF-8 is replaced.
fn read(file: &Path) -> io::Result<String> {
    Ok(String::from_utf8_lossy(&fs::read(file)?).into_owned())
}
