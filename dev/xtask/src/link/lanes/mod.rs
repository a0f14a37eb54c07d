//! Translation of a validated module to Rust over lanes. Every value belongs to several rays at once, control
//! flow uses masks, and values that depend on the settings alone stay scalars.
//!
//! Functions with the same result in all lanes are calls of the scalar translation.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use naga::valid::ModuleInfo;
use naga::{Function, Handle, Module};

use super::modules::Modules;

mod block;
mod expression;
mod function;
mod live;
mod operation;
mod reach;
mod statement;
mod types;
mod uniform;

pub use block::blocks;

/// A text over lanes.
pub struct LaneText {
    /// The functions that are called from without.
    pub roots: &'static [&'static str],
    /// Arguments of theirs that are the same in all lanes: function and argument.
    pub same_arguments: &'static [(&'static str, &'static str)],
    /// Members that are the same in all lanes, because calls are made for what has them in common: struct
    /// and member.
    pub shared_members: &'static [(&'static str, &'static str)],
    /// Whether a function of that name is called for each lane by itself, as single numbers have it.
    pub one_by_one: fn(&str) -> bool,
    /// Functions that the runtime has over lanes, since they can be had there in a better way than from their
    /// text.
    pub by_hand: &'static [&'static str],
    /// Whether lanes read textures in levels of their own.
    pub levels_differ: bool,
    /// Structs that are handed over in blocks.
    pub blocks: &'static [&'static str],
}

impl LaneText {
    /// A text without functions, in which nothing is shared.
    pub const EMPTY: Self = Self {
        roots: &[],
        same_arguments: &[],
        shared_members: &[],
        one_by_one: |_| false,
        by_hand: &[],
        levels_differ: false,
        blocks: &[],
    };

    /// Whether a member of a struct is the same in all lanes.
    fn is_shared(&self, structure: &str, member: &str) -> bool {
        self.shared_members.contains(&(structure, member))
    }
}

