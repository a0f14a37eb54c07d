//! Reader of a scene's files. It reads each file once, within the memory limit.

use super::file_material::add_pictures;
use super::ramp::{outside_remark, tinted};
use super::{MeshChoice, RampChoice, SceneError, SurfaceSpec};
use crate::environment::Environment;
use crate::material_maps::{MaterialMap, MaterialMapError, MaterialMaps, MaterialPictures};
use crate::motif::{MotifFile, MotifOptions, read_motif};
use relief_core::mesh::{Mesh, UvProjection};
use relief_core::{BYTES_PER_TILE_TRIANGLE, ByteSize, HeightMap, MotifTree, Wrap};
use relief_io::{
    ColorTable, Curve, Files, GreenSign, HeightFile, HeightOptions, MaterialTextures, MeshColors,
    MeshMaterial, MeshOptions, NormalMap, Picture, ReadError, ReadNote, ReadProblem, Remark, Up, VolumeFile,
    VolumeOptions, omissions, read_color_table,
};
use relief_mesh::shell_map::{MotifForRays, motif_for_rays};
use relief_shaders::Selection;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes per texel of a height map while it is rendered: itself, and the exact tracer's hierarchy
/// or the GPU's copy.
const BYTES_PER_HEIGHT: u64 = 4 + 7;

/// Further bytes per texel of a height map with levels of detail: a third more of itself and of
/// what is built on it, derived normals, and temporary memory.
const BYTES_OF_LEVELS: u64 = 16;

/// Bytes per texel of a normal map: as read, and as the shaders read it with coarser levels.
/// Reading is limited by the first.
const NORMAL_BYTES: [u64; 2] = [12, 16 + 11 + 8];

/// Bytes per texel of a picture as it is read.
const READ_BYTES: u64 = 16;

/// Bytes per texel of a colour map with its coarser levels.
const COLOR_BYTES: u64 = READ_BYTES + 6;

/// Bytes per triangle of a mesh while it is rendered: itself, its vertices, and the backends'
/// hierarchies and triangles.
pub(super) const BYTES_PER_TRIANGLE: u64 = 640;

/// Mesh and colours of a file.
#[derive(Clone)]
pub(super) struct LoadedMesh {
    pub mesh: Mesh,
    pub colors: Option<Arc<MeshColors>>,
}

/// Motif of a file.
#[derive(Clone)]
pub(super) struct LoadedMotif {
    pub tree: MotifTree,
    /// Metres of the heights 0 and 1 above the base, without a bias.
    pub heights_m: [f64; 2],
}

/// Reads maps, each file once, within the memory limit.
pub struct Maps<'a> {
    files: &'a Files,
    limit: ByteSize,
    left: u64,
    heights: Vec<(PathBuf, HeightOptions, HeightMap)>,
    colors: Vec<(PathBuf, Arc<Picture>)>,
    /// Colours by height, with the texels that they belong to.
    tints: Vec<(RampChoice, HeightMap, Arc<Picture>)>,
    meshes: Vec<(PathBuf, MeshOptions, LoadedMesh)>,
    motifs: Vec<(PathBuf, MotifOptions, LoadedMotif)>,
    materials: Vec<([Option<PathBuf>; MaterialMap::ALL.len()], Wrap, Arc<MaterialMaps>)>,
    /// Notes of the file readers.
    notes: Vec<ReadNote>,
}

