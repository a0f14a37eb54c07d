//! Writers of meshes, block by block, one module for each format.

mod glb;
mod obj;
mod ply;
mod shells;
mod stl;

use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use glam::{DVec3, Vec3};
use relief_core::mesh::MeshBlock;

pub(crate) use glb::tangent;
pub use glb::{GlbLayout, GlbLevel, GlbMaterials, GlbNode, Quantization};
pub use shells::{MAX_SHELLS, Shells, write_shells};

use super::MeshFormat;
use super::up::{Up, comment};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// Size of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshCounts {
    /// Number of vertices.
    pub vertices: u64,
    /// Number of triangles.
    pub triangles: u64,
}

/// Receiver of the next block of a mesh.
pub type MeshSink<'a> = dyn FnMut(&MeshBlock) -> io::Result<()> + 'a;

/// Encoder of a block.
type Encode<'a> = dyn FnMut(&MeshBlock, &mut Regions<'_, '_>) -> io::Result<()> + 'a;

impl MeshFormat {
    /// Bytes of a mesh's file in this format: exact, but a lower bound for OBJ, which is text.
    pub fn bytes(self, counts: MeshCounts) -> u64 {
        match self {
            MeshFormat::Gltf => GlbLayout::of(counts).bytes(),
            MeshFormat::Obj => obj::least_bytes(counts),
            MeshFormat::Ply => ply::bytes(counts),
            MeshFormat::Stl => stl::bytes(counts),
        }
    }

    /// Checks whether this format can hold a mesh of this size.
    ///
    /// # Errors
    ///
    /// When it cannot; the error says what can.
    pub fn check(self, counts: MeshCounts) -> Result<(), WriteProblem> {
        if self == MeshFormat::Gltf {
            return GlbLayout::of(counts).check();
        }
        check_counts(counts)
    }
}

/// Checks that there are vertices and triangles, and that 32-bit numbers can index them.
fn check_counts(MeshCounts { vertices, triangles }: MeshCounts) -> Result<(), WriteProblem> {
    let cannot = |what: &str| {
        let of = format!("a mesh of {vertices} vertices and {triangles} triangles");
        Err(WriteProblem::NotStorable(format!("{of} {what}")))
    };
    if vertices == 0 || triangles == 0 {
        return cannot("is empty: give it vertices and triangles");
    }
    if vertices >= u64::from(u32::MAX) || triangles > u64::from(u32::MAX) {
        return cannot("exceeds 32-bit indices: make it coarser");
    }
    Ok(())
}

/// Writes a mesh as binary glTF (GLB), binary PLY, OBJ or binary STL. `blocks` passes the blocks of
/// the mesh to its argument; `counts` are their totals.
///
/// | format | lengths | what is written |
/// | --- | --- | --- |
/// | GLB | metres | positions, normals, tangents, texture coordinates |
/// | PLY | metres | positions, normals, texture coordinates `s` and `t`, `t` upward |
/// | OBJ | metres | as PLY; a block's faces follow its vertices |
/// | STL | millimetres | triangles with their normals |
///
/// In an STL `z` is up, in the others `y`, as in memory. [`write_mesh_in_frame`] sets another axis.
///
/// A tangent's `w` has the sign with which the green of glTF's normal maps points up in the
/// picture. Only one block is held in memory. The same blocks give the same bytes.
///
/// ```
/// use relief_core::mesh::{MeshBlock, cube};
/// use relief_io::{MeshCounts, MeshFormat, MeshOptions, Source, read_mesh, write_mesh};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("cube.ply");
/// let mesh = cube(2)?;
/// let [vertices, triangles] = [mesh.vertices().len(), mesh.triangles().len()].map(|count| count as u64);
/// let counts = MeshCounts { vertices, triangles };
/// let (vertices, triangles) = (mesh.vertices().to_vec(), mesh.triangles().to_vec());
/// let points = vertices.iter().map(|vertex| vertex.position).collect();
/// let block = MeshBlock { vertices, corners: triangles.clone(), triangles, points, owners: Vec::new() };
/// write_mesh(&path, MeshFormat::Ply, counts, |sink| sink(&block))?;
/// assert_eq!(read_mesh(path.as_path(), &MeshOptions::default())?.mesh.triangles().len(), 48);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
///
/// When the format [cannot hold](MeshFormat::check) the mesh, when `blocks` fails or its blocks do
/// not match `counts`, or when the file cannot be written. Nothing is left behind then.
pub fn write_mesh(
    path: &Path,
    format: MeshFormat,
    counts: MeshCounts,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_mesh_in_frame(path, format, &FileFrame::usual(format), counts, blocks)
}

/// Coordinate frame of a mesh's file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileFrame {
    /// Axis that points up.
    pub up: Up,
    /// Height in metres that is stored as 0. Default: 0.
    pub base_m: f64,
}

impl FileFrame {
    /// Returns the usual frame of a format, with unchanged heights.
    pub const fn usual(format: MeshFormat) -> Self {
        Self { up: Up::usual(format), base_m: 0.0 }
    }

    /// Converts a position to the file's frame. `units` is the number of its units in a metre.
    fn point(&self, position: Vec3, units: f64) -> Vec3 {
        let position = if self.base_m == 0.0 && units == 1.0 {
            position
        } else {
            ((position.as_dvec3() - DVec3::Y * self.base_m) * DVec3::splat(units)).as_vec3()
        };
        self.up.stored(position)
    }
}

