//! What of a surface lies on the GPU. A part is uploaded, or built there, when it is another one than before:
//! by its address, or of settings by their bytes.

use std::sync::Arc;

use relief_core::{BakedMap, HeightMap, TexelMask, Wrap};
use relief_shaders::MapSlot;
use relief_shaders::cpu::{Shared, SurfaceSettings, write_all};
use relief_shaders::wgsl::Sampling;
use wgpu::{BindGroup, BindGroupLayout, BindingResource, Buffer, BufferUsages, Sampler, TextureView};

use super::drawn::Drawn;
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

/// A uniform buffer and what was written last.
#[derive(Debug)]
pub struct Uniform {
    buffer: Buffer,
    bytes: Vec<u8>,
}

impl Uniform {
    /// One of zeros.
    pub fn new<T: Shared>(gpu: &Gpu, label: &str) -> Self {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        Self { buffer: gpu.buffer(label, T::SIZE as u64, usage), bytes: Vec::new() }
    }

    /// Writes a value unless it is there. True when it was not.
    pub fn set<T: Shared>(&mut self, gpu: &Gpu, value: T) -> bool {
        let bytes = write_all(&[value]);
        let is_other = bytes != self.bytes;
        if is_other {
            gpu.write(&self.buffer, 0, &bytes);
            self.bytes = bytes;
        }
        is_other
    }

    /// What is bound.
    pub fn resource(&self) -> BindingResource<'_> {
        self.buffer.as_entire_binding()
    }
}

/// A map on the GPU, and what it was made from.
#[derive(Debug)]
struct Held<T> {
    of: Option<T>,
    view: TextureView,
}

/// What the map of a slot is made from.
#[derive(Clone, Debug)]
enum SlotSource {
    /// It is uploaded.
    Baked(Arc<BakedMap>),
    /// It is built here.
    Pyramid(pyramid::Source),
}

impl SlotSource {
    /// What a slot of a surface reads, if anything.
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

/// Holds another map where it is another one. True when it is.
fn hold<T: Clone>(
    held: &mut Option<Held<T>>,
    of: Option<&T>,
    is_same: impl Fn(&T, &T) -> bool,
    upload: impl FnOnce() -> Result<TextureView, GpuError>,
) -> Result<bool, GpuError> {
    let is_held = |held: &Held<T>| match (&held.of, of) {
        (Some(a), Some(b)) => is_same(a, b),
        (None, None) => true,
        _ => false,
    };
    if held.as_ref().is_some_and(is_held) {
        return Ok(false);
    }
    // What was held goes first, so that both need not fit.
    *held = None;
    *held = Some(Held { of: of.cloned(), view: upload()? });
    Ok(true)
}

/// A surface on the GPU.
#[derive(Debug)]
pub struct Resident {
    settings: Uniform,
    precision: Option<Precision>,
    heights: Option<Held<Arc<HeightMap>>>,
    /// How many levels of the height map are there.
    height_levels: u32,
    holes: Option<Held<Arc<TexelMask>>>,
    color: Option<Held<Arc<Mipmaps>>>,
    normals: Option<Held<Arc<Mipmaps>>>,
    slots: [Option<Held<SlotSource>>; MapSlot::ALL.len()],
    sampler: Option<(Wrap, Sampler)>,
    mesh: Option<(Arc<Triangles>, BindGroup)>,
    shells: Option<Shells>,
    tessellated: Option<Tessellated>,
    /// Group 0, with what it was made for. None where a part has changed.
    maps: Option<(Sampling, u64, MapGroups)>,
}

/// Group 0 of a surface, for the camera, and for lights, which do not see what lights see.
#[derive(Clone, Debug)]
pub struct MapGroups {
    pub seen: BindGroup,
    pub by_lights: BindGroup,
    /// Whether they, or the settings, are others than for the last picture.
    pub changed: bool,
}

/// The triangles of a surface, ready to be drawn.
#[derive(Debug)]
pub struct ResidentMesh {
    /// Group 1.
    pub group: BindGroup,
    /// Group 2 of the pass that traces, where there are shells.
    pub shells: Option<BindGroup>,
    pub drawn: Drawn,
    /// Whether they are others than for the last picture.
    pub is_other: bool,
}

/// What group 0 binds besides a surface's own things. It is another one when its number is.
pub struct Common<'a> {
    pub number: u64,
    pub frame: BindingResource<'a>,
    pub passes: BindingResource<'a>,
    /// What builds pyramids, where there are any to build.
    pub builder: Option<&'a Builder>,
    /// What lights see, where shadows are looked up there.
    pub light_map: Option<&'a TextureView>,
}

