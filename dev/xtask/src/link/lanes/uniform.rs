//! Which values are the same in all lanes: those made of literals and bound settings alone.

use std::collections::{HashMap, HashSet};

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Block, Expression, Function, Handle, Module, Statement, TypeInner};

use super::types::{self, is_by_reference};
use super::{LaneText, reach};

/// Parts of a function that are the same in all lanes.
#[derive(Clone, PartialEq)]
pub struct Facts {
    pub arguments: Vec<bool>,
    pub locals: Vec<bool>,
    pub expressions: Vec<bool>,
    /// Whether it gives the same in all lanes, because all that it is given is.
    pub result: bool,
    /// Whether lanes go different ways in it, so that it has to know which of them run.
    pub is_masked: bool,
}

impl Facts {
    pub fn is_uniform(&self, expression: Handle<Expression>) -> bool {
        self.expressions[expression.index()]
    }
}

/// A function as it is called: with what is the same in all lanes, where that decides how it reads a texture.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    pub function: Handle<Function>,
    pub same: Option<Vec<bool>>,
}

/// Facts about every function that the roots reach.
pub struct Program<'a> {
    pub module: &'a Module,
    pub info: &'a ModuleInfo,
    pub text: &'a LaneText,
    pub roots: Vec<Handle<Function>>,
    facts: HashMap<Variant, Facts>,
    /// Those that read a texture of layers and levels, or call one that does.
    reads_layers: HashSet<Handle<Function>>,
}

impl<'a> Program<'a> {
    /// The facts; the roots' arguments differ from lane to lane, but for those that the text says.
    pub fn new(
        module: &'a Module,
        info: &'a ModuleInfo,
        text: &'a LaneText,
        roots: Vec<Handle<Function>>,
    ) -> Self {
        let mut reads_layers = HashSet::new();
        for handle in reach::functions(module, &roots) {
            let function = &module.functions[handle];
            let mut reads = function.expressions.iter().any(|(_, expression)| {
                matches!(expression, Expression::ImageLoad { array_index, .. }
                    if array_index.is_some() || text.levels_differ)
            });
            reach::calls(&function.body, &mut |callee| reads |= reads_layers.contains(&callee));
            if reads {
                reads_layers.insert(handle);
            }
        }
        let mut program = Self { module, info, text, roots, facts: HashMap::new(), reads_layers };
        for root in program.roots.clone() {
            program.called(root, &program.arguments_of_root(root));
        }
        // Everything is taken to be the same until something says that it is not; what is said once stays.
        let mut is_settled = false;
        while !is_settled {
            is_settled = true;
            for variant in program.facts.keys().cloned().collect::<Vec<_>>() {
                if program.is_apart(&variant) {
                    continue;
                }
                let handle = variant.function;
                let function = &module.functions[handle];
                let before = program.facts[&variant].clone();
                let facts = before.clone();
                let mut pass = Pass {
                    info: &info[handle],
                    function,
                    facts,
                    program: &mut program,
                    has_image_load: false,
                };
                pass.expressions();
                pass.block(&function.body, false);
                let same = pass.facts.arguments.iter().all(|same| *same) && !pass.has_image_load;
                pass.facts.result &= same && !pass.facts.is_masked;
                let mut facts = pass.facts;
                // It may have called itself under other conditions.
                for (argument, same) in facts.arguments.iter_mut().zip(&program.facts[&variant].arguments) {
                    *argument &= same;
                }
                is_settled &= facts == before;
                program.facts.insert(variant, facts);
            }
        }
        program
    }

    pub fn facts(&self, variant: &Variant) -> &Facts {
        &self.facts[variant]
    }

    /// Which of a root's arguments are the same in all lanes.
    fn arguments_of_root(&self, root: Handle<Function>) -> Vec<bool> {
        let name = |name: &Option<String>| name.clone().unwrap_or_default();
        let function = &self.module.functions[root];
        let is_same = |argument: &naga::FunctionArgument| {
            self.text.same_arguments.contains(&(&*name(&function.name), &*name(&argument.name)))
        };
        function.arguments.iter().map(is_same).collect()
    }

    /// Whether the runtime has a function over lanes.
    pub fn is_by_hand(&self, variant: &Variant) -> bool {
        let name = self.module.functions[variant.function].name.as_deref().unwrap_or_default();
        self.text.by_hand.contains(&name)
    }

