//! Pyramids of least and greatest heights, built on the GPU from its own height map. They need not
//! be baked on the CPU and uploaded (Oh, Ki and Lee 2006, section 3.1).
//!
//! A pyramid has the same bits as the map of kind `pyramid` that the CPU bakes in 32-bit floats,
//! except that its zeros are never negative. It is built level by level. Each level is a pass that
//! reads the one before.

use std::sync::Arc;

use relief_bake::WantedMap;
use relief_bake::kind::pyramid::{KIND, OVER_CELLS, OVER_LEVELS, OVER_TEXELS};
use relief_core::registry::MapLevels;
use relief_core::{HeightMap, MapFormat, MapLayout, Metric};
use relief_shaders::cpu::{PyramidPass, Shared, write_all};
use relief_shaders::{MapNeed, MapSlot};
use wgpu::{
    BindGroup, BindGroupLayout, BindingResource, Buffer, BufferBinding, BufferSize, BufferUsages, Color,
    CommandEncoder, Extent3d, LoadOp, Operations, RenderPassColorAttachment, RenderPassDescriptor,
    RenderPipeline, StoreOp, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};

use super::layouts::group;
use super::{Gpu, GpuError};
use crate::job::JobSurface;

/// Format of a node's least and greatest height. Every device renders to it.
pub const NODES: TextureFormat = TextureFormat::Rg32Float;

/// Bytes of a node.
pub const NODE_BYTES: u32 = 8;

/// Levels of the map that are built. Level 0 is the height map itself.
const LEVELS: MapLevels = MapLevels::ChainFrom(1);

/// Samples over which the extremes are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Dual cells. The extremes bound the surface.
    Cells,
    /// Texels, as in the publication.
    Texels,
    /// Dual cells of all mip levels. The extremes bound the surface in each level of detail.
    Levels,
}

/// Source of a pyramid.
#[derive(Clone, Debug)]
pub struct Source {
    pub heights: Arc<HeightMap>,
    pub over: Over,
}

impl Source {
    /// Returns the source of the pyramid for a slot of a surface, or `None` if the slot needs none.
    pub fn of(surface: &JobSurface, slot: MapSlot) -> Option<Self> {
        let needs = surface.selection.map_needs();
        let over = needs.iter().find(|need| need.slot == slot).and_then(over)?;
        Some(Self { heights: Arc::clone(&surface.height_map), over })
    }

    /// Whether the other source gives the same pyramid.
    pub fn is_same(&self, other: &Self) -> bool {
        self.over == other.over
            && self.heights.wrap() == other.heights.wrap()
            && self.heights.shares_texels(&other.heights)
    }
}

/// Returns the samples of the extremes if a needed map is a pyramid that the GPU can build, else
/// `None`.
pub fn over(need: &MapNeed) -> Option<Over> {
    let is_whole = need.input.texture.is_empty() && need.side.is_none();
    if need.input.kind != KIND.name || !is_whole || need.input.levels != LEVELS {
        return None;
    }
    match need.settings.as_slice() {
        [] => Some(Over::Cells),
        [("over", value)] => {
            let known = [(OVER_CELLS, Over::Cells), (OVER_TEXELS, Over::Texels), (OVER_LEVELS, Over::Levels)];
            known.into_iter().find(|(number, _)| *value == *number as f32).map(|(_, over)| over)
        }
        _ => None,
    }
}

/// Program that builds levels, with the layout of its bind group.
#[derive(Clone, Debug)]
pub struct Builder {
    pub program: RenderPipeline,
    pub layout: BindGroupLayout,
}

impl Builder {
    /// Builds the pyramid of heights that are 32-bit floats on the GPU. With [`Over::Levels`],
    /// `heights` must hold all mip levels. It does not wait for the GPU.
    ///
    /// # Errors
    ///
    /// When the pyramid is larger than the adapter's textures may be.
    pub fn build(
        &self,
        gpu: &Gpu,
        label: &str,
        source: &Source,
        heights: &TextureView,
    ) -> Result<Texture, GpuError> {
        let map = &source.heights;
        let size = [map.width(), map.height()];
        let MapLayout { size: padded, levels, .. } = layout(size)?;
        gpu.check_texture("baked map", padded)?;
        let texture = empty(gpu, label, padded, levels);
        let passes = passes(source, size, levels);
        let (settings, stride) = uniforms(gpu, &passes);
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        let mut finer = heights.clone();
        for level in 0..levels {
            let bytes = BufferSize::new(PyramidPass::SIZE as u64);
            let settings =
                BufferBinding { buffer: &settings, offset: u64::from(level) * stride, size: bytes };
            let bound = [
                ("finer_level", BindingResource::TextureView(&finer)),
                ("heights_below", BindingResource::TextureView(heights)),
                ("pyramid_pass", BindingResource::Buffer(settings)),
            ];
            let read = group(gpu.device(), label, &self.layout, &bound);
            let nodes = level_view(&texture, level);
            self.draw(&mut encoder, &read, &nodes, nodes_size(size, level + 1));
            finer = nodes;
        }
        gpu.queue().submit([encoder.finish()]);
        gpu.count_built();
        Ok(texture)
    }

