//! Comments and text literals of Rust source. WESL has the same comments and no literals.

/// The part of a source that a passage is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A comment that is no documentation.
    Comment,
    /// Documentation of the file (`//!`).
    ModuleDoc,
    /// Documentation of the item that follows (`///`).
    ItemDoc {
        /// Whether the item is `pub`, or a variant or function of a `pub` enum or trait.
        public: bool,
        /// Whether clap shows the text: the item is, or belongs to, a type that derives a part of
        /// a command.
        help: bool,
    },
    /// A string literal, byte strings and raw ones included.
    Literal,
}

/// A comment with all its adjoining lines, or one literal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passage {
    /// Line of the first character, counted from 1.
    pub line: usize,
    /// The part of the source.
    pub kind: Kind,
    /// The words, without comment marks and quotes; one line of it is one line of the source.
    pub text: String,
}

impl Passage {
    /// Lines of the source that it takes.
    pub fn lines(&self) -> usize {
        1 + self.text.matches('\n').count()
    }
}

/// The comments and literals of `source`, in their order. Adjoining line comments of one kind are
/// one passage.
pub fn passages(source: &str) -> Vec<Passage> {
    let mut passages: Vec<Passage> = Vec::new();
    let mut end_of_last = 0;
    for part in parts(source) {
        let line = 1 + source[..part.start].matches('\n').count();
        let whole = &source[part.start..part.end];
        let (kind, text) = match part.literal {
            Some((before, after)) => (Kind::Literal, whole[before..whole.len() - after].to_owned()),
            None => comment(whole),
        };
        let adjoins = whole.starts_with("//") && source[end_of_last..part.start].trim().is_empty();
        end_of_last = part.end;
        match passages.last_mut() {
            Some(last) if adjoins && last.kind == kind && last.line + last.lines() == line => {
                last.text.push('\n');
                last.text.push_str(&text);
            }
            _ => passages.push(Passage { line, kind, text }),
        }
    }
    settle_items(source, &mut passages);
    passages
}

/// Derived traits of types that hold a part of a command and its help.
const COMMAND_DERIVES: [&str; 4] = ["Parser", "Args", "Subcommand", "ValueEnum"];

/// Tells item documentation apart by the items that follow.
fn settle_items(source: &str, passages: &mut [Passage]) {
    let lines: Vec<&str> = source.lines().collect();
    let blocks = blocks(&lines);
    for passage in passages {
        let after = passage.line - 1 + passage.lines();
        if let Kind::ItemDoc { public, help } = &mut passage.kind {
            let item = item_line(&lines, after);
            let block = blocks.iter().find(|block| (block.opens..block.closes).contains(&item));
            let text = lines.get(item).map_or("", |line| line.trim_start());
            let in_open_block = block.is_some_and(|block| block.shares_visibility && block.opens < item);
            *public = text.starts_with("pub ") || in_open_block;
            *help = block.is_some_and(|block| block.is_command);
        }
    }
}

/// An item at the margin, from its line to the brace that closes it.
struct Block {
    opens: usize,
    closes: usize,
    /// Whether all that it holds is as public as a `pub` item: an enum or a trait.
    shares_visibility: bool,
    is_command: bool,
}

/// The items at the margin, as rustfmt writes them.
fn blocks(lines: &[&str]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut derives = "";
    let mut at = 0;
    while let Some(line) = lines.get(at) {
        let starts_item = line.starts_with(|first: char| first.is_ascii_alphabetic());
        if line.starts_with("#[derive(") {
            derives = line;
        } else if starts_item {
            let closes = match line.ends_with('{') {
                true => lines[at..].iter().position(|line| *line == "}").map_or(lines.len(), |len| at + len),
                false => at + 1,
            };
            blocks.push(Block {
                opens: at,
                closes,
                shares_visibility: line.starts_with("pub enum ") || line.starts_with("pub trait "),
                is_command: COMMAND_DERIVES.iter().any(|name| derives.contains(name)),
            });
            derives = "";
            at = closes.max(at + 1) - 1;
        }
        at += 1;
    }
    blocks
}

