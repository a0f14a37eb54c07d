//! The part of WGSL that the shaders are written in, as a tree that keeps comments.
//!
//! Libraries that parse WGSL drop comments, which are half of a shader that people read.

mod parse;
mod print;
mod tokens;

pub use parse::parse;
pub use print::{expression, print};

/// A shader.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    /// The declarations and the headings between them, in order.
    pub items: Vec<Item>,
}

/// A declaration, or a heading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// The lines of its comment, without slashes.
    pub comment: Vec<String>,
    pub kind: ItemKind,
}

/// A kind of declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// A comment that belongs to no declaration.
    Heading,
    Struct(Struct),
    Constant(Constant),
    Variable(Variable),
    Function(Function),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Struct {
    pub name: String,
    pub members: Vec<Member>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    pub comment: Vec<String>,
    pub name: String,
    pub of: String,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constant {
    pub name: String,
    pub value: Expression,
}

/// A bound variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    pub name: String,
    /// The address space, as in `uniform`; empty for textures and samplers.
    pub space: String,
    pub of: String,
    pub group: u32,
    pub binding: u32,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    pub name: String,
    pub parameters: Vec<Parameter>,
    pub returns: String,
    pub body: Block,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    pub name: String,
    pub of: String,
}

/// Statements between braces.
pub type Block = Vec<Statement>;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    pub comment: Vec<String>,
    /// Whether an empty line stands before it.
    pub is_apart: bool,
    pub kind: StatementKind,
}

