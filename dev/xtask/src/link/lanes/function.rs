//! One function over lanes: its head, and what its expressions and statements share.

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;

use naga::valid::FunctionInfo;
use naga::{Expression, Function, Handle, Module, Span, Statement, Type};

use super::block;
use super::live::Live;
use super::reach;
use super::statement::{BlockContext, LoopAround};
use super::types::{self, Kind, vector};
use super::uniform::{Facts, Program, Variant, is_masked_loop};

/// Why something is not written in lanes, and where it stands.
#[derive(Debug)]
pub struct Refusal {
    pub what: String,
    pub span: Option<Span>,
}

impl From<String> for Refusal {
    fn from(what: String) -> Self {
        Self { what, span: None }
    }
}

/// Writes one function.
pub struct Writer<'a> {
    pub module: &'a Module,
    pub info: &'a FunctionInfo,
    pub function: &'a Function,
    pub program: &'a Program<'a>,
    pub written: &'a [Variant],
    variant: &'a Variant,
    pub live: Live<'a>,
    out: String,
    indent: usize,
    /// The names of values that have one, by the block that they were named in.
    names: Vec<HashMap<Handle<Expression>, String>>,
    numbers: usize,
    pub loops: Vec<LoopAround>,
    /// No lane is here: what follows in the block is not reached.
    pub is_dead: bool,
    /// Lanes have left since it was last asked whether any is still here.
    pub is_unsure: bool,
    /// Lanes have returned, so that there is a value for them.
    pub has_returned: bool,
    /// Whether lanes return out of a loop that others stay in.
    pub has_alive: bool,
    pub structs: BTreeSet<Handle<Type>>,
}

impl<'a> Writer<'a> {
    pub fn new(program: &'a Program<'a>, written: &'a [Variant], variant: &'a Variant) -> Self {
        let function = &program.module.functions[variant.function];
        Self {
            module: program.module,
            info: &program.info[variant.function],
            function,
            program,
            written,
            variant,
            live: Live::of(function),
            out: String::new(),
            indent: 1,
            names: vec![HashMap::new()],
            numbers: 0,
            loops: Vec::new(),
            is_dead: false,
            is_unsure: false,
            has_returned: false,
            has_alive: false,
            structs: BTreeSet::new(),
        }
    }

