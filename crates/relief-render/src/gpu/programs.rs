//! Programs of a device. Each is assembled for a selection of variants and compiled when it is first
//! needed.

use relief_shaders::surface::{Proposal, Shown};
use relief_shaders::wgsl::{Root, Sampling, assemble};
use relief_shaders::{MapSlot, Selection};
use wgpu::{BindGroupLayout, ColorTargetState, ComputePipeline, Device, Face, RenderPipeline, TextureFormat};

use super::layouts::{layout, named, shared};
use super::pipelines::{
    DEPTH, DEPTH_AND_COUNT, HIT, KEYS, WHAT, compute, compute_entry, label, module, nearest, pipeline_layout,
    raster,
};
use super::program_cache::{ProgramCache, Variant};
use super::pyramid::{Builder, NODES, Source};
use super::stencil::StencilPrograms;
use super::tessellate::{self, Tessellator};
use super::textures::Precision;
use super::{Gpu, GpuError};
use crate::job::JobSurface;

/// Layouts of the bind groups.
#[derive(Clone, Debug)]
pub struct Layouts {
    exact: BindGroupLayout,
    fast: BindGroupLayout,
    /// Group 1 of the passes of a picture: the triangles.
    pub mesh: BindGroupLayout,
    /// Group 2 of the passes that trace shells: their BVH.
    pub shells: BindGroupLayout,
    /// Group 2 of the passes that shade and resolve.
    pub traced: BindGroupLayout,
    /// Group 2 of the passes that gather the light of translucent surfaces.
    pub gathered: BindGroupLayout,
    /// Group 2 of the passes before and behind these.
    pub composed: BindGroupLayout,
    /// Group 1 of the pass that shows.
    pub shown: BindGroupLayout,
    /// Group 1 of the pass that makes pictures for screens.
    pub screen: BindGroupLayout,
    rays: BindGroupLayout,
    paths: BindGroupLayout,
    /// Group 1 of the passes that build pyramids: their input.
    pub pyramid: BindGroupLayout,
    /// Group 1 of the passes that tessellate, if the GPU can bind enough buffers.
    pub tessellated: Option<tessellate::Groups>,
}

impl Layouts {
    pub fn new(device: &Device) -> Self {
        let of = |label, names: &[&str]| layout(device, label, &named(names), Sampling::Exact);
        Self {
            exact: layout(device, "maps", &shared(), Sampling::Exact),
            fast: layout(device, "maps", &shared(), Sampling::Fast),
            mesh: of("mesh", &["mesh_faces", "mesh_corners"]),
            shells: of("shells", &["shell_nodes"]),
            traced: of("traced", &["traced_hit", "traced_what", "records", "sums"]),
            gathered: of("gathered", &["traced_what", "gathered", "shell_nodes"]),
            composed: of("composed", &["traced_what", "records", "gathered"]),
            shown: of("shown", &["shown_records", "picture"]),
            screen: of("screen", &["shown_records", "screen_settings", "screen"]),
            rays: of("rays", &List::Rays.names()),
            paths: of("paths", &List::Paths.names()),
            pyramid: of("pyramid", &["finer_level", "heights_below", "pyramid_pass"]),
            tessellated: tessellate::is_possible(device).then(|| tessellate::Groups {
                counting: of("tessellate", tessellate::COUNTING),
                making: of("tessellate", tessellate::MAKING),
            }),
        }
    }

    /// Returns the layout of group 0 of every program.
    pub fn maps(&self, sampling: Sampling) -> &BindGroupLayout {
        match sampling {
            Sampling::Exact => &self.exact,
            Sampling::Fast => &self.fast,
        }
    }

    /// Returns the layout of group 1 of the programs over a list: the list and the results.
    pub fn list(&self, list: List) -> &BindGroupLayout {
        match list {
            List::Rays => &self.rays,
            List::Paths => &self.paths,
        }
    }
}

/// List over which a program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum List {
    /// Rays, by all stages.
    Rays,
    /// Paths, by search and refinement.
    Paths,
}

impl List {
    /// Returns the names of the bindings of the list and of the results.
    pub fn names(self) -> [&'static str; 2] {
        match self {
            Self::Rays => ["pixels", "probes"],
            Self::Paths => ["given_paths", "found_hits"],
        }
    }

    fn root(self) -> Root {
        match self {
            Self::Rays => Root::Probe,
            Self::Paths => Root::Paths,
        }
    }
}

/// Viewer for which surfaces are traced.
#[derive(Clone, Copy, Debug)]
pub enum Viewer {
    /// The camera. Results are all values that shading needs.
    Camera,
    /// A light. Results are the keys of the hits alone.
    Light,
    /// The camera, in a picture in which images of an object are counted.
    CameraBesideCounts,
}

