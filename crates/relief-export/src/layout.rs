//! Structs of buffers: members, offsets and sizes, from the module itself.

use std::collections::BTreeMap;

use naga::{ArraySize, Handle, Module, ScalarKind, Type, TypeInner, VectorSize};

use crate::manifest::{ArrayLayout, Member, Struct};

/// Adds all structs that a type holds to `structs`, by name.
pub fn collect(module: &Module, ty: Handle<Type>, structs: &mut BTreeMap<String, Struct>) {
    match &module.types[ty].inner {
        TypeInner::Array { base, .. } => collect(module, *base, structs),
        TypeInner::Struct { members, span } => {
            let name = name(module, ty);
            if structs.contains_key(&name) {
                return;
            }
            for member in members {
                collect(module, member.ty, structs);
            }
            let members = members.iter().map(|member| member_of(module, member)).collect();
            structs.insert(name, Struct { size: *span, members });
        }
        _ => {}
    }
}

fn member_of(module: &Module, member: &naga::StructMember) -> Member {
    let inner = &module.types[member.ty].inner;
    let (of, array) = match inner {
        TypeInner::Array { base, size: ArraySize::Constant(count), stride } => {
            (*base, Some(ArrayLayout { count: count.get(), stride: *stride }))
        }
        _ => (member.ty, None),
    };
    Member {
        name: member.name.clone().unwrap_or_default(),
        offset: member.offset,
        size: inner.size(module.to_ctx()),
        of: name(module, of),
        array,
    }
}

/// Returns a type as WGSL writes it.
pub fn name(module: &Module, ty: Handle<Type>) -> String {
    let ty = &module.types[ty];
    let letter = |kind: ScalarKind| match kind {
        ScalarKind::Sint => "i",
        ScalarKind::Uint => "u",
        _ => "f",
    };
    match &ty.inner {
        TypeInner::Scalar(scalar) => format!("{}32", letter(scalar.kind)),
        TypeInner::Vector { size, scalar } => {
            let count = match size {
                VectorSize::Bi => 2,
                VectorSize::Tri => 3,
                VectorSize::Quad => 4,
            };
            format!("vec{count}{}", letter(scalar.kind))
        }
        TypeInner::Array { base, .. } => format!("array<{}>", name(module, *base)),
        _ => ty.name.clone().unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_are_where_the_rules_of_wgsl_put_them() {
        let text = "struct Inner { a: u32, b: vec4f }\n\
                    struct Outer { first: vec2f, inner: array<Inner, 3>, last: vec3i }\n\
                    @group(0) @binding(0) var<uniform> outer: Outer;";
        let module = naga::front::wgsl::parse_str(text).expect("valid WGSL");
        let mut structs = BTreeMap::new();
        for (_, variable) in module.global_variables.iter() {
            collect(&module, variable.ty, &mut structs);
        }
        let names: Vec<&str> = structs.keys().map(String::as_str).collect();
        assert_eq!(names, ["Inner", "Outer"]);
        assert_eq!((structs["Inner"].size, structs["Outer"].size), (32, 128));
        let members: Vec<_> = structs["Outer"]
            .members
            .iter()
            .map(|member| (member.name.as_str(), member.offset, member.size, member.of.as_str()))
            .collect();
        assert_eq!(
            members,
            [("first", 0, 8, "vec2f"), ("inner", 16, 96, "Inner"), ("last", 112, 12, "vec3i")]
        );
        let array = structs["Outer"].members[1].array;
        assert_eq!(array, Some(ArrayLayout { count: 3, stride: 32 }));
    }
}
