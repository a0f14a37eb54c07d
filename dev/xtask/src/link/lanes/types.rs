//! Names of types over lanes and in single numbers, and the structs of lanes.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use naga::proc::TypeResolution;
use naga::{ArraySize, Handle, Module, Scalar, ScalarKind, Type, TypeInner};

use super::LaneText;

/// Kind of a number.
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

    /// Returns the suffix of the names of operations.
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
        (&TypeInner::Array { base, size: ArraySize::Constant(size), .. }, _) if is_lanes => {
            Ok(format!("[{}; {size}]", name(module, base, true)?))
        }
        _ => Err(format!("values of type {:?} are not known in lanes", ty.inner)),
    }
}

/// The name of a number or a vector.
pub fn vector_name(kind: Kind, size: usize, is_lanes: bool) -> String {
    let kind = if is_lanes { kind.lanes() } else { kind.single() };
    if size == 1 { kind.to_owned() } else { format!("Vec{size}<{kind}>") }
}

/// Whether values of a type are handed over by reference: structs and arrays.
pub fn is_by_reference(module: &Module, ty: Handle<Type>) -> bool {
    vector(&module.types[ty].inner).is_none()
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

/// Returns the given structs, and the structs that are parts of them.
pub fn with_parts(module: &Module, structs: BTreeSet<Handle<Type>>) -> BTreeSet<Handle<Type>> {
    let mut all = BTreeSet::new();
    let mut waiting: Vec<Handle<Type>> = structs.into_iter().collect();
    while let Some(ty) = waiting.pop() {
        if all.insert(ty)
            && let TypeInner::Struct { members, .. } = &module.types[ty].inner
        {
            waiting.extend(members.iter().map(|member| member.ty).filter(|ty| is_struct(module, *ty)));
        }
    }
    all
}

/// A member of a struct over lanes.
pub struct Member {
    pub name: String,
    pub ty: Handle<Type>,
    /// Nothing of lanes where it is the same in all.
    pub what: Option<What>,
}

/// Type of one lane.
pub enum What {
    /// A number or a vector.
    Vector(Kind, usize),
    /// A struct of that name.
    Struct(String),
}

/// The members of a struct of the shaders.
pub fn members(module: &Module, text: &LaneText, ty: Handle<Type>) -> Result<Vec<Member>, String> {
    let structure = module.types[ty].name.as_deref().unwrap_or_default();
    let TypeInner::Struct { members, .. } = &module.types[ty].inner else {
        return Err(format!("{structure} is no struct"));
    };
    let member = |member: &naga::StructMember| {
        let name = member.name.clone().unwrap_or_default();
        let of = &module.types[member.ty];
        let what = match (vector(&of.inner), &of.name) {
            _ if text.is_shared(structure, &name) => None,
            (Some((kind, size)), _) => Some(What::Vector(kind, size)),
            (None, Some(inner)) if is_struct(module, member.ty) => Some(What::Struct(inner.clone())),
            _ => return Err(format!("member {name} of {structure}: its type is not known in lanes")),
        };
        Ok(Member { name, ty: member.ty, what })
    };
    members.iter().map(member).collect()
}

/// Whether all lanes share that member of a struct, or of what points to one.
pub fn is_shared_member(module: &Module, text: &LaneText, of: &TypeResolution, index: u32) -> bool {
    let structure = match *of.inner_with(&module.types) {
        TypeInner::Pointer { base, .. } => Some(base),
        _ => of.handle(),
    };
    let Some(structure) = structure.map(|handle| &module.types[handle]) else { return false };
    let TypeInner::Struct { members, .. } = &structure.inner else { return false };
    let name = |name: &Option<String>| name.clone().unwrap_or_default();
    text.is_shared(&name(&structure.name), &name(&members[index as usize].name))
}

/// Whether lanes share a member of that type.
fn has_shared(module: &Module, text: &LaneText, ty: Handle<Type>) -> bool {
    module.types.iter().any(|(_, of)| {
        let TypeInner::Struct { members, .. } = &of.inner else { return false };
        let structure = of.name.as_deref().unwrap_or_default();
        let mut shared = members
            .iter()
            .filter(|member| text.is_shared(structure, member.name.as_deref().unwrap_or_default()));
        shared.any(|member| member.ty == ty)
    })
}

/// A struct of lanes, with the functions that choose between two and, where no other struct is shared by its
/// lanes, that make one of zeros.
pub fn structure(module: &Module, text: &LaneText, ty: Handle<Type>) -> Result<String, String> {
    let structure = module.types[ty].name.clone().unwrap_or_default();
    let [mut declared, mut chosen, mut zeros, mut splats] = [(); 4].map(|()| String::new());
    let mut has_zero = true;
    for Member { name, ty, what } in members(module, text, ty)? {
        let declaration = self::name(module, ty, what.is_some())?;
        let (choice, zero, splat) = match what {
            None => {
                let kind = vector(&module.types[ty].inner).filter(|(_, size)| *size == 1);
                has_zero &= kind.is_some();
                let zero = kind.map_or("", |(kind, _)| kind.zero()).to_owned();
                (format!("a.{name}"), zero, format!("value.{name}"))
            }
            Some(What::Vector(kind, size)) => {
                let part =
                    |at: usize| if size == 1 { name.clone() } else { format!("{name}.{}", COMPONENTS[at]) };
                let suffix = kind.suffix();
                let choice = |at: usize| format!("sel{suffix}(m, a.{0}, b.{0})", part(at));
                let zero = format!("splat{suffix}({})", kind.zero());
                let splat = |at: usize| format!("splat{suffix}(value.{})", part(at));
                (
                    made(size, (0..size).map(choice)),
                    made(size, (0..size).map(|_| zero.clone())),
                    made(size, (0..size).map(splat)),
                )
            }
            Some(What::Struct(of)) => {
                let (select, zero) = (function_of("sel", &of), function_of("zero", &of));
                let splat = format!("{}(&value.{name})", function_of("splat", &of));
                (format!("{select}(m, &a.{name}, &b.{name})"), format!("{zero}()"), splat)
            }
        };
        let _ = writeln!(declared, "    pub {name}: {declaration},");
        let _ = writeln!(chosen, "        {name}: {choice},");
        let _ = writeln!(zeros, "        {name}: {zero},");
        let _ = writeln!(splats, "        {name}: {splat},");
    }
    let (select, zero) = (function_of("sel", &structure), function_of("zero", &structure));
    let mut out = format!(
        "#[derive(Clone, Copy)]\npub struct {structure} {{\n{declared}}}\n\
         lanes! {{ fn {select}(m: M, a: &{structure}, b: &{structure}) -> {structure} {{\n    \
         {structure} {{\n{chosen}    }}\n}} }}\n"
    );
    if has_zero {
        let _ = writeln!(
            out,
            "lanes! {{ fn {zero}() -> {structure} {{\n    {structure} {{\n{zeros}    }}\n}} }}"
        );
    }
    if has_shared(module, text, ty) {
        let splat = function_of("splat", &structure);
        let _ = writeln!(
            out,
            "lanes! {{ fn {splat}(value: &single::{structure}) -> {structure} {{\n    \
             {structure} {{\n{splats}    }}\n}} }}"
        );
    }
    Ok(out)
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