/// The line of the item that documentation before line `at` belongs to: the first beyond attributes
/// and comments.
fn item_line(lines: &[&str], mut at: usize) -> usize {
    while let Some(line) = lines.get(at).map(|line| line.trim()) {
        if line.starts_with("#[") {
            let mut depth = 0;
            while let Some(line) = lines.get(at) {
                depth += line.matches('[').count() as i32 - line.matches(']').count() as i32;
                if depth <= 0 {
                    break;
                }
                at += 1;
            }
        } else if !line.is_empty() && !line.starts_with("//") {
            break;
        }
        at += 1;
    }
    at
}

/// Kind and words of a comment.
fn comment(whole: &str) -> (Kind, String) {
    let item = Kind::ItemDoc { public: false, help: false };
    if let Some(block) = whole.strip_prefix("/*") {
        let text = block.strip_suffix("*/").unwrap_or(block);
        return match text.as_bytes().first() {
            Some(b'!') => (Kind::ModuleDoc, text[1..].to_owned()),
            Some(b'*') if !text.starts_with("**") && text.len() > 1 => (item, text[1..].to_owned()),
            _ => (Kind::Comment, text.to_owned()),
        };
    }
    let (kind, text) = match whole {
        _ if whole.starts_with("////") => (Kind::Comment, whole.trim_start_matches('/')),
        _ if whole.starts_with("///") => (item, &whole[3..]),
        _ if whole.starts_with("//!") => (Kind::ModuleDoc, &whole[3..]),
        _ => (Kind::Comment, &whole[2..]),
    };
    (kind, text.trim().to_owned())
}

/// Place of a comment or a literal in bytes, and the lengths of a literal's opening and closing quotes.
struct Part {
    start: usize,
    end: usize,
    literal: Option<(usize, usize)>,
}

/// The comments and literals of a source. None begins inside another.
fn parts(source: &str) -> Vec<Part> {
    let bytes = source.as_bytes();
    let mut parts = Vec::new();
    let mut at = 0;
    while let Some(rest) = bytes.get(at..).filter(|rest| !rest.is_empty()) {
        let (len, literal) = match rest {
            [b'/', b'/', ..] => (find(rest, b"\n"), Some(None)),
            [b'/', b'*', ..] => (block_comment_len(rest), Some(None)),
            [b'"', ..] => literal(rest, 1, quoted_len(&rest[1..]), 1),
            [b'\'', b'\\', _, after @ ..] => (4 + find(after, b"'"), None),
            [b'\'', b'"', b'\'', ..] => (3, None),
            [first, ..] if first.is_ascii_alphabetic() || *first == b'_' => word(rest),
            _ => (1, None),
        };
        let end = bytes.len().min(at + len);
        if let Some(literal) = literal {
            parts.push(Part { start: at, end, literal });
        }
        at += len;
    }
    parts
}

/// Length of a word, or of the raw literal that it begins.
fn word(rest: &[u8]) -> (usize, Option<Option<(usize, usize)>>) {
    let is_end = |byte: &u8| !byte.is_ascii_alphanumeric() && *byte != b'_';
    let len = rest.iter().position(is_end).unwrap_or(rest.len());
    let hashes = rest[len..].iter().take_while(|byte| **byte == b'#').count();
    let is_raw = matches!(&rest[..len], b"r" | b"br" | b"cr");
    if !is_raw || rest.get(len + hashes) != Some(&b'"') {
        return (len, None);
    }
    let before = len + hashes + 1;
    let closing = [&b"\""[..], &b"#".repeat(hashes)].concat();
    literal(rest, before, find(&rest[before..], &closing), closing.len())
}

/// Length of a literal and of its quotes. An unfinished literal lacks the closing one.
fn literal(rest: &[u8], before: usize, len: usize, after: usize) -> (usize, Option<Option<(usize, usize)>>) {
    let after = after.min(rest.len() - before - len);
    (before + len + after, Some(Some((before, after))))
}

