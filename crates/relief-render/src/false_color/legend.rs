//! Legends: a bar of colours with numbers, the quantity's name, and the marks of pixels without a
//! number.

use super::canvas::{Canvas, TextSize};
use super::palette::Palette;
use super::quantity::{Form, Quantity, ValueOf};
use super::scale::Scale;
use relief_scene::Shown;

/// Texts of the marks.
const NO_SURFACE_TEXT: &str = "no surface";
const NOT_COMPARABLE_TEXT: &str = "missed, or a false hit";

/// Text of a legend whose quantity has no numbers in the pictures.
const NO_NUMBERS: &str = "no numbers";

/// Colour of pixels that cannot be compared: beyond the end of the palette.
pub const NOT_COMPARABLE_COLOR: [u8; 3] = [255; 3];

/// Palette of numbers.
pub const PALETTE: Palette = Palette::Viridis;

/// Greatest number of characters of the numbers at a bar's sides.
const LABEL: &str = "-0.0001234";

/// Axes of directions.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Legend of a quantity.
pub struct Legend<'a> {
    pub quantity: &'a Quantity,
    pub text: TextSize,
}

impl Legend<'_> {
    /// Distance between parts.
    fn gap(&self) -> u32 {
        self.text.height() / 2
    }

    /// Width of a mark's square with the gap behind it.
    fn mark(&self) -> u32 {
        self.text.height() + self.gap()
    }

    /// Marks that the quantity may need.
    fn marks(&self) -> &'static [&'static str] {
        match self.quantity.value {
            _ if self.quantity.shown == Shown::Error => &[NO_SURFACE_TEXT, NOT_COMPARABLE_TEXT],
            // Every pixel has a colour.
            ValueOf::OfColors => &[],
            ValueOf::Number(_) | ValueOf::Direction(_) | ValueOf::OfHit => &[NO_SURFACE_TEXT],
        }
    }

    /// Returns the least width at which nothing is cut off.
    pub fn least_width(&self) -> u32 {
        let marks = self.marks().iter().map(|text| self.mark() + self.text.width(text) + 2 * self.gap());
        let bar = match self.quantity.form {
            Form::Directions => 3 * (self.text.width("-1 x 1") + 3 * self.gap()),
            _ => 2 * self.text.width(LABEL) + 2 * self.gap(),
        };
        // The squares' outlines are a pixel wide.
        [self.text.width(self.quantity.title), marks.sum(), bar].into_iter().fold(0, u32::max) + 2
    }

    /// Returns the height: name, bar, numbers and marks.
    pub fn height(&self) -> u32 {
        4 * self.text.height() + 3 * self.gap()
    }

    /// Draws the legend with a bar of the given width.
    pub fn draw(&self, canvas: &mut Canvas, [left, top]: [u32; 2], width: u32, scale: &Scale) {
        let (line, gap) = (self.text.height(), self.gap());
        canvas.text([left, top], self.quantity.title, self.text);
        let bar = [left + 1, top + line + gap];
        match self.quantity.form {
            Form::Directions => self.axes(canvas, bar, width - 2),
            _ => self.bar(canvas, bar, width - 2, scale),
        }
        let mut left = left + 1;
        let top = top + 3 * line + 3 * gap;
        for text in self.marks() {
            for (y, x) in (0..line).flat_map(|y| (0..line).map(move |x| (y, x))) {
                let at = [left + x, top + y];
                match *text {
                    NO_SURFACE_TEXT => canvas.hatch(at),
                    _ => canvas.set(at, NOT_COMPARABLE_COLOR),
                }
            }
            canvas.frame([left, top], [line; 2]);
            left += self.mark();
            canvas.text([left, top], text, self.text);
            left += self.text.width(text) + 2 * gap;
        }
    }

    fn bar(&self, canvas: &mut Canvas, [left, top]: [u32; 2], width: u32, scale: &Scale) {
        let line = self.text.height();
        let ticks = scale.ticks();
        if ticks.is_empty() {
            canvas.text([left, top], NO_NUMBERS, self.text);
            return;
        }
        let last = (width - 1).max(1);
        for x in 0..width {
            let place = if scale.is_constant() { 0.5 } else { x as f32 / last as f32 };
            let color = PALETTE.at(place);
            (0..line).for_each(|y| canvas.set([left + x, top + y], color));
        }
        canvas.frame([left, top], [width, line]);
        // A number without room is left out. The ends come first.
        let mut taken: Vec<[u32; 2]> = Vec::new();
        for tick in ticks {
            let x = left + (tick.place * last as f32).round() as u32;
            let text = self.text.width(&tick.label);
            let from = x.saturating_sub(text / 2).clamp(left, left + width.saturating_sub(text));
            let room = [from, from + text];
            let gap = self.gap();
            if taken.iter().all(|other| room[1] + gap <= other[0] || other[1] + gap <= room[0]) {
                canvas.line([x, top + line], line / 4);
                canvas.text([from, top + line + line / 4 + 1], &tick.label, self.text);
                taken.push(room);
            }
        }
    }

    /// Draws a bar for each axis of directions, each with the other two at 0.
    fn axes(&self, canvas: &mut Canvas, [left, top]: [u32; 2], width: u32) {
        let (line, gap) = (self.text.height(), self.gap());
        let each = (width - 2 * gap) / 3;
        for (axis, name) in AXES.into_iter().enumerate() {
            let left = left + axis as u32 * (each + gap);
            for x in 0..each {
                let mut color = [128u8; 3];
                color[axis] = (255.0 * x as f32 / (each - 1).max(1) as f32 + 0.5) as u8;
                (0..line).for_each(|y| canvas.set([left + x, top + y], color));
            }
            canvas.frame([left, top], [each, line]);
            let below = top + line + line / 4 + 1;
            let middle = left + (each - self.text.width(name)) / 2;
            canvas.text([left, below], "-1", self.text);
            canvas.text([middle, below], name, self.text);
            canvas.text([left + each - self.text.width("1"), below], "1", self.text);
        }
    }
}
