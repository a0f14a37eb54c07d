//! A shader's text as a tree.

use super::tokens::{Token, TokenKind, tokens};
use super::{
    Block, Constant, Expression, Function, Item, ItemKind, Member, Parameter, Statement, StatementKind,
    Struct, Unit, Variable,
};

/// Reads a shader. The error names the line.
pub fn parse(text: &str) -> Result<Unit, String> {
    let mut parser = Parser { tokens: tokens(text)?, at: 0 };
    let mut unit = Unit::default();
    while parser.peek().kind != TokenKind::End {
        let item = parser.item()?;
        unit.items.push(item);
    }
    Ok(unit)
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
}

/// Binary operators, from the ones that bind least to the ones that bind most.
const LEVELS: [&[&str]; 10] = [
    &["||"],
    &["&&"],
    &["|"],
    &["^"],
    &["&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["<<", ">>"],
    &["+", "-"],
    &["*", "/", "%"],
];

/// How tightly a binary operator binds.
pub fn level_of(operator: &str) -> usize {
    LEVELS.iter().position(|level| level.contains(&operator)).unwrap_or(LEVELS.len())
}

impl Parser {
    fn peek(&self) -> &Token {
        &self.tokens[self.at]
    }

    fn next(&mut self) -> Token {
        let token = self.tokens[self.at].clone();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn is(&self, text: &str) -> bool {
        let token = self.peek();
        token.text == text && matches!(token.kind, TokenKind::Sign | TokenKind::Word)
    }

    fn take(&mut self, text: &str) -> bool {
        let is_it = self.is(text);
        if is_it {
            self.next();
        }
        is_it
    }

    fn require(&mut self, text: &str) -> Result<(), String> {
        if self.take(text) { Ok(()) } else { Err(self.unexpected(text)) }
    }

    fn unexpected(&self, wanted: &str) -> String {
        let Token { text, line, .. } = self.peek();
        format!("line {line}: '{text}' in place of '{wanted}'")
    }

    fn word(&mut self) -> Result<String, String> {
        if self.peek().kind == TokenKind::Word {
            Ok(self.next().text)
        } else {
            Err(self.unexpected("a name"))
        }
    }

    fn number(&mut self) -> Result<u32, String> {
        let number = self.next();
        number.text.parse().map_err(|_| format!("line {}: '{}' is no number", number.line, number.text))
    }

    /// The comment before what follows. A comment that an empty line ends is a heading.
    fn comment(&mut self) -> Vec<String> {
        let mut lines = Vec::new();
        while self.peek().kind == TokenKind::Comment {
            lines.push(self.next().text);
        }
        lines
    }

    fn item(&mut self) -> Result<Item, String> {
        let mut comment = Vec::new();
        while self.peek().kind == TokenKind::Comment {
            comment.push(self.next().text);
            if self.peek().is_apart {
                return Ok(Item { comment, kind: ItemKind::Heading });
            }
        }
        let kind = if self.take("struct") {
            ItemKind::Struct(self.structure()?)
        } else if self.take("const") {
            let name = self.word()?;
            self.require("=")?;
            let value = self.expression(0)?;
            self.require(";")?;
            ItemKind::Constant(Constant { name, value })
        } else if self.is("@") {
            ItemKind::Variable(self.variable()?)
        } else if self.take("fn") {
            ItemKind::Function(self.function()?)
        } else {
            return Err(self.unexpected("a declaration"));
        };
        Ok(Item { comment, kind })
    }

    fn structure(&mut self) -> Result<Struct, String> {
        let name = self.word()?;
        self.require("{")?;
        let mut members = Vec::new();
        while !self.take("}") {
            let comment = self.comment();
            let name = self.word()?;
            self.require(":")?;
            let of = self.kind()?;
            members.push(Member { comment, name, of });
            if !self.take(",") {
                self.require("}")?;
                break;
            }
        }
        Ok(Struct { name, members })
    }

    fn variable(&mut self) -> Result<Variable, String> {
        let mut place = [0, 0];
        for (number, name) in place.iter_mut().zip(["group", "binding"]) {
            self.require("@")?;
            self.require(name)?;
            self.require("(")?;
            *number = self.number()?;
            self.require(")")?;
        }
        self.require("var")?;
        let mut space = String::new();
        if self.take("<") {
            while !self.take(">") {
                space += &self.next().text;
            }
        }
        let name = self.word()?;
        self.require(":")?;
        let of = self.kind()?;
        self.require(";")?;
        Ok(Variable { name, space, of, group: place[0], binding: place[1] })
    }

    fn function(&mut self) -> Result<Function, String> {
        let name = self.word()?;
        self.require("(")?;
        let mut parameters = Vec::new();
        while !self.take(")") {
            let name = self.word()?;
            self.require(":")?;
            parameters.push(Parameter { name, of: self.kind()? });
            if !self.take(",") {
                self.require(")")?;
                break;
            }
        }
        self.require("->")?;
        let returns = self.kind()?;
        let body = self.block()?;
        Ok(Function { name, parameters, returns, body })
    }

    /// A type, as in `array<vec4f, 4>`.
    fn kind(&mut self) -> Result<String, String> {
        let mut text = self.word()?;
        if self.take("<") {
            text.push('<');
            while !self.take(">") {
                let part = self.next().text;
                text += if part == "," { ", " } else { &part };
            }
            text.push('>');
        }
        Ok(text)
    }

    fn block(&mut self) -> Result<Block, String> {
        self.require("{")?;
        let mut block = Vec::new();
        while !self.take("}") {
            block.push(self.statement()?);
        }
        Ok(block)
    }

    fn statement(&mut self) -> Result<Statement, String> {
        let is_apart = self.peek().is_apart;
        let comment = self.comment();
        let kind = self.statement_kind()?;
        Ok(Statement { comment, is_apart, kind })
    }

    fn statement_kind(&mut self) -> Result<StatementKind, String> {
        if self.is("{") {
            return Ok(StatementKind::Block(self.block()?));
        }
        if self.take("if") {
            return self.if_statement();
        }
        if self.take("while") {
            let condition = self.expression(0)?;
            return Ok(StatementKind::While(condition.bare().clone(), self.block()?));
        }
        let kind = if self.take("let") {
            let (name, value) = self.local()?;
            StatementKind::Let(name, value)
        } else if self.take("var") {
            let (name, value) = self.local()?;
            StatementKind::Var(name, value)
        } else if self.take("return") {
            StatementKind::Return(self.expression(0)?)
        } else if self.take("break") {
            StatementKind::Break
        } else if self.take("continue") {
            StatementKind::Continue
        } else {
            let to = self.expression(0)?;
            self.require("=")?;
            StatementKind::Assign(to, self.expression(0)?)
        };
        self.require(";")?;
        Ok(kind)
    }

    fn local(&mut self) -> Result<(String, Expression), String> {
        let name = self.word()?;
        self.require("=")?;
        Ok((name, self.expression(0)?))
    }

    fn if_statement(&mut self) -> Result<StatementKind, String> {
        let condition = self.expression(0)?.bare().clone();
        let then = self.block()?;
        let other = if !self.take("else") {
            None
        } else if self.take("if") {
            Some(vec![Statement::plain(self.if_statement()?)])
        } else {
            Some(self.block()?)
        };
        Ok(StatementKind::If(condition, then, other))
    }

    fn expression(&mut self, level: usize) -> Result<Expression, String> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.expression(level + 1)?;
        while let Some(operator) = operators.iter().find(|operator| self.is(operator)) {
            self.next();
            let right = self.expression(level + 1)?;
            left = Expression::Binary(operator, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expression, String> {
        for operator in ["-", "!", "~"] {
            if self.take(operator) {
                return Ok(Expression::Unary(operator, Box::new(self.unary()?)));
            }
        }
        self.postfix()
    }

    fn postfix(&mut self) -> Result<Expression, String> {
        let mut value = self.primary()?;
        loop {
            if self.take(".") {
                value = Expression::Member(Box::new(value), self.word()?);
            } else if self.take("[") {
                let index = self.expression(0)?;
                self.require("]")?;
                value = Expression::Index(Box::new(value), Box::new(index));
            } else {
                return Ok(value);
            }
        }
    }

    fn primary(&mut self) -> Result<Expression, String> {
        if self.take("(") {
            let inner = self.expression(0)?;
            self.require(")")?;
            return Ok(Expression::Group(Box::new(inner)));
        }
        if self.peek().kind == TokenKind::Number {
            return Ok(Expression::Literal(self.next().text));
        }
        if matches!(self.peek().text.as_str(), "true" | "false") {
            return Ok(Expression::Literal(self.next().text));
        }
        let is_type = ["vec2", "vec3", "vec4", "array"].contains(&self.peek().text.as_str());
        let name = if is_type { self.kind()? } else { self.word()? };
        if !self.take("(") {
            return Ok(Expression::Name(name));
        }
        let mut arguments = Vec::new();
        while !self.take(")") {
            arguments.push(self.expression(0)?);
            if !self.take(",") {
                self.require(")")?;
                break;
            }
        }
        Ok(Expression::Call(name, arguments))
    }
}
