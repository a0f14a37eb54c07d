//! Distance fields for sphere tracing: lower bounds of the distance to the relief, from every point
//! above it.
//!
//! Szirmay-Kalos and Umenhoffer 2008, section 4.3.4, after Hart 1993 and Donnelly 2005. Their
//! transform, by Danielsson, is not exact. Here each height slice is one exact two-dimensional
//! transform, along columns and then along rows (Felzenszwalb and Huttenlocher 2012).
//!
//! # What is stored
//!
//! The map is a volume of `W x H x slices` voxels, read trilinearly at `(u, v, height)`, with the
//! map's wrap along `u` and `v` and clamped along the height. Voxel `(i, j, k)` has its centre over
//! texel `(i, j)` at height `(k + ½) / slices`. A value is a length in metres of the [`Metric`]. It
//! is negative where the surface may be nearer than the voxels can resolve.
//!
//! # Guarantee
//!
//! Let `q` be a point with a height of at least 0 (under `clamp` also outside of the footprint).
//! The trilinear fetch at `q` is at most the distance from `q` to the bilinear surface, and not
//! positive below it.
//!
//! *Proof.* Let `S` be the closed set on and below the bilinear surface, and `d` the distance to
//! it. Let `c` be the eight voxel centres around `q` and `w` their trilinear weights, so that
//! `q = Σ w c`.
//!
//! 1. *At a voxel centre* the transform gives the distance `b` to the union of boxes that stand on
//!    dual cells and reach up to the highest of their four corners. A patch never rises above its
//!    corners, so `S` lies in the union and `b(c) ≤ d(c)`. The distance is exact because the point
//!    of a dual cell that is nearest to a texel centre is one of the cell's corners. So the least
//!    over boxes is the least over texels `x` of `|c - x|² + max(0, z - h⁺(x))²`. Here `h⁺` is the
//!    highest of the 3x3 texels around `x`, which are the corners of the four boxes that meet
//!    there. Texels beyond the edge of a clamped or mirrored map may be left out, since each
//!    repeats the `h⁺` of a nearer one inside, or a lower one.
//! 2. *Between voxel centres*: let `s` be the point of `S` next to `q`. Then `b(c)² ≤ |c - s|²`,
//!    and `Σ w |c - s|² = |q - s|² + Σ w |c - q|²`. The last sum is `Σ over axes a² f (1 - f)` for
//!    the voxel's sides `a` and the fractions `f` of `q` in it. It is at most `δ²` with `δ` half of
//!    the voxel's diagonal. So `Σ w b² ≤ d(q)² + δ²`.
//! 3. *Stored* is `φ(b²)` with `φ(t) = (t - δ²) / δ` up to `t = 2δ²` and `sqrt(t - δ²)` above. `φ`
//!    rises and is concave (at `2δ²` its slope falls from `1/δ` to `1/2δ`). So the fetch is
//!    `Σ w φ(b²) ≤ φ(Σ w b²) ≤ φ(d(q)² + δ²)`, which is `d(q)` from `d(q) = δ` on and
//!    `d(q)²/δ ≤ d(q)` before. Far from the surface this costs `δ²/2d` only, where subtracting half
//!    of the diagonal would cost `δ` everywhere.
//! 4. *Ends of the volume*: `d` grows with the height, since a ball lifted out of `S` stays out of
//!    it. So the last slice bounds everything above it. Slice 0 holds `φ(0)`, the value at height
//!    0, which the fetch between height 0 and its centre needs; its centre would allow more.
//!    Outside of a clamped footprint the fetch equals the fetch at the nearest point of the border.
//!    Clamping coordinates takes `S` into itself and brings no two points further apart.
//! 5. *Rounding*: every stored value is lowered by `2^-19 (|value| + 6δ)` and by `δ/128`. The first
//!    is more than `f32` rounding can add: five roundings of the square, of `φ` and of a trilinear
//!    interpolation in `f32` (neighbours differ by `4√2 δ` at most). The second is the way between
//!    `q` and the point that a texture unit fetches for it when its weights have 8 bits.
//!
//! # Cost
//!
//! The time is O(1) a voxel. Slices are made one after the other, each by all threads. The working
//! set is three planes of `f32` beside the map (`h⁺`, one transform and the slice) and, for each
//! thread, 16 lines.

