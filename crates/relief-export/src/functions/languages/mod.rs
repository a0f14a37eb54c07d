//! Functions in other languages than WGSL, through naga's writers.
//!
//! A writer needs an entry point, and names things anew. So the functions are written with one that calls all
//! that programs call, which is cut off; textures get our names back, and declarations their comments.

mod comments;
mod glsl;
mod godot;
mod hlsl;
mod macros;
mod msl;
mod unreal;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use relief_shaders::Selection;

use self::comments::Comments;
use self::godot::Uniforms;
use super::names::{Prefix, in_words};
use super::syntax::{ItemKind, print};
use super::{Form, FunctionOptions, Reduced};
use crate::program::Checked;
use crate::{ExportError, Profile, Target};

/// A program to be written: the functions, with an entry point.
struct Source {
    checked: Checked,
    /// The entry point's name.
    entry: String,
    comments: Comments,
    /// The bound variables: name, group and number.
    textures: Vec<(String, u32, u32)>,
}

/// Writes the functions in a profile.
pub fn write(
    selection: &Selection,
    reduced: &Reduced,
    prefix: &Prefix,
    profile: Profile,
    options: &FunctionOptions,
) -> Result<String, ExportError> {
    let entry = prefix.of("entry");
    let functions = match profile.target() {
        Target::Godot => print(&godot::with_counts(&reduced.unit, prefix)),
        Target::Unreal => print(&unreal::with_scalar_choices(&reduced.unit, prefix)),
        _ => reduced.text.clone(),
    };
    let text = format!("{functions}\n{}", entry_point(selection, reduced, prefix, &entry, options.form));
    let variables = reduced.unit.variables();
    let source = Source {
        checked: Checked::read(&text)?,
        entry,
        comments: Comments::of(&reduced.unit),
        textures: variables.map(|of| (of.name.clone(), of.group, of.binding)).collect(),
    };
    let text = match profile.target() {
        Target::Glsl => glsl::write(&source, profile),
        Target::Hlsl => hlsl::write(&source, profile),
        Target::Unreal => unreal::check(&source.checked).and_then(|()| hlsl::write(&source, profile)),
        Target::Msl => msl::write(&source),
        Target::Godot => godot::write(
            &source,
            &Uniforms {
                unit: &reduced.unit,
                settings: &reduced.settings,
                prefix,
                form: options.form,
                sampling: options.sampling,
                wrap: options.wrap,
            },
        ),
        target @ (Target::Wgsl | Target::Wesl | Target::Spirv) => Err(ExportError::NoFunctionsIn { target }),
    }?;
    let lent: Vec<String> = options.form.called(selection).into_iter().map(|name| prefix.of(name)).collect();
    let text = with_own_parameters(&text, &lent);
    Ok(match profile.target() {
        Target::Unreal => {
            let macros = macros::of(&reduced.unit, prefix, options.form);
            unreal::enclosed(&text, &macros, &prefix.of(unreal::STRUCT))
        }
        _ => text,
    })
}

/// The parameters of the functions that programs call.
const PARAMETERS: [&str; 8] = ["settings", "at", "ray", "hit", "toward", "position", "normal", "uv"];

/// The text with our names for parameters of the functions that programs call. Writers number names
/// that stand in several functions.
fn with_own_parameters(text: &str, lent: &[String]) -> String {
    let mut own = String::with_capacity(text.len());
    let mut numbered: BTreeMap<String, &str> = BTreeMap::new();
    let mut is_head = false;
    for line in text.lines() {
        let is_begin = line.starts_with(|c: char| c.is_ascii_alphabetic());
        is_head |= is_begin && lent.iter().any(|name| line.contains(&format!(" {name}(")));
        if is_head {
            let words = line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
            let parameter = |word: &str| {
                let base = word.trim_end_matches(|c: char| c.is_ascii_digit()).strip_suffix('_')?;
                let known = PARAMETERS.into_iter().find(|known| *known == base)?;
                Some((word.to_owned(), known))
            };
            numbered.extend(words.filter_map(parameter));
            is_head = !line.contains(')');
        }
        own += &in_words(line, &|word| numbered.get(word).copied());
        own.push('\n');
        if line == "}" {
            numbered.clear();
        }
    }
    own
}

/// An entry point that calls all that programs call, with all that they give.
fn entry_point(selection: &Selection, reduced: &Reduced, prefix: &Prefix, name: &str, form: Form) -> String {
    let mut body = String::new();
    let of = |name: &str| prefix.of(name);
    // What both forms find, and in what a ray goes in beside its triangle.
    let [given, ray] = match form {
        Form::Tangent => ["at", "at"],
        Form::Triangle => ["at, ray", "ray"],
    };
    for function in form.called(selection) {
        let name = of(function);
        let declared = reduced.unit.items.iter().find_map(|item| match &item.kind {
            ItemKind::Function(function) if function.name == name => Some(function),
            _ => None,
        });
        let takes = |of: &str| {
            declared.is_some_and(|declared| declared.parameters.iter().any(|parameter| parameter.name == of))
        };
        let settings = if takes("settings") { "settings, " } else { "" };
        let _ = match function {
            found if found == form.hit() => {
                let _ = writeln!(body, "    var settings: {};", of(super::settings::STRUCT));
                let _ = writeln!(body, "    var at: {};", of(form.given()[0]));
                if form == Form::Triangle {
                    let _ = writeln!(body, "    var ray: {};", of("ReliefRay"));
                }
                writeln!(
                    body,
                    "    let hit = {name}({settings}{given});\n    \
                     var sum = vec3f(hit.uv, hit.height) + hit.normal * hit.depth;\n    \
                     if (hit.hit) {{\n        sum = sum + position;\n    }}"
                )
            }
            light if light == form.light() => {
                writeln!(body, "    sum = sum * {name}({settings}{ray}, hit, position);")
            }
            "relief_tile" => writeln!(body, "    sum = sum + vec3f({name}(position, uv), 0.0);"),
            _ => writeln!(body, "    sum = sum + {name}(position, position, uv);"),
        };
    }
    format!(
        "@fragment\n\
         fn {name}(@location(0) position: vec3f, @location(1) uv: vec2f) -> @location(0) vec4f {{\n\
         {body}    return vec4f(sum, 1.0);\n}}\n"
    )
}
