//! Slices of a volume side by side in one map.

/// Where the slices of a volume lie in its atlas: in rows from the top left, slice 0 first. What remains of
/// the last row is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SliceLayout {
    size: [u32; 3],
    columns: u32,
}

impl SliceLayout {
    /// A layout that is as square as whole slices allow.
    pub(super) fn new(size: [u32; 3]) -> Self {
        let [width, height, slices] = size.map(u64::from);
        let is_wide = |columns: &u64| columns * width >= slices.div_ceil(*columns) * height;
        let columns = (1..=slices).find(is_wide).unwrap_or(slices);
        Self { size, columns: columns as u32 }
    }

    /// Columns, rows and slices of the volume.
    pub fn size(&self) -> [u32; 3] {
        self.size
    }

    /// Slices in a row of the atlas.
    pub fn slices_in_a_row(&self) -> u32 {
        self.columns
    }

    /// Columns and rows of the atlas, in texels.
    pub fn atlas_size(&self) -> [u32; 2] {
        let [width, height, slices] = self.size;
        // A side that would not fit is refused by the height map.
        [width.saturating_mul(self.columns), height.saturating_mul(slices.div_ceil(self.columns))]
    }

    /// Column and row of the atlas at which a slice begins.
    #[inline]
    pub fn place(&self, slice: u32) -> [u32; 2] {
        [slice % self.columns * self.size[0], slice / self.columns * self.size[1]]
    }

    /// Number of voxels.
    pub fn voxels(&self) -> u64 {
        self.size.iter().map(|&side| u64::from(side)).product()
    }

    /// Column, row and slice of the value of that number.
    pub(super) fn voxel(&self, number: usize) -> [u32; 3] {
        let [width, height, _] = self.size.map(|side| side as usize);
        [number % width, number / width % height, number / (width * height)].map(|at| at as u32)
    }

    /// Values slice by slice as texels of the atlas.
    pub(super) fn pack(&self, values: &[f32]) -> Vec<f32> {
        let [width, height] = self.atlas_size().map(|side| side as usize);
        let mut texels = vec![0.0; width * height];
        for (at, row) in self.rows() {
            let columns = self.size[0] as usize;
            texels[at..at + columns].copy_from_slice(&values[row * columns..][..columns]);
        }
        texels
    }

    /// Texels of the atlas as values slice by slice.
    pub(super) fn unpack(&self, texels: &[f32]) -> Vec<f32> {
        let mut values = Vec::with_capacity(self.voxels() as usize);
        for (at, _) in self.rows() {
            values.extend_from_slice(&texels[at..at + self.size[0] as usize]);
        }
        values
    }

    /// For each row of each slice, the first texel in the atlas and the row's number.
    fn rows(&self) -> impl Iterator<Item = (usize, usize)> {
        let layout = *self;
        let width = layout.atlas_size()[0] as usize;
        (0..layout.size[2]).flat_map(move |slice| {
            let [x, y] = layout.place(slice).map(|at| at as usize);
            let rows = layout.size[1] as usize;
            (0..rows).map(move |row| ((y + row) * width + x, slice as usize * rows + row))
        })
    }
}
