//! Functions in other languages than WGSL, through naga's writers.
//!
//! A writer needs an entry point, and names things anew. So the functions are written with one that calls all
//! that programs call, which is cut off; textures get our names back, and declarations their comments.

mod comments;
mod glsl;
mod hlsl;
mod msl;

use std::fmt::Write as _;

use relief_shaders::Selection;

use self::comments::Comments;
use super::names::Prefix;
use super::syntax::ItemKind;
use super::{Reduced, called};
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
) -> Result<String, ExportError> {
    let entry = prefix.of("entry");
    let text = format!("{}\n{}", reduced.text, entry_point(selection, reduced, prefix, &entry));
    let variables = reduced.unit.variables();
    let source = Source {
        checked: Checked::read(&text)?,
        entry,
        comments: Comments::of(&reduced.unit),
        textures: variables.map(|of| (of.name.clone(), of.group, of.binding)).collect(),
    };
    match profile.target() {
        Target::Glsl => glsl::write(&source, profile),
        Target::Hlsl => hlsl::write(&source, profile),
        Target::Msl => msl::write(&source),
        target @ (Target::Wgsl | Target::Wesl | Target::Spirv) => Err(ExportError::NoFunctionsIn { target }),
    }
}

/// An entry point that calls all that programs call, with all that they give.
fn entry_point(selection: &Selection, reduced: &Reduced, prefix: &Prefix, name: &str) -> String {
    let mut body = String::new();
    let of = |name: &str| prefix.of(name);
    for function in called(selection) {
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
            "relief_hit" => writeln!(
                body,
                "    var settings: {};\n    var at: {};\n    let hit = {name}({settings}at);\n    \
                 var sum = vec3f(hit.uv, hit.height) + hit.normal * hit.depth;\n    \
                 if (hit.hit) {{\n        sum = sum + position;\n    }}",
                of(super::settings::STRUCT),
                of("ReliefPoint")
            ),
            "relief_light" => writeln!(body, "    sum = sum * {name}({settings}at, hit, position);"),
            "relief_tile" => writeln!(body, "    sum = sum + vec3f({name}(position, uv), 0.0);"),
            _ => writeln!(body, "    sum = sum + {name}(position, position, uv);"),
        };
    }
    format!(
        "@fragment\nfn {name}(@location(0) position: vec3f, @location(1) uv: vec2f) -> @location(0) vec4f {{\n\
         {body}    return vec4f(sum, 1.0);\n}}\n"
    )
}
