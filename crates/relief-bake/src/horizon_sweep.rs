//! Sweep that finds the horizons of all texels, azimuth by azimuth (Timonen and Westerholm 2010).
//!
//! The first steps are read from each texel's own ray; farther steps are read from sheared lines.
//! The kinds `horizon`, `occlusion` and `bent-normal` use it. The kind `horizon` states its
//! accuracy.

mod far;
mod near;
mod sweep;

pub use self::near::NEAR_STEPS;
pub(crate) use self::sweep::Sweep;