    /// Draws a level of the given columns and rows, padded with zeros.
    fn draw(&self, encoder: &mut CommandEncoder, read: &BindGroup, nodes: &TextureView, size: [u32; 2]) {
        let ops = Operations { load: LoadOp::Clear(Color::TRANSPARENT), store: StoreOp::Store };
        let target = RenderPassColorAttachment { view: nodes, depth_slice: None, resolve_target: None, ops };
        let mut drawn = encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("pyramid"),
            color_attachments: &[Some(target)],
            depth_stencil_attachment: None,
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        drawn.set_scissor_rect(0, 0, size[0], size[1]);
        drawn.set_pipeline(&self.program);
        drawn.set_bind_group(1, read, &[]);
        drawn.draw(0..3, 0..1);
    }
}

/// Returns the layout of the pyramid of a map with the given columns and rows, as the CPU bakes it.
fn layout(size: [u32; 2]) -> Result<MapLayout, GpuError> {
    let wanted = WantedMap {
        kind: &KIND,
        texture: "",
        settings: KIND.defaults(),
        metric: Metric::UNIT,
        levels: LEVELS,
        height_level: 0,
        format: MapFormat::F32,
    };
    wanted.layout(size).map_err(|error| GpuError::Refused(error.to_string()))
}

/// Returns columns and rows of a level of nodes.
fn nodes_size(size: [u32; 2], level: u32) -> [u32; 2] {
    size.map(|side| side.div_ceil(1 << level))
}

/// Returns the settings of each level's pass.
fn passes(source: &Source, size: [u32; 2], levels: u32) -> Vec<PyramidPass> {
    let wrap = source.heights.wrap();
    let of_level = |level: u32| {
        let reads_heights = level == 0 || (source.over == Over::Levels && level < source.heights.levels());
        let heights_size = if reads_heights { size.map(|side| (side >> level).max(1)) } else { [0, 0] };
        PyramidPass {
            nodes_size: if level == 0 { [0, 0] } else { nodes_size(size, level) }.into(),
            heights_size: heights_size.into(),
            beyond: heights_size.map(|side| wrap.index(i64::from(side), side.max(1))).into(),
            reach: u32::from(source.over != Over::Texels),
            level,
        }
    };
    (0..levels).map(of_level).collect()
}

/// Creates a buffer of the settings of all passes, and returns it with the stride in bytes.
fn uniforms(gpu: &Gpu, passes: &[PyramidPass]) -> (Buffer, u64) {
    let alignment = gpu.device().limits().min_uniform_buffer_offset_alignment as usize;
    let stride = PyramidPass::SIZE.next_multiple_of(alignment);
    let mut bytes = vec![0; passes.len() * stride];
    for (place, pass) in bytes.chunks_mut(stride).zip(passes) {
        place[..PyramidPass::SIZE].copy_from_slice(&write_all(&[*pass]));
    }
    let buffer =
        gpu.buffer("pyramid passes", bytes.len() as u64, BufferUsages::UNIFORM | BufferUsages::COPY_DST);
    gpu.write(&buffer, 0, &bytes);
    (buffer, stride as u64)
}

/// Creates an empty texture of nodes. It can be copied from, for tests.
fn empty(gpu: &Gpu, label: &str, [width, height]: [u32; 2], levels: u32) -> Texture {
    gpu.device().create_texture(&TextureDescriptor {
        label: Some(label),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: levels,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: NODES,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

fn level_view(texture: &Texture, level: u32) -> TextureView {
    texture.create_view(&TextureViewDescriptor {
        dimension: Some(TextureViewDimension::D2),
        base_mip_level: level,
        mip_level_count: Some(1),
        ..Default::default()
    })
}

#[cfg(test)]
mod tests;
