//! Header of a PLY: its encoding, and the elements with their properties.

use super::damaged;
use crate::ReadProblem;
use crate::mesh::text::shown;
use crate::text::line_len;

/// Greatest number of elements of a header, and of properties of an element. Files have a few.
const MOST: usize = 256;

/// Encoding of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// Type of a stored number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn by_name(name: &[u8]) -> Result<Self, ReadProblem> {
        Ok(match name {
            b"char" | b"int8" => Scalar::I8,
            b"uchar" | b"uint8" => Scalar::U8,
            b"short" | b"int16" => Scalar::I16,
            b"ushort" | b"uint16" => Scalar::U16,
            b"int" | b"int32" => Scalar::I32,
            b"uint" | b"uint32" => Scalar::U32,
            b"float" | b"float32" => Scalar::F32,
            b"double" | b"float64" => Scalar::F64,
            other => return Err(damaged(format!("its header has the unknown type '{}'", shown(other)))),
        })
    }

    /// Bytes of a number in a binary file.
    pub const fn bytes(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }
}

/// Property of an element: a number or a list of numbers.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub name: Vec<u8>,
    /// Type of the numbers.
    pub scalar: Scalar,
    /// Type of a list's length; none for a single number.
    pub list: Option<Scalar>,
}

/// Element, which is repeated `count` times after the header.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub name: Vec<u8>,
    pub count: u64,
    pub properties: Vec<Property>,
}

#[derive(Clone, Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Bytes and lines of the header.
    pub len: usize,
    pub lines: usize,
}

impl Header {
    pub fn read(bytes: &[u8]) -> Result<Self, ReadProblem> {
        let (mut encoding, mut elements) = (None, Vec::<Element>::new());
        let (mut at, mut lines) = (0, 0);
        // The first line shows how all lines end; binary numbers after the header may begin with
        // any byte.
        let line_end = match bytes[..line_len(bytes)] {
            [.., b'\r'] => b'\r',
            _ => b'\n',
        };
        loop {
            let rest = &bytes[at..];
            let Some(end) = rest.iter().position(|&byte| byte == line_end) else {
                return Err(damaged(if lines == 0 {
                    "it does not begin with ply"
                } else {
                    "its header has no end"
                }));
            };
            let line = &rest[..end];
            (at, lines) = (at + end + 1, lines + 1);
            let words: Vec<&[u8]> =
                line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).take(6).collect();
            match words.as_slice() {
                [b"ply"] if lines == 1 => {}
                _ if lines == 1 => return Err(damaged("it does not begin with ply")),
                [] | [b"comment" | b"obj_info", ..] => {}
                [b"format", name, ..] => encoding = Some(encoding_of(name)?),
                [b"element", name, count] if elements.len() < MOST => {
                    let count = std::str::from_utf8(count).ok().and_then(|count| count.parse().ok());
                    let count =
                        count.ok_or_else(|| damaged("its header has a count that is not a number"))?;
                    elements.push(Element { name: name.to_vec(), count, properties: Vec::new() });
                }
                [b"property", of_type @ ..] => {
                    let element = elements.last_mut().filter(|element| element.properties.len() < MOST);
                    let element =
                        element.ok_or_else(|| damaged("its header has a property without an element"))?;
                    element.properties.push(property(of_type)?);
                }
                [b"end_header"] => break,
                [other, ..] => {
                    let what = format!("line {lines} of its header, '{}', cannot be read", shown(other));
                    return Err(damaged(what));
                }
            }
        }
        let encoding = encoding.ok_or_else(|| damaged("its header names no format"))?;
        Ok(Self { encoding, elements, len: at, lines })
    }
}

fn encoding_of(name: &[u8]) -> Result<Encoding, ReadProblem> {
    match name {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::LittleEndian),
        b"binary_big_endian" => Ok(Encoding::BigEndian),
        other => Err(damaged(format!("its header names the unknown format '{}'", shown(other)))),
    }
}

fn property(of_type: &[&[u8]]) -> Result<Property, ReadProblem> {
    match of_type {
        [b"list", length, scalar, name] => Ok(Property {
            name: name.to_vec(),
            scalar: Scalar::by_name(scalar)?,
            list: Some(Scalar::by_name(length)?),
        }),
        [scalar, name] => Ok(Property { name: name.to_vec(), scalar: Scalar::by_name(scalar)?, list: None }),
        _ => Err(damaged("its header has a property without a type or a name")),
    }
}
