//! Comments of declarations, put before them in other languages.

use std::collections::BTreeMap;

use crate::functions::syntax::{ItemKind, Unit};

/// The comments of functions and structs, by name, and of members by struct and name.
pub struct Comments {
    declarations: BTreeMap<String, String>,
    members: BTreeMap<(String, String), String>,
}

impl Comments {
    /// The first sentence of each comment.
    pub fn of(unit: &Unit) -> Self {
        let mut comments = Self { declarations: BTreeMap::new(), members: BTreeMap::new() };
        for item in &unit.items {
            let Some(name) = item.kind.name() else { continue };
            if let Some(sentence) = first_sentence(&item.comment) {
                comments.declarations.insert(name.to_owned(), sentence);
            }
            if let ItemKind::Struct(structure) = &item.kind {
                for member in &structure.members {
                    if let Some(sentence) = first_sentence(&member.comment) {
                        comments.members.insert((name.to_owned(), member.name.clone()), sentence);
                    }
                }
            }
        }
        comments
    }

    /// Adds comments to a text in a language of the C family, where functions and structs begin a line.
    pub fn add(&self, text: &str) -> String {
        let mut commented = String::with_capacity(2 * text.len());
        let mut inside: Option<String> = None;
        for line in text.lines() {
            let name = declared(line);
            if let Some(name) = &name {
                if let Some(sentence) = self.declarations.get(name) {
                    commented += &format!("// {sentence}\n");
                }
                inside = line.starts_with("struct ").then(|| name.clone());
            }
            if line.starts_with('}') {
                inside = None;
            }
            if let Some(structure) = &inside
                && name.is_none()
                && let Some(member) = member(line)
                && let Some(sentence) = self.members.get(&(structure.clone(), member.to_owned()))
            {
                commented += &format!("    // {sentence}\n");
            }
            commented += line;
            commented.push('\n');
        }
        commented
    }
}

/// The name that a line declares: of a struct, or of a function whose body follows.
fn declared(line: &str) -> Option<String> {
    if let Some(rest) = line.strip_prefix("struct ") {
        return Some(rest.trim_end_matches([' ', '{']).to_owned());
    }
    let is_begin = line.starts_with(|c: char| c.is_ascii_alphabetic());
    let before = line.split_once('(').filter(|_| is_begin)?.0;
    let name = before.split_whitespace().last()?;
    (before.split_whitespace().count() > 1).then(|| name.to_owned())
}

/// The member that a line of a struct declares.
fn member(line: &str) -> Option<&str> {
    let (_, name) = line.trim().strip_suffix(';')?.rsplit_once(' ')?;
    Some(name)
}

fn first_sentence(comment: &[String]) -> Option<String> {
    let text = comment.join(" ");
    let end = text.find(". ").map_or(text.len(), |end| end + 1);
    (!text.is_empty()).then(|| text[..end].to_owned())
}
