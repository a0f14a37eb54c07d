//! Words and signs of a shader.

/// A word, a sign or a comment, and what stands before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    pub text: String,
    pub kind: TokenKind,
    /// Whether an empty line stands before it.
    pub is_apart: bool,
    /// The number of its line, from 1 on.
    pub line: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    Word,
    Number,
    Sign,
    /// A line of a comment, without its slashes.
    Comment,
    End,
}

/// Signs of two characters.
const PAIRS: [&str; 9] = ["->", "==", "!=", "<=", ">=", "&&", "||", "<<", ">>"];

/// Splits a shader. The last token is the end.
pub fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    let mut is_apart = false;
    let mut last = 0;
    for (number, line) in (1..).zip(text.lines()) {
        last = number;
        if line.trim().is_empty() {
            is_apart = true;
            continue;
        }
        let mut rest = line.trim();
        while !rest.is_empty() {
            let (kind, length) = first_token(rest).ok_or_else(|| format!("line {number}: {rest}"))?;
            let (text, after) = rest.split_at(length);
            let text = if kind == TokenKind::Comment { text[2..].trim() } else { text };
            tokens.push(Token { text: text.to_owned(), kind, is_apart, line: number });
            is_apart = false;
            rest = after.trim_start();
        }
    }
    tokens.push(Token { text: String::new(), kind: TokenKind::End, is_apart, line: last });
    Ok(tokens)
}

/// The kind and the length of the token that a text begins with.
fn first_token(text: &str) -> Option<(TokenKind, usize)> {
    if text.starts_with("//") {
        return Some((TokenKind::Comment, text.len()));
    }
    let first = text.chars().next()?;
    let length = |is_part: fn(char) -> bool| text.find(|c| !is_part(c)).unwrap_or(text.len());
    if first.is_ascii_alphabetic() || first == '_' {
        return Some((TokenKind::Word, length(|c| c.is_ascii_alphanumeric() || c == '_')));
    }
    if first.is_ascii_digit() {
        return Some((TokenKind::Number, number_length(text)));
    }
    if PAIRS.iter().any(|pair| text.starts_with(pair)) {
        return Some((TokenKind::Sign, 2));
    }
    "+-*/%<>=!&|^~(){}[].,:;@".contains(first).then_some((TokenKind::Sign, 1))
}

/// The length of the number that a text begins with: digits, a point, an exponent with its sign, a suffix.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let is_exponent = matches!(bytes[at], b'e' | b'E') && !text.starts_with("0x");
        let has_sign = is_exponent && matches!(bytes.get(at + 1), Some(b'+' | b'-'));
        if !(bytes[at].is_ascii_alphanumeric() || bytes[at] == b'.') {
            break;
        }
        at += if has_sign { 2 } else { 1 };
    }
    at
}
