//! Loading of surfaces: defaults, checks and files.

use super::builder::{
    AMBIENT_ENVIRONMENT, DEFAULT_METHOD, DEFAULT_METHOD_OF_MOTIFS, DEFAULT_METHOD_OF_OBJECTS,
    DEFAULT_METHOD_OF_VOLUMES, of_selection,
};
use super::depth::depth_remark;
use super::error::{SceneError, ValueError, ValueProblem};
use super::extinction::check_extinction;
use super::file_material::FileMaterials;
use super::maps::{LoadedMesh, LoadedMotif, Maps};
use super::material_spec::{metallic_roughness, reads_materials};
use super::metres::{MAX_METRES, check_metres};
use super::normal_green::green_remark;
use super::solids::{folded_remark, ground_of, ground_of_motif};
use super::surface_colors::{DrawnColors, DrawnMaterial};
use super::surface_spec::environment;
use super::walls::{triangles_of_walls, walls};
use super::{BaseThickness, Look, MeshChoice, ObjectProblem, SceneObject, Surface, SurfaceSpec};
use crate::material::{Material, ShadingModel};
use crate::motif::MotifOptions;
use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::{Builtin, Mesh, Placement, UvProjection, square};
use relief_core::object::ImageObject;
use relief_core::{HeightMap, MotifTree, TileTriangle, Volume, Wrap};
use relief_io::{
    Convention, Fill, HeightOptions, HeightRange, MeshColors, MeshMaterial, Remark, VolumeFile, omissions,
};
use relief_object::{ObjectFile, ObjectOptions};
use relief_shaders::field::Solids;
use relief_shaders::surface::{Proposal, Shown};
use relief_shaders::{
    AMBIENT, DETAIL, Entry, GEOMETRY, REFINE, SEARCH, SHADE, SHADOW, SHADOW_SEARCH, STAGES, SURFACE,
    Selection,
};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Detail variant for pictures with several samples per pixel, if the search's maps can have levels
/// of detail.
const FOOTPRINT: &str = "footprint";

/// Method and shadow of a mesh without a height map. The triangles cast shadows on each other.
const METHOD_OF_MESHES: &str = "bump";
const SHADOW_OF_MESHES: &str = "map";

/// Key that a projection needs.
const MESH_OF_FILE: &str = "mesh FILE";

/// Linear colour of the walls of blocks: earth.
const COLOR_OF_WALLS: Vec3 = Vec3::new(0.24, 0.17, 0.12);

/// Default displacement between heights 0 and 1 in metres, if neither the scene nor the height
/// map's file states one.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Deepest relief that counts as ground, as a part of the longer side of a tile. No landscape is
/// nearly as deep. A deeper file is a model without a unit or with a wrong one.
const DEEPEST_GROUND: f64 = 0.75;

/// Deepest relief that counts as ground if the file names the unit of its heights, as a part of the
/// longer side of a tile. Cliffs are that steep.
const DEEPEST_NAMED: f64 = 2.0;

/// Depth at which a model that is no ground is shown, as a part of the shorter side of a tile. Much
/// deeper ones would hide their lowest parts.
const DEPTH_OF_NO_GROUND: f64 = 0.25;

/// Most tiles along an axis; its inverse is the fewest. Beyond it, `f32` cannot distinguish the
/// texels of a tile, and much farther it overflows.
pub(super) const MAX_TILES: f32 = 1e6;

/// Valid lengths of a tile in metres.
pub(super) const LENGTHS_M: std::ops::RangeInclusive<f64> = 1e-9..=MAX_METRES;

/// Valid factors on the scale.
pub(super) const EXAGGERATIONS: std::ops::RangeInclusive<f64> = 1e-6..=1e6;

/// Largest factor on a mesh; its inverse is the smallest. Lengths in metres then stay within the
/// range of `f32` arithmetic.
pub(super) const MAX_SIZE: f64 = 1e6;

/// Parts of a surface that need no file, completed and checked.
pub struct Parts {
    mesh: Mesh,
    material: Material,
    selection: Selection,
    /// `None` stands for the height map's file or the default.
    scale_m: Option<f64>,
    /// `None` stands for minus the scale.
    bias_m: Option<f64>,
    /// Factor on the scale, and on the bias if it is not given.
    exaggerate: f64,
    two_sided: bool,
    holes: bool,
    creases: bool,
}

/// Values of the scene that a surface depends on.
#[derive(Clone, Copy, Debug, Default)]
pub struct SceneContext {
    pub look: Look,
    /// Whether the scene has an environment map.
    pub has_environment: bool,
    /// Whether the scene has several surfaces.
    pub several: bool,
    /// Columns and rows of the picture, or an assumed size.
    pub size: [u32; 2],
}

