//! Slow, obvious bakes that the fast ones are held to.

pub mod cone;
pub mod dilation_erosion;
pub mod distance;
pub mod frustum;
pub mod horizon;
pub mod normal;
pub mod pyramid;
pub mod relaxed_cone;
pub mod sky;
pub mod visibility;
