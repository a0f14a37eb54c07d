//! Statements over lanes. `ex` are the lanes that run now; a branch runs under those that want it, a loop
//! until none is left in it, and a value that a lane returns waits in `ret` until all have returned.

use naga::{Block, Expression, Handle, Statement, SwitchValue, TypeInner};

use super::function::{Refusal, Writer};
use super::live::Locals;
use super::reach;
use super::types::{self, COMPONENTS, What, vector};
use super::uniform::is_masked_loop;

mod branch;

/// Branches and loops around a statement.
#[derive(Clone, Default)]
pub struct BlockContext {
    /// Local variables read later by lanes that wait behind a branch or loop around.
    keep: Locals,
    /// Number of branches and loops around that part the lanes.
    depth: usize,
    /// The condition of the branches around that all lanes go through.
    condition: Option<String>,
    /// Whether lanes wait in a branch, where it cannot be left because none is in it any more.
    is_in_branch: bool,
}

/// A loop around a statement.
pub struct LoopAround {
    /// Where its turns end, and where it does.
    turn: Option<String>,
    end: String,
    is_masked: bool,
    /// The lanes that go into the next turn, where some may end a turn before others do.
    live: Option<String>,
}

type Done = Result<(), Refusal>;

impl Writer<'_> {
    pub fn block(&mut self, block: &Block, context: &BlockContext) -> Done {
        for (statement, span) in block.span_iter() {
            if self.is_dead {
                break;
            }
            self.statement(statement, context)
                .map_err(|refusal| Refusal { span: refusal.span.or(Some(*span)), ..refusal })?;
        }
        Ok(())
    }

    fn statement(&mut self, statement: &Statement, context: &BlockContext) -> Done {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let expressions = &self.function.expressions;
                    if matches!(expressions[handle], Expression::ImageLoad { .. }) || self.is_slow(handle) {
                        self.settle(context);
                    }
                    self.emit(handle)?;
                }
                Ok(())
            }
            Statement::Block(inner) => self.block(inner, context),
            Statement::If { condition, accept, reject } => {
                self.branch(statement, *condition, accept, reject, context)
            }
            Statement::Switch { selector, cases } => self.switch(*selector, cases, context),
            Statement::Loop { body, .. } => self.turns(statement, body, context),
            Statement::Break => self.leave(true),
            Statement::Continue => self.leave(false),
            Statement::Return { value: Some(value) } => self.give(*value, context),
            Statement::Store { pointer, value } => self.store(*pointer, *value, context),
            Statement::Call { function, arguments, result: Some(result) } => {
                self.call(*function, arguments, *result, context)
            }
            _ => Err(Refusal::from("this statement is not known in lanes".to_owned())),
        }
    }

    /// Whether an expression is worth asking whether any lane needs it.
    fn is_slow(&self, handle: Handle<Expression>) -> bool {
        !self.is_uniform(handle)
            && matches!(
                self.function.expressions[handle],
                Expression::Binary { op: naga::BinaryOperator::Modulo, .. }
            )
    }

    /// Leaves what no lane is in any more, where some have left since that was asked last.
    fn settle(&mut self, context: &BlockContext) {
        if !self.is_unsure || context.is_in_branch || context.condition.is_some() {
            return;
        }
        self.is_unsure = false;
        let way = match self.loops.last() {
            _ if context.depth == 0 => "return ret;".to_owned(),
            Some(around) => format!("break {};", around.turn.as_ref().unwrap_or(&around.end)),
            None => return,
        };
        self.line(&format!("if none(ex) {{ {way} }}"));
    }

    /// Calls a function; one that gives the same in all lanes is called as it is for single numbers.
    fn call(
        &mut self,
        function: Handle<naga::Function>,
        arguments: &[Handle<Expression>],
        result: Handle<Expression>,
        context: &BlockContext,
    ) -> Done {
        let module = self.module;
        let callee = &module.functions[function];
        let same: Vec<bool> = arguments.iter().map(|argument| self.is_uniform(*argument)).collect();
        let variant = self.program.variant(function, &same);
        let facts = self.program.facts(&variant);
        if facts.result {
            let name = callee.name.as_deref().unwrap_or_default();
            let values: Result<Vec<String>, Refusal> =
                arguments.iter().map(|argument| self.value(*argument, false)).collect();
            let text = format!("r.{name}({})", values?.join(", "));
            self.bind(result, &text);
            return Ok(());
        }
        self.settle(context);
        let name = self.program.name(&variant, self.written);
        let mut text = format!("{name}(r");
        if facts.is_masked {
            text.push_str(", ex");
        }
        for (number, (argument, declared)) in arguments.iter().zip(&callee.arguments).enumerate() {
            let value = self.value(*argument, !facts.arguments[number])?;
            let by = if types::is_by_reference(module, declared.ty) && !self.is_reference(*argument) {
                "&"
            } else {
                ""
            };
            text.push_str(&format!(", {by}{value}"));
        }
        text.push(')');
        self.bind(result, &text);
        Ok(())
    }

    /// Whether a struct is a reference already: an argument of the function.
    pub fn is_reference(&self, value: Handle<Expression>) -> bool {
        matches!(self.function.expressions[value], Expression::FunctionArgument(_))
            && self.vector_of(value).is_none()
    }

    fn store(
        &mut self,
        pointer: Handle<Expression>,
        value: Handle<Expression>,
        context: &BlockContext,
    ) -> Done {
        let Some(local) = reach::local_of(self.function, pointer) else {
            return self.refuse(pointer, "a store there is");
        };
        let target = self.place(pointer)?;
        if self.facts().locals[local.index()] {
            let value = self.value(value, false)?;
            self.line(&format!("{target} = {value};"));
            return Ok(());
        }
        if self.facts().is_uniform(pointer) {
            return self.refuse(pointer, "a store to a member that all lanes share is");
        }
        let value = self.owned(value, true)?;
        self.assign(pointer, &target, &value, local, context)
    }

    /// What a pointer points at.
    fn pointee(&self, pointer: Handle<Expression>) -> Result<What, Refusal> {
        let types = &self.module.types;
        let of = |inner: &TypeInner| vector(inner).map(|(kind, size)| What::Vector(kind, size));
        let what = match *self.info[pointer].ty.inner_with(types) {
            TypeInner::Pointer { base, .. } => {
                of(&types[base].inner).or_else(|| types[base].name.clone().map(What::Struct))
            }
            TypeInner::ValuePointer { size: Some(size), scalar, .. } => {
                of(&TypeInner::Vector { size, scalar })
            }
            TypeInner::ValuePointer { size: None, scalar, .. } => of(&TypeInner::Scalar(scalar)),
            ref inner => of(inner),
        };
        what.map_or_else(|| self.refuse(pointer, "a value of this type is"), Ok)
    }

    /// Stores a value in the lanes that run here; in the others, too, where they do not miss what was there.
    fn assign(
        &mut self,
        pointer: Handle<Expression>,
        target: &str,
        value: &str,
        local: Handle<naga::LocalVariable>,
        context: &BlockContext,
    ) -> Done {
        let mask = match (context.keep.contains(&local), &context.condition) {
            (true, Some(condition)) => Some(format!("and(ex, {condition})")),
            (true, None) => Some("ex".to_owned()),
            (false, condition) => condition.clone(),
        };
        let Some(mask) = mask else {
            self.line(&format!("{target} = {value};"));
            return Ok(());
        };
        let chosen = self.chosen(&mask, value, target, pointer)?;
        self.line(&format!("{target} = {chosen};"));
        Ok(())
    }

    /// One of two values, lane by lane.
    fn chosen(
        &mut self,
        mask: &str,
        yes: &str,
        no: &str,
        pointer: Handle<Expression>,
    ) -> Result<String, Refusal> {
        Ok(match self.pointee(pointer)? {
            What::Vector(kind, 1) => format!("sel{}({mask}, {yes}, {no})", kind.suffix()),
            What::Vector(kind, size) => {
                let (mask_name, yes_name) = (self.fresh("m"), self.fresh("y"));
                self.line(&format!("let ({mask_name}, {yes_name}) = ({mask}, {yes});"));
                let part = |name: &&str| {
                    format!("sel{}({mask_name}, {yes_name}.{name}, {no}.{name})", kind.suffix())
                };
                types::made(size, COMPONENTS[..size].iter().map(part))
            }
            What::Struct(name) => {
                format!("{}({mask}, &{yes}, &{no})", types::function_of("sel", &name))
            }
        })
    }

    /// Gives a value back to the caller, from the lanes that run here.
    fn give(&mut self, value: Handle<Expression>, context: &BlockContext) -> Done {
        let value = self.owned(value, true)?;
        if context.depth == 0 {
            let text = if self.has_returned { self.returned("ex", &value) } else { value };
            self.line(&format!("return {text};"));
            self.is_dead = true;
            return Ok(());
        }
        if self.loops.last().is_some_and(|around| !around.is_masked) {
            return Err(Refusal::from(
                "a return out of a loop that parts no lanes is not known in lanes".to_owned(),
            ));
        }
        self.note(&value, "ex");
        self.line("ex = no_lane();");
        self.is_dead = true;
        Ok(())
    }

    /// Keeps a value for the lanes of a mask, which have returned.
    fn note(&mut self, value: &str, mask: &str) {
        let is_first = !self.has_returned && self.loops.is_empty();
        let text = if is_first { value.to_owned() } else { self.returned(mask, value) };
        self.line(&format!("ret = {text};"));
        self.has_returned = true;
        if self.has_alive && !self.loops.is_empty() {
            self.line(&format!("alive = and_not(alive, {mask});"));
        }
        let lives: Vec<String> = self.loops.iter().filter_map(|around| around.live.clone()).collect();
        for live in lives {
            self.line(&format!("{live} = and_not({live}, {mask});"));
        }
    }

    /// A value for the lanes of a mask, in the others what they have returned.
    fn returned(&mut self, mask: &str, value: &str) -> String {
        let Some(result) = &self.function.result else { return value.to_owned() };
        let ty = &self.module.types[result.ty];
        match vector(&ty.inner) {
            Some((kind, 1)) => format!("sel{}({mask}, {value}, ret)", kind.suffix()),
            Some((kind, size)) => {
                let name = self.fresh("y");
                self.line(&format!("let {name} = {value};"));
                let part = |part: &&str| format!("sel{}({mask}, {name}.{part}, ret.{part})", kind.suffix());
                types::made(size, COMPONENTS[..size].iter().map(part))
            }
            None => {
                let function = types::function_of("sel", ty.name.as_deref().unwrap_or_default());
                format!("{function}({mask}, &{value}, &ret)")
            }
        }
    }

    /// Leaves the innermost loop, or its turn.
    fn leave(&mut self, ends_loop: bool) -> Done {
        let Some(around) = self.loops.last() else {
            return Err(Refusal::from("a break out of a switch is not known in lanes".to_owned()));
        };
        self.is_dead = true;
        if !around.is_masked {
            let way = match (ends_loop, &around.turn) {
                (false, Some(turn)) => format!("break {turn};"),
                _ => format!("break {};", around.end),
            };
            self.line(&way);
            return Ok(());
        }
        if ends_loop && let Some(live) = around.live.clone() {
            self.line(&format!("{live} = and_not({live}, ex);"));
        }
        self.line("ex = no_lane();");
        Ok(())
    }

    fn switch(
        &mut self,
        selector: Handle<Expression>,
        cases: &[naga::SwitchCase],
        context: &BlockContext,
    ) -> Done {
        if !self.is_uniform(selector) {
            return self.refuse(selector, "a switch by what differs is");
        }
        let selector = self.value(selector, false)?;
        self.open(&format!("match {selector}"));
        let (before, mut all_dead, mut any_unsure) = (self.is_unsure, true, false);
        for case in cases {
            if case.fall_through {
                return Err(Refusal::from("a case that falls through is not known in lanes".to_owned()));
            }
            let pattern = match case.value {
                SwitchValue::I32(value) => format!("{value}i32"),
                SwitchValue::U32(value) => format!("{value}u32"),
                SwitchValue::Default => "_".to_owned(),
            };
            self.open(&format!("{pattern} =>"));
            self.is_unsure = before;
            self.block(&case.body, context)?;
            self.close("");
            all_dead &= self.is_dead;
            any_unsure |= self.is_unsure;
            self.is_dead = false;
        }
        self.close("");
        (self.is_dead, self.is_unsure) = (all_dead, any_unsure);
        Ok(())
    }

    fn turns(&mut self, statement: &Statement, body: &Block, context: &BlockContext) -> Done {
        self.settle(context);
        let is_masked = is_masked_loop(self.facts(), body);
        let has_continue = own_exit(body, |inner| matches!(inner, Statement::Continue));
        let end = self.fresh("'l");
        let turn = has_continue.then(|| self.fresh("'t"));
        let mut inside = context.clone();
        let (mut before, mut live) = (String::new(), None);
        if is_masked {
            before = self.fresh("b");
            self.line(&format!("let {before} = ex;"));
            inside.depth += 1;
            inside.is_in_branch = false;
            inside.keep.extend(self.live.after(statement));
            if has_continue {
                inside.keep.extend(self.live.turn(statement));
                let name = self.fresh("live");
                self.line(&format!("let mut {name} = ex;"));
                live = Some(name);
            }
        }
        let unsure = std::mem::replace(&mut self.is_unsure, false);
        self.open(&format!("{end}: loop"));
        if let Some(turn) = &turn {
            self.open(&format!("{turn}:"));
        }
        self.loops.push(LoopAround { turn: turn.clone(), end: end.clone(), is_masked, live: live.clone() });
        self.block(body, &inside)?;
        if turn.is_some() {
            self.close("");
        }
        if let Some(live) = &live {
            self.line(&format!("ex = {live};"));
            self.line(&format!("if none(ex) {{ break {end}; }}"));
        } else if is_masked && (self.is_unsure || self.is_dead) {
            self.line(&format!("if none(ex) {{ break {end}; }}"));
        }
        self.loops.pop();
        self.close("");
        self.is_dead = false;
        self.is_unsure = unsure;
        if is_masked {
            if reach::has(body, |inner| matches!(inner, Statement::Return { .. })) {
                self.line(&format!("ex = and({before}, alive);"));
                self.is_unsure = true;
            } else {
                self.line(&format!("ex = {before};"));
            }
        }
        Ok(())
    }
}

/// Whether a block has such a statement outside of the loops in it.
fn own_exit(block: &Block, is_one: impl Fn(&Statement) -> bool + Copy) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Block(inner) => own_exit(inner, is_one),
        Statement::If { accept, reject, .. } => own_exit(accept, is_one) || own_exit(reject, is_one),
        Statement::Switch { cases, .. } => cases.iter().any(|case| own_exit(&case.body, is_one)),
        statement => is_one(statement),
    })
}
