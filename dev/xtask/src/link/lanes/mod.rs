//! A validated module to Rust over lanes: every value is that of several rays at once, control flow goes by
//! masks, and what the settings alone say stays a single number.
//!
//! Functions that give the same in all lanes are those of the translation to single numbers, which are
//! called.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use naga::valid::ModuleInfo;
use naga::{Function, Handle, Module};

use super::modules::Modules;

mod expression;
mod function;
mod live;
mod operation;
mod reach;
mod statement;
mod types;
mod uniform;

/// The translation of what these functions reach, as the text of a Rust module that is included once for each
/// width. `text` is the linked WGSL that the module was read from.
pub fn translate(
    module: &Module,
    info: &ModuleInfo,
    roots: &[&str],
    text: &str,
    modules: &Modules,
) -> Result<String, String> {
    let roots: Vec<Handle<Function>> = roots
        .iter()
        .map(|root| {
            let named = module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(*root));
            named
                .map(|(handle, _)| handle)
                .ok_or_else(|| format!("there is no function {root} to write in lanes"))
        })
        .collect::<Result<_, _>>()?;
    let program = uniform::Program::new(module, info, roots);
    let written = program.written();
    let mut functions = String::new();
    let mut refused = Vec::new();
    let mut structs = BTreeSet::new();
    for variant in &written {
        match function::Writer::new(&program, &written, variant).write(&mut structs) {
            Ok(function) => functions.push_str(&function),
            Err(refusal) => {
                let name = module.functions[variant.function].name.as_deref().unwrap_or("?");
                let code = refusal.span.and_then(|span| span.to_range()).and_then(|range| text.get(range));
                let code = code.unwrap_or_default();
                refused.push(format!("{}: {}: {code}", modules.locate(name, code), refusal.what));
            }
        }
    }
    if !refused.is_empty() {
        return Err(refused.join("\n"));
    }
    let mut out = String::from(
        "// The stages over lanes. Written by `cargo xtask link`; do not edit.\n\nuse super::*;\n\n",
    );
    for structure in structs {
        let _ = writeln!(out, "{}", types::structure(module, structure)?);
    }
    out.push_str(&functions);
    Ok(out)
}
