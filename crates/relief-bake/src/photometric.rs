//! Normals and albedo from photographs under known lights.
//!
//! Woodham 1980, *Photometric Method for Determining Surface Orientation from Multiple Images*; Szirmay-Kalos
//! and Umenhoffer 2008, section 2.2, name it as a source of height maps.
//! [`from_normals`](crate::from_normals) makes the heights.
//!
//! One camera looks straight down at a matt surface (Lambert) that distant lights shine on one after the
//! other. A pixel's brightness is then `I = intensity (l · g)` with `l` the unit vector to the light and `g`
//! the normal times the albedo; three lights that shine on it give `g`, more give it by least squares.
//!
//! * *Shadows*, attached and cast, are left out: samples at or below a threshold, which should lie above what
//!   stray light leaves in shadows. So are overexposed ones. A normal whose least-squares fit is turned away
//!   from a light that was not left out is fitted again without that sample.
//! * A pixel is *known* when at least three lights that are well spread are left. The slopes of others are
//!   filled in smoothly from known ones around them, coarse to fine, and their albedo likewise.

mod colour;
mod normals;

pub use self::colour::ColourAlbedo;
pub use self::normals::{Exposure, Photo, PhotometricError, Photometry, check_lights, normals_from_photos};
