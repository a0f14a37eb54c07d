//! Sheets: pictures side by side, with their names and legends.

use relief_scene::MAX_IMAGE_SIDE;

use super::canvas::{Canvas, TextSize};
use super::gather::Content;
use super::legend::Legend;
use super::quantity::{Form, Quantity};
use super::scale::Scale;

/// Longer side of a picture from which text is large.
const LARGE: u32 = 800;

/// Pictures of one quantity, which share a scale and a legend.
#[derive(Clone, Debug)]
pub struct Group {
    /// The quantity; none for pictures in their own colours, which have no legend.
    pub quantity: Option<&'static Quantity>,
    /// Name of each picture.
    pub names: Vec<String>,
}

impl Group {
    /// Creates a group of named pictures.
    pub fn of(quantity: Option<&'static Quantity>, names: &[&str]) -> Self {
        Self { quantity, names: names.iter().map(|name| (*name).to_owned()).collect() }
    }

    /// Returns the scale that its pictures share. Directions have a fixed one.
    pub fn scale(&self, contents: &[Content]) -> Scale {
        let numbers = contents.iter().flat_map(|content| match content {
            Content::Numbers(numbers) => numbers.as_slice(),
            Content::Picture(_) | Content::Directions(_) => &[],
        });
        Scale::of(self.quantity.map_or(Form::Linear, |quantity| quantity.form), numbers)
    }
}

/// Reason that a sheet cannot be made.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SheetError {
    /// There is nothing to draw.
    #[error("a sheet without pictures: name at least one")]
    Empty,
    /// The sheet is larger than a picture may be.
    #[error(
        "{pictures} pictures of {}x{} pixels make a sheet of {}x{}, and {most} a side is the most: \
         show fewer, or smaller ones", size[0], size[1], sheet[0], sheet[1]
    )]
    TooLarge {
        /// Number of pictures.
        pictures: usize,
        /// Columns and rows of a picture.
        size: [u32; 2],
        /// Columns and rows of the sheet.
        sheet: [u64; 2],
        /// Greatest number of columns and rows.
        most: u32,
    },
    /// The contents do not match the groups.
    #[error("the pictures of a sheet do not have its sizes: this is a mistake of the program")]
    Contents,
}

/// Layout of a sheet. Its size follows from the pictures' size, the quantities and the names, and
/// not from the values.
#[derive(Clone, Debug)]
pub struct Sheet {
    picture: [u32; 2],
    groups: Vec<Group>,
    text: TextSize,
    size: [u32; 2],
}

/// Size of a group, its columns, and the width of a column.
struct GroupLayout {
    size: [u64; 2],
    columns: u64,
    column: u64,
}

impl Sheet {
    /// Lays out groups of pictures of `size` pixels. A group has its pictures beside each other, up
    /// to three in a row, or in a grid. Groups of one picture form a grid, too; other groups lie
    /// below each other.
    ///
    /// # Errors
    ///
    /// When there are no pictures, or the sheet is larger than a picture may be.
    pub fn new(picture: [u32; 2], groups: Vec<Group>) -> Result<Self, SheetError> {
        let pictures: usize = groups.iter().map(|group| group.names.len()).sum();
        if groups.iter().any(|group| group.names.is_empty()) || groups.is_empty() {
            return Err(SheetError::Empty);
        }
        let text = if picture[0].max(picture[1]) >= LARGE { TextSize::Large } else { TextSize::Small };
        let mut sheet = Self { picture, groups, text, size: [0; 2] };
        let (cell, columns) = (sheet.cell(), sheet.group_columns());
        let rows = (sheet.groups.len() as u64).div_ceil(columns);
        let gap = sheet.gap();
        let whole = [columns * (cell[0] + gap) + gap, rows * (cell[1] + 2 * gap)];
        let most = MAX_IMAGE_SIDE;
        if whole.iter().any(|side| *side > u64::from(most)) {
            return Err(SheetError::TooLarge { pictures, size: picture, sheet: whole, most });
        }
        sheet.size = whole.map(|side| side as u32);
        Ok(sheet)
    }

