//! No text of a library names a flag of the command, which adds it.

use relief_words::rust::{self, Kind};
use relief_words::tree;

/// The crate whose texts are the command's.
const COMMAND: &str = "relief-cli";

/// The lines on which a literal names a flag.
fn flags(source: &str) -> Vec<usize> {
    let mut lines = Vec::new();
    for literal in rust::passages(source).into_iter().filter(|passage| passage.kind == Kind::Literal) {
        let text = literal.text.as_bytes();
        let names =
            |at: &usize| matches!(&text[*at..], [b'-', b'-', letter, ..] if letter.is_ascii_alphabetic());
        let line = |at: usize| literal.line + text[..at].iter().filter(|byte| **byte == b'\n').count();
        lines.extend((0..text.len()).filter(names).map(line));
    }
    lines
}

#[test]
fn no_text_of_a_library_names_a_flag_of_the_command() {
    let (mut libraries, mut found) = (0, Vec::new());
    for folder in crate::crates().into_iter().filter(|folder| !folder.ends_with(COMMAND)) {
        libraries += 1;
        for file in tree::files(&folder.join("src"), &["rs"]).expect("the folder is readable") {
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
