//! Reader of glTF 2.0: JSON with buffers beside it or inside, and GLB.
//!
//! The crate `gltf` parses and checks the JSON. Buffers, accessors and nodes are resolved here,
//! since a file may claim any size, name any path and link its nodes in any way.

mod accessor;
pub(super) mod buffers;
mod colors;
pub(super) mod container;
pub(super) mod extras;
mod image;
mod material;
mod nodes;
mod pose;

use ::gltf::mesh::Mode;
use ::gltf::{Document, Error, Node, Primitive, Semantic, json};
use glam::{DMat4, DVec3, Vec2, Vec3};
use relief_core::mesh::RawCorner;

use self::buffers::Buffers;
use self::colors::Colors;
use self::pose::Poses;
use super::builder::Builder;
use crate::{MeshColors, MeshOptions, ReadProblem, Remark, Source, omissions};

const FORMAT: &str = "glTF";

/// Greatest memory for an object, a list and an item after a comma while the JSON is read.
const BYTES_OF_JSON: [(u8, u64); 3] = [(b'{', 1024), (b'[', 320), (b',', 96)];

/// Prefixes of extensions that do not affect positions of triangles, or that are supported.
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
    notes: &mut Vec<Remark>,
) -> Result<Option<MeshColors>, ReadProblem> {
    let (text, binary) = container::split(bytes)?;
    let for_json = take_json(text, builder)?;
    let document = document(text)?;
    let mut buffers = Buffers::new(source, binary, document.buffers().len());
    let mut poses = Poses::new();
    let mut colors = options.colors.then(|| Colors::new(&document, options));
    let (mut triangles, mut others) = (0, false);
    for (node, transform) in nodes::in_scene(&document)? {
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            match primitive.mode() {
                Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => {
                    let placed = (&document, &node, transform);
                    let looks = (&mut poses, colors.as_mut());
                    triangles += add(placed, &primitive, looks, &mut buffers, builder)?;
                }
                _ => others = true,
            }
        }
    }
    if triangles == 0 {
        let but =
            if others { "it has no triangles, only points and lines" } else { "its scene contains no mesh" };
        return Err(damaged(but));
    }
    builder.give_back(for_json);
    if poses.unweighted > 0 {
        let count = poses.unweighted;
        let what = "vertices of its skins have weights that add up to 0: each follows its first joint";
        notes.push(Remark::new(&omissions::UNWEIGHTED, format!("{count} {what}")));
    }
    match colors {
        Some(colors) => colors.finish(&document, &mut buffers, builder, notes),
        None => Ok(None),
    }
}

/// Counts the memory for reading the JSON, and returns it.
fn take_json(text: &[u8], builder: &mut Builder) -> Result<u64, ReadProblem> {
    let count = |wanted: u8| text.iter().filter(|&&byte| byte == wanted).count() as u64;
    let parts = BYTES_OF_JSON.map(|(byte, bytes)| bytes * count(byte));
    let for_json = parts.iter().sum::<u64>() + text.len() as u64;
    builder.take(for_json)?;
    Ok(for_json)
}

/// Parses and checks the JSON.
fn document(text: &[u8]) -> Result<Document, ReadProblem> {
    let mut root: json::Root = json::deserialize::from_slice(text).map_err(damaged)?;
    let is_harmless = |name: &&String| HARMLESS.iter().any(|beginning| name.starts_with(beginning));
    if let Some(name) = root.extensions_required.iter().find(|name| !is_harmless(name)) {
        let name: String = name.chars().take(100).collect();
        let advice = unpacked_by(&name);
        return Err(ReadProblem::Unsupported { what: format!("the extension {name}"), advice });
    }
    root.extensions_required.clear();
    // The check accesses the accessors of positions before it knows that they exist.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut accessors = primitives.flat_map(|primitive| primitive.attributes.values());
    if accessors.any(|accessor| accessor.value() >= root.accessors.len()) {
        return Err(damaged("a primitive refers to an accessor that does not exist"));
    }
    Document::from_json(root).map_err(|error| match error {
        Error::Validation(errors) => {
            let first = errors.first().map(|(path, error)| format!("{path}: {error}"));
            damaged(first.unwrap_or_default())
        }
        other => damaged(other),
    })
}