    /// Returns the sheet's columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the groups.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// Returns the bytes of the sheet and the contents of all its pictures.
    pub fn bytes(&self) -> u64 {
        let area = |size: [u32; 2]| size.map(u64::from).iter().product::<u64>();
        let pictures: usize = self.groups.iter().map(|group| group.names.len()).sum();
        3 * area(self.size) + pictures as u64 * Content::BYTES_PER_PIXEL * area(self.picture)
    }

    /// Draws the sheet from the contents of each group's pictures.
    ///
    /// # Errors
    ///
    /// When their numbers or sizes are not the layout's.
    pub fn draw(&self, contents: Vec<Vec<Content>>) -> Result<Canvas, SheetError> {
        let pixels = self.picture.map(|side| side as usize).iter().product::<usize>();
        let is_of = |(group, contents): (&Group, &Vec<Content>)| {
            group.names.len() == contents.len() && contents.iter().all(|content| content.len() == pixels)
        };
        if contents.len() != self.groups.len() || !self.groups.iter().zip(&contents).all(is_of) {
            return Err(SheetError::Contents);
        }
        let mut canvas = Canvas::new(self.size);
        let (cell, gap, columns) = (self.cell(), self.gap(), self.group_columns());
        for (place, (group, contents)) in (0u64..).zip(self.groups.iter().zip(contents)) {
            let left = gap + place % columns * (cell[0] + gap);
            let top = gap + place / columns * (cell[1] + 2 * gap);
            self.draw_group(&mut canvas, [left as u32, top as u32], group, &contents);
        }
        Ok(canvas)
    }

    fn draw_group(&self, canvas: &mut Canvas, [left, top]: [u32; 2], group: &Group, contents: &[Content]) {
        let layout = self.layout(group);
        let (gap, line) = (self.gap() as u32, self.text.height());
        let scale = group.scale(contents);
        let row = self.picture_height() as u32;
        for (place, (name, content)) in (0u32..).zip(group.names.iter().zip(contents)) {
            let left = left + place % layout.columns as u32 * (layout.column as u32 + gap);
            let top = top + place / layout.columns as u32 * (row + gap);
            canvas.text([left, top], name, self.text);
            let top = top + line + line / 4;
            canvas.frame([left, top], self.picture);
            self.fill(canvas, [left, top], content, &scale);
        }
        if let Some(legend) = self.legend(group) {
            let top = top + layout.size[1] as u32 - legend.height();
            let width = layout.column.max(u64::from(legend.least_width())) as u32;
            legend.draw(canvas, [left, top], width, &scale);
        }
    }

    fn fill(&self, canvas: &mut Canvas, [left, top]: [u32; 2], content: &Content, scale: &Scale) {
        let width = self.picture[0].max(1);
        for pixel in 0..content.len() {
            let at = [left + pixel as u32 % width, top + pixel as u32 / width];
            match content.color(pixel, scale) {
                Some(color) => canvas.set(at, color),
                None => canvas.hatch(at),
            }
        }
    }

    fn legend<'a>(&self, group: &'a Group) -> Option<Legend<'a>> {
        group.quantity.map(|quantity| Legend { quantity, text: self.text })
    }

    /// Distance between pictures.
    fn gap(&self) -> u64 {
        u64::from(self.text.height())
    }

    /// Height of a picture with its name above it.
    fn picture_height(&self) -> u64 {
        let line = u64::from(self.text.height());
        line + line / 4 + u64::from(self.picture[1])
    }

    fn layout(&self, group: &Group) -> GroupLayout {
        let count = group.names.len() as u64;
        let columns = in_row(count);
        let rows = count.div_ceil(columns);
        let names = group.names.iter().map(|name| u64::from(self.text.width(name)));
        let column = names.fold(u64::from(self.picture[0]), u64::max);
        let gap = self.gap();
        let legend = self.legend(group);
        let least = legend.as_ref().map_or(0, |legend| u64::from(legend.least_width()));
        let below = legend.map_or(0, |legend| gap / 2 + u64::from(legend.height()));
        let width = (columns * column + (columns - 1) * gap).max(least);
        GroupLayout {
            size: [width, rows * self.picture_height() + (rows - 1) * gap + below],
            columns,
            column,
        }
    }

    /// Number of groups beside each other.
    fn group_columns(&self) -> u64 {
        let are_single = self.groups.iter().all(|group| group.names.len() == 1);
        if are_single { in_row(self.groups.len() as u64) } else { 1 }
    }

    /// Size of the largest group.
    fn cell(&self) -> [u64; 2] {
        let sizes = self.groups.iter().map(|group| self.layout(group).size);
        sizes.fold([0; 2], |most, size| [0, 1].map(|axis| most[axis].max(size[axis])))
    }
}

