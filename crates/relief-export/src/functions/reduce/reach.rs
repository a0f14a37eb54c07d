//! Declarations that nothing reaches are left out.

use std::collections::BTreeSet;

use super::Kept;
use super::fold::declared;
use super::types::mentions;
use crate::functions::syntax::{Expression, Item, ItemKind, Unit, visit_expressions};

pub fn only(unit: &mut Unit, kept: &Kept<'_>) {
    let mut reached = BTreeSet::new();
    let named = kept.functions.iter().chain(kept.structs).chain(kept.whole);
    let mut waiting: Vec<String> = named.map(|&name| name.to_owned()).collect();
    let types: Vec<String> = unit.structs().map(|of| of.name.clone()).collect();
    let mentioned =
        |of: &str| types.iter().filter(|name| mentions(of, name)).cloned().collect::<Vec<String>>();
    while let Some(name) = waiting.pop() {
        if !reached.insert(name.clone()) {
            continue;
        }
        let found = unit.items.iter().find(|item| item.kind.name() == Some(&name));
        match found.map(|item| &item.kind) {
            Some(ItemKind::Struct(of)) => {
                waiting.extend(of.members.iter().flat_map(|member| mentioned(&member.of)));
            }
            Some(ItemKind::Constant(of)) => waiting.extend(names(&of.value)),
            Some(ItemKind::Variable(of)) => waiting.extend(mentioned(&of.of)),
            Some(ItemKind::Function(of)) => {
                waiting.extend(mentioned(&of.returns));
                waiting.extend(of.parameters.iter().flat_map(|parameter| mentioned(&parameter.of)));
                let locals = declared(&of.body);
                let is_local = |name: &String| {
                    locals.contains(name) || of.parameters.iter().any(|parameter| parameter.name == *name)
                };
                visit_expressions(&of.body, &mut |part| match part {
                    Expression::Call(name, _) => waiting.push(name.clone()),
                    // A local may have the name of a function.
                    Expression::Name(name) if !is_local(name) => waiting.push(name.clone()),
                    _ => {}
                });
            }
            Some(ItemKind::Heading) | None => {}
        }
    }
    unit.items.retain(|item| item.kind.name().is_none_or(|name| reached.contains(name)));
    // A line without words says nothing.
    unit.items
        .retain(|item| item.kind != ItemKind::Heading || item.comment.iter().any(|line| !is_rule(line)));
    let is_heading = |item: Option<&Item>| item.is_none_or(|item| item.kind == ItemKind::Heading);
    let empty: Vec<bool> = (0..unit.items.len())
        .map(|place| is_heading(unit.items.get(place)) && is_heading(unit.items.get(place + 1)))
        .collect();
    let mut empty = empty.into_iter();
    unit.items.retain(|_| empty.next() != Some(true));
}

/// Whether a line of a comment is only a rule.
fn is_rule(line: &str) -> bool {
    line.chars().all(|c| c == '-')
}

fn names(value: &Expression) -> Vec<String> {
    let mut names = Vec::new();
    value.visit(&mut |part| {
        if let Expression::Name(name) | Expression::Call(name, _) = part {
            names.push(name.clone());
        }
    });
    names
}
