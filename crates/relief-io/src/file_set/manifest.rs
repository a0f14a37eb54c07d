//! Manifest of complete files: their names, lengths and hashes, and the identity of their inputs.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// First line of a manifest.
const BEGIN: &str = "relief manifest 1";

/// Greatest number of bytes of a manifest that are read.
const MOST_BYTES: u64 = 16 << 20;

/// List of files in parts, each made from one input. It is written as the last file of a set, and
/// records which files are complete.
///
/// The text consists of lines: first the version; for each part `part NAME` and `made-from
/// IDENTITY`, then for each of its files `file BYTES BLAKE3 NAME`; at the end `end BLAKE3` of all
/// lines before. In names, a control character or `%` is written as `%` with the two hexadecimal
/// digits of each of its bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    parts: Vec<Part>,
}

/// Files that were written together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Name of the part, unique in the manifest.
    pub name: String,
    /// Identity of the inputs, such as a hash.
    pub made_from: String,
    /// Files of the part.
    pub files: Vec<ListedFile>,
}

/// File of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedFile {
    /// Name in the manifest's folder.
    pub name: String,
    /// Length in bytes.
    pub bytes: u64,
    /// BLAKE3 hash of the content, in hexadecimal digits.
    pub hash: String,
}

/// State of the file at a manifest's path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ManifestState {
    /// There is no file.
    Missing,
    /// The file is a valid manifest.
    Valid(Manifest),
    /// The file begins as a manifest, but is damaged.
    Damaged,
    /// The file is something else.
    OtherFile,
}

impl Manifest {
    /// Reads the manifest at a path.
    ///
    /// # Errors
    ///
    /// When a file exists and cannot be read.
    pub fn find(path: &Path) -> io::Result<ManifestState> {
        match fs::metadata(path) {
            Ok(about) if !about.is_file() => return Ok(ManifestState::OtherFile),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(ManifestState::Missing),
            found => found?,
        };
        let mut bytes = Vec::new();
        File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
        if !bytes.starts_with(BEGIN.as_bytes()) {
            return Ok(ManifestState::OtherFile);
        }
        let text = std::str::from_utf8(&bytes).ok();
        Ok(text.and_then(Self::parse).map_or(ManifestState::Damaged, ManifestState::Valid))
    }

    /// Returns the manifest's text. Equal manifests have the same text.
    pub fn to_text(&self) -> String {
        let mut text = format!("{BEGIN}\n");
        let mut line = |key: &str, value: &str| {
            // Writing to a text does not fail.
            let _ = writeln!(text, "{key} {value}");
        };
        for Part { name, made_from, files } in &self.parts {
            line("part", &escaped(name));
            line("made-from", &escaped(made_from));
            for ListedFile { name, bytes, hash } in files {
                line("file", &format!("{bytes} {hash} {}", escaped(name)));
            }
        }
        let hash = blake3::hash(text.as_bytes()).to_hex();
        text + "end " + &hash + "\n"
    }

    fn parse(text: &str) -> Option<Self> {
        let (body, end) = text.strip_suffix('\n')?.rsplit_once("\nend ")?;
        let hashed = text.get(..=body.len())?;
        if blake3::hash(hashed.as_bytes()).to_hex().as_str() != end {
            return None;
        }
        let mut lines = body.lines();
        if lines.next() != Some(BEGIN) {
            return None;
        }
        let mut manifest = Self::default();
        while let Some(line) = lines.next() {
            match line.split_once(' ')? {
                ("part", name) => {
                    let made_from = plain(lines.next()?.strip_prefix("made-from ")?)?;
                    manifest.parts.push(Part { name: plain(name)?, made_from, files: Vec::new() });
                }
                ("file", about) => {
                    let [bytes, hash, name] = about.splitn(3, ' ').collect::<Vec<_>>().try_into().ok()?;
                    let (bytes, hash) = (bytes.parse().ok()?, hash.to_owned());
                    let name = plain(name).filter(|name| is_file_name(name))?;
                    let file = ListedFile { name, bytes, hash };
                    manifest.parts.last_mut()?.files.push(file);
                }
                _ => return None,
            }
        }
        Some(manifest)
    }

    /// Parts in the order of their names.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// Returns the part `name`.
    pub fn part(&self, name: &str) -> Option<&Part> {
        self.parts.iter().find(|part| part.name == name)
    }

    /// Inserts a part, replacing the one of the same name.
    pub fn set(&mut self, part: Part) {
        self.parts.retain(|other| other.name != part.name);
        let place = self.parts.partition_point(|other| other.name < part.name);
        self.parts.insert(place, part);
    }

    /// Whether any part lists a file of that name.
    pub fn lists(&self, file: &str) -> bool {
        self.parts.iter().any(|part| part.files.iter().any(|listed| listed.name == file))
    }

    /// Returns the part `name` if it was made from `made_from` and all of its files in the folder
    /// are as listed.
    pub fn whole(&self, folder: &Path, name: &str, made_from: &str) -> Option<&Part> {
        let part = self.part(name).filter(|part| part.made_from == made_from && !part.files.is_empty())?;
        part.files.iter().all(|file| file.is_in(folder)).then_some(part)
    }
}

impl ListedFile {
    /// Hashes the file at `path`, to be listed as `name`.
    ///
    /// # Errors
    ///
    /// When the file cannot be read, or is not a regular file.
    pub fn of(path: &Path, name: &str) -> io::Result<Self> {
        if !fs::metadata(path)?.is_file() {
            return Err(io::Error::other("it is not a regular file"));
        }
        let mut hasher = blake3::Hasher::new();
        hasher.update_reader(File::open(path)?)?;
        let (bytes, hash) = (hasher.count(), hasher.finalize().to_hex().to_string());
        Ok(Self { name: name.to_owned(), bytes, hash })
    }

    /// Whether the folder contains a file of that name, length and content.
    pub fn is_in(&self, folder: &Path) -> bool {
        let path = folder.join(&self.name);
        fs::metadata(&path).is_ok_and(|about| about.len() == self.bytes)
            && Self::of(&path, &self.name).is_ok_and(|found| found == *self)
    }
}

/// Whether a text is a plain file name and not a path to another folder.
fn is_file_name(name: &str) -> bool {
    Path::new(name).file_name().is_some_and(|found| found == name)
}

/// Escapes `%` and control characters, so that the text fits on a line.
fn escaped(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for char in text.chars() {
        if char == '%' || char.is_control() {
            let mut bytes = [0; 4];
            for byte in char.encode_utf8(&mut bytes).bytes() {
                let _ = write!(line, "%{byte:02x}");
            }
        } else {
            line.push(char);
        }
    }
    line
}

/// Reverses [`escaped`].
fn plain(line: &str) -> Option<String> {
    let mut parts = line.split('%');
    let mut bytes = parts.next()?.as_bytes().to_vec();
    for part in parts {
        let (digits, rest) = part.split_at_checked(2)?;
        bytes.push(u8::from_str_radix(digits, 16).ok()?);
        bytes.extend_from_slice(rest.as_bytes());
    }
    String::from_utf8(bytes).ok()
}
