//! Declarations of the modules as written, with their comments and the names that they use. The library
//! assembles shaders from them. The linker drops comments. This module reads the sources, and is checked
//! against the linker's result.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use relief_shaders::STAGES;
use wgsl_parse::syntax::{Attribute, GlobalDeclaration, TranslationUnit};

use super::modules::Modules;
use super::names::{name_of, used_names};

/// A declaration.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Module, such as `search/linear`.
    pub module: String,
    pub name: String,
    pub is_function: bool,
    /// Whether this is the declaration of fast sampling, if two have the name.
    pub fast: Option<bool>,
    /// Text as written, with its comment first.
    pub text: String,
    /// The other declarations that it uses.
    pub uses: Vec<String>,
}

/// All declarations except the dispatch's, module by module in the order in which a reader wants them.
pub fn all(modules: &Modules) -> Result<Vec<Declaration>, String> {
    let mut all = Vec::new();
    let mut paths: Vec<&str> = modules.paths().filter(|path| !path.starts_with("dispatch/")).collect();
    paths.sort_by_key(|path| (rank(path), *path));
    for path in paths {
        of_module(path, modules.source(path), &mut all)?;
    }
    let named = |is_function: bool| {
        let of_kind = all.iter().filter(move |declaration| declaration.is_function == is_function);
        of_kind.map(|declaration| declaration.name.clone()).collect::<BTreeSet<String>>()
    };
    let (mut functions, others) = (named(true), named(false));
    functions.extend(STAGES.iter().flat_map(|stage| stage.functions()));
    for declaration in &mut all {
        let Declaration { name, text, .. } = declaration;
        // A variable may have the name of a function, which is called where it is used.
        let is_used = |(used, is_called): &(&str, bool)| {
            *used != name && (others.contains(*used) || (*is_called && functions.contains(*used)))
        };
        let used = used_names(text).filter(is_used).map(|(used, _)| used.to_owned());
        declaration.uses = used.collect::<BTreeSet<String>>().into_iter().collect();
    }
    Ok(all)
}

/// The order of modules: what is bound, constants, what is shared, the stages in theirs, the roots.
fn rank(path: &str) -> usize {
    let folder = path.split('/').next().unwrap_or_default();
    let stage = STAGES.iter().position(|stage| stage.folder == folder);
    match (folder, stage) {
        ("bindings", _) => 0,
        ("constants", _) => 1,
        ("shared", _) => 2,
        (_, Some(place)) => 3 + place,
        _ => 3 + STAGES.len(),
    }
}

fn of_module(path: &str, source: &str, all: &mut Vec<Declaration>) -> Result<(), String> {
    let unit: TranslationUnit = source.parse().map_err(|error| format!("{path}.wesl: {error}"))?;
    for declaration in &unit.global_declarations {
        let Some(name) = name_of(declaration) else { continue };
        if is_marked(declaration) {
            continue;
        }
        let span = declaration.span().range();
        let (fast, text) = without_condition(declaration, source, span.clone())
            .ok_or_else(|| format!("{path}.wesl: {name}: only @if(fast) and @if(!fast) are known here"))?;
        let text = format!("{}{}", comment_before(&source[..span.start]), without_marks(&text));
        let is_function = matches!(&**declaration, GlobalDeclaration::Function(_));
        all.push(Declaration { module: path.to_owned(), name, is_function, fast, text, uses: Vec::new() });
    }
    Ok(())
}

/// The condition of what is kept for drawings alone.
const MARKED: &str = "@if(explain)";

/// Whether a declaration is for drawings alone.
fn is_marked(declaration: &GlobalDeclaration) -> bool {
    declaration.to_string().trim_start().starts_with(MARKED)
}

/// The text of a declaration without its marks, which are lines.
fn without_marks(text: &str) -> String {
    let kept = text.split_inclusive('\n').filter(|line| !line.trim_start().starts_with(MARKED));
    kept.collect()
}

/// The text of a declaration without its `@if`, and what that says of the sampling. None for another
/// condition.
fn without_condition(
    declaration: &GlobalDeclaration,
    source: &str,
    span: std::ops::Range<usize>,
) -> Option<(Option<bool>, String)> {
    let attributes = match declaration {
        GlobalDeclaration::Declaration(declaration) => &declaration.attributes,
        GlobalDeclaration::TypeAlias(alias) => &alias.attributes,
        GlobalDeclaration::Struct(structure) => &structure.attributes,
        GlobalDeclaration::Function(function) => &function.attributes,
        GlobalDeclaration::Void | GlobalDeclaration::ConstAssert(_) => return None,
    };
    let text = &source[span.clone()];
    for attribute in attributes {
        if let Attribute::If(condition) = &**attribute {
            let fast = match condition.to_string().as_str() {
                "fast" => true,
                "!fast" => false,
                _ => return None,
            };
            let at = attribute.span().range();
            let (before, after) = (&source[span.start..at.start], &source[at.end..span.end]);
            return Some((Some(fast), format!("{}{}", before.trim_end(), after.trim_start())));
        }
    }
    Some((None, text.to_owned()))
}

