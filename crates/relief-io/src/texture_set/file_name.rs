//! Reading of a texture's file name: its role, and the name, tile and resolution beside it.

use super::names::{self, Found, Row};
use crate::Format;

/// What the name of a texture says.
#[derive(Debug)]
pub struct FileName {
    /// Row of the ending that gives the role.
    pub row: &'static Row,
    /// Whether the ending is at the end of the name.
    pub is_at_end: bool,
    /// Name of the set, as it is written. Empty if the file is named by its role alone.
    pub stem: String,
    /// Name of the set in lower case without separators.
    pub key: String,
    /// Words and numbers after the ending, in lower case: a variant of the file or of the set.
    pub variant: String,
    /// Texels, of a resolution in the name.
    pub texels: Option<u64>,
    /// Number of the UDIM tile.
    pub tile: Option<u32>,
    /// Whether `texels` is from a `1024`, which is also the number of a tile.
    pub may_be_tile: bool,
}

/// Number that is both a resolution and a tile.
pub const RESOLUTION_OR_TILE: u32 = 1024;

/// Words after an ending that say nothing, as in `NormalMap`.
const FILLERS: [&str; 4] = ["map", "maps", "tex", "texture"];

/// Words for the workflow of a set, which Poliigon writes after the resolution.
const WORKFLOWS: [&str; 2] = ["metalness", "specular"];

impl FileName {
    /// Reads a file's name, which is given without its extension. None if no role is recognised.
    pub fn read(name: &str) -> Option<Self> {
        let tokens = tokens(name);
        let mut places: Vec<usize> = (0..tokens.len()).filter(|&at| tokens[at].kind == Kind::Word).collect();
        let mut words: Vec<String> = places.iter().map(|&at| tokens[at].folded.clone()).collect();
        let is_unreal = name.get(..2).is_some_and(|start| start.eq_ignore_ascii_case("t_"));
        if is_workflow(&tokens, &words) {
            words.pop();
            places.pop();
        }
        let end = |words: &[String], places: &[usize]| {
            let after = places.last().map_or(0, |at| at + 1);
            let is_numbered = tokens[after..].iter().any(|token| matches!(token.kind, Kind::Number(_)));
            names::at_end(words, is_unreal, is_numbered)
        };
        let mut found = end(&words, &places);
        if found.is_none() && words.last().is_some_and(|word| FILLERS.contains(&word.as_str())) {
            found = end(&words[..words.len() - 1], &places[..places.len() - 1]);
            if found.is_some() {
                words.pop();
                places.pop();
            }
        }
        let is_at_end = found.is_some();
        let (first, count, row): Found = found.or_else(|| names::only_one(&words))?;
        // Of a word such as `MetallicOcclusionSmoothness` only the end would be known.
        if tokens[places[first]].is_glued && names::ends_in_role(&words[..first]) {
            return None;
        }
        let last = places[first + count - 1];
        let of_set = |at: &usize| match tokens[*at].kind {
            Kind::Word => places[..first].contains(at) || places[first + count..].contains(at),
            Kind::Number(_) => true,
            _ => false,
        };
        let (mut before, mut after): (Vec<usize>, Vec<usize>) =
            (0..tokens.len()).filter(of_set).partition(|at| *at < last);
        // The role comes first, as in `color_wall`.
        if before.is_empty() && after.iter().any(|at| tokens[*at].kind == Kind::Word) {
            std::mem::swap(&mut before, &mut after);
        }
        let variant = |at: &usize| match tokens[*at].kind {
            Kind::Number(number) => number.to_string(),
            _ => tokens[*at].folded.clone(),
        };
        let mut read = Self {
            row,
            is_at_end,
            stem: stem(name, &tokens, &before),
            key: before.iter().map(|&at| tokens[at].folded.as_str()).collect(),
            variant: after.iter().map(variant).collect::<Vec<_>>().join(" "),
            texels: None,
            tile: None,
            may_be_tile: false,
        };
        for token in &tokens {
            match token.kind {
                Kind::Texels(texels) => {
                    read.texels = Some(texels);
                    read.may_be_tile = token.folded == RESOLUTION_OR_TILE.to_string();
                }
                Kind::Tile(tile) => read.tile = Some(tile),
                _ => {}
            }
        }
        Some(read)
    }
}

