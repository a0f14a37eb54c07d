//! Worn phrases: forms that point at something instead of naming it.

use crate::markdown;

/// The worn phrases. Each is counted whole, in any case and across line ends.
pub const PHRASES: [&str; 8] =
    ["so many", "those of", "that of", "of which", "is told", "makes of", "comes to", "what is left of"];

/// The plural of a phrase that counts as the phrase.
const PLURAL: (&str, &str) = ("are told", "is told");

/// A worn phrase in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Worn {
    /// Line of its first word, counted from 1.
    pub line: usize,
    /// Place in [`PHRASES`].
    pub phrase: usize,
}

/// The worn phrases in `text`, in their order. Code between backticks does not count.
pub fn worn(text: &str) -> Vec<Worn> {
    let (spaced, lines) = spaced(&markdown::without_code(text));
    let phrases = PHRASES.iter().enumerate().map(|(phrase, words)| (*words, phrase));
    let plural = PHRASES.iter().position(|words| *words == PLURAL.1).map(|phrase| (PLURAL.0, phrase));
    let mut found: Vec<(usize, Worn)> = phrases
        .chain(plural)
        .flat_map(|(words, phrase)| {
            let lines = &lines;
            places(&spaced, words).into_iter().map(move |at| (at, Worn { line: lines[at], phrase }))
        })
        .collect();
    found.sort_by_key(|(at, worn)| (*at, worn.phrase));
    found.into_iter().map(|(_, worn)| worn).collect()
}

/// The text in lower case with one space between words, and the line of each of its bytes.
fn spaced(text: &str) -> (String, Vec<usize>) {
    let (mut spaced, mut lines) = (String::new(), Vec::new());
    for (index, line) in text.replace("\\\n", " \n").lines().enumerate() {
        for word in line.split_whitespace() {
            let word = word.to_lowercase();
            lines.extend(std::iter::repeat_n(index + 1, word.len() + 1));
            spaced.push_str(&word);
            spaced.push(' ');
        }
    }
    (spaced, lines)
}

/// The places in `text` at which `words` stand as whole words.
fn places(text: &str, words: &str) -> Vec<usize> {
    let in_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let is_whole =
        |at: &usize| !text[..*at].ends_with(in_word) && !text[*at + words.len()..].starts_with(in_word);
    text.match_indices(words).map(|(at, _)| at).filter(is_whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_phrase_is_seen_across_lines_and_in_any_case() {
        for (phrase, words) in PHRASES.iter().enumerate() {
            let sentence = format!("First.\n{} it", words.to_uppercase().replacen(' ', "\n  ", 1));
            assert_eq!(worn(&sentence), [Worn { line: 2, phrase }], "{words}");
        }
        assert_eq!(worn("they are told").len(), 1);
    }

    #[test]
    fn parts_of_words_punctuation_and_code_do_not_count() {
        assert_eq!(worn("also many; so, many; so manyfold; of_which; `so many`\n```\nthose of\n```"), []);
    }

    #[test]
    fn a_line_that_goes_on_is_one_text() {
        assert_eq!(worn("as so \\\n    many").len(), 1);
    }
}
