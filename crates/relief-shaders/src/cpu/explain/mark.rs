//! What a turn of a loop looked at.

/// A mark of a loop. Every `t` is a parameter of the path. Texture coordinates are not wrapped; heights are
/// texel heights, from 0 to 1. What follows a [`Turn`](Mark::Turn) belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A turn begins.
    Turn {
        /// Where the ray is.
        t: f64,
    },
    /// The ray's height and the surface's are compared.
    Sample {
        /// Where.
        t: f64,
    },
    /// The bilinear patch of a dual cell is tested.
    Patch {
        /// Texture coordinates of the cell's corner with the least coordinates.
        low: [f64; 2],
        /// The opposite corner.
        high: [f64; 2],
        /// Where the tested part of the ray begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// The surface is nowhere higher over a rectangle.
    Box {
        /// Texture coordinates of the rectangle's corner with the least coordinates.
        low: [f64; 2],
        /// The opposite corner.
        high: [f64; 2],
        /// The height.
        top: f64,
    },
    /// A cone that opens upward and is taken to be empty.
    Cone {
        /// Texture coordinates of the apex.
        uv: [f64; 2],
        /// Height of the apex.
        apex: f64,
        /// Height per tile.
        slope: f64,
    },
    /// A frustum on a cell that is empty in the quadrant where the ray goes.
    Frustum {
        /// Texture coordinates of the cell's corner with the least coordinates.
        low: [f64; 2],
        /// The opposite corner.
        high: [f64; 2],
        /// Height over the cell.
        top: f64,
        /// Height per tile from the cell on, along `u` and along `v`. The greater of the two rises counts.
        slopes: [f64; 2],
    },
    /// A ball around a place of the ray that is taken to be empty.
    Ball {
        /// The place.
        t: f64,
        /// The radius, in tiles and heights.
        radius: f64,
    },
    /// The hit is known to be between two places.
    Bracket {
        /// The nearer one.
        near: f64,
        /// The farther one.
        far: f64,
    },
    /// The gap between ray and surface is taken to be linear.
    Chord {
        /// Two places.
        ends: [f64; 2],
        /// The gaps there, positive above the surface.
        gaps: [f64; 2],
    },
    /// The surface is taken to be a plane.
    Plane {
        /// A place of the ray.
        t: f64,
        /// The plane's height there.
        height: f64,
        /// Change of the plane's height along the ray, for a change of 1 in `t`.
        rise: f64,
    },
}
