//! Meshes to files, block by block, one file a format.

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

pub use glb::{GlbLayout, GlbLevel, GlbMaterials, GlbNode, Quantization};
pub use shells::{MAX_SHELLS, Shells, write_shells};

use super::MeshFormat;
use super::up::{Up, comment};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// How large a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshCounts {
    /// Vertices.
    pub vertices: u64,
    /// Triangles.
    pub triangles: u64,
}

/// Takes the next block of a mesh.
pub type MeshSink<'a> = dyn FnMut(&MeshBlock) -> io::Result<()> + 'a;

/// What a writer does with each block.
type Encode<'a> = dyn FnMut(&MeshBlock, &mut Regions<'_, '_>) -> io::Result<()> + 'a;

impl MeshFormat {
    /// The bytes of a mesh's file in this format: exactly, but of OBJ, which is text, at least.
    pub fn bytes(self, counts: MeshCounts) -> u64 {
        match self {
            MeshFormat::Gltf => GlbLayout::of(counts).bytes(),
            MeshFormat::Obj => obj::least_bytes(counts),
            MeshFormat::Ply => ply::bytes(counts),
            MeshFormat::Stl => stl::bytes(counts),
        }
    }

    /// Whether this format can hold so large a mesh.
    ///
    /// # Errors
    ///
    /// When it cannot, with what holds it.
    pub fn check(self, counts: MeshCounts) -> Result<(), WriteProblem> {
        if self == MeshFormat::Gltf {
            return GlbLayout::of(counts).check();
        }
        check_counts(counts)
    }
}

/// Whether so many vertices and triangles can be numbered, and are any.
fn check_counts(MeshCounts { vertices, triangles }: MeshCounts) -> Result<(), WriteProblem> {
    let cannot = |what: &str| {
        let of = format!("a mesh of {vertices} vertices and {triangles} triangles");
        Err(WriteProblem::NotStorable(format!("{of} {what}")))
    };
    if vertices == 0 || triangles == 0 {
        return cannot("shows nothing");
    }
    if vertices >= u64::from(u32::MAX) || triangles > u64::from(u32::MAX) {
        return cannot("has more than 32-bit numbers count: make it coarser");
    }
    Ok(())
}

/// Writes a mesh whose blocks `blocks` hands over: as binary glTF (GLB), as binary PLY, as OBJ, or as binary
/// STL.
///
/// | format | lengths | what is written |
/// | --- | --- | --- |
/// | GLB | metres | positions, normals, tangents, texture coordinates |
/// | PLY | metres | positions, normals, texture coordinates `s` and `t`, `t` upward |
/// | OBJ | metres | the same; a block's faces follow its vertices |
/// | STL | millimetres | triangles with their normals |
///
/// In an STL `z` is up, in the others `y`, as in memory; [`write_mesh_standing`] has it otherwise.
///
/// A tangent's `w` is such that the green of glTF's normal maps points up in the picture. Nothing but a block
/// is held. The same blocks give the same bytes.
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
/// When the format [cannot hold](MeshFormat::check) the mesh, when `blocks` fails or hands over other counts
/// than it promised, or when the file cannot be written. Nothing is left behind then.
pub fn write_mesh(
    path: &Path,
    format: MeshFormat,
    counts: MeshCounts,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_mesh_standing(path, format, &Standing::usual(format), counts, blocks)
}

/// How a mesh stands in its file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The axis that points up.
    pub up: Up,
    /// The height that becomes 0, in metres.
    pub base_m: f64,
}

impl Standing {
    /// As is usual in a format, with heights as they are.
    pub const fn usual(format: MeshFormat) -> Self {
        Self { up: Up::usual(format), base_m: 0.0 }
    }

    /// A position as the file has it. `units` is how many of its units are a metre.
    fn point(&self, position: Vec3, units: f64) -> Vec3 {
        let position = if self.base_m == 0.0 && units == 1.0 {
            position
        } else {
            ((position.as_dvec3() - DVec3::Y * self.base_m) * DVec3::splat(units)).as_vec3()
        };
        self.up.stored(position)
    }
}