impl Parts {
    /// Returns the variants of all stages.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }
}

impl SurfaceSpec {
    /// Returns the parts that need no file, completed and checked, for `samples` samples per pixel.
    pub(super) fn parts(&self, samples: u32, context: &SceneContext) -> Result<Parts, ValueError> {
        if let Some(key) = self.key_of_relief().filter(|_| self.object.is_some()) {
            return Err(ValueProblem::Excludes("object").of(key));
        }
        if let Some(key) = self.key_of_heights().filter(|_| self.volume.is_some()) {
            return Err(ValueProblem::Excludes("volume").of(key));
        }
        if self.motif.is_some() {
            if self.volume.is_some() {
                return Err(ValueProblem::Excludes("motif").of("volume"));
            }
            if let Some(key) = self.key_of_heights() {
                return Err(ValueProblem::Excludes("motif").of(key));
            }
            if let Some(wrap) = self.wrap.filter(|wrap| *wrap != Wrap::Repeat) {
                return Err(ValueProblem::WrapOfMotif(wrap).of("wrap"));
            }
            if self.scale == Some(0.0) {
                return Err(ValueProblem::Number { value: 0.0, must: "above 0" }.of("scale"));
            }
        } else if self.axes.is_some() {
            return Err(ValueProblem::Needs("motif").of("axes"));
        }
        self.scale.map_or(Ok(()), check_scale)?;
        check_metres("bias", self.bias.as_slice())?;
        self.extinction.map_or(Ok(()), check_extinction)?;
        if let Some(value) = self.exaggerate.filter(|factor| !EXAGGERATIONS.contains(factor)) {
            return Err(ValueProblem::Number { value, must: "from 1e-6 to 1e6" }.of("exaggerate"));
        }
        if let Some(&value) = self.tile_size.iter().flatten().find(|length| !LENGTHS_M.contains(length)) {
            return Err(ValueProblem::Number { value, must: "from 1e-9 to 1e9 metres" }.of("tile-size"));
        }
        if let Some([low, high]) = self.range.and_then(HeightRange::between)
            && !(low.is_finite() && high.is_finite() && low < high)
        {
            let (value, must) =
                if low.is_finite() { (high, "finite and above the first") } else { (low, "finite") };
            return Err(ValueProblem::Number { value, must }.of("range"));
        }
        if let Some([low, high]) = self.elevation {
            check_metres("elevation", &[low, high])?;
            if low >= high {
                let must = "above the first";
                return Err(ValueProblem::Number { value: high, must }.of("elevation"));
            }
        }
        if let Some(value) = self.nodata.filter(|value| !value.is_finite()) {
            let must = "finite, as texels that are NaN or infinite never have a value";
            return Err(ValueProblem::Number { value, must }.of("nodata"));
        }
        if self.project.is_some() && !matches!(self.mesh, Some(MeshChoice::File(_))) {
            return Err(ValueProblem::Needs(MESH_OF_FILE).of("project"));
        }
        if self.mesh_up.is_some() && !matches!(self.mesh, Some(MeshChoice::File(_))) {
            return Err(ValueProblem::Needs(MESH_OF_FILE).of("mesh-up"));
        }
        if self.ramp.is_some() && self.color.is_some() {
            return Err(ValueProblem::Excludes("color").of("ramp"));
        }
        if self.ramp.is_some() && self.is_mesh_alone() && self.textures.is_none() {
            return Err(ValueProblem::Needs("height").of("ramp"));
        }
        if self.base.is_some() && self.walls != Some(true) {
            return Err(ValueProblem::Needs("walls").of("base"));
        }
        let (metres, must) = match self.base.unwrap_or_default() {
            BaseThickness::Metres(metres) => (metres, "above 0 and at most 1e9 metres"),
            BaseThickness::Share(share) => (share, "above 0 and at most 1e9"),
        };
        if !(metres > 0.0 && metres <= MAX_METRES) {
            return Err(ValueProblem::Number { value: metres, must }.of("base"));
        }
        let selection = self.selection(samples, context)?;
        if self.has_walls() {
            self.check_walls(&selection)?;
        }
        Ok(Parts {
            mesh: self.placed(self.mesh_without_file([1.0, 1.0])?)?,
            material: self.material_of(None, &selection)?,
            selection,
            scale_m: self.scale,
            bias_m: self.bias,
            exaggerate: self.exaggerate.unwrap_or(1.0),
            two_sided: self.two_sided.unwrap_or_default(),
            holes: self.holes.unwrap_or_default(),
            creases: self.creases.unwrap_or_default(),
        })
    }

