//! Readers and writers of meshes: glTF, OBJ, PLY and STL.

mod builder;
mod folder;
mod gltf;
mod material;
mod material_values;
mod obj;
mod ply;
mod polygon;
mod referenced;
mod stl;
mod text;
mod up;
mod write;

use std::fmt;
use std::path::{Path, PathBuf};

use relief_core::mesh::{Framed, Mesh, RawMesh, UvProjection};

pub use self::material::{MeshColors, MeshMaterial};
pub use self::material_values::{MaterialTextures, MaterialValues, NormalTexture, OcclusionTexture};
pub use self::referenced::files_of_mesh;
pub use self::up::Up;
pub(crate) use self::write::tangent;
pub use self::write::{
    FileFrame, GlbLayout, GlbLevel, GlbMaterials, GlbNode, MAX_SHELLS, MeshCounts, MeshSink, Quantization,
    Shells, write_glb, write_mesh, write_mesh_in_frame, write_shells,
};

use self::builder::Builder;
use crate::{DEFAULT_MAX_BYTES, ReadError, ReadProblem, Remark, Source, omissions};

/// File format of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshFormat {
    /// glTF 2.0, as JSON or as binary GLB.
    Gltf,
    /// Wavefront OBJ.
    Obj,
    /// PLY, as text or binary.
    Ply,
    /// STL, as text or binary.
    Stl,
}

/// File extensions of meshes.
const ENDINGS: [(&str, MeshFormat); 5] = [
    ("gltf", MeshFormat::Gltf),
    ("glb", MeshFormat::Gltf),
    ("obj", MeshFormat::Obj),
    ("ply", MeshFormat::Ply),
    ("stl", MeshFormat::Stl),
];

impl MeshFormat {
    /// Returns the format's common name.
    pub const fn name(self) -> &'static str {
        match self {
            MeshFormat::Gltf => "glTF",
            MeshFormat::Obj => "OBJ",
            MeshFormat::Ply => "PLY",
            MeshFormat::Stl => "STL",
        }
    }

    /// Recognises the format by a file's extension, in upper or lower case; none if it is not a
    /// mesh's.
    pub fn by_name(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        ENDINGS.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(ending)).map(|(_, format)| format)
    }
}

impl fmt::Display for MeshFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Options for reading a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Projection that makes texture coordinates in place of the file's. None: the file's
    /// coordinates.
    pub projection: Option<UvProjection>,
    /// Axis of the file that points up. None: as noted in files that Relief wrote, otherwise `z` in
    /// STL and `y` in all others.
    pub up: Option<Up>,
    /// Whether to read the colours and pictures of the file's materials. Default: false.
    pub colors: bool,
    /// Whether to read the materials' pictures of roughness, metalness, occlusion, emission and normals,
    /// too. Without [`Self::colors`] none is read. Default: false.
    pub materials: bool,
    /// Greatest memory for reading, in bytes. Default: [`DEFAULT_MAX_BYTES`].
    pub max_bytes: u64,
}

impl Default for MeshOptions {
    fn default() -> Self {
        Self { projection: None, up: None, colors: false, materials: false, max_bytes: DEFAULT_MAX_BYTES }
    }
}

/// Mesh read from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The mesh.
    pub mesh: Mesh,
    /// File format.
    pub format: MeshFormat,
    /// Colours, if they were requested and the file has them: a glTF with materials or colours of
    /// vertices.
    pub colors: Option<MeshColors>,
    /// Notes on parts of the file that were ignored, or possibly read differently than meant.
    pub notes: Vec<Remark>,
    /// Number of triangles without an area, which were left out.
    pub degenerate: usize,
    /// Number of triangles with the same corners and front as an earlier one, which were left out.
    pub double: usize,
}

