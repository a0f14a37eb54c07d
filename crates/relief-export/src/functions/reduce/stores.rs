//! Assignments behind which nothing reads the variable.

use std::collections::BTreeMap;

use super::constants::root;
use crate::functions::syntax::{Block, Expression, StatementKind, Unit};

/// Leaves out such assignments.
pub fn only(unit: &mut Unit) {
    for function in unit.functions_mut() {
        let mut reads = Reads::default();
        reads.block(&function.body);
        let mut place = 0;
        drop_idle(&mut function.body, &reads.last, &mut place, None);
    }
}

/// The place of the last statement that reads each name, as statements are counted.
#[derive(Default)]
struct Reads {
    last: BTreeMap<String, usize>,
    place: usize,
}

impl Reads {
    fn block(&mut self, block: &Block) {
        for statement in block {
            self.place += 1;
            match &statement.kind {
                StatementKind::Assign(to, value) => {
                    // A part of a variable that is written leaves the rest to be read.
                    if !matches!(to, Expression::Name(_)) {
                        self.reads(to);
                    }
                    self.reads(value);
                }
                StatementKind::If(condition, then, other) => {
                    self.reads(condition);
                    self.block(then);
                    if let Some(other) = other {
                        self.block(other);
                    }
                }
                StatementKind::While(condition, body) => {
                    self.reads(condition);
                    self.block(body);
                    // It is read again before each turn.
                    self.place += 1;
                    self.reads(condition);
                }
                StatementKind::Block(inner) => self.block(inner),
                other => other.expressions().into_iter().for_each(|value| self.reads(value)),
            }
        }
    }

    fn reads(&mut self, value: &Expression) {
        value.visit(&mut |part| {
            if let Expression::Name(name) = part {
                self.last.insert(name.clone(), self.place);
            }
        });
    }
}

/// `turns` is the place of the outermost loop around a block: what is read in it from there on is read behind
/// all of its statements.
fn drop_idle(block: &mut Block, last: &BTreeMap<String, usize>, place: &mut usize, turns: Option<usize>) {
    block.retain_mut(|statement| {
        *place += 1;
        let here = *place;
        match &mut statement.kind {
            StatementKind::Assign(to, _) => {
                let read = root(to).and_then(|name| last.get(name)).copied().unwrap_or_default();
                read > turns.unwrap_or(here)
            }
            StatementKind::If(_, then, other) => {
                drop_idle(then, last, place, turns);
                if let Some(other) = other {
                    drop_idle(other, last, place, turns);
                }
                true
            }
            StatementKind::While(_, body) => {
                drop_idle(body, last, place, turns.or(Some(here - 1)));
                *place += 1;
                true
            }
            StatementKind::Block(inner) => {
                drop_idle(inner, last, place, turns);
                true
            }
            _ => true,
        }
    });
}