    pub fn facts(&self) -> &'a Facts {
        self.program.facts(self.variant)
    }

    /// The whole function.
    pub fn write(mut self, structs: &mut BTreeSet<Handle<Type>>) -> Result<String, Refusal> {
        let facts = self.facts();
        let name = self.program.name(self.variant, self.written);
        let mut head = String::from("r: &Resources<'_>");
        if facts.is_masked {
            head.push_str(", within: M");
        }
        for (number, argument) in self.function.arguments.iter().enumerate() {
            let ty = self.type_name(argument.ty, !facts.arguments[number])?;
            let by = if types::is_by_reference(self.module, argument.ty) { "&" } else { "" };
            let _ = write!(head, ", {}: {by}{ty}", self.argument_name(number));
        }
        let result = self.result_type()?;
        let returns = self.type_name(result, true)?;
        let mut has_loop = false;
        reach::statements(&self.function.body, &mut |statement| {
            if let Statement::Loop { body, .. } = statement {
                has_loop = true;
                self.has_alive |= is_masked_loop(facts, body)
                    && reach::has(body, |inner| matches!(inner, Statement::Return { .. }));
            }
        });
        if facts.is_masked {
            self.line("let mut ex = within;");
            let zero = self.zero(result);
            self.line(&format!("let mut ret: {returns} = {zero};"));
        }
        if self.has_alive {
            self.line("let mut alive = ex;");
        }
        self.locals()?;
        self.block(&self.function.body, &BlockContext::default())?;
        if self.is_dead && facts.is_masked && !self.ends_in_return(&self.function.body) {
            self.line("ret");
        }
        structs.append(&mut self.structs);
        let (reach, attribute) = if self.program.roots.contains(&self.variant.function) {
            ("pub(super) ", "stage")
        } else {
            ("", "lanes")
        };
        let attribute = if has_loop { "stage" } else { attribute };
        Ok(format!("{attribute}! {{ {reach}fn {name}({head}) -> {returns} {{\n{}}} }}\n", self.out))
    }

    /// A function that is called for each lane by itself, as single numbers have it.
    pub fn write_one_by_one(
        mut self,
        structs: &mut BTreeSet<Handle<Type>>,
        apart: &mut BTreeSet<Handle<Type>>,
    ) -> Result<String, Refusal> {
        let facts = self.facts();
        let (mut head, mut singles, mut values) = (String::new(), String::new(), Vec::new());
        for (number, argument) in self.function.arguments.iter().enumerate() {
            let is_lanes = !facts.arguments[number];
            let ty = self.type_name(argument.ty, is_lanes)?;
            let name = self.argument_name(number);
            let by = if types::is_by_reference(self.module, argument.ty) { "&" } else { "" };
            let _ = write!(head, ", {name}: {by}{ty}");
            if is_lanes {
                let single = block::singles(self.module, argument.ty, &name)?;
                let _ = writeln!(singles, "    let {name} = {single};");
                values.push(format!("{name}[lane]"));
            } else {
                let of = if by.is_empty() { "" } else { "*" };
                values.push(format!("{of}{name}"));
            }
        }
        let result = self.result_type()?;
        let returns = self.type_name(result, true)?;
        let (zero, lanes) = (self.zero(result), block::lanes_of(self.module, result, "results")?);
        let name = self.program.name(self.variant, self.written);
        let single = self.function.name.as_deref().unwrap_or_default();
        let values = values.join(", ");
        apart.extend(&self.structs);
        structs.append(&mut self.structs);
        Ok(format!(
            "stage! {{ fn {name}(r: &Resources<'_>, within: M{head}) -> {returns} {{\n\
             \x20   if none(within) {{ return {zero}; }}\n{singles}\
             \x20   let one = |lane: usize| r.{single}({values});\n\
             \x20   let mut rest = bits_of(within);\n\
             \x20   let mut results = [one(rest.trailing_zeros() as usize); LANES];\n\
             \x20   rest &= rest - 1;\n\
             \x20   while rest != 0 {{\n\
             \x20       let lane = rest.trailing_zeros() as usize;\n\
             \x20       results[lane] = one(lane);\n\
             \x20       rest &= rest - 1;\n\
             \x20   }}\n    {lanes}\n}} }}\n"
        ))
    }

    /// The type of what the function gives.
    fn result_type(&self) -> Result<Handle<Type>, Refusal> {
        let none = || Refusal::from("a function without a result is not known in lanes".to_owned());
        self.function.result.as_ref().map(|result| result.ty).ok_or_else(none)
    }

    /// Whether a block ends in a return that is one for all lanes. The last statement of a function's body is
    /// one, or a choice by settings between blocks that end in one.
    fn ends_in_return(&self, block: &naga::Block) -> bool {
        match block.last() {
            Some(Statement::Return { .. }) => true,
            Some(Statement::Block(inner)) => self.ends_in_return(inner),
            Some(Statement::If { condition, accept, reject }) => {
                self.facts().is_uniform(*condition)
                    && self.ends_in_return(accept)
                    && self.ends_in_return(reject)
            }
            Some(Statement::Switch { cases, .. }) => cases.iter().all(|case| self.ends_in_return(&case.body)),
            _ => false,
        }
    }

    fn locals(&mut self) -> Result<(), Refusal> {
        for (local, variable) in self.function.local_variables.iter() {
            let is_lanes = !self.facts().locals[local.index()];
            let ty = self.type_name(variable.ty, is_lanes)?;
            let first = match (variable.init, is_lanes) {
                (Some(init), _) => self.value(init, is_lanes)?,
                (None, true) => self.zero(variable.ty),
                (None, false) => match vector(&self.module.types[variable.ty].inner) {
                    Some((kind, size)) => types::made(size, (0..size).map(|_| kind.zero().to_owned())),
                    None => return Err(Refusal::from("a single struct is not known in lanes".to_owned())),
                },
            };
            let name = self.local_name(local);
            self.line(&format!("let mut {name}: {ty} = {first};"));
        }
        Ok(())
    }

    /// The name of a type; structs of lanes are noted.
    pub fn type_name(&mut self, ty: Handle<Type>, is_lanes: bool) -> Result<String, Refusal> {
        if is_lanes && types::is_struct(self.module, ty) {
            self.structs.insert(ty);
        }
        Ok(types::name(self.module, ty, is_lanes)?)
    }

    /// A value of zeros in all lanes.
    pub fn zero(&self, ty: Handle<Type>) -> String {
        let ty = &self.module.types[ty];
        match vector(&ty.inner) {
            Some((kind, size)) => {
                types::made(size, (0..size).map(|_| format!("splat{}({})", kind.suffix(), kind.zero())))
            }
            None => format!("{}()", types::function_of("zero", ty.name.as_deref().unwrap_or_default())),
        }
    }

    pub fn argument_name(&self, number: usize) -> String {
        format!("{}_a{number}", self.function.arguments[number].name.as_deref().unwrap_or("of"))
    }

    pub fn local_name(&self, local: Handle<naga::LocalVariable>) -> String {
        let name = self.function.local_variables[local].name.as_deref().unwrap_or("both");
        format!("{name}_v{}", local.index())
    }

    /// The kind and size of an expression's type, if it is a number or a vector.
    pub fn vector_of(&self, expression: Handle<Expression>) -> Option<(Kind, usize)> {
        vector(self.info[expression].ty.inner_with(&self.module.types))
    }

    pub fn refuse<T>(&self, expression: Handle<Expression>, what: &str) -> Result<T, Refusal> {
        let span = Some(self.function.expressions.get_span(expression));
        Err(Refusal { what: format!("{what} not known in lanes"), span })
    }

    pub fn line(&mut self, text: &str) {
        for _ in 0..self.indent {
            self.out.push_str("    ");
        }
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// Opens a block of Rust: what is named in it has its name there alone.
    pub fn open(&mut self, head: &str) {
        self.line(&format!("{head} {{"));
        self.indent += 1;
        self.names.push(HashMap::new());
    }

    pub fn close(&mut self, tail: &str) {
        self.indent -= 1;
        self.names.pop();
        self.line(&format!("}}{tail}"));
    }

    /// Opens a block of Rust whose head stands on the line before.
    pub fn reopen(&mut self) {
        self.indent += 1;
        self.names.push(HashMap::new());
    }

    pub fn named(&self, expression: Handle<Expression>) -> Option<&str> {
        self.names.iter().rev().find_map(|names| names.get(&expression)).map(String::as_str)
    }

    /// Gives a value a name.
    pub fn bind(&mut self, expression: Handle<Expression>, text: &str) -> String {
        let given = self.function.named_expressions.get(&expression).map_or("e", String::as_str);
        let name = format!("{given}_{}", expression.index());
        self.line(&format!("let {name} = {text};"));
        if let Some(names) = self.names.last_mut() {
            names.insert(expression, name.clone());
        }
        name
    }

    /// A name that nothing else has.
    pub fn fresh(&mut self, stem: &str) -> String {
        self.numbers += 1;
        format!("{stem}{}", self.numbers)
    }
}
