//! The rays that searches and tracers are measured with, and how.

use std::time::Instant;

use relief_core::camera::Camera;
use relief_core::{HeightMap, Path, Wrap};
use relief_tests::maps::fractal;
use relief_tests::rng::Rng;

/// Pixels of the view.
const SIZE: [u32; 2] = [1000, 750];

/// Rays from anywhere to anywhere.
const SCATTERED: usize = 200_000;

/// How deep the relief is, in tiles.
const SCALE: f64 = 0.08;

/// Natural ground of so many texels in both directions.
pub fn ground(side: u32, wrap: Wrap) -> Result<HeightMap, String> {
    HeightMap::new(side, side, fractal(3, side, side, 0.55), wrap).map_err(|error| error.to_string())
}

/// The rays of a view over a tile, by blocks of 4 x 4 pixels, and rays scattered over it: from where they
/// enter the relief to its bottom, or to the tile's edge.
pub fn rays() -> Result<[Vec<Path>; 2], String> {
    let camera = Camera::new([0.24, 0.72, 0.96].into(), [0.0; 3].into(), 45.0);
    let camera = camera.map_err(|error| error.to_string())?;
    let mut view = Vec::new();
    for block in (0..SIZE[1] / 4).flat_map(|row| (0..SIZE[0] / 4).map(move |column| [column, row])) {
        for place in 0..16 {
            let [x, y] = [4 * block[0] + place % 4, 4 * block[1] + place / 4];
            let ray = camera.ray(x, y, SIZE[0], SIZE[1]);
            let at = |height: f64| ray.at((height - ray.origin.y) / ray.direction.y);
            let (from, to) = (at(SCALE), at(0.0));
            view.extend(within([from.x + 0.5, from.z + 0.5], [to.x + 0.5, to.z + 0.5]));
        }
    }
    let mut rng = Rng::new(9);
    let mut place = || [rng.unit(), rng.unit()];
    let scattered = std::iter::repeat_with(|| {
        let (from, way) = (place(), place());
        within(from, [from[0] + 0.4 * (way[0] - 0.5), from[1] + 0.4 * (way[1] - 0.5)])
    });
    Ok([view, scattered.flatten().take(SCATTERED).collect()])
}

/// A path from the top of the relief to its bottom, cut off where it leaves the tile.
fn within(from: [f64; 2], to: [f64; 2]) -> Option<Path> {
    let is_inside = |[u, v]: [f64; 2]| (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
    is_inside(from).then(|| {
        let mut path = Path::between([from[0], from[1], 1.0], [to[0], to[1], 0.0]);
        for axis in 0..2 {
            let (at, speed) = (path.uv[axis], path.duv[axis]);
            let edge = if speed > 0.0 { 1.0 } else { 0.0 };
            if speed != 0.0 {
                path.exit = path.exit.min((edge - at) / speed);
            }
        }
        path
    })
}

/// The least nanoseconds a ray of so many rounds, of some things that are done in turn.
pub fn fastest(rounds: u16, rays: usize, things: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; things.len()];
    for _ in 0..rounds {
        for (thing, least) in things.iter_mut().zip(&mut least) {
            let started = Instant::now();
            thing();
            *least = least.min(started.elapsed().as_secs_f64() * 1e9 / rays as f64);
        }
    }
    least
}