    /// Returns whether walls close the relief to a block.
    pub(super) fn has_walls(&self) -> bool {
        self.walls == Some(true)
    }

    /// Refuses walls around another mesh than a plane, or around a relief that shows no sides.
    fn check_walls(&self, selection: &Selection) -> Result<(), ValueError> {
        let is_plane = matches!(
            self.mesh,
            None | Some(MeshChoice::Builtin(Builtin::Plane)) | Some(MeshChoice::Builtin(Builtin::Square))
        );
        if !is_plane {
            return Err(ValueProblem::WallsOfMesh.of("walls"));
        }
        let paths = selection.paths();
        let is_searched = paths.has_relief() && !selection.choices[SEARCH].entry.is_idle();
        match paths.shown {
            Shown::Relief if is_searched && paths.proposal == Proposal::Shells => Ok(()),
            Shown::Triangles => Ok(()),
            _ => Err(ValueProblem::WallsOfBase.of("walls")),
        }
    }

    /// Makes the walls and the bottom of a loaded surface: a surface without a relief, with its
    /// shading.
    pub(super) fn load_walls(
        &self,
        surface: &Surface,
        samples: u32,
        context: &SceneContext,
        maps: &mut Maps<'_>,
    ) -> Result<Surface, SceneError> {
        let shadow = STAGES[SHADOW].first(Entry::is_idle).map(|(_, entry)| entry.name);
        // Nothing lies beside a block, so only other surfaces cast shadows on its walls.
        let shadow = shadow.filter(|_| !context.several).map(|name| (STAGES[SHADOW].key, name));
        let named = |stage: usize| Some((STAGES[stage].key, surface.selection().choices[stage].entry.name));
        let is_free = surface.selection().choices[AMBIENT].entry.maps.is_empty();
        let is_named =
            surface.selection().sees_environment() || self.stages.contains_key(STAGES[AMBIENT].key);
        let ambient = named(AMBIENT).filter(|_| is_free && is_named);
        let stages = [named(SHADE), ambient, shadow].into_iter().flatten();
        let spec = SurfaceSpec {
            mesh: Some(MeshChoice::File(PathBuf::new())),
            stages: stages.map(|(key, name)| (key.to_owned(), name.to_owned())).collect(),
            ..SurfaceSpec::default()
        };
        let selection = spec.selection(samples, context)?;
        let material = spec.material_of(Some(COLOR_OF_WALLS), &selection)?;
        let path = self.height.as_deref().unwrap_or(Path::new(""));
        maps.take_triangles(path, surface.height_map(), triangles_of_walls(surface))?;
        let mesh = walls(surface, self.base.unwrap_or_default())
            .map_err(|error| ValueProblem::from(error).of("walls"))?;
        let level = level_map(None)?.with_displacement(0.0, 0.0);
        let level = level.map_err(|error| ValueProblem::from(error).of("walls"))?;
        Ok(Surface::new(mesh, level).with_material(material).with_selection(selection))
    }

    /// Replaces the mesh of `parts` by a square.
    pub(super) fn on_a_square(&self, parts: Parts) -> Result<Parts, ValueError> {
        let mesh = square(1).map_err(|error| ValueProblem::from(error).of("mesh"))?;
        Ok(Parts { mesh: self.placed(mesh)?, ..parts })
    }

    /// Returns the surface with placeholders for the files of its relief or object, and no other
    /// maps.
    pub(super) fn stand_in(&self, parts: Parts) -> Result<Surface, ValueError> {
        if self.object.is_none() {
            let problem = |problem: relief_core::HeightMapError| ValueProblem::from(problem).of("height");
            let flat = HeightMap::new(1, 1, vec![0.0], self.wrap.unwrap_or_default()).map_err(problem)?;
            let surface = self.with_heights(parts, flat)?;
            if self.motif.is_some() {
                let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
                let triangle = TileTriangle { corners, normals: [Vec3::Z; 3] };
                let motif =
                    MotifTree::new(&[triangle]).map_err(|error| ValueProblem::from(error).of("motif"))?;
                let (scale_m, bias_m) = (surface.height_map().scale_m(), surface.height_map().bias_m());
                return surface.with_motif(motif, scale_m, bias_m).map_err(problem);
            }
            if self.volume.is_none() {
                return Ok(surface);
            }
            let volume = Volume::new([1; 3], &[0.0], self.wrap.unwrap_or_default());
            return Ok(surface.with_volume(volume.map_err(|error| ValueProblem::from(error).of("volume"))?));
        }
        let problem = |problem: ObjectProblem| ValueProblem::from(problem).of("object");
        let object = self.placed_object(&SceneObject::stand_in().map_err(problem)?)?;
        let surface = Surface::of_object(object).map_err(problem)?;
        Ok(surface.with_material(parts.material).with_selection(parts.selection))
    }

