//! The rays that searches and the exact tracer are measured with.

use relief_core::exact::FastTracer;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path, Wrap};
use relief_testing::maps::fractal;

use crate::trace::view::{Ground, SIZE, camera, sun};

/// How much higher an octave of the ground is than the one before.
const ROUGHNESS: f32 = 0.55;

/// Rays from anywhere to anywhere.
const SCATTERED: usize = 200_000;

/// Fractal ground with the given number of texels a side, in 65536 levels.
pub fn ground(side: u32, wrap: Wrap) -> Result<HeightMap, String> {
    let levels = f32::from(u16::MAX);
    let texels = fractal(11, side, side, ROUGHNESS).iter().map(|x| (x * levels).round() / levels).collect();
    HeightMap::new(side, side, texels, wrap).map_err(|error| error.to_string())
}

/// The paths of the camera's rays, in blocks of 4 x 4 pixels.
pub fn view(map: &HeightMap) -> Result<Vec<Path>, String> {
    let (camera, ground) = (camera().map_err(|error| error.to_string())?, Ground::of(map));
    let [width, height] = SIZE;
    let blocks =
        (0..height.div_ceil(4)).flat_map(|row| (0..width.div_ceil(4)).map(move |column| (column, row)));
    let pixels = blocks.flat_map(|(column, row)| (0..16).map(move |k| (4 * column + k % 4, 4 * row + k / 4)));
    let inside = pixels.filter(|(x, y)| *x < width && *y < height);
    Ok(inside
        .filter_map(|(x, y)| {
            let ray = camera.ray(x, y, width, height);
            ground.path(ray.origin, ray.direction)
        })
        .collect())
}

/// The paths from the view's hits to the sun, in the view's order.
pub fn shadows(map: &HeightMap, tracer: &FastTracer, view: &[Path]) -> Vec<Path> {
    let (ground, sun) = (Ground::of(map), sun());
    let hits = view.iter().map(|path| tracer.trace(path).hit).filter(|hit| hit.found);
    hits.filter_map(|hit| ground.path_to_sun(Ground::point(hit.uv, hit.height), sun)).collect()
}

/// Paths from anywhere on top of the relief down to its bottom, in any direction.
pub fn scattered() -> Vec<Path> {
    let mut rng = Rng::new(3);
    let path = |_| {
        let (angle, reach) = (rng.unit() * std::f64::consts::TAU, rng.between(0.05, 0.3));
        let from = [rng.between(0.31, 0.69), rng.between(0.31, 0.69)];
        let to = [from[0] + angle.cos() * reach, from[1] + angle.sin() * reach];
        Path::between([from[0], from[1], 1.0], [to[0], to[1], 0.0])
    };
    (0..SCATTERED).map(path).collect()
}