    /// Whether a function's body does not matter: it takes a mask of the lanes that run, and its result
    /// differs from lane to lane.
    fn is_apart(&self, variant: &Variant) -> bool {
        self.is_one_by_one(variant) || self.is_by_hand(variant)
    }

    /// Whether a function is called for each lane by itself.
    pub fn is_one_by_one(&self, variant: &Variant) -> bool {
        let name = self.module.functions[variant.function].name.as_deref().unwrap_or_default();
        (self.text.one_by_one)(name)
    }

    /// The variant that a call with these arguments calls.
    pub fn variant(&self, function: Handle<Function>, same: &[bool]) -> Variant {
        Variant { function, same: self.reads_layers.contains(&function).then(|| same.to_vec()) }
    }

    /// Notes a call.
    fn called(&mut self, function: Handle<Function>, same: &[bool]) -> &Facts {
        let variant = self.variant(function, same);
        let callee = &self.module.functions[function];
        let module = self.module;
        let is_apart = self.is_apart(&variant);
        // Structs that are made have lanes, whatever they are made of.
        let gives_number = callee.result.as_ref().is_some_and(|result| !is_by_reference(module, result.ty));
        let facts = self.facts.entry(variant).or_insert_with(|| Facts {
            arguments: same.to_vec(),
            locals: callee
                .local_variables
                .iter()
                .map(|(_, local)| !matches!(module.types[local.ty].inner, TypeInner::Struct { .. }))
                .collect(),
            expressions: vec![true; callee.expressions.len()],
            result: gives_number && !is_apart,
            is_masked: is_apart,
        });
        for (argument, same) in facts.arguments.iter_mut().zip(same) {
            *argument &= same;
        }
        facts
    }

    /// The variants that are written, each after those that it calls.
    pub fn written(&self) -> Vec<Variant> {
        let mut waiting: Vec<Variant> =
            self.roots.iter().map(|root| self.variant(*root, &self.arguments_of_root(*root))).collect();
        let mut reached = HashSet::new();
        while let Some(variant) = waiting.pop() {
            let facts = &self.facts[&variant];
            if facts.result || !reached.insert(variant.clone()) || self.is_apart(&variant) {
                // What they are made of is not written.
                continue;
            }
            reach::statements(&self.module.functions[variant.function].body, &mut |statement| {
                if let Statement::Call { function, arguments, .. } = statement {
                    let same: Vec<bool> =
                        arguments.iter().map(|argument| facts.is_uniform(*argument)).collect();
                    waiting.push(self.variant(*function, &same));
                }
            });
        }
        let mut written: Vec<Variant> = reached.into_iter().collect();
        // The front end has put functions after what they call.
        written.sort_by(|a, b| (a.function, &a.same).cmp(&(b.function, &b.same)));
        written
    }

    /// Name of a variant: the function's, with its arguments' letters if there are several.
    pub fn name(&self, variant: &Variant, written: &[Variant]) -> String {
        let name = self.module.functions[variant.function].name.clone().unwrap_or_default();
        let is_alone = written.iter().filter(|other| other.function == variant.function).count() < 2;
        let letter = |same: &bool| if *same { 's' } else { 'l' };
        match &variant.same {
            Some(same) if !is_alone => format!("{name}_{}", same.iter().map(letter).collect::<String>()),
            _ => name,
        }
    }
}

struct Pass<'p, 'a> {
    info: &'a FunctionInfo,
    function: &'a Function,
    facts: Facts,
    program: &'p mut Program<'a>,
    has_image_load: bool,
}

impl Pass<'_, '_> {
    fn expressions(&mut self) {
        for (handle, expression) in self.function.expressions.iter() {
            let same = self.expression(handle, expression);
            self.facts.expressions[handle.index()] &= same;
        }
    }

