//! What is whole: names, lengths and hashes of files, and what they were made from.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// What a manifest begins with.
const BEGIN: &str = "relief manifest 1";

/// The most bytes of a manifest that are read.
const MOST_BYTES: u64 = 16 << 20;

/// A list of files in parts, each made from one thing. Put in its place as the last file of a set, it says
/// what is whole.
///
/// It is lines of text: a first line with the version; for each part `part NAME` and `made-from IDENTITY`,
/// then for each of its files `file BYTES BLAKE3 NAME`; at the end `end BLAKE3` of all lines before. In names
/// a control character or `%` is `%` with the two hexadecimal digits of each of its bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    parts: Vec<Part>,
}

/// Files that were made together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// What tells it from other parts.
    pub name: String,
    /// What decides its content, such as a hash of all inputs.
    pub made_from: String,
    /// Its files.
    pub files: Vec<ListedFile>,
}

/// A file of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedFile {
    /// Its name in the folder of the manifest.
    pub name: String,
    /// Its length.
    pub bytes: u64,
    /// BLAKE3 of its content, in hexadecimal digits.
    pub hash: String,
}

/// What lies where a manifest may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FoundManifest {
    /// Nothing.
    Nothing,
    /// A manifest.
    Whole(Manifest),
    /// The beginning of a manifest, which does not go on as one.
    Damaged,
    /// Something else.
    Stranger,
}

impl Manifest {
    /// The manifest in that place.
    ///
    /// # Errors
    ///
    /// When there is a file that cannot be read.
    pub fn find(path: &Path) -> io::Result<FoundManifest> {
        match fs::metadata(path) {
            Ok(about) if !about.is_file() => return Ok(FoundManifest::Stranger),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(FoundManifest::Nothing),
            found => found?,
        };
        let mut bytes = Vec::new();
        File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
        if !bytes.starts_with(BEGIN.as_bytes()) {
            return Ok(FoundManifest::Stranger);
        }
        let text = std::str::from_utf8(&bytes).ok();
        Ok(text.and_then(Self::parse).map_or(FoundManifest::Damaged, FoundManifest::Whole))
    }

    /// Its text; the same manifest has the same.
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

    /// The parts, in the order of their names.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The part of that name.
    pub fn part(&self, name: &str) -> Option<&Part> {
        self.parts.iter().find(|part| part.name == name)
    }

    /// Takes a part in place of the one of its name.
    pub fn set(&mut self, part: Part) {
        self.parts.retain(|other| other.name != part.name);
        let place = self.parts.partition_point(|other| other.name < part.name);
        self.parts.insert(place, part);
    }

    /// Whether a file of that name is in any part.
    pub fn lists(&self, file: &str) -> bool {
        self.parts.iter().any(|part| part.files.iter().any(|listed| listed.name == file))
    }

    /// The part of that name if it was made from that and all of its files in the folder are as listed.
    pub fn whole(&self, folder: &Path, name: &str, made_from: &str) -> Option<&Part> {
        let part = self.part(name).filter(|part| part.made_from == made_from && !part.files.is_empty())?;
        part.files.iter().all(|file| file.is_in(folder)).then_some(part)
    }
}

impl ListedFile {
    /// Of the content of a file that is to have that name.
    ///
    /// # Errors
    ///
    /// When it cannot be read, or is no regular file.
    pub fn of(path: &Path, name: &str) -> io::Result<Self> {
        if !fs::metadata(path)?.is_file() {
            return Err(io::Error::other("it is no regular file"));
        }
        let mut hasher = blake3::Hasher::new();
        hasher.update_reader(File::open(path)?)?;
        let (bytes, hash) = (hasher.count(), hasher.finalize().to_hex().to_string());
        Ok(Self { name: name.to_owned(), bytes, hash })
    }

    /// Whether a file of that name, length and content is in the folder.
    pub fn is_in(&self, folder: &Path) -> bool {
        let path = folder.join(&self.name);
        fs::metadata(&path).is_ok_and(|about| about.len() == self.bytes)
            && Self::of(&path, &self.name).is_ok_and(|found| found == *self)
    }
}

/// Whether it is the name of a file in the manifest's folder, and no path to another one.
fn is_file_name(name: &str) -> bool {
    Path::new(name).file_name().is_some_and(|found| found == name)
}

/// A text without line breaks.
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

/// The text that was escaped.
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
