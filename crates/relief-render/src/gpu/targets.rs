//! Targets of a picture's passes: textures and buffers for a band of its rows.

use relief_shaders::cpu::{Gathered, PassSettings, Record, ScreenSettings, Shared, write_all};
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferBinding, BufferSize, BufferUsages, Extent3d, Texture,
    TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView, TextureViewDescriptor,
};

use super::layouts::{PICTURE, group};
use super::pipelines::{DEPTH, DEPTH_AND_COUNT, HIT, WHAT};
use super::programs::Layouts;
use super::{Gpu, GpuError};
use crate::samples::Sample;

/// Bytes of the sum of a pixel's colours.
const SUM_BYTES: u64 = 16;

/// A band of rows.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    pub first_row: u32,
    pub rows: u32,
}

/// One sample of the pixels of a band.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    pub band: Band,
    /// Offset of the pass's settings in the buffer of all passes.
    pub offset: u32,
    pub is_last: bool,
}

/// Targets of pictures of one size.
#[derive(Debug)]
pub struct Targets {
    pub size: [u32; 2],
    /// Samples of every pixel.
    pub samples: Vec<Sample>,
    /// Whether there is a stencil buffer beside the depths.
    pub counts: bool,
    /// Passes of each band, from the top.
    pub bands: Vec<Vec<Pass>>,
    pub hit: TextureView,
    pub what: TextureView,
    pub depth: TextureView,
    pub records: Buffer,
    pub sums: Buffer,
    /// Group 2 of the passes that shade and resolve.
    pub traced: BindGroup,
    /// Number of translucent surfaces, and what their passes bind, if there are any.
    pub translucent: u32,
    gathered: Option<Gathering>,
    passes: Buffer,
    /// Buffer for reading back, created when first needed.
    readable: Option<Buffer>,
    /// Offset of the settings of a pass over all of a shadow map.
    pub whole: u32,
    /// Picture that stays on the GPU, with group 1 of the pass that shows it. Created when first
    /// needed.
    shown: Option<(Texture, BindGroup)>,
    /// The picture for screens. It is allocated when it is first needed.
    screen: Option<Screen>,
}

/// What the pass that makes the picture for screens binds.
#[derive(Clone, Debug)]
pub struct Screen {
    /// The settings.
    pub settings: Buffer,
    /// The picture: red, green, blue and 255 of each pixel.
    pub picture: Buffer,
    /// The buffer from which it is read back.
    pub readable: Buffer,
    /// Group 1 of the pass.
    pub group: BindGroup,
}

/// What passes over translucent surfaces bind.
#[derive(Debug)]
struct Gathering {
    /// What every pixel sees of each.
    gathered: Buffer,
    /// Group 2 of the passes before and behind them.
    composed: BindGroup,
}

impl Targets {
    /// Creates the targets of pictures of a size, which is not empty, and with the given samples.
    /// With `counts` they have a stencil buffer, in which images of objects are counted. `translucent` is
    /// the number of translucent surfaces.
    ///
    /// # Errors
    ///
    /// When the settings of all passes do not fit into a buffer.
    pub fn new(
        gpu: &Gpu,
        [width, height]: [u32; 2],
        samples: Vec<Sample>,
        counts: bool,
        translucent: u32,
        layouts: &Layouts,
    ) -> Result<Self, GpuError> {
        let gathered_bytes = Gathered::SIZE as u64 * u64::from(translucent);
        let fitting = gpu.storage_capacity(gathered_bytes.max(1) as usize).min(u64::from(u32::MAX)) as u32;
        if fitting < width {
            return Err(GpuError::TooManyTranslucent { surfaces: translucent, width });
        }
        let rows = (gpu.band_pixels().min(fitting) / width).clamp(1, height);
        let texture = |label, format, usage| {
            let usage = TextureUsages::RENDER_ATTACHMENT | usage;
            let texture = target(gpu, label, [width, rows], format, usage);
            texture.create_view(&TextureViewDescriptor::default())
        };
        let stride = gpu.device().limits().min_uniform_buffer_offset_alignment.max(PassSettings::SIZE as u32);
        // One more is for the shadow maps.
        let count = u64::from(height.div_ceil(rows)) * samples.len() as u64 + 1;
        if count * u64::from(stride) > gpu.device().limits().max_buffer_size.min(u64::from(u32::MAX)) {
            return Err(GpuError::TooManyPasses { samples: samples.len(), width, height });
        }
        let band = |number: u32| {
            let first_row = number * rows;
            let band = Band { first_row, rows: rows.min(height - first_row) };
            let pass = |at: usize| Pass {
                band,
                offset: (number * samples.len() as u32 + at as u32) * stride,
                is_last: at + 1 == samples.len(),
            };
            (0..samples.len()).map(pass).collect()
        };
        let bands: Vec<Vec<Pass>> = (0..height.div_ceil(rows)).map(band).collect();
        let pixels = u64::from(width) * u64::from(rows);
        let storage = BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let records = gpu.buffer("records", pixels * Record::SIZE as u64, storage);
        let sums = gpu.buffer("sums", pixels * SUM_BYTES, storage);
        let hit = texture("traced hit", HIT, TextureUsages::TEXTURE_BINDING);
        let what = texture("traced what", WHAT, TextureUsages::TEXTURE_BINDING);
        let format = if counts { DEPTH_AND_COUNT } else { DEPTH };
        let depth = texture("depth", format, TextureUsages::empty());
        let bound = [
            ("traced_hit", BindingResource::TextureView(&hit)),
            ("traced_what", BindingResource::TextureView(&what)),
            ("records", records.as_entire_binding()),
            ("sums", sums.as_entire_binding()),
        ];
        let traced = group(gpu.device(), "traced", &layouts.traced, &bound);
        let gathered = (translucent > 0).then(|| {
            let gathered = gpu.buffer("gathered", pixels * gathered_bytes, storage);
            let bound = [
                ("traced_what", BindingResource::TextureView(&what)),
                ("records", records.as_entire_binding()),
                ("gathered", gathered.as_entire_binding()),
            ];
            let composed = group(gpu.device(), "composed", &layouts.composed, &bound);
            Gathering { gathered, composed }
        });
        let passes = passes(gpu, [width, height], rows, &samples, &bands, stride);
        let size = [width, height];
        let (readable, shown, screen) = (None, None, None);
        let whole = (count - 1) as u32 * stride;
        Ok(Self {
            size,
            samples,
            counts,
            bands,
            hit,
            what,
            depth,
            records,
            sums,
            traced,
            translucent,
            gathered,
            passes,
            readable,
            whole,
            shown,
            screen,
        })
    }

