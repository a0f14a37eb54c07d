//! Errors of reading and writing files: what is wrong, and what to do about it.

use std::io;
use std::path::{Path, PathBuf};

use relief_core::mesh::FramingError;
use relief_core::registry::UnknownName;
use relief_core::{Cancelled, HeightMapError, VolumeError};

use crate::{ColorTableProblem, ForeignFormat, RawLayout};

/// Error of reading a file: the file and the reason.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct ReadError {
    /// Path of the file, or the name given with its bytes.
    pub path: PathBuf,
    /// Reason why the file could not be read, and the remedy.
    pub problem: ReadProblem,
}

/// Reason why a file could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadProblem {
    /// The operating system reported an error.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// The path is a folder.
    #[error("is a folder: give a file")]
    Folder,
    /// The path is a pipe, a device or the like.
    #[error("is not a regular file: save its content to a file first")]
    NoFile,
    /// The file has no bytes.
    #[error("is empty: obtain or export it again")]
    Empty,
    /// The content is in none of the supported formats.
    #[error("is not a PNG, JPEG, EXR, TIFF, Radiance HDR, PGM or WebP file: convert it")]
    Unrecognised,
    /// The content is in a known format of heights that is not supported.
    #[error("{0}")]
    Foreign(ForeignFormat),
    /// A headerless file, by its name, was given without its layout.
    #[error("holds samples without a header: give its size and byte order")]
    NeedsRawLayout,
    /// The length of a headerless file does not fit its layout.
    #[error(
        "holds {actual} bytes, but {layout} needs {expected}: check width, height and that samples are 16 bit"
    )]
    RawSize {
        /// The layout given.
        layout: RawLayout,
        /// Bytes that the layout needs.
        expected: u64,
        /// Bytes in the file.
        actual: u64,
    },
    /// The size, or a texel, is invalid for a height map.
    #[error(transparent)]
    Map(#[from] HeightMapError),
    /// Reading would take more memory than allowed.
    #[error(
        "{width}x{height} texels need {} MiB of memory, but {} MiB are allowed: make the file smaller or \
         raise the limit",
        needed.div_ceil(1 << 20),
        limit >> 20
    )]
    TooMuchMemory {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Bytes that reading needs.
        needed: u64,
        /// Bytes that may be used.
        limit: u64,
    },
    /// Reading a volume would take more memory than allowed.
    #[error(
        "{}x{}x{} voxels need {} MiB of memory, but {} MiB are allowed: make the volume smaller or raise the \
         limit",
        size[0], size[1], size[2],
        needed.div_ceil(1 << 20),
        limit >> 20
    )]
    VolumeMemory {
        /// Columns, rows and slices.
        size: [u32; 3],
        /// Bytes that reading needs.
        needed: u64,
        /// Bytes that may be used.
        limit: u64,
    },
    /// A motif's file states no depth that can be used; the text under its name.
    #[error("extras.motif of its node is {0}: it needs a depth above 0")]
    MotifDepth(String),
    /// The content does not make a volume.
    #[error("cannot be used: {0}")]
    Volume(VolumeError),
    /// The system has no more memory.
    #[error("needs {needed} bytes of memory, which the system refuses: make the file smaller")]
    OutOfMemory {
        /// Bytes asked for.
        needed: u64,
    },
    /// The file is damaged or cut off.
    #[error("is a damaged or incomplete {format} file ({what}): obtain or export it again")]
    Damaged {
        /// The format.
        format: &'static str,
        /// Description of the damage.
        what: String,
    },
    /// The file uses a feature of its format that is not supported.
    #[error("uses {what}, which is not supported: {advice}")]
    Unsupported {
        /// The unsupported feature.
        what: String,
        /// Advice on what to do instead.
        advice: &'static str,
    },
    /// The channel asked for does not exist.
    #[error("{0}")]
    UnknownChannel(UnknownName),
    /// The file has several channels and none was chosen.
    #[error("has the channels {}: choose one", relief_core::registry::listed(channels))]
    ChooseChannel {
        /// The channels.
        channels: Vec<String>,
    },
    /// The three channels of the picture differ, so that none of them is clearly the height.
    #[error(
        "is a picture in colour (texel ({column}, {row}) is not grey); its channels are {}: choose one{}",
        relief_core::registry::listed(channels),
        if *alpha_varies { ", such as a, which varies as heights do" } else { "" }
    )]
    NotGrey {
        /// The channels.
        channels: Vec<String>,
        /// Column of the first texel whose channels differ.
        column: u32,
        /// Row of that texel.
        row: u32,
        /// Whether an alpha channel exists and varies, so that it may be the height.
        alpha_varies: bool,
    },
    /// The channels do not form a picture, a normal map or a vector displacement map.
    #[error(
        "has the channels {}, which do not form a {what}: export it with R, G and B",
        relief_core::registry::listed(channels)
    )]
    NoColour {
        /// Kind of image wanted: a picture, a normal map or a vector displacement map.
        what: &'static str,
        /// The channels.
        channels: Vec<String>,
    },
    /// Some texels have no value.
    #[error(
        "{} of its texels have no value ({not_finite} NaN or infinite, {nodata} marked as nodata, {masked} \
         masked), the first at ({column}, {row}): fill them from their surroundings",
        not_finite + nodata + masked
    )]
    Holes {
        /// Number of texels that are NaN or infinite.
        not_finite: u64,
        /// Number of texels that equal the nodata value.
        nodata: u64,
        /// Number of texels that the file's mask excludes.
        masked: u64,
        /// Column of the first such texel.
        column: u32,
        /// Row of the first such texel.
        row: u32,
    },
    /// The file states an impossible georeference or impossible units.
    #[error(
        "cannot be an elevation model: {what}: correct that entry or remove it, for instance with gdal_edit"
    )]
    Georeference {
        /// The impossible entry.
        what: String,
    },
    /// The mask that marks texels with a value cannot be used.
    #[error("has a mask that cannot be used: {mask}: {problem}")]
    Mask {
        /// Name of the mask's file, or a note that it is inside the map's file.
        mask: String,
        /// Problem with the mask.
        problem: Box<ReadProblem>,
    },
    /// A mask differs from its map in size or channels.
    #[error("is {mask}, but the map is {map}: make them alike, or remove the mask")]
    MaskSize {
        /// Size and channels of the mask.
        mask: String,
        /// Size and channels of the map.
        map: String,
    },
    /// Values of a picture are NaN or infinite.
    #[error(
        "{not_finite} of its texels are NaN or infinite, the first at ({column}, {row}): repair the picture"
    )]
    NotFinite {
        /// Number of such texels.
        not_finite: u64,
        /// Column of the first.
        column: u32,
        /// Row of the first.
        row: u32,
    },
    /// No texel has a value.
    #[error("holds no texel with a finite value: check its nodata value and mask, or export it again")]
    AllHoles,
    /// Values lie outside the range given.
    #[error(
        "its values go from {} to {}, outside the range {} to {}: widen the range",
        actual[0],
        actual[1],
        range[0],
        range[1]
    )]
    OutsideRange {
        /// The range given.
        range: [f64; 2],
        /// Least and greatest value in the file.
        actual: [f64; 2],
    },
    /// The file's name has no extension of a mesh format.
    #[error("is not named as a mesh: give a glTF (.gltf, .glb), OBJ, PLY or STL file")]
    NoMesh,
    /// A mesh takes more memory than allowed.
    #[error(
        "is a mesh that needs more than the {} MiB of memory allowed: make it coarser or raise the limit",
        limit >> 20
    )]
    MeshMemory {
        /// Bytes that may be used.
        limit: u64,
    },
    /// The content does not form a usable mesh.
    #[error("cannot be used: {0}")]
    Mesh(#[from] FramingError),
    /// A file that this file refers to cannot be read.
    #[error("refers to {}, which {problem}", file.display())]
    Part {
        /// The file referred to.
        file: PathBuf,
        /// Problem with that file.
        problem: Box<ReadProblem>,
    },
    /// A file that this file refers to is outside its folder.
    #[error(
        "refers to '{file}', which is not in its folder: put it there, and refer to it by a relative path"
    )]
    OutsideFolder {
        /// The name as it is written in the file.
        file: String,
    },
    /// A table of colours cannot be used.
    #[error("{}{problem}", line.map_or(String::new(), |line| format!("line {line}: ")))]
    ColorTable {
        /// Line of the problem, counted from 1; none if it is the file's as a whole.
        line: Option<usize>,
        /// Description of the problem.
        problem: Box<ColorTableProblem>,
    },
    /// The range given is not a valid range.
    #[error(
        "the range {} to {} is not usable: both ends must be finite, the first below the second (for maps of \
         depth use the depth convention)",
        range[0],
        range[1]
    )]
    BadRange {
        /// The range given.
        range: [f64; 2],
    },
    /// The elevations given are not valid.
    #[error(
        "the elevations {} to {} are not usable: both must be finite, the first below the second",
        range[0],
        range[1]
    )]
    BadElevations {
        /// Elevations of heights 0 and 1, in metres.
        range: [f64; 2],
    },
}

