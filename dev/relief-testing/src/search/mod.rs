//! Searches that use baked maps, in `f64`, as plainly as they can be written: what a map promises is put to
//! use here and its answers are held against the exact tracers.

pub mod frustum;
pub mod pyramid;

use relief_core::exact::ExactHit;
use relief_core::{Cost, HeightMap, Hit, Path};

/// A search's answer, and how many steps it took: nodes or frusta passed over, and patches solved.
#[derive(Clone, Copy, Debug)]
pub struct Searched {
    /// The answer, to be judged; its cost, slope and clearance are 0.
    pub answer: ExactHit,
    /// Steps.
    pub steps: u32,
}

/// A path in cells.
#[derive(Clone, Copy, Debug)]
struct CellRay<'a> {
    map: &'a HeightMap,
    path: &'a Path,
    start: [f64; 2],
    speed: [f64; 2],
}

impl<'a> CellRay<'a> {
    fn new(map: &'a HeightMap, path: &'a Path) -> Self {
        let size = [f64::from(map.width()), f64::from(map.height())];
        let start = [0, 1].map(|axis| path.uv[axis] * size[axis] - 0.5);
        Self { map, path, start, speed: [0, 1].map(|axis| path.duv[axis] * size[axis]) }
    }

    fn cell_at(&self, t: f64) -> [i64; 2] {
        [0, 1].map(|axis| (self.start[axis] + self.speed[axis] * t).floor() as i64)
    }

    fn forward(&self) -> [bool; 2] {
        self.speed.map(|speed| speed >= 0.0)
    }

    /// When the ray leaves a rectangle of cells along each axis; infinity where it never does.
    fn leaves(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let line = if self.speed[axis] >= 0.0 { high[axis] } else { low[axis] };
            if self.speed[axis] == 0.0 { f64::INFINITY } else { (line - self.start[axis]) / self.speed[axis] }
        })
    }

    /// Coefficients of the height about `t`.
    fn height(&self, t: f64) -> [f64; 3] {
        let [h0, h1, h2] = self.path.h;
        [h0 + t * (h1 + t * h2), h1 + 2.0 * t * h2, h2]
    }

    /// When the path, from `from` to `to`, first is not above a level.
    fn reaches(&self, level: f64, from: f64, to: f64) -> Option<f64> {
        let [h0, h1, h2] = self.height(from);
        first_root([h0 - level, h1, h2], to - from).map(|after| from + after)
    }

    /// The first hit of a dual cell's patch from `from` to `to`.
    fn patch(&self, cell: [i64; 2], from: f64, to: f64) -> Option<f64> {
        let [h00, h10, h01, h11] = self.map.cell(cell[0], cell[1]).map(f64::from);
        let (a, b, c) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        let [x, y] = [0, 1].map(|axis| self.start[axis] + self.speed[axis] * from - cell[axis] as f64);
        let ([dx, dy], [h0, h1, h2]) = (self.speed, self.height(from));
        let gap = [
            h0 - (h00 + a * x + b * y + c * x * y),
            h1 - (a * dx + b * dy + c * (x * dy + y * dx)),
            h2 - c * dx * dy,
        ];
        first_root(gap, to - from).map(|after| from + after)
    }

    fn hit(&self, t: f64, steps: u32) -> Searched {
        let [u, v, _] = self.path.at(t);
        let height = self.map.height_at(u, v);
        let hit = Hit { found: true, exhausted: false, uv: [u, v], height, t, cost: Cost::default() };
        Searched { answer: ExactHit { hit, cell: [0; 2], slope: 0.0, clearance: 0.0 }, steps }
    }

    fn miss(steps: u32) -> Searched {
        Searched { answer: ExactHit::miss(Cost::default(), 0.0), steps }
    }
}

/// The first place in `[0, length]` where a quadratic is not positive.
fn first_root([c0, c1, c2]: [f64; 3], length: f64) -> Option<f64> {
    if c0 <= 0.0 {
        return Some(0.0);
    }
    let disc = c1 * c1 - 4.0 * c0 * c2;
    // Of the two forms of the first positive root, the one in which nothing cancels; none where there is no
    // such root.
    let root = if c1 <= 0.0 { 2.0 * c0 / (disc.sqrt() - c1) } else { (c1 + disc.sqrt()) / (-2.0 * c2) };
    if root >= 0.0 && root <= length {
        return Some(root);
    }
    let at_the_end = c0 + length * (c1 + length * c2);
    (at_the_end <= 0.0).then_some(length)
}
