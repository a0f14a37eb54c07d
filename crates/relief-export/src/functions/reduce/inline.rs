//! Functions that only pass on: what they return stands in the place of their calls.

use std::collections::BTreeMap;

use super::constants::functions_by_name;
use super::{Kept, Values};
use crate::functions::syntax::{
    Expression, Function, StatementKind, Unit, change_expressions, expression, visit_expressions,
};

/// Inlines functions that return a constant, a parameter, or the call of another function, and short
/// ones that are called once.
pub fn all(unit: &mut Unit, kept: &Kept<'_>) {
    let values = Values::of(unit);
    let functions = functions_by_name(unit);
    let calls = calls(unit);
    let is_inlined = |name: &str, function: &Function| {
        let is_single = calls.get(name) == Some(&1) && is_short(function);
        !kept.function(name) && (is_single || passes_on(function, &functions, &values))
    };
    let passing: BTreeMap<&String, &Function> =
        functions.iter().filter(|(name, function)| is_inlined(name, function)).collect();
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part
                && let Some(called) = passing.get(name)
                && let Some(value) = returned(called)
                && may_stand_in(value, called, arguments)
            {
                *part = with_arguments(value, called, arguments).closed();
            }
        });
    }
}

/// How often each function is called.
fn calls(unit: &Unit) -> BTreeMap<String, usize> {
    let mut calls = BTreeMap::new();
    for function in unit.functions() {
        visit_expressions(&function.body, &mut |part| {
            if let Expression::Call(name, _) = part {
                *calls.entry(name.clone()).or_default() += 1;
            }
        });
    }
    calls
}

/// The most characters of what stands in the place of a single call.
const SHORT: usize = 64;

/// Whether a function returns a short expression.
fn is_short(function: &Function) -> bool {
    returned(function).is_some_and(|value| expression(value).len() <= SHORT)
}

/// Whether nothing is computed twice where a function's value stands in the place of a call.
fn may_stand_in(value: &Expression, called: &Function, arguments: &[Expression]) -> bool {
    called.parameters.iter().zip(arguments).all(|(parameter, argument)| {
        let is_simple = matches!(argument.bare(), Expression::Literal(_)) || is_chain(argument);
        is_simple || count(value, &parameter.name) <= 1
    })
}

fn count(value: &Expression, name: &str) -> usize {
    let mut count = 0;
    value.visit(&mut |part| count += usize::from(matches!(part, Expression::Name(word) if word == name)));
    count
}

/// What a function returns that does nothing else.
pub fn returned(function: &Function) -> Option<&Expression> {
    match function.body.as_slice() {
        [only] => match &only.kind {
            StatementKind::Return(value) => Some(value),
            _ => None,
        },
        _ => None,
    }
}

fn passes_on(function: &Function, functions: &BTreeMap<String, Function>, values: &Values) -> bool {
    let is_plain = |value: &Expression| match value.bare() {
        Expression::Name(_) | Expression::Literal(_) => true,
        other => values.value(other).is_some(),
    };
    let Some(value) = returned(function) else { return false };
    match value.bare() {
        Expression::Call(name, arguments) if name != &function.name => {
            let is_conversion = CONVERSIONS.contains(&name.as_str()) && arguments.len() == 1;
            (is_conversion || functions.contains_key(name))
                && arguments.iter().all(|given| is_plain(given) || is_chain(given))
        }
        other => is_plain(other),
    }
}

/// Conversions of vectors.
const CONVERSIONS: [&str; 2] = ["vec2i", "vec2f"];

/// Whether an expression is members of something.
fn is_chain(value: &Expression) -> bool {
    super::constants::root(value).is_some()
}

/// What a function returns for arguments.
pub fn with_arguments(value: &Expression, called: &Function, arguments: &[Expression]) -> Expression {
    let mut value = value.clone();
    let given: BTreeMap<&str, &Expression> =
        called.parameters.iter().map(|parameter| parameter.name.as_str()).zip(arguments).collect();
    value.change(&mut |part| {
        if let Expression::Name(name) = part
            && let Some(argument) = given.get(name.as_str())
        {
            *part = (*argument).clone().closed();
        }
    });
    value
}
