//! Parameters, members and locals that always have the same value.

use std::collections::{BTreeMap, BTreeSet};

use super::Kept;
use super::fold::declared;
use super::types::{Locals, Types};
use super::values::Values;
use crate::functions::syntax::{
    Block, Expression, Function, ItemKind, Statement, StatementKind, Unit, change_expressions,
    each_statement, expression, visit_expressions,
};

/// The one constant that all of some expressions are, if there is one.
fn common<'a>(mut all: impl Iterator<Item = &'a Expression>, values: &Values) -> Option<Expression> {
    let first = all.next()?;
    let constant = constant(first, values)?;
    let is_same = |other: &Expression| {
        expression(other.bare()) == expression(first.bare())
            || (values.value(other).is_some() && values.value(other) == values.value(first))
    };
    all.all(is_same).then_some(constant)
}

/// An expression that is a constant or a setting, as it may stand anywhere.
fn constant(of: &Expression, values: &Values) -> Option<Expression> {
    match of.bare() {
        Expression::Literal(_) => Some(of.bare().clone()),
        Expression::Name(name) if values.value(of).is_some() => Some(Expression::name(name)),
        other => match values.value(other) {
            Some(value) => Some(value.literal()),
            None => values.is_setting(other).then(|| other.clone()),
        },
    }
}

/// Puts an expression in the place of a name.
pub fn substitute(block: &mut Block, name: &str, by: &Expression) {
    let by = by.clone().closed();
    change_expressions(block, &mut |part| {
        if matches!(part, Expression::Name(found) if found == name) {
            *part = by.clone();
        }
    });
}

/// Leaves out parameters for which every call gives the same constant.
pub fn parameters(unit: &mut Unit, kept: &Kept<'_>) {
    let values = Values::of(unit);
    let mut calls: BTreeMap<String, Vec<Vec<Expression>>> = BTreeMap::new();
    for function in unit.functions() {
        visit_expressions(&function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part {
                calls.entry(name.clone()).or_default().push(arguments.clone());
            }
        });
    }
    let mut gone: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for function in unit.functions_mut().filter(|function| !kept.function(&function.name)) {
        let Some(calls) = calls.get(&function.name) else { continue };
        let locals = declared(&function.body);
        let mut places = Vec::new();
        for (place, parameter) in function.parameters.iter().enumerate() {
            let given = calls.iter().filter_map(|arguments| arguments.get(place));
            if !locals.contains(&parameter.name)
                && let Some(constant) = common(given, &values)
            {
                substitute(&mut function.body, &parameter.name, &constant);
                places.push(place);
            }
        }
        for place in places.iter().rev() {
            function.parameters.remove(*place);
        }
        gone.insert(function.name.clone(), places);
    }
    without_arguments(unit, &gone);
}

/// Leaves out arguments of calls, by their places.
pub fn without_arguments(unit: &mut Unit, gone: &BTreeMap<String, Vec<usize>>) {
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part
                && let Some(places) = gone.get(name)
            {
                for place in places.iter().rev() {
                    arguments.remove(*place);
                }
            }
        });
    }
}

/// Leaves out members of structs that always have the same value.
pub fn members(unit: &mut Unit, kept: &Kept<'_>) {
    let values = Values::of(unit);
    let given = kept.given(unit);
    let names: Vec<String> =
        unit.structs().map(|of| of.name.clone()).filter(|name| !given.contains(name)).collect();
    for name in names {
        let types = Types::of(unit);
        let locals = types.all_locals(unit);
        let members = types.members(&name).to_vec();
        let known: BTreeMap<String, Expression> = (0..members.len())
            .filter_map(|place| {
                let constant =
                    member_constant(unit, (&types, &locals), &values, &name, place, &members[place].0)?;
                Some((members[place].0.clone(), constant))
            })
            .collect();
        if !known.is_empty() {
            without_members(unit, &types, &name, &|member| known.contains_key(member), &|member| {
                known.get(member).cloned()
            });
        }
    }
}

/// The constant that a member always is.
fn member_constant(
    unit: &Unit,
    types: (&Types, &BTreeMap<String, Locals>),
    values: &Values,
    name: &str,
    place: usize,
    member: &str,
) -> Option<Expression> {
    common(member_values(unit, types, name, place, member)?.iter(), values)
}

/// All that a member of a struct is made of; none if that is not known.
pub fn member_values(
    unit: &Unit,
    (types, locals): (&Types, &BTreeMap<String, Locals>),
    name: &str,
    place: usize,
    member: &str,
) -> Option<Vec<Expression>> {
    let mut all: Vec<Expression> = Vec::new();
    let mut is_sure = true;
    for function in unit.functions() {
        let Some(locals) = locals.get(&function.name) else { continue };
        let is_of = |of: &Expression| types.type_of(of, locals).as_deref() == Some(name);
        visit_expressions(&function.body, &mut |part| match part {
            Expression::Call(called, arguments) if called == name => match arguments.get(place) {
                Some(value) => all.push(value.clone()),
                None => is_sure = false,
            },
            // A struct of an unknown type may be this one.
            Expression::Member(of, found) if found == member => {
                is_sure &= types.type_of(of, locals).is_some();
            }
            _ => {}
        });
        each_statement(&function.body, &mut |statement| {
            let StatementKind::Assign(Expression::Member(of, found), value) = &statement.kind else { return };
            if found == member && is_of(of) {
                all.push(value.clone());
            }
            // A part of the member is written.
            is_sure &= !matches!(&**of, Expression::Member(whole, found) if found == member && is_of(whole));
        });
    }
    is_sure.then_some(all)
}

