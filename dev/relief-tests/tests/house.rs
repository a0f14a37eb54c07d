//! What holds for the sources of all libraries: their texts name no flag of the command, which adds it.

use std::path::{Path, PathBuf};

/// The crate whose texts are those of the command.
const COMMAND: &str = "relief-cli";

/// A literal of a text: its line, counted from 1, and what stands between its quotes.
type Literal<'a> = (usize, &'a [u8]);

/// The literals of texts in Rust source, raw ones and those of bytes too; none that stands in a comment.
fn literals(source: &[u8]) -> Vec<Literal<'_>> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(rest) = source.get(at..).filter(|rest| !rest.is_empty()) {
        at += match rest {
            [b'/', b'/', ..] => rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len()),
            [b'/', b'*', ..] => comment_len(rest),
            [b'"', ..] => text(source, at, 1, text_len(&rest[1..]), 1, &mut found),
            [b'\'', b'\\', _, after @ ..] => 4 + until(after, b"'"),
            [b'\'', b'"', b'\'', ..] => 3,
            [first, ..] if first.is_ascii_alphabetic() || *first == b'_' => {
                let word = rest.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_');
                let word = word.unwrap_or(rest.len());
                let hashes = rest[word..].iter().take_while(|byte| **byte == b'#').count();
                let is_raw = matches!(&rest[..word], b"r" | b"br" | b"cr");
                if is_raw && rest.get(word + hashes) == Some(&b'"') {
                    let (before, after) = (word + hashes + 1, 1 + hashes);
                    let end = [&b"\""[..], &b"#".repeat(hashes)].concat();
                    text(source, at, before, until(&rest[before..], &end), after, &mut found)
                } else {
                    word
                }
            }
            _ => 1,
        };
    }
    found
}

/// Notes a literal that begins at a place with so many bytes before its text, and gives its length in all.
fn text<'a>(
    source: &'a [u8],
    at: usize,
    before: usize,
    len: usize,
    after: usize,
    found: &mut Vec<Literal<'a>>,
) -> usize {
    let start = at + before;
    found.push((line(&source[..start]), &source[start..start + len]));
    before + len + after
}

/// The line on which a text ends.
fn line(text: &[u8]) -> usize {
    1 + text.iter().filter(|byte| **byte == b'\n').count()
}

/// Bytes of a text up to its closing quote.
fn text_len(text: &[u8]) -> usize {
    let mut escaped = false;
    let closes = |byte: &u8| {
        let closes = *byte == b'"' && !escaped;
        escaped = *byte == b'\\' && !escaped;
        closes
    };
    text.iter().position(closes).unwrap_or(text.len())
}

/// Bytes up to the next such end.
fn until(text: &[u8], end: &[u8]) -> usize {
    text.windows(end.len()).position(|found| found == end).unwrap_or(text.len())
}

/// Bytes of a comment that may hold others.
fn comment_len(text: &[u8]) -> usize {
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

/// The lines on which a literal names a flag.
fn flags(source: &str) -> Vec<usize> {
    let mut lines = Vec::new();
    for (first, text) in literals(source.as_bytes()) {
        let names =
            |at: &usize| matches!(&text[*at..], [b'-', b'-', letter, ..] if letter.is_ascii_alphabetic());
        lines.extend((0..text.len()).filter(names).map(|at| first + line(&text[..at]) - 1));
    }
    lines
}

/// All Rust files below a folder.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the folder is readable") {
        let path = entry.expect("the folder is readable").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn no_text_of_a_library_names_a_flag_of_the_command() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates");
    let (mut libraries, mut found) = (0, Vec::new());
    for entry in std::fs::read_dir(&crates).expect("the workspace has crates") {
        let folder = entry.expect("the folder is readable").path();
        if !folder.join("src/lib.rs").is_file() || folder.ends_with(COMMAND) {
            continue;
        }
        libraries += 1;
        for file in rust_files(&folder.join("src")) {
            let source = std::fs::read_to_string(&file).expect("source is text");
            found.extend(flags(&source).into_iter().map(|line| format!("{}:{line}", file.display())));
        }
    }
    assert!(libraries >= 6, "{libraries} libraries");
    assert!(
        found.is_empty(),
        "flags belong to the command, which knows them (see its advice.rs):\n{}",
        found.join("\n")
    );
}

#[test]
fn a_flag_in_a_text_is_seen_and_one_in_a_comment_is_not() {
    let source = r##"
//! The command's `--channel`, "--channel".
/// "--fill" fills.
#[error("choose one with --channel")] // line 4
const LONG: &str = "a quote \" and
    then on line 6: give --fill";
/* "--raw" /* "--raw" */ "--raw" */
const QUOTE: char = '"'; // and no text begins there: --raw
const OTHERS: [char; 3] = ['\'', '\\', '\u{22}'];
fn lifetime<'a>(r#type: &'a str) -> &'a str { r#type }
const RAW: &str = r#"a "quote" on line 11, --max-memory"#;
const BYTES: &[u8] = b"--wrap on line 12";
const RULES: &str = "-- no flag, a---- nor this, - -x, 1--2";
const LAST: i32 = 3 - -2;
const RAW_BYTES: &[u8] = br"\"; const AFTER: &str = "--scale on line 15";
"##;
    assert_eq!(flags(source), [4, 6, 11, 12, 15]);
    assert_eq!(flags("\"unfinished --raw"), [1]);
    assert_eq!(flags("r#\"unfinished --raw"), [1]);
    assert_eq!(flags("/* unfinished \"--raw\""), []);
    assert_eq!(flags("'\\"), []);
}
