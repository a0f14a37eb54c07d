//! Names and values inside texture files.

use crate::WriteProblem;

/// The attribute of EXR files that holds the metadata, a line each.
pub(super) const EXR_ATTRIBUTE: &str = "relief";

/// Names and values that travel inside a texture's file, in the order of their names: `iTXt` chunks in PNG,
/// key/value data in KTX2, the lines of the string attribute `relief` in EXR.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Metadata(Vec<(String, String)>);

impl Metadata {
    /// Checks names and values.
    ///
    /// # Errors
    ///
    /// When a name is not 1 to 79 printable ASCII characters without `=` and outer spaces, or is given twice;
    /// when a value holds a line break, NUL or another control character, none of which every format can
    /// hold.
    pub fn new(mut entries: Vec<(String, String)>) -> Result<Self, WriteProblem> {
        entries.sort();
        if let Some(pair) = entries.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(WriteProblem::NotStorable(format!("the metadata '{}' are given twice", pair[0].0)));
        }
        for (key, value) in &entries {
            let printable = key.bytes().all(|byte| (b' '..=b'~').contains(&byte) && byte != b'=');
            if !(1..=79).contains(&key.len()) || !printable || key.trim() != key {
                return Err(WriteProblem::NotStorable(format!("'{key}' is no name of metadata")));
            }
            if value.chars().any(char::is_control) {
                let what = format!("the value of the metadata '{key}' holds a control character");
                return Err(WriteProblem::NotStorable(what));
            }
        }
        Ok(Self(entries))
    }

    /// The value of that name.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.iter().find(|(found, _)| found == key).map(|(_, value)| value.as_str())
    }

    /// Names and values, in the order of the names.
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

    /// What a file holds, whatever it is.
    pub(crate) fn found(mut entries: Vec<(String, String)>) -> Self {
        entries.sort();
        Self(entries)
    }
}
