//! Reader of PLY, as text and binary of either byte order.
//!
//! The parser is our own: claims of the header are checked against the file's length, only data for
//! meshes is stored, and memory is counted as it is taken.

mod header;
mod values;

use glam::{Vec2, Vec3};
use relief_core::mesh::RawCorner;

use self::header::{Element, Header, Property};
use self::values::Values;
use super::builder::Builder;
use crate::ReadProblem;
use crate::text::without_mark;

const FORMAT: &str = "PLY";

/// Properties of a vertex that are read, with the names that programs use: position, normal,
/// texture coordinates.
const OF_VERTEX: [&[&str]; 8] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx"],
    &["ny"],
    &["nz"],
    &["u", "s", "texture_u", "texture_s"],
    &["v", "t", "texture_v", "texture_t"],
];

/// Names of the list of a face's vertices.
const VERTICES: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Name of the list of a face's texture coordinates, two for each vertex.
const TEXTURE: &str = "texcoord";

pub(super) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), ReadProblem> {
    let bytes = without_mark(bytes)?;
    let header = Header::read(bytes)?;
    let mut values = Values::new(&header, bytes);
    let mut vertices = None;
    // Faces that come before their vertices, with their numbers.
    let mut waiting: Vec<(&Element, Values<'_>)> = Vec::new();
    let mut faces = 0;
    for element in &header.elements {
        values.check_element(element)?;
        match element.name.as_slice() {
            b"vertex" if vertices.is_none() => {
                let read = *vertices.insert(read_vertices(element, &mut values, builder)?);
                for (element, mut values) in waiting.drain(..) {
                    read_faces(element, &mut values, read, builder)?;
                }
            }
            b"face" => {
                faces += element.count;
                match vertices {
                    Some(vertices) => read_faces(element, &mut values, vertices, builder)?,
                    None => {
                        waiting.push((element, values.clone()));
                        skip(element, &mut values)?;
                    }
                }
            }
            b"tristrips" => {
                let what = "triangle strips".to_owned();
                return Err(ReadProblem::Unsupported { what, advice: "export it with faces" });
            }
            _ => skip(element, &mut values)?,
        }
    }
    if faces == 0 {
        return Err(damaged("it has no faces, only points"));
    }
    if vertices.is_none() {
        return Err(damaged("it has no vertices"));
    }
    Ok(())
}

fn damaged(what: impl ToString) -> ReadProblem {
    ReadProblem::damaged(FORMAT, what)
}

fn skip(element: &Element, values: &mut Values<'_>) -> Result<(), ReadProblem> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            values.property(property, |_| Ok(()))?;
        }
    }
    Ok(())
}

/// Number of vertices, and the attributes that they have.
#[derive(Clone, Copy)]
struct Vertices {
    count: u32,
    normals: bool,
    uvs: bool,
}

fn read_vertices(
    element: &Element,
    values: &mut Values<'_>,
    builder: &mut Builder,
) -> Result<Vertices, ReadProblem> {
    let place = |property: &Property| {
        let is_name = |names: &&[&str]| names.iter().any(|name| name.as_bytes() == property.name);
        OF_VERTEX.iter().position(is_name).filter(|_| property.list.is_none())
    };
    let places: Vec<Option<usize>> = element.properties.iter().map(place).collect();
    let has = |range: std::ops::Range<usize>| range.into_iter().all(|at| places.contains(&Some(at)));
    if !has(0..3) {
        return Err(damaged("its vertices have no x, y and z"));
    }
    let count = u32::try_from(element.count).map_err(|_| damaged("it has too many vertices"))?;
    let vertices = Vertices { count, normals: has(3..6), uvs: has(6..8) };
    for _ in 0..count {
        let mut numbers = [0.0f32; OF_VERTEX.len()];
        for (property, place) in element.properties.iter().zip(&places) {
            values.property(property, |value| {
                if let Some(place) = place {
                    numbers[*place] = value as f32;
                }
                Ok(())
            })?;
        }
        let [x, y, z, nx, ny, nz, u, v] = numbers;
        builder.position(Vec3::new(x, y, z))?;
        if vertices.normals {
            builder.normal(Vec3::new(nx, ny, nz))?;
        }
        if vertices.uvs {
            builder.uv(Vec2::new(u, 1.0 - v))?;
        }
    }
    Ok(vertices)
}

fn read_faces(
    element: &Element,
    values: &mut Values<'_>,
    vertices: Vertices,
    builder: &mut Builder,
) -> Result<(), ReadProblem> {
    let is = |property: &Property, names: &[&str]| {
        property.list.is_some() && names.iter().any(|name| name.as_bytes() == property.name)
    };
    if element.count > 0 && !element.properties.iter().any(|property| is(property, &VERTICES)) {
        return Err(damaged("its faces have no list of vertices"));
    }
    let (mut corners, mut texture) = (Vec::new(), Vec::new());
    for face in 0..element.count {
        corners.clear();
        texture.clear();
        for property in &element.properties {
            if is(property, &VERTICES) {
                values.property(property, |value| {
                    Builder::check_corners(corners.len() + 1)?;
                    corners.push(corner(face, value, vertices)?);
                    Ok(())
                })?;
            } else if is(property, &[TEXTURE]) {
                values.property(property, |value| {
                    Builder::check_corners(texture.len() / 2 + 1)?;
                    texture.push(value as f32);
                    Ok(())
                })?;
            } else {
                values.property(property, |_| Ok(()))?;
            }
        }
        if corners.len() < 3 {
            return Err(damaged(format!("face {face} has {} corners", corners.len())));
        }
        if texture.len() == 2 * corners.len() {
            for (corner, [u, v]) in corners.iter_mut().zip(texture.as_chunks::<2>().0) {
                corner.uv = builder.uv(Vec2::new(*u, 1.0 - v))?;
            }
        }
        builder.face(&corners)?;
    }
    Ok(())
}

fn corner(face: u64, value: f64, vertices: Vertices) -> Result<RawCorner, ReadProblem> {
    if value.fract() != 0.0 || !(0.0..f64::from(vertices.count)).contains(&value) {
        let what = format!("face {face} refers to vertex {value}, but there are {}", vertices.count);
        return Err(damaged(what));
    }
    let position = value as u32;
    let where_it_has = |has: bool| if has { position } else { RawCorner::NONE };
    Ok(RawCorner { position, normal: where_it_has(vertices.normals), uv: where_it_has(vertices.uvs) })
}