impl Statement {
    /// A statement without a comment.
    pub fn plain(kind: StatementKind) -> Self {
        Self { comment: Vec::new(), is_apart: false, kind }
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StatementKind {
    Let(String, Expression),
    Var(String, Expression),
    Assign(Expression, Expression),
    If(Expression, Block, Option<Block>),
    While(Expression, Block),
    Return(Expression),
    Break,
    Continue,
    Block(Block),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    Name(String),
    Literal(String),
    Unary(&'static str, Box<Expression>),
    Binary(&'static str, Box<Expression>, Box<Expression>),
    /// A call of a function, or a value of a type.
    Call(String, Vec<Expression>),
    Member(Box<Expression>, String),
    Index(Box<Expression>, Box<Expression>),
    /// In parentheses.
    Group(Box<Expression>),
}

impl Expression {
    /// A name.
    pub fn name(name: &str) -> Self {
        Self::Name(name.to_owned())
    }

    /// A literal.
    pub fn literal(text: &str) -> Self {
        Self::Literal(text.to_owned())
    }

    /// A member of something.
    pub fn member(self, name: &str) -> Self {
        Self::Member(Box::new(self), name.to_owned())
    }

    /// Whether it needs no parentheses anywhere.
    pub const fn is_closed(&self) -> bool {
        !matches!(self, Self::Unary(..) | Self::Binary(..))
    }

    /// The expression as an operand: in parentheses if it needs them.
    #[must_use]
    pub fn closed(self) -> Self {
        if self.is_closed() { self } else { Self::Group(Box::new(self)) }
    }

    /// The expression without parentheses around it.
    pub fn bare(&self) -> &Self {
        match self {
            Self::Group(inner) => inner.bare(),
            other => other,
        }
    }

    /// Its parts, one level down.
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Name(_) | Self::Literal(_) => Vec::new(),
            Self::Unary(_, part) | Self::Member(part, _) | Self::Group(part) => vec![part],
            Self::Binary(_, a, b) | Self::Index(a, b) => vec![a, b],
            Self::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// Its parts, one level down, to be changed.
    pub fn parts_mut(&mut self) -> Vec<&mut Self> {
        match self {
            Self::Name(_) | Self::Literal(_) => Vec::new(),
            Self::Unary(_, part) | Self::Member(part, _) | Self::Group(part) => vec![part],
            Self::Binary(_, a, b) | Self::Index(a, b) => vec![a, b],
            Self::Call(_, arguments) => arguments.iter_mut().collect(),
        }
    }

    /// Calls a function on it and all its parts.
    pub fn visit<'a>(&'a self, act: &mut impl FnMut(&'a Self)) {
        act(self);
        for part in self.parts() {
            part.visit(act);
        }
    }

    /// Calls a function on all its parts and then on itself.
    pub fn change(&mut self, act: &mut impl FnMut(&mut Self)) {
        for part in self.parts_mut() {
            part.change(act);
        }
        act(self);
    }
}

/// Calls a function on each statement of a block, those in inner blocks too.
pub fn each_statement<'a>(block: &'a [Statement], act: &mut impl FnMut(&'a Statement)) {
    for statement in block {
        act(statement);
        match &statement.kind {
            StatementKind::If(_, then, other) => {
                each_statement(then, act);
                if let Some(other) = other {
                    each_statement(other, act);
                }
            }
            StatementKind::While(_, body) | StatementKind::Block(body) => each_statement(body, act),
            _ => {}
        }
    }
}

impl StatementKind {
    /// Its own expressions, without the ones of inner blocks.
    pub fn expressions(&self) -> Vec<&Expression> {
        match self {
            Self::Let(_, value) | Self::Var(_, value) | Self::Return(value) => vec![value],
            Self::Assign(to, value) => vec![to, value],
            Self::If(condition, ..) | Self::While(condition, _) => vec![condition],
            Self::Break | Self::Continue | Self::Block(_) => Vec::new(),
        }
    }

    /// Its own expressions, to be changed.
    pub fn expressions_mut(&mut self) -> Vec<&mut Expression> {
        match self {
            Self::Let(_, value) | Self::Var(_, value) | Self::Return(value) => vec![value],
            Self::Assign(to, value) => vec![to, value],
            Self::If(condition, ..) | Self::While(condition, _) => vec![condition],
            Self::Break | Self::Continue | Self::Block(_) => Vec::new(),
        }
    }

    /// Its inner blocks, to be changed.
    pub fn blocks_mut(&mut self) -> Vec<&mut Block> {
        match self {
            Self::If(_, then, None) => vec![then],
            Self::If(_, then, Some(other)) => vec![then, other],
            Self::While(_, body) | Self::Block(body) => vec![body],
            _ => Vec::new(),
        }
    }
}

/// Calls a function on each expression of a block and all its parts, the parts first.
pub fn change_expressions(block: &mut Block, act: &mut impl FnMut(&mut Expression)) {
    for statement in block {
        for expression in statement.kind.expressions_mut() {
            expression.change(act);
        }
        for inner in statement.kind.blocks_mut() {
            change_expressions(inner, act);
        }
    }
}

/// Calls a function on each expression of a block and all its parts.
pub fn visit_expressions<'a>(block: &'a [Statement], act: &mut impl FnMut(&'a Expression)) {
    each_statement(block, &mut |statement| {
        for expression in statement.kind.expressions() {
            expression.visit(act);
        }
    });
}

impl Unit {
    /// The functions.
    pub fn functions(&self) -> impl Iterator<Item = &Function> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Function(function) => Some(function),
            _ => None,
        })
    }

    /// The functions, to be changed.
    pub fn functions_mut(&mut self) -> impl Iterator<Item = &mut Function> {
        self.items.iter_mut().filter_map(|item| match &mut item.kind {
            ItemKind::Function(function) => Some(function),
            _ => None,
        })
    }

    /// The structs.
    pub fn structs(&self) -> impl Iterator<Item = &Struct> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Struct(structure) => Some(structure),
            _ => None,
        })
    }

    /// The structs, to be changed.
    pub fn structs_mut(&mut self) -> impl Iterator<Item = &mut Struct> {
        self.items.iter_mut().filter_map(|item| match &mut item.kind {
            ItemKind::Struct(structure) => Some(structure),
            _ => None,
        })
    }

    /// The constants.
    pub fn constants(&self) -> impl Iterator<Item = &Constant> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Constant(constant) => Some(constant),
            _ => None,
        })
    }

    /// The bound variables.
    pub fn variables(&self) -> impl Iterator<Item = &Variable> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Variable(variable) => Some(variable),
            _ => None,
        })
    }
}

impl ItemKind {
    /// The name that is declared; none for a heading.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Heading => None,
            Self::Struct(structure) => Some(&structure.name),
            Self::Constant(constant) => Some(&constant.name),
            Self::Variable(variable) => Some(&variable.name),
            Self::Function(function) => Some(&function.name),
        }
    }
}

#[cfg(test)]
mod tests;
