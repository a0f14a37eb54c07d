//! What the passes of a picture write: textures of the whole picture, and buffers of a band of its rows.

use relief_shaders::cpu::{PassSettings, Record, Shared, write_all};
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferBinding, BufferSize, BufferUsages, Extent3d, Texture,
    TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView, TextureViewDescriptor,
};

use super::layouts::{PICTURE, group};
use super::programs::{DEPTH, HIT, Layouts, WHAT};
use super::{Gpu, GpuError};

/// Pixels of a band of rows, which is traced, shaded and read back at once: 20 MiB of records. Larger, and
/// slow adapters may take so long that the system resets them; smaller, and the mesh is drawn more often than
/// need be.
const BAND_PIXELS: u32 = 1 << 18;

/// A band of rows.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    pub first_row: u32,
    pub rows: u32,
    /// Where its settings lie in the buffer of all passes.
    pub offset: u32,
}

/// The targets of pictures of one size.
#[derive(Debug)]
pub struct Targets {
    pub size: [u32; 2],
    pub bands: Vec<Band>,
    pub hit: TextureView,
    pub what: TextureView,
    pub depth: TextureView,
    pub records: Buffer,
    /// Group 2 of the pass that shades.
    pub traced: BindGroup,
    passes: Buffer,
    /// For reading back; made when something is.
    readable: Option<Buffer>,
    /// The picture that stays on the GPU, with group 1 of the pass that shows; made when it is asked for.
    shown: Option<(Texture, BindGroup)>,
}

impl Targets {
    /// The targets of pictures of that size, which is not empty.
    pub fn new(gpu: &Gpu, [width, height]: [u32; 2], layouts: &Layouts) -> Self {
        let texture = |label, format, usage| {
            let usage = TextureUsages::RENDER_ATTACHMENT | usage;
            let texture = target(gpu, label, [width, height], format, usage);
            texture.create_view(&TextureViewDescriptor::default())
        };
        let rows = (BAND_PIXELS / width).clamp(1, height);
        let stride = gpu.device().limits().min_uniform_buffer_offset_alignment.max(PassSettings::SIZE as u32);
        let bands: Vec<Band> = (0..height.div_ceil(rows))
            .map(|number| {
                let first_row = number * rows;
                Band { first_row, rows: rows.min(height - first_row), offset: number * stride }
            })
            .collect();
        let records = gpu.buffer(
            "records",
            u64::from(width) * u64::from(rows) * Record::SIZE as u64,
            BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
        );
        let hit = texture("traced hit", HIT, TextureUsages::TEXTURE_BINDING);
        let what = texture("traced what", WHAT, TextureUsages::TEXTURE_BINDING);
        let depth = texture("depth", DEPTH, TextureUsages::empty());
        let bound = [
            ("traced_hit", BindingResource::TextureView(&hit)),
            ("traced_what", BindingResource::TextureView(&what)),
            ("records", records.as_entire_binding()),
        ];
        let traced = group(gpu.device(), "traced", &layouts.traced, &bound);
        let passes = passes(gpu, &bands, stride);
        Self {
            size: [width, height],
            bands,
            hit,
            what,
            depth,
            records,
            traced,
            passes,
            readable: None,
            shown: None,
        }
    }

    /// What a pass binds of the buffer of all passes, at the offset of its band.
    pub fn passes(&self) -> BindingResource<'_> {
        let size = BufferSize::new(PassSettings::SIZE as u64);
        BindingResource::Buffer(BufferBinding { buffer: &self.passes, offset: 0, size })
    }

    /// Bytes of a band's records.
    pub fn bytes(&self, band: Band) -> u64 {
        u64::from(self.size[0]) * u64::from(band.rows) * Record::SIZE as u64
    }

    /// The buffer that a band's records are read back from.
    pub fn readable(&mut self, gpu: &Gpu) -> &Buffer {
        let bytes = self.records.size();
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        self.readable.get_or_insert_with(|| gpu.buffer("records to read", bytes, usage))
    }

    /// The picture that stays on the GPU, and group 1 of the pass that shows it.
    pub fn shown(&mut self, gpu: &Gpu, layouts: &Layouts) -> &(Texture, BindGroup) {
        let (size, records) = (self.size, &self.records);
        self.shown.get_or_insert_with(|| {
            let usage =
                TextureUsages::STORAGE_BINDING | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC;
            let picture = target(gpu, "picture", size, PICTURE, usage);
            let view = picture.create_view(&TextureViewDescriptor::default());
            let bound = [
                ("shown_records", records.as_entire_binding()),
                ("picture", BindingResource::TextureView(&view)),
            ];
            let group = group(gpu.device(), "shown", &layouts.shown, &bound);
            (picture, group)
        })
    }
}

/// The settings of every band's pass, a stride apart.
fn passes(gpu: &Gpu, bands: &[Band], stride: u32) -> Buffer {
    let mut bytes = vec![0; stride as usize * bands.len()];
    for Band { first_row, rows, offset } in bands {
        let settings = PassSettings { offset: [0.0; 2].into(), first_row: *first_row, rows: *rows };
        let of_band = write_all(&[settings]);
        bytes[*offset as usize..][..of_band.len()].copy_from_slice(&of_band);
    }
    let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
    let buffer = gpu.buffer("passes", bytes.len() as u64, usage);
    gpu.write(&buffer, 0, &bytes);
    buffer
}

fn target(
    gpu: &Gpu,
    label: &str,
    [width, height]: [u32; 2],
    format: TextureFormat,
    usage: TextureUsages,
) -> Texture {
    gpu.device().create_texture(&TextureDescriptor {
        label: Some(label),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// Refuses pictures that the adapter cannot hold.
pub fn check(gpu: &Gpu, size: [u32; 2]) -> Result<(), GpuError> {
    gpu.check_texture("picture", size)
}