    fn expression(&mut self, handle: Handle<Expression>, expression: &Expression) -> bool {
        match *expression {
            Expression::Literal(_) | Expression::Constant(_) | Expression::ZeroValue(_) => true,
            Expression::FunctionArgument(number) => self.facts.arguments[number as usize],
            Expression::GlobalVariable(_) => true,
            Expression::LocalVariable(local) => self.facts.locals[local.index()],
            Expression::Load { pointer } => self.facts.is_uniform(pointer),
            // Set where the call stands, which knows with what.
            Expression::CallResult(_) => true,
            Expression::ImageLoad { array_index, level, .. } => {
                self.has_image_load = true;
                // Which layers and levels are needed is asked of the lanes that run.
                let differs = |operand: Option<Handle<Expression>>| {
                    operand.is_some_and(|operand| !self.facts.is_uniform(operand))
                };
                self.facts.is_masked |= differs(array_index) || differs(level);
                false
            }
            Expression::AccessIndex { base, index } => {
                self.facts.is_uniform(base)
                    || types::is_shared_member(
                        self.program.module,
                        self.program.text,
                        &self.info[base].ty,
                        index,
                    )
            }
            // A struct that a function makes has its lanes.
            Expression::Compose { ty, .. }
                if matches!(self.program.module.types[ty].inner, TypeInner::Struct { .. }) =>
            {
                self.facts.arguments.iter().all(|same| *same) && self.operands_same(handle)
            }
            _ => self.operands_same(handle),
        }
    }

    fn operands_same(&self, handle: Handle<Expression>) -> bool {
        let mut same = true;
        reach::operands(&self.function.expressions[handle], |operand| same &= self.facts.is_uniform(operand));
        same
    }

    /// `parted` says that not all lanes that are in the function need to be here.
    fn block(&mut self, block: &Block, parted: bool) {
        for statement in block {
            match statement {
                Statement::Block(inner) => self.block(inner, parted),
                Statement::If { condition, accept, reject } => {
                    let differs = !self.facts.is_uniform(*condition);
                    self.facts.is_masked |= differs;
                    self.block(accept, parted || differs);
                    self.block(reject, parted || differs);
                }
                Statement::Switch { selector, cases } => {
                    let differs = !self.facts.is_uniform(*selector);
                    self.facts.is_masked |= differs;
                    for case in cases {
                        self.block(&case.body, parted || differs);
                    }
                }
                Statement::Loop { body, .. } => {
                    let differs = self.is_masked_loop(body);
                    self.facts.is_masked |= differs;
                    self.block(body, parted || differs);
                }
                Statement::Store { pointer, value } => {
                    if (parted || !self.facts.is_uniform(*value))
                        && let Some(local) = reach::local_of(self.function, *pointer)
                    {
                        self.facts.locals[local.index()] = false;
                    }
                }
                Statement::Return { value: Some(value) } => {
                    self.facts.result &= self.facts.is_uniform(*value);
                }
                Statement::Call { function, arguments, result } => {
                    let same: Vec<bool> =
                        arguments.iter().map(|argument| self.facts.is_uniform(*argument)).collect();
                    let callee = self.program.called(*function, &same);
                    self.facts.is_masked |= callee.is_masked;
                    if let Some(result) = result {
                        self.facts.expressions[result.index()] &= callee.result;
                    }
                }
                _ => {}
            }
        }
    }

    fn is_masked_loop(&self, body: &Block) -> bool {
        is_masked_loop(&self.facts, body)
    }
}

/// Whether lanes leave a loop, or a turn of it, at different times.
pub fn is_masked_loop(facts: &Facts, body: &Block) -> bool {
    leaves_parted(facts, body, false, true)
}

/// `own` says whether breaks and continues belong to the given loop.
fn leaves_parted(facts: &Facts, block: &Block, parted: bool, own: bool) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Block(inner) => leaves_parted(facts, inner, parted, own),
        Statement::If { condition, accept, reject } => {
            let parted = parted || !facts.is_uniform(*condition);
            leaves_parted(facts, accept, parted, own) || leaves_parted(facts, reject, parted, own)
        }
        Statement::Switch { selector, cases } => {
            let parted = parted || !facts.is_uniform(*selector);
            cases.iter().any(|case| leaves_parted(facts, &case.body, parted, own))
        }
        Statement::Loop { body, .. } => {
            let parted = parted || is_masked_loop(facts, body);
            leaves_parted(facts, body, parted, false)
        }
        Statement::Break | Statement::Continue => own && parted,
        Statement::Return { .. } => parted,
        _ => false,
    })
}
