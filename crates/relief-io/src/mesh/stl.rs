//! Reader of STL, as text and binary.
//!
//! Numbers in STL have no unit. They are read and written as millimetres, as in nearly all programs
//! and printers.
//!
//! The parser is our own. Binary files often begin with the word that marks text files; only their
//! length tells them apart. Normals are not used: they are often wrong or not numbers.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::RawCorner;

use super::builder::Builder;
use super::text::{Words, number, shown};
use crate::ReadProblem;
use crate::text::without_mark;

const FORMAT: &str = "STL";

/// Millimetres per metre.
pub(super) const MILLIMETRES: f64 = 1000.0;

/// Bytes before the triangles of a binary file: a text, and the number of triangles.
const HEADER: usize = 84;

/// Bytes of a triangle: its normal, three corners, and two more.
const TRIANGLE: usize = 50;

/// Memory of a position in the map that merges equal positions.
const BYTES_TO_TELL_APART: u64 = 40;

/// Collects triangles, and stores equal positions once.
struct Triangles<'a> {
    builder: &'a mut Builder,
    places: HashMap<[u32; 3], u32>,
}

impl Triangles<'_> {
    fn add(&mut self, corners: [Vec3; 3]) -> Result<(), ReadProblem> {
        let mut places = [0; 3];
        for (place, corner) in places.iter_mut().zip(corners) {
            let bits = corner.to_array().map(f32::to_bits);
            *place = match self.places.get(&bits) {
                Some(&known) => known,
                None => {
                    self.builder.take(BYTES_TO_TELL_APART)?;
                    let metres = corner.as_dvec3() / DVec3::splat(MILLIMETRES);
                    let new = self.builder.position(metres.as_vec3())?;
                    self.places.insert(bits, new);
                    new
                }
            };
        }
        let none = RawCorner::NONE;
        self.builder.triangle(places.map(|position| RawCorner { position, normal: none, uv: none }))
    }
}

pub(super) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), ReadProblem> {
    let mut triangles = Triangles { builder, places: HashMap::new() };
    let count = bytes.get(HEADER - 4..HEADER).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let binary_len = count.map(|count| HEADER as u64 + TRIANGLE as u64 * u64::from(count));
    if let Some(len) = binary_len.filter(|&len| len == bytes.len() as u64) {
        return binary(bytes, len, &mut triangles);
    }
    let unmarked = without_mark(bytes)?;
    if unmarked.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) {
        return text(unmarked, &mut triangles);
    }
    let len = binary_len.ok_or_else(|| ReadProblem::damaged(FORMAT, "it is shorter than its header"))?;
    binary(bytes, len, &mut triangles)
}

fn binary(bytes: &[u8], len: u64, triangles: &mut Triangles<'_>) -> Result<(), ReadProblem> {
    if (bytes.len() as u64) < len {
        let what = format!("its header says {len} bytes, but the file has {}", bytes.len());
        return Err(ReadProblem::damaged(FORMAT, what));
    }
    let body = &bytes[HEADER..len as usize];
    for (at, triangle) in body.as_chunks::<TRIANGLE>().0.iter().enumerate() {
        let numbers = triangle[..48].as_chunks::<4>().0;
        let corner =
            |first: usize| Vec3::from_array([0, 1, 2].map(|k| f32::from_le_bytes(numbers[first + k])));
        let corners = [corner(3), corner(6), corner(9)];
        if !corners.iter().all(|corner| corner.is_finite()) {
            let what = format!("triangle {at} has a number that is not finite");
            return Err(ReadProblem::damaged(FORMAT, what));
        }
        triangles.add(corners)?;
    }
    Ok(())
}

fn text(bytes: &[u8], triangles: &mut Triangles<'_>) -> Result<(), ReadProblem> {
    let mut words = Words::new(bytes, 1);
    // Corners of the current loop, and whether a solid is open.
    let (mut corners, mut is_open) = (Vec::new(), false);
    while let Some(word) = words.next() {
        let line = words.line();
        match word.to_ascii_lowercase().as_slice() {
            b"solid" => {
                is_open = true;
                words.skip_line();
            }
            b"endsolid" => {
                is_open = false;
                words.skip_line();
            }
            // The normal that follows (its name and three numbers) is not read.
            b"facet" => words.by_ref().take(4).for_each(drop),
            b"outer" => {
                corners.clear();
                words.next();
            }
            b"vertex" if corners.len() < 3 => {
                let mut numbers = [0.0; 3];
                for place in &mut numbers {
                    *place = number(FORMAT, line, words.next().unwrap_or_default())?;
                }
                corners.push(Vec3::from_array(numbers));
            }
            b"endloop" => {
                let three = <[Vec3; 3]>::try_from(corners.as_slice()).map_err(|_| {
                    let what = format!("line {line}: a face of {} corners", corners.len());
                    ReadProblem::damaged(FORMAT, what)
                })?;
                triangles.add(three)?;
                corners.clear();
            }
            b"endfacet" => {}
            other => {
                let what = format!("line {line}: '{}' does not belong there", shown(other));
                return Err(ReadProblem::damaged(FORMAT, what));
            }
        }
    }
    if is_open {
        return Err(ReadProblem::damaged(FORMAT, "it ends too early"));
    }
    Ok(())
}
