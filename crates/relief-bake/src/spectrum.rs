//! Real transforms of a plane that turn differences between neighbours into products.

use std::f64::consts::PI;
use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use relief_core::{Cancelled, Watch};

use crate::transpose::transpose;

/// Lines that a thread transforms together.
const LINES: usize = 16;

/// Continuation of a plane beyond its edges: tiled, or mirrored half a sample beyond the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Border {
    Tiled,
    Mirrored,
}

/// Transform of lines of one length: Hartley when they are tiled, cosine (DCT-II) when they are
/// mirrored. Both are real and computed from one real FFT.
pub(crate) struct LineTransform {
    border: Border,
    length: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    back: Arc<dyn ComplexToReal<f64>>,
    /// `exp(-iπk / 2N)`.
    quarter_turns: Vec<Complex<f64>>,
}

/// Buffers for the transform of a line.
struct LineBuffers {
    line: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

/// Changes every wave of a plane. `change` gets the wave's numbers along the lines and across them. The
/// other plane is scratch of the same size.
pub(crate) fn change_waves(
    [along, across]: &[LineTransform; 2],
    plane: &mut [f64],
    turned: &mut [f64],
    watch: &Watch,
    change: impl Fn([usize; 2], &mut f64) + Sync,
) -> Result<(), Cancelled> {
    along.lines(plane, false, &watch.piece(0.0, 0.25))?;
    transpose(plane, along.length, turned);
    across.lines(turned, false, &watch.piece(0.25, 0.5))?;
    turned.par_chunks_mut(across.length).enumerate().for_each(|(i, column)| {
        column.iter_mut().enumerate().for_each(|(j, wave)| change([i, j], wave));
    });
    across.lines(turned, true, &watch.piece(0.5, 0.75))?;
    transpose(turned, across.length, plane);
    along.lines(plane, true, &watch.piece(0.75, 1.0))
}

impl LineTransform {
    pub fn new(length: usize, border: Border) -> Self {
        let mut planner = RealFftPlanner::new();
        let turn = |k: usize| Complex::from_polar(1.0, -PI * k as f64 / (2.0 * length as f64));
        let (forward, back) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
        Self { border, length, forward, back, quarter_turns: (0..=length / 2).map(turn).collect() }
    }

    /// Returns the angle by which a wave of index `k` turns from sample to sample.
    pub fn turn(&self, k: usize) -> f64 {
        match self.border {
            Border::Tiled => 2.0 * PI * k as f64 / self.length as f64,
            Border::Mirrored => PI * k as f64 / self.length as f64,
        }
    }

    /// Returns whether central differences of the wave of index `k` vanish. These are the constant
    /// wave and, in a tiled line of even length, the wave that changes its sign from sample to
    /// sample.
    pub fn is_invisible(&self, k: usize) -> bool {
        k == 0 || (self.border == Border::Tiled && 2 * k == self.length)
    }

    /// Transforms every line of a plane, or back.
    pub fn lines(&self, plane: &mut [f64], back: bool, watch: &Watch) -> Result<(), Cancelled> {
        let buffers = || LineBuffers {
            line: vec![0.0; self.length],
            spectrum: self.forward.make_output_vec(),
            scratch: vec![
                Complex::default();
                self.forward.get_scratch_len().max(self.back.get_scratch_len())
            ],
        };
        let blocks = plane.len().div_ceil(self.length * LINES) as f32;
        plane.par_chunks_mut(self.length * LINES).enumerate().try_for_each_init(
            buffers,
            |buffers, (block, lines)| {
                watch.at(block as f32 / blocks)?;
                for line in lines.chunks_mut(self.length) {
                    match (self.border, back) {
                        (Border::Tiled, false) => self.hartley(line, 1.0, buffers),
                        (Border::Tiled, true) => self.hartley(line, 1.0 / self.length as f64, buffers),
                        (Border::Mirrored, false) => self.cosines(line, buffers),
                        (Border::Mirrored, true) => self.cosines_back(line, buffers),
                    }
                }
                Ok(())
            },
        )
    }

