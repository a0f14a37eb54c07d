//! Probes that attack the guarantees of baked maps.

pub mod cone;
pub mod dilation_erosion;
pub mod distance;
mod found;
pub mod frustum;
pub mod place;
pub mod pyramid;
pub mod relaxed_cone;

pub use found::Found;