/// Writes a mesh as [`write_mesh`] does, standing as `standing` says. A GLB always has `y` up.
///
/// # Errors
///
/// As [`write_mesh`]; and when a GLB is to stand otherwise than is usual.
pub fn write_mesh_standing(
    path: &Path,
    format: MeshFormat,
    standing: &Standing,
    counts: MeshCounts,
    blocks: impl FnOnce(&mut MeshSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    format.check(counts).map_err(|problem| problem.at(path))?;
    if format == MeshFormat::Gltf && *standing != Standing::usual(format) {
        let problem = WriteProblem::NotStorable("a GLB has y up, and heights as they are".to_owned());
        return Err(problem.at(path));
    }
    let comment = comment(format, standing.up);
    write_file(path, |out| {
        let mut regions = Regions::new(out);
        match format {
            MeshFormat::Gltf => {
                glb_blocks(&GlbLayout::of(counts), &mut regions, blocks)?;
            }
            MeshFormat::Ply => {
                ply::begin(counts, &comment, &mut regions)?;
                counted(counts, &mut regions, &mut |block, to| ply::block(block, standing, to), blocks)?;
            }
            MeshFormat::Obj => {
                regions.write(0, format!("# {comment}\n").as_bytes())?;
                counted(counts, &mut regions, &mut |block, to| obj::block(block, standing, to), blocks)?;
            }
            MeshFormat::Stl => {
                stl::begin(counts, &comment, &mut regions)?;
                counted(counts, &mut regions, &mut |block, to| stl::block(block, standing, to), blocks)?;
            }
        }
        Ok(())
    })
}

/// Writes a GLB of one mesh or several levels of detail, in floats or integers, whose blocks `blocks` hands
/// over: those of the finest level first, and each level whole before the next. Vertices are numbered from 0
/// in each. Nothing but a block is held. The same blocks give the same bytes. Gives the number of indices of
/// each level: three a triangle, or as many as its [strip](GlbLayout::strips) takes.
///
/// In integers, positions are rounded to the nearest points of the lattice; a mesh that was rounded already
/// stays as it is. See [`Quantization`] for what is stored.
///
/// # Errors
///
/// When a GLB [cannot hold](GlbLayout::check) it, when `blocks` fails or hands over other counts than it
/// promised, when a position lies beyond the lattice or texture coordinates beyond 0 and 1 that were promised
/// to lie between, when strips are longer than 4 GiB or have no triangle, or when the file cannot be written.
/// Nothing is left behind then.
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

/// Hands blocks on, and finds out whether they are as many as was promised.
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
            return Err(io::Error::other("there is more of the mesh than was promised"));
        }
        encode(block, regions)
    })?;
    if found == counts {
        return Ok(());
    }
    let MeshCounts { vertices, triangles } = counts;
    let what = format!(
        "the mesh has {} vertices and {} triangles where {vertices} and {triangles} were promised",
        found.vertices, found.triangles
    );
    Err(WriteProblem::NotStorable(what))
}

/// A file that is written in several places: vertices, and what follows all of them.
struct Regions<'a, 'b> {
    out: &'a mut BufWriter<&'b File>,
    /// Where each goes on.
    next: Vec<u64>,
    /// Where the file is written.
    at: u64,
}

impl<'a, 'b> Regions<'a, 'b> {
    fn new(out: &'a mut BufWriter<&'b File>) -> Self {
        Self { out, next: vec![0; 2], at: 0 }
    }

    /// Goes on with a region.
    fn write(&mut self, region: usize, bytes: &[u8]) -> io::Result<()> {
        self.write_at(self.next[region], bytes)?;
        self.next[region] += bytes.len() as u64;
        Ok(())
    }

    fn write_at(&mut self, place: u64, bytes: &[u8]) -> io::Result<()> {
        if place != self.at {
            self.out.seek(SeekFrom::Start(place))?;
        }
        self.out.write_all(bytes)?;
        self.at = place + bytes.len() as u64;
        Ok(())
    }
}

/// The bytes of floats, the least first.
fn floats(bytes: &mut Vec<u8>, numbers: impl IntoIterator<Item = f32>) {
    bytes.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
}

/// `v` as it is stored where it runs up.
fn turned_over(v: f32) -> f32 {
    (1.0 - f64::from(v)) as f32
}
