//! The colours of a material.

use ::gltf::Document;

use super::buffers::Buffers;
use super::damaged;
use crate::mesh::builder::Builder;
use crate::{MeshColors, ReadProblem, Source, read_picture};

/// The base colour of a material, without its picture where texture coordinates are not the file's.
pub(super) fn read(
    document: &Document,
    material: usize,
    is_projected: bool,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<Option<MeshColors>, ReadProblem> {
    let Some(material) = document.materials().nth(material) else { return Ok(None) };
    let base = material.pbr_metallic_roughness();
    let [red, green, blue, _] = base.base_color_factor();
    let part = |part: f32| if part.is_finite() { part.clamp(0.0, 1.0) } else { 1.0 };
    let factor = [red, green, blue].map(part);
    let texture = base.base_color_texture().filter(|texture| texture.tex_coord() == 0 && !is_projected);
    let Some(texture) = texture else { return Ok(Some(MeshColors { factor, picture: None })) };

    let number = texture.texture().source().index();
    let image = document.as_json().images.get(number);
    let image = image.ok_or_else(|| damaged(format!("image {number} is not there")))?;
    let name = format!("image {number}");
    let view = image.buffer_view.and_then(|view| document.views().nth(view.value()));
    let bytes = match (view, &image.uri) {
        (Some(view), _) => buffers.view(&view, builder)?.to_vec(),
        (None, Some(uri)) => buffers.named(&name, uri, builder)?.into_owned(),
        (None, None) => return Err(damaged(format!("{name} has no bytes"))),
    };
    let picture = read_picture(Source::bytes(&name, &bytes), builder.left());
    let picture = picture
        .map_err(|error| ReadProblem::Part { file: error.path.clone(), problem: Box::new(error.problem) })?;
    Ok(Some(MeshColors { factor, picture: Some(picture) }))
}
