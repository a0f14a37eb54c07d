//! glTF 2.0: JSON with buffers beside it or inside, and GLB.
//!
//! The crate `gltf` reads and checks the JSON. Buffers, accessors and nodes are resolved here, since a file
//! may claim any size, name any path and tie its nodes to any knot.

mod accessor;
pub(super) mod buffers;
mod colors;
pub(super) mod container;
pub(super) mod extras;
mod nodes;

use ::gltf::mesh::Mode;
use ::gltf::{Document, Error, Primitive, Semantic, json};
use glam::{DMat3, DMat4, DVec3, Vec2, Vec3};
use relief_core::mesh::RawCorner;

use self::buffers::Buffers;
use super::builder::Builder;
use crate::{MeshColors, MeshOptions, ReadProblem, Source};

const FORMAT: &str = "glTF";

/// Memory that an object, a list and what a comma parts take at most when the JSON is read.
const BYTES_OF_JSON: [(u8, u64); 3] = [(b'{', 1024), (b'[', 320), (b',', 96)];

/// Beginnings of the names of extensions that say nothing of where triangles are, or that are read.
const HARMLESS: [&str; 8] = [
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_lights_",
    "KHR_animation_",
    "KHR_xmp",
    "KHR_mesh_quantization",
    "MSFT_texture_",
];

fn damaged(what: impl ToString) -> ReadProblem {
    ReadProblem::damaged(FORMAT, what)
}

pub(super) fn read(
    source: Source<'_>,
    bytes: &[u8],
    options: &MeshOptions,
    builder: &mut Builder,
) -> Result<Option<MeshColors>, ReadProblem> {
    let (text, binary) = container::split(bytes)?;
    let for_json = take_json(text, builder)?;
    let document = document(text)?;
    let mut buffers = Buffers::new(source, binary, document.buffers().len());
    let (mut triangles, mut others, mut materials) = (0, false, Vec::new());
    for (node, transform) in nodes::placed(&document)? {
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            match primitive.mode() {
                Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => {
                    triangles += add(&primitive, transform, &mut buffers, builder)?;
                    materials.push(primitive.material().index());
                    materials.dedup();
                }
                _ => others = true,
            }
        }
    }
    if triangles == 0 {
        let but =
            if others { "it has no triangles, only points and lines" } else { "its scene shows no mesh" };
        return Err(damaged(but));
    }
    builder.give_back(for_json);
    match materials.as_slice() {
        [Some(material)] if options.colors => {
            colors::read(&document, *material, options.projection.is_some(), &mut buffers, builder)
        }
        _ => Ok(None),
    }
}

/// Takes the memory that reading the JSON takes, and says how much.
fn take_json(text: &[u8], builder: &mut Builder) -> Result<u64, ReadProblem> {
    let count = |wanted: u8| text.iter().filter(|&&byte| byte == wanted).count() as u64;
    let parts = BYTES_OF_JSON.map(|(byte, bytes)| bytes * count(byte));
    let for_json = parts.iter().sum::<u64>() + text.len() as u64;
    builder.take(for_json)?;
    Ok(for_json)
}

/// The checked JSON.
fn document(text: &[u8]) -> Result<Document, ReadProblem> {
    let mut root: json::Root = json::deserialize::from_slice(text).map_err(damaged)?;
    let is_harmless = |name: &&String| HARMLESS.iter().any(|beginning| name.starts_with(beginning));
    if let Some(name) = root.extensions_required.iter().find(|name| !is_harmless(name)) {
        let advice = if name.contains("compression") {
            "export it again without compression"
        } else {
            "export it again without this extension"
        };
        return Err(ReadProblem::Unsupported { what: format!("the extension {name}"), advice });
    }
    root.extensions_required.clear();
    // The check looks at the accessors of positions before it knows that they are there.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut accessors = primitives.flat_map(|primitive| primitive.attributes.values());
    if accessors.any(|accessor| accessor.value() >= root.accessors.len()) {
        return Err(damaged("a primitive names an accessor that is not there"));
    }
    Document::from_json(root).map_err(|error| match error {
        Error::Validation(errors) => {
            let first = errors.first().map(|(path, error)| format!("{path}: {error}"));
            damaged(first.unwrap_or_default())
        }
        other => damaged(other),
    })
}