/// Writes a mesh like [`write_mesh`], in the given frame. A GLB always has `y` up and unchanged
/// heights.
///
/// # Errors
///
/// See [`write_mesh`]. Also when a GLB is to have another frame than the usual one.
pub fn write_mesh_in_frame(
    path: &Path,
    format: MeshFormat,
    frame: &FileFrame,
    counts: MeshCounts,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    format.check(counts).map_err(|problem| problem.at(path))?;
    if format == MeshFormat::Gltf && *frame != FileFrame::usual(format) {
        let problem = WriteProblem::NotStorable(
            "a GLB always has y up and unchanged heights: choose another format".to_owned(),
        );
        return Err(problem.at(path));
    }
    let comment = comment(format, frame.up);
    write_file(path, |out| {
        let mut regions = Regions::new(out);
        match format {
            MeshFormat::Gltf => {
                glb_blocks(&GlbLayout::of(counts), &mut regions, blocks)?;
            }
            MeshFormat::Ply => {
                ply::begin(counts, &comment, &mut regions)?;
                counted(counts, &mut regions, &mut |block, to| ply::block(block, frame, to), blocks)?;
            }
            MeshFormat::Obj => {
                regions.write(0, format!("# {comment}\n").as_bytes())?;
                counted(counts, &mut regions, &mut |block, to| obj::block(block, frame, to), blocks)?;
            }
            MeshFormat::Stl => {
                stl::begin(counts, &comment, &mut regions)?;
                counted(counts, &mut regions, &mut |block, to| stl::block(block, frame, to), blocks)?;
            }
        }
        Ok(())
    })
}

/// Writes a GLB of one mesh or several levels of detail, in floats or integers. `blocks` passes the
/// blocks to its argument: the finest level first, each level complete before the next. Vertices
/// are numbered from 0 in each block's level. Only one block is held in memory. The same blocks
/// give the same bytes. Returns the number of indices of each level: three a triangle, or the
/// length of its [strip](GlbLayout::strips).
///
/// In integers, positions are rounded to the nearest points of the lattice; a mesh that was rounded
/// before stays unchanged. See [`Quantization`] for the stored types.
///
/// # Errors
///
/// When a GLB [cannot hold](GlbLayout::check) the levels; when `blocks` fails or its blocks do not
/// match the counts; when a position lies outside the lattice, or texture coordinates outside the
/// promised range of 0 to 1; when strips are longer than 4 GiB or have no triangle; or when the
/// file cannot be written. Nothing is left behind then.
pub fn write_glb(
    path: &Path,
    layout: &GlbLayout,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<Vec<u64>, WriteError> {
    layout.check().map_err(|problem| problem.at(path))?;
    let mut indices = Vec::new();
    write_file(path, |out| {
        indices = glb_blocks(layout, &mut Regions::new(out), blocks)?;
        Ok(())
    })?;
    Ok(indices)
}

fn glb_blocks(
    layout: &GlbLayout,
    regions: &mut Regions<'_, '_>,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<Vec<u64>, WriteProblem> {
    let mut glb = glb::Glb::begin(layout, regions);
    counted(layout.counts(), regions, &mut |block, regions| glb.block(block, regions), blocks)?;
    Ok(glb.finish(regions)?)
}

/// Passes blocks on, and checks that their totals match the counts.
fn counted(
    counts: MeshCounts,
    regions: &mut Regions<'_, '_>,
    encode: &mut Encode<'_>,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    let mut found = MeshCounts { vertices: 0, triangles: 0 };
    blocks(&mut |block| {
        found.vertices += block.vertices.len() as u64;
        found.triangles += block.triangles.len() as u64;
        if found.vertices > counts.vertices || found.triangles > counts.triangles {
            return Err(io::Error::other("the mesh has more vertices or triangles than its counts say"));
        }
        encode(block, regions)
    })?;
    if found == counts {
        return Ok(());
    }
    let MeshCounts { vertices, triangles } = counts;
    let what = format!(
        "the mesh has {} vertices and {} triangles, but its counts say {vertices} and {triangles}",
        found.vertices, found.triangles
    );
    Err(WriteProblem::NotStorable(what))
}

/// File that is written in several regions: vertices, and the data after them.
struct Regions<'a, 'b> {
    out: &'a mut BufWriter<&'b File>,
    /// Offset at which each region continues.
    next: Vec<u64>,
    /// Current offset in the file.
    at: u64,
}

impl<'a, 'b> Regions<'a, 'b> {
    fn new(out: &'a mut BufWriter<&'b File>) -> Self {
        Self { out, next: vec![0; 2], at: 0 }
    }

    /// Appends to a region.
    fn write(&mut self, region: usize, bytes: &[u8]) -> io::Result<()> {
        self.write_at(self.next[region], bytes)?;
        self.next[region] += bytes.len() as u64;
        Ok(())
    }

    fn write_at(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        if offset != self.at {
            self.out.seek(SeekFrom::Start(offset))?;
        }
        self.out.write_all(bytes)?;
        self.at = offset + bytes.len() as u64;
        Ok(())
    }
}

/// Appends floats as bytes, the lowest first.
fn floats(bytes: &mut Vec<u8>, numbers: impl IntoIterator<Item = f32>) {
    bytes.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
}

/// Converts `v` for formats in which it runs upward.
fn turned_over(v: f32) -> f32 {
    (1.0 - f64::from(v)) as f32
}
