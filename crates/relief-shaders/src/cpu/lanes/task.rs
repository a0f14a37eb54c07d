//! What is done for the places of a block.

use super::block::{EnteredBlock, HitBlock, PathBlock, PixelOutBlock, Row};
use crate::MAX_LIGHTS;
use crate::cpu::Triangle;

/// Rays through points of the picture that meet a side of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct TriangleRays<'a> {
    /// The triangle.
    pub triangle: &'a Triangle,
    /// 1 on its front, -1 on its back.
    pub side: f32,
    /// Columns and rows of the points, in pixels from the picture's upper left corner.
    pub points: &'a [Row<f32>; 2],
}

/// A point of a light, by its number and how many there are, as the shadow `soft` has them; of none the
/// light's centre.
#[derive(Clone, Copy, Debug)]
pub struct LightPoint {
    /// The number of the light in the frame.
    pub light: u32,
    /// The number of the point.
    pub point: u32,
    /// How many points there are.
    pub count: u32,
}

/// What is asked of the shaders for some places of a block, and where the answers go. The answers of other
/// places stay as they were.
pub(in crate::cpu) enum Task<'a> {
    /// Search and refinement.
    Trace { paths: &'a PathBlock, hits: &'a mut HitBlock },
    /// Whether the search for shadows finds nothing: a bit for each place.
    Free { paths: &'a PathBlock, free: &'a mut u16 },
    /// Where rays meet the surface, and their first segments, where they have any.
    Enter { rays: TriangleRays<'a>, at: &'a mut EnteredBlock, paths: &'a mut PathBlock },
    /// The segments of that number of rays that have as many.
    Segment { rays: TriangleRays<'a>, number: u32, at: &'a EnteredBlock, paths: &'a mut PathBlock },
    /// What was found on segments of that number, as what rays meet there, and what orders that.
    Meet {
        rays: TriangleRays<'a>,
        number: u32,
        at: &'a EnteredBlock,
        paths: &'a PathBlock,
        hits: &'a mut HitBlock,
        keys: &'a mut Row<f32>,
    },
    /// The places of hits in the world.
    Place {
        rays: TriangleRays<'a>,
        at: &'a EnteredBlock,
        paths: &'a PathBlock,
        hits: &'a HitBlock,
        placed: &'a mut EnteredBlock,
    },
    /// The rays from placed hits to a point of a light, and their states.
    RaysToLight {
        to: LightPoint,
        placed: &'a EnteredBlock,
        hits: &'a HitBlock,
        states: &'a mut Row<u32>,
        paths: &'a mut PathBlock,
    },
    /// The part of a light that arrives at placed hits.
    Visible { light: u32, placed: &'a EnteredBlock, hits: &'a HitBlock, parts: &'a mut Row<f32> },
    /// What placed hits look like.
    Shade {
        points: &'a [Row<f32>; 2],
        placed: &'a EnteredBlock,
        hits: &'a HitBlock,
        visible: &'a [Row<f32>; MAX_LIGHTS],
        pixels: &'a mut PixelOutBlock,
    },
}