/// Compiled programs of a device.
#[derive(Debug)]
pub struct Programs {
    pub layouts: Layouts,
    /// Programs for each viewer: of one-sided and of two-sided surfaces.
    trace: [[ProgramCache<Variant, RenderPipeline>; 2]; 3],
    stencil: ProgramCache<Variant, StencilPrograms>,
    shade: ProgramCache<Variant, ComputePipeline>,
    gather: ProgramCache<Variant, ComputePipeline>,
    lists: ProgramCache<(List, Variant), ComputePipeline>,
    /// Programs that do not depend on the selection of variants.
    resolve: ProgramCache<(), ComputePipeline>,
    compose: ProgramCache<(), Composer>,
    show: ProgramCache<(), ComputePipeline>,
    screen: ProgramCache<(), ComputePipeline>,
    pyramid: ProgramCache<(), RenderPipeline>,
    tessellate: ProgramCache<Sampling, Tessellator>,
    compiled: u32,
}

/// Programs before and behind those that gather the light of translucent surfaces.
#[derive(Clone, Debug)]
pub struct Composer {
    /// Says how far every pixel's rays go.
    pub begin: ComputePipeline,
    /// Lays what was gathered over the opaque surfaces.
    pub compose: ComputePipeline,
}

impl Programs {
    /// Creates an empty cache of programs.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            layouts: Layouts::new(gpu.device()),
            trace: std::array::from_fn(|_| [ProgramCache::new(), ProgramCache::new()]),
            stencil: ProgramCache::new(),
            shade: ProgramCache::new(),
            gather: ProgramCache::new(),
            lists: ProgramCache::new(),
            resolve: ProgramCache::new(),
            compose: ProgramCache::new(),
            show: ProgramCache::new(),
            screen: ProgramCache::new(),
            pyramid: ProgramCache::new(),
            tessellate: ProgramCache::new(),
            compiled: 0,
        }
    }

    /// Returns the number of programs compiled so far.
    pub fn compiled(&self) -> u32 {
        self.compiled
    }

    /// Returns the program that rasterises and traces surfaces for a viewer.
    pub async fn trace(
        &mut self,
        gpu: &Gpu,
        viewer: Viewer,
        selection: &Selection,
        sampling: Sampling,
        two_sided: bool,
    ) -> Result<RenderPipeline, GpuError> {
        let Layouts { mesh, shells, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, shells].map(Clone::clone);
        let (roots, formats): ([Root; 3], &[TextureFormat]) = match viewer {
            Viewer::Camera | Viewer::CameraBesideCounts => {
                ([Root::Trace, Root::TraceShells, Root::TraceObjects], &[HIT, WHAT])
            }
            Viewer::Light => ([Root::Light, Root::LightShells, Root::LightObjects], &[KEYS]),
        };
        // For shells a triangle that covers the picture is drawn, and its face does not matter.
        let paths = selection.paths();
        let (root, count, faces) = match (paths.proposal, paths.shown) {
            (Proposal::Polygons, _) => (roots[0], 2, (!two_sided).then_some(Face::Back)),
            (Proposal::Shells, Shown::Object) => (roots[2], 3, None),
            (Proposal::Shells, _) => (roots[1], 3, None),
        };
        let text = || assemble(selection, root, sampling);
        let compile = |text: &str| {
            let groups = groups.each_ref().map(Some);
            let groups = &groups[..count];
            let targets: Vec<_> =
                formats.iter().map(|format| Some(ColorTargetState::from(*format))).collect();
            let format = if matches!(viewer, Viewer::CameraBesideCounts) { DEPTH_AND_COUNT } else { DEPTH };
            raster(gpu.device(), text, root, groups, faces, Some(nearest(format)), &targets)
        };
        let cache = &mut self.trace[viewer as usize][usize::from(two_sided)];
        cache.get(gpu, &mut self.compiled, Variant::new(selection, sampling), text, compile).await
    }

    /// Returns the programs that count the images of an object.
    pub async fn stencil(
        &mut self,
        gpu: &Gpu,
        selection: &Selection,
        sampling: Sampling,
    ) -> Result<StencilPrograms, GpuError> {
        let groups = [self.layouts.maps(sampling).clone(), self.layouts.mesh.clone()];
        let text = || assemble(selection, Root::Stencil, sampling);
        let compile = |text: &str| {
            let (device, label) = (gpu.device(), label(Root::Stencil));
            let module = module(device, label, text);
            let layout = pipeline_layout(device, label, &groups.each_ref().map(Some));
            StencilPrograms::new(device, label, &module, &layout)
        };
        self.stencil.get(gpu, &mut self.compiled, Variant::new(selection, sampling), text, compile).await
    }

    /// Returns the program that shades.
    pub async fn shade(
        &mut self,
        gpu: &Gpu,
        selection: &Selection,
        sampling: Sampling,
    ) -> Result<ComputePipeline, GpuError> {
        let Layouts { mesh, traced, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, traced].map(Clone::clone);
        let text = || assemble(selection, Root::Shade, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Shade, &groups.each_ref());
        self.shade.get(gpu, &mut self.compiled, Variant::new(selection, sampling), text, compile).await
    }

    /// Returns the program that gathers the light of a translucent surface.
    pub async fn gather(
        &mut self,
        gpu: &Gpu,
        selection: &Selection,
        sampling: Sampling,
    ) -> Result<ComputePipeline, GpuError> {
        let Layouts { mesh, gathered, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, gathered].map(Clone::clone);
        let text = || assemble(selection, Root::Gather, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Gather, &groups.each_ref());
        self.gather.get(gpu, &mut self.compiled, Variant::new(selection, sampling), text, compile).await
    }

    /// Returns the programs before and behind those.
    pub async fn compose(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<Composer, GpuError> {
        let Layouts { mesh, composed, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, composed].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Compose, sampling);
        let compile = |text: &str| {
            let device = gpu.device();
            let module = module(device, label(Root::Compose), text);
            let of = |entry: &'static str| {
                let groups = groups.each_ref().map(Some);
                compute_entry(device, &module, label(Root::Compose), Some(entry), &groups)
            };
            Composer { begin: of("begin_gather_main"), compose: of("compose_main") }
        };
        self.compose.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// Returns the program that adds a sample to the sums of the earlier ones.
    pub async fn resolve(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<ComputePipeline, GpuError> {
        let Layouts { mesh, traced, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, traced].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Resolve, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Resolve, &groups.each_ref());
        self.resolve.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// Returns the program that converts records to a picture.
    pub async fn show(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<ComputePipeline, GpuError> {
        let groups = [self.layouts.maps(sampling), &self.layouts.shown].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Show, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Show, &groups.each_ref());
        self.show.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// Returns the program that converts records to a picture for screens.
    pub async fn screen(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<ComputePipeline, GpuError> {
        let groups = [self.layouts.maps(sampling), &self.layouts.screen].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Screen, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Screen, &groups.each_ref());
        self.screen.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// Returns the builder of the surfaces' pyramids. `None` if no pyramid is missing, or if the
    /// heights are not stored as 32-bit floats on the GPU.
    pub async fn pyramids(
        &mut self,
        gpu: &Gpu,
        surfaces: &[JobSurface],
        sampling: Sampling,
    ) -> Result<Option<Builder>, GpuError> {
        let is_built = |surface: &JobSurface, slot| {
            surface.maps.iter().all(|(of, _)| *of != slot) && Source::of(surface, slot).is_some()
        };
        let is_any = |surface: &JobSurface| MapSlot::ALL.iter().any(|slot| is_built(surface, *slot));
        if Precision::of(gpu, sampling) != Precision::F32 || !surfaces.iter().any(is_any) {
            return Ok(None);
        }
        let layout = self.layouts.pyramid.clone();
        let text = || assemble(&Selection::default(), Root::Pyramid, Sampling::Exact);
        let compile = |text: &str| {
            // The program binds nothing of group 0, whose maps it builds.
            let targets = [Some(ColorTargetState::from(NODES))];
            raster(gpu.device(), text, Root::Pyramid, &[None, Some(&layout)], None, None, &targets)
        };
        let program = self.pyramid.get(gpu, &mut self.compiled, (), text, compile).await?;
        Ok(Some(Builder { program, layout }))
    }

    /// Returns the programs that tessellate bases. `None` if no base has to be tessellated, or if
    /// the GPU cannot do it.
    pub async fn tessellator(
        &mut self,
        gpu: &Gpu,
        surfaces: &[JobSurface],
        sampling: Sampling,
    ) -> Result<Option<Tessellator>, GpuError> {
        let is_asked_for = surfaces.iter().any(|surface| surface.triangles.tessellation().is_some());
        let Some(tessellate::Groups { counting, making }) =
            self.layouts.tessellated.clone().filter(|_| is_asked_for)
        else {
            return Ok(None);
        };
        let maps = self.layouts.maps(sampling).clone();
        let text = || assemble(&Selection::default(), Root::Tessellate, sampling);
        let compile = |text: &str| {
            let device = gpu.device();
            let module = module(device, label(Root::Tessellate), text);
            let of = |entry: &str, groups: &[Option<&BindGroupLayout>]| {
                compute_entry(device, &module, label(Root::Tessellate), Some(entry), groups)
            };
            let count = |entry: &str| of(entry, &[None, Some(&counting)]);
            let make = |entry: &str| of(entry, &[Some(&maps), Some(&making)]);
            Tessellator {
                begin: count("begin_main"),
                voxels: count("voxels_main"),
                seen: count("seen_main"),
                edges: count("edges_main"),
                patches: count("patches_main"),
                blocks: count("blocks_main"),
                totals: count("totals_main"),
                starts: count("starts_main"),
                points: make("points_main"),
                triangles: make("triangles_main"),
                swept: make("swept_main"),
            }
        };
        self.tessellate.get(gpu, &mut self.compiled, sampling, text, compile).await.map(Some)
    }

    /// Returns the program that runs stages over a list.
    pub async fn over(
        &mut self,
        gpu: &Gpu,
        list: List,
        selection: &Selection,
        sampling: Sampling,
    ) -> Result<ComputePipeline, GpuError> {
        let groups = [self.layouts.maps(sampling), self.layouts.list(list)].map(Clone::clone);
        let text = || assemble(selection, list.root(), sampling);
        let compile = |text: &str| compute(gpu.device(), text, list.root(), &groups.each_ref());
        let key = (list, Variant::new(selection, sampling));
        self.lists.get(gpu, &mut self.compiled, key, text, compile).await
    }
}
