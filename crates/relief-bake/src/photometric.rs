//! Normals and albedo from photographs under known lights.
//!
//! Woodham 1980, *Photometric Method for Determining Surface Orientation from Multiple Images*;
//! Szirmay-Kalos and Umenhoffer 2008, section 2.2, name it as a source of height maps.
//! [`from_normals`](crate::from_normals) makes the heights.
//!
//! One camera looks straight down at a matt (Lambertian) surface, lit by one distant light after
//! another. A pixel's brightness is then `I = intensity (l · g)`. Here `l` is the unit vector to
//! the light, and `g` the normal times the albedo. Three lights that reach the pixel determine `g`;
//! with more, `g` is their least-squares fit.
//!
//! * *Shadows*, attached and cast, are left out: samples at or below a threshold. The threshold
//!   should exceed the stray light in shadows. Overexposed samples are left out, too. If a fitted
//!   normal is turned away from a light in use, it is fitted again without that sample.
//! * *Known* pixels have at least three well-spread lights left. Slopes and albedo of the others
//!   are filled in smoothly from known ones around them, coarse to fine.

mod colour;
mod normals;

pub use self::colour::ColourAlbedo;
pub use self::normals::{Exposure, Photo, PhotometricError, Photometry, check_lights, normals_from_photos};