    /// Loads the surface of an object's file.
    fn load_object(&self, path: &Path, parts: Parts, maps: &mut Maps<'_>) -> Result<Surface, SceneError> {
        let options = ObjectOptions { max_bytes: maps.left(), ..ObjectOptions::default() };
        let ObjectFile { object, color, normal, .. } =
            relief_object::read_object(maps.files().source(path), &options)?;
        maps.take(path, object.heights(), &parts.selection)?;
        let object = self.placed_object(&object)?;
        let surface = if parts.selection.blends_normals() && !object.has_solid() {
            Surface::of_object_in_ball(object)
        } else {
            Surface::of_object(object)
        };
        let surface = surface.map_err(|error| ValueProblem::from(error).of("object"))?;
        let under = || {
            if reads_materials(&parts.selection) { Vec3::ONE } else { Material::under_colours().diffuse() }
        };
        let material = self.material_of(color.is_some().then(under), &parts.selection)?;
        let mut surface = surface.with_material(material).with_selection(parts.selection);
        if let Some(color) = color {
            maps.take_picture(&color);
            surface = surface.with_color(color);
        }
        // Silhouettes have normals of their own.
        if let Some(normal) = normal.filter(|_| parts.selection.has_normals_of_relief()) {
            maps.take_normals([normal.width, normal.height]);
            surface = surface.with_normal_map(&normal);
        }
        Ok(surface.with_creases(parts.creases))
    }

    fn placed_object(&self, object: &ImageObject) -> Result<ImageObject, ValueError> {
        object.placed(&self.placement()?).map_err(|error| ValueProblem::from(error).of("position"))
    }

