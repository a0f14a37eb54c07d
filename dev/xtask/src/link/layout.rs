//! The structs that the GPU shares with the host, as Rust: their bytes, from the offsets that the shader's
//! rules give.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use naga::{AddressSpace, Handle, Module, ScalarKind, Type, TypeInner};

/// A Rust module with the bytes of every struct in a uniform or storage buffer of the modules. Structs of the
/// names in `translated` exist already; the others are declared.
pub fn write(modules: &[&Module], translated: &BTreeSet<String>) -> Result<String, String> {
    let mut text = String::from(
        "// Host-shared structs and their bytes on the GPU. Written by `cargo xtask link`; do not edit.\n\n\
         use super::bytes::Shared;\nuse super::generated::*;\nuse super::runtime as rt;\n",
    );
    let mut done = BTreeSet::new();
    for module in modules {
        for (_, global) in module.global_variables.iter() {
            if matches!(global.space, AddressSpace::Uniform | AddressSpace::Storage { .. }) {
                collect(module, global.ty, translated, &mut done, &mut text)?;
            }
        }
    }
    Ok(text)
}

fn collect(
    module: &Module,
    ty: Handle<Type>,
    translated: &BTreeSet<String>,
    done: &mut BTreeSet<String>,
    text: &mut String,
) -> Result<(), String> {
    match &module.types[ty].inner {
        TypeInner::Array { base, .. } => collect(module, *base, translated, done, text),
        TypeInner::Struct { members, span } => {
            let name = module.types[ty].name.clone().ok_or("a struct without a name")?;
            if !done.insert(name.clone()) {
                return Ok(());
            }
            for member in members {
                collect(module, member.ty, translated, done, text)?;
            }
            let fields = members
                .iter()
                .map(|member| {
                    let field = member.name.clone().ok_or("a member without a name")?;
                    Ok((field, rust_type(module, member.ty)?, member.offset))
                })
                .collect::<Result<Vec<_>, String>>()?;
            if !translated.contains(&name) {
                let _ = write!(text, "\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {name} {{\n");
                for (field, kind, _) in &fields {
                    let _ = writeln!(text, "    pub {field}: {kind},");
                }
                text.push_str("}\n");
            }
            // Arrays of structs are strided by the struct's size, which the host's arrays follow.
            let _ = write!(text, "\nimpl Shared for {name} {{\n    const SIZE: usize = {span};\n");
            text.push_str("\n    fn write(&self, bytes: &mut [u8]) {\n");
            for (field, _, offset) in &fields {
                let _ = writeln!(text, "        self.{field}.write(&mut bytes[{offset}..]);");
            }
            text.push_str("    }\n\n    fn read(bytes: &[u8]) -> Self {\n        Self {\n");
            for (field, _, offset) in &fields {
                let _ = writeln!(text, "            {field}: Shared::read(&bytes[{offset}..]),");
            }
            text.push_str("        }\n    }\n}\n");
            Ok(())
        }
        _ => Ok(()),
    }
}

fn rust_type(module: &Module, ty: Handle<Type>) -> Result<String, String> {
    let scalar = |kind: ScalarKind| match kind {
        ScalarKind::Float => Ok("f32"),
        ScalarKind::Sint => Ok("i32"),
        ScalarKind::Uint => Ok("u32"),
        _ => Err("a scalar that buffers cannot hold".to_owned()),
    };
    match &module.types[ty].inner {
        TypeInner::Scalar(kind) => Ok(scalar(kind.kind)?.to_owned()),
        TypeInner::Vector { size, scalar: kind } => {
            Ok(format!("rt::Vec{}<{}>", *size as u8, scalar(kind.kind)?))
        }
        TypeInner::Array { base, size: naga::ArraySize::Constant(count), .. } => {
            Ok(format!("[{}; {count}]", rust_type(module, *base)?))
        }
        TypeInner::Struct { .. } => {
            module.types[ty].name.clone().ok_or_else(|| "a struct without a name".to_owned())
        }
        other => Err(format!("no host type for {other:?}")),
    }
}
