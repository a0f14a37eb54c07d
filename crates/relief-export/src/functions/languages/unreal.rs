//! HLSL of Unreal's materials: an include whose functions are methods of a struct, together with the textures
//! that they read. A Custom node has textures as inputs and puts them into the struct.

use std::collections::{BTreeMap, BTreeSet};

use naga::{BinaryOperator, Expression as Value, Handle, ScalarKind, TypeInner};

use crate::functions::names::Prefix;
use crate::functions::reduce::{Types, width};
use crate::functions::syntax::{
    Expression, Function, Item, ItemKind, Parameter, Statement, StatementKind, Unit, change_expressions,
};
use crate::program::Checked;
use crate::{ExportError, Target};

/// The struct's name in the sources.
pub const STRUCT: &str = "Relief";

/// The beginning of the names of functions that choose for each component; its name in the sources.
const CHOSEN: &str = "relief_chosen";

/// The functions, with a call in place of each choice by a vector of conditions: HLSL 2021 chooses by one.
pub fn with_scalar_choices(unit: &Unit, prefix: &Prefix) -> Unit {
    let mut unit = unit.clone();
    let types = Types::of(&unit);
    let mut chosen = BTreeSet::new();
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part
                && name == "select"
                && let [no, _, by] = arguments.as_slice()
                && types.type_of(by, &locals).is_some_and(|by| width(&by).is_some())
                && let Some(of) = types.type_of(no, &locals)
            {
                *name = chooser(&of, prefix);
                chosen.insert(of);
            }
        });
    }
    unit.items.extend(chosen.iter().map(|of| choosing(of, prefix)));
    unit
}

/// The name of the function that chooses among vectors of a type.
fn chooser(of: &str, prefix: &Prefix) -> String {
    let letters = of.trim_start_matches("vec").replace(['<', '>'], "");
    format!("{}_{letters}", prefix.of(CHOSEN))
}

/// The function that chooses among vectors of a type.
fn choosing(of: &str, prefix: &Prefix) -> Item {
    let count = width(of).unwrap_or_default();
    let component = |letter: char| {
        let [no, yes, by] =
            ["no", "yes", "by"].map(|name| Expression::name(name).member(&letter.to_string()));
        Expression::Call("select".to_owned(), vec![no, yes, by])
    };
    let made = Expression::Call(of.to_owned(), "xyzw".chars().take(count).map(component).collect());
    let parameter = |name: &str, of: &str| Parameter { name: name.to_owned(), of: of.to_owned() };
    let function = Function {
        name: chooser(of, prefix),
        parameters: vec![
            parameter("no", of),
            parameter("yes", of),
            parameter("by", &format!("vec{count}<bool>")),
        ],
        returns: of.to_owned(),
        body: vec![Statement::plain(StatementKind::Return(made))],
    };
    let comment =
        vec!["For each component the second where the condition holds, the first elsewhere.".to_owned()];
    Item { comment, kind: ItemKind::Function(function) }
}

/// Checks that no vector is a condition in the HLSL of a module.
pub fn check(checked: &Checked) -> Result<(), ExportError> {
    let Checked { module, info } = checked;
    for (handle, function) in module.functions.iter() {
        let types = &info[handle];
        let kind_of = |value: Handle<Value>| match types[value].ty.inner_with(&module.types) {
            TypeInner::Vector { scalar, .. } => Some(scalar.kind),
            _ => None,
        };
        let is_wrong = function.expressions.iter().any(|(_, value)| match *value {
            Value::Select { condition, .. } => kind_of(condition).is_some(),
            // The writer chooses another divisor where a whole one is 0.
            Value::Binary { op: BinaryOperator::Divide | BinaryOperator::Modulo, left, .. } => {
                kind_of(left).is_some_and(|kind| kind != ScalarKind::Float)
            }
            _ => false,
        });
        if is_wrong {
            return Err(ExportError::Inexpressible {
                target: Target::Unreal,
                function: function.name.clone().unwrap_or_default(),
                reason: "it chooses by a vector of conditions".to_owned(),
            });
        }
    }
    Ok(())
}

