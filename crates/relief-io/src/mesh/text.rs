//! Numbers and words in text files.

use crate::ReadProblem;

/// Parses a finite number. An error shows the word instead.
pub(super) fn number(format: &'static str, line: usize, word: &[u8]) -> Result<f32, ReadProblem> {
    let text = std::str::from_utf8(word).ok();
    let number = text.and_then(|text| text.parse::<f32>().ok()).filter(|number| number.is_finite());
    number.ok_or_else(|| {
        let what = format!("line {line}: '{}' is not a finite number", shown(word));
        ReadProblem::damaged(format, what)
    })
}

/// Returns the beginning of a word in a readable form.
pub(super) fn shown(word: &[u8]) -> String {
    const MOST: usize = 32;
    let cut = &word[..word.len().min(MOST)];
    let text: String = String::from_utf8_lossy(cut).chars().filter(|shown| !shown.is_control()).collect();
    if cut.len() < word.len() { format!("{text}...") } else { text }
}

/// Number of line ends in white space: a line feed, a carriage return, or both.
fn line_ends(space: &[u8]) -> usize {
    let ends = |at: usize| match space[at] {
        b'\n' => true,
        byte => byte == b'\r' && space.get(at + 1) != Some(&b'\n'),
    };
    (0..space.len()).filter(|&at| ends(at)).count()
}

/// Iterator over the words of a text, with the line of the last word, counted from 1.
#[derive(Clone, Debug)]
pub(super) struct Words<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Words<'a> {
    /// Creates an iterator over `rest`, which begins on line `line`.
    pub fn new(rest: &'a [u8], line: usize) -> Self {
        Self { rest, line }
    }

    /// Returns the line of the last word.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Number of bytes that remain.
    pub fn left(&self) -> usize {
        self.rest.len()
    }

    /// Skips the rest of the line.
    pub fn skip_line(&mut self) {
        let end = self.rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        self.rest = &self.rest[end.unwrap_or(self.rest.len())..];
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        self.line += line_ends(&self.rest[..start]);
        let rest = &self.rest[start..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.rest = rest;
        Some(word)
    }
}
