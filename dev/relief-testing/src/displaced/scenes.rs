//! Meshes and maps that are hard to judge.

use glam::Vec2;
use relief_core::mesh::{Mesh, MeshError, cylinder, sphere, square, torus};
use relief_core::{HeightMap, Wrap};

use super::sheet::Sheet;
use relief_core::rng::Rng;

/// A named sheet.
pub struct Scene {
    /// Description.
    pub name: String,
    /// The sheet.
    pub sheet: Sheet,
    /// Whether no shell is turned inside out.
    pub unfolded: bool,
}

/// Pattern of the heights of a map.
#[derive(Clone, Copy, Debug)]
pub enum Heights {
    /// White noise.
    Noise,
    /// A tenth of the texels at 1, the others at 0.
    Spikes,
    /// All alike.
    Constant,
    /// A level slope.
    Ramp,
    /// Waves.
    Smooth,
}

/// Map of the given columns and rows.
///
/// # Panics
///
/// When a side is 0.
pub fn map(heights: Heights, [width, height]: [u32; 2], wrap: Wrap) -> HeightMap {
    let mut rng = Rng::new(7);
    let texel = |i: u32, j: u32| {
        let random = rng.unit() as f32;
        let (x, y) = (i as f32 / width as f32, j as f32 / height as f32);
        match heights {
            Heights::Noise => random,
            Heights::Spikes => f32::from(u8::from(random > 0.9)),
            Heights::Constant => 0.6,
            Heights::Ramp => 0.7 * x + 0.3 * y,
            Heights::Smooth => 0.5 + 0.25 * (6.3 * x).sin() + 0.25 * (12.6 * y).cos(),
        }
    };
    HeightMap::from_fn(width, height, wrap, texel).expect("a valid map")
}

fn scene(name: &str, mesh: Result<Mesh, MeshError>, tile: Vec2, map: HeightMap, lengths: [f64; 2]) -> Scene {
    let mesh = mesh.and_then(|mesh| mesh.tiled(tile)).expect("a valid mesh");
    let [scale_m, bias_m] = lengths;
    let name = format!("{name}, {}x{} {}, {scale_m} m", map.width(), map.height(), map.wrap());
    Scene { name, sheet: Sheet { mesh, map, scale_m, bias_m, normalised: false }, unfolded: true }
}

/// All scenes.
pub fn all() -> Vec<Scene> {
    use Heights::{Constant, Noise, Ramp, Smooth, Spikes};
    use Wrap::{Clamp, Mirror, Repeat};
    let one = Vec2::ONE;
    let mut scenes = vec![
        scene("square, noise", square(2), one, map(Noise, [13, 11], Repeat), [0.1, -0.1]),
        scene("square, spikes", square(3), one, map(Spikes, [16, 16], Clamp), [0.3, 0.0]),
        scene("square, column", square(1), Vec2::new(2.5, 1.5), map(Noise, [1, 7], Mirror), [0.2, 0.0]),
        scene("square, row", square(1), Vec2::new(1.7, 2.3), map(Noise, [7, 1], Clamp), [0.2, 0.0]),
        scene("square, one texel", square(1), one, map(Noise, [1, 1], Mirror), [0.2, 0.0]),
        scene("square, upside down", square(1), one, map(Noise, [5, 3], Repeat), [-0.2, 0.05]),
        scene("torus, noise", torus(16, 8), one, map(Noise, [23, 17], Repeat), [0.05, -0.02]),
        scene(
            "torus, smooth",
            torus(16, 8),
            Vec2::new(3.0, 2.0),
            map(Smooth, [16, 16], Repeat),
            [0.05, -0.05],
        ),
        scene("torus, spikes", torus(16, 8), Vec2::new(1.5, 2.0), map(Spikes, [13, 8], Mirror), [0.1, -0.05]),
        scene("torus, constant", torus(16, 8), one, map(Constant, [8, 8], Repeat), [0.1, 0.0]),
        scene("sphere, noise", sphere(12, 6), one, map(Noise, [31, 16], Repeat), [0.1, 0.0]),
        scene("sphere, ramp", sphere(9, 5), Vec2::new(2.0, 1.0), map(Ramp, [16, 7], Mirror), [0.2, -0.1]),
        scene(
            "cylinder, smooth",
            cylinder(9, 2),
            Vec2::new(3.0, 1.0),
            map(Smooth, [16, 16], Repeat),
            [0.1, 0.0],
        ),
        scene(
            "cylinder, noise",
            cylinder(12, 1),
            Vec2::new(1.5, 1.5),
            map(Noise, [19, 5], Clamp),
            [0.1, 0.0],
        ),
    ];
    // Carved deeper than the tube is thick.
    let folded = scene("torus, folded", torus(12, 6), one, map(Noise, [16, 16], Repeat), [0.3, -0.25]);
    scenes.push(Scene { unfolded: false, ..folded });
    scenes
}
