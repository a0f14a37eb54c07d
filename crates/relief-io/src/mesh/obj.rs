//! Reader of Wavefront OBJ.
//!
//! The parser is our own: errors name lines, text need not be UTF-8, faces with and without texture
//! coordinates may be mixed, and memory is counted as it is taken.

use glam::{Vec2, Vec3};
use relief_core::mesh::RawCorner;

use super::builder::Builder;
use super::text::{number, shown};
use crate::ReadProblem;
use crate::text::{line_len, without_mark};

const FORMAT: &str = "OBJ";

/// Statements other than faces, which show nothing.
#[derive(Default)]
struct Others {
    lines_or_points: bool,
    curves: bool,
}

/// Statements with names, in which `#` does not begin a comment.
const NAMING: [&[u8]; 5] = [b"usemtl", b"mtllib", b"o", b"g", b"usemap"];

pub(super) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), ReadProblem> {
    let bytes = without_mark(bytes)?;
    let totals = totals(bytes);
    let mut corners = Vec::new();
    let (mut faces, mut others) = (0usize, Others::default());
    for (line, mut words) in lines(bytes) {
        match words.next() {
            Some(b"v") => {
                let [x, y, z] = numbers(line, &mut words, 3)?;
                builder.position(Vec3::new(x, y, z))?;
            }
            Some(b"vt") => {
                let [u, v, _] = numbers(line, &mut words, 1)?;
                builder.uv(Vec2::new(u, 1.0 - v))?;
            }
            Some(b"vn") => {
                let [x, y, z] = numbers(line, &mut words, 3)?;
                builder.normal(Vec3::new(x, y, z))?;
            }
            Some(b"l" | b"p") => others.lines_or_points = true,
            Some(b"curv" | b"curv2" | b"surf") => others.curves = true,
            _ => {}
        }
    }
    // Faces may refer to later vertices, so they are read in a second pass.
    let mut so_far = [0; 3];
    for (line, mut words) in lines(bytes) {
        match words.next() {
            Some(b"v") => so_far[0] += 1,
            Some(b"vt") => so_far[1] += 1,
            Some(b"vn") => so_far[2] += 1,
            Some(b"f") => {
                corners.clear();
                for word in words {
                    Builder::check_corners(corners.len() + 1)?;
                    corners.push(corner(line, word, so_far, totals)?);
                }
                if corners.len() < 3 {
                    let what = format!("line {line}: a face of {} corners", corners.len());
                    return Err(ReadProblem::damaged(FORMAT, what));
                }
                builder.face(&corners)?;
                faces += 1;
            }
            _ => {}
        }
    }
    if faces > 0 {
        return Ok(());
    }
    if others.curves {
        let what = "curved surfaces".to_owned();
        return Err(ReadProblem::Unsupported { what, advice: "export it as polygons" });
    }
    let but = if others.lines_or_points { ", only lines and points" } else { "" };
    Err(ReadProblem::damaged(FORMAT, format!("it has no faces{but}")))
}

/// Numbers of positions, texture coordinates and normals in a file.
fn totals(bytes: &[u8]) -> [usize; 3] {
    let mut totals = [0; 3];
    for (_, mut words) in lines(bytes) {
        match words.next() {
            Some(b"v") => totals[0] += 1,
            Some(b"vt") => totals[1] += 1,
            Some(b"vn") => totals[2] += 1,
            _ => {}
        }
    }
    totals
}

/// Iterates over the lines as words, with their numbers from 1. A line that ends in a backslash
/// continues in the next one. A comment begins with `#` and ends with its line.
fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, impl Iterator<Item = &[u8]>)> {
    let (mut rest, mut number) = (bytes, 1);
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let (mut end, first) = (0, number);
        loop {
            let from = end;
            end += line_len(&rest[from..]);
            number += 1;
            if end == rest.len() || !without_comment(&rest[from..end]).trim_ascii_end().ends_with(b"\\") {
                break;
            }
        }
        let (line, after) = rest.split_at(end);
        rest = after;
        // Names of files contain backslashes, too, but are not read.
        let words = without_comment(line).split(|byte| byte.is_ascii_whitespace() || *byte == b'\\');
        Some((first, words.filter(|word| !word.is_empty())))
    })
}

/// Returns a line up to its comment.
fn without_comment(line: &[u8]) -> &[u8] {
    let Some(comment) = line.iter().position(|&byte| byte == b'#') else { return line };
    let statement = line.trim_ascii_start().split(u8::is_ascii_whitespace).next().unwrap_or_default();
    if NAMING.contains(&statement) { line } else { &line[..comment] }
}

/// Reads up to three numbers, at least `least`. Anything behind them, such as colours, is ignored.
fn numbers<'a>(
    line: usize,
    words: &mut impl Iterator<Item = &'a [u8]>,
    least: usize,
) -> Result<[f32; 3], ReadProblem> {
    let mut found = [0.0; 3];
    for (at, place) in found.iter_mut().enumerate() {
        match words.next() {
            Some(word) => *place = number(FORMAT, line, word)?,
            None if at < least => {
                let what = format!("line {line}: {at} numbers, but at least {least} are needed");
                return Err(ReadProblem::damaged(FORMAT, what));
            }
            None => break,
        }
    }
    Ok(found)
}

/// Parses a corner `position/uv/normal`; the last two may be missing.
fn corner(
    line: usize,
    word: &[u8],
    so_far: [usize; 3],
    totals: [usize; 3],
) -> Result<RawCorner, ReadProblem> {
    let wrong = |what: &str| {
        ReadProblem::damaged(FORMAT, format!("line {line}: the corner '{}' {what}", shown(word)))
    };
    let mut places = [RawCorner::NONE; 3];
    for (at, part) in word.split(|&byte| byte == b'/').enumerate() {
        if at >= 3 {
            return Err(wrong("has more than three parts"));
        }
        if part.is_empty() {
            continue;
        }
        let text = std::str::from_utf8(part).ok();
        let index: i64 = text.and_then(|text| text.parse().ok()).ok_or_else(|| wrong("is not a number"))?;
        // Negative indices count back from the last one so far.
        let place = if index < 0 { (so_far[at] as i64).checked_add(index) } else { index.checked_sub(1) };
        let place = place.and_then(|place| u32::try_from(place).ok());
        let place = place.filter(|&place| (place as usize) < totals[at]);
        let name = ["position", "texture coordinates", "normal"][at];
        places[at] = place.ok_or_else(|| {
            wrong(&format!("refers to a {name} that does not exist (the file has {})", totals[at]))
        })?;
    }
    let [position, uv, normal] = places;
    if position == RawCorner::NONE {
        return Err(wrong("has no position"));
    }
    Ok(RawCorner { position, normal, uv })
}
