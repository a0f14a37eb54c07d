//! Distances to the solid of a volume, by which a walk over its cells skips empty ones.

use rayon::prelude::*;
use relief_core::{Cancelled, SliceLayout, Volume, Watch, Wrap};

/// Distances of the dual cells of a volume, see [`volume_distance`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VolumeDistance {
    layout: SliceLayout,
    wrap: Wrap,
    texels: Vec<u8>,
}

impl VolumeDistance {
    /// Greatest distance that is stored.
    pub const MOST: u8 = u8::MAX;

    /// Where the slices of cells lie in [`texels`](Self::texels): as the volume's in its atlas.
    /// Cell `(i, j, k)` has the place of voxel `(i, j, k)`.
    pub fn layout(&self) -> SliceLayout {
        self.layout
    }

    /// All distances, row by row of the atlas. What remains of the last row of slices is 0.
    pub fn texels(&self) -> &[u8] {
        &self.texels
    }

    /// Distance of dual cell `(i, j, k)`, which lies between voxel `(i, j, k)` and voxel
    /// `(i + 1, j + 1, k + 1)`. Outside of the tile cells are wrapped as the volume. A cell before
    /// the first voxel, at a mirrored or clamped edge or below the lowest slice, has the distance of
    /// the cell behind that voxel.
    pub fn cell(&self, i: i64, j: i64, k: i64) -> u8 {
        let [columns, rows, slices] = self.layout.size();
        let along = |at: i64, count: u32| match self.wrap {
            Wrap::Repeat | Wrap::Clamp => self.wrap.index(at, count),
            // A cell is mirrored with its voxels: cell -1 lies between voxel 0 and its image.
            Wrap::Mirror => {
                let (count, turn) = (i64::from(count), 2 * i64::from(count));
                let place = (at + 1).rem_euclid(turn);
                (place.min(turn - place) - 1).clamp(0, count - 1) as u32
            }
        };
        let [x, y] = self.layout.place(Wrap::Clamp.index(k, slices));
        let width = self.layout.atlas_size()[0] as usize;
        self.texels[(y + along(j, rows)) as usize * width + (x + along(i, columns)) as usize]
    }
}

/// Computes for each dual cell of a volume the distance to the nearest cell in which the field may
/// reach a value: a cell with a corner of that value or more. The value is [`Volume::SURFACE`] for what
/// is solid, or next to 0 for what is translucent. The distance is the greatest of the differences
/// along the three axes, in cells (Chebyshev distance). So in all cells less than the distance away,
/// along every axis, the field stays below the value: a walk may leave the box of these cells in one
/// step. Distance 0 marks a cell in which the field may reach it. 255 stands for 255 or more, and for
/// a volume that nowhere reaches it.
///
/// Distances wrap along `u` and `v` as the volume does. Along the height there is nothing beyond the
/// lowest and the highest half voxel. The result has the same bytes with any number of threads. It
/// takes two bytes a voxel.
///
/// ```
/// use relief_bake::volumes::volume_distance;
/// use relief_core::{Volume, Watch, Wrap};
///
/// let floor = Volume::from_fn([8, 8, 8], Wrap::Repeat, |[_, _, h]| if h < 0.2 { 1.0 } else { 0.0 })?;
/// let distance = volume_distance(&floor, 0.5, &Watch::none())?;
/// // Slices 0 and 1 are solid, so that cell 1 is the last to reach the surface.
/// assert_eq!([0, 1, 2, 5].map(|k| distance.cell(3, 3, k)), [0, 0, 1, 4]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// When it is cancelled.
pub fn volume_distance(volume: &Volume, value: f32, watch: &Watch) -> Result<VolumeDistance, Cancelled> {
    let (wrap, layout) = (volume.wrap(), volume.layout());
    let [columns, rows, slices] = volume.size().map(|side| side as usize);
    let mut distances = vec![VolumeDistance::MOST; columns * rows * slices];
    distances.par_chunks_mut(columns).enumerate().try_for_each(|(at, cells)| {
        let (j, k) = ((at % rows) as i64, (at / rows) as i64);
        for (i, cell) in (0i64..).zip(cells) {
            let reaches = (0..8).any(|corner| {
                volume.voxel(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)) >= value
            });
            *cell = if reaches { 0 } else { VolumeDistance::MOST };
        }
        watch.check()
    })?;
    watch.at(0.4)?;
    // The greatest of three differences is found along one axis after the other.
    let sideways = wrap == Wrap::Repeat;
    distances.par_chunks_mut(columns).for_each(|line| widen(line, sideways));
    watch.at(0.6)?;
    distances.par_chunks_mut(columns * rows).for_each(|slice| {
        let mut line = vec![0; rows];
        (0..columns).for_each(|column| widen_along(slice, column, columns, &mut line, sideways));
    });
    watch.at(0.8)?;
    let mut line = vec![0; slices];
    for column in 0..columns * rows {
        widen_along(&mut distances, column, columns * rows, &mut line, false);
    }
    let [width, height] = layout.atlas_size().map(|side| side as usize);
    let mut texels = vec![0; width * height];
    for (at, cells) in distances.chunks_exact(columns).enumerate() {
        let [x, y] = layout.place((at / rows) as u32).map(|part| part as usize);
        texels[(y + at % rows) * width + x..][..columns].copy_from_slice(cells);
    }
    watch.at(1.0)?;
    Ok(VolumeDistance { layout, wrap, texels })
}

/// Widens along the cells that are `step` apart, from `first` on. `line` has room for them.
fn widen_along(cells: &mut [u8], first: usize, step: usize, line: &mut [u8], joined: bool) {
    for (place, cell) in line.iter_mut().zip(cells[first..].iter().step_by(step)) {
        *place = *cell;
    }
    widen(line, joined);
    for (place, cell) in line.iter().zip(cells[first..].iter_mut().step_by(step)) {
        *cell = *place;
    }
}

/// Replaces each value by the least, over all places of the line, of the greater of the value there
/// and the distance to it. If the ends are `joined`, the first place follows the last. Mirrored and
/// clamped cells beyond an end are no nearer than their images inside.
fn widen(line: &mut [u8], joined: bool) {
    let before = line.to_vec();
    let count = line.len();
    for (at, value) in line.iter_mut().enumerate() {
        let mut away = 1;
        while away < usize::from(*value) && away < count {
            let (left, right) = (at.checked_sub(away), (at + away < count).then_some(at + away));
            let (left, right) = if joined {
                (Some((at + count - away) % count), Some((at + away) % count))
            } else {
                (left, right)
            };
            for place in [left, right].into_iter().flatten() {
                *value = (*value).min(before[place].max(away as u8));
            }
            away += 1;
        }
    }
}
