//! Godot's shading language: GLSL of OpenGL ES, with uniforms that its inspector shows.

use std::fmt::Write as _;

use relief_core::Wrap;
use relief_shaders::wgsl::Sampling;

use super::{Source, glsl, macros};
use crate::functions::form::Form;
use crate::functions::names::Prefix;
use crate::functions::reduce::Types;
use crate::functions::settings::{STRUCT, Setting};
use crate::functions::syntax::{
    Expression, Function, Item, ItemKind, Parameter, Statement, StatementKind, Unit, change_expressions,
};
use crate::{ExportError, Profile};

/// The scale that a new material has: 5 cm in Godot's metres.
const SCALE: &str = "0.05";

/// The widest range of a slider.
const WIDEST: f32 = 10_000.0;

/// What Godot must know of a text beside its functions.
pub struct Uniforms<'a> {
    pub unit: &'a Unit,
    pub settings: &'a [Setting],
    pub prefix: &'a Prefix,
    pub form: Form,
    pub sampling: Sampling,
    pub wrap: Option<Wrap>,
}

pub fn write(source: &Source, uniforms: &Uniforms) -> Result<String, ExportError> {
    let text = glsl::write(source, Profile::Godot4)?;
    let hints = texture_hints(uniforms);
    let text = int_counts(&text, uniforms.prefix);
    let mut own = String::with_capacity(text.len());
    for line in text.lines() {
        match line.strip_prefix("uniform highp ").and_then(|rest| rest.strip_suffix(';')) {
            Some(texture) => {
                let _ = writeln!(own, "uniform {texture} : {hints};");
            }
            None => {
                own += line;
                own.push('\n');
            }
        }
    }
    let Uniforms { unit, prefix, form, .. } = *uniforms;
    Ok(macros::of(unit, prefix, form) + &own + "\n" + &settings(uniforms))
}

/// The function through which counts of bits go; its name in the sources.
const COUNT: &str = "relief_count";

/// The functions, with a call around each number of bits by which an `i32` is shifted. Godot takes an
/// `int` there, WGSL a `u32`: so the call gets another type in the text that is written.
pub fn with_counts(unit: &Unit, prefix: &Prefix) -> Unit {
    let mut unit = unit.clone();
    let types = Types::of(&unit);
    let name = prefix.of(COUNT);
    let mut has_some = false;
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Binary("<<" | ">>", left, right) = part
                && types.type_of(left, &locals).as_deref() == Some("i32")
            {
                has_some = true;
                **right = Expression::Call(name.clone(), vec![(**right).clone()]);
            }
        });
    }
    if has_some {
        let by = || "by".to_owned();
        let body = vec![Statement::plain(StatementKind::Return(Expression::Name(by())))];
        let parameters = vec![Parameter { name: by(), of: "u32".to_owned() }];
        let function = Function { name, parameters, returns: "u32".to_owned(), body };
        let comment = vec!["A number of bits to shift by.".to_owned()];
        unit.items.push(Item { comment, kind: ItemKind::Function(function) });
    }
    unit
}

/// Makes `int` of the counts of bits.
fn int_counts(text: &str, prefix: &Prefix) -> String {
    let called = format!("{}(", prefix.of(COUNT));
    let mut is_inside = false;
    let mut own = String::with_capacity(text.len());
    for line in text.lines() {
        let is_call = line.contains(&called);
        let is_head = is_call && line.starts_with("uint ");
        own += &match line.strip_prefix("    return ").and_then(|rest| rest.strip_suffix(';')) {
            Some(by) if is_inside => format!("    return int({by});"),
            _ if is_call => line.replacen("uint ", "int ", 1),
            _ => line.to_owned(),
        };
        own.push('\n');
        is_inside = is_head || (is_inside && line != "}");
    }
    own
}

/// Texels that are loaded one by one need no filter; `fast` reads through one.
fn texture_hints(uniforms: &Uniforms) -> String {
    let filter = match uniforms.sampling {
        Sampling::Exact => "filter_nearest",
        Sampling::Fast => "filter_linear_mipmap",
    };
    let repeat = match uniforms.wrap {
        Some(Wrap::Clamp) => "repeat_disable",
        _ => "repeat_enable",
    };
    format!("{filter}, {repeat}")
}

