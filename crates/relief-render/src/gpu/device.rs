//! A GPU that is ready to work, and the few things that every task does with it.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use relief_shaders::STAGES;
use relief_shaders::cpu::{Settings, Shared, write_all};
use wgpu::{Buffer, BufferDescriptor, BufferUsages, DeviceDescriptor, ErrorFilter, MapMode, PollType};

use super::probe::ProbeProgram;
use super::render::RenderProgram;
use super::{AdapterChoice, GpuError, Sampling, adapter};

/// Bytes that are handed to the driver at once; as many wait in its staging memory. Smaller uploads wait more often.
pub(super) const STAGING_BYTES: usize = 16 << 20;

/// A GPU. Pipelines are compiled when a method is first used and kept, so one `Gpu` should serve many pictures.
pub struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    pub(super) render_programs: Programs<RenderProgram>,
    pub(super) probe_programs: Programs<ProbeProgram>,
    description: String,
    filterable: bool,
    troubles: Arc<Mutex<Troubles>>,
}

/// What the driver reported outside of any call.
#[derive(Default)]
struct Troubles {
    lost: Option<String>,
    stray: Option<GpuError>,
}

/// What a program is compiled for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Variant {
    pub sampling: Sampling,
    pub two_sided: bool,
    /// The number of each stage's variant.
    numbers: [u32; STAGES.len()],
}

impl Variant {
    pub fn new(settings: &Settings, sampling: Sampling, two_sided: bool) -> Self {
        Self { sampling, two_sided, numbers: settings.choices.map(|choice| choice.number) }
    }

    /// The values of a shader's overridable constants: of the stages that it reaches.
    pub fn constants(&self, source: &str) -> Vec<(String, f64)> {
        let named = STAGES.iter().zip(self.numbers);
        named
            .map(|(stage, number)| (stage.key.to_uppercase(), f64::from(number)))
            .filter(|(name, _)| source.contains(&format!("override {name}:")))
            .collect()
    }
}

/// Compiled programs by variant.
pub(super) struct Programs<T>(Mutex<HashMap<Variant, T>>);

impl<T: Clone> Programs<T> {
    fn new() -> Self {
        Self(Mutex::new(HashMap::new()))
    }

