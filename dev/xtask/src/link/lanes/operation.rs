//! The names of operations, over lanes and on single numbers.

use naga::{BinaryOperator, MathFunction, UnaryOperator};

use super::types::Kind;

/// An operation on two numbers, over lanes.
pub fn binary_lanes(op: BinaryOperator, kind: Kind, left: &str, right: &str) -> Option<String> {
    use BinaryOperator as Op;
    use Kind::{Bool, Float, Signed, Unsigned};
    let name = match (op, kind) {
        (Op::Add, Float | Signed | Unsigned) => "add",
        (Op::Subtract, Float | Signed | Unsigned) => "sub",
        (Op::Multiply, Float | Signed | Unsigned) => "mul",
        (Op::Divide, Float) => "div",
        (Op::Modulo, Signed) => "rem",
        (Op::Equal, _) => "eq",
        (Op::NotEqual, _) => "ne",
        (Op::Less, Float | Signed | Unsigned) => "lt",
        (Op::LessEqual, Float | Signed | Unsigned) => "le",
        (Op::Greater, Float | Signed | Unsigned) => "gt",
        (Op::GreaterEqual, Float | Signed | Unsigned) => "ge",
        (Op::And | Op::LogicalAnd, Bool) => return Some(format!("and({left}, {right})")),
        (Op::InclusiveOr | Op::LogicalOr, Bool) => return Some(format!("or({left}, {right})")),
        (Op::And, Unsigned) => "and",
        (Op::ExclusiveOr, Unsigned) => "xor",
        (Op::ShiftLeft, Signed) => "shl",
        (Op::ShiftRight, Unsigned) => return Some(format!("shr_u({left}, i_of_u({right}))")),
        (Op::ShiftRight, Signed) => "shr",
        _ => return None,
    };
    Some(format!("{name}{}({left}, {right})", kind.suffix()))
}

/// An operation on two single numbers.
pub fn binary_single(op: BinaryOperator, kind: Kind, left: &str, right: &str) -> Option<String> {
    use BinaryOperator as Op;
    let sign = match op {
        Op::Add => "+",
        Op::Subtract => "-",
        Op::Multiply => "*",
        Op::Divide if kind == Kind::Float => "/",
        Op::Equal => "==",
        Op::NotEqual => "!=",
        Op::Less => "<",
        Op::LessEqual => "<=",
        Op::Greater => ">",
        Op::GreaterEqual => ">=",
        Op::And | Op::LogicalAnd if kind == Kind::Bool => "&&",
        Op::And if kind == Kind::Unsigned => "&",
        Op::InclusiveOr | Op::LogicalOr if kind == Kind::Bool => "||",
        Op::ShiftLeft => return Some(format!("{left}.unbounded_shl({right})")),
        Op::ShiftRight => return Some(format!("{left}.unbounded_shr({right})")),
        _ => return None,
    };
    let wrapping = match op {
        Op::Add => "wrapping_add",
        Op::Subtract => "wrapping_sub",
        Op::Multiply => "wrapping_mul",
        _ => "",
    };
    if matches!(kind, Kind::Signed | Kind::Unsigned) && !wrapping.is_empty() {
        return Some(format!("{left}.{wrapping}({right})"));
    }
    Some(format!("({left} {sign} {right})"))
}

/// An operation on one number.
pub fn unary(op: UnaryOperator, kind: Kind, is_lanes: bool, operand: &str) -> Option<String> {
    match (op, kind, is_lanes) {
        (UnaryOperator::LogicalNot, Kind::Bool, true) => Some(format!("not({operand})")),
        (UnaryOperator::LogicalNot, Kind::Bool, false) => Some(format!("!{operand}")),
        (UnaryOperator::Negate, Kind::Float, false) => Some(format!("(-{operand})")),
        (UnaryOperator::Negate, Kind::Float, true) => Some(format!("neg({operand})")),
        _ => None,
    }
}

/// A number as another kind. A float that is small is no NaN and fits into an integer.
pub fn convert(from: Kind, to: Kind, is_lanes: bool, is_small: bool, operand: &str) -> Option<String> {
    use Kind::{Bool, Float, Signed, Unsigned};
    if from == to {
        return Some(operand.to_owned());
    }
    if !is_lanes {
        return match (from, to) {
            (Bool, _) | (_, Bool) => None,
            _ => Some(format!("({operand} as {})", to.single())),
        };
    }
    let name = match (from, to) {
        (Float, Signed) if is_small => "i_of_small",
        (Float, Signed) => "i_of_f",
        (Signed, Float) => "f_of_i",
        (Unsigned, Signed) => "i_of_u",
        (Float, Unsigned) => "u_of_f",
        (Unsigned, Float) => "f_of_u",
        _ => return None,
    };
    Some(format!("{name}({operand})"))
}

/// A function of one number.
pub fn math_one(function: MathFunction, kind: Kind, is_lanes: bool, x: &str) -> Option<String> {
    let name = match (function, kind) {
        (MathFunction::Abs, Kind::Float) => "abs",
        (MathFunction::Floor, Kind::Float) => "floor",
        (MathFunction::Ceil, Kind::Float) => "ceil",
        (MathFunction::Sqrt, Kind::Float) => "sqrt",
        _ => return None,
    };
    Some(if is_lanes { format!("{name}({x})") } else { format!("{x}.{name}()") })
}

/// The smaller or the greater of two numbers. `constant` says that the second number is known and no NaN:
/// single numbers are then compared in one instruction, which lanes do, too.
pub fn extreme(name: &str, kind: Kind, is_lanes: bool, a: &str, b: &str, constant: bool) -> Option<String> {
    match (kind, is_lanes) {
        (Kind::Bool, _) => None,
        (_, false) => Some(format!("{a}.{name}({b})")),
        (Kind::Float, true) if constant => Some(format!("{name}_with({a}, {b})")),
        (_, true) => Some(format!("{name}{}({a}, {b})", kind.suffix())),
    }
}
