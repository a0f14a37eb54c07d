//! The sweep that finds the horizons of all texels, azimuth by azimuth (Timonen and Westerholm 2010).
//!
//! The first steps are read from each texel's own ray; what lies farther is read from sheared lines. The
//! kinds `horizon`, `occlusion` and `bent-normal` use it. The kind `horizon` says how exact it is.

mod far;
mod near;
mod sweep;

pub use self::near::NEAR_STEPS;
pub(crate) use self::sweep::Sweep;
