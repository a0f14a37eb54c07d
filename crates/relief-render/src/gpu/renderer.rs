//! Renderer of jobs on a GPU. Each surface takes two passes: one rasterises and traces, the other
//! shades each pixel in which the surface is the nearest so far. With several samples, this is done
//! for each sample, and the results are added up.

mod passes;
mod prepare;
mod time;

use std::ops::Range;

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};
use relief_scene::tone::Tone;
use relief_shaders::MapNeed;
use relief_shaders::cpu::{PixelOut, Record, ScreenSettings, Shared, write_all};
use relief_shaders::wgsl::Sampling;
use wgpu::Texture;

use self::passes::{Passes, dispatch, submit_band};
use super::light_map::{Frames, LightMap};
use super::programs::Programs;
use super::resident::Resident;
use super::targets::{self, Band, Targets};
use super::textures::Precision;
use super::{Gpu, GpuError, pyramid};
use crate::block_on;
use crate::cpu::tessellated::TessellatedCache;
use crate::job::{Job, Rendering};
use crate::samples::samples;

/// Bytes of a pixel of a picture for screens.
const SCREEN_BYTES: u64 = 4;

/// Renders jobs on a GPU and caches there what they share. A second frame of the same surfaces
/// uploads a camera and compiles nothing.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    programs: Programs,
    frames: Frames,
    light_map: Option<LightMap>,
    surfaces: Vec<Resident>,
    targets: Option<Targets>,
    /// Number of the current targets and buffers, which every surface binds.
    generation: u64,
    /// Cache of bases tessellated on the CPU, if this GPU cannot do it.
    tessellated: TessellatedCache,
    work: Work,
}

/// Work for a picture besides drawing it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Bytes uploaded.
    pub uploaded: u64,
    /// Programs compiled.
    pub compiled: u32,
    /// Baked maps built on the GPU.
    pub built: u64,
}

impl GpuRenderer {
    /// Creates a renderer on `gpu` with an empty cache.
    pub fn new(gpu: Gpu) -> Self {
        let (programs, frames) = (Programs::new(&gpu), Frames::new(&gpu));
        let (light_map, surfaces, targets, work) = (None, Vec::new(), None, Work::default());
        let tessellated = TessellatedCache::default();
        Self { gpu, programs, frames, light_map, surfaces, targets, generation: 0, tessellated, work }
    }

    /// Returns the GPU.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Whether the renderer itself builds a map that a surface needs and does not have. It builds
    /// pyramids of heights that are 32-bit floats on the GPU, to the bit as the CPU bakes them.
    pub fn builds(&self, need: &MapNeed, sampling: Sampling) -> bool {
        Precision::of(&self.gpu, sampling) == Precision::F32 && pyramid::over(need).is_some()
    }

    /// Returns the buffers of a surface's last tessellation: totals, corners and faces.
    #[cfg(test)]
    pub(super) fn tessellation_buffers(&self, surface: usize) -> Option<[&wgpu::Buffer; 3]> {
        self.surfaces.get(surface)?.tessellation_buffers()
    }

    /// Returns the work for the last picture besides drawing it.
    pub fn last_work(&self) -> Work {
        self.work
    }

    /// Renders a job and reads it back. `watch` gets the progress after every band of rows. It
    /// waits for the GPU, which the web does not allow: use [`Self::render_async`] there.
    ///
    /// The same adapter always gives the same picture. With exact sampling it differs from the
    /// CPU's by rounding, and at pixels on edges that the rasteriser gives to the other triangle.
    ///
    /// # Errors
    ///
    /// When the picture, a map or a mesh is larger than the adapter takes, or a map is malformed.
    /// Also when memory runs out, the device is lost, or the rendering is cancelled.
    pub fn render(
        &mut self,
        job: &Job,
        sampling: Sampling,
        watch: &Watch<'_>,
    ) -> Result<Rendering, GpuError> {
        block_on(self.render_async(job, sampling, watch))
    }

