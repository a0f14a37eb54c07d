//! Loops of a single turn.

use super::values::{Value, Values};
use crate::functions::syntax::{
    Block, Expression, Statement, StatementKind, Unit, each_statement, visit_expressions,
};

/// Runs the bodies of counted loops with one turn once.
pub fn of_one_turn(unit: &mut Unit) {
    let values = Values::of(unit);
    for function in unit.functions_mut() {
        in_block(&mut function.body, &values);
    }
}

fn in_block(block: &mut Block, values: &Values) {
    for statement in block.iter_mut() {
        for inner in statement.kind.blocks_mut() {
            in_block(inner, values);
        }
    }
    for place in 1..block.len() {
        let StatementKind::Var(counter, first) = &block[place - 1].kind else { continue };
        let body = match &block[place].kind {
            StatementKind::While(condition, body) if is_one_turn(counter, first, condition, values) => {
                once(counter, body, &block[place + 1..])
            }
            _ => None,
        };
        if let Some(body) = body {
            block[place].kind = StatementKind::Block(body);
            return;
        }
    }
}

fn is_one_turn(counter: &str, first: &Expression, condition: &Expression, values: &Values) -> bool {
    let Expression::Binary("<", left, right) = condition else { return false };
    matches!(&**left, Expression::Name(name) if name == counter)
        && values.is(first, Value::Count(0))
        && values.is(right, Value::Count(1))
}

/// The body without its counting, if it only counts at its end, and nothing else ends it.
fn once(counter: &str, body: &Block, behind: &[Statement]) -> Option<Block> {
    let (last, rest) = body.split_last()?;
    let counts = matches!(&last.kind, StatementKind::Assign(Expression::Name(name), _) if name == counter);
    let mut is_plain = true;
    each_statement(rest, &mut |statement| match &statement.kind {
        StatementKind::Break | StatementKind::Continue => is_plain = false,
        StatementKind::Assign(Expression::Name(name), _) => is_plain &= name != counter,
        _ => {}
    });
    visit_expressions(behind, &mut |part| {
        is_plain &= !matches!(part, Expression::Name(name) if name == counter);
    });
    (counts && is_plain).then(|| rest.to_vec())
}
