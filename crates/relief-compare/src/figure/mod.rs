//! Drawings of lines, areas and text, as SVG and as pixels.

mod raster;
mod svg;

/// An sRGB colour.
pub type Color = [u8; 3];

/// A place in a drawing: units to the right and down from its top-left corner.
pub type Place = [f64; 2];

/// A drawing. Its unit is a pixel of a screen, or two of [`Figure::pixels`].
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Width and height in units.
    pub size: [u32; 2],
    /// The rectangle that [`Figure::inside`] is cut to: its top-left corner, and the opposite one.
    pub frame: [Place; 2],
    /// Shapes that are cut to the frame, from back to front.
    pub inside: Vec<Shape>,
    /// Shapes in front of them.
    pub over: Vec<Shape>,
}

/// A shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A filled area.
    Area {
        /// Its corners, in order.
        corners: Vec<Place>,
        /// Its colour.
        color: Color,
        /// Its opacity, from 0 to 1.
        opacity: f64,
    },
    /// A line through places.
    Line {
        /// The places, in order.
        places: Vec<Place>,
        /// Its colour.
        color: Color,
        /// Its width in units.
        width: f64,
        /// Whether it is dashed.
        dashed: bool,
    },
    /// A filled ellipse with an outline.
    Ellipse {
        /// Its centre.
        centre: Place,
        /// Half its width and half its height, in units.
        radii: [f64; 2],
        /// Its colour.
        color: Color,
        /// The opacity of its area, from 0 to 1. The outline is opaque.
        opacity: f64,
    },
    /// A line of text.
    Text {
        /// The end of its baseline that [`Text::anchor`](Anchor) says.
        at: Place,
        /// The characters.
        text: String,
        /// Its size.
        size: TextSize,
        /// Its colour.
        color: Color,
        /// Which part of the text is at the place.
        anchor: Anchor,
    },
}

/// Which part of a text is at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}

/// Size of text: characters have one width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextSize {
    /// 12 units high.
    Small,
    /// 16 units high.
    Large,
}

impl TextSize {
    /// Returns the height of a line in units.
    pub const fn height(self) -> f64 {
        match self {
            TextSize::Small => 12.0,
            TextSize::Large => 16.0,
        }
    }

    /// Returns the width of a character in units.
    pub fn advance(self) -> f64 {
        raster::advance(self)
    }
}
