//! Lengths of sentences.

use crate::markdown;

/// Abbreviations whose full stop ends no sentence.
const ABBREVIATIONS: [&str; 9] = ["al.", "e.g.", "i.e.", "cf.", "vs.", "Fig.", "fig.", "Eq.", "No."];

/// A sentence of prose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sentence {
    /// First line of its paragraph, counted from 1.
    pub line: usize,
    /// Number of words with a letter or a digit.
    pub words: usize,
    /// Text on one line.
    pub text: String,
}

/// The sentences in the prose of a markdown text. A paragraph ends its last sentence.
pub fn sentences(markdown: &str) -> Vec<Sentence> {
    let mut sentences = Vec::new();
    for paragraph in markdown::prose(markdown) {
        for text in split(&paragraph.text) {
            let words = words(&text);
            if words > 0 {
                sentences.push(Sentence { line: paragraph.line, words, text });
            }
        }
    }
    sentences
}

/// Words with a letter or a digit. A piece of code is one word.
fn words(text: &str) -> usize {
    text.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count()
}

/// The sentences of a paragraph. One ends with `.`, `!` or `?` before a word that begins one.
fn split(paragraph: &str) -> Vec<String> {
    let words: Vec<&str> = paragraph.split_whitespace().collect();
    let mut sentences = vec![String::new()];
    for (index, word) in words.iter().enumerate() {
        if let Some(sentence) = sentences.last_mut() {
            if !sentence.is_empty() {
                sentence.push(' ');
            }
            sentence.push_str(word);
        }
        if words.get(index + 1).is_some_and(|next| ends(word) && begins(next)) {
            sentences.push(String::new());
        }
    }
    sentences
}

/// Whether a word may be the last of a sentence.
fn ends(word: &str) -> bool {
    let bare = word.trim_end_matches(['"', '\'', ')', ']', '*', '_', '”', '’']);
    bare.ends_with(['.', '!', '?']) && !ABBREVIATIONS.contains(&bare.trim_start_matches(['(', '"']))
}

/// Whether a word may be the first of a sentence.
fn begins(word: &str) -> bool {
    let bare = word.trim_start_matches(['"', '\'', '(', '[', '*', '_', '“', '‘']);
    bare.starts_with(char::is_uppercase)
}

/// Lengths of sentences, in words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lengths {
    /// Number of sentences.
    pub count: usize,
    /// Half of them have at most about this length.
    pub median: usize,
    /// Nine tenths of them have at most about this length.
    pub ninety: usize,
    /// The longest.
    pub longest: usize,
}

/// The lengths of `sentences`; all 0 without any.
pub fn lengths(sentences: &[Sentence]) -> Lengths {
    let mut words: Vec<usize> = sentences.iter().map(|sentence| sentence.words).collect();
    words.sort_unstable();
    let at = |index: usize| words.get(index).copied().unwrap_or(0);
    let count = words.len();
    Lengths { count, median: at(count / 2), ninety: at(count * 9 / 10), longest: at(count.max(1) - 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_end_where_the_next_begins() {
        let page =
            "One two (three.) Four e.g. Five, ver. 0.1 six? `code` is one. And so\non it - goes\n\nLast";
        let counted: Vec<_> =
            sentences(page).iter().map(|sentence| (sentence.line, sentence.words)).collect();
        assert_eq!(counted, [(1, 3), (1, 6), (1, 3), (1, 5), (4, 1)]);
    }

    #[test]
    fn lengths_are_read_off_the_sorted_list() {
        let page = |words: usize| format!("{}.", ["word"; 100][..words].join(" "));
        let pages: Vec<_> = [7, 1, 2, 9, 3, 4, 5, 6, 8, 40].into_iter().map(page).collect();
        let lengths = lengths(&sentences(&pages.join("\n\n")));
        assert_eq!(lengths, Lengths { count: 10, median: 6, ninety: 40, longest: 40 });
        assert_eq!(super::lengths(&[]), Lengths::default());
    }
}
