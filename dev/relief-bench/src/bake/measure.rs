//! Time and memory of a bake.

use std::process::{Command, ExitCode};
use std::time::Instant;

use cpu_time::ProcessTime;
use rayon::ThreadPool;
use relief_bake::{Kind, Settings, Sink, SinkError, Texture, bake};
use relief_core::{HeightMap, Metric, Watch};

use crate::memory;

/// Seconds that the runs of a bake take together at least.
const LEAST_S: f64 = 0.05;

/// The most runs of a bake.
const MOST_RUNS: usize = 10_000;

/// From how many bytes on the C library of Linux takes memory from the system and gives it back.
const FRESH: (&str, &str) = ("MALLOC_MMAP_THRESHOLD_", "65536");

/// Runs this program again so that planes are fresh memory in every bake, and gives its exit code; nothing
/// where it runs so.
///
/// Else the small maps of a series get the memory that the bake before has left, which large ones do not, and
/// time seems to grow faster than the map. Only the C library's start reads this, so it cannot be set for the
/// program that runs already.
///
/// # Errors
///
/// When the program cannot be run again.
pub fn with_fresh_memory() -> Result<Option<ExitCode>, String> {
    if !cfg!(target_os = "linux") || std::env::var_os(FRESH.0).is_some() {
        return Ok(None);
    }
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let mut again = Command::new(program);
    let status = again.args(std::env::args_os().skip(1)).env(FRESH.0, FRESH.1).status();
    let code = status.map_err(|error| error.to_string())?.code().and_then(|code| u8::try_from(code).ok());
    Ok(Some(ExitCode::from(code.unwrap_or(1))))
}

/// Time and memory of a bake.
pub struct Measured {
    /// Milliseconds: the median of the runs.
    pub ms: f64,
    /// Milliseconds of processor time, which other programs disturb less.
    pub cpu_ms: f64,
    /// Input, output and everything between, at its peak, over input and output.
    pub memory: f64,
}

/// Takes textures and forgets them, so that only the bake is timed.
#[derive(Default)]
struct Nowhere {
    values: u64,
}

impl Sink for Nowhere {
    fn begin(&mut self, _: &Texture) -> Result<(), SinkError> {
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        self.values += planes.iter().map(|plane| plane.len() as u64).sum::<u64>();
        std::hint::black_box(planes);
        Ok(())
    }
}

/// Bakes on the threads of a pool until the given number of times and [`LEAST_S`] are reached. A bake
/// that takes more than `once_s` runs once.
pub fn measure(
    kind: &Kind,
    map: &HeightMap,
    metric: Metric,
    settings: &Settings,
    pool: &ThreadPool,
    runs: usize,
    once_s: f64,
) -> Result<Measured, String> {
    let input = size_of_val(map.texels()) as f64;
    let (mut times, mut cpu_times, mut memory) = (Vec::new(), Vec::new(), 0.0f64);
    let mut total = 0.0;
    while times.is_empty()
        || (times.len() < runs && total < once_s)
        || (total < LEAST_S && times.len() < MOST_RUNS)
    {
        let mut sink = Nowhere::default();
        memory::reset();
        let (started, cpu) = (Instant::now(), ProcessTime::now());
        pool.install(|| bake(kind, map, metric, settings, &Watch::none(), &mut sink))
            .map_err(|error| error.to_string())?;
        let seconds = started.elapsed().as_secs_f64();
        cpu_times.push(cpu.elapsed().as_secs_f64());
        let output = (size_of::<f32>() as u64 * sink.values) as f64;
        memory = memory.max((input + memory::peak() as f64) / (input + output));
        times.push(seconds);
        total += seconds;
    }
    Ok(Measured { ms: 1e3 * median(times), cpu_ms: 1e3 * median(cpu_times), memory })
}

/// The median of at least one value.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[values.len() / 2]
}
