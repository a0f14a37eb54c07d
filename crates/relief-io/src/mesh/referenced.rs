//! Files that a mesh's file refers to.

use std::fmt;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::{Deserializer, Error, Visitor};

use super::MeshFormat;
use super::gltf::buffers::relative;
use super::gltf::container::json_len;
use super::gltf::extras::BEFORE_JSON;
use crate::{ReadProblem, Source};

/// Lists the files that a mesh's file refers to: the buffers and pictures of a glTF, whether or not
/// they are used or exist. The list is empty if the file cannot be read, is damaged, or contains
/// all of its parts.
///
/// Only the names are held in memory.
///
/// ```no_run
/// let files = relief_io::files_of_mesh("tree.gltf");
/// assert!(files.contains(&"bark.png".into()));
/// ```
pub fn files_of_mesh<'a>(source: impl Into<Source<'a>>) -> Vec<PathBuf> {
    let source = source.into();
    match MeshFormat::by_name(source.name()) {
        Some(MeshFormat::Gltf) => of_gltf(source).unwrap_or_default(),
        _ => Vec::new(),
    }
}

fn of_gltf(source: Source<'_>) -> Result<Vec<PathBuf>, ReadProblem> {
    let (mut reader, _) = source.open()?;
    let mut head = Vec::new();
    reader.by_ref().take(BEFORE_JSON as u64).read_to_end(&mut head)?;
    let document: serde_json::Result<Document> = match json_len(&head) {
        Some(json) => serde_json::from_reader(reader.take(json)),
        None => serde_json::from_reader(Cursor::new(head).chain(reader)),
    };
    let document = document.map_err(io::Error::from)?;
    let folder = source.folder().unwrap_or(Path::new(""));
    let parts = document.buffers.into_iter().chain(document.images);
    let names = parts.filter_map(|part| relative(&part.uri.0?));
    Ok(names.map(|name| folder.join(name)).collect())
}

/// Parts of a glTF that refer to files.
#[derive(Deserialize)]
struct Document {
    #[serde(default)]
    buffers: Vec<Part>,
    #[serde(default)]
    images: Vec<Part>,
}

#[derive(Deserialize)]
struct Part {
    #[serde(default)]
    uri: Uri,
}

/// URI, unless it contains the data itself.
#[derive(Default)]
struct Uri(Option<String>);

impl<'de> Deserialize<'de> for Uri {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl Visitor<'_> for Text {
            type Value = Uri;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a URI")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Uri, E> {
                Ok(Uri((!text.starts_with("data:")).then(|| text.to_owned())))
            }

            fn visit_unit<E: Error>(self) -> Result<Uri, E> {
                Ok(Uri::default())
            }
        }
        deserializer.deserialize_any(Text)
    }
}
