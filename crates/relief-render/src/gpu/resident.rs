//! Cache of a surface's data on the GPU. A part is uploaded, or built there, when it changed. Maps
//! and meshes are compared by address, settings by their bytes.

use std::sync::Arc;

use relief_core::{BakedMap, HeightMap, TexelMask, Wrap};
use relief_shaders::MapSlot;
use relief_shaders::cpu::{Shared, SurfaceSettings, write_all};
use relief_shaders::wgsl::Sampling;
use wgpu::{BindGroup, BindGroupLayout, BindingResource, Buffer, BufferUsages, Sampler, TextureView};

use super::draw_call::DrawCall;
use super::layouts::group;
use super::pass_clock::PassClock;
use super::programs::Layouts;
use super::pyramid::Builder;
use super::shells::Shells;
use super::tessellate::{Tessellated, Tessellator};
use super::textures::{self, Precision};
use super::{Gpu, GpuError, pyramid, shells};
use crate::job::{JobSurface, Triangles};
use crate::mipmaps::Mipmaps;

/// Uniform buffer and the bytes that were written last.
#[derive(Debug)]
pub struct Uniform {
    buffer: Buffer,
    bytes: Vec<u8>,
}

impl Uniform {
    /// Creates a uniform buffer of zeros.
    pub fn new<T: Shared>(gpu: &Gpu, label: &str) -> Self {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        Self { buffer: gpu.buffer(label, T::SIZE as u64, usage), bytes: Vec::new() }
    }

    /// Writes a value unless the buffer holds it. Returns whether it changed.
    pub fn set<T: Shared>(&mut self, gpu: &Gpu, value: T) -> bool {
        let bytes = write_all(&[value]);
        let is_other = bytes != self.bytes;
        if is_other {
            gpu.write(&self.buffer, 0, &bytes);
            self.bytes = bytes;
        }
        is_other
    }

    /// Returns the binding of the buffer.
    pub fn resource(&self) -> BindingResource<'_> {
        self.buffer.as_entire_binding()
    }
}

/// Texture of a map, and the map from which it was made.
#[derive(Debug)]
struct CachedTexture<T> {
    of: Option<T>,
    view: TextureView,
}

/// Source of a slot's map.
#[derive(Clone, Debug)]
enum SlotSource {
    /// The map is uploaded.
    Baked(Arc<BakedMap>),
    /// The map is built on the GPU.
    Pyramid(pyramid::Source),
}

impl SlotSource {
    /// Returns the source of a surface's slot, or `None` if the slot is not read.
    fn of(surface: &JobSurface, slot: MapSlot, builder: Option<&Builder>) -> Option<Self> {
        let given = surface.maps.iter().find(|(of, _)| *of == slot);
        let built = || pyramid::Source::of(surface, slot).filter(|_| builder.is_some());
        match given {
            Some((_, map)) => Some(Self::Baked(Arc::clone(map))),
            None => built().map(Self::Pyramid),
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Baked(a), Self::Baked(b)) => Arc::ptr_eq(a, b),
            (Self::Pyramid(a), Self::Pyramid(b)) => a.is_same(b),
            _ => false,
        }
    }
}

/// Uploads a map if it is another one than before. Returns whether it was.
fn update_texture<T: Clone>(
    held: &mut Option<CachedTexture<T>>,
    of: Option<&T>,
    is_same: impl Fn(&T, &T) -> bool,
    upload: impl FnOnce() -> Result<TextureView, GpuError>,
) -> Result<bool, GpuError> {
    let is_held = |held: &CachedTexture<T>| match (&held.of, of) {
        (Some(a), Some(b)) => is_same(a, b),
        (None, None) => true,
        _ => false,
    };
    if held.as_ref().is_some_and(is_held) {
        return Ok(false);
    }
    // The old one is dropped first, so that both need not fit into memory.
    *held = None;
    *held = Some(CachedTexture { of: of.cloned(), view: upload()? });
    Ok(true)
}

