//! Reading and writing of objects: a folder with an `object.toml` and pictures.

mod description;
mod error;
mod write;

use std::path::Path;

use glam::DVec3;
use relief_core::HeightMap;
use relief_core::object::{AtlasLayout, DEFAULT_JUMP_TEXELS, ImageObject, JumpCells};
use relief_io::{
    DEFAULT_MAX_BYTES, GreenSign, NormalMap, Picture, Source, beside_file, read_normal_map, read_picture,
    read_stored_heights,
};

pub use self::description::{Description, ViewEntry, parse_description, read_description, read_views};
pub use self::error::{ObjectFileError, ObjectFileProblem};
pub use self::write::{OBJECT_FILE, ObjectFiles, ObjectWriter, WriteObjectError, check_sheet};

/// Options for reading an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectOptions {
    /// Treatment of cells whose heights jump.
    pub cells: JumpCells,
    /// Difference between a cell's corners above which it jumps, in texels of the coarsest image.
    pub jump_texels: f64,
    /// Most memory that reading may take, in bytes.
    pub max_bytes: u64,
}

impl Default for ObjectOptions {
    fn default() -> Self {
        Self { cells: JumpCells::default(), jump_texels: DEFAULT_JUMP_TEXELS, max_bytes: DEFAULT_MAX_BYTES }
    }
}

/// An object read from files.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectFile {
    /// The object.
    pub object: ImageObject,
    /// Colours in linear light, packed as the heights are by [`ImageObject::layout`]. The edges of
    /// images are repeated around them. Beside all images there is black with an opacity of 0.
    pub color: Option<Picture>,
    /// Normals, packed in the same way, in the tangent space of each image: `x` to the right, `y`
    /// up and `z` toward the viewer. Beside all images they are `(0, 0, 1)`.
    pub normal: Option<NormalMap>,
    /// Differences from the mesh that the object was captured from, if they were measured.
    pub measured: Option<Measured>,
}

/// Differences between an object and a mesh, measured in pictures of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Number of pictures compared.
    pub views: u32,
    /// Side of each picture in pixels.
    pub size: u32,
    /// Treatment of cells whose heights jump in the object compared.
    pub cells: JumpCells,
    /// Difference above which cells jump, in texels.
    pub jump_texels: f64,
    /// Intersection over union: pixels that show both, divided by pixels that show either, over all
    /// pictures.
    pub iou: f64,
    /// Mean distance between both over the pixels that show both, in percent of the ball's
    /// diameter. `None` if no pixel shows both.
    pub depth_error_percent: Option<f64>,
    /// Direction toward the viewer of the picture with the least intersection over union.
    pub worst_from: DVec3,
    /// Least intersection over union of a picture.
    pub worst_iou: f64,
    /// Greatest mean distance of a picture, in percent of the ball's diameter.
    pub worst_depth_error_percent: Option<f64>,
}

impl Measured {
    /// Whether this is nearer to the mesh than another. The greater intersection over union
    /// decides; if these are equal, the smaller mean distance.
    pub fn is_nearer_than(&self, other: &Self) -> bool {
        let apart = |measured: &Self| measured.depth_error_percent.unwrap_or(f64::INFINITY);
        self.iou.total_cmp(&other.iou).then(apart(other).total_cmp(&apart(self))).is_gt()
    }
}

/// Bytes per texel of an atlas of heights, of colours and of normals.
const TEXEL_BYTES: [u64; 3] = [4, 16, 12];

