//! What the signs of a cut mean.

use relief_shaders::cpu::Mark;

use super::cut::{BRACKET, CHORD, FOUND, PATCH, TRUTH};
use super::volume::{BALL, BOX, CONE};
use crate::figure::{Anchor, Color, Place, Shape, TextSize};

/// A kind of sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Turn,
    Truth,
    Found,
    Patch,
    Box,
    Cone,
    Frustum,
    Ball,
    Bracket,
    Chord,
    Plane,
}

impl Sign {
    /// The sign of a mark; None for marks that are drawn as turns.
    pub fn of(mark: &Mark) -> Option<Self> {
        match mark {
            Mark::Turn { .. } | Mark::Sample { .. } => None,
            Mark::Patch { .. } => Some(Sign::Patch),
            Mark::Box { .. } => Some(Sign::Box),
            Mark::Cone { .. } => Some(Sign::Cone),
            Mark::Frustum { .. } => Some(Sign::Frustum),
            Mark::Ball { .. } => Some(Sign::Ball),
            Mark::Bracket { .. } => Some(Sign::Bracket),
            Mark::Chord { .. } => Some(Sign::Chord),
            Mark::Plane { .. } => Some(Sign::Plane),
        }
    }

    const fn meaning(self) -> &'static str {
        match self {
            Sign::Turn => "the ray at the start of a turn",
            Sign::Truth => "true first hit",
            Sign::Found => "the method's hit",
            Sign::Patch => "tested part of the surface",
            Sign::Box => "the surface is below this box's top",
            Sign::Cone => "empty cone",
            Sign::Frustum => "empty frustum",
            Sign::Ball => "empty ball",
            Sign::Bracket => "bracket, turn by turn",
            Sign::Chord => "the surface is taken for this line",
            Sign::Plane => "the surface is taken for this plane",
        }
    }

    const fn color(self) -> Color {
        match self {
            Sign::Turn => [40, 40, 40],
            Sign::Truth => TRUTH,
            Sign::Found => FOUND,
            Sign::Patch => PATCH,
            Sign::Box => BOX,
            Sign::Cone | Sign::Frustum => CONE,
            Sign::Ball => BALL,
            Sign::Bracket => BRACKET,
            Sign::Chord | Sign::Plane => CHORD,
        }
    }
}

/// The signs of a drawing, in the order in which they came.
#[derive(Clone, Debug, Default)]
pub struct Legend(Vec<Sign>);

/// Units from a line of the legend to the next.
const LINE: f64 = 18.0;

/// Units from a sign to its text, and from a text to the next sign.
const GAPS: [f64; 2] = [14.0, 22.0];

impl Legend {
    /// Adds a sign unless it is there.
    pub fn add(&mut self, sign: Option<Sign>) {
        self.0.extend(sign.filter(|sign| !self.0.contains(sign)));
    }

    /// The legend from a place on, in lines of that width, and where it ends.
    pub fn shapes(&self, [left, top]: Place, width: f64) -> (Vec<Shape>, f64) {
        let (mut shapes, mut x, mut y) = (Vec::new(), left, top + 0.5 * LINE);
        for sign in &self.0 {
            let text = sign.meaning();
            let long = GAPS[0] + text.chars().count() as f64 * TextSize::Small.advance();
            if x > left && x + long > left + width {
                (x, y) = (left, y + LINE);
            }
            let centre = [x + 5.0, y - 4.0];
            shapes.push(Shape::Ellipse { centre, radii: [4.0; 2], color: sign.color(), opacity: 0.8 });
            shapes.push(Shape::Text {
                at: [x + GAPS[0], y],
                text: text.to_owned(),
                size: TextSize::Small,
                color: [30, 30, 30],
                anchor: Anchor::Start,
            });
            x += long + GAPS[1];
        }
        (shapes, y)
    }
}
