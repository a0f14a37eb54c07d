//! Shadow maps drawn on the GPU: a layer for each view, and the frames of the views beside the
//! camera's.

use relief_shaders::cpu::{Frame, Shared, write_all};
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferBinding, BufferSize, BufferUsages, Color, Extent3d, LoadOp,
    Operations, RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor,
    RenderPipeline, StoreOp, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView,
    TextureViewDescriptor, TextureViewDimension,
};

use super::draw_call::DrawCall;
use super::pipelines::{DEPTH, KEYS};
use super::{Gpu, GpuError};
use crate::job::LightViews;

/// Granularity of buffer writes, in bytes.
const WORD: usize = 4;

/// Buffer of a picture's frames: the camera's, then the lights' views, a stride apart.
#[derive(Debug)]
pub struct Frames {
    buffer: Buffer,
    /// Number of frames that fit.
    capacity: usize,
    stride: usize,
    bytes: Vec<u8>,
}

impl Frames {
    /// Creates a buffer for the camera's frame.
    pub fn new(gpu: &Gpu) -> Self {
        Self::with_capacity(gpu, 1)
    }

    fn with_capacity(gpu: &Gpu, capacity: usize) -> Self {
        let least = gpu.device().limits().min_uniform_buffer_offset_alignment as usize;
        let stride = Frame::SIZE.next_multiple_of(least.max(1));
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let buffer = gpu.buffer("frames", (stride * capacity) as u64, usage);
        Self { buffer, capacity, stride, bytes: Vec::new() }
    }

    /// Writes the frames that changed. Returns whether a view changed, and whether the buffer is a
    /// new one.
    pub fn set(&mut self, gpu: &Gpu, frame: Frame, views: &[Frame]) -> [bool; 2] {
        let is_other_buffer = self.capacity < 1 + views.len();
        if is_other_buffer {
            *self = Self::with_capacity(gpu, 1 + views.len());
        }
        let mut bytes = vec![0; self.stride * (1 + views.len())];
        for (place, frame) in bytes.chunks_exact_mut(self.stride).zip([frame].iter().chain(views)) {
            place[..Frame::SIZE].copy_from_slice(&write_all(&[*frame]));
        }
        let of_views = |bytes: &[u8]| bytes.get(self.stride..).unwrap_or_default().to_vec();
        let other_views = of_views(&bytes) != of_views(&self.bytes);
        // The camera changes most of the time, and it alone.
        let (before, now) = (self.bytes.as_chunks::<WORD>().0, bytes.as_chunks::<WORD>().0);
        let is_other = |at: &usize| before.get(*at) != now.get(*at);
        let (first, last) = ((0..now.len()).find(is_other), (0..now.len()).rfind(is_other));
        if let Some((first, last)) = first.zip(last) {
            gpu.write(&self.buffer, (first * WORD) as u64, &bytes[first * WORD..(last + 1) * WORD]);
        }
        self.bytes = bytes;
        [other_views, is_other_buffer]
    }

    /// Returns the binding of a pass, at the offset of its frame.
    pub fn resource(&self) -> BindingResource<'_> {
        let size = BufferSize::new(Frame::SIZE as u64);
        BindingResource::Buffer(BufferBinding { buffer: &self.buffer, offset: 0, size })
    }

    /// Returns the offset of a view's frame.
    fn offset(&self, view: usize) -> u32 {
        (self.stride * (1 + view)) as u32
    }
}

/// Textures of the shadow maps.
#[derive(Debug)]
pub struct LightMap {
    size: u32,
    layers: Vec<TextureView>,
    depth: TextureView,
    /// View of all layers, for lookups.
    pub view: TextureView,
}

/// Program, bind groups and draw call of a surface that casts shadows.
pub struct Caster {
    pub program: RenderPipeline,
    pub maps: BindGroup,
    pub mesh: BindGroup,
    /// BVH of its shells, if any.
    pub shells: Option<BindGroup>,
    pub drawn: DrawCall,
}

impl LightMap {
    /// Whether size and number of layers fit the given views.
    pub fn fits(&self, views: &LightViews) -> bool {
        (self.size, self.layers.len()) == (views.size, views.frames.len())
    }

    /// Creates the textures for views, at least one.
    ///
    /// # Errors
    ///
    /// When the shadow maps are larger, or more, than the adapter takes.
    pub fn new(gpu: &Gpu, views: &LightViews) -> Result<Self, GpuError> {
        let (size, count) = (views.size, views.frames.len() as u32);
        gpu.check_texture("shadow map", [size, size])?;
        let texture = |label, layers, format: TextureFormat, usage| {
            gpu.device().create_texture(&TextureDescriptor {
                label: Some(label),
                size: Extent3d { width: size, height: size, depth_or_array_layers: layers },
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            })
        };
        let keys = texture("shadow maps", count, KEYS, TextureUsages::TEXTURE_BINDING);
        let depth = texture("shadow map depth", 1, DEPTH, TextureUsages::empty());
        let layer = |number| {
            keys.create_view(&TextureViewDescriptor {
                dimension: Some(TextureViewDimension::D2),
                base_array_layer: number,
                array_layer_count: Some(1),
                ..Default::default()
            })
        };
        let dimension = Some(TextureViewDimension::D2Array);
        Ok(Self {
            size,
            layers: (0..count).map(layer).collect(),
            depth: depth.create_view(&Default::default()),
            view: keys.create_view(&TextureViewDescriptor { dimension, ..Default::default() }),
        })
    }

    /// Draws the shadow maps one by one, so that no submission takes long. `pass` is the offset of
    /// the settings of a shadow map's pass.
    pub fn draw(&self, gpu: &Gpu, frames: &Frames, pass: u32, casters: &[Caster]) {
        for (number, layer) in self.layers.iter().enumerate() {
            let mut encoder = gpu.device().create_command_encoder(&Default::default());
            let ops = Operations { load: LoadOp::Clear(Color::TRANSPARENT), store: StoreOp::Store };
            let color =
                RenderPassColorAttachment { view: layer, depth_slice: None, resolve_target: None, ops };
            let mut drawn = encoder.begin_render_pass(&RenderPassDescriptor {
                label: Some("light"),
                color_attachments: &[Some(color)],
                depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                    view: &self.depth,
                    depth_ops: Some(Operations { load: LoadOp::Clear(0.0), store: StoreOp::Discard }),
                    stencil_ops: None,
                }),
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            for caster in casters {
                drawn.set_pipeline(&caster.program);
                drawn.set_bind_group(0, &caster.maps, &[frames.offset(number), pass]);
                drawn.set_bind_group(1, &caster.mesh, &[]);
                if let Some(shells) = &caster.shells {
                    drawn.set_bind_group(2, shells, &[]);
                }
                caster.drawn.draw(&mut drawn);
            }
            drop(drawn);
            gpu.queue().submit([encoder.finish()]);
        }
    }
}
