//! Reader of what materials say in the JSON alone: program-specific keys (`extras`) and values.

use std::collections::BTreeMap;
use std::io::Read;

use ::gltf::Material;
use ::gltf::json::{Value, deserialize, serialize};
use ::gltf::mesh::Mode;

use super::material::{has_maps, values_of};
use super::{container, damaged, document, nodes, take_json};
use crate::mesh::builder::Builder;
use crate::{ReadProblem, Source};

/// Bytes of a GLB before the text of its JSON, including the JSON's length and type.
pub(in crate::mesh) const BEFORE_JSON: usize = 20;

/// Returns the JSON under `name` in the extras of the triangles' materials, as text.
pub(in crate::mesh) fn read(
    source: Source<'_>,
    name: &str,
    builder: &mut Builder,
) -> Result<Option<String>, ReadProblem> {
    let mut values = each_material(source, builder, |material| value(material, name))?.into_iter();
    let Some(first) = values.next() else { return Ok(None) };
    if values.any(|value| value != first) {
        let what = format!("a mesh of several materials with different extras.{name}");
        return Err(ReadProblem::Unsupported { what, advice: "export a file for each material" });
    }
    first.map(|value| serialize::to_string(&value).map_err(damaged)).transpose()
}

/// Returns the JSON under `name` in the extras of the first node with a mesh that has it, as text.
pub(in crate::mesh) fn read_of_nodes(
    source: Source<'_>,
    name: &str,
    builder: &mut Builder,
) -> Result<Option<String>, ReadProblem> {
    let text = text_of(source, builder)?;
    take_json(&text, builder)?;
    let document = document(&text)?;
    for (node, _) in nodes::in_scene(&document)? {
        let Some(extras) = node.extras().as_ref().filter(|_| node.mesh().is_some()) else { continue };
        let extras: Value = deserialize::from_str(extras.get()).map_err(damaged)?;
        if let Some(value) = extras.get(name) {
            return Ok(Some(serialize::to_string(value).map_err(damaged)?));
        }
    }
    Ok(None)
}

/// Returns whether a material of the triangles needs shading by roughness and metalness.
pub(in crate::mesh) fn needs_roughness(
    source: Source<'_>,
    builder: &mut Builder,
) -> Result<bool, ReadProblem> {
    let needs = |material: &Material<'_>| Ok(values_of(material)?.needs_roughness(has_maps(material)));
    Ok(each_material(source, builder, needs)?.contains(&true))
}

/// Returns what `value` gives for each material of the triangles, in the order of the file.
fn each_material<T>(
    source: Source<'_>,
    builder: &mut Builder,
    value: impl Fn(&Material<'_>) -> Result<T, ReadProblem>,
) -> Result<Vec<T>, ReadProblem> {
    let text = text_of(source, builder)?;
    take_json(&text, builder)?;
    let document = document(&text)?;
    let mut of_materials = BTreeMap::new();
    for (node, _) in nodes::in_scene(&document)? {
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            let is_of_triangles =
                matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan);
            let material = primitive.material();
            if is_of_triangles && !of_materials.contains_key(&material.index()) {
                of_materials.insert(material.index(), value(&material)?);
            }
        }
    }
    Ok(of_materials.into_values().collect())
}

/// Returns the value under `name` in a material's extras.
fn value(material: &Material<'_>, name: &str) -> Result<Option<Value>, ReadProblem> {
    let Some(extras) = material.extras() else { return Ok(None) };
    let mut extras: Value = deserialize::from_str(extras.get()).map_err(damaged)?;
    Ok(extras.get_mut(name).map(Value::take))
}

/// Reads the text of the JSON. Of a valid GLB nothing else is read.
fn text_of(source: Source<'_>, builder: &mut Builder) -> Result<Vec<u8>, ReadProblem> {
    let (mut reader, len) = source.open()?;
    let mut head = Vec::new();
    reader.by_ref().take(BEFORE_JSON as u64).read_to_end(&mut head)?;
    let fits = |json: &u64| len >= BEFORE_JSON as u64 + json;
    if let Some(json) = container::json_len(&head).filter(fits) {
        builder.take(json)?;
        let mut text = Vec::new();
        reader.take(json).read_to_end(&mut text)?;
        return Ok(text);
    }
    let bytes = source.whole(|len| builder.take(len))?;
    Ok(container::split(&bytes)?.0.to_vec())
}
