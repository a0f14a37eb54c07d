//! Parallel lines along an azimuth that visit every texel once (Timonen and Westerholm 2010), and maps in their order.
//!
//! The horizon sweep and the kind `visibility` look along them.

mod lines;
mod sheared_map;

pub(crate) use self::lines::{Lines, Rows, Stretch};
pub(crate) use self::sheared_map::{Band, Plane, Run, SKEW, Slab};
