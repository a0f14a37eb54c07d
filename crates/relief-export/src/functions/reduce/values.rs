//! Values that are known without running the shader.

use std::collections::{BTreeMap, BTreeSet};

use crate::functions::syntax::{Expression, Unit};

/// A known value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Bool(bool),
    Int(i64),
    /// An unsigned number.
    Count(u32),
    Float(f32),
}

impl Value {
    /// The value as a literal.
    pub fn literal(self) -> Expression {
        let text = match self {
            Self::Bool(value) => value.to_string(),
            Self::Int(value) => value.to_string(),
            Self::Count(value) => format!("{value}u"),
            Self::Float(value) => format!("{value:?}"),
        };
        Expression::Literal(text)
    }
}

/// The values of a shader's constants, and what is the same for all of a draw.
pub struct Values {
    constants: BTreeMap<String, Value>,
    /// The uniform buffers.
    uniforms: BTreeSet<String>,
}

impl Values {
    pub fn of(unit: &Unit) -> Self {
        let uniforms = unit.variables().filter(|of| of.space == "uniform").map(|of| of.name.clone());
        let mut values = Self { constants: BTreeMap::new(), uniforms: uniforms.collect() };
        // Constants may be made of others, in any order.
        loop {
            let known = values.constants.len();
            for constant in unit.constants() {
                if let Some(value) = values.value(&constant.value) {
                    values.constants.insert(constant.name.clone(), value);
                }
            }
            if values.constants.len() == known {
                return values;
            }
        }
    }

    /// The value of an expression, if it is known. Sums and products of floats are not: shaders round them.
    pub fn value(&self, expression: &Expression) -> Option<Value> {
        match expression {
            Expression::Literal(text) => literal(text),
            Expression::Name(name) => self.constants.get(name).copied(),
            Expression::Group(inner) => self.value(inner),
            Expression::Unary(operator, of) => match (*operator, self.value(of)?) {
                ("!", Value::Bool(value)) => Some(Value::Bool(!value)),
                ("-", Value::Int(value)) => Some(Value::Int(-value)),
                ("-", Value::Float(value)) => Some(Value::Float(-value)),
                _ => None,
            },
            Expression::Binary(operator, left, right) => {
                binary(operator, self.value(left)?, self.value(right)?)
            }
            Expression::Call(name, arguments) => match arguments.as_slice() {
                [only] => converted(name, self.value(only)?),
                _ => None,
            },
            Expression::Member(..) | Expression::Index(..) => None,
        }
    }

    /// Whether an expression is a member of a uniform buffer, by known indices.
    pub fn is_setting(&self, expression: &Expression) -> bool {
        match expression {
            Expression::Name(name) => self.uniforms.contains(name),
            Expression::Member(of, _) | Expression::Group(of) => self.is_setting(of),
            Expression::Index(of, index) => self.value(index).is_some() && self.is_setting(of),
            _ => false,
        }
    }

    /// Whether an expression is known to be that value.
    pub fn is(&self, expression: &Expression, value: Value) -> bool {
        self.value(expression) == Some(value)
    }
}

fn literal(text: &str) -> Option<Value> {
    if let Ok(value) = text.parse() {
        return Some(Value::Bool(value));
    }
    if let Some(count) = text.strip_suffix('u') {
        return count.parse().ok().map(Value::Count);
    }
    if let Ok(value) = text.parse() {
        return Some(Value::Int(value));
    }
    text.parse().ok().map(Value::Float)
}

fn converted(name: &str, value: Value) -> Option<Value> {
    match (name, value) {
        ("i32", Value::Count(value)) => Some(Value::Int(i64::from(value))),
        ("i32", Value::Int(_)) | ("u32", Value::Count(_)) => Some(value),
        ("u32", Value::Int(value)) => u32::try_from(value).ok().map(Value::Count),
        // Whole numbers that floats hold.
        ("f32", Value::Int(value)) if value.unsigned_abs() < 1 << 24 => Some(Value::Float(value as f32)),
        ("f32", Value::Count(value)) if value < 1 << 24 => Some(Value::Float(value as f32)),
        _ => None,
    }
}

fn binary(operator: &str, left: Value, right: Value) -> Option<Value> {
    match (left, right) {
        (Value::Bool(a), Value::Bool(b)) => match operator {
            "&&" => Some(Value::Bool(a && b)),
            "||" => Some(Value::Bool(a || b)),
            "==" => Some(Value::Bool(a == b)),
            "!=" => Some(Value::Bool(a != b)),
            _ => None,
        },
        (Value::Int(a), Value::Int(b)) => {
            compared(operator, a.partial_cmp(&b)?).or_else(|| whole(operator, a, b).map(Value::Int))
        }
        (Value::Count(a), Value::Count(b)) => compared(operator, a.partial_cmp(&b)?).or_else(|| {
            let whole = whole(operator, i64::from(a), i64::from(b))?;
            u32::try_from(whole).ok().map(Value::Count)
        }),
        (Value::Float(a), Value::Float(b)) => compared(operator, a.partial_cmp(&b)?),
        _ => None,
    }
}

fn compared(operator: &str, order: std::cmp::Ordering) -> Option<Value> {
    let is_so = match operator {
        "==" => order.is_eq(),
        "!=" => order.is_ne(),
        "<" => order.is_lt(),
        "<=" => order.is_le(),
        ">" => order.is_gt(),
        ">=" => order.is_ge(),
        _ => return None,
    };
    Some(Value::Bool(is_so))
}

fn whole(operator: &str, a: i64, b: i64) -> Option<i64> {
    match operator {
        "+" => Some(a + b),
        "-" => Some(a - b),
        "*" => a.checked_mul(b),
        "&" => Some(a & b),
        "|" => Some(a | b),
        _ => None,
    }
}
