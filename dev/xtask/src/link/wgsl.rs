//! Modules to one plain WGSL text.

use std::fmt::Write as _;

use relief_shaders::STAGES;
use wgsl_parse::syntax::{GlobalDeclaration, TranslationUnit};

use super::Program;
use super::modules::{Modules, module_path};

/// Links a program. Names are kept as written; twice the same name is an error. Comments do not survive.
pub fn link(modules: &Modules, program: &Program, gpu: bool, fast: bool) -> Result<String, String> {
    let mut linker = wesl::Wesl::new_barebones().set_custom_resolver(modules.resolver());
    linker
        .set_mangler(wesl::ManglerKind::None)
        .use_imports(true)
        .use_condcomp(true)
        .use_stripping(true)
        .set_feature("gpu", gpu)
        .set_feature("fast", fast);
    if !program.keep.is_empty() {
        linker.keep_declarations(program.keep.iter().map(|&name| name.to_owned()).collect());
    }
    let linked = linker
        .compile(&module_path(program.root))
        .map_err(|error| format!("linking {} failed:\n{error}", program.root))?;
    ordered(linked.syntax)
}

/// The linker's order of declarations changes from run to run: sort them into what a reader expects.
fn ordered(unit: TranslationUnit) -> Result<String, String> {
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

/// The comment at the head of a linked file: what it is, and what each number of its switches stands for.
pub fn header(program: &str, sampling: &str) -> String {
    let mut text = format!(
        "// Relief, linked shader: {program}, {sampling} sampling. Written by `cargo xtask link`; do not edit.\n\
         // SPDX-License-Identifier: MIT OR Apache-2.0\n//\n\
         // The constants SURFACE, SEARCH, REFINE and SHADE choose a variant of each stage:\n"
    );
    for stage in &STAGES {
        let constant = stage.key.to_uppercase();
        for (number, entry) in stage.entries.iter().enumerate() {
            let section = match entry.publication.section {
                "" => entry.publication.paper.to_owned(),
                section => format!("section {section}"),
            };
            let _ =
                writeln!(text, "//   {constant} = {number}: {}, {} ({section})", entry.name, entry.summary);
            for map in entry.maps {
                let texture = [map.kind, map.texture].join(" ");
                let _ = writeln!(text, "//     search_map: {}", texture.trim_end());
            }
            for (param, component) in entry.params.iter().zip(["x", "y", "z", "w"]) {
                let _ = writeln!(
                    text,
                    "//     params.{component}: {}, {} ({} to {}, {})",
                    param.name, param.summary, param.min, param.max, param.default
                );
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_sorted_and_a_name_may_stand_once() {
        let unit = |text: &str| text.parse::<TranslationUnit>().expect("valid WGSL");
        let one =
            ordered(unit("fn b() {}\nconst z = 1u;\nstruct S { a: u32 }\nfn a() {}")).expect("no name twice");
        let other =
            ordered(unit("struct S { a: u32 }\nfn a() {}\nfn b() {}\nconst z = 1u;")).expect("no name twice");
        assert_eq!(one, other);
        assert!(one.find("const z") < one.find("struct S") && one.find("fn a") < one.find("fn b"));
        let twice = ordered(unit("fn a() {}\nfn b() {}\nfn a() {}"));
        assert!(twice.is_err_and(|said| said.contains("'a'")));
    }
}
