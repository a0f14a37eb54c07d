//! Names of a program's functions: all that stands outside of functions begins with a prefix, so that it goes
//! into any shader.

use std::collections::{BTreeMap, BTreeSet};

use super::reduce::declared;
use super::syntax::{Expression, ItemKind, Unit, change_expressions};
use crate::ExportError;

/// The prefix of the sources, of functions and of types.
const OWN: (&str, &str) = ("relief_", "Relief");

/// Words that no name may be, or begin with and an underscore, in one of the languages.
const WORDS: &[&str] = &[
    "alias",
    "array",
    "as",
    "asm",
    "async",
    "attribute",
    "auto",
    "await",
    "bool",
    "break",
    "buffer",
    "case",
    "catch",
    "cbuffer",
    "centroid",
    "char",
    "class",
    "coherent",
    "common",
    "compile",
    "const",
    "constant",
    "constexpr",
    "continue",
    "continuing",
    "default",
    "delete",
    "device",
    "diagnostic",
    "discard",
    "do",
    "double",
    "else",
    "enable",
    "enum",
    "export",
    "extern",
    "external",
    "f16",
    "f32",
    "false",
    "filter",
    "final",
    "fixed",
    "flat",
    "float",
    "fn",
    "for",
    "fragment",
    "friend",
    "gl",
    "global",
    "goto",
    "groupshared",
    "half",
    "highp",
    "hint",
    "i32",
    "if",
    "import",
    "in",
    "inline",
    "inout",
    "input",
    "instance",
    "int",
    "interface",
    "invariant",
    "kernel",
    "layout",
    "let",
    "linear",
    "long",
    "loop",
    "lowp",
    "macro",
    "main",
    "match",
    "matrix",
    "mediump",
    "metal",
    "mod",
    "module",
    "mut",
    "namespace",
    "naga",
    "new",
    "nil",
    "noinline",
    "null",
    "operator",
    "out",
    "output",
    "override",
    "package",
    "packed",
    "partition",
    "pass",
    "patch",
    "precision",
    "private",
    "protected",
    "ptr",
    "pub",
    "public",
    "readonly",
    "ref",
    "register",
    "render_mode",
    "require",
    "requires",
    "resource",
    "restrict",
    "return",
    "row_major",
    "sample",
    "sampler",
    "self",
    "shader_type",
    "shared",
    "short",
    "signed",
    "sizeof",
    "smooth",
    "snorm",
    "static",
    "struct",
    "subroutine",
    "super",
    "switch",
    "target",
    "tbuffer",
    "technique",
    "template",
    "texture",
    "this",
    "thread",
    "threadgroup",
    "throw",
    "trait",
    "true",
    "try",
    "type",
    "typedef",
    "typename",
    "u32",
    "uint",
    "uniform",
    "union",
    "unless",
    "unorm",
    "unsigned",
    "use",
    "using",
    "var",
    "varying",
    "vec2",
    "vec3",
    "vec4",
    "vector",
    "vertex",
    "virtual",
    "void",
    "volatile",
    "wgsl",
    "where",
    "while",
    "with",
    "workgroup",
    "writeonly",
    "yield",
];

/// A prefix, as functions and as types have it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prefix {
    functions: String,
    types: String,
}