/// Adds the triangles of a primitive and says how many they are.
fn add(
    primitive: &Primitive<'_>,
    transform: DMat4,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<usize, ReadProblem> {
    let accessor = primitive.get(&Semantic::Positions);
    let accessor = accessor.ok_or_else(|| damaged("a primitive has no positions"))?;
    let count = accessor.count();
    let positions = accessor::floats::<3>(&accessor, buffers, builder)?;
    let beside = |semantic: Semantic| match primitive.get(&semantic) {
        Some(accessor) if accessor.count() != count => {
            Err(damaged(format!("{semantic:?} has {} elements, the positions {count}", accessor.count())))
        }
        accessor => Ok(accessor),
    };
    let normals = beside(Semantic::Normals)?;
    let normals = normals.map(|accessor| accessor::floats::<3>(&accessor, buffers, builder)).transpose()?;
    let uvs = beside(Semantic::TexCoords(0))?;
    let uvs = uvs.map(|accessor| accessor::floats::<2>(&accessor, buffers, builder)).transpose()?;
    let indices = primitive.indices();
    let indices =
        indices.map(|accessor| accessor::indices(&accessor, count, buffers, builder)).transpose()?;

    let linear = DMat3::from_mat4(transform);
    // The transposed inverse but for a factor, which is finite where there is no inverse.
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let is_mirrored = linear.determinant() < 0.0;
    let sign = if is_mirrored { -1.0 } else { 1.0 };
    let of_normals = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * sign;
    let mut first = None;
    for (at, position) in positions.iter().enumerate() {
        let placed = transform.transform_point3(DVec3::from(position.map(f64::from)));
        let position = builder.position(placed.as_vec3())?;
        let normal = match &normals {
            Some(normals) => {
                let turned = of_normals * DVec3::from(normals[at].map(f64::from));
                builder.normal(unit(turned))?
            }
            None => RawCorner::NONE,
        };
        let uv = match &uvs {
            Some(uvs) => builder.uv(Vec2::from(uvs[at]))?,
            None => RawCorner::NONE,
        };
        first = first.or(Some(RawCorner { position, normal, uv }));
    }
    let Some(first) = first else { return Ok(0) };
    let corner = |index: usize| {
        let place = |first: u32| if first == RawCorner::NONE { first } else { first + index as u32 };
        RawCorner { position: place(first.position), normal: place(first.normal), uv: place(first.uv) }
    };
    let index = |at: usize| indices.as_ref().map_or(at, |indices| indices[at] as usize);
    let length = indices.as_ref().map_or(count, Vec::len);
    let triangles = match primitive.mode() {
        Mode::Triangles => length / 3,
        _ => length.saturating_sub(2),
    };
    let mut added = 0;
    for triangle in 0..triangles {
        let [a, b, c] = match primitive.mode() {
            Mode::Triangles => [3 * triangle, 3 * triangle + 1, 3 * triangle + 2],
            Mode::TriangleFan => [triangle + 1, triangle + 2, 0],
            // Every second triangle of a strip runs the other way.
            _ if triangle % 2 == 1 => [triangle + 1, triangle, triangle + 2],
            _ => [triangle, triangle + 1, triangle + 2],
        };
        let [a, b, c] = [a, b, c].map(index);
        // An index that a strip names twice joins what is beside it.
        if primitive.mode() == Mode::TriangleStrip && (a == b || b == c || c == a) {
            continue;
        }
        added += 1;
        let [a, b, c] = [a, b, c].map(corner);
        builder.triangle(if is_mirrored { [a, c, b] } else { [a, b, c] })?;
    }
    let lists =
        [Some(3 * count), normals.map(|_| 3 * count), uvs.map(|_| 2 * count), indices.map(|list| list.len())];
    builder
        .give_back(lists.into_iter().flatten().map(|numbers| size_of::<f32>() as u64 * numbers as u64).sum());
    Ok(added)
}

/// The unit vector; of no direction as it is, which says that a normal is missing or no number.
fn unit(vector: DVec3) -> Vec3 {
    vector.try_normalize().unwrap_or(vector).as_vec3()
}