    /// Returns the binding of the buffer of all passes' settings, at the offset of a pass.
    pub fn passes(&self) -> BindingResource<'_> {
        let size = BufferSize::new(PassSettings::SIZE as u64);
        BindingResource::Buffer(BufferBinding { buffer: &self.passes, offset: 0, size })
    }

    /// Returns group 2 of the passes before and behind those over translucent surfaces, if there are any.
    pub fn composed(&self) -> Option<&BindGroup> {
        self.gathered.as_ref().map(|gathering| &gathering.composed)
    }

    /// Creates group 2 of the pass over a translucent surface, from the BVH of its shells.
    pub fn gathered(&self, gpu: &Gpu, layouts: &Layouts, nodes: &Buffer) -> Option<BindGroup> {
        let Gathering { gathered, .. } = self.gathered.as_ref()?;
        let bound = [
            ("traced_what", BindingResource::TextureView(&self.what)),
            ("gathered", gathered.as_entire_binding()),
            ("shell_nodes", nodes.as_entire_binding()),
        ];
        Some(group(gpu.device(), "gathered", &layouts.gathered, &bound))
    }

    /// Returns the bytes of a band's records, and of its sums of colours.
    pub fn bytes(&self, band: Band) -> [u64; 2] {
        let pixels = u64::from(self.size[0]) * u64::from(band.rows);
        [pixels * Record::SIZE as u64, pixels * SUM_BYTES]
    }

    /// Returns the buffer from which a band's records are read back.
    pub fn readable(&mut self, gpu: &Gpu) -> &Buffer {
        let bytes = self.records.size();
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        self.readable.get_or_insert_with(|| gpu.buffer("records to read", bytes, usage))
    }

    /// Returns the picture for screens.
    pub fn screen(&mut self, gpu: &Gpu, layouts: &Layouts) -> &Screen {
        let ([width, height], records) = (self.size, &self.records);
        self.screen.get_or_insert_with(|| {
            let bytes = 4 * u64::from(width) * u64::from(height);
            let picture = gpu.buffer("screen", bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
            let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
            let settings = gpu.buffer("screen settings", ScreenSettings::SIZE as u64, usage);
            let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
            let readable = gpu.buffer("screen to read", bytes, usage);
            let bound = [
                ("shown_records", records.as_entire_binding()),
                ("screen_settings", settings.as_entire_binding()),
                ("screen", picture.as_entire_binding()),
            ];
            let group = group(gpu.device(), "screen", &layouts.screen, &bound);
            Screen { settings, picture, readable, group }
        })
    }

    /// Returns the picture that stays on the GPU, and group 1 of the pass that shows it.
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

/// Creates the buffer of every pass's settings, a stride apart, over targets of the given rows. The
/// last settings are for a pass over all of a shadow map.
fn passes(
    gpu: &Gpu,
    [width, height]: [u32; 2],
    rows: u32,
    samples: &[Sample],
    bands: &[Vec<Pass>],
    stride: u32,
) -> Buffer {
    let mut bytes = vec![0; stride as usize * (bands.len() * samples.len() + 1)];
    let zoom = height as f32 / rows as f32;
    for (pass, sample) in bands.iter().flat_map(|band| band.iter().zip(samples)) {
        let [right, down] = sample.offset;
        let Band { first_row, rows: in_band } = pass.band;
        // The targets show the picture from the band's first row on, moved against the sample's
        // offset.
        let across = 2.0 * right / width as f32;
        let along = 2.0 * (first_row as f32 + down) / rows as f32;
        let settings = PassSettings {
            offset: sample.offset.into(),
            shift: [-across, 1.0 - zoom + along].into(),
            zoom,
            weight: sample.weight,
            first_row,
            rows: in_band,
            is_last: u32::from(pass.is_last),
        };
        let of_pass = write_all(&[settings]);
        bytes[pass.offset as usize..][..of_pass.len()].copy_from_slice(&of_pass);
    }
    let whole = PassSettings {
        offset: [0.0; 2].into(),
        shift: [0.0; 2].into(),
        zoom: 1.0,
        weight: 1.0,
        first_row: 0,
        rows: 0,
        is_last: 1,
    };
    let (of_whole, at) = (write_all(&[whole]), stride as usize * bands.len() * samples.len());
    bytes[at..][..of_whole.len()].copy_from_slice(&of_whole);
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

/// Fails if a picture's rows are too long for the adapter.
pub fn check(gpu: &Gpu, size: [u32; 2]) -> Result<(), GpuError> {
    let fits = size[0] <= gpu.device().limits().max_texture_dimension_2d;
    if fits { Ok(()) } else { check_whole(gpu, size) }
}

/// Fails if the adapter cannot hold a picture in one texture.
pub fn check_whole(gpu: &Gpu, size: [u32; 2]) -> Result<(), GpuError> {
    gpu.check_texture("picture", size)
}
