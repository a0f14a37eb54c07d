//! A shader without what its choices leave out: what is always the same is put in its place, and what is then
//! not needed is left out. No arithmetic on floats is done here, so results keep their bits.

mod constants;
mod fold;
mod inline;
mod live;
mod loops;
mod narrow;
mod reach;
mod sets;
mod stores;
mod types;
mod values;

use std::collections::BTreeSet;

pub use fold::declared;
pub use types::{Types, width};
pub use values::Values;

use super::syntax::Unit;

/// What a program calls.
pub struct Kept<'a> {
    /// The functions that stay as they are declared.
    pub functions: &'a [&'a str],
    /// The structs that go in and out.
    pub structs: &'a [&'a str],
    /// The structs whose members all stay: what comes out.
    pub whole: &'a [&'a str],
}

impl Kept<'_> {
    fn function(&self, name: &str) -> bool {
        self.functions.contains(&name)
    }

    /// The structs whose values may come from elsewhere: the kept ones and the contents of bindings.
    fn given(&self, unit: &Unit) -> BTreeSet<String> {
        let kept = self.structs.iter().chain(self.whole).map(|&name| name.to_owned());
        let mut given: BTreeSet<String> = kept.collect();
        let mut waiting: Vec<String> = unit.variables().map(|variable| variable.of.clone()).collect();
        while let Some(of) = waiting.pop() {
            for structure in unit.structs().filter(|structure| types::mentions(&of, &structure.name)) {
                if given.insert(structure.name.clone()) {
                    waiting.extend(structure.members.iter().map(|member| member.of.clone()));
                }
            }
        }
        given
    }
}

/// Reduces a shader to what the kept functions need.
pub fn reduce(unit: &mut Unit, kept: &Kept<'_>) {
    reach::only(unit, kept);
    loop {
        let before = unit.clone();
        fold::all(unit);
        constants::parameters(unit, kept);
        constants::members(unit, kept);
        constants::locals(unit);
        sets::compare(unit, kept);
        inline::all(unit, kept);
        loops::of_one_turn(unit);
        stores::only(unit);
        live::only(unit, kept);
        narrow::counters(unit);
        reach::only(unit, kept);
        if *unit == before {
            return;
        }
    }
}

#[cfg(test)]
mod tests;
