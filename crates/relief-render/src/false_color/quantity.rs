//! The list of quantities that can be shown.

use relief_core::registry::UnknownName;
use relief_scene::Scene;
use relief_shaders::cpu::PixelOut;

/// Quantity of a picture's pixels.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
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
    /// A comparison of the pixel with the exact hit, which the caller makes. `relief-compare` has
    /// one.
    Comparison,
}

/// All quantities. Where the CPU renders `exact`, reads and steps count nodes and cells of the exact
/// tracer.
pub static QUANTITIES: [Quantity; 8] = [
    Quantity {
        name: "height",
        title: "height over the base, m",
        unit: "m",
        form: Form::Linear,
        value: ValueOf::Number(height_m),
        is_of_reliefs: true,
    },
    Quantity {
        name: "depth",
        title: "depth along the view, m",
        unit: "m",
        form: Form::Linear,
        value: ValueOf::Number(|pixel, _| pixel.depth),
        is_of_reliefs: false,
    },
    Quantity {
        name: "normal",
        title: "normal in the world",
        unit: "",
        form: Form::Directions,
        value: ValueOf::Direction(|pixel| [pixel.normal.x, pixel.normal.y, pixel.normal.z]),
        is_of_reliefs: false,
    },
    Quantity {
        name: "reads",
        title: "reads of maps, or tracer nodes",
        unit: "reads",
        form: Form::Counts,
        value: ValueOf::Number(|pixel, _| pixel.reads as f32),
        is_of_reliefs: false,
    },
    Quantity {
        name: "steps",
        title: "steps of the search, or tracer cells",
        unit: "steps",
        form: Form::Counts,
        value: ValueOf::Number(|pixel, _| pixel.steps as f32),
        is_of_reliefs: false,
    },
    Quantity {
        name: "error",
        title: "distance from the exact hit, texels",
        unit: "texels",
        form: Form::Logarithmic(LEAST_ERROR),
        value: ValueOf::Comparison,
        is_of_reliefs: false,
    },
    Quantity {
        name: "lit",
        title: "arriving share of the first light",
        unit: "share",
        form: Form::Linear,
        value: ValueOf::Number(|pixel, _| pixel.lit),
        is_of_reliefs: false,
    },
    Quantity {
        name: "level",
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
