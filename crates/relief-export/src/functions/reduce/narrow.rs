//! Counters of reads, steps and bytes become single numbers where one count alone is needed.

use std::collections::BTreeSet;

use super::types::{Locals, Types};
use crate::functions::syntax::{Expression, ItemKind, Unit, change_expressions, visit_expressions};

/// The type of counters, of a single count, and the components: reads, steps, bytes.
const COUNTER: &str = "vec3u";
const NUMBER: &str = "u32";
const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// Leaves out the counts that nothing reads. One that is left is a number.
pub fn counters(unit: &mut Unit) {
    let Some(read) = read(unit) else { return };
    match read.iter().copied().collect::<Vec<usize>>().as_slice() {
        [only] => narrow(unit, *only),
        _ => without_counts(unit, &read),
    }
}

/// The places of the components that are read; none where a vector of that type is no counter.
fn read(unit: &Unit) -> Option<BTreeSet<usize>> {
    let types = Types::of(unit);
    let is_counter =
        |part: &Expression, locals: &Locals| types.type_of(part, locals).as_deref() == Some(COUNTER);
    let mut read = BTreeSet::new();
    let mut is_sure = true;
    for function in unit.functions() {
        let locals = types.locals(function);
        visit_expressions(&function.body, &mut |part| match part {
            Expression::Member(of, component) if is_counter(of, &locals) => {
                match COMPONENTS.iter().position(|known| known == component) {
                    Some(place) => {
                        read.insert(place);
                    }
                    None => is_sure = false,
                }
            }
            Expression::Index(of, _) => is_sure &= !is_counter(of, &locals),
            // What is made of one number, or of another vector.
            Expression::Call(name, arguments) => is_sure &= name != COUNTER || arguments.len() == 3,
            _ => {}
        });
    }
    is_sure.then_some(read)
}

/// Counts nothing where nothing is read.
fn without_counts(unit: &mut Unit, read: &BTreeSet<usize>) {
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(name, arguments) = part
                && name == COUNTER
            {
                for place in (0..arguments.len()).filter(|place| !read.contains(place)) {
                    arguments[place] = Expression::literal("0u");
                }
            }
        });
    }
}

fn narrow(unit: &mut Unit, kept: usize) {
    let types = Types::of(unit);
    let is_counter =
        |part: &Expression, locals: &Locals| types.type_of(part, locals).as_deref() == Some(COUNTER);
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        change_expressions(&mut function.body, &mut |part| {
            let number = match part {
                Expression::Member(of, _) if is_counter(of, &locals) => Some((**of).clone()),
                Expression::Call(name, arguments) if name == COUNTER => arguments.get(kept).cloned(),
                _ => None,
            };
            if let Some(number) = number {
                *part = number.closed();
            }
        });
    }
    let narrowed = |of: &mut String| {
        if of == COUNTER {
            NUMBER.clone_into(of);
        }
    };
    for item in &mut unit.items {
        match &mut item.kind {
            ItemKind::Struct(of) => of.members.iter_mut().for_each(|member| narrowed(&mut member.of)),
            ItemKind::Constant(of) => {
                if let Expression::Call(name, arguments) = &of.value
                    && name == COUNTER
                    && let Some(number) = arguments.get(kept)
                {
                    of.value = number.clone();
                }
            }
            ItemKind::Function(of) => {
                narrowed(&mut of.returns);
                of.parameters.iter_mut().for_each(|parameter| narrowed(&mut parameter.of));
            }
            ItemKind::Heading | ItemKind::Variable(_) => {}
        }
    }
}