/// The comment lines directly before a declaration.
fn comment_before(before: &str) -> String {
    let lines: Vec<&str> = before.lines().collect();
    // A declaration begins its line: what precedes it there are blanks.
    let count = lines.iter().rev().take_while(|line| line.starts_with("//")).count();
    lines[lines.len() - count..].iter().fold(String::new(), |mut text, line| {
        let _ = writeln!(text, "{line}");
        text
    })
}

/// Whether the declarations match the linker's result, for a linked program in one sampling.
pub fn check(declarations: &[Declaration], linked: &TranslationUnit, fast: bool) -> Result<(), String> {
    let chosen = declarations.iter().filter(|declaration| declaration.fast.is_none_or(|of| of == fast));
    let texts: BTreeMap<&str, &str> =
        chosen.map(|declaration| (declaration.name.as_str(), declaration.text.as_str())).collect();
    for declaration in &linked.global_declarations {
        let Some(name) = name_of(declaration).filter(|name| !is_dispatch(name)) else { continue };
        let text = texts.get(name.as_str()).ok_or_else(|| format!("{name} is linked and not declared"))?;
        let parsed: TranslationUnit = text.parse().map_err(|error| format!("{name}: {error}"))?;
        let own: Vec<String> = parsed.global_declarations.iter().map(ToString::to_string).collect();
        if own != [declaration.to_string()] {
            return Err(format!("{name} is linked as\n{declaration}\nand declared as\n{}", own.join("\n")));
        }
    }
    Ok(())
}

/// Whether that is a function of the dispatch, which the library writes itself.
fn is_dispatch(name: &str) -> bool {
    name == super::dispatch::PROCEDURE
        || STAGES.iter().flat_map(|stage| stage.functions()).any(|function| function == name)
}

/// The Rust module that holds the declarations.
pub fn write(modules: &Modules, declarations: &[Declaration]) -> String {
    let mut text = String::from(
        "// The shaders' declarations as they are written, and the names that each uses. Written by `cargo \
         xtask link`;\n\
         // do not edit.\n\nuse crate::wgsl::{Declaration, Module, Sampling};\n\n\
         pub const MODULES: &[Module] = &[\n",
    );
    let mut done = BTreeSet::new();
    for Declaration { module, .. } in declarations {
        if done.insert(module) {
            let head = head(modules.source(module));
            let _ = writeln!(text, "    Module {{ path: {module:?}, head: r#\"{head}\"# }},");
        }
    }
    text += "];\n\npub const DECLARATIONS: &[Declaration] = &[\n";
    for Declaration { module, name, fast, text: code, uses, .. } in declarations {
        let sampling = match fast {
            None => "None",
            Some(true) => "Some(Sampling::Fast)",
            Some(false) => "Some(Sampling::Exact)",
        };
        let _ = writeln!(
            text,
            "    Declaration {{\n        module: {module:?},\n        name: {name:?},\n        \
             sampling: {sampling},\n        \
             uses: &{uses:?},\n        text: r#\"{code}\"#,\n    }},"
        );
    }
    text + "];\n"
}

/// The comment at the head of a module.
fn head(source: &str) -> String {
    let lines = source.lines().take_while(|line| line.starts_with("//"));
    lines.map(|line| line.to_owned() + "\n").collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "// The head.\n\nimport package::other::helper;\n\n// A number.\n\
        const ONE = 1.0;\n\n\
        // Doubled.\n// Twice.\n@if(fast)\nfn twice(at: Pair) -> f32 {\n    // not helper\n    \
        return at.ONE * 2.0;\n}\n\n\
        @if(!fast)\nfn twice(at: Pair) -> f32 {\n    return helper(at.x) + ONE;\n}\n";

    #[test]
    fn declarations_keep_their_comments_and_name_what_they_use() {
        let modules = Modules::from_sources([
            ("search/trial", SOURCE),
            ("shared/other", "struct Pair { x: f32 }\nfn helper(x: f32) -> f32 { return x; }\n"),
        ]);
        let all = all(&modules).expect("proper modules");
        let names: Vec<&str> = all.iter().map(|declaration| declaration.name.as_str()).collect();
        assert_eq!(names, ["Pair", "helper", "ONE", "twice", "twice"]);
        assert_eq!(all[2].text, "// A number.\nconst ONE = 1.0;");
        let fast = &all[3];
        assert_eq!((fast.fast, fast.uses.as_slice()), (Some(true), &["Pair".to_owned()][..]));
        assert!(fast.text.starts_with("// Doubled.\n// Twice.\nfn twice"), "{}", fast.text);
        assert_eq!((all[4].fast, all[4].uses.join(" ")), (Some(false), "ONE Pair helper".to_owned()));
        assert_eq!(head(SOURCE), "// The head.\n");
    }

    #[test]
    fn what_the_linker_makes_otherwise_is_noticed() {
        let modules = Modules::from_sources([("shared/other", "fn helper(x: f32) -> f32 { return x; }\n")]);
        let declarations = all(&modules).expect("proper modules");
        let linked = |text: &str| text.parse::<TranslationUnit>().expect("valid WGSL");
        let same = linked("fn helper(x: f32) -> f32 {\n  return x;\n}");
        assert_eq!(check(&declarations, &same, false), Ok(()));
        let other = linked("fn helper(x: f32) -> f32 { return x + x; }");
        assert!(check(&declarations, &other, false).is_err());
        assert!(check(&declarations, &linked("const TWO = 2.0;"), false).is_err());
    }
}
