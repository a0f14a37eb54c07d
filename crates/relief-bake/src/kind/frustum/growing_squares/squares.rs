//! Greatest heights of squares of texels, in the directions of a quadrant.

use rayon::prelude::*;
use relief_core::{HeightMap, Wrap};

use super::SPANS;

/// Greatest heights of the squares of a side that begin at the texels ahead of all cells.
///
/// Places are counted in the direction of the quadrant: a cell's near texel has the same place as
/// the cell. There is one more place than cells. Squares continue beyond the map with its wrap.
pub struct Squares<'a> {
    map: &'a HeightMap,
    forward: [bool; 2],
    pub side: usize,
    pub highest: Vec<f32>,
    /// Columns in the map of the places beyond its width.
    beyond: Vec<usize>,
}

impl<'a> Squares<'a> {
    /// Creates the squares of one texel, in a plane that is used again.
    pub fn of_texels(map: &'a HeightMap, forward: [bool; 2], mut highest: Vec<f32>) -> Self {
        let [width, height] = [map.width(), map.height()].map(|side| side as usize + 1);
        let last = i64::from(map.width());
        let column =
            |place: i64| map.wrap().index(if forward[0] { place } else { last - place }, map.width());
        let beyond = (last..last + 2 * SPANS as i64).map(|place| column(place) as usize).collect();
        let mut squares = Self { map, forward, side: 1, highest: Vec::new(), beyond };
        highest.resize(width * height, 0.0);
        highest.par_chunks_mut(width).enumerate().with_min_len(8).for_each(|(row, line)| {
            for (column, texel) in line.iter_mut().enumerate() {
                *texel = squares.texel([column, row]);
            }
        });
        squares.highest = highest;
        squares
    }

    /// Returns the texel at a place.
    #[inline(always)]
    pub fn texel(&self, places: [usize; 2]) -> f32 {
        let size = [self.map.width() as usize, self.map.height() as usize];
        let [column, row] = [0, 1].map(|axis| {
            if self.forward[axis] {
                places[axis] as isize
            } else {
                size[axis] as isize - places[axis] as isize
            }
        });
        if (column as usize) < size[0] && (row as usize) < size[1] {
            self.map.texels()[row as usize * size[0] + column as usize]
        } else {
            self.map.texel(column as i64, row as i64)
        }
    }

    /// Reads a row of texels from a place on, which is not the first.
    #[inline(always)]
    pub fn texels_of_row(&self, row: usize, from: usize, texels: &mut [f32]) {
        let (width, height) = (self.map.width() as usize, i64::from(self.map.height()));
        let in_map = if self.forward[1] { row as i64 } else { height - row as i64 };
        let start = self.map.wrap().index(in_map, self.map.height()) as usize * width;
        let line = &self.map.texels()[start..start + width];
        let in_map = if self.forward[0] { width } else { width + 1 }.saturating_sub(from);
        let (inner, beyond) = texels.split_at_mut(in_map.min(texels.len()));
        if self.forward[0] {
            inner.copy_from_slice(&line[width - in_map..][..inner.len()]);
        } else {
            inner.iter_mut().zip(line[..in_map].iter().rev()).for_each(|(to, texel)| *to = *texel);
        }
        let columns = self.beyond.iter().skip((from + in_map).saturating_sub(width));
        for (texel, column) in beyond.iter_mut().zip(columns) {
            *texel = line[*column];
        }
    }

    /// Returns the index of the squares that begin at a place along an axis.
    #[inline(always)]
    fn held(&self, axis: usize, place: usize) -> usize {
        let last = if axis == 0 { self.map.width() } else { self.map.height() } as usize;
        if place <= last {
            return place;
        }
        match self.map.wrap() {
            Wrap::Clamp => last,
            Wrap::Repeat => place % last,
            Wrap::Mirror => {
                let mirrored = if self.forward[axis] { 2 * last - 1 } else { 2 * last + 1 };
                (mirrored + 1).saturating_sub(place + self.side)
            }
        }
    }

    /// Returns the greatest height of the square that begins at a place and ends `ahead` texels
    /// ahead. `ahead` is at least the side and less than twice the side.
    #[inline(always)]
    pub fn highest_up_to(&self, [column, row]: [usize; 2], ahead: usize) -> f32 {
        let width = self.map.width() as usize + 1;
        let by = ahead + 1 - self.side;
        let right = self.held(0, column + by);
        let below = self.held(1, row + by) * width;
        let row = row * width;
        let highest = &self.highest;
        greater(
            greater(highest[row + column], highest[row + right]),
            greater(highest[below + column], highest[below + right]),
        )
    }

    /// Computes the greatest heights of squares larger by `by`, from a column of a row on.
    #[inline(always)]
    pub fn highest_of_row(&self, row: usize, by: usize, column: usize, larger: &mut [f32]) {
        let width = self.map.width() as usize + 1;
        let line = |row: usize| &self.highest[row * width..(row + 1) * width];
        let (own, below) = (line(row), line(self.held(1, row + by)));
        let inner = width.saturating_sub(by + column).min(larger.len());
        let (inside, beyond) = larger.split_at_mut(inner);
        let at = |column: usize| (&own[column..], &below[column..]);
        highest_of(at(column), at((column + by).min(width)), inside);
        let (column, last) = (column + inner, width - 1);
        match self.map.wrap() {
            Wrap::Repeat if column + by > last && by <= last => {
                highest_of(at(column), at(column + by - last), beyond);
            }
            _ => {
                for (column, highest) in (column..).zip(beyond) {
                    let right = self.held(0, column + by);
                    *highest =
                        greater(greater(own[column], below[column]), greater(own[right], below[right]));
                }
            }
        }
    }
}

/// Writes the highest of each four heights.
#[inline(always)]
fn highest_of(left: (&[f32], &[f32]), right: (&[f32], &[f32]), highest: &mut [f32]) {
    let four = left.0.iter().zip(left.1).zip(right.0).zip(right.1);
    for (highest, (((own, below), own_right), below_right)) in highest.iter_mut().zip(four) {
        *highest = greater(greater(*own, *below), greater(*own_right, *below_right));
    }
}

/// Returns the greater number, in the form that compiles to one instruction.
#[inline(always)]
pub fn greater(x: f32, y: f32) -> f32 {
    if x > y { x } else { y }
}
