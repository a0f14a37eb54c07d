//! Base triangles with their corners.

use super::{Corner, Shell};

/// A base triangle, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The first corner; they run counter-clockwise seen from the front.
    pub a: Corner,
    /// The second corner.
    pub b: Corner,
    /// The third corner.
    pub c: Corner,
    /// The space that its relief may fill.
    pub shell: Shell,
}
