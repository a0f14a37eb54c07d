//! Readers of height maps, pictures, normal maps and meshes; writers of pictures, float channels
//! and meshes.
//!
//! [`read_mesh`] and [`write_mesh`] read and write meshes, and list their formats. Maps and
//! pictures have these formats:
//!
//! | format | recognised by | samples | notes |
//! | --- | --- | --- | --- |
//! | PNG | content | 1 to 16 bit, grey, colour, palette, opacity | pictures that say so are linear |
//! | JPEG | content | 8 bit, grey, colour | |
//! | EXR | content | f16, f32, u32, any channel | flat parts, all compressions but HTJ2K, LJ2K, ZSTD |
//! | TIFF, GeoTIFF | content | 8 to 64-bit integers and floats | metres, nodata, masks; not LZMA |
//! | Radiance HDR | content | RGBE | |
//! | PGM (PPM) | content | 8 and 16 bit, plain and binary | |
//! | WebP | content | 8 bit, colour, opacity | of animations the first picture |
//! | raw | [`RawLayout`] given | 16 bit | |
//!
//! Pictures are turned by the orientation in their EXIF metadata or TIFF tag, for all uses.
//! Exceptions are pictures that a glTF refers to and TIFFs with a georeference.
//!
//! [`find_textures`] finds the textures of a material in a folder by their names. [`ENGINES`] has the
//! conventions of engines for such textures.
//!
//! Writers leave a complete file or none; [`file_set`] does the same for several files at once.
//!
//! A reader returns a [`ReadNote`] for everything that it ignores or assumes. The note's row in
//! [`OMISSIONS`] describes the case and the treatment. [`read_height_file`] and
//! [`inspect`](inspect()) return notes; [`read_notes`] returns them for other pictures.
//!
//! Every reader takes a [`Source`]: a file's path, the bytes of a file in memory, or a path among
//! [`Files`], which are on disk or in memory.
//!
//! # Memory
//!
//! Headers are checked against [`HeightOptions::max_bytes`] and the file's length before memory is
//! allocated for their claims. Pictures are decoded row by row or block by block: reading a height
//! map peaks at 8 bytes a texel and 32 MiB. There are two exceptions, which `max_bytes` covers all
//! the same. A *progressive colour JPEG* takes 9 bytes a texel and the file's length. An EXR or
//! TIFF *block* (tile, strip, or the 16 to 256 rows of a compressed EXR block, all channels) is
//! held two or three times. If the whole picture is one block, such as a TIFF with a single strip,
//! that is up to three times its uncompressed size.
//!
//! Bytes in memory are decoded in place. Only the decoder of JPEG copies them whole, as it also
//! does with a file.
//!
//! ```
//! use relief_io::{HeightOptions, Source, read_height};
//!
//! let file = b"P5 3 2 255\n\x00\x10\x20\x30\x40\xff";
//! let heights = read_height(Source::bytes("heights.pgm", file), &HeightOptions::default())?;
//! assert_eq!((heights.width(), heights.height()), (3, 2));
//! assert_eq!(heights.texels()[5], 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod banding;
mod color_table;
mod convention;
mod elevation;
mod engine;
mod error;
mod examine;
mod exif;
mod exr;
pub mod file_set;
mod files;
mod fill;
mod foreign;
mod georeference;
mod ground;
mod hdr;
mod height;
mod height_note;
mod height_range;
mod image_file;
mod input;
mod inspect;
mod jpeg;
mod jpeg_write;
mod ktx2;
mod layout;
mod length;
mod mesh;
mod motif;
mod nodata;
mod normal_map;
pub mod omissions;
mod orientation;
mod pgm;
mod picture;
mod picture_file;
mod png;
mod raw;
mod raw_layout;
mod samples;
mod source;
mod text;
mod texture;
mod texture_set;
mod tiff;
mod vector_map;
mod webp;
mod write;
mod write_whole;

pub use self::ktx2::{
    Ktx2File, Ktx2Level, Ktx2Texture, TexelFormat, VolumeFile, VolumeFormat, VolumeOptions, read_ktx2,
    read_volume, write_ktx2, write_volume,
};
pub use color_table::{
    BuiltinRamp, ColorEntry, ColorRamp, ColorTable, ColorTableProblem, TableElevation, read_color_table,
};
pub use convention::{Detection, Guess, detect, guess_by_name};
pub use elevation::{CoordinateSystem, Doubt, Elevation, Georeference, GridTransform, UnitOrigin};
pub use engine::{
    ENGINES, Engine, EngineModel, EngineSetting, EngineShape, EngineTexture, HeightUse, ModelTextures,
    SettingValue, SurfaceChannel, TextureContent, VertexFrames, godot_mesh, percent_encoded,
    write_engine_model,
};
pub use error::{ReadError, ReadProblem, WriteError, WriteProblem};
pub use files::{FileStamp, Files, MemoryFiles, MemoryPathError};
pub use foreign::ForeignFormat;
pub use georeference::{GivenUnits, LengthUnit, epsg};
pub use ground::{Ground, read_ground};
pub use height::{
    Convention, DEFAULT_MAX_BYTES, Fill, HeightFile, HeightOptions, read_height, read_height_file,
    read_stored_heights,
};
pub use height_note::HeightNote;
pub use height_range::HeightRange;
pub use inspect::{HISTOGRAM_BINS, SEAM_LIMIT, SourceInfo, Tiling, Values, inspect};
pub use layout::{Channel, Format, SampleKind, SampleType};
pub use length::{LengthError, metres};
pub use mesh::{
    FileFrame, GlbLayout, GlbLevel, GlbMaterials, GlbNode, MAX_SHELLS, MaterialTextures, MaterialValues,
    MeshColors, MeshCounts, MeshFile, MeshFormat, MeshMaterial, MeshOptions, MeshSink, NormalTexture,
    OcclusionTexture, Quantization, Shells, Up, beside_file, files_of_mesh, mesh_needs_roughness, read_mesh,
    read_mesh_extras, read_node_extras, read_raw_mesh, write_glb, write_mesh, write_mesh_in_frame,
    write_shells,
};
pub use motif::{MOTIF_EXTRAS, read_motif_depth};
pub use normal_map::{GreenSign, NormalMap, NormalVectors, SHORTEST, read_normal_map, read_normal_vectors};
pub use omissions::{OMISSIONS, Omission, ReadNote, Remark, read_notes};
pub use picture::{Curve, Picture, linear_to_srgb, read_picture, read_picture_as, srgb_to_linear};
pub use picture_file::{PictureFormat, PictureSink, encode_picture, write_picture};
pub use raw_layout::{BadRawLayout, ByteOrder, RawLayout};
pub use source::Source;
pub use text::decode_text;
pub use texture::{
    LineSink, Metadata, PngTexture, Row, RowSource, encode_exr_lines, read_metadata, write_dds,
    write_exr_lines, write_exr_rows, write_png_colours, write_png_rows,
};
pub use texture_set::{
    FoundTexture, LeftReason, TextureRole, TextureSet, TextureSetError, find_textures, material_name,
};
pub use vector_map::{VectorMap, read_vector_map};
pub use write::{PngColour, write_exr, write_png8, write_png16};
pub use write_whole::write_atomically;