/// The include: structs and constants, and a struct of textures and functions.
pub fn enclosed(text: &str, macros: &str, structure: &str) -> String {
    let mut declared = String::new();
    let mut textures = BTreeMap::new();
    let mut methods = String::new();
    let mut was_constant = false;
    for piece in pieces(text) {
        let head = piece.iter().find(|line| !line.starts_with("//")).copied().unwrap_or_default();
        if ["Texture", "SamplerState "].iter().any(|begin| head.starts_with(begin)) {
            let (texture, place) =
                head.split_once(" : register(").unwrap_or((head.trim_end_matches(';'), ""));
            let number = place.trim_start_matches(['t', 's']).split([',', ')']).next();
            let number: u32 = number.and_then(|number| number.parse().ok()).unwrap_or_default();
            textures.insert((number, texture), format!("    {texture};\n"));
        } else if ["struct ", "static const ", "typedef "].iter().any(|begin| head.starts_with(begin)) {
            let is_constant = head.starts_with("static const ");
            if !(is_constant && was_constant) {
                declared.push('\n');
            }
            was_constant = is_constant;
            let kept = piece.iter().filter(|line| !is_padding(line));
            declared += &kept.map(|line| format!("{line}\n")).collect::<String>();
        } else {
            let indented = |line: &&str| match line.is_empty() {
                true => "\n".to_owned(),
                false => format!("    {line}\n"),
            };
            methods.push('\n');
            methods += &piece.iter().map(indented).collect::<String>();
        }
    }
    let textures: String = textures.into_values().collect();
    let macros = if macros.is_empty() { String::new() } else { format!("\n{macros}") };
    format!(
        "#pragma once\n{macros}{declared}\n\
         // The textures of a relief, and the functions that read them. Give it the textures, then call the \
         functions.\nstruct {structure}\n{{\n{textures}{methods}}};\n"
    )
}

/// Declarations with their comments: each ends with a brace that begins a line, or is a line with a
/// semicolon.
fn pieces(text: &str) -> Vec<Vec<&str>> {
    let mut pieces = Vec::new();
    let mut piece = Vec::new();
    let mut is_open = false;
    for line in text.lines() {
        if line.is_empty() && !is_open {
            continue;
        }
        piece.push(line);
        let is_comment = line.starts_with("//");
        let ends = line.starts_with('}') || (!is_open && !is_comment && line.ends_with(';'));
        is_open = !ends && (is_open || !is_comment);
        if ends {
            pieces.push(std::mem::take(&mut piece));
        }
    }
    pieces
}

/// Whether a line is a member that only a buffer needs.
fn is_padding(line: &str) -> bool {
    let member = line.trim_start();
    ["int _pad", "int _end_pad"].iter().any(|begin| member.starts_with(begin))
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;
    use relief_shaders::Selection;

    use super::*;
    use crate::{FunctionOptions, Profile, functions};

    fn text(method: &str, sampling: relief_shaders::wgsl::Sampling) -> String {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("surface", "quadric-vertical").expect("a surface");
        selection.choose("shadow", "none").expect("a shadow");
        let options = FunctionOptions {
            prefix: "rock_wall".to_owned(),
            wrap: Some(Wrap::Repeat),
            sampling,
            profiles: vec![Profile::Unreal5],
            ..FunctionOptions::default()
        };
        let exported = functions(&selection, &options).expect("functions");
        assert!(exported.files[0].name.ends_with(".ush"));
        String::from_utf8(exported.files[0].bytes.clone()).expect("text")
    }

    #[test]
    fn textures_and_functions_are_members_of_a_struct() {
        let text = text("cone", relief_shaders::wgsl::Sampling::Exact);
        assert!(text.contains("\n#pragma once\n\n#define ROCK_WALL_HAS_CURVATURE\n\n"), "{text}");
        // The head lists methods as well.
        assert!(
            text.contains("//   RockWallHit rock_wall_hit(RockWallSettings settings, RockWallPoint at)\n")
        );
        let (before, inside) = text.split_once("\nstruct RockWall\n{\n").expect("a struct");
        assert!(inside.starts_with(
            "    Texture2D<float4> rock_wall_height_map;\n    Texture2D<float4> rock_wall_search_map;\n\n"
        ));
        assert!(before.contains("\nstruct RockWallHit {\n") && before.contains("\nstatic const uint "));
        assert!(inside.ends_with("\n    }\n};\n") && !inside.contains("\n}\n"), "{inside}");
        for foreign in ["register", "_pad", "};\nstruct"] {
            assert!(!text.contains(foreign), "{foreign}");
        }
    }

    #[test]
    fn a_sampler_is_a_member() {
        let text = text("cone", relief_shaders::wgsl::Sampling::Fast);
        let (_, inside) = text.split_once("\nstruct RockWall\n{\n").expect("a struct");
        assert!(inside.contains("    SamplerState rock_wall_map_sampler;\n"), "{inside}");
        assert!(!text.contains("nagaSampler"));
    }

    #[test]
    fn choices_by_vectors_are_refused() {
        let checked = |body: &str| {
            let text = format!("fn f(a: vec2f, b: vec2i) -> vec2f {{\n    return {body};\n}}\n");
            check(&Checked::read(&text).expect("a module")).map_err(|error| error.to_string())
        };
        assert_eq!(checked("select(a, a.yx, a.x > 0.0) / a"), Ok(()));
        for wrong in ["select(a, a.yx, a > a.yx)", "vec2f(b % b.yx)", "vec2f(b / b.yx)"] {
            assert!(checked(wrong).expect_err("a refusal").contains("'f'"), "{wrong}");
        }
    }
}