/// Leaves out members of a struct: where they are declared, given and assigned. What reads one gets what
/// stands for it.
pub fn without_members(
    unit: &mut Unit,
    types: &Types,
    name: &str,
    is_gone: &dyn Fn(&str) -> bool,
    in_place: &dyn Fn(&str) -> Option<Expression>,
) {
    let places: Vec<usize> =
        (0..types.members(name).len()).filter(|place| is_gone(&types.members(name)[*place].0)).collect();
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        drop_assignments(&mut function.body, &|to| is_member(to, types, &locals, name, is_gone));
        change_expressions(&mut function.body, &mut |part| {
            let replaced = match part {
                Expression::Member(of, member) if types.type_of(of, &locals).as_deref() == Some(name) => {
                    in_place(member)
                }
                _ => None,
            };
            if let Some(by) = replaced {
                *part = by.closed();
            }
        });
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(called, arguments) = part
                && called == name
                && !arguments.is_empty()
            {
                for place in places.iter().rev() {
                    arguments.remove(*place);
                }
            }
        });
    }
    for structure in unit.structs_mut().filter(|structure| structure.name == name) {
        structure.members.retain(|member| !is_gone(&member.name));
    }
}

/// Whether something assigned to is a member that is gone, or a part of one.
fn is_member(
    to: &Expression,
    types: &Types,
    locals: &Locals,
    name: &str,
    is_gone: &dyn Fn(&str) -> bool,
) -> bool {
    let Expression::Member(of, member) = to else { return false };
    (is_gone(member) && types.type_of(of, locals).as_deref() == Some(name))
        || is_member(of, types, locals, name, is_gone)
}

/// Leaves out the assignments to what a test says.
pub fn drop_assignments(block: &mut Block, is_gone: &dyn Fn(&Expression) -> bool) {
    block.retain(|statement| !matches!(&statement.kind, StatementKind::Assign(to, _) if is_gone(to)));
    for statement in block {
        for inner in statement.kind.blocks_mut() {
            drop_assignments(inner, is_gone);
        }
    }
}

/// Leaves out locals that are another name of something, and makes variables that never change constant.
pub fn locals(unit: &mut Unit) {
    let values = Values::of(unit);
    let types = Types::of(unit);
    for function in unit.functions_mut() {
        let assigned = assigned(function);
        fix(&mut function.body, &assigned);
        let known = types.locals(function);
        let is_alias = |value: &Expression| match value.bare() {
            Expression::Literal(_) => true,
            Expression::Name(name) => !assigned.contains(name) || values.value(value).is_some(),
            chain => {
                let is_struct = || types.type_of(chain, &known).is_some_and(|of| types.is_struct(&of));
                values.is_setting(chain) && is_struct()
            }
        };
        let once = declared_once(function);
        let mut aliases = Vec::new();
        take_aliases(&mut function.body, &|name, value| once.contains(name) && is_alias(value), &mut aliases);
        for (name, value) in aliases {
            substitute(&mut function.body, &name, &value);
        }
    }
}

/// The name that a chain of members and indices begins with.
pub fn root(chain: &Expression) -> Option<&str> {
    match chain {
        Expression::Name(name) => Some(name),
        Expression::Member(of, _) | Expression::Index(of, _) | Expression::Group(of) => root(of),
        _ => None,
    }
}

/// The variables that are assigned to, whole or in part.
fn assigned(function: &Function) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    each_statement(&function.body, &mut |statement| {
        if let StatementKind::Assign(to, _) = &statement.kind {
            names.extend(root(to).map(str::to_owned));
        }
    });
    names
}

fn fix(block: &mut Block, assigned: &BTreeSet<String>) {
    for statement in block {
        if let StatementKind::Var(name, value) = &statement.kind
            && !assigned.contains(name)
        {
            statement.kind = StatementKind::Let(name.clone(), value.clone());
        }
        for inner in statement.kind.blocks_mut() {
            fix(inner, assigned);
        }
    }
}

/// The names that are declared once in a function.
fn declared_once(function: &Function) -> BTreeSet<String> {
    let mut counts: BTreeMap<String, usize> =
        function.parameters.iter().map(|parameter| (parameter.name.clone(), 1)).collect();
    each_statement(&function.body, &mut |statement| {
        if let StatementKind::Let(name, _) | StatementKind::Var(name, _) = &statement.kind {
            *counts.entry(name.clone()).or_default() += 1;
        }
    });
    counts.into_iter().filter(|(_, count)| *count == 1).map(|(name, _)| name).collect()
}

/// Takes out the locals that are another name of something.
fn take_aliases(
    block: &mut Block,
    is_alias: &dyn Fn(&str, &Expression) -> bool,
    aliases: &mut Vec<(String, Expression)>,
) {
    let mut is_apart = false;
    block.retain_mut(|Statement { kind, is_apart: apart, .. }| {
        let alias = match kind {
            StatementKind::Let(name, value) if is_alias(name, value) => Some((name.clone(), value.clone())),
            _ => None,
        };
        if alias.is_some() {
            is_apart |= *apart;
        } else {
            *apart |= std::mem::take(&mut is_apart);
        }
        let is_kept = alias.is_none();
        aliases.extend(alias);
        is_kept
    });
    for statement in block {
        for inner in statement.kind.blocks_mut() {
            take_aliases(inner, is_alias, aliases);
        }
    }
}

/// The parts of a unit that are functions, by name.
pub fn functions_by_name(unit: &Unit) -> BTreeMap<String, Function> {
    let functions = unit.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Function(function) => Some((function.name.clone(), function.clone())),
        _ => None,
    });
    functions.collect()
}
