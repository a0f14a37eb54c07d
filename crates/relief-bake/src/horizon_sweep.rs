//! The sweep that finds the horizons of all texels, azimuth by azimuth (Timonen and Westerholm 2010).
//!
//! The first steps are read from each texel's own ray, what is farther from the sheared lines. The kinds `horizon`,
//! `occlusion` and `bent-normal` use it; how exact it is says the kind `horizon`.

mod far;
mod near;
mod sweep;

pub use self::near::NEAR_STEPS;
pub(crate) use self::sweep::Sweep;