/// The translation of what its roots reach, as the text of a Rust module that is included once for each
/// width. `source` is the linked WGSL that the module was read from.
pub fn translate(
    module: &Module,
    info: &ModuleInfo,
    text: &LaneText,
    source: &str,
    modules: &Modules,
) -> Result<String, String> {
    let roots: Vec<Handle<Function>> = text
        .roots
        .iter()
        .map(|root| {
            let named = module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(*root));
            named
                .map(|(handle, _)| handle)
                .ok_or_else(|| format!("there is no function {root} to write in lanes"))
        })
        .collect::<Result<_, _>>()?;
    let program = uniform::Program::new(module, info, text, roots);
    let written = program.written();
    let mut functions = String::new();
    let mut refused = Vec::new();
    let (mut structs, mut apart) = (BTreeSet::new(), BTreeSet::new());
    for variant in &written {
        let writer = function::Writer::new(&program, &written, variant);
        if program.is_by_hand(variant) {
            continue;
        }
        let function = if program.is_one_by_one(variant) {
            writer.write_one_by_one(&mut structs, &mut apart)
        } else {
            writer.write(&mut structs)
        };
        match function {
            Ok(function) => functions.push_str(&function),
            Err(refusal) => {
                let name = module.functions[variant.function].name.as_deref().unwrap_or("?");
                let code = refusal.span.and_then(|span| span.to_range()).and_then(|range| source.get(range));
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
    for structure in types::with_parts(module, structs) {
        let _ = writeln!(out, "{}", types::structure(module, text, structure)?);
    }
    for structure in types::with_parts(module, apart) {
        let _ = writeln!(out, "{}", block::conversions(module, text, structure)?);
    }
    for name in text.blocks {
        let _ = writeln!(out, "{}", block::in_lanes(module, name)?);
    }
    out.push_str(&functions);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::super::naga_check::validate;
    use super::*;

    /// A text of one function.
    const TRIAL: LaneText = LaneText { roots: &["trial"], ..LaneText::EMPTY };

    /// What a module that holds just this function is in lanes.
    fn translated(source: &str) -> Result<String, String> {
        in_text(source, &TRIAL)
    }

    fn in_text(source: &str, text: &LaneText) -> Result<String, String> {
        let modules = Modules::from_sources([("search/trial", source)]);
        let (module, info) = validate(source).expect("valid WGSL");
        translate(&module, &info, text, source, &modules)
    }

    /// What is said of a function of a number with that body.
    fn refused(body: &str) -> Option<String> {
        translated(&format!("// A trial.\n\nfn trial(x: f32) -> f32 {{\n{body}\n}}\n")).err()
    }

    #[test]
    fn branches_loops_and_returns_are_written() {
        let body = "var sum = 0.0;\nvar k = 0.0;\nwhile (k < x) {\nif (sum > 9.0) {\nreturn sum;\n}\n\
                    sum = sum + sqrt(k);\n\
                    k = k + 1.0;\n}\nreturn clamp(sum, 0.0, 1.0);";
        assert_eq!(refused(body), None);
    }

    #[test]
    fn what_lanes_do_not_know_is_refused_with_file_and_line() {
        let bodies = [
            "let k = i32(x);\nswitch (k) {\ncase 1: { return 1.0; }\ndefault: { return 2.0; }\n}",
            "let y = x;\nreturn atan2(y, x);",
            "let k = i32(x);\nvar all = array<f32, 3>(x, x, x);\nreturn all[k];",
            "let y = x;\nreturn pow(x, y);",
        ];
        for body in bodies {
            let said = refused(body).unwrap_or_else(|| panic!("{body} was not refused"));
            let line = said.strip_prefix("search/trial.wesl:").and_then(|rest| rest.split(':').next());
            let line: Option<usize> = line.and_then(|line| line.parse().ok());
            // A variable of a type that is not known is where its function begins.
            assert!(line.is_some_and(|line| (3..=6).contains(&line)), "{body}: {said}");
        }
    }

    #[test]
    fn what_lanes_do_not_know_can_be_called_lane_by_lane() {
        let source = "struct Both {\nangle: f32,\nlength: f32,\n}\n\n\
                      fn both(x: Both) -> Both {\nlet y = x.length;\n\
                      return Both(atan2(y, x.angle), y);\n}\n\n\
                      fn trial(x: f32) -> f32 {\nreturn both(Both(x, x + 1.0)).angle;\n}\n";
        assert!(translated(source).is_err());
        let text = LaneText { one_by_one: |name| name == "both", ..TRIAL };
        let written = in_text(source, &text).expect("a text");
        assert!(written.contains("r.both(") && written.contains("singles_both("), "{written}");
    }

    #[test]
    fn what_the_runtime_has_is_called_and_not_written() {
        let source = "fn both(x: f32) -> vec2f {\nreturn vec2f(x, atan2(x, 1.0));\n}\n\n\
                      fn trial(x: f32) -> f32 {\nreturn both(x).y;\n}\n";
        assert!(translated(source).is_err());
        let text = LaneText { by_hand: &["both"], ..TRIAL };
        let written = in_text(source, &text).expect("a text");
        assert!(written.contains("both(r, ") && !written.contains("fn both"), "{written}");
    }

    #[test]
    fn what_differs_is_no_shared_member() {
        let source = "struct Ray {\nat: f32,\nlevel: f32,\n}\n\n\
                      fn trial(x: f32) -> Ray {\nreturn Ray(x, floor(x));\n}\n";
        assert!(translated(source).is_ok());
        let text = LaneText { shared_members: &[("Ray", "level")], ..TRIAL };
        let said = in_text(source, &text).expect_err("the level differs");
        assert!(said.contains("share"), "{said}");
    }

    #[test]
    fn a_function_that_is_not_there_is_named() {
        let said = translated("fn other(x: f32) -> f32 {\n    return x;\n}\n")
            .expect_err("there is no such function");
        assert!(said.contains("trial"), "{said}");
    }
}
