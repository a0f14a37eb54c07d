//! Squared distance transform of a line by its monotone minima.
//!
//! All parabolas are the same but for their place. So of two samples each stays the nearer one on
//! its side of where they cross. From sample to sample the place of the minimum never goes back:
//! the matrix of distances is totally monotone (Aggarwal, Klawe, Moran, Shor and Wilber 1987,
//! *Geometric Applications of a Matrix-Searching Algorithm*). For a few samples the places are
//! found by halving, each between the places of its two neighbours. Samples between two of these
//! few test only the places between the two. In the mean these are as many places as there are
//! samples, whatever the distances. Where roundings leave several places open, all of them stay
//! candidates, in whole runs that are compared at once.

/// Samples between two whose place of the minimum is found: they test their candidates together.
const BLOCK: usize = 16;

/// Candidates that are compared together.
const LANES: usize = 16;

/// Relative excess in `f32` up to which a minimum counts as no greater than another: more than the
/// roundings of both.
const CAUTION: f32 = 1.0 / (1 << 20) as f32;

/// Tables and buffers for lines of one length.
#[derive(Debug)]
pub struct Monotone {
    margin: usize,
    /// Squared distances of samples, from `margin` and a block to the left on.
    rises: Vec<f32>,
    /// First and last place where the minimum may be attained, for every sample at a block's begin,
    /// and for the last sample.
    places: Vec<[usize; 2]>,
}

impl Monotone {
    /// Allocates buffers for lines of `length` samples, `step_squared` apart, with `margin` more at
    /// either end.
    pub fn new(length: usize, margin: usize, step_squared: f32) -> Self {
        let farthest = (margin + BLOCK) as i64;
        let rises = (-farthest..=farthest).map(|k| step_squared * (k * k) as f32).collect();
        Self { margin, rises, places: vec![[0; 2]; length.div_ceil(BLOCK) + 1] }
    }

    /// Computes `out[i] = min over k of values[margin + i + k] + step² k²` for `k` from `-margin`
    /// to `margin`, in `f32`. The minimum over more samples must not be less.
    pub fn transform(&mut self, values: &[f32], out: &mut [f32]) {
        let last = self.places.len() - 1;
        let sample = |point: usize| (point * BLOCK).min(out.len() - 1);
        for point in [0, last] {
            self.places[point] = self.attained(values, sample(point), [0, values.len() - 1]);
        }
        let mut stride = last.next_power_of_two();
        while stride > 1 {
            for point in (stride / 2..last).step_by(stride) {
                let (before, after) = (point - stride / 2, (point + stride / 2).min(last));
                let between = [self.places[before][0], self.places[after][1]];
                self.places[point] = self.attained(values, sample(point), between);
            }
            stride /= 2;
        }
        for (block, out) in out.chunks_mut(BLOCK).enumerate() {
            // For a sample later in the block, the rises are as much farther on in the table.
            let first = 2 * self.margin + BLOCK + block * BLOCK;
            let mut best = [f32::MAX; BLOCK];
            let (from, to) = (self.places[block][0], self.places[block + 1][1].min(first));
            for (place, value) in (from..).zip(&values[from..=to]) {
                let Some(rises) = self.rises.get(first - place..first - place + BLOCK) else { continue };
                for (best, rise) in best.iter_mut().zip(rises) {
                    let distance = value + rise;
                    *best = if distance < *best { distance } else { *best };
                }
            }
            out.copy_from_slice(&best[..out.len()]);
        }
    }

    /// Returns the first and the last place, between two given ones, where the minimum of a sample
    /// may be attained.
    fn attained(&self, values: &[f32], sample: usize, [from, to]: [usize; 2]) -> [usize; 2] {
        let (from, to) = (from.max(sample), to.min(sample + 2 * self.margin));
        let values = &values[from..=to];
        let rises = &self.rises[from + BLOCK - sample..][..values.len()];
        let ((values, value_rest), (rises, rise_rest)) =
            (values.as_chunks::<LANES>(), rises.as_chunks::<LANES>());
        let lesser = |a: f32, b: f32| if a < b { a } else { b };
        let mut least = [f32::MAX; LANES];
        for (values, rises) in values.iter().zip(rises) {
            for (least, (value, rise)) in least.iter_mut().zip(values.iter().zip(rises)) {
                *least = lesser(value + rise, *least);
            }
        }
        let rest = value_rest.iter().zip(rise_rest).map(|(value, rise)| value + rise);
        let limit = rest.chain(least).fold(f32::MAX, lesser) * (1.0 + CAUTION);
        let near = |values: &[f32], rises: &[f32]| {
            values.iter().zip(rises).fold(false, |near, (value, rise)| near | (value + rise <= limit))
        };
        let pairs = || values.iter().zip(rises);
        let (whole, end) = (values.len() * LANES, from + values.len() * LANES + value_rest.len() - 1);
        let first = pairs()
            .position(|(values, rises)| near(values, rises))
            .map_or(from + whole, |at| from + at * LANES);
        let last = if near(value_rest, rise_rest) {
            end
        } else {
            pairs()
                .rposition(|(values, rises)| near(values, rises))
                .map_or(end, |at| from + at * LANES + LANES - 1)
        };
        [first, last]
    }
}
