//! Numbers of pixels in colours, with their legend, and the errors beside the exact picture.

use relief_compare::picture::{Flip, Image, peak_signal_to_noise, root_mean_square};
use relief_render::false_color::{Content, Form, NOT_COMPARABLE, PALETTE, Quantity, Scale, hatched};
use relief_render::job::Rendering;
use relief_scene::{Scene, Shown};
use serde_json::{Value, json};

use crate::exact::Exact;
use crate::pane::Painted;

/// Number of colours of a legend.
const STOPS: u32 = 16;

/// The scale that views of the same quantity share.
pub fn scale<'a>(quantity: &Quantity, painted: impl Iterator<Item = &'a Painted>) -> Scale {
    let numbers = painted.filter_map(|painted| match painted {
        Painted::Quantity(Content::Numbers(numbers), _) => Some(numbers),
        _ => None,
    });
    Scale::of(quantity.form, numbers.flatten())
}

/// The colours of a view: red, green, blue and 255.
pub fn bytes(painted: &Painted, scale: Option<&Scale>, size: [u32; 2]) -> Vec<u8> {
    let (content, scale) = match (painted, scale) {
        (Painted::Picture(bytes, _), _) => return bytes.clone(),
        (Painted::Quantity(..), None) => return Vec::new(),
        (Painted::Quantity(content, _), Some(scale)) => (content, scale),
    };
    let width = size[0].max(1);
    let color = |pixel: usize| {
        let at = [pixel as u32 % width, pixel as u32 / width];
        let [red, green, blue] = content.color(pixel, scale).unwrap_or_else(|| hatched(at));
        [red, green, blue, u8::MAX]
    };
    (0..content.len()).flat_map(color).collect()
}

/// The legend of a quantity.
pub fn legend(quantity: &Quantity, scale: &Scale) -> Value {
    let stops: Vec<String> = match quantity.form {
        Form::Directions => Vec::new(),
        _ => (0..=STOPS).map(|stop| hex(PALETTE.at(stop as f32 / STOPS as f32))).collect(),
    };
    let ticks = scale.ticks().into_iter().map(|tick| json!({ "place": tick.place, "label": tick.label }));
    json!({
        "title": quantity.title, "unit": quantity.unit, "stops": stops, "ticks": ticks.collect::<Vec<_>>(),
    })
}

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The errors of a view as `relief compare` has them, and its worst pixel.
pub fn errors(quantity: &Quantity, exact: &Exact, painted: &Painted, scene: &Scene) -> Option<Value> {
    let Painted::Quantity(Content::Numbers(numbers), pixels) = painted else { return None };
    let [width, height] = scene.size();
    let figures = match quantity.shown {
        Shown::Flip => {
            let flip = Flip { size: [width, height], differences: numbers.clone() };
            json!({ "flip": flip.mean() })
        }
        Shown::ColorError => {
            let rendering = Rendering { width, height, pixels: pixels.clone() };
            let picture = Image::of(&rendering, scene).ok()?;
            let rms = root_mean_square(exact.image()?, &picture).ok()?;
            json!({ "rms": rms, "psnr_db": peak_signal_to_noise(exact.image()?, &picture).ok()? })
        }
        _ => json!(exact.hits()?.errors(pixels)),
    };
    let worst = worst(numbers).map(|number| [number as u32 % width, number as u32 / width]);
    Some(json!({ "figures": figures, "worst": worst }))
}

/// The pixel with the greatest number; one that cannot be compared, if no other differs.
fn worst(numbers: &[f32]) -> Option<usize> {
    let finite = numbers.iter().enumerate().filter(|(_, number)| number.is_finite() && **number > 0.0);
    let greatest = finite.max_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(number, _)| number);
    greatest.or_else(|| numbers.iter().position(|number| *number == NOT_COMPARABLE))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_pixel_is_the_farthest_hit_and_else_a_miss() {
        let [none, miss] = [f32::NAN, NOT_COMPARABLE];
        assert_eq!(worst(&[0.0, none, 3.0, miss, 2.0]), Some(2));
        assert_eq!(worst(&[0.0, none, miss]), Some(2));
        assert_eq!(worst(&[0.0, none]), None);
    }
}