/// Reads an object from its `object.toml` and the pictures named there, which must be in its folder
/// or below.
///
/// Depths are heights from 0 to 1, as in a [`View`](relief_core::object::View), stored as floats or
/// as integers of up to 16 bits. Colours are decoded like all pictures. Normals have green upward.
///
/// At most [`ObjectOptions::max_bytes`] of memory are used. A texel of the object takes 4 bytes of
/// height, 16 of colour and 12 of normals. The picture that is being read counts, too. Excess is
/// detected before the memory is allocated.
///
/// # Errors
///
/// As [`read_description`]. Also when a picture cannot be read, lies outside the folder, or has
/// another size than the depths. Also when a rectangle reaches beyond them, a depth is not from 0
/// to 1, or the object takes more memory than allowed.
pub fn read_object<'a>(
    source: impl Into<Source<'a>>,
    options: &ObjectOptions,
) -> Result<ObjectFile, ObjectFileError> {
    let source = source.into();
    let path = source.name();
    let description = read_description(source)?;
    let Description { centre, radius, ref views, measured, .. } = description;
    let in_file = |number: usize, problem: ObjectFileProblem| ObjectFileError::InFile {
        path: path.to_owned(),
        line: views[number].line,
        view: Some(number + 1),
        problem: Box::new(problem),
    };
    let sizes: Vec<[u32; 2]> = views.iter().map(|view| [view.rect[2], view.rect[3]]).collect();
    let of_object = |source| ObjectFileError::Object { path: path.to_owned(), source };
    let layout = AtlasLayout::new(sizes.clone()).map_err(of_object)?;
    let texels: u64 = layout.size().map(u64::from).iter().product();
    let has = [true, description.color.is_some(), description.normal.is_some()];
    let needed: u64 = TEXEL_BYTES.iter().zip(has).map(|(bytes, has)| u64::from(has) * bytes * texels).sum();
    let limit = options.max_bytes;
    // The border around an image is not in the picture, nor are the gaps between the images.
    let left = limit.checked_sub(needed).ok_or(ObjectFileError::TooMuchMemory {
        path: path.to_owned(),
        needed,
        limit,
    })?;
    let depth = beside_file(source, &description.depth)?;
    let atlas = read_stored_heights(source.with_name(&depth), left)?;
    let depth_size = [atlas.width(), atlas.height()];
    for (number, view) in views.iter().enumerate() {
        let [x, y, width, height] = view.rect.map(u64::from);
        if x + width > u64::from(depth_size[0]) || y + height > u64::from(depth_size[1]) {
            let problem =
                ObjectFileProblem::Outside { rect: view.rect, depth: depth.clone(), size: depth_size };
            return Err(in_file(number, problem));
        }
    }
    let maps = views.iter().map(|view| cut(&atlas, view.rect)).collect::<Result<Vec<_>, _>>();
    let maps = maps.map_err(|error| of_object(error.into()))?;
    drop(atlas);
    let made = views.iter().zip(&sizes).enumerate().map(|(number, (view, size))| {
        view.spec.view(centre, radius, *size).map_err(|error| in_file(number, error.into()))
    });
    let made = made.collect::<Result<Vec<_>, _>>()?;
    let object = ImageObject::new(made, &maps, options.cells, options.jump_texels).map_err(of_object)?;
    drop(maps);
    let [width, height] = layout.size();
    let same_size = |path: &Path, size: [u32; 2]| match size == depth_size {
        true => Ok(()),
        false => {
            Err(ObjectFileError::OtherSize { path: path.to_owned(), size, depth: depth.clone(), depth_size })
        }
    };
    let place = |image: usize, [x, y]: [u32; 2]| {
        let [left, top, ..] = views[image].rect;
        (top + y) as usize * depth_size[0] as usize + (left + x) as usize
    };
    let mut color = None;
    if let Some(name) = &description.color {
        let file = beside_file(source, name)?;
        let picture = read_picture(source.with_name(&file), left)?;
        same_size(&file, [picture.width, picture.height])?;
        let texels = layout.pack_with_edges(|image, at| picture.texels[place(image, at)], [0.0; 4]);
        color = Some(Picture { width, height, texels });
    }
    let mut normal = None;
    if let Some(name) = &description.normal {
        let file = beside_file(source, name)?;
        let map = read_normal_map(source.with_name(&file), GreenSign::PlusY, left)?;
        same_size(&file, [map.width, map.height])?;
        let level = [0.0, 0.0, 1.0];
        let normals = layout.pack_with_edges(|image, at| map.normals[place(image, at)], level);
        normal = Some(NormalMap { width, height, normals, degenerate: map.degenerate });
    }
    Ok(ObjectFile { object, color, normal, measured })
}

/// Cuts a rectangle, given by column, row, width and height, out of a map.
fn cut(map: &HeightMap, [x, y, width, height]: [u32; 4]) -> Result<HeightMap, relief_core::HeightMapError> {
    let columns = x as usize..(x + width) as usize;
    let row = |y: u32| &map.texels()[y as usize * map.width() as usize..][columns.clone()];
    let texels = (y..y + height).flat_map(row).copied().collect();
    HeightMap::new(width, height, texels, relief_core::Wrap::Clamp)
}