    /// Returns the surface with a given height map, and no other maps.
    pub(super) fn with_heights(&self, parts: Parts, map: HeightMap) -> Result<Surface, ValueError> {
        let map = match self.tile_size {
            Some([u, v]) => {
                let size_m = [u / f64::from(map.width()), v / f64::from(map.height())];
                map.with_texel_size_m(size_m)
            }
            None => Ok(map),
        };
        let map = map.map_err(|error| ValueProblem::from(error).of("tile-size"))?;
        // All other meshes do not depend on the height map.
        let mesh = match self.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(Builtin::Plane) => self.placed(self.mesh_without_file(map.proportions())?)?,
            _ => parts.mesh,
        };
        let stated_m = map.stated_displacement_m();
        // A volume or a motif keeps its proportions: in larger tiles it is as much deeper.
        let is_solid = self.volume.is_some() || self.motif.is_some();
        let stated_m = match map.stated_tile_m() {
            Some([u, v]) if is_solid => {
                let [tile_u, tile_v] = mesh.tile_m();
                let larger = (tile_u * tile_v / (u * v)).sqrt();
                stated_m.map(|[low, high]| [larger * low, larger * high])
            }
            _ => stated_m,
        };
        // The part of the scale that a volume lies above the surface. Heights of a given scale are carved.
        let low = stated_m.filter(|[low, high]| is_solid && high > low);
        let carved = if self.motif.is_some() { 0.0 } else { -1.0 };
        let low = low.map_or(carved, |[low, high]| low / (high - low));
        let stated_m = stated_m.filter(|_| parts.scale_m.is_none());
        let of_mesh_alone = self.is_mesh_alone().then_some(0.0);
        let scale_m =
            parts.scale_m.or(of_mesh_alone).or(stated_m.map(|[low, high]| high - low)).or_else(|| {
                let stated = stated_scale_m(&map, &mesh)?;
                let [u, v] = mesh.tile_m();
                let deepest = if map.has_named_heights() { DEEPEST_NAMED } else { DEEPEST_GROUND };
                let is_ground = stated <= deepest * u.max(v);
                Some(if is_ground { stated } else { DEPTH_OF_NO_GROUND * u.min(v) })
            });
        let scale_m = parts.exaggerate * scale_m.unwrap_or(DEFAULT_SCALE_M);
        check_scale(scale_m)?;
        let low_m = stated_m.map_or(low * scale_m, |[low, _]| parts.exaggerate * low);
        let map = map
            .with_displacement(scale_m, parts.bias_m.unwrap_or(low_m))
            .map_err(|error| ValueProblem::from(error).of("scale"))?;
        Ok(Surface::new(mesh, map)
            .with_material(parts.material)
            .with_selection(parts.selection)
            .with_two_sided(parts.two_sided)
            .with_holes(parts.holes)
            .with_creases(parts.creases))
    }

    /// Loads the surface with its maps.
    pub(super) fn load(
        &self,
        parts: Parts,
        number: Option<usize>,
        maps: &mut Maps<'_>,
    ) -> Result<Surface, SceneError> {
        if let Some(path) = &self.object {
            let surface = self.load_object(path, parts, maps);
            return surface.map_err(|error| match error {
                SceneError::Value(error) => error.of_surface(number).into(),
                error => error,
            });
        }
        let has_solid = self.volume.is_some() || self.motif.is_some();
        if self.height.is_none() && !has_solid && !self.is_mesh_alone() {
            return Err(SceneError::NoHeightMap(number));
        }
        let of_number = |error: ValueError| error.of_surface(number);
        let (mut parts, of_file) = match &self.mesh {
            Some(MeshChoice::File(file)) => {
                // Under Blinn-Phong a colour of the surface's own replaces the file's materials.
                let reads = !self.has_own_color() || reads_materials(&parts.selection);
                // A mesh without any map needs no texture coordinates.
                let is_bare = self.is_mesh_alone()
                    && self.project.is_none()
                    && self.color.is_none()
                    && self.normal.is_none();
                let loaded = match maps.mesh(file, (self.project, self.mesh_up), reads) {
                    Err(SceneError::Mesh(error)) if is_bare && error.problem.is_of_texture_coordinates() => {
                        maps.mesh(file, (Some(UvProjection::Box), self.mesh_up), reads)
                    }
                    loaded => loaded,
                };
                let LoadedMesh { mesh, colors } = loaded?;
                // Pictures use the file's texture coordinates, regardless of tiles.
                let of_file = colors.map(|colors| (file, colors, mesh.clone()));
                let mesh = self.placed(mesh).map_err(of_number)?;
                (Parts { mesh, ..parts }, of_file)
            }
            _ => (parts, None),
        };
        // Beyond a block there is no ground, unless its map is shown several times.
        let is_single = self.tile.is_none_or(|tile| tile.iter().all(|tile| *tile <= 1.0));
        let wrap_of_block = (self.has_walls() && is_single).then_some(Wrap::Clamp);
        let options = HeightOptions {
            channel: self.channel.clone(),
            convention: self.depth.map(|depth| if depth { Convention::Depth } else { Convention::Height }),
            range: self.range,
            elevation_m: self.elevation,
            nodata: self.nodata,
            unit: self.unit,
            raw: self.raw,
            fill: match self.fill {
                None if parts.holes => Fill::Always,
                None => Fill::Elevation,
                Some(true) => Fill::Always,
                Some(false) => Fill::Never,
            },
            wrap: self.wrap.or(wrap_of_block),
            max_bytes: maps.left(),
        };
        let volume = match &self.volume {
            Some(path) => Some(maps.volume(path, self.wrap, &parts.selection)?),
            None => None,
        };
        let motif = match &self.motif {
            Some(path) => {
                let (axes, tile_m, scale_m) = (self.axes, parts.mesh.tile_m(), parts.scale_m.take());
                let motif =
                    maps.motif(path, MotifOptions { axes, tile_m, scale_m, max_bytes: maps.left() })?;
                parts.bias_m = parts.bias_m.map(|bias_m| bias_m + parts.exaggerate * motif.heights_m[0]);
                Some(motif)
            }
            None => None,
        };
        let map = match (&self.height, &volume) {
            (Some(path), _) => maps.height(path, options)?,
            (None, Some(volume)) => ground_of(volume).map_err(of_number)?,
            (None, None) => match &motif {
                Some(motif) => ground_of_motif(motif.heights_m, parts.mesh.tile_m()).map_err(of_number)?,
                None => level_map(of_file.as_ref().and_then(|(_, colors, _)| wrap_of_normals(colors)))?,
            },
        };
        let splits = parts.selection.geometry().is_none();
        let has_own_color = self.has_own_color();
        let file_colors =
            of_file.as_ref().filter(|_| !has_own_color).map(|(_, colors, _)| Arc::clone(colors));
        let mut drawn = of_file.as_ref().and_then(|(file, colors, mesh)| {
            let mut remarks = Vec::new();
            let has_picture = colors.materials.iter().any(MeshMaterial::has_placed_pictures);
            if has_picture && self.tile.is_some_and(|tile| tile != [1.0, 1.0]) {
                let what = "its picture is tiled as the height map is";
                remarks.push(Remark::new(&omissions::TILED_PICTURE, what));
            }
            let drawn = DrawnColors::of(colors, mesh, splits, &mut remarks);
            maps.remark(file, remarks);
            drawn
        });
        let mut of_materials = FileMaterials::new(self, &parts.selection);
        for material in drawn.iter_mut().flat_map(DrawnColors::materials_mut) {
            of_materials.complete(material, maps).map_err(|error| match error {
                SceneError::Value(error) => of_number(error).into(),
                error => error,
            })?;
        }
        let remarks = of_materials.into_remarks();
        if let Some((file, ..)) = of_file {
            maps.remark(file, remarks);
        }
        parts.material = match &drawn {
            Some(DrawnColors::One(DrawnMaterial { material: Some(material), .. })) => *material,
            _ => self.material_of(None, &parts.selection).map_err(of_number)?,
        };
        if let Some(path) = &self.height {
            // Each material is drawn with maps of its own.
            let times = match &drawn {
                Some(DrawnColors::Several(colors)) => colors.materials.len(),
                _ => 1,
            };
            for _ in 0..times {
                maps.take(path, &map, &parts.selection)?;
            }
        }
        let tints = match (&self.ramp, &self.height) {
            (Some(ramp), Some(path)) => Some(maps.tints(ramp, path, &map)?),
            (Some(_), None) => return Err(of_number(ValueProblem::Needs("height").of("ramp")).into()),
            (None, _) => None,
        };
        let surface = self.with_heights(parts, map);
        let mut surface = surface.map_err(of_number)?;
        if let Some(path) = &self.height {
            maps.remark(path, depth_remark(surface.height_map(), surface.metric()).into_iter().collect());
        }
        if let Some(LoadedMotif { tree, .. }) = motif {
            let (scale_m, bias_m) = (surface.height_map().scale_m(), surface.height_map().bias_m());
            let shown = surface.with_motif(tree, scale_m, bias_m);
            surface = shown.map_err(|error| of_number(ValueProblem::from(error).of("scale")))?;
        }
        if let Some(VolumeFile { volume, .. }) = volume {
            let (scale_m, bias_m) = (surface.height_map().scale_m(), surface.height_map().bias_m());
            let volume = volume.with_displacement(scale_m, bias_m);
            let volume = volume.map_err(|error| of_number(ValueProblem::from(error).of("scale")))?;
            surface = surface.with_volume(volume);
            surface = self.with_extinction(surface, scale_m).map_err(of_number)?;
        }
        if let Some(path) = self.motif.as_ref().or(self.volume.as_ref()) {
            maps.remark(path, folded_remark(&surface).into_iter().collect());
        }
        if let Some(path) = &self.color {
            surface = surface.with_color(maps.color(path)?);
        }
        if let Some(tints) = tints {
            surface = surface.with_color(tints);
        }
        if let Some(path) = &self.normal {
            let map = maps.normal(path, self.green.unwrap_or_default())?;
            if self.green.is_none() {
                maps.remark(path, green_remark(surface.height_map(), &map).into_iter().collect());
            }
            surface = surface.with_normal_map(&map);
        }
        let wrap = surface.height_map().wrap();
        if let Some(material_maps) = maps.material(self, wrap, None)? {
            let (path, remarks) = self.remarks_on_factors(&material_maps);
            maps.remark(path, remarks);
            surface = surface.with_material_maps(material_maps);
        }
        Ok(match drawn {
            Some(DrawnColors::One(material)) => surface.with_file_material(material, has_own_color),
            Some(DrawnColors::Several(mut colors)) => {
                if has_own_color {
                    let own = |drawn: DrawnMaterial| surface.with_own_color(drawn);
                    colors.materials = colors.materials.into_iter().map(own).collect();
                }
                surface.with_colors(Arc::new(colors))
            }
            None => surface,
        }
        .with_file_colors(file_colors))
    }

    /// Returns whether the mesh of a file is shown without a height map.
    pub(super) fn is_mesh_alone(&self) -> bool {
        let has_relief =
            self.height.is_some() || self.volume.is_some() || self.motif.is_some() || self.object.is_some();
        !has_relief && matches!(self.mesh, Some(MeshChoice::File(_)))
    }

    /// Returns the number of tiles along `u` and `v`.
    fn tiles(&self) -> Result<[f32; 2], ValueError> {
        let tiles = self.tile.unwrap_or([1.0, 1.0]);
        let possible = 1.0 / MAX_TILES..=MAX_TILES;
        match tiles.iter().find(|tiles| !possible.contains(tiles)) {
            Some(&value) => {
                let must = "from 1e-6 to 1e6";
                Err(ValueProblem::Number { value: f64::from(value), must }.of("tile"))
            }
            None => Ok(tiles),
        }
    }

    /// Returns the built-in mesh for a height map with these proportions of its tile, or a square
    /// for a file's mesh.
    fn mesh_without_file(&self, [u, v]: [f64; 2]) -> Result<Mesh, ValueError> {
        let [across, down] = self.tiles()?.map(f64::from);
        let mesh = match self.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(builtin) => builtin.build([u * across, v * down]),
            MeshChoice::File(_) => square(1),
        };
        mesh.map_err(|error| ValueProblem::from(error).of("mesh"))
    }

    /// Returns a mesh in world space, with its tiles.
    fn placed(&self, mesh: Mesh) -> Result<Mesh, ValueError> {
        let mesh =
            mesh.tiled(Vec2::from(self.tiles()?)).map_err(|error| ValueProblem::from(error).of("tile"))?;
        let placement = self.placement()?;
        mesh.placed(&placement).map_err(|error| ValueProblem::from(error).of("position"))
    }

    /// Returns the placement in world space.
    fn placement(&self) -> Result<Placement, ValueError> {
        let placement = Placement {
            position_m: self.position.unwrap_or_default().into(),
            rotation_degrees: self.rotation.unwrap_or_default().into(),
            size: self.mesh_scale.unwrap_or(1.0),
        };
        check_metres("position", self.position.as_ref().map_or(&[], |position| position))?;
        if let Some(&value) = self.rotation.iter().flatten().find(|turn| !turn.is_finite()) {
            return Err(ValueProblem::Number { value, must: "finite" }.of("rotation"));
        }
        if !(1.0 / MAX_SIZE..=MAX_SIZE).contains(&placement.size) {
            let (value, must) = (placement.size, "from 1e-6 to 1e6");
            return Err(ValueProblem::Number { value, must }.of("mesh-scale"));
        }
        Ok(placement)
    }

    /// Returns the variants of all stages. With several samples per pixel, minified maps are
    /// filtered, too, if the search's maps can have levels of detail.
    fn selection(&self, samples: u32, context: &SceneContext) -> Result<Selection, ValueError> {
        if samples > 1 && !self.stages.contains_key(STAGES[DETAIL].key) {
            let selection = self.selection_in(Some(FOOTPRINT), context)?;
            let has_levels = selection.object_cells().is_none() && selection.solids() == Solids::Heights;
            if has_levels && selection.check_levels().is_ok() {
                return Ok(selection);
            }
        }
        self.selection_in(None, context)
    }

    /// Returns the selection, with `detail` in place of the method's.
    fn selection_in(&self, detail: Option<&str>, context: &SceneContext) -> Result<Selection, ValueError> {
        let named = |stage: usize| self.stages.get(STAGES[stage].key).map(String::as_str);
        let selection = match (&self.method, named(SEARCH), named(REFINE)) {
            (Some(_), None, None) if named(GEOMETRY).is_some() => {
                return Err(ValueProblem::Excludes("geometry").of("method"));
            }
            (method, None, None) => {
                let default = match self.object {
                    Some(_) => DEFAULT_METHOD_OF_OBJECTS,
                    None if self.volume.is_some() => DEFAULT_METHOD_OF_VOLUMES,
                    None if self.motif.is_some() => DEFAULT_METHOD_OF_MOTIFS,
                    None if self.is_mesh_alone() => METHOD_OF_MESHES,
                    None => DEFAULT_METHOD,
                };
                Selection::method(method.as_deref().unwrap_or(default))
            }
            (None, Some(search), Some(refine)) => Selection::pair(search, refine),
            (None, Some(_), None) => return Err(ValueProblem::Needs("refine").of("search")),
            (None, None, Some(_)) => return Err(ValueProblem::Needs("search").of("refine")),
            (Some(_), _, _) => return Err(ValueProblem::Excludes("search and refine").of("method")),
        };
        let mut selection = selection.map_err(of_selection)?;
        if self.volume.is_some() {
            selection = selection.with_solids(Solids::Volumes);
        }
        if self.motif.is_some() {
            selection = selection.with_solids(Solids::Motifs);
        }
        if self.extinction.is_some() && !selection.is_translucent() {
            return Err(ValueProblem::NotTranslucent.of("extinction"));
        }
        if let Some(detail) = detail {
            selection.choose(STAGES[DETAIL].key, detail).map_err(of_selection)?;
        }
        // The sides of a block are seen, where a relief on polygons shows nothing.
        let is_named = [GEOMETRY, SURFACE].iter().any(|stage| named(*stage).is_some());
        if self.has_walls() && !is_named && selection.geometry().is_none() {
            let shells = STAGES[SURFACE].first(|entry| entry.paths().proposal == Proposal::Shells);
            if let Some((_, entry)) = shells {
                selection.choose(STAGES[SURFACE].key, entry.name).map_err(of_selection)?;
            }
        }
        let model = self.shading_model()?;
        let is_rough =
            model.map_or(context.look.shades_materials(), |model| model == ShadingModel::MetallicRoughness);
        if is_rough {
            selection.choose(STAGES[SHADE].key, metallic_roughness()).map_err(of_selection)?;
        }
        let sees_environment = context.has_environment || self.asks_for_environment();
        if sees_environment {
            selection.choose(STAGES[AMBIENT].key, environment()).map_err(of_selection)?;
        }
        if self.is_mesh_alone() {
            selection.choose(STAGES[SHADOW].key, SHADOW_OF_MESHES).map_err(of_selection)?;
        }
        // A shadow takes over the view's search with its settings, unless it has its own.
        for is_of_shadow in [false, true] {
            let of_part = |key: &&String| key.starts_with(STAGES[SHADOW].key) == is_of_shadow;
            for key in self.stages.keys().filter(of_part) {
                selection.choose(key, &self.stages[key]).map_err(of_selection)?;
            }
            let is_named = |stage: usize| self.stages.contains_key(STAGES[stage].key);
            if !is_of_shadow && !sees_environment && !is_named(AMBIENT) {
                context.look.light_from_sky(&mut selection, !self.is_mesh_alone(), context.size);
            }
            let sets_search =
                self.set.keys().any(|key| key.split('.').next() == Some(STAGES[SHADOW_SEARCH].key));
            let has_shadow =
                self.is_mesh_alone() || is_named(SHADOW) || is_named(SHADOW_SEARCH) || sets_search;
            if is_of_shadow && context.several && !has_shadow {
                context.look.share_shadows(&mut selection, context.size);
            }
            for key in self.set.keys().filter(of_part) {
                selection.set(key, self.set[key]).map_err(of_selection)?;
            }
        }
        let is_read = selection.sees_environment() || reads_materials(&selection);
        if self.ior.is_some_and(|ior| ior != Material::default().ior()) && !is_read {
            return Err(ValueProblem::Needs(&AMBIENT_ENVIRONMENT).of("ior"));
        }
        if !selection.uses(SHADOW_SEARCH) {
            let search = STAGES[SHADOW_SEARCH].key;
            if self.stages.contains_key(search) {
                return Err(ValueProblem::NoShadowRays.of(search));
            }
            if self.set.keys().any(|key| key.split('.').next() == Some(search)) {
                return Err(ValueProblem::NoShadowRays.of("set"));
            }
        }
        Ok(selection)
    }
}

