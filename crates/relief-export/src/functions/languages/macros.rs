//! Macros that say what a text has, for shaders that include it.

use std::fmt::Write as _;

use crate::functions::form::Form;
use crate::functions::names::Prefix;
use crate::functions::syntax::Unit;

/// The macros of functions, a line for each.
pub fn of(unit: &Unit, prefix: &Prefix, form: Form) -> String {
    let light = prefix.of(form.light());
    let point = prefix.of("ReliefPoint");
    let point = unit.structs().find(|structure| structure.name == point);
    let takes = |name: &str| {
        point.is_some_and(|structure| structure.members.iter().any(|member| member.name == name))
    };
    let mut text = String::new();
    for (name, has) in [
        ("HAS_LIGHT", unit.functions().any(|function| function.name == light)),
        ("HAS_CURVATURE", takes("curvature")),
        ("HAS_FOOTPRINT", takes("footprint")),
    ] {
        if has {
            let _ = writeln!(text, "#define {}", prefix.of(name));
        }
    }
    text
}
