//! Pictures of both backends, and their light and shadows beside the truth.

mod ambient;
mod backends;
mod cast_shadows;
mod materials;
mod picture;
mod pictures_of_both;
mod scenes;
mod shadow;
mod shadows_beside_truth;
