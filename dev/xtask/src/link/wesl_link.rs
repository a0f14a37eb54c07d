//! Modules to one plain WGSL text.

use std::collections::{BTreeMap, BTreeSet};

use wgsl_parse::syntax::{GlobalDeclaration, TranslationUnit};

use super::modules::{Modules, module_path};
use super::names::{identifiers, name_of};

/// The conditions that modules may ask for: `@if(fast)` and `@if(explain)`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Features {
    /// Heights are sampled by the GPU's filter.
    pub fast: bool,
    /// Loops call marks, which a drawing of them is made from.
    pub explain: bool,
}

/// Links a root module and keeps its named declarations, or its entry points. Names stay as written. Comments
/// do not survive.
pub fn link(
    modules: &Modules,
    root: &str,
    keep: &[&str],
    features: Features,
) -> Result<TranslationUnit, String> {
    let mut linker = wesl::Wesl::new_barebones().set_custom_resolver(modules.resolver());
    linker
        .set_mangler(wesl::ManglerKind::None)
        .use_imports(true)
        .use_condcomp(true)
        .use_stripping(true)
        .set_feature("fast", features.fast)
        .set_feature("explain", features.explain);
    if !keep.is_empty() {
        linker.keep_declarations(keep.iter().map(|&name| name.to_owned()).collect());
    }
    let linked =
        linker.compile(&module_path(root)).map_err(|error| format!("linking {root} failed:\n{error}"))?;
    let declared: BTreeSet<String> =
        linked.syntax.global_declarations.iter().filter_map(|of| name_of(of)).collect();
    match keep.iter().find(|name| !declared.contains(**name)) {
        Some(unknown) => Err(format!("linking {root} failed: it has no '{unknown}'")),
        None => Ok(stripped(linked.syntax, keep)),
    }
}

/// A program without the declarations that neither its entry points nor the names to keep reach. The linker's
/// own stripping leaves what other unreached declarations use.
fn stripped(mut unit: TranslationUnit, keep: &[&str]) -> TranslationUnit {
    let texts: BTreeMap<String, String> = unit
        .global_declarations
        .iter()
        .filter_map(|declaration| Some((name_of(declaration)?, declaration.to_string())))
        .collect();
    let is_entry =
        |text: &&String| ["@vertex", "@fragment", "@compute"].iter().any(|entry| text.contains(entry));
    let entries = texts.iter().filter(|(_, text)| is_entry(text)).map(|(name, _)| name.as_str());
    let mut waiting: Vec<&str> = entries.chain(keep.iter().copied()).collect();
    let mut reached = BTreeSet::new();
    while let Some(name) = waiting.pop() {
        if let Some(text) = texts.get(name)
            && reached.insert(name.to_owned())
        {
            waiting.extend(identifiers(text));
        }
    }
    unit.global_declarations
        .retain(|declaration| name_of(declaration).is_none_or(|name| reached.contains(&name)));
    unit
}

/// A linked program as text. The linker's order of declarations changes from run to run: they are sorted into
/// what a reader expects. Twice the same name is an error.
pub fn ordered(unit: &TranslationUnit) -> Result<String, String> {
    let mut declarations: Vec<(u8, String, String)> = Vec::new();
    for declaration in &unit.global_declarations {
        let text = declaration.to_string();
        let (rank, name) = match &**declaration {
            GlobalDeclaration::Void => continue,
            GlobalDeclaration::Declaration(declaration) => {
                let rank = if text.contains("@group") { 2 } else { 0 };
                (rank, declaration.ident.to_string())
            }
            GlobalDeclaration::TypeAlias(alias) => (1, alias.ident.to_string()),
            GlobalDeclaration::Struct(structure) => (1, structure.ident.to_string()),
            GlobalDeclaration::Function(function) => (3, function.ident.to_string()),
            GlobalDeclaration::ConstAssert(_) => (4, text.clone()),
        };
        declarations.push((rank, name, text.trim().to_owned()));
    }
    declarations.sort();
    if let Some(twice) = declarations.windows(2).find(|pair| pair[0].1 == pair[1].1) {
        return Err(format!("the name '{}' is declared twice", twice[0].1));
    }
    let mut text = String::new();
    let mut before = None;
    for (rank, _, declaration) in &declarations {
        if before.is_some_and(|before| before != *rank || *rank == 1 || *rank == 3) {
            text.push('\n');
        }
        before = Some(*rank);
        text.push_str(declaration);
        text.push('\n');
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_sorted_and_a_name_may_stand_once() {
        let unit = |text: &str| text.parse::<TranslationUnit>().expect("valid WGSL");
        let one = ordered(&unit("fn b() {}\nconst z = 1u;\nstruct S { a: u32 }\nfn a() {}"))
            .expect("no name twice");
        let other = ordered(&unit("struct S { a: u32 }\nfn a() {}\nfn b() {}\nconst z = 1u;"))
            .expect("no name twice");
        assert_eq!(one, other);
        assert!(one.find("const z") < one.find("struct S") && one.find("fn a") < one.find("fn b"));
        let twice = ordered(&unit("fn a() {}\nfn b() {}\nfn a() {}"));
        assert!(twice.is_err_and(|said| said.contains("'a'")));
    }
}
