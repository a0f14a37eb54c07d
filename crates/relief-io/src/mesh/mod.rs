//! Meshes from and to files: glTF, OBJ, PLY and STL.

mod builder;
mod folder;
mod gltf;
mod material;
mod named;
mod obj;
mod ply;
mod polygon;
mod stl;
mod text;
mod up;
mod write;

use std::fmt;
use std::path::{Path, PathBuf};

use relief_core::mesh::{Framed, Mesh, RawMesh, UvProjection};

pub use self::material::{MeshColors, MeshMaterial};
pub use self::named::files_of_mesh;
pub use self::up::Up;
pub use self::write::{
    GlbLayout, GlbLevel, GlbMaterials, GlbNode, MAX_SHELLS, MeshCounts, MeshSink, Quantization, Shells,
    Standing, write_glb, write_mesh, write_mesh_standing, write_shells,
};

use self::builder::Builder;
use crate::{DEFAULT_MAX_BYTES, ReadError, ReadProblem, Remark, Source, omissions};

/// A format of meshes.
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

/// The endings of meshes' names.
const ENDINGS: [(&str, MeshFormat); 5] = [
    ("gltf", MeshFormat::Gltf),
    ("glb", MeshFormat::Gltf),
    ("obj", MeshFormat::Obj),
    ("ply", MeshFormat::Ply),
    ("stl", MeshFormat::Stl),
];

impl MeshFormat {
    /// The name of the format.
    pub const fn name(self) -> &'static str {
        match self {
            MeshFormat::Gltf => "glTF",
            MeshFormat::Obj => "OBJ",
            MeshFormat::Ply => "PLY",
            MeshFormat::Stl => "STL",
        }
    }

    /// The format of a file by the ending of its name, in upper or lower case; none where it is no mesh's.
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

/// How to read a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// How texture coordinates are made, in place of the file's. None: those of the file.
    pub projection: Option<UvProjection>,
    /// Which axis of the file points up. None: as a file of Relief says itself, else `z` in STL and `y` in
    /// all others.
    pub up: Option<Up>,
    /// Whether the colours of the file's materials are read, too, with their pictures.
    pub colors: bool,
    /// The most memory that reading may take, in bytes.
    pub max_bytes: u64,
}

impl Default for MeshOptions {
    fn default() -> Self {
        Self { projection: None, up: None, colors: false, max_bytes: DEFAULT_MAX_BYTES }
    }
}

/// A mesh of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The mesh.
    pub mesh: Mesh,
    /// The file's format.
    pub format: MeshFormat,
    /// The colours, if they were asked for and the file has them: a glTF with materials or colours of
    /// vertices.
    pub colors: Option<MeshColors>,
    /// What of the file is read otherwise than it may be meant, or left out.
    pub notes: Vec<Remark>,
    /// Triangles without an area, which were left out.
    pub degenerate: usize,
    /// Triangles that lay on an earlier one with the same corners and front, which were left out.
    pub double: usize,
}

/// Reads a mesh from a file or from the bytes of one: all of its triangles as one mesh, with normals and true
/// tangent frames (see [`RawMesh::framed`](relief_core::mesh::RawMesh::framed)). The format is that of the
/// ending of its name.
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
/// A unit is a metre, in STL a millimetre. `y` is up, in STL `z`, or what [`MeshOptions::up`] says. Files of
/// other programs may count in something else; a [`Placement`](relief_core::mesh::Placement) sizes them.
///
/// | format | what is read |
/// | --- | --- |
/// | glTF | all triangles of the default scene, see below; the first texture coordinates |
/// | OBJ | faces of any number of corners, with `vt` and `vn`; `v` is turned over, as it runs up there |
/// | PLY | faces of any number of corners; `u` and `v`, `s` and `t` or `texture_u` and `texture_v` of vertices, or `texcoord` of faces, turned over; normals |
/// | STL | triangles, in millimetres; their normals are not used |
///
/// A glTF without a default scene has its first one read. Triangles are in the places of their nodes; they may
/// be strips, of which the triangles that join them are left out, or fans, and accessors sparse or quantised.
/// Morph targets and skins put vertices where the file's nodes and weights say; animations are not played. A
/// vertex whose weights add up to 0 follows its first joint. Compressed meshes are refused.
///
/// Files that a glTF names have to lie in its folder or below. Bytes in memory have no folder: there all
/// buffers are in the file itself.
///
/// # Memory
///
/// A triangle takes at most 480 bytes, a position 100, and the file its length; they are counted while they
/// are read, and reading ends before it takes more than [`MeshOptions::max_bytes`].
///
/// # Errors
///
/// When the file, or one that it names, cannot be read, is damaged, lies outside the folder or is too large;
/// when it has no triangles, no texture coordinates (and no projection is asked for), or numbers that are not
/// finite; or when it uses what is not supported.
pub fn read_mesh<'a>(source: impl Into<Source<'a>>, options: &MeshOptions) -> Result<MeshFile, ReadError> {
    let source = source.into();
    read(source, options).map_err(|problem| source.error(problem))
}

/// What a mesh's file says for a program, as a JSON text: what its materials' `extras` hold under a name.
/// None where they hold nothing of that name, and in all formats but glTF. Of a GLB only the JSON is read.
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
/// When the file cannot be read, is no mesh's, is damaged, or takes more than `max_bytes` to be read; when
/// its triangles have materials that say different things.
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

/// The place of a file that another one, such as a mesh's, names by a path from its folder on.
///
/// # Errors
///
/// When there is no such file, or it does not lie in that folder or below, links followed.
pub fn beside_file(naming: &Path, name: &Path) -> Result<PathBuf, ReadError> {
    let folder = naming.parent().unwrap_or(Path::new(""));
    let place = folder::inside(folder, name, &name.to_string_lossy());
    place.map_err(|problem| Source::from(naming).error(problem))
}

/// Reads what a mesh's file holds, as [`read_mesh`] does, and makes nothing of it: neither normals nor
/// texture coordinates need be there.
///
/// # Errors
///
/// When the file, or one that it names, cannot be read, is damaged, lies outside the folder, takes more than
/// `max_bytes`, or uses what is not supported.
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

/// What a file holds, before anything is made of it.
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
                let what = "the materials of its .mtl file are not read: a .glb of it keeps them";
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
