//! The mutator: bytes, integers, numbers and lines of a valid input are changed, the same ones for the same
//! seed.

use std::ops::Range;

use crate::common::Random;

/// The longest input, in bytes.
const LONGEST: usize = 1 << 16;

/// Bytes at the start of a file that are changed as often as all the others: headers lie there.
const HEADER: usize = 600;

/// Numbers that texts are given in place of theirs.
const NUMBERS: [&str; 16] = [
    "0",
    "-0",
    "1",
    "-1",
    "0.5",
    "2",
    "1e-9",
    "1e9",
    "1e39",
    "-1e999",
    "nan",
    "inf",
    "255",
    "65536",
    "4294967296",
    "99999999999999999999999",
];

/// An input of the corpus after one or more mutations.
pub fn mutated(corpus: &[Vec<u8>], seed: u64) -> Vec<u8> {
    let mut random = Random::new(seed);
    let mut bytes = one_of(corpus, &mut random).map(<[u8]>::to_vec).unwrap_or_default();
    loop {
        mutate(&mut bytes, corpus, &mut random);
        if random.below(2) == 0 {
            break;
        }
    }
    bytes.truncate(LONGEST);
    // Else no change of a PNG would get beyond its checksums.
    if random.below(4) != 0 {
        write_checksums(&mut bytes);
    }
    bytes
}

fn one_of<'a>(corpus: &'a [Vec<u8>], random: &mut Random) -> Option<&'a [u8]> {
    corpus.get(random.below(corpus.len())).map(Vec::as_slice)
}

fn mutate(bytes: &mut Vec<u8>, corpus: &[Vec<u8>], random: &mut Random) {
    if bytes.is_empty() {
        bytes.push(random.below(256) as u8);
    }
    // Most of the other mutations of a text make what is no text of its kind at once.
    let any = random.below(14);
    let mutation = if bytes.is_ascii() { [11, 11, 11, 12, 12, 13, 7, any][random.below(8)] } else { any };
    match mutation {
        0 => flip(bytes, random),
        1 => (0..2 + random.below(16)).for_each(|_| flip(bytes, random)),
        2 => {
            let value = [0, 0xff, b' ', random.below(256) as u8][random.below(4)];
            let run = run(bytes, 32, random);
            bytes[run].fill(value);
        }
        3 => {
            let run = run(bytes, 32, random);
            bytes[run].fill_with(|| random.below(256) as u8);
        }
        4 => bytes.truncate(random.below(bytes.len())),
        5 => drop(bytes.drain(run(bytes, 64, random))),
        6 => {
            let run = run(bytes, 64, random);
            let copies = [1, 1, 2, 7, 300][random.below(5)];
            let copied = bytes[run.clone()].repeat(copies);
            bytes.splice(run.end..run.end, copied);
        }
        7 => {
            let Some(other) = one_of(corpus, random) else { return };
            bytes.truncate(random.below(bytes.len()));
            bytes.extend(&other[random.below(other.len())..]);
        }
        8..=10 => set_integer(bytes, random),
        11 => set_number(bytes, random),
        12 => change_line(bytes, corpus, random),
        _ => {
            let Some(other) = one_of(corpus, random) else { return };
            let from = run(other, 64, random);
            let run = run(bytes, 64, random);
            bytes.splice(run, other[from].iter().copied());
        }
    }
}

/// A place in bytes that are not empty.
fn place(bytes: &[u8], random: &mut Random) -> usize {
    let is_header = random.below(2) == 0;
    random.below(if is_header { bytes.len().min(HEADER) } else { bytes.len() })
}

fn run(bytes: &[u8], longest: usize, random: &mut Random) -> Range<usize> {
    let start = place(bytes, random);
    start..(start + 1 + random.below(longest)).min(bytes.len())
}

fn flip(bytes: &mut [u8], random: &mut Random) {
    let at = place(bytes, random);
    bytes[at] ^= 1 << random.below(8);
}

/// Writes an integer of 1, 2, 4 or 8 bytes at a border of its type, or near the one that was there.
fn set_integer(bytes: &mut [u8], random: &mut Random) {
    let size = (1 << random.below(4)).min(bytes.len());
    let at = place(bytes, random).min(bytes.len() - size);
    let is_big = random.below(2) == 0;
    let place = &mut bytes[at..at + size];
    if is_big {
        place.reverse();
    }
    let old = place.iter().rev().fold(0u64, |value, &byte| value << 8 | u64::from(byte));
    let bits = 8 * size as u32;
    let greatest = u64::MAX >> (64 - bits);
    let value = match random.below(10) {
        0 => 0,
        1 => 1,
        2 => greatest,
        3 => greatest >> 1,
        4 => (greatest >> 1) + 1,
        5 => old.wrapping_add(1),
        6 => old.wrapping_sub(1),
        7 => old.wrapping_mul(2),
        8 => 1 << random.below(bits as usize),
        _ => old ^ greatest,
    };
    place.copy_from_slice(&value.to_le_bytes()[..size]);
    if is_big {
        place.reverse();
    }
}

/// Replaces a number that is written in digits.
fn set_number(bytes: &mut Vec<u8>, random: &mut Random) {
    let from = place(bytes, random);
    let Some(start) = bytes[from..].iter().position(u8::is_ascii_digit).map(|at| from + at) else { return };
    let is_part = |byte: &u8| byte.is_ascii_digit() || b".eE+-".contains(byte);
    let before = bytes[..start].iter().rev().take_while(|byte| is_part(byte)).count();
    let len = bytes[start..].iter().take_while(|byte| is_part(byte)).count();
    let number = NUMBERS[random.below(NUMBERS.len())];
    bytes.splice(start - before..start + len, number.bytes());
}

/// Removes a line, repeats it, or writes a line of another input before it.
fn change_line(bytes: &mut Vec<u8>, corpus: &[Vec<u8>], random: &mut Random) {
    let line = line_at(bytes, place(bytes, random));
    match random.below(3) {
        0 => drop(bytes.drain(line)),
        1 => {
            let copy = bytes[line.clone()].to_vec();
            bytes.splice(line.end..line.end, copy);
        }
        _ => {
            let Some(other) = one_of(corpus, random).filter(|other| !other.is_empty()) else { return };
            let from = line_at(other, random.below(other.len()));
            bytes.splice(line.start..line.start, other[from].iter().copied());
        }
    }
}

/// The line around a place, with its end.
fn line_at(bytes: &[u8], at: usize) -> Range<usize> {
    let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |before| before + 1);
    let end = bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |end| at + end + 1);
    start..end
}

/// Writes the right checksum behind each chunk of a PNG, which may begin at the first or the second byte.
fn write_checksums(bytes: &mut [u8]) {
    const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
    let Some(start) = (0..2).find(|&at| bytes.get(at..).is_some_and(|rest| rest.starts_with(SIGNATURE)))
    else {
        return;
    };
    let mut at = start + SIGNATURE.len();
    while let Some(length) = bytes.get(at..at + 4) {
        let length = length.iter().fold(0, |value, &byte| value << 8 | usize::from(byte));
        let end = at + 8 + length;
        let Some(checked) = bytes.get(at + 4..end) else { break };
        let mut checksum = flate2::Crc::new();
        checksum.update(checked);
        let Some(place) = bytes.get_mut(end..end + 4) else { break };
        place.copy_from_slice(&checksum.sum().to_be_bytes());
        at = end + 4;
    }
}
