//! Which local variables are read after a statement, before something else is stored in them. A lane that
//! waits behind a branch or a loop keeps those, and no others.

use std::collections::{BTreeSet, HashMap};

use naga::{Block, Expression, Function, Handle, LocalVariable, Statement};

use super::reach;

/// Local variables.
pub type Locals = BTreeSet<Handle<LocalVariable>>;

/// Variables that are read after each branch and loop of a function.
pub struct Live<'a> {
    function: &'a Function,
    after: HashMap<*const Statement, Locals>,
    turn: HashMap<*const Statement, Locals>,
}

/// What is read where the loop around goes on, and where it ends.
struct Around {
    turn: Locals,
    end: Locals,
}

impl<'a> Live<'a> {
    pub fn of(function: &'a Function) -> Self {
        let mut live = Self { function, after: HashMap::new(), turn: HashMap::new() };
        live.block(&function.body, Locals::new(), &Around { turn: Locals::new(), end: Locals::new() });
        live
    }

    /// Returns the variables that are read after a branch or a loop of the function.
    pub fn after(&self, statement: &Statement) -> &Locals {
        &self.after[&std::ptr::from_ref(statement)]
    }

    /// Returns the variables that are read from the start of a turn of a loop on.
    pub fn turn(&self, statement: &Statement) -> &Locals {
        &self.turn[&std::ptr::from_ref(statement)]
    }

    /// What is read from the start of a block on, given what is read after it.
    fn block(&mut self, block: &Block, after: Locals, around: &Around) -> Locals {
        let mut live = after;
        for statement in block.iter().rev() {
            let place = std::ptr::from_ref(statement);
            match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        if let Expression::Load { pointer } = self.function.expressions[handle] {
                            live.extend(reach::local_of(self.function, pointer));
                        }
                    }
                }
                Statement::Store { pointer, .. } => {
                    if let Expression::LocalVariable(local) = self.function.expressions[*pointer] {
                        live.remove(&local);
                    }
                }
                Statement::Block(inner) => live = self.block(inner, live, around),
                Statement::If { accept, reject, .. } => {
                    self.after.insert(place, live.clone());
                    let mut either = self.block(accept, live.clone(), around);
                    either.extend(self.block(reject, live, around));
                    live = either;
                }
                Statement::Switch { cases, .. } => {
                    self.after.insert(place, live.clone());
                    let starts: Vec<Locals> =
                        cases.iter().map(|case| self.block(&case.body, live.clone(), around)).collect();
                    live = starts.into_iter().flatten().collect();
                }
                Statement::Loop { body, .. } => {
                    self.after.insert(place, live.clone());
                    let mut inside = Around { turn: Locals::new(), end: live };
                    loop {
                        let start = self.block(body, inside.turn.clone(), &inside);
                        if start.is_subset(&inside.turn) {
                            break;
                        }
                        inside.turn.extend(start);
                    }
                    live = inside.turn.clone();
                    self.turn.insert(place, inside.turn);
                }
                Statement::Break => live = around.end.clone(),
                Statement::Continue => live = around.turn.clone(),
                Statement::Return { .. } => live = Locals::new(),
                _ => {}
            }
        }
        live
    }
}
