//! Orientation of stored pictures. All orientations of EXIF, TIFF and Radiance files are converted
//! to positions of texels here.

use crate::layout::Span;

/// Orientation of a stored picture: columns and rows may be flipped, and then transposed. These are
/// the eight orientations of EXIF and TIFF (tag 274).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Orientation {
    /// Whether stored columns run from right to left, and stored rows from bottom to top.
    pub turned_over: [bool; 2],
    /// Whether stored rows are columns of the displayed picture.
    pub transposed: bool,
}

impl Orientation {
    /// Identity: the picture is displayed as it is stored.
    pub const STORED: Self = Self { turned_over: [false; 2], transposed: false };

    /// Returns the orientation with a number of EXIF or TIFF, from 1 to 8.
    pub const fn of_number(number: u32) -> Option<Self> {
        let (turned_over, transposed) = match number {
            1 => ([false, false], false),
            2 => ([true, false], false),
            3 => ([true, true], false),
            4 => ([false, true], false),
            5 => ([false, false], true),
            6 => ([false, true], true),
            7 => ([true, true], true),
            8 => ([true, false], true),
            _ => return None,
        };
        Some(Self { turned_over, transposed })
    }

    /// Swaps a pair of values along stored rows and columns into values along `u` and `v` of the
    /// displayed picture.
    pub fn shown<T>(self, [u, v]: [T; 2]) -> [T; 2] {
        if self.transposed { [v, u] } else { [u, v] }
    }

    /// Locates the samples of a span, in a picture of the given stored size.
    pub fn line<'a>(self, [width, height]: [u32; 2], span: &Span<'a>) -> Line<'a> {
        let [columns_turned, rows_turned] = self.turned_over;
        let turn = |at: u32, side: u32, is_turned: bool| if is_turned { side - 1 - at } else { at } as usize;
        let column = turn(span.column, width, columns_turned);
        let row = turn(span.row, height, rows_turned);
        let (first, step) = if self.transposed {
            (column * height as usize + row, height as isize)
        } else {
            (row * width as usize + column, 1)
        };
        let forth = if columns_turned { -step } else { step };
        Line { first, step: forth * span.step as isize, samples: span.samples }
    }
}

/// Samples of texels at equal distances in the displayed picture.
#[derive(Clone, Copy)]
pub(crate) struct Line<'a> {
    /// Index of the first texel, row by row from the top.
    first: usize,
    /// Step from a texel's index to the next one's.
    step: isize,
    /// Raw values, the chosen channels interleaved.
    pub samples: &'a [f64],
}

impl Line<'_> {
    /// Iterates over the indices of `count` texels.
    pub fn places(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        let Self { first, step, .. } = *self;
        (0..count as isize).map(move |at| (first as isize + at * step) as usize)
    }

    /// Returns the highest index of `count` texels plus one.
    pub fn end(&self, count: usize) -> usize {
        let last = self.first as isize + (count as isize - 1).max(0) * self.step;
        self.first.max(last as usize) + 1
    }

    /// Returns the same texels with other samples.
    pub fn with<'b>(&self, samples: &'b [f64]) -> Line<'b> {
        Line { first: self.first, step: self.step, samples }
    }
}

/// Receiver of the lines of a picture. Every texel comes exactly once, in the decoder's order.
pub(crate) type LineSink<'a> = dyn FnMut(Line<'_>) -> Result<(), crate::ReadProblem> + 'a;
