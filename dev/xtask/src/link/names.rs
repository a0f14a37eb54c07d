//! The names that a text declares and uses.

use wgsl_parse::syntax::GlobalDeclaration;

/// The name that a declaration declares, if it declares one.
pub fn name_of(declaration: &GlobalDeclaration) -> Option<String> {
    match declaration {
        GlobalDeclaration::Declaration(declaration) => Some(declaration.ident.to_string()),
        GlobalDeclaration::TypeAlias(alias) => Some(alias.ident.to_string()),
        GlobalDeclaration::Struct(structure) => Some(structure.ident.to_string()),
        GlobalDeclaration::Function(function) => Some(function.ident.to_string()),
        GlobalDeclaration::Void | GlobalDeclaration::ConstAssert(_) => None,
    }
}

/// The identifiers of a text outside of comments, but for those after a dot, which are members.
pub fn identifiers(text: &str) -> impl Iterator<Item = &str> {
    used_names(text).map(|(name, _)| name)
}

/// The identifiers, and whether each is called: a parenthesis follows it.
pub fn used_names(text: &str) -> impl Iterator<Item = (&str, bool)> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let mut rest = line;
        let mut before = ' ';
        std::iter::from_fn(move || {
            loop {
                let start = rest.find(is_part)?;
                before = rest[..start].chars().next_back().unwrap_or(before);
                let word = &rest[start..];
                let end = word.find(|c| !is_part(c)).unwrap_or(word.len());
                let (word, after) = word.split_at(end);
                rest = after;
                let is_member = before == '.';
                before = ' ';
                if !is_member && !word.starts_with(|c: char| c.is_ascii_digit()) {
                    return Some((word, after.trim_start().starts_with('(')));
                }
            }
        })
    })
}
