//! What is known is put in its place: conditions, whole numbers, choices.

use std::collections::BTreeSet;

use super::values::{Value, Values};
use crate::functions::syntax::{
    Block, Expression, Statement, StatementKind, Unit, change_expressions, each_statement,
};

pub fn all(unit: &mut Unit) {
    let values = Values::of(unit);
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |expression| fold(expression, &values));
        let parameters = function.parameters.iter().map(|of| of.name.clone()).collect();
        statements(&mut function.body, &values, &parameters);
    }
}

/// Simplifies an expression whose parts are simple.
fn fold(expression: &mut Expression, values: &Values) {
    if let Expression::Call(_, arguments) = expression {
        for argument in arguments {
            *argument = argument.bare().clone();
        }
    }

    if let Some(simpler) = simpler(expression, values) {
        *expression = simpler;
    }
}

fn simpler(expression: &Expression, values: &Values) -> Option<Expression> {
    let is_made = match expression {
        Expression::Binary(..) | Expression::Call(..) => true,
        Expression::Unary(operator, _) => *operator == "!",
        _ => false,
    };
    if is_made && let Some(value) = values.value(expression) {
        return Some(value.literal());
    }
    match expression {
        Expression::Group(inner) if inner.is_closed() => Some((**inner).clone()),
        Expression::Call(name, arguments) if name == "select" => match arguments.as_slice() {
            [no, yes, condition] => match values.value(condition)? {
                Value::Bool(true) => Some(yes.clone().closed()),
                Value::Bool(false) => Some(no.clone().closed()),
                _ => None,
            },
            _ => None,
        },
        Expression::Binary(operator, left, right) => binary(operator, left, right, values),
        _ => None,
    }
}

/// An operation that changes nothing. The parts keep their bits.
fn binary(operator: &str, left: &Expression, right: &Expression, values: &Values) -> Option<Expression> {
    let is =
        |part: &Expression, known: &[Value]| values.value(part).is_some_and(|value| known.contains(&value));
    let zero = [Value::Count(0), Value::Int(0)];
    let one = [Value::Count(1), Value::Int(1), Value::Float(1.0)];
    let (yes, no) = ([Value::Bool(true)], [Value::Bool(false)]);
    let kept = match operator {
        "&&" if is(left, &yes) => right,
        "&&" if is(right, &yes) => left,
        "&&" if is(left, &no) => left,
        "||" if is(left, &no) => right,
        "||" if is(right, &no) => left,
        "||" if is(left, &yes) => left,
        "*" | "/" if is(right, &one) => left,
        "*" if is(left, &one) => right,
        "+" | "-" | "<<" | ">>" if is(right, &zero) => left,
        "+" if is(left, &zero) => right,
        _ => return None,
    };
    Some(kept.clone().closed())
}

fn statements(block: &mut Block, values: &Values, taken: &BTreeSet<String>) {
    for statement in block.iter_mut() {
        for whole in statement.kind.expressions_mut() {
            *whole = whole.bare().clone();
        }
        for inner in statement.kind.blocks_mut() {
            statements(inner, values, &BTreeSet::new());
        }
    }
    return_directly(block);
    let before = std::mem::take(block);
    let mut taken = taken.clone();
    taken.extend(own_names(&before));
    for mut statement in before {
        match known(&statement.kind, values) {
            Some(inner) => splice(block, statement, inner, &taken),
            None => {
                tidy(&mut statement.kind);
                if !is_idle(&statement.kind) {
                    block.push(statement);
                }
            }
        }
        if block.last().is_some_and(|last| always_ends(&last.kind)) {
            break;
        }
    }
}

/// The statements that run in place of one whose condition is known.
fn known(kind: &StatementKind, values: &Values) -> Option<Block> {
    match kind {
        StatementKind::If(condition, then, other) => match values.value(condition)? {
            Value::Bool(true) => Some(then.clone()),
            Value::Bool(false) => Some(other.clone().unwrap_or_default()),
            _ => None,
        },
        StatementKind::While(condition, _) => values.is(condition, Value::Bool(false)).then(Block::new),
        StatementKind::Block(inner) => Some(inner.clone()),
        _ => None,
    }
}

/// Adds the statements of an inner block to a block, where no name stands twice then.
fn splice(block: &mut Block, statement: Statement, mut inner: Block, taken: &BTreeSet<String>) {
    let mut before = own_names(block);
    before.extend(taken.iter().cloned());
    if !own_names(&inner).is_disjoint(&before) {
        block.push(Statement { kind: StatementKind::Block(inner), ..statement });
        return;
    }
    if let Some(first) = inner.first_mut() {
        first.is_apart |= statement.is_apart;
    }
    block.append(&mut inner);
}

/// Returns a local's value where the block ends with both.
fn return_directly(block: &mut Block) {
    let Some([local, last]) = block.last_chunk::<2>() else { return };
    if let (StatementKind::Let(name, value), StatementKind::Return(Expression::Name(returned))) =
        (&local.kind, &last.kind)
        && name == returned
    {
        let kind = StatementKind::Return(value.clone());
        let joined = Statement { kind, ..local.clone() };
        block.truncate(block.len() - 2);
        block.push(joined);
    }
}

/// The names that a block itself declares.
fn own_names(block: &[Statement]) -> BTreeSet<String> {
    let declared = block.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Let(name, _) | StatementKind::Var(name, _) => Some(name.clone()),
        _ => None,
    });
    declared.collect()
}

/// Leaves out branches that do nothing.
fn tidy(kind: &mut StatementKind) {
    let StatementKind::If(condition, then, other) = kind else { return };
    if other.as_ref().is_some_and(Vec::is_empty) {
        *other = None;
    }
    if then.is_empty()
        && let Some(other) = other.take()
    {
        *condition = Expression::Unary("!", Box::new(condition.clone().closed()));
        *then = other;
    }
}

fn is_idle(kind: &StatementKind) -> bool {
    match kind {
        StatementKind::Assign(to, value) => to == value,
        StatementKind::If(_, then, other) => then.is_empty() && other.is_none(),
        StatementKind::Block(inner) => inner.is_empty(),
        _ => false,
    }
}

/// Whether nothing behind a statement of the same block runs.
fn always_ends(kind: &StatementKind) -> bool {
    let ends = |block: &Block| block.last().is_some_and(|last| always_ends(&last.kind));
    match kind {
        StatementKind::Return(_) | StatementKind::Break | StatementKind::Continue => true,
        StatementKind::If(_, then, Some(other)) => ends(then) && ends(other),
        StatementKind::Block(inner) => ends(inner),
        _ => false,
    }
}

/// The names of a block's locals, of its inner blocks too.
pub fn declared(block: &[Statement]) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    each_statement(block, &mut |statement| {
        if let StatementKind::Let(name, _) | StatementKind::Var(name, _) = &statement.kind {
            names.insert(name.clone());
        }
    });
    names
}
