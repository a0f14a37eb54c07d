//! Metadata inside texture files: names and values.

use crate::WriteProblem;

/// Attribute of EXR files with the metadata, one line each.
pub(super) const EXR_ATTRIBUTE: &str = "relief";

/// Names and values inside a texture's file, sorted by name. They are `iTXt` chunks in PNG,
/// key/value data in KTX2, and lines of the string attribute `relief` in EXR.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Metadata(Vec<(String, String)>);

impl Metadata {
    /// Creates metadata from names and values, and checks them.
    ///
    /// # Errors
    ///
    /// When a name is not 1 to 79 printable ASCII characters without `=` and outer spaces, or is
    /// given twice; or when a value has a line break, NUL or another control character, which some
    /// format cannot hold.
    pub fn new(mut entries: Vec<(String, String)>) -> Result<Self, WriteProblem> {
        entries.sort();
        if let Some(pair) = entries.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(WriteProblem::NotStorable(format!("the metadata '{}' are given twice", pair[0].0)));
        }
        for (key, value) in &entries {
            let printable = key.bytes().all(|byte| (b' '..=b'~').contains(&byte) && byte != b'=');
            if !(1..=79).contains(&key.len()) || !printable || key.trim() != key {
                return Err(WriteProblem::NotStorable(format!(
                    "'{key}' cannot be a name of metadata: use 1 to 79 printable ASCII characters without ="
                )));
            }
            if value.chars().any(char::is_control) {
                let what = format!("the value of the metadata '{key}' has a control character: remove it");
                return Err(WriteProblem::NotStorable(what));
            }
        }
        Ok(Self(entries))
    }

    /// Returns the value of a name.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.iter().find(|(found, _)| found == key).map(|(_, value)| value.as_str())
    }

    /// Iterates over names and values, in the order of the names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(key, value)| (key.as_str(), value.as_str()))
    }

    pub(super) fn to_lines(&self) -> String {
        self.iter().map(|(key, value)| format!("{key}={value}\n")).collect()
    }

    pub(super) fn from_lines(lines: &str) -> Self {
        let entries = lines.lines().filter_map(|line| line.split_once('='));
        Self::found(entries.map(|(key, value)| (key.to_owned(), value.to_owned())).collect())
    }

    /// Creates metadata from a file's entries, without checks.
    pub(crate) fn found(mut entries: Vec<(String, String)>) -> Self {
        entries.sort();
        Self(entries)
    }
}
