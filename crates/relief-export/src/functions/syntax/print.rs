//! A tree as a shader's text.

use super::parse::level_of;
use super::{Block, Expression, Function, Item, ItemKind, Statement, StatementKind, Struct, Unit};

/// The greatest number of columns of a line.
const COLUMNS: usize = 110;

const INDENT: usize = 4;

/// Writes a shader. Constants and bindings of one line stand together.
pub fn print(unit: &Unit) -> String {
    let mut text = String::new();
    let mut was_short = true;
    for (number, item) in unit.items.iter().enumerate() {
        let is_short = matches!(item.kind, ItemKind::Constant(_) | ItemKind::Variable(_));
        if number > 0 && !(is_short && was_short && item.comment.is_empty()) {
            text.push('\n');
        }
        was_short = is_short;
        comment(&mut text, &item.comment, 0);
        declaration(&mut text, item);
    }
    text
}

fn declaration(text: &mut String, item: &Item) {
    match &item.kind {
        ItemKind::Heading => {}
        ItemKind::Struct(structure) => self::structure(text, structure),
        ItemKind::Constant(constant) => {
            let before = format!("const {} = ", constant.name);
            *text += &line(0, &before, &constant.value, ";");
        }
        ItemKind::Variable(variable) => {
            let space =
                if variable.space.is_empty() { String::new() } else { format!("<{}>", variable.space) };
            let (group, binding, name, of) = (variable.group, variable.binding, &variable.name, &variable.of);
            *text += &format!("@group({group}) @binding({binding}) var{space} {name}: {of};\n");
        }
        ItemKind::Function(function) => self::function(text, function),
    }
}

fn comment(text: &mut String, lines: &[String], indent: usize) {
    for line in lines {
        *text += &" ".repeat(indent);
        *text += format!("// {line}").trim_end();
        text.push('\n');
    }
}

fn structure(text: &mut String, structure: &Struct) {
    *text += &format!("struct {} {{\n", structure.name);
    for member in &structure.members {
        comment(text, &member.comment, INDENT);
        *text += &format!("    {}: {},\n", member.name, member.of);
    }
    *text += "}\n";
}

fn function(text: &mut String, function: &Function) {
    let declared: Vec<String> =
        function.parameters.iter().map(|parameter| format!("{}: {}", parameter.name, parameter.of)).collect();
    let flat = format!("fn {}({}) -> {} {{\n", function.name, declared.join(", "), function.returns);
    if flat.len() <= COLUMNS + 1 {
        *text += &flat;
    } else {
        *text +=
            &format!("fn {}(\n{}) -> {} {{\n", function.name, filled(declared, INDENT), function.returns);
    }
    block(text, &function.body, INDENT);
    *text += "}\n";
}

fn block(text: &mut String, block: &Block, indent: usize) {
    for (number, inner) in block.iter().enumerate() {
        if number > 0 && inner.is_apart {
            text.push('\n');
        }
        statement(text, inner, indent);
    }
}

fn statement(text: &mut String, statement: &Statement, indent: usize) {
    comment(text, &statement.comment, indent);
    let blanks = " ".repeat(indent);
    match &statement.kind {
        StatementKind::Let(name, value) => *text += &line(indent, &format!("let {name} = "), value, ";"),
        StatementKind::Var(name, value) => *text += &line(indent, &format!("var {name} = "), value, ";"),
        StatementKind::Assign(to, value) => {
            *text += &line(indent, &format!("{} = ", expression(to)), value, ";");
        }
        StatementKind::Return(value) => *text += &line(indent, "return ", value, ";"),
        StatementKind::Break => *text += &format!("{blanks}break;\n"),
        StatementKind::Continue => *text += &format!("{blanks}continue;\n"),
        StatementKind::Block(inner) => {
            *text += &format!("{blanks}{{\n");
            block(text, inner, indent + INDENT);
            *text += &format!("{blanks}}}\n");
        }
        StatementKind::While(condition, body) => {
            *text += &line(indent, "while (", condition, ") {");
            block(text, body, indent + INDENT);
            *text += &format!("{blanks}}}\n");
        }
        StatementKind::If(..) => {
            text.push_str(&blanks);
            branches(text, &statement.kind, indent);
        }
    }
}

