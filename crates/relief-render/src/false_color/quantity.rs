//! The list of quantities that can be shown.

use relief_core::registry::UnknownName;
use relief_scene::{Scene, Shown};
use relief_shaders::cpu::PixelOut;

/// Quantity of a picture's pixels.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// What it is of a picture.
    pub shown: Shown,
    /// Name on the command line, such as `height`.
    pub name: &'static str,
    /// Title of the legend, with the unit.
    pub title: &'static str,
    /// Unit, such as `m`; empty for directions.
    pub unit: &'static str,
    /// Division of its scale.
    pub form: Form,
    /// Origin of a pixel's value.
    pub value: ValueOf,
    /// Whether only reliefs have it, and depth objects do not.
    pub is_of_reliefs: bool,
}

/// Error of a quantity that a scene does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{0} is measured from the base of a relief, and a depth object has none: show another quantity, such \
     as depth"
)]
pub struct NotOfObjects(&'static str);

impl Quantity {
    /// Checks that the pixels of a scene have the quantity.
    ///
    /// # Errors
    ///
    /// When it is a height, and a surface is a depth object.
    pub fn check(&self, scene: &Scene) -> Result<(), NotOfObjects> {
        let has_object = scene.surfaces().iter().any(|surface| surface.object().is_some());
        if self.is_of_reliefs && has_object { Err(NotOfObjects(self.name)) } else { Ok(()) }
    }
}

/// Division of a scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Equal distances for equal differences.
    Linear,
    /// Equal distances for equal differences of whole numbers.
    Counts,
    /// Equal distances for equal factors. All values up to the given one have the first colour.
    Logarithmic(f32),
    /// Directions: red, green and blue are x, y and z, from -1 to 1.
    Directions,
}

/// Origin of a pixel's value.
#[derive(Clone, Copy, Debug)]
pub enum ValueOf {
    /// A number of the pixel.
    Number(fn(&PixelOut, &Scene) -> f32),
    /// A direction of the pixel, of length 1.
    Direction(fn(&PixelOut) -> [f32; 3]),
    /// A comparison of the pixel's hit with the exact one, by a [`Judge`](super::Judge).
    OfHit,
    /// A comparison of the picture's colours with the exact ones, by a [`Judge`](super::Judge).
    OfColors,
}

impl ValueOf {
    /// Whether it compares a picture with the exact one.
    pub fn is_comparison(self) -> bool {
        matches!(self, ValueOf::OfHit | ValueOf::OfColors)
    }
}

/// All quantities. Where the CPU renders `exact`, reads and steps count nodes and cells of the exact
/// tracer.
pub static QUANTITIES: [Quantity; 11] = [
    Quantity {
        shown: Shown::Height,
        name: Shown::Height.name(),
        title: "height over the base, m",
        unit: "m",
        form: Form::Linear,
        value: ValueOf::Number(height_m),
        is_of_reliefs: true,
    },
    Quantity {
        shown: Shown::Depth,
        name: Shown::Depth.name(),
        title: "depth along the view, m",
        unit: "m",
        form: Form::Linear,
        value: ValueOf::Number(|pixel, _| pixel.depth),
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Normal,
        name: Shown::Normal.name(),
        title: "normal in the world",
        unit: "",
        form: Form::Directions,
        value: ValueOf::Direction(|pixel| [pixel.normal.x, pixel.normal.y, pixel.normal.z]),
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Reads,
        name: Shown::Reads.name(),
        title: "reads of maps, or tracer nodes",
        unit: "reads",
        form: Form::Counts,
        value: ValueOf::Number(|pixel, _| pixel.reads as f32),
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Steps,
        name: Shown::Steps.name(),
        title: "steps of the search, or tracer cells",
        unit: "steps",
        form: Form::Counts,
        value: ValueOf::Number(|pixel, _| pixel.steps as f32),
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Error,
        name: Shown::Error.name(),
        title: "distance from the exact hit, texels",
        unit: "texels",
        form: Form::Logarithmic(LEAST_ERROR),
        value: ValueOf::OfHit,
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Passed,
        name: Shown::Passed.name(),
        title: "passed the exact hit: 1 if so",
        unit: "rays",
        form: Form::Counts,
        value: ValueOf::OfHit,
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::ColorError,
        name: Shown::ColorError.name(),
        title: "difference of linear colour",
        unit: "of 1",
        form: Form::Linear,
        value: ValueOf::OfColors,
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Flip,
        name: Shown::Flip.name(),
        title: "FLIP difference, 0 is equal",
        unit: "of 1",
        form: Form::Linear,
        value: ValueOf::OfColors,
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Lit,
        name: Shown::Lit.name(),
        title: "arriving share of the first light",
        unit: "share",
        form: Form::Linear,
        value: ValueOf::Number(|pixel, _| pixel.lit),
        is_of_reliefs: false,
    },
    Quantity {
        shown: Shown::Level,
        name: Shown::Level.name(),
        title: "level of detail, 0 is the finest",
        unit: "levels",
        form: Form::Counts,
        value: ValueOf::Number(|pixel, _| pixel.level as f32),
        is_of_reliefs: false,
    },
];

/// Error in texels below which hits differ by rounding alone.
const LEAST_ERROR: f32 = 1e-3;

/// Returns the displacement at a pixel: metres from the base to the surface.
fn height_m(pixel: &PixelOut, scene: &Scene) -> f32 {
    let surface = scene.surfaces().get(pixel.surface as usize);
    surface.map_or(f32::NAN, |surface| {
        let map = surface.height_map();
        (f64::from(pixel.height) * map.scale_m() + map.bias_m()) as f32
    })
}

/// Returns what shows a quantity of pictures; none for the picture itself.
pub fn quantity_of(shown: Shown) -> Option<&'static Quantity> {
    QUANTITIES.iter().find(|quantity| quantity.shown == shown)
}

/// Returns the quantity of that name.
///
/// # Errors
///
/// When no quantity has that name; the error names the nearest.
pub fn quantity(name: &str) -> Result<&'static Quantity, UnknownName> {
    let known = || QUANTITIES.iter().map(|quantity| quantity.name);
    let found = QUANTITIES.iter().find(|quantity| quantity.name == name);
    found.ok_or_else(|| UnknownName::new("quantity", name, known()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_can_be_shown_is_a_quantity_but_the_picture() {
        let without: Vec<Shown> =
            Shown::ALL.into_iter().filter(|shown| quantity_of(*shown).is_none()).collect();
        assert_eq!(without, [Shown::Picture]);
        assert_eq!(QUANTITIES.len() + 1, Shown::ALL.len());
    }
}