/// Data of a surface on the GPU.
#[derive(Debug)]
pub struct Resident {
    settings: Uniform,
    precision: Option<Precision>,
    heights: Option<CachedTexture<Arc<HeightMap>>>,
    /// Number of the height map's mip levels on the GPU.
    height_levels: u32,
    holes: Option<CachedTexture<Arc<TexelMask>>>,
    color: Option<CachedTexture<Arc<Mipmaps>>>,
    normals: Option<CachedTexture<Arc<Mipmaps>>>,
    materials: Option<CachedTexture<Arc<Mipmaps>>>,
    slots: [Option<CachedTexture<SlotSource>>; MapSlot::ALL.len()],
    sampler: Option<(Wrap, Sampler)>,
    mesh: Option<(Arc<Triangles>, BindGroup)>,
    shells: Option<Shells>,
    tessellated: Option<Tessellated>,
    /// Group 0, with the sampling and the number of [`Common`] for which it was made.
    maps: Option<(Sampling, u64, MapGroups)>,
}

/// Group 0 of a surface: for the camera, and for lights, which do not read shadow maps.
#[derive(Clone, Debug)]
pub struct MapGroups {
    pub for_camera: BindGroup,
    pub for_lights: BindGroup,
    /// Whether the groups or the settings changed since the last picture.
    pub changed: bool,
}

/// Triangles of a surface, ready to be drawn.
#[derive(Debug)]
pub struct ResidentMesh {
    /// Group 1.
    pub group: BindGroup,
    /// Group 2 of the pass that traces, if there are shells.
    pub shells: Option<BindGroup>,
    /// The shells' BVH, if there are any.
    pub shell_nodes: Option<Buffer>,
    pub drawn: DrawCall,
    /// Whether the triangles changed since the last picture.
    pub is_other: bool,
}

/// Bindings of group 0 that all surfaces share. They changed if `number` did.
pub struct Common<'a> {
    pub number: u64,
    pub frame: BindingResource<'a>,
    pub passes: BindingResource<'a>,
    /// Builder of pyramids, if any have to be built.
    pub builder: Option<&'a Builder>,
    /// Shadow maps, if surfaces read them.
    pub light_map: Option<&'a TextureView>,
}