/// An `if` behind its blanks, with all that follows from `else if` on.
fn branches(text: &mut String, kind: &StatementKind, indent: usize) {
    let StatementKind::If(condition, then, other) = kind else { return };
    *text += line(indent, "if (", condition, ") {").trim_start();
    block(text, then, indent + INDENT);
    *text += &" ".repeat(indent);
    match other.as_deref() {
        None => *text += "}\n",
        Some([only]) if only.comment.is_empty() && matches!(only.kind, StatementKind::If(..)) => {
            *text += "} else ";
            branches(text, &only.kind, indent);
        }
        Some(other) => {
            *text += "} else {\n";
            block(text, &other.to_vec(), indent + INDENT);
            *text += &format!("{}}}\n", " ".repeat(indent));
        }
    }
}

/// A line, or several where one would be too long.
fn line(indent: usize, before: &str, value: &Expression, after: &str) -> String {
    let blanks = " ".repeat(indent);
    let used = indent + before.len();
    format!("{blanks}{before}{}{after}\n", laid_out(value, indent, used, after.len()))
}

/// An expression that begins in column `used` and has `after` columns behind it.
fn laid_out(value: &Expression, indent: usize, used: usize, after: usize) -> String {
    let flat = expression(value);
    if used + flat.len() + after <= COLUMNS {
        return flat;
    }
    let inner = indent + INDENT;
    let blanks = " ".repeat(inner);
    match value {
        Expression::Call(name, arguments) if !arguments.is_empty() => {
            let arguments = arguments.iter().map(|argument| laid_out(argument, inner, inner, 1)).collect();
            format!("{name}(\n{}{})", filled(arguments, inner), " ".repeat(indent))
        }
        Expression::Group(group) => format!("({})", laid_out(group, indent, used + 1, after + 1)),
        Expression::Binary(operator, ..) => {
            let level = level_of(operator);
            let (first, rest) = chain(value, level);
            let mut text = laid_out(first, indent, used, 0);
            let mut column = used + expression(first).len();
            for (operator, part) in rest {
                let flat = format!(" {operator} {}", expression(part));
                if column + flat.len() + after <= COLUMNS {
                    text += &flat;
                    column += flat.len();
                } else {
                    let begin = inner + operator.len() + 1;
                    text += &format!("\n{blanks}{operator} {}", laid_out(part, inner, begin, after));
                    column = begin + expression(part).len();
                }
            }
            text
        }
        _ => flat,
    }
}

/// Parts with commas behind them, as many to a line as it holds.
fn filled(parts: Vec<String>, indent: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if !part.contains('\n') && indent + line.len() + part.len() + 2 <= COLUMNS => {
                *line += &format!(" {part},");
            }
            _ => lines.push(format!("{part},")),
        }
    }
    let blanks = " ".repeat(indent);
    lines.into_iter().map(|line| format!("{blanks}{line}\n")).collect()
}

/// The operands of operators of one level: the first, and the others behind theirs.
fn chain(value: &Expression, level: usize) -> (&Expression, Vec<(&'static str, &Expression)>) {
    match value {
        Expression::Binary(operator, left, right) if level_of(operator) == level => {
            let (first, mut rest) = chain(left, level);
            rest.push((operator, right));
            (first, rest)
        }
        other => (other, Vec::new()),
    }
}

/// An expression in one line.
pub fn expression(value: &Expression) -> String {
    match value {
        Expression::Name(text) | Expression::Literal(text) => text.clone(),
        Expression::Unary(operator, of) => format!("{operator}{}", expression(of)),
        Expression::Binary(operator, left, right) => {
            format!("{} {operator} {}", expression(left), expression(right))
        }
        Expression::Call(name, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(expression).collect();
            format!("{name}({})", arguments.join(", "))
        }
        Expression::Member(of, name) => format!("{}.{name}", expression(of)),
        Expression::Index(of, index) => format!("{}[{}]", expression(of), expression(index)),
        Expression::Group(inner) => format!("({})", expression(inner)),
    }
}