    /// The program of a variant, compiled unless it is there. A program that the driver refused is not kept.
    pub fn get(&self, gpu: &Gpu, variant: Variant, compile: impl FnOnce() -> T) -> Result<T, GpuError> {
        if let Some(program) = locked(&self.0).get(&variant) {
            return Ok(program.clone());
        }
        let program = gpu.guarded(|| Ok(compile()))?;
        locked(&self.0).insert(variant, program.clone());
        Ok(program)
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Gpu {
    /// Opens the best adapter of a kind.
    ///
    /// # Errors
    ///
    /// When there is no such adapter, or when its driver refuses to open it.
    pub fn new(choice: AdapterChoice) -> Result<Self, GpuError> {
        let adapter = choice.find()?;
        let info = adapter.get_info();
        let features = adapter::features(&adapter);
        let descriptor = DeviceDescriptor {
            label: Some("relief"),
            required_features: features,
            required_limits: adapter::limits(&adapter),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| GpuError::Device { adapter: info.name.clone(), reason: error.to_string() })?;
        let troubles = Arc::new(Mutex::new(Troubles::default()));
        let noted = Arc::clone(&troubles);
        device.set_device_lost_callback(move |cause, reason| {
            let reason = if reason.is_empty() { format!("{cause:?}").to_lowercase() } else { reason };
            locked(&noted).lost.get_or_insert(reason);
        });
        let noted = Arc::clone(&troubles);
        device.on_uncaptured_error(Arc::new(move |error| {
            locked(&noted).stray.get_or_insert(refusal(&error));
        }));
        Ok(Self {
            device,
            queue,
            render_programs: Programs::new(),
            probe_programs: Programs::new(),
            description: adapter::described(&info),
            filterable: features.contains(wgpu::Features::FLOAT32_FILTERABLE),
            troubles,
        })
    }

    /// The adapter's name, its backend and its driver.
    pub fn description(&self) -> String {
        self.description.clone()
    }

    /// Runs commands and turns whatever the driver says of them into an error: lack of memory first, then a loss of the
    /// device, from both of which other errors follow, then the first refusal.
    pub(super) fn guarded<T>(&self, work: impl FnOnce() -> Result<T, GpuError>) -> Result<T, GpuError> {
        self.check()?;
        let refused = self.device.push_error_scope(ErrorFilter::Validation);
        let failed = self.device.push_error_scope(ErrorFilter::Internal);
        let memory = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let result = work();
        let [memory, failed, refused] =
            [memory, failed, refused].map(|scope| pollster::block_on(scope.pop()));
        if memory.is_some() {
            return Err(GpuError::OutOfMemory);
        }
        match failed.or(refused) {
            Some(error) => {
                // A loss is reported when the device is asked.
                self.wait()?;
                Err(refusal(&error))
            }
            None => {
                self.check()?;
                result
            }
        }
    }

    /// The error that was reported since the last call, if any. A loss stays.
    fn check(&self) -> Result<(), GpuError> {
        let mut troubles = locked(&self.troubles);
        if let Some(reason) = &troubles.lost {
            return Err(GpuError::Lost(reason.clone()));
        }
        troubles.stray.take().map_or(Ok(()), Err)
    }

    /// Waits until the GPU has done all that it was given.
    pub(super) fn wait(&self) -> Result<(), GpuError> {
        // wgpu panics here when the driver reports a loss; its message is all that is known then.
        let polled = catch_unwind(AssertUnwindSafe(|| self.device.poll(PollType::wait_indefinitely())));
        match polled {
            Ok(Ok(_)) => self.check(),
            Ok(Err(error)) => Err(GpuError::Refused(error.to_string())),
            Err(panic) => {
                let reason = panic.downcast_ref::<String>().map_or("the driver reset it", String::as_str);
                let mut troubles = locked(&self.troubles);
                Err(GpuError::Lost(troubles.lost.get_or_insert(reason.trim().to_owned()).clone()))
            }
        }
    }

    /// Hands over what was written so far, so that its staging memory can be used again.
    pub(super) fn flush(&self) -> Result<(), GpuError> {
        self.queue.submit([]);
        self.wait()
    }

    /// Refuses a sampling that the adapter cannot do.
    pub(super) fn check_sampling(&self, sampling: Sampling) -> Result<(), GpuError> {
        if sampling == Sampling::Fast && !self.filterable {
            return Err(GpuError::NotFilterable { adapter: self.description.clone() });
        }
        Ok(())
    }

    /// Refuses a texture that the adapter cannot hold.
    pub(super) fn check_texture(&self, what: &'static str, width: u32, height: u32) -> Result<(), GpuError> {
        let limit = self.device.limits().max_texture_dimension_2d;
        if width > limit || height > limit {
            return Err(GpuError::TooLarge { what, width, height, limit });
        }
        Ok(())
    }

    /// The most values of `bytes` bytes each that a storage buffer holds.
    pub(super) fn storage_capacity(&self, bytes: usize) -> u64 {
        let limits = self.device.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / bytes as u64
    }

    /// An empty buffer.
    pub(super) fn buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Buffer {
        let label = Some(label);
        self.device.create_buffer(&BufferDescriptor { label, size: bytes, usage, mapped_at_creation: false })
    }

    /// A buffer of values. It holds one value of zeros when there are none, because buffers cannot be empty.
    pub(super) fn filled<T: Shared>(
        &self,
        label: &str,
        values: &[T],
        usage: BufferUsages,
    ) -> Result<Buffer, GpuError> {
        let buffer =
            self.buffer(label, (values.len().max(1) * T::SIZE) as u64, usage | BufferUsages::COPY_DST);
        let count = STAGING_BYTES / T::SIZE;
        for (number, chunk) in values.chunks(count).enumerate() {
            if number > 0 {
                self.flush()?;
            }
            self.queue.write_buffer(&buffer, (number * count * T::SIZE) as u64, &write_all(chunk));
        }
        Ok(buffer)
    }

    /// Waits for the first bytes of a buffer and shows them to `each`.
    pub(super) fn read(&self, buffer: &Buffer, bytes: u64, each: impl FnOnce(&[u8])) -> Result<(), GpuError> {
        let (sender, receiver) = mpsc::channel();
        buffer.map_async(MapMode::Read, ..bytes, move |mapped| {
            // The receiver is gone only when waiting failed, which is reported then.
            let _ = sender.send(mapped);
        });
        self.wait()?;
        let failed = |reason: String| self.check().err().unwrap_or(GpuError::Refused(reason));
        receiver
            .recv()
            .map_err(|error| failed(error.to_string()))?
            .map_err(|error| failed(error.to_string()))?;
        let view = buffer.get_mapped_range(..bytes).map_err(|error| failed(error.to_string()))?;
        each(&view);
        drop(view);
        buffer.unmap();
        Ok(())
    }
}

fn refusal(error: &wgpu::Error) -> GpuError {
    match error {
        wgpu::Error::OutOfMemory { .. } => GpuError::OutOfMemory,
        wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
            GpuError::Refused(description.trim().to_owned())
        }
    }
}
