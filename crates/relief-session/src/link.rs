//! A scene as the end of an address: the keys that have values, with a version.

use std::fmt::Write as _;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};
use relief_scene::SceneSpec;
use toml::{Table, Value};

use crate::document::{SURFACES, is_key, is_plain, read, values};

/// The version that is written, and the only one that is read.
const VERSION: &str = "1";

/// Longest link in characters: more is cut by some programs that send it on.
const MAX_LENGTH: usize = 2000;

/// Characters that stay as they are: those that an address may have behind its `#`, without `&` and `=`.
const CODED: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'_')
    .remove(b'.')
    .remove(b'~')
    .remove(b'/')
    .remove(b':')
    .remove(b',')
    .remove(b'@')
    .remove(b'!')
    .remove(b'(')
    .remove(b')');

/// The parts that are no keys of a scene.
const VERSION_PART: &str = "s";
const FILE_PART: &str = "file";
const END_PART: &str = "end";

/// A scene, and the files that it needs, for the end of an address.
///
/// The text begins with `s=` and the version. Keys follow as actions name them, each with its value as a
/// scene file writes it, and files with their hashes. It ends with `end`, so that a cut one is noticed.
///
/// ```
/// use relief_session::{Link, Session};
///
/// let session = Session::new("height = \"cobbles.png\"\nmethod = \"cone\"\nscale = 0.05")?;
/// let link = Link { spec: session.spec().clone(), files: Vec::new() };
/// let text = link.to_text()?;
/// assert_eq!(text, "s=1&height=cobbles.png&method=cone&scale=0.05&end");
/// assert_eq!(Link::read(&text)?, link);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The scene.
    pub spec: SceneSpec,
    /// Files that whoever opens the link must have.
    pub files: Vec<LinkedFile>,
}

/// A file that a link names.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LinkedFile {
    /// Path, as the scene has it, or of a file in a folder that the scene has.
    pub path: String,
    /// Hash of the content, of letters and digits.
    pub hash: String,
}

/// Reason why a scene has no link, or a link no scene.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LinkError {
    /// The scene needs a longer link.
    #[error(
        "a link to this scene needs {0} characters, and at most {MAX_LENGTH} are possible: save the scene"
    )]
    TooMuch(usize),
    /// The text is longer than any link.
    #[error("the link has {0} characters, and at most {MAX_LENGTH} are read")]
    TooLong(usize),
    /// Another version has written it.
    #[error("the link has version {0}, and version {VERSION} is known here: open it with a newer page")]
    Version(String),
    /// It ends too soon.
    #[error("the link is not whole: copy it again, to its end")]
    Cut,
    /// A part has no meaning.
    #[error("the link cannot be used: {0}")]
    Damaged(String),
}

impl Link {
    /// Returns the text.
    ///
    /// # Errors
    ///
    /// When it would be longer than 2,000 characters.
    pub fn to_text(&self) -> Result<String, LinkError> {
        let mut text = format!("{VERSION_PART}={VERSION}");
        if !self.spec.surfaces.is_empty() {
            add(&mut text, SURFACES, &self.spec.surfaces.len().to_string());
        }
        for (key, value) in values(&self.spec) {
            add(&mut text, &key, bare(&value).as_deref().unwrap_or(&value));
        }
        for LinkedFile { path, hash } in &self.files {
            add(&mut text, FILE_PART, &format!("{hash}:{path}"));
        }
        text += "&";
        text += END_PART;
        if text.len() > MAX_LENGTH { Err(LinkError::TooMuch(text.len())) } else { Ok(text) }
    }

    /// Reads a text.
    ///
    /// # Errors
    ///
    /// When it is longer than 2,000 characters, of another version, cut, or no scene.
    pub fn read(text: &str) -> Result<Self, LinkError> {
        if text.len() > MAX_LENGTH {
            return Err(LinkError::TooLong(text.len()));
        }
        let mut parts = text.split('&');
        match parts.next().and_then(|first| first.split_once('=')) {
            Some((VERSION_PART, VERSION)) => {}
            Some((VERSION_PART, version)) => return Err(LinkError::Version(version.to_owned())),
            _ => return Err(LinkError::Damaged(format!("it does not begin with {VERSION_PART}={VERSION}"))),
        }
        if parts.next_back() != Some(END_PART) {
            return Err(LinkError::Cut);
        }
        let mut lines = Lines::default();
        let mut files = Vec::new();
        for part in parts {
            let (key, value) = part.split_once('=').ok_or_else(|| damaged(part, "it has no value"))?;
            let (key, value) = (decoded(key)?, decoded(value)?);
            if key == FILE_PART {
                let (hash, path) = value.split_once(':').ok_or_else(|| damaged(&key, "it has no hash"))?;
                files.push(LinkedFile { path: path.to_owned(), hash: hash.to_owned() });
            } else {
                lines.add(&key, &value)?;
            }
        }
        let spec = read(&lines.text()).map_err(|refused| LinkError::Damaged(refused.to_string()))?;
        Ok(Self { spec, files })
    }
}

/// The lines of a scene file: the scene's own, and each surface's.
#[derive(Default)]
struct Lines {
    scene: String,
    surfaces: Vec<String>,
}

