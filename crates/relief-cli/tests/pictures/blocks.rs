//! Blocks: planes that walls close, beside a march through the solid, and on all lanes.

use crate::common::aov::{Aov, Pixel};
use crate::common::command::{Folder, Ran};
use crate::common::maps::Map;
use glam::DVec3;
use relief_core::{HeightMap, Wrap};

const SIZE: [usize; 2] = [48, 36];

/// Displacement between heights 0 and 1, and the base below the lowest texel, in metres.
const SCALE_M: f64 = 0.3;
const BASE_M: f64 = 0.1;

/// Steps of the march through a metre.
const STEPS: f64 = 2000.0;

fn hills() -> Map {
    Map::new(32, 24, |x, y| {
        let [u, v] = [f64::from(x) / 32.0, f64::from(y) / 24.0];
        ((0.5 + 0.25 * ((9.0 * u + 1.0).sin() + (8.0 * v - 5.0 * u).cos())) * 65535.0) as u16
    })
}

/// The block as a solid: everything between its bottom and the bilinear surface.
struct Block {
    map: HeightMap,
    /// Height of the bottom in metres.
    low_m: f64,
}

impl Block {
    fn new() -> Self {
        let map = hills();
        let texels = map.texels.iter().map(|&texel| f32::from(texel) / 65535.0).collect();
        let map = HeightMap::new(32, 24, texels, Wrap::Clamp).expect("a map");
        let low_m = f64::from(map.extremes()[0]) * SCALE_M - SCALE_M - BASE_M;
        Self { map, low_m }
    }

    fn holds(&self, point: DVec3) -> bool {
        let [u, v] = [point.x + 0.5, point.z / 0.75 + 0.5];
        let is_beside = !(0.0..=1.0).contains(&u) || !(0.0..=1.0).contains(&v);
        !is_beside
            && (self.low_m..=0.0).contains(&point.y)
            && point.y <= (self.map.height_at(u, v) - 1.0) * SCALE_M
    }

    /// Returns the first point of the solid on the ray of a pixel.
    fn first(&self, eye: DVec3, target: DVec3, x: usize, y: usize) -> Option<DVec3> {
        let forward = (target - eye).normalize();
        let right = forward.cross(DVec3::Y).normalize();
        let up = right.cross(forward);
        let half = 20f64.to_radians().tan();
        let across = ((x as f64 + 0.5) / SIZE[0] as f64 * 2.0 - 1.0) * half * SIZE[0] as f64 / SIZE[1] as f64;
        let along = (1.0 - (y as f64 + 0.5) / SIZE[1] as f64 * 2.0) * half;
        let direction = (forward + right * across + up * along).normalize();
        (0..(4.0 * STEPS) as u32)
            .map(|step| eye + direction * (f64::from(step) / STEPS))
            .find(|point| self.holds(*point))
    }
}

#[test]
fn a_block_is_the_solid_between_its_bottom_and_its_relief() {
    let folder = Folder::new();
    folder.write("map.png", hills().png());
    let block = Block::new();
    for eye in [DVec3::new(1.1, 0.5, 1.2), DVec3::new(-1.5, 0.05, 0.4), DVec3::new(0.2, -1.2, -1.0)] {
        let target = DVec3::new(0.0, -0.15, 0.0);
        let [from, to] = [eye, target].map(|point| format!("{},{},{}", point.x, point.y, point.z));
        let line = format!(
            "render map.png --backend cpu --samples 1 --size {}x{} --scale {SCALE_M} --eye={from} \
             --target={to}",
            SIZE[0], SIZE[1]
        );
        let pixels = (0..SIZE[0] * SIZE[1]).map(|at| block.first(eye, target, at % SIZE[0], at / SIZE[0]));
        let expected: Vec<Option<DVec3>> = pixels.collect();
        assert!(expected.iter().flatten().count() > 300, "{eye}");
        // Number of pixels with another first point.
        let others = |flags: &str| {
            folder.relief(&format!("{line} {flags} -o a.png --aov a.exr")).fine();
            let aov = Aov::read(&folder.path("a.exr"));
            let is_other = |&(x, y, pixel): &(usize, usize, Pixel)| {
                let found = (pixel.hit > 0.5).then_some(pixel.position);
                match (expected[y * SIZE[0] + x], found) {
                    (Some(expected), Some(found)) => expected.distance(found) > 4e-3,
                    (expected, found) => expected.is_some() != found.is_some(),
                }
            };
            aov.pixels().filter(is_other).count()
        };
        let walls = others(&format!("--walls --base {BASE_M}"));
        assert!(walls <= 3, "{eye}: {walls}");
        // A relief without walls, and a thinner base, are noticed.
        let [open, thin] = ["--wrap clamp", "--walls --base 1%"].map(others);
        assert!(open > 30 && thin > 30, "{eye}: {open} {thin}");
    }
}

#[test]
fn the_picture_of_a_block_is_the_same_on_all_lanes() {
    let folder = Folder::new();
    folder.write("map.png", hills().png());
    let line = "render map.png --walls --ramp viridis --look sun --backend cpu --size 64x48 -o a.png";
    let picture = |lanes: Option<&str>| {
        let mut command = folder.command();
        command.args(line.split(' ')).envs(lanes.map(|lanes| ("RELIEF_LANES", lanes)));
        Ran::new(line, &command.output().expect("the command starts")).fine();
        std::fs::read(folder.path("a.png")).expect("a picture")
    };
    assert_eq!(picture(Some("1")), picture(None));
}

#[test]
fn blocks_that_cannot_be_are_refused_with_their_flag() {
    let folder = Folder::new();
    folder.write("map.png", hills().png());
    for (flags, words) in [
        ("--walls --mesh sphere", ["--walls", "plane and square"]),
        ("--walls --method parallax", ["--walls", "prism"]),
        ("--base 5%", ["--base", "--walls"]),
        ("--walls --base 0", ["--base", "above 0"]),
        ("--walls --base thick", ["--base", "5%"]),
        ("--ramp terain", ["--ramp", "terrain"]),
        ("--ramp grey --color map.png", ["--ramp", "--color"]),
        ("--ramp none.txt", ["none.txt", "cannot be read"]),
    ] {
        let ran = folder.relief(&format!("render map.png --backend cpu --size 8x6 -o a.png {flags}"));
        assert!(matches!(ran.code, Some(1 | 2)), "{flags}: {:?}", ran.code);
        assert!(words.iter().all(|word| ran.stderr.contains(word)), "{flags}: {}", ran.stderr);
        assert!(!folder.path("a.png").exists(), "{flags}");
    }
}
