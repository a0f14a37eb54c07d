//! Table of everything that readers ignore, assume, or treat differently than a user may expect.
//! Every note names its row of the table.

use std::fmt;
use std::path::PathBuf;

use crate::image_file::ImageFile;
use crate::{DEFAULT_MAX_BYTES, ReadError, Source};

/// Row of the table of notes.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Omission {
    /// Name for programs, such as `undeclared-nodata`.
    pub name: &'static str,
    /// Reader that gives the note: of heights, of meshes or of pictures, or a format.
    pub reader: &'static str,
    /// Content of the file that causes the note.
    pub case: &'static str,
    /// Treatment by the reader.
    pub treatment: &'static str,
}

/// Declares the rows, each as a constant, and the list of all rows.
macro_rules! omissions {
    ($($row:ident: $name:literal, $reader:literal, $case:literal, $treatment:literal;)*) => {
        $(
            #[doc = concat!("Note on ", $reader, ": ", $case, ". Treatment: ", $treatment, ".")]
            pub const $row: Omission =
                Omission { name: $name, reader: $reader, case: $case, treatment: $treatment };
        )*

        /// All rows.
        pub const OMISSIONS: &[Omission] = &[$($row),*];
    };
}

// A new row needs a file that makes it appear: `FEEDS` in `crates/relief-cli/tests/pictures/notes.rs`.
omissions! {
    UNDECLARED_NODATA: "undeclared-nodata", "heights",
        "a value far from all others, which neither the file nor the user declares as nodata",
        "it is read as a height";
    NEAR_NODATA: "near-nodata", "heights",
        "values that nearly equal the declared nodata value, after lossy compression",
        "their texels have no value";
    ABSENT_NODATA: "absent-nodata", "heights",
        "a nodata value that is given, but that no texel has",
        "all texels keep their values";
    NARROW_RANGE: "narrow-range", "heights",
        "integers that use less than a tenth of their type's range",
        "heights 0 and 1 are the type's least and greatest value";
    FITTED_RANGE: "fitted-range", "heights",
        "floats between 0 and 1 that use less than nine tenths of this range",
        "heights 0 and 1 are their least and greatest value";
    BANDED: "banded", "heights that are inspected",
        "a smooth relief of few levels in equal steps, much of it in flat runs",
        "the steps are read as relief";
    NEARLY_GREY: "nearly-grey", "heights",
        "red, green and blue that are nearly equal",
        "their mean is the height";
    FILLED: "filled", "heights",
        "texels without a value, without an option for them",
        "they are filled from their surroundings";
    HOLES: "holes", "heights",
        "texels without a value, with the option for open holes",
        "the surface is open there";
    NO_HOLES: "no-holes", "heights",
        "no texel without a value, with the option for open holes",
        "the surface has no openings";
    NAMED_LIKE_DEPTH: "named-like-depth", "heights",
        "a file name that is usual for depth maps",
        "white is high nevertheless";
    UNITS: "units", "heights",
        "heights or a ground whose unit is not named or not known, or heights that cannot be metres",
        "both share the unit of one, or metres are not known";
    UNWEIGHTED: "unweighted-vertices", "meshes",
        "vertices of a skin whose weights add up to 0",
        "each follows its first joint";
    ABSENT_COORDINATES: "absent-coordinates", "meshes",
        "a material whose picture needs texture coordinates that the mesh lacks",
        "the mesh's own coordinates are used";
    UNREAD_PICTURE: "unread-picture", "meshes",
        "a material's picture in an unsupported format, or a texture without a picture",
        "the material has only its colour";
    OTHER_PICTURES: "other-pictures", "meshes",
        "materials with pictures of normals, metal, roughness, occlusion or emission, for a use or a \
         shading without them",
        "they are left out";
    UNREAD_MATERIAL: "unread-material", "meshes",
        "a part of a material that is not read: an extension, or a picture with a place of its own",
        "the rest of the material is read";
    UNSHOWN_MATERIAL: "unshown-material", "meshes that are drawn",
        "a part of a material that the shading does not have, or normals where a height map gives them",
        "the rest of the material is shown";
    MTL: "mtl", "meshes",
        "an OBJ that refers to a file of materials",
        "its materials are left out";
    BLENDED: "blended", "meshes",
        "a material that is blended with its background",
        "it is opaque where its opacity is at least 0.5, and invisible elsewhere";
    UNEVEN_COLORS: "uneven-colours", "meshes that are drawn",
        "triangles whose vertices have several colours",
        "each triangle has the mean of its vertices' colours";
    LEFT_OUT_COLORS: "left-out-colours", "meshes that are drawn",
        "more materials than are drawn, or several where triangles are displaced or sliced",
        "the surface has the colour of its own material";
    TILED_PICTURE: "tiled-picture", "meshes that are drawn",
        "a material's picture where the height map is tiled",
        "the picture is tiled as the height map is";
    MOTIF_BEYOND: "beyond-motif", "motifs that are drawn",
        "vertices below height 0 or above height 1",
        "it is cut off at these heights";
    FOLDED_SHELLS: "folded-shells", "motifs and volumes that are drawn",
        "shells of triangles that are deeper than the mesh is curved",
        "what is in them is shown folded";
    OPEN_MOTIF: "open-motif", "motifs that are drawn",
        "a mesh with edges that do not have two triangles",
        "its inside is seen";
    COARSE_VECTORS: "coarse-vectors", "vector displacement maps that are drawn",
        "8 bits a channel",
        "its steps show as terraces";
    UNWRITTEN_MATERIALS: "unwritten-materials", "meshes that are displaced",
        "materials of the base mesh that the format, strips or a plane cannot have, or more than are drawn",
        "the written file has none of them";
    NO_ORIENTATION: "no-orientation", "pictures",
        "an orientation that is not from 1 to 8",
        "the picture is read as it is stored";
    ORIENTATION_ON_GROUND: "orientation-on-ground", "pictures",
        "an orientation in a picture with a georeference",
        "rows are read as the georeference says";
    PAGES: "pages", "pictures",
        "several pages of a TIFF",
        "the first is read";
    NO_PHOTOMETRIC: "no-photometric", "pictures",
        "a TIFF that does not say whether 0 is black or white",
        "0 is black";
    LONG_OPACITY: "long-opacity", "pictures",
        "opacity of a PNG without an alpha channel (chunk tRNS) that is longer than its colours allow",
        "it is applied in part, or not at all";
    DISPLAY_WINDOW: "display-window", "pictures",
        "an EXR whose display window differs from its data window",
        "the data window is read";
    ANIMATION: "animation", "pictures",
        "an animation in a PNG or WebP file",
        "the PNG's still picture is read, or the WebP's first picture";
    OTHER_GREEN: "other-green", "pictures",
        "a normal map that fits the heights better with green down, where nobody says which it has",
        "green is read as up (+y)";
    TEXTURE_SET: "texture-set", "folders of textures",
        "maps of a material, recognised by their names",
        "each is taken for what its name says";
    LEFT_TEXTURES: "left-textures", "folders of textures",
        "files that have no name of a texture, or that another file replaces",
        "they are not read";
    DEEP_RELIEF: "deep-relief", "surfaces",
        "a relief more than ten times as deep as its tiles are long",
        "it is displaced as far as the scale says";
    TABLE_OPACITY: "table-opacity", "tables of colours",
        "colours that are not opaque, except of texels without a value",
        "they are shown opaque";
    OUTSIDE_TABLE: "outside-table", "tables of colours",
        "heights with less than a tenth of them between the table's elevations",
        "heights beyond them have the colours of its ends";
    IDLE_FACTOR: "idle-factor", "material maps",
        "a factor on a map that is 0 everywhere",
        "the product is 0: a map of its own replaces the channel";
    ORIENTATION_IN_GLTF: "orientation-in-gltf", "meshes",
        "a picture of a glTF with an orientation",
        "it is read as it is stored, as viewers of glTF do";
}