impl Resident {
    /// Nothing yet.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            settings: Uniform::new::<SurfaceSettings>(gpu, "surface settings"),
            precision: None,
            heights: None,
            height_levels: 0,
            holes: None,
            color: None,
            normals: None,
            slots: [const { None }; MapSlot::ALL.len()],
            sampler: None,
            mesh: None,
            shells: None,
            tessellated: None,
            maps: None,
        }
    }

    /// Uploads what is not there, and gives group 0.
    pub fn maps(
        &mut self,
        gpu: &Gpu,
        surface: &JobSurface,
        sampling: Sampling,
        layout: &BindGroupLayout,
        common: &Common,
    ) -> Result<MapGroups, GpuError> {
        let changed = self.hold_all(gpu, surface, sampling, common.builder)?;
        let mut settings = surface.settings;
        for (map, held) in settings.maps.iter_mut().zip(&self.slots) {
            // The job has no map that could say so.
            if matches!(held, Some(Held { of: Some(SlotSource::Pyramid(_)), .. })) {
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
        let by_lights = self.group(gpu, sampling, layout, common, None);
        let seen = match common.light_map {
            Some(view) => self.group(gpu, sampling, layout, common, Some(view)),
            None => by_lights.clone(),
        };
        let groups = MapGroups { seen, by_lights, changed: true };
        self.maps = Some((sampling, common.number, groups.clone()));
        Ok(groups)
    }

    /// Group 1: the triangles, which are uploaded, or made here where they are to be made.
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
            shells::hold(&mut self.shells, gpu, surface, &layouts.shells)?;
            let shells = self.shells.as_ref().map(|shells| shells.group.clone());
            return Ok(ResidentMesh { group, shells, drawn: Drawn::of(surface), is_other });
        };
        (self.mesh, self.shells) = (None, None);
        if !self.tessellated.as_ref().is_some_and(|known| known.fits(gpu, of)) {
            // What was held goes first, so that both need not fit.
            self.tessellated = None;
        }
        let is_new = self.tessellated.is_none();
        let tessellated = match &mut self.tessellated {
            Some(tessellated) => tessellated,
            none => none.insert(Tessellated::new(gpu, of, groups, &layouts.mesh)?),
        };
        let is_other_surface = is_new || maps.changed;
        let is_other = tessellated.make(gpu, of, tessellator, &maps.by_lights, is_other_surface, clock);
        let drawn = Drawn::Indirect(tessellated.drawn().clone());
        Ok(ResidentMesh { group: tessellated.mesh().clone(), shells: None, drawn, is_other })
    }

    /// How many triangles were made last of a base that is tessellated here, once that is done.
    pub async fn made_triangles(&self, gpu: &Gpu) -> Result<u64, GpuError> {
        match &self.tessellated {
            Some(tessellated) => tessellated.triangles(gpu).await,
            None => Ok(0),
        }
    }

    /// What was made last where the base is tessellated here.
    #[cfg(test)]
    pub fn made(&self) -> Option<[&Buffer; 3]> {
        self.tessellated.as_ref().map(Tessellated::made)
    }

    /// The triangles that are uploaded. True where they are others than for the last picture.
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
        // What was held goes first, so that both need not fit.
        self.mesh = None;
        let faces = gpu.filled("mesh_faces", triangles.faces(), BufferUsages::STORAGE)?;
        let corners = gpu.filled("mesh_corners", triangles.corners(), BufferUsages::STORAGE)?;
        let bound =
            [("mesh_faces", faces.as_entire_binding()), ("mesh_corners", corners.as_entire_binding())];
        let group = group(gpu.device(), "mesh", layout, &bound);
        self.mesh = Some((Arc::clone(triangles), group.clone()));
        Ok((group, true))
    }

    /// Uploads and builds the maps that are not there. True when one was another one.
    fn hold_all(
        &mut self,
        gpu: &Gpu,
        surface: &JobSurface,
        sampling: Sampling,
        builder: Option<&Builder>,
    ) -> Result<bool, GpuError> {
        let precision = Precision::of(gpu, sampling);
        if self.precision != Some(precision) {
            (self.heights, self.color, self.normals) = (None, None, None);
            self.precision = Some(precision);
        }
        let levels = surface.settings.height_levels;
        if self.height_levels < levels {
            self.heights = None;
        }
        let mut changed = hold(
            &mut self.heights,
            Some(&surface.height_map),
            |a, b| a.shares_texels(b),
            || textures::heights(gpu, &surface.height_map, levels, precision),
        )?;
        if changed {
            self.height_levels = levels;
        }
        changed |= hold(&mut self.holes, surface.holes(), Arc::ptr_eq, || {
            textures::holes(gpu, surface.holes().map(Arc::as_ref))
        })?;
        changed |= hold(&mut self.color, surface.color.as_ref(), Arc::ptr_eq, || {
            textures::picture(gpu, "colour map", surface.color.as_deref(), precision, false)
        })?;
        changed |= hold(&mut self.normals, surface.normal_map.as_ref(), Arc::ptr_eq, || {
            textures::picture(gpu, "normal map", surface.normal_map.as_deref(), precision, true)
        })?;
        for (place, slot) in MapSlot::ALL.into_iter().enumerate() {
            let of = SlotSource::of(surface, slot, builder);
            // The searches of view and shadow read the same map as a rule: it is there once.
            let (before, rest) = self.slots.split_at_mut(place);
            let is_same = |held: &&Held<SlotSource>| {
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
            changed |= hold(&mut rest[0], of.as_ref(), SlotSource::is_same, || shared.map_or_else(make, Ok))?;
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
