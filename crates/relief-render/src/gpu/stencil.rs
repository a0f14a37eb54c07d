//! Counting of a depth object's images in a stencil buffer: slice by slice, from front to back,
//! with a pass for each image.
//!
//! Kautz and Seidel 2001, section 4.1.

use relief_shaders::wgsl::Root;
use wgpu::{
    ColorTargetState, ColorWrites, CompareFunction, DepthStencilState, Device, FragmentState, PipelineLayout,
    PrimitiveState, RenderPass, RenderPipeline, RenderPipelineDescriptor, ShaderModule, StencilFaceState,
    StencilOperation, StencilState, VertexState,
};

use super::pipelines::{DEPTH_AND_COUNT, HIT, WHAT};
use crate::job::JobSurface;

/// Programs of the passes over a slice.
#[derive(Clone, Debug)]
pub struct StencilPrograms {
    /// Adds 1 to the count where an image holds the point, and all images before it do.
    test: RenderPipeline,
    /// Does so for the last image, and writes the hit.
    hit: RenderPipeline,
    /// Resets the count where not all images hold the point.
    clear: RenderPipeline,
}

/// Slices and images of a surface, with the programs that count them.
#[derive(Clone, Debug)]
pub struct Counted {
    /// Programs of the passes.
    pub programs: StencilPrograms,
    /// Ends of the slices among the triangles, from front to back.
    ends: Vec<u32>,
    /// Number of images.
    images: u32,
}

impl StencilPrograms {
    /// Compiles the programs from the module of the root `Stencil`.
    pub fn new(device: &Device, label: &str, module: &ShaderModule, layout: &PipelineLayout) -> Self {
        let names = Root::Stencil.functions();
        let program = |place: usize, depth_compare, stencil: StencilFaceState, writes: bool| {
            let write_mask = if writes { ColorWrites::ALL } else { ColorWrites::empty() };
            let target = |format| Some(ColorTargetState { write_mask, ..ColorTargetState::from(format) });
            device.create_render_pipeline(&RenderPipelineDescriptor {
                label: Some(label),
                layout: Some(layout),
                vertex: VertexState {
                    module,
                    entry_point: names.first().copied(),
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                // Slices have no back.
                primitive: PrimitiveState::default(),
                depth_stencil: Some(DepthStencilState {
                    format: DEPTH_AND_COUNT,
                    depth_write_enabled: Some(writes),
                    depth_compare: Some(depth_compare),
                    stencil: StencilState { front: stencil, back: stencil, read_mask: !0, write_mask: !0 },
                    bias: Default::default(),
                }),
                multisample: Default::default(),
                fragment: Some(FragmentState {
                    module,
                    entry_point: names.get(place).copied(),
                    compilation_options: Default::default(),
                    targets: &[target(HIT), target(WHAT)],
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        // What lies behind another surface is counted, too, so that slices behind it are not asked.
        let counted = StencilFaceState {
            compare: CompareFunction::Equal,
            fail_op: StencilOperation::Keep,
            depth_fail_op: StencilOperation::IncrementClamp,
            pass_op: StencilOperation::IncrementClamp,
        };
        let taken_back = StencilFaceState {
            compare: CompareFunction::NotEqual,
            fail_op: StencilOperation::Keep,
            depth_fail_op: StencilOperation::Keep,
            pass_op: StencilOperation::Zero,
        };
        Self {
            test: program(1, CompareFunction::Always, counted, false),
            hit: program(2, CompareFunction::Greater, counted, true),
            clear: program(3, CompareFunction::Always, taken_back, false),
        }
    }
}

impl Counted {
    /// Creates the slices and images of a surface.
    pub fn of(surface: &JobSurface, programs: StencilPrograms) -> Self {
        Self { programs, ends: surface.triangles.slices().to_vec(), images: surface.settings.solids }
    }

    /// Draws all slices.
    pub fn draw(&self, pass: &mut RenderPass) {
        let StencilPrograms { test, hit, clear } = &self.programs;
        let mut first = 0;
        for &end in &self.ends {
            let vertices = 3 * first..3 * end;
            for image in 0..self.images {
                pass.set_pipeline(if image + 1 == self.images { hit } else { test });
                pass.set_stencil_reference(image);
                pass.draw(vertices.clone(), image..image + 1);
            }
            pass.set_pipeline(clear);
            pass.set_stencil_reference(self.images);
            pass.draw(vertices, 0..1);
            first = end;
        }
    }
}
