//! Reader of a height map's georeference, from its header alone.

use crate::elevation::Elevation;
use crate::height::{BYTES_PER_TEXEL, select};
use crate::image_file::ImageFile;
use crate::{Format, Georeference, HeightNote, HeightOptions, ReadError, ReadProblem, Source};

/// Georeference and units of a height map's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Numbers of columns and rows of the map.
    pub size: [u32; 2],
    /// Lengths of the whole map along `u` and `v` in metres, if the file gives them.
    pub tile_m: Option<[f64; 2]>,
    /// Position of the map on the ground, if the file gives any.
    pub georeference: Option<Georeference>,
    /// Meaning of the values of the channel that is read, if the file is an elevation model.
    pub elevation: Option<Elevation>,
    /// File format.
    pub format: Format,
}

/// Reads the georeference and units of a height map's file, and none of its texels. Options are
/// used as in [`crate::read_height`].
///
/// # Errors
///
/// When the file cannot be read, its header is damaged, or it states an impossible georeference.
pub fn read_ground<'a>(source: impl Into<Source<'a>>, options: &HeightOptions) -> Result<Ground, ReadError> {
    let source = source.into();
    read(source, options).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, options: &HeightOptions) -> Result<Ground, ReadProblem> {
    let file = ImageFile::open(source, options.raw, BYTES_PER_TEXEL, options.max_bytes)?;
    let file = file.in_units(options.unit);
    let layout = file.layout();
    let size = [layout.width, layout.height];
    let terrain = layout.terrain()?;
    let note = HeightNote::of_file(source, layout);
    let of_texel = |[u, v]: [f64; 2]| [u * f64::from(size[0]), v * f64::from(size[1])];
    let tile_m = note.map(|note| note.tile_m).or_else(|| terrain?.texel_size_m().map(of_texel));
    let channel = select(layout, options.channel.as_deref()).ok().map(|selection| selection.first());
    // A note by Relief takes precedence over the georeference.
    let elevation = terrain.filter(|_| note.is_none()).zip(channel);
    Ok(Ground {
        size,
        tile_m,
        georeference: terrain.and_then(|terrain| terrain.georeference.clone()),
        elevation: elevation.map(|(terrain, channel)| terrain.channels[channel].clone()),
        format: layout.format,
    })
}