impl<'a> Maps<'a> {
    /// Creates a reader of `files` with `left` bytes for maps, out of the whole limit.
    pub fn new(files: &'a Files, limit: ByteSize, left: u64) -> Self {
        Self {
            files,
            limit,
            left,
            heights: Vec::new(),
            colors: Vec::new(),
            tints: Vec::new(),
            meshes: Vec::new(),
            motifs: Vec::new(),
            materials: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Notes of the file readers.
    pub fn into_notes(self) -> Vec<ReadNote> {
        self.notes
    }

    /// Returns the files that are read.
    pub(super) fn files(&self) -> &'a Files {
        self.files
    }

    /// Returns the bytes that are left.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Reads the height map of a file.
    pub(super) fn height(&mut self, path: &Path, options: HeightOptions) -> Result<HeightMap, SceneError> {
        let same = |(known, with, _): &&(PathBuf, HeightOptions, _)| {
            known == path && HeightOptions { max_bytes: options.max_bytes, ..with.clone() } == options
        };
        if let Some((_, _, map)) = self.heights.iter().find(same) {
            return Ok(map.clone());
        }
        let HeightFile { map, notes } = relief_io::read_height_file(self.files.source(path), &options)?;
        self.notes.extend(notes);
        self.heights.push((path.to_owned(), options, map.clone()));
        Ok(map)
    }

    /// Reads the volume of a file, and counts its memory. `wrap` stands for the file's.
    pub(super) fn volume(
        &mut self,
        path: &Path,
        wrap: Option<Wrap>,
        selection: &Selection,
    ) -> Result<VolumeFile, SceneError> {
        let options = VolumeOptions { wrap, max_bytes: self.left };
        let file = relief_io::read_volume(self.files.source(path), &options).map_err(SceneError::Volume)?;
        self.take(path, file.volume.atlas(), selection)?;
        Ok(file)
    }

    /// Reads the motif of a file, and counts its memory.
    pub(super) fn motif(&mut self, path: &Path, options: MotifOptions) -> Result<LoadedMotif, SceneError> {
        let is_same = |(known, with, _): &&(PathBuf, MotifOptions, _)| {
            known == path && MotifOptions { max_bytes: options.max_bytes, ..*with } == options
        };
        if let Some((_, _, loaded)) = self.motifs.iter().find(is_same) {
            return Ok(loaded.clone());
        }
        let MotifFile { mesh, scale_m, low_m, is_coarse, axes, .. } =
            read_motif(self.files.source(path), &options)?;
        let of_motif = |source| SceneError::NoMotif { path: path.to_owned(), source };
        let MotifForRays { tree, beyond } = motif_for_rays(&mesh).map_err(of_motif)?;
        let needed = BYTES_PER_TILE_TRIANGLE * u64::from(tree.triangles());
        self.left = self.left.checked_sub(needed).ok_or_else(|| {
            let problem = ReadProblem::MeshMemory { limit: self.limit.0 };
            SceneError::Motif(ReadError { path: path.to_owned(), problem }.into())
        })?;
        if beyond > 0.0 {
            let percent = (1000.0 * beyond).round() / 10.0;
            let what = format!(
                "{percent} % of its vertices lie below height 0 or above height 1, where it is cut off"
            );
            self.remark(path, vec![Remark::new(&omissions::MOTIF_BEYOND, what)]);
        }
        if axes.is_none() && !tree.is_closed() {
            let what = "it is not closed: its inside is seen where it is open";
            self.remark(path, vec![Remark::new(&omissions::OPEN_MOTIF, what)]);
        }
        if is_coarse {
            let what = "it has 8 bits a channel, whose steps show as terraces: export floats or 16 bits";
            self.remark(path, vec![Remark::new(&omissions::COARSE_VECTORS, what)]);
        }
        let loaded = LoadedMotif { tree, heights_m: [low_m, low_m + scale_m] };
        self.motifs.push((path.to_owned(), options, loaded.clone()));
        Ok(loaded)
    }

    /// Reads the colour picture of a file.
    pub(super) fn color(&mut self, path: &Path) -> Result<Arc<Picture>, SceneError> {
        if let Some((_, color)) = self.colors.iter().find(|(known, _)| known == path) {
            return Ok(Arc::clone(color));
        }
        let color = Arc::new(
            relief_io::read_picture(self.files.source(path), self.left).map_err(SceneError::Picture)?,
        );
        self.note(path);
        self.take_picture(&color);
        self.colors.push((path.to_owned(), Arc::clone(&color)));
        Ok(color)
    }

    /// Returns the colours of a height map, read from `path`, by a table.
    pub(super) fn tints(
        &mut self,
        ramp: &RampChoice,
        path: &Path,
        map: &HeightMap,
    ) -> Result<Arc<Picture>, SceneError> {
        let is_same = |(known, of, _): &&(RampChoice, HeightMap, _)| {
            known == ramp && of.shares_texels(map) && of.physical_range() == map.physical_range()
        };
        if let Some((.., tints)) = self.tints.iter().find(is_same) {
            return Ok(Arc::clone(tints));
        }
        let table = match ramp {
            RampChoice::Builtin(builtin) => ColorTable::from(*builtin),
            RampChoice::File(path) => {
                read_color_table(self.files.source(path)).map_err(SceneError::Picture)?
            }
        };
        let (width, height) = (map.width(), map.height());
        let needed = COLOR_BYTES * u64::from(width) * u64::from(height);
        if needed > self.left {
            let problem = ReadProblem::TooMuchMemory { width, height, needed, limit: self.left };
            return Err(SceneError::Picture(ReadError { path: path.to_owned(), problem }));
        }
        let tints =
            tinted(map, &table).map_err(|source| SceneError::Ramp { path: path.to_owned(), source })?;
        if let (RampChoice::File(path), true) = (ramp, table.has_opacity()) {
            let what = "its opacities are left out: colours by height are opaque";
            self.remark(path, vec![Remark::new(&omissions::TABLE_OPACITY, what)]);
        }
        self.remark(path, outside_remark(map, &table).into_iter().collect());
        let tints = Arc::new(tints);
        self.take_picture(&tints);
        self.tints.push((ramp.clone(), map.clone(), Arc::clone(&tints)));
        Ok(tints)
    }

    /// Reads the mesh of a file as placed in the file, with its colours if `colors` is true.
    pub(super) fn mesh(
        &mut self,
        path: &Path,
        (projection, up): (Option<UvProjection>, Option<Up>),
        colors: bool,
    ) -> Result<LoadedMesh, SceneError> {
        let options = MeshOptions { projection, up, colors, materials: colors, max_bytes: self.left };
        let is_same = |(known, with, _): &&(PathBuf, MeshOptions, _)| {
            known == path && MeshOptions { max_bytes: options.max_bytes, ..*with } == options
        };
        let loaded = match self.meshes.iter().find(is_same) {
            Some((_, _, loaded)) => loaded.clone(),
            None => {
                let file =
                    relief_io::read_mesh(self.files.source(path), &options).map_err(SceneError::Mesh)?;
                let colors = file.colors.map(Arc::new);
                let mut pictures: Vec<&Arc<Picture>> = Vec::new();
                for picture in
                    colors.iter().flat_map(|colors| &colors.materials).flat_map(MeshMaterial::pictures)
                {
                    if !pictures.iter().any(|known| Arc::ptr_eq(known, picture)) {
                        pictures.push(picture);
                    }
                }
                for picture in pictures {
                    self.take_picture(picture);
                }
                self.remark(path, file.notes);
                let loaded = LoadedMesh { mesh: file.mesh, colors: colors.clone() };
                self.meshes.push((path.to_owned(), options, loaded.clone()));
                loaded
            }
        };
        // Each surface has a copy of the mesh, placed in world space.
        let needed = BYTES_PER_TRIANGLE * loaded.mesh.triangles().len() as u64;
        self.left = self.left.checked_sub(needed).ok_or_else(|| {
            let problem = ReadProblem::MeshMemory { limit: self.limit.0 };
            SceneError::Mesh(ReadError { path: path.to_owned(), problem })
        })?;
        Ok(loaded)
    }

    /// Reads the normal map of a file.
    pub(super) fn normal(&mut self, path: &Path, green: GreenSign) -> Result<NormalMap, SceneError> {
        let [read, converted] = NORMAL_BYTES;
        let limit = self.left / (read + converted) * read;
        let map =
            relief_io::read_normal_map(self.files.source(path), green, limit).map_err(SceneError::Picture)?;
        self.note(path);
        self.spend((read + converted) * u64::from(map.width) * u64::from(map.height));
        Ok(map)
    }

    /// Reads the material maps of a surface whose maps have that wrap, over the pictures of its mesh's
    /// file. `None` if there are none.
    pub(super) fn material(
        &mut self,
        spec: &SurfaceSpec,
        wrap: Wrap,
        of_file: Option<&MaterialTextures>,
    ) -> Result<Option<Arc<MaterialMaps>>, SceneError> {
        let files = spec.material_files().map(|(_, file)| file.clone());
        if files.iter().all(Option::is_none) && of_file.is_none() {
            return Ok(None);
        }
        let is_same = |(of, with, _): &&(_, Wrap, _)| of_file.is_none() && (of, *with) == (&files, wrap);
        if let Some((.., known)) = self.materials.iter().find(is_same) {
            return Ok(Some(Arc::clone(known)));
        }
        let mut pictures = MaterialPictures::default();
        for ((what, file), picture) in MaterialMap::ALL.into_iter().zip(&files).zip(&mut pictures) {
            let Some(path) = file else { continue };
            let curve = if what == MaterialMap::Emission { Curve::Srgb } else { Curve::Linear };
            let read = relief_io::read_picture_as(self.files.source(path), curve, self.left)
                .map_err(SceneError::Picture)?;
            self.note(path);
            self.spend(READ_BYTES * u64::from(read.width) * u64::from(read.height));
            *picture = Some(read);
        }
        if let Some(textures) = of_file {
            add_pictures(&mut pictures, textures);
        }
        let path_of = |files: &[Option<PathBuf>]| match (&spec.mesh, files.iter().flatten().next()) {
            (_, Some(file)) => file.clone(),
            (Some(MeshChoice::File(file)), None) => file.clone(),
            _ => PathBuf::new(),
        };
        let size = MaterialMaps::size_of(&pictures);
        let texels = u64::from(size[0]) * u64::from(size[1]);
        let needed = MaterialMaps::BYTES_PER_TEXEL * texels;
        if needed > self.left {
            let path = path_of(&files);
            let source = MaterialMapError::Memory { needed: ByteSize(needed), left: ByteSize(self.left) };
            return Err(SceneError::MaterialMap { path, source });
        }
        self.spend(needed);
        let maps = MaterialMaps::new(&pictures, wrap).map_err(|(what, source)| {
            let path = files[what as usize].clone().unwrap_or_else(|| path_of(&[]));
            SceneError::MaterialMap { path, source }
        })?;
        let maps = Arc::new(maps);
        if of_file.is_none() {
            self.materials.push((files, wrap, Arc::clone(&maps)));
        }
        Ok(Some(maps))
    }

    /// Subtracts the memory of a normal map that has been read.
    pub(super) fn take_normals(&mut self, [width, height]: [u32; 2]) {
        self.spend(NORMAL_BYTES[1] * u64::from(width) * u64::from(height));
    }

    /// Subtracts bytes from the memory that is left.
    pub(super) fn spend(&mut self, bytes: u64) {
        self.left = self.left.saturating_sub(bytes);
    }

    /// Adds notes on data that a file's reader left out or changed.
    pub(super) fn remark(&mut self, path: &Path, remarks: Vec<Remark>) {
        self.notes.extend(remarks.into_iter().map(|remark| remark.of(path)));
    }

    /// Notes what the header of a picture says that is not followed. It has been read.
    fn note(&mut self, path: &Path) {
        self.notes.extend(relief_io::read_notes(self.files.source(path)).unwrap_or_default());
    }

    /// Subtracts the memory of a colour picture.
    pub(super) fn take_picture(&mut self, picture: &Picture) {
        let texels = u64::from(picture.width) * u64::from(picture.height);
        self.spend(COLOR_BYTES * texels);
    }

    /// Reads the environment map of a file.
    pub fn environment(&mut self, path: &Path) -> Result<Environment, SceneError> {
        let [of_texel, kept] = Environment::BYTES;
        let limit = self.left / (READ_BYTES + of_texel) * READ_BYTES;
        let picture = relief_io::read_picture(self.files.source(path), limit).map_err(SceneError::Picture)?;
        self.note(path);
        let environment = Environment::from_equirectangular(&picture);
        let environment =
            environment.map_err(|source| SceneError::Environment { path: path.to_owned(), source })?;
        self.spend(kept);
        Ok(environment)
    }

    /// Subtracts the memory of triangles around a height map.
    pub(super) fn take_triangles(
        &mut self,
        path: &Path,
        map: &HeightMap,
        count: u64,
    ) -> Result<(), SceneError> {
        let (width, height) = (map.width(), map.height());
        let needed = BYTES_PER_TRIANGLE.saturating_mul(count);
        let (left, limit) = (self.left, self.limit);
        self.left = left.checked_sub(needed).ok_or_else(|| {
            let path = path.to_owned();
            SceneError::TooMuchToTrace { path, width, height, needed, left, limit }
        })?;
        Ok(())
    }

    /// Subtracts the memory of a height map and what is built on it.
    pub(super) fn take(
        &mut self,
        path: &Path,
        map: &HeightMap,
        selection: &Selection,
    ) -> Result<(), SceneError> {
        let (width, height) = (map.width(), map.height());
        let maps = relief_maps::Maps::in_memory();
        let baked = maps.bytes(selection, [width, height])?;
        let at_hand = maps.working_bytes(selection, [width, height])?;
        let of_levels = if selection.has_levels() { BYTES_OF_LEVELS } else { 0 };
        let texels = u64::from(width) * u64::from(height);
        let needed = ((BYTES_PER_HEIGHT + of_levels) * texels).saturating_add(baked).saturating_add(at_hand);
        let (left, limit) = (self.left, self.limit);
        self.left = left.checked_sub(needed).ok_or_else(|| {
            let path = path.to_owned();
            SceneError::TooMuchToTrace { path, width, height, needed, left, limit }
        })?;
        Ok(())
    }
}
