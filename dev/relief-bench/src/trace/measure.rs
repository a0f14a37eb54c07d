//! Rays a second by processor time: a thread that is kept from running on a shared machine does not count as
//! slow.

use std::hint::black_box;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use cpu_time::ThreadTime;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::samples::Samples;

/// Rays between two looks at the clock. Fewer and looking costs time; more and the slowest tracer overruns
/// its turn.
const CHUNK: usize = 1024;

/// A pool of that many threads.
pub fn pool(threads: usize) -> Result<ThreadPool, String> {
    ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
}

/// Where in a set of rays the next measurement goes on, so that all rays get their turn.
#[derive(Debug, Default)]
pub struct Cursor(AtomicUsize);

impl Cursor {
    /// The next chunk of `count` rays. Successive chunks are as far apart as the golden ratio puts them, so
    /// that any number of them is spread evenly over the picture: a slow tracer that gets to a part of the
    /// rays only is given as many near and far, hard and easy ones as a fast one.
    fn next_chunk(&self, count: usize) -> Range<usize> {
        let chunks = count.div_ceil(CHUNK).max(1);
        let turn = self.0.fetch_add(1, Ordering::Relaxed) % chunks;
        let from = turn * stride(chunks) % chunks * CHUNK;
        from..(from + CHUNK).min(count)
    }
}

/// The number nearest to `0.618 * chunks` that shares no factor with it.
fn stride(chunks: usize) -> usize {
    let shares_factor = |step: usize| {
        let (mut a, mut b) = (chunks, step);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a > 1
    };
    let mut step = (chunks as f64 * 0.618_034).round().max(1.0) as usize;
    while shares_factor(step) {
        step += 1;
    }
    step
}

/// Rays a second of processor time, summed over the threads of the pool: on each of them `trace` gets chunk
/// after chunk of `count` rays until its time is over, and returns what it found.
pub fn rays_per_second(
    pool: &ThreadPool,
    count: usize,
    cursor: &Cursor,
    turn: Duration,
    trace: impl Fn(Range<usize>) -> usize + Sync,
) -> f64 {
    let rates = pool.broadcast(|_| {
        let start = ThreadTime::now();
        let mut rays = 0;
        loop {
            let chunk = cursor.next_chunk(count);
            rays += chunk.len();
            black_box(trace(chunk));
            let elapsed = start.elapsed();
            if elapsed >= turn {
                return rays as f64 / elapsed.as_secs_f64();
            }
        }
    });
    rates.iter().sum()
}

/// Texels that one measurement of a set-up goes over, in as many copies as that takes.
const SETUP_TEXELS: usize = 1 << 22;

/// Texels of a map from which on the memory of what is built from it can be told from the allocator's
/// reserves.
const MEMORY_TEXELS: usize = 1 << 24;

/// Time and memory to build something from a map.
pub struct Setup {
    /// Seconds.
    pub seconds: Samples,
    /// Resident memory that it holds, in bytes a texel, where that can be measured.
    pub bytes_per_texel: Option<f64>,
}

/// Builds something from a map of that many texels, `rounds` times.
pub fn set_up<T>(texels: usize, rounds: usize, build: impl Fn() -> T) -> Setup {
    let copies = SETUP_TEXELS.div_ceil(texels);
    let mut seconds = Samples::default();
    let mut bytes_per_texel = None;
    for _ in 0..rounds {
        let before = resident_bytes();
        let start = Instant::now();
        let built: Vec<T> = (0..copies).map(|_| build()).collect();
        seconds.push(start.elapsed().as_secs_f64() / copies as f64);
        if texels >= MEMORY_TEXELS
            && let (Some(before), Some(after)) = (before, resident_bytes())
        {
            bytes_per_texel = Some((after - before) / (texels * copies) as f64);
        }
        drop(black_box(built));
    }
    Setup { seconds, bytes_per_texel }
}

/// Memory of this process that is in use; `None` where the system does not tell.
fn resident_bytes() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok().map(|kib| kib * 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ray_gets_its_turn_once_a_round() {
        for count in [1, 1023, 1024, 5000, 100 * CHUNK, 97 * CHUNK + 1] {
            let (cursor, chunks) = (Cursor::default(), count.div_ceil(CHUNK));
            let mut seen = vec![0; count];
            for _ in 0..chunks {
                cursor.next_chunk(count).for_each(|ray| seen[ray] += 1);
            }
            assert!(seen.iter().all(|&times| times == 1), "{count} rays");
        }
    }

    #[test]
    fn the_first_chunks_are_spread_over_the_whole() {
        let (cursor, count) = (Cursor::default(), 730 * CHUNK);
        let mut starts: Vec<usize> = (0..20).map(|_| cursor.next_chunk(count).start).collect();
        starts.sort_unstable();
        let widest = starts.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or_default();
        assert!(widest < count / 8, "a gap of {widest} of {count} rays");
    }
}
