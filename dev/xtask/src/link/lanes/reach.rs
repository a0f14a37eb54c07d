//! Walks over naga's expressions and statements.

use std::collections::HashSet;

use naga::{Block, Expression, Function, Handle, LocalVariable, Module, Statement};

/// The functions that these reach, each after those that it calls.
pub fn functions(module: &Module, roots: &[Handle<Function>]) -> Vec<Handle<Function>> {
    let mut reached = HashSet::new();
    let mut waiting = roots.to_vec();
    while let Some(handle) = waiting.pop() {
        if reached.insert(handle) {
            calls(&module.functions[handle].body, &mut |callee| waiting.push(callee));
        }
    }
    // The front end has put functions after what they call.
    module.functions.iter().map(|(handle, _)| handle).filter(|handle| reached.contains(handle)).collect()
}

/// Every function that a block calls.
pub fn calls(block: &Block, say: &mut dyn FnMut(Handle<Function>)) {
    statements(block, &mut |statement| {
        if let Statement::Call { function, .. } = statement {
            say(*function);
        }
    });
}

/// Every statement of a block and of the blocks in it.
pub fn statements<'a>(block: &'a Block, say: &mut dyn FnMut(&'a Statement)) {
    for statement in block {
        say(statement);
        match statement {
            Statement::Block(inner) => statements(inner, say),
            Statement::If { accept, reject, .. } => {
                statements(accept, say);
                statements(reject, say);
            }
            Statement::Switch { cases, .. } => {
                for case in cases {
                    statements(&case.body, say);
                }
            }
            Statement::Loop { body, .. } => statements(body, say),
            _ => {}
        }
    }
}

/// Whether a block has a statement of that sort.
pub fn has(block: &Block, is_one: impl Fn(&Statement) -> bool) -> bool {
    let mut found = false;
    statements(block, &mut |statement| found |= is_one(statement));
    found
}

/// The local variable that a pointer points into.
pub fn local_of(function: &Function, pointer: Handle<Expression>) -> Option<Handle<LocalVariable>> {
    match function.expressions[pointer] {
        Expression::LocalVariable(local) => Some(local),
        Expression::AccessIndex { base, .. } | Expression::Access { base, .. } => local_of(function, base),
        _ => None,
    }
}

/// Passes the operands of an expression to `say`.
pub fn operands(expression: &Expression, mut say: impl FnMut(Handle<Expression>)) {
    match *expression {
        Expression::Compose { ref components, .. } => components.iter().copied().for_each(say),
        Expression::Access { base, index } => [base, index].into_iter().for_each(say),
        Expression::AccessIndex { base: operand, .. }
        | Expression::Splat { value: operand, .. }
        | Expression::Swizzle { vector: operand, .. }
        | Expression::Load { pointer: operand }
        | Expression::Unary { expr: operand, .. }
        | Expression::Relational { argument: operand, .. }
        | Expression::As { expr: operand, .. } => say(operand),
        Expression::Binary { left, right, .. } => [left, right].into_iter().for_each(say),
        Expression::Select { condition, accept, reject } => {
            [condition, accept, reject].into_iter().for_each(say);
        }
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            [Some(arg), arg1, arg2, arg3].into_iter().flatten().for_each(say);
        }
        Expression::ImageLoad { coordinate, array_index, level, .. } => {
            [Some(coordinate), array_index, level].into_iter().flatten().for_each(say);
        }
        _ => {}
    }
}
