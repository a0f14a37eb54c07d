//! Collection of values while a scene is rendered.

use relief_scene::Scene;
use relief_shaders::cpu::PixelOut;

use super::legend::{NOT_COMPARABLE_COLOR, PALETTE};
use super::quantity::{Quantity, ValueOf};
use super::scale::{NO_SURFACE, NOT_COMPARABLE, Scale};
use crate::Wire;
use crate::picture::{Display, srgb};

/// Compares a picture with the exact one. `relief-compare` has one.
pub trait Judge: Sync {
    /// Returns the value of a [quantity of hits](ValueOf::OfHit) at a pixel, or [`NO_SURFACE`] or
    /// [`NOT_COMPARABLE`]. `number` is the pixel's, row by row from the top.
    fn of_hit(&self, quantity: &Quantity, number: usize, pixel: &PixelOut) -> f32;

    /// Returns the values of a [quantity of colours](ValueOf::OfColors) at all pixels, from the
    /// picture's linear colours.
    fn of_colors(&self, quantity: &Quantity, linear: &[[f32; 3]]) -> Vec<f32>;
}

/// What a picture of a sheet shows: one value a pixel, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// sRGB colours.
    Picture(Vec<[u8; 3]>),
    /// Numbers. [`NO_SURFACE`] and [`NOT_COMPARABLE`](super::NOT_COMPARABLE) are none.
    Numbers(Vec<f32>),
    /// Directions as colours; none where no surface is visible.
    Directions(Vec<Option<[u8; 3]>>),
}

impl Content {
    /// Greatest number of bytes a pixel.
    pub const BYTES_PER_PIXEL: u64 = 4;

    /// Returns the number of pixels.
    pub fn len(&self) -> usize {
        match self {
            Content::Picture(pixels) => pixels.len(),
            Content::Numbers(pixels) => pixels.len(),
            Content::Directions(pixels) => pixels.len(),
        }
    }

    /// Whether there are no pixels.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the colour of a pixel, with the numbers' scale; none where no surface is visible.
    ///
    /// # Panics
    ///
    /// When there is no such pixel.
    pub fn color(&self, pixel: usize, scale: &Scale) -> Option<[u8; 3]> {
        match self {
            Content::Picture(colors) => Some(colors[pixel]),
            Content::Directions(colors) => colors[pixel],
            Content::Numbers(numbers) => match numbers[pixel] {
                number if number.is_nan() => None,
                NOT_COMPARABLE => Some(NOT_COMPARABLE_COLOR),
                number => Some(PALETTE.at(scale.place(number))),
            },
        }
    }
}

/// Values of quantities, collected from the bands of a rendering.
pub struct Gathered<'a> {
    scene: &'a Scene,
    display: Display,
    wire: Option<Wire>,
    judge: Option<&'a dyn Judge>,
    /// Linear colours, if they are to be compared.
    linear: Option<Vec<[f32; 3]>>,
    /// What is collected, with the values so far. None: the picture itself.
    all: Vec<(Option<&'static Quantity>, Content)>,
    done: usize,
}

impl<'a> Gathered<'a> {
    /// Begins to collect `shown` from a rendering of `scene`. None is the picture itself.
    pub fn new(scene: &'a Scene, shown: &[Option<&'static Quantity>]) -> Self {
        let content = |of: Option<&Quantity>| match of.map(|of| of.value) {
            None => Content::Picture(Vec::new()),
            Some(ValueOf::Direction(_)) => Content::Directions(Vec::new()),
            Some(ValueOf::Number(_) | ValueOf::OfHit | ValueOf::OfColors) => Content::Numbers(Vec::new()),
        };
        let is_of_colors = |of: &Quantity| matches!(of.value, ValueOf::OfColors);
        let linear = shown.iter().flatten().copied().any(is_of_colors).then(Vec::new);
        let all = shown.iter().map(|&of| (of, content(of))).collect();
        Self { scene, display: Display::of(scene), wire: None, judge: None, linear, all, done: 0 }
    }

    /// Compares the picture by `judge`. Without this, comparisons have no values.
    #[must_use]
    pub fn with_judge(self, judge: &'a dyn Judge) -> Self {
        Self { judge: Some(judge), ..self }
    }

    /// Draws the base meshes' edges over the picture.
    #[must_use]
    pub fn with_wire(self) -> Self {
        Self { wire: Some(Wire::new(self.scene)), ..self }
    }

    /// Adds the next band of whole rows. Numbers need a rendering [with
    /// numbers](crate::Renderer::render_bands).
    pub fn add(&mut self, band: &[PixelOut]) {
        let width = self.scene.size()[0].max(1) as usize;
        for pixels in band.chunks(width) {
            self.add_row(pixels);
        }
    }

    fn add_row(&mut self, pixels: &[PixelOut]) {
        let Self { scene, display, wire, judge, linear, all, done } = self;
        let row = (*done / scene.size()[0].max(1) as usize) as u32;
        if let Some(linear) = linear {
            linear.extend(display.linear_row(row, pixels));
        }
        for (quantity, content) in all {
            match (quantity.map(|of| of.value), content) {
                (None, Content::Picture(colors)) => {
                    let mut linear = display.linear_row(row, pixels);
                    linear.iter_mut().for_each(|color| *color = color.map(|part| part.clamp(0.0, 1.0)));
                    if let Some(wire) = wire {
                        wire.next_row(pixels, &mut linear);
                    }
                    let byte = |part: f32| (part * 255.0 + 0.5) as u8;
                    colors.extend(linear.into_iter().map(|color| srgb(color).map(byte)));
                }
                (Some(ValueOf::Number(of)), Content::Numbers(numbers)) => {
                    let number =
                        |pixel: &PixelOut| if pixel.hit == 0 { NO_SURFACE } else { of(pixel, scene) };
                    numbers.extend(pixels.iter().map(number));
                }
                (Some(ValueOf::OfHit), Content::Numbers(numbers)) => {
                    let of = |(at, pixel): (usize, &PixelOut)| match (&judge, &quantity) {
                        (Some(judge), Some(quantity)) => judge.of_hit(quantity, *done + at, pixel),
                        _ => NO_SURFACE,
                    };
                    numbers.extend(pixels.iter().enumerate().map(of));
                }
                (Some(ValueOf::Direction(of)), Content::Directions(colors)) => {
                    let byte = |part: f32| ((part * 0.5 + 0.5).clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
                    colors.extend(pixels.iter().map(|pixel| (pixel.hit != 0).then(|| of(pixel).map(byte))));
                }
                // `new` made the contents of these forms, and colours are compared at the end.
                _ => {}
            }
        }
        *done += pixels.len();
    }

    /// Returns what was collected, in the order in which it was asked for.
    pub fn finish(self) -> Vec<Content> {
        let Self { judge, linear, all, done, .. } = self;
        let finished = |(quantity, content): (Option<&Quantity>, Content)| match quantity {
            Some(quantity) if matches!(quantity.value, ValueOf::OfColors) => {
                let linear = linear.as_deref().unwrap_or_default();
                Content::Numbers(
                    judge.map_or(vec![NO_SURFACE; done], |judge| judge.of_colors(quantity, linear)),
                )
            }
            _ => content,
        };
        all.into_iter().map(finished).collect()
    }
}