/// Remark of a reader on a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// Row of the table.
    pub row: &'static Omission,
    /// Description of the case in this file, as a sentence without a full stop.
    pub text: String,
    /// Value of an option that reads the file in another way, if there is one: a number, or numbers
    /// separated by commas.
    pub mend: Option<String>,
}

impl Remark {
    /// Creates a remark without an option's value.
    ///
    /// `text` describes the case in this file: a whole sentence without a full stop. Users see it
    /// as it is, after the file's path and a colon.
    pub fn new(row: &'static Omission, text: impl Into<String>) -> Self {
        Self { row, text: text.into(), mend: None }
    }

    /// Sets the value of the option that reads the file in another way. The row says which option.
    ///
    /// `mend` is the value alone, without the option's name: a number, or numbers separated by
    /// commas. It replaces an earlier value. Default: none.
    #[must_use]
    pub fn with_mend(self, mend: impl Into<String>) -> Self {
        Self { mend: Some(mend.into()), ..self }
    }

    /// Turns the remark into a note on a file. `path` is the file's path, or the name given with
    /// its bytes.
    pub fn of(self, path: impl Into<PathBuf>) -> ReadNote {
        ReadNote { path: path.into(), remark: self }
    }
}

/// Note on a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadNote {
    /// Path of the file, or the name given with its bytes.
    pub path: PathBuf,
    /// Remark on the file.
    pub remark: Remark,
}

impl fmt::Display for ReadNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.remark.text)
    }
}

/// Returns notes on everything in a picture's header that readers do not apply or read. No sample
/// is decoded. For heights, [`crate::read_height_file`] returns these notes and more.
///
/// # Errors
///
/// When the file cannot be read, is in none of the formats that are recognised by content, or is
/// damaged.
pub fn read_notes<'a>(source: impl Into<Source<'a>>) -> Result<Vec<ReadNote>, ReadError> {
    let source = source.into();
    let file =
        ImageFile::open(source, None, 0, DEFAULT_MAX_BYTES).map_err(|problem| source.error(problem))?;
    Ok(file.layout().remarks.iter().cloned().map(|remark| remark.of(source.name())).collect())
}