/// Advice for a file that needs an unsupported extension.
fn unpacked_by(extension: &str) -> &'static str {
    if extension.contains("draco") || extension.contains("meshopt") {
        "unpack it, with `gltf-transform copy in.glb out.glb`, or export it again without compression"
    } else {
        "export it again without this extension"
    }
}

/// Adds the triangles of a primitive of a node, transformed to the world, and returns their number.
fn add(
    (document, node, transform): (&Document, &Node<'_>, DMat4),
    primitive: &Primitive<'_>,
    (poses, mut colors): (&mut Poses, Option<&mut Colors>),
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<usize, ReadProblem> {
    let accessor = primitive.get(&Semantic::Positions);
    let accessor = accessor.ok_or_else(|| damaged("a primitive has no positions"))?;
    let count = accessor.count();
    let mut positions = accessor::floats::<3>(&accessor, buffers, builder)?;
    let beside = |semantic: Semantic| match primitive.get(&semantic) {
        Some(accessor) if accessor.count() != count => {
            Err(damaged(format!("{semantic:?} has {} elements, the positions {count}", accessor.count())))
        }
        accessor => Ok(accessor),
    };
    let normals = beside(Semantic::Normals)?;
    let mut normals =
        normals.map(|accessor| accessor::floats::<3>(&accessor, buffers, builder)).transpose()?;
    pose::morph(node, primitive, &mut positions, normals.as_deref_mut(), buffers, builder)?;
    let uvs = beside(Semantic::TexCoords(0))?;
    let uvs = uvs.map(|accessor| accessor::floats::<2>(&accessor, buffers, builder)).transpose()?;
    let indices = primitive.indices();
    let indices =
        indices.map(|accessor| accessor::indices(&accessor, count, buffers, builder)).transpose()?;

    let of_primitive = match &mut colors {
        Some(colors) => Some(colors.of_primitive(primitive, count, buffers, builder)?),
        None => None,
    };
    let transforms = poses.transforms(document, (node, transform), (primitive, count), buffers, builder)?;
    let mut first = None;
    for (at, position) in positions.iter().enumerate() {
        let turned = transforms.of(at);
        let position = builder.position(turned.position(*position).as_vec3())?;
        let normal = match &normals {
            Some(normals) => builder.normal(unit(turned.normal(normals[at])))?,
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
        // A repeated index in a strip makes a triangle without an area, which joins its neighbours.
        if primitive.mode() == Mode::TriangleStrip && (a == b || b == c || c == a) {
            continue;
        }
        added += 1;
        let [a, b, c] = if transforms.of(a).is_mirrored { [a, c, b] } else { [a, b, c] };
        if let (Some(colors), Some(of)) = (&mut colors, &of_primitive) {
            colors.triangle(of, [a, b, c], builder)?;
        }
        builder.triangle([a, b, c].map(corner))?;
    }
    let lists =
        [Some(3 * count), normals.map(|_| 3 * count), uvs.map(|_| 2 * count), indices.map(|list| list.len())];
    builder.give_back(of_primitive.map_or(0, |of| of.bytes()));
    builder.give_back(transforms.bytes());
    builder
        .give_back(lists.into_iter().flatten().map(|numbers| size_of::<f32>() as u64 * numbers as u64).sum());
    Ok(added)
}

/// Returns the unit vector. A vector without direction stays as it is, which marks the normal as
/// missing or invalid.
fn unit(vector: DVec3) -> Vec3 {
    vector.try_normalize().unwrap_or(vector).as_vec3()
}