/// Number of pictures beside each other: up to three in a row, else a grid about as wide as high.
fn in_row(count: u64) -> u64 {
    if count <= 3 { count.max(1) } else { (count as f64).sqrt().ceil() as u64 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::false_color::{NO_SURFACE, NOT_COMPARABLE, PALETTE, QUANTITIES, quantity};

    /// Colour of a canvas' pixel.
    fn at(canvas: &Canvas, [x, y]: [u32; 2]) -> [u8; 3] {
        canvas.pixels()[(y * canvas.size()[0] + x) as usize]
    }

    /// Draws one picture of numbers; returns the canvas, and its first pixel's place on it.
    fn drawn(name: &str, size: [u32; 2], numbers: &[f32]) -> (Canvas, [u32; 2]) {
        let quantity = quantity(name).expect("a quantity");
        let sheet = Sheet::new(size, vec![Group::of(Some(quantity), &[name])]).expect("it fits");
        let canvas = sheet.draw(vec![vec![Content::Numbers(numbers.to_vec())]]).expect("its size");
        assert_eq!(canvas.size(), sheet.size());
        (canvas, [16, 16 + 16 + 4])
    }

    #[test]
    fn equal_numbers_have_one_color() {
        let (canvas, [left, top]) = drawn("height", [40, 30], &[0.05; 1200]);
        let colors: Vec<_> =
            (0..1200).map(|pixel| at(&canvas, [left + pixel % 40, top + pixel / 40])).collect();
        assert!(colors.iter().all(|color| *color == colors[0]));
        assert_eq!(colors[0], PALETTE.at(0.5));
    }

    /// Reads a pixel's number back from the picture, by the legend's bar: the place of its colour
    /// between the two ends.
    fn read_back(canvas: &Canvas, [left, top]: [u32; 2], height: u32, color: [u8; 3], ends: [f32; 2]) -> f32 {
        // Below the picture: half a gap, the title, half a gap, and the bar.
        let middle = top + height + 8 + 16 + 8 + 8;
        let last = (left + 1..).take_while(|x| at(canvas, [*x, middle]) != [26; 3]).last().expect("a bar");
        let difference = |x: &u32| {
            let parts = at(canvas, [*x, middle]).into_iter().zip(color);
            parts.map(|(a, b)| u32::from(a.abs_diff(b))).sum::<u32>()
        };
        let nearest = (left + 1..=last).min_by_key(difference).expect("a bar");
        ends[0] + (ends[1] - ends[0]) * (nearest - left - 1) as f32 / (last - left - 1) as f32
    }

    /// Greatest difference between numbers and those that the picture's legend gives.
    fn worst(numbers: &[f32], shown: &[f32]) -> f32 {
        let size = [50, 20];
        let (canvas, [left, top]) = drawn("depth", size, shown);
        let ends = Scale::of(Form::Linear, shown).ends().expect("numbers");
        let of = |(pixel, number): (usize, &f32)| {
            let color = at(&canvas, [left + pixel as u32 % 50, top + pixel as u32 / 50]);
            (read_back(&canvas, [left, top], 20, color, ends) - number).abs()
        };
        numbers.iter().enumerate().map(of).fold(0.0, f32::max)
    }

    #[test]
    fn the_legend_gives_the_numbers_back() {
        let numbers: Vec<f32> = (0..1000).map(|pixel| (pixel * 7919 % 1000) as f32 / 100.0 + 2.0).collect();
        assert!(worst(&numbers, &numbers) < 0.1, "{}", worst(&numbers, &numbers));
        // The comparison notices one wrong pixel, and pictures that are turned over.
        let mut wrong = numbers.clone();
        wrong[500] = 12.0 - wrong[500] / 2.0;
        assert!(worst(&numbers, &wrong) > 1.0);
        let turned: Vec<f32> = numbers.iter().map(|number| 14.0 - number).collect();
        assert!(worst(&numbers, &turned) > 5.0);
    }

    #[test]
    fn pixels_without_numbers_have_marks_of_their_own() {
        let numbers = [0.0, 5.0, NO_SURFACE, NO_SURFACE, NOT_COMPARABLE, 0.001];
        let (canvas, [left, top]) = drawn("error", [6, 1], &numbers);
        let colors: Vec<_> = (0..6).map(|x| at(&canvas, [left + x, top])).collect();
        assert_eq!((colors[0], colors[1], colors[4]), (PALETTE.at(0.0), PALETTE.at(1.0), [255; 3]));
        assert_eq!(colors[5], PALETTE.at(0.0));
        assert!(colors[2..4].iter().all(|color| [[244; 3], [214; 3]].contains(color)));
    }

    #[test]
    fn no_text_is_cut_off() {
        let names = ["a", "parallax-iterative", "linear+true-secant"];
        let sizes = [[1, 1], [64, 64], [512, 512], [1200, 2]];
        for (quantity, size) in QUANTITIES.iter().flat_map(|quantity| sizes.map(|size| (quantity, size))) {
            let sheet = Sheet::new(size, vec![Group::of(Some(quantity), &names)]).expect("it fits");
            let pixels = (size[0] * size[1]) as usize;
            let numbers = (0..pixels).map(|pixel| -0.000_123_4 * (pixel + 1) as f32).collect();
            let content = match quantity.form {
                Form::Directions => Content::Directions(vec![None; pixels]),
                _ => Content::Numbers(numbers),
            };
            let canvas = sheet.draw(vec![vec![content; 3]]).expect("its size");
            let [width, height] = canvas.size();
            let margin = if size[0] < LARGE { 14 } else { 30 };
            let is_border =
                |x: u32, y: u32| x < margin || y < margin - 2 || x >= width - margin || y >= height - margin;
            for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
                let color = at(&canvas, [x, y]);
                assert!(!is_border(x, y) || color == [255; 3], "{} {size:?}: {x}, {y}", quantity.name);
            }
        }
    }

    #[test]
    fn sizes_are_known_before_and_limited() {
        let of = |count: usize| vec![Group::of(None, &vec!["it"; count])];
        let size = |groups| Sheet::new([100, 50], groups).map(|sheet| sheet.size());
        // A picture has a line and a quarter of text above it; 16 pixels lie between pictures.
        assert_eq!(size(of(1)), Ok([100 + 32, 70 + 32]));
        assert_eq!(size(of(3)), Ok([3 * 116 + 16, 70 + 32]));
        assert_eq!(size(of(5)), Ok([3 * 116 + 16, 2 * 70 + 16 + 32]));
        assert_eq!(size(vec![]), Err(SheetError::Empty));
        let most = MAX_IMAGE_SIDE;
        assert!(matches!(Sheet::new([most, 1], of(2)), Err(SheetError::TooLarge { pictures: 2, .. })));
        let sheet = Sheet::new([100, 50], of(1)).expect("it fits");
        assert_eq!(sheet.bytes(), 3 * 132 * 102 + 4 * 5000);
        let wrong = sheet.draw(vec![vec![Content::Numbers(vec![0.0; 4999])]]);
        assert_eq!(wrong, Err(SheetError::Contents));
    }
}
