//! Passes of a picture on the GPU: each surface is traced and then shaded, sample after sample.

use relief_shaders::wgsl::SHADE_GROUP;
use wgpu::{
    BindGroup, Color, CommandEncoder, ComputePipeline, LoadOp, Operations, RenderPassColorAttachment,
    RenderPassDepthStencilAttachment, RenderPassDescriptor, RenderPassTimestampWrites, RenderPipeline,
    StoreOp,
};

use crate::gpu::Gpu;
use crate::gpu::draw_call::DrawCall;
use crate::gpu::pass_clock::{PassClock, PassKind, Timed, timed_compute};
use crate::gpu::programs::Composer;
use crate::gpu::stencil::Counted;
use crate::gpu::targets::{Pass, Targets};

/// Offset of the camera's frame in the buffer of all frames.
const CAMERA: u32 = 0;

/// Programs that trace a surface.
pub(super) enum Tracer {
    /// One program.
    Whole(RenderPipeline),
    /// Programs that go slice by slice and image by image.
    Counted(Counted),
}

/// Surface ready to be drawn.
pub(super) struct DrawableSurface {
    pub(super) trace: Tracer,
    pub(super) shade: ComputePipeline,
    pub(super) maps: BindGroup,
    pub(super) mesh: BindGroup,
    pub(super) shells: Option<BindGroup>,
    pub(super) drawn: DrawCall,
}

/// Translucent surface whose light is ready to be gathered.
pub(super) struct TranslucentSurface {
    pub(super) gather: ComputePipeline,
    pub(super) maps: BindGroup,
    pub(super) mesh: BindGroup,
    /// What the pass writes, and the shells that it reads.
    pub(super) gathered: BindGroup,
}

/// Surfaces and programs of a picture's passes.
pub(super) struct Passes {
    pub(super) surfaces: Vec<DrawableSurface>,
    pub(super) translucent: Vec<TranslucentSurface>,
    /// Programs before and behind the translucent surfaces, if there are any.
    pub(super) compose: Option<Composer>,
    /// Program that adds up samples, if there are several.
    pub(super) resolve: Option<ComputePipeline>,
}

impl Passes {
    /// Returns groups 0 and 1 of any surface, for passes that read no surface's settings of their own.
    pub(super) fn first_groups(&self) -> Option<[&BindGroup; 2]> {
        let opaque = self.surfaces.first().map(|surface| [&surface.maps, &surface.mesh]);
        opaque.or_else(|| self.translucent.first().map(|surface| [&surface.maps, &surface.mesh]))
    }
}

/// Traces and shades the rows of a band, sample after sample, so that no submission takes long.
/// `finish` records the end of the last one.
pub(super) fn submit_band(
    gpu: &Gpu,
    targets: &Targets,
    ready: &Passes,
    passes: &[Pass],
    clock: Option<&PassClock>,
    finish: impl Fn(&mut CommandEncoder, &Pass),
) {
    for (number, pass) in passes.iter().enumerate() {
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        let [records, sums] = targets.bytes(pass.band);
        if number == 0 && ready.resolve.is_some() {
            encoder.clear_buffer(&targets.sums, 0, Some(sums));
        }
        // The first surface's pass writes all of them.
        if ready.surfaces.is_empty() {
            encoder.clear_buffer(&targets.records, 0, Some(records));
        }
        for (number, surface) in ready.surfaces.iter().enumerate() {
            let timed = |kind| clock.and_then(|clock| clock.next(kind));
            trace(&mut encoder, targets, surface, pass, number == 0, timed(PassKind::Trace));
            let groups = [&surface.maps, &surface.mesh, &targets.traced];
            dispatch(&mut encoder, &surface.shade, &groups, targets.size[0], pass, timed(PassKind::Shade));
        }
        if let (Some(composer), Some(composed), Some(first)) =
            (&ready.compose, targets.composed(), ready.translucent.first())
        {
            let around = [&first.maps, &first.mesh, composed];
            dispatch(&mut encoder, &composer.begin, &around, targets.size[0], pass, None);
            for surface in &ready.translucent {
                let timed = clock.and_then(|clock| clock.next(PassKind::Shade));
                let groups = [&surface.maps, &surface.mesh, &surface.gathered];
                dispatch(&mut encoder, &surface.gather, &groups, targets.size[0], pass, timed);
            }
            dispatch(&mut encoder, &composer.compose, &around, targets.size[0], pass, None);
        }
        if let Some((resolve, [maps, mesh])) = ready.resolve.as_ref().zip(ready.first_groups()) {
            let groups = [maps, mesh, &targets.traced];
            dispatch(&mut encoder, resolve, &groups, targets.size[0], pass, None);
        }
        if pass.is_last {
            finish(&mut encoder, pass);
        }
        gpu.queue().submit([encoder.finish()]);
    }
}

/// Rasterises and traces a surface, behind the surfaces before it unless it is the first.
fn trace(
    encoder: &mut CommandEncoder,
    targets: &Targets,
    surface: &DrawableSurface,
    pass: &Pass,
    is_first: bool,
    timed: Option<Timed>,
) {
    let ops = Operations { load: LoadOp::Clear(Color::TRANSPARENT), store: StoreOp::Store };
    let keys = if is_first { LoadOp::Clear(0.0) } else { LoadOp::Load };
    let color = |view| Some(RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops });
    let mut drawn = encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("trace"),
        color_attachments: &[color(&targets.hit), color(&targets.what)],
        depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
            view: &targets.depth,
            depth_ops: Some(Operations { load: keys, store: StoreOp::Store }),
            stencil_ops: targets
                .counts
                .then_some(Operations { load: LoadOp::Clear(0), store: StoreOp::Discard }),
        }),
        timestamp_writes: timed.map(|Timed { queries, begin, end }| RenderPassTimestampWrites {
            query_set: queries,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(end),
        }),
        occlusion_query_set: None,
        multiview_mask: None,
    });
    drawn.set_scissor_rect(0, 0, targets.size[0], pass.band.rows);
    drawn.set_bind_group(0, &surface.maps, &[CAMERA, pass.offset]);
    drawn.set_bind_group(1, &surface.mesh, &[]);
    if let Some(shells) = &surface.shells {
        drawn.set_bind_group(2, shells, &[]);
    }
    match &surface.trace {
        Tracer::Whole(program) => {
            drawn.set_pipeline(program);
            surface.drawn.draw(&mut drawn);
        }
        Tracer::Counted(counted) => counted.draw(&mut drawn),
    }
}

/// Runs a program over the pixels of a band. Group 0 has the offsets of the frame and of the pass.
pub(super) fn dispatch(
    encoder: &mut CommandEncoder,
    program: &ComputePipeline,
    groups: &[&BindGroup],
    width: u32,
    pass: &Pass,
    timed: Option<Timed>,
) {
    let mut run = encoder.begin_compute_pass(&timed_compute(timed));
    run.set_pipeline(program);
    for (number, group) in (0u32..).zip(groups) {
        let offsets = [CAMERA, pass.offset];
        run.set_bind_group(number, *group, if number == 0 { &offsets } else { &[] });
    }
    run.dispatch_workgroups(width.div_ceil(SHADE_GROUP), pass.band.rows.div_ceil(SHADE_GROUP), 1);
}
