//! Device and queue of a GPU, with buffers, transfers and error handling.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use relief_shaders::cpu::{Shared, write_all};
use wgpu::{Buffer, BufferDescriptor, BufferUsages, DeviceDescriptor, ErrorFilter, MapMode, PollType};

use super::promise::promise;
use super::textures::STAGING_BYTES;
use super::{AdapterChoice, GpuError, adapter};
use crate::block_on;

/// GPU with an open device and its queue. Clones share them.
#[derive(Clone, Debug)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    description: String,
    filters_f32: bool,
    band_pixels: u32,
    /// Errors that the driver reported outside of any call; `None` for a caller's own device, whose
    /// handlers the caller keeps.
    driver_errors: Option<Arc<Mutex<DriverErrors>>>,
    uploaded: Arc<AtomicU64>,
    built: Arc<AtomicU64>,
}

/// Errors that the driver reported outside of any call.
#[derive(Debug, Default)]
struct DriverErrors {
    lost: Option<String>,
    stray: Option<GpuError>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Gpu {
    /// Opens the best adapter of a kind, and waits for it. The web does not allow waiting: use
    /// [`Self::open`] there.
    ///
    /// # Errors
    ///
    /// When there is no such adapter, or when its driver refuses to open it.
    pub fn new(choice: AdapterChoice) -> Result<Self, GpuError> {
        block_on(Self::open(choice))
    }

    /// Opens the best adapter of a kind.
    ///
    /// # Errors
    ///
    /// When there is no such adapter, or when its driver refuses to open it.
    pub async fn open(choice: AdapterChoice) -> Result<Self, GpuError> {
        let adapter = choice.find().await?;
        let info = adapter.get_info();
        let descriptor = DeviceDescriptor {
            label: Some("relief"),
            required_features: adapter::features(&adapter),
            required_limits: adapter::limits(&adapter),
            ..Default::default()
        };
        let (device, queue) = adapter
            .request_device(&descriptor)
            .await
            .map_err(|error| GpuError::Device { adapter: info.name.clone(), reason: error.to_string() })?;
        let driver_errors = Arc::new(Mutex::new(DriverErrors::default()));
        let noted = Arc::clone(&driver_errors);
        device.set_device_lost_callback(move |cause, reason| {
            let reason = if reason.is_empty() { format!("{cause:?}").to_lowercase() } else { reason };
            locked(&noted).lost.get_or_insert(reason);
        });
        let noted = Arc::clone(&driver_errors);
        device.on_uncaptured_error(Arc::new(move |error| {
            locked(&noted).stray.get_or_insert(refusal(&error));
        }));
        let gpu = Self::of_device(device, queue, &adapter::described(&info));
        let band_pixels = adapter::band_pixels(info.device_type);
        Ok(Self { band_pixels, driver_errors: Some(driver_errors), ..gpu })
    }

    /// Wraps a device and queue of the caller, whose error handlers stay. Errors of Relief's own
    /// commands are caught and returned as results. `name` describes the device in errors and
    /// reports.
    ///
    /// The device's limits must be at least WebGPU's reduced ones, `Limits::downlevel_defaults()`.
    /// With the feature `FLOAT32_FILTERABLE`, fast sampling reads maps in 32-bit floats, without it
    /// in 16-bit floats.
    pub fn of_device(device: wgpu::Device, queue: wgpu::Queue, name: &str) -> Self {
        Self {
            filters_f32: device.features().contains(wgpu::Features::FLOAT32_FILTERABLE),
            band_pixels: adapter::BAND_PIXELS,
            device,
            queue,
            description: name.to_owned(),
            driver_errors: None,
            uploaded: Arc::default(),
            built: Arc::default(),
        }
    }

    /// Returns the adapter's name, its backend and its driver.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// Whether the device is known to be lost. Of a caller's own device it is not known.
    pub fn is_lost(&self) -> bool {
        self.driver_errors.as_ref().is_some_and(|errors| locked(errors).lost.is_some())
    }

    /// Returns the device.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Returns the device's queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Whether samplers filter 32-bit floats.
    pub(super) fn filters_f32(&self) -> bool {
        self.filters_f32
    }

    /// Returns the number of pixels that are traced, shaded and read back at once.
    pub(super) fn band_pixels(&self) -> u32 {
        self.band_pixels
    }

    /// Returns the bytes uploaded so far, by all clones.
    pub(super) fn uploaded(&self) -> u64 {
        self.uploaded.load(Ordering::Relaxed)
    }

    /// Counts uploaded bytes.
    pub(super) fn count(&self, bytes: usize) {
        self.uploaded.fetch_add(bytes as u64, Ordering::Relaxed);
    }

    /// Returns the number of baked maps built on the GPU so far, by all clones.
    pub(super) fn built(&self) -> u64 {
        self.built.load(Ordering::Relaxed)
    }

    /// Counts a baked map built on the GPU.
    pub(super) fn count_built(&self) {
        self.built.fetch_add(1, Ordering::Relaxed);
    }

    /// Runs commands and returns the driver's errors. Lack of memory comes first, then a loss of
    /// the device, because other errors follow from both. The first refused command comes last.
    pub(super) async fn guarded<T>(&self, work: impl FnOnce() -> Result<T, GpuError>) -> Result<T, GpuError> {
        self.check()?;
        let refused = self.device.push_error_scope(ErrorFilter::Validation);
        let failed = self.device.push_error_scope(ErrorFilter::Internal);
        let memory = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let result = work();
        let [memory, failed, refused] = [memory.pop(), failed.pop(), refused.pop()];
        if memory.await.is_some() {
            return Err(GpuError::OutOfMemory);
        }
        match failed.await.or(refused.await) {
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

    /// Returns the error that was reported since the last call, if any. A lost device stays lost.
    fn check(&self) -> Result<(), GpuError> {
        let Some(driver_errors) = &self.driver_errors else { return Ok(()) };
        let mut driver_errors = locked(driver_errors);
        if let Some(reason) = &driver_errors.lost {
            return Err(GpuError::Lost(reason.clone()));
        }
        driver_errors.stray.take().map_or(Ok(()), Err)
    }

    /// Waits until the GPU has finished all submitted work. On the web it returns at once.
    pub(super) fn wait(&self) -> Result<(), GpuError> {
        // wgpu panics here when the driver reports a loss; its message is all that is known then.
        let polled = catch_unwind(AssertUnwindSafe(|| self.device.poll(PollType::wait_indefinitely())));
        match polled {
            Ok(Ok(_)) => self.check(),
            Ok(Err(error)) => Err(GpuError::Refused(error.to_string())),
            Err(panic) => {
                let reason = panic.downcast_ref::<String>().map_or("the driver reset it", String::as_str);
                let reason = reason.trim().to_owned();
                Err(GpuError::Lost(match &self.driver_errors {
                    Some(driver_errors) => locked(driver_errors).lost.get_or_insert(reason).clone(),
                    None => reason,
                }))
            }
        }
    }

    /// Submits all writes so far, so that their staging memory can be reused.
    pub(super) fn flush(&self) -> Result<(), GpuError> {
        self.queue.submit([]);
        self.wait()
    }

    /// Fails if a texture is larger than the adapter takes.
    pub(super) fn check_texture(
        &self,
        what: &'static str,
        [width, height]: [u32; 2],
    ) -> Result<(), GpuError> {
        let limit = self.device.limits().max_texture_dimension_2d;
        if width > limit || height > limit {
            return Err(GpuError::TooLarge { what, width, height, limit });
        }
        Ok(())
    }

    /// Returns the number of values of `bytes` bytes each that a storage buffer holds at most.
    pub(super) fn storage_capacity(&self, bytes: usize) -> u64 {
        let limits = self.device.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / bytes as u64
    }

    /// Creates an empty buffer.
    pub(super) fn buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Buffer {
        let label = Some(label);
        self.device.create_buffer(&BufferDescriptor { label, size: bytes, usage, mapped_at_creation: false })
    }

    /// Writes bytes into a buffer.
    pub(super) fn write(&self, buffer: &Buffer, offset: u64, bytes: &[u8]) {
        self.count(bytes.len());
        self.queue.write_buffer(buffer, offset, bytes);
    }

    /// Creates a buffer of values. Without values it holds one of zeros, because buffers cannot be
    /// empty.
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
            self.write(&buffer, (number * count * T::SIZE) as u64, &write_all(chunk));
        }
        Ok(buffer)
    }

    /// Reads the first bytes of a buffer, waits for them, and calls `each` with them.
    pub(super) async fn read(
        &self,
        buffer: &Buffer,
        bytes: u64,
        each: impl FnOnce(&[u8]),
    ) -> Result<(), GpuError> {
        let (sender, receiver) = promise();
        buffer.map_async(MapMode::Read, ..bytes, move |mapped| sender.send(mapped));
        self.wait()?;
        let failed = |reason: String| self.check().err().unwrap_or(GpuError::Refused(reason));
        receiver.await.map_err(|error| failed(error.to_string()))?;
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
