//! Parts of tests and benchmarks that need the core alone: adversarial maps and rays, brute forces, and the
//! judge that compares one tracer with another. Never published.

pub mod brute;
pub mod displaced;
pub mod judge;
pub mod maps;
pub mod mesh_distance;
pub mod motifs;
pub mod outline;
pub mod probes;
pub mod rays;
pub mod search;
pub mod smooth_base;
pub mod volumes;

/// Number of adversarial rays that a test sends through each map in each wrap. Tests that cost more a
/// ray take a fraction of it. All test times scale with it: 25,000 makes 1.2 million rays over
/// [`maps::ALL`] in the three wraps.
pub const RAYS_PER_MAP: usize = 25_000;

/// The steepest slope of a map along an axis, in heights a texel.
pub fn steepest(map: &relief_core::HeightMap) -> f64 {
    let cells = (0..i64::from(map.height())).flat_map(|j| (0..i64::from(map.width())).map(move |i| (i, j)));
    cells.fold(0.0, |steepest, (i, j)| {
        let [h00, h10, h01, h11] = map.cell(i, j).map(f64::from);
        let slopes = [h10 - h00, h01 - h00, h11 - h01, h11 - h10].map(f64::abs);
        slopes.into_iter().fold(steepest, f64::max)
    })
}
