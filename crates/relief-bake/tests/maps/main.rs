//! Baked maps against brute force, and heights from normals and photographs.

mod cone;
mod deband;
mod dilation_erosion;
mod distance;
mod filter_levels;
mod from_normals;
mod from_shading;
mod frustum;
mod horizon;
mod normal;
mod occlusion;
mod photometric;
mod pyramid;
mod relaxed_cone;
mod seen_normal;
mod ties;
mod view_dependent;
mod visibility;
