//! Compiled shaders. Each is assembled for what is chosen, compiled when it is first needed, and kept.

use std::collections::HashMap;
use std::hash::Hash;

use relief_shaders::surface::{Proposal, Shown};
use relief_shaders::wgsl::{Root, Sampling, assemble};
use relief_shaders::{MapSlot, STAGES, Selection};
use wgpu::{
    BindGroupLayout, ColorTargetState, CompareFunction, ComputePipeline, ComputePipelineDescriptor,
    DepthStencilState, Device, Face, FragmentState, PipelineLayout, PipelineLayoutDescriptor, PrimitiveState,
    RenderPipeline, RenderPipelineDescriptor, ShaderModule, ShaderModuleDescriptor, ShaderSource,
    TextureFormat, VertexState,
};

use super::layouts::{layout, named, shared};
use super::pyramid::{Builder, NODES, Source};
use super::stencil::StencilPrograms;
use super::tessellate::{self, Tessellator};
use super::textures::Precision;
use super::{Gpu, GpuError};
use crate::job::JobSurface;

/// Formats of what the first pass writes.
pub const HIT: TextureFormat = TextureFormat::Rgba32Float;
pub const WHAT: TextureFormat = TextureFormat::Rgba32Sint;
pub const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// The format of depths where images are counted beside them.
pub const DEPTH_AND_COUNT: TextureFormat = TextureFormat::Depth32FloatStencil8;

/// The format of what lights see.
pub const KEYS: TextureFormat = TextureFormat::R32Float;

/// What a shader is assembled and compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Variant {
    sampling: Sampling,
    /// The number of each stage's variant.
    numbers: [u32; STAGES.len()],
}

impl Variant {
    fn new(selection: &Selection, sampling: Sampling) -> Self {
        Self { sampling, numbers: selection.choices.map(|choice| choice.number) }
    }
}

/// The layouts of the bind groups.
#[derive(Clone, Debug)]
pub struct Layouts {
    exact: BindGroupLayout,
    fast: BindGroupLayout,
    /// Group 1 of the passes of a picture: the triangles.
    pub mesh: BindGroupLayout,
    /// Group 2 of the passes that trace shells: their hierarchy.
    pub shells: BindGroupLayout,
    /// Group 2 of the passes that shade and resolve.
    pub traced: BindGroupLayout,
    /// Group 1 of the pass that shows.
    pub shown: BindGroupLayout,
    rays: BindGroupLayout,
    paths: BindGroupLayout,
    /// Group 1 of the passes that build pyramids: what is read.
    pub pyramid: BindGroupLayout,
    /// What the passes that tessellate bind, where the GPU can bind as much.
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
            shown: of("shown", &["shown_records", "picture"]),
            rays: of("rays", &List::Rays.names()),
            paths: of("paths", &List::Paths.names()),
            pyramid: of("pyramid", &["finer_level", "heights_below", "pyramid_pass"]),
            tessellated: tessellate::is_possible(device).then(|| tessellate::Groups {
                counting: of("tessellate", tessellate::COUNTING),
                making: of("tessellate", tessellate::MAKING),
            }),
        }
    }

    /// Group 0 of every program.
    pub fn maps(&self, sampling: Sampling) -> &BindGroupLayout {
        match sampling {
            Sampling::Exact => &self.exact,
            Sampling::Fast => &self.fast,
        }
    }

    /// Group 1 of the programs that go over a list: it, and what they make of it.
    pub fn list(&self, list: List) -> &BindGroupLayout {
        match list {
            List::Rays => &self.rays,
            List::Paths => &self.paths,
        }
    }
}

/// A list that a program goes over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum List {
    /// Rays, by all stages.
    Rays,
    /// Paths, by search and refinement.
    Paths,
}

impl List {
    /// What the list is bound as, and what is made of it.
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

/// For whom surfaces are traced.
#[derive(Clone, Copy, Debug)]
pub enum Viewer {
    /// For the picture: all that shading needs.
    Camera,
    /// For shadows: the keys of the hits alone.
    Light,
    /// As for the camera, in a picture in which images of an object are counted.
    CameraBesideCounts,
}

/// All programs of a device.
#[derive(Debug)]
pub struct Programs {
    pub layouts: Layouts,
    /// For each that sees: of surfaces seen from their front, and from both sides.
    trace: [[ProgramCache<Variant, RenderPipeline>; 2]; 3],
    stencil: ProgramCache<Variant, StencilPrograms>,
    shade: ProgramCache<Variant, ComputePipeline>,
    lists: ProgramCache<(List, Variant), ComputePipeline>,
    /// The same for everything that is chosen.
    resolve: ProgramCache<(), ComputePipeline>,
    show: ProgramCache<(), ComputePipeline>,
    pyramid: ProgramCache<(), RenderPipeline>,
    tessellate: ProgramCache<Sampling, Tessellator>,
    compiled: u32,
}

/// Programs by what they were asked for, and by their text: what differs in a stage that a program does not
/// reach has the same one.
#[derive(Debug)]
struct ProgramCache<K, T> {
    by_key: HashMap<K, T>,
    by_text: Vec<(String, T)>,
}

impl<K: Hash + Eq, T: Clone> ProgramCache<K, T> {
    fn new() -> Self {
        Self { by_key: HashMap::new(), by_text: Vec::new() }
    }