    fn fft(&self, buffers: &mut LineBuffers) {
        self.forward
            .process_with_scratch(&mut buffers.line, &mut buffers.spectrum, &mut buffers.scratch)
            .expect("the buffers have the plan's lengths");
    }

    /// `H[k] = scale Σ x[n] (cos + sin)(2πkn/N)`; its own inverse with `scale = 1/N`.
    fn hartley(&self, line: &mut [f64], scale: f64, buffers: &mut LineBuffers) {
        buffers.line.copy_from_slice(line);
        self.fft(buffers);
        for (k, wave) in buffers.spectrum.iter().enumerate() {
            line[k] = scale * (wave.re - wave.im);
            line[(self.length - k) % self.length] = scale * (wave.re + wave.im);
        }
        // The constant and the alternating wave have no imaginary part, so that both assignments
        // agree.
    }

    /// `C[k] = Σ x[n] cos(πk(2n+1)/2N)`, from an FFT of the even samples and then the odd ones
    /// backwards (Makhoul 1980).
    fn cosines(&self, line: &mut [f64], buffers: &mut LineBuffers) {
        for (n, &x) in line.iter().enumerate() {
            let place = if n % 2 == 0 { n / 2 } else { self.length - 1 - n / 2 };
            buffers.line[place] = x;
        }
        self.fft(buffers);
        for (k, (wave, turn)) in buffers.spectrum.iter().zip(&self.quarter_turns).enumerate() {
            let wave = wave * turn;
            if k > 0 {
                line[self.length - k] = -wave.im;
            }
            line[k] = wave.re;
        }
    }

    fn cosines_back(&self, line: &mut [f64], buffers: &mut LineBuffers) {
        for (k, (wave, turn)) in buffers.spectrum.iter_mut().zip(&self.quarter_turns).enumerate() {
            let mirrored = if k > 0 { line[self.length - k] } else { 0.0 };
            *wave = Complex::new(line[k], -mirrored) * turn.conj();
            if k == 0 || 2 * k == self.length {
                wave.im = 0.0;
            }
        }
        self.back
            .process_with_scratch(&mut buffers.spectrum, &mut buffers.line, &mut buffers.scratch)
            .expect("the buffers have the plan's lengths and the ends are real");
        let scale = 1.0 / self.length as f64;
        for (n, x) in line.iter_mut().enumerate() {
            let place = if n % 2 == 0 { n / 2 } else { self.length - 1 - n / 2 };
            *x = scale * buffers.line[place];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transforms_are_the_sums_that_they_stand_for_and_come_back() {
        for length in [1usize, 2, 3, 4, 7, 12, 53] {
            for border in [Border::Tiled, Border::Mirrored] {
                let line: Vec<f64> = (0..length).map(|n| ((n * n * 7 + 3) % 11) as f64 - 4.0).collect();
                let transform = LineTransform::new(length, border);
                let mut waves = line.clone();
                transform.lines(&mut waves, false, &Watch::none()).expect("nobody cancels");
                for (k, wave) in waves.iter().enumerate() {
                    let basis = |n: usize| match border {
                        Border::Tiled => {
                            let angle = transform.turn(k) * n as f64;
                            angle.cos() + angle.sin()
                        }
                        Border::Mirrored => (transform.turn(k) * (n as f64 + 0.5)).cos(),
                    };
                    let sum: f64 = line.iter().enumerate().map(|(n, x)| x * basis(n)).sum();
                    assert!((wave - sum).abs() < 1e-10, "{border:?} {length}: wave {k} is {wave}, not {sum}");
                }
                transform.lines(&mut waves, true, &Watch::none()).expect("nobody cancels");
                assert!(line.iter().zip(&waves).all(|(a, b)| (a - b).abs() < 1e-12), "{border:?} {length}");
            }
        }
    }
}