/// Reads all triangles of a file, or of the bytes of one, as one mesh, with normals and true
/// tangent frames (see [`RawMesh::framed`](relief_core::mesh::RawMesh::framed)). The extension of
/// the file's name gives the format.
///
/// ```
/// use relief_io::{MeshOptions, Source, read_mesh};
///
/// let text = b"v 0 0 0\nv 0 0 2\nv 2 0 2\nvt 0 1\nvt 0 0\nvt 1 0\nf 1/1 2/2 3/3\n";
/// let mesh = read_mesh(Source::bytes("corner.obj", text), &MeshOptions::default())?.mesh;
/// assert_eq!(mesh.triangles().len(), 1);
/// // One tile is 2 m wide: along x, as u grows.
/// assert_eq!(mesh.vertices()[0].tangent.to_array(), [2.0, 0.0, 0.0]);
/// # Ok::<(), relief_io::ReadError>(())
/// ```
///
/// A unit is a metre, in STL a millimetre. `y` points up, in STL `z`, unless [`MeshOptions::up`]
/// says otherwise. Files of other programs may use other units; a
/// [`Placement`](relief_core::mesh::Placement) sizes them.
///
/// | format | what is read |
/// | --- | --- |
/// | glTF | all triangles of the default scene, see below; the first texture coordinates |
/// | OBJ | faces of any number of corners, with `vt` and `vn`; `v` is flipped, since it runs upward |
/// | PLY | faces of any number of corners; `u` and `v`, `s` and `t` or `texture_u` and `texture_v` of vertices, or `texcoord` of faces, turned over; normals |
/// | STL | triangles, in millimetres; their normals are not used |
///
/// In a glTF without a default scene the first one is read. Triangles are transformed by their
/// nodes. They may be strips or fans; triangles without an area that only join parts of a strip are
/// left out. Accessors may be sparse or quantised. Morph targets and skins move vertices by the
/// file's nodes and weights; animations are not played. A vertex whose weights add up to 0 follows
/// its first joint. Compressed meshes are refused.
///
/// Files that a glTF refers to must be in its folder or below, on disk or among the
/// [`MemoryFiles`](crate::MemoryFiles). Bytes alone have no folder: all their buffers must be in the
/// file itself.
///
/// # Memory
///
/// A triangle takes at most 480 bytes, a position 100, and the file its length. They are counted
/// while they are read, and reading ends before it takes more than [`MeshOptions::max_bytes`].
///
/// # Errors
///
/// When the file, or one that it refers to, cannot be read, is damaged, lies outside the folder or
/// is too large; when it has no triangles, no texture coordinates (and no projection is given), or
/// numbers that are not finite; or when it uses an unsupported feature.
pub fn read_mesh<'a>(source: impl Into<Source<'a>>, options: &MeshOptions) -> Result<MeshFile, ReadError> {
    let source = source.into();
    read(source, options).map_err(|problem| source.error(problem))
}

/// Reads the value under `name` in the `extras` of a mesh's materials, as JSON text. None if the
/// extras have no such name, and in all formats but glTF. Of a GLB only the JSON is read.
///
/// ```
/// use relief_io::{Source, read_mesh_extras};
///
/// let text = br#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
///   "buffers": [{"uri": "wall.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
///   "accessors": [{"bufferView": 0, "count": 3, "componentType": 5126, "type": "VEC3",
///     "min": [0, 0, 0], "max": [1, 1, 1]}],
///   "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
///   "materials": [{"extras": {"relief": {"scale": 0.1}}}]}"#;
/// let extras = read_mesh_extras(Source::bytes("wall.gltf", text), "relief", 1 << 20)?;
/// assert_eq!(extras.as_deref(), Some(r#"{"scale":0.1}"#));
/// # Ok::<(), relief_io::ReadError>(())
/// ```
///
/// # Errors
///
/// When the file cannot be read, is not a mesh, is damaged, or needs more than `max_bytes`; or when
/// its triangles have materials with different values.
pub fn read_mesh_extras<'a>(
    source: impl Into<Source<'a>>,
    name: &str,
    max_bytes: u64,
) -> Result<Option<String>, ReadError> {
    let source = source.into();
    let extras = match MeshFormat::by_name(source.name()) {
        Some(MeshFormat::Gltf) => gltf::extras::read(source, name, &mut Builder::new(max_bytes)),
        Some(_) => Ok(None),
        None => Err(ReadProblem::NoMesh),
    };
    extras.map_err(|problem| source.error(problem))
}

/// Reads the value under `name` in the `extras` of a mesh's nodes, as JSON text: of the first node
/// with a mesh that has it. None if no node has it, and in all formats but glTF. Of a GLB only the
/// JSON is read. [`GlbNode::extras`] writes such values.
///
/// # Errors
///
/// When the file cannot be read, is not a mesh, is damaged, or needs more than `max_bytes`.
pub fn read_node_extras<'a>(
    source: impl Into<Source<'a>>,
    name: &str,
    max_bytes: u64,
) -> Result<Option<String>, ReadError> {
    let source = source.into();
    let extras = match MeshFormat::by_name(source.name()) {
        Some(MeshFormat::Gltf) => gltf::extras::read_of_nodes(source, name, &mut Builder::new(max_bytes)),
        Some(_) => Ok(None),
        None => Err(ReadProblem::NoMesh),
    };
    extras.map_err(|problem| source.error(problem))
}

