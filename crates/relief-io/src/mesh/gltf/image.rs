//! Pictures of a glTF.

use ::gltf::{Document, Texture};

use super::buffers::Buffers;
use super::damaged;
use crate::mesh::builder::Builder;
use crate::omissions::ORIENTATION_IN_GLTF;
use crate::picture::read_gltf_picture;
use crate::{Curve, Picture, ReadProblem, Remark, Source};

/// Extensions by which a texture refers to a picture in another format, and whether that is
/// supported.
const SOURCES: [(&str, bool); 4] = [
    ("EXT_texture_webp", true),
    ("KHR_texture_basisu", false),
    ("EXT_texture_avif", false),
    ("MSFT_texture_dds", false),
];

/// Source of a texture's picture.
pub enum Image {
    /// Number of an image in a supported format.
    Read(usize),
    /// The image is in an unsupported format, which the extension names.
    LeftOut(&'static str),
    /// There is no image, which glTF allows.
    None,
}

impl Image {
    /// Finds the image of a texture: an extension's if its format is supported, otherwise the plain
    /// one.
    pub fn of(texture: &Texture<'_>) -> Image {
        let by_extension = |name: &str| texture.extension_value(name)?.get("source")?.as_u64();
        let known = SOURCES.iter().filter(|(_, is_read)| *is_read);
        if let Some(source) = known.filter_map(|(name, _)| by_extension(name)).next() {
            return Image::Read(usize::try_from(source).unwrap_or(usize::MAX));
        }
        if let Some(image) = texture.source() {
            return Image::Read(image.index());
        }
        let unread = SOURCES.iter().find(|(name, _)| texture.extension_value(name).is_some());
        unread.map_or(Image::None, |(name, _)| Image::LeftOut(name))
    }
}

/// Reads the image with the given number, and decodes its colours by `curve`.
pub fn read(
    document: &Document,
    (number, curve): (usize, Curve),
    buffers: &mut Buffers<'_>,
    builder: &mut Builder,
) -> Result<Picture, ReadProblem> {
    let image = document.as_json().images.get(number);
    let image = image.ok_or_else(|| damaged(format!("image {number} does not exist")))?;
    let name = format!("image {number}");
    let view = image.buffer_view.and_then(|view| document.views().nth(view.value()));
    let bytes = match (view, &image.uri) {
        (Some(view), _) => buffers.view(&view, builder)?.to_vec(),
        (None, Some(uri)) => buffers.named(&name, uri, builder)?.into_owned(),
        (None, None) => return Err(damaged(format!("{name} has no bytes"))),
    };
    let read = read_gltf_picture(Source::bytes(&name, &bytes), curve, builder.left());
    let (picture, is_turned) = read
        .map_err(|error| ReadProblem::Part { file: error.path.clone(), problem: Box::new(error.problem) })?;
    if is_turned {
        let what = "has an orientation, which viewers of glTF ignore: it is read as it is stored";
        builder.notes.push(Remark::new(&ORIENTATION_IN_GLTF, format!("{name} {what}")));
    }
    builder.take(size_of_val(&picture.texels[..]) as u64)?;
    Ok(picture)
}
