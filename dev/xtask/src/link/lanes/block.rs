//! Structs of all lanes as rows of numbers in memory, and as one struct a lane.

use std::fmt::Write as _;

use naga::{Handle, Module, Type};

use super::LaneText;
use super::types::{self, COMPONENTS, Kind, Member, What, function_of, made, vector};

/// The blocks of structs, for single numbers: one row for each number. The texts over lanes load and store
/// them.
pub fn blocks(module: &Module, text: &LaneText) -> Result<String, String> {
    let mut out = String::from(
        "// Blocks of the shaders' structs. Written by `cargo xtask link`; do not edit.\n\nuse super::*;\n",
    );
    for name in text.blocks {
        let (mut declared, mut zeros, mut set, mut get) =
            (String::new(), String::new(), String::new(), String::new());
        for (member, kind, size) in rows(module, name)? {
            let (single, zero) = (kind.single(), kind.zero());
            let row = |part: usize| {
                if size == 1 { format!("self.{member}") } else { format!("self.{member}[{part}]") }
            };
            let component = |part: usize| {
                if size == 1 { member.clone() } else { format!("{member}.{}", COMPONENTS[part]) }
            };
            let (ty, zero) = match size {
                1 => (format!("[{single}; BLOCK]"), format!("[{zero}; BLOCK]")),
                _ => (format!("[[{single}; BLOCK]; {size}]"), format!("[[{zero}; BLOCK]; {size}]")),
            };
            let _ = writeln!(declared, "    pub {member}: {ty},");
            let _ = writeln!(zeros, "            {member}: {zero},");
            for part in 0..size {
                let _ = writeln!(set, "        {}[at] = value.{};", row(part), component(part));
            }
            let value = made(size, (0..size).map(|part| format!("{}[at]", row(part))));
            let _ = writeln!(get, "            {member}: {value},");
        }
        let _ = write!(
            out,
            "\n/// Sixteen of [`{name}`], each number of theirs in a row.\n#[derive(Clone, Copy, Debug)]\n\
             pub struct {name}Block {{\n{declared}}}\n\nimpl Default for {name}Block {{\n    \
             fn default() -> Self {{\n        Self {{\n{zeros}        }}\n    }}\n}}\n\n\
             impl {name}Block {{\n    /// Puts one in a place.\n    #[inline]\n    \
             pub fn set(&mut self, at: usize, value: &{name}) {{\n{set}    }}\n\n    \
             /// The one in a place.\n    #[inline]\n    pub fn get(&self, at: usize) -> {name} {{\n        \
             {name} {{\n{get}        }}\n    }}\n}}\n"
        );
    }
    Ok(out)
}

/// The functions over lanes that load and store a block of a struct.
pub fn in_lanes(module: &Module, name: &str) -> Result<String, String> {
    let (mut loaded, mut stored) = (String::new(), String::new());
    for (member, kind, size) in rows(module, name)? {
        let suffix = kind.suffix();
        let row = |part: usize| if size == 1 { member.clone() } else { format!("{member}[{part}]") };
        let value = made(
            size,
            (0..size).map(|part| format!("load{suffix}(&block.{}.as_chunks().0[part])", row(part))),
        );
        let _ = writeln!(loaded, "        {member}: {value},");
        for (part, component) in COMPONENTS.iter().enumerate().take(size) {
            let component = if size == 1 { member.clone() } else { format!("{member}.{component}") };
            let _ = writeln!(
                stored,
                "    store{suffix}(&mut block.{}.as_chunks_mut().0[part], which, value.{component});",
                row(part)
            );
        }
    }
    let (load, store) = (function_of("load", name), function_of("store", name));
    Ok(format!(
        "lanes! {{ pub fn {load}(block: &{name}Block, part: usize) -> {name} {{\n    {name} {{\n\
         {loaded}    }}\n}} }}\n\
         lanes! {{ pub fn {store}(block: &mut {name}Block, part: usize, which: M, value: &{name}) {{\n\
         {stored}}} }}\n"
    ))
}

