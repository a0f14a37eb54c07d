//! Locals, parameters and members that nothing needs are left out. All expressions are pure, so whatever is
//! not needed need not be computed.

use std::collections::{BTreeMap, BTreeSet};

use super::Kept;
use super::constants::{root, without_arguments, without_members};
use super::types::{Locals, Types};
use crate::functions::syntax::{Block, Expression, Function, StatementKind, Unit};

/// What is needed.
#[derive(Default)]
struct Live {
    /// Locals and parameters, by function and name.
    locals: BTreeSet<(String, String)>,
    /// Members, by struct and name.
    members: BTreeSet<(String, String)>,
}

impl Live {
    /// How much is needed: it only grows.
    fn size(&self) -> usize {
        self.locals.len() + self.members.len()
    }
}

struct Search<'a> {
    unit: &'a Unit,
    types: Types,
    parameters: BTreeMap<String, Vec<String>>,
    live: Live,
}

pub fn only(unit: &mut Unit, kept: &Kept<'_>) {
    let live = live(unit, kept);
    let mut gone: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for function in unit.functions_mut() {
        let is_dead = |name: &str| !live.locals.contains(&(function.name.clone(), name.to_owned()));
        if !kept.function(&function.name) {
            let places = function.parameters.iter().enumerate();
            let places: Vec<usize> =
                places.filter(|(_, of)| is_dead(&of.name)).map(|(place, _)| place).collect();
            gone.insert(function.name.clone(), places);
        }
        drop_dead(&mut function.body, &is_dead);
    }
    without_arguments(unit, &gone);
    for function in unit.functions_mut() {
        if let Some(places) = gone.get(&function.name) {
            for place in places.iter().rev() {
                function.parameters.remove(*place);
            }
        }
    }
    let types = Types::of(unit);
    let given: BTreeSet<&str> = kept.whole.iter().copied().collect();
    let bound: BTreeSet<String> =
        unit.variables().filter(|of| types.is_struct(&of.of)).map(|of| of.of.clone()).collect();
    let names: Vec<String> = unit.structs().map(|of| of.name.clone()).collect();
    for name in names.iter().filter(|name| !given.contains(name.as_str()) && !bound.contains(*name)) {
        let is_gone = |member: &str| !live.members.contains(&(name.clone(), member.to_owned()));
        without_members(unit, &types, name, &is_gone, &|_| None);
    }
}

fn drop_dead(block: &mut Block, is_dead: &dyn Fn(&str) -> bool) {
    block.retain(|statement| match &statement.kind {
        StatementKind::Let(name, _) | StatementKind::Var(name, _) => !is_dead(name),
        StatementKind::Assign(to, _) => !root(to).is_some_and(is_dead),
        _ => true,
    });
    for statement in block {
        for inner in statement.kind.blocks_mut() {
            drop_dead(inner, is_dead);
        }
    }
}

fn live(unit: &Unit, kept: &Kept<'_>) -> Live {
    let parameters = |function: &'_ Function| {
        function.parameters.iter().map(|parameter| parameter.name.clone()).collect::<Vec<String>>()
    };
    let mut live = Live::default();
    for function in unit.functions().filter(|function| kept.function(&function.name)) {
        live.locals.extend(parameters(function).into_iter().map(|name| (function.name.clone(), name)));
    }
    for structure in unit.structs().filter(|of| kept.whole.contains(&of.name.as_str())) {
        let members = structure.members.iter().map(|member| member.name.clone());
        live.members.extend(members.map(|member| (structure.name.clone(), member)));
    }
    let names = |function: &'_ Function| function.parameters.iter().map(|of| of.name.clone()).collect();
    let parameters = unit.functions().map(|function| (function.name.clone(), names(function))).collect();
    let types = Types::of(unit);
    let locals = types.all_locals(unit);
    let mut search = Search { unit, types, parameters, live };
    loop {
        let size = search.live.size();
        for function in search.unit.functions() {
            search.block(&function.body, function, &locals[&function.name]);
        }
        if search.live.size() == size {
            return search.live;
        }
    }
}

impl Search<'_> {
    fn block(&mut self, block: &Block, function: &Function, locals: &Locals) {
        for statement in block {
            match &statement.kind {
                StatementKind::Let(name, value) | StatementKind::Var(name, value) => {
                    if self.is_live(function, name) {
                        self.needs(value, function, locals);
                    }
                }
                StatementKind::Assign(to, value) => {
                    if self.is_written(to, function, locals) {
                        self.needs(value, function, locals);
                    }
                }
                StatementKind::If(condition, then, other) => {
                    if !then.is_empty() || other.is_some() {
                        self.needs(condition, function, locals);
                    }
                    self.block(then, function, locals);
                    if let Some(other) = other {
                        self.block(other, function, locals);
                    }
                }
                StatementKind::While(condition, body) => {
                    self.needs(condition, function, locals);
                    self.block(body, function, locals);
                }
                StatementKind::Return(value) => self.needs(value, function, locals),
                StatementKind::Block(inner) => self.block(inner, function, locals),
                StatementKind::Break | StatementKind::Continue => {}
            }
        }
    }

    fn is_live(&self, function: &Function, name: &str) -> bool {
        self.live.locals.contains(&(function.name.clone(), name.to_owned()))
    }

    /// Whether something assigned to is needed.
    fn is_written(&self, to: &Expression, function: &Function, locals: &Locals) -> bool {
        match to {
            Expression::Name(name) => self.is_live(function, name),
            Expression::Member(of, member) => {
                let is_needed = match self.types.type_of(of, locals) {
                    Some(kind) if self.types.is_struct(&kind) => {
                        self.live.members.contains(&(kind, member.clone()))
                    }
                    _ => true,
                };
                is_needed && self.is_written(of, function, locals)
            }
            Expression::Index(of, _) | Expression::Group(of) => self.is_written(of, function, locals),
            _ => true,
        }
    }

    /// Marks what a needed expression needs.
    fn needs(&mut self, value: &Expression, function: &Function, locals: &Locals) {
        match value {
            Expression::Name(name) => {
                self.live.locals.insert((function.name.clone(), name.clone()));
            }
            Expression::Member(of, member) => {
                let kind = self.types.type_of(of, locals);
                match kind {
                    Some(kind) => {
                        self.live.members.insert((kind, member.clone()));
                    }
                    // It may be a member of any struct.
                    None => {
                        let all = self.unit.structs().map(|of| (of.name.clone(), member.clone()));
                        self.live.members.extend(all);
                    }
                }
                self.needs(of, function, locals);
            }
            Expression::Call(name, arguments) => {
                for (place, argument) in arguments.iter().enumerate() {
                    if self.takes(name, place) {
                        self.needs(argument, function, locals);
                    }
                }
            }
            other => {
                for part in other.parts() {
                    self.needs(part, function, locals);
                }
            }
        }
    }

    /// Whether a function or a struct needs its argument at that place.
    fn takes(&self, name: &str, place: usize) -> bool {
        if self.types.is_struct(name) {
            let member = &self.types.members(name)[place].0;
            return self.live.members.contains(&(name.to_owned(), member.clone()));
        }
        match self.parameters.get(name) {
            Some(parameters) => self.live.locals.contains(&(name.to_owned(), parameters[place].clone())),
            None => true,
        }
    }
}