    /// Renders a job like [`Self::render`], without blocking the thread.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub async fn render_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        watch: &Watch<'_>,
    ) -> Result<Rendering, GpuError> {
        let (width, height) = (job.width, job.height);
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(width as usize * height as usize).map_err(|_| GpuError::OutOfMemory)?;
        let mut sink = |band: &[PixelOut]| {
            // On all cores, since the first touch of memory takes time.
            pixels.par_extend(band);
            Ok(())
        };
        self.render_rows_async(job, sampling, 0..height, true, watch, &mut sink).await?;
        Ok(Rendering { width, height, pixels })
    }

    /// Renders some rows of a job, counted from the top, in bands, without blocking the thread.
    /// `sink` gets each band when it is read back. With `numbers`, pixels are the same as in a
    /// [`Rendering`]. Without, only the colour is; the other values come from one of the pixel's
    /// samples, which takes less time. Rows below the picture do not count.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when `sink` cancels the rendering.
    pub async fn render_rows_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        rows: Range<u32>,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut dyn FnMut(&[PixelOut]) -> Result<(), Cancelled>,
    ) -> Result<(), GpuError> {
        let Range { start, end } = rows.start..rows.end.min(job.height);
        if job.width == 0 || start >= end {
            return Ok(());
        }
        let before = self.work_so_far();
        let ready = self.prepare(job, sampling, samples(job.samples, numbers), None).await?;
        let mut pixels = Vec::new();
        for number in 0..self.targets()?.bands.len() {
            let Some(band) = self.band(number) else { continue };
            let [first, last] = [band.first_row, band.first_row + band.rows].map(|row| row.clamp(start, end));
            if first >= last {
                continue;
            }
            pixels.clear();
            self.read_band(&ready, number, &mut pixels).await?;
            watch.at((last - start) as f32 / (end - start) as f32)?;
            let [first, last] = [first, last].map(|row| (row - band.first_row) as usize * job.width as usize);
            sink(&pixels[first..last])?;
        }
        self.work = self.work_since(before);
        Ok(())
    }

    /// Draws a job into a texture that stays on the GPU, over the frame's background. It holds
    /// linear colours in 16-bit floats. The next call draws over it. Only compiling and large
    /// uploads are waited for.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when the picture is empty.
    pub async fn draw(&mut self, job: &Job, sampling: Sampling) -> Result<&Texture, GpuError> {
        if job.width == 0 || job.height == 0 {
            return Err(GpuError::EmptyPicture);
        }
        targets::check_whole(&self.gpu, [job.width, job.height])?;
        let before = self.work_so_far();
        let ready = self.prepare(job, sampling, samples(job.samples, false), None).await?;
        let show = self.programs.show(&self.gpu, sampling).await?;
        // Every surface's group 0 binds the frame and the passes. Without a surface there is only
        // the background to show.
        let maps = ready.first_groups().ok_or(GpuError::EmptyPicture)?[0].clone();
        let (gpu, layouts) = (self.gpu.clone(), self.programs.layouts.clone());
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        gpu.guarded(|| {
            let (_, shown) = targets.shown(&gpu, &layouts).clone();
            for passes in &targets.bands {
                submit_band(&gpu, targets, &ready, passes, None, |encoder, last| {
                    dispatch(encoder, &show, &[&maps, &shown], targets.size[0], last, None);
                });
            }
            Ok(())
        })
        .await?;
        self.work = self.work_since(before);
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        Ok(&targets.shown(&self.gpu, &self.programs.layouts).0)
    }

    /// Renders a job into a picture for screens: red, green, blue and 255 of each pixel in sRGB, row
    /// by row from the top, after a factor on the light and a tone curve. A pixel takes 4 bytes of
    /// transfer in place of a whole record. Each byte is the one of the picture by
    /// [`Self::render_async`], or a neighbour.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when no surface is shown, or the picture is larger than a buffer of
    /// the adapter.
    pub async fn screen_async(
        &mut self,
        job: &Job,
        sampling: Sampling,
        gain: f32,
        tone: Tone,
    ) -> Result<Vec<u8>, GpuError> {
        let (width, height) = (job.width, job.height);
        if width == 0 || height == 0 {
            return Ok(Vec::new());
        }
        if u64::from(width) * u64::from(height) > self.gpu.storage_capacity(SCREEN_BYTES as usize) {
            let limit = (self.gpu.storage_capacity(SCREEN_BYTES as usize) / u64::from(width)) as u32;
            return Err(GpuError::TooLarge { what: "picture", width, height, limit });
        }
        let before = self.work_so_far();
        let ready = self.prepare(job, sampling, samples(job.samples, false), None).await?;
        let program = self.programs.screen(&self.gpu, sampling).await?;
        let maps = ready.first_groups().ok_or(GpuError::EmptyPicture)?[0].clone();
        let (gpu, layouts) = (self.gpu.clone(), self.programs.layouts.clone());
        let targets = self.targets.as_mut().ok_or(GpuError::EmptyPicture)?;
        let tone = Tone::ALL.iter().position(|known| *known == tone).unwrap_or_default() as u32;
        let settings = ScreenSettings { size: [width, height].into(), gain, tone };
        let bytes = SCREEN_BYTES * u64::from(width) * u64::from(height);
        let screen = targets.screen(&gpu, &layouts).clone();
        gpu.guarded(|| {
            gpu.write(&screen.settings, 0, &write_all(&[settings]));
            for passes in &targets.bands {
                submit_band(&gpu, targets, &ready, passes, None, |encoder, last| {
                    dispatch(encoder, &program, &[&maps, &screen.group], width, last, None);
                });
            }
            let mut encoder = gpu.device().create_command_encoder(&Default::default());
            encoder.copy_buffer_to_buffer(&screen.picture, 0, &screen.readable, 0, bytes);
            gpu.queue().submit([encoder.finish()]);
            Ok(())
        })
        .await?;
        let mut picture = Vec::new();
        picture.try_reserve_exact(bytes as usize).map_err(|_| GpuError::OutOfMemory)?;
        gpu.read(&screen.readable, bytes, |bytes| picture.extend_from_slice(bytes)).await?;
        self.work = self.work_since(before);
        Ok(picture)
    }

    fn work_so_far(&self) -> Work {
        let (uploaded, built) = (self.gpu.uploaded(), self.gpu.built());
        Work { uploaded, compiled: self.programs.compiled(), built }
    }

    fn work_since(&self, before: Work) -> Work {
        let now = self.work_so_far();
        Work {
            uploaded: now.uploaded - before.uploaded,
            compiled: now.compiled - before.compiled,
            built: now.built - before.built,
        }
    }

    fn targets(&mut self) -> Result<&mut Targets, GpuError> {
        self.targets.as_mut().ok_or(GpuError::EmptyPicture)
    }

    /// Returns the rows of a band.
    fn band(&self, number: usize) -> Option<Band> {
        Some(self.targets.as_ref()?.bands.get(number)?.first()?.band)
    }

    /// Traces and shades the rows of a band, and reads them back.
    async fn read_band(
        &mut self,
        ready: &Passes,
        number: usize,
        pixels: &mut Vec<PixelOut>,
    ) -> Result<(), GpuError> {
        let gpu = self.gpu.clone();
        let band = self.band(number).ok_or(GpuError::EmptyPicture)?;
        let targets = self.targets()?;
        let [bytes, _] = targets.bytes(band);
        let readable = gpu
            .guarded(|| {
                let readable = targets.readable(&gpu).clone();
                submit_band(&gpu, targets, ready, &targets.bands[number], None, |encoder, _| {
                    encoder.copy_buffer_to_buffer(&targets.records, 0, &readable, 0, bytes);
                });
                Ok(readable)
            })
            .await?;
        let read = gpu.read(&readable, bytes, |bytes| {
            let records = bytes.par_chunks_exact(Record::SIZE).map(Record::read);
            pixels.par_extend(records.map(pixel_of));
        });
        read.await
    }
}

fn pixel_of(record: Record) -> PixelOut {
    PixelOut {
        color: record.color,
        hit: record.hit & 1,
        exhausted: (record.hit >> 1) & 1,
        uv: record.uv,
        height: record.height,
        position: record.position,
        normal: record.normal,
        depth: record.depth,
        t: record.t,
        cell: record.cell,
        reads: record.reads,
        steps: record.steps,
        bytes: record.bytes,
        lit: record.lit,
        level: (record.hit >> 2) & 63,
        z: record.z,
        surface: record.hit >> 8,
        transmittance: record.transmittance,
    }
}