impl Prefix {
    /// Checks a prefix, which is a name by itself.
    pub fn new(prefix: &str) -> Result<Self, ExportError> {
        let refused = |reason: &'static str| ExportError::Prefix { prefix: prefix.to_owned(), reason };
        if !prefix.starts_with(|c: char| c.is_ascii_lowercase()) {
            return Err(refused("it must begin with a small letter from a to z"));
        }
        if !prefix.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_') {
            return Err(refused("it may hold small letters, digits and '_' alone"));
        }
        if prefix.contains("__") || prefix.ends_with('_') {
            return Err(refused("it may not hold two '_' in a row, nor end in one: one is added"));
        }
        if WORDS.contains(&prefix) {
            return Err(refused("it is a word of a shading language"));
        }
        let types = prefix.split('_').map(|word| {
            let (first, rest) = word.split_at(1);
            first.to_uppercase() + rest
        });
        Ok(Self { functions: format!("{prefix}_"), types: types.collect() })
    }

    /// A name of the sources with this prefix.
    pub fn of(&self, name: &str) -> String {
        let is_type =
            name.starts_with(|c: char| c.is_ascii_uppercase()) && name.contains(|c: char| c.is_lowercase());
        if is_type {
            return format!("{}{}", self.types, name.strip_prefix(OWN.1).unwrap_or(name));
        }
        if name.chars().any(char::is_lowercase) {
            return format!("{}{}", self.functions, name.strip_prefix(OWN.0).unwrap_or(name));
        }
        format!("{}{name}", self.functions.to_uppercase())
    }

    /// Renames all declarations.
    pub fn rename(&self, unit: &mut Unit) {
        let known = || unit.items.iter().filter_map(|item| item.kind.name());
        // What programs call keeps its name; another with the same name gets a word more.
        let lent: BTreeSet<String> = known().filter(|name| is_lent(name)).map(|name| self.of(name)).collect();
        let of = |name: &str| {
            let plain = self.of(name);
            if lent.contains(&plain) && !is_lent(name) { self.of(&format!("Traced{name}")) } else { plain }
        };
        let names: BTreeMap<String, String> = known().map(|name| (name.to_owned(), of(name))).collect();
        let renamed = |name: &mut String| {
            if let Some(other) = names.get(name) {
                name.clone_from(other);
            }
        };
        let in_type = |of: &mut String| *of = in_words(of, &|word| names.get(word).map(String::as_str));
        let in_quotes = |line: &mut String| {
            // Comments name declarations in backquotes.
            let parts = line.split('`').enumerate();
            let parts = parts.map(|(number, part)| {
                if number % 2 == 1 {
                    in_words(part, &|word| names.get(word).map(String::as_str))
                } else {
                    part.to_owned()
                }
            });
            *line = parts.collect::<Vec<_>>().join("`");
        };
        for item in &mut unit.items {
            item.comment.iter_mut().for_each(in_quotes);
            match &mut item.kind {
                ItemKind::Heading => {}
                ItemKind::Struct(of) => {
                    renamed(&mut of.name);
                    for member in &mut of.members {
                        in_type(&mut member.of);
                        member.comment.iter_mut().for_each(in_quotes);
                    }
                }
                ItemKind::Constant(of) => {
                    renamed(&mut of.name);
                    of.value.change(&mut |part| rename(part, &renamed));
                }
                ItemKind::Variable(of) => {
                    renamed(&mut of.name);
                    in_type(&mut of.of);
                }
                ItemKind::Function(of) => {
                    renamed(&mut of.name);
                    in_type(&mut of.returns);
                    of.parameters.iter_mut().for_each(|parameter| in_type(&mut parameter.of));
                    // A local may have the name of a function, which is called.
                    let mut locals = declared(&of.body);
                    locals.extend(of.parameters.iter().map(|parameter| parameter.name.clone()));
                    change_expressions(&mut of.body, &mut |part| {
                        if !matches!(part, Expression::Name(name) if locals.contains(name)) {
                            rename(part, &renamed);
                        }
                    });
                }
            }
        }
    }
}

/// A text with other names for some of its words.
pub fn in_words<'a>(text: &'a str, other: &dyn Fn(&'a str) -> Option<&'a str>) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut renamed = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_part) {
        let (before, from) = rest.split_at(start);
        let (word, after) = from.split_at(from.find(|c| !is_part(c)).unwrap_or(from.len()));
        renamed += before;
        renamed += other(word).unwrap_or(word);
        rest = after;
    }
    renamed + rest
}

/// Whether a name of the sources begins with their prefix: programs use it.
fn is_lent(name: &str) -> bool {
    name.starts_with(OWN.0) || name.starts_with(OWN.1)
}

fn rename(part: &mut Expression, renamed: &dyn Fn(&mut String)) {
    if let Expression::Name(name) | Expression::Call(name, _) = part {
        renamed(name);
    }
}
