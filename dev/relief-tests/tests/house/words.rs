//! Worn phrases are few where users read, and become fewer elsewhere. Sentences are short.
//!
//! `cargo xtask words .` prints the same counts by phrase.

use std::path::{Path, PathBuf};

use relief_words::phrases::{self, PHRASES};
use relief_words::rust::{self, Kind, Passage};
use relief_words::sentences::{Lengths, Sentence, lengths, sentences};
use relief_words::tree;

use crate::{crates, root};

/// Worn phrases allowed in all that users read. The limit must not rise. Other comments and pages
/// have none.
const MOST_FOR_USERS: usize = 10;
/// Pages that the command writes.
const GENERATED_PAGES: [&str; 2] = ["methods.md", "pairs.md"];
/// Words of a sentence: at the median, at the 90th percentile, and at most.
const LIMITS: (usize, usize, usize) = (16, 25, 35);

/// A worn phrase, as a reader looks for it.
fn place(file: &Path, line: usize, phrase: usize) -> String {
    format!("{}:{line}: {}", file.display(), PHRASES[phrase])
}

/// The worn phrases of a source, divided by whether users read the passage.
#[derive(Default)]
struct Worn {
    for_users: Vec<String>,
    elsewhere: Vec<String>,
}

impl Worn {
    /// Counts Rust or WESL. `is_front` says which passages users read; literals of others do not
    /// count.
    fn count_source(&mut self, file: &Path, source: &str, is_front: impl Fn(&Kind) -> bool) {
        for Passage { line, kind, text } in rust::passages(source) {
            let places =
                phrases::worn(&text).into_iter().map(|worn| place(file, line + worn.line - 1, worn.phrase));
            match kind {
                _ if is_front(&kind) => self.for_users.extend(places),
                Kind::Literal => {}
                _ => self.elsewhere.extend(places),
            }
        }
    }

    /// The phrases of a page.
    fn of_page(file: &Path) -> Vec<String> {
        let worn = phrases::worn(&read(file));
        worn.into_iter().map(|worn| place(file, worn.line, worn.phrase)).collect()
    }
}

