//! Reader of the numbers after the header of a PLY.

use super::damaged;
use super::header::{Element, Encoding, Header, Property, Scalar};
use crate::ReadProblem;
use crate::mesh::text::{Words, shown};

/// Numbers that remain to be read.
#[derive(Clone)]
pub(super) enum Values<'a> {
    Text(Words<'a>),
    Binary { rest: &'a [u8], big_endian: bool },
}

impl<'a> Values<'a> {
    pub fn new(header: &Header, bytes: &'a [u8]) -> Self {
        let rest = &bytes[header.len..];
        match header.encoding {
            Encoding::Text => Values::Text(Words::new(rest, header.lines + 1)),
            Encoding::LittleEndian => Values::Binary { rest, big_endian: false },
            Encoding::BigEndian => Values::Binary { rest, big_endian: true },
        }
    }

    /// Refuses an element that claims more than the rest of the file can hold.
    pub fn check_element(&self, element: &Element) -> Result<(), ReadProblem> {
        let least = element.properties.iter().map(|property| self.least_bytes(property)).sum::<u64>();
        // The last number of a text file needs no separator.
        if element.count.saturating_mul(least) > self.left().saturating_add(1) {
            let name = shown(&element.name);
            let what = format!("its header says {} of '{name}', more than the file can hold", element.count);
            return Err(damaged(what));
        }
        Ok(())
    }

    fn least_bytes(&self, property: &Property) -> u64 {
        match self {
            // A digit and a separator.
            Values::Text(_) => 2,
            Values::Binary { .. } => property.list.unwrap_or(property.scalar).bytes() as u64,
        }
    }

    fn left(&self) -> u64 {
        match self {
            Values::Text(words) => words.left() as u64,
            Values::Binary { rest, .. } => rest.len() as u64,
        }
    }

    /// Reads a property and passes each of its numbers to `each`.
    pub fn property(
        &mut self,
        property: &Property,
        mut each: impl FnMut(f64) -> Result<(), ReadProblem>,
    ) -> Result<(), ReadProblem> {
        let Some(length) = property.list else {
            return each(self.number(property.scalar)?);
        };
        let length = self.number(length)?;
        if !(length >= 0.0 && length.fract() == 0.0) {
            return Err(damaged(format!("a list has the length {length}")));
        }
        // A list longer than the file ends in an error.
        for _ in 0..length as u64 {
            each(self.number(property.scalar)?)?;
        }
        Ok(())
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadProblem> {
        match self {
            Values::Text(words) => {
                let word = words.next().ok_or_else(|| damaged("it ends too early"))?;
                let text = std::str::from_utf8(word).ok();
                text.and_then(|text| text.parse().ok()).ok_or_else(|| {
                    damaged(format!("line {}: '{}' is not a number", words.line(), shown(word)))
                })
            }
            Values::Binary { rest, big_endian } => {
                let (bytes, after) =
                    rest.split_at_checked(scalar.bytes()).ok_or_else(|| damaged("it ends too early"))?;
                *rest = after;
                // Numbers are stored at the end of these eight bytes, the highest byte first.
                let mut wide = [0; 8];
                let place = &mut wide[8 - bytes.len()..];
                place.copy_from_slice(bytes);
                if !*big_endian {
                    place.reverse();
                }
                Ok(decoded(scalar, wide))
            }
        }
    }
}

/// Decodes the number in the last bytes of eight, the highest byte first.
fn decoded(scalar: Scalar, wide: [u8; 8]) -> f64 {
    let bits = u64::from_be_bytes(wide);
    match scalar {
        Scalar::I8 => f64::from(bits as u8 as i8),
        Scalar::U8 => f64::from(bits as u8),
        Scalar::I16 => f64::from(bits as u16 as i16),
        Scalar::U16 => f64::from(bits as u16),
        Scalar::I32 => f64::from(bits as u32 as i32),
        Scalar::U32 => f64::from(bits as u32),
        Scalar::F32 => f64::from(f32::from_bits(bits as u32)),
        Scalar::F64 => f64::from_bits(bits),
    }
}