impl ReadProblem {
    /// Whether a mesh is refused only for its texture coordinates, which a projection can supply.
    pub fn is_of_texture_coordinates(&self) -> bool {
        use relief_core::mesh::FramingError::{NoTextureArea, NoTextureCoordinates};
        matches!(self, Self::Mesh(NoTextureCoordinates { .. } | NoTextureArea { .. }))
    }

    pub(crate) fn damaged(format: &'static str, what: impl ToString) -> Self {
        Self::Damaged { format, what: what.to_string() }
    }
}

/// Error of writing a file: the file and the reason. Nothing is left behind.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// Reason why the file could not be written, and the remedy.
    pub problem: WriteProblem,
}

/// Reason why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteProblem {
    /// The folder cannot be written to, or does not exist.
    #[error("cannot write into its folder ({0}): create it, or check its permissions")]
    Folder(#[source] io::Error),
    /// Writing failed before the end.
    #[error("writing failed ({0}): check the free space of the disk")]
    Io(#[from] io::Error),
    /// The finished file could not be renamed to its final name.
    #[error(
        "the finished file could not be moved to its name ({0}): check that it is not a folder and not \
         write-protected"
    )]
    Rename(#[source] io::Error),
    /// The path ends in no file name.
    #[error("has no file name: end the path with one")]
    NoName,
    /// The samples do not fit the size.
    #[error("{width}x{height} needs {expected} samples, {given} were given")]
    WrongLength {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Samples that the size needs.
        expected: u64,
        /// Samples given.
        given: u64,
    },
    /// The size or the channels cannot be stored in the format.
    #[error("{0}")]
    NotStorable(String),
    /// Writing was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl WriteProblem {
    /// Names the file that cannot be written.
    pub fn at(self, path: &Path) -> WriteError {
        WriteError { path: path.to_owned(), problem: self }
    }
}