mod line;
mod monotone;
mod window;

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, Metric, Rounding, Watch, Wrap};

use self::line::Line;
use super::{BITS, Kind, Reach};
use crate::quantise::unorm;
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture};

/// The kind `distance`.
pub const KIND: Kind = Kind {
    name: "distance",
    summary: "distance to the relief from every point above it, a volume, for sphere tracing",
    revision: 1,
    publication: Publication { paper: "Szirmay-Kalos and Umenhoffer 2008", section: "4.3.4" },
    params: &[SLICES, BITS],
    guarantee: "a trilinear fetch is at most the distance to the bilinear surface, in the metres of the \
                bake's metric",
    is_picture: false,
    of_volume: false,
    shapes: |size, settings| vec![Shape::slices("", size, settings.count(0), 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| 3.5,
    bake,
};

const SLICES: Param = Param {
    name: "slices",
    summary: "height slices of the volume",
    unit: "slices",
    min: 2.0,
    max: 2048.0,
    default: 64.0,
    integer: true,
    names: &[],
};

/// Lines that a thread transposes together: one cache line of `f32` from each column.
const LINES: usize = 16;

/// Amount by which stored values are lowered, relative to themselves and six half diagonals.
/// Smaller, rounding could break the bound.
const ROUNDING: f32 = 1.0 / (1 << 19) as f32;

/// Part of the half diagonal by which a texture unit's 8-bit weights may move the fetched point: 1
/// of 128.
const WEIGHTS: f32 = 1.0 / 128.0;

/// Amount by which integers are lowered before they are rounded down, as a part of the range. It is
/// twice the rounding of scaling to the range and back in `f32`.
const DECODING: f32 = 1.0 / (1 << 21) as f32;

/// Distance field to be computed, with the data that its slices share.
#[derive(Debug)]
pub struct DistanceField {
    size: [u32; 3],
    /// Whether the map is repeated beyond its edges.
    repeats: bool,
    /// Most texels that a distance is long, along `u` and `v`.
    reach: [usize; 2],
    /// Unit of lengths, in metres: the longest of texel and relief, so that squares fit `f32`.
    unit_m: f64,
    /// Size of a texel along `u` and `v` and height of the relief, in that unit.
    texel: [f64; 2],
    scale: f64,
    /// Half of a voxel's diagonal in that unit.
    half_diagonal: f64,
    /// Dilated heights `h⁺`, column by column.
    tops: Vec<f32>,
    /// Lowest dilated height.
    lowest: f32,
}

impl DistanceField {
    /// Prepares the field of a map in a metric, with `slices` height slices, at least one.
    pub fn new(map: &HeightMap, metric: Metric, slices: u32) -> Self {
        let slices = slices.max(1);
        let texel_m = metric.texel_m(map);
        let unit_m = texel_m[0].max(texel_m[1]).max(metric.scale_m);
        let texel = texel_m.map(|side| side / unit_m);
        let scale = metric.scale_m / unit_m;
        let depth = scale / f64::from(slices);
        let tops = dilated_columns(map);
        let lowest = tops.par_iter().copied().reduce(|| 1.0, f32::min);
        // No distance is longer than the way straight down.
        let longest = (1.0 - f64::from(lowest)) * scale;
        let reach = texel.map(|texel| (longest / texel).ceil() as usize);
        let repeats = map.wrap() == Wrap::Repeat;
        let half_diagonal = 0.5 * (texel[0] * texel[0] + texel[1] * texel[1] + depth * depth).sqrt();
        let size = [map.width(), map.height(), slices];
        Self { size, repeats, reach, unit_m, texel, scale, half_diagonal, tops, lowest }
    }

    /// Returns half of a voxel's diagonal in metres.
    pub fn half_diagonal_m(&self) -> f64 {
        self.half_diagonal * self.unit_m
    }

    /// Returns the range of all values, in metres.
    pub fn range_m(&self) -> [f32; 2] {
        let top = 1.0 - 0.5 / f64::from(self.size[2]);
        let longest = (top - f64::from(self.lowest)).max(0.0) * self.scale;
        let least = f64::from(self.stored(0.0)) * self.unit_m;
        [(least * (1.0 + 1e-6)) as f32, (longest.max(self.half_diagonal) * self.unit_m) as f32]
    }

    /// Computes the slices from the lowest up and hands each to `each`, its values in metres row by
    /// row from the top. Ends early with the first error.
    ///
    /// # Errors
    ///
    /// When the bake is cancelled, or `each` fails.
    pub fn slices(
        &self,
        watch: &Watch,
        mut each: impl FnMut(&mut [f32]) -> Result<(), BakeError>,
    ) -> Result<(), BakeError> {
        let texels = self.size[0] as usize * self.size[1] as usize;
        let (mut columns, mut slice) = (vec![0.0; texels], vec![0.0; texels]);
        let count = self.size[2];
        for k in 0..count {
            let watch = watch.piece(k as f32 / count as f32, (k + 1) as f32 / count as f32);
            watch.at(0.0)?;
            if k == 0 {
                slice.fill(self.metres(0.0));
            } else {
                let level = (f64::from(k) + 0.5) / f64::from(count);
                self.along_columns(level, &mut columns, &watch.piece(0.0, 0.5))?;
                self.along_rows(&columns, &mut slice, &watch.piece(0.5, 1.0))?;
            }
            each(&mut slice)?;
        }
        Ok(watch.at(1.0)?)
    }

    /// Computes squared distances within each column at height `level`. [`LINES`] columns lie
    /// together. Within them, [`LINES`] rows lie together, column by column, as
    /// [`Self::along_rows`] reads them.
    fn along_columns(&self, level: f64, columns: &mut [f32], watch: &Watch) -> Result<(), Cancelled> {
        let height = self.size[1] as usize;
        let blocks = self.size[0].div_ceil(LINES as u32) as f32;
        let chunk = height * LINES;
        columns.par_chunks_mut(chunk).zip(self.tops.par_chunks(chunk)).enumerate().try_for_each_init(
            || (Line::new(height, self.texel[1], self.reach[1], self.repeats), vec![0.0f32; height]),
            |(line, distances), (block, (columns, tops))| {
                watch.at(block as f32 / blocks)?;
                let count = tops.len() / height;
                for (i, tops) in tops.chunks(height).enumerate() {
                    for (sample, &top) in line.samples().iter_mut().zip(tops) {
                        let gap = (level - f64::from(top)).max(0.0) * self.scale;
                        *sample = (gap * gap) as f32;
                    }
                    line.transform(distances);
                    for (part, rows) in distances.chunks(LINES).zip(columns.chunks_mut(count * LINES)) {
                        rows[i * part.len()..(i + 1) * part.len()].copy_from_slice(part);
                    }
                }
                Ok(())
            },
        )
    }

    /// Computes the slice's values from the squared distances within columns.
    fn along_rows(&self, columns: &[f32], slice: &mut [f32], watch: &Watch) -> Result<(), Cancelled> {
        let [width, height] = [self.size[0] as usize, self.size[1] as usize];
        let blocks = self.size[1].div_ceil(LINES as u32) as f32;
        let line = || Line::new(width, self.texel[0], self.reach[0], self.repeats);
        // The stride is longer than a row, so that rows of a power of two do not all fall into the
        // same cache lines.
        let stride = width + LINES;
        slice.par_chunks_mut(width * LINES).enumerate().try_for_each_init(
            || (line(), vec![0.0f32; stride * LINES]),
            |(line, across), (block, rows)| {
                watch.at(block as f32 / blocks)?;
                let count = rows.len() / width;
                for (group, columns) in columns.chunks(height * LINES).enumerate() {
                    let all = columns.len() / height;
                    let block = &columns[block * LINES * all..][..count * all];
                    for (i, column) in block.chunks(count).enumerate() {
                        for (j, &value) in column.iter().enumerate() {
                            across[j * stride + group * LINES + i] = value;
                        }
                    }
                }
                for (row, across) in rows.chunks_mut(width).zip(across.chunks(stride)) {
                    line.samples().copy_from_slice(&across[..width]);
                    line.transform(row);
                    for value in row {
                        *value = self.metres(*value);
                    }
                }
                Ok(())
            },
        )
    }

    /// Returns the stored value for a squared distance to the boxes, in metres.
    #[inline]
    fn metres(&self, squared: f32) -> f32 {
        self.stored(squared) * self.unit_m as f32
    }

    /// Returns the stored value in the field's unit: `φ`, lowered for rounding.
    #[inline]
    fn stored(&self, squared: f32) -> f32 {
        let half = self.half_diagonal as f32;
        let over = squared - half * half;
        let bound = if over <= half * half { over / half } else { over.sqrt() };
        bound - ROUNDING * (bound.abs() + 6.0 * half) - WEIGHTS * half
    }
}

/// Returns the highest of the 3x3 texels around each texel, column by column.
fn dilated_columns(map: &HeightMap) -> Vec<f32> {
    let [width, height] = [map.width() as usize, map.height() as usize];
    let wrapped = |at: usize, side: u32| {
        let at = at as i64;
        [map.wrap().index(at - 1, side) as usize, at as usize, map.wrap().index(at + 1, side) as usize]
    };
    let texels = map.texels();
    let mut tops = vec![0.0; width * height];
    tops.par_chunks_mut(height * LINES).enumerate().for_each_init(
        || vec![[0.0f32; LINES]; height],
        |across, (block, columns)| {
            let first = block * LINES;
            for (row, across) in texels.chunks(width).zip(across.iter_mut()) {
                for (i, highest) in (first..width.min(first + LINES)).zip(across) {
                    let [before, here, after] = wrapped(i, map.width());
                    *highest = row[before].max(row[here]).max(row[after]);
                }
            }
            for (place, column) in columns.chunks_mut(height).enumerate() {
                for (j, top) in column.iter_mut().enumerate() {
                    let [above, here, below] = wrapped(j, map.height());
                    *top = across[above][place].max(across[here][place]).max(across[below][place]);
                }
            }
        },
    );
    tops
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (slices, bits) = (settings.count(0), settings.count(1));
    let field = DistanceField::new(source.map, source.metric, slices);
    let [low, high] = field.range_m();
    if !(low.is_normal() && high.is_normal() && (high - low).is_normal()) {
        let reason =
            format!("distances of {low} to {high} m are beyond 32-bit floats: use another unit of length");
        return Err(BakeError::Impossible { kind: KIND.name, reason });
    }
    sink.begin(&Texture {
        name: "",
        size: field.size,
        mips: Vec::new(),
        channels: vec![Channel { name: "distance", unit: "m", range: [low, high], rounding: Rounding::Down }],
        notes: vec![
            ("unit", "m".to_owned()),
            ("slices", "centred at heights (k + 1/2) / slices".to_owned()),
            ("half diagonal of a voxel", format!("{} m", field.half_diagonal_m())),
        ],
    })?;
    field.slices(watch, |slice| {
        if bits != 0 {
            let span = high - low;
            slice.par_iter_mut().for_each(|value| {
                let part = (*value - low) / span - DECODING;
                *value = low + span * unorm(part, bits, Rounding::Down);
            });
        }
        Ok(sink.slice(&[slice])?)
    })
}