fn read(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

fn files(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    tree::files(folder, extensions).unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
}

/// README, ARCHITECTURE and the guide.
fn front_pages() -> Vec<PathBuf> {
    let guide = files(&root().join("docs/guide"), &["md"]);
    [root().join("README.md"), root().join("ARCHITECTURE.md")].into_iter().chain(guide).collect()
}

/// The other pages, without those that a program writes and those about measurements and trials.
fn other_pages() -> Vec<PathBuf> {
    let docs = root().join("docs");
    let is_written = |page: &PathBuf| GENERATED_PAGES.iter().any(|name| page.ends_with(name));
    let pages =
        files(&docs, &["md"]).into_iter().filter(|page| page.parent() == Some(&docs) && !is_written(page));
    pages.chain([root().join("CONTRIBUTING.md")]).collect()
}

/// What users read of a crate's sources: literals, which hold errors and help; documentation of
/// `pub` items and modules; and of the command what clap shows.
fn is_front(is_command: bool, is_public_module: bool, kind: &Kind) -> bool {
    match kind {
        Kind::Literal => true,
        Kind::ItemDoc { help, .. } if is_command => *help,
        Kind::ItemDoc { public, .. } => *public,
        Kind::ModuleDoc => !is_command && is_public_module,
        Kind::Comment => false,
    }
}

/// The modules that some file of a crate declares `pub`, and its root.
fn public_modules(sources: &[(PathBuf, String)]) -> Vec<String> {
    let lines = sources.iter().flat_map(|(_, source)| source.lines());
    let names = lines.filter_map(|line| line.trim().strip_prefix("pub mod "));
    let name = |rest: &str| rest.trim_end_matches(['{', ';', ' ']).to_owned();
    names.map(name).chain(["lib".to_owned()]).collect()
}

/// The name of the module that a file holds.
fn module(file: &Path) -> String {
    let named = match file.file_stem() {
        Some(stem) if stem == "mod" => file.parent().and_then(Path::file_name),
        stem => stem,
    };
    named.unwrap_or_default().to_string_lossy().into_owned()
}

/// All worn phrases of the project but those in generated files and pages of measurements.
fn worn() -> Worn {
    let mut worn = Worn::default();
    let readmes = crates().into_iter().map(|folder| folder.join("README.md"));
    for page in front_pages().into_iter().chain(readmes) {
        worn.for_users.extend(Worn::of_page(&page));
    }
    for page in other_pages() {
        worn.elsewhere.extend(Worn::of_page(&page));
    }
    let in_sources: Vec<PathBuf> = crates().iter().map(|folder| folder.join("src")).collect();
    for folder in &in_sources {
        let is_command = folder.parent().is_some_and(|folder| folder.ends_with("relief-cli"));
        let sources: Vec<_> =
            files(folder, &["rs", "wesl"]).into_iter().map(|file| (file.clone(), read(&file))).collect();
        let public = public_modules(&sources);
        for (file, source) in &sources {
            let is_public = public.contains(&module(file));
            worn.count_source(file, source, |kind| is_front(is_command, is_public, kind));
        }
    }
    for folder in ["crates", "dev", "fuzz"] {
        for file in files(&root().join(folder), &["rs", "wesl"]) {
            if !in_sources.iter().any(|folder| file.starts_with(folder)) {
                worn.count_source(&file, &read(&file), |_| false);
            }
        }
    }
    worn
}

#[test]
fn worn_phrases_are_few_where_users_read_and_do_not_spread_elsewhere() {
    let worn = worn();
    println!("worn phrases: {} where users read, {} elsewhere", worn.for_users.len(), worn.elsewhere.len());
    let is_within = worn.for_users.len() <= MOST_FOR_USERS && worn.elsewhere.is_empty();
    assert!(
        is_within,
        "at most {MOST_FOR_USERS} where users read, but there are {}:\n{}\nnone elsewhere, but \
         there are {}:\n{}\nname the thing instead (CONTRIBUTING.md, Writing)",
        worn.for_users.len(),
        worn.for_users.join("\n"),
        worn.elsewhere.len(),
        worn.elsewhere.join("\n")
    );
}

/// The sentences of a page that are too long, and its lengths where too many are long.
fn too_long(page: &str) -> (Lengths, Vec<Sentence>) {
    let all = sentences(page);
    let lengths = lengths(&all);
    (lengths, all.into_iter().filter(|sentence| sentence.words > LIMITS.2).collect())
}

/// Whether a page keeps the three limits.
fn keeps_limits(lengths: &Lengths) -> bool {
    lengths.median <= LIMITS.0 && lengths.ninety <= LIMITS.1 && lengths.longest <= LIMITS.2
}

#[test]
fn sentences_of_readme_architecture_and_guide_are_short() {
    let mut faults = Vec::new();
    for page in front_pages() {
        let (lengths, long) = too_long(&read(&page));
        let Lengths { count, median, ninety, longest } = lengths;
        let line = format!(
            "{}: {count} sentences, {median} words at the median, {ninety} at the 90th percentile, {longest} \
             at most",
            page.display()
        );
        println!("{line}");
        if !keeps_limits(&lengths) {
            faults.push(line);
            faults.extend(
                long.into_iter().map(|sentence| format!("  line {}: {}", sentence.line, sentence.text)),
            );
        }
    }
    let (median, ninety, longest) = LIMITS;
    assert!(
        faults.is_empty(),
        "at most {median} words at the median, {ninety} at the 90th percentile, {longest} in all:\n{}",
        faults.join("\n")
    );
}

#[test]
fn each_phrase_is_seen_where_it_counts() {
    for (index, words) in PHRASES.iter().enumerate() {
        let [first, rest] = [0, 1].map(|part| words.splitn(2, ' ').nth(part).expect("two words"));
        let broken = format!("{first}\n/// {rest}");
        let source = format!(
            "//! {words}\n\n/// {broken}\npub fn a() {{}}\n\n/// {words}\nfn b() {{}} // {words}\n\n\
             const C: &str = \"{words}\";\n\n/// `{words}`, {first}, {rest}, x{words}\nstruct D;\n"
        );
        let lines = |worn: &[String]| -> Vec<String> {
            worn.iter().map(|place| place.split(' ').next().expect("a place").to_owned()).collect()
        };
        let mut library = Worn::default();
        library.count_source(Path::new("a.rs"), &source, |kind| is_front(false, true, kind));
        assert_eq!(lines(&library.for_users), ["a.rs:1:", "a.rs:3:", "a.rs:10:"], "{words}");
        assert_eq!(lines(&library.elsewhere), ["a.rs:7:", "a.rs:8:"], "{words}");
        assert!(library.for_users.iter().all(|place| place.ends_with(PHRASES[index])));

        let mut tests = Worn::default();
        tests.count_source(Path::new("a.rs"), &source, |_| false);
        assert_eq!((tests.for_users.len(), tests.elsewhere.len()), (0, 4), "{words}");

        let mut command = Worn::default();
        let help = format!(
            "/// {words}\n#[derive(Args)]\nstruct A {{\n    /// {words}\n    a: u8,\n}}\n/// {words}\n\
             fn b() {{}}\n"
        );
        command.count_source(Path::new("a.rs"), &help, |kind| is_front(true, true, kind));
        assert_eq!((command.for_users.len(), command.elsewhere.len()), (2, 1), "{words}");
    }
    assert_eq!(phrases::worn("as they are told").len(), 1);
}

#[test]
fn a_page_of_long_sentences_is_seen() {
    let sentence = |words: usize| format!("{}.", vec!["Word"; words].join(" "));
    let page = |lengths: &[usize]| lengths.iter().map(|words| sentence(*words)).collect::<Vec<_>>().join(" ");
    let within = page(&[16, 16, 16, 16, 16, 16, 16, 16, 16, 25]);
    assert!(keeps_limits(&too_long(&within).0));
    for (what, changed) in [
        ("median", page(&[17, 17, 17, 17, 17, 17, 16, 16, 16, 16])),
        ("90th percentile", page(&[16, 16, 16, 16, 16, 16, 16, 16, 16, 26])),
        ("longest", page(&[[16; 11].as_slice(), &[36]].concat())),
    ] {
        assert!(!keeps_limits(&too_long(&changed).0), "{what}");
    }
    let (_, long) = too_long(&format!(
        "# {}\n\n- {}\n\nShort.\n\n{within}\n{}",
        sentence(40),
        sentence(40),
        sentence(36)
    ));
    assert_eq!(long.iter().map(|sentence| (sentence.line, sentence.words)).collect::<Vec<_>>(), [(7, 36)]);
}
