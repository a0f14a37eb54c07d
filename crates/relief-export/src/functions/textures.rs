//! A texture is a plain one where a single layer of it is read.

use std::collections::BTreeSet;

use super::reduce::Values;
use super::syntax::{Expression, ItemKind, Unit, change_expressions, visit_expressions};

const LAYERS: &str = "texture_2d_array<f32>";
const PLAIN: &str = "texture_2d<f32>";

/// Functions that read a texture, and the place of the layer among their arguments.
const READERS: [(&str, usize); 2] = [("textureLoad", 2), ("textureSampleLevel", 3)];

/// Makes textures of one layer plain.
pub fn flatten(unit: &mut Unit) {
    let values = Values::of(unit);
    let mut flat: BTreeSet<String> =
        unit.variables().filter(|of| of.of == LAYERS).map(|of| of.name.clone()).collect();
    let zero = |layer: &Expression| {
        values.value(layer).map(|value| value.literal()) == Some(Expression::literal("0"))
    };
    for function in unit.functions() {
        visit_expressions(&function.body, &mut |part| {
            if let Some((texture, layer)) = layer_of(part)
                && !zero(layer)
            {
                flat.remove(texture);
            }
            // Its layers are counted.
            if let Expression::Call(name, arguments) = part
                && name == "textureNumLayers"
                && let Some(Expression::Name(texture)) = arguments.first()
            {
                flat.remove(texture);
            }
        });
    }
    for function in unit.functions_mut() {
        change_expressions(&mut function.body, &mut |part| {
            if layer_of(part).is_some_and(|(texture, _)| flat.contains(texture))
                && let Expression::Call(name, arguments) = part
                && let Some((_, place)) = READERS.iter().find(|(reader, _)| reader == name)
            {
                arguments.remove(*place);
            }
        });
    }
    for item in &mut unit.items {
        if let ItemKind::Variable(variable) = &mut item.kind
            && flat.contains(&variable.name)
        {
            PLAIN.clone_into(&mut variable.of);
        }
    }
}

/// The texture that a call reads, and the layer.
fn layer_of(part: &Expression) -> Option<(&str, &Expression)> {
    let Expression::Call(name, arguments) = part else { return None };
    let (_, place) = READERS.iter().find(|(reader, _)| reader == name)?;
    match (arguments.first()?, arguments.get(*place)?) {
        (Expression::Name(texture), layer) => Some((texture, layer)),
        _ => None,
    }
}