    /// The program, compiled unless it is there. A program that the driver refused is not kept.
    async fn get(
        &mut self,
        gpu: &Gpu,
        compiled: &mut u32,
        key: K,
        text: impl FnOnce() -> String,
        compile: impl FnOnce(&str) -> T,
    ) -> Result<T, GpuError> {
        if let Some(program) = self.by_key.get(&key) {
            return Ok(program.clone());
        }
        let text = text();
        let known = self.by_text.iter().find(|(known, _)| *known == text).map(|(_, program)| program.clone());
        let program = match known {
            Some(program) => program,
            None => {
                let program = gpu.guarded(|| Ok(compile(&text))).await?;
                *compiled += 1;
                self.by_text.push((text, program.clone()));
                program
            }
        };
        self.by_key.insert(key, program.clone());
        Ok(program)
    }
}

impl Programs {
    /// None yet.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            layouts: Layouts::new(gpu.device()),
            trace: std::array::from_fn(|_| [ProgramCache::new(), ProgramCache::new()]),
            stencil: ProgramCache::new(),
            shade: ProgramCache::new(),
            lists: ProgramCache::new(),
            resolve: ProgramCache::new(),
            show: ProgramCache::new(),
            pyramid: ProgramCache::new(),
            tessellate: ProgramCache::new(),
            compiled: 0,
        }
    }

    /// How many programs were compiled so far.
    pub fn compiled(&self) -> u32 {
        self.compiled
    }

    /// The program that rasterises and traces what one sees.
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
        // A triangle that covers the picture is drawn for shells, and its face does not matter.
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

    /// The programs that count the images of an object.
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

    /// The program that shades.
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

    /// The program that adds a sample to those before.
    pub async fn resolve(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<ComputePipeline, GpuError> {
        let Layouts { mesh, traced, .. } = &self.layouts;
        let groups = [self.layouts.maps(sampling), mesh, traced].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Resolve, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Resolve, &groups.each_ref());
        self.resolve.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// The program that makes a picture of records.
    pub async fn show(&mut self, gpu: &Gpu, sampling: Sampling) -> Result<ComputePipeline, GpuError> {
        let groups = [self.layouts.maps(sampling), &self.layouts.shown].map(Clone::clone);
        let text = || assemble(&Selection::default(), Root::Show, sampling);
        let compile = |text: &str| compute(gpu.device(), text, Root::Show, &groups.each_ref());
        self.show.get(gpu, &mut self.compiled, (), text, compile).await
    }

    /// What builds the pyramids of some surfaces; none where all have the maps that they read, or where
    /// heights do not lie on the GPU as they are.
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

    /// What tessellates the bases of some surfaces; none where none is to be tessellated.
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

    /// The program that runs its stages over a list.
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

fn module(device: &Device, label: &str, text: &str) -> ShaderModule {
    let source = ShaderSource::Wgsl(text.into());
    device.create_shader_module(ShaderModuleDescriptor { label: Some(label), source })
}

fn pipeline_layout(device: &Device, label: &str, groups: &[Option<&BindGroupLayout>]) -> PipelineLayout {
    device.create_pipeline_layout(&PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: groups,
        immediate_size: 0,
    })
}

/// The label of a root's programs.
fn label(root: Root) -> &'static str {
    match root {
        Root::Functions => "functions",
        Root::Trace | Root::TraceShells | Root::TraceObjects => "trace",
        Root::Light | Root::LightShells | Root::LightObjects => "light",
        Root::Stencil => "stencil",
        Root::Prepass | Root::PrepassShells | Root::PrepassObjects => "prepass",
        Root::Draw | Root::DrawDepth | Root::DrawShells | Root::DrawObjects => "draw",
        Root::Shade => "shade",
        Root::Resolve => "resolve",
        Root::Show => "show",
        Root::Probe => "probe",
        Root::Paths => "paths",
        Root::Pyramid => "pyramid",
        Root::Tessellate => "tessellate",
    }
}

fn compute(device: &Device, text: &str, root: Root, groups: &[&BindGroupLayout]) -> ComputePipeline {
    let groups: Vec<Option<&BindGroupLayout>> = groups.iter().map(|group| Some(*group)).collect();
    let module = module(device, label(root), text);
    compute_entry(device, &module, label(root), root.functions().first().copied(), &groups)
}

fn compute_entry(
    device: &Device,
    module: &ShaderModule,
    label: &str,
    entry_point: Option<&str>,
    groups: &[Option<&BindGroupLayout>],
) -> ComputePipeline {
    device.create_compute_pipeline(&ComputePipelineDescriptor {
        label: Some(label),
        layout: Some(&pipeline_layout(device, label, groups)),
        module,
        entry_point,
        compilation_options: Default::default(),
        cache: None,
    })
}

/// What is strictly nearer is seen: of two hits with the same key the first triangle's counts, as on the CPU.
/// The shaders write the keys, which grow toward the eye.
pub(super) fn nearest(format: TextureFormat) -> DepthStencilState {
    DepthStencilState {
        format,
        depth_write_enabled: Some(true),
        depth_compare: Some(CompareFunction::Greater),
        stencil: Default::default(),
        bias: Default::default(),
    }
}

pub(super) fn raster(
    device: &Device,
    text: &str,
    root: Root,
    groups: &[Option<&BindGroupLayout>],
    cull_mode: Option<Face>,
    depth_stencil: Option<DepthStencilState>,
    targets: &[Option<ColorTargetState>],
) -> RenderPipeline {
    let label = label(root);
    let module = module(device, label, text);
    let [vertex, fragment] = [0, 1].map(|place| root.functions().get(place).copied());
    device.create_render_pipeline(&RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&pipeline_layout(device, label, groups)),
        vertex: VertexState {
            module: &module,
            entry_point: vertex,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: PrimitiveState { cull_mode, ..Default::default() },
        depth_stencil,
        multisample: Default::default(),
        fragment: Some(FragmentState {
            module: &module,
            entry_point: fragment,
            compilation_options: Default::default(),
            targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}