/// Reads whether a mesh's file has a material that Blinn-Phong shading cannot show: a metal with a
/// roughness of its own, maps of roughness, metalness, occlusion or emission, light of its own, or an
/// extension on transparency or reflection. False in all formats but glTF. Of a GLB only the JSON is
/// read.
///
/// # Errors
///
/// When the file cannot be read, is not a mesh, is damaged, or needs more than `max_bytes`.
pub fn mesh_needs_roughness<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<bool, ReadError> {
    let source = source.into();
    let needs = match MeshFormat::by_name(source.name()) {
        Some(MeshFormat::Gltf) => gltf::extras::needs_roughness(source, &mut Builder::new(max_bytes)),
        Some(_) => Ok(false),
        None => Err(ReadProblem::NoMesh),
    };
    needs.map_err(|problem| source.error(problem))
}

/// Resolves a path that a file `naming`, such as a mesh, contains: `name` is relative to its
/// folder.
///
/// # Errors
///
/// When the file does not exist, or is not in that folder or below, after links are followed.
pub fn beside_file<'a>(naming: impl Into<Source<'a>>, name: &Path) -> Result<PathBuf, ReadError> {
    let naming = naming.into();
    folder::inside(naming, name, &name.to_string_lossy()).map_err(|problem| naming.error(problem))
}

/// Reads the raw content of a mesh's file. Unlike [`read_mesh`], neither normals nor texture
/// coordinates are needed.
///
/// # Errors
///
/// When the file, or one that it refers to, cannot be read, is damaged, lies outside the folder,
/// needs more than `max_bytes`, or uses an unsupported feature.
pub fn read_raw_mesh<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<RawMesh, ReadError> {
    let source = source.into();
    let options = MeshOptions { max_bytes, ..MeshOptions::default() };
    let raw = read_raw(source, &options).map(|read| read.raw);
    raw.map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, options: &MeshOptions) -> Result<MeshFile, ReadProblem> {
    let Read { mut raw, format, colors, notes } = read_raw(source, options)?;
    if let Some(projection) = options.projection {
        raw = raw.projected(projection)?;
    }
    let Framed { mesh, numbers, degenerate, double } = raw.framed()?;
    let colors = colors.map(|colors| colors.of_framed(&mesh, &numbers));
    Ok(MeshFile { mesh, format, colors, notes, degenerate, double })
}

/// Raw content of a file.
struct Read {
    raw: RawMesh,
    format: MeshFormat,
    colors: Option<MeshColors>,
    notes: Vec<Remark>,
}

fn read_raw(source: Source<'_>, options: &MeshOptions) -> Result<Read, ReadProblem> {
    let format = MeshFormat::by_name(source.name()).ok_or(ReadProblem::NoMesh)?;
    let mut builder = Builder::new(options.max_bytes);
    let bytes = source.whole(|len| builder.take(len))?;
    builder.up = options.up.unwrap_or_else(|| Up::of_file(format, &bytes));
    let (mut colors, mut notes) = (None, Vec::new());
    match format {
        MeshFormat::Gltf => colors = gltf::read(source, &bytes, options, &mut builder, &mut notes)?,
        MeshFormat::Obj => {
            obj::read(&bytes, &mut builder)?;
            let names_materials = |line: &[u8]| line.trim_ascii_start().starts_with(b"mtllib ");
            if options.colors && bytes.split(|byte| matches!(byte, b'\n' | b'\r')).any(names_materials) {
                let what = "the materials of its .mtl file are not read: convert it to .glb, which holds its \
                            materials";
                notes.push(Remark::new(&omissions::MTL, what));
            }
        }
        MeshFormat::Ply => ply::read(&bytes, &mut builder)?,
        MeshFormat::Stl => stl::read(&bytes, &mut builder)?,
    }
    drop(bytes);
    notes.append(&mut builder.notes);
    Ok(Read { raw: builder.finish(), format, colors, notes })
}
