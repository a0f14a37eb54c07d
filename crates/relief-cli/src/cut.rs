//! Shortening of long names and lines in messages: nobody reads a line of a megabyte.

use std::borrow::Cow;

/// Limit of a word, such as a name.
const WORD: Limit = Limit { most: 400, start: 260, end: 100 };

/// Limit of a line.
const LINE: Limit = Limit { most: 4000, start: 3000, end: 600 };

/// Limit of a part of a message, in characters.
struct Limit {
    /// Greatest length that is printed in full.
    most: usize,
    /// Number of characters kept at the start and, in `end`, at the end of a longer text.
    start: usize,
    end: usize,
}

impl Limit {
    fn cut<'a>(&self, text: &'a str) -> Cow<'a, str> {
        // A character has at least one byte.
        if text.len() <= self.most || text.chars().count() <= self.most {
            return text.into();
        }
        let start = text.char_indices().nth(self.start).map_or(text.len(), |(at, _)| at);
        let end = text.char_indices().rev().nth(self.end - 1).map_or(0, |(at, _)| at);
        format!("{}…{}", &text[..start], &text[end.max(start)..]).into()
    }
}

/// Returns a text whose long words and lines are cut in the middle.
pub fn cut(text: &str) -> String {
    let line = |line: &str| {
        let words: String = line.split_inclusive(char::is_whitespace).map(|word| WORD.cut(word)).collect();
        // Below a line that is cut there are only spaces and marks.
        LINE.cut(words.trim_end()).into_owned()
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Whether [`cut`] would change a text.
pub fn is_long(text: &str) -> bool {
    text.lines()
        .any(|line| LINE.cut(line) != line || line.split_whitespace().any(|word| WORD.cut(word) != word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_texts_stay_and_long_ones_keep_both_ends() {
        let usual = "map.png: cannot be read\n  |\n1 | size = 3\n  |        ^\n";
        assert_eq!(cut(usual), usual);
        assert!(!is_long(usual));
        let name = format!("start{}end.png", "ä".repeat(100_000));
        let said = cut(&format!("{name}: there is no such file: give another one"));
        assert!(
            said.chars().count() < 500 && said.starts_with("start") && said.contains("end.png: there is")
        );
        let words = cut(&format!("first {}last", "word ".repeat(10_000)));
        assert!(words.chars().count() <= 3601 && words.starts_with("first") && words.ends_with("last"));
        assert!(is_long(&name) && is_long(&"word ".repeat(10_000)));
        // A name as long as systems have them is said.
        let longest = format!("{}.png", "a".repeat(255));
        assert_eq!(cut(&longest), longest);
    }
}
