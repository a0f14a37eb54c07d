//! Branches over lanes.

use naga::{Block, Expression, Handle, Statement};

use super::super::function::{Refusal, Writer};
use super::super::reach;
use super::{BlockContext, Done, own_exit};

/// The most operations of a branch that all lanes go through, so that there is no jump.
const SHORT_OPERATIONS: usize = 8;

impl Writer<'_> {
    pub(super) fn branch(
        &mut self,
        statement: &Statement,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
        context: &BlockContext,
    ) -> Done {
        if self.is_uniform(condition) {
            return self.plain_branch(condition, accept, reject, context);
        }
        if let (Some(a), Some(b)) = (self.operations(accept), self.operations(reject))
            && a + b <= SHORT_OPERATIONS
        {
            return self.both_ways(condition, accept, reject, context);
        }
        if context.condition.is_none() && (accept.is_empty() || reject.is_empty()) {
            let (way, is_accept) = if reject.is_empty() { (accept, true) } else { (reject, false) };
            if self.is_short_exit(way, context) {
                return self.short_exit(condition, way, is_accept, context);
            }
        }
        self.settle(context);
        let condition = self.value(condition, true)?;
        let (before, wanted) = (self.fresh("b"), self.fresh("c"));
        self.line(&format!("let ({before}, {wanted}) = (ex, {condition});"));
        let mut inside = context.clone();
        inside.keep.extend(self.live.after(statement));
        inside.depth += 1;
        inside.is_in_branch = true;
        let ways_out = [self.has_exit(accept), self.has_exit(reject)];
        let all = Some(format!("and({before}, {wanted})"));
        let left = if accept.is_empty() {
            all
        } else {
            self.line(&format!("ex = and({before}, {wanted});"));
            match (self.lanes_only(accept, &inside)?, ways_out[0]) {
                (true, _) => None,
                (false, true) => {
                    let rest = self.fresh("x");
                    self.line(&format!("let {rest} = ex;"));
                    Some(rest)
                }
                (false, false) => all,
            }
        };
        if reject.is_empty() && !ways_out[0] {
            self.line(&format!("ex = {before};"));
            return Ok(());
        }
        self.line(&format!("ex = and_not({before}, {wanted});"));
        let is_dead = if reject.is_empty() { false } else { self.lanes_only(reject, &inside)? };
        match (left, is_dead) {
            _ if ways_out == [false, false] => self.line(&format!("ex = {before};")),
            (Some(left), true) => self.line(&format!("ex = {left};")),
            (Some(left), false) => self.line(&format!("ex = or(ex, {left});")),
            (None, true) => self.is_dead = true,
            (None, false) => {}
        }
        self.is_unsure |= ways_out[0] || ways_out[1];
        Ok(())
    }

    /// A block under the lanes of `ex`, which is skipped when there are none. Says whether all leave in it.
    fn lanes_only(&mut self, block: &Block, inside: &BlockContext) -> Result<bool, Refusal> {
        self.open("if any(ex)");
        let unsure = std::mem::replace(&mut self.is_unsure, false);
        self.block(block, inside)?;
        self.is_unsure = unsure;
        self.close("");
        Ok(std::mem::replace(&mut self.is_dead, false))
    }

    /// A branch by settings.
    fn plain_branch(
        &mut self,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
        context: &BlockContext,
    ) -> Done {
        let condition = self.value(condition, false)?;
        let unsure = self.is_unsure;
        self.open(&format!("if {condition}"));
        self.block(accept, context)?;
        let (dead, mut any_unsure) = (std::mem::replace(&mut self.is_dead, false), self.is_unsure);
        self.is_unsure = unsure;
        self.close(if reject.is_empty() { "" } else { " else {" });
        if !reject.is_empty() {
            self.reopen();
            self.block(reject, context)?;
            self.close("");
        }
        self.is_dead &= dead;
        any_unsure |= self.is_unsure || (dead && context.depth > 0);
        self.is_unsure = any_unsure;
        Ok(())
    }

    /// A short branch, which all lanes go through.
    fn both_ways(
        &mut self,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
        context: &BlockContext,
    ) -> Done {
        if let (Some((yes_head, target, yes)), Some((no_head, other, no))) =
            (self.only_store(accept), self.only_store(reject))
            && target == other
        {
            for head in [yes_head, no_head] {
                for statement in head {
                    self.statement(statement, context)?;
                }
            }
            return self.store_either(condition, target, [yes, no], context);
        }
        let condition = self.value(condition, true)?;
        let wanted = self.fresh("c");
        self.line(&format!("let {wanted} = {condition};"));
        for (block, own) in [(accept, wanted.clone()), (reject, format!("not({wanted})"))] {
            let condition = match &context.condition {
                Some(around) => format!("and({around}, {own})"),
                None => own,
            };
            self.block(block, &BlockContext { condition: Some(condition), ..context.clone() })?;
        }
        Ok(())
    }

    /// What a block works out before it stores once, at its end; where to, and what.
    fn only_store<'b>(
        &self,
        block: &'b Block,
    ) -> Option<(Vec<&'b Statement>, Handle<Expression>, Handle<Expression>)> {
        let mut statements: Vec<&Statement> = block.iter().collect();
        let &Statement::Store { pointer, value } = statements.pop()? else { return None };
        let is_plain = |statement: &&Statement| match statement {
            Statement::Emit(_) => true,
            // The one for another `&&`, whose variable nothing else stores in.
            Statement::If { accept, reject, .. } => {
                self.only_store(accept).is_some() && self.only_store(reject).is_some()
            }
            _ => false,
        };
        statements.iter().all(is_plain).then_some((statements, pointer, value))
    }

    /// Stores one of two values by a condition: `&&`, `||` and choices.
    fn store_either(
        &mut self,
        condition: Handle<Expression>,
        target: Handle<Expression>,
        [yes, no]: [Handle<Expression>; 2],
        context: &BlockContext,
    ) -> Done {
        let Some(local) = reach::local_of(self.function, target) else {
            return self.refuse(target, "a store there is");
        };
        let is_literal = |handle: Handle<Expression>, wanted: bool| {
            matches!(self.function.expressions[handle],
                Expression::Literal(naga::Literal::Bool(value)) if value == wanted)
        };
        let (is_and, is_or) = (is_literal(no, false), is_literal(no, true));
        let value = match self.function.expressions[condition] {
            Expression::Unary { op: naga::UnaryOperator::LogicalNot, expr } if is_or => {
                format!("or({}, {})", self.value(expr, true)?, self.value(yes, true)?)
            }
            _ if is_and => format!("and({}, {})", self.value(condition, true)?, self.value(yes, true)?),
            _ => {
                let (condition, yes, no) =
                    (self.value(condition, true)?, self.value(yes, true)?, self.value(no, true)?);
                let no_name = self.fresh("n");
                self.line(&format!("let {no_name} = {no};"));
                self.chosen(&condition, &yes, &no_name, target)?
            }
        };
        let (pointer, target) = (target, self.place(target)?);
        self.assign(pointer, &target, &value, local, context)
    }

    /// How many operations a block has that all lanes may go through; none where it has something else.
    fn operations(&self, block: &Block) -> Option<usize> {
        let mut count = 0;
        for statement in block {
            match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        count += self.weight(handle)?;
                    }
                }
                Statement::Store { pointer, .. } => {
                    reach::local_of(self.function, *pointer)?;
                    count += 1;
                }
                Statement::Block(inner) => count += self.operations(inner)?,
                Statement::If { accept, reject, .. } => {
                    count += self.operations(accept)? + self.operations(reject)?;
                }
                _ => return None,
            }
        }
        Some(count)
    }

    fn weight(&self, handle: Handle<Expression>) -> Option<usize> {
        let size = self.vector_of(handle).map_or(0, |(_, size)| size);
        match self.function.expressions[handle] {
            Expression::ImageLoad { .. } | Expression::Binary { op: naga::BinaryOperator::Modulo, .. } => {
                None
            }
            Expression::Unary { .. }
            | Expression::Binary { .. }
            | Expression::Select { .. }
            | Expression::Math { .. }
            | Expression::As { .. }
                if !self.is_uniform(handle) =>
            {
                Some(size)
            }
            _ => Some(0),
        }
    }

    /// Whether lanes may leave a block otherwise than at its end.
    fn has_exit(&self, block: &Block) -> bool {
        reach::has(block, |statement| matches!(statement, Statement::Return { .. }))
            || own_exit(block, |statement| matches!(statement, Statement::Break | Statement::Continue))
    }

    /// Whether a block is no more than a short way out.
    fn is_short_exit(&self, block: &Block, context: &BlockContext) -> bool {
        let Some(last) = block.last() else { return false };
        let is_number = |handle: Handle<Expression>| self.vector_of(handle).is_some();
        let is_way_out = match last {
            Statement::Break | Statement::Continue => {
                self.loops.last().is_some_and(|around| around.is_masked)
            }
            Statement::Return { value: Some(value) } => context.depth == 0 && is_number(*value),
            _ => false,
        };
        let mut count = 0;
        for statement in block.iter().take(block.len() - 1) {
            let Statement::Emit(range) = statement else { return false };
            for handle in range.clone() {
                let Some(weight) = self.weight(handle) else { return false };
                count += weight;
            }
        }
        is_way_out && count <= SHORT_OPERATIONS
    }

    /// Lanes that leave at once, by a condition.
    fn short_exit(
        &mut self,
        condition: Handle<Expression>,
        block: &Block,
        is_accept: bool,
        context: &BlockContext,
    ) -> Done {
        let condition = self.value(condition, true)?;
        let wanted = self.fresh("c");
        self.line(&format!("let {wanted} = {condition};"));
        let leave = if is_accept { format!("and(ex, {wanted})") } else { format!("and_not(ex, {wanted})") };
        let stay = if is_accept { format!("and_not(ex, {wanted})") } else { format!("and(ex, {wanted})") };
        for statement in block.iter().take(block.len() - 1) {
            self.statement(statement, context)?;
        }
        match block.last() {
            Some(Statement::Return { value: Some(value) }) => {
                let value = self.value(*value, true)?;
                self.note(&value, &leave);
            }
            Some(Statement::Break) => {
                let live = self.loops.last().and_then(|around| around.live.clone());
                if let Some(live) = live {
                    self.line(&format!("{live} = and_not({live}, {leave});"));
                }
            }
            _ => {}
        }
        self.line(&format!("ex = {stay};"));
        self.is_unsure = true;
        Ok(())
    }
}
