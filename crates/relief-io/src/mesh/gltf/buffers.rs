//! Buffers of a glTF: in the file itself, or in files of its folder.

use std::borrow::Cow;
use std::path::PathBuf;

use ::gltf::buffer::{self, Buffer};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::damaged;
use crate::mesh::builder::Builder;
use crate::mesh::folder::{inside, stays};
use crate::{ReadProblem, Source};

/// Buffers, each read when it is first needed.
pub(super) struct Buffers<'a> {
    source: Source<'a>,
    binary: Option<&'a [u8]>,
    read: Vec<Option<Cow<'a, [u8]>>>,
}

impl<'a> Buffers<'a> {
    pub fn new(source: Source<'a>, binary: Option<&'a [u8]>, count: usize) -> Self {
        Self { source, binary, read: vec![None; count] }
    }

    /// Returns the bytes of a view.
    pub fn view(&mut self, view: &buffer::View<'_>, builder: &mut Builder) -> Result<&[u8], ReadProblem> {
        let buffer = view.buffer();
        let place = buffer.index();
        if self.read.get(place).is_some_and(Option::is_none) {
            self.read[place] = Some(self.open(&buffer, builder)?);
        }
        let bytes = self.read.get(place).and_then(Option::as_deref).unwrap_or_default();
        let bytes = bytes.get(view.offset()..).and_then(|rest| rest.get(..view.length()));
        bytes.ok_or_else(|| damaged(format!("buffer view {} reaches beyond its buffer", view.index())))
    }

    fn open(&self, buffer: &Buffer<'_>, builder: &mut Builder) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let (number, length) = (buffer.index(), buffer.length());
        let bytes = match buffer.source() {
            buffer::Source::Bin => {
                Cow::Borrowed(self.binary.ok_or_else(|| damaged(format!("buffer {number} has no bytes")))?)
            }
            buffer::Source::Uri(uri) => self.named(&format!("buffer {number}"), uri, builder)?,
        };
        if bytes.len() < length {
            let what =
                format!("buffer {number} has {} bytes, but its description says {length}", bytes.len());
            return Err(damaged(what));
        }
        Ok(match bytes {
            Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..length]),
            Cow::Owned(mut bytes) => {
                bytes.truncate(length);
                Cow::Owned(bytes)
            }
        })
    }

    /// Reads the bytes that a URI contains or refers to. Errors call them `name`.
    pub fn named(&self, name: &str, uri: &str, builder: &mut Builder) -> Result<Cow<'a, [u8]>, ReadProblem> {
        match uri.strip_prefix("data:") {
            Some(data) => decoded(name, data, builder),
            None => self.beside(uri, builder),
        }
    }

    /// Reads a file in the folder of the glTF, or below.
    fn beside(&self, uri: &str, builder: &mut Builder) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let outside = || ReadProblem::OutsideFolder { file: uri.chars().take(200).collect() };
        let path = relative(uri).ok_or_else(outside)?;
        let file = inside(self.source, &path, uri)?;
        let of_part = |problem| ReadProblem::Part { file: file.clone(), problem: Box::new(problem) };
        self.source.whole_of(&file, |len| builder.take(len)).map_err(of_part)
    }
}

/// Decodes bytes inside the JSON.
fn decoded<'a>(name: &str, data: &str, builder: &mut Builder) -> Result<Cow<'a, [u8]>, ReadProblem> {
    let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
    let encoded = encoded.ok_or_else(|| damaged(format!("{name} holds no base64")))?;
    builder.take(encoded.len() as u64)?;
    let bytes = STANDARD.decode(encoded);
    bytes.map(Cow::Owned).map_err(|error| damaged(format!("the base64 of {name}: {error}")))
}

/// Converts a URI to a path, if it is one that stays in its folder.
pub(in crate::mesh) fn relative(uri: &str) -> Option<PathBuf> {
    let path = PathBuf::from(percent_decoded(uri)?);
    (!uri.contains([':', '\\']) && stays(&path)).then_some(path)
}

/// Decodes bytes that are written as `%20`, if the result is valid text.
fn percent_decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        let digits =
            after.get(..2).filter(|digits| *first == b'%' && digits.iter().all(u8::is_ascii_hexdigit));
        let decoded =
            digits.and_then(|digits| u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok());
        bytes.push(decoded.unwrap_or(*first));
        rest = if decoded.is_some() { &after[2..] } else { after };
    }
    String::from_utf8(bytes).ok()
}