/// A uniform for each setting that a material must give, and a function that gathers all.
fn settings(uniforms: &Uniforms) -> String {
    let Uniforms { settings, prefix, .. } = uniforms;
    let of = |name: &str| prefix.of(name);
    let group = of("relief_scale").trim_end_matches("_scale").to_owned();
    let mut declared = format!("group_uniforms {group};\n");
    let mut members = Vec::new();
    for setting in *settings {
        let name = of(&format!("relief_{}", setting.name));
        match setting.name.as_str() {
            // A material that changes one alone would lift the relief above the mesh, where it is cut.
            "bias" => members.push(format!("-{}", of("relief_scale"))),
            "height_size" => {
                members.push(format!("uvec2(textureSize({}, 0))", of("relief_height_map")));
            }
            "scale" => {
                let _ = writeln!(declared, "/** {} */", setting.holds);
                let _ = writeln!(declared, "uniform float {name} = {SCALE};");
                members.push(name);
            }
            _ => {
                let (kind, value) = member(setting, &name);
                let range = setting.param.map_or(String::new(), |(param, start)| {
                    let step = if param.integer { ", 1.0" } else { "" };
                    // A slider over millions sets nothing.
                    let hint = match param.max - param.min <= WIDEST {
                        true => format!(" : hint_range({:?}, {:?}{step})", param.min, param.max),
                        false => String::new(),
                    };
                    format!("{hint} = {start:?}")
                });
                let _ = writeln!(declared, "/** {} */\nuniform {kind} {name}{range};", setting.holds);
                members.push(value);
            }
        }
    }
    declared += "group_uniforms;\n\n";
    let structure = of(STRUCT);
    let gathered = of("relief_settings");
    declared
        + &format!(
            "// The settings of this material.\n{structure} {gathered}() {{\n    return {structure}({});\n\
             }}\n",
            members.join(", ")
        )
}

/// The type of a setting's uniform, and the member that is made of it.
fn member(setting: &Setting, name: &str) -> (&'static str, String) {
    match setting.of.as_str() {
        "u32" => ("int", format!("uint({name})")),
        "vec2u" => ("ivec2", format!("uvec2({name})")),
        "vec4u" => ("ivec4", format!("uvec4({name})")),
        "vec2f" => ("vec2", name.to_owned()),
        _ => ("float", name.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use relief_shaders::Selection;

    use crate::{FunctionOptions, Profile, functions};

    fn text(method: &str, surface: &str) -> String {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("surface", surface).expect("a surface");
        selection.choose("shadow", "none").expect("a shadow");
        let options = FunctionOptions {
            prefix: "rock".to_owned(),
            profiles: vec![Profile::Godot4],
            ..FunctionOptions::default()
        };
        let exported = functions(&selection, &options).expect("functions");
        assert!(exported.files[0].name.ends_with(".gdshaderinc"));
        String::from_utf8(exported.files[0].bytes.clone()).expect("text")
    }

    #[test]
    fn every_setting_is_a_uniform_or_follows_from_one() {
        let text = text("relief", "quadric-vertical");
        assert!(text.contains("#define ROCK_HAS_CURVATURE\n") && !text.contains("ROCK_HAS_LIGHT"));
        let (_, settings) = text.split_once("group_uniforms rock;").expect("a group");
        for declared in
            ["uniform float rock_scale = ", "uniform float rock_search_steps :", "uniform int rock_wrap"]
        {
            assert!(settings.contains(declared), "{declared}: {settings}");
        }
        let gathered = "RockSettings(rock_scale, -rock_scale, uvec2(textureSize(rock_height_map, 0))";
        assert!(settings.contains(gathered), "{settings}");
    }

    #[test]
    fn integers_are_shifted_by_integers() {
        let text = text("pyramidal", "plane");
        assert!(text.contains("int rock_count(uint by) {\n    return int(by);"), "{text}");
        let counts = text.lines().filter(|line| line.contains(" = rock_count("));
        let mut count = 0;
        for line in counts {
            assert!(line.trim_start().starts_with("int "), "{line}");
            count += 1;
        }
        assert!(count > 0);
    }
}
