//! The types of expressions, as far as members of structs need them.

use std::collections::BTreeMap;

use crate::functions::syntax::{Expression, Function, StatementKind, Unit, each_statement};

/// The types of a shader's declarations.
pub struct Types {
    structs: BTreeMap<String, Vec<(String, String)>>,
    functions: BTreeMap<String, String>,
    /// Bound variables and constants.
    globals: BTreeMap<String, String>,
}

/// The types of a function's parameters and locals; none where they are not known.
pub type Locals = BTreeMap<String, Option<String>>;

impl Types {
    pub fn of(unit: &Unit) -> Self {
        let members = |members: &[crate::functions::syntax::Member]| {
            members.iter().map(|member| (member.name.clone(), member.of.clone())).collect()
        };
        let mut types = Self {
            structs: unit.structs().map(|of| (of.name.clone(), members(&of.members))).collect(),
            functions: unit.functions().map(|of| (of.name.clone(), of.returns.clone())).collect(),
            globals: unit.variables().map(|of| (of.name.clone(), of.of.clone())).collect(),
        };
        for constant in unit.constants() {
            if let Some(of) = types.type_of(&constant.value, &Locals::new()) {
                types.globals.insert(constant.name.clone(), of);
            }
        }
        types
    }

    /// Whether that is a struct.
    pub fn is_struct(&self, name: &str) -> bool {
        self.structs.contains_key(name)
    }

    /// The names and types of a struct's members.
    pub fn members(&self, name: &str) -> &[(String, String)] {
        self.structs.get(name).map_or(&[], Vec::as_slice)
    }

    /// The types of all functions' locals, by the functions' names.
    pub fn all_locals(&self, unit: &Unit) -> BTreeMap<String, Locals> {
        unit.functions().map(|function| (function.name.clone(), self.locals(function))).collect()
    }

    /// The types of a function's locals. Two of one name must have one type.
    pub fn locals(&self, function: &Function) -> Locals {
        let mut locals: Locals =
            function.parameters.iter().map(|of| (of.name.clone(), Some(of.of.clone()))).collect();
        each_statement(&function.body, &mut |statement| {
            if let StatementKind::Let(name, value) | StatementKind::Var(name, value) = &statement.kind {
                let of = self.type_of(value, &locals);
                let known = locals.entry(name.clone()).or_insert_with(|| of.clone());
                if *known != of {
                    *known = None;
                }
            }
        });
        locals
    }

    /// The type of an expression, if it is known.
    pub fn type_of(&self, expression: &Expression, locals: &Locals) -> Option<String> {
        match expression {
            Expression::Name(name) => match locals.get(name) {
                Some(of) => of.clone(),
                None => self.globals.get(name).cloned(),
            },
            Expression::Group(inner) | Expression::Unary(_, inner) => self.type_of(inner, locals),
            Expression::Member(of, name) => {
                let of = self.type_of(of, locals)?;
                match self.structs.get(&of) {
                    Some(members) => {
                        members.iter().find(|(member, _)| member == name).map(|(_, kind)| kind.clone())
                    }
                    None => component(&of, name),
                }
            }
            Expression::Index(of, _) => element(&self.type_of(of, locals)?),
            Expression::Call(name, arguments) => match self.functions.get(name) {
                Some(returns) => Some(returns.clone()),
                None if self.is_struct(name) || name.starts_with("vec") || is_scalar(name) => {
                    Some(name.clone())
                }
                None if is_reducing(name) => element(&self.type_of(arguments.first()?, locals)?),
                None if name == "textureLoad" || name == "textureSampleLevel" => Some("vec4f".to_owned()),
                None => self.type_of(arguments.first()?, locals),
            },
            Expression::Binary(operator, left, right) => {
                if ["==", "!=", "<", ">", "<=", ">=", "&&", "||"].contains(operator) {
                    let width = self.type_of(left, locals).and_then(|of| width(&of));
                    return Some(width.map_or("bool".to_owned(), |width| format!("vec{width}<bool>")));
                }
                let left = self.type_of(left, locals)?;
                // The right side of a shift counts bits.
                if ["<<", ">>"].contains(operator) {
                    return Some(left);
                }
                if left.starts_with("vec") { Some(left) } else { self.type_of(right, locals) }
            }
            Expression::Literal(text) => Some(
                match text.as_str() {
                    "true" | "false" => "bool",
                    text if text.ends_with('u') => "u32",
                    text if text.contains(['.', 'e']) => "f32",
                    _ => "i32",
                }
                .to_owned(),
            ),
        }
    }
}

/// Functions of vectors that give a number.
fn is_reducing(name: &str) -> bool {
    ["dot", "length", "all", "any"].contains(&name)
}

fn is_scalar(name: &str) -> bool {
    ["f32", "u32", "i32", "bool"].contains(&name)
}

/// The type of a vector's components behind a point.
fn component(of: &str, name: &str) -> Option<String> {
    let scalar = element(of)?;
    let letter = scalar.chars().next()?;
    match name.len() {
        1 => Some(scalar),
        count => Some(format!("vec{count}{letter}")),
    }
}

/// The type of the elements of an array or a vector.
fn element(of: &str) -> Option<String> {
    if let Some(inner) = of.strip_prefix("array<") {
        return inner.trim_end_matches('>').split(',').next().map(|of| of.trim().to_owned());
    }
    let scalar = match of.strip_prefix("vec")?.get(1..)? {
        "f" | "<f32>" => "f32",
        "u" | "<u32>" => "u32",
        "i" | "<i32>" => "i32",
        "<bool>" => "bool",
        _ => return None,
    };
    Some(scalar.to_owned())
}

/// The number of a vector's components.
pub fn width(of: &str) -> Option<usize> {
    of.strip_prefix("vec")?.get(..1)?.parse().ok()
}

/// Whether a type's text holds a name.
pub fn mentions(of: &str, name: &str) -> bool {
    of.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).any(|word| word == name)
}
