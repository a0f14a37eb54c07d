//! What readers meet in files and leave out, assume, or take in another way than a user may expect. Every
//! such thing is a row of one table, and every note that is given of it names its row.

use std::fmt;
use std::path::PathBuf;

use crate::image_file::ImageFile;
use crate::{DEFAULT_MAX_BYTES, ReadError, Source};

/// A row of the table of what readers meet.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Omission {
    /// The name by which programs know it, as in `undeclared-nodata`.
    pub name: &'static str,
    /// The reader that meets it: of heights, of meshes or of pictures, or a format.
    pub reader: &'static str,
    /// What it meets.
    pub met: &'static str,
    /// What it does then.
    pub done: &'static str,
}

/// Declares the rows, each a constant, and the list of all of them.
macro_rules! omissions {
    ($($row:ident: $name:literal, $reader:literal, $met:literal, $done:literal;)*) => {
        $(
            #[doc = concat!("Met by the reader of ", $reader, ": ", $met, ". Then: ", $done, ".")]
            pub const $row: Omission = Omission { name: $name, reader: $reader, met: $met, done: $done };
        )*

        /// All rows.
        pub const OMISSIONS: &[Omission] = &[$($row),*];
    };
}

// A new row needs a file that makes it appear: `FEEDS` in `crates/relief-cli/tests/pictures/notes.rs`.
omissions! {
    UNDECLARED_NODATA: "undeclared-nodata", "heights",
        "a value far beyond all others, which no file and no user declares as a value for none",
        "it is taken for a height";
    NEAR_NODATA: "near-nodata", "heights",
        "values that are the declared value for none but for a little, as lossy compression leaves it",
        "their texels have no value";
    ABSENT_NODATA: "absent-nodata", "heights",
        "a value for none that is given, and that no texel has",
        "all texels keep their values";
    NARROW_RANGE: "narrow-range", "heights",
        "integers that use less than a tenth of what their type holds",
        "heights 0 and 1 are the type's least and greatest value";
    FITTED_RANGE: "fitted-range", "heights",
        "floats between 0 and 1 that use less than nine tenths of it",
        "heights 0 and 1 are their least and greatest value";
    NEARLY_GREY: "nearly-grey", "heights",
        "red, green and blue that are nearly equal",
        "their mean is the height";
    FILLED: "filled", "heights",
        "texels without a value, with nothing said of them",
        "they are filled from their surroundings";
    HOLES: "holes", "heights",
        "texels without a value where holes are asked for",
        "what is behind them is seen";
    NO_HOLES: "no-holes", "heights",
        "no texel without a value where holes are asked for",
        "the whole surface is seen";
    NAMED_LIKE_DEPTH: "named-like-depth", "heights",
        "a name as depth maps have",
        "white is high all the same";
    UNITS: "units", "heights",
        "heights or a ground whose unit is not named or not known, or heights that are no metres",
        "the unit of the other is taken, or metres are not known";
    UNWEIGHTED: "unweighted-vertices", "meshes",
        "vertices of a skin whose weights add up to 0",
        "each follows its first joint";
    ABSENT_COORDINATES: "absent-coordinates", "meshes",
        "a material whose picture lies by texture coordinates that are not there",
        "the mesh's own coordinates are taken";
    UNREAD_PICTURE: "unread-picture", "meshes",
        "a material's picture in a format that is not read, or a texture without a picture",
        "the material has its colour alone";
    OTHER_PICTURES: "other-pictures", "meshes",
        "materials with pictures of normals, metal, roughness, occlusion or emission",
        "they are left out";
    MTL: "mtl", "meshes",
        "an OBJ that names a file of materials",
        "its materials are left out";
    BLENDED: "blended", "meshes",
        "a material that is blended with what is behind it",
        "it is opaque where its opacity is at least 0.5, and nothing elsewhere";
    UNEVEN_COLORS: "uneven-colours", "meshes that are drawn",
        "triangles whose vertices have several colours",
        "each triangle has the mean of its vertices' colours";
    LEFT_OUT_COLORS: "left-out-colours", "meshes that are drawn",
        "more materials than are drawn, or several where triangles are displaced or sliced",
        "the surface has the colour of its own material";
    TILED_PICTURE: "tiled-picture", "meshes that are drawn",
        "a material's picture where the height map is tiled",
        "the picture is tiled as the height map is";
    UNWRITTEN_MATERIALS: "unwritten-materials", "meshes that are displaced",
        "materials of the base mesh in a format, strips or a plane that has none, or more than are drawn",
        "the file that is written has none of them";
    NO_ORIENTATION: "no-orientation", "pictures",
        "an orientation that is none of 1 to 8",
        "the picture is read as it is stored";
    ORIENTATION_ON_GROUND: "orientation-on-ground", "pictures",
        "an orientation beside a place on the ground",
        "rows are read as the place says";
    PAGES: "pages", "pictures",
        "several pages of a TIFF",
        "the first is read";
    NO_PHOTOMETRIC: "no-photometric", "pictures",
        "a TIFF that does not say whether 0 is black or white",
        "0 is black";
    LONG_OPACITY: "long-opacity", "pictures",
        "opacity of a PNG without an alpha channel (chunk tRNS) that is longer than its colours allow",
        "it is followed in part, or not at all";
    DISPLAY_WINDOW: "display-window", "pictures",
        "an EXR whose display window is another than its data window",
        "the data window is read";
    ANIMATION: "animation", "pictures",
        "an animation in a PNG or WebP file",
        "the picture that is shown without it is read; of WebP the first";
    ORIENTATION_IN_GLTF: "orientation-in-gltf", "meshes",
        "a picture with an orientation that a glTF names",
        "it is read as it is stored, as viewers of glTF do";
}

/// Something that a reader met in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// The row of the table.
    pub row: &'static Omission,
    /// What was met in this file, as a sentence without a full stop.
    pub text: String,
    /// The value of an option that reads the file in another way, where there is one: a number, or numbers
    /// between commas.
    pub mend: Option<String>,
}

impl Remark {
    /// A remark without an option that mends it.
    pub fn new(row: &'static Omission, text: impl Into<String>) -> Self {
        Self { row, text: text.into(), mend: None }
    }

    /// The same with the value of an option.
    #[must_use]
    pub fn with_mend(self, mend: impl Into<String>) -> Self {
        Self { mend: Some(mend.into()), ..self }
    }

    /// A note of a file.
    pub fn of(self, path: impl Into<PathBuf>) -> ReadNote {
        ReadNote { path: path.into(), remark: self }
    }
}

/// What a reader met in a file of that name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadNote {
    /// The file's path, or the name given with its bytes.
    pub path: PathBuf,
    /// What it met.
    pub remark: Remark,
}

impl fmt::Display for ReadNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.remark.text)
    }
}

/// What the header of a picture's file says that reading it does not follow, or tells of that is not read. No
/// sample is decoded. Of heights [`crate::read_height_file`] says this, too, and more.
///
/// # Errors
///
/// When the file cannot be read, is none of the formats that are recognised by their content, or is damaged.
pub fn read_notes<'a>(source: impl Into<Source<'a>>) -> Result<Vec<ReadNote>, ReadError> {
    let source = source.into();
    let file =
        ImageFile::open(source, None, 0, DEFAULT_MAX_BYTES).map_err(|problem| source.error(problem))?;
    Ok(file.layout().remarks.iter().cloned().map(|remark| remark.of(source.name())).collect())
}
