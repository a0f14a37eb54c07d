//! The comments of structs and their members, carried over to the Rust that is made of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::declarations::Declaration;

/// Comments by struct, and in it by member. The struct's own comment has the empty name.
pub struct Docs(BTreeMap<String, BTreeMap<String, Vec<String>>>);

impl Docs {
    /// Returns the comments of the given declarations.
    pub fn of(declarations: &[Declaration]) -> Self {
        let mut structs = BTreeMap::new();
        for declaration in declarations {
            let (mut comments, mut pending) = (BTreeMap::new(), Vec::new());
            let mut inside = false;
            for line in declaration.text.lines().map(str::trim) {
                if let Some(comment) = line.strip_prefix("//") {
                    pending.push(comment.trim().to_owned());
                } else if line.starts_with("struct ") {
                    comments.insert(String::new(), std::mem::take(&mut pending));
                    inside = true;
                } else if let Some((name, _)) = line.split_once(':')
                    && inside
                {
                    let name = name.rsplit(' ').next().unwrap_or_default();
                    comments.insert(name.to_owned(), std::mem::take(&mut pending));
                }
            }
            if inside {
                structs.insert(declaration.name.clone(), comments);
            }
        }
        Self(structs)
    }

    /// The Rust text with the comments before each public struct and member.
    ///
    /// # Errors
    ///
    /// When a struct has no comment: its page in the documentation would say nothing.
    pub fn add(&self, text: &str) -> Result<String, String> {
        let mut out = String::with_capacity(text.len());
        let mut members = None;
        for line in text.lines() {
            let indent = &line[..line.len() - line.trim_start().len()];
            let comment = if let Some(rest) = line.strip_prefix("pub struct ") {
                let name = rest.split([' ', '<']).next().unwrap_or_default();
                members = self.0.get(name);
                let comment = members.and_then(|members| members.get(""));
                if comment.is_none_or(Vec::is_empty) {
                    return Err(format!("the struct {name} has no comment in its WESL source"));
                }
                comment
            } else if line == "}" {
                members = None;
                None
            } else {
                let name = line.trim_start().strip_prefix("pub ").and_then(|rest| rest.split_once(':'));
                members.zip(name).and_then(|(members, (name, _))| members.get(name))
            };
            for sentence in comment.into_iter().flatten() {
                let _ = writeln!(out, "{indent}/// {sentence}");
            }
            let _ = writeln!(out, "{line}");
        }
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn docs(text: &str) -> Docs {
        let (module, name, text) = ("shared/types".to_owned(), "Light".to_owned(), text.to_owned());
        Docs::of(&[Declaration { module, name, is_function: true, fast: None, text, uses: Vec::new() }])
    }

    #[test]
    fn comments_stand_before_the_struct_and_its_members() {
        let docs =
            docs("// A light.\nstruct Light {\n    // Where it is.\n    place: vec4f,\n    color: vec4f,\n}");
        let rust = "#[repr(C)]\npub struct Light {\n    pub place: Vec4,\n    pub color: Vec4,\n}\n";
        let expected = "#[repr(C)]\n/// A light.\npub struct Light {\n    /// Where it is.\n    \
                        pub place: Vec4,\n    pub color: Vec4,\n}\n";
        assert_eq!(docs.add(rust).as_deref(), Ok(expected));
    }

    #[test]
    fn a_struct_without_a_comment_is_refused() {
        assert!(docs("struct Light {\n    place: vec4f,\n}").add("pub struct Light {\n}\n").is_err());
    }
}
