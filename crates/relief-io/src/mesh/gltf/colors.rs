//! The colours of a material.

use ::gltf::Document;

use super::buffers::Buffers;
use super::image::{self, Image};
use crate::mesh::builder::Builder;
use crate::{MeshColors, ReadProblem};

/// The base colour of a material, without its picture where texture coordinates are not the file's.
pub(super) fn read(
    document: &Document,
    material: usize,
    is_projected: bool,
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
    notes: &mut Vec<String>,
) -> Result<Option<MeshColors>, ReadProblem> {
    let Some(material) = document.materials().nth(material) else { return Ok(None) };
    let base = material.pbr_metallic_roughness();
    let [red, green, blue, _] = base.base_color_factor();
    let part = |part: f32| if part.is_finite() { part.clamp(0.0, 1.0) } else { 1.0 };
    let factor = [red, green, blue].map(part);
    let Some(texture) = base.base_color_texture() else {
        return Ok(Some(MeshColors { factor, picture: None }));
    };
    let left_out = match Image::of(&texture.texture()) {
        _ if is_projected => Some("texture coordinates are projected".to_owned()),
        _ if texture.tex_coord() != 0 => Some("it lies by other texture coordinates than maps".to_owned()),
        Image::LeftOut(format) => {
            Some(format!("{format} is not read (gltf-transform ktxdecompress unpacks Basis)"))
        }
        Image::None => Some("it has no image".to_owned()),
        Image::Read(_) => None,
    };
    let (Image::Read(number), None) = (Image::of(&texture.texture()), &left_out) else {
        let why = left_out.unwrap_or_default();
        notes.push(format!("the picture of its colours is left out: {why}"));
        return Ok(Some(MeshColors { factor, picture: None }));
    };
    let picture = image::read(document, number, buffers, builder)?;
    Ok(Some(MeshColors { factor, picture: Some(picture) }))
}
