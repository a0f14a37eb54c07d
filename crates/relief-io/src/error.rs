//! What can go wrong with a file, and what can be done about it.

use std::io;
use std::path::{Path, PathBuf};

use relief_core::mesh::FramingError;
use relief_core::registry::UnknownName;
use relief_core::{Cancelled, HeightMapError};

use crate::{ForeignFormat, RawLayout};

/// A file could not be read: which file, and why.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct ReadError {
    /// The file's path, or the name given with its bytes.
    pub path: PathBuf,
    /// What is wrong with it and what to do about it.
    pub problem: ReadProblem,
}

/// Why a file could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadProblem {
    /// The operating system refused.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// The path is a folder.
    #[error("is a folder: give a file")]
    Folder,
    /// The path is a pipe, a device or the like.
    #[error("is no regular file: save what it gives to a file first")]
    NoFile,
    /// The file has no bytes.
    #[error("is empty")]
    Empty,
    /// The content is none of the formats that are read.
    #[error("is not a PNG, JPEG, EXR, TIFF, Radiance HDR, PGM or WebP file: convert it")]
    Unrecognised,
    /// The content is of a format of heights that is known and not read.
    #[error("{0}")]
    Foreign(ForeignFormat),
    /// A headerless file, by its name, without its layout.
    #[error("holds samples without a header: give its size and byte order")]
    NeedsRawLayout,
    /// The length of a headerless file is not that of its layout.
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
    /// The size, or a texel, is none of a height map.
    #[error(transparent)]
    Map(#[from] HeightMapError),
    /// Reading would take more memory than allowed.
    #[error(
        "{width}x{height} texels need {} MiB of memory, {} MiB are allowed: make the file smaller or raise the limit",
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
        /// What is wrong.
        what: String,
    },
    /// The file uses a part of its format that is not read.
    #[error("uses {what}, which is not supported: {advice}")]
    Unsupported {
        /// What is not supported.
        what: String,
        /// What to do instead.
        advice: &'static str,
    },
    /// The channel asked for does not exist.
    #[error("{0}")]
    UnknownChannel(UnknownName),
    /// There are several channels and none was chosen.
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
        /// Its row.
        row: u32,
        /// Whether there is an alpha that varies, so that it may be the height.
        alpha_varies: bool,
    },
    /// The channels are none of a picture.
    #[error("has the channels {}, which make no {what}", relief_core::registry::listed(channels))]
    NoColour {
        /// What was wanted: a picture or a normal map.
        what: &'static str,
        /// The channels.
        channels: Vec<String>,
    },
    /// Texels without a value.
    #[error(
        "{} of its texels have no value ({not_finite} NaN or infinite, {nodata} marked as nodata, {masked} masked), the first at ({column}, {row}): fill them from their surroundings",
        not_finite + nodata + masked
    )]
    Holes {
        /// How many are NaN or infinite.
        not_finite: u64,
        /// How many equal the file's nodata value.
        nodata: u64,
        /// How many the file's mask leaves out.
        masked: u64,
        /// Column of the first.
        column: u32,
        /// Row of the first.
        row: u32,
    },
    /// The file says things of the ground or of its metres that cannot be.
    #[error(
        "cannot be an elevation model: {what}: correct what it says or remove it, for instance with gdal_edit"
    )]
    Georeference {
        /// What cannot be.
        what: String,
    },
    /// The mask that says which texels have a value cannot be used.
    #[error("has a mask that cannot be used: {mask}: {problem}")]
    Mask {
        /// The mask's file, or that it is inside the file itself.
        mask: String,
        /// What is wrong with it.
        problem: Box<ReadProblem>,
    },
    /// A mask has another size, or other channels, than what it belongs to.
    #[error("is {mask}, the map {map}: make them alike, or remove the mask")]
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
        /// How many texels.
        not_finite: u64,
        /// Column of the first.
        column: u32,
        /// Row of the first.
        row: u32,
    },
    /// No texel has a value.
    #[error("holds no texel with a finite value")]
    AllHoles,
    /// Values lie outside the range given.
    #[error("its values go from {} to {}, outside the range {} to {}: widen the range", actual[0], actual[1], range[0], range[1])]
    OutsideRange {
        /// The range given.
        range: [f64; 2],
        /// Least and greatest value in the file.
        actual: [f64; 2],
    },
    /// The name is no mesh's.
    #[error("is no mesh by its name: glTF (.gltf, .glb), OBJ, PLY and STL are read")]
    NoMesh,
    /// A mesh takes more memory than allowed.
    #[error(
        "is a mesh that takes more than the {} MiB of memory allowed: make it coarser or raise the limit",
        limit >> 20
    )]
    MeshMemory {
        /// Bytes that may be used.
        limit: u64,
    },
    /// What the file holds makes no mesh.
    #[error("cannot be used: {0}")]
    Mesh(#[from] FramingError),
    /// A file that this one names cannot be read.
    #[error("names {}, which {problem}", file.display())]
    Part {
        /// The file that is named.
        file: PathBuf,
        /// What is wrong with it.
        problem: Box<ReadProblem>,
    },
    /// A file that this one names lies elsewhere.
    #[error("names '{file}', which is not in its folder: put it there, and name it by a relative path")]
    OutsideFolder {
        /// The name.
        file: String,
    },
    /// The range given is no range.
    #[error("the range {} to {} is not usable: both ends must be finite, the first below the second (for maps of depth use the depth convention)", range[0], range[1])]
    BadRange {
        /// The range given.
        range: [f64; 2],
    },
}

impl ReadProblem {
    /// Whether a mesh is refused for its texture coordinates alone, which a projection makes.
    pub fn is_of_texture_coordinates(&self) -> bool {
        use relief_core::mesh::FramingError::{NoTextureArea, NoTextureCoordinates};
        matches!(self, Self::Mesh(NoTextureCoordinates { .. } | NoTextureArea { .. }))
    }

    pub(crate) fn damaged(format: &'static str, what: impl ToString) -> Self {
        Self::Damaged { format, what: what.to_string() }
    }
}

/// A file could not be written: which file, and why. Nothing is left behind.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// What went wrong and what to do about it.
    pub problem: WriteProblem,
}

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteProblem {
    /// The folder cannot be written to, or does not exist.
    #[error("cannot write into its folder ({0}): create it, or check its permissions")]
    Folder(#[source] io::Error),
    /// Writing failed on the way.
    #[error("writing failed ({0}): check the free space of the disk")]
    Io(#[from] io::Error),
    /// The finished file could not take its name.
    #[error(
        "the finished file could not be moved to its name ({0}): check that it is no folder and not protected"
    )]
    Rename(#[source] io::Error),
    /// The path ends in no file name.
    #[error("is no file name")]
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
    pub(crate) fn at(self, path: &Path) -> WriteError {
        WriteError { path: path.to_owned(), problem: self }
    }
}
