//! Drawings as pixels.

use relief_render::glyphs::{GlyphSize, inked};
use tiny_skia::{FillRule, Mask, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, StrokeDash, Transform};

use super::{Anchor, Color, Figure, Place, Shape, TextSize};

/// Pixels of a unit.
const SCALE: u32 = 2;

/// Dashes and gaps in units.
const DASHES: [f32; 2] = [5.0, 3.0];

const fn glyphs(size: TextSize) -> GlyphSize {
    match size {
        TextSize::Small => GlyphSize::Medium,
        TextSize::Large => GlyphSize::Large,
    }
}

/// The width of a character in units.
pub fn advance(size: TextSize) -> f64 {
    f64::from(glyphs(size).advance()) / f64::from(SCALE)
}

impl Figure {
    /// Returns columns and rows, and the sRGB values of the pixels, row by row from the top, two
    /// pixels a unit. None if the drawing has no pixels, or more than memory can address.
    pub fn pixels(&self) -> Option<([u32; 2], Vec<u8>)> {
        let [width, height] = self.size.map(|side| side.checked_mul(SCALE));
        let mut canvas = Canvas { pixels: Pixmap::new(width?, height?)?, mask: None };
        canvas.pixels.fill(tiny_skia::Color::WHITE);
        let [[left, top], [right, bottom]] = self.frame.map(|place| place.map(|x| x as f32));
        let mut mask = Mask::new(width?, height?)?;
        let frame = PathBuilder::from_rect(Rect::from_ltrb(left, top, right, bottom)?);
        mask.fill_path(&frame, FillRule::Winding, false, scaled());
        canvas.mask = Some(mask);
        self.inside.iter().for_each(|shape| canvas.draw(shape));
        canvas.mask = None;
        self.over.iter().for_each(|shape| canvas.draw(shape));
        // The canvas is opaque everywhere.
        let values = canvas.pixels.pixels().iter().flat_map(|it| [it.red(), it.green(), it.blue()]).collect();
        Some(([width?, height?], values))
    }
}

fn scaled() -> Transform {
    Transform::from_scale(SCALE as f32, SCALE as f32)
}

struct Canvas {
    pixels: Pixmap,
    mask: Option<Mask>,
}

impl Canvas {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Area { corners, color, opacity } => {
                if let Some(path) = path(corners, true) {
                    self.fill(&path, *color, *opacity);
                }
            }
            Shape::Line { places, color, width, dashed } => {
                if let Some(path) = path(places, false) {
                    self.stroke(&path, *color, *width, *dashed);
                }
            }
            Shape::Ellipse { centre: [x, y], radii: [across, up], color, opacity } => {
                let sides = [x - across, y - up, x + across, y + up].map(|side| side as f32);
                let bounds = Rect::from_ltrb(sides[0], sides[1], sides[2], sides[3]);
                if let Some(path) = bounds.and_then(PathBuilder::from_oval) {
                    self.fill(&path, *color, *opacity);
                    self.stroke(&path, *color, 1.0, false);
                }
            }
            Shape::Text { at, text, size, color, anchor } => self.text(*at, text, *size, *color, *anchor),
        }
    }

    fn fill(&mut self, path: &Path, color: Color, opacity: f64) {
        let paint = paint(color, opacity);
        self.pixels.fill_path(path, &paint, FillRule::Winding, scaled(), self.mask.as_ref());
    }

    fn stroke(&mut self, path: &Path, color: Color, width: f64, dashed: bool) {
        let dash = if dashed { StrokeDash::new(DASHES.into(), 0.0) } else { None };
        let stroke =
            Stroke { width: width as f32, dash, line_join: tiny_skia::LineJoin::Round, ..Stroke::default() };
        self.pixels.stroke_path(path, &paint(color, 1.0), &stroke, scaled(), self.mask.as_ref());
    }

    /// Blends a line of text into the pixels.
    fn text(&mut self, [x, y]: Place, text: &str, size: TextSize, color: Color, anchor: Anchor) {
        let scale = f64::from(SCALE);
        let long = text.chars().count() as f64 * advance(size);
        let left = match anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * long,
            Anchor::End => x - long,
        };
        // The baseline of the font is a fifth of its height above the lower edge.
        let top = ((y - 0.8 * size.height()) * scale).round() as i64;
        let left = (left * scale).round() as i64;
        let (width, height) = (i64::from(self.pixels.width()), i64::from(self.pixels.height()));
        glyphs(size).draw(text, |[x, y], coverage| {
            let (x, y) = (left + i64::from(x), top + i64::from(y));
            if (0..width).contains(&x) && (0..height).contains(&y) {
                let at = 4 * (y * width + x) as usize;
                let pixel = &mut self.pixels.data_mut()[at..at + 3];
                for (value, ink) in pixel.iter_mut().zip(color) {
                    *value = inked(*value, ink, coverage);
                }
            }
        });
    }
}

fn paint([red, green, blue]: Color, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, (opacity.clamp(0.0, 1.0) * 255.0).round() as u8);
    paint.anti_alias = true;
    paint
}

/// A path through places, at least two of them different.
fn path(places: &[Place], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (number, [x, y]) in places.iter().enumerate() {
        match number {
            0 => builder.move_to(*x as f32, *y as f32),
            _ => builder.line_to(*x as f32, *y as f32),
        }
    }
    if closed {
        builder.close();
    }
    builder.finish()
}
