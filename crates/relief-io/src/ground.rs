//! What the header of a height map's file says of the ground.

use crate::elevation::Elevation;
use crate::height::{BYTES_PER_TEXEL, select};
use crate::image_file::ImageFile;
use crate::{Format, Georeference, HeightNote, HeightOptions, ReadError, ReadProblem, Source};

/// What a height map's file says of the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Columns and rows of the map.
    pub size: [u32; 2],
    /// Length of the whole map along `u` and `v` in metres, where the file says it.
    pub tile_m: Option<[f64; 2]>,
    /// Where the map lies, where the file says anything of it.
    pub georeference: Option<Georeference>,
    /// What the values of the channel that is read stand for, where the file is an elevation model.
    pub elevation: Option<Elevation>,
    /// The format of the file.
    pub format: Format,
}

/// Reads what a height map's file says of the ground, and none of its texels. Options are used as in
/// [`crate::read_height`].
///
/// # Errors
///
/// When the file cannot be read, its header is damaged, or it says of itself what cannot be.
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
    // What Relief notes of a map comes before what is said of the ground.
    let elevation = terrain.filter(|_| note.is_none()).zip(channel);
    Ok(Ground {
        size,
        tile_m,
        georeference: terrain.and_then(|terrain| terrain.georeference.clone()),
        elevation: elevation.map(|(terrain, channel)| terrain.channels[channel].clone()),
        format: layout.format,
    })
}