impl Lines {
    fn add(&mut self, key: &str, value: &str) -> Result<(), LinkError> {
        if key == SURFACES {
            let count = value.parse().ok().filter(|count| *count <= MAX_LENGTH && self.surfaces.is_empty());
            self.surfaces
                .resize(count.ok_or_else(|| damaged(key, "it is no number of surfaces"))?, String::new());
            return Ok(());
        }
        let of_surface = key.strip_prefix(SURFACES).and_then(|rest| rest.strip_prefix('[')?.split_once("]."));
        let (lines, own) = match of_surface {
            Some((number, own)) => {
                let number = number.parse::<usize>().ok();
                let lines = number.and_then(|number| self.surfaces.get_mut(number));
                (lines.ok_or_else(|| damaged(key, "there is no such surface"))?, own)
            }
            None => (&mut self.scene, key),
        };
        if !is_key(own) {
            return Err(damaged(key, "it is no key"));
        }
        let value =
            if is_one(value) { value.to_owned() } else { Value::String(value.to_owned()).to_string() };
        // A text is written in one line.
        let _ = writeln!(lines, "{own} = {value}");
        Ok(())
    }

    fn text(&self) -> String {
        let surface = |lines: &String| format!("[[{SURFACES}]]\n{lines}");
        self.scene.clone() + &self.surfaces.iter().map(surface).collect::<String>()
    }
}

/// Adds a part.
fn add(text: &mut String, key: &str, value: &str) {
    let [key, value] = [key, value].map(|part| utf8_percent_encode(part, CODED));
    let _ = write!(text, "&{key}={value}");
}

/// A written text without its quotation marks, if it is read as the same text without them.
fn bare(written: &str) -> Option<String> {
    let table = format!("value = {written}").parse::<Table>().ok()?;
    let text = table.get("value")?.as_str()?;
    (is_plain(text) && !is_one(text)).then(|| text.to_owned())
}

/// Whether a text is one value as a scene file writes it.
fn is_one(value: &str) -> bool {
    format!("value = {value}").parse::<Table>().is_ok_and(|table| table.len() == 1)
}

fn decoded(text: &str) -> Result<String, LinkError> {
    let decoded = percent_decode_str(text).decode_utf8();
    decoded.map(Into::into).map_err(|_| damaged(text, "it is no text"))
}

fn damaged(part: &str, why: &str) -> LinkError {
    let part: String = part.chars().take(40).collect();
    LinkError::Damaged(format!("'{part}': {why}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Session;

    fn link(text: &str) -> Link {
        Link { spec: Session::new(text).expect("a scene").spec().clone(), files: Vec::new() }
    }

    const SCENES: [&str; 5] = [
        "",
        "height = \"a b & c=%.png\"\nmethod = \"relief\"\nset.search.steps = 12\nviewer.second = \"cone\"",
        "height = \"1\"\ncolor = \"ä, \\u0022quoted\\u0022.png\"\nscale = \"5cm\"\neye = [1.5, 2, -3]",
        "material.base = [1, 0, 0]\nlights = [{ direction = [0, 1, 0], color = [1, 1, 1] }]",
        "scale = 0.1\n[[surfaces]]\nheight = \"a.png\"\n[[surfaces]]\n[[surfaces]]\nmethod = \"steep\"\n\
         set.search.steps = 3",
    ];

    #[test]
    fn a_link_is_read_as_the_scene_that_it_was_made_of() {
        for text in SCENES {
            let file = LinkedFile { path: "given/1/ä b.png".to_owned(), hash: "0123abcd".to_owned() };
            let link = Link { files: vec![file], ..link(text) };
            let written = link.to_text().expect("short");
            assert!(written.is_ascii() && written.starts_with("s=1&"), "{written}");
            assert!(!written.contains(['"', ' ', '<', '>', '#']), "{written}");
            assert_eq!(Link::read(&written), Ok(link), "{written}");
        }
    }

    #[test]
    fn a_cut_link_is_noticed_at_each_place() {
        for text in SCENES {
            let written = link(text).to_text().expect("short");
            for end in 0..written.len() {
                assert!(Link::read(&written[..end]).is_err(), "{}", &written[..end]);
            }
        }
    }

    #[test]
    fn what_is_no_link_says_why() {
        for (text, said) in [
            ("s=2&height=a.png&end", "version 2"),
            ("s=1&height=a.png", "not whole"),
            ("height=a.png&end", "begin with s=1"),
            ("s=1&heigth=a.png&end", "heigth"),
            ("s=1&height&end", "no value"),
            ("s=1&height=%ff&end", "no text"),
            ("s=1&a%0Ab=1&end", "no key"),
            ("s=1&surfaces=2&surfaces[2].scale=1&end", "no such surface"),
            ("s=1&surfaces=-1&end", "number of surfaces"),
            ("s=1&surfaces=2&surfaces=3&end", "number of surfaces"),
            ("s=1&samples=5000&end", "1024"),
            ("s=1&scale=1&scale=2&end", "duplicate"),
            ("s=1&file=a.png&end", "no hash"),
        ] {
            let error = Link::read(text).expect_err(text);
            assert!(error.to_string().contains(said), "{text}: {error}");
        }
        let long = format!("s=1&height={}.png&end", "a".repeat(1 << 20));
        assert_eq!(Link::read(&long), Err(LinkError::TooLong(long.len())));
        let scene = link(&format!("height = \"{}\"", "a".repeat(3000)));
        assert!(matches!(scene.to_text(), Err(LinkError::TooMuch(3000..))));
    }
}