/// Returns the height map of a mesh that is shown without one: one texel at the mesh's level.
/// Normals of the mesh's file have its wrap.
fn level_map(wrap: Option<Wrap>) -> Result<HeightMap, SceneError> {
    let map = HeightMap::new(1, 1, vec![1.0], wrap.unwrap_or(Wrap::Repeat));
    Ok(map.map_err(|error| ValueProblem::from(error).of("height"))?)
}

/// Returns the wrap of the pictures of normals, if all have the same along both axes.
fn wrap_of_normals(colors: &MeshColors) -> Option<Wrap> {
    let of = |material: &MeshMaterial| material.values.textures.normal.as_ref().map(|of| of.wrap);
    let mut wraps = colors.materials.iter().filter_map(of).flatten();
    let first = wraps.next()?;
    wraps.all(|wrap| wrap == first).then_some(first)
}

fn check_scale(scale_m: f64) -> Result<(), ValueError> {
    if (0.0..=MAX_METRES).contains(&scale_m) {
        return Ok(());
    }
    Err(ValueProblem::Number { value: scale_m, must: "from 0 to 1e9 metres" }.of("scale"))
}

/// Returns the scale that gives the relief the proportions stated in the height map's file.
///
/// The ratio of depth to a tile's side is the same on the mesh as in the file, as the geometric
/// mean of both directions. On a plane both directions agree.
pub(super) fn stated_scale_m(map: &HeightMap, mesh: &Mesh) -> Option<f64> {
    let (tile, span) = map.stated_lengths()?;
    let [u, v] = mesh.tile_m();
    Some(span * (u / tile[0] * (v / tile[1])).sqrt())
}
