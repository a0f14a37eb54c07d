//! Atlas: several images packed into one.

use super::ObjectError;
use crate::HeightMap;

/// Width in texels of the border around each image, so that filtering at an edge does not read a
/// neighbour.
const BORDER: u32 = 1;

/// Layout of images in an atlas: in rows, with a border of one texel around each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AtlasLayout {
    size: [u32; 2],
    places: Vec<[u32; 2]>,
    sizes: Vec<[u32; 2]>,
}

impl AtlasLayout {
    /// Packs images with these columns and rows in their order, about as wide as high.
    ///
    /// # Errors
    ///
    /// When they have more texels together than a height map may have.
    pub fn new(sizes: Vec<[u32; 2]>) -> Result<Self, ObjectError> {
        let padded = |side: u32| u64::from(side) + 2 * u64::from(BORDER);
        let texels: u64 = sizes.iter().map(|size| padded(size[0]).saturating_mul(padded(size[1]))).sum();
        let widest = sizes.iter().map(|size| padded(size[0])).max().unwrap_or(1);
        // A row holds whole images. It is about as wide as a square with the same number of texels.
        let width = widest.max((texels as f64).sqrt().ceil() as u64);
        let (mut places, mut used) = (Vec::with_capacity(sizes.len()), 0);
        let (mut x, mut y, mut tallest) = (0, 0, 0);
        for size in &sizes {
            let [columns, rows] = size.map(padded);
            if x + columns > width {
                (x, y, tallest) = (0, y + tallest, 0);
            }
            places.push([x, y].map(|at| at + u64::from(BORDER)));
            x += columns;
            tallest = tallest.max(rows);
            used = used.max(x);
        }
        let size = [used.max(1), (y + tallest).max(1)].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        HeightMap::check_size(size[0], size[1])?;
        let places = places.into_iter().map(|place| place.map(|at| at as u32)).collect();
        Ok(Self { size, places, sizes })
    }

    /// Columns and rows of the atlas.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Column and row of the first texel of each image.
    pub fn places(&self) -> &[[u32; 2]] {
        &self.places
    }

    /// Packs the images' texels into the atlas, row by row. Texels outside all images become
    /// `outside`. `images` must have the number and sizes of the layout.
    pub fn pack<'a, T: Copy + 'a>(&self, images: impl IntoIterator<Item = &'a [T]>, outside: T) -> Vec<T> {
        let [width, height] = self.size.map(|side| side as usize);
        let mut texels = vec![outside; width * height];
        for ((image, place), size) in images.into_iter().zip(&self.places).zip(&self.sizes) {
            let [columns, x, y] = [size[0], place[0], place[1]].map(|at| at as usize);
            for (row, line) in image.chunks_exact(columns).enumerate() {
                let first = (y + row) * width + x;
                texels[first..first + columns].copy_from_slice(line);
            }
        }
        texels
    }

    /// Packs images whose texels are computed from image, column and row. The edge texels are
    /// repeated in the border around each image, so that filtering at an edge reads only the image
    /// itself.
    pub fn pack_with_edges<T: Copy>(&self, texel: impl Fn(usize, [u32; 2]) -> T, outside: T) -> Vec<T> {
        let [width, height] = self.size.map(|side| side as usize);
        let mut texels = vec![outside; width * height];
        for (image, (place, size)) in self.places.iter().zip(&self.sizes).enumerate() {
            let [x, y] = place.map(|at| (at - BORDER) as usize);
            let [columns, rows] = size.map(|side| side + 2 * BORDER);
            for row in 0..rows {
                let first = (y + row as usize) * width + x;
                for column in 0..columns {
                    let inside = |at: u32, side: u32| at.saturating_sub(BORDER).min(side - 1);
                    texels[first + column as usize] =
                        texel(image, [inside(column, size[0]), inside(row, size[1])]);
                }
            }
        }
        texels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_go_on_around_images() {
        let layout = AtlasLayout::new(vec![[3, 2], [1, 1], [2, 4]]).expect("small");
        let of = |image: usize, [x, y]: [u32; 2]| [image as u32 + 1, x, y];
        let packed = layout.pack_with_edges(of, [0; 3]);
        let inner =
            layout.pack([&[[1, 0, 0], [1, 1, 0], [1, 2, 0], [1, 0, 1], [1, 1, 1], [1, 2, 1]][..]], [0; 3]);
        let [width, _] = layout.size();
        let place = |x: u32, y: u32| (y * width + x) as usize;
        let [x, y] = layout.places()[0];
        assert_eq!(packed[place(x + 1, y)], inner[place(x + 1, y)]);
        assert_eq!(packed[place(x - 1, y - 1)], [1, 0, 0]);
        assert_eq!(packed[place(x + 3, y + 1)], [1, 2, 1]);
        assert_eq!(packed[place(x + 1, y + 2)], [1, 1, 1]);
        assert_eq!(packed.iter().filter(|texel| texel[0] == 2).count(), 9);
    }

    #[test]
    fn images_lie_apart_and_whole() {
        let sizes = vec![[3, 2], [1, 1], [2, 4], [3, 3]];
        let layout = AtlasLayout::new(sizes.clone()).expect("small");
        let images: Vec<Vec<u32>> = sizes
            .iter()
            .enumerate()
            .map(|(number, size)| vec![number as u32 + 1; (size[0] * size[1]) as usize])
            .collect();
        let packed = layout.pack(images.iter().map(Vec::as_slice), 0);
        let [width, height] = layout.size();
        let at = |x: u32, y: u32| packed[(y * width + x) as usize];
        for (number, (place, size)) in layout.places().iter().zip(&sizes).enumerate() {
            for y in place[1] - 1..=place[1] + size[1] {
                for x in place[0] - 1..=place[0] + size[0] {
                    let inside = (place[0]..place[0] + size[0]).contains(&x)
                        && (place[1]..place[1] + size[1]).contains(&y);
                    let expected = if inside { number as u32 + 1 } else { 0 };
                    assert!(x < width && y < height && at(x, y) == expected, "image {number}, ({x}, {y})");
                }
            }
        }
        assert_eq!(packed.iter().filter(|texel| **texel > 0).count(), 6 + 1 + 8 + 9);
        assert!(AtlasLayout::new(vec![[1 << 20, 1 << 20]]).is_err());
    }
}
