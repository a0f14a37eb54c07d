//! Pipelines of assembled shaders: formats of their targets, and the depth test.

use relief_shaders::wgsl::Root;
use wgpu::{
    BindGroupLayout, ColorTargetState, CompareFunction, ComputePipeline, ComputePipelineDescriptor,
    DepthStencilState, Device, Face, FragmentState, PipelineLayout, PipelineLayoutDescriptor, PrimitiveState,
    RenderPipeline, RenderPipelineDescriptor, ShaderModule, ShaderModuleDescriptor, ShaderSource,
    TextureFormat, VertexState,
};

/// Formats of the targets of the first pass.
pub const HIT: TextureFormat = TextureFormat::Rgba32Float;
pub const WHAT: TextureFormat = TextureFormat::Rgba32Sint;
pub const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// Format of depths with a stencil buffer, in which images are counted.
pub const DEPTH_AND_COUNT: TextureFormat = TextureFormat::Depth32FloatStencil8;

/// Format of the shadow maps.
pub const KEYS: TextureFormat = TextureFormat::R32Float;

pub(super) fn module(device: &Device, label: &str, text: &str) -> ShaderModule {
    let source = ShaderSource::Wgsl(text.into());
    device.create_shader_module(ShaderModuleDescriptor { label: Some(label), source })
}

pub(super) fn pipeline_layout(
    device: &Device,
    label: &str,
    groups: &[Option<&BindGroupLayout>],
) -> PipelineLayout {
    device.create_pipeline_layout(&PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: groups,
        immediate_size: 0,
    })
}

/// Returns the label of a root's programs.
pub(super) fn label(root: Root) -> &'static str {
    match root {
        Root::Functions | Root::TriangleFunctions => "functions",
        Root::Trace | Root::TraceShells | Root::TraceObjects => "trace",
        Root::Light | Root::LightShells | Root::LightObjects => "light",
        Root::Stencil => "stencil",
        Root::Prepass | Root::PrepassShells | Root::PrepassObjects => "prepass",
        Root::Draw | Root::DrawDepth | Root::DrawShells | Root::DrawObjects | Root::DrawTranslucent => "draw",
        Root::Shade => "shade",
        Root::Gather => "gather",
        Root::Compose => "compose",
        Root::Resolve => "resolve",
        Root::Show => "show",
        Root::Screen => "screen",
        Root::Probe => "probe",
        Root::Paths => "paths",
        Root::Pyramid => "pyramid",
        Root::Tessellate => "tessellate",
    }
}

pub(super) fn compute(
    device: &Device,
    text: &str,
    root: Root,
    groups: &[&BindGroupLayout],
) -> ComputePipeline {
    let groups: Vec<Option<&BindGroupLayout>> = groups.iter().map(|group| Some(*group)).collect();
    let module = module(device, label(root), text);
    compute_entry(device, &module, label(root), root.functions().first().copied(), &groups)
}

pub(super) fn compute_entry(
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

/// Returns the depth test in which only strictly nearer hits win. Ties go to the first triangle, as
/// on the CPU. The shaders write the keys, which grow toward the eye.
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