/// Whether the last word is a workflow after a resolution, with a role before it.
fn is_workflow(tokens: &[Token<'_>], words: &[String]) -> bool {
    match (tokens, words) {
        ([.., before, last], [earlier @ .., _]) => {
            matches!(before.kind, Kind::Texels(_))
                && WORKFLOWS.contains(&last.folded.as_str())
                && names::at_end(earlier, false, false).is_some()
        }
        _ => false,
    }
}

/// Part of a name.
struct Token<'a> {
    text: &'a str,
    /// Place of the text in the name, in bytes.
    start: usize,
    /// Text in lower case, umlauts as two letters.
    folded: String,
    kind: Kind,
    /// Whether the part before it is in the same word, as `Base` is before `Color`.
    is_glued: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Word,
    /// Resolution, in texels.
    Texels(u64),
    /// Number of a variant.
    Number(u32),
    /// Number of a UDIM tile.
    Tile(u32),
    /// Name of a file format.
    Format,
}

/// Mark that makes a letter an umlaut, in names of decomposed characters.
const UMLAUT: char = '\u{308}';

/// Splits a name at everything that is neither letter nor digit, and before the capital of a word.
fn tokens(name: &str) -> Vec<Token<'_>> {
    let is_part = |sign: char| sign.is_alphanumeric() || sign == UMLAUT;
    let mut tokens = Vec::new();
    // Start of the part that is being read, and whether it is glued to the one before.
    let mut open: Option<(usize, bool)> = None;
    let mut before = None;
    let mut signs = name.char_indices().peekable();
    let mut close = |open: &mut Option<(usize, bool)>, end: usize| {
        if let Some((start, is_glued)) = open.take() {
            let text = &name[start..end];
            let folded = folded(text);
            tokens.push(Token { text, start, kind: kind(&folded), folded, is_glued });
        }
    };
    while let Some((at, sign)) = signs.next() {
        if !is_part(sign) {
            close(&mut open, at);
        } else if open.is_none() {
            open = Some((at, false));
        } else if sign.is_uppercase() {
            let next_is_lower = signs.peek().is_some_and(|(_, next)| next.is_lowercase());
            if next_is_lower || before.is_some_and(char::is_lowercase) {
                close(&mut open, at);
                open = Some((at, true));
            }
        }
        before = Some(sign);
    }
    close(&mut open, name.len());
    tokens
}

/// Writes a text in lower case and its umlauts as two letters.
fn folded(text: &str) -> String {
    let mut folded = String::with_capacity(text.len());
    for sign in text.chars().flat_map(char::to_lowercase) {
        match sign {
            'ä' => folded.push_str("ae"),
            'ö' => folded.push_str("oe"),
            'ü' => folded.push_str("ue"),
            'ß' => folded.push_str("ss"),
            UMLAUT => folded.push('e'),
            _ => folded.push(sign),
        }
    }
    folded
}

/// Returns the kind of a part, in lower case.
fn kind(part: &str) -> Kind {
    let number = |digits: &str| {
        let is_number = digits.len() <= 5 && digits.bytes().all(|digit| digit.is_ascii_digit());
        digits.parse::<u32>().ok().filter(|_| is_number)
    };
    if let Some(value) = number(part) {
        return match value {
            512 | RESOLUTION_OR_TILE | 2048 | 4096 | 8192 | 16384 => Kind::Texels(square(value)),
            1001..=1999 if part.len() == 4 => Kind::Tile(value),
            _ if part.len() <= 3 => Kind::Number(value),
            _ => Kind::Word,
        };
    }
    if let Some(value @ 1..=16) = part.strip_suffix('k').and_then(number) {
        return Kind::Texels(square(value * 1024));
    }
    if let Some((width, height)) = part.split_once('x')
        && let (Some(width), Some(height)) = (number(width), number(height))
    {
        return Kind::Texels(u64::from(width) * u64::from(height));
    }
    if let Some(value @ 0..=999) = part.strip_prefix('v').and_then(number) {
        return Kind::Number(value);
    }
    match Format::by_ending(part) {
        Some(Format::Raw) | None => Kind::Word,
        Some(_) => Kind::Format,
    }
}

fn square(side: u32) -> u64 {
    u64::from(side) * u64::from(side)
}

/// Joins the kept parts. Neighbours keep what stands between them.
fn stem(name: &str, tokens: &[Token<'_>], kept: &[usize]) -> String {
    let mut stem = String::new();
    for (order, &at) in kept.iter().enumerate() {
        let token = &tokens[at];
        match order.checked_sub(1).map(|before| kept[before]) {
            Some(before) if before + 1 == at => {
                let end = tokens[before].start + tokens[before].text.len();
                stem.push_str(&name[end..token.start]);
            }
            Some(_) => stem.push('_'),
            None => {}
        }
        stem.push_str(token.text);
    }
    stem
}