impl Resident {
    /// Creates a surface without any data on the GPU.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            settings: Uniform::new::<SurfaceSettings>(gpu, "surface settings"),
            precision: None,
            heights: None,
            height_levels: 0,
            holes: None,
            color: None,
            normals: None,
            materials: None,
            slots: [const { None }; MapSlot::ALL.len()],
            sampler: None,
            mesh: None,
            shells: None,
            tessellated: None,
            maps: None,
        }
    }

    /// Uploads the maps and settings that changed, and returns group 0.
    pub fn maps(
        &mut self,
        gpu: &Gpu,
        surface: &JobSurface,
        sampling: Sampling,
        layout: &BindGroupLayout,
        common: &Common,
    ) -> Result<MapGroups, GpuError> {
        let changed = self.update_maps(gpu, surface, sampling, common.builder)?;
        let mut settings = surface.settings;
        for (map, held) in settings.maps.iter_mut().zip(&self.slots) {
            // The job has no map with this size.
            if matches!(held, Some(CachedTexture { of: Some(SlotSource::Pyramid(_)), .. })) {
                map.texel_bytes = pyramid::NODE_BYTES;
            }
        }
        let others = self.settings.set(gpu, settings);
        if let Some((of, number, groups)) = &self.maps
            && !changed
            && (*of, *number) == (sampling, common.number)
        {
            return Ok(MapGroups { changed: others, ..groups.clone() });
        }
        let for_lights = self.group(gpu, sampling, layout, common, None);
        let for_camera = match common.light_map {
            Some(view) => self.group(gpu, sampling, layout, common, Some(view)),
            None => for_lights.clone(),
        };
        let groups = MapGroups { for_camera, for_lights, changed: true };
        self.maps = Some((sampling, common.number, groups.clone()));
        Ok(groups)
    }

    /// Uploads or tessellates the triangles, and returns group 1 with their draw call.
    pub fn mesh(
        &mut self,
        gpu: &Gpu,
        surface: &JobSurface,
        layouts: &Layouts,
        tessellator: Option<&Tessellator>,
        maps: &MapGroups,
        clock: Option<&PassClock>,
    ) -> Result<ResidentMesh, GpuError> {
        let triangles = &surface.triangles;
        let made_here = triangles.tessellation().zip(tessellator).zip(layouts.tessellated.as_ref());
        let Some(((of, tessellator), groups)) = made_here else {
            self.tessellated = None;
            let (group, is_other) = self.uploaded(gpu, triangles, &layouts.mesh)?;
            shells::update(&mut self.shells, gpu, surface, &layouts.shells)?;
            let shells = self.shells.as_ref();
            let shell_nodes = shells.map(|shells| shells.nodes.clone());
            let shells = shells.map(|shells| shells.group.clone());
            return Ok(ResidentMesh { group, shells, shell_nodes, drawn: DrawCall::of(surface), is_other });
        };
        (self.mesh, self.shells) = (None, None);
        if !self.tessellated.as_ref().is_some_and(|known| known.fits(gpu, of)) {
            // The old one is dropped first, so that both need not fit into memory.
            self.tessellated = None;
        }
        let is_new = self.tessellated.is_none();
        let tessellated = match &mut self.tessellated {
            Some(tessellated) => tessellated,
            none => none.insert(Tessellated::new(gpu, of, groups, &layouts.mesh)?),
        };
        let is_other_surface = is_new || maps.changed;
        let is_other = tessellated.make(gpu, of, tessellator, &maps.for_lights, is_other_surface, clock);
        let drawn = DrawCall::Indirect(tessellated.drawn().clone());
        Ok(ResidentMesh {
            group: tessellated.mesh().clone(),
            shells: None,
            shell_nodes: None,
            drawn,
            is_other,
        })
    }

    /// Waits for the GPU and returns the number of triangles tessellated last; 0 for other
    /// surfaces.
    pub async fn made_triangles(&self, gpu: &Gpu) -> Result<u64, GpuError> {
        match &self.tessellated {
            Some(tessellated) => tessellated.triangles(gpu).await,
            None => Ok(0),
        }
    }

    /// Returns the buffers of the last tessellation, if any.
    #[cfg(test)]
    pub fn tessellation_buffers(&self) -> Option<[&Buffer; 3]> {
        self.tessellated.as_ref().map(Tessellated::tessellation_buffers)
    }

    /// Uploads triangles unless they are cached. Returns their bind group, and whether they
    /// changed.
    fn uploaded(
        &mut self,
        gpu: &Gpu,
        triangles: &Arc<Triangles>,
        layout: &BindGroupLayout,
    ) -> Result<(BindGroup, bool), GpuError> {
        if let Some((of, group)) = &self.mesh
            && Arc::ptr_eq(of, triangles)
        {
            return Ok((group.clone(), false));
        }
        // The old one is dropped first, so that both need not fit into memory.
        self.mesh = None;
        let faces = gpu.filled("mesh_faces", triangles.faces(), BufferUsages::STORAGE)?;
        let corners = gpu.filled("mesh_corners", triangles.corners(), BufferUsages::STORAGE)?;
        let bound =
            [("mesh_faces", faces.as_entire_binding()), ("mesh_corners", corners.as_entire_binding())];
        let group = group(gpu.device(), "mesh", layout, &bound);
        self.mesh = Some((Arc::clone(triangles), group.clone()));
        Ok((group, true))
    }

    /// Uploads and builds the maps that changed. Returns whether any did.
    fn update_maps(
        &mut self,
        gpu: &Gpu,
        surface: &JobSurface,
        sampling: Sampling,
        builder: Option<&Builder>,
    ) -> Result<bool, GpuError> {
        let precision = Precision::of(gpu, sampling);
        if self.precision != Some(precision) {
            (self.heights, self.color, self.normals, self.materials) = (None, None, None, None);
            self.precision = Some(precision);
        }
        let levels = surface.settings.height_levels;
        if self.height_levels < levels {
            self.heights = None;
        }
        let mut changed = update_texture(
            &mut self.heights,
            Some(&surface.height_map),
            |a, b| a.shares_texels(b),
            || textures::heights(gpu, &surface.height_map, levels, precision),
        )?;
        if changed {
            self.height_levels = levels;
        }
        changed |= update_texture(&mut self.holes, surface.holes(), Arc::ptr_eq, || {
            textures::holes(gpu, surface.holes().map(Arc::as_ref))
        })?;
        changed |= update_texture(&mut self.color, surface.color.as_ref(), Arc::ptr_eq, || {
            textures::picture(gpu, "colour map", surface.color.as_deref(), precision, false)
        })?;
        changed |= update_texture(&mut self.normals, surface.normal_map.as_ref(), Arc::ptr_eq, || {
            textures::picture(gpu, "normal map", surface.normal_map.as_deref(), precision, true)
        })?;
        changed |= update_texture(&mut self.materials, surface.material_maps.as_ref(), Arc::ptr_eq, || {
            textures::picture(gpu, "material map", surface.material_maps.as_deref(), precision, true)
        })?;
        for (place, slot) in MapSlot::ALL.into_iter().enumerate() {
            let of = SlotSource::of(surface, slot, builder);
            // The searches of view and shadow usually read the same map. It is uploaded once.
            let (before, rest) = self.slots.split_at_mut(place);
            let is_same = |held: &&CachedTexture<SlotSource>| {
                held.of.as_ref().zip(of.as_ref()).is_some_and(|(a, b)| a.is_same(b))
            };
            let shared = before.iter().flatten().find(is_same).map(|held| held.view.clone());
            let heights = self.heights.as_ref().map(|held| &held.view);
            let make = || match (&of, builder, heights) {
                (Some(SlotSource::Pyramid(source)), Some(builder), Some(heights)) => {
                    Ok(textures::view(&builder.build(gpu, slot.name(), source, heights)?, true))
                }
                (Some(SlotSource::Baked(map)), ..) => textures::baked(gpu, slot, Some(map)),
                _ => textures::baked(gpu, slot, None),
            };
            changed |= update_texture(&mut rest[0], of.as_ref(), SlotSource::is_same, || {
                shared.map_or_else(make, Ok)
            })?;
        }
        let wrap = surface.height_map.wrap();
        if self.sampler.as_ref().is_none_or(|(of, _)| *of != wrap) {
            self.sampler = Some((wrap, textures::sampler(gpu, wrap)));
            changed = true;
        }
        Ok(changed)
    }

    fn group(
        &self,
        gpu: &Gpu,
        sampling: Sampling,
        layout: &BindGroupLayout,
        common: &Common,
        light_map: Option<&TextureView>,
    ) -> BindGroup {
        let mut bound = vec![
            ("surface_settings", self.settings.resource()),
            ("frame", common.frame.clone()),
            ("pass_settings", common.passes.clone()),
        ];
        let views = [
            ("height_map", self.heights.as_ref().map(|held| &held.view)),
            ("hole_map", self.holes.as_ref().map(|held| &held.view)),
            ("color_map", self.color.as_ref().map(|held| &held.view)),
            ("normal_map", self.normals.as_ref().map(|held| &held.view)),
            ("material_map", self.materials.as_ref().map(|held| &held.view)),
        ];
        let slots = MapSlot::ALL.into_iter().zip(&self.slots);
        let slots = slots.map(|(slot, held)| {
            let lights = light_map.filter(|_| slot == MapSlot::Lights);
            (slot.name(), lights.or(held.as_ref().map(|held| &held.view)))
        });
        for (name, view) in views.into_iter().chain(slots) {
            bound.extend(view.map(|view| (name, BindingResource::TextureView(view))));
        }
        if let Some((_, sampler)) = &self.sampler
            && sampling == Sampling::Fast
        {
            bound.push(("map_sampler", BindingResource::Sampler(sampler)));
        }
        group(gpu.device(), "maps", layout, &bound)
    }
}