/// The numbers and vectors that a struct holds.
fn rows(module: &Module, name: &str) -> Result<Vec<(String, Kind, usize)>, String> {
    let named = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name));
    let (ty, _) = named.ok_or_else(|| format!("there is no struct {name} to make a block of"))?;
    let row = |Member { name: member, ty, .. }: Member| match vector(&module.types[ty].inner) {
        Some((kind, size)) if kind != Kind::Bool => Ok((member, kind, size)),
        _ => Err(format!("member {member} of {name}: its type is not known in blocks")),
    };
    types::members(module, &LaneText::EMPTY, ty)?.into_iter().map(row).collect()
}

/// A value of all lanes as an array with the value of each.
pub fn singles(module: &Module, ty: Handle<Type>, value: &str) -> Result<String, String> {
    match vector(&module.types[ty].inner) {
        Some((kind, 1)) => Ok(format!("row{}({value})", kind.suffix())),
        Some((kind, size)) => {
            let rows: Vec<String> = COMPONENTS[..size]
                .iter()
                .map(|part| format!("row{}({value}.{part})", kind.suffix()))
                .collect();
            let parts = made(size, (0..size).map(|part| format!("rows.{part}[lane]")));
            Ok(format!(
                "{{ let rows = ({}); std::array::from_fn::<_, LANES, _>(|lane| {parts}) }}",
                rows.join(", ")
            ))
        }
        None => {
            let name = module.types[ty].name.as_deref().unwrap_or_default();
            Ok(format!("{}({value})", function_of("singles", name)))
        }
    }
}

/// A value of all lanes, of an array of theirs.
pub fn lanes_of(module: &Module, ty: Handle<Type>, values: &str) -> Result<String, String> {
    let load = |kind: Kind, of: String| {
        format!("load{}(&std::array::from_fn(|lane| {values}[lane]{of}))", kind.suffix())
    };
    match vector(&module.types[ty].inner) {
        Some((kind, 1)) => Ok(load(kind, String::new())),
        Some((kind, size)) => {
            Ok(made(size, COMPONENTS[..size].iter().map(|part| load(kind, format!(".{part}")))))
        }
        None => {
            let name = module.types[ty].name.as_deref().unwrap_or_default();
            Ok(format!("{}(&{values})", function_of("lanes_of", name)))
        }
    }
}

/// The functions that make one struct a lane of a struct of lanes, and the other way round.
pub fn conversions(module: &Module, text: &LaneText, ty: Handle<Type>) -> Result<String, String> {
    let structure = module.types[ty].name.clone().unwrap_or_default();
    let (mut rows, mut one, mut lanes) = (String::new(), String::new(), String::new());
    let mut members = Vec::new();
    for Member { name, ty, what } in types::members(module, text, ty)? {
        let by = match what {
            None => {
                let _ = write!(one, "{name}: value.{name}, ");
                members.push(format!("{name}: values[0].{name}"));
                continue;
            }
            Some(What::Vector(..)) => "",
            Some(What::Struct(_)) => "&",
        };
        let _ = writeln!(rows, "    let {name} = {};", singles(module, ty, &format!("{by}value.{name}"))?);
        let _ = write!(one, "{name}: {name}[lane], ");
        let row = format!("let {name} = std::array::from_fn::<_, LANES, _>(|lane| values[lane].{name});");
        let _ = writeln!(lanes, "    {row}\n    let {name}_of_all = {};", lanes_of(module, ty, &name)?);
        members.push(format!("{name}: {name}_of_all"));
    }
    let (to, from) = (function_of("singles", &structure), function_of("lanes_of", &structure));
    Ok(format!(
        "lanes! {{ fn {to}(value: &{structure}) -> [single::{structure}; LANES] {{\n{rows}    \
         std::array::from_fn(|lane| single::{structure} {{ {one}}})\n}} }}\n\
         lanes! {{ fn {from}(values: &[single::{structure}; LANES]) -> {structure} {{\n{lanes}    \
         {structure} {{ {} }}\n}} }}\n",
        members.join(", ")
    ))
}
