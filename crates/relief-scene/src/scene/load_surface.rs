//! Loading of a surface: its mesh, height map, colours and other maps from their files.

use super::depth::depth_remark;
use super::error::{SceneError, ValueError, ValueProblem};
use super::file_material::FileMaterials;
use super::maps::{LoadedMesh, LoadedMotif, Maps};
use super::material_spec::reads_materials;
use super::normal_green::green_remark;
use super::solids::{folded_remark, ground_of, ground_of_motif};
use super::surface_colors::{DrawnColors, DrawnMaterial};
use super::surface_parts::Parts;
use super::{MeshChoice, Surface, SurfaceSpec};
use crate::motif::MotifOptions;
use relief_core::mesh::UvProjection;
use relief_core::{HeightMap, Wrap};
use relief_io::{Convention, Fill, HeightOptions, MeshColors, MeshMaterial, Remark, VolumeFile, omissions};
use std::sync::Arc;

impl SurfaceSpec {
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
}

/// Returns the height map of a mesh that is shown without one: one texel at the mesh's level.
/// Normals of the mesh's file have its wrap.
pub(super) fn level_map(wrap: Option<Wrap>) -> Result<HeightMap, SceneError> {
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
