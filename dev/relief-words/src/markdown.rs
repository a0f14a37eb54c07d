//! Markdown reduced to its prose.

/// A paragraph of prose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paragraph {
    /// First line, counted from 1.
    pub line: usize,
    /// Words. A piece of code is one word, a link its text.
    pub text: String,
}

/// The word that stands for a piece of code.
const CODE: char = 'X';

/// The paragraphs of `text`. Lists, tables, code, headings, pictures and HTML are left out.
pub fn prose(text: &str) -> Vec<Paragraph> {
    let mut paragraphs: Vec<Paragraph> = Vec::new();
    let mut open = None;
    for (index, line) in without_code(text).lines().enumerate() {
        let starts_other = is_other(line);
        open = match open {
            _ if line.trim().is_empty() => None,
            _ if starts_other => Some(false),
            None => Some(!line.starts_with("  ")),
            Some(is_prose) => Some(is_prose),
        };
        if open != Some(true) || starts_other {
            continue;
        }
        let goes_on = index > 0 && paragraphs.last().is_some_and(|last| ends_at(last, index));
        let line = line.trim().trim_start_matches('>').trim_start();
        if goes_on && let Some(last) = paragraphs.last_mut() {
            last.text.push('\n');
            last.text.push_str(line);
        } else {
            paragraphs.push(Paragraph { line: index + 1, text: line.to_owned() });
        }
    }
    for paragraph in &mut paragraphs {
        paragraph.text = without_links(&paragraph.text);
    }
    paragraphs.retain(|paragraph| !paragraph.text.trim().is_empty());
    paragraphs
}

/// Whether the last line of a paragraph has the number `line`.
fn ends_at(paragraph: &Paragraph, line: usize) -> bool {
    paragraph.line + paragraph.text.matches('\n').count() == line
}

/// Whether a line begins what is no prose: a list, a table, a heading, HTML or a link's definition.
fn is_other(line: &str) -> bool {
    let line = line.trim_start();
    let digits = line.trim_start_matches(|letter: char| letter.is_ascii_digit());
    let is_number = digits.len() < line.len() && (digits.starts_with(". ") || digits.starts_with(") "));
    let is_definition = line.starts_with('[') && line.contains("]:");
    let is_bullet = ["- ", "* ", "+ "].iter().any(|mark| line.starts_with(mark));
    is_number || is_definition || is_bullet || line.starts_with(['|', '#', '<'])
}

/// The text with each piece of code between backticks replaced by one word, and fenced code left
/// out. Line ends stay where they are.
pub fn without_code(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut fence: Option<&str> = None;
    let mut prose_from = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let trimmed = line.trim_start();
        let mark = ["```", "~~~"].into_iter().find(|mark| trimmed.starts_with(mark));
        match (fence, mark) {
            (Some(open), Some(mark)) if open == mark => {
                fence = None;
                prose_from = None;
                out.push('\n');
            }
            (Some(_), _) => out.push('\n'),
            (None, Some(mark)) if !trimmed[3..].contains('`') => {
                without_spans(&text[prose_from.take().unwrap_or(at)..at], &mut out);
                fence = Some(mark);
                out.push('\n');
            }
            _ => {
                prose_from.get_or_insert(at);
            }
        }
        at += line.len();
    }
    if let Some(from) = prose_from {
        without_spans(&text[from..], &mut out);
    }
    out
}

/// Appends `text` with a word for each piece of code. A piece ends with its paragraph.
fn without_spans(text: &str, out: &mut String) {
    let mut rest = text;
    while let Some(open) = rest.find('`') {
        out.push_str(&rest[..open]);
        rest = &rest[open..];
        let ticks = rest.len() - rest.trim_start_matches('`').len();
        let inner = &rest[ticks..];
        let paragraph = &inner[..inner.find("\n\n").unwrap_or(inner.len())];
        match closing(paragraph, ticks) {
            Some(len) => {
                out.push(CODE);
                out.extend(inner[..len].matches('\n'));
                rest = &inner[len + ticks..];
            }
            None => rest = inner,
        }
    }
    out.push_str(rest);
}

/// Bytes before the next run of exactly `ticks` backticks.
fn closing(text: &str, ticks: usize) -> Option<usize> {
    let mut at = 0;
    while let Some(next) = text[at..].find('`') {
        let run = text[at + next..].len() - text[at + next..].trim_start_matches('`').len();
        if run == ticks {
            return Some(at + next);
        }
        at += next + run;
    }
    None
}

/// The text with each link replaced by its words, and without pictures.
fn without_links(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(open) = rest.find('[') {
        let before = &rest[..open];
        let is_picture = before.ends_with('!');
        out.push_str(before.strip_suffix('!').unwrap_or(before));
        let inner = &rest[open + 1..];
        let Some(len) = bracket(inner) else {
            out.push_str(&rest[open..]);
            return out;
        };
        if !is_picture {
            out.push_str(&without_links(&inner[..len]));
        }
        rest = &inner[len + 1..];
        let closes = match rest.as_bytes().first() {
            Some(b'(') => rest.find(')'),
            Some(b'[') => rest.find(']'),
            _ => None,
        };
        rest = closes.map_or(rest, |len| &rest[len + 1..]);
    }
    out.push_str(rest);
    out
}

/// Bytes before the bracket that closes one already open.
fn bracket(text: &str) -> Option<usize> {
    let mut depth = 1;
    text.bytes().position(|byte| {
        depth += i32::from(byte == b'[') - i32::from(byte == b']');
        depth == 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<(usize, String)> {
        prose(text).into_iter().map(|paragraph| (paragraph.line, paragraph.text)).collect()
    }

    #[test]
    fn prose_is_what_no_list_table_code_or_heading_holds() {
        let page = "# Title\n\n![picture](a.png)\n\nOne `a b` and\ntwo.\n\n- list\n  goes on\n\n  and on\n\n\
            1. number\n\n\
            | a | b |\n| --- | --- |\n\n```sh\nThree.\n```\n\nFour:\n- five\nsix\n\n<p>seven</p>\n\n    \
            eight\n\n> nine\n";
        let expected = [(5, "One X and\ntwo."), (22, "Four:"), (30, "nine")];
        assert_eq!(texts(page), expected.map(|(line, text)| (line, text.to_owned())));
    }

    #[test]
    fn a_link_is_its_words_and_a_picture_none() {
        let page = "See [the `guide`](docs/a.md), [this][1] ![picture](b.png) and [![badge](c)](d)end!\n\n\
                    [1]: e.md\n";
        assert_eq!(texts(page), [(1, "See the X, this  and end!".to_owned())]);
    }

    #[test]
    fn a_backtick_without_its_other_is_none() {
        assert_eq!(without_code("a ` b\n\nc `d` ``e`f`` g"), "a  b\n\nc X X g");
    }
}
