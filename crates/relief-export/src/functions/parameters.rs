//! The parameters of variants, which shaders pass on as vectors, as numbers with names.

use std::collections::{BTreeMap, BTreeSet};

use relief_shaders::{STAGES, Selection};

use super::syntax::{Expression, Item, ItemKind, Parameter, Unit, change_expressions, visit_expressions};

/// The name of the vector.
const VECTOR: &str = "params";

const COMPONENTS: [&str; 4] = ["x", "y", "z", "w"];

/// The name of a parameter of a stage's variant.
pub fn name(stage: &str, parameter: &str) -> String {
    format!("{stage}_{parameter}").replace('-', "_")
}

/// Passes on only the numbers that a function reads.
pub fn separate(unit: &mut Unit, selection: &Selection) {
    let read = read(unit);
    let names = names(unit, selection);
    name_in_comments(unit, &names);
    for function in unit.functions_mut() {
        let own = names.get(&function.name);
        let named = |letter: &str| -> String {
            own.and_then(|names| names.get(letter)).cloned().unwrap_or_else(|| name("param", letter))
        };
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Call(called, arguments) = part
                && let Some((place, letters)) = read.get(called)
            {
                let vector = arguments.remove(*place);
                let numbers = letters.iter().map(|letter| match &vector {
                    Expression::Name(name) if name == VECTOR => Expression::Name(named(letter)),
                    other => other.clone().member(letter),
                });
                arguments.splice(place..place, numbers.collect::<Vec<_>>());
            }
        });
        change_expressions(&mut function.body, &mut |part| {
            if let Expression::Member(of, letter) = part
                && matches!(&**of, Expression::Name(name) if name == VECTOR)
            {
                *part = Expression::Name(named(letter));
            }
        });
        if let Some((place, letters)) = read.get(&function.name) {
            let numbers =
                letters.iter().map(|letter| Parameter { name: named(letter), of: "f32".to_owned() });
            let numbers: Vec<Parameter> = numbers.collect();
            function.parameters.splice(place..=place, numbers);
        }
    }
}

/// Names the numbers in the comments of the sections whose functions take them.
fn name_in_comments(unit: &mut Unit, names: &BTreeMap<String, BTreeMap<&'static str, String>>) {
    let mut begin = 0;
    while begin < unit.items.len() {
        let is_heading = |item: &Item| item.kind == ItemKind::Heading;
        let rest = unit.items[begin + 1..].iter().position(is_heading);
        let end = rest.map_or(unit.items.len(), |rest| begin + 1 + rest);
        let section = &mut unit.items[begin..end];
        let own = section.iter().find_map(|item| names.get(item.kind.name()?)).cloned();
        for (letter, name) in own.unwrap_or_default() {
            let quoted = format!("`{VECTOR}.{letter}`");
            for line in section.iter_mut().flat_map(|item| &mut item.comment) {
                *line = line.replace(&quoted, &format!("`{name}`"));
            }
        }
        begin = end;
    }
}

/// The functions that take the vector: its place, and the components that they and what they call read.
fn read(unit: &Unit) -> BTreeMap<String, (usize, BTreeSet<&'static str>)> {
    let mut read: BTreeMap<String, (usize, BTreeSet<&'static str>)> = BTreeMap::new();
    for function in unit.functions() {
        let place = function.parameters.iter().position(|parameter| parameter.name == VECTOR);
        if let Some(place) = place {
            read.insert(function.name.clone(), (place, BTreeSet::new()));
        }
    }
    loop {
        let before = read.clone();
        for function in unit.functions().filter(|function| before.contains_key(&function.name)) {
            let mut letters = BTreeSet::new();
            visit_expressions(&function.body, &mut |part| match part {
                Expression::Member(of, letter) if matches!(&**of, Expression::Name(name) if name == VECTOR) =>
                {
                    letters.extend(COMPONENTS.into_iter().filter(|known| known == letter));
                }
                Expression::Call(called, arguments) => {
                    if let Some((place, theirs)) = before.get(called)
                        && matches!(&arguments[*place], Expression::Name(name) if name == VECTOR)
                    {
                        letters.extend(theirs);
                    }
                }
                _ => {}
            });
            if let Some((_, known)) = read.get_mut(&function.name) {
                known.extend(letters);
            }
        }
        if read == before {
            return read;
        }
    }
}

/// The names of the components in each function: a variant's functions have its own, others the ones of
/// their callers.
fn names(unit: &Unit, selection: &Selection) -> BTreeMap<String, BTreeMap<&'static str, String>> {
    let mut names: BTreeMap<String, BTreeMap<&'static str, String>> = BTreeMap::new();
    for (stage, choice) in STAGES.iter().zip(&selection.choices) {
        let own: BTreeMap<&'static str, String> = COMPONENTS
            .into_iter()
            .zip(choice.entry.params)
            .map(|(letter, param)| (letter, name(stage.folder, param.name)))
            .collect();
        for call in stage.calls {
            names.entry(stage.function_of(call, choice.entry)).or_insert_with(|| own.clone());
        }
    }
    loop {
        let known = names.len();
        for function in unit.functions() {
            let Some(own) = names.get(&function.name).cloned() else { continue };
            visit_expressions(&function.body, &mut |part| {
                if let Expression::Call(called, arguments) = part
                    && arguments.iter().any(|given| matches!(given, Expression::Name(name) if name == VECTOR))
                {
                    names.entry(called.clone()).or_insert_with(|| own.clone());
                }
            });
        }
        if names.len() == known {
            return names;
        }
    }
}
