//! A page of Markdown: its commands, files, pictures and Rust, each with its line.

use std::path::{Path, PathBuf};

/// Contents of a page.
pub struct Page {
    pub file: PathBuf,
    /// Commands and files, in the page's order.
    pub items: Vec<Item>,
    /// Line and path of each picture.
    pub pictures: Vec<(usize, String)>,
    /// Line and text of each block of Rust.
    pub rust: Vec<(usize, String)>,
    /// Error in a page, with its name and line.
    pub errors: Vec<String>,
}

/// One step of a page.
#[derive(Debug, PartialEq)]
pub enum Item {
    /// Arguments of `relief`.
    Command { line: usize, words: Vec<String> },
    /// A file that the page tells its reader to write.
    File { line: usize, name: String, text: String },
}

/// Beginnings of commands that are the same as `relief`.
const RELIEF: [&str; 2] = ["relief ", "cargo run --release --bin relief -- "];

/// Reads a page.
pub fn parse(file: &Path, text: &str) -> Page {
    let mut page = Page {
        file: file.to_owned(),
        items: Vec::new(),
        pictures: Vec::new(),
        rust: Vec::new(),
        errors: Vec::new(),
    };
    let mut lines = text.lines().enumerate().map(|(at, line)| (at + 1, line));
    while let Some((number, line)) = lines.next() {
        let Some(language) = line.trim_start().strip_prefix("```") else {
            page.pictures.extend(pictures(line).map(|path| (number, path)));
            continue;
        };
        let block: Vec<(usize, &str)> = lines.by_ref().take_while(|(_, line)| line.trim() != "```").collect();
        page.add_block(number, language.trim(), &block);
    }
    page
}

impl Page {
    /// The page's name and a line, as editors read them.
    pub fn place(&self, line: usize) -> String {
        format!("{}:{line}", self.file.display())
    }

    fn add_block(&mut self, number: usize, language: &str, block: &[(usize, &str)]) {
        let text = || block.iter().map(|(_, line)| format!("{line}\n")).collect::<String>();
        let name = block.first().and_then(|(_, line)| line.strip_prefix("# "));
        match language {
            "sh" => self.add_commands(block),
            "rust" => self.rust.push((number, text())),
            "toml" => {
                if let Some(name) = name.filter(|name| name.ends_with(".toml") && !name.contains('/')) {
                    self.items.push(Item::File { line: number, name: name.to_owned(), text: text() });
                }
            }
            "" => self.error(number, "a block needs a language: `sh` is run, `text` is not"),
            _ => {}
        }
    }

    fn add_commands(&mut self, block: &[(usize, &str)]) {
        let mut rest = block.iter();
        while let Some(&(number, line)) = rest.next() {
            let mut command = line.trim().to_owned();
            while let Some(part) = command.strip_suffix('\\') {
                command = part.to_owned() + rest.next().map_or("", |(_, line)| line.trim());
            }
            if command.is_empty() || command.starts_with('#') {
                continue;
            }
            match RELIEF.iter().find_map(|start| command.strip_prefix(start)) {
                Some(arguments) => match words(arguments) {
                    Ok(words) => self.items.push(Item::Command { line: number, words }),
                    Err(message) => self.error(number, &message),
                },
                // Cargo's commands take minutes or change the reader's own project.
                None if command.starts_with("cargo ") => {}
                None => self.error(number, "only `relief` and `cargo` can be run here"),
            }
        }
    }

    fn error(&mut self, line: usize, message: &str) {
        self.errors.push(format!("{}: {message}", self.place(line)));
    }
}

/// Words of a shell's command: single and double quotes, and a comment at the end. Whatever asks more of a
/// shell is refused, so that the commands mean the same in each of them.
fn words(command: &str) -> Result<Vec<String>, String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for letter in command.chars() {
        match (letter, quote) {
            (_, Some(open)) if letter == open => quote = None,
            (_, Some(_)) => word.get_or_insert_default().push(letter),
            ('\'' | '"', None) => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            (' ', None) => words.extend(word.take()),
            ('#', None) if word.is_none() => break,
            ('|' | '>' | '<' | '&' | ';' | '$' | '*' | '`', None) => {
                return Err(format!("'{letter}' needs a shell, and differs between shells"));
            }
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    if quote.is_some() { Err("a quote is not closed".to_owned()) } else { Ok(words) }
}

/// Paths of the pictures of a line, `![text](path)`.
fn pictures(line: &str) -> impl Iterator<Item = String> {
    line.split("![").skip(1).filter_map(|part| {
        let (_, path) = part.split_once("](")?;
        Some(path.split_once(')')?.0.to_owned())
    })
}
