//! A validated module to Rust.

use std::fmt::Write as _;

use naga::valid::ModuleInfo;
use naga::{AddressSpace, Module, TypeInner};
use naga_rust_back::{Config, Writer};
use relief_shaders::MapSlot;

/// Where the generated code finds the run-time library; shortened to `rt` afterwards.
const RUNTIME: &str = "crate::cpu::runtime";

/// How the translator declares a texture, after its name: any reader, behind a pointer that is called for
/// each texel.
const ANY_READER: &str = "<&'g dyn rt::texture::Read<Coordinates = rt::Vec2<i32>, Component = f32>>";

/// What the translator writes, with the run time's short name and its conversions.
pub fn written(module: &Module, info: &ModuleInfo) -> Result<String, String> {
    let config = Config::new().resource_struct("Resources").public_items(true).runtime_path(RUNTIME);
    let mut text = String::new();
    Writer::new(config)
        .write(&mut text, module, info)
        .map_err(|error| format!("translating to Rust: {error}"))?;
    // The library's conversions are not compiled into their callers, the run time's own are.
    Ok(text.replace(&format!("{RUNTIME}::"), "rt::").replace(".cast_elem_as_", ".to_"))
}

/// The translation, as the text of a Rust module.
pub fn translate(module: &Module, info: &ModuleInfo) -> Result<String, String> {
    let text = concrete_textures(module, &written(module, info)?)?;
    // The functions with marks call these functions, too.
    let text = short_ones_inlined(&crate_alone(&text)?)?.replace("\n    fn v_", "\n    pub(super) fn v_");
    let bound = bound(module);
    Ok(format!(
        "// The stages' translation. Written by `cargo xtask link`; do not edit.\n\n\
         use {RUNTIME} as rt;\nuse {RUNTIME}::{{Convert as _, SquareRoot as _}};\n\n{text}\n{bound}"
    ))
}

/// Keeps the resources and their functions to the crate; its own types call them.
fn crate_alone(text: &str) -> Result<String, String> {
    let marks = ["pub struct Resources<'g> {", "impl<'g> Resources<'g> {"];
    let [fields, functions] = marks.map(|mark| text.find(mark));
    let (Some(fields), Some(functions)) = (fields, functions) else {
        return Err("the translation declares its resources in another way than expected".to_owned());
    };
    let (before, resources) = text.split_at(fields);
    let (fields, functions) = resources.split_at(functions - before.len());
    let (fields, functions) =
        (fields.replace("pub ", "pub(crate) "), functions.replace("\n    pub fn ", "\n    pub(crate) fn "));
    Ok(format!("{before}#[derive(Clone, Copy, Debug)]\n{fields}{functions}"))
}

/// The most lines of a body that is compiled into its callers.
const SHORT_LINES: usize = 14;

/// What is compiled into its callers though it is longer: every turn of a search asks for a cell's heights,
/// and a call in each takes half as long again as the rest.
const IN_LOOPS: &str = "    fn v_object_cell_stage(";

/// Has short functions without loops compiled into their callers: vectors are handed over in memory, where
/// reading them as a whole waits for their parts.
fn short_ones_inlined(text: &str) -> Result<String, String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut marked = String::with_capacity(text.len());
    let (mut count, mut has_in_loops) = (0, false);
    for (at, line) in lines.iter().enumerate() {
        if line.starts_with("    fn v_") {
            let is_in_loops = line.starts_with(IN_LOOPS);
            let body = lines[at..].iter().skip_while(|line| !line.ends_with('{')).skip(1);
            let body: Vec<&&str> = body.take_while(|line| **line != "    }").collect();
            let is_short = body.len() <= SHORT_LINES && !body.iter().any(|line| line.contains("loop {"));
            if is_short || is_in_loops {
                marked.push_str("    #[inline(always)]\n");
                count += 1;
                has_in_loops |= is_in_loops;
            }
        }
        marked.push_str(line);
        marked.push('\n');
    }
    if count == 0 || !has_in_loops {
        return Err("the translation writes its functions in another way than expected".to_owned());
    }
    Ok(marked)
}

/// The constructor that takes, of all that can be bound, what the translated shaders use.
fn bound(module: &Module) -> String {
    let mut fields = String::new();
    for (_, global) in module.global_variables.iter() {
        let name = global.name.as_deref().unwrap_or_default();
        let value = match MapSlot::ALL.into_iter().find(|slot| slot.name() == name) {
            Some(slot) => format!("bound.slot(crate::MapSlot::{slot:?})"),
            None => format!("bound.{name}"),
        };
        let _ = writeln!(fields, "            {name}: {value},");
    }
    format!(
        "impl<'g> Resources<'g> {{\n    /// What the stages are called on.\n    \
         pub(crate) fn of(bound: &crate::cpu::Bound<'g>) -> Self {{\n        Self {{\n\
         {fields}        }}\n    }}\n}}\n"
    )
}

/// Gives each texture its concrete type, which lets reads be inlined and the resources be shared between
/// threads.
fn concrete_textures(module: &Module, text: &str) -> Result<String, String> {
    let mut text = text.to_owned();
    for (_, global) in module.global_variables.iter() {
        let TypeInner::Image { arrayed, .. } = module.types[global.ty].inner else { continue };
        if global.space != AddressSpace::Handle {
            continue;
        }
        let name = global.name.as_deref().unwrap_or_default();
        let any = if arrayed { "Texture2dArray" } else { "Texture2d" };
        let declared = format!("pub {name}: rt::texture::{any}{ANY_READER}");
        if !text.contains(&declared) {
            return Err(format!("the translation declares the texture {name} in another way than expected"));
        }
        let concrete = match name {
            "height_map" => "HeightTexture",
            "hole_map" => "HoleTexture",
            "color_map" | "normal_map" | "material_map" => "ColorTexture",
            _ => "MapTexture",
        };
        text = text.replace(&declared, &format!("pub {name}: rt::{concrete}<'g>"));
    }
    Ok(text)
}
