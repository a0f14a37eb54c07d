//! The functions that reach a mark, from a translation to Rust: methods of the type that keeps the marks.
//! All other functions stand in the translation without marks, which that type dereferences to.

use std::collections::{BTreeMap, BTreeSet};

/// Begins the name of a mark's function, as the translator calls it.
const MARK: &str = "mark_";

/// The line on which a translated function begins.
const HEAD: &str = "    fn v_";

/// The line on which it ends.
const END: &str = "    }";

/// The text of a Rust module with the functions that reach a mark. The marks themselves are left out: they
/// are written by hand.
pub fn marked(text: &str) -> Result<String, String> {
    let functions = functions(text);
    let is_mark = |name: &str| name.starts_with(MARK);
    let mut reaching: BTreeSet<&str> = functions.keys().copied().filter(|name| is_mark(name)).collect();
    if reaching.is_empty() {
        return Err("the translation with marks has none".to_owned());
    }
    loop {
        let calls = |body: &str| reaching.iter().any(|name| body.contains(&format!("self.v_{name}(")));
        let more: Vec<&str> = functions
            .iter()
            .filter(|(name, body)| !reaching.contains(*name) && calls(body))
            .map(|(name, _)| *name)
            .collect();
        if more.is_empty() {
            break;
        }
        reaching.extend(more);
    }
    let mut module = String::from(
        "// The functions that reach a mark. Written by `cargo xtask link`; do not edit.\n\n\
         use super::Marked;\nuse crate::cpu::generated::*;\nuse crate::cpu::runtime as rt;\n\
         use crate::cpu::runtime::{Convert as _, SquareRoot as _};\n\nimpl Marked<'_> {\n",
    );
    for (name, body) in functions.iter().filter(|(name, _)| reaching.contains(*name) && !is_mark(name)) {
        let body = body.strip_prefix(HEAD).unwrap_or(body).strip_prefix(name).unwrap_or(body);
        module += &format!("    pub(super) fn v_{name}{body}");
    }
    Ok(module + "}\n")
}

/// The translated functions by their names, from head to end.
fn functions(text: &str) -> BTreeMap<&str, String> {
    let mut functions = BTreeMap::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let Some(name) = line.strip_prefix(HEAD).and_then(|rest| rest.split('(').next()) else { continue };
        let mut body = format!("{line}\n");
        if !line.ends_with("{}") {
            for line in lines.by_ref() {
                body += line;
                body.push('\n');
                if line == END {
                    break;
                }
            }
        }
        functions.insert(name, body);
    }
    functions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_that_reach_a_mark_are_kept_and_marks_are_not() {
        let text = "    fn v_mark_turn(\n        &self,\n    ) {\n    }\n\
                    \u{20}   fn v_a(&self) {\n        self.v_mark_turn();\n    }\n\
                    \u{20}   fn v_b(&self) {\n        self.v_a();\n    }\n\
                    \u{20}   fn v_c(&self) {\n        self.v_d();\n    }\n";
        let marked = marked(text).expect("a mark");
        assert!(marked.contains("fn v_a(&self) {\n        self.v_mark_turn();"), "{marked}");
        assert!(marked.contains("fn v_b(") && !marked.contains("fn v_c(") && !marked.contains("fn v_mark"));
        assert!(super::marked("    fn v_c(&self) {\n    }\n").is_err());
    }
}
