//! Tasks for the places of a block.

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
    /// Columns and rows of the points, in pixels from the picture's top-left corner.
    pub points: &'a [Row<f32>; 2],
}

/// A point of a light's disc, as for the shadow `soft`, or the light's centre.
#[derive(Clone, Copy, Debug)]
pub struct LightPoint {
    /// The number of the light in the frame.
    pub light: u32,
    /// The number of the point, from 0.
    pub point: u32,
    /// The number of points on the disc; 0 stands for the light's centre.
    pub count: u32,
}

/// A task for some places of a block: its inputs, and where the results go. The results of other
/// places stay as they were.
pub(in crate::cpu) enum Task<'a> {
    /// Search and refinement.
    Trace { paths: &'a PathBlock, hits: &'a mut HitBlock },
    /// Whether the search for shadows finds nothing: a bit for each place.
    Free { paths: &'a PathBlock, free: &'a mut u16 },
    /// Points where rays meet the surface, and their first segments, if they have any.
    Enter { rays: TriangleRays<'a>, at: &'a mut EnteredBlock, paths: &'a mut PathBlock },
    /// The segments with the number `number`, of rays that have as many.
    Segment { rays: TriangleRays<'a>, number: u32, at: &'a EnteredBlock, paths: &'a mut PathBlock },
    /// Hits on the segments with the number `number`, moved onto their rays, and their keys.
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
    /// The shaded pixels of placed hits.
    Shade {
        points: &'a [Row<f32>; 2],
        placed: &'a EnteredBlock,
        hits: &'a HitBlock,
        visible: &'a [Row<f32>; MAX_LIGHTS],
        pixels: &'a mut PixelOutBlock,
    },
}
