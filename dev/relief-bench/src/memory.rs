//! Memory that this program holds, counted by its allocator.

use std::alloc::System;
use std::hint::black_box;

use peakmem_alloc::{PeakMemAlloc, PeakMemAllocTrait};

#[global_allocator]
static ALLOCATOR: PeakMemAlloc<System> = PeakMemAlloc::system();

/// Bytes of a block that is larger than all that is measured beside it. It is asked for, and not touched.
const PROBE: usize = 1 << 30;

/// Begins to measure.
pub fn reset() {
    ALLOCATOR.reset_peak_memory();
}

/// The most bytes that were held at a time since then, over those held then.
pub fn peak() -> usize {
    ALLOCATOR.get_peak_memory()
}

/// Makes something, and counts the bytes that are held when it is made over those before.
pub fn held<T>(make: impl FnOnce() -> T) -> (T, usize) {
    reset();
    let made = make();
    // The allocator reports peaks alone: a block's peak on top of the memory held before it.
    drop(black_box(Vec::<u8>::with_capacity(PROBE)));
    let held = peak().saturating_sub(PROBE);
    (made, held)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_is_told_from_what_was_needed() {
        // So large that what other tests hold meanwhile is little. None of it is touched.
        const LARGE: usize = 1 << 29;
        let (made, bytes) = held(|| {
            drop(black_box(Vec::<u8>::with_capacity(LARGE)));
            Vec::<u8>::with_capacity(LARGE)
        });
        assert!(made.capacity() == LARGE && (bytes as f64 / LARGE as f64 - 1.0).abs() < 0.25, "{bytes}");
    }
}