/// Bytes up to the quote that closes a literal.
fn quoted_len(text: &[u8]) -> usize {
    let mut escaped = false;
    let closes = |byte: &u8| {
        let closes = *byte == b'"' && !escaped;
        escaped = *byte == b'\\' && !escaped;
        closes
    };
    text.iter().position(closes).unwrap_or(text.len())
}

/// Bytes before `end`, or all.
fn find(text: &[u8], end: &[u8]) -> usize {
    text.windows(end.len()).position(|part| part == end).unwrap_or(text.len())
}

/// Bytes of a block comment, which may hold others.
fn block_comment_len(text: &[u8]) -> usize {
    let (mut at, mut depth) = (0, 0);
    while at < text.len() {
        match &text[at..] {
            [b'/', b'*', ..] => (at, depth) = (at + 2, depth + 1),
            [b'*', b'/', ..] => (at, depth) = (at + 2, depth - 1),
            _ => at += 1,
        }
        if depth == 0 {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(source: &str) -> Vec<(usize, Kind, String)> {
        passages(source).into_iter().map(|passage| (passage.line, passage.kind, passage.text)).collect()
    }

    #[test]
    fn adjoining_lines_are_one_passage() {
        let item = Kind::ItemDoc { public: true, help: false };
        assert_eq!(
            kinds(
                "//! One\n//! two.\n\n/// Three\n///\n/// four.\n#[must_use]\npub fn five() {} // six\n\
                 // seven"
            ),
            [
                (1, Kind::ModuleDoc, "One\ntwo.".to_owned()),
                (4, item, "Three\n\nfour.".to_owned()),
                (8, Kind::Comment, "six\nseven".to_owned()),
            ]
        );
    }

    #[test]
    fn an_item_is_public_by_itself_or_by_its_enum() {
        let source = "/// A\npub enum A {\n    /// B\n    B,\n}\n/// C\nenum C {\n    /// D\n    D,\n}\n\
            /// E\npub struct E {\n    /// F\n    f: i32,\n    /// G\n    pub g: i32,\n}\n/// H\n\
            pub(crate) fn h() {}\n";
        let public: Vec<_> = kinds(source)
            .into_iter()
            .filter(|(_, kind, _)| matches!(kind, Kind::ItemDoc { public: true, .. }))
            .map(|(_, _, text)| text)
            .collect();
        assert_eq!(public, ["A", "B", "E", "G"]);
    }

    #[test]
    fn help_is_what_clap_derives() {
        let source = "/// A\n#[derive(Args)]\n#[command(\n    about\n)]\npub struct A {\n    /// B\n    \
            #[arg(long)]\n    \
            pub b: i32,\n}\n/// C\nstruct C {\n    /// D\n    d: i32,\n}\n";
        let help: Vec<_> = kinds(source)
            .into_iter()
            .filter(|(_, kind, _)| matches!(kind, Kind::ItemDoc { help: true, .. }))
            .map(|(_, _, text)| text)
            .collect();
        assert_eq!(help, ["A", "B"]);
    }

    #[test]
    fn literals_are_told_from_comments_and_characters() {
        let source = r##"
/* "a" /* "b" */ "c" */
const QUOTE: char = '"'; // "d"
const OTHERS: [char; 3] = ['\'', '\\', '\u{22}'];
fn lifetime<'a>(r#type: &'a str) -> &'a str { "e \" f" }
const RAW: &str = r#"g "h""#; const BYTES: &[u8] = br"\"; const LAST: &str = "i"##;
        let literals: Vec<_> = kinds(source)
            .into_iter()
            .filter(|part| part.1 == Kind::Literal)
            .map(|part| (part.0, part.2))
            .collect();
        let expected = [(5, r#"e \" f"#), (6, r#"g "h""#), (6, r"\"), (6, "i")];
        assert_eq!(literals, expected.map(|(line, text)| (line, text.to_owned())));
    }
}
