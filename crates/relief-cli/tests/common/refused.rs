//! Common checks of all refusals.

use std::path::Path;

use super::command::{Folder, Ran};

/// Folder of the outputs; nothing else is ever there.
pub const OUT: &str = "out";

/// Returns the names of a folder's entries.
pub fn entries(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder is there");
    entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
}

/// A folder with an empty one for outputs.
pub fn with_out() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path(OUT)).expect("the temporary folder is writable");
    folder
}

/// Fails unless the command failed as it should: with the exit code, in a paragraph that has the
/// words, without a trace. Notes may stand before it, a line each: what they say of the input is
/// often why it was refused.
pub fn assert_refused(folder: &Folder, ran: &Ran, code: i32, words: &[&str]) {
    let Ran { line, stderr, stdout, .. } = ran;
    assert_eq!(ran.code, Some(code), "relief {line}: {stderr}");
    assert_eq!(stdout, "", "relief {line}");
    let is_note = |line: &&str| line.starts_with("note: ");
    let first = stderr.lines().find(|line| !is_note(line)).unwrap_or_default();
    assert!(first.starts_with("error: "), "relief {line}: {stderr}");
    assert!(!stderr.contains("panicked") && !stderr.contains("RUST_BACKTRACE"), "relief {line}: {stderr}");
    assert!(stderr.len() > 20, "relief {line}: {stderr}");
    // What clap refuses has its usage below; everything else is one paragraph.
    let usage = stderr.contains("\n\nUsage:") || stderr.contains("\n\nFor more information");
    assert!(usage || !stderr.trim_end().contains("\n\n"), "relief {line}: {stderr}");
    for word in words {
        assert!(stderr.contains(word), "relief {line} does not say '{word}': {stderr}");
    }
    assert_flags_are_known(folder, ran);
    assert_eq!(entries(&folder.path(OUT)), Vec::<String>::new(), "relief {line} left something behind");
}

/// The flags that a text names.
fn flags(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !c.is_ascii_lowercase() && c != '-');
    words.filter(|word| word.len() > 2 && word.starts_with("--"))
}

/// Fails where an error names a flag that the command does not take, but for those that it was
/// given.
fn assert_flags_are_known(folder: &Folder, Ran { line, stderr, .. }: &Ran) {
    let error = stderr.split("\n\n").next().unwrap_or_default();
    // What stands between backticks are commands of their own.
    let of_this = error.split('`').step_by(2);
    let mut help = None;
    for flag in of_this.flat_map(flags).filter(|flag| flags(line).all(|given| given != *flag)) {
        let command = match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["height", second, ..] => format!("height {second}"),
            [first, ..] => first.to_owned(),
            [] => String::new(),
        };
        let help = help.get_or_insert_with(|| folder.relief(&format!("{command} --help")).stdout);
        let is_known = flags(help).any(|known| known == flag);
        assert!(is_known, "relief {line} names {flag}, which it does not take: {stderr}");
    }
}

/// Makes the folder [`OUT`] read-only, and returns whether it worked: some users, root among them,
/// may write anywhere, which is printed.
pub fn make_read_only(folder: &Folder) -> bool {
    let out = folder.path(OUT);
    let mut permissions = std::fs::metadata(&out).expect("it is there").permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&out, permissions).expect("it is ours");
    let is_read_only = std::fs::write(out.join("probe"), "").is_err();
    if !is_read_only {
        println!("skipped: this user may write into folders that are read-only");
    }
    is_read_only
}
