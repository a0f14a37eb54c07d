//! Members that are one of a few constants: comparisons with others are known.

use std::collections::BTreeMap;

use super::Kept;
use super::constants::member_values;
use super::types::Types;
use super::values::{Value, Values};
use crate::functions::syntax::{Expression, Unit, change_expressions};

/// Puts the results of comparisons in their places that no value of a member can have.
pub fn compare(unit: &mut Unit, kept: &Kept<'_>) {
    let (types, values) = (Types::of(unit), Values::of(unit));
    let given = kept.given(unit);
    let all_locals = types.all_locals(unit);
    let mut known: BTreeMap<(String, String), Vec<Value>> = BTreeMap::new();
    for name in unit.structs().map(|of| &of.name).filter(|name| !given.contains(*name)) {
        for (place, (member, _)) in types.members(name).iter().enumerate() {
            let all = member_values(unit, (&types, &all_locals), name, place, member).unwrap_or_default();
            let constants: Option<Vec<Value>> = all.iter().map(|value| values.value(value)).collect();
            if let Some(constants) = constants.filter(|constants| !constants.is_empty()) {
                known.insert((name.clone(), member.clone()), constants);
            }
        }
    }
    for function in unit.functions_mut() {
        let locals = types.locals(function);
        change_expressions(&mut function.body, &mut |part| {
            let Expression::Binary(operator @ ("==" | "!="), left, right) = part else { return };
            let Expression::Member(of, member) = &**left else { return };
            let possible = types.type_of(of, &locals).and_then(|of| known.get(&(of, member.clone())));
            if let (Some(possible), Some(value)) = (possible, values.value(right))
                && !possible.contains(&value)
            {
                *part = Value::Bool(*operator == "!=").literal();
            }
        });
    }
}
