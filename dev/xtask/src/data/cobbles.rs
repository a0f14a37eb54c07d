//! Cobblestones: rounded stones of very different size, laid close, with sand between them.

use super::lattice::{fractal_noise, mix, mix_colour, random, signed, smooth_step, wrapped_difference};
use super::picture::Grid;

const SIDE: u32 = 256;
/// Radii of the largest and the smallest stone, in tiles.
const RADII: [f64; 2] = [0.115, 0.02];
/// How many places are tried for stones. More fill smaller gaps, until no stone fits any more.
const TRIES: u32 = 30_000;
/// How close stones are laid, relative to the sum of their radii: below 1 they press each other flat.
const CLOSENESS: f64 = 0.9;
/// Half the width of a gap, in tiles.
const HALF_GAP: f64 = 0.0035;

/// Roughness of stones and of sand.
const ROUGHNESS: [f64; 2] = [0.34, 0.95];

const SAND: [f64; 3] = [92.0, 80.0, 64.0];
const STONE: [[f64; 3]; 4] =
    [[136.0, 134.0, 130.0], [112.0, 116.0, 122.0], [152.0, 140.0, 122.0], [126.0, 112.0, 100.0]];

struct Stone {
    centre: [f64; 2],
    radius: f64,
}

/// Height and colour, and occlusion, roughness and metalness: dry sand, and stones that are worn smooth.
pub fn maps() -> (Grid<f64>, Grid<[f64; 3]>, Grid<[f64; 3]>) {
    let stones = lay();
    let grid = Grid::square(SIDE, |u, v| {
        let Texel { height, colour, material } = texel(&stones, u, v);
        (height, (colour, material))
    });
    let (heights, rest) = grid.unzip();
    let (colours, materials) = rest.unzip();
    (heights, colours, materials)
}

/// A point of the ground.
struct Texel {
    height: f64,
    colour: [f64; 3],
    material: [f64; 3],
}

/// Lays stones at random, the large ones first, each where it does not overlap those that lie there.
fn lay() -> Vec<Stone> {
    let mut stones: Vec<Stone> = Vec::new();
    for i in 0..TRIES {
        let done = f64::from(i) / f64::from(TRIES);
        // Most tries go to the small stones, which have the most gaps to find.
        let radius = mix(RADII[0], RADII[1], 1.0 - (1.0 - done) * (1.0 - done) * (1.0 - done) * (1.0 - done));
        let centre = [random(i, 0, 101), random(i, 1, 101)];
        let free = stones.iter().all(|stone| {
            let (dx, dy) = (
                wrapped_difference(stone.centre[0], centre[0]),
                wrapped_difference(stone.centre[1], centre[1]),
            );
            let apart = CLOSENESS * (stone.radius + radius);
            dx * dx + dy * dy >= apart * apart
        });
        if free {
            stones.push(Stone { centre, radius });
        }
    }
    stones
}

fn texel(stones: &[Stone], u: f64, v: f64) -> Texel {
    let wander = 0.007;
    let x = u + wander * fractal_noise(u, v, 12, 2, 11);
    let y = v + wander * fractal_noise(u, v, 12, 2, 21);
    let offsets: Vec<[f64; 2]> = stones
        .iter()
        .map(|stone| [wrapped_difference(stone.centre[0], x), wrapped_difference(stone.centre[1], y)])
        .collect();
    // A stone's share of the ground is its cell in the power diagram, which gives large stones more room.
    let power = |k: usize| {
        let [dx, dy] = offsets[k];
        dx * dx + dy * dy - stones[k].radius * stones[k].radius
    };
    let own = (0..stones.len())
        .min_by(|&a, &b| power(a).total_cmp(&power(b)))
        .expect("the first stone always fits");
    // Distance to the cell's border, with its corners rounded: the inverse fourth powers of the distances to
    // all sides are added, so that where two sides are near, the border seems nearer than either.
    let mut closeness = 0.0;
    for other in (0..stones.len()).filter(|&other| other != own) {
        let (ax, ay) = (offsets[own][0] - offsets[other][0], offsets[own][1] - offsets[other][1]);
        let side = (power(other) - power(own)) / (2.0 * (ax * ax + ay * ay).sqrt());
        let near = 1.0 / side.max(1e-6);
        closeness += near * near * near * near;
    }
    let border = 1.0 / closeness.sqrt().sqrt() - HALF_GAP;

    let stone = &stones[own];
    let number = own as u32;
    let size = (stone.radius - RADII[1]) / (RADII[0] - RADII[1]);
    let grain = fractal_noise(u, v, 40, 3, 31);
    // A flattened dome: an ellipse from the border to the middle.
    let inward = (border / (0.62 * stone.radius)).clamp(0.0, 1.0);
    let dome = (inward * (2.0 - inward)).sqrt();
    let askew = 1.2 * (signed(number, 1, 2) * offsets[own][0] + signed(number, 2, 2) * offsets[own][1]);
    let top = 0.6 + 0.22 * size + 0.12 * signed(number, 0, 3) + askew + 0.025 * grain;
    let sand = 0.1 + 0.05 * fractal_noise(u, v, 48, 2, 41) + 0.05 * fractal_noise(u, v, 8, 1, 51);
    let height = mix(sand, sand.max(top), dome);

    let kind = STONE[(random(number, 0, 4) * 4.0) as usize];
    let shade = 1.0 + 0.16 * signed(number, 0, 5) + 0.12 * grain;
    let sandy = SAND.map(|part| part * (1.0 + 0.2 * fractal_noise(u, v, 64, 2, 61)));
    let stone_colour = kind.map(|part| part * shade);
    let colour = mix_colour(sandy, stone_colour, smooth_step(0.0, 0.35, inward));
    let smooth = ROUGHNESS[0] + 0.12 * signed(number, 0, 6) + 0.1 * grain;
    let roughness = mix(ROUGHNESS[1], smooth, smooth_step(0.1, 0.6, inward));
    let open = mix(0.4, 1.0, smooth_step(0.0, 0.5, inward));
    let material = [open, roughness, 0.0].map(|part| (part * 255.0).clamp(0.0, 255.0));
    Texel { height, colour: colour.map(|part| part.clamp(0.0, 255.0)), material }
}
