//! Names of types over lanes and in single numbers, and the structs of lanes.

use std::fmt::Write as _;

use naga::{Handle, Module, Scalar, ScalarKind, Type, TypeInner};

use super::uniform::is_shared;

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Float,
    Signed,
    Unsigned,
    Bool,
}

/// Names of components.
pub const COMPONENTS: [&str; 4] = ["x", "y", "z", "w"];

impl Kind {
    pub fn of(scalar: Scalar) -> Option<Self> {
        match scalar {
            Scalar { kind: ScalarKind::Float, width: 4 } => Some(Self::Float),
            Scalar { kind: ScalarKind::Sint, width: 4 } => Some(Self::Signed),
            Scalar { kind: ScalarKind::Uint, width: 4 } => Some(Self::Unsigned),
            Scalar { kind: ScalarKind::Bool, .. } => Some(Self::Bool),
            _ => None,
        }
    }

    /// The type of a number in each lane.
    pub fn lanes(self) -> &'static str {
        ["F", "I", "U", "M"][self as usize]
    }

    /// The type of a single number.
    pub fn single(self) -> &'static str {
        ["f32", "i32", "u32", "bool"][self as usize]
    }

    /// What the names of operations end with.
    pub fn suffix(self) -> &'static str {
        ["", "_i", "_u", "_m"][self as usize]
    }

    /// Zero, as a single number.
    pub fn zero(self) -> &'static str {
        ["0f32", "0i32", "0u32", "false"][self as usize]
    }
}

/// The kind and the number of components of a number or a vector.
pub fn vector(inner: &TypeInner) -> Option<(Kind, usize)> {
    match *inner {
        TypeInner::Scalar(scalar) => Some((Kind::of(scalar)?, 1)),
        TypeInner::Vector { size, scalar } => Some((Kind::of(scalar)?, size as usize)),
        _ => None,
    }
}

/// The name of a type, of lanes or single.
pub fn name(module: &Module, ty: Handle<Type>, is_lanes: bool) -> Result<String, String> {
    let ty = &module.types[ty];
    if let Some((kind, size)) = vector(&ty.inner) {
        return Ok(vector_name(kind, size, is_lanes));
    }
    match (&ty.inner, &ty.name) {
        (TypeInner::Struct { .. }, Some(name)) if is_lanes => Ok(name.clone()),
        (TypeInner::Struct { .. }, Some(name)) => Ok(format!("single::{name}")),
        _ => Err(format!("values of type {:?} are not known in lanes", ty.inner)),
    }
}

/// The name of a number or a vector.
pub fn vector_name(kind: Kind, size: usize, is_lanes: bool) -> String {
    let kind = if is_lanes { kind.lanes() } else { kind.single() };
    if size == 1 { kind.to_owned() } else { format!("Vec{size}<{kind}>") }
}

/// Whether a type is a struct.
pub fn is_struct(module: &Module, ty: Handle<Type>) -> bool {
    matches!(module.types[ty].inner, TypeInner::Struct { .. })
}

/// The function of that purpose for a struct.
pub fn function_of(purpose: &str, structure: &str) -> String {
    let mut name = purpose.to_owned();
    for letter in structure.chars() {
        if letter.is_uppercase() {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

/// A struct of lanes, with the functions that choose between two and that make one of zeros.
pub fn structure(module: &Module, ty: Handle<Type>) -> Result<String, String> {
    let TypeInner::Struct { members, .. } = &module.types[ty].inner else { return Ok(String::new()) };
    let structure = module.types[ty].name.clone().unwrap_or_default();
    let (mut declared, mut chosen, mut zeros) = (String::new(), String::new(), String::new());
    for member in members {
        let name = member.name.clone().unwrap_or_default();
        let shared = is_shared(&structure, &name);
        let ty = self::name(module, member.ty, !shared)?;
        let Some((kind, size)) = vector(&module.types[member.ty].inner) else {
            return Err(format!("member {name} of {structure}: a struct in a struct is not known in lanes"));
        };
        let _ = writeln!(declared, "    pub {name}: {ty},");
        let choice = if shared {
            format!("a.{name}")
        } else {
            let parts = (0..size).map(|at| {
                let part = if size == 1 { name.clone() } else { format!("{name}.{}", COMPONENTS[at]) };
                format!("sel{}(m, a.{part}, b.{part})", kind.suffix())
            });
            made(size, parts)
        };
        let zero = if shared {
            kind.zero().to_owned()
        } else {
            made(size, (0..size).map(|_| format!("splat{}({})", kind.suffix(), kind.zero())))
        };
        let _ = writeln!(chosen, "        {name}: {choice},");
        let _ = writeln!(zeros, "        {name}: {zero},");
    }
    let (select, zero) = (function_of("sel", &structure), function_of("zero", &structure));
    Ok(format!(
        "#[derive(Clone, Copy)]\npub struct {structure} {{\n{declared}}}\n\
         lanes! {{ fn {select}(m: M, a: &{structure}, b: &{structure}) -> {structure} {{\n    {structure} {{\n{chosen}    }}\n}} }}\n\
         lanes! {{ fn {zero}() -> {structure} {{\n    {structure} {{\n{zeros}    }}\n}} }}\n"
    ))
}

/// A number, or a vector of these parts.
pub fn made(size: usize, parts: impl Iterator<Item = String>) -> String {
    let parts: Vec<String> = parts.collect();
    if size == 1 {
        return parts.into_iter().next().unwrap_or_default();
    }
    let named: Vec<String> =
        COMPONENTS.iter().zip(parts).map(|(name, part)| format!("{name}: {part}")).collect();
    format!("Vec{size} {{ {} }}", named.join(", "))
}
