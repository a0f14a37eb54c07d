//! Parallel lines along an azimuth that visit every texel once, and maps in their order.
//!
//! The lines follow Timonen and Westerholm 2010. The horizon sweep and the kind `visibility` use
//! them.

mod lines;
mod sheared_map;

pub(crate) use self::lines::{Lines, Rows, Stretch};
pub(crate) use self::sheared_map::{Band, Plane, Run, SKEW, Slab};
